/* Devices that are not there: a source whose events come from a table by time, or are posted by whoever holds it. It
 * stands in for any other source, in tests, in demonstrations and in measurements. */
#ifndef FROND_SOURCE_FAKE_H
#define FROND_SOURCE_FAKE_H

#include "source.h"

enum { SOURCE_FAKE_DEVICES = 16, SOURCE_FAKE_LAMPS = 64 };

enum source_fake_action {
    FAKE_EVENT,  /* `event` happens, on a device that is there */
    FAKE_ARRIVE, /* a device comes */
    FAKE_LEAVE,  /* it goes, and what it held down is released */
};

struct source_fake_step {
    uint64_t at_us; /* since the source was made; steps stand in the order of time */
    enum source_fake_action action;
    int device;         /* in the definition */
    struct event event; /* its time, device and source are filled in */
};

struct source_fake_def {
    enum event_source source;             /* what its events say they come from; SOURCE_FAKE if it plays nobody */
    const struct device *devices;         /* all that may come; copied. Ids are given here: 1, 2, ...; class NULL:
                                             "device" */
    int device_count;                     /* 0: one device that has no name */
    bool absent;                          /* they are not there at first; else they are, and say so */
    const struct source_fake_step *steps; /* copied */
    int step_count;
    uint64_t period_us; /* the table begins again after so long; 0: it is played once */
    int lamps;          /* how many lamps there are */
    /* CLOCK_MONOTONIC in microseconds; NULL: the real one. A test that gives its own needs not wait. */
    uint64_t (*clock)(void *user);
    void *user;
};

/* NULL: the definition is wrong, or memory is short. */
struct source *source_fake_create(const struct source_fake_def *def, struct device_error *error);

/* Devices by their place in the definition. What a device does while it is not there is lost, as with real ones. */
void source_fake_arrive(struct source *source, int device);
void source_fake_leave(struct source *source, int device);
/* Happens now; an event that has a time keeps it. */
void source_fake_post(struct source *source, int device, const struct event *event);

float source_fake_lamp(const struct source *source, int lamp); /* the level it was last given; 0 at first */
int source_fake_lamp_orders(const struct source *source);      /* how often any was given one */

#endif
