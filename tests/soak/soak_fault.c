#include "soak_fault.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "disk_case.h"

static const int64_t HOUR = 3600, DAY = 86400;
static const uint64_t SLEPT_US = 3600000000;

static void pull(struct soak *soak, enum soak_source source, bool begin)
{
    int device = 0; /* the one that is used most */
    if (soak->fakes[source]) {
        begin ? source_fake_leave(soak->fakes[source], device) : source_fake_arrive(soak->fakes[source], device);
    }
}

static void wrong_exhibit(struct soak *soak, bool begin)
{
    static const char *const WRONG[] = {"exhibit: 1\nvisti: {idle: 30}\n", "exhibit: 1\nvisit: {idle: [\n", "",
                                        "exhibit: 7\n", "exhibit: 1\nvisit: {idle: 1e9}\nscenes: []\n"};
    uint32_t which = soak_random(soak, 6);
    if (!begin) {
        soak_write_exhibit(soak, false);
    } else if (which == 5) {
        remove(soak->file);
    } else {
        soak_put(soak->file, WRONG[which], strlen(WRONG[which]));
    }
}

/* A picture with a stretch of noise in it, or cut short; and as it was. */
static void break_picture(struct soak *soak, const char *sample, const char *name, bool begin)
{
    char path[512], bytes[8192];
    snprintf(path, sizeof path, IMAGE_SAMPLES "/%s", sample);
    FILE *file = fopen(path, "rb");
    size_t size = file ? fread(bytes, 1, sizeof bytes, file) : 0;
    if (!file || fclose(file) != 0 || size < 64) {
        soak_fail(soak, "%s cannot be read", path);
        return;
    }
    for (size_t at = 30 + soak_random(soak, (uint32_t)size - 46), i = 0; begin && i < 16; i++) {
        bytes[at + i] = (char)soak_random(soak, 256);
    }
    if (begin && soak_random(soak, 2) == 0) {
        size = 12 + soak_random(soak, (uint32_t)size - 12);
    }
    snprintf(path, sizeof path, "%s/%s", soak->pictures, name);
    soak_put(path, bytes, size);
}

/* All but less than what the gallery leaves to others. */
static void fill_disk(struct soak *soak, bool begin)
{
    static char block[1 << 20];
    char path[100];
    snprintf(path, sizeof path, "%s/others", soak->disk);
    if (!begin) {
        remove(path);
        return;
    }
    FILE *file = fopen(path, "wb");
    memset(block, 1, sizeof block);
    int left = 64;
    while (file && left > 0 && fwrite(block, 1, sizeof block, file) == sizeof block) {
        left--;
    }
    if (file) {
        fclose(file);
    }
}

static void jump_wall(struct soak *soak, bool begin)
{
    static const int64_t JUMPS[] = {-1804075200, -400, 600, 365, -365, 12000, 1, -1}; /* to 1970; days */
    uint32_t which = soak_random(soak, 8);
    soak->wall_ahead_s = !begin ? 0 : which == 0 ? JUMPS[0] : JUMPS[which] * DAY;
}

static void heat_up(struct faults *faults, bool begin)
{
    char path[160];
    snprintf(path, sizeof path, "%s/sys/class/thermal/thermal_zone0/temp", faults->heat);
    soak_put(path, begin ? "86000\n" : "45000\n", 6);
}

static void edit(struct soak *soak, bool begin)
{
    if (begin) {
        soak->variant++;
        soak_write_exhibit(soak, soak->variant % 2 == 0);
    }
}

static void set_time(struct soak *soak, enum fault_kind kind, bool begin)
{
    if (kind == FAULT_CLOCK) {
        jump_wall(soak, begin);
    } else if (kind == FAULT_NIGHT) {
        soak->wall_ahead_s = begin ? 11 * HOUR : 0;
    } else {
        soak->ahead_us += begin ? SLEPT_US : 0;
    }
}

static void set(struct faults *faults, struct soak *soak, enum fault_kind kind, bool begin)
{
    switch (kind) {
    case FAULT_GLASS:
    case FAULT_PAD:
    case FAULT_LINES:
        pull(soak, (enum soak_source)(SOAK_TOUCH + (int)kind - (int)FAULT_GLASS), begin);
        break;
    case FAULT_INPUTS:
    case FAULT_EDIT:
        soak->inputs += begin && kind == FAULT_INPUTS;
        edit(soak, begin);
        break;
    case FAULT_WRONG:
        wrong_exhibit(soak, begin);
        break;
    case FAULT_PICTURE:
        break_picture(soak, "lossy.webp", "lossy.webp", begin);
        break;
    case FAULT_GUIDE:
        break_picture(soak, "rgb.png", "leaf.png", begin);
        break;
    case FAULT_FULL:
        fill_disk(soak, begin);
        break;
    case FAULT_LOCKED:
        disk_case_read_only(soak->disk, begin);
        break;
    case FAULT_RESET:
        if (begin) {
            display_inject_reset(soak->display);
        }
        break;
    case FAULT_HEAT:
        heat_up(faults, begin);
        break;
    default:
        set_time(soak, kind, begin);
        break;
    }
}

