/* The journal: what is written is what is read, to the bit; and whatever befalls its bytes, only whole records are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include "journal.h"
#include "journal_case.h"

enum { EACH = 5, MOST = 400 };

/* A journal with each verb some times, and the actions in it. */
struct diary {
    struct journal_writer writer;
    struct action actions[MOST];
    struct journal_case_values values[MOST];
    int64_t ticked[MOST];
    int count;
};

static void write_actions(struct diary *diary)
{
    for (int i = 0; i < EACH * ACTION_VERBS; i++) {
        diary->actions[i] = journal_case_action((enum action_verb)(i % ACTION_VERBS), i, &diary->values[i]);
        diary->ticked[i] = i * i / 3;
        journal_action(&diary->writer, diary->ticked[i], &diary->actions[i]);
        diary->count++;
    }
}

static struct diary *open_diary(void)
{
    struct diary *diary = calloc(1, sizeof *diary);
    struct journal_head head = journal_case_head();
    struct journal_sheet sheet = journal_case_sheet();
    assert_non_null(diary);
    journal_begin(&diary->writer, &head);
    journal_sheet(&diary->writer, 0, &sheet);
    return diary;
}

static void close_diary(struct diary *diary)
{
    assert_false(diary->writer.out.failed);
    journal_finish(&diary->writer);
    free(diary);
}

static struct journal_reader read_from(const struct bytes *bytes)
{
    struct journal_reader reader;
    struct journal_error error = {""};
    if (!journal_open(&reader, bytes->data, bytes->size, &error)) {
        fail_msg("%s", error.text);
    }
    return reader;
}

static void what_is_written_is_read(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    struct journal_sheet scene = journal_case_sheet();
    struct journal_record record;
    write_actions(diary);
    int64_t end = diary->ticked[diary->count - 1];
    journal_grid(&diary->writer, end + 5, 32, 24, 3);
    journal_mark(&diary->writer, end + 9);
    strcpy(scene.scene, "dusk");
    journal_scene(&diary->writer, end + 9, &scene);
    journal_restored(&diary->writer, end + 10, 77);
    journal_end(&diary->writer, end + 11);
    assert_int_equal(diary->writer.written, diary->writer.out.size);

    struct journal_reader reader = read_from(&diary->writer.out);
    assert_string_equal(reader.head.version, "0.1.0");
    assert_string_equal(reader.head.engine, "cpu");
    assert_string_equal(reader.head.exhibit, "table");
    assert_true(reader.head.exhibit_hash == 0x123456789abcdefu);
    assert_true(journal_next(&reader, &record));
    struct journal_sheet sheet = journal_case_sheet();
    assert_int_equal(record.kind, JOURNAL_SHEET);
    assert_true(journal_case_same_sheet(&record.sheet, &sheet));
    for (int i = 0; i < diary->count; i++) {
        assert_true(journal_next(&reader, &record));
        assert_int_equal(record.kind, JOURNAL_ACTION);
        assert_int_equal(record.ticked, diary->ticked[i]);
        assert_int_equal(record.action.tick, diary->ticked[i]);
        if (!journal_case_same(&record.action, &diary->actions[i])) {
            fail_msg("%s is another action", action_name(diary->actions[i].verb));
        }
    }
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_GRID && record.grid.width == 32 &&
                record.grid.height == 24 && record.grid.margin == 3 && record.ticked == end + 5);
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_MARK && record.ticked == end + 9);
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_SCENE && record.ticked == end + 9);
    assert_true(journal_case_same_sheet(&record.sheet, &scene));
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_RESTORED && record.lost == 77);
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_END && record.ticked == end + 11);
    assert_false(journal_next(&reader, &record));
    assert_int_equal(reader.ending, JOURNAL_ENDS);
    assert_int_equal(reader.skipped, 0);
    assert_int_equal(reader.good, diary->writer.out.size);
    assert_int_equal(reader.records, diary->writer.records);
    journal_close(&reader);
    close_diary(diary);
}

/* Exact also where a number is no round one, or what a visitor wants is out of its range. */
static void numbers_are_kept_to_the_bit(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    struct journal_record record;
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){-0.0f, 1.17549435e-38f};
    drop.has_at = true;
    drop.radius = 9.80908925027372e-1f;
    drop.solvent = 1e9f; /* the engines take 1000 */
    journal_action(&diary->writer, 3, &drop);
    struct journal_reader reader = read_from(&diary->writer.out);
    assert_true(journal_next(&reader, &record) && journal_next(&reader, &record));
    assert_memory_equal(&record.action.at, &drop.at, sizeof drop.at);
    assert_memory_equal(&record.action.radius, &drop.radius, sizeof drop.radius);
    struct action legal = action_legal(&drop);
    assert_memory_equal(&record.action.solvent, &legal.solvent, sizeof legal.solvent);
    journal_close(&reader);
    close_diary(diary);
}

