/* Built without libmosquitto. */
#include "broker.h"

struct broker *broker_create(const struct broker_def *def, struct device_error *error)
{
    (void)def;
    device_fail(error, "this Frond was built without MQTT (libmosquitto)");
    return NULL;
}

void broker_destroy(struct broker *broker)
{
    (void)broker;
}

bool broker_publish(struct broker *broker, const char *topic, const char *text)
{
    (void)broker;
    (void)topic;
    (void)text;
    return false;
}

bool broker_message(struct broker *broker, struct broker_message *message)
{
    (void)broker;
    (void)message;
    return false;
}

bool broker_log(struct broker *broker, char *line, int size)
{
    (void)broker;
    (void)line;
    (void)size;
    return false;
}
