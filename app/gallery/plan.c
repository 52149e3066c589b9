#include "plan.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "branches.h"

enum { MICRONS = 1000, NUMBER = 24 };

struct plan {
    char *text;
    size_t length, size;
    bool short_of_memory;
    double scale; /* microns a cell */
};

__attribute__((format(printf, 2, 3))) static void write_text(struct plan *plan, const char *format, ...)
{
    char piece[512];
    va_list arguments;
    va_start(arguments, format);
    size_t length = (size_t)vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    if (plan->length + length + 1 > plan->size) {
        size_t size = 2 * (plan->length + length + 1);
        char *larger = realloc(plan->text, size);
        if (!larger) {
            plan->short_of_memory = true;
            return;
        }
        plan->text = larger;
        plan->size = size;
    }
    memcpy(plan->text + plan->length, piece, length + 1);
    plan->length += length;
}

/* Millimetres, whatever the locale writes between them and their parts. */
static const char *millimetres(long microns, char text[NUMBER])
{
    long rest = labs(microns) % MICRONS;
    int length = snprintf(text, NUMBER, "%s%ld", microns < 0 ? "-" : "", labs(microns) / MICRONS);
    if (rest > 0) {
        length += snprintf(text + length, (size_t)(NUMBER - length), ".%03ld", rest);
        while (text[length - 1] == '0') {
            text[--length] = '\0';
        }
    }
    return text;
}

static void write_point(struct plan *plan, char before, struct branch_point point)
{
    char x[NUMBER], y[NUMBER];
    write_text(plan, "%c%s %s", before, millimetres(lround((double)point.x * plan->scale), x),
               millimetres(lround((double)point.y * plan->scale), y));
}

/* The direction of the curve in a point, from the one before to the one after; of length 1 or 0. */
static struct branch_point direction(struct branch_point before, struct branch_point after)
{
    float x = after.x - before.x, y = after.y - before.y, length = hypotf(x, y);
    return length > 0 ? (struct branch_point){x / length, y / length} : (struct branch_point){0, 0};
}

static struct branch_point beyond(struct branch_point from, struct branch_point along, float by)
{
    return (struct branch_point){from.x + by * along.x, from.y + by * along.y};
}

/* Curves through the points whose handles are a third of their pieces, so that none swings out. */
static void write_curves(struct plan *plan, const struct branch_point *points, int count)
{
    write_point(plan, 'M', points[0]);
    for (int i = 0; i + 1 < count; i++) {
        struct branch_point from = points[i], to = points[i + 1];
        struct branch_point before = i > 0 ? points[i - 1] : from;
        struct branch_point after = i + 2 < count ? points[i + 2] : to;
        float third = hypotf(to.x - from.x, to.y - from.y) / 3;
        write_point(plan, 'C', beyond(from, direction(before, to), third));
        write_point(plan, ' ', beyond(to, direction(from, after), -third));
        write_point(plan, ' ', to);
    }
}

static void write_branch(struct plan *plan, const struct branches *branches, const struct branch *branch)
{
    const struct branch_point *points = branches->points + branch->first;
    char width[NUMBER];
    write_text(plan, "<path stroke-width=\"%s\" d=\"", millimetres(lround((double)branch->width * plan->scale), width));
    if (branch->count == 1) { /* a dot: round ends make it one, and a machine needs some length */
        write_point(plan, 'M', beyond(points[0], (struct branch_point){1, 0}, -0.1f));
        write_point(plan, 'L', beyond(points[0], (struct branch_point){1, 0}, 0.1f));
    } else if (branch->count == 2) {
        write_point(plan, 'M', points[0]);
        write_point(plan, 'L', points[1]);
    } else {
        write_curves(plan, points, branch->count);
    }
    write_text(plan, "\"/>\n");
}

char *plan_svg(const float *depth, int width, int height, double paper_mm, size_t *size)
{
    struct branches branches;
    struct plan plan = {.scale = paper_mm * MICRONS / width};
    char across[NUMBER], down[NUMBER];
    if (!branches_find(depth, width, height, &branches)) {
        return NULL;
    }
    millimetres(lround(width * plan.scale), across);
    millimetres(lround(height * plan.scale), down);
    write_text(&plan,
               "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%smm\" height=\"%smm\" viewBox=\"0 0 %s %s\">\n"
               "<g fill=\"none\" stroke=\"black\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
               across, down, across, down);
    for (int i = 0; i < branches.count; i++) {
        write_branch(&plan, &branches, &branches.list[i]);
    }
    write_text(&plan, "</g>\n</svg>\n");
    branches_finish(&branches);
    if (plan.short_of_memory) {
        free(plan.text);
        return NULL;
    }
    *size = plan.length;
    return plan.text;
}