static void a_raster_is_written_once(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    enum { SIDE = 200 };
    float *values = calloc(2 * SIDE * SIDE, sizeof *values), *copy = calloc(2 * SIDE * SIDE, sizeof *values);
    struct action guide = action_default(ACTION_GUIDE);
    assert_true(values && copy);
    for (int i = 0; i < 2 * SIDE * SIDE; i++) {
        copy[i] = values[i] = (float)(i % SIDE) / SIDE;
    }
    guide.picture = (struct action_raster){values, SIDE, SIDE, 2};
    size_t before = diary->writer.out.size;
    journal_action(&diary->writer, 0, &guide);
    size_t once = diary->writer.out.size - before;
    assert_in_range(once, 100, SIDE * SIDE); /* compressed */
    guide.picture.values = copy;             /* elsewhere, the same */
    journal_action(&diary->writer, 0, &guide);
    assert_in_range(diary->writer.out.size - before - once, 10, 100);
    copy[7] = 0.25f;
    journal_action(&diary->writer, 0, &guide);
    assert_true(diary->writer.out.size - before > 3 * once / 2);
    struct journal_reader reader = read_from(&diary->writer.out);
    struct journal_record record;
    for (int i = 0; i < 4; i++) {
        assert_true(journal_next(&reader, &record));
    }
    assert_memory_equal(record.action.picture.values, copy, 2 * SIDE * SIDE * sizeof *copy);
    journal_close(&reader);
    close_diary(diary);
    free(values);
    free(copy);
}

/* How many of the diary's actions come out of these bytes, each as it went in. */
static int read_whole_ones(const struct diary *diary, const uint8_t *data, size_t size, enum journal_ending *ending)
{
    struct journal_reader reader;
    struct journal_record record;
    struct journal_error error = {""};
    int count = 0;
    if (!journal_open(&reader, data, size, &error)) {
        assert_true(error.text[0]);
        *ending = JOURNAL_TORN;
        return -1;
    }
    while (journal_next(&reader, &record)) {
        if (record.kind == JOURNAL_ACTION) {
            assert_true(count < diary->count && journal_case_same(&record.action, &diary->actions[count]));
            assert_int_equal(record.ticked, diary->ticked[count]);
            count++;
        }
    }
    assert_true((reader.ending == JOURNAL_TORN) == (reader.error.text[0] != '\0'));
    assert_true(reader.good <= size);
    *ending = reader.ending;
    journal_close(&reader);
    return count;
}

static void cut_anywhere_it_gives_what_is_whole(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    enum journal_ending ending;
    int before = -1, whole = 0;
    write_actions(diary);
    const struct bytes *out = &diary->writer.out;
    for (size_t size = 0; size <= out->size; size++) {
        uint8_t *cut = malloc(size + 1); /* so that a sanitizer sees every byte beyond */
        memcpy(cut, out->data, size);
        int count = read_whole_ones(diary, cut, size, &ending);
        assert_true(count >= before);
        before = count;
        whole += ending == JOURNAL_STOPS;
        assert_int_not_equal(ending, JOURNAL_ENDS);
        free(cut);
    }
    assert_int_equal(before, diary->count);
    assert_int_equal(whole, diary->writer.records); /* elsewhere than between two records it is torn */
    close_diary(diary);
}

static void no_flipped_bit_goes_unseen(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    enum journal_ending ending;
    write_actions(diary);
    journal_end(&diary->writer, 100000);
    const struct bytes *out = &diary->writer.out;
    uint8_t *data = malloc(out->size);
    memcpy(data, out->data, out->size);
    for (size_t i = 0; i < out->size; i++) {
        data[i] ^= (uint8_t)(1u << (i * 5 % 8));
        int count = read_whole_ones(diary, data, out->size, &ending);
        assert_true(count < diary->count || ending == JOURNAL_TORN);
        assert_int_equal(ending, JOURNAL_TORN);
        data[i] = out->data[i];
    }
    free(data);
    close_diary(diary);
}

/* Blocks of an older file where the newer one ends: whole records, not in their place. */
static void records_of_another_journal_are_none(void **state)
{
    (void)state;
    struct diary *diary = open_diary(), *other = open_diary();
    enum journal_ending ending;
    write_actions(diary);
    struct action pour = action_default(ACTION_POUR);
    for (int i = 0; i < 4; i++) {
        pour.radius = 20 + (float)i;
        size_t from = other->writer.out.size;
        journal_action(&other->writer, i, &pour);
        if (i == 3) {
            bytes_put(&diary->writer.out, other->writer.out.data + from, other->writer.out.size - from);
        }
    }
    assert_int_equal(read_whole_ones(diary, diary->writer.out.data, diary->writer.out.size, &ending), diary->count);
    assert_int_equal(ending, JOURNAL_TORN);
    close_diary(diary);
    close_diary(other);
}

