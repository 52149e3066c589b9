#include "schedule.h"

#include <stdio.h>
#include <stdlib.h>

enum {
    DAYS_BEFORE = 2, /* hours may end on the day after */
    DAYS = 7 + 2 * DAYS_BEFORE,
    SPANS = EXHIBIT_HOURS * DAYS,
    MINUTES_A_DAY = 1440,
};

struct span {
    time_t from, to;
};

/* What a clock on the wall shows as `minutes` of a day may be two moments, or none. Two: the first or the last of
 * them. None, because the clock was put forward over it: as if it had not been yet. */
static time_t moment(const struct tm *day, int minutes, bool last)
{
    time_t found = 0;
    bool any = false;
    for (int summer = 1; summer >= 0; summer--) {
        struct tm wanted = {.tm_year = day->tm_year,
                            .tm_mon = day->tm_mon,
                            .tm_mday = day->tm_mday + minutes / MINUTES_A_DAY,
                            .tm_hour = minutes % MINUTES_A_DAY / 60,
                            .tm_min = minutes % 60,
                            .tm_isdst = summer};
        time_t time = mktime(&wanted);
        bool shows = wanted.tm_hour * 60 + wanted.tm_min == minutes % MINUTES_A_DAY && wanted.tm_isdst == summer;
        if (!any || (shows && (last ? time > found : time < found))) {
            found = time;
        }
        any |= shows;
    }
    return found;
}

static int by_beginning(const void *a, const void *b)
{
    const struct span *one = a, *other = b;
    return (one->from > other->from) - (one->from < other->from);
}

/* The hours of the days around `now`, in order; those that touch are one. */
static int spans_around(const struct exhibit *exhibit, time_t now, struct span spans[SPANS])
{
    struct tm today;
    if (!localtime_r(&now, &today)) {
        return 0;
    }
    int count = 0;
    for (int i = 0; i < DAYS; i++) {
        struct tm day = {.tm_year = today.tm_year,
                         .tm_mon = today.tm_mon,
                         .tm_mday = today.tm_mday + i - DAYS_BEFORE,
                         .tm_hour = 12,
                         .tm_isdst = -1};
        mktime(&day);
        for (int j = 0; j < exhibit->hours_count; j++) {
            const struct exhibit_hours *hours = &exhibit->hours[j];
            if (hours->days[(day.tm_wday + 6) % 7]) {
                int to = hours->to > hours->from ? hours->to : hours->to + MINUTES_A_DAY;
                spans[count++] = (struct span){moment(&day, hours->from, false), moment(&day, to, true)};
            }
        }
    }
    qsort(spans, (size_t)count, sizeof spans[0], by_beginning);
    int merged = 0;
    for (int i = 0; i < count; i++) {
        if (merged > 0 && spans[i].from <= spans[merged - 1].to) {
            time_t to = spans[merged - 1].to;
            spans[merged - 1].to = spans[i].to > to ? spans[i].to : to;
        } else {
            spans[merged++] = spans[i];
        }
    }
    return merged;
}

static void say(struct schedule_answer *answer, const char *what)
{
    static const char *const days[] = {"Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"};
    struct tm next;
    if (answer->next && localtime_r(&answer->next, &next)) {
        snprintf(answer->text, sizeof answer->text, "%s until %s %02d:%02d", what, days[next.tm_wday], next.tm_hour,
                 next.tm_min);
    } else {
        snprintf(answer->text, sizeof answer->text, "always %s", what);
    }
}

struct schedule_answer schedule_at(const struct exhibit *exhibit, time_t now, time_t built)
{
    struct schedule_answer answer = {.open = true};
    if (now < built) {
        answer.unset = true;
        snprintf(answer.text, sizeof answer.text, "open: the clock was never set");
        return answer;
    }
    if (exhibit->hours_count == 0) {
        say(&answer, "open");
        return answer;
    }
    struct span spans[SPANS];
    int count = spans_around(exhibit, now, spans);
    int i = 0;
    while (i < count && spans[i].to <= now) {
        i++;
    }
    answer.open = i < count && spans[i].from <= now;
    if (i < count) {
        answer.next = answer.open ? spans[i].to : spans[i].from;
    }
    time_t week = 7 * (time_t)86400;
    if (answer.open && answer.next - now > week) { /* hours that follow one another without end */
        answer.next = 0;
    }
    say(&answer, answer.open ? "open" : "closed");
    return answer;
}
