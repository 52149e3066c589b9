#include "live_slides.h"

#include <stdio.h>
#include <stdlib.h>

enum { LISTED = 200, SCATTER = 7919 };

void live_slides_open(struct live_slides *slides)
{
    *slides = (struct live_slides){.stick = usb_stick_create(USB_STICK_FOLDER, NULL)};
}

void live_slides_close(struct live_slides *slides)
{
    gallery_export_destroy(slides->export);
    usb_stick_destroy(slides->stick);
    *slides = (struct live_slides){.stick = NULL};
}

/* Bytes of red green blue as the kiosk shows them; the picture's are freed. */
static uint8_t *with_alpha(uint8_t *rgb, int width, int height)
{
    size_t pixels = (size_t)width * (size_t)height;
    uint8_t *rgba = malloc(pixels * 4);
    for (size_t i = 0; rgba && i < pixels; i++) {
        rgba[4 * i] = rgb[3 * i];
        rgba[4 * i + 1] = rgb[3 * i + 1];
        rgba[4 * i + 2] = rgb[3 * i + 2];
        rgba[4 * i + 3] = 255;
    }
    free(rgb);
    return rgba;
}

static void ask(struct live_slides *slides, struct gallery *gallery)
{
    char(*names)[GALLERY_NAME] = malloc(LISTED * sizeof *names);
    int count = names ? gallery_list(gallery, names, LISTED) : 0;
    count = count < LISTED ? count : LISTED;
    if (count > 0) {
        slides->turn += SCATTER;
        gallery_want(gallery, names[slides->turn % (uint32_t)count]);
        slides->asked = true;
    }
    free(names);
}

static void run_slides(struct live_slides *slides, struct kiosk *kiosk, struct gallery *gallery, uint64_t now_us)
{
    uint8_t *rgb;
    int width, height;
    if (slides->asked && gallery_got(gallery, &rgb, &width, &height)) {
        slides->asked = false;
        uint8_t *rgba = rgb ? with_alpha(rgb, width, height) : NULL;
        if (rgba) {
            kiosk_slide(kiosk, rgba, width, height, now_us);
        }
    }
    if (kiosk_wants_slide(kiosk) && !slides->asked) {
        ask(slides, gallery);
    }
}

void live_slides_run(struct live_slides *slides, struct kiosk *kiosk, struct gallery *gallery, const char *folder,
                     const char *name, uint64_t now_us)
{
    if (!gallery) {
        slides->asked = false;
        return;
    }
    run_slides(slides, kiosk, gallery, now_us);
    enum usb_stick_news news = slides->stick ? usb_stick_look(slides->stick) : USB_STICK_SAME;
    if (news != USB_STICK_SAME) {
        gallery_export_destroy(slides->export);
        slides->export = NULL;
    }
    if (news == USB_STICK_CAME) {
        slides->export = gallery_export_start(folder, USB_STICK_FOLDER, name ? name : EXPORT_FOLDER);
    }
}

bool live_slides_log(struct live_slides *slides, char *line, int size)
{
    if (!slides->export || size < EXPORT_LINE || !gallery_export_ended(slides->export, line)) {
        return false;
    }
    gallery_export_destroy(slides->export);
    slides->export = NULL;
    return true;
}
