/* The painting kept against crashes and pulled plugs: checkpoints of it and its journal, in a folder of their own,
 * written by a thread of their own. After an end that was not meant, keep_find takes up the newest that is whole, and
 * does again what the journal holds since.
 *
 *     if (keep_find(folder, KEEP_REPEAT_S, &found)) { begin the studio with found.checkpoint, at found.ticked ... }
 *     keep = keep_create(&def, &found);
 *     studio_def.teller = (struct studio_teller){keep_tell, keep};
 *     keep_visit(keep, true);      a visitor paints: from now on it is kept
 *     keep_visit(keep, false);     attract: nothing is written, and nothing is left
 *
 * A checkpoint is written at most every `every_s`, and only as soon as repeating what came after the last would take
 * `repeat_s`; when the painting is as it was last, none is, and after that nothing at all until something happens. The
 * journal follows every `flush_s`. The folder holds one journal and two checkpoints at most.
 *
 * A disk that is full, read-only or failing costs one line in the log and what it cannot hold; it is tried again every
 * `retry_s`, and when it can be written to again, that is one line too. */
#ifndef FROND_KEEP_H
#define FROND_KEEP_H

#include "checkpoint.h"
#include "file.h"
#include "journal.h"
#include "studio_tell.h"

struct keep_def {
    const char *folder; /* made, with those above it, if it is not there; nobody else's */
    struct journal_head head;
    double every_s;                 /* from one checkpoint to the next, at least: 4 */
    double most_s;                  /* and at most, while something happens: 20 */
    double repeat_s;                /* of ticks that may have to be repeated: 0.6 */
    double flush_s;                 /* from one append to the journal to the next: 2 */
    double retry_s;                 /* after a disk that failed: 30 */
    size_t journal_most;            /* bytes; a longer one is given up, and every_s counts alone: 16 MiB */
    const struct file_calls *calls; /* NULL: the system's */
};

struct keep_def keep_default_def(void);

/* What there was when we began. */
struct keep_found {
    struct checkpoint checkpoint; /* the painting, with what could be repeated */
    struct journal_sheet sheet;   /* its inks, mode and scene */
    uint64_t exhibit_hash;
    int64_t ticked;       /* since its journal began: studio_def.from_ticked */
    int64_t lost;         /* ticks that the journal knows of and that are not in it */
    char line[400];       /* for the log: what was found, also when nothing was; "" when there is nothing to say */
    struct bytes journal; /* up to there; empty when it cannot be gone on with */
    struct journal_place place;
    uint64_t generation, number;
};

#define KEEP_REPEAT_S 1.5 /* a kiosk is back within two seconds */

/* The newest painting in the folder that is whole; false: there is none. What the journal holds since is repeated for
 * `most_s` seconds at most: the rest is lost. */
bool keep_find(const char *folder, double most_s, struct keep_found *found);
void keep_found_finish(struct keep_found *found); /* may be done twice */

struct keep;

/* Goes on with what was found (its journal is taken over), or from nothing where that is NULL or empty. Nothing is
 * written before keep_visit. NULL when memory is short or there is no thread to be had. */
struct keep *keep_create(const struct keep_def *def, struct keep_found *found);
/* Writes what is not written yet; takes NULL. The files stay: a painting goes on after a restart that was meant. */
void keep_destroy(struct keep *keep);

/* For struct studio_teller, in the studio's thread; `data` is the keep. Waits for no disk. */
void keep_tell(void *data, const struct studio_event *event);
/* Whether the painting is a visitor's, and kept. */
void keep_visit(struct keep *keep, bool on);
/* The id of the scene that sheets and scenes told from now on are of. */
void keep_scene(struct keep *keep, const char *scene);
/* The whole journal of the sheet now, ended, for a gallery; false when there is none that stands alone. */
bool keep_journal(struct keep *keep, struct bytes *journal);

enum keep_state { KEEP_GOOD, KEEP_FULL, KEEP_READ_ONLY, KEEP_FAILING };

struct keep_report {
    enum keep_state state;
    int64_t checkpoints;      /* written since keep_create */
    int64_t spared;           /* that were as the last one */
    int64_t bytes;            /* written, of checkpoints and journals */
    int64_t checkpoint_bytes; /* of the newest */
    double bytes_per_hour;    /* since keep_create */
    double pack_ms, write_ms; /* what the newest took */
    double save_ms;           /* that the studio's thread gave to it */
    int64_t kept_ticked;      /* all that was told until this tick is on the disk */
};
struct keep_report keep_report(struct keep *keep);
/* The next line for the log; false: none. */
bool keep_log(struct keep *keep, char *line, int size);

#endif
