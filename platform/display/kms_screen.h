/* The screen of a card through everything that befalls it: nothing plugged in, plugged in elsewhere, another mode, off
 * by night, another program master of the card. Knows no GL and no clock: time is given, framebuffers are numbers. */
#ifndef FROND_KMS_SCREEN_H
#define FROND_KMS_SCREEN_H

#include "display.h"
#include "display_pace.h"
#include "kms_calls.h"
#include "kms_choice.h"
#include "kms_output.h"

enum kms_stage {
    KMS_EMPTY,   /* nothing to show on */
    KMS_CHOSEN,  /* connector and mode are chosen: make framebuffers of its size and call kms_screen_fit */
    KMS_FITTED,  /* the mode will be set with the next frame */
    KMS_RUNNING, /* the mode is set */
};

enum {
    KMS_SCAN_US = 2000000,    /* between looks at the connectors: forcing one by sysfs raises no event */
    KMS_MASTER_US = 500000,   /* between attempts to become master again */
    KMS_BUSY_US = 4000,       /* until a commit is tried again that the kernel was too busy for */
    KMS_FLIP_US = 2000000,    /* after which a flip is given up, and the mode set again */
    KMS_REFUSED_US = 30000000 /* after which a mode that was refused is tried again */
};

struct kms_screen {
    struct kms_card *card;
    struct kms_wish wish;
    struct kms_scan *scan;
    enum kms_stage stage;
    struct kms_output output; /* from KMS_CHOSEN on */
    uint32_t connector;       /* that had the picture last, 0: none yet */
    bool lent, dark;
    bool stale;              /* lent for good: the card has to be opened anew */
    bool to_switch_off;      /* the output is to be taken apart before anything else */
    bool to_darken;          /* ACTIVE is to be cleared */
    uint64_t off_until_us;   /* after which taking the output apart is given up */
    int chosen;              /* index of the mode */
    bool refused[KMS_MODES]; /* of the connector `refused_of` */
    uint32_t refused_of;
    struct device_error reason; /* why KMS_EMPTY */

    uint32_t next;    /* framebuffer that the kernel was too busy to take, 0: none */
    bool pending;     /* a flip has been asked for */
    uint64_t token;   /* of that flip */
    uint64_t flip_us; /* when it was asked for */
    struct display_pace pace;
    struct display_frames frames;

    uint64_t signature; /* of the last scan */
    uint64_t scan_due_us, master_due_us, busy_due_us, refused_due_us;
    uint32_t past_crtc; /* 0: not read */
    struct kms_past past;
};

/* Takes no card: that is the caller's, and outlives the screen. False with the reason when the wish can never come
 * true: no such connector on the card, or no such mode on a connector that is plugged in. */
bool kms_screen_start(struct kms_screen *screen, struct kms_card *card, const struct kms_wish *wish, uint64_t now_us,
                      struct device_error *error);
/* Puts back what the CRTC showed before, or switches it off. */
void kms_screen_finish(struct kms_screen *screen);

/* Attends to flips, hot-plug (`hot`: the kernel has told of one), master and everything that is due. */
void kms_screen_attend(struct kms_screen *screen, uint64_t now_us, bool hot);
uint64_t kms_screen_due_us(const struct kms_screen *screen); /* when to attend again at the latest */

enum display_state kms_screen_state(const struct kms_screen *screen);
/* Whether the kernel still reads framebuffers that are about to be dropped. */
bool kms_screen_reads(const struct kms_screen *screen);

/* KMS_CHOSEN: asks the kernel about a framebuffer of the mode's size. False when it refuses; `reason` then says
 * why. `last`: there is no other kind of framebuffer to try; another mode is chosen, or none. */
bool kms_screen_fit(struct kms_screen *screen, uint32_t framebuffer, bool last, uint64_t now_us);
/* No framebuffers can be made for what is chosen. */
void kms_screen_unfit(struct kms_screen *screen, const struct device_error *reason, uint64_t now_us);

/* Whether a frame may be presented now. */
bool kms_screen_free(const struct kms_screen *screen);
void kms_screen_present(struct kms_screen *screen, uint32_t framebuffer, uint64_t now_us);
void kms_screen_power(struct kms_screen *screen, bool on, uint64_t now_us);

#endif
