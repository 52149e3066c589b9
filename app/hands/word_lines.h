/* Words with commas between them, in lines of bounded length, four spaces in. */
#ifndef FROND_WORD_LINES_H
#define FROND_WORD_LINES_H

#include <stdio.h>

struct word_lines { /* `out`, else zero */
    FILE *out;
    int column;
};

void word_lines_add(struct word_lines *lines, const char *text);
void word_lines_end(struct word_lines *lines);

#endif
