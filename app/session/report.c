#include "report.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

void report_init(struct report *report, const char *file)
{
    *report = (struct report){.file = strdup(file)};
}

void report_finish(struct report *report)
{
    for (int i = 0; i < report->count; i++) {
        free(report->problems[i].text);
    }
    free(report->problems);
    free(report->file);
    *report = (struct report){0};
}

bool report_empty(const struct report *report)
{
    return report->count == 0 && report->dropped == 0;
}

static bool make_room(struct report *report)
{
    if (report->count < report->capacity) {
        return true;
    }
    if (report->count == REPORT_PROBLEMS_MAX) {
        return false;
    }
    int capacity = report->capacity ? 2 * report->capacity : 16;
    capacity = capacity < REPORT_PROBLEMS_MAX ? capacity : REPORT_PROBLEMS_MAX;
    struct problem *grown = realloc(report->problems, (size_t)capacity * sizeof *grown);
    if (!grown) {
        return false;
    }
    report->problems = grown;
    report->capacity = capacity;
    return true;
}

void report_add(struct report *report, int line, int column, const char *key, const char *format, ...)
{
    char message[2048];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);

    size_t size = strlen(key) + strlen(message) + 3;
    char *text = make_room(report) ? malloc(size) : NULL;
    if (!text) {
        report->dropped++;
        return;
    }
    snprintf(text, size, "%s%s%s", key, *key ? ": " : "", message);
    for (char *c = text; *c; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
    report->problems[report->count++] = (struct problem){line, column, text};
}

static int by_place(const void *a, const void *b)
{
    const struct problem *p = a, *q = b;
    if (p->line != q->line) {
        return p->line < q->line ? -1 : 1;
    }
    if (p->column != q->column) {
        return p->column < q->column ? -1 : 1;
    }
    return strcmp(p->text, q->text);
}

void report_print(struct report *report, FILE *out)
{
    const char *file = report->file ? report->file : "?";
    if (report->count) {
        qsort(report->problems, (size_t)report->count, sizeof *report->problems, by_place);
    }
    for (int i = 0; i < report->count; i++) {
        const struct problem *problem = &report->problems[i];
        if (problem->line > 0) {
            fprintf(out, "%s:%d:%d: %s\n", file, problem->line, problem->column, problem->text);
        } else {
            fprintf(out, "%s: %s\n", file, problem->text);
        }
    }
    if (report->dropped) {
        fprintf(out, "%s: and %d more\n", file, report->dropped);
    }
}

char *report_text(struct report *report)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return NULL;
    }
    report_print(report, out);
    if (fclose(out) != 0) {
        free(text);
        return NULL;
    }
    return text;
}
