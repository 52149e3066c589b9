#include "yaml.h"

#include <stdlib.h>
#include <string.h>

#include <libfyaml.h>

enum { BLOCK_SIZE = 1 << 16 };

struct block {
    struct block *next;
    size_t used, size;
    max_align_t bytes[];
};

struct yaml {
    struct block *blocks;
    struct yaml_node *root;
};

struct building {
    struct yaml *yaml;
    struct report *report;
    struct yaml_node *open[YAML_DEPTH_MAX];
    int depth;
    int line, column; /* of the last token that had a place */
    int documents;
    bool failed;
};

static void *take(struct yaml *yaml, size_t size)
{
    size = (size + sizeof(max_align_t) - 1) / sizeof(max_align_t) * sizeof(max_align_t);
    struct block *block = yaml->blocks;
    if (!block || block->size - block->used < size) {
        size_t room = size > BLOCK_SIZE ? size : BLOCK_SIZE;
        block = malloc(sizeof *block + room);
        if (!block) {
            return NULL;
        }
        *block = (struct block){.next = yaml->blocks, .size = room};
        yaml->blocks = block;
    }
    char *at = (char *)block->bytes + block->used;
    block->used += size;
    return at;
}

void yaml_destroy(struct yaml *yaml)
{
    if (!yaml) {
        return;
    }
    while (yaml->blocks) {
        struct block *next = yaml->blocks->next;
        free(yaml->blocks);
        yaml->blocks = next;
    }
    free(yaml);
}

const struct yaml_node *yaml_root(const struct yaml *yaml)
{
    return yaml->root;
}

bool yaml_is_nothing(const struct yaml_node *node)
{
    return node->kind == YAML_SCALAR && node->plain &&
           (!*node->text || strcmp(node->text, "~") == 0 || strcmp(node->text, "null") == 0);
}

const struct yaml_node *yaml_get(const struct yaml_node *mapping, const char *key)
{
    for (const struct yaml_node *k = mapping->first; k && k->next; k = k->next->next) {
        if (k->kind == YAML_SCALAR && strcmp(k->text, key) == 0) {
            return k->next;
        }
    }
    return NULL;
}

const char *yaml_found(const struct yaml_node *node, char *buffer, size_t size)
{
    enum { SHOWN = 40 };
    if (node->kind == YAML_LIST) {
        return "a list";
    }
    if (node->kind == YAML_MAPPING) {
        return "a mapping";
    }
    if (yaml_is_nothing(node)) {
        return "nothing";
    }
    int length = (int)strnlen(node->text, SHOWN + 1);
    if (length > SHOWN) {
        length = SHOWN;
        while (((unsigned char)node->text[length] & 0xc0) == 0x80) {
            length--; /* never cut a character in two */
        }
        snprintf(buffer, size, "'%.*s...'", length, node->text);
    } else {
        snprintf(buffer, size, "'%s'", node->text);
    }
    return buffer;
}

