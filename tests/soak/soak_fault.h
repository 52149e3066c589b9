/* What goes wrong around a kiosk, again and again, each for a while. */
#ifndef FROND_SOAK_FAULT_H
#define FROND_SOAK_FAULT_H

#include "soak.h"

enum fault_kind {
    FAULT_GLASS,   /* a touchscreen is pulled out and comes back */
    FAULT_PAD,     /* a controller */
    FAULT_LINES,   /* the buttons on the wall */
    FAULT_EDIT,    /* the exhibit is another one */
    FAULT_INPUTS,  /* its inputs are */
    FAULT_WRONG,   /* its file is wrong, then right again */
    FAULT_PICTURE, /* a picture is broken, then mended */
    FAULT_GUIDE,   /* so is one that the exhibit needs */
    FAULT_FULL,    /* the disk is full */
    FAULT_LOCKED,  /* the disk is read-only */
    FAULT_RESET,   /* the GPU is lost */
    FAULT_CLOCK,   /* the wall's clock jumps */
    FAULT_SLEEP,   /* the machine was asleep: the visit's clock jumps */
    FAULT_NIGHT,   /* the exhibit closes, and opens */
    FAULT_HEAT,    /* the board is hot: the governor does less */
    FAULT_KINDS,
};

struct faults {
    struct fault {
        double due_s; /* when it begins, or ends */
        bool is;      /* it has begun */
        int count;    /* begun */
    } fault[FAULT_KINDS];
    double pace;    /* times the average time from one to the next */
    char heat[100]; /* a made-up tree of sysfs */
    bool retired;   /* nothing begins any more */
};

/* `soak` is open. `only`: the name of the one fault that there is; NULL: all. False: the folders of faults cannot be
 * made. */
bool faults_init(struct faults *faults, struct soak *soak, double pace, const char *only);
void faults_turn(struct faults *faults, struct soak *soak);
/* Everything is as it should be. */
bool faults_over(const struct faults *faults);
const char *fault_name(enum fault_kind kind);
/* Begun, all kinds together. */
int faults_count(const struct faults *faults);

#endif
