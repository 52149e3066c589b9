#include "gpio_bank.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <unistd.h>

#include "source_device.h"

/* ---- chips */

static uint32_t device_of(const char *path)
{
    const char *digits = path + strlen(path);
    while (digits > path && digits[-1] >= '0' && digits[-1] <= '9') {
        digits--;
    }
    return (uint32_t)strtoul(digits, NULL, 10) + 1;
}

static bool same_path(const char *wanted, const char *path)
{
    if (strcmp(wanted, path) == 0) {
        return true;
    }
    char *real = wanted[0] == '/' ? realpath(wanted, NULL) : NULL; /* a link of udev's */
    bool same = real && strcmp(real, path) == 0;
    free(real);
    return same;
}

static bool chip_matches(const struct bank_line *line, const struct bank_chip *chip)
{
    return line->chip[0] == '\0' || strcmp(line->chip, chip->info.label) == 0 ||
           strcmp(line->chip, chip->info.name) == 0 || same_path(line->chip, chip->path);
}

static void say_failed(const char *path, int code, char *text, size_t size)
{
    char reason[BANK_TROUBLE];
    device_explain(reason, sizeof reason, path, code,
                   "SUBSYSTEM==\"gpio\", KERNEL==\"gpiochip*\", GROUP=\"gpio\", MODE=\"0660\"");
    snprintf(text, size, "%.31s: %.120s", path, reason);
}

/* Its place; -1: `text` says why not. */
static int open_chip(struct gpio_bank *bank, const char *path, char *text, size_t size)
{
    int place = -1;
    for (int i = 0; i < BANK_CHIPS; i++) {
        if (bank->chips[i].chip && !bank->chips[i].left && strcmp(bank->chips[i].path, path) == 0) {
            return i;
        }
        if (!bank->chips[i].chip && !bank->chips[i].left && place < 0) {
            place = i;
        }
    }
    int code = EMFILE;
    struct gpio_chip *opened = place >= 0 ? bank->ops->open(bank->context, path, &code) : NULL;
    if (!opened) {
        say_failed(path, code, text, size);
        return -1;
    }
    struct bank_chip *chip = &bank->chips[place];
    *chip = (struct bank_chip){.chip = opened, .device = device_of(path)};
    snprintf(chip->path, sizeof chip->path, "%.63s", path);
    bank->ops->info(opened, &chip->info);
    return place;
}

static void close_unused(struct gpio_bank *bank)
{
    for (int i = 0; i < BANK_CHIPS; i++) {
        if (bank->chips[i].chip && bank->chips[i].held == 0) {
            bank->ops->close(bank->chips[i].chip);
            bank->chips[i].chip = NULL;
        }
    }
}

/* ---- taking lines */

/* "line 4 'BTN_OK' of gpiochip0" */
static void say_line(const struct bank_chip *chip, int offset, const char *name, char *text, size_t size)
{
    if (name[0]) {
        snprintf(text, size, "line %d '%.31s' of %.31s", offset, name, chip->info.name);
    } else {
        snprintf(text, size, "line %d of %.31s", offset, chip->info.name);
    }
}

static void say_refused(const struct bank_chip *chip, int offset, const struct gpio_line_info *info, int code,
                        char *text, size_t size)
{
    char which[100];
    say_line(chip, offset, info->name, which, sizeof which);
    if (code == EBUSY && info->consumer[0]) {
        snprintf(text, size, "%s is taken by '%.31s'", which, info->consumer);
    } else if (code == EBUSY) {
        snprintf(text, size, "%s is taken by another program or driver", which);
    } else if (code == ENXIO || code == ENOTTY || code == EOPNOTSUPP) {
        snprintf(text, size, "%.85s cannot do this: the chip reports no changes of it, or is read-only", which);
    } else {
        snprintf(text, size, "%.70s cannot be had: %.70s", which, strerror(code));
    }
}

static bool watch(struct gpio_bank *bank, int number)
{
    struct bank_line *line = &bank->lines[number];
    struct epoll_event want = {.events = EPOLLIN, .data.u32 = (uint32_t)number};
    return line->request.output || epoll_ctl(bank->epoll, EPOLL_CTL_ADD, bank->ops->fd(line->line), &want) == 0;
}

