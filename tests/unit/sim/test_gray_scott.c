/* Gray-Scott on the CPU: the fast paths give the bits of the plainest code, for every width of vectors, number of
 * threads and number of steps at once; limits, brushes, seeds and maps do what they say. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gray_scott.h"
#include "noise.h"
#include "patience.h"

static struct gray_scott *seeded(int width, int height, const struct gray_scott_def *def, int threads,
                                 enum vectors vectors)
{
    struct gray_scott *chemistry = gray_scott_create(width, height, def, threads, vectors);
    assert_non_null(chemistry);
    gray_scott_seed_noise(chemistry, 0.2f, 5);
    return chemistry;
}

static void assert_same(const struct gray_scott *a, const struct gray_scott *b)
{
    assert_int_equal(gray_scott_steps(a), gray_scott_steps(b));
    size_t bytes = (size_t)gray_scott_width(a) * sizeof(float);
    for (int y = 0; y < gray_scott_height(a); y++) {
        assert_memory_equal(gray_scott_u(a, y), gray_scott_u(b, y), bytes);
        assert_memory_equal(gray_scott_v(a, y), gray_scott_v(b, y), bytes);
    }
}

struct sums {
    double u, v, least, most;
};

static struct sums sums_of(const struct gray_scott *chemistry)
{
    struct sums sums = {0, 0, 2, -1};
    for (int y = 0; y < gray_scott_height(chemistry); y++) {
        for (int x = 0; x < gray_scott_width(chemistry); x++) {
            double u = (double)gray_scott_u(chemistry, y)[x], v = (double)gray_scott_v(chemistry, y)[x];
            sums.u += u;
            sums.v += v;
            sums.least = fmin(sums.least, fmin(u, v));
            sums.most = fmax(sums.most, fmax(u, v));
            assert_true(u >= 0 && u <= 1 && v >= 0 && v <= 1);
        }
    }
    return sums;
}

static const enum vectors WIDTHS[] = {VECTORS_NARROW, VECTORS_AVX2, VECTORS_AVX512};

static void fast_is_plain(void **state)
{
    (void)state;
    static const int SIZES[][2] = {{1, 1}, {3, 5}, {16, 40}, {47, 33}, {1100, 9}, {130, 200}};
    for (int size = 0; size < (int)(sizeof SIZES / sizeof *SIZES); size++) {
        for (int kind = 0; kind < 4; kind++) {
            struct gray_scott_def def = gray_scott_default_def();
            def.boundary = kind & 1 ? BOUNDARY_NO_FLUX : BOUNDARY_PERIODIC;
            def.stencil = size % LAPLACIANS;
            def.noise_kill = kind & 2 ? 0.006f : 0;
            def.noise_feed = kind & 2 ? 0.01f : 0;
            def.noise_size = 20;
            def.noise_speed = 30;
            struct gray_scott *plain = seeded(SIZES[size][0], SIZES[size][1], &def, 1, VECTORS_NARROW);
            for (int i = 0; i < 43; i++) {
                assert_true(gray_scott_step_reference(plain));
            }
            for (int i = 0; i < 3; i++) {
                struct gray_scott *fast = seeded(SIZES[size][0], SIZES[size][1], &def, 3 - i, WIDTHS[i]);
                gray_scott_step(fast, 5 + i);
                gray_scott_step(fast, 38 - i);
                assert_same(plain, fast);
                gray_scott_destroy(fast);
            }
            assert_true(sums_of(plain).v > 0 || size < 2);
            gray_scott_destroy(plain);
        }
    }
}

/* What has no plain counterpart is the same for all widths and threads, and stays within its limits. */
static void general_is_the_same(void **state)
{
    (void)state;
    struct gray_scott_def def = gray_scott_default_def();
    def.anisotropy_u = 0.5f;
    def.anisotropy_v = -0.3f;
    def.orientation = 30;
    def.displacement = 0.5f;
    def.noise_size = 30;
    def.noise_speed = 3;
    def.boundary = BOUNDARY_NO_FLUX;
    struct gray_scott *first = seeded(90, 70, &def, 1, VECTORS_BEST);
    assert_false(gray_scott_step_reference(first));
    gray_scott_step(first, 70);
    assert_true(sums_of(first).v > 1);
    for (int i = 0; i < 2; i++) {
        struct gray_scott *other = seeded(90, 70, &def, 3, WIDTHS[i]);
        gray_scott_step(other, 70);
        assert_same(first, other);
        gray_scott_destroy(other);
    }
    gray_scott_destroy(first);
}

