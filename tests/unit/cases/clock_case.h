/* The clock of the app (bench_wall_s) in the test's hand: it stands, and passes as the test lets it, in all threads. So
 * what happens within a time does not depend on how quick the machine is. For programs that frond_unit links with
 * CLOCK. */
#ifndef FROND_CLOCK_CASE_H
#define FROND_CLOCK_CASE_H

/* Seconds that have not passed for the app yet, 0..; whoever waits for them on the system's clock waits in vain, and
 * looks again. */
void clock_case_pass(double seconds);
/* So long as has really passed since this, or clock_case_pass, was called last, but not more than `most` seconds. */
void clock_case_follow(double most);

#endif
