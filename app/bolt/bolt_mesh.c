#include "bolt_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "file_text.h"

enum { LEAF_VERTICES = 6, LEAF_FACES = 8 };

struct vertex {
    float at[3], radius;
    int32_t branch;
};

/* What is made, piece by piece; faces have 3 corners, edges 2. */
struct mesh {
    struct vertex *vertices;
    int32_t (*faces)[3];
    int32_t vertex_count, face_count, vertex_room, face_room, branches;
    bool failed;
};

static bool widen(void **array, int32_t have, int32_t more, int32_t *room, size_t size)
{
    if (have > INT32_MAX / 2 - more) {
        return false;
    }
    if (have + more > *room) {
        int32_t wide = 2 * (have + more) + 1024;
        void *memory = realloc(*array, (size_t)wide * size);
        if (!memory) {
            return false;
        }
        *array = memory;
        *room = wide;
    }
    return true;
}

/* Room for one more piece. */
static bool has_room(struct mesh *mesh, int32_t vertices, int32_t faces)
{
    void *own[2] = {mesh->vertices, mesh->faces};
    bool good =
        !mesh->failed && widen(&own[0], mesh->vertex_count, vertices, &mesh->vertex_room, sizeof *mesh->vertices);
    mesh->vertices = own[0];
    good = good && widen(&own[1], mesh->face_count, faces, &mesh->face_room, sizeof *mesh->faces);
    mesh->faces = own[1];
    good = good && mesh->vertices && mesh->faces;
    mesh->failed = !good;
    return good;
}

static void add_vertex(struct mesh *mesh, const float *at, float radius)
{
    mesh->vertices[mesh->vertex_count++] = (struct vertex){{at[0], at[1], at[2]}, radius, mesh->branches};
}

static void add_face(struct mesh *mesh, int32_t a, int32_t b, int32_t c)
{
    int32_t *face = mesh->faces[mesh->face_count++];
    face[0] = a;
    face[1] = b;
    face[2] = c;
}

/* The places along a branch, to be freed. */
struct way {
    float (*at)[3], *radius;
    int32_t count;
};

static void place(const struct bolt_mesh_def *def, int32_t node, float *at)
{
    const float *from = def->shape->nodes[node].at;
    at[0] = from[0] - 0.5f * (float)def->width;
    at[1] = 0.5f * (float)def->height - from[1];
    at[2] = -from[2];
}

static bool walk(const struct bolt_mesh_def *def, int32_t first, struct way *way)
{
    const struct bolt_node *nodes = def->shape->nodes;
    int32_t count = 1;
    for (int32_t i = first; i >= 0; i = nodes[i].heaviest) {
        count++;
    }
    *way = (struct way){calloc((size_t)count, sizeof *way->at), calloc((size_t)count, sizeof *way->radius), 0};
    if (!way->at || !way->radius) {
        return false;
    }
    place(def, nodes[first].parent, way->at[way->count]);
    way->radius[way->count++] = bolt_shape_root(def->shape, first);
    for (int32_t i = first; i >= 0; i = nodes[i].heaviest) {
        float squared = 0;
        place(def, i, way->at[way->count]);
        for (int d = 0; d < 3; d++) {
            float by = way->at[way->count][d] - way->at[way->count - 1][d];
            squared += by * by;
        }
        way->radius[way->count] = nodes[i].radius > 1e-3f ? nodes[i].radius : 1e-3f;
        way->count += squared > 1e-8f; /* those that lie on one another are one */
    }
    return true;
}

static float scale_to_one(float *v)
{
    float length = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int d = 0; d < 3; d++) {
        v[d] /= length > 1e-12f ? length : 1;
    }
    return length;
}

static void cross(const float *a, const float *b, float *out)
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* The direction of a way at one of its places. */
static void tangent_of(const struct way *way, int32_t i, float *tangent)
{
    int32_t before = i > 0 ? i - 1 : 0, after = i + 1 < way->count ? i + 1 : i;
    for (int d = 0; d < 3; d++) {
        tangent[d] = way->at[after][d] - way->at[before][d];
    }
    if (scale_to_one(tangent) < 1e-6f) { /* it turns back on itself */
        for (int d = 0; d < 3; d++) {
            tangent[d] = way->at[i][d] - way->at[before][d];
        }
        scale_to_one(tangent);
    }
}

