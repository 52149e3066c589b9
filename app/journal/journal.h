/* A journal: everything that happened to a painting, by tick, so that the CPU engine repeats it to the bit. It stands
 * alone: sheet, seed, inks and coefficients are in it, and every raster of its actions. Byte by byte: FORMAT.md.
 *
 * Written by appending alone, read up to the first record that is not whole: a torn tail costs what it held. Verbs,
 * parameters, coefficients, inks, brushes and choices are written by their names, and every parameter of an action with
 * its value, so that neither a new verb nor another default asks for anything here; what this Frond does not know is
 * left out and counted.
 *
 *     struct journal_writer writer;
 *     journal_begin(&writer, &head);
 *     journal_sheet(&writer, 0, &sheet);
 *     journal_action(&writer, ticked, &action);
 *     ... writer.out holds the bytes, to be appended to a file ...
 *
 *     struct journal_reader reader;
 *     if (journal_open(&reader, data, size, &error)) {
 *         while (journal_next(&reader, &record)) { ... }
 *     }
 *     journal_close(&reader);
 *
 * Pure: bytes in, bytes out; no files, no clocks. Time is ticks that were painted since the journal began: it never
 * goes back, also where the painting does. */
#ifndef FROND_JOURNAL_H
#define FROND_JOURNAL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "action.h"
#include "bytes.h"
#include "history.h"
#include "painting.h"
#include "script.h"

enum {
    JOURNAL_MAJOR = 1, /* others are refused */
    JOURNAL_MINOR = 0, /* more is understood; unknown records and what follows the known part of one are skipped */
    JOURNAL_PATH_MAX = 65536,                             /* points of a stroke */
    JOURNAL_RASTERS_MAX = 1024,                           /* in one journal */
    JOURNAL_RASTER_VALUES_MAX = SCRIPT_RASTER_VALUES_MAX, /* floats of all rasters together */
    JOURNAL_RECORD_MAX = 256 << 20,                       /* bytes */
    JOURNAL_TICKS_MAX = INT32_MAX,                        /* between two records: a year */
};

enum journal_kind {
    JOURNAL_HEAD = 1, /* who wrote it; the first record */
    JOURNAL_SHEET,    /* a fresh sheet */
    JOURNAL_SCENE,    /* other inks, coefficients and seed; the painting stays, brought to that canvas */
    JOURNAL_GRID,     /* the painting is brought to another grid; all else stays */
    JOURNAL_RASTER,   /* values that actions refer to; not given to readers */
    JOURNAL_VERB,     /* a verb and its parameters by name; not given to readers */
    JOURNAL_ACTION,   /* an action */
    JOURNAL_MARK,     /* time has passed */
    JOURNAL_RESTORED, /* taken up again after an end that was not meant: nothing from before can be undone */
    JOURNAL_END,      /* nothing follows */
    JOURNAL_KINDS,
};

struct journal_head {
    char version[BYTES_TEXT]; /* of the Frond that writes */
    char engine[BYTES_TEXT];  /* as struct engine_ops has it; only what "cpu" painted is repeated to the bit */
    char exhibit[BYTES_TEXT]; /* id of the exhibit or name of the script; "": none */
    uint64_t exhibit_hash;    /* of its file; 0: none */
    int minor;                /* of the format, as it was read */
};

/* A sheet, or another scene on it. */
struct journal_sheet {
    struct painting_def def; /* width, height, margin, seed, coefficients; the rest is not written */
    int mode;                /* enum ink_mixing */
    int inks[PAINTING_INKS]; /* indices into inks[] */
    int ink_count;
    char scene[BYTES_TEXT];     /* its id; "": none */
    struct history_def history; /* what undo, redo and rewind go back to; `bytes` 0: there is no history */
};

/* The sheet of a script on a painting of this definition, with the default history. */
struct journal_sheet journal_sheet_of(const struct script *script, const struct painting_def *def);

struct journal_error {
    char text[300];
};

