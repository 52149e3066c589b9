/* What has grown in a garden, as pixels: band by band, each of which fits into the cache. */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "garden_glow.h"
#include "garden_state.h"
#include "growth_paint.h"

enum {
    BAND = 48, /* rows */
    BAND_PLANES = 5,
};

struct span {
    float top, bottom; /* rows of the plate */
};

struct brushwork {
    const struct garden *garden;
    struct plate *plate;
    struct growth_shade shade;
    struct growth_paint_def def;
    struct stroke_raster raster;
    struct glow_map glow;
    struct span *spans; /* of each stroke */
    float *band;        /* red, green, blue, all by alpha; alpha; birth */
    int above;          /* rows of the raster above the band */
};

static void find_spans(struct brushwork *work)
{
    const struct strokes *strokes = &work->garden->strokes;
    const struct stroke_raster *raster = &work->raster;
    for (int32_t s = 0; s < strokes->count; s++) {
        const struct stroke *stroke = &strokes->strokes[s];
        float top = FLT_MAX, bottom = -FLT_MAX;
        for (int32_t i = 0; i < stroke->count; i++) {
            const struct stroke_point *point = &strokes->points[stroke->first + i];
            float y = work->def.top + (point->y + 0.5f) * raster->scale, wide = point->radius * raster->scale + 2;
            top = y - wide < top ? y - wide : top;
            bottom = y + wide > bottom ? y + wide : bottom;
        }
        work->spans[s] = (struct span){top, bottom};
    }
}

/* Lays a colour over the band; `opaque` 0..1. */
static inline void lay(float *pixel, const float rgb[3], float opaque, float birth)
{
    float left = 1 - opaque;
    for (int c = 0; c < 3; c++) {
        pixel[c] = pixel[c] * left + rgb[c] * opaque;
    }
    if (opaque >= pixel[3] * left) { /* it is what is seen there */
        pixel[4] = birth;
    }
    pixel[3] = pixel[3] * left + opaque;
}

/* The lower right rim of a crack catches the light. */
static void lay_rim(struct brushwork *work, int row, float *line)
{
    const struct stroke_raster *raster = &work->raster;
    size_t apart = (size_t)work->above;
    const float *here = raster->cover + (size_t)(row + work->above) * (size_t)raster->width;
    const float *there = here - apart * (size_t)raster->width - apart;
    const float *birth = raster->birth + (there - raster->cover);
    for (size_t x = apart; x < (size_t)raster->width; x++) {
        float rim = there[x] - here[x];
        if (rim > 0) {
            lay(line + BAND_PLANES * x, work->shade.light, 0.6f * rim, birth[x]);
        }
    }
}

static void lay_kind(struct brushwork *work, int rows)
{
    const struct stroke_raster *raster = &work->raster;
    bool rim = work->garden->def.growth.metaphor == METAPHOR_CRACKS && work->shade.kind == STROKE_BRANCH;
    for (int row = 0; row < rows; row++) {
        float *line = work->band + (size_t)row * (size_t)raster->width * BAND_PLANES;
        size_t from = (size_t)(row + work->above) * (size_t)raster->width;
        if (rim) {
            lay_rim(work, row, line);
        }
        for (int x = 0; x < raster->width; x++) {
            size_t i = from + (size_t)x;
            if (raster->cover[i] > 0) {
                float colour[3];
                float opaque = raster->cover[i] * growth_colour(&work->shade, raster, x, row + work->above, colour);
                lay(line + BAND_PLANES * (size_t)x, colour, opaque, raster->birth[i]);
            }
        }
    }
}

static uint8_t byte_of(float value)
{
    return (uint8_t)(value > 0 ? value < 1 ? value * 255 + 0.5f : 255 : 0);
}

static void finish_band(struct brushwork *work, int top, int rows)
{
    size_t pixels = (size_t)rows * (size_t)work->plate->width;
    uint8_t *rgba = work->plate->rgba + 4 * (size_t)top * (size_t)work->plate->width;
    float *birth = work->plate->birth + (size_t)top * (size_t)work->plate->width;
    for (size_t i = 0; i < pixels; i++) {
        const float *pixel = work->band + BAND_PLANES * i;
        uint8_t alpha = byte_of(pixel[3]);
        if (alpha == 0) {
            continue; /* the plate is clear */
        }
        for (int c = 0; c < 3; c++) {
            uint8_t value = byte_of(pixel[c]);
            rgba[4 * i + (size_t)c] = value < alpha ? value : alpha;
        }
        rgba[4 * i + 3] = alpha;
        birth[i] = pixel[4];
    }
}

