/* Writes the status of a kiosk (status.h) into a folder, STATUS_JSON and STATUS_METRICS, on a thread of its own: the
 * frame that tells it never waits for a disk. Readers see the old file or the new one, never half of one. Meant for a
 * folder in memory, the $RUNTIME_DIRECTORY of a unit. */
#ifndef FROND_STATUS_WRITER_H
#define FROND_STATUS_WRITER_H

#include "status.h"

#define STATUS_JSON    "status.json"
#define STATUS_METRICS "frond.prom"

enum { STATUS_EVERY_US = 5000000 };

struct status_writer;

/* `folder` must be there; copied. NULL when memory is short or the thread cannot be started. */
struct status_writer *status_writer_create(const char *folder);
/* Takes NULL. Waits for the file that is being written, and takes both away: what is not running has no status. */
void status_writer_destroy(struct status_writer *writer);
/* Whether it is time for another one: the first at once, then one every STATUS_EVERY_US. `now_us` of any clock that
 * does not jump. */
bool status_writer_due(const struct status_writer *writer, uint64_t now_us);
/* Copies it, and has it written soon. One that has not been written yet is replaced. */
void status_writer_post(struct status_writer *writer, const struct status *status, uint64_t now_us);
/* The next line for the log: writing fails, or works again. False: there is none. */
bool status_writer_log(struct status_writer *writer, char *line, int size);

#endif