struct journal_writer {
    struct bytes out; /* what was not taken yet; `failed`: memory was short, and the journal is of no use any more */
    uint64_t written; /* bytes since the beginning, those of `out` included */
    uint64_t records;
    uint32_t crc;   /* of all records before */
    int64_t ticked; /* of the last record */
    size_t record;  /* where in `out` the one being written begins */
    bool declared[ACTION_VERBS];
    uint64_t rasters[JOURNAL_RASTERS_MAX]; /* hashes of those in the journal */
    int raster_first, raster_count;        /* number of rasters[0]; how many */
};

/* Begins a journal with its head, at tick 0. */
void journal_begin(struct journal_writer *writer, const struct journal_head *head);
/* `ticked`: ticks painted since the journal began, not less than the last time. */
void journal_sheet(struct journal_writer *writer, int64_t ticked, const struct journal_sheet *sheet);
void journal_scene(struct journal_writer *writer, int64_t ticked, const struct journal_sheet *scene);
void journal_grid(struct journal_writer *writer, int64_t ticked, int width, int height, int margin);
/* An action before the next tick. A raster is written where the journal does not hold it yet, which takes some
 * milliseconds a megabyte. */
void journal_action(struct journal_writer *writer, int64_t ticked, const struct action *action);
void journal_mark(struct journal_writer *writer, int64_t ticked);
/* `lost`: ticks that were painted before and are not in the painting. */
void journal_restored(struct journal_writer *writer, int64_t ticked, int64_t lost);
void journal_end(struct journal_writer *writer, int64_t ticked);
void journal_finish(struct journal_writer *writer);

struct journal_record {
    enum journal_kind kind;
    int64_t ticked; /* since the journal began: so many are painted before it happens */
    union {
        struct journal_sheet sheet; /* SHEET, SCENE */
        struct {
            int width, height, margin;
        } grid;
        struct action action; /* `tick` is `ticked`; path good until the next record, rasters until journal_close */
        int64_t lost;         /* RESTORED */
    };
};

enum journal_ending {
    JOURNAL_GOES_ON, /* it was not read to its end */
    JOURNAL_ENDS,    /* it was ended as it should */
    JOURNAL_STOPS,   /* after a whole record, without an end: whoever wrote it was stopped */
    JOURNAL_TORN,    /* inside a record, or one is damaged: `error` says where; what comes after it is lost */
};

struct journal_raster {
    float *values;
    int width, height, channels;
};

struct journal_verb;

struct journal_reader {
    struct journal_head head;
    enum journal_ending ending;
    struct journal_error error; /* of JOURNAL_TORN, or "" */
    int skipped;                /* records of unknown kinds or verbs, and parameters that nobody knows */
    int64_t ticked;             /* of the last record */
    uint64_t good, records;     /* bytes and number of the whole records */
    uint32_t crc;               /* of those */
    /* The inside. */
    const uint8_t *data;
    size_t size;
    struct journal_verb *verbs; /* [256] */
    struct journal_raster *rasters;
    int raster_count;
    size_t raster_values; /* floats of all of them */
    struct point *points; /* of the action's path */
    int points_room;
};

/* False, with one line, where it is no journal, or of another major version, or its head is damaged. The bytes stay the
 * caller's and must outlive the reader. */
bool journal_open(struct journal_reader *reader, const void *data, size_t size, struct journal_error *error);
/* The next record; false at its end, see `ending`. */
bool journal_next(struct journal_reader *reader, struct journal_record *record);
void journal_close(struct journal_reader *reader); /* may be done twice; a zeroed one may be closed */

/* A place between two records. */
struct journal_place {
    uint64_t good, records; /* bytes and number of the records before */
    uint32_t crc;
    int64_t ticked;
    int rasters;
};
/* Behind what a reader has read. */
struct journal_place journal_place_of(const struct journal_reader *reader);
/* Goes on with a journal: what is written belongs behind its first `place->good` bytes. */
void journal_continue(struct journal_writer *writer, const struct journal_place *place);

const char *journal_kind_name(enum journal_kind kind);

#endif
