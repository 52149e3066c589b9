#include "live_kiosk.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench.h"
#include "pictures.h"
#include "script_sheet.h"

static const int64_t SPARE_BYTES = INT64_C(64) << 20; /* of the disk, that are left to others */

static uint64_t now_us(const struct live_kiosk *kiosk)
{
    return live_clock_us(&kiosk->clock);
}

static uint64_t real_us(void)
{
    return (uint64_t)(1e6 * bench_wall_s());
}

static void say(struct live_kiosk *kiosk, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void say(struct live_kiosk *kiosk, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(kiosk->line, sizeof kiosk->line, format, arguments);
    va_end(arguments);
    kiosk->level = LOG_LEVEL_INFO;
    kiosk->has_line = true;
}

static bool stage_post(void *context, const struct action *action, uint64_t event_us)
{
    struct live_kiosk *kiosk = context;
    bool planted =
        scene_kind_of(action->verb) != SCENE_PAINTING; /* no fields hold it: how long it takes is not measured */
    bool posted = studio_post_event(kiosk->status.studio, action, planted ? 0 : event_us);
    kiosk->drops += posted && action->verb == ACTION_DROP && action->visitor > 0;
    return posted;
}

static void stage_fresh(void *context)
{
    struct live_kiosk *kiosk = context;
    live_picture_hold(kiosk->picture);
    studio_fresh(kiosk->status.studio);
}

static void stage_change(void *context, const struct script *script)
{
    struct live_kiosk *kiosk = context;
    const struct exhibit_scene *scene = kiosk_scene(kiosk->kiosk);
    live_scene_scene(kiosk->scene, script, (enum scene_kind)scene->kind, scene->id);
    studio_change(kiosk->status.studio, script);
    kiosk->other = true;
    live_keep_scene(kiosk->painting, scene);
    if (kiosk->pictures) {
        live_pictures_scene(kiosk->pictures, scene);
    }
}

static void stage_keep(void *context)
{
    struct live_kiosk *kiosk = context;
    kiosk->keep = kiosk->gallery;
}

static void stage_power(void *context, bool on)
{
    struct live_kiosk *kiosk = context;
    display_power(kiosk->status.display, on);
}

static struct kiosk_sheet stage_sheet(void *context)
{
    struct live_kiosk *kiosk = context;
    struct studio_report report = studio_report(kiosk->status.studio);
    struct live_scene_sheet scene = live_scene_sheet(kiosk->scene, bench_wall_s());
    uint64_t undo = scene.kind != SCENE_PAINTING ? scene.can_undo : report.can_undo;
    uint64_t redo = scene.kind != SCENE_PAINTING ? scene.can_redo : report.can_redo;
    return (struct kiosk_sheet){report.sessions, report.ticks, undo, redo};
}

static bool stage_guide(void *context, struct action *guide)
{
    struct live_kiosk *kiosk = context;
    return kiosk->pictures && live_pictures_next(kiosk->pictures, guide);
}

static bool stage_stock(void *context, bool next, struct action *stock)
{
    struct live_kiosk *kiosk = context;
    return kiosk->pictures && live_pictures_stock(kiosk->pictures, next, stock);
}

static bool stage_inputs(void *context, int scene, struct action *actions, int *count)
{
    struct live_kiosk *kiosk = context;
    return kiosk->graph && live_graph_actions(kiosk->graph, scene, actions, count);
}

/* Its own fields, which will be there in a moment; until then, and of paintings, what is to be seen. */
static void stage_hand(void *context, int scene)
{
    struct live_kiosk *kiosk = context;
    int width, height;
    bool drawn = kiosk->graph && display_enter(kiosk->status.display);
    uint8_t *rgb = drawn ? live_picture_capture(kiosk->picture, &width, &height) : NULL;
    if (kiosk->graph) {
        live_scene_hand(kiosk->scene, (int)(kiosk->reloads % INT16_MAX) * EXHIBIT_SCENES + scene);
    }
    if (rgb) {
        live_scene_draw_reveal(kiosk->scene_draw, rgb, width, height);
        live_graph_hand(kiosk->graph, scene, rgb, width, height);
    }
    free(rgb);
}

static bool stage_cover(void *context, int kind, uint32_t seed, double share)
{
    struct live_kiosk *kiosk = context;
    struct display_size size = display_sheet(kiosk->status.display);
    bool known = size.width > 0 && size.height > 0;
    return live_leave_cover(&kiosk->leave, kind, seed, share, known ? size.width : DISPLAY_HEADLESS_WIDTH,
                            known ? size.height : DISPLAY_HEADLESS_HEIGHT);
}

static void take_hand(struct live_kiosk *kiosk)
{
    struct outcome outcome;
    int number;
    if (kiosk->graph && live_scene_handed(kiosk->scene, &number, &outcome)) {
        if (number / EXHIBIT_SCENES == (int)(kiosk->reloads % INT16_MAX)) {
            live_graph_take(kiosk->graph, number % EXHIBIT_SCENES, &outcome);
        } else { /* of an exhibit that was */
            outcome_finish(&outcome);
        }
    }
}

static void stage_status(void *context, char *lines, size_t size)
{
    struct live_kiosk *kiosk = context;
    live_status(&kiosk->status, lines, size);
}

void live_kiosk_fit(struct exhibit *exhibit, int width, int height)
{
    for (int i = 0; width > 0 && height > 0 && i < exhibit->scene_count; i++) {
        script_fit(exhibit->scenes[i].script, width, height);
        exhibit->scenes[i].script->ticks = SCRIPT_TICKS_MAX; /* it ends by the visit, not by itself */
    }
}

static bool same_gallery(const struct exhibit_gallery *a, const struct exhibit_gallery *b)
{
    return a->pictures == b->pictures && a->megabytes == b->megabytes &&
           (a->folder && b->folder ? strcmp(a->folder, b->folder) == 0 : a->folder == b->folder);
}

static void gallery_path(const struct live_kiosk *kiosk, const struct exhibit *exhibit, char *path, size_t size)
{
    snprintf(path, size, "%s/%s", kiosk->state ? kiosk->state : "",
             exhibit->gallery.folder ? exhibit->gallery.folder : "");
}

/* `before`: what was shown until now, or NULL. The same gallery stays open: to close one waits for what it writes. */
static void open_gallery(struct live_kiosk *kiosk, const struct exhibit *exhibit, const struct exhibit *before)
{
    char folder[1200];
    if (before && same_gallery(&exhibit->gallery, &before->gallery)) {
        return;
    }
    gallery_destroy(kiosk->gallery);
    kiosk->gallery = NULL;
    kiosk->keep = kiosk->slides.asked = false;
    if (kiosk->state && exhibit->gallery.folder) {
        gallery_path(kiosk, exhibit, folder, sizeof folder);
        kiosk->gallery = gallery_create(&(struct gallery_def){.folder = folder,
                                                              .pictures = exhibit->gallery.pictures,
                                                              .bytes = (int64_t)exhibit->gallery.megabytes << 20,
                                                              .spare = SPARE_BYTES});
    }
    kiosk->status.gallery = kiosk->gallery;
}

/* The controls of this exhibit: other devices and bindings, where its inputs are others. */
static bool open_input(struct live_kiosk *kiosk, const struct exhibit *exhibit)
{
    struct live_input_def *def = &kiosk->input_def;
    kiosk_controls(kiosk->kiosk, NULL); /* what is held now will never be told to leave */
    live_input_close(kiosk->input);
    def->inputs = exhibit->inputs;
    def->seats = exhibit->seats;
    def->seat_count = exhibit->seat_count;
    def->kiosk = kiosk->kiosk;
    bool good = live_input_open(kiosk->input, kiosk_scene(kiosk->kiosk)->script, kiosk->status.display, def);
    kiosk_controls(kiosk->kiosk, kiosk->input->controls);
    return good;
}

/* The exhibit's file is wrong, and why. */
static void refuse(struct live_kiosk *kiosk, const char *what, const char *report)
{
    kiosk_trouble(kiosk->kiosk, report);
    say(kiosk, "%s:\n%.1100s", what, report);
    kiosk->level = LOG_LEVEL_WARNING;
    kiosk->errors++;
    kiosk->wrong = true;
}

bool live_kiosk_open(struct live_kiosk *kiosk, const struct live_kiosk_def *def, const struct live_status_def *status,
                     struct live_picture *picture, struct live_input *input, const struct live_input_def *input_def,
                     const struct shader_folder *folder)
{
    struct display_size size = display_sheet(status->display);
    *kiosk = (struct live_kiosk){.status = *status,
                                 .picture = picture,
                                 .input = input,
                                 .state = def->state,
                                 .painting = def->painting,
                                 .scene = def->scene,
                                 .scene_draw = def->scene_draw,
                                 .clock = def->clock};
    kiosk->input_def = *input_def;
    kiosk->input_def.clock = def->clock;
    live_overlay_init(&kiosk->overlay, folder);
    live_leave_init(&kiosk->leave, folder);
    if (!def->exhibit) {
        return true;
    }
    struct kiosk_def kiosk_def = {.exhibit = def->exhibit,
                                  .width = size.width > 0 ? size.width : DISPLAY_HEADLESS_WIDTH,
                                  .height = size.height > 0 ? size.height : DISPLAY_HEADLESS_HEIGHT,
                                  .seed = (uint64_t)live_clock_wall(&def->clock),
                                  .built = FROND_BUILT,
                                  .open = def->open,
                                  .resume = def->painting->scene >= 0,
                                  .scene = def->painting->scene,
                                  .stage = {kiosk, stage_post, stage_fresh, stage_change, stage_keep, stage_power,
                                            stage_sheet, stage_guide, stage_status, stage_stock, stage_inputs,
                                            stage_hand, stage_cover}};
    kiosk->watch = exhibit_watch_create(def->exhibit->path, def->exhibit);
    kiosk->kiosk = kiosk_create(&kiosk_def, now_us(kiosk));
    if (!kiosk->kiosk || !kiosk->watch) {
        return false;
    }
    if (def->trouble) {
        refuse(kiosk, "the exhibit cannot be shown, and another one stands in for it until it can", def->trouble);
    }
    open_gallery(kiosk, kiosk_shows(kiosk->kiosk), kiosk->before);
    live_slides_open(&kiosk->slides);
    struct script_def pictures = script_default_def();
    pictures.load = pictures_load;
    kiosk->pictures = live_pictures_create(kiosk_shows(kiosk->kiosk), kiosk_scene(kiosk->kiosk), &pictures);
    kiosk->graph = live_graph_create(&pictures);
    if (kiosk->graph) {
        live_graph_set(kiosk->graph, kiosk_shows(kiosk->kiosk));
    }
    live_keep_scene(kiosk->painting, kiosk_scene(kiosk->kiosk));
    kiosk->other = true;
    return open_input(kiosk, kiosk_shows(kiosk->kiosk));
}

/* After the studio, which has scripts of the exhibit. */
void live_kiosk_close(struct live_kiosk *kiosk)
{
    live_overlay_finish(&kiosk->overlay);
    live_leave_finish(&kiosk->leave);
    exhibit_watch_destroy(kiosk->watch);
    live_graph_destroy(kiosk->graph); /* before the exhibit */
    kiosk_destroy(kiosk->kiosk);
    exhibit_destroy(kiosk->before);
    live_slides_close(&kiosk->slides);
    live_pictures_destroy(kiosk->pictures);
    gallery_destroy(kiosk->gallery);
    *kiosk = (struct live_kiosk){.kiosk = NULL};
}

static bool same_seat(const struct exhibit_seat *a, const struct exhibit_seat *b)
{
    bool same = a->ink == b->ink && a->side == b->side;
    for (int i = 0; same && i < 4; i++) {
        same = !(a->zone[i] < b->zone[i] || a->zone[i] > b->zone[i]);
    }
    return same;
}

/* Whether what visitors hold may stay in their hands. */
static bool same_hands(const struct exhibit *now, const struct exhibit *next)
{
    bool seats = now->seat_count == next->seat_count;
    for (int i = 0; seats && i < now->seat_count; i++) {
        seats = same_seat(&now->seats[i], &next->seats[i]);
    }
    return seats && now->inputs_mark == next->inputs_mark &&
           now->scenes[0].script->ink_count == next->scenes[0].script->ink_count;
}

/* The exhibit as its file is now. The painting goes on. */
static void take_up(struct live_kiosk *kiosk, struct exhibit *exhibit)
{
    struct display_size size = display_sheet(kiosk->status.display);
    live_kiosk_fit(exhibit, size.width, size.height);
    kiosk_trouble(kiosk->kiosk, NULL);
    bool same = same_hands(kiosk_shows(kiosk->kiosk), exhibit);
    if (kiosk->graph) {
        live_graph_set(kiosk->graph, exhibit);
    }
    kiosk->before = kiosk_exhibit(kiosk->kiosk, exhibit, now_us(kiosk));
    if (kiosk_shows(kiosk->kiosk) != exhibit) {
        if (kiosk->graph) {
            live_graph_set(kiosk->graph, kiosk_shows(kiosk->kiosk));
        }
        refuse(kiosk, "the exhibit stays as it was", "memory is short for another one");
        return;
    }
    open_gallery(kiosk, exhibit, kiosk->before);
    if (kiosk->pictures) {
        live_pictures_set(kiosk->pictures, kiosk_shows(kiosk->kiosk), kiosk_scene(kiosk->kiosk));
    }
    if (same) { /* the inputs in use become the new exhibit's */
        struct inputs *inputs = exhibit->inputs;
        exhibit->inputs = kiosk->before->inputs;
        kiosk->before->inputs = inputs;
        kiosk_controls(kiosk->kiosk, kiosk->input->controls);
    } else {
        open_input(kiosk, kiosk_shows(kiosk->kiosk));
    }
    say(kiosk, "%s: taken up %.0f ms after it was changed%s", kiosk_shows(kiosk->kiosk)->path,
        exhibit_watch_ms(kiosk->watch), same ? "" : ", with other inputs");
    kiosk->reloads++;
    kiosk->wrong = false;
}

static void look_at_file(struct live_kiosk *kiosk)
{
    struct exhibit *exhibit = NULL;
    char *report = NULL;
    if (kiosk->before) { /* one after another */
        /* Neither the studio nor the picture has a script of it any more. */
        if (!kiosk->other && studio_script(kiosk->status.studio) == kiosk_scene(kiosk->kiosk)->script) {
            exhibit_destroy(kiosk->before);
            kiosk->before = NULL;
        }
        return;
    }
    switch (exhibit_watch_news(kiosk->watch, real_us(), kiosk_shows(kiosk->kiosk), &exhibit, &report)) {
    case EXHIBIT_READ:
        take_up(kiosk, exhibit);
        break;
    case EXHIBIT_WRONG:
        refuse(kiosk, "the exhibit stays as it was", report);
        free(report);
        break;
    default:
        break;
    }
}

static void run_slides(struct live_kiosk *kiosk)
{
    const struct exhibit *exhibit = kiosk_shows(kiosk->kiosk);
    char folder[1200];
    gallery_path(kiosk, exhibit, folder, sizeof folder);
    live_slides_run(&kiosk->slides, kiosk->kiosk, kiosk->gallery, folder, exhibit->gallery.stick, now_us(kiosk));
}

void live_kiosk_run(struct live_kiosk *kiosk)
{
    if (!kiosk->kiosk) {
        return;
    }
    take_hand(kiosk);
    kiosk_run(kiosk->kiosk, now_us(kiosk), live_clock_wall(&kiosk->clock));
    const struct script *script = kiosk_scene(kiosk->kiosk)->script;
    if (kiosk->other && studio_script(kiosk->status.studio) == script) {
        live_picture_change(kiosk->picture, script);
        live_care_change(kiosk->status.care, script);
        kiosk->other = false;
    }
    if (kiosk_is_visited(kiosk->kiosk) != kiosk->visited) {
        kiosk->visited = !kiosk->visited;
        live_keep_visit(kiosk->painting, kiosk->visited);
    }
    run_slides(kiosk);
    look_at_file(kiosk);
}

bool live_kiosk_changed(struct live_kiosk *kiosk)
{
    return kiosk->kiosk && kiosk_look(kiosk->kiosk, now_us(kiosk))->changed;
}

static void keep(struct live_kiosk *kiosk)
{
    int width, height;
    uint8_t *rgb = live_picture_capture(kiosk->picture, &width, &height);
    kiosk->keep = false;
    if (rgb) {
        live_scene_draw_reveal(kiosk->scene_draw, rgb, width, height);
        char journal[40];
        int fd = live_keep_journal(kiosk->painting);
        snprintf(journal, sizeof journal, "/proc/self/fd/%d", fd);
        gallery_keep(kiosk->gallery, &(struct gallery_picture){.rgb = rgb,
                                                               .width = width,
                                                               .height = height,
                                                               .unix_s = (int64_t)live_clock_wall(&kiosk->clock),
                                                               .journal = fd >= 0 ? journal : NULL});
        if (fd >= 0) {
            close(fd);
        }
    }
}

bool live_kiosk_draw(struct live_kiosk *kiosk, struct shader_error *error)
{
    if (!kiosk->kiosk) {
        return true;
    }
    if (kiosk->keep) {
        keep(kiosk);
    }
    return live_leave_draw(&kiosk->leave, kiosk->status.display, error) &&
           live_overlay_draw(&kiosk->overlay, kiosk->status.display, kiosk_look(kiosk->kiosk, now_us(kiosk)), error);
}

void live_kiosk_lost(struct live_kiosk *kiosk)
{
    live_overlay_finish(&kiosk->overlay);
    live_leave_lost(&kiosk->leave);
}

int live_kiosk_wait_ms(const struct live_kiosk *kiosk, int most)
{
    return kiosk->kiosk ? kiosk_timeout_ms(kiosk->kiosk, now_us(kiosk), most) : most;
}

bool live_kiosk_leaves(const struct live_kiosk *kiosk)
{
    return kiosk->kiosk && kiosk_leaves(kiosk->kiosk);
}

/* What the visit has come to, whenever that is another state than before. */
static void note_visit(struct live_kiosk *kiosk)
{
    const char *state = kiosk_state(kiosk->kiosk);
    if (state != kiosk->said) {
        say(kiosk, "visit %u: %s", kiosk_visits(kiosk->kiosk), state);
        kiosk->said = state;
    } else if (kiosk_staff(kiosk->kiosk) != kiosk->status_said) {
        kiosk->status_said = !kiosk->status_said;
        say(kiosk, "staff: the status view is %s", kiosk->status_said ? "up" : "gone");
    }
}

bool live_kiosk_log(struct live_kiosk *kiosk, char *line, int size, enum log_level *level)
{
    if (kiosk->kiosk && !kiosk->has_line) {
        note_visit(kiosk);
    }
    if (kiosk->has_line) {
        snprintf(line, (size_t)size, "%s", kiosk->line);
        kiosk->has_line = false;
        *level = kiosk->level;
        return true;
    }
    *level = LOG_LEVEL_NOTICE;
    if (kiosk->kiosk && (live_keep_log(kiosk->painting, line, size) || live_slides_log(&kiosk->slides, line, size) ||
                         (kiosk->pictures && live_pictures_log(kiosk->pictures, line, size)) ||
                         (kiosk->graph && live_graph_log(kiosk->graph, line, size)))) {
        return true;
    }
    return kiosk->gallery && size >= GALLERY_LINE && gallery_log(kiosk->gallery, line);
}