/* What was across before, across now: the frame does not twist. */
static void carry(const float *tangent, float *across)
{
    float along = across[0] * tangent[0] + across[1] * tangent[1] + across[2] * tangent[2];
    for (int d = 0; d < 3; d++) {
        across[d] -= along * tangent[d];
    }
    if (scale_to_one(across) < 1e-3f) {
        float other[3] = {0};
        other[fabsf(tangent[0]) < 0.6f ? 0 : 1] = 1;
        cross(tangent, other, across);
        scale_to_one(across);
    }
}

static void add_ring(struct mesh *mesh, const struct way *way, int32_t i, int sides, const float *tangent,
                     const float *across)
{
    float aside[3], at[3];
    cross(tangent, across, aside);
    for (int k = 0; k < sides; k++) {
        float angle = 6.2831853f * (float)k / (float)sides, x = cosf(angle), y = sinf(angle);
        for (int d = 0; d < 3; d++) {
            at[d] = way->at[i][d] + way->radius[i] * (x * across[d] + y * aside[d]);
        }
        add_vertex(mesh, at, way->radius[i]);
    }
}

/* A swept tube with a lid at each end. */
static void add_tube(struct mesh *mesh, const struct way *way, int sides)
{
    if (way->count < 2 || !has_room(mesh, way->count * sides + 2, 2 * way->count * sides)) {
        return;
    }
    int32_t first = mesh->vertex_count, last = first + (way->count - 1) * sides, foot = last + sides, tip = foot + 1;
    float across[3] = {0};
    for (int32_t i = 0; i < way->count; i++) {
        float tangent[3];
        tangent_of(way, i, tangent);
        carry(tangent, across);
        add_ring(mesh, way, i, sides, tangent, across);
    }
    add_vertex(mesh, way->at[0], way->radius[0]);
    add_vertex(mesh, way->at[way->count - 1], way->radius[way->count - 1]);
    for (int32_t ring = first; ring < last; ring += sides) {
        for (int k = 0; k < sides; k++) {
            int32_t next = (k + 1) % sides;
            add_face(mesh, ring + k, ring + next, ring + sides + next);
            add_face(mesh, ring + k, ring + sides + next, ring + sides + k);
        }
    }
    for (int k = 0; k < sides; k++) {
        int32_t next = (k + 1) % sides;
        add_face(mesh, foot, first + next, first + k);
        add_face(mesh, tip, last + k, last + next);
    }
}

