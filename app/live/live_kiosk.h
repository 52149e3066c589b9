/* An exhibit on a display: the kiosk (kiosk.h) between the devices and the studio, its pieces over the picture, its
 * file watched, its pictures kept. Without an exhibit all of this does nothing, and a session is shown as it is. */
#ifndef FROND_LIVE_KIOSK_H
#define FROND_LIVE_KIOSK_H

#include "exhibit_watch.h"
#include "gallery.h"
#include "kiosk.h"
#include "live_clock.h"
#include "live_graph.h"
#include "live_input.h"
#include "live_keep.h"
#include "live_leave.h"
#include "live_overlay.h"
#include "live_picture.h"
#include "live_pictures.h"
#include "live_scene.h"
#include "live_scene_draw.h"
#include "live_slides.h"
#include "live_status.h"
#include "log.h"
#include "studio.h"

struct live_kiosk_def {
    struct exhibit *exhibit;    /* taken over; NULL: a session, and no kiosk */
    bool open;                  /* whatever the schedule says */
    struct live_keep *painting; /* opened, and known to the studio */
    struct live_scene *scene;   /* known to the studio, too */
    struct live_scene_draw *scene_draw;
    const char *state;       /* folder that may be written to, with the gallery in it; NULL: nothing is kept */
    const char *trouble;     /* as in struct live_def */
    struct live_clock clock; /* all zero: the real ones */
};

struct live_kiosk {
    struct live_keep *painting; /* that is kept against crashes; who is not ours */
    struct live_scene *scene;   /* the others', too */
    struct live_scene_draw *scene_draw;
    bool visited;        /* as it was told last */
    struct kiosk *kiosk; /* NULL: a session */
    struct live_overlay overlay;
    struct live_leave leave; /* under it */
    struct exhibit_watch *watch;
    struct exhibit *before; /* until the studio has let go of its scripts */
    struct gallery *gallery;
    struct live_slides slides;
    struct live_pictures *pictures; /* of the exhibit's folder */
    struct live_graph *graph;       /* what its scenes take from one another */
    struct live_status_def status;  /* the others, who are not ours */
    struct live_picture *picture;
    struct live_input *input;
    struct live_input_def input_def;
    struct live_clock clock;
    const char *state;
    bool keep;        /* the next picture goes to the gallery */
    bool other;       /* another script is on its way to the picture */
    const char *said; /* the state that was said last */
    bool status_said;
    char line[1200];
    enum log_level level; /* of the line */
    bool has_line;
    uint64_t drops;           /* that visitors let fall */
    uint32_t reloads, errors; /* exhibits taken up while it runs; those that could not be */
    bool wrong;               /* the file cannot be used as it is now */
};

/* The exhibit must have the display's shape (live_kiosk_fit). With an exhibit this opens the input as well. False when
 * memory is short. */
bool live_kiosk_open(struct live_kiosk *kiosk, const struct live_kiosk_def *def, const struct live_status_def *status,
                     struct live_picture *picture, struct live_input *input, const struct live_input_def *input_def,
                     const struct shader_folder *folder);
void live_kiosk_close(struct live_kiosk *kiosk);
/* Once a turn of the loop, whether a frame is drawn or not. */
void live_kiosk_run(struct live_kiosk *kiosk);
/* Whether what is over the picture has changed. */
bool live_kiosk_changed(struct live_kiosk *kiosk);
/* After the picture, between display_begin and display_end. */
bool live_kiosk_draw(struct live_kiosk *kiosk, struct shader_error *error);
/* The GPU is lost: nothing of it is there any more. */
void live_kiosk_lost(struct live_kiosk *kiosk);
int live_kiosk_wait_ms(const struct live_kiosk *kiosk, int most);
bool live_kiosk_leaves(const struct live_kiosk *kiosk);
/* The next line for the log. */
bool live_kiosk_log(struct live_kiosk *kiosk, char *line, int size, enum log_level *level);

/* Every scene of an exhibit in the shape of a display of this size in pixels. */
void live_kiosk_fit(struct exhibit *exhibit, int width, int height);

#endif
