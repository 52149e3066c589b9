/* soak [--minutes N | --seconds N] [--seed N] [--only FAULT] [--aloud]: a kiosk with visitors, and all that goes wrong.
 * Tells figures once a minute; the exit status is 0 when everything is as it should be. */
#include "soak.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>

#include "kiosk_state.h"
#include "patience.h"
#include "soak_chatter.h"
#include "soak_fault.h"
#include "soak_gauge.h"
#include "soak_guest.h"

static const double PEACE_S = 90 * SLOWER; /* until everything must be as at first, once nothing happens any more */
static const double LONG_S = 300;          /* from then on slopes mean something */
enum { BESIDES = 20 };

struct order {
    double seconds;
    uint32_t seed;
    const char *only; /* this fault alone, and often; NULL: all */
    bool aloud;
};

static bool read_order(int count, char **arguments, struct order *order)
{
    *order = (struct order){.seconds = 25, .seed = 1};
    for (int i = 1; i < count; i++) {
        const char *name = arguments[i], *value = i + 1 < count ? arguments[i + 1] : "";
        char *end = NULL;
        if (strcmp(name, "--aloud") == 0) {
            order->aloud = true;
            continue;
        }
        if (strcmp(name, "--only") == 0 && *value) {
            order->only = value;
            i++;
            continue;
        }
        double number = strtod(value, &end);
        if (end == value || *end || number <= 0 || number > 1e6) {
            return false;
        }
        if (strcmp(name, "--minutes") == 0) {
            order->seconds = 60 * number;
        } else if (strcmp(name, "--seconds") == 0) {
            order->seconds = number;
        } else if (strcmp(name, "--seed") == 0) {
            order->seed = (uint32_t)number;
        } else {
            return false;
        }
        i++;
    }
    return true;
}

/* Hands that the kiosk believes in, while there are none. */
static int phantoms(const struct soak *soak)
{
    const struct kiosk *kiosk = soak->live.kiosk.kiosk;
    int count = controls_are_held(soak->live.input.controls);
    for (int i = 0; i < KIOSK_HANDS; i++) {
        count += kiosk->hands[i].used;
    }
    for (int i = 0; i < HUD_FINGERS; i++) {
        count += kiosk->hud.fingers[i].used;
    }
    return count;
}

/* The same line three times a minute, and 120 of all of them: log.h; and no more of a kind than there were reasons. */
static void judge_log(const struct chatter *chatter, const struct faults *faults, struct soak *soak)
{
    int all = faults_count(faults), minutes = (int)(soak_s(soak) / 60) + 2;
    for (int i = 0; i < chatter->line_count; i++) {
        const struct chatter_line *line = &chatter->lines[i];
        soak_say("%6d x %s", line->count, line->text);
        if (strncmp(line->text, "frond: visit #", 14) != 0 && line->count > 2 * all + BESIDES) {
            soak_fail(soak, "that comes too often for %d faults", all);
        }
    }
    soak_say("%d lines in the log", chatter->total);
    if (chatter->same_most > LOG_SAME || chatter->total > (LOG_LINES + BESIDES) * minutes || chatter->lost > 0) {
        soak_fail(soak, "%d lines, one of them %d times on end; %d found no room", chatter->total, chatter->same_most,
                  chatter->lost);
    }
}

static bool has_visits(const struct soak *soak, const struct guest *guest, double seconds)
{
    return kiosk_visits(soak->live.kiosk.kiosk) >= seconds / 5 && guest->finished > 0 && guest->walked > 0;
}

static void judge(struct soak *soak, const struct guest *guest, const struct faults *faults, double seconds)
{
    uint32_t visits = kiosk_visits(soak->live.kiosk.kiosk);
    struct controls_counts counts = controls_counts(soak->live.input.controls);
    soak_say(
        "%u visits in %.0f s: %d finished, %d walked away, %d of them came back in the countdown; the longest took "
        "%.1f s from the last touch to attract; the one switch was pressed %d times",
        visits, seconds, guest->finished, guest->walked, guest->teased, guest->longest_s, guest->switched);
    for (int i = 0; i < FAULT_KINDS; i++) {
        printf("%s%s %d", i > 0 ? ", " : "faults: ", fault_name((enum fault_kind)i), faults->fault[i].count);
    }
    soak_say("%s", soak->disks ? "" : " (no disk of its own can be mounted here)");
    unsigned resets = (unsigned)soak->live.service.status.gpu_resets;
    if (resets != (unsigned)faults->fault[FAULT_RESET].count) {
        soak_fail(soak, "of %d resets of the GPU %u were noticed", faults->fault[FAULT_RESET].count, resets);
    }
    if (!has_visits(soak, guest, seconds)) {
        soak_fail(soak, "too few visits");
    }
    if (soak->refused > 0 || counts.dropped > 0) {
        soak_fail(soak, "%llu actions refused, %llu dropped", (unsigned long long)soak->refused,
                  (unsigned long long)counts.dropped);
    }
}