/* True: the line is held. Else `text` says why not. */
static bool take(struct gpio_bank *bank, int number, int place, int offset, char *text, size_t size)
{
    struct bank_line *line = &bank->lines[number];
    struct bank_chip *chip = &bank->chips[place];
    struct gpio_line_info info = {.used = false};
    int code = bank->ops->line_info(chip->chip, offset, &info), level = 0;
    if (code == 0) {
        line->line = bank->ops->request(chip->chip, offset, &line->request, &code);
    }
    if (line->line && !watch(bank, number)) {
        code = errno;
    } else if (line->line && !line->request.output) {
        level = bank->ops->get(line->line);
        code = level < 0 ? -level : 0;
    }
    if (code == EBUSY) { /* it may have been taken since */
        (void)bank->ops->line_info(chip->chip, offset, &info);
    }
    if (!line->line || code != 0) {
        say_refused(chip, offset, &info, code, text, size);
        if (line->line) {
            bank->ops->release(line->line);
            line->line = NULL;
        }
        return false;
    }
    line->place = place;
    line->found = offset;
    line->level = level > 0;
    line->fresh = true;
    line->stirred = !line->request.output; /* an edge may have come in between */
    chip->fresh |= chip->held == 0;
    chip->held++;
    return true;
}

/* What was found out about a line that is not held; the later the better. */
enum finding { NO_CHIP, DENIED, NO_LINE, REFUSED };

struct search {
    enum finding finding;
    char text[BANK_TROUBLE];
};

static void find_out(struct search *search, enum finding finding, const char *text)
{
    if (finding > search->finding) {
        search->finding = finding;
        snprintf(search->text, sizeof search->text, "%s", text);
    }
}

static void try_line(struct gpio_bank *bank, int number, int place, int offset, struct search *search)
{
    char text[BANK_TROUBLE];
    if (!take(bank, number, place, offset, text, sizeof text)) {
        find_out(search, REFUSED, text);
    }
}

/* Lines that are wanted by offset, and what can be said if the chip has no line of the name. */
static bool search_by_offset(struct gpio_bank *bank, int place, struct search *searches)
{
    const struct bank_chip *chip = &bank->chips[place];
    bool by_name = false;
    for (int i = 0; i < bank->count; i++) {
        const struct bank_line *line = &bank->lines[i];
        char text[BANK_TROUBLE];
        if (line->line || !chip_matches(line, chip)) {
            continue;
        }
        if (line->name[0]) {
            by_name = true;
            if (line->chip[0]) {
                snprintf(text, sizeof text, "%.31s has no line '%.31s'", chip->info.name, line->name);
                find_out(&searches[i], NO_LINE, text);
            }
        } else if (line->offset >= chip->info.lines) {
            snprintf(text, sizeof text, "%.31s has no line %d, only 0..%d", chip->info.name, line->offset,
                     chip->info.lines - 1);
            find_out(&searches[i], NO_LINE, text);
        } else {
            try_line(bank, i, place, line->offset, &searches[i]);
        }
    }
    return by_name;
}

static void search_by_name(struct gpio_bank *bank, int place, struct search *searches)
{
    const struct bank_chip *chip = &bank->chips[place];
    for (int offset = 0; offset < chip->info.lines; offset++) {
        struct gpio_line_info info;
        if (bank->ops->line_info(chip->chip, offset, &info) != 0) {
            return; /* it has just left */
        }
        for (int i = 0; info.name[0] && i < bank->count; i++) {
            const struct bank_line *line = &bank->lines[i];
            if (!line->line && strcmp(line->name, info.name) == 0 && chip_matches(line, chip)) {
                try_line(bank, i, place, offset, &searches[i]);
            }
        }
    }
}

/* Only what is new is logged, and what several lines suffer from only once. */
static void note_trouble(struct gpio_bank *bank, int number, const char *text)
{
    struct bank_line *line = &bank->lines[number];
    bool known = strcmp(line->trouble, text) == 0;
    for (int i = 0; i < bank->count; i++) {
        known |= strcmp(bank->lines[i].trouble, text) == 0;
    }
    snprintf(line->trouble, sizeof line->trouble, "%s", text);
    if (!known) {
        source_note(bank->queue, "%s waits: %s", line->title, text);
    }
}

