#include "gray_scott_classes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "components.h"

const char *const gray_scott_class_names[CLASSES + 1] = {"uniform", "spots", "worms", "holes", "waves", NULL};

#define PRESETS(ROW)                                                                                                   \
    ROW("wavelets", "α", 0.010f, 0.047f, START_SPOTS, 10, CLASS_WAVES,                                                 \
        "Wavelets that break, meet and put each other out.")                                                           \
    ROW("voids", "β", 0.026f, 0.051f, START_SPOTS, 10, CLASS_WAVES, "An ocean in which voids open and fill.")          \
    ROW("ripples", "γ", 0.024f, 0.0515f, START_SPOTS, 10, CLASS_WAVES,                                                 \
        "Holes and stripes that flicker and never rest.")                                                              \
    ROW("honeycomb", "δ", 0.042f, 0.059f, START_NOISE, 10, CLASS_HOLES, "Holes that settle into a honeycomb.")         \
    ROW("cells", "ε", 0.018f, 0.055f, START_SPOTS, 10, CLASS_WAVES,                                                    \
        "Rings and spots that crowd each other out, for ever.")                                                        \
    ROW("crowd", "ζ", 0.022f, 0.059f, START_SPOTS, 10, CLASS_WAVES, "Spots that divide and overcrowd.")                \
    ROW("worms_and_spots", "η", 0.034f, 0.0618f, START_NOISE, 10, CLASS_WORMS, "Short worms among spots.")             \
    ROW("fingerprint", "θ", 0.037f, 0.060f, START_NOISE, 10, CLASS_WORMS, "Ridges as of a fingertip.")                 \
    ROW("negatons", "ι", 0.046f, 0.0594f, START_SPOTS, 10, CLASS_HOLES, "Holes that hold together like molecules.")    \
    ROW("maze", "κ", 0.050f, 0.063f, START_SPOTS, 10, CLASS_WORMS, "Worms that join into a maze.")                     \
    ROW("mitosis", "λ", 0.0367f, 0.0649f, START_SPOTS, 6, CLASS_SPOTS, "Spots that divide until the sheet is full.")   \
    ROW("worms", "μ", 0.058f, 0.065f, START_SPOTS, 10, CLASS_WORMS, "Worms that grow from their ends and keep apart.") \
    ROW("solitons", "ν", 0.054f, 0.067f, START_SPOTS, 6, CLASS_SPOTS, "Lonely spots that stay.")                       \
    ROW("spirals", "ξ", 0.014f, 0.049f, START_SPOTS, 10, CLASS_WAVES, "Spirals, as of Belousov and Zhabotinsky.")      \
    ROW("skates", "π", 0.062f, 0.0609f, START_BLUE, 6, CLASS_HOLES, "Stripes and holes that attract and repel.")       \
    ROW("red", "R", 0.050f, 0.070f, START_NOISE, 10, CLASS_UNIFORM, "All fades: a fresh sheet.")                       \
    ROW("blue", "B", 0.050f, 0.050f, START_NOISE, 10, CLASS_UNIFORM, "All is filled, evenly.")
#define ROW(word, sign, f, k, from, cells, class, text)                                                                \
    {.name = word, .letter = sign, .feed = f, .kill = k, .start = from, .radius = cells, .is = class, .meaning = text},
#define NAME(word, ...) word,
const struct gray_scott_preset gray_scott_presets[] = {PRESETS(ROW){.name = NULL}};
const char *const gray_scott_preset_names[] = {PRESETS(NAME) NULL};

const struct gray_scott_preset *gray_scott_preset_find(const char *name)
{
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        if (strcmp(preset->name, name) == 0) {
            return preset;
        }
    }
    return NULL;
}

const struct gray_scott_preset *gray_scott_preset_near(float feed, float kill)
{
    const float feed_span = 0.11f, kill_span = 0.04f; /* of the map */
    const struct gray_scott_preset *nearest = gray_scott_presets;
    float least = 1e30f;
    for (const struct gray_scott_preset *preset = gray_scott_presets; preset->name; preset++) {
        float df = (preset->feed - feed) / feed_span, dk = (preset->kill - kill) / kill_span;
        float distance = df * df + dk * dk;
        nearest = distance < least ? preset : nearest;
        least = distance < least ? distance : least;
    }
    return nearest;
}

struct gray_scott_def gray_scott_preset_def(const struct gray_scott_preset *preset)
{
    struct gray_scott_def def = gray_scott_default_def();
    def.feed = preset->feed;
    def.kill = preset->kill;
    return def;
}

