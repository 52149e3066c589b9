/* The inside of the kiosk. Private to kiosk*.c. */
#ifndef FROND_KIOSK_STATE_H
#define FROND_KIOSK_STATE_H

#include "access.h"
#include "attract.h"
#include "hud.h"
#include "kiosk.h"
#include "kiosk_look.h"
#include "schedule.h"
#include "staff.h"
#include "swallow.h"
#include "transition.h"
#include "visit.h"
#include "wash.h"

enum { KIOSK_AXES = 32, KIOSK_HANDS = 64 };

/* How a sheet goes where it is not washed (kiosk_leave.c). */
struct kiosk_leave {
    enum kiosk_leaving {
        LEAVE_NOT,
        LEAVE_WAITS,  /* for the stage */
        LEAVE_COVERS, /* the old sheet is seen less and less */
        LEAVE_HIDES,  /* all is covered, and the sheet is another */
        LEAVE_BARES,  /* the new sheet is seen more and more */
        LEAVE_BACK,   /* somebody has touched it: what has come so far goes again, over the new sheet */
    } state;
    int kind; /* enum transition_kind */
    uint32_t seed;
    uint64_t since_us, lasts_us; /* of the state */
    double from, to;             /* share of the transition at its beginning and end */
    bool asked;                  /* the next scene has been asked for, and comes when all is covered, or washed */
    bool told;                   /* what is being washed for it has been kept and handed over */
};

struct kiosk {
    struct kiosk_def def;
    struct exhibit *exhibit;
    struct controls *controls; /* the caller's */
    int scene;
    struct visit visit;
    struct hud hud;
    struct staff staff;
    struct access access;
    struct attract *attract;
    struct wash wash;
    struct swallow swallow;
    struct kiosk_leave leave;

    struct scene_options options; /* of the scene, as they are now (kiosk_options.c) */
    /* Of a scene of trees (kiosk_garden.c). */
    bool stocked;       /* the sheet has a picture */
    bool wants_picture; /* a visitor has asked for the next, which is not read yet */
    int gardens;        /* begun */

    int sheet;        /* number of the sheet that is meant; what is posted is for it */
    bool grounded;    /* its ground has been laid */
    bool attracting;  /* it paints itself... */
    bool begun;       /* ...and has been told what */
    bool washing;     /* for attract's next painting, or for the visit */
    uint32_t painted; /* by attract, in all */
    bool slide_due;
    uint64_t slide_us; /* since when one is shown; 0: none is */
    uint64_t slides;   /* shown so far */
    int paintings;     /* of attract, in this scene */
    bool leaves;
    bool dark;
    time_t time; /* of the last run */
    struct schedule_answer hours;
    enum kiosk_hours told; /* from afar */
    int wanted;            /* scene, 1..; 0: none */
    struct kiosk_hand {    /* a finger on the sheet */
        bool used;
        int id, seat;
    } hands[KIOSK_HANDS];
    struct kiosk_axis { /* where an axis was when it last counted as input: drift is no visitor */
        bool used;
        enum event_source source;
        uint32_t device, control;
        int index;
        float value;
    } axes[KIOSK_AXES];
    char *trouble;    /* owned; NULL: none */
    char lines[4096]; /* of the staff's view */
    uint64_t lines_us;
    struct kiosk_pieces pieces;
    struct hud_image images[KIOSK_PIECES];
};

/* kiosk_feel.c */
void kiosk_run_access(struct kiosk *kiosk, uint64_t now_us);

/* Tells the controls what is chosen on a palette. */
void kiosk_choose(struct kiosk *kiosk, int seat);
/* Tells the palettes which hands are busy. */
void kiosk_busy(struct kiosk *kiosk, uint64_t now_us);
/* Whatever is down leaves: its devices are gone. */
void kiosk_let_all_go(struct kiosk *kiosk);

/* kiosk_garden.c */
bool kiosk_has_trees(const struct kiosk *kiosk);
/* The picture of a fresh sheet of trees; nothing of other scenes. In attract it is another each time. */
void kiosk_lay_garden(struct kiosk *kiosk);
/* Pictures that are waited for. */
void kiosk_run_garden(struct kiosk *kiosk);
void kiosk_next_picture(struct kiosk *kiosk);

/* kiosk_options.c */
enum scene_kind kiosk_kind(const struct kiosk *kiosk);
/* A fresh sheet: what is set in its scene is as the file has it. */
void kiosk_lay_options(struct kiosk *kiosk);
/* Dials stand where the options are. */
void kiosk_stand_dials(struct kiosk *kiosk);
/* A visitor has set something: an option, a coefficient. It is shown beside the palette. */
void kiosk_take_option(struct kiosk *kiosk, const struct action *action, uint64_t now_us);
/* Another exhibit has this scene on the same sheet; these were its options before by its file. */
void kiosk_change_options(struct kiosk *kiosk, const struct scene_options *before);
/* What dials have set of drops to come is shown. */
void kiosk_tell_dials(struct kiosk *kiosk, uint64_t now_us);
/* The next value of what brings others: metaphor, kind, preset. */
void kiosk_next_kind(struct kiosk *kiosk, uint64_t now_us);
/* What was picked on a map since. */
void kiosk_run_maps(struct kiosk *kiosk, uint64_t now_us);

/* kiosk_leave.c */
/* The sheet begins to go as its scene does. False: it is to be washed. */
bool kiosk_leave(struct kiosk *kiosk, uint64_t now_us);
void kiosk_run_leave(struct kiosk *kiosk, uint64_t now_us);
/* The sheet is another: what covers the old one goes back, unless all is covered. */
void kiosk_leave_sheet(struct kiosk *kiosk, uint64_t now_us);
/* Somebody is there and wants to see the sheet. */
void kiosk_leave_hurry(struct kiosk *kiosk, uint64_t now_us);
/* The screen is off. */
void kiosk_leave_stop(struct kiosk *kiosk);
/* The next scene, as this one goes. */
void kiosk_ask_scene(struct kiosk *kiosk, uint64_t now_us);
/* Somebody paints, who does not wait for the scene that was asked for: it comes at once. */
void kiosk_leave_touched(struct kiosk *kiosk, uint64_t now_us);

/* kiosk.c */
/* The sheet goes as its scene does. */
void kiosk_begin_wash(struct kiosk *kiosk, uint64_t now_us);
/* The sheet is washed, or covered: what comes then. */
void kiosk_gone(struct kiosk *kiosk, uint64_t now_us);
/* An action of a visitor. */
bool kiosk_post(struct kiosk *kiosk, const struct action *action, uint64_t event_us);
/* Does what the visit orders. */
void kiosk_obey(struct kiosk *kiosk, uint64_t now_us);

#endif
