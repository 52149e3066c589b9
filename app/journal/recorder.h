/* What the studio tells, into a journal. */
#ifndef FROND_RECORDER_H
#define FROND_RECORDER_H

#include "journal.h"
#include "studio_tell.h"

/* Writes what an event says; TICKED, TAKING and WHOLE say nothing. `since`: the event's `ticked` at which the journal
 * began. `scene`: id of the scene of now, "" for none. */
void recorder_write(struct journal_writer *writer, const struct studio_event *event, int64_t since, const char *scene);
/* The sheet that a SHEET or SCENE event begins. */
struct journal_sheet recorder_sheet(const struct studio_event *event, const char *scene);

#endif
