/* The schedule: hours by weekday in local time, over midnight and over days on which clocks are changed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "schedule.h"

static const time_t BUILT = 1700000000; /* 14 November 2023 */

static void zone(const char *name)
{
    setenv("TZ", name, 1);
    tzset();
}

/* Seconds since 1970 of a time in UTC. */
static time_t utc(int year, int month, int day, int hour, int minute)
{
    struct tm tm = {.tm_year = year - 1900, .tm_mon = month - 1, .tm_mday = day, .tm_hour = hour, .tm_min = minute};
    return timegm(&tm);
}

/* "1111100 10:00 18:00": days, Monday first. */
static void add(struct exhibit *exhibit, const char *days, int from, int to)
{
    struct exhibit_hours *hours = &exhibit->hours[exhibit->hours_count++];
    *hours = (struct exhibit_hours){.from = from, .to = to};
    for (int i = 0; i < 7; i++) {
        hours->days[i] = days[i] == '1';
    }
}

static void check(const struct exhibit *exhibit, time_t now, bool open, time_t next, const char *text)
{
    struct schedule_answer answer = schedule_at(exhibit, now, BUILT);
    if (answer.open != open || answer.next != next || strcmp(answer.text, text) != 0) {
        fail_msg("%s, next %lld; wanted: %s, next %lld", answer.text, (long long)answer.next, text, (long long)next);
    }
    assert_false(answer.unset);
}

static void weekdays(void **state)
{
    (void)state;
    zone("Europe/Berlin");
    struct exhibit exhibit = {.hours_count = 0};
    check(&exhibit, utc(2026, 11, 22, 12, 0), true, 0, "always open");
    add(&exhibit, "1111100", 600, 1080);
    add(&exhibit, "0000010", 720, 1200);
    /* Friday 20 November 2026; Berlin is an hour ahead. */
    check(&exhibit, utc(2026, 11, 20, 8, 59), false, utc(2026, 11, 20, 9, 0), "closed until Friday 10:00");
    check(&exhibit, utc(2026, 11, 20, 9, 0), true, utc(2026, 11, 20, 17, 0), "open until Friday 18:00");
    check(&exhibit, utc(2026, 11, 20, 16, 59), true, utc(2026, 11, 20, 17, 0), "open until Friday 18:00");
    check(&exhibit, utc(2026, 11, 20, 17, 0), false, utc(2026, 11, 21, 11, 0), "closed until Saturday 12:00");
    check(&exhibit, utc(2026, 11, 21, 19, 30), false, utc(2026, 11, 23, 9, 0), "closed until Monday 10:00");
    check(&exhibit, utc(2026, 11, 22, 12, 0), false, utc(2026, 11, 23, 9, 0), "closed until Monday 10:00");
    memset(exhibit.hours, 0, sizeof exhibit.hours);
    check(&exhibit, utc(2026, 11, 22, 12, 0), false, 0, "always closed");
    exhibit.hours_count = 0;
    add(&exhibit, "0000001", 600, 660); /* once a week */
    check(&exhibit, utc(2026, 11, 22, 10, 0), false, utc(2026, 11, 29, 9, 0), "closed until Sunday 10:00");
}

static void hours_that_touch_are_one(void **state)
{
    (void)state;
    zone("UTC");
    struct exhibit exhibit = {.hours_count = 0};
    add(&exhibit, "1000000", 600, 1080);
    add(&exhibit, "1000000", 1080, 1200);
    add(&exhibit, "1000000", 1140, 1260);
    check(&exhibit, utc(2026, 11, 23, 11, 0), true, utc(2026, 11, 23, 21, 0), "open until Monday 21:00");
    exhibit.hours_count = 0;
    add(&exhibit, "1111111", 0, 1440);
    check(&exhibit, utc(2026, 11, 23, 0, 0), true, 0, "always open");
    check(&exhibit, utc(2026, 11, 23, 23, 59), true, 0, "always open");
    exhibit.hours_count = 0;
    add(&exhibit, "1111110", 0, 1440); /* from Monday to Saturday without a night */
    check(&exhibit, utc(2026, 11, 24, 3, 0), true, utc(2026, 11, 29, 0, 0), "open until Sunday 00:00");
}

static void days_go_over_midnight(void **state)
{
    (void)state;
    zone("America/New_York"); /* five hours behind in winter */
    struct exhibit exhibit = {.hours_count = 0};
    add(&exhibit, "0000110", 1080, 120);
    check(&exhibit, utc(2026, 11, 20, 23, 0), true, utc(2026, 11, 21, 7, 0), "open until Saturday 02:00");
    check(&exhibit, utc(2026, 11, 21, 6, 59), true, utc(2026, 11, 21, 7, 0), "open until Saturday 02:00");
    check(&exhibit, utc(2026, 11, 21, 7, 0), false, utc(2026, 11, 21, 23, 0), "closed until Saturday 18:00");
    check(&exhibit, utc(2026, 11, 22, 6, 0), true, utc(2026, 11, 22, 7, 0), "open until Sunday 02:00");
    check(&exhibit, utc(2026, 11, 22, 8, 0), false, utc(2026, 11, 27, 23, 0), "closed until Friday 18:00");
    exhibit.hours_count = 0;
    add(&exhibit, "0000001", 600, 600); /* a whole day and night */
    check(&exhibit, utc(2026, 11, 23, 14, 59), true, utc(2026, 11, 23, 15, 0), "open until Monday 10:00");
}