static const struct rhythm {
    const char *name;
    double every_s, lasts_s; /* on the average, and at most */
    enum fault_kind apart;   /* not at the same time as this one */
    bool disk;               /* of a disk that was mounted */
} rhythms[FAULT_KINDS] = {
    [FAULT_GLASS] = {"glass", 5, 0.5, FAULT_KINDS, false},    [FAULT_PAD] = {"pad", 4, 0.5, FAULT_KINDS, false},
    [FAULT_LINES] = {"lines", 6, 0.5, FAULT_KINDS, false},    [FAULT_EDIT] = {"edit", 9, 0, FAULT_WRONG, false},
    [FAULT_INPUTS] = {"inputs", 20, 0, FAULT_WRONG, false},   [FAULT_WRONG] = {"wrong", 17, 2, FAULT_KINDS, false},
    [FAULT_PICTURE] = {"picture", 15, 2, FAULT_KINDS, false}, [FAULT_GUIDE] = {"guide", 25, 2, FAULT_KINDS, false},
    [FAULT_FULL] = {"full disk", 20, 4, FAULT_LOCKED, true},  [FAULT_LOCKED] = {"locked disk", 25, 3, FAULT_FULL, true},
    [FAULT_RESET] = {"GPU reset", 15, 0, FAULT_KINDS, false}, [FAULT_CLOCK] = {"clock", 10, 3, FAULT_NIGHT, false},
    [FAULT_SLEEP] = {"sleep", 20, 0, FAULT_KINDS, false},     [FAULT_NIGHT] = {"night", 30, 2.5, FAULT_CLOCK, false},
    [FAULT_HEAT] = {"heat", 60, 30, FAULT_KINDS, false},
};

const char *fault_name(enum fault_kind kind)
{
    return rhythms[kind].name;
}

static double due(struct soak *soak, double now, double length_s)
{
    return now + length_s * (0.2 + 0.0016 * soak_random(soak, 1000));
}

bool faults_init(struct faults *faults, struct soak *soak, double pace, const char *only)
{
    static const char *const LEVELS[] = {"", "/sys", "/sys/class", "/sys/class/thermal",
                                         "/sys/class/thermal/thermal_zone0"};
    char path[200];
    bool good = true;
    *faults = (struct faults){.pace = pace};
    snprintf(faults->heat, sizeof faults->heat, "%s/board", soak->root);
    for (size_t i = 0; good && i < sizeof LEVELS / sizeof LEVELS[0]; i++) {
        snprintf(path, sizeof path, "%s%s", faults->heat, LEVELS[i]);
        good = mkdir(path, 0777) == 0;
    }
    snprintf(path, sizeof path, "%s/sys/class/thermal/thermal_zone0/type", faults->heat);
    good = good && soak_put(path, "cpu-thermal\n", 12);
    heat_up(faults, false);
    thermal_destroy(soak->live.care.thermal);
    soak->live.care.thermal = thermal_create(faults->heat);
    for (int i = 0; i < FAULT_KINDS; i++) {
        faults->fault[i].due_s =
            only && strcmp(only, rhythms[i].name) != 0 ? INFINITY : due(soak, 1, pace * rhythms[i].every_s);
    }
    return good && soak->live.care.thermal;
}

void faults_turn(struct faults *faults, struct soak *soak)
{
    double now = soak_s(soak);
    for (int i = 0; i < FAULT_KINDS; i++) {
        const struct rhythm *rhythm = &rhythms[i];
        struct fault *fault = &faults->fault[i];
        bool may = fault->is || (!faults->retired && (soak->disks || !rhythm->disk) &&
                                 (rhythm->apart == FAULT_KINDS || !faults->fault[rhythm->apart].is));
        if (!may || (now < fault->due_s && !(faults->retired && fault->is))) {
            continue;
        }
        fault->is = !fault->is;
        fault->count += fault->is;
        fault->due_s = due(soak, now, fault->is ? 0.55 * rhythm->lasts_s : faults->pace * rhythm->every_s);
        set(faults, soak, (enum fault_kind)i, fault->is);
    }
}

bool faults_over(const struct faults *faults)
{
    for (int i = 0; i < FAULT_KINDS; i++) {
        if (faults->fault[i].is) {
            return false;
        }
    }
    return true;
}

int faults_count(const struct faults *faults)
{
    int count = 0;
    for (int i = 0; i < FAULT_KINDS; i++) {
        count += faults->fault[i].count;
    }
    return count;
}
