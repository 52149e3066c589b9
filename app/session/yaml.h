/* A YAML text as a tree in which every node knows its place. Parsed by libfyaml, event by event; anchors, aliases, tags
 * and merge keys are refused, so that the tree is never larger than its text. */
#ifndef FROND_YAML_H
#define FROND_YAML_H

#include <stdbool.h>
#include <stddef.h>

#include "report.h"

enum {
    YAML_SIZE_MAX = 1 << 20, /* bytes of a file */
    YAML_DEPTH_MAX = 16,     /* lists and mappings inside each other */
};

enum yaml_kind {
    YAML_SCALAR,
    YAML_LIST,
    YAML_MAPPING,
    YAML_REFUSED, /* already in the report: readers pass over it */
};

struct yaml_node {
    enum yaml_kind kind;
    bool plain;             /* a scalar without quotes */
    int line, column;       /* from 1; columns in characters */
    const char *text;       /* of a scalar: UTF-8, no NUL inside; "" for nothing at all */
    int count;              /* of a list: items; of a mapping: pairs */
    struct yaml_node *next; /* the next item; from a key to its value, from a value to the next key */
    struct yaml_node *first, *last;
};

struct yaml;

/* Parses `size` bytes. NULL when memory is short or the text is no YAML; that and all else goes to the report. */
struct yaml *yaml_parse(const char *text, size_t size, struct report *report);
void yaml_destroy(struct yaml *yaml); /* takes NULL */

/* NULL for a text without content. */
const struct yaml_node *yaml_root(const struct yaml *yaml);
/* Whether a scalar is nothing: empty, ~ or null, without quotes. */
bool yaml_is_nothing(const struct yaml_node *node);
/* The value of a key of a mapping, or NULL. The first one, if it is there twice. */
const struct yaml_node *yaml_get(const struct yaml_node *mapping, const char *key);
/* What a node is, for messages: "a list", "a mapping", "nothing", or the scalar itself in quotes, shortened. */
const char *yaml_found(const struct yaml_node *node, char *buffer, size_t size);

#endif