/* The length of the UTF-8 character at `text` (RFC 3629), or 0. */
static size_t character(const unsigned char *text, size_t left)
{
    size_t length = text[0] < 0x80 ? 1 : text[0] >= 0xc2 && text[0] < 0xe0 ? 2 : (text[0] & 0xf0) == 0xe0 ? 3 : 0;
    if (text[0] >= 0xf0 && text[0] < 0xf5) {
        length = 4;
    }
    if (length == 0 || length > left) {
        return 0;
    }
    for (size_t i = 1; i < length; i++) {
        if ((text[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    bool overlong = (text[0] == 0xe0 && text[1] < 0xa0) || (text[0] == 0xf0 && text[1] < 0x90);
    bool beyond = (text[0] == 0xed && text[1] >= 0xa0) || (text[0] == 0xf4 && text[1] >= 0x90);
    return overlong || beyond ? 0 : length;
}

/* libfyaml takes a byte that is no text for the end of the file, so those are looked for first. */
static bool is_text(const char *text, size_t size, struct report *report)
{
    const unsigned char *at = (const unsigned char *)text;
    int line = 1, column = 1;
    for (size_t i = 0; i < size;) {
        size_t length = character(at + i, size - i);
        bool control = at[i] == 0x7f || (at[i] < 0x20 && at[i] != '\t' && at[i] != '\n' && at[i] != '\r');
        if (length == 0 || control) {
            report_add(report, line, column, "", "byte 0x%02x is not text; a script is UTF-8 text", at[i]);
            return false;
        }
        column++;
        if (at[i] == '\n') {
            line++;
            column = 1;
        }
        i += length;
    }
    return true;
}

static void locate(struct building *building, struct fy_token *token)
{
    const struct fy_mark *mark = token ? fy_token_start_mark(token) : NULL;
    if (mark) {
        enum fy_scalar_style style = fy_token_scalar_style(token);
        bool quoted = style == FYSS_SINGLE_QUOTED || style == FYSS_DOUBLE_QUOTED;
        building->line = mark->line + 1;
        building->column = mark->column + 1 - (quoted && mark->column > 0); /* the mark stands behind the quote */
    }
}

static bool expects_key(const struct building *building)
{
    const struct yaml_node *parent = building->depth ? building->open[building->depth - 1] : NULL;
    if (!parent || parent->kind != YAML_MAPPING) {
        return false;
    }
    return parent->count % 2 == 0; /* while it is open, `count` counts keys and values alike */
}

static struct yaml_node *add(struct building *building, enum yaml_kind kind, struct fy_token *token)
{
    bool key = expects_key(building);
    struct yaml_node *node = take(building->yaml, sizeof *node);
    if (!node) {
        report_add(building->report, 0, 0, "", "memory is short");
        building->failed = true;
        return NULL;
    }
    locate(building, token);
    *node = (struct yaml_node){.kind = kind, .line = building->line, .column = building->column, .text = ""};
    if (key && (kind == YAML_LIST || kind == YAML_MAPPING)) {
        report_add(building->report, node->line, node->column, "", "a %s for a key; a key is a word",
                   kind == YAML_LIST ? "list" : "mapping");
    }
    if (building->depth) {
        struct yaml_node *parent = building->open[building->depth - 1];
        *(parent->last ? &parent->last->next : &parent->first) = node;
        parent->last = node;
        parent->count++;
    } else {
        building->yaml->root = node;
    }
    return node;
}

static void refuse(struct building *building, struct fy_token *token, const char *what)
{
    if (token) {
        locate(building, token);
        report_add(building->report, building->line, building->column, "", "%s; write the value out", what);
    }
}

static void open_collection(struct building *building, enum yaml_kind kind, struct fy_token *token)
{
    struct yaml_node *node = add(building, kind, token);
    if (node && building->depth == YAML_DEPTH_MAX) {
        report_add(building->report, node->line, node->column, "", "nested too deep; at most %d deep", YAML_DEPTH_MAX);
        building->failed = true;
    } else if (node) {
        building->open[building->depth++] = node;
    }
}

static void close_collection(struct building *building)
{
    struct yaml_node *node = building->open[--building->depth];
    if (node->kind == YAML_MAPPING) {
        node->count /= 2;
    }
}

static void add_scalar(struct building *building, const struct fy_event_scalar_data *scalar)
{
    bool key = expects_key(building);
    refuse(building, scalar->anchor, "an anchor");
    refuse(building, scalar->tag, "a tag");
    size_t length = 0;
    const char *text = scalar->value ? fy_token_get_text(scalar->value, &length) : "";
    bool plain = !scalar->value || fy_token_scalar_style(scalar->value) == FYSS_PLAIN;
    /* Nothing has a place in some versions of libfyaml and none in others: it stands where its key does. */
    struct yaml_node *node = add(building, YAML_SCALAR, plain && length == 0 ? NULL : scalar->value);
    char *copy = node ? take(building->yaml, length + 1) : NULL;
    if (!copy || !text) {
        building->failed = true;
        return;
    }
    memcpy(copy, text, length);
    copy[length] = '\0';
    node->text = copy;
    node->plain = plain;
    if (memchr(copy, '\0', length)) {
        report_add(building->report, node->line, node->column, "", "a NUL character; a script is UTF-8 text");
        node->kind = YAML_REFUSED;
    } else if (key && node->plain && strcmp(copy, "<<") == 0) {
        report_add(building->report, node->line, node->column, "", "a merge key; write the keys out");
        node->kind = YAML_REFUSED;
    }
}

static void take_event(struct building *building, const struct fy_event *event)
{
    switch (event->type) {
    case FYET_DOCUMENT_START:
        if (building->documents++) {
            locate(building, event->document_start.document_start);
            report_add(building->report, building->line, building->column, "", "a second document; a file holds one");
            building->failed = true;
        }
        break;
    case FYET_ALIAS:
        refuse(building, event->alias.anchor, "an alias");
        add(building, YAML_REFUSED, event->alias.anchor);
        break;
    case FYET_SCALAR:
        add_scalar(building, &event->scalar);
        break;
    case FYET_SEQUENCE_START:
        refuse(building, event->sequence_start.anchor, "an anchor");
        refuse(building, event->sequence_start.tag, "a tag");
        open_collection(building, YAML_LIST, event->sequence_start.sequence_start);
        break;
    case FYET_MAPPING_START:
        refuse(building, event->mapping_start.anchor, "an anchor");
        refuse(building, event->mapping_start.tag, "a tag");
        open_collection(building, YAML_MAPPING, event->mapping_start.mapping_start);
        break;
    case FYET_SEQUENCE_END:
    case FYET_MAPPING_END:
        close_collection(building);
        break;
    default:
        break;
    }
}

/* What libfyaml had to say about the syntax. */
static void report_syntax(struct fy_diag *diag, struct report *report)
{
    int before = report->count;
    void *iterator = NULL;
    for (struct fy_diag_error *error; (error = fy_diag_errors_iterate(diag, &iterator));) {
        if (error->type == FYET_ERROR) {
            report_add(report, error->line, error->column, "", "%s", error->msg);
        }
    }
    if (report->count == before) {
        report_add(report, 1, 1, "", "this is not YAML");
    }
}

static bool build(struct building *building, const char *text, size_t size)
{
    struct fy_diag_cfg diag_cfg;
    fy_diag_cfg_default(&diag_cfg);
    diag_cfg.fp = NULL;
    diag_cfg.colorize = false;
    struct fy_diag *diag = fy_diag_create(&diag_cfg);
    if (!diag) {
        return false;
    }
    fy_diag_set_collect_errors(diag, true);
    struct fy_parse_cfg cfg = {.flags = FYPCF_QUIET | FYPCF_COLLECT_DIAG | FYPCF_DEFAULT_VERSION_1_2 | FYPCF_JSON_NONE |
                                        FYPCF_DISABLE_MMAP_OPT,
                               .diag = diag};
    struct fy_parser *parser = fy_parser_create(&cfg);
    bool done = false;
    if (parser && fy_parser_set_string(parser, text, size) == 0) {
        while (!building->failed && !done) {
            struct fy_event *event = fy_parser_parse(parser);
            if (event) {
                take_event(building, event);
                done = event->type == FYET_STREAM_END;
                fy_parser_event_free(parser, event);
            } else {
                report_syntax(diag, building->report);
                building->failed = true;
            }
        }
    }
    fy_parser_destroy(parser);
    fy_diag_destroy(diag);
    return done;
}

struct yaml *yaml_parse(const char *text, size_t size, struct report *report)
{
    if (size > YAML_SIZE_MAX) {
        report_add(report, 0, 0, "", "the file is larger than 1 MiB; a script is at most 1 MiB");
        return NULL;
    }
    if (!is_text(text, size, report)) {
        return NULL;
    }
    struct building building = {.yaml = calloc(1, sizeof *building.yaml), .report = report, .line = 1, .column = 1};
    if (!building.yaml || !build(&building, text, size)) {
        if (report_empty(report)) {
            report_add(report, 0, 0, "", "memory is short");
        }
        yaml_destroy(building.yaml);
        return NULL;
    }
    return building.yaml;
}
