#include "scrub.h"

#include <ctype.h>
#include <regex.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { WORDS_STEP = 32 };

static const struct {
    const char *pattern, *instead;
} patterns[] = {
    {"([0-9a-fA-F]{2}[:-]){5}[0-9a-fA-F]{2}", "[hardware address]"},
    {"[0-9a-fA-F]{8}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[0-9a-fA-F]{12}", "[unique number]"},
    {"[0-9a-fA-F]{32}", "[unique number]"},
    {"[A-Za-z0-9._%+-]+@[A-Za-z0-9-]+\\.[A-Za-z0-9.-]*[A-Za-z0-9]", "[e-mail address]"},
    {"([0-9]{1,3}\\.){3}[0-9]{1,3}", "[address]"},
    {"([0-9a-fA-F]{1,4}:){3,7}(:|[0-9a-fA-F]{1,4})|[0-9a-fA-F]{0,4}::([0-9a-fA-F]{1,4}:)+[0-9a-fA-F]{1,4}",
     "[address]"},
};

enum { PATTERNS = sizeof patterns / sizeof patterns[0] };

struct scrub {
    struct scrub_word {
        char *text;
        size_t length;
        const char *instead;
    } * words;
    int count, capacity;
    regex_t expressions[PATTERNS];
    int compiled;
};

struct scrub *scrub_create(void)
{
    struct scrub *scrub = calloc(1, sizeof *scrub);
    while (scrub && scrub->compiled < PATTERNS) {
        if (regcomp(&scrub->expressions[scrub->compiled], patterns[scrub->compiled].pattern, REG_EXTENDED) != 0) {
            scrub_destroy(scrub);
            return NULL;
        }
        scrub->compiled++;
    }
    return scrub;
}

void scrub_destroy(struct scrub *scrub)
{
    if (!scrub) {
        return;
    }
    for (int i = 0; i < scrub->compiled; i++) {
        regfree(&scrub->expressions[i]);
    }
    for (int i = 0; i < scrub->count; i++) {
        free(scrub->words[i].text);
    }
    free(scrub->words);
    free(scrub);
}

bool scrub_learn(struct scrub *scrub, const char *word, const char *instead)
{
    bool telling = false;
    while (isspace((unsigned char)*word)) {
        word++;
    }
    size_t length = strlen(word);
    while (length > 0 && isspace((unsigned char)word[length - 1])) {
        length--;
    }
    for (size_t i = 0; i < length; i++) {
        telling = telling || (isalnum((unsigned char)word[i]) && word[i] != '0');
    }
    if (length < 2 || !telling) { /* "0000000" is a serial number of those that have none */
        return true;
    }
    if (scrub->count == scrub->capacity) {
        int capacity = scrub->capacity + WORDS_STEP;
        struct scrub_word *words = realloc(scrub->words, (size_t)capacity * sizeof *words);
        if (!words) {
            return false;
        }
        scrub->words = words;
        scrub->capacity = capacity;
    }
    char *text = strndup(word, length);
    if (text) {
        scrub->words[scrub->count++] = (struct scrub_word){text, length, instead};
    }
    return text;
}

/* Whether a word may begin or end between these two. */
static bool apart(char a, char b)
{
    return !isalnum((unsigned char)a) || !isalnum((unsigned char)b);
}

/* The first word at or after `at` in the text, the longest where several begin; its place in *found. */
static const struct scrub_word *find_word(const struct scrub *scrub, const char *text, const char *at,
                                          const char **found)
{
    for (; *at; at++) {
        const struct scrub_word *best = NULL;
        for (int i = 0; i < scrub->count; i++) {
            const struct scrub_word *word = &scrub->words[i];
            if (strncasecmp(at, word->text, word->length) == 0 && (at == text || apart(at[-1], at[0])) &&
                apart(at[word->length - 1], at[word->length]) && (!best || word->length > best->length)) {
                best = word;
            }
        }
        if (best) {
            *found = at;
            return best;
        }
    }
    return NULL;
}

static char *without_words(const struct scrub *scrub, const char *text)
{
    char *clean = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&clean, &size);
    const char *at = text, *found;
    const struct scrub_word *word;
    if (!out) {
        return NULL;
    }
    while ((word = find_word(scrub, text, at, &found))) {
        fwrite(at, 1, (size_t)(found - at), out);
        fputs(word->instead, out);
        at = found + word->length;
    }
    fputs(at, out);
    return fclose(out) == 0 ? clean : (free(clean), NULL);
}

static char *without_pattern(const regex_t *expression, const char *instead, const char *text)
{
    char *clean = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&clean, &size);
    regmatch_t match;
    if (!out) {
        return NULL;
    }
    while (*text && regexec(expression, text, 1, &match, 0) == 0 && match.rm_eo > match.rm_so) {
        fwrite(text, 1, (size_t)match.rm_so, out);
        fputs(instead, out);
        text += match.rm_eo;
    }
    fputs(text, out);
    return fclose(out) == 0 ? clean : (free(clean), NULL);
}

/* Patterns first: an e-mail address whose first part is a user's name is still one. */
char *scrub_text(const struct scrub *scrub, const char *text)
{
    char *clean = strdup(text);
    for (int i = 0; clean && i < PATTERNS; i++) {
        char *next = without_pattern(&scrub->expressions[i], patterns[i].instead, clean);
        free(clean);
        clean = next;
    }
    char *words = clean ? without_words(scrub, clean) : NULL;
    free(clean);
    return words;
}
