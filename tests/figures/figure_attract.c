/* What people see first: a dozen generated sessions of attract, small. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "attract.h"
#include "figure.h"
#include "ink.h"
#include "painting.h"
#include "picture.h"
#include "sheet.h"

enum {
    SESSIONS = 12,
    WIDTH = 240, /* cells */
    HEIGHT = 150,
    CELLS = WIDTH * HEIGHT,
    PIXELS = 480,
    SECONDS = 28,
    RATE = 40,
    WINDOW = 2 * RATE, /* ticks in which something must change */
    BLOCKS_X = 16,
    BLOCKS_Y = 10,
    BLOCKS = BLOCKS_X * BLOCKS_Y,
};

struct watched {
    float *depth, *ink[PAINTING_INKS], *spare;
    float *before; /* depth and ink, at the end of the window before */
};

struct seen {
    double covered; /* share of the sheet */
    double inked;   /* share of that which has ink */
    int stillest;   /* cells that change in a window, least */
    int liveliest;  /* cells that are covered in one, most */
    int stillest_window;
    float blocks[BLOCKS]; /* share covered */
};

static float *take_plane(size_t planes)
{
    float *plane = calloc(planes * CELLS, sizeof *plane);
    if (!plane) {
        figure_stop("planes", "no memory");
    }
    return plane;
}

static void read_planes(struct painting *painting, struct watched *watched)
{
    painting_read(painting, PAINTING_CARVED, watched->depth);
    painting_read(painting, PAINTING_ACTIVE, watched->spare);
    for (int i = 0; i < CELLS; i++) {
        watched->depth[i] += watched->spare[i];
    }
    for (int ink = 0; ink < PAINTING_INKS; ink++) {
        painting_read(painting, (enum painting_field)(PAINTING_WET + ink), watched->ink[ink]);
        painting_read(painting, (enum painting_field)(PAINTING_DRY + ink), watched->spare);
        for (int i = 0; i < CELLS; i++) {
            watched->ink[ink][i] += watched->spare[i];
        }
    }
}

/* Cells in which depth or ink are visibly others than when last asked. */
static int changed(struct watched *watched, int *grown)
{
    int count = 0;
    *grown = 0;
    for (int i = 0; i < CELLS; i++) {
        float change = fabsf(watched->depth[i] - watched->before[i]);
        *grown += watched->depth[i] > 0.1f && watched->before[i] <= 0.1f;
        watched->before[i] = watched->depth[i];
        for (int ink = 0; ink < PAINTING_INKS; ink++) {
            float *before = &watched->before[(ink + 1) * CELLS + i];
            change = fmaxf(change, fabsf(watched->ink[ink][i] - *before));
            *before = watched->ink[ink][i];
        }
        count += change > 0.04f;
    }
    return count;
}

static void measure(const struct watched *watched, struct seen *seen)
{
    int covered = 0, inked = 0;
    memset(seen->blocks, 0, sizeof seen->blocks);
    for (int i = 0; i < CELLS; i++) {
        if (watched->depth[i] < 0.1f) {
            continue;
        }
        float ink = 0;
        for (int j = 0; j < PAINTING_INKS; j++) {
            ink += watched->ink[j][i];
        }
        covered++;
        inked += ink > 0.1f;
        int x = i % WIDTH * BLOCKS_X / WIDTH, y = i / WIDTH * BLOCKS_Y / HEIGHT;
        seen->blocks[y * BLOCKS_X + x] += (float)BLOCKS / CELLS;
    }
    seen->covered = (double)covered / CELLS;
    seen->inked = covered ? (double)inked / covered : 0;
}

/* How alike two are, -1..1: the correlation of what is covered where. */
static double likeness(const struct seen *one, const struct seen *other)
{
    double mean_a = 0, mean_b = 0, ab = 0, aa = 0, bb = 0;
    for (int i = 0; i < BLOCKS; i++) {
        mean_a += (double)one->blocks[i] / BLOCKS;
        mean_b += (double)other->blocks[i] / BLOCKS;
    }
    for (int i = 0; i < BLOCKS; i++) {
        double a = (double)one->blocks[i] - mean_a, b = (double)other->blocks[i] - mean_b;
        ab += a * b;
        aa += a * a;
        bb += b * b;
    }
    return aa > 0 && bb > 0 ? ab / sqrt(aa * bb) : 0;
}

static void show(const struct watched *watched, const struct script *script, struct sheet *sheet, int number,
                 const struct seen *seen)
{
    struct picture_def def = picture_default_def();
    def.cells_x = WIDTH;
    def.cells_y = HEIGHT;
    def.width = PIXELS;
    def.height = PIXELS * HEIGHT / WIDTH;
    memcpy(def.ink, script->inks, sizeof def.ink);
    struct picture *picture = picture_create(&def);
    uint8_t *rgb = malloc((size_t)PIXELS * PIXELS * 3);
    if (!picture || !rgb) {
        figure_stop("picture", "no memory");
    }
    memset(rgb, 0xff, (size_t)PIXELS * PIXELS * 3); /* sheets have square pictures */
    struct picture_planes planes = {.depth = watched->depth};
    memcpy(planes.ink, watched->ink, sizeof planes.ink);
    picture_draw(picture, &planes, rgb + (size_t)(PIXELS - def.height) / 2 * PIXELS * 3);
    sheet_add(sheet, rgb,
              "session %d: %.0f %% covered, %.0f %% of it inked; at least %d cells change in 2 s, at most %d grow",
              number, 100 * seen->covered, 100 * seen->inked, seen->stillest, seen->liveliest);
    picture_destroy(picture);
    free(rgb);
}

