#include "picture.h"

#include <stdlib.h>

#include "picture_work.h"
#include "team.h"

struct picture_def picture_default_def(void)
{
    struct picture_def def = {.width = 1280, .height = 720, .cells_x = 1280, .cells_y = 720, .seed = 1, .threads = 1};
    for (int i = 0; i < INK_PALETTE; i++) {
        def.ink[i] = ink_find(palettes[0].inks[i]);
    }
    return def;
}

static bool within(int value, int most)
{
    return value >= 1 && value <= most;
}

bool picture_valid(const struct picture_def *def)
{
    bool measured = def->depth_ref >= 0 && def->depth_ref <= 0;
    bool fixed = def->depth_ref >= PICTURE_DEPTH_LEAST && def->depth_ref <= PICTURE_DEPTH_MOST;
    return (measured || fixed) && def->follow >= 0 && def->follow <= 1e6f && within(def->width, PICTURE_SIZE_MAX) &&
           within(def->height, PICTURE_SIZE_MAX) && within(def->cells_x, PICTURE_CELLS_MAX) &&
           within(def->cells_y, PICTURE_CELLS_MAX) && within(def->threads, PICTURE_THREADS_MAX);
}

/* Hands out the rows of the pool; with none yet, only counts them. */
static float *take(const struct picture *picture, size_t *used, size_t floats)
{
    float *at = picture->pool ? picture->pool + *used : NULL;
    *used += floats;
    return at;
}

static size_t share_out(struct picture *picture)
{
    size_t cells = (size_t)picture->def.cells_x * (size_t)picture->def.cells_y;
    size_t width = (size_t)picture->def.width;
    size_t used = 0;
    for (int layer = 0; layer < LAYERS; layer++) {
        bool wanted = picture->def.plain ? layer == LAYER_PLAIN || layer == LAYER_LINE : layer != LAYER_PLAIN;
        if (wanted && layer != LAYER_WET && layer != LAYER_MASK) {
            picture->own[layer] = take(picture, &used, cells);
        }
    }
    if (!picture->def.plain) {
        picture->blur_wide = take(picture, &used, cells);
        picture->blur_narrow = take(picture, &used, cells);
        picture->blur_broad = take(picture, &used, cells);
    }
    for (int i = 0; i < picture->def.threads; i++) {
        struct picture_worker *worker = &picture->workers[i];
        worker->picture = picture;
        for (int layer = 0; layer < LAYERS; layer++) {
            worker->lines[layer] = take(picture, &used, width * (size_t)picture->ring_rows);
            worker->row[layer] = take(picture, &used, width);
        }
        for (int j = 0; j < 3; j++) {
            worker->relief[j] = take(picture, &used, width);
            worker->film[j] = take(picture, &used, width);
        }
        worker->light = take(picture, &used, width);
        worker->gloss = take(picture, &used, width);
        worker->thickness = take(picture, &used, width);
        worker->streaks = take(picture, &used, width);
        worker->cells[0] = take(picture, &used, (size_t)picture->def.cells_x);
        worker->cells[1] = take(picture, &used, (size_t)picture->def.cells_x);
    }
    return used;
}

bool picture_resampler(struct resample *resample, int cells, int pixels, bool smooth)
{
    /* Between Mitchell and the B-spline: sharper beads along thin gaps, smoother melts them. */
    return smooth ? resample_init(resample, cells, pixels, 1, 0)
                  : resample_init(resample, cells, pixels, 0.65f, 0.175f);
}

/* The depth_ref of a picture from that of the one before (0: none) and the measured one. */
static float follow_depth(const struct picture_def *def, float before, float measured)
{
    if (def->depth_ref > 0) {
        return def->depth_ref;
    }
    /* 0 before the first picture. */
    return before > 0 && def->follow > 1 ? before + (measured - before) / def->follow : measured;
}

static bool init_resamplers(struct picture *picture)
{
    const struct picture_def *def = &picture->def;
    picture->ring_rows = 0;
    for (int i = 0; i < 2; i++) {
        if (!picture_resampler(&picture->across[i], def->cells_x, def->width, i) ||
            !picture_resampler(&picture->down[i], def->cells_y, def->height, i)) {
            return false;
        }
    }
    picture->ring_rows = picture->down[0].taps + def->cells_y / def->height + 2;
    return true;
}

