/* What frond bolt writes without the picture helper: meshes whose branches are closed, and an SVG with a path a branch;
 * charges as they are written on a command line. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bolt_charge_text.h"
#include "bolt_mesh.h"
#include "bolt_order.h"

enum { VERTICES = 60000, FACES = 120000 };

struct fixture {
    struct bolt_order order;
    struct bolt_result result;
    char path[64];
};

static int set_up(void **state)
{
    static struct fixture fixture;
    enum laplacian_status status;
    fixture = (struct fixture){.order = bolt_order_default()};
    fixture.order.kind = BOLT_CORAL;
    fixture.order.width = fixture.order.height = 300;
    bolt_order_preset(&fixture.order);
    fixture.order.bolt.growth.particles = 300;
    fixture.result.order = &fixture.order;
    fixture.result.laplacian = laplacian_create(&fixture.order.bolt.growth, &status);
    assert_non_null(fixture.result.laplacian);
    laplacian_step(fixture.result.laplacian, 300);
    struct bolt_sight sight = bolt_sight_of(&fixture.order.bolt, 300, 300);
    assert_true(bolt_shape_make(&fixture.result.shape, fixture.result.laplacian, &fixture.order.bolt.look, &sight));
    snprintf(fixture.path, sizeof fixture.path, "/tmp/frond-bolt-%d", (int)getpid());
    *state = &fixture;
    return 0;
}

static int tear_down(void **state)
{
    struct fixture *fixture = *state;
    unlink(fixture->path);
    bolt_shape_finish(&fixture->result.shape);
    laplacian_destroy(fixture->result.laplacian);
    return 0;
}

static struct bolt_mesh_def mesh_of(const struct fixture *fixture, int sides)
{
    return (struct bolt_mesh_def){.shape = &fixture->result.shape,
                                  .look = &fixture->order.bolt.look,
                                  .width = 300,
                                  .height = 300,
                                  .sides = sides};
}

struct edge {
    int32_t from, to;
};

static int compare(const void *a, const void *b)
{
    const struct edge *one = a, *other = b;
    return one->from != other->from ? (one->from < other->from ? -1 : 1)
                                    : (one->to > other->to) - (one->to < other->to);
}

static int find_branches(const struct bolt_shape *shape)
{
    int branches = 0;
    for (int32_t i = 0; i < shape->count; i++) {
        branches += bolt_shape_begins(shape, i);
    }
    return branches;
}

static void every_edge_of_a_tube_has_two_faces(void **state)
{
    const struct fixture *fixture = *state;
    static float at[VERTICES][3];
    static struct edge edges[3 * FACES];
    for (int sides = 3; sides <= 8; sides += 5) {
        struct bolt_mesh_def def = mesh_of(fixture, sides);
        struct file_error error;
        assert_true(bolt_write_obj(&def, fixture->path, &error));
        FILE *file = fopen(fixture->path, "r");
        char line[128];
        int vertices = 0, count = 0, groups = 0;
        double volume = 0;
        assert_non_null(file);
        while (fgets(line, sizeof line, file)) {
            int face[3];
            groups += line[0] == 'g';
            if (line[0] == 'v') {
                float *v = at[vertices++];
                assert_int_equal(sscanf(line, "v %f %f %f", &v[0], &v[1], &v[2]), 3);
            } else if (sscanf(line, "f %d %d %d", &face[0], &face[1], &face[2]) == 3) {
                const float *a = at[face[0] - 1], *b = at[face[1] - 1], *c = at[face[2] - 1];
                volume += (double)(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                                   a[2] * (b[0] * c[1] - b[1] * c[0])) /
                          6;
                for (int k = 0; k < 3; k++) {
                    edges[count++] = (struct edge){face[k], face[(k + 1) % 3]};
                    assert_in_range(face[k], 1, vertices);
                }
            }
        }
        fclose(file);
        assert_int_equal(groups, find_branches(&fixture->result.shape));
        assert_true(volume > 1000); /* outside is outside */
        qsort(edges, (size_t)count, sizeof *edges, compare);
        for (int i = 0; i < count; i++) {
            struct edge back = {edges[i].to, edges[i].from};
            assert_non_null(bsearch(&back, edges, (size_t)count, sizeof *edges, compare));
            assert_true(i == 0 || compare(&edges[i - 1], &edges[i]) != 0);
        }
    }
}

static void lines_have_a_radius_to_each_place(void **state)
{
    const struct fixture *fixture = *state;
    struct bolt_mesh_def def = mesh_of(fixture, 3);
    struct file_error error;
    char line[128];
    int places = 0, radii = 0, pieces = 0;
    def.lines = true;
    assert_true(bolt_write_obj(&def, fixture->path, &error));
    FILE *file = fopen(fixture->path, "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        float radius;
        radii += sscanf(line, "vt %f", &radius) == 1 && radius > 0;
        places += strncmp(line, "v ", 2) == 0;
        pieces += strncmp(line, "l ", 2) == 0;
    }
    fclose(file);
    assert_int_equal(places, radii);
    assert_int_equal(pieces, places - find_branches(&fixture->result.shape));
}

