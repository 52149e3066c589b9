/* What many charges do, summed on a coarse lattice over the sheet: particles of other bolts, and what is painted. A sum
 * is of 1 / distance, in places of the lattice; nearer than NEAREST of them it is what it is there. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "storm_state.h"

static const float NEAREST = 0.75f;

bool storm_lattice_init(struct storm *storm)
{
    int width = storm->width, height = storm->height, longer = width > height ? width : height;
    storm->columns = (int)(((int64_t)STORM_LATTICE * width + longer / 2) / longer);
    storm->rows = (int)(((int64_t)STORM_LATTICE * height + longer / 2) / longer);
    storm->mask_columns = (int)(((int64_t)STORM_MASK * width + longer / 2) / longer);
    storm->mask_rows = (int)(((int64_t)STORM_MASK * height + longer / 2) / longer);
    int *sizes[] = {&storm->columns, &storm->rows, &storm->mask_columns, &storm->mask_rows};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        *sizes[i] = *sizes[i] < 2 ? 2 : *sizes[i];
    }
    int wide = 2 * storm->columns - 1;
    size_t places = (size_t)storm->columns * (size_t)storm->rows,
           masks = (size_t)storm->mask_columns * (size_t)storm->mask_rows;
    storm->kernel = malloc((size_t)wide * (size_t)storm->rows * sizeof(float));
    storm->painted = calloc(places, sizeof(float));
    storm->sources = calloc(places, sizeof(float));
    storm->mask = malloc(masks * sizeof(float));
    storm->scar = calloc(masks, 1);
    if (!storm->kernel || !storm->painted || !storm->sources || !storm->mask || !storm->scar) {
        return false;
    }
    for (int y = 0; y < storm->rows; y++) {
        for (int x = 0; x < wide; x++) {
            float dx = (float)(x - (storm->columns - 1)), dy = (float)y, far = sqrtf(dx * dx + dy * dy);
            storm->kernel[y * wide + x] = 1 / (far > NEAREST ? far : NEAREST);
        }
    }
    for (size_t i = 0; i < masks; i++) {
        storm->mask[i] = 1;
    }
    return true;
}

void storm_lattice_finish(struct storm *storm)
{
    free(storm->kernel);
    free(storm->painted);
    free(storm->sources);
    free(storm->mask);
    free(storm->scar);
    storm->scar = NULL;
    storm->kernel = storm->painted = storm->sources = storm->mask = NULL;
}

/* A charge shared by the four places around it; x, y in 0..1 of the sheet. */
static void put(const struct storm *storm, float *sources, float x, float y, float charge)
{
    float right = (float)(storm->columns - 1), bottom = (float)(storm->rows - 1);
    float u = x * (float)storm->columns - 0.5f, v = y * (float)storm->rows - 0.5f;
    u = u > 0 ? fminf(u, right) : 0;
    v = v > 0 ? fminf(v, bottom) : 0;
    int column = (int)u, row = (int)v;
    column = column < storm->columns - 1 ? column : storm->columns - 2;
    row = row < storm->rows - 1 ? row : storm->rows - 2;
    u -= (float)column;
    v -= (float)row;
    float *here = sources + row * storm->columns + column, *below = here + storm->columns;
    here[0] += charge * (1 - u) * (1 - v);
    here[1] += charge * u * (1 - v);
    below[0] += charge * (1 - u) * v;
    below[1] += charge * u * v;
}

float storm_sample(const struct storm *storm, const float *lattice, float x, float y)
{
    float u = x * (float)storm->columns - 0.5f, v = y * (float)storm->rows - 0.5f;
    u = u > 0 ? fminf(u, (float)(storm->columns - 1)) : 0;
    v = v > 0 ? fminf(v, (float)(storm->rows - 1)) : 0;
    int column = (int)u, row = (int)v;
    column = column < storm->columns - 1 ? column : storm->columns - 2;
    row = row < storm->rows - 1 ? row : storm->rows - 2;
    u -= (float)column;
    v -= (float)row;
    const float *here = lattice + row * storm->columns + column, *below = here + storm->columns;
    return (1 - v) * ((1 - u) * here[0] + u * here[1]) + v * ((1 - u) * below[0] + u * below[1]);
}

/* Adds what the sources make all over, and takes them away. */
static void spread(const struct storm *storm, float *sources, float *potential)
{
    int columns = storm->columns, rows = storm->rows, wide = 2 * columns - 1;
    for (int row = 0; row < rows; row++) {
        for (int column = 0; column < columns; column++) {
            float charge = sources[row * columns + column];
            if (charge == 0) {
                continue;
            }
            sources[row * columns + column] = 0;
            for (int y = 0; y < rows; y++) {
                const float *kernel = storm->kernel + abs(y - row) * wide + (columns - 1 - column);
                float *out = potential + y * columns;
                for (int x = 0; x < columns; x++) {
                    out[x] += charge * kernel[x];
                }
            }
        }
    }
}

static void put_nodes(const struct storm *storm, const struct storm_bolt *bolt, int32_t first, float *sources)
{
    float across = bolt->scale / bolt->width, down = bolt->scale / bolt->height;
    for (int32_t i = first; i < bolt->count; i++) {
        const struct storm_node *node = &bolt->nodes[i];
        put(storm, sources, 0.5f + node->at[0] * across, 0.5f + node->at[1] * down, 1);
    }
}

