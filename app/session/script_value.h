/* One value of a script against its struct key: type, range, and what to say when it does not fit. */
#ifndef FROND_SCRIPT_VALUE_H
#define FROND_SCRIPT_VALUE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "key.h"
#include "script.h"
#include "yaml.h"

enum { NAMES_MAX = 128 };

/* Names to choose from, for suggestions and lists. */
struct names {
    const char *names[NAMES_MAX];
    int count;
};

struct names names_of_keys(const struct key *keys);
struct names names_of_choices(const char *const *choices);
struct names names_of_verbs(void);
struct names names_of_brushes(void);
struct names names_of_inks(void);
struct names names_of_palettes(void);
/* The index of a name, or -1. */
int names_find(const struct names *names, const char *name);
/* "one of a, b, c", led by "did you mean a? " where a name is near. */
const char *names_allowed(const struct names *names, const char *misspelt, char *buffer, size_t size);

struct script_memory {
    struct script_memory *next;
    void *block;
};

/* What reading a script carries along. */
struct reader {
    struct report *report;
    struct script *script;
    const struct script_def *def;
    const char *folder;
    const char *whose;          /* inks: "session's" where it is NULL, for messages */
    size_t raster_values;       /* taken so far */
    int64_t spent;              /* of def->work_max, where it is not def->spent that counts */
    struct script_grown *grown; /* sessions that have been grown (script_session.c) */
    char path[256];             /* "actions[0].drop.radius" */
};

/* Goes down to a named or numbered part; reader_leave takes back the length from before. */
size_t reader_enter(struct reader *reader, const char *name);
size_t reader_enter_index(struct reader *reader, int index);
void reader_leave(struct reader *reader, size_t length);
/* A problem with the part where the reader is. */
void reader_problem(struct reader *reader, const struct yaml_node *at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/* A file that the script names is about to be read: def->names is told. */
void reader_names(const struct reader *reader, const char *path);
/* Memory that lives as long as the script; NULL is reported. */
void *reader_take(struct reader *reader, size_t size);
/* Takes over a block from malloc, for as long. False is reported; the block is free then. */
bool reader_adopt(struct reader *reader, void *block);

/* Whether a row is a list or a mapping with a reader of its own: one with the unit "section". */
bool key_is_section(const struct key *key);
/* "what was found; allowed" of a node of the wrong kind. Nothing for one that is refused already. */
void value_wrong_kind(struct reader *reader, const struct yaml_node *node, const char *allowed);

/* Reads `node` into the field of `key` in `object`. Problems go to the report; the field then keeps its default. */
bool value_read(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object);
bool value_number(struct reader *reader, const struct key *key, const struct yaml_node *node, double *number);
bool value_choice(struct reader *reader, const struct names *names, const char *what, const struct yaml_node *node,
                  int *choice);
/* The range of a key as people read it: "0.5 to 512 cells". */
const char *value_allowed(const struct key *key, char *buffer, size_t size);

/* Reads one value of a mapping; `context` is the caller's. */
struct value_reading {
    bool (*read)(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                 void *context);
    void *context;
};
/* Reads a mapping into `object`: every key at most once, none unknown, none required missing. Returns the keys that
 * were given, a bit for each row of the table. `reading` NULL: value_read. */
uint64_t mapping_read(struct reader *reader, const struct key *keys, const struct yaml_node *node, void *object,
                      const struct value_reading *reading);

#endif