static void a_path_for_each_branch(void **state)
{
    struct fixture *fixture = *state;
    struct file_error error;
    char line[65536];
    int paths = 0, ends = 0;
    assert_true(bolt_write_svg(&fixture->result, fixture->path, &error));
    FILE *file = fopen(fixture->path, "r");
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        paths += strncmp(line, "<path class=\"branch\"", 20) == 0;
        ends += strcmp(line, "</svg>\n") == 0;
        assert_null(strstr(line, "nan"));
    }
    fclose(file);
    assert_int_equal(paths, find_branches(&fixture->result.shape));
    assert_int_equal(ends, 1);
}

static void charges_are_what_is_written(void **state)
{
    static const char *const BAD[] = {
        "",         "1",           "1,",      "1,2,3,4",          "1,2/1,0", "line:1,2", "line:1,2/0,0",
        "plane:/1", "1,2:",        "1,2:-5",  "cylinder:1,2/0,1", "stroke:", "1,2!x",    "nan,1",
        "1e9,0",    "stroke:1,2;", "1,2:1e10"};
    static struct bolt_order order;
    (void)state;
    order = bolt_order_default();
    order.bare = true;
    bolt_order_preset(&order);
    order.bolt.growth.dimensions = 3;
    for (size_t i = 0; i < sizeof BAD / sizeof *BAD; i++) {
        assert_non_null(bolt_charge_take(&order, BAD[i], true));
    }
    assert_int_equal(order.bolt.growth.charge_count, 0);
    assert_null(bolt_charge_take(&order, "-3,4.5", true));
    assert_null(bolt_charge_take(&order, "cylinder:1,2,3/0,1,0/7.5:20!", false));
    assert_null(bolt_charge_take(&order, "stroke:1,2;3,4,5;6,7:2", true));
    const struct laplacian_charge *charges = order.bolt.charges;
    assert_int_equal(charges[0].shape, LAPLACIAN_POINT);
    assert_true(charges[0].at[0] == -3 && charges[0].at[1] == 4.5f && charges[0].at[2] == 0 && !charges[0].ends);
    assert_true(charges[0].charge == 1000);
    assert_int_equal(charges[1].shape, LAPLACIAN_CYLINDER);
    assert_true(charges[1].along[1] == 1 && charges[1].radius == 7.5f && charges[1].charge == -20 && charges[1].ends);
    assert_int_equal(charges[2].path_count, 3);
    assert_true(charges[2].path[5] == 5 && charges[2].path[6] == 6 && charges[2].charge == 2);
    assert_null(bolt_seed_take(&order, "1,2/3,4,5", true));
    assert_null(bolt_seed_take(&order, "8,9", false));
    assert_int_equal(order.bolt.growth.seed_count, 2);
    assert_true(order.bolt.seeds[0].to[2] == 5 && order.bolt.seeds[1].to[1] == 9);
    for (int i = 0; i < BOLT_CHARGES - 3; i++) {
        assert_null(bolt_charge_take(&order, "0,0", true));
    }
    assert_non_null(bolt_charge_take(&order, "0,0", true));
    bolt_order_finish(&order);
}

/* In a room of other cells a plant is the same to look at. */
static void a_plant_keeps_its_size(void **state)
{
    (void)state;
    static struct bolt_order order, finer;
    order = bolt_order_default();
    order.lsystem = 1 + LSYSTEM_VINE;
    order.width = order.height = 256;
    bolt_order_preset(&order);
    finer = order;
    finer.plant.growth.dimensions = 2;
    bolt_order_respan(&finer, 512);
    assert_true(finer.bolt.growth.span == 2 * order.bolt.growth.span);
    assert_float_equal(finer.plant.growth.length, 2 * order.plant.growth.length, 1e-4);
    assert_float_equal(finer.plant.growth.keep, 2 * order.plant.growth.keep, 1e-4);
    assert_float_equal(finer.plant.growth.response, order.plant.growth.response / 2, 1e-5);
    assert_float_equal(finer.bolt.charges[0].radius, 2 * order.bolt.charges[0].radius, 1e-4);
    assert_float_equal(finer.bolt.seeds[0].from[1], 2 * order.bolt.seeds[0].from[1], 1e-4);
    assert_float_equal(finer.bolt.look.trunk, order.bolt.look.trunk, 1e-5);
    assert_int_equal(finer.plant.growth.dimensions, 2);
    finer.bare = true;
    bolt_order_respan(&finer, 1); /* every value is one that can be */
    assert_true(keys_are_legal(lsystem_keys, &finer.plant.growth) && finer.bolt.growth.seed_count == 0);
    finer.bare = false;
    finer.lsystem = 0;
    bolt_order_preset(&finer);
    float radius = finer.bolt.growth.environment_radius;
    bolt_order_respan(&finer, 3 * finer.bolt.growth.span);
    assert_float_equal(finer.bolt.growth.environment_radius, 3 * radius, 1e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_edge_of_a_tube_has_two_faces),
        cmocka_unit_test(lines_have_a_radius_to_each_place),
        cmocka_unit_test(a_path_for_each_branch),
        cmocka_unit_test(charges_are_what_is_written),
        cmocka_unit_test(a_plant_keeps_its_size),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
