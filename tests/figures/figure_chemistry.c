/* Gray-Scott: the figures of "Reaction diffusion on shader", Pearson's classes, and the map of feed and kill. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "gray_scott_classes.h"
#include "gray_scott_shade.h"
#include "importance.h"
#include "motif.h"
#include "noise.h"
#include "sheet.h"

enum { SIDE = 320, SHOWN = 480, CELLS = SIDE * SIDE };

struct show {
    struct figure *figure;
    struct sheet *sheet;
    float u[CELLS], v[CELLS], earlier[CELLS], raster[2 * CELLS], texture[3 * SHOWN * SHOWN];
    uint8_t rgb[3 * SHOWN * SHOWN];
};

static struct show *show_create(struct figure *figure, const char *title, int columns, int rows)
{
    struct show *show = calloc(1, sizeof *show);
    if (!show) {
        figure_stop("chemistry", "no memory");
    }
    show->figure = figure;
    show->sheet = sheet_create(figure, title, columns, rows, SHOWN);
    return show;
}

static void show_finish(struct show *show)
{
    sheet_finish(show->sheet);
    free(show);
}

static struct gray_scott *sheet_of(const struct gray_scott_def *def)
{
    struct gray_scott *chemistry = gray_scott_create(SIDE, SIDE, def, 0, VECTORS_BEST);
    if (!chemistry) {
        figure_stop("chemistry", "no memory");
    }
    return chemistry;
}

static void shade(struct show *show, const struct gray_scott_shade_def *def)
{
    const struct pattern_plane plane = {show->v, SIDE, SIDE};
    gray_scott_shade(&plane, def, SHOWN, SHOWN, show->rgb);
}

static struct gray_scott_shade_def look(const char *gradient, float relief)
{
    struct gray_scott_shade_def def = gray_scott_shade_default_def();
    def.relief = relief;
    for (const struct gradient_named *named = gradients; named->name; named++) {
        def.gradient = strcmp(named->name, gradient) == 0 ? named->gradient : def.gradient;
    }
    return def;
}

/* Steps, takes the state and destroys. */
static void run(struct show *show, struct gray_scott *chemistry, int steps)
{
    gray_scott_step(chemistry, steps);
    gray_scott_save(chemistry, show->u, show->v);
    gray_scott_destroy(chemistry);
}

static double deviation(const struct show *show)
{
    struct gray_scott_figures figures;
    return gray_scott_measure(SIDE, SIDE, show->v, NULL, &figures) ? figures.deviation : 0;
}

/* Rings, as a picture or a letter would be. */
static void draw_mask(float *mask)
{
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            float dx = (float)x - 0.5f * SIDE, dy = (float)y - 0.5f * SIDE, r = sqrtf(dx * dx + dy * dy);
            bool bar = fabsf(dx) < 8 && dy > -90 && dy < 90, ring = fabsf(r - 110) < 8;
            mask[y * SIDE + x] = bar || ring ? 1.0f : 0.0f;
        }
    }
}

/* The article's first results: different initial states. */
static void show_starts(struct show *show)
{
    static const char *const STARTS[] = {"spots", "noise", "a mask"};
    for (int i = 0; i < 3; i++) {
        struct gray_scott_def def = gray_scott_default_def();
        def.stencil = LAPLACIAN_ARTICLE;
        def.diffusion_u = 1;
        def.diffusion_v = 0.5f;
        def.feed = 0.037f;
        def.kill = 0.06f;
        struct gray_scott *chemistry = sheet_of(&def);
        draw_mask(show->raster);
        if (i == 0) {
            gray_scott_seed_spots(chemistry, 8, 10, 4);
        } else if (i == 1) {
            gray_scott_seed_noise(chemistry, 0.4f, 4);
        } else {
            gray_scott_seed_mask(chemistry, &(struct action_raster){show->raster, SIDE, SIDE, 1}, false);
        }
        run(show, chemistry, 1800);
        struct gray_scott_shade_def bone = look("bone", 0);
        shade(show, &bone);
        figure_check(show->figure, deviation(show) > 0.03, "from %s something grows: deviation %.3f", STARTS[i],
                     deviation(show));
        sheet_add(show->sheet, show->rgb, "from %s, the article's kernel", STARTS[i]);
    }
}

static void draw_texture(float *texture)
{
    for (int y = 0; y < SHOWN; y++) {
        for (int x = 0; x < SHOWN; x++) {
            bool dark = (x / 24 + y / 24) % 2;
            float *pixel = &texture[3 * (y * SHOWN + x)];
            pixel[0] = dark ? 0.25f : 0.6f;
            pixel[1] = dark ? 0.06f : 0.4f;
            pixel[2] = dark ? 0.05f : 0.2f;
        }
    }
}

/* Figure 4: gradients of one state, one of them over a pattern. */
static void show_gradients(struct show *show)
{
    struct gray_scott_def def = gray_scott_preset_def(gray_scott_preset_find("fingerprint"));
    struct gray_scott *chemistry = sheet_of(&def);
    gray_scott_seed_spots(chemistry, 12, 10, 7);
    run(show, chemistry, 5000);
    draw_texture(show->texture);
    for (const struct gradient_named *named = gradients + 1; named->name; named++) {
        struct gray_scott_shade_def way = look(named->name, 14);
        way.texture = show->texture;
        way.texture_width = way.texture_height = SHOWN;
        shade(show, &way);
        sheet_add(show->sheet, show->rgb, "figure 4: gradient %s", named->name);
    }
}

