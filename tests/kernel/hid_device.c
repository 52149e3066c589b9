/* hid_device: a controller of the kernel's own, made through /dev/uhid.
 *
 *     hid_device SAMPLE NAME SERIAL        the descriptor is that of a sample of tests/unit
 *
 * Standard input: "in HEX..." sends a report, "storm N" sends N pairs of a press and a release of a gamepad's first
 * button at once, "quit" unplugs it. What is written to it is printed as "out HEX...". */
#include <fcntl.h>
#include <linux/input.h>
#include <linux/uhid.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "hid_samples.h"

static void put(int fd, const struct uhid_event *event)
{
    if (write(fd, event, sizeof *event) != (ssize_t)sizeof *event) {
        perror("hid_device: /dev/uhid");
        exit(1);
    }
}

static void create(int fd, char *argv[])
{
    struct uhid_event event = {.type = UHID_CREATE2};
    const struct hid_sample *sample = hid_sample(argv[1]);
    if (!sample) {
        fprintf(stderr, "hid_device: no sample is called %s\n", argv[1]);
        exit(2);
    }
    snprintf((char *)event.u.create2.name, sizeof event.u.create2.name, "%s", argv[2]);
    snprintf((char *)event.u.create2.uniq, sizeof event.u.create2.uniq, "%s", argv[3]);
    event.u.create2.bus = BUS_USB;
    event.u.create2.vendor = 0x1209;
    event.u.create2.product = 0x0001;
    event.u.create2.rd_size = (uint16_t)sample->size;
    memcpy(event.u.create2.rd_data, sample->bytes, sample->size);
    put(fd, &event);
}

static void send_report(int fd, const uint8_t *bytes, size_t size)
{
    struct uhid_event event = {.type = UHID_INPUT2};
    event.u.input2.size = (uint16_t)size;
    memcpy(event.u.input2.data, bytes, size);
    put(fd, &event);
}

static void send_hex(int fd, const char *text)
{
    uint8_t bytes[256];
    size_t size = 0;
    char *end;
    for (unsigned long value = strtoul(text, &end, 16); end != text && size < sizeof bytes;
         value = strtoul(text, &end, 16)) {
        bytes[size++] = (uint8_t)value;
        text = end;
    }
    send_report(fd, bytes, size);
}

static void storm(int fd, int pairs)
{
    for (int i = 0; i < 2 * pairs; i++) {
        uint8_t report[11] = {0};
        report[7] = i % 2 == 0;
        send_report(fd, report, sizeof report);
    }
}

static void hear_kernel(int fd)
{
    struct uhid_event event;
    if (read(fd, &event, sizeof event) <= 0) {
        return;
    }
    if (event.type == UHID_OUTPUT) {
        printf("out");
        for (unsigned i = 0; i < event.u.output.size; i++) {
            printf(" %02x", event.u.output.data[i]);
        }
        putchar('\n');
    } else if (event.type == UHID_OPEN || event.type == UHID_CLOSE) {
        puts(event.type == UHID_OPEN ? "opened" : "closed");
    }
}

int main(int argc, char *argv[])
{
    char line[1024];
    int fd = open("/dev/uhid", O_RDWR | O_CLOEXEC);
    if (argc != 4 || fd < 0) {
        perror(argc != 4 ? "hid_device SAMPLE NAME SERIAL" : "hid_device: /dev/uhid");
        return 2;
    }
    setvbuf(stdin, NULL, _IONBF, 0);
    setvbuf(stdout, NULL, _IOLBF, 0);
    create(fd, argv);
    struct pollfd pollers[] = {{.fd = fd, .events = POLLIN}, {.fd = STDIN_FILENO, .events = POLLIN}};
    while (poll(pollers, 2, -1) > 0) {
        if (pollers[0].revents) {
            hear_kernel(fd);
        }
        if (!pollers[1].revents) {
            continue;
        }
        if (!fgets(line, sizeof line, stdin) || strncmp(line, "quit", 4) == 0) {
            break;
        }
        if (strncmp(line, "in ", 3) == 0) {
            send_hex(fd, line + 3);
        } else if (strncmp(line, "storm ", 6) == 0) {
            storm(fd, (int)strtol(line + 6, NULL, 10));
        }
    }
    put(fd, &(struct uhid_event){.type = UHID_DESTROY});
    return 0;
}