/* Draws the strokes of a kind that reach into the band; whether there are any. */
static bool draw_kind(struct brushwork *work, enum stroke_kind kind, int top, int rows)
{
    const struct strokes *strokes = &work->garden->strokes;
    bool any = false;
    for (int32_t s = 0; s < strokes->count; s++) {
        if (strokes->strokes[s].kind == kind && work->spans[s].bottom >= (float)(top - work->above) &&
            work->spans[s].top <= (float)(top + rows)) {
            if (!any) {
                stroke_raster_clear(&work->raster);
            }
            any = true;
            stroke_raster_stroke(&work->raster, strokes, s, FLT_MAX);
        }
    }
    return any;
}

static void paint_band(struct brushwork *work, int top, int rows)
{
    static const enum stroke_kind ORDER[] = {STROKE_NEEDLE, STROKE_TENDRIL, STROKE_BRANCH, STROKE_LEAF};
    struct stroke_raster *raster = &work->raster;
    size_t pixels = (size_t)rows * (size_t)work->plate->width;
    bool any = false;
    raster->top = work->def.top - (float)(top - work->above);
    raster->row = top;
    memset(work->band, 0, pixels * BAND_PLANES * sizeof *work->band);
    for (int y = 0; y < rows && work->glow.rgb; y++) {
        float *line = work->band + (size_t)y * (size_t)work->plate->width * BAND_PLANES;
        for (int x = 0; x < work->plate->width; x++) {
            any = glow_map_at(&work->glow, (float)x, (float)(top + y), line + BAND_PLANES * (size_t)x) || any;
        }
    }
    for (size_t k = 0; k < sizeof ORDER / sizeof *ORDER; k++) {
        work->shade.kind = (int)ORDER[k];
        if (draw_kind(work, ORDER[k], top, rows)) {
            lay_kind(work, rows);
            any = true;
        }
    }
    if (any) {
        finish_band(work, top, rows);
    }
}

/* Metaphors with a ground of their own: a night, a window. */
static void lay_ground(struct brushwork *work)
{
    int metaphor = work->garden->def.growth.metaphor;
    bool own = work->garden->stock && (metaphor == METAPHOR_LIGHTNING || metaphor == METAPHOR_FROST);
    memset(work->plate->ground, 0, sizeof work->plate->ground);
    for (int c = 0; c < 3 && own; c++) {
        work->plate->ground[c] = byte_of(work->shade.haze[c]);
        work->plate->ground[3] = 255;
    }
}

bool garden_paint(struct garden *garden, struct plate *plate)
{
    const struct bed *bed = garden->bed;
    struct brushwork work = {.garden = garden, .plate = plate};
    int metaphor = garden->def.growth.metaphor;
    garden->growth.def.metaphor = metaphor;
    work.shade = (struct growth_shade){.growth = &garden->growth, .def = &work.def};
    growth_match(&work.shade);
    plate_clear(plate);
    plate->tick = garden->origin;
    lay_ground(&work);
    if (!bed || garden->strokes.count == 0) {
        return true;
    }
    float scale = (float)plate->width / (float)bed->width;
    work.def = (struct growth_paint_def){.width = plate->width,
                                         .height = plate->height,
                                         .scale = scale * bed->unit,
                                         .top = 0.5f * ((float)plate->height - scale * (float)bed->height)};
    work.above = metaphor == METAPHOR_CRACKS ? 1 + (int)(0.6f * work.def.scale) : 0;
    work.spans = malloc((size_t)garden->strokes.count * sizeof *work.spans);
    work.band = malloc((size_t)plate->width * BAND * BAND_PLANES * sizeof *work.band);
    bool good = work.spans && work.band &&
                stroke_raster_init(&work.raster, plate->width, BAND + work.above, work.def.scale, 0, 0) &&
                glow_map_init(&work.glow, metaphor, &garden->strokes, &work.def);
    if (good) {
        find_spans(&work);
        for (int top = 0; top < plate->height; top += BAND) {
            paint_band(&work, top, plate->height - top < BAND ? plate->height - top : BAND);
        }
    }
    glow_map_finish(&work.glow);
    stroke_raster_finish(&work.raster);
    free(work.band);
    free(work.spans);
    return good;
}
