/* What a kiosk says and hears in a group: topics and what they mean. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "group.h"

static const struct exhibit_mqtt HALL = {.topic = "museum/frond", .name = "hall", .group = "all"};
static const struct exhibit_mqtt ALONE = {.topic = "frond", .name = "hall"};

static bool heard(const struct exhibit_mqtt *mqtt, const char *topic, const char *text, struct group_command *command)
{
    static struct broker_message message;
    snprintf(message.topic, sizeof message.topic, "%s", topic);
    snprintf(message.text, sizeof message.text, "%s", text);
    return group_read(mqtt, &message, command);
}

static void topics(void **state)
{
    char topic[BROKER_TOPIC], list[BROKER_TOPICS][BROKER_TOPIC];
    (void)state;
    group_topic(&HALL, GROUP_ALIVE, topic);
    assert_string_equal(topic, "museum/frond/hall/alive");
    group_topic(&HALL, GROUP_STATUS, topic);
    assert_string_equal(topic, "museum/frond/hall/status");
    assert_int_equal(group_topics(&HALL, list), 4);
    assert_string_equal(list[0], "museum/frond/hall/scene");
    assert_string_equal(list[3], "museum/frond/all/hours");
    assert_int_equal(group_topics(&ALONE, list), 2);
}

static void commands(void **state)
{
    struct group_command command;
    (void)state;
    assert_true(heard(&HALL, "museum/frond/all/scene", "dawn", &command));
    assert_int_equal(command.kind, GROUP_SCENE);
    assert_string_equal(command.scene, "dawn");
    assert_true(heard(&HALL, "museum/frond/hall/hours", "closed", &command));
    assert_int_equal(command.kind, GROUP_HOURS);
    assert_int_equal(command.hours, KIOSK_CLOSED);
    assert_true(heard(&HALL, "museum/frond/all/hours", "open", &command));
    assert_int_equal(command.hours, KIOSK_OPEN);
    assert_true(heard(&HALL, "museum/frond/all/hours", "schedule", &command));
    assert_int_equal(command.hours, KIOSK_BY_SCHEDULE);
}

static void all_else_is_nothing(void **state)
{
    struct group_command command;
    (void)state;
    assert_false(heard(&HALL, "museum/frond/all/hours", "", &command));
    assert_false(heard(&HALL, "museum/frond/all/hours", "OPEN", &command));
    assert_false(heard(&HALL, "museum/frond/all/scene", "", &command));
    assert_false(heard(&HALL, "museum/frond/cellar/scene", "dawn", &command));
    assert_false(heard(&HALL, "museum/frond/cellar/hours", "open", &command));
    assert_false(heard(&HALL, "museum/frond/hall/status", "dawn", &command));
    assert_false(heard(&HALL, "museum/frond/hall/status", "open", &command));
    assert_false(heard(&ALONE, "frond/all/hours", "closed", &command));
    assert_false(heard(&ALONE, "frond/all/scene", "dawn", &command));
    assert_int_equal(command.kind, GROUP_NOTHING);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(topics), cmocka_unit_test(commands),
                                       cmocka_unit_test(all_else_is_nothing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