/* What is appended later, behind what was whole. */
static void it_goes_on_after_a_tear(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    struct journal_record record;
    write_actions(diary);
    struct journal_reader reader =
        read_from(&(struct bytes){diary->writer.out.data, diary->writer.out.size - 3, 0, false});
    while (journal_next(&reader, &record)) {
    }
    assert_int_equal(reader.ending, JOURNAL_TORN);
    assert_int_equal(reader.records, diary->writer.records - 1);
    struct bytes all = {.data = NULL};
    struct journal_writer later;
    bytes_put(&all, diary->writer.out.data, (size_t)reader.good);
    struct journal_place place = journal_place_of(&reader);
    journal_continue(&later, &place);
    journal_close(&reader);
    journal_restored(&later, later.ticked, 12);
    diary->count--;
    for (int i = 0; i < 20; i++, diary->count++) {
        struct action *action = &diary->actions[diary->count];
        *action = journal_case_action((enum action_verb)(i % ACTION_VERBS), 900 + i, &diary->values[diary->count]);
        diary->ticked[diary->count] = later.ticked + 3;
        journal_action(&later, later.ticked + 3, action);
    }
    journal_end(&later, later.ticked);
    assert_int_equal(later.written, all.size + later.out.size);
    bytes_put(&all, later.out.data, later.out.size);
    enum journal_ending ending;
    assert_int_equal(read_whole_ones(diary, all.data, all.size, &ending), diary->count);
    assert_int_equal(ending, JOURNAL_ENDS);
    bytes_finish(&all);
    journal_finish(&later);
    close_diary(diary);
}

/* A record of the test's own. */
static void put_record(struct journal_writer *writer, const struct bytes *body)
{
    struct bytes *out = &writer->out;
    size_t from = out->size;
    bytes_put_u32(out, (uint32_t)body->size);
    bytes_put(out, body->data, body->size);
    writer->crc = bytes_crc(writer->crc, out->data + from, out->size - from);
    bytes_put_u32(out, writer->crc);
}

static void put_drop_of_a_later_version(struct journal_writer *writer)
{
    struct bytes body = {.data = NULL};
    bytes_put_u8(&body, JOURNAL_VERB);
    bytes_put_varint(&body, 0);
    bytes_put_u8(&body, 200);
    bytes_put_text(&body, "drop");
    bytes_put_u8(&body, 8);
    for (int type = 1; type <= 8; type++) { /* one of each type that nobody knows, but two */
        bytes_put_text(&body, type == 1 ? "radius" : type == 4 ? "at" : "glitter");
        bytes_put_u8(&body, (unsigned)type);
    }
    put_record(writer, &body);
    body.size = 0;
    bytes_put_u8(&body, JOURNAL_ACTION);
    bytes_put_varint(&body, 40);
    bytes_put_u8(&body, 200);
    bytes_put_varint(&body, 2);
    bytes_put_float(&body, 12.5f);
    bytes_put_u32(&body, 7);
    bytes_put_u8(&body, 1);
    bytes_put_u8(&body, 1);
    bytes_put_float(&body, 0.25f);
    bytes_put_float(&body, 0.75f);
    bytes_put_text(&body, "gold");
    bytes_put_u8(&body, 3);
    bytes_put_varint(&body, 2);
    bytes_put(&body, "0123456789abcdef", 16);
    bytes_put_varint(&body, 0);
    bytes_put_text(&body, "and what a later version adds");
    put_record(writer, &body);
    bytes_finish(&body);
}

static void what_a_later_version_adds_is_skipped(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    struct journal_record record;
    struct bytes body = {.data = NULL};
    bytes_put_u8(&body, 77); /* a kind that nobody knows */
    bytes_put_varint(&body, 300);
    bytes_put_text(&body, "whatever");
    put_record(&diary->writer, &body);
    put_drop_of_a_later_version(&diary->writer);
    body.size = 0;
    bytes_put_u8(&body, JOURNAL_VERB);
    bytes_put_varint(&body, 0);
    bytes_put_u8(&body, 201);
    bytes_put_text(&body, "sprinkle");
    bytes_put_u8(&body, 0);
    put_record(&diary->writer, &body);
    body.size = 0;
    bytes_put_u8(&body, JOURNAL_ACTION);
    bytes_put_varint(&body, 9);
    bytes_put_u8(&body, 201);
    bytes_put_varint(&body, 0);
    put_record(&diary->writer, &body);
    diary->writer.ticked = 349;
    journal_mark(&diary->writer, 350);
    struct journal_reader reader = read_from(&diary->writer.out);
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_SHEET);
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_ACTION && record.ticked == 340);
    struct action expected = action_default(ACTION_DROP); /* what is not said is as it always was */
    expected.visitor = 1;
    expected.radius = 12.5f;
    expected.at = (struct point){0.25f, 0.75f};
    expected.has_at = true;
    assert_true(journal_case_same(&record.action, &expected));
    assert_true(journal_next(&reader, &record) && record.kind == JOURNAL_MARK && record.ticked == 350);
    assert_false(journal_next(&reader, &record));
    assert_int_equal(reader.ending, JOURNAL_STOPS);
    assert_int_equal(reader.skipped, 1 + 6 + 1);
    journal_close(&reader);
    bytes_finish(&body);
    close_diary(diary);
}

