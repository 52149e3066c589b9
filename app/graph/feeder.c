#include "feeder.h"

#include <stdlib.h>
#include <string.h>

#include "feed_action.h"
#include "garden.h"
#include "raster.h"
#include "scene_options.h"

struct feeder {
    struct feeder_def def;
    struct kept {
        int scene, tick;
        struct outcome outcome;
    } kept[EXHIBIT_SCENES * EXHIBIT_FEEDS]; /* one for each input at most */
    int count;
};

struct feeder *feeder_create(const struct feeder_def *def)
{
    struct feeder *feeder = calloc(1, sizeof *feeder);
    if (feeder) {
        feeder->def = *def;
    }
    return feeder;
}

void feeder_destroy(struct feeder *feeder)
{
    for (int i = 0; feeder && i < feeder->count; i++) {
        outcome_finish(&feeder->kept[i].outcome);
    }
    free(feeder);
}

void feeder_close(struct feeder_session *session)
{
    for (int i = 0; i < session->raster_count; i++) {
        free(session->rasters[i]);
    }
    session->raster_count = 0;
}

static bool add(struct feeder_session *session, const struct action *action)
{
    if (session->script.action_count >= FEEDER_ACTIONS) {
        return false;
    }
    struct action *place = &session->actions[session->script.action_count++];
    *place = *action;
    place->tick = 0;
    return true;
}

static void add_options(const struct exhibit_scene *scene, struct feeder_session *session)
{
    struct action actions[SCENE_OPTIONS_ACTIONS];
    int count = scene_options_actions(&scene->options, actions);
    for (int i = 0; i < count && scene->kind != SCENE_PAINTING; i++) {
        add(session, &actions[i]);
    }
}

/* What is grown over first: the scene's own picture, else the first of the folder; none where another scene gives it.
 */
static bool add_stock(const struct feeder *feeder, const struct exhibit_scene *scene, struct feeder_session *session,
                      struct file_error *error)
{
    const struct exhibit *exhibit = feeder->def.exhibit;
    bool fed = scene->kind != SCENE_TREES;
    for (int i = 0; i < scene->feed_count; i++) {
        fed = fed || scene->feeds[i].as == PORT_PICTURE;
    }
    if (fed) {
        return true;
    }
    struct exhibit_pictures pictures = exhibit_pictures(exhibit);
    const char *path = scene->picture ? scene->picture : pictures.count > 0 ? pictures.paths[0] : "";
    struct script_picture picture = {0};
    const struct script_def *load = &feeder->def.load;
    bool good = load->load && load->load(load->data, exhibit->folder, path, &picture, error);
    if (!load->load) {
        file_fail(error, path, "pictures cannot be read here");
    }
    if (good) {
        struct action action = action_default(ACTION_STOCK);
        int longer = picture.width > picture.height ? picture.width : picture.height;
        int side = longer < GARDEN_STOCK_SIDE ? longer : GARDEN_STOCK_SIDE;
        int width = (int)((int64_t)picture.width * side / longer),
            height = (int)((int64_t)picture.height * side / longer);
        width = width > 0 ? width : 1;
        height = height > 0 ? height : 1;
        float *values = malloc((size_t)width * (size_t)height * sizeof *values);
        good = (values && raster_from_picture(&picture, RASTER_BRIGHTNESS, width, height, values)) ||
               file_fail(error, path, "memory is short");
        session->rasters[session->raster_count++] = values;
        action.picture = (struct action_raster){values, width, height, 1};
        add(session, &action);
    }
    free(picture.values);
    exhibit_pictures_finish(&pictures);
    return good;
}

static bool add_feeds(struct feeder *feeder, const struct exhibit_scene *scene, struct feeder_session *session,
                      struct file_error *error)
{
    bool good = true;
    for (int i = 0; i < scene->feed_count && good; i++) {
        const struct exhibit_feed *feed = &scene->feeds[i];
        const struct outcome *from = feeder_outcome(feeder, feed->from, feed->tick, error);
        struct action action;
        good = from && (feed_action(feed, scene, from, &action, &session->rasters[session->raster_count]) ||
                        file_fail(error, scene->id, "memory is short"));
        if (good) {
            session->raster_count++;
            add(session, &action);
        }
    }
    return good;
}

bool feeder_open(struct feeder *feeder, int scene, int ticks, struct feeder_session *session, struct file_error *error)
{
    const struct exhibit_scene *of = &feeder->def.exhibit->scenes[scene];
    *session = (struct feeder_session){.script = *of->script};
    session->script.ticks = ticks;
    session->script.actions = session->actions;
    session->script.action_count = 0;
    add_options(of, session);
    bool good = add_stock(feeder, of, session, error);
    for (int i = 0; i < of->opening && good; i++) {
        add(session, &of->ground[i]);
    }
    good = good && add_feeds(feeder, of, session, error);
    for (int i = of->opening; i < of->ground_count && good; i++) {
        add(session, &of->ground[i]);
    }
    return good;
}

/* A graph without cycles: whatever a scene needs is grown on the way to it. */
const struct outcome *feeder_outcome(struct feeder *feeder, int scene, int tick, struct file_error *error)
{
    for (int i = 0; i < feeder->count; i++) {
        if (feeder->kept[i].scene == scene && feeder->kept[i].tick == tick) {
            return &feeder->kept[i].outcome;
        }
    }
    struct feeder_session *session = calloc(1, sizeof *session);
    struct outcome outcome = {.width = 0};
    if (!session) {
        file_fail(error, "the scene", "memory is short");
        return NULL;
    }
    bool good = feeder_open(feeder, scene, tick, session, error) &&
                outcome_grow(&outcome, &session->script, tick, feeder->def.threads, feeder->def.stop, error);
    feeder_close(session);
    free(session);
    if (!good) {
        return NULL;
    }
    struct kept *kept = &feeder->kept[feeder->count++];
    *kept = (struct kept){scene, tick, outcome};
    return &kept->outcome;
}
