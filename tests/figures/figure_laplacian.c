/* Laplacian growth: bolts over eta, attractors and repulsors, masks, coral, light, four dimensions. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "laplacian.h"
#include "sheet.h"
#include "stroke_raster.h"

enum { SHOWN = 480, RASTER = 128 };
static const float PI = 3.14159265f;

struct look {
    float turn;                     /* radians about y, of what has depth */
    float power;                    /* of the particles that a branch carries, in its radius */
    float thick;                    /* radius of a tip, pixels */
    float back[3], far[3], near[3]; /* colours: ground, thin or distant, thick or close */
};

static const struct look BOLT = {.power = 0.28f,
                                 .thick = 0.42f,
                                 .back = {0.02f, 0.02f, 0.07f},
                                 .far = {0.36f, 0.42f, 0.95f},
                                 .near = {0.98f, 0.98f, 1}},
                         CORAL = {.turn = 0.6f,
                                  .power = 0.24f,
                                  .thick = 0.7f,
                                  .back = {0.97f, 0.95f, 0.91f},
                                  .far = {0.93f, 0.72f, 0.66f},
                                  .near = {0.62f, 0.12f, 0.13f}},
                         MOSS = {.power = 0.25f,
                                 .thick = 0.6f,
                                 .back = {0.97f, 0.96f, 0.91f},
                                 .far = {0.45f, 0.58f, 0.38f},
                                 .near = {0.10f, 0.22f, 0.14f}};

struct view {
    float x, y, scale; /* what is in the middle, pixels a cell */
};

static struct laplacian *grow(const struct laplacian_def *def)
{
    enum laplacian_status status;
    struct laplacian *laplacian = laplacian_create(def, &status);
    if (!laplacian) {
        figure_stop("laplacian", laplacian_status_names[status]);
    }
    laplacian_step(laplacian, def->particles);
    return laplacian;
}

/* Places turned, seen from far; depth from -1 far to 1 near. */
static void project(const struct laplacian *laplacian, const struct look *look, float (*seen)[3])
{
    float sine = sinf(look->turn), cosine = cosf(look->turn), most = 1e-6f;
    for (int i = 0; i < laplacian_count(laplacian); i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        float z = node.at[2] + 0.5f * node.at[3];
        seen[i][0] = cosine * node.at[0] + sine * z;
        seen[i][1] = node.at[1] + 0.35f * node.at[3];
        seen[i][2] = sine * node.at[0] - cosine * z;
        most = fmaxf(most, fabsf(seen[i][2]));
    }
    for (int i = 0; i < laplacian_count(laplacian); i++) {
        seen[i][2] /= most;
    }
}

static struct view frame(float (*seen)[3], int count)
{
    float low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < count; i++) {
        for (int d = 0; d < 2; d++) {
            low[d] = fminf(low[d], seen[i][d]);
            high[d] = fmaxf(high[d], seen[i][d]);
        }
    }
    float wide = fmaxf(fmaxf(high[0] - low[0], high[1] - low[1]), 20);
    return (struct view){(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0.9f * SHOWN / wide};
}

/* Branches by how much they carry, the far ones first. */
static void shade(const struct laplacian *laplacian, const struct look *look, const struct view *given, uint8_t *rgb)
{
    int count = laplacian_count(laplacian);
    float(*seen)[3] = calloc((size_t)count, sizeof *seen);
    float *carried = malloc((size_t)count * sizeof *carried), most = 1;
    static float light[SHOWN * SHOWN][3];
    if (!seen || !carried) {
        figure_stop("laplacian", "no memory");
    }
    project(laplacian, look, seen);
    struct view view = given ? *given : frame(seen, count);
    for (int i = 0; i < count; i++) {
        carried[i] = 1;
    }
    for (int i = count - 1; i >= 0; i--) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        if (node.parent >= 0) {
            carried[node.parent] += carried[i];
        }
        most = fmaxf(most, carried[i]);
    }
    for (int i = 0; i < SHOWN * SHOWN; i++) {
        memcpy(light[i], look->back, sizeof light[i]);
    }
    enum { SLICES = 6 };
    int slices = look->turn != 0 ? SLICES : 1;
    for (int slice = 0; slice < slices; slice++) {
        struct strokes strokes = {0};
        struct stroke_raster raster;
        bool good = stroke_raster_init(&raster, SHOWN, SHOWN, 1, 0, 0);
        for (int i = 0; i < count && good; i++) {
            int parent = laplacian_node(laplacian, i).parent, in = (int)((seen[i][2] + 1) * 0.5f * (float)slices);
            if (parent < 0 || (slices > 1 && (in < slices ? in : slices - 1) != slice)) {
                continue;
            }
            float radius = look->thick * powf(carried[i], look->power);
            float tone = slices > 1 ? 0.5f * (seen[i][2] + 1) : powf(carried[i] / most, 0.3f);
            good = strokes_begin(&strokes, STROKE_BRANCH, 0, 0, 0, tone);
            for (int end = 0; end < 2 && good; end++) {
                int at = end ? i : parent;
                good = strokes_point(&strokes, (seen[at][0] - view.x) * view.scale + SHOWN / 2,
                                     (seen[at][1] - view.y) * view.scale + SHOWN / 2, radius, 0);
            }
        }
        if (!good) {
            figure_stop("laplacian", "no memory");
        }
        stroke_raster_draw(&raster, &strokes, 0, STROKE_BRANCH, 1e9f);
        for (int i = 0; i < SHOWN * SHOWN; i++) {
            for (int c = 0; c < 3; c++) {
                float ink = look->far[c] + (look->near[c] - look->far[c]) * raster.tone[i];
                ink *= slices > 1 ? 1 - 0.45f * raster.across[i] * raster.across[i] : 1;
                light[i][c] += raster.cover[i] * (ink - light[i][c]);
            }
        }
        stroke_raster_finish(&raster);
        strokes_finish(&strokes);
    }
    for (int i = 0; i < SHOWN * SHOWN; i++) {
        for (int c = 0; c < 3; c++) {
            float value = 255 * light[i][c] + 0.5f;
            rgb[3 * i + c] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
        }
    }
    free(seen);
    free(carried);
}