/* No visitor, no fault: attract, with nothing left of what was. */
static void come_to_rest(struct soak *soak, struct guest *guest, struct faults *faults, struct gauge *gauge,
                         struct chatter *chatter)
{
    double from = soak_s(soak), calm_s = 0;
    bool going = true, rested = false;
    guest->retired = faults->retired = gauge->resting = true;
    while (going && !rested && soak_s(soak) < from + PEACE_S) {
        guest_turn(guest, soak);
        faults_turn(faults, soak);
        going = soak_turn(soak);
        gauge_turn(gauge, soak);
        chatter_listen(chatter, soak_s(soak));
        const struct live_kiosk *kiosk = &soak->live.kiosk;
        bool calm = guest->state == GUEST_AWAY && faults_over(faults) && !kiosk->before && phantoms(soak) == 0 &&
                    strcmp(kiosk_state(kiosk->kiosk), "attract") == 0 && gauge->quiet;
        calm_s = calm ? (calm_s > 0 ? calm_s : soak_s(soak)) : 0;
        rested = calm && soak_s(soak) > calm_s + 2;
    }
    if (!rested) {
        const struct live_kiosk *kiosk = &soak->live.kiosk;
        soak_fail(
            soak,
            "%.0f s after everybody has gone it is in %s, with %d hands that are not there; visitors %s, faults %s, "
            "%s, %s is written",
            PEACE_S, kiosk_state(kiosk->kiosk), phantoms(soak), guest->state == GUEST_AWAY ? "away" : "there",
            faults_over(faults) ? "over" : "not over", kiosk->before ? "an exhibit is held" : "no exhibit is held",
            gauge->quiet ? "nothing" : "something");
    }
}

static bool run(struct soak *soak, const struct order *order)
{
    static struct gauge gauge;
    static struct chatter chatter;
    struct guest guest = {.state = GUEST_AWAY};
    struct faults faults;
    double told_s = 0;
    if (!chatter_open(&chatter, order->aloud) || !soak_open(soak, order->seed) ||
        !faults_init(&faults, soak,
                     order->only               ? 0.1
                     : order->seconds < LONG_S ? 0.4
                                               : 1,
                     order->only) ||
        !gauge_open(&gauge, soak, order->seconds < LONG_S ? 3 : 30)) {
        chatter_close(&chatter);
        soak_say("the soak cannot begin; the last line was: %s", chatter.last);
        return false;
    }
    bool going = true;
    double most_s = order->seconds + PATIENCE_S; /* where the machine is slow, visitors are */
    while (going &&
           (soak_s(soak) < order->seconds || (soak_s(soak) < most_s && !has_visits(soak, &guest, order->seconds)))) {
        guest_turn(&guest, soak);
        faults_turn(&faults, soak);
        going = soak_turn(soak);
        gauge_turn(&gauge, soak);
        chatter_listen(&chatter, soak_s(soak));
        if (order->aloud && soak->turn_s > 0.4) {
            soak_say("%8.3f a turn of %.0f ms in %s", soak_s(soak), 1000 * soak->turn_s,
                     kiosk_state(soak->live.kiosk.kiosk));
        }
        if (soak_s(soak) > told_s + 60) {
            told_s = soak_s(soak);
            gauge_tell(&gauge, soak);
        }
    }
    gauge_tell(&gauge, soak);
    come_to_rest(soak, &guest, &faults, &gauge, &chatter);
    chatter_close(&chatter);
    judge(soak, &guest, &faults, order->seconds);
    gauge_judge(&gauge, soak, order->seconds >= LONG_S);
    judge_log(&chatter, &faults, soak);
    gauge_close(&gauge);
    return !soak->failed;
}

int main(int count, char **arguments)
{
    static struct soak soak;
    struct order order;
    if (!read_order(count, arguments, &order)) {
        fprintf(stderr, "soak [--minutes N | --seconds N] [--seed N] [--only FAULT] [--aloud]\n");
        return 2;
    }
    setvbuf(stdout, NULL, _IOLBF, 0);
    prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0); /* the kernel's huge pages fill up a heap's holes: no growth of ours */
    bool good = run(&soak, &order);
    soak_close(&soak);
    soak_say("%s", good ? "the soak is passed" : "the soak has failed");
    return good ? 0 : 1;
}
