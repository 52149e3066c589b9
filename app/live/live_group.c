#include "live_group.h"

#include <stdio.h>
#include <string.h>

#include "group.h"
#include "hash.h"
#include "live_service.h"

enum { PATH = 1400 };

/* A path of the exhibit, which is beside it. NULL stays NULL. */
static const char *beside(const struct exhibit *exhibit, const char *name, char path[PATH])
{
    snprintf(path, PATH, "%s/%s", exhibit->folder, name ? name : "");
    return name ? path : NULL;
}

static void open_broker(struct live_group *group, const struct exhibit *exhibit)
{
    const struct exhibit_mqtt *mqtt = &exhibit->mqtt;
    char ca[PATH], certificate[PATH], key[PATH], credentials[PATH];
    struct device_error error;
    char alive[BROKER_TOPIC], topics[BROKER_TOPICS][BROKER_TOPIC];
    struct broker_def def = {.host = mqtt->host,
                             .port = mqtt->port,
                             .ca = beside(exhibit, mqtt->ca, ca),
                             .certificate = beside(exhibit, mqtt->certificate, certificate),
                             .key = beside(exhibit, mqtt->key, key),
                             .credentials = beside(exhibit, mqtt->credentials, credentials),
                             .alive = alive};
    group_topic(mqtt, GROUP_ALIVE, alive);
    int count = group_topics(mqtt, topics);
    for (int i = 0; i < count; i++) {
        def.topics[i] = topics[i];
    }
    group->broker = broker_create(&def, &error);
    group->said_us = 0;
    if (!group->broker) {
        snprintf(group->line, sizeof group->line, "broker %.100s: %.200s", mqtt->host, error.text);
        group->has_line = true;
    }
}

/* Another exhibit may name another broker, or none. */
static void keep_up(struct live_group *group, const struct exhibit *exhibit)
{
    const struct exhibit_mqtt *mqtt = &exhibit->mqtt;
    const char *const parts[] = {mqtt->host, mqtt->topic,       mqtt->name, mqtt->group,
                                 mqtt->ca,   mqtt->certificate, mqtt->key,  mqtt->credentials};
    uint64_t mark = hash_number(HASH_START, mqtt->port);
    if (group->since == exhibit) {
        return;
    }
    group->since = exhibit;
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        mark = parts[i] ? hash_bytes(mark, parts[i], strlen(parts[i]) + 1) : hash_number(mark, (int64_t)i);
    }
    if (mark == group->mark) {
        return;
    }
    group->mark = mark;
    broker_destroy(group->broker);
    group->broker = NULL;
    if (mqtt->host) {
        open_broker(group, exhibit);
    }
}

static void hear(struct live_group *group, struct live_kiosk *kiosk)
{
    const struct exhibit_mqtt *mqtt = &kiosk_shows(kiosk->kiosk)->mqtt;
    struct broker_message message;
    struct group_command command;
    while (!group->has_line && broker_message(group->broker, &message)) { /* each has its line */
        bool known = group_read(mqtt, &message, &command);
        if (known && command.kind == GROUP_SCENE) {
            known = kiosk_want_scene(kiosk->kiosk, command.scene);
        } else if (known) {
            kiosk_keep_hours(kiosk->kiosk, command.hours);
        }
        snprintf(group->line, sizeof group->line, "broker: %.100s %s '%.60s'", message.topic,
                 known ? "says" : "says what is not known here,", message.text);
        for (char *c = group->line; *c; c++) { /* it comes from a network */
            if ((unsigned char)*c < ' ' || *c == 0x7f) {
                *c = '?';
            }
        }
        group->has_line = true;
    }
}

void live_group_turn(struct live_group *group, struct live_kiosk *kiosk, struct status *status, uint64_t now_us)
{
    char text[STATUS_BYTES];
    char topic[BROKER_TOPIC];
    if (!kiosk->kiosk) {
        return;
    }
    const struct exhibit *exhibit = kiosk_shows(kiosk->kiosk);
    keep_up(group, exhibit);
    if (!group->broker) {
        return;
    }
    hear(group, kiosk);
    if (group->said_us == 0 || now_us - group->said_us >= (uint64_t)exhibit->mqtt.every * 1000000) {
        group->said_us = now_us;
        live_service_status(status, kiosk, now_us);
        group_topic(&exhibit->mqtt, GROUP_STATUS, topic);
        if (status_json(status, text, sizeof text) > 0) {
            broker_publish(group->broker, topic, text);
        }
    }
}

void live_group_close(struct live_group *group)
{
    broker_destroy(group->broker);
    *group = (struct live_group){.broker = NULL};
}

bool live_group_log(struct live_group *group, char *line, int size)
{
    if (group->has_line) {
        snprintf(line, (size_t)size, "%s", group->line);
        group->has_line = false;
        return true;
    }
    return group->broker && broker_log(group->broker, line, size);
}