static void say_missing(const struct bank_line *line, char *text, size_t size)
{
    if (line->chip[0]) {
        snprintf(text, size, "there is no GPIO chip '%s'", line->chip);
    } else {
        snprintf(text, size, "no GPIO chip has a line '%s'", line->name);
    }
}

static void note_findings(struct gpio_bank *bank, const struct search *searches)
{
    for (int i = 0; i < bank->count; i++) {
        struct bank_line *line = &bank->lines[i];
        if (!line->line) {
            note_trouble(bank, i, searches[i].text);
        } else if (line->trouble[0]) {
            line->trouble[0] = '\0';
            if (!bank->chips[line->place].fresh) { /* else it is said of the chip */
                source_note(bank->queue, "%s is there", line->title);
            }
        }
    }
}

static void take_missing(struct gpio_bank *bank)
{
    struct search searches[GPIO_LINES];
    char paths[BANK_CHIPS][GPIO_PATH], text[BANK_TROUBLE];
    for (int i = 0; i < bank->count; i++) {
        searches[i].finding = NO_CHIP;
        say_missing(&bank->lines[i], searches[i].text, sizeof searches[i].text);
    }
    int chips = bank->ops->scan(bank->context, paths, BANK_CHIPS);
    for (int c = 0; c < chips; c++) {
        int place = open_chip(bank, paths[c], text, sizeof text);
        if (place < 0) {
            for (int i = 0; i < bank->count; i++) {
                find_out(&searches[i], DENIED, text);
            }
        } else if (search_by_offset(bank, place, searches)) {
            search_by_name(bank, place, searches);
        }
    }
    close_unused(bank);
    note_findings(bank, searches);
}

/* ---- losing them */

static void let_go(struct gpio_bank *bank, struct bank_line *line)
{
    if (!line->request.output) {
        epoll_ctl(bank->epoll, EPOLL_CTL_DEL, bank->ops->fd(line->line), NULL);
    }
    bank->ops->release(line->line);
    line->line = NULL;
    bank->chips[line->place].held--;
}

void bank_lose(struct gpio_bank *bank, int number, int code)
{
    int place = bank->lines[number].place;
    struct bank_chip *chip = &bank->chips[place];
    source_note(bank->queue, "%s '%s' has left: %s", chip->info.name, chip->info.label,
                code == -ENODEV ? "it was removed" : strerror(-code));
    for (int i = 0; i < bank->count; i++) {
        struct bank_line *line = &bank->lines[i];
        if (line->line && line->place == place) {
            let_go(bank, line);
            line->lost |= !line->fresh; /* one that is fresh nobody has seen yet */
            line->fresh = false;
            say_missing(line, line->trouble, sizeof line->trouble); /* the log knows */
        }
    }
    bank->ops->close(chip->chip);
    chip->chip = NULL;
    chip->left = !chip->fresh;
    chip->fresh = false;
}

void bank_forget(struct gpio_bank *bank)
{
    for (int i = 0; i < BANK_CHIPS; i++) {
        bank->chips[i].left = false;
    }
}

/* ---- from time to time */

/* Whether the chip still answers, and whether an edge got lost. Not every chip can read its outputs. */
static void check_line(struct gpio_bank *bank, int number)
{
    struct bank_line *line = &bank->lines[number];
    struct gpio_line_info info;
    if (!line->line) {
        return;
    }
    int value = line->request.output ? -bank->ops->line_info(bank->chips[line->place].chip, line->found, &info)
                                     : bank->ops->get(line->line);
    if (value < 0) {
        bank_lose(bank, number, value);
    } else if (!line->request.output) {
        line->stirred |= (value > 0) != line->level;
    }
}

void bank_check(struct gpio_bank *bank)
{
    bool missing = false, lost = false;
    for (int i = 0; i < bank->count; i++) {
        check_line(bank, i);
    }
    for (int i = 0; i < bank->count; i++) {
        missing |= !bank->lines[i].line;
        lost |= bank->lines[i].lost;
    }
    if (missing && !lost) { /* what was lost is let go of first, as on the chip that it was on */
        take_missing(bank);
    }
    bank->retry_us = bank->count > 0 ? bank->ops->now_us(bank->context) + BANK_RETRY_US : 0;
}

bool bank_start(struct gpio_bank *bank)
{
    bank->epoll = epoll_create1(EPOLL_CLOEXEC);
    return bank->epoll >= 0;
}

