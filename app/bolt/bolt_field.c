/* The potential of what has grown over the picture, as bands of colour and as heights. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <zlib.h>

#include "bolt_order.h"
#include "file_text.h"
#include "image.h"
#include "ink.h"
#include "progress.h"

enum { FIELD_SIDE = 1024, BANDS = 9, RANKS = 4096 };

/* Eq. 10 over the picture, 0 on the growth (the least) to 1 (the greatest), columns * rows of squares of a pixel or
 * more. */
struct field {
    float *values;
    int columns, rows;
};

/* In the plane that is seen, through the middle of what lies behind it. */
static bool sample(const struct bolt_result *result, struct field *field)
{
    const struct bolt_order *order = result->order;
    int longer = order->width > order->height ? order->width : order->height;
    float step = longer > FIELD_SIDE ? (float)longer / FIELD_SIDE : 1;
    float scale = bolt_scale(&order->bolt, order->width), least = INFINITY, most = -INFINITY;
    *field = (struct field){.columns = (int)ceilf((float)order->width / step),
                            .rows = (int)ceilf((float)order->height / step)};
    size_t count = (size_t)field->columns * (size_t)field->rows;
    field->values = calloc(count, sizeof *field->values);
    struct progress progress = progress_start("measuring the potential", stderr);
    for (int row = 0; row < field->rows && field->values; row++) {
        for (int column = 0; column < field->columns; column++) {
            float at[LAPLACIAN_DIMENSIONS_MAX] = {0};
            at[order->axes[0]] = (((float)column + 0.5f) * step - 0.5f * (float)order->width) / scale;
            at[order->axes[1]] = (((float)row + 0.5f) * step - 0.5f * (float)order->height) / scale;
            float value = laplacian_potential(result->laplacian, at);
            field->values[(size_t)row * (size_t)field->columns + (size_t)column] = value;
            least = value < least ? value : least;
            most = value > most ? value : most;
        }
        progress_step(&progress, row, field->rows);
    }
    progress_end(&progress);
    for (size_t i = 0; i < count && field->values; i++) {
        field->values[i] = most > least ? (field->values[i] - least) / (most - least) : 0;
    }
    return field->values;
}

/* Bilinear, at the middle of a pixel. */
static float value_at(const struct field *field, float x, float y)
{
    x -= 0.5f;
    y -= 0.5f;
    x = x < 0 ? 0 : x > (float)(field->columns - 1) ? (float)(field->columns - 1) : x;
    y = y < 0 ? 0 : y > (float)(field->rows - 1) ? (float)(field->rows - 1) : y;
    int column = (int)x, row = (int)y, next = column + 1 < field->columns ? column + 1 : column;
    const float *top = field->values + (size_t)row * (size_t)field->columns;
    const float *below = row + 1 < field->rows ? top + field->columns : top;
    float u = x - (float)column, v = y - (float)row;
    return (1 - v) * ((1 - u) * top[column] + u * top[next]) + v * ((1 - u) * below[column] + u * below[next]);
}

/* Which share of the picture has a lower potential: bands of the same area, so that all can be told apart, as
 * Mandelbrot and Evertsz colour theirs. */
static void rank(const struct field *field, float *shares)
{
    size_t count = (size_t)field->columns * (size_t)field->rows, sum = 0;
    size_t counts[RANKS] = {0};
    for (size_t i = 0; i < count; i++) {
        counts[(int)(field->values[i] * (RANKS - 1))]++;
    }
    for (int k = 0; k < RANKS; k++) {
        sum += counts[k];
        shares[k] = ((float)sum - 0.5f * (float)counts[k]) / (float)count;
    }
}

/* From the growth outwards: embers, night, sea, foam. */
static void colour_of(float share, uint8_t *rgb)
{
    static const float STOPS[][3] = {{255, 252, 222}, {252, 194, 58}, {222, 66, 30},   {122, 14, 62},  {38, 12, 84},
                                     {18, 58, 150},   {20, 140, 178}, {122, 210, 186}, {236, 246, 224}};
    enum { COUNT = sizeof STOPS / sizeof *STOPS };
    float band = share * BANDS, within = band - floorf(band), at = share * (COUNT - 1);
    int stop = (int)at < COUNT - 1 ? (int)at : COUNT - 2;
    float part = at - (float)stop, light = 0.72f + 0.28f * within; /* each band dawns, and breaks off at a level */
    for (int c = 0; c < 3; c++) {
        float value = light * (STOPS[stop][c] + part * (STOPS[stop + 1][c] - STOPS[stop][c]));
        rgb[c] = (uint8_t)(value + 0.5f);
    }
}

