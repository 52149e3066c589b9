/* A torus displaced by a pattern: a mesh, triangle by triangle into a picture with depths, at twice the size. */
#include <math.h>
#include <stdlib.h>

#include "gray_scott_shade.h"
#include "ink.h"

#define FARTHEST (-1e9f)

enum { RING = 960, TUBE = 480, OVER = 2 };

struct vec {
    float x, y, z;
};

struct corner {
    struct vec at, normal; /* before the eye: x right, y down, z towards the eye */
    float rgb[3];
};

struct canvas {
    int width, height;
    float *depth, *rgb;
    struct corner *corners; /* [TUBE][RING] */
};

struct torus_def torus_default_def(void)
{
    return (struct torus_def){.tube = 0.45f, .height = 0.22f, .repeats = 2, .tilt = 0.14f};
}

static struct vec minus(struct vec a, struct vec b)
{
    return (struct vec){a.x - b.x, a.y - b.y, a.z - b.z};
}

static struct vec cross(struct vec a, struct vec b)
{
    return (struct vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static float dot(struct vec a, struct vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vec unit(struct vec a)
{
    float length = sqrtf(dot(a, a));
    return length > 0 ? (struct vec){a.x / length, a.y / length, a.z / length} : a;
}

/* The pattern at a corner of the mesh, bilinear between its cells. */
static float height_at(const struct pattern_plane *plane, int repeats, int i, int j)
{
    float x = (float)i * (float)(repeats * plane->width) / RING, y = (float)j * (float)plane->height / TUBE;
    int x0 = (int)x % plane->width, y0 = (int)y % plane->height;
    int x1 = (x0 + 1) % plane->width, y1 = (y0 + 1) % plane->height;
    float dx = x - floorf(x), dy = y - floorf(y);
    float top = plane->v[y0 * plane->width + x0] * (1 - dx) + plane->v[y0 * plane->width + x1] * dx;
    float low = plane->v[y1 * plane->width + x0] * (1 - dx) + plane->v[y1 * plane->width + x1] * dx;
    return top + dy * (low - top);
}

static void place_corners(const struct pattern_plane *plane, const struct gray_scott_shade_def *def,
                          const struct torus_def *torus, struct corner *corners)
{
    const float turn = 6.2831853f;
    float sine = sinf(turn * torus->tilt), cosine = cosf(turn * torus->tilt);
    for (int j = 0; j < TUBE; j++) {
        float b = turn * (float)j / TUBE;
        for (int i = 0; i < RING; i++) {
            float a = turn * ((float)i / RING + torus->turn), v = height_at(plane, torus->repeats, i, j), rgba[4];
            float reach = 1 + (torus->tube + torus->height * v) * cosf(b);
            struct vec flat = {reach * cosf(a), (torus->tube + torus->height * v) * sinf(b), reach * sinf(a)};
            struct corner *corner = &corners[j * RING + i];
            corner->at = (struct vec){flat.x, flat.y * cosine + flat.z * sine, flat.z * cosine - flat.y * sine};
            gradient_colour(&def->gradient, (v - def->low) / (def->high - def->low), rgba);
            for (int c = 0; c < 3; c++) {
                corner->rgb[c] = rgba[3] * rgba[c];
            }
        }
    }
    for (int j = 0; j < TUBE; j++) {
        for (int i = 0; i < RING; i++) {
            struct vec along =
                minus(corners[j * RING + (i + 1) % RING].at, corners[j * RING + (i + RING - 1) % RING].at);
            struct vec around =
                minus(corners[(j + 1) % TUBE * RING + i].at, corners[(j + TUBE - 1) % TUBE * RING + i].at);
            corners[j * RING + i].normal = unit(cross(around, along));
        }
    }
}

static void shade_pixel(const struct canvas *canvas, const struct gray_scott_shade_def *def, int at,
                        const struct corner *corner)
{
    struct vec light = unit((struct vec){def->light[0], def->light[1], def->light[2]}), normal = unit(corner->normal);
    float lit = dot(normal, light), half = dot(normal, unit((struct vec){light.x, light.y, light.z + 1}));
    float rim = 1 - (normal.z > 0 ? normal.z : 0), gloss = half > 0 ? 0.4f * powf(half, 40) : 0;
    lit = 0.08f + 1.1f * (lit > 0 ? lit : 0);
    for (int c = 0; c < 3; c++) {
        canvas->rgb[3 * at + c] = lit * corner->rgb[c] + gloss + 0.05f * rim * rim * rim;
    }
}

static void draw_triangle(const struct canvas *canvas, const struct gray_scott_shade_def *def,
                          const struct corner *const corners[3])
{
    const float eye = 5.0f, scale = 1.28f * (float)canvas->height; /* distance in radii of the ring; pixels */
    float x[3], y[3];
    for (int i = 0; i < 3; i++) {
        float near = scale / (eye - corners[i]->at.z);
        x[i] = 0.5f * (float)canvas->width + near * corners[i]->at.x;
        y[i] = 0.5f * (float)canvas->height + near * corners[i]->at.y;
    }
    float area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (fabsf(area) < 1e-9f) {
        return;
    }
    int x0 = (int)ceilf(fminf(fminf(x[0], x[1]), x[2]) - 0.5f), x1 = (int)floorf(fmaxf(fmaxf(x[0], x[1]), x[2]) - 0.5f);
    int y0 = (int)ceilf(fminf(fminf(y[0], y[1]), y[2]) - 0.5f), y1 = (int)floorf(fmaxf(fmaxf(y[0], y[1]), y[2]) - 0.5f);
    for (int py = y0 > 0 ? y0 : 0; py <= y1 && py < canvas->height; py++) {
        for (int px = x0 > 0 ? x0 : 0; px <= x1 && px < canvas->width; px++) {
            float cx = (float)px + 0.5f, cy = (float)py + 0.5f;
            float b = ((cx - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (cy - y[0])) / area;
            float c = ((x[1] - x[0]) * (cy - y[0]) - (cx - x[0]) * (y[1] - y[0])) / area, a = 1 - b - c;
            if (a < 0 || b < 0 || c < 0) {
                continue;
            }
            float share[3] = {a, b, c}, depth = 0;
            struct corner mean = {.rgb = {0}};
            for (int i = 0; i < 3; i++) {
                depth += share[i] * corners[i]->at.z;
                mean.normal.x += share[i] * corners[i]->normal.x;
                mean.normal.y += share[i] * corners[i]->normal.y;
                mean.normal.z += share[i] * corners[i]->normal.z;
                for (int k = 0; k < 3; k++) {
                    mean.rgb[k] += share[i] * corners[i]->rgb[k];
                }
            }
            int at = py * canvas->width + px;
            if (depth > canvas->depth[at]) {
                canvas->depth[at] = depth;
                shade_pixel(canvas, def, at, &mean);
            }
        }
    }
}

/* Where nothing is drawn the texture shows, where there is one. */
static void shrink(const struct canvas *canvas, const struct gray_scott_shade_def *def, int width, int height,
                   uint8_t *rgb)
{
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            for (int c = 0; c < 3; c++) {
                float sum = 0, behind = 0;
                if (def->texture) {
                    behind =
                        def->texture[3 * (y % def->texture_height * def->texture_width + x % def->texture_width) + c];
                }
                for (int k = 0; k < OVER * OVER; k++) {
                    int at = (y * OVER + k / OVER) * canvas->width + x * OVER + k % OVER;
                    sum += canvas->depth[at] > FARTHEST ? canvas->rgb[3 * at + c] : behind;
                }
                float value = 255 * ink_encode(sum / (OVER * OVER));
                rgb[3 * (y * width + x) + c] = (uint8_t)(value < 0 ? 0 : value > 254.5f ? 255 : value + 0.5f);
            }
        }
    }
}

bool gray_scott_torus(const struct pattern_plane *plane, const struct gray_scott_shade_def *def,
                      const struct torus_def *torus, int width, int height, uint8_t *rgb)
{
    struct canvas canvas = {.width = width * OVER, .height = height * OVER};
    size_t pixels = (size_t)canvas.width * (size_t)canvas.height;
    canvas.depth = malloc(pixels * sizeof *canvas.depth);
    canvas.rgb = calloc(pixels, 3 * sizeof *canvas.rgb);
    canvas.corners = malloc((size_t)RING * TUBE * sizeof *canvas.corners);
    bool good = canvas.depth && canvas.rgb && canvas.corners;
    if (good) {
        for (size_t i = 0; i < pixels; i++) {
            canvas.depth[i] = FARTHEST;
        }
        place_corners(plane, def, torus, canvas.corners);
        for (int j = 0; j < TUBE; j++) {
            for (int i = 0; i < RING; i++) {
                const struct corner *a = &canvas.corners[j * RING + i], *b = &canvas.corners[j * RING + (i + 1) % RING];
                const struct corner *c = &canvas.corners[(j + 1) % TUBE * RING + i];
                const struct corner *d = &canvas.corners[(j + 1) % TUBE * RING + (i + 1) % RING];
                draw_triangle(&canvas, def, (const struct corner *const[]){a, b, c});
                draw_triangle(&canvas, def, (const struct corner *const[]){b, d, c});
            }
        }
        shrink(&canvas, def, width, height, rgb);
    }
    free(canvas.depth);
    free(canvas.rgb);
    free(canvas.corners);
    return good;
}
