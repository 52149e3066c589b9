#include <string.h>

#include "storm.h"

#include "key_fields.h"

#define KEY_AT(field) offsetof(struct storm_def, field)

const struct key storm_keys[] = {
    CHOICE(kind, bolt_kind_names, BOLT_LIGHTNING,
           "What grows; another brings its own values of all others but the seed."),
    NUMBER(eta, "", 0, 20, 8, "How much growth prefers what stands out: 0 a round lump, 10 almost a line."),
    WHOLE(particles, "", 10, STORM_PARTICLES, 8000, "A bolt is complete with so many."),
    NUMBER(pace, "particles a tick", 0.05, 1000, 45, "How quickly a bolt grows, while the machine can follow."),
    NUMBER(life, "ticks", 0, 3600, 50, "How long a strike glows once it has come; 0: it stays."),
    NUMBER(thickness, "times", 0.1, 10, 1, "Of branches, beside that of their kind."),
    WHOLE(dimensions, "", 2, 3, 2, "Of the space it grows in."),
    NUMBER(turn, "turns a minute", -20, 20, 0, "How quickly it turns, in three dimensions."),
    NUMBER(repel, "", -4, 16, 0.5,
           "Charge of a particle of another bolt, of one of its own: above 0 they keep clear of each other."),
    FLAG(clear, "The painting shows behind it, instead of a ground of its own."),
    WHOLE(seed, "", 0, 2147483647, 1, "Another number, another chance."),
    END,
};

/* What a visit can wait for, and what is apart from `frond bolt`, where one growth has the whole sheet. */
static const struct {
    int particles;
    float pace, turn, repel;
} LIVE[BOLT_KINDS] = {
    [BOLT_LIGHTNING] = {8000, 45, 0, 0.5f}, [BOLT_TESLA] = {6000, 90, 1, 1},         [BOLT_TREE] = {9000, 25, 1, 1},
    [BOLT_LICHEN] = {9000, 20, 0, 1},       [BOLT_CORAL] = {1700, 4, 1, 1},          [BOLT_RIVER] = {9000, 25, 0, 3},
    [BOLT_SNOW] = {6000, 15, 0, 2},         [BOLT_FRACTURE] = {3600, 120, 0, 1},     [BOLT_VESSELS] = {9000, 25, 0, 3},
    [BOLT_CITY] = {5000, 10, 0, 1},         [BOLT_LICHTENBERG] = {16000, 250, 0, 2}, [BOLT_FROST] = {9000, 25, 0, 2},
};

struct storm_def storm_preset(enum bolt_kind kind)
{
    struct storm_def def = {0};
    struct bolt bolt;
    kind = (int)kind >= 0 && kind < BOLT_KINDS ? kind : BOLT_LIGHTNING;
    key_defaults(storm_keys, &def);
    bolt_preset(&bolt, kind, 740, 465);
    def.kind = (int)kind;
    def.eta = kind == BOLT_LIGHTNING ? 8 : bolt.growth.eta; /* from the cloud to the hand it is to be slender */
    def.dimensions = bolt.growth.dimensions;
    def.life = bolt.look.life;
    def.particles = LIVE[kind].particles;
    def.pace = LIVE[kind].pace;
    def.turn = LIVE[kind].turn;
    def.repel = LIVE[kind].repel;
    return def;
}

void storm_take(struct storm_def *def, int key, float value)
{
    if (strcmp(storm_keys[key].name, "kind") == 0) {
        struct storm_def chosen = {0};
        key_take(&storm_keys[key], &chosen, value);
        chosen = (struct storm_def){.kind = chosen.kind, .seed = def->seed};
        *def = storm_preset((enum bolt_kind)chosen.kind);
        def->seed = chosen.seed;
        return;
    }
    key_take(&storm_keys[key], def, value);
}
