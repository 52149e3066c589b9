/* The gallery copied to a stick that staff plug in (usb_stick.h).
 *
 * Nothing leaves by itself: a stick is written to only if there is, at its top, a folder of the name that the exhibit
 * gives, which staff have made on it at home (EXPORT_FOLDER unless told). A visitor's stick has none and nothing
 * happens, not even a line in the log. What is copied are pictures, plans and journals, under their own names, into
 * that folder; what is there already is skipped; nothing on the stick is read, replaced or removed. Each file is whole
 * or not there, whenever the stick is pulled; the folder is synced before it is said to be done.
 *
 * A thread of its own copies; the gallery goes on meanwhile, and files that it removes are left out. */
#ifndef FROND_GALLERY_EXPORT_H
#define FROND_GALLERY_EXPORT_H

#include <stdbool.h>

#define EXPORT_FOLDER "frond-gallery"

enum { EXPORT_LINE = 320 };

struct gallery_export;

/* Starts to copy from the gallery's folder to the folder `name` of the stick mounted at `stick`; texts are copied.
 * `name` is one part of a path. NULL when there is no such folder on the stick, it is a link or another file system, or
 * memory is short. */
struct gallery_export *gallery_export_start(const char *gallery, const char *stick, const char *name);
/* Whether it has ended; once, with the line for the log: "stick: 12 files were copied (34.5 MB), 40 were there". */
bool gallery_export_ended(struct gallery_export *export, char line[EXPORT_LINE]);
/* Takes NULL. Breaks off between two pieces of a file, and waits for that. */
void gallery_export_destroy(struct gallery_export *export);

#endif