/* Without anisotropy the whole kernel is the plain one, to rounding. */
static void whole_is_near_plain(void **state)
{
    (void)state;
    struct gray_scott_def def = gray_scott_default_def();
    struct gray_scott *plain = seeded(64, 64, &def, 1, VECTORS_BEST);
    def.anisotropy_u = 1e-9f;
    struct gray_scott *whole = seeded(64, 64, &def, 1, VECTORS_BEST);
    gray_scott_step(plain, 50);
    gray_scott_step(whole, 50);
    for (int y = 0; y < 64; y++) {
        for (int x = 0; x < 64; x++) {
            assert_float_equal(gray_scott_v(plain, y)[x], gray_scott_v(whole, y)[x], 2e-5f);
        }
    }
    gray_scott_destroy(plain);
    gray_scott_destroy(whole);
}

/* Diffusion alone moves both chemicals about and makes none: 1 - u and v together change by f and k only. */
static void mass_is_balanced(void **state)
{
    (void)state;
    for (int boundary = 0; boundary < BOUNDARIES; boundary++) {
        struct gray_scott_def def = gray_scott_default_def();
        def.feed = def.kill = 0;
        def.diffusion_u = def.diffusion_v; /* else v gathers, up to the limit of 1 */
        def.time_step = 0.25f;             /* else u is used up within a step */
        def.boundary = boundary;
        struct gray_scott *chemistry = seeded(100, 80, &def, 1, VECTORS_BEST);
        struct sums before = sums_of(chemistry);
        gray_scott_step(chemistry, 800);
        struct sums after = sums_of(chemistry);
        assert_true(after.v > before.v + 1); /* it did react */
        assert_float_equal((float)((after.u + after.v) / (before.u + before.v)), 1.0f, 5e-5f);
        gray_scott_destroy(chemistry);
    }
}

/* Where nothing diffuses and nothing reacts v fades as exactly as Euler has it, to 0 and not to denormals. */
static void fading(void **state)
{
    (void)state;
    struct gray_scott_def def = gray_scott_default_def();
    struct gray_scott *chemistry = gray_scott_create(32, 32, &def, 1, VECTORS_BEST);
    gray_scott_fill(chemistry, 0, 0.01f);
    def.feed = 0;
    assert_true(gray_scott_set(chemistry, &def));
    gray_scott_step(chemistry, 10);
    assert_float_equal(gray_scott_v(chemistry, 3)[7], 0.01f * powf(1 - def.kill, 10), 1e-6f);
    gray_scott_step(chemistry, 3000);
    assert_true(gray_scott_v(chemistry, 3)[7] == 0.0f);
    gray_scott_destroy(chemistry);
}

static void no_flux_is_no_wrap(void **state)
{
    (void)state;
    for (int boundary = 0; boundary < BOUNDARIES; boundary++) {
        struct gray_scott_def def = gray_scott_default_def();
        def.boundary = boundary;
        struct gray_scott *chemistry = gray_scott_create(64, 64, &def, 1, VECTORS_BEST);
        struct point at = {0, 0.5f};
        gray_scott_stroke(chemistry, &(struct action_path){&at, 1}, 4, CHEMISTRY_PAINT, 1);
        gray_scott_step(chemistry, 8);
        assert_true((gray_scott_v(chemistry, 32)[60] > 0) == (boundary == BOUNDARY_PERIODIC));
        assert_true(gray_scott_v(chemistry, 32)[10] > 0);
        gray_scott_destroy(chemistry);
    }
}

