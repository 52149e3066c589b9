/* test_keep_kill [KILLS]: a process that paints is killed at random moments, again and again; each time the painting is
 * there, to the bit that of a tick at most five seconds before, and its journal with it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "folder_case.h"
#include "keep_case.h"
#include "patience.h"
#include "player.h"

enum {
    KILLS = 25,
    AGE_MOST = 5 * 60, /* ticks: five seconds */
    SHEET_TICKS = 90,  /* then a fresh sheet */
    JOURNAL_EVERY = 5, /* kills from one whole play of the journal to the next */
    LEAST_MS = 5,
    MOST_MS = 160,
};

/* What the one who is killed has painted. */
struct shared {
    _Atomic uint64_t generation; /* 0: nothing yet */
    _Atomic int64_t ticks;
    _Atomic bool begun;
};

struct place {
    struct keep_case_table table;
    struct shared *shared;
    int kills;
    uint32_t dice;
};

static void nap(int ms)
{
    struct timespec time = {ms / 1000, ms % 1000 * 1000000L};
    nanosleep(&time, NULL);
}

/* Of all threads: what others do on the machine does not count. */
static double processor_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* A second of this is worth twenty of a kiosk's: a tick takes a millisecond and a little. */
static struct keep_def quick_def(void)
{
    struct keep_def def = keep_default_def();
    def.folder = "state";
    def.every_s = 0.04;
    def.most_s = 0.2;
    def.repeat_s = 0.05;
    def.flush_s = 0.02;
    strcpy(def.head.engine, "cpu");
    return def;
}

/* The one who is killed. */
static void paint_for_ever(struct place *place)
{
    struct keep_def def = quick_def();
    struct keep_found found;
    struct keep_case one;
    bool good = keep_find("state", PATIENCE_S, &found);
    struct keep *keep = keep_create(&def, good ? &found : NULL);
    if (!keep) {
        _exit(3);
    }
    keep_visit(keep, true);
    if (!keep_case_open(&one, keep, good ? &found : NULL) || !keep_case_is_right(&one, &place->table)) {
        _exit(4);
    }
    uint64_t generation = good ? found.generation : 1; /* nothing was kept: as the keep counts */
    place->shared->generation = generation;
    place->shared->ticks = one.engine->ops->ticks(one.engine);
    place->shared->begun = true;
    for (int64_t most = SHEET_TICKS;;) {
        int64_t ticks = one.engine->ops->ticks(one.engine);
        if (ticks >= most) {
            while (keep_report(keep).kept_ticked < ticks) { /* a disk that is sheets behind loses them */
                nap(1);
            }
            most = ticks + 1; /* no sheet is as long as one before, so that what is kept is of this one */
            keep_case_fresh(&one);
            place->shared->generation = ++generation;
            place->shared->ticks = 0;
        }
        keep_case_tick(&one);
        place->shared->ticks = one.engine->ops->ticks(one.engine);
        nap(1);
    }
}

/* Paints it all again from its first tick. */
static void check_journal(const struct keep_found *found, uint64_t hash)
{
    struct player player;
    const int threads = 1;
    struct player_maker maker = player_cpu(&threads);
    struct file_error error;
    assert_true(found->journal.size > 0);
    if (!player_open(&player, found->journal.data, found->journal.size, &maker, &error)) {
        fail_msg("%s", error.text);
    }
    while (player_tick(&player, &error)) {
    }
    while (player.ticked < found->ticked) { /* time that no record tells of any more */
        player.engine->ops->tick(player.engine);
        player.ticked++;
    }
    assert_true(painting_hash(engine_cpu_painting(player.engine)) == hash);
    player_close(&player);
}

/* How old the painting is that is there, in ticks; -1: there is none, as it may be in the first moments. */
static int64_t check(const struct place *place, bool journal, double *took_s)
{
    struct keep_found found;
    struct keep_case one;
    double began = processor_s();
    int64_t painted = place->shared->ticks;
    if (!keep_find("state", PATIENCE_S, &found)) {
        assert_true(place->shared->generation <= 1 && painted <= AGE_MOST);
        return -1;
    }
    *took_s = processor_s() - began;
    assert_true(keep_case_open(&one, NULL, &found));
    assert_true(keep_case_is_right(&one, &place->table));
    if (journal) {
        check_journal(&found, keep_case_hash(&one));
    }
    int64_t age = found.generation == place->shared->generation ? painted - found.ticked : painted;
    assert_true(found.generation + 1 >= place->shared->generation);
    keep_case_close(&one);
    keep_found_finish(&found);
    return age;
}

static void the_painting_survives_every_kill(void **state)
{
    struct place *place = *state;
    int64_t oldest = 0, sum = 0;
    double longest_s = 0;
    int back = 0;
    for (int kill_number = 0; kill_number < place->kills; kill_number++) {
        double took_s = 0;
        place->shared->begun = false;
        pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            paint_for_ever(place);
        }
        for (int waited = 0; kill_number % 4 > 0 && !place->shared->begun && waited < PATIENCE_MS; waited++) {
            nap(1); /* one in four is killed while it begins */
        }
        place->dice = place->dice * 1664525u + 1013904223u;
        nap(LEAST_MS + (int)(place->dice >> 8) % (MOST_MS - LEAST_MS));
        int status;
        assert_int_equal(kill(child, SIGKILL), 0);
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status)); /* it did not end by itself, with a painting that was wrong */
        int64_t age = check(place, kill_number % JOURNAL_EVERY == 0 && place->shared->generation > 0, &took_s);
        assert_true(age <= AGE_MOST);
        back += age >= 0;
        sum += age > 0 ? age : 0;
        oldest = age > oldest ? age : oldest;
        longest_s = took_s > longest_s ? took_s : longest_s;
    }
    print_message(
        "%d kills, %d sheets: %d times back, %.0f ticks old, %lld at most; found within %.0f ms of a processor\n",
        place->kills, (int)place->shared->generation, back, back ? (double)sum / back : 0, (long long)oldest,
        1e3 * longest_s);
    assert_true(back >= place->kills * 3 / 4);
    assert_true(longest_s < 3 * SLOWER);
}

static int set_up(void **state)
{
    struct place *place = *state;
    place->shared = mmap(NULL, sizeof *place->shared, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    place->dice = (uint32_t)getpid();
    bool good = place->shared != MAP_FAILED && keep_case_paint(&place->table);
    return good ? folder_case_enter(state) : -1;
}

int main(int argc, char *argv[])
{
    static struct place place;
    place.kills = argc > 1 ? atoi(argv[1]) : KILLS;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate_setup_teardown(the_painting_survives_every_kill, set_up, folder_case_leave, &place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
