#include "rinse.h"

#include <math.h>

#include "noise.h"
#include "smooth.h"

#define FARTHEST 2.0f /* sheets that a front may lie beyond one: the range of its key */
#define SLACK    0.1f /* phase that differs from place to place of the lattice, about */
#define FINEST   6.0f /* cells: features of the noise that the lattice can hold */
#define PAST     1.3f /* phase beyond which nothing is done any more */

enum { NO_LINE = -2 }; /* not even the one before the first */

static float clamp(float value, float least, float most)
{
    value = value >= least ? value : least; /* NaN becomes the least */
    return value <= most ? value : most;
}

/* Across and along the flow. */
static struct point turned(const struct rinse *rinse, float x, float y)
{
    return (struct point){rinse->flow.x * y - rinse->flow.y * x, rinse->flow.x * x + rinse->flow.y * y};
}

static void take_front(struct rinse *rinse, const struct action_path *path)
{
    float width = (float)rinse->canvas.width, height = (float)rinse->canvas.height;
    rinse->count = path->count < RINSE_POINTS ? path->count : RINSE_POINTS;
    for (int i = 0; i < rinse->count; i++) {
        struct point point = turned(rinse, clamp(path->points[i].x, -FARTHEST, 1.0f + FARTHEST) * width,
                                    clamp(path->points[i].y, -FARTHEST, 1.0f + FARTHEST) * height);
        int at = i;
        for (; at > 0 && rinse->front[at - 1].x > point.x; at--) {
            rinse->front[at] = rinse->front[at - 1];
        }
        rinse->front[at] = point;
    }
}

/* Cells of the sheet with its margin from places on the visible one. The margin has the phase of the border. */
static int first_cell(float at, int cells, int margin)
{
    return at <= 0.0f ? 0 : at >= (float)cells ? cells + 2 * margin : (int)at + margin;
}

static int end_cell(float at, int cells, int margin)
{
    return at >= (float)cells ? cells + 2 * margin : at < 0.0f ? 0 : (int)at + 1 + margin;
}

/* The cells where the phase may be `first` or more: of a front, those between the corners of its band. */
static struct rectangle bounds_of(const struct rinse *rinse, float first)
{
    const struct canvas *canvas = &rinse->canvas;
    float width = (float)canvas->width, height = (float)canvas->height;
    float x0 = width, x1 = 0.0f, y0 = height, y1 = 0.0f;
    if (rinse->disc) {
        x0 = rinse->at.x - rinse->radius, x1 = rinse->at.x + rinse->radius;
        y0 = rinse->at.y - rinse->radius, y1 = rinse->at.y + rinse->radius;
    } else {
        float least = rinse->front[0].y, most = rinse->front[0].y, across = width + height;
        for (int i = 1; i < rinse->count; i++) {
            least = rinse->front[i].y < least ? rinse->front[i].y : least;
            most = rinse->front[i].y > most ? rinse->front[i].y : most;
        }
        float ragged = RINSE_MOST * rinse->vary * rinse->depth;
        const float ALONG[] = {least - PAST * rinse->depth - ragged, most - first * rinse->depth + ragged},
                    ACROSS[] = {-across, across};
        for (int corner = 0; corner < 4; corner++) {
            float along = ALONG[corner % 2], c = ACROSS[corner / 2];
            float x = rinse->flow.x * along - rinse->flow.y * c, y = rinse->flow.y * along + rinse->flow.x * c;
            x0 = x < x0 ? x : x0, x1 = x > x1 ? x : x1;
            y0 = y < y0 ? y : y0, y1 = y > y1 ? y : y1;
        }
    }
    return (struct rectangle){
        first_cell(x0, canvas->width, canvas->margin), end_cell(x1, canvas->width, canvas->margin),
        first_cell(y0, canvas->height, canvas->margin), end_cell(y1, canvas->height, canvas->margin)};
}

void rinse_begin(struct rinse *rinse, const struct canvas *canvas, const struct action *action)
{
    float length = sqrtf(action->flow.x * action->flow.x + action->flow.y * action->flow.y);
    rinse->canvas = *canvas;
    rinse->flow = (struct point){0.0f, 1.0f};
    if (length > 1e-6f) {
        rinse->flow = (struct point){action->flow.x / length, action->flow.y / length};
    }
    float extent = fabsf(rinse->flow.x) * (float)canvas->width + fabsf(rinse->flow.y) * (float)canvas->height;
    rinse->disc = action->path.count <= 0 && action->has_at;
    rinse->at = (struct point){action->at.x * (float)canvas->width, action->at.y * (float)canvas->height};
    rinse->radius = action->radius;
    rinse->depth = action->reach * extent;
    rinse->vary = rinse->disc ? 0.0f : action->vary;
    rinse->size = clamp(0.07f * extent, FINEST, 1e4f);
    rinse->line = NO_LINE;
    rinse->count = 0;
    rinse->cells = rinse->over = (struct rectangle){0, 0, 0, 0};
    if (action->path.count > 0) {
        take_front(rinse, &action->path);
    }
    if (rinse->disc || rinse->count > 0) {
        rinse->cells = bounds_of(rinse, 0.0f);
        rinse->over = bounds_of(rinse, RINSE_OVER);
    }
}

