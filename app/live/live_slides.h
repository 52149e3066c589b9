/* Pictures of the gallery that are shown between two paintings of attract, in an order that is not that of their
 * keeping; and the gallery copied to a stick that staff plug in. */
#ifndef FROND_LIVE_SLIDES_H
#define FROND_LIVE_SLIDES_H

#include <stdint.h>

#include "gallery.h"
#include "gallery_export.h"
#include "kiosk.h"
#include "usb_stick.h"

struct live_slides {
    bool asked; /* the gallery reads one */
    uint32_t turn;
    struct usb_stick *stick; /* NULL: this machine tells nothing of mounts */
    struct gallery_export *export;
};

void live_slides_open(struct live_slides *slides);
void live_slides_close(struct live_slides *slides);
/* Once a turn of the loop. `folder`: of the gallery; `name`: of the folder on a stick, NULL: EXPORT_FOLDER. */
void live_slides_run(struct live_slides *slides, struct kiosk *kiosk, struct gallery *gallery, const char *folder,
                     const char *name, uint64_t now_us);
bool live_slides_log(struct live_slides *slides, char *line, int size);

#endif
