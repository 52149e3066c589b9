#include "busy.h"

static struct action drop_at(float x, float y, int ink)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){x, y};
    drop.ink = ink;
    return drop;
}

struct painting_def busy_def(void)
{
    struct painting_def def = painting_default_def();
    def.width = 203; /* no multiple of a vector or a tile */
    def.height = 117;
    def.margin = 9;
    def.threads = 1;
    return def;
}

void busy_init(struct busy *busy)
{
    for (int y = 0; y < 64; y++) {
        for (int x = 0; x < 64; x++) {
            busy->wall[y * 64 + x] = x > 50 && y > 30 ? 1.0f : 0.0f;
            busy->wave[y * 64 + x] = 0.5f;
            busy->wave[64 * 64 + y * 64 + x] = (float)(x % 16) / 8.0f - 1.0f;
        }
    }
}

void busy_act(const struct busy *busy, int tick, void (*apply)(void *context, const struct action *), void *context)
{
    static const struct point STROKE[] = {{0.2f, 0.3f}, {0.5f, 0.55f}, {0.8f, 0.4f}};
    struct action act;
    switch (tick) {
    case 0:
        act = drop_at(0.35f, 0.4f, 0);
        act.brush = 1;
        act.edge = EDGE_RAGGED;
        apply(context, &act);
        act = drop_at(0.7f, 0.35f, 1);
        act.edge = EDGE_SOFT;
        break;
    case 20:
        act = action_default(ACTION_MASK);
        act.formula = (struct action_raster){busy->wall, 64, 64, 1};
        break;
    case 40:
        act = action_default(ACTION_GUIDE);
        act.formula = (struct action_raster){busy->wave, 64, 64, 2};
        break;
    case 60:
    case 100:
    case 140:
        act = action_default(tick == 60 ? ACTION_BRUSH_SOLVENT : tick == 100 ? ACTION_BRUSH_INK : ACTION_DRAW);
        act.path = (struct action_path){STROKE, 3};
        act.ink = 2;
        break;
    case 180:
        act = drop_at(0.5f, 0.9f, 3);
        act.brush = 3;
        act.amount = 120;
        break;
    case 220:
        act = action_default(ACTION_POUR);
        act.at = (struct point){0.4f, 0.4f};
        act.radius = 20;
        act.has_at = true;
        break;
    case 260:
        act = action_default(ACTION_SET);
        act.coefficient = (int)(key_find(coefficient_keys, "flood") - coefficient_keys);
        act.value = 0.5f;
        apply(context, &act);
        act = action_default(ACTION_SET);
        act.coefficient = (int)(key_find(coefficient_keys, "alpha_a") - coefficient_keys);
        act.value = 0.3f;
        act.vary = 0.4f;
        break;
    case 300:
        act = action_default(ACTION_DRY);
        act.amount = 0.5f;
        apply(context, &act);
        act = action_default(ACTION_UNMASK);
        break;
    case 340:
        act = action_default(ACTION_WET);
        act.solvent = 2;
        apply(context, &act);
        act = action_default(ACTION_SET);
        act.coefficient = (int)(key_find(coefficient_keys, "k") - coefficient_keys);
        act.value = 2.3f;
        break;
    default:
        return;
    }
    apply(context, &act);
}
