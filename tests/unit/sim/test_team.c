/* Every piece is done once, by a member of the team, before team_run returns. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdatomic.h>
#include <string.h>
#include <unistd.h>

#include "team.h"

enum { PIECES = 500, SIZE = 5 };

struct ledger {
    int done[PIECES]; /* plain: two members on one piece are a race that the thread sanitizer sees */
    atomic_int strangers;
};

static void enter(void *context, int piece, int member)
{
    struct ledger *ledger = context;
    ledger->done[piece]++;
    if (member < 0 || member >= SIZE) {
        atomic_fetch_add(&ledger->strangers, 1);
    }
}

static void every_piece_is_done_once(void **state)
{
    (void)state;
    struct team *team = team_create(SIZE);
    assert_non_null(team);
    assert_int_equal(team_size(team), SIZE);
    struct ledger ledger = {.strangers = 0};
    int rounds = 0;
    for (int pieces = 0; pieces <= PIECES; pieces += 1 + pieces / 3, rounds++) {
        memset(ledger.done, 0, sizeof ledger.done);
        team_run(team, enter, &ledger, pieces);
        for (int piece = 0; piece < PIECES; piece++) {
            assert_int_equal(ledger.done[piece], piece < pieces);
        }
        if (rounds % 5 == 0) {
            usleep(3000); /* the others fall asleep: they must be woken */
        }
    }
    assert_int_equal(ledger.strangers, 0);
    team_destroy(team);
}

static void a_team_may_be_alone_or_as_many_as_the_machine_has(void **state)
{
    (void)state;
    struct team *alone = team_create(1), *whole = team_create(0);
    assert_true(alone && whole);
    assert_int_equal(team_size(alone), 1);
    assert_true(team_size(whole) >= 1);
    team_destroy(alone);
    team_destroy(whole);
    team_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_piece_is_done_once),
        cmocka_unit_test(a_team_may_be_alone_or_as_many_as_the_machine_has),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
