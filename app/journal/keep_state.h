/* The inside of what keeps the painting: keep.c (whoever calls) and keep_work.c (the thread). */
#ifndef FROND_KEEP_STATE_H
#define FROND_KEEP_STATE_H

#include <pthread.h>

#include "keep.h"
#include "pack.h"

enum { KEEP_LINES = 8, KEEP_LINE = 300 };

/* Who has the checkpoint that goes from the studio to the disk. */
enum keep_turn { TURN_FREE, TURN_STUDIO, TURN_FULL, TURN_DISK };

struct keep {
    struct keep_def def;
    char *folder;
    pthread_t thread;

    pthread_mutex_t lock; /* of what follows, to the empty line; never held while the disk is waited for */
    pthread_cond_t changed;
    bool stop, on;
    bool clear;                   /* what lies in the folder is of no use any more */
    struct journal_writer writer; /* the whole journal of the sheet now, from its beginning */
    bool alone;                   /* it has one */
    bool overflown;               /* and is too long: nothing is written to it any more */
    uint64_t generation, number;  /* of the sheet now; of the newest checkpoint */
    int64_t since;                /* event's `ticked` at which the journal began */
    int64_t ticked;               /* the newest, of the journal */
    int64_t lost;                 /* of what was found, until the studio says that it has taken it up */
    bool still;                   /* nothing has changed since the newest checkpoint but time */
    bool urgent;                  /* what has happened cannot be repeated from an older one */
    uint64_t events, note_events; /* told so far, but ticks; when the checkpoint was taken */
    double taken_s, busy_s;       /* when the last was taken; what the ticks since have taken */
    enum keep_turn turn;
    struct checkpoint checkpoint; /* whose it is, says `turn` */
    struct painting_def wanted;   /* it should be for this sheet */
    struct pack_note note;        /* with the checkpoint */
    struct pack_note begun;       /* where the GPU began the rolling one */
    uint64_t begun_events;
    char scene[BYTES_TEXT];
    struct journal_sheet sheet; /* of now */
    struct keep_report report;
    char lines[KEEP_LINES][KEEP_LINE];
    int line_count;

    /* The thread's alone. */
    const struct file_calls *calls;
    struct packer packer;
    struct bytes packed, pending;
    int fd;                      /* of the journal; -1: it is not open, and not as it should be */
    uint64_t journal_generation; /* that the file is of */
    uint64_t flushed;            /* its bytes */
    uint64_t hash;               /* of the newest checkpoint on the disk; 0: there is none of this sheet */
    uint64_t hash_generation;
    double flush_at, retry_at, began_s;
    bool folder_made;
};

/* The thread: takes the keep. */
void *keep_work(void *context);
double keep_now_s(void);
/* A line for the log; with the lock held. The oldest goes when nobody has looked. */
void keep_say(struct keep *keep, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
