#define _GNU_SOURCE /* mkostemp */
#include "soak_chatter.h"

#include <ctype.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool chatter_open(struct chatter *chatter, bool aloud)
{
    char path[] = "/tmp/frond-chatter-XXXXXX";
    *chatter = (struct chatter){.terminal = dup(STDERR_FILENO), .aloud = aloud};
    chatter->file = mkostemp(path, O_APPEND | O_CLOEXEC);
    return chatter->file >= 0 && unlink(path) == 0 && dup2(chatter->file, STDERR_FILENO) >= 0;
}

static void take(struct chatter *chatter, const char *line)
{
    char text[CHATTER_BYTES];
    size_t length = 0;
    for (const char *at = line; *at && length + 1 < sizeof text; at++) {
        bool digit = isdigit((unsigned char)*at) || (*at == '.' && isdigit((unsigned char)at[1]));
        if (!digit || length == 0 || text[length - 1] != '#') {
            text[length++] = digit ? '#' : *at;
        }
    }
    text[length] = '\0';
    chatter->total++;
    chatter->same = strcmp(chatter->last, line) == 0 ? chatter->same + 1 : 1;
    chatter->same_most = chatter->same > chatter->same_most ? chatter->same : chatter->same_most;
    snprintf(chatter->last, sizeof chatter->last, "%s", line);
    if (chatter->aloud) {
        printf("%8.3f %s\n", chatter->now_s, line);
    }
    for (int i = 0; i < chatter->line_count; i++) {
        if (strcmp(chatter->lines[i].text, text) == 0) {
            chatter->lines[i].count++;
            return;
        }
    }
    if (chatter->line_count < CHATTER_LINES) {
        struct chatter_line *free = &chatter->lines[chatter->line_count++];
        memcpy(free->text, text, length + 1);
        free->count = 1;
    } else {
        chatter->lost++;
    }
}

void chatter_listen(struct chatter *chatter, double now_s)
{
    chatter->now_s = now_s;
    char bytes[4096];
    ssize_t got;
    while ((got = pread(chatter->file, bytes, sizeof bytes, (off_t)chatter->offset)) > 0) {
        chatter->offset += got;
        for (ssize_t i = 0; i < got; i++) {
            bool end = bytes[i] == '\n';
            if (!end && chatter->length + 1 < sizeof chatter->rest) {
                chatter->rest[chatter->length++] = bytes[i];
            }
            if (end) {
                chatter->rest[chatter->length] = '\0';
                take(chatter, chatter->rest);
                chatter->length = 0;
            }
        }
    }
    if (chatter->offset > 0 && ftruncate(chatter->file, 0) == 0) { /* it is appended to */
        chatter->offset = 0;
    }
}

void chatter_close(struct chatter *chatter)
{
    fflush(stderr);
    chatter_listen(chatter, chatter->now_s);
    dup2(chatter->terminal, STDERR_FILENO);
    close(chatter->terminal);
    close(chatter->file);
}

int chatter_count(const struct chatter *chatter, const char *part)
{
    int count = 0;
    for (int i = 0; i < chatter->line_count; i++) {
        count += strstr(chatter->lines[i].text, part) ? chatter->lines[i].count : 0;
    }
    return count;
}