/* How much less v there is where the noise makes the kill rate high. */
static double follows(const struct show *show, const struct gray_scott_def *def)
{
    double high = 0, low = 0, highs = 0, lows = 0;
    for (int i = 0; i < CELLS; i++) {
        float n = noise_simplex((float)(i % SIDE) / def->noise_size, (float)(i / SIDE) / def->noise_size, 0,
                                (uint32_t)def->seed);
        high += n > 0.4f ? (double)show->v[i] : 0;
        highs += n > 0.4f;
        low += n < -0.4f ? (double)show->v[i] : 0;
        lows += n < -0.4f;
    }
    return (high / highs) / (low / lows);
}

/* Figures 5, 6 and 7. */
static void show_noises(struct show *show)
{
    struct gray_scott_def def = gray_scott_default_def();
    def.feed = 0.045f;
    def.kill = 0.0615f;
    def.noise_kill = 0.006f;
    def.noise_size = 70;
    struct gray_scott *chemistry = sheet_of(&def);
    gray_scott_seed_noise(chemistry, 0.3f, 2);
    run(show, chemistry, 4000);
    struct gray_scott_shade_def bone = look("bone", 0);
    shade(show, &bone);
    for (int i = 0; i < SHOWN * SHOWN; i++) {
        float x = (float)(i % SHOWN) * SIDE / SHOWN / def.noise_size,
              y = (float)(i / SHOWN) * SIDE / SHOWN / def.noise_size;
        float red = 130 * (0.5f + 0.5f * noise_simplex(x, y, 0, (uint32_t)def.seed));
        show->rgb[3 * i] = (uint8_t)fmaxf(red, show->rgb[3 * i]);
    }
    double ratio = follows(show, &def);
    figure_check(show->figure, ratio < 0.7, "figure 5: %.2f times as much v where the kill rate is high", ratio);
    sheet_add(show->sheet, show->rgb, "figure 5: noise (red) on the kill rate");
    def.noise_feed = 0.012f;
    chemistry = sheet_of(&def);
    gray_scott_seed_noise(chemistry, 0.3f, 2);
    run(show, chemistry, 4000);
    struct gray_scott_shade_def reef = look("reef", 14), ember = look("indigo", 10);
    shade(show, &reef);
    sheet_add(show->sheet, show->rgb, "figure 6: noise on feed and kill");
    def.displacement = 0.35f;
    def.noise_speed = 0.5f;
    chemistry = sheet_of(&def);
    gray_scott_seed_noise(chemistry, 0.3f, 2);
    run(show, chemistry, 3000);
    shade(show, &ember);
    figure_check(show->figure, deviation(show) > 0.03, "figure 7: alive, deviation %.3f", deviation(show));
    sheet_add(show->sheet, show->rgb, "figure 7: noise on feed, kill and displacement");
}

/* Beyond the article: orientation, style. */
static void show_maps(struct show *show)
{
    struct gray_scott_def def = gray_scott_preset_def(gray_scott_preset_find("fingerprint"));
    def.anisotropy_v = 0.5f;
    struct gray_scott *chemistry = sheet_of(&def);
    for (int i = 0; i < CELLS; i++) {
        show->raster[i] = 0.5f * SIDE - (float)(i / SIDE); /* around the middle */
        show->raster[CELLS + i] = (float)(i % SIDE) - 0.5f * SIDE;
    }
    gray_scott_seed_noise(chemistry, 0.3f, 6);
    if (!gray_scott_orient(chemistry, &(struct action_raster){show->raster, SIDE, SIDE, 2})) {
        figure_stop("chemistry", "no memory");
    }
    run(show, chemistry, 5000);
    struct gray_scott_shade_def indigo = look("indigo", 8), bone = look("bone", 0);
    shade(show, &indigo);
    sheet_add(show->sheet, show->rgb, "orientation: around the middle");
    motif_draw(MOTIF_PORTRAIT, SIDE, SIDE, show->texture);
    importance_grey(show->texture, SIDE, SIDE, 3, -1, show->raster);
    def = gray_scott_default_def();
    def.feed = 0.037f;
    def.kill = 0.0655f;
    def.style_kill = -0.0075f;
    chemistry = sheet_of(&def);
    gray_scott_seed_noise(chemistry, 0.4f, 6);
    if (!gray_scott_style(chemistry, &(struct action_raster){show->raster, SIDE, SIDE, 1})) {
        figure_stop("chemistry", "no memory");
    }
    run(show, chemistry, 6000);
    shade(show, &bone);
    sheet_add(show->sheet, show->rgb, "style: kill by the brightness of a portrait");
}

