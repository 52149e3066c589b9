/* A painting as bytes: it comes back to the bit and goes on as if nothing had happened, or it does not come back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "busy.h"
#include "journal_case.h"
#include "journal_file.h"
#include "pack.h"

#ifdef SANITIZED
enum { LARGE_STEP = 199400 };
#else
enum { LARGE_STEP = 19940 };
#endif

static void act_on(void *painting, const struct action *action)
{
    painting_act(painting, action);
}

static struct painting *paint(const struct painting_def *def, int ticks)
{
    struct busy busy;
    struct painting *painting = painting_create(def);
    assert_non_null(painting);
    busy_init(&busy);
    for (int tick = 0; tick < ticks; tick++) {
        busy_act(&busy, tick, act_on, painting);
        painting_tick(painting);
    }
    return painting;
}

static struct pack_note note_of(void)
{
    return (struct pack_note){.sheet = journal_case_sheet(),
                              .generation = 7,
                              .number = 1ull << 40,
                              .ticked = 12345678901,
                              .records = 99,
                              .written = 1ull << 33,
                              .crc = 0xfedcba98,
                              .exhibit_hash = 42};
}

static struct bytes pack(const struct painting *painting, uint64_t *hash)
{
    struct painting_def def = painting_get_def(painting);
    struct checkpoint checkpoint;
    struct packer packer = {.fresh = NULL};
    struct pack_note note = note_of();
    struct bytes out = {.data = NULL};
    assert_true(checkpoint_init(&checkpoint, &def) && painting_save(painting, &checkpoint));
    assert_true(checkpoint_pack(&packer, &checkpoint, &note, &out, hash));
    checkpoint_finish(&checkpoint);
    packer_finish(&packer);
    return out;
}

static struct painting *unpack(const struct bytes *bytes, struct pack_note *note)
{
    struct checkpoint checkpoint;
    struct journal_error error = {""};
    if (!checkpoint_unpack(bytes->data, bytes->size, &checkpoint, note, &error)) {
        fail_msg("%s", error.text);
    }
    struct painting *painting = painting_create(&checkpoint.def);
    assert_true(painting && painting_load(painting, &checkpoint));
    checkpoint_finish(&checkpoint);
    return painting;
}

static void it_comes_back_and_goes_on_to_the_bit(void **state)
{
    (void)state;
    static const int when[] = {1, 130, 370}; /* before and after masks, guidance, brushes and other coefficients */
    for (size_t i = 0; i < sizeof when / sizeof when[0]; i++) {
        struct painting_def def = busy_def();
        struct painting *painting = paint(&def, when[i]);
        uint64_t hash, again;
        struct bytes bytes = pack(painting, &hash);
        struct pack_note note, expected = note_of();
        struct painting *back = unpack(&bytes, &note);
        assert_true(painting_hash(back) == painting_hash(painting));
        assert_int_equal(painting_ticks(back), when[i]);
        struct painting_totals then = painting_totals(painting), now = painting_totals(back);
        assert_memory_equal(&then, &now, sizeof now);
        struct bytes packed_again = pack(back, &again);
        assert_true(again == hash);
        for (int tick = 0; tick < 150; tick++) { /* over a period of drying */
            painting_tick(painting);
            painting_tick(back);
        }
        assert_true(painting_hash(back) == painting_hash(painting));
        assert_int_equal(note.generation, expected.generation);
        assert_int_equal(note.number, expected.number);
        assert_int_equal(note.ticked, expected.ticked);
        assert_int_equal(note.records, expected.records);
        assert_int_equal(note.written, expected.written);
        assert_int_equal(note.crc, expected.crc);
        assert_int_equal(note.exhibit_hash, expected.exhibit_hash);
        assert_memory_equal(note.sheet.inks, expected.sheet.inks, sizeof expected.sheet.inks);
        assert_string_equal(note.sheet.scene, "dawn");
        assert_int_equal(note.sheet.mode, expected.sheet.mode);
        bytes_finish(&bytes);
        bytes_finish(&packed_again);
        painting_destroy(painting);
        painting_destroy(back);
    }
}