static void days_on_which_clocks_are_changed(void **state)
{
    (void)state;
    struct exhibit exhibit = {.hours_count = 0};
    add(&exhibit, "1111111", 600, 1080);
    /* Berlin: 29 March 2026 forward, 25 October 2026 back. The hours on the wall stay. */
    zone("Europe/Berlin");
    check(&exhibit, utc(2026, 3, 28, 9, 0), true, utc(2026, 3, 28, 17, 0), "open until Saturday 18:00");
    check(&exhibit, utc(2026, 3, 28, 18, 0), false, utc(2026, 3, 29, 8, 0), "closed until Sunday 10:00");
    check(&exhibit, utc(2026, 3, 29, 8, 0), true, utc(2026, 3, 29, 16, 0), "open until Sunday 18:00");
    check(&exhibit, utc(2026, 10, 24, 20, 0), false, utc(2026, 10, 25, 9, 0), "closed until Sunday 10:00");
    check(&exhibit, utc(2026, 10, 25, 9, 0), true, utc(2026, 10, 25, 17, 0), "open until Sunday 18:00");
    /* An hour that is there twice: open from its first, until its last. */
    exhibit.hours_count = 0;
    add(&exhibit, "0000001", 150, 240);
    add(&exhibit, "0000010", 1320, 150);
    check(&exhibit, utc(2026, 10, 25, 0, 29), true, utc(2026, 10, 25, 3, 0), "open until Sunday 04:00");
    exhibit.hours_count = 1;
    check(&exhibit, utc(2026, 10, 25, 0, 29), false, utc(2026, 10, 25, 0, 30), "closed until Sunday 02:30");
    exhibit.hours_count = 0;
    add(&exhibit, "0000010", 1320, 150);
    check(&exhibit, utc(2026, 10, 25, 1, 29), true, utc(2026, 10, 25, 1, 30), "open until Sunday 02:30");
    check(&exhibit, utc(2026, 10, 25, 1, 30), false, utc(2026, 10, 31, 21, 0), "closed until Saturday 22:00");
    /* An hour that is not there. */
    check(&exhibit, utc(2026, 3, 29, 0, 0), true, utc(2026, 3, 29, 1, 30), "open until Sunday 03:30");
    /* Half an hour, in the south; and a night that begins before and ends after. */
    zone("Australia/Lord_Howe"); /* 5 April 2026 back from +11:00 to +10:30 */
    exhibit.hours_count = 0;
    add(&exhibit, "0000010", 1200, 360);
    check(&exhibit, utc(2026, 4, 4, 9, 0), true, utc(2026, 4, 4, 19, 30), "open until Sunday 06:00");
    zone("Asia/Kathmandu"); /* +5:45, no summer time */
    check(&exhibit, utc(2026, 4, 4, 14, 14), false, utc(2026, 4, 4, 14, 15), "closed until Saturday 20:00");
}

static void a_clock_that_was_never_set_means_open(void **state)
{
    (void)state;
    zone("Europe/Berlin");
    struct exhibit exhibit = {.hours_count = 0};
    add(&exhibit, "1111111", 600, 1080);
    static const time_t times[] = {0, 1, 86400, 1699999999, -5};
    for (size_t i = 0; i < sizeof times / sizeof times[0]; i++) {
        struct schedule_answer answer = schedule_at(&exhibit, times[i], BUILT);
        assert_true(answer.open && answer.unset && answer.next == 0);
        assert_string_equal(answer.text, "open: the clock was never set");
    }
    assert_false(schedule_at(&exhibit, BUILT, BUILT).unset);
}

/* Whatever the clock shows, and however it gets there: what is said to come next comes, and not before. */
static void what_is_next_is_next(void **state)
{
    (void)state;
    static const char *const zones[] = {"Europe/Berlin", "America/Sao_Paulo", "Pacific/Apia", "Africa/Casablanca",
                                        "America/New_York"};
    struct exhibit exhibit = {.hours_count = 0};
    add(&exhibit, "1110100", 615, 1080);
    add(&exhibit, "0000111", 1200, 165);
    add(&exhibit, "0010000", 0, 60);
    for (size_t i = 0; i < sizeof zones / sizeof zones[0]; i++) {
        zone(zones[i]);
        for (time_t now = utc(2026, 1, 1, 0, 0); now < utc(2027, 1, 1, 0, 0); now += 9 * 86400 + 30061) {
            struct schedule_answer answer = schedule_at(&exhibit, now, BUILT);
            assert_true(answer.next > now && answer.next <= now + 8 * (time_t)86400);
            assert_int_equal(schedule_at(&exhibit, answer.next - 1, BUILT).open, answer.open);
            assert_int_equal(schedule_at(&exhibit, answer.next, BUILT).open, !answer.open);
            time_t between = now + (answer.next - now) / 2;
            assert_true(schedule_at(&exhibit, between, BUILT).next == answer.next);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weekdays),
        cmocka_unit_test(hours_that_touch_are_one),
        cmocka_unit_test(days_go_over_midnight),
        cmocka_unit_test(days_on_which_clocks_are_changed),
        cmocka_unit_test(a_clock_that_was_never_set_means_open),
        cmocka_unit_test(what_is_next_is_next),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