static void brushes(void **state)
{
    (void)state;
    struct gray_scott_def def = gray_scott_default_def();
    struct gray_scott *chemistry = gray_scott_create(100, 50, &def, 1, VECTORS_BEST);
    static const struct point LINE[] = {{0.2f, 0.5f}, {0.8f, 0.5f}}, OUTSIDE[] = {{-3, -3}, {1e9f, -2}};
    gray_scott_stroke(chemistry, &(struct action_path){LINE, 2}, 5, CHEMISTRY_PAINT, 1);
    double area = sums_of(chemistry).v / 0.25;
    assert_true(fabs(area - (60 * 10 + 3.14159 * 25)) < 20);
    assert_true(gray_scott_u(chemistry, 25)[50] == 0.5f && gray_scott_v(chemistry, 25)[50] == 0.25f);
    gray_scott_stroke(chemistry, &(struct action_path){LINE, 2}, 3, CHEMISTRY_ERASE, 1);
    assert_true(gray_scott_u(chemistry, 25)[50] == 1.0f && gray_scott_v(chemistry, 25)[50] == 0.0f);
    assert_true(gray_scott_v(chemistry, 20)[50] > 0.15f);
    double rest = sums_of(chemistry).v;
    gray_scott_stroke(chemistry, &(struct action_path){OUTSIDE, 2}, 5, CHEMISTRY_PAINT, 1);
    gray_scott_stroke(chemistry, &(struct action_path){LINE, 0}, 5, CHEMISTRY_PAINT, 1);
    assert_true(sums_of(chemistry).v == rest);
    gray_scott_fill(chemistry, 1, 0);
    gray_scott_seed_spots(chemistry, 6, 4, 9);
    assert_true(sums_of(chemistry).v > 40);
    static const float MASK[] = {0, 1, 1, 0};
    gray_scott_fill(chemistry, 1, 0);
    gray_scott_seed_mask(chemistry, &(struct action_raster){MASK, 2, 2, 1}, false);
    assert_true(gray_scott_v(chemistry, 5)[5] == 0.0f && gray_scott_v(chemistry, 5)[95] == 0.25f);
    assert_true(gray_scott_v(chemistry, 45)[5] == 0.25f && gray_scott_v(chemistry, 45)[95] == 0.0f);
    gray_scott_destroy(chemistry);
}

/* Parameters beyond every range are brought into it, and the sheet stays within 0..1. */
static void degenerate(void **state)
{
    (void)state;
    assert_null(gray_scott_create(0, 5, &(struct gray_scott_def){0}, 1, VECTORS_BEST));
    assert_null(gray_scott_create(5, GRAY_SCOTT_SIZE_MAX + 1, &(struct gray_scott_def){0}, 1, VECTORS_BEST));
    gray_scott_destroy(NULL);
    for (const struct key *key = gray_scott_keys; key->name; key++) {
        for (int end = 0; end < 3; end++) {
            struct gray_scott_def def = gray_scott_default_def();
            if (key->type == KEY_NUMBER) {
                float value = end == 0 ? (float)-1e30 : end == 1 ? (float)1e30 : NAN;
                memcpy((char *)&def + key->offset, &value, sizeof value);
            } else {
                int value = end == 0 ? -5 : 2147483647;
                memcpy((char *)&def + key->offset, &value, sizeof value);
            }
            struct gray_scott *chemistry = seeded(40, 30, &def, 1, VECTORS_BEST);
            gray_scott_step(chemistry, 20);
            (void)sums_of(chemistry);
            gray_scott_destroy(chemistry);
        }
    }
    struct gray_scott_def fast = gray_scott_default_def();
    fast.diffusion_u = fast.diffusion_v = 2;
    fast.time_step = 2;
    fast.size = 4;
    fast.feed = fast.kill = 0;
    struct gray_scott *chemistry = seeded(40, 30, &fast, 1, VECTORS_BEST);
    gray_scott_step(chemistry, 300); /* far beyond the stability of a step of 2: it is made shorter, and all is mixed */
    struct sums sums = sums_of(chemistry);
    assert_true(sums.most - sums.v / 1200 < 0.05 || sums.most - sums.u / 1200 < 0.05);
    gray_scott_destroy(chemistry);
}

/* Style and orientation: the map reaches its own half of the sheet only. */
static void maps_reach_their_cells(void **state)
{
    (void)state;
    static const float HALVES[] = {0, 0, 0, 0, 1, 1, 1, 1};
    struct gray_scott_def def = gray_scott_default_def();
    def.style_kill = 0.05f;
    struct gray_scott *chemistry = seeded(128, 64, &def, 1, VECTORS_BEST);
    assert_true(gray_scott_style(chemistry, &(struct action_raster){HALVES, 8, 1, 1}));
    gray_scott_step(chemistry, 600);
    double dark = 0, light = 0;
    for (int y = 0; y < 64; y++) {
        for (int x = 8; x < 56; x++) {
            dark += (double)gray_scott_v(chemistry, y)[x];
            light += (double)gray_scott_v(chemistry, y)[x + 64];
        }
    }
    assert_true(dark > 100 && light < 1e-3 * dark);
    assert_true(gray_scott_style(chemistry, NULL));
    gray_scott_step(chemistry, 2000);
    assert_true(gray_scott_v(chemistry, 32)[80] >= 0);
    gray_scott_destroy(chemistry);
}

