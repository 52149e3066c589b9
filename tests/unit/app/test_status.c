/* The status of a kiosk: JSON that a parser takes, metrics as a strict reader of the exposition format takes them. */
#include <ctype.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <json.h>

#include "status.h"

static struct status sample(void)
{
    struct status status = {.uptime_s = 86400.7,
                            .unix_s = 1768478400,
                            .display = "shown",
                            .state = "painting",
                            .scene = "dawn",
                            .engine = "cpu",
                            .visits = 12,
                            .drops = 345,
                            .frames_presented = 5000000000,
                            .blanks_missed = 17,
                            .ticks = 700,
                            .ticks_per_second = 59.5,
                            .tick_s = 0.0042,
                            .grid = 0.75,
                            .celsius = 61.5,
                            .throttled = true,
                            .gallery = 8,
                            .exhibit_errors = 2,
                            .exhibit_wrong = true,
                            .device_count = 2};
    status_frame(&status.frames, 0.0167);
    status_frame(&status.frames, 0.0333);
    status_frame(&status.frames, 7);
    status.devices[0] = (struct status_device){.class = "touchscreen", .admitted = true, .works = true};
    status_word(status.devices[0].name, "A \"quoted\\\" name\n");
    status.devices[1] = status.devices[0]; /* two of a kind */
    status.devices[1].works = false;
    return status;
}

/* A reader of the exposition format. It knows the lines it may meet, and stops at any other. */
struct metrics {
    int samples, families;
    char family[80], type[20]; /* of the lines that follow */
    char seen[80][80];         /* families so far */
    char series[120][200];     /* names with labels so far */
    double values[120];
};

static size_t name_length(const char *text)
{
    size_t length = 0;
    while (isalpha((unsigned char)text[length]) || text[length] == '_' || text[length] == ':' ||
           (length > 0 && isdigit((unsigned char)text[length]))) {
        length++;
    }
    return length;
}

static const char *read_labels(const char *at)
{
    assert_int_equal(*at, '{');
    at++;
    while (*at != '}') {
        size_t length = name_length(at);
        assert_true(length > 0);
        at += length;
        assert_memory_equal(at, "=\"", 2);
        for (at += 2; *at != '"'; at++) {
            assert_true(*at != '\0' && *at != '\n');
            if (*at == '\\') {
                at++;
                assert_non_null(strchr("\\\"n", *at));
            }
        }
        at++;
        assert_true(*at == ',' || *at == '}');
        at += *at == ',' && at[1] != '}';
    }
    return at + 1;
}

static void read_head(struct metrics *metrics, const char *line)
{
    char family[80], type[20];
    if (strncmp(line, "# HELP ", 7) == 0) {
        assert_int_equal(sscanf(line, "# HELP %79s", family), 1);
        for (int i = 0; i < metrics->families; i++) { /* all lines of a family stand together */
            assert_string_not_equal(metrics->seen[i], family);
        }
        snprintf(metrics->seen[metrics->families++], 80, "%s", family);
        snprintf(metrics->family, sizeof metrics->family, "%s", family);
        metrics->type[0] = '\0';
        return;
    }
    assert_int_equal(sscanf(line, "# TYPE %79s %19s", family, type), 2);
    assert_string_equal(family, metrics->family);
    assert_true(strcmp(type, "gauge") == 0 || strcmp(type, "counter") == 0 || strcmp(type, "histogram") == 0);
    snprintf(metrics->type, sizeof metrics->type, "%s", type);
}

static void read_sample(struct metrics *metrics, const char *line)
{
    size_t length = name_length(line), family = strlen(metrics->family);
    const char *at = line + length;
    char *end;
    assert_true(metrics->type[0] && length >= family && strncmp(line, metrics->family, family) == 0);
    if (strcmp(metrics->type, "histogram") == 0) {
        char suffix[80];
        snprintf(suffix, sizeof suffix, "%.*s", (int)(length - family), line + family);
        assert_true(!strcmp(suffix, "_bucket") || !strcmp(suffix, "_sum") || !strcmp(suffix, "_count"));
    } else {
        assert_int_equal(length, family);
    }
    if (strcmp(metrics->type, "counter") == 0) {
        assert_memory_equal(line + length - 6, "_total", 6);
    }
    at = *at == '{' ? read_labels(at) : at;
    snprintf(metrics->series[metrics->samples], 200, "%.*s", (int)(at - line), line);
    for (int i = 0; i < metrics->samples; i++) { /* no series twice */
        assert_string_not_equal(metrics->series[i], metrics->series[metrics->samples]);
    }
    assert_int_equal(*at, ' ');
    metrics->values[metrics->samples++] = strtod(at + 1, &end);
    assert_true(end > at + 1 && *end == '\0');
}

static void read_metrics(struct metrics *metrics, char *text)
{
    assert_int_equal(text[strlen(text) - 1], '\n');
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n")) {
        if (line[0] == '#') {
            read_head(metrics, line);
        } else {
            read_sample(metrics, line);
        }
    }
}

static double value(const struct metrics *metrics, const char *series)
{
    for (int i = 0; i < metrics->samples; i++) {
        if (strcmp(metrics->series[i], series) == 0) {
            return metrics->values[i];
        }
    }
    return NAN;
}

static void assert_value(const struct metrics *metrics, const char *series, double wanted)
{
    if (!(fabs(value(metrics, series) - wanted) < 1e-9 * (1 + fabs(wanted)))) {
        fail_msg("%s is %g, not %g", series, value(metrics, series), wanted);
    }
}

