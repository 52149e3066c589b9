#include "replay.h"

#include <stdio.h>
#include <string.h>

#include "journal_file.h"
#include "player.h"
#include "stats.h"
#include "video.h"

/* Ticks in which the tone of moving pictures comes 63 % of the way: it holds still for the eye, as on the screen. */
enum { TONE_TICKS = 240 };

struct replaying {
    const struct replay_def *def;
    struct easel easel;
    struct player player;
    struct painting_def first;   /* sheet; width 0: there was none yet */
    struct easel_picture moving; /* of frames and film */
    struct video *video;
    int64_t shown; /* ticks of the last picture on the way; -1: none */
};

struct replay_def replay_default_def(void)
{
    return (struct replay_def){.every = REPLAY_EVERY, .easel = {.engine = ENGINE_CPU}};
}

/* What the sheet of now looks like. `scale`: pixels a cell of the first sheet: the size stays when the grid changes; 0:
 * as is asked for, a pixel a cell if nothing is. */
static struct picture_def picture_of(const struct replaying *replaying, int scale)
{
    const struct replay_def *asked = replaying->def;
    bool sized = scale == 0 && asked->width > 0;
    const struct journal_sheet *sheet = &replaying->player.sheet;
    struct picture_def def = picture_default_def();
    def.width = sized ? asked->width : replaying->first.width * (scale > 0 ? scale : 1);
    def.height = sized ? asked->height : replaying->first.height * (scale > 0 ? scale : 1);
    def.cells_x = sheet->def.width;
    def.cells_y = sheet->def.height;
    def.mixing = (enum ink_mixing)sheet->mode;
    def.seed = sheet->def.seed;
    for (int i = 0; i < INK_PALETTE; i++) {
        def.ink[i] = sheet->inks[i < sheet->ink_count ? i : 0];
    }
    return def;
}

static bool frame(struct replaying *replaying, struct easel_picture *picture, int scale, float follow,
                  struct file_error *error)
{
    if (replaying->first.width == 0) {
        replaying->first = replaying->player.sheet.def;
    }
    struct picture_def def = picture_of(replaying, scale);
    const struct picture_def *now = &picture->def;
    def.follow = follow;
    bool same = picture->picture && def.cells_x == now->cells_x && def.cells_y == now->cells_y &&
                def.mixing == now->mixing && def.seed == now->seed && memcmp(def.ink, now->ink, sizeof def.ink) == 0;
    if (def.width > PICTURE_SIZE_MAX || def.height > PICTURE_SIZE_MAX) {
        return file_fail(error, "the picture", "%dx%d pixels are more than %d a side", def.width, def.height,
                         PICTURE_SIZE_MAX);
    }
    return same || easel_frame(&replaying->easel, picture, &def, replaying->player.sheet.ink_count) ||
           file_fail(error, "the picture", "memory is short for %dx%d pixels", def.width, def.height);
}

/* A picture on the way. */
static bool show(struct replaying *replaying, struct file_error *error)
{
    const struct replay_def *def = replaying->def;
    struct easel_picture *picture = &replaying->moving;
    struct player *player = &replaying->player;
    if (!def->frames && !def->video) {
        return true;
    }
    if (!frame(replaying, picture, 0, (float)TONE_TICKS / (float)def->every, error)) {
        return false;
    }
    if (def->video && !replaying->video) {
        replaying->video = video_open(def->video, picture->def.width, picture->def.height, error);
    }
    if (def->video && !replaying->video) {
        return false;
    }
    replaying->shown = player->ticked;
    struct easel_scene scene = {player->engine, player->plot, player->ticked};
    bool good =
        def->frames ? easel_write_frame(picture, &scene, def->frames, error) : easel_draw(picture, &scene, error);
    return good && (!replaying->video || video_put(replaying->video, picture->rgb, error));
}

static bool play(struct replaying *replaying, struct progress *progress, struct file_error *error)
{
    struct player *player = &replaying->player;
    while (player_tick(player, error)) {
        replaying->first = replaying->first.width > 0 ? replaying->first : player->sheet.def;
        if (player->ticked % replaying->def->every == 0 && !show(replaying, error)) {
            return false;
        }
        if (progress) {
            progress_step(progress, player->ticked, player->last);
        }
    }
    return error->text[0] == '\0' && (replaying->shown == player->ticked || show(replaying, error));
}

static bool write_end(struct replaying *replaying, struct file_error *error)
{
    const struct replay_def *def = replaying->def;
    struct player *player = &replaying->player;
    struct easel_picture still = {.picture = NULL};
    /* What the figures are of. */
    const struct script sheet = {
        .width = player->sheet.def.width, .height = player->sheet.def.height, .margin = player->sheet.def.margin};
    if (def->stats && !stats_write(def->stats, &sheet, player->engine, player->plot, error)) {
        return false;
    }
    if (def->svg && !easel_write_plan(player->engine, def->paper_mm, def->svg, error)) {
        return false;
    }
    if (!def->picture) {
        return true;
    }
    easel_unframe(&replaying->moving);
    struct easel_scene scene = {player->engine, player->plot, player->ticked};
    bool good = frame(replaying, &still, def->scale, 0, error) && easel_write(&still, &scene, def->picture, error);
    easel_unframe(&still);
    return good;
}

static void remark(const struct replaying *replaying, struct replay_result *result)
{
    const struct player *player = &replaying->player;
    const struct journal_reader *reader = &player->reader;
    const char *engine = replaying->easel.def.engine == ENGINE_GPU ? "gpu" : "cpu";
    result->remark[0] = '\0';
    if (reader->ending == JOURNAL_TORN) {
        snprintf(result->remark, sizeof result->remark, "it is torn, and played up to there: %s", reader->error.text);
    } else if (strcmp(reader->head.engine, "cpu") != 0 || strcmp(engine, "cpu") != 0) {
        snprintf(result->remark, sizeof result->remark,
                 "painted by engine %.20s, played by %s: only the CPU's repeats a painting to the bit",
                 reader->head.engine, engine);
    } else if (reader->skipped > 0) {
        snprintf(result->remark, sizeof result->remark, "%d things in it are unknown to this Frond and left out",
                 reader->skipped);
    }
}

static bool check(const struct replay_def *def, struct file_error *error)
{
    return easel_check_file(def->picture, error) && easel_check_file(def->stats, error) &&
           easel_check_file(def->svg, error) &&
           (!def->video || (video_name(def->video, error) && easel_check_file(def->video, error))) &&
           (!def->frames || file_make_folder(def->frames, error));
}

bool replay(const struct replay_def *def, struct progress *progress, struct replay_result *result,
            struct file_error *error)
{
    struct replaying replaying = {.def = def, .easel = {.def = def->easel}, .shown = -1};
    struct bytes bytes;
    *result = (struct replay_result){.ticks = 0};
    if (!check(def, error) || !journal_file_read(def->journal, JOURNAL_FILE_MOST, &bytes, error)) {
        return false;
    }
    struct player_maker maker = {easel_make, &replaying.easel, true};
    bool good = player_open(&replaying.player, bytes.data, bytes.size, &maker, error) &&
                play(&replaying, progress, error) && write_end(&replaying, error);
    struct file_error ignored;
    good = video_close(replaying.video, good, good ? error : &ignored) && good;
    if (progress) {
        progress_end(progress);
    }
    result->ticks = replaying.player.ticked;
    result->sheets = replaying.player.sheets;
    result->actions = replaying.player.actions;
    remark(&replaying, result);
    easel_unframe(&replaying.moving);
    player_close(&replaying.player);
    easel_close(&replaying.easel);
    bytes_finish(&bytes);
    return good;
}