static float extent_of(const struct laplacian *laplacian)
{
    float most = 0;
    for (int i = 0; i < laplacian_count(laplacian); i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        most = fmaxf(most, hypotf(node.at[0], node.at[1]));
    }
    return most;
}

static void show_etas(struct figure *figure, struct sheet *sheet, uint8_t *rgb)
{
    static const float ETAS[4] = {1, 2, 3, 6};
    float before = 0;
    for (int i = 0; i < 4; i++) {
        struct laplacian_def def = laplacian_default_def();
        def.particles = i == 3 ? 4000 : 12000;
        def.eta = ETAS[i];
        def.seed = 4;
        struct laplacian *laplacian = grow(&def);
        shade(laplacian, &BOLT, NULL, rgb);
        sheet_add(sheet, rgb, "eta %g, %d particles", (double)def.eta, laplacian_count(laplacian));
        float wide = extent_of(laplacian) / sqrtf((float)def.particles);
        figure_check(figure, wide > before, "eta %g: as far as %.2f times the root of its particles", (double)def.eta,
                     (double)wide);
        before = wide;
        laplacian_destroy(laplacian);
    }
}

static void show_strike(struct figure *figure, struct sheet *sheet, uint8_t *rgb)
{
    struct laplacian_charge charges[2] = {
        {.shape = LAPLACIAN_PLANE, .charge = 9000, .at = {0, 260}, .along = {0, 1}, .ends = true},
        {.shape = LAPLACIAN_POINT, .charge = 2000, .at = {70, 240}, .ends = true}};
    struct laplacian_def def = laplacian_default_def();
    def.particles = 40000;
    def.eta = 4;
    def.seed = 3;
    def.charges = charges;
    def.charge_count = 2;
    struct laplacian *laplacian = grow(&def);
    shade(laplacian, &BOLT, &(struct view){0, 125, 1.55f}, rgb);
    sheet_add(sheet, rgb, "to the ground, and a point on it");
    figure_check(figure, laplacian_status(laplacian) == LAPLACIAN_HIT, "the bolt strikes after %d particles",
                 laplacian_count(laplacian));
    laplacian_destroy(laplacian);
}

/* Sown along a line; a stroke repels, two points attract. */
static void show_painted(struct figure *figure, struct sheet *sheet, uint8_t *rgb)
{
    float path[2 * 24];
    for (int i = 0; i < 24; i++) {
        float angle = PI * (float)i / 23;
        path[2 * i] = 75 * cosf(angle);
        path[2 * i + 1] = 20 - 60 * sinf(angle);
    }
    struct laplacian_charge charges[4] = {{.shape = LAPLACIAN_STROKE, .charge = -60, .path = path, .path_count = 24},
                                          {.shape = LAPLACIAN_POINT, .charge = 5000, .at = {-120, -120}},
                                          {.shape = LAPLACIAN_POINT, .charge = 5000, .at = {120, -120}},
                                          {.shape = LAPLACIAN_PLANE, .charge = -6000, .at = {0, 130}, .along = {0, 1}}};
    struct laplacian_seed seed = {{-120, 120}, {120, 120}};
    struct laplacian_def def = laplacian_default_def();
    def.particles = 26000;
    def.eta = 4;
    def.charges = charges;
    def.charge_count = 4;
    def.seeds = &seed;
    def.seed_count = 1;
    struct laplacian *laplacian = grow(&def);
    int inside = 0, above = 0;
    for (int i = 0; i < laplacian_count(laplacian); i++) {
        struct laplacian_node node = laplacian_node(laplacian, i);
        above += node.at[1] < -10;
        inside += hypotf(node.at[0] / 75, (node.at[1] - 20) / 60) < 1 && node.at[1] < 20;
    }
    shade(laplacian, &MOSS, &(struct view){0, 0, 1.75f}, rgb);
    sheet_add(sheet, rgb, "a painted arch repels, two points attract");
    figure_check(figure, above > 500 && inside < above / 4, "under the arch %d, as high beside it %d", inside, above);
    laplacian_destroy(laplacian);
}

