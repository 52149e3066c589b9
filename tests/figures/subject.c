#include "subject.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "picture.h"

enum { PLANE_SOLVENT = PAINTING_INKS, PLANE_SPARE, PLANES };

static void *take(size_t count, size_t size, const char *what)
{
    void *memory = calloc(count, size);
    if (!memory) {
        figure_stop(what, "no memory");
    }
    return memory;
}

struct painting_def subject_def(int size)
{
    struct painting_def def = painting_default_def();
    def.width = def.height = size;
    def.threads = 1;
    return def;
}

struct subject subject_create(const struct painting_def *def)
{
    struct subject subject = {.painting = painting_create(def), .width = def->width, .height = def->height};
    if (!subject.painting) {
        figure_stop("painting", "no memory, or no legal size");
    }
    subject.cells = (size_t)def->width * (size_t)def->height;
    subject.depth = take(subject.cells, sizeof(float), "plane");
    subject.planes = take(PLANES * subject.cells, sizeof(float), "planes");
    subject.x = def->width / 2 + 0.5;
    subject.y = def->height / 2 + 0.5;
    for (int i = 0; i < INK_PALETTE; i++) {
        subject.inks[i] = ink_find(palettes[0].inks[i]);
    }
    return subject;
}

void subject_finish(struct subject *subject)
{
    painting_destroy(subject->painting);
    free(subject->depth);
    free(subject->planes);
    *subject = (struct subject){0};
}

struct action subject_drop(float x, float y)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){x, y};
    drop.has_at = true;
    return drop;
}

void subject_run(struct subject *subject, int ticks)
{
    for (int tick = 0; tick < ticks; tick++) {
        painting_tick(subject->painting);
    }
}

const float *subject_read(struct subject *subject, enum painting_field field)
{
    float *plane = subject->planes + PLANE_SPARE * subject->cells;
    painting_read(subject->painting, field, plane);
    return plane;
}

const float *subject_depth(struct subject *subject)
{
    painting_read(subject->painting, PAINTING_ACTIVE, subject->depth);
    const float *carved = subject_read(subject, PAINTING_CARVED);
    for (size_t i = 0; i < subject->cells; i++) {
        subject->depth[i] += carved[i];
    }
    return subject->depth;
}

struct shape_figures subject_measure(struct subject *subject)
{
    struct shape_def def = shape_default_def();
    def.width = subject->width;
    def.height = subject->height;
    def.has_centre = true;
    def.centre_x = subject->x;
    def.centre_y = subject->y;
    struct shape_figures figures;
    if (!shape_measure(&def, subject_depth(subject), &figures)) {
        figure_stop("figures of a shape", "no memory");
    }
    return figures;
}

int64_t subject_area(struct subject *subject)
{
    const float *depth = subject_depth(subject);
    int64_t area = 0;
    for (size_t i = 0; i < subject->cells; i++) {
        area += depth[i] > 0.1f;
    }
    return area;
}

static uint8_t *take_pixels(int side)
{
    return take((size_t)side * (size_t)side, 3, "pixels");
}

void subject_show_depth(struct subject *subject, struct sheet *sheet, const char *label, ...)
{
    char text[256];
    va_list arguments;
    va_start(arguments, label);
    vsnprintf(text, sizeof text, label, arguments);
    va_end(arguments);
    uint8_t *rgb = take_pixels(sheet_side(sheet));
    int side = sheet_side(sheet);
    if (!picture_grey(subject_depth(subject), subject->width, subject->height, 0.0f, 0.9f, side, side, rgb)) {
        figure_stop("greys", "no memory, or no legal size");
    }
    sheet_add(sheet, rgb, "%s", text);
    free(rgb);
}

/* Wet plus dry pigment, solvent, mask and depth, as the picture wants them. */
static struct picture_planes gather(struct subject *subject)
{
    struct picture_planes planes = {.depth = subject_depth(subject)};
    for (int ink = 0; ink < PAINTING_INKS; ink++) {
        float *sum = subject->planes + (size_t)ink * subject->cells;
        painting_read(subject->painting, (enum painting_field)(PAINTING_WET + ink), sum);
        const float *dry = subject_read(subject, (enum painting_field)(PAINTING_DRY + ink));
        for (size_t i = 0; i < subject->cells; i++) {
            sum[i] += dry[i];
        }
        planes.ink[ink] = sum;
    }
    float *solvent = subject->planes + PLANE_SOLVENT * subject->cells;
    painting_read(subject->painting, PAINTING_SOLVENT, solvent);
    planes.solvent = solvent;
    planes.mask = subject_read(subject, PAINTING_MASK);
    return planes;
}

uint8_t *subject_picture(struct subject *subject, int side, enum subject_light light)
{
    struct picture_def def = picture_default_def();
    def.width = def.height = side;
    def.cells_x = subject->width;
    def.cells_y = subject->height;
    def.plain = light != SUBJECT_LIT;
    def.mixing = light == SUBJECT_PLAIN_CMY ? INK_CMY : def.mixing;
    memcpy(def.ink, subject->inks, sizeof def.ink);
    struct picture *picture = picture_create(&def);
    if (!picture) {
        figure_stop("picture", "no memory, or no legal size");
    }
    uint8_t *rgb = take_pixels(side);
    struct picture_planes planes = gather(subject);
    picture_draw(picture, &planes, rgb);
    picture_destroy(picture);
    return rgb;
}

void subject_show_ink(struct subject *subject, struct sheet *sheet, enum subject_light light, const char *label, ...)
{
    char text[256];
    va_list arguments;
    va_start(arguments, label);
    vsnprintf(text, sizeof text, label, arguments);
    va_end(arguments);
    uint8_t *rgb = subject_picture(subject, sheet_side(sheet), light);
    sheet_add(sheet, rgb, "%s", text);
    free(rgb);
}

static void show_grown(struct subject *subject, struct sheet *sheet, const char *label,
                       const struct shape_figures *shape)
{
    if (sheet) {
        subject_show_depth(subject, sheet, "%s\nR %.0f, %.3f edge, %.1f junctions\n%.1f tips, %.2f hull, %.1f wide",
                           label, shape->radius, shape->perimeter_per_cell, shape->junctions_per_1000,
                           shape->tips_per_1000, shape->hull_share, shape->mean_width);
    }
}

struct shape_figures subject_grow(const struct painting_def *def, int ticks, struct sheet *sheet, const char *label,
                                  ...)
{
    char text[128];
    va_list arguments;
    va_start(arguments, label);
    vsnprintf(text, sizeof text, label, arguments);
    va_end(arguments);
    struct subject subject = subject_create(def);
    struct action drop = subject_drop(0.5f, 0.5f);
    painting_act(subject.painting, &drop);
    subject_run(&subject, ticks);
    struct shape_figures shape = subject_measure(&subject);
    show_grown(&subject, sheet, text, &shape);
    subject_finish(&subject);
    return shape;
}

struct shape_figures subject_grow_to(const struct painting_def *def, double radius, int most, struct sheet *sheet,
                                     const char *label, ...)
{
    char text[128];
    va_list arguments;
    va_start(arguments, label);
    vsnprintf(text, sizeof text, label, arguments);
    va_end(arguments);
    struct subject subject = subject_create(def);
    struct action drop = subject_drop(0.5f, 0.5f);
    painting_act(subject.painting, &drop);
    struct shape_figures shape = {0};
    for (int tick = 0; tick < most && shape.radius < radius; tick += 10) {
        subject_run(&subject, 10);
        shape = subject_measure(&subject);
    }
    show_grown(&subject, sheet, text, &shape);
    subject_finish(&subject);
    return shape;
}
