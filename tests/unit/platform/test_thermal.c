/* Temperature and throttling, as boards tell them, from made-up trees of sysfs. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "folder_case.h"
#include "thermal.h"

enum { SECOND = 1000000 };

static int make_root(void **state)
{
    char *root = calloc(1, FOLDER_CASE_PATH);
    *state = root;
    return root && folder_case_make(root) ? 0 : 1;
}

static int remove_root(void **state)
{
    bool removed = folder_case_remove(*state);
    free(*state);
    return removed ? 0 : 1;
}

/* Writes a file of the tree, its folders first. */
static void put(const char *root, const char *name, const char *text)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", root, name);
    for (char *slash = strchr(path + strlen(root) + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        mkdir(path, 0777);
        *slash = '/';
    }
    assert_true(folder_case_put(path, text));
}

static void put_zone(const char *root, int number, const char *type, const char *temperature)
{
    char path[100];
    snprintf(path, sizeof path, "sys/class/thermal/thermal_zone%d/type", number);
    put(root, path, type);
    snprintf(path, sizeof path, "sys/class/thermal/thermal_zone%d/temp", number);
    put(root, path, temperature);
}

static void assert_celsius(struct thermal_reading reading, double celsius)
{
    assert_true(fabs((double)reading.celsius - celsius) < 1e-3);
}

static void a_machine_that_tells_nothing(void **state)
{
    struct thermal *thermal = thermal_create(*state);
    assert_string_equal(thermal_describe(thermal),
                        "this machine tells neither its temperature nor whether it throttles");
    struct thermal_reading reading = thermal_read(thermal, 0);
    assert_true(isnan(reading.celsius));
    assert_string_equal(reading.zone, "");
    assert_false(reading.throttled || reading.under_voltage);
    thermal_destroy(thermal);
    thermal_destroy(NULL);
}

static void a_raspberry_pi(void **state)
{
    static const char *const firmware = "sys/devices/platform/soc/soc:firmware/get_throttled";
    put_zone(*state, 0, "cpu-thermal\n", "61836\n");
    put(*state, "sys/class/hwmon/hwmon0/name", "cpu_thermal\n");
    put(*state, "sys/class/hwmon/hwmon0/in0_lcrit_alarm", "1\n"); /* of another sensor */
    put(*state, "sys/class/hwmon/hwmon1/name", "rpi_volt\n");
    put(*state, "sys/class/hwmon/hwmon1/in0_lcrit_alarm", "0\n");
    put(*state, "sys/class/thermal/cooling_device0/type", "pwm-fan\n");
    put(*state, "sys/class/thermal/cooling_device0/cur_state", "3\n");
    put(*state, firmware, "50000\n"); /* both have occurred, neither is now */
    struct thermal *thermal = thermal_create(*state);
    assert_string_equal(thermal_describe(thermal), "temperature by cpu-thermal; under-voltage by rpi_volt; "
                                                   "throttling and under-voltage by the firmware");
    struct thermal_reading reading = thermal_read(thermal, 5);
    assert_celsius(reading, 61.836);
    assert_string_equal(reading.zone, "cpu-thermal");
    assert_false(reading.throttled || reading.under_voltage);
    static const struct {
        const char *text;
        bool throttled, under_voltage;
    } cases[] = {
        {"50005\n", true, true}, {"1\n", false, true},     {"2\n", false, false},
        {"4\n", true, false},    {"80008\n", true, false}, {"0xe0004\n", true, false},
    };
    for (int i = 0; i < 6; i++) {
        put(*state, firmware, cases[i].text);
        reading = thermal_read(thermal, (i + 1) * 2 * SECOND);
        assert_int_equal(reading.throttled, cases[i].throttled);
        assert_int_equal(reading.under_voltage, cases[i].under_voltage);
    }
    put(*state, firmware, "0\n");
    put(*state, "sys/class/hwmon/hwmon1/in0_lcrit_alarm", "1\n");
    reading = thermal_read(thermal, 100 * SECOND);
    assert_true(reading.under_voltage && !reading.throttled);
    thermal_destroy(thermal);
}

