/* Boards that Frond is meant for, as far as their numbers are known, and what they would take for work that is counted
 * in bytes and operations. A prediction, not a measurement: no board is at hand. */
#ifndef FROND_BENCH_BOARD_H
#define FROND_BENCH_BOARD_H

struct bench_board {
    const char *name;
    double bytes_per_s;      /* usable memory bandwidth, as published by those who measured it */
    double operations_per_s; /* of the best hand-written compute shader that is known */
};

/* Raspberry Pi 4 (V3D 4.2), Raspberry Pi 5 (V3D 7.1), RK3588 (Mali-G610); ends with a board whose name is NULL. */
extern const struct bench_board bench_boards[];

/* Seconds by the roofline: as long as the slower of memory and arithmetic takes. */
double bench_board_s(const struct bench_board *board, double bytes, double operations);

#endif