bool bolt_write_potential(const struct bolt_result *result, const char *path, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    struct field field = {0};
    float *shares = calloc(RANKS + 1, sizeof *shares);
    uint8_t *rgb = malloc((size_t)order->width * (size_t)order->height * 3);
    bool good = shares && rgb && sample(result, &field);
    if (!good) {
        file_fail(error, path, "memory is short");
    }
    if (good) {
        rank(&field, shares);
        shares[RANKS] = shares[RANKS - 1];
        for (int y = 0; y < order->height; y++) {
            for (int x = 0; x < order->width; x++) {
                float value = value_at(&field, ((float)x + 0.5f) * (float)field.columns / (float)order->width,
                                       ((float)y + 0.5f) * (float)field.rows / (float)order->height);
                float at = value * (RANKS - 1), part = at - floorf(at);
                int k = (int)at;
                colour_of(shares[k] + part * (shares[k + 1] - shares[k]),
                          rgb + 3 * ((size_t)y * (size_t)order->width + (size_t)x));
            }
        }
        good = image_write_png(path, rgb, order->width, order->height, NULL, error);
    }
    free(field.values);
    free(shares);
    free(rgb);
    return good;
}

static void put_chunk(struct file_text *text, const char *type, const uint8_t *bytes, size_t size)
{
    uLong sum = crc32(crc32(0, (const Bytef *)type, 4), bytes, (uInt)size);
    const uint8_t length[4] = {(uint8_t)(size >> 24), (uint8_t)(size >> 16), (uint8_t)(size >> 8), (uint8_t)size};
    const uint8_t check[4] = {(uint8_t)(sum >> 24), (uint8_t)(sum >> 16), (uint8_t)(sum >> 8), (uint8_t)sum};
    file_text_bytes(text, length, 4);
    file_text_bytes(text, type, 4);
    file_text_bytes(text, bytes, size);
    file_text_bytes(text, check, 4);
}

/* Grey of 16 bits, which image_write_png has not (PNG, third edition, sections 5 and 11). `rows`: a filter byte and two
 * bytes a pixel each. */
static bool write_grey16(const char *path, const uint8_t *rows, int width, int height, struct file_error *error)
{
    static const uint8_t SIGNATURE[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    const unsigned w = (unsigned)width, h = (unsigned)height;
    const uint8_t header[13] = {(uint8_t)(w >> 24), (uint8_t)(w >> 16), (uint8_t)(w >> 8),
                                (uint8_t)w,         (uint8_t)(h >> 24), (uint8_t)(h >> 16),
                                (uint8_t)(h >> 8),  (uint8_t)h,         16};
    uLong size = (uLong)(2 * w + 1) * h;
    uLongf packed = compressBound(size);
    uint8_t *bytes = malloc(packed);
    if (!bytes || compress2(bytes, &packed, rows, size, 6) != Z_OK) {
        free(bytes);
        return file_fail(error, path, "memory is short");
    }
    struct file_text text = {0};
    file_text_bytes(&text, SIGNATURE, sizeof SIGNATURE);
    put_chunk(&text, "IHDR", header, sizeof header);
    put_chunk(&text, "IDAT", bytes, packed);
    put_chunk(&text, "IEND", SIGNATURE, 0);
    free(bytes);
    return file_text_write(&text, path, error);
}

bool bolt_write_height(const struct bolt_result *result, const char *path, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    bool cuts = order->kind == BOLT_RIVER || order->kind == BOLT_FRACTURE;
    struct field field = {0};
    size_t stride = 2 * (size_t)order->width + 1;
    uint8_t *rows = calloc(stride, (size_t)order->height);
    /* Of what has grown alone: attractors and repulsors would be the highest peaks and deepest holes by far. */
    const struct laplacian_def *growth = &order->bolt.growth;
    bool good = rows && laplacian_charge(result->laplacian, NULL, 0) && sample(result, &field) &&
                laplacian_charge(result->laplacian, growth->charges, growth->charge_count);
    if (!good) {
        file_fail(error, path, "memory is short");
    }
    for (int y = 0; y < order->height && good; y++) {
        uint8_t *at = rows + stride * (size_t)y + 1; /* filter 0 */
        for (int x = 0; x < order->width; x++) {
            float value = value_at(&field, ((float)x + 0.5f) * (float)field.columns / (float)order->width,
                                   ((float)y + 0.5f) * (float)field.rows / (float)order->height);
            unsigned height = (unsigned)(65535 * (cuts ? value : 1 - value) + 0.5f);
            *at++ = (uint8_t)(height >> 8);
            *at++ = (uint8_t)height;
        }
    }
    good = good && write_grey16(path, rows, order->width, order->height, error);
    free(field.values);
    free(rows);
    return good;
}
