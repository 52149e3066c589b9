#include "clock_case.h"

#include <math.h>
#include <stdatomic.h>

#include "bench.h"

/* Names of the linker (--wrap). NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp) */
double __real_bench_wall_s(void);
double __wrap_bench_wall_s(void);

static _Atomic double now_s, followed_s; /* 0: not begun */

static void begin(void)
{
    double zero = 0, real_s = __real_bench_wall_s();
    if (atomic_compare_exchange_strong(&now_s, &zero, real_s)) {
        followed_s = real_s;
    }
}

double __wrap_bench_wall_s(void)
{
    begin();
    return now_s;
}

void clock_case_pass(double seconds)
{
    begin();
    followed_s = __real_bench_wall_s();
    now_s = now_s + seconds;
}

void clock_case_follow(double most)
{
    begin();
    clock_case_pass(fmin(__real_bench_wall_s() - followed_s, most));
}
/* NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp) */
