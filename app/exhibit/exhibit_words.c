/* Languages, and everything that is written in them. */
#include <string.h>

#include "exhibit_read.h"

static struct names names_of_languages(void)
{
    struct names names = {.count = 0};
    for (int i = 0; i < WORDS_LANGUAGES && words_languages[i].tag; i++) {
        names.names[names.count++] = words_languages[i].tag;
    }
    return names;
}

static struct names names_of_own(const struct exhibit *exhibit)
{
    struct names names = {.count = 0};
    for (int i = 0; i < exhibit->language_count; i++) {
        names.names[names.count++] = words_languages[exhibit->languages[i]].tag;
    }
    return names;
}

static void read_language(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit *exhibit = context;
    struct names all = names_of_languages(), own = names_of_own(exhibit);
    int language = 0;
    (void)index;
    if (!value_choice(reader, &all, "language", item, &language)) {
        return;
    }
    if (names_find(&own, item->text) >= 0) {
        reader_problem(reader, item, "'%s' is there already; each language once", item->text);
        return;
    }
    exhibit->languages[exhibit->language_count++] = language;
}

void exhibit_read_languages(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    inputs_list(reader, root, "languages", WORDS_LANGUAGES, "a list of languages: [en, fr]", read_language, exhibit);
    if (exhibit->language_count == 0) {
        exhibit->language_count = 1; /* English */
    }
}

/* One language of a text. */
static void read_word(struct reader *reader, const struct yaml_node *tag, const struct exhibit *exhibit,
                      struct words *words)
{
    static const struct key TEXT = {.name = "", .type = KEY_TEXT, .unit = "text", .min = 1, .max = TEXT_BYTES};
    char allowed[512];
    struct names all = names_of_languages(), own = names_of_own(exhibit);
    int language = words_find(tag->text);
    size_t length = reader_enter(reader, tag->text);
    if (language < 0) {
        reader_problem(reader, tag, "unknown language; %s", names_allowed(&all, tag->text, allowed, sizeof allowed));
    } else if (names_find(&own, tag->text) < 0) {
        reader_problem(reader, tag, "not among the exhibit's languages; %s",
                       names_allowed(&own, tag->text, allowed, sizeof allowed));
    } else if (words->in[language]) {
        reader_problem(reader, tag, "given twice; once is enough");
    } else {
        value_read(reader, &TEXT, tag->next, &words->in[language]);
    }
    reader_leave(reader, length);
}

static void read_mapping(struct reader *reader, const struct yaml_node *node, const struct exhibit *exhibit,
                         struct words *words)
{
    if (node->kind != YAML_MAPPING) {
        value_wrong_kind(reader, node, "a text by language: {en: TEXT, fr: TEXT}");
        return;
    }
    for (const struct yaml_node *tag = node->first; tag && tag->next; tag = tag->next->next) {
        if (tag->kind == YAML_SCALAR) {
            read_word(reader, tag, exhibit, words);
        }
    }
}

void exhibit_read_words(struct reader *reader, const struct yaml_node *root, const char *name,
                        const struct exhibit *exhibit, struct words *words)
{
    const struct yaml_node *node = yaml_get(root, name);
    if (node && !yaml_is_nothing(node)) {
        size_t length = reader_enter(reader, name);
        read_mapping(reader, node, exhibit, words);
        reader_leave(reader, length);
    }
}

/* A countdown that does not count. */
static void check_countdown(struct reader *reader, const struct yaml_node *node, const struct words *words)
{
    for (int i = 0; i < WORDS_LANGUAGES; i++) {
        if (words->in[i] && !strstr(words->in[i], "{seconds}")) {
            exhibit_problem(reader, words_languages[i].tag, yaml_get(node, words_languages[i].tag),
                            "has no {seconds}; a sentence with {seconds} where the number is to stand");
        }
    }
}

static bool read_text(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                      void *context)
{
    struct exhibit *exhibit = context;
    enum exhibit_text text = (enum exhibit_text)(key - text_keys);
    (void)object;
    read_mapping(reader, node, exhibit, &exhibit->texts[text]);
    if (text == TEXT_COUNTDOWN && node->kind == YAML_MAPPING) {
        check_countdown(reader, node, &exhibit->texts[text]);
    }
    return true;
}

void exhibit_read_texts(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    const struct yaml_node *node = yaml_get(root, "texts");
    struct value_reading reading = {read_text, exhibit};
    if (!node || yaml_is_nothing(node)) {
        return;
    }
    size_t length = reader_enter(reader, "texts");
    if (node->kind == YAML_MAPPING) {
        mapping_read(reader, text_keys, node, exhibit, &reading);
    } else {
        value_wrong_kind(reader, node, "texts by their names: {invite: {en: TEXT, fr: TEXT}, ...}");
    }
    reader_leave(reader, length);
}