/* Another tick on a painting at rest is no other painting; anything else is. */
static void equal_paintings_have_equal_hashes(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct painting *painting = painting_create(&def);
    uint64_t fresh, later, other;
    struct bytes bytes = pack(painting, &fresh);
    size_t size = bytes.size;
    bytes_finish(&bytes);
    painting_tick(painting);
    bytes = pack(painting, &later);
    bytes_finish(&bytes);
    assert_true(fresh == later);
    assert_in_range(size, 100, 3000); /* of five million */
    struct action mask = action_default(ACTION_MASK);
    mask.at = (struct point){0.5f, 0.5f};
    mask.has_at = true;
    mask.radius = 0.6f;
    painting_act(painting, &mask);
    bytes = pack(painting, &other);
    bytes_finish(&bytes);
    assert_true(other != fresh);
    painting_destroy(painting);
}

static bool comes_back(const uint8_t *data, size_t size)
{
    struct checkpoint checkpoint;
    struct pack_note note;
    struct journal_error error = {""};
    uint8_t *copy = malloc(size + 1);
    assert_non_null(copy);
    memcpy(copy, data, size);
    bool good = checkpoint_unpack(copy, size, &checkpoint, &note, &error);
    assert_true(good || (error.text[0] && !checkpoint.planes && !checkpoint.ground));
    if (good) {
        checkpoint_finish(&checkpoint);
    }
    free(copy);
    return good;
}

/* Every length of a small one, some of a larger; and in the middle of each a bit the other way. */
static void nothing_but_the_whole_of_it_comes_back(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    for (int large = 0; large < 2; large++) {
        def.width = large ? 203 : 16;
        def.height = large ? 117 : 16;
        def.margin = large ? 9 : 0;
        struct painting *painting = paint(&def, large ? 200 : 0);
        uint64_t hash;
        struct bytes bytes = pack(painting, &hash);
        size_t step = large ? LARGE_STEP : 1;
        assert_true(comes_back(bytes.data, bytes.size));
        for (size_t size = 0; size < bytes.size; size += step) {
            assert_false(comes_back(bytes.data, size));
        }
        for (size_t i = 0; i < bytes.size; i += step) {
            bytes.data[i] ^= (uint8_t)(1u << (i % 8));
            assert_false(comes_back(bytes.data, bytes.size));
            bytes.data[i] ^= (uint8_t)(1u << (i % 8));
        }
        bytes_put_u8(&bytes, 0); /* something behind it */
        assert_false(comes_back(bytes.data, bytes.size));
        bytes_finish(&bytes);
        painting_destroy(painting);
    }
}

static void another_version_is_refused(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct painting *painting = painting_create(&def);
    struct checkpoint checkpoint;
    struct pack_note note;
    struct journal_error error;
    uint64_t hash;
    struct bytes bytes = pack(painting, &hash);
    bytes.data[8] = 3;
    assert_false(checkpoint_unpack(bytes.data, bytes.size, &checkpoint, &note, &error));
    assert_string_equal(error.text, "the painting is of version 3.0; this Frond (" FROND_VERSION ") reads version 1");
    assert_false(checkpoint_unpack("frond: 1", 8, &checkpoint, &note, &error));
    assert_string_equal(error.text, "it is no painting of Frond");
    bytes_finish(&bytes);
    painting_destroy(painting);
}

/* A painting kept by the first version of the format. */
static void an_old_one_still_comes_back(void **state)
{
    (void)state;
    struct bytes bytes;
    struct pack_note note;
    struct file_error error;
    assert_true(journal_file_read(FROND_TEST_DATA "/journal/v1-sheet.frond", JOURNAL_FILE_MOST, &bytes, &error));
    struct painting *painting = unpack(&bytes, &note);
    assert_true(painting_hash(painting) == 0x7d863a8c65b86bc4u);
    assert_int_equal(painting_ticks(painting), 70);
    assert_string_equal(note.sheet.scene, "kept");
    assert_int_equal(note.number, 9);
    bytes_finish(&bytes);
    painting_destroy(painting);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_comes_back_and_goes_on_to_the_bit),
        cmocka_unit_test(equal_paintings_have_equal_hashes),
        cmocka_unit_test(nothing_but_the_whole_of_it_comes_back),
        cmocka_unit_test(another_version_is_refused),
        cmocka_unit_test(an_old_one_still_comes_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
