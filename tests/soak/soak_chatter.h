/* What a kiosk writes on stderr while it is left alone: how often each line comes, numbers aside. */
#ifndef FROND_SOAK_CHATTER_H
#define FROND_SOAK_CHATTER_H

#include <stdbool.h>
#include <stddef.h>

enum { CHATTER_LINES = 256, CHATTER_BYTES = 120 };

struct chatter {
    int file, terminal; /* where stderr goes now, and went before */
    long long offset;
    char rest[CHATTER_BYTES * 4]; /* a line whose end has not come */
    size_t length;
    struct chatter_line {
        char text[CHATTER_BYTES]; /* each number is a # */
        int count;
    } lines[CHATTER_LINES];
    int line_count;
    int lost; /* other lines than there is room for */
    char last[CHATTER_BYTES * 4];
    int same, same_most; /* the very same line, one after the other */
    int total;
    double now_s;
    bool aloud; /* lines are told as well */
};

/* Takes stderr. False: no file is to be had. */
bool chatter_open(struct chatter *chatter, bool aloud);
/* Takes what has been said since. */
void chatter_listen(struct chatter *chatter, double now_s);
/* Gives stderr back. */
void chatter_close(struct chatter *chatter);
/* How often a line with that in it came. */
int chatter_count(const struct chatter *chatter, const char *part);

#endif
