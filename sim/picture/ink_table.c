#include "ink_table.h"

#include <stdlib.h>
#include <string.h>

enum {
    NODES = INK_TABLE_NODES,
    LANES = 4, /* red, green, blue, nothing: one vector a node */
};

static const float bend = INK_TABLE_BEND;

struct ink_table {
    enum ink_mixing mixing;
    float cmy[INK_PALETTE][3];
    float ground[3];
    float *lattice; /* [NODES][NODES][NODES][NODES][LANES]; NULL for INK_CMY */
};

static float node_thickness(int node)
{
    float last = INK_TABLE_THICKNESS / (INK_TABLE_THICKNESS + bend);
    float u = (float)node / (float)(NODES - 1) * last;
    return bend * u / (1 - u);
}

static void bake(struct ink_table *table, const int ink[INK_PALETTE])
{
    float *at = table->lattice;
    for (int node = 0; node < NODES * NODES * NODES * NODES; node++) {
        float thickness[INK_PALETTE];
        int rest = node;
        for (int i = INK_PALETTE - 1; i >= 0; i--) {
            thickness[i] = node_thickness(rest % NODES);
            rest /= NODES;
        }
        /* Colours outside sRGB are kept: brought in here, the fold at the border would fall between nodes. */
        ink_mix_unbounded(ink, thickness, at);
        at[3] = 0;
        at += LANES;
    }
}

struct ink_table *ink_table_create(const int ink[INK_PALETTE], enum ink_mixing mixing)
{
    int count = 0;
    while (inks[count].name) {
        count++;
    }
    for (int i = 0; i < INK_PALETTE; i++) {
        if (ink[i] < 0 || ink[i] >= count) {
            return NULL;
        }
    }
    struct ink_table *table = calloc(1, sizeof *table);
    if (!table) {
        return NULL;
    }
    table->mixing = mixing;
    ink_mix(ink, (float[INK_PALETTE]){0, 0, 0, 0}, table->ground);
    for (int i = 0; i < INK_PALETTE; i++) {
        ink_cmy(ink[i], table->cmy[i]);
    }
    if (mixing == INK_KUBELKA_MUNK) {
        table->lattice = malloc(sizeof(float) * NODES * NODES * NODES * NODES * LANES);
        if (!table->lattice) {
            free(table);
            return NULL;
        }
        bake(table, ink);
    }
    return table;
}

void ink_table_destroy(struct ink_table *table)
{
    if (table) {
        free(table->lattice);
        free(table);
    }
}

const float *ink_table_lattice(const struct ink_table *table)
{
    return table->lattice;
}

static void mix_cmy(const struct ink_table *table, const float thickness[INK_PALETTE], float rgb[3])
{
    for (int c = 0; c < 3; c++) {
        float display = 1;
        for (int i = 0; i < INK_PALETTE; i++) {
            display -= thickness[i] * table->cmy[i][c];
        }
        rgb[c] = ink_decode(display) * table->ground[c];
    }
}

void ink_table_mix(const struct ink_table *table, const float thickness[INK_PALETTE], float rgb[3])
{
    if (table->mixing == INK_CMY) {
        mix_cmy(table, thickness, rgb);
        return;
    }
    static const int stride[INK_PALETTE] = {NODES * NODES * NODES * LANES, NODES * NODES * LANES, NODES * LANES, LANES};
    const float scale = (NODES - 1) * (INK_TABLE_THICKNESS + bend) / INK_TABLE_THICKNESS;
    int corner[1 << INK_PALETTE];
    float weight[1 << INK_PALETTE];
    int corners = 1;
    corner[0] = 0;
    weight[0] = 1;
    for (int i = 0; i < INK_PALETTE; i++) {
        float u = thickness[i] / (thickness[i] + bend) * scale;
        u = u < (float)(NODES - 1) ? u : (float)(NODES - 1);
        if (u < 1.0f / 1024) {
            continue; /* absent, or too little to see: half the corners */
        }
        int node = (int)u < NODES - 2 ? (int)u : NODES - 2;
        float share = u - (float)node;
        for (int j = 0; j < corners; j++) {
            int low = corner[j] + node * stride[i];
            corner[corners + j] = low + stride[i];
            weight[corners + j] = weight[j] * share;
            corner[j] = low;
            weight[j] = weight[j] * (1 - share);
        }
        corners *= 2;
    }
    float sum[LANES] = {0, 0, 0, 0};
    for (int j = 0; j < corners; j++) {
        const float *colour = table->lattice + corner[j];
        for (int lane = 0; lane < LANES; lane++) {
            sum[lane] += weight[j] * colour[lane];
        }
    }
    ink_into_gamut(sum);
    memcpy(rgb, sum, 3 * sizeof *rgb);
}
