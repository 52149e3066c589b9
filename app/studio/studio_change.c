/* A fresh sheet and another script, for a studio that is at work. */
#include "studio_work.h"

void studio_fresh(struct studio *studio)
{
    pthread_mutex_lock(&studio->lock);
    studio->fresh = true;
    studio->inbox_count = 0; /* what was posted was for the sheet that goes */
    pthread_cond_broadcast(&studio->changed);
    pthread_mutex_unlock(&studio->lock);
}

void studio_change(struct studio *studio, const struct script *script)
{
    pthread_mutex_lock(&studio->lock);
    studio->next_script = script;
    pthread_cond_broadcast(&studio->changed);
    pthread_mutex_unlock(&studio->lock);
}

const struct script *studio_script(struct studio *studio)
{
    pthread_mutex_lock(&studio->lock);
    const struct script *script = studio->script_now ? studio->script_now : studio->def.script;
    pthread_mutex_unlock(&studio->lock);
    return script;
}

static float value_of(const struct coefficients *coefficients, const struct key *key)
{
    const char *at = (const char *)coefficients + key->offset;
    return key->type == KEY_NUMBER ? *(const float *)(const void *)at : (float)*(const int *)(const void *)at;
}

/* The coefficients of the new script where they differ from the old one's; what visitors have turned stays else. */
static void set_coefficients(struct studio *studio, const struct script *old, const struct script *script)
{
    for (const struct key *key = coefficient_keys; key->name; key++) {
        struct action action = action_default(ACTION_SET);
        action.coefficient = (int)(key - coefficient_keys);
        action.value = value_of(&script->coefficients, key);
        if (action.value < value_of(&old->coefficients, key) || action.value > value_of(&old->coefficients, key)) {
            studio_act(studio, &action);
        }
    }
}

static void take_script(struct studio *studio, const struct script *script)
{
    const struct script *old = studio->def.script;
    bool other = old->width != script->width || old->height != script->height || old->margin != script->margin;
    studio->def.script = script;
    studio->next_action = 0;
    if (other) {
        studio_change_scale(studio, studio->report.scale);
    }
    set_coefficients(studio, old, script);
}

bool studio_take_orders(struct studio *studio)
{
    pthread_mutex_lock(&studio->lock);
    const struct script *script = studio->next_script;
    bool fresh = studio->fresh;
    studio->next_script = NULL;
    studio->fresh = false;
    pthread_mutex_unlock(&studio->lock);
    if (script) {
        take_script(studio, script);
    }
    bool good = !fresh || studio_begin_session(studio);
    pthread_mutex_lock(&studio->lock);
    studio->script_now = studio->def.script;
    pthread_mutex_unlock(&studio->lock);
    return good;
}