/* A flat octahedron at the node, lengthwise away from its parent. */
static void add_leaf(struct mesh *mesh, const struct bolt_mesh_def *def, int32_t node, float size)
{
    static const int8_t FACES[LEAF_FACES][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    float from[3], at[3], along[3], across[3] = {0.3f, 0.5f, 0.8f}, up[3];
    if (!has_room(mesh, LEAF_VERTICES, LEAF_FACES)) {
        return;
    }
    place(def, def->shape->nodes[node].parent, from);
    place(def, node, at);
    for (int d = 0; d < 3; d++) {
        along[d] = at[d] - from[d];
    }
    if (scale_to_one(along) < 1e-6f) {
        along[0] = 1;
    }
    carry(along, across);
    cross(along, across, up);
    int32_t first = mesh->vertex_count;
    const float sizes[3] = {size, 0.45f * size, 0.06f * size};
    const float *const ways[3] = {along, across, up};
    for (int k = 0; k < LEAF_VERTICES; k++) {
        float corner[3];
        for (int d = 0; d < 3; d++) {
            float side = (k % 2 == 0 ? 1.0f : -1.0f) * sizes[k / 2];
            corner[d] = at[d] + size * along[d] + side * ways[k / 2][d];
        }
        add_vertex(mesh, corner, size);
    }
    for (int k = 0; k < LEAF_FACES; k++) {
        add_face(mesh, first + FACES[k][0], first + FACES[k][1], first + FACES[k][2]);
    }
}

static void add_line(struct mesh *mesh, const struct way *way)
{
    if (way->count < 2 || !has_room(mesh, way->count, way->count)) {
        return;
    }
    for (int32_t i = 0; i < way->count; i++) {
        add_vertex(mesh, way->at[i], way->radius[i]);
        if (i > 0) {
            add_face(mesh, mesh->vertex_count - 2, mesh->vertex_count - 1, -1);
        }
    }
}

static void finish(struct mesh *mesh)
{
    free(mesh->vertices);
    free(mesh->faces);
}

static bool make(struct mesh *mesh, const struct bolt_mesh_def *def)
{
    for (int32_t i = 0; i < def->shape->count && !mesh->failed; i++) {
        if (bolt_shape_begins(def->shape, i)) {
            struct way way;
            bool good = walk(def, i, &way);
            if (good && def->lines) {
                add_line(mesh, &way);
            } else if (good) {
                add_tube(mesh, &way, def->sides);
            }
            mesh->failed = mesh->failed || !good;
            free(way.at);
            free(way.radius);
            mesh->branches++;
        }
    }
    for (int32_t i = 0; i < def->shape->count && !mesh->failed && !def->lines; i++) {
        float size = bolt_shape_leaf(def->shape, i, def->look);
        if (size > 0) {
            add_leaf(mesh, def, i, size);
            mesh->branches++;
        }
    }
    return !mesh->failed;
}

bool bolt_write_obj(const struct bolt_mesh_def *def, const char *path, struct file_error *error)
{
    struct mesh mesh = {0};
    struct file_text text = {0};
    bool good = make(&mesh, def);
    if (!good) {
        file_fail(error, path, "memory is short");
    }
    file_text_put(&text, "# frond bolt: %s, pixels from the middle of the picture, y up\n",
                  def->lines ? "branches as lines, radii as texture coordinates" : "branches as closed tubes");
    for (int32_t i = 0; i < mesh.vertex_count && good; i++) {
        const struct vertex *vertex = &mesh.vertices[i];
        file_text_put(&text, "v %.4f %.4f %.4f\n", (double)vertex->at[0], (double)vertex->at[1], (double)vertex->at[2]);
        if (def->lines) {
            file_text_put(&text, "vt %.4f\n", (double)vertex->radius);
        }
    }
    for (int32_t i = 0, branch = -1; i < mesh.face_count && good; i++) {
        const int32_t *face = mesh.faces[i];
        if (mesh.vertices[face[0]].branch != branch) {
            branch = mesh.vertices[face[0]].branch;
            file_text_put(&text, "g branch%d\n", branch);
        }
        if (def->lines) {
            file_text_put(&text, "l %d/%d %d/%d\n", face[0] + 1, face[0] + 1, face[1] + 1, face[1] + 1);
        } else {
            file_text_put(&text, "f %d %d %d\n", face[0] + 1, face[1] + 1, face[2] + 1);
        }
    }
    finish(&mesh);
    if (!good) {
        free(text.bytes);
        return false;
    }
    return file_text_write(&text, path, error);
}

/* Little endian, whatever the machine is. */
static void put_word(struct file_text *text, uint32_t word)
{
    const uint8_t bytes[4] = {(uint8_t)word, (uint8_t)(word >> 8), (uint8_t)(word >> 16), (uint8_t)(word >> 24)};
    file_text_bytes(text, bytes, sizeof bytes);
}

static void put_number(struct file_text *text, float number)
{
    uint32_t word;
    memcpy(&word, &number, sizeof word);
    put_word(text, word);
}

bool bolt_write_ply(const struct bolt_mesh_def *def, const char *path, struct file_error *error)
{
    struct mesh mesh = {0};
    struct file_text text = {0};
    bool good = make(&mesh, def);
    if (!good) {
        file_fail(error, path, "memory is short");
    }
    file_text_put(&text, "ply\nformat binary_little_endian 1.0\ncomment frond bolt\nelement vertex %d\n",
                  mesh.vertex_count);
    file_text_put(&text, "property float x\nproperty float y\nproperty float z\nproperty float radius\n"
                         "property int branch\n");
    file_text_put(&text,
                  def->lines ? "element edge %d\nproperty int vertex1\nproperty int vertex2\nend_header\n"
                             : "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
                  mesh.face_count);
    for (int32_t i = 0; i < mesh.vertex_count && good; i++) {
        const struct vertex *vertex = &mesh.vertices[i];
        for (int d = 0; d < 3; d++) {
            put_number(&text, vertex->at[d]);
        }
        put_number(&text, vertex->radius);
        put_word(&text, (uint32_t)vertex->branch);
    }
    for (int32_t i = 0; i < mesh.face_count && good; i++) {
        const uint8_t corners = 3;
        if (!def->lines) {
            file_text_bytes(&text, &corners, 1);
        }
        for (int k = 0; k < (def->lines ? 2 : 3); k++) {
            put_word(&text, (uint32_t)mesh.faces[i][k]);
        }
    }
    finish(&mesh);
    if (!good) {
        free(text.bytes);
        return false;
    }
    return file_text_write(&text, path, error);
}