static void metrics_are_read(void **state)
{
    static char text[STATUS_BYTES];
    static struct metrics metrics;
    struct status status = sample();
    (void)state;
    size_t length = status_metrics(&status, text, sizeof text);
    assert_true(length > 0 && length == strlen(text));
    read_metrics(&metrics, text);
    assert_value(&metrics, "frond_info{version=\"" FROND_VERSION "\",engine=\"cpu\",state=\"painting\",scene=\"dawn\"}",
                 1);
    assert_value(&metrics, "frond_uptime_seconds", 86400);
    assert_value(&metrics, "frond_visits_total", 12);
    assert_value(&metrics, "frond_drops_total", 345);
    assert_value(&metrics, "frond_frames_total", 5e9);
    assert_value(&metrics, "frond_vertical_blanks_missed_total", 17);
    assert_value(&metrics, "frond_display{state=\"shown\"}", 1);
    assert_value(&metrics, "frond_display{state=\"absent\"}", 0);
    assert_value(&metrics, "frond_frame_seconds_bucket{le=\"0.0175\"}", 1);
    assert_value(&metrics, "frond_frame_seconds_bucket{le=\"0.034\"}", 2);
    assert_value(&metrics, "frond_frame_seconds_bucket{le=\"5\"}", 2);
    assert_value(&metrics, "frond_frame_seconds_bucket{le=\"+Inf\"}", 3);
    assert_value(&metrics, "frond_frame_seconds_count", 3);
    assert_value(&metrics, "frond_frame_seconds_sum", 7.05);
    assert_value(&metrics, "frond_tick_seconds", 0.0042);
    assert_value(&metrics, "frond_temperature_celsius", 61.5);
    assert_value(&metrics, "frond_throttled", 1);
    assert_value(&metrics, "frond_gallery_pictures", 8);
    assert_value(&metrics, "frond_exhibit_errors_total", 2);
    assert_value(&metrics, "frond_exhibit_wrong", 1);
    assert_value(&metrics, "frond_device_works{device=\"0\",class=\"touchscreen\",name=\"A \\\"quoted\\\\\\\" name \"}",
                 1);
    assert_value(&metrics, "frond_device_works{device=\"1\",class=\"touchscreen\",name=\"A \\\"quoted\\\\\\\" name \"}",
                 0);
}

static void what_is_not_known_has_no_sample(void **state)
{
    static char text[STATUS_BYTES];
    static struct metrics metrics;
    struct status status = {.display = "absent", .celsius = NAN, .gallery = -1};
    (void)state;
    memset(&metrics, 0, sizeof metrics);
    assert_true(status_metrics(&status, text, sizeof text) > 0);
    read_metrics(&metrics, text);
    assert_true(isnan(value(&metrics, "frond_temperature_celsius")));
    assert_true(isnan(value(&metrics, "frond_gallery_pictures")));
    assert_value(&metrics, "frond_display{state=\"absent\"}", 1);
    assert_int_equal(status_metrics(&status, text, 100), 0); /* never half of it */
    assert_int_equal(status_json(&status, text, 100), 0);
}

static struct json_object *get(struct json_object *object, const char *name)
{
    struct json_object *found = NULL;
    assert_true(json_object_object_get_ex(object, name, &found));
    return found;
}

static void json_is_read(void **state)
{
    static char text[STATUS_BYTES];
    struct status status = sample();
    (void)state;
    size_t length = status_json(&status, text, sizeof text);
    assert_true(length > 0 && length == strlen(text));
    struct json_object *object = json_tokener_parse(text);
    assert_non_null(object);
    assert_string_equal(json_object_get_string(get(object, "frond")), FROND_VERSION);
    assert_string_equal(json_object_get_string(get(object, "state")), "painting");
    assert_int_equal(json_object_get_int64(get(object, "drops")), 345);
    assert_int_equal(json_object_get_int64(get(get(object, "frames"), "presented")), 5000000000);
    assert_float_equal(json_object_get_double(get(get(object, "frames"), "longest_ms")), 7000, 1e-3);
    assert_float_equal(json_object_get_double(get(get(object, "board"), "celsius")), 61.5, 1e-3);
    assert_int_equal(json_object_array_length(get(object, "devices")), 2);
    assert_int_equal(json_object_get_int(get(object, "gallery")), 8);
    json_object_put(object);
    status.celsius = NAN;
    status.gallery = -1;
    assert_true(status_json(&status, text, sizeof text) > 0);
    object = json_tokener_parse(text);
    assert_null(get(get(object, "board"), "celsius"));
    assert_null(get(object, "gallery"));
    json_object_put(object);
}

static void names_are_cleaned(void **state)
{
    char word[STATUS_WORD], text[200];
    (void)state;
    status_word(word, "Ger\xc3\xa4t\t\x01 \xff\xc3");
    assert_string_equal(word, "Ger\xc3\xa4t   ??");
    for (int i = 0; i < 66; i += 3) { /* no character is cut in two */
        memcpy(text + i, "\xe2\x82\xac", 4);
    }
    status_word(word, text);
    assert_int_equal(strlen(word), 63);
    memmove(text + 1, text, 67);
    text[0] = 'x';
    status_word(word, text);
    assert_int_equal(strlen(word), 61);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(metrics_are_read),
        cmocka_unit_test(what_is_not_known_has_no_sample),
        cmocka_unit_test(json_is_read),
        cmocka_unit_test(names_are_cleaned),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
