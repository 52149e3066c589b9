#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "journal_file.h"
#include "keep.h"
#include "keep_files.h"
#include "keep_state.h"
#include "pack.h"
#include "player.h"

static const int ALL_THREADS = 0;

void keep_found_finish(struct keep_found *found)
{
    checkpoint_finish(&found->checkpoint);
    bytes_finish(&found->journal);
}

/* Whether the journal is the one that a checkpoint was taken beside, whole up to there. */
static bool is_beside(const struct bytes *journal, const struct pack_note *note)
{
    struct journal_reader reader;
    struct journal_record record;
    struct journal_error error;
    if (!journal->data || !journal_open(&reader, journal->data, journal->size, &error)) {
        return false;
    }
    while (reader.records < note->records && journal_next(&reader, &record)) {
    }
    bool beside = reader.records >= note->records && reader.ticked <= note->ticked;
    /* Records that are for the reader alone come with the one after them: go up to the place itself. */
    struct cursor place = cursor_over(journal->data, journal->size);
    const uint8_t *all = cursor_take(&place, (size_t)note->written);
    beside = beside && note->written >= 4 && all;
    if (beside) {
        struct cursor last = cursor_over(all + note->written - 4, 4);
        beside = cursor_u32(&last) == note->crc;
    }
    journal_close(&reader);
    return beside;
}

/* What is due, tick by tick, while there is time; then the painting as it is, and how far that was. */
static bool repeat(struct player *player, double most_s, struct keep_found *found)
{
    struct file_error error;
    double began = keep_now_s();
    while (player_tick(player, &error)) {
        if (keep_now_s() - began > most_s) {
            break;
        }
    }
    struct checkpoint taken = {.planes = NULL};
    struct painting_def def = player->engine ? player->engine->ops->get_def(player->engine) : (struct painting_def){0};
    if (!player->engine || error.text[0] || !checkpoint_init(&taken, &def) ||
        !player->engine->ops->save(player->engine, &taken)) {
        checkpoint_finish(&taken);
        return false;
    }
    checkpoint_finish(&found->checkpoint);
    found->checkpoint = taken;
    found->sheet = player->sheet;
    found->place = player->done;
    found->lost = player->last > player->ticked ? player->last - player->ticked : 0;
    found->ticked = player->ticked;
    return true;
}

/* The journal up to where it was repeated; what follows is lost. */
static void take_journal(struct keep_found *found, struct bytes *journal)
{
    if (found->place.good <= journal->size) {
        journal->size = (size_t)found->place.good;
        found->journal = *journal;
        *journal = (struct bytes){.data = NULL};
    }
}

static bool from_checkpoint(const char *path, struct bytes *journal, double most_s, struct keep_found *found)
{
    struct bytes bytes;
    struct pack_note note;
    struct journal_error reason;
    struct file_error error;
    struct player player = {.engine = NULL};
    struct player_maker maker = player_cpu(&ALL_THREADS);
    if (!journal_file_read(path, JOURNAL_FILE_MOST, &bytes, &error)) {
        return false;
    }
    bool good = checkpoint_unpack(bytes.data, bytes.size, &found->checkpoint, &note, &reason);
    bytes_finish(&bytes);
    if (!good) {
        return false;
    }
    found->sheet = note.sheet;
    found->exhibit_hash = note.exhibit_hash;
    found->generation = note.generation;
    found->number = note.number;
    found->ticked = note.ticked;
    found->lost = 0;
    struct player_place place = {&found->checkpoint, note.ticked, note.records};
    if (is_beside(journal, &note) && player_resume(&player, journal->data, journal->size, &place, &maker, &error) &&
        repeat(&player, most_s, found)) {
        snprintf(found->line, sizeof found->line,
                 "the painting is taken up again, checkpoint %llu and %lld ticks of its journal; %lld ticks are lost",
                 (unsigned long long)note.number, (long long)(found->ticked - note.ticked), (long long)found->lost);
        take_journal(found, journal);
    } else {
        snprintf(found->line, sizeof found->line, "the painting is taken up again, checkpoint %llu without its journal",
                 (unsigned long long)note.number);
    }
    player_close(&player);
    return true;
}

static bool from_journal(struct bytes *journal, uint64_t generation, double most_s, struct keep_found *found)
{
    struct file_error error;
    struct player player = {.engine = NULL};
    struct player_maker maker = player_cpu(&ALL_THREADS);
    bool good = journal->data && player_open(&player, journal->data, journal->size, &maker, &error) &&
                repeat(&player, most_s, found);
    if (good) {
        found->exhibit_hash = player.reader.head.exhibit_hash;
        found->generation = generation;
        found->number = 0;
        snprintf(found->line, sizeof found->line,
                 "the painting is taken up again, %lld ticks of its journal; %lld ticks are lost",
                 (long long)found->ticked, (long long)found->lost);
    }
    player_close(&player);
    if (good) {
        take_journal(found, journal);
    }
    return good;
}

/* The newest of a generation that is whole; `first`: of its files. */
static bool from_generation(const char *folder, const struct keep_files *files, int first, double most_s,
                            struct keep_found *found)
{
    char path[KEEP_PATH];
    struct bytes journal = {.data = NULL};
    struct file_error error;
    uint64_t generation = files->files[first].generation;
    bool good = false;
    struct keep_file beside = {.journal = true, .generation = generation};
    if (keep_files_path(folder, &beside, path)) {
        journal_file_read(path, JOURNAL_FILE_MOST, &journal, &error);
    }
    for (int i = first; !good && i < files->count && files->files[i].generation == generation; i++) {
        if (keep_files_path(folder, &files->files[i], path)) {
            good = files->files[i].journal ? from_journal(&journal, generation, most_s, found)
                                           : from_checkpoint(path, &journal, most_s, found);
        }
    }
    bytes_finish(&journal);
    return good;
}

bool keep_find(const char *folder, double most_s, struct keep_found *found)
{
    struct keep_files files = keep_files_list(folder);
    bool good = false;
    *found = (struct keep_found){.ticked = 0};
    for (int i = 0; !good && i < files.count; i++) {
        if (i == 0 || files.files[i].generation != files.files[i - 1].generation) {
            good = from_generation(folder, &files, i, most_s, found);
        }
    }
    if (!good && files.count > 0) {
        snprintf(found->line, sizeof found->line, "nothing that was kept of the painting is whole: it begins anew");
    }
    if (!good) {
        keep_found_finish(found);
    }
    return good;
}
