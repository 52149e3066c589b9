#include "word_lines.h"

#include <string.h>

enum { WIDTH = 100 };

void word_lines_add(struct word_lines *lines, const char *text)
{
    if (lines->column == 0 || lines->column + (int)strlen(text) > WIDTH) {
        lines->column = fprintf(lines->out, "%s    %s", lines->column > 0 ? ",\n" : "", text);
    } else {
        lines->column += fprintf(lines->out, ", %s", text);
    }
}

void word_lines_end(struct word_lines *lines)
{
    if (lines->column > 0) {
        fputc('\n', lines->out);
    }
}