/* A spiral that holds the growth. */
static void show_mask(struct figure *figure, struct sheet *sheet, uint8_t *rgb)
{
    static float mask[RASTER * RASTER];
    for (int i = 0; i < RASTER * RASTER; i++) {
        float x = (float)(i % RASTER) - 63.5f, y = (float)(i / RASTER) - 63.5f, far = hypotf(x, y);
        float turn = (atan2f(y, x) / (2 * PI) + 1) * 24, arm = fmodf(far + 48 - turn, 24);
        mask[i] = far < 60 && (arm < 15 || far < 8) ? 1 : 0;
    }
    struct laplacian_def def = laplacian_default_def();
    def.particles = 14000;
    def.eta = 3;
    def.span = 320;
    def.mask = (struct action_raster){mask, RASTER, RASTER, 1};
    struct laplacian *laplacian = grow(&def);
    shade(laplacian, &MOSS, &(struct view){0, 0, 1.5f}, rgb);
    sheet_add(sheet, rgb, "within a mask");
    figure_check(figure, laplacian_count(laplacian) > 5000, "the mask holds %d particles", laplacian_count(laplacian));
    laplacian_destroy(laplacian);
}

static void show_space(struct figure *figure, struct sheet *sheet, uint8_t *rgb)
{
    static float sky[64 * 32];
    struct laplacian_charge ground = {.shape = LAPLACIAN_PLANE, .charge = -3000, .at = {0, 4}, .along = {0, 1}};
    for (int i = 0; i < 64 * 32; i++) {
        float around = ((float)(i % 64) + 0.5f) / 64 * 2 * PI, up = ((float)(i / 64) + 0.5f) / 32;
        sky[i] = up < 0.5f ? fmaxf(0, cosf(around)) * 2 : 0;
    }
    for (int which = 0; which < 4; which++) {
        static const char *const LABELS[4] = {"coral in 3D, above a plane that repels",
                                              "the same, light from the right", "off the grid, 3D, eta 4",
                                              "4D, seen in the plane"};
        struct laplacian_def def = laplacian_default_def();
        def.dimensions = which == 3 ? 4 : 3;
        def.particles = which == 3 ? 1200 : which == 2 ? 3000 : 9000;
        def.eta = which == 3 ? 4 : which == 2 ? 4 : 5;
        def.off_grid = which == 2;
        def.charges = &ground;
        def.charge_count = which < 2;
        if (which == 1) {
            def.environment = (struct action_raster){sky, 64, 32, 1};
            def.environment_radius = 160;
            def.environment_strength = 0.4f;
        }
        struct laplacian *laplacian = grow(&def);
        double mean = 0, below = 0;
        for (int i = 0; i < laplacian_count(laplacian); i++) {
            struct laplacian_node node = laplacian_node(laplacian, i);
            mean += (double)node.at[0] / laplacian_count(laplacian);
            below += node.at[1] > 4;
        }
        shade(laplacian, &CORAL, NULL, rgb);
        sheet_add(sheet, rgb, "%s", LABELS[which]);
        if (which < 2) {
            figure_check(figure, below < 0.1 * laplacian_count(laplacian) && (which == 0 ? fabs(mean) < 25 : mean > 5),
                         "%s: %.0f below the plane, mean of x %.1f", LABELS[which], below, mean);
        }
        laplacian_destroy(laplacian);
    }
}

void figure_laplacian(struct figure *figure)
{
    uint8_t *rgb = malloc((size_t)3 * SHOWN * SHOWN);
    struct sheet *sheet = sheet_create(figure, "Laplacian growth", 4, 3, SHOWN);
    if (!rgb) {
        figure_stop("laplacian", "no memory");
    }
    show_etas(figure, sheet, rgb);
    show_strike(figure, sheet, rgb);
    show_painted(figure, sheet, rgb);
    show_mask(figure, sheet, rgb);
    show_space(figure, sheet, rgb);
    sheet_finish(sheet);
    free(rgb);
}