static void a_board_with_many_zones(void **state)
{
    put_zone(*state, 0, "package-thermal\n", "70307\n");
    put_zone(*state, 1, "bigcore0-thermal\n", "74000\n");
    put_zone(*state, 5, "gpu-thermal\n", "73076\n");
    put_zone(*state, 6, "iwlwifi_1\n", "99000\n"); /* a radio */
    put_zone(*state, 7, "battery\n", "98000\n");
    put(*state, "sys/class/thermal/cooling_device0/type", "cpufreq-cpu0\n");
    put(*state, "sys/class/thermal/cooling_device0/cur_state", "0\n");
    put(*state, "sys/class/thermal/cooling_device1/type", "cpufreq-cpu0\n");
    put(*state, "sys/class/thermal/cooling_device1/cur_state", "2\n");
    struct thermal *thermal = thermal_create(*state);
    assert_non_null(strstr(thermal_describe(thermal), "; throttling by cpufreq-cpu0"));
    assert_null(strstr(thermal_describe(thermal), "iwlwifi"));
    assert_null(strstr(thermal_describe(thermal), "cpufreq-cpu0 and cpufreq-cpu0"));
    struct thermal_reading reading = thermal_read(thermal, 0);
    assert_celsius(reading, 74);
    assert_string_equal(reading.zone, "bigcore0-thermal");
    assert_true(reading.throttled);
    thermal_destroy(thermal);
}

static void files_are_read_once_a_second(void **state)
{
    put_zone(*state, 0, "cpu-thermal\n", "50000\n");
    struct thermal *thermal = thermal_create(*state);
    assert_celsius(thermal_read(thermal, 10 * SECOND), 50);
    put_zone(*state, 0, "cpu-thermal\n", "60000\n");
    assert_celsius(thermal_read(thermal, 11 * SECOND - 1), 50);
    assert_celsius(thermal_read(thermal, 11 * SECOND), 60);
    thermal_destroy(thermal);
}

static void nonsense_is_not_a_temperature(void **state)
{
    static const char *const texts[] = {"",         "\n",    "0\n",         "-274000\n",
                                        "255000\n", "hot\n", "50000 hot\n", "999999999999\n"};
    put_zone(*state, 0, "gpu-thermal\n", "40000\n");
    put_zone(*state, 1, "cpu-thermal\n", "50000\n");
    struct thermal *thermal = thermal_create(*state);
    for (int i = 0; i < 8; i++) {
        put_zone(*state, 1, "cpu-thermal\n", texts[i]);
        assert_celsius(thermal_read(thermal, i * SECOND), 40); /* the other one */
    }
    put_zone(*state, 0, "gpu-thermal\n", "");
    assert_true(isnan(thermal_read(thermal, 20 * SECOND).celsius));
    thermal_destroy(thermal);
}

static void this_machine_can_be_asked(void **state)
{
    (void)state;
    struct thermal *thermal = thermal_create(NULL);
    struct thermal_reading reading = thermal_read(thermal, 0);
    assert_true(isnan(reading.celsius) || (reading.celsius > 0 && reading.celsius < 200));
    assert_true(isnan(reading.celsius) == (reading.zone[0] == '\0'));
    assert_int_not_equal(strlen(thermal_describe(thermal)), 0);
    thermal_destroy(thermal);
}

int main(void)
{
#define IN_ROOT(test) cmocka_unit_test_setup_teardown(test, make_root, remove_root)
    const struct CMUnitTest tests[] = {
        IN_ROOT(a_machine_that_tells_nothing),  IN_ROOT(a_raspberry_pi),
        IN_ROOT(a_board_with_many_zones),       IN_ROOT(files_are_read_once_a_second),
        IN_ROOT(nonsense_is_not_a_temperature), cmocka_unit_test(this_machine_can_be_asked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