void gray_scott_preset_start(struct gray_scott *chemistry, const struct gray_scott_preset *preset, uint32_t seed)
{
    int64_t cells = (int64_t)gray_scott_width(chemistry) * gray_scott_height(chemistry);
    int spots = (int)(cells / 3000) + 2;
    float u, v;
    struct gray_scott_def def = gray_scott_preset_def(preset);
    gray_scott_fill(chemistry, 1, 0);
    switch (preset->start) {
    case START_BLUE:
        if (gray_scott_blue_state(&def, &u, &v)) {
            gray_scott_fill(chemistry, u, v);
        }
        for (int i = 0; i < spots; i++) {
            struct point at = gray_scott_seed_place(i, seed);
            gray_scott_stroke(chemistry, &(struct action_path){&at, 1}, preset->radius, CHEMISTRY_ERASE, 1);
        }
        break;
    case START_NOISE:
        gray_scott_seed_noise(chemistry, 0.2f, seed);
        break;
    case START_SPOTS:
    default:
        gray_scott_seed_spots(chemistry, spots, preset->radius, seed);
        break;
    }
}

/* Area and perimeter of each object of a mask on a torus of cells; the perimeter by the four and eight neighbours that
 * lie beyond, weighed so that discs of any size have that of a circle. */
static void outline(int width, int height, const int32_t *labels, double *area, double *perimeter)
{
    for (int y = 0; y < height; y++) {
        int up = (y + height - 1) % height * width, here = y * width, down = (y + 1) % height * width;
        for (int x = 0; x < width; x++) {
            int32_t label = labels[here + x];
            if (label == 0) {
                continue;
            }
            int left = (x + width - 1) % width, right = (x + 1) % width;
            int axes = !labels[up + x] + !labels[down + x] + !labels[here + left] + !labels[here + right];
            int diagonals = !labels[up + left] + !labels[up + right] + !labels[down + left] + !labels[down + right];
            area[label]++;
            perimeter[label] += 0.2618 * (axes + 0.70711 * diagonals) * 1.2426; /* Cauchy-Crofton, four directions */
        }
    }
}

/* Islands of the smaller part, and how round they are. */
static bool measure_islands(int width, int height, const uint8_t *mask, struct gray_scott_figures *figures)
{
    size_t cells = (size_t)width * (size_t)height;
    int32_t *labels = malloc(cells * sizeof *labels);
    int count = labels ? components_label(mask, width, height, labels) : -1;
    double *area = count >= 0 ? calloc((size_t)count + 1, sizeof *area) : NULL;
    double *perimeter = count >= 0 ? calloc((size_t)count + 1, sizeof *perimeter) : NULL;
    bool good = area && perimeter;
    if (good) {
        double all = 0, sum = 0;
        outline(width, height, labels, area, perimeter);
        for (int i = 1; i <= count; i++) {
            double roundness = perimeter[i] > 0 ? 12.566371 * area[i] / (perimeter[i] * perimeter[i]) : 1;
            sum += area[i] * (roundness < 1 ? roundness : 1);
            all += area[i];
        }
        figures->islands = count;
        figures->roundness = all > 0 ? sum / all : 0;
    }
    free(labels);
    free(area);
    free(perimeter);
    return good;
}

bool gray_scott_measure(int width, int height, const float *v, const float *earlier, struct gray_scott_figures *figures)
{
    size_t cells = (size_t)width * (size_t)height, above = 0;
    double sum = 0, square = 0, change = 0;
    float least = v[0], most = v[0];
    *figures = (struct gray_scott_figures){0};
    uint8_t *mask = malloc(cells);
    if (!mask) {
        return false;
    }
    for (size_t i = 0; i < cells; i++) {
        double d = earlier ? (double)(v[i] - earlier[i]) : 0;
        sum += (double)v[i];
        square += (double)v[i] * (double)v[i];
        change += d * d;
        least = v[i] < least ? v[i] : least;
        most = v[i] > most ? v[i] : most;
    }
    figures->mean = sum / (double)cells;
    double variance = square / (double)cells - figures->mean * figures->mean;
    figures->deviation = variance > 0 ? sqrt(variance) : 0;
    figures->change = figures->deviation > 0 ? sqrt(change / (double)cells) / figures->deviation : 0;
    for (size_t i = 0; i < cells; i++) {
        mask[i] = v[i] > 0.5f * (least + most);
        above += mask[i];
    }
    figures->covered = (double)above / (double)cells;
    for (size_t i = 0; i < cells && figures->covered > 0.5; i++) {
        mask[i] = !mask[i];
    }
    bool good = measure_islands(width, height, mask, figures);
    free(mask);
    return good;
}

enum gray_scott_class gray_scott_classify(const struct gray_scott_figures *figures)
{
    if (figures->deviation < 0.01) {
        return CLASS_UNIFORM;
    }
    if (figures->change > 0.3) {
        return CLASS_WAVES;
    }
    if (figures->roundness < 0.9) {
        return CLASS_WORMS;
    }
    return figures->covered > 0.5 ? CLASS_HOLES : CLASS_SPOTS;
}
