/* What a kiosk says and hears in a group of kiosks, by topics of an MQTT broker:
 *
 *   TOPIC/NAME/alive     "1" while it is connected, "0" after that; retained
 *   TOPIC/NAME/status    its status (status_json), at least every `every` seconds: the heartbeat; retained
 *   TOPIC/NAME/scene     heard: the id of a scene that is shown as soon as nobody paints
 *   TOPIC/NAME/hours     heard: "open", "closed", or "schedule", which is what the exhibit says
 *   TOPIC/GROUP/scene, TOPIC/GROUP/hours    the same for all of a group
 *
 * Pure. */
#ifndef FROND_GROUP_H
#define FROND_GROUP_H

#include <stdbool.h>

#include "broker.h"
#include "exhibit.h"
#include "kiosk.h"

enum group_topic { GROUP_ALIVE, GROUP_STATUS };

enum group_kind { GROUP_NOTHING, GROUP_SCENE, GROUP_HOURS };

struct group_command {
    enum group_kind kind;
    const char *scene; /* in the text of the message */
    enum kiosk_hours hours;
};

/* The topic of what this kiosk says. */
void group_topic(const struct exhibit_mqtt *mqtt, enum group_topic which, char topic[BROKER_TOPIC]);
/* The topics to listen to: how many of `topics` are filled. */
int group_topics(const struct exhibit_mqtt *mqtt, char topics[BROKER_TOPICS][BROKER_TOPIC]);
/* What is to be done. False: the message says nothing that is known. */
bool group_read(const struct exhibit_mqtt *mqtt, const struct broker_message *message, struct group_command *command);

#endif
