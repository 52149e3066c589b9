/* Flashes in a sequence of frames, as WCAG 2.2 counts them (success criterion 2.3.1, "three flashes or below
 * threshold"; definitions "general flash and red flash thresholds" and "relative luminance").
 *
 *     struct flash *flash = flash_begin(320, 200);
 *     each frame: flash_frame(flash, rgb, time_us);
 *     struct flash_worst worst = flash_worst(flash);      worst.general <= FLASH_MOST and so on
 *     flash_end(flash);
 *
 * A flash is a pair of opposing transitions: of relative luminance by FLASH_STEP or more, the darker end below
 * FLASH_DARKER; or to and from saturated red. It counts where it takes a quarter of a window of a third of the frame
 * each way (341 x 256 of 1024 x 768), anywhere. A frame is looked at in FLASH_BLOCKS x FLASH_BLOCKS blocks, averaged.
 * Counted twice over, the greater holds: each block by itself (they need not flash at one moment: too strict rather
 * than too lax), and what blocks of a window do at one moment, whichever they are. */
#ifndef FROND_FLASH_H
#define FROND_FLASH_H

#include <stdint.h>

enum {
    FLASH_BLOCKS = 24, /* across and down */
    FLASH_WINDOW = 8,  /* blocks of a window, across and down */
    FLASH_MOST = 3,    /* in any second, that WCAG allows */
};
#define FLASH_STEP   0.10f
#define FLASH_DARKER 0.80f

struct flash;

/* Frames of this size, FLASH_BLOCKS pixels each way at the least. Fails the test when memory is short. */
struct flash *flash_begin(int width, int height);
void flash_end(struct flash *flash); /* takes NULL */
/* 8-bit sRGB, row by row from the top left; times in microseconds, each later than the one before. */
void flash_frame(struct flash *flash, const uint8_t *rgb, uint64_t time_us);

struct flash_worst {
    int general, red;        /* the most flashes in any second */
    int x, y;                /* pixel: upper left of the window of most `general` and `red` together */
    uint64_t time_us;        /* of the frame that ends that second */
    double mean_change;      /* most that the mean relative luminance of the frame changed within a second */
    uint64_t mean_time_us;   /* of the frame that ends that one */
    double mean_first, mean; /* mean relative luminance of the first frame and the last */
    int frames;
};
struct flash_worst flash_worst(const struct flash *flash); /* of all frames until now */

#endif
