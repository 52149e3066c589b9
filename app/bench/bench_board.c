#include "bench_board.h"

#include <stddef.h>

const struct bench_board bench_boards[] = {
    {"pi4", 5.0e9, 3.9e9},
    {"pi5", 8.3e9, 19.8e9},
    {"rk3588", 18.0e9, 467e9},
    {NULL, 0, 0},
};

double bench_board_s(const struct bench_board *board, double bytes, double operations)
{
    double memory = bytes / board->bytes_per_s, arithmetic = operations / board->operations_per_s;
    return memory > arithmetic ? memory : arithmetic;
}