static void assert_refused(const uint8_t *data, size_t size, const char *line)
{
    struct journal_reader reader;
    struct journal_error error = {""};
    assert_false(journal_open(&reader, data, size, &error));
    assert_string_equal(error.text, line);
    journal_close(&reader);
}

static void other_files_and_versions_are_refused(void **state)
{
    (void)state;
    struct diary *diary = open_diary();
    struct bytes *out = &diary->writer.out;
    assert_refused((const uint8_t *)"frond: 1\ncanvas: {}\n", 20, "it is no journal of Frond");
    assert_refused(NULL, 0, "it is no journal of Frond");
    assert_refused(out->data, 11, "the journal ends before it begins");
    assert_refused(out->data, 12, "the head of the journal is broken");
    out->data[8] = 2;
    out->data[10] = 4;
    assert_refused(out->data, out->size,
                   "the journal is of version 2.4; this Frond (" FROND_VERSION ") reads version 1");
    close_diary(diary);
}

/* Sheets, paths and rasters that are whole and make no sense. */
static void nonsense_ends_the_reading(void **state)
{
    (void)state;
    struct point far[] = {{0.5f, 0.5f}, {1e30f, 0.5f}};
    struct diary *diary = open_diary();
    struct action stroke = action_default(ACTION_BRUSH_INK);
    struct journal_record record;
    stroke.path = (struct action_path){far, 2};
    journal_action(&diary->writer, 1, &stroke);
    struct journal_reader reader = read_from(&diary->writer.out);
    assert_true(journal_next(&reader, &record));
    assert_false(journal_next(&reader, &record));
    assert_int_equal(reader.ending, JOURNAL_TORN);
    assert_non_null(strstr(reader.error.text, "brush_ink: path makes no sense"));
    journal_close(&reader);
    close_diary(diary);
    diary = open_diary();
    journal_grid(&diary->writer, 1, 5, 5, 0);
    reader = read_from(&diary->writer.out);
    assert_true(journal_next(&reader, &record));
    assert_false(journal_next(&reader, &record));
    assert_non_null(strstr(reader.error.text, "grid: it makes no sense"));
    journal_close(&reader);
    close_diary(diary);
}

static void varints_and_crc_are_the_standard_ones(void **state)
{
    (void)state;
    static const uint64_t numbers[] = {0, 1, 127, 128, 300, 1u << 31, UINT64_MAX};
    struct bytes bytes = {.data = NULL};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        bytes_put_varint(&bytes, numbers[i]);
    }
    struct cursor cursor = cursor_over(bytes.data, bytes.size);
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        assert_true(cursor_varint(&cursor) == numbers[i]);
    }
    assert_true(!cursor.failed && cursor.at == cursor.end);
    cursor = cursor_over("\xff\xff\xff\xff\xff\xff\xff\xff\xff\x02", 10);
    assert_int_equal(cursor_varint(&cursor), 0);
    assert_true(cursor.failed);
    bytes_finish(&bytes);
    assert_int_equal(bytes_crc(0, "123456789", 9), 0xcbf43926);
    assert_int_equal(bytes_crc(bytes_crc(0, "1234", 4), "56789", 5), 0xcbf43926);
    uint8_t *much = calloc(1, 100003); /* that much goes another way */
    uint32_t little = 0;
    assert_non_null(much);
    for (int i = 0; i < 100003; i++) {
        much[i] = (uint8_t)((unsigned)i * (unsigned)i / 7);
        little = bytes_crc(little, much + i, 1);
    }
    assert_int_equal(bytes_crc(0, much, 100003), little);
    free(much);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read),
        cmocka_unit_test(numbers_are_kept_to_the_bit),
        cmocka_unit_test(a_raster_is_written_once),
        cmocka_unit_test(cut_anywhere_it_gives_what_is_whole),
        cmocka_unit_test(no_flipped_bit_goes_unseen),
        cmocka_unit_test(records_of_another_journal_are_none),
        cmocka_unit_test(it_goes_on_after_a_tear),
        cmocka_unit_test(what_a_later_version_adds_is_skipped),
        cmocka_unit_test(other_files_and_versions_are_refused),
        cmocka_unit_test(nonsense_ends_the_reading),
        cmocka_unit_test(varints_and_crc_are_the_standard_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
