/* A connection to an MQTT broker (3.1.1), on a thread of its own: nobody waits here for a network. While the broker
 * cannot be reached it is tried again, ever more seldom (BROKER_AGAIN_MOST_S); what is published meanwhile is kept, the
 * newest of each topic, and sent then. Built without libmosquitto there is none, and broker_create says so. */
#ifndef FROND_BROKER_H
#define FROND_BROKER_H

#include <stdbool.h>

#include "device_error.h"

enum {
    BROKER_TOPICS = 4,   /* listened to; and published at a time */
    BROKER_TOPIC = 200,  /* bytes of a topic, with the final NUL */
    BROKER_TEXT = 128,   /* bytes of a message that is listened to, with the final NUL; longer ones are not taken */
    BROKER_WAITING = 16, /* messages that nobody has fetched; what comes then is not taken */
    BROKER_AGAIN_MOST_S = 60,
    BROKER_GOODBYE_S = 2, /* that broker_destroy() waits at most */
};

struct broker_def { /* all of it is copied; paths are read when it connects */
    const char *host;
    int port;
    const char *ca; /* PEM, what signs the broker's certificate, whose name must be `host`; NULL: no TLS */
    const char *certificate, *key;     /* PEM, of this client; NULL: it has none */
    const char *credentials;           /* a file: a line with the user, a line with the password; NULL: none */
    const char *topics[BROKER_TOPICS]; /* listened to; NULL: no more */
    const char *alive;                 /* topic that is "1" while this is connected and "0" afterwards, retained */
};

struct broker;

/* NULL with the reason in `error`. That the broker cannot be reached is no reason. */
struct broker *broker_create(const struct broker_def *def, struct device_error *error);
/* Takes NULL. Says goodbye, and waits for the thread; where a network hangs the thread is left to end by itself. */
void broker_destroy(struct broker *broker);
/* Publishes, retained, at least once. False when memory is short or BROKER_TOPICS others wait. */
bool broker_publish(struct broker *broker, const char *topic, const char *text);

struct broker_message {
    char topic[BROKER_TOPIC], text[BROKER_TEXT];
};
/* The next message of the topics that are listened to. Retained ones come at each connection. */
bool broker_message(struct broker *broker, struct broker_message *message);
/* The next line for the log: connected, refused, lost. */
bool broker_log(struct broker *broker, char *line, int size);

#endif