struct picture *picture_create(const struct picture_def *def)
{
    if (!picture_valid(def)) {
        return NULL;
    }
    struct picture *picture = calloc(1, sizeof *picture);
    if (!picture) {
        return NULL;
    }
    picture->def = *def;
    picture->table = ink_table_create(def->ink, def->mixing);
    float pixels_x = (float)def->width / (float)def->cells_x;
    float pixels_y = (float)def->height / (float)def->cells_y;
    if (!picture->table || !grain_init(&picture->grain, def->seed, pixels_x, pixels_y) || !init_resamplers(picture)) {
        picture_destroy(picture);
        return NULL;
    }
    picture->pool = calloc(share_out(picture), sizeof *picture->pool);
    picture->team = team_create(def->threads);
    if (!picture->pool || !picture->team) {
        picture_destroy(picture);
        return NULL;
    }
    share_out(picture);
    picture->wide = blur_of(4);
    picture->narrow = blur_of(0.8f);
    picture->broad = blur_of(5);
    for (int i = 0; i < SRGB_STEPS; i++) {
        float root = (float)i / (SRGB_STEPS - 1);
        picture->srgb[i] = 255 * ink_encode(root * root);
    }
    return picture;
}

void picture_destroy(struct picture *picture)
{
    if (!picture) {
        return;
    }
    team_destroy(picture->team);
    for (int i = 0; i < 2; i++) {
        resample_finish(&picture->across[i]);
        resample_finish(&picture->down[i]);
    }
    grain_finish(&picture->grain);
    ink_table_destroy(picture->table);
    free(picture->pool);
    free(picture);
}

/* Rows handed out in bands. Each row is made the same way whichever member makes it. */
struct shift {
    struct picture *picture;
    void (*work)(struct picture_worker *worker, int y0, int y1);
    int rows, band;
};

static void do_band(void *context, int piece, int member)
{
    const struct shift *shift = context;
    int y0 = piece * shift->band;
    int y1 = y0 + shift->band < shift->rows ? y0 + shift->band : shift->rows;
    shift->work(&shift->picture->workers[member], y0, y1);
}

static void share_work(struct picture *picture, void (*work)(struct picture_worker *, int, int), int rows, int band)
{
    struct shift shift = {.picture = picture, .work = work, .rows = rows, .band = band};
    team_run(picture->team, do_band, &shift, (rows + band - 1) / band);
}

void picture_draw(struct picture *picture, const struct picture_planes *planes, uint8_t *rgb)
{
    const int cell_band = 16;
    const int pixel_band = 64; /* a band resamples four rows of cells again that its neighbour had */
    int cell_rows = picture->def.cells_y;
    picture->planes = *planes;
    picture->rgb = rgb;
    atomic_store(&picture->inked, 0);
    if (picture->def.plain) {
        share_work(picture, picture_prepare_plain, cell_rows, cell_band);
    } else {
        picture->depth_ref = follow_depth(&picture->def, picture->depth_ref, picture_depth_ref(picture));
        share_work(picture, picture_prepare_across, cell_rows, cell_band);
        share_work(picture, picture_prepare_down, cell_rows, cell_band);
    }
    unsigned inked = atomic_load(&picture->inked);
    for (int layer = 0; layer < LAYERS; layer++) {
        picture->layer[layer] = picture->own[layer];
    }
    for (int i = 0; i < INK_PALETTE; i++) {
        const float *ink = picture->def.plain ? planes->ink[i] : picture->own[LAYER_INK + i];
        picture->layer[LAYER_INK + i] = inked >> i & 1 ? ink : NULL;
    }
    picture->layer[LAYER_LINE] = inked >> INK_PALETTE & 1 ? picture->own[LAYER_LINE] : NULL;
    picture->layer[LAYER_BODY] = inked ? picture->own[LAYER_BODY] : NULL;
    picture->layer[LAYER_WET] = picture->def.plain ? NULL : planes->solvent;
    picture->layer[LAYER_MASK] = planes->mask;
    share_work(picture, picture_shade, picture->def.height, pixel_band);
}
