#include "group.h"

#include <stdio.h>
#include <string.h>

void group_topic(const struct exhibit_mqtt *mqtt, enum group_topic which, char topic[BROKER_TOPIC])
{
    static const char *const NAMES[] = {"alive", "status"};
    snprintf(topic, BROKER_TOPIC, "%s/%s/%s", mqtt->topic, mqtt->name, NAMES[which]);
}

int group_topics(const struct exhibit_mqtt *mqtt, char topics[BROKER_TOPICS][BROKER_TOPIC])
{
    const char *const who[] = {mqtt->name, mqtt->group};
    int count = 0;
    for (int i = 0; i < 2 && who[i]; i++) {
        snprintf(topics[count++], BROKER_TOPIC, "%s/%s/scene", mqtt->topic, who[i]);
        snprintf(topics[count++], BROKER_TOPIC, "%s/%s/hours", mqtt->topic, who[i]);
    }
    return count;
}

static bool read_hours(const char *text, enum kiosk_hours *hours)
{
    static const char *const NAMES[] = {"schedule", "open", "closed"}; /* enum kiosk_hours */
    for (int i = 0; i < 3; i++) {
        if (strcmp(text, NAMES[i]) == 0) {
            *hours = (enum kiosk_hours)i;
            return true;
        }
    }
    return false;
}

bool group_read(const struct exhibit_mqtt *mqtt, const struct broker_message *message, struct group_command *command)
{
    char topics[BROKER_TOPICS][BROKER_TOPIC];
    int count = group_topics(mqtt, topics);
    *command = (struct group_command){.kind = GROUP_NOTHING};
    for (int i = 0; i < count; i++) {
        if (strcmp(topics[i], message->topic) == 0 && i % 2 == 0 && message->text[0]) {
            command->kind = GROUP_SCENE;
            command->scene = message->text;
        } else if (strcmp(topics[i], message->topic) == 0 && i % 2 == 1 && read_hours(message->text, &command->hours)) {
            command->kind = GROUP_HOURS;
        }
    }
    return command->kind != GROUP_NOTHING;
}
