/* The section `inputs`: an inputs file of the exhibit's own. */
#include "exhibit_read.h"

/* A binding paints in whatever scene there is: the ink that it names is in all of them. */
static void check_inks(struct reader *reader, const struct yaml_node *node, const struct exhibit *exhibit)
{
    const struct inputs *inputs = exhibit->inputs;
    const struct yaml_node *list = yaml_get(node, "bindings");
    const struct yaml_node *item = list && list->kind == YAML_LIST ? list->first : NULL;
    size_t length = reader_enter(reader, "bindings");
    for (int i = 0; item && i < inputs->binding_count; i++, item = item->next) {
        const struct binding *binding = &inputs->bindings[i];
        const char *verb = binding->what == DO_VERB ? action_name(binding->action.verb) : "";
        const struct yaml_node *parameters = item->kind == YAML_MAPPING ? yaml_get(item, verb) : NULL;
        const struct yaml_node *ink =
            parameters && parameters->kind == YAML_MAPPING ? yaml_get(parameters, "ink") : NULL;
        if (ink && binding->action.ink >= 0) {
            size_t outer = reader_enter_index(reader, i);
            reader_enter(reader, verb);
            reader_enter(reader, "ink");
            exhibit_same_ink(reader, ink, exhibit, binding->action.ink);
            reader_leave(reader, outer);
        }
    }
    reader_leave(reader, length);
}

/* FNV-1a, a value at a time. */
static uint64_t mix(uint64_t mark, int value)
{
    return (mark ^ (uint64_t)(uint32_t)value) * 0x100000001b3;
}

/* Of everything below a node, wherever in the file it stands. */
static uint64_t mark_of(uint64_t mark, const struct yaml_node *node)
{
    mark = mix(mix(mix(mark, (int)node->kind), node->plain), node->count);
    if (node->kind == YAML_SCALAR) {
        for (const char *text = node->text; *text; text++) {
            mark = mix(mark, *text);
        }
        return mark;
    }
    for (const struct yaml_node *child = node->first; child; child = child->next) {
        mark = mark_of(mark, child); /* at most YAML_DEPTH_MAX deep */
    }
    return mark;
}

void exhibit_read_inputs(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    const struct yaml_node *node = yaml_get(root, "inputs");
    int before = reader->report->count + reader->report->dropped;
    if (!node || yaml_is_nothing(node) || exhibit->scene_count == 0) {
        return;
    }
    const struct script *first = exhibit->scenes[0].script;
    size_t length = reader_enter(reader, "inputs");
    if (node->kind == YAML_MAPPING) {
        reader->whose = "first scene's";
        exhibit->inputs = inputs_section(reader, node, first);
        reader->whose = NULL;
        exhibit->inputs_mark = mark_of(0xcbf29ce484222325, node);
        for (int i = 0; i < first->ink_count; i++) {
            exhibit->inputs_mark = mix(exhibit->inputs_mark, first->inks[i]); /* which bindings name */
        }
        if (exhibit->inputs && reader->report->count + reader->report->dropped == before) {
            check_inks(reader, node, exhibit);
        }
    } else {
        value_wrong_kind(reader, node, "a mapping as an inputs file is: {bindings: [...], gpio: {...}, ...}");
    }
    reader_leave(reader, length);
}