static double roughness(const struct gray_scott *chemistry, int dx, int dy)
{
    double sum = 0;
    for (int y = 0; y + dy < gray_scott_height(chemistry); y++) {
        for (int x = dx < 0 ? -dx : 0; x + (dx > 0 ? dx : 0) < gray_scott_width(chemistry); x++) {
            double d = (double)(gray_scott_v(chemistry, y + dy)[x + dx] - gray_scott_v(chemistry, y)[x]);
            sum += d * d;
        }
    }
    return sum;
}

static void anisotropy_turns_stripes(void **state)
{
    (void)state;
    for (int way = 0; way < 4; way++) {
        struct gray_scott_def def = gray_scott_default_def();
        const float field[2] = {0, 1}; /* the third time: the same from a field */
        def.anisotropy_v = 0.4f;
        def.orientation = way == 0 ? 0 : way == 1 ? 90 : way == 2 ? 17 : 45;
        struct gray_scott *chemistry = seeded(96, 96, &def, 1, VECTORS_BEST);
        if (way == 2) {
            assert_true(gray_scott_orient(chemistry, &(struct action_raster){field, 1, 1, 2}));
        }
        gray_scott_step(chemistry, 2500);
        double ratio = roughness(chemistry, 1, 0) / roughness(chemistry, 0, 1);
        double diagonal = roughness(chemistry, 1, 1) / roughness(chemistry, -1, 1);
        assert_true(way == 0 ? ratio < 0.5 : way == 3 ? diagonal < 0.5 : ratio > 2);
        gray_scott_destroy(chemistry);
    }
}

static void simplex_noise(void **state)
{
    (void)state;
    double sum = 0, square = 0, most = 0, jump = 0;
    for (int i = 0; i < 20000; i++) {
        float x = (float)(i % 137) * 0.173f - 9, y = (float)(i / 137) * 0.091f - 5, z = (float)(i % 11) * 0.37f - 2;
        double n = (double)noise_simplex(x, y, z, 4);
        jump = fmax(jump, fabs(n - (double)noise_simplex(x + 1e-3f, y - 1e-3f, z + 1e-3f, 4)));
        sum += n;
        square += n * n;
        most = fmax(most, fabs(n));
    }
    assert_true(fabs(sum / 20000) < 0.05);
    assert_true(square / 20000 > 0.05 && square / 20000 < 0.3);
    assert_true(most > 0.7 && most <= 1);
    assert_true(jump < 0.02);
    assert_true(noise_simplex(0.3f, 0.4f, 0.5f, 1) != noise_simplex(0.3f, 0.4f, 0.5f, 2));
}

static uint64_t hash_of(const struct gray_scott *chemistry)
{
    uint64_t hash = 14695981039346656037u;
    for (int y = 0; y < gray_scott_height(chemistry); y++) {
        for (int x = 0; x < gray_scott_width(chemistry); x++) {
            uint32_t bits[2];
            memcpy(bits, gray_scott_u(chemistry, y) + x, 4);
            memcpy(bits + 1, gray_scott_v(chemistry, y) + x, 4);
            hash = ((hash ^ bits[0]) * 1099511628211u ^ bits[1]) * 1099511628211u;
        }
    }
    return hash;
}

static void golden(void **state)
{
    (void)state;
    struct gray_scott_def def = gray_scott_default_def();
    def.noise_kill = 0.006f;
    def.noise_feed = 0.004f;
    def.noise_speed = 2;
    def.displacement = 0.2f;
    def.anisotropy_u = 0.2f;
    def.orientation = 30;
    struct gray_scott *chemistry = seeded(150, 101, &def, 2, VECTORS_BEST);
    gray_scott_step(chemistry, 300);
    assert_true(sums_of(chemistry).v > 50);
    assert_int_equal(hash_of(chemistry), 0x9eeab1eef6b35961u);
    gray_scott_destroy(chemistry);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fast_is_plain),
        cmocka_unit_test(general_is_the_same),
        cmocka_unit_test(whole_is_near_plain),
        cmocka_unit_test(mass_is_balanced),
        cmocka_unit_test(fading),
        cmocka_unit_test(no_flux_is_no_wrap),
        cmocka_unit_test(brushes),
        cmocka_unit_test(degenerate),
        cmocka_unit_test(maps_reach_their_cells),
        cmocka_unit_test(anisotropy_turns_stripes),
        cmocka_unit_test(simplex_noise),
        cmocka_unit_test(golden),
    };
#ifdef SANITIZED_THREAD
    if (!is_whole()) { /* the others have one thread */
        cmocka_set_test_filter("general_is_the_same");
    }
#endif
    return cmocka_run_group_tests(tests, NULL, NULL);
}