static struct seen play(struct attract *attract, struct watched *watched, int seed)
{
    struct painting_def def = painting_default_def();
    def.width = WIDTH;
    def.height = HEIGHT;
    def.seed = (uint32_t)seed;
    def.threads = 1;
    struct painting *painting = painting_create(&def);
    if (!painting) {
        figure_stop("painting", "no memory");
    }
    struct seen seen = {.stillest = CELLS};
    memset(watched->before, 0, (PAINTING_INKS + 1) * CELLS * sizeof *watched->before);
    for (int64_t tick = 0; !attract_over(attract, tick); tick++) {
        struct action action;
        while (attract_action(attract, tick, &action)) {
            painting_act(painting, &action);
        }
        painting_tick(painting);
        if ((tick + 1) % WINDOW == 0) {
            read_planes(painting, watched);
            int grown, count = changed(watched, &grown);
            seen.stillest_window = count < seen.stillest ? (int)(tick / WINDOW) : seen.stillest_window;
            seen.stillest = count < seen.stillest ? count : seen.stillest;
            seen.liveliest = grown > seen.liveliest ? grown : seen.liveliest;
        }
    }
    read_planes(painting, watched);
    measure(watched, &seen);
    painting_destroy(painting);
    return seen;
}

static void check_sessions(struct figure *figure, const struct seen seen[SESSIONS])
{
    double most_alike = -1, least_used = 1;
    for (int i = 0; i < SESSIONS; i++) {
        figure_check(figure, seen[i].covered > 0.07 && seen[i].covered < 0.6,
                     "session %d covers %.0f %% of the sheet, of 7 to 60", i, 100 * seen[i].covered);
        figure_check(figure, seen[i].inked > 0.96, "session %d has ink in %.0f %% of that, over 96", i,
                     100 * seen[i].inked);
        figure_check(figure, seen[i].stillest >= 40,
                     "session %d never stands still: %d cells change in the stillest 2 s (number %d), over 40", i,
                     seen[i].stillest, seen[i].stillest_window);
        figure_check(figure, seen[i].liveliest < CELLS / 10,
                     "session %d never bursts: %d cells grow in the liveliest 2 s, under %d", i, seen[i].liveliest,
                     CELLS / 10);
        for (int j = 0; j < i; j++) {
            most_alike = fmax(most_alike, likeness(&seen[i], &seen[j]));
        }
    }
    figure_check(figure, most_alike < 0.9, "no two are alike: the nearest correlate by %.2f, under 0.9", most_alike);
    int unused = 0;
    for (int i = 0; i < BLOCKS; i++) {
        double used = 0;
        for (int j = 0; j < SESSIONS; j++) {
            used = fmax(used, (double)seen[j].blocks[i]);
        }
        unused += used < 0.1;
        least_used = fmin(least_used, used);
    }
    figure_check(figure, unused <= BLOCKS / 20, "every part of the sheet is used: %d of %d are not", unused, BLOCKS);
}

void figure_attract(struct figure *figure)
{
    static const char *const scene_inks[][PAINTING_INKS] = {
        {"turquoise", "quinacridone", "ochre", "hansa"},
        {"cobalt blue", "turquoise", "sap green", "hansa"},
        {"quinacridone", "sienna", "ochre", "cobalt blue"},
        {"carbon black", "cobalt blue", "turquoise", "quinacridone"}};
    enum { SCENES = sizeof scene_inks / sizeof scene_inks[0] };
    struct script scripts[SCENES] = {{0}};
    struct exhibit exhibit = {
        .sheet = {.cells = CELLS, .rate = RATE}, .scene_count = SCENES, .visit = {.attract = SECONDS}};
    for (int i = 0; i < SCENES; i++) {
        for (int j = 0; j < PAINTING_INKS; j++) {
            scripts[i].inks[j] = ink_find(scene_inks[i][j]);
        }
        scripts[i].ink_count = PAINTING_INKS;
        exhibit.scenes[i].script = &scripts[i];
    }
    struct attract *attract = attract_create(&exhibit, 20);
    if (!attract) {
        figure_stop("attract", "no memory");
    }
    struct watched watched = {.depth = take_plane(1), .spare = take_plane(1), .before = take_plane(PAINTING_INKS + 1)};
    for (int i = 0; i < PAINTING_INKS; i++) {
        watched.ink[i] = take_plane(1);
    }
    struct sheet *sheet = sheet_create(figure, "Attract: generated sessions", 3, SESSIONS / 3, PIXELS);
    struct seen seen[SESSIONS];
    for (int i = 0; i < SESSIONS; i++) {
        attract_begin(attract, i % SCENES, (float)WIDTH / HEIGHT);
        seen[i] = play(attract, &watched, i + 1);
        show(&watched, &scripts[i % SCENES], sheet, i, &seen[i]);
    }
    sheet_finish(sheet);
    check_sessions(figure, seen);
    attract_destroy(attract);
    free(watched.depth);
    free(watched.spare);
    free(watched.before);
    for (int i = 0; i < PAINTING_INKS; i++) {
        free(watched.ink[i]);
    }
}