void bank_stop(struct gpio_bank *bank)
{
    for (int i = 0; i < bank->count; i++) {
        if (bank->lines[i].line) {
            let_go(bank, &bank->lines[i]);
        }
    }
    close_unused(bank);
    if (bank->epoll >= 0) {
        close(bank->epoll);
        bank->epoll = -1;
    }
}

/* ---- what there is */

static void describe(const struct gpio_bank *bank, const char *path, struct device *device)
{
    int code, place = -1;
    struct gpio_chip_info info = {.lines = 0};
    *device = (struct device){.id = device_of(path), .class = DEVICE_LINES};
    snprintf(device->path, sizeof device->path, "%.63s", path);
    struct gpio_chip *chip = bank->ops->open(bank->context, path, &code);
    if (!chip) {
        say_failed(path, code, device->trouble, sizeof device->trouble);
        return;
    }
    bank->ops->info(chip, &info);
    bank->ops->close(chip);
    snprintf(device->name, sizeof device->name, "%s", info.label);
    gpio_lines_port(info.name, device->port, sizeof device->port);
    for (int i = 0; i < BANK_CHIPS; i++) {
        if (bank->chips[i].chip && strcmp(bank->chips[i].path, path) == 0) {
            place = i;
        }
    }
    struct bank_chip found = {.info = info};
    snprintf(found.path, sizeof found.path, "%.63s", path);
    for (int i = 0; i < bank->count; i++) {
        const struct bank_line *line = &bank->lines[i];
        bool held = line->line && line->place == place;
        bool wanted = !line->line && line->chip[0] && chip_matches(line, &found);
        device->admitted |= held || wanted;
        if (wanted && !device->trouble[0]) {
            snprintf(device->trouble, sizeof device->trouble, "%s", line->trouble);
        }
    }
}

/* Chips, or lines of no chip in particular, that are wanted and not there: each once. */
static bool describe_missing(const struct gpio_bank *bank, const struct device *devices, int listed, int number,
                             struct device *device)
{
    const struct bank_line *line = &bank->lines[number];
    bool told = line->line != NULL;
    for (int i = 0; i < listed && !told; i++) {
        told = strcmp(devices[i].trouble, line->trouble) == 0 ||
               (line->chip[0] && (strcmp(devices[i].name, line->chip) == 0 || same_path(line->chip, devices[i].path) ||
                                  strcmp(devices[i].path + strlen("/dev/"), line->chip) == 0));
    }
    if (!told) {
        *device = (struct device){.class = DEVICE_LINES, .admitted = true};
        snprintf(device->name, sizeof device->name, "%s", line->chip[0] ? line->chip : line->name);
        snprintf(device->trouble, sizeof device->trouble, "%s", line->trouble);
    }
    return !told;
}

int bank_devices(const struct gpio_bank *bank, struct device *devices, int most)
{
    char paths[BANK_CHIPS][GPIO_PATH];
    struct device listed[BANK_CHIPS + GPIO_LINES];
    int count = bank->ops->scan(bank->context, paths, BANK_CHIPS);
    for (int c = 0; c < count; c++) {
        describe(bank, paths[c], &listed[c]);
    }
    for (int i = 0; i < bank->count; i++) {
        count += describe_missing(bank, listed, count, i, &listed[count]);
    }
    for (int i = 0; i < count && i < most; i++) {
        devices[i] = listed[i];
    }
    return count;
}

int bank_line_infos(const struct gpio_bank *bank, uint32_t device, struct gpio_line_info *lines, int most)
{
    char paths[BANK_CHIPS][GPIO_PATH];
    struct gpio_chip_info info = {.lines = 0};
    int code, chips = bank->ops->scan(bank->context, paths, BANK_CHIPS);
    for (int c = 0; c < chips; c++) {
        struct gpio_chip *chip = device_of(paths[c]) == device ? bank->ops->open(bank->context, paths[c], &code) : NULL;
        if (!chip) {
            continue;
        }
        bank->ops->info(chip, &info);
        for (int i = 0; i < info.lines && i < most; i++) {
            lines[i] = (struct gpio_line_info){.used = false};
            (void)bank->ops->line_info(chip, i, &lines[i]);
        }
        bank->ops->close(chip);
        return info.lines;
    }
    return 0;
}
