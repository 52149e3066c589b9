#include "render.h"

#include <stdio.h>
#include <stdlib.h>

#include "image.h"
#include "journal.h"
#include "running.h"
#include "script_sheet.h"
#include "stats.h"

/* Everything a session needs while it runs. */
struct rendering {
    const struct script *script;
    const struct render_def *def;
    struct running running;
    struct easel_picture picture;
    struct journal_writer journal;
    size_t cells;
};

struct render_def render_default_def(void)
{
    return (struct render_def){.every = RENDER_EVERY, .engine = ENGINE_CPU};
}

static bool open_picture(struct rendering *rendering, struct file_error *error)
{
    const struct script *script = rendering->script;
    const struct render_def *def = rendering->def;
    if (!def->picture && !def->frames) {
        return true;
    }
    struct picture_def picture =
        script_picture(script, def->width ? def->width : script->width, def->height ? def->height : script->height);
    return easel_frame(&rendering->running.easel, &rendering->picture, &picture, script->ink_count) ||
           file_fail(error, "the painting", "memory is short for %dx%d cells and %dx%d pixels", script->width,
                     script->height, picture.width, picture.height);
}

/* What is written: the painting's fields, then those of what grows over it. */
struct channels {
    const char *names[IMAGE_CHANNELS_MAX];
    const float *planes[IMAGE_CHANNELS_MAX];
    char own[IMAGE_CHANNELS_MAX][PLOT_CHANNEL_NAME];
    int count;
};

static bool fill_channels(struct rendering *rendering, struct channels *channels, float *values)
{
    const struct script *script = rendering->script;
    bool good = true;
    for (int i = 0; i < channels->count && good; i++) {
        float *at = values + (size_t)i * rendering->cells;
        if (i < PAINTING_FIELDS) {
            rendering->running.engine->ops->read(rendering->running.engine, (enum painting_field)i, at);
            channels->names[i] = painting_field_name((enum painting_field)i);
        } else {
            plot_channel_name(rendering->running.plot, i - PAINTING_FIELDS, channels->own[i]);
            channels->names[i] = channels->own[i];
            good = plot_channel(rendering->running.plot, i - PAINTING_FIELDS, script->width, script->height, at);
        }
        channels->planes[i] = at;
    }
    return good;
}

static bool write_fields(struct rendering *rendering, const char *path, struct file_error *error)
{
    struct channels channels = {.count = PAINTING_FIELDS};
    channels.count += rendering->running.plot ? plot_channels(rendering->running.plot) : 0;
    channels.count = channels.count < IMAGE_CHANNELS_MAX ? channels.count : IMAGE_CHANNELS_MAX;
    float *values = malloc((size_t)channels.count * rendering->cells * sizeof *values);
    bool good = values && fill_channels(rendering, &channels, values);
    struct image_def def = image_default_def();
    def.megabytes = 4096; /* our own planes, not a stranger's file */
    good = good ? image_write_exr(path, channels.names, channels.planes, channels.count, rendering->script->width,
                                  rendering->script->height, &def, error)
                : file_fail(error, path, "memory is short for the fields");
    free(values);
    return good;
}

static struct easel_scene scene_of(const struct rendering *rendering)
{
    return (struct easel_scene){rendering->running.engine, rendering->running.plot,
                                rendering->running.engine->ops->ticks(rendering->running.engine)};
}

static bool write_frame(struct rendering *rendering, struct file_error *error)
{
    const struct render_def *def = rendering->def;
    struct easel_scene scene = scene_of(rendering);
    return !def->frames || scene.ticked % def->every != 0 ||
           easel_write_frame(&rendering->picture, &scene, def->frames, error);
}

static void begin_journal(struct rendering *rendering)
{
    struct journal_head head = {.exhibit_hash = 0};
    struct painting_def def = script_painting(rendering->script);
    struct journal_sheet sheet = journal_sheet_of(rendering->script, &def);
    snprintf(head.version, sizeof head.version, "%s", FROND_VERSION);
    snprintf(head.engine, sizeof head.engine, "%s", rendering->running.engine->ops->name);
    journal_begin(&rendering->journal, &head);
    journal_sheet(&rendering->journal, 0, &sheet);
}

static bool write_journal(struct rendering *rendering, const char *path, struct file_error *error)
{
    const struct bytes *out = &rendering->journal.out;
    journal_end(&rendering->journal, rendering->script->ticks);
    return out->failed ? file_fail(error, path, "memory is short for the journal")
                       : file_write_atomic(path, out->data, out->size, error);
}

static void keep_action(void *data, int64_t tick, const struct action *action)
{
    struct rendering *rendering = data;
    if (rendering->def->journal) {
        journal_action(&rendering->journal, tick, action);
    }
}

/* The actions of a tick, then the tick; those of the very last tick too, so that a session can end with one. */
static bool run_session(struct rendering *rendering, struct progress *progress, struct file_error *error)
{
    const struct script *script = rendering->script;
    bool good = true;
    if (rendering->def->journal) {
        begin_journal(rendering);
    }
    for (int64_t tick = 0; good && tick <= script->ticks; tick++) {
        running_act(&rendering->running, tick, keep_action, rendering);
        good = running_plot(&rendering->running, tick, error);
        if (good && tick < script->ticks) {
            running_tick(&rendering->running);
            good = write_frame(rendering, error);
        }
        if (progress) {
            progress_step(progress, tick, script->ticks);
        }
    }
    return good;
}

static bool write_end(struct rendering *rendering, struct file_error *error)
{
    const struct render_def *def = rendering->def;
    struct easel_scene scene = scene_of(rendering);
    return (!def->journal || write_journal(rendering, def->journal, error)) &&
           (!def->fields || write_fields(rendering, def->fields, error)) &&
           (!def->stats ||
            stats_write(def->stats, rendering->script, rendering->running.engine, rendering->running.plot, error)) &&
           (!def->svg || easel_write_plan(rendering->running.engine, def->paper_mm, def->svg, error)) &&
           (!def->picture || easel_write(&rendering->picture, &scene, def->picture, error));
}

bool render(const struct script *script, const struct render_def *def, struct progress *progress,
            struct file_error *error)
{
    struct rendering rendering = {.script = script, .def = def};
    rendering.cells = (size_t)script->width * (size_t)script->height;
    struct easel_def easel = {def->engine, def->shaders, def->threads, def->dense};
    if (!easel_check_file(def->picture, error) || !easel_check_file(def->fields, error) ||
        !easel_check_file(def->stats, error) || !easel_check_file(def->journal, error) ||
        !easel_check_file(def->svg, error) || (def->frames && !file_make_folder(def->frames, error))) {
        return false;
    }
    bool good = running_open(&rendering.running, script, &easel, error) && open_picture(&rendering, error) &&
                run_session(&rendering, progress, error) && write_end(&rendering, error);
    if (progress) {
        progress_end(progress);
    }
    journal_finish(&rendering.journal);
    easel_unframe(&rendering.picture);
    running_close(&rendering.running);
    return good;
}
