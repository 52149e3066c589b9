#include "gpio_lines.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "source_queue.h"

/* The number of a node "gpiochip12"; -1: it is something else. */
static long chip_number(const char *name)
{
    static const char prefix[] = "gpiochip";
    size_t length = sizeof prefix - 1;
    if (strncmp(name, prefix, length) != 0 || name[length] < '0' || name[length] > '9') {
        return -1;
    }
    char *end;
    long number = strtol(name + length, &end, 10);
    return *end || end - name > 15 ? -1 : number;
}

int gpio_lines_scan(void *context, char (*paths)[GPIO_PATH], int most)
{
    (void)context;
    DIR *folder = opendir("/dev");
    if (!folder) {
        return 0;
    }
    long numbers[64], last = -1;
    int count = 0, listed = 0;
    for (const struct dirent *entry = readdir(folder); entry && count < 64; entry = readdir(folder)) {
        long number = chip_number(entry->d_name);
        if (number >= 0) {
            numbers[count++] = number;
        }
    }
    closedir(folder);
    for (; listed < count && listed < most; listed++) {
        long next = -1;
        for (int i = 0; i < count; i++) {
            if (numbers[i] > last && (next < 0 || numbers[i] < next)) {
                next = numbers[i];
            }
        }
        if (next < 0) {
            break;
        }
        snprintf(paths[listed], GPIO_PATH, "/dev/gpiochip%ld", next);
        last = next;
    }
    return listed;
}

uint64_t gpio_lines_now_us(void *context)
{
    (void)context;
    return source_now_us();
}

void gpio_lines_port(const char *name, char *port, int size)
{
    char link[GPIO_PATH + 32];
    snprintf(link, sizeof link, "/sys/bus/gpio/devices/%s", name);
    char *found = realpath(link, NULL);
    static const char prefix[] = "/sys/devices/";
    const char *start = found && strncmp(found, prefix, sizeof prefix - 1) == 0 ? found + sizeof prefix - 1 : "";
    const char *end = strrchr(start, '/'); /* before the chip's own folder, whose number may change */
    int length = end ? (int)(end - start) : 0;
    if (length >= size) { /* the end tells more than the start */
        start += length - (size - 1);
        length = size - 1;
    }
    snprintf(port, (size_t)size, "%.*s", length, start);
    free(found);
}