void storm_deposit(struct storm *storm, struct storm_bolt *bolt)
{
    if (bolt->deposited < bolt->count) {
        put_nodes(storm, bolt, bolt->deposited, storm->sources);
        spread(storm, storm->sources, bolt->potential);
        bolt->deposited = bolt->count;
        storm->changed++;
    }
}

static bool counts(const struct storm_bolt *bolt)
{
    return bolt->lives && bolt->undone == 0 && !bolt->leaves;
}

void storm_feel(struct storm *storm, struct storm_bolt *bolt)
{
    int places = storm->columns * storm->rows;
    float *sum = bolt->background[1 - bolt->turn], spacing = bolt->width / bolt->scale / (float)storm->columns;
    float others = storm->def.repel / spacing, painted = storm_felt(bolt) / spacing;
    for (int i = 0; i < places; i++) {
        sum[i] = -painted * storm->painted[i];
    }
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        const struct storm_bolt *other = &storm->bolts[slot];
        if (other != bolt && counts(other) && others != 0) {
            for (int i = 0; i < places; i++) {
                sum[i] += others * other->potential[i];
            }
        }
    }
    bolt->turn = 1 - bolt->turn;
    bolt->felt = storm->changed;
    bolt->felt_count = bolt->count;
    const struct action_raster raster = {sum, storm->columns, storm->rows, 1};
    laplacian_background(bolt->laplacian, &raster);
}

bool storm_potential(const struct storm *storm, float *potential)
{
    size_t places = (size_t)storm->columns * (size_t)storm->rows;
    float *sources = calloc(places, sizeof *sources);
    if (!sources) {
        return false;
    }
    memset(potential, 0, places * sizeof *potential);
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        if (counts(&storm->bolts[slot])) {
            put_nodes(storm, &storm->bolts[slot], 0, sources);
        }
    }
    spread(storm, sources, potential);
    free(sources);
    return true;
}

void storm_strokes_sum(struct storm *storm)
{
    memset(storm->painted, 0, (size_t)storm->columns * (size_t)storm->rows * sizeof(float));
    for (int i = 0; i < STORM_STROKES; i++) {
        const struct storm_stroke *stroke = &storm->strokes[i];
        for (int k = 0; stroke->lives && stroke->undone == 0 && k < stroke->count; k++) {
            struct point a = stroke->points[k > 0 ? k - 1 : 0], b = stroke->points[k];
            float dx = (b.x - a.x) * (float)storm->width, dy = (b.y - a.y) * (float)storm->height;
            float length = stroke->count == 1 ? 1 : sqrtf(dx * dx + dy * dy);
            int pieces = (int)(length * (float)storm->columns / (float)storm->width) * 2 + 1;
            for (int p = 0; p < pieces; p++) {
                float t = ((float)p + 0.5f) / (float)pieces;
                put(storm, storm->sources, a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
                    stroke->charge * length / (float)pieces);
            }
        }
    }
    spread(storm, storm->sources, storm->painted);
    storm->strokes_changed = false;
    storm->changed++;
}

static struct point legal(struct point at)
{
    at.x = at.x >= 0 ? fminf(at.x, 1) : 0; /* NaN becomes 0 */
    at.y = at.y >= 0 ? fminf(at.y, 1) : 0;
    return at;
}

static void take_stroke(struct storm *storm, const struct action *action)
{
    struct storm_stroke *oldest = &storm->strokes[0];
    storm_forget_undone(storm, action->visitor);
    for (int i = 0; i < STORM_STROKES && oldest->lives; i++) {
        struct storm_stroke *stroke = &storm->strokes[i];
        oldest = !stroke->lives || stroke->serial < oldest->serial ? stroke : oldest;
    }
    int given = action->path.count, count = given < STORM_POINTS ? given : STORM_POINTS;
    *oldest = (struct storm_stroke){
        .lives = true, .serial = ++storm->serial, .visitor = action->visitor, .charge = action->amount, .count = count};
    for (int i = 0; i < count; i++) { /* of too many, every so many */
        int64_t from = count > 1 ? (int64_t)i * (given - 1) / (count - 1) : 0;
        oldest->points[i] = legal(action->path.points[from]);
    }
    storm->strokes_changed = true;
}

void storm_attract(struct storm *storm, const struct action *action)
{
    if (action->path.count > 0) {
        take_stroke(storm, action);
        return;
    }
    struct storm_hand *hand = NULL;
    for (int i = 0; i < STORM_HANDS; i++) {
        struct storm_hand *there = &storm->hands[i];
        hand = there->lies && there->visitor == action->visitor ? there : hand;
    }
    for (int i = 0; i < STORM_HANDS && !hand && action->has_at; i++) {
        hand = storm->hands[i].lies ? NULL : &storm->hands[i];
    }
    if (!hand) {
        return;
    }
    *hand = (struct storm_hand){action->has_at, action->visitor, action->at, action->amount};
    storm->hands_changed++;
    for (int slot = 0; slot < STORM_SLOTS && hand->lies && hand->charge > 0; slot++) {
        struct storm_bolt *bolt = &storm->bolts[slot];
        if (storm_bolt_grows(bolt) && bolt->aims && bolt->visitor == action->visitor) {
            bolt->target = action->at; /* a strike follows the hand that it was made with */
        }
    }
}