static void show_torus(struct show *show, const char *preset, const char *gradient, float turn)
{
    const struct gray_scott_preset *found = gray_scott_preset_find(preset);
    struct gray_scott_def def = gray_scott_preset_def(found);
    struct gray_scott *chemistry = sheet_of(&def);
    gray_scott_preset_start(chemistry, found, 3);
    run(show, chemistry, 9000);
    const struct pattern_plane plane = {show->v, SIDE, SIDE};
    struct gray_scott_shade_def way = look(gradient, 0);
    struct torus_def torus = torus_default_def();
    torus.turn = turn;
    if (!gray_scott_torus(&plane, &way, &torus, SHOWN, SHOWN, show->rgb)) {
        figure_stop("chemistry", "no memory");
    }
    int seen = 0;
    for (int i = 0; i < SHOWN * SHOWN; i++) {
        seen += show->rgb[3 * i] > 8 || show->rgb[3 * i + 2] > 8;
    }
    figure_check(show->figure, seen > SHOWN * SHOWN / 4 && seen < SHOWN * SHOWN * 3 / 4, "a torus covers %.0f %%",
                 100.0 * seen / (SHOWN * SHOWN));
    sheet_add(show->sheet, show->rgb, "figure 2: %s on a torus", preset);
}

void figure_chemistry(struct figure *figure)
{
    struct show *show = show_create(figure, "Gray-Scott: the figures of \"Reaction diffusion on shader\"", 4, 4);
    show_starts(show);
    show_gradients(show);
    show_noises(show);
    show_maps(show);
    show_torus(show, "mitosis", "reef", 0);
    show_torus(show, "maze", "ember", 0.1f);
    show_finish(show);
}

/* Feed from bottom to top, kill from left to right; a dot where each preset is, in the colour of its class. */
static void show_map(struct show *show)
{
    static const uint8_t COLOURS[CLASSES][3] = {
        {160, 160, 160}, {255, 210, 60}, {255, 90, 60}, {90, 200, 255}, {120, 255, 120}};
    const float feed_low = 0.005f, feed_span = 0.065f, kill_low = 0.038f, kill_span = 0.034f;
    struct gray_scott_def def = gray_scott_default_def();
    def.boundary = BOUNDARY_NO_FLUX;
    def.feed = feed_low;
    def.kill = kill_low;
    def.style_feed = feed_span;
    def.style_kill = kill_span;
    struct gray_scott *chemistry = sheet_of(&def);
    for (int i = 0; i < CELLS; i++) {
        show->raster[i] = 1 - ((float)(i / SIDE) + 0.5f) / SIDE;
        show->raster[CELLS + i] = ((float)(i % SIDE) + 0.5f) / SIDE;
    }
    for (int i = 0; i < 12; i++) {
        gray_scott_seed_spots(chemistry, 40, 8, (uint32_t)i);
    }
    if (!gray_scott_style(chemistry, &(struct action_raster){show->raster, SIDE, SIDE, 2})) {
        figure_stop("chemistry", "no memory");
    }
    run(show, chemistry, 5000);
    struct gray_scott_shade_def bone = look("bone", 0);
    shade(show, &bone);
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        float x = (preset->kill - kill_low) / kill_span * SHOWN,
              y = (1 - (preset->feed - feed_low) / feed_span) * SHOWN;
        for (int i = 0; i < SHOWN * SHOWN; i++) {
            float dx = (float)(i % SHOWN) - x, dy = (float)(i / SHOWN) - y, r = dx * dx + dy * dy;
            if (r < 49) {
                memcpy(&show->rgb[3 * i], r < 25 ? COLOURS[preset->is] : (const uint8_t[]){0, 0, 0}, 3);
            }
        }
    }
    sheet_add(show->sheet, show->rgb,
              "kill .038 to .072 across, feed .005 to .07 up; yellow spots, red worms, blue holes, "
              "green waves, grey uniform");
}

void figure_classes(struct figure *figure)
{
    struct show *show = show_create(figure, "Gray-Scott: Pearson's classes, and the map of feed and kill", 6, 3);
    struct gray_scott_shade_def reef = look("reef", 10);
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        struct gray_scott_def def = gray_scott_preset_def(preset);
        struct gray_scott_figures figures;
        struct gray_scott *chemistry = sheet_of(&def);
        gray_scott_preset_start(chemistry, preset, 1);
        gray_scott_step(chemistry, 8000);
        gray_scott_save(chemistry, show->u, show->earlier);
        run(show, chemistry, 300);
        if (!gray_scott_measure(SIDE, SIDE, show->v, show->earlier, &figures)) {
            figure_stop("chemistry", "no memory");
        }
        enum gray_scott_class is = gray_scott_classify(&figures);
        figure_check(figure, is == preset->is,
                     "%s %s is %s (deviation %.3f, change %.2f, covered %.2f, roundness %.2f)", preset->letter,
                     preset->name, gray_scott_class_names[is], figures.deviation, figures.change, figures.covered,
                     figures.roundness);
        shade(show, &reef);
        sheet_add(show->sheet, show->rgb, "%s %s, feed %.3f kill %.4f: %s", preset->letter, preset->name,
                  (double)preset->feed, (double)preset->kill, gray_scott_class_names[is]);
    }
    show_map(show);
    show_finish(show);
}