/* Between points the front goes without corners; beyond them it goes straight across. */
static float front_at(const struct rinse *rinse, float across)
{
    const struct point *front = rinse->front;
    int last = rinse->count - 1, i = 0;
    if (across <= front[0].x) {
        return front[0].y;
    }
    while (i < last && front[i + 1].x < across) {
        i++;
    }
    if (i == last) {
        return front[last].y;
    }
    return front[i].y + (front[i + 1].y - front[i].y) * smooth_between(front[i].x, front[i + 1].x, across);
}

/* The cells of the margin are where the border is. */
static struct point place_of(const struct rinse *rinse, float x, float y)
{
    float margin = (float)rinse->canvas.margin;
    return (struct point){clamp(x - margin, 0.0f, (float)rinse->canvas.width),
                          clamp(y - margin, 0.0f, (float)rinse->canvas.height)};
}

/* How far a place is behind the front, in depths of the water; `turn` as rinse_phase says. */
static float behind_at(const struct rinse *rinse, struct point place, float *turn)
{
    const uint32_t seed = rinse->canvas.seed;
    place = turned(rinse, place.x, place.y);
    float behind = (front_at(rinse, place.x) - place.y) / rinse->depth, ragged = RINSE_MOST * rinse->vary;
    *turn = 0.0f;
    if (behind <= -ragged - SLACK || behind >= PAST + ragged + SLACK) {
        return behind;
    }
    float x = place.x, y = 0.22f * place.y; /* tongues are longer than wide */
    float early = 0.6f * noise_smooth(x, y, rinse->size, seed, RANDOM_WATER) +
                  0.25f * noise_smooth(x + 0.5f * y, y, clamp(0.4f * rinse->size, FINEST, 1e4f), seed, RANDOM_WATER) +
                  0.25f * noise_smooth(x, 0.3f * y, clamp(0.25f * rinse->size, FINEST, 1e4f), seed, RANDOM_WATER);
    *turn = clamp(noise_smooth(x, y, 0.7f * rinse->size, seed, RANDOM_WATER_TURN), -1.0f, 1.0f);
    return behind + rinse->vary * clamp(early, -RINSE_MOST, RINSE_MOST);
}

static void fill_line(const struct rinse *rinse, int line, float behind[], float turn[])
{
    int first = rinse->cells.x0 / RINSE_LATTICE, end = (rinse->cells.x1 - 1) / RINSE_LATTICE + 2;
    for (int i = first; i < end; i++) {
        struct point place = place_of(rinse, (float)(i * RINSE_LATTICE), (float)(line * RINSE_LATTICE));
        behind[i] = behind_at(rinse, place, &turn[i]);
    }
}

static void take_lines(struct rinse *rinse, int line)
{
    int slot = line & 1;
    if (rinse->line != line - 1) {
        fill_line(rinse, line, rinse->rows[slot][0], rinse->rows[slot][1]);
    }
    fill_line(rinse, line + 1, rinse->rows[!slot][0], rinse->rows[!slot][1]);
    rinse->line = line;
}

static float between(const struct rinse *rinse, int field, int x, int y)
{
    const float share = 1.0f / RINSE_LATTICE;
    int slot = (y / RINSE_LATTICE) & 1, column = x / RINSE_LATTICE;
    float u = (float)(x % RINSE_LATTICE) * share, v = (float)(y % RINSE_LATTICE) * share;
    const float *up = rinse->rows[slot][field] + column, *down = rinse->rows[!slot][field] + column;
    float top = up[0] + u * (up[1] - up[0]), bottom = down[0] + u * (down[1] - down[0]);
    return top + v * (bottom - top);
}

float rinse_phase(struct rinse *rinse, int x, int y, float *turn)
{
    *turn = 0.0f;
    if (rinse->disc) {
        struct point cell = place_of(rinse, (float)x + 0.5f, (float)y + 0.5f);
        float dx = cell.x - rinse->at.x, dy = cell.y - rinse->at.y, away = sqrtf(dx * dx + dy * dy);
        return away < rinse->radius ? 0.8f * (1.0f - away / rinse->radius) : 0.0f;
    }
    if (y / RINSE_LATTICE != rinse->line) {
        take_lines(rinse, y / RINSE_LATTICE);
    }
    float behind = between(rinse, 0, x, y);
    if (behind <= 0.0f || behind > PAST) {
        return 0.0f;
    }
    *turn = between(rinse, 1, x, y);
    return behind < 1.0f ? behind : 1.0f;
}

bool rinse_is_over(struct rinse *rinse, int x, int y)
{
    float turn;
    return rinse_phase(rinse, x, y, &turn) >= RINSE_OVER;
}

struct rinse_shares rinse_shares(float phase, float strength)
{
    float comes = smooth_between(0.0f, 0.15f, phase), goes = smooth_between(0.2f, 0.85f, phase),
          last = smooth_between(0.75f, RINSE_OVER, phase);
    float wets = 3.0f * strength * comes, drains = phase < RINSE_OVER ? last * last : 1.0f;
    float thins = strength * (0.1f * comes + 0.9f * goes) + drains;
    return (struct rinse_shares){wets < 1.0f ? wets : 1.0f, thins < 1.0f ? thins : 1.0f, drains};
}

float rinse_takes(float phase, float strength)
{
    return phase >= RINSE_OVER ? 1.0f : rinse_shares(phase, strength).thins;
}
