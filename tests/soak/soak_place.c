#include "soak.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench.h"
#include "disk_case.h"
#include "kiosk_state.h"
#include "pictures.h"

enum {
    DISK_KB = 70 << 10, /* the gallery leaves 64 MB to others */
    REFRESH_MHZ = 60000,
    TICKS_PER_SECOND = 150,
    DEVICES = 2, /* of a source */
};

static const double SLOW_S = 0.5;
static const time_t NOON = 1804075200; /* 2027-03-03 12:00 UTC, a Wednesday */

static const char *const TITLES[] = {"Soak", "Another soak", "A third soak", "The soak that never ends"};

void soak_say(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    putchar('\n');
    fflush(stdout);
}

void soak_fail(struct soak *soak, const char *format, ...)
{
    va_list arguments;
    printf("FAILED at %.1f s: ", soak_s(soak));
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    putchar('\n');
    fflush(stdout);
    soak->failed = true;
}

static uint64_t now_us(void)
{
    return (uint64_t)(1e6 * bench_wall_s());
}

double soak_s(const struct soak *soak)
{
    return 1e-6 * (double)(now_us() - soak->began_us);
}

/* xorshift32, Marsaglia 2003. */
uint32_t soak_random(struct soak *soak, uint32_t below)
{
    soak->random ^= soak->random << 13;
    soak->random ^= soak->random >> 17;
    soak->random ^= soak->random << 5;
    return soak->random % below;
}

static uint64_t kiosk_us(void *context, uint64_t real_us)
{
    const struct soak *soak = context;
    return soak->began_us + SOAK_SPEED * (real_us - soak->began_us) + soak->ahead_us;
}

static time_t wall(void *context)
{
    const struct soak *soak = context;
    return NOON + (time_t)((int64_t)soak_s(soak) % 3600 + soak->wall_ahead_s);
}

bool soak_put(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    bool good = file && fwrite(bytes, 1, size, file) == size;
    return file && fclose(file) == 0 && good;
}

static int write_text(const struct soak *soak, char *text, size_t size)
{
    bool two = soak->variant % 3 == 1;
    return snprintf(text, size,
                    "exhibit: 1\n"
                    "title: {en: %s, fr: Trempage}\n"
                    "languages: [en, fr]\n"
                    "display: {width: 530}\n"
                    "sheet: {cells: 16384, rate: 10, seed: %d}\n"
                    "engine: cpu\n"
                    "scenes:\n"
                    "  - {id: leaf, inks: [cyan, magenta, ochre], guide: pictures/leaf.png}\n"
                    "  - {id: plain, inks: [turquoise, sienna, black]}\n"
                    "  - {id: garden, kind: trees, trees: {over: pictures/leaf.png, endpoints: 300}}\n"
                    "pictures: pictures\n"
                    "%s"
                    "inputs:\n"
                    "  controllers: [{id: pad, vendor: '1209', name: little}]\n"
                    "  gpio: {buttons: [{id: finish, line: FINISH}, {id: staff, line: STAFF}, {id: one, line: ONE}]}\n"
                    "  bindings:\n"
                    "    - {touch: press, drop: {}}\n"
                    "    - {touch: drag, brush_ink: {}}\n"
                    "    - {touch: press, plant: {}}\n"
                    "    - {usage: Button 1, controller: pad, pour: {radius: %d}}\n"
                    "    - {usage: Button 2, controller: pad, undo: {}}\n"
                    "    - {usage: Button 3, controller: pad, next_scene: {}}\n"
                    "    - {button: finish, finish: {}}\n"
                    "    - {button: staff, staff: {}}\n"
                    "    - {button: one, switch: {}}\n"
                    "access: {scan: 3}\n"
                    "visit: {idle: 5, countdown: 3, thanks: 1, wash: 1, attract: 20, next_scene: 2, hide: 0.5}\n"
                    "schedule: [{open: '09:00', close: '21:00'}]\n"
                    "gallery: {folder: gallery, pictures: %d, megabytes: %d}\n",
                    TITLES[soak->variant % 4], 1 + soak->variant,
                    two ? "seats:\n  - {zone: [0, 0, 0.5, 1], side: left}\n  - {zone: [0.5, 0, 1, 1], side: bottom}\n"
                        : "",
                    20 + soak->inputs, SOAK_PICTURES, SOAK_MEGABYTES);
}

void soak_write_exhibit(struct soak *soak, bool in_place)
{
    char text[4000], other[100];
    size_t length = (size_t)write_text(soak, text, sizeof text);
    snprintf(other, sizeof other, "%s.new", soak->file);
    bool good = soak_put(in_place ? soak->file : other, text, length) && (in_place || rename(other, soak->file) == 0);
    if (!good) {
        soak_fail(soak, "%s cannot be written: %s", soak->file, strerror(errno));
    }
}

static bool are_plugged_in(const struct sources *sources)
{
    const struct source *source = NULL;
    for (int i = 0; (source = sources_at(sources, i)); i++) {
        if (strcmp(source->ops->name, "fake") == 0) {
            return true;
        }
    }
    return false;
}

/* The devices that are not there, whenever the kiosk has begun with other inputs. */
static void plug_in(struct soak *soak)
{
    static const struct device devices[SOAK_SOURCES][DEVICES] = {
        {{.class = DEVICE_TOUCH, .name = "glass", .admitted = true},
         {.class = DEVICE_TOUCH, .name = "second glass", .admitted = true}},
        {{.class = DEVICE_CONTROLLER, .vendor = 0x1209, .name = "little pad", .admitted = true},
         {.class = DEVICE_CONTROLLER, .vendor = 0x1209, .name = "little other pad", .admitted = true}},
        {{.class = DEVICE_LINES, .name = "lines", .admitted = true}, {.class = DEVICE_LINES, .name = "more lines"}},
    };
    static const enum event_source kinds[SOAK_SOURCES] = {SOURCE_TOUCH, SOURCE_HID, SOURCE_GPIO};
    struct sources *sources = soak->live.input.sources;
    int fds[SOURCES_MAX];
    if (!sources || are_plugged_in(sources)) {
        return;
    }
    for (int i = 0; i < SOAK_SOURCES; i++) {
        struct device_error error = {""};
        soak->fakes[i] = source_fake_create(
            &(struct source_fake_def){.source = kinds[i], .devices = devices[i], .device_count = DEVICES}, &error);
        if (!soak->fakes[i] || !sources_add(sources, soak->fakes[i])) {
            soak_fail(soak, "a source cannot be added: %s", error.text);
            soak->fakes[i] = NULL;
        }
    }
    display_wake_on(soak->display, fds, sources_fds(sources, fds));
}

void soak_post(struct soak *soak, enum soak_source source, int device, const struct event *event)
{
    struct event own = *event;
    own.time_us = soak->event_us;
    if (soak->fakes[source]) {
        source_fake_post(soak->fakes[source], device, &own);
    }
}

static bool copy_sample(const char *sample, const char *folder, const char *name)
{
    char bytes[8192], path[512];
    snprintf(path, sizeof path, IMAGE_SAMPLES "/%s", sample);
    FILE *file = fopen(path, "rb");
    size_t size = file ? fread(bytes, 1, sizeof bytes, file) : 0;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return file && fclose(file) == 0 && size > 0 && soak_put(path, bytes, size);
}

static bool make_folders(struct soak *soak)
{
    if (!folder_case_make(soak->root)) {
        return false;
    }
    snprintf(soak->pictures, sizeof soak->pictures, "%s/pictures", soak->root);
    snprintf(soak->file, sizeof soak->file, "%s/soak.yaml", soak->root);
    snprintf(soak->disk, sizeof soak->disk, "%s/disk", soak->root);
    snprintf(soak->state, sizeof soak->state, "%s/state", soak->disk);
    bool made = mkdir(soak->pictures, 0777) == 0 && mkdir(soak->disk, 0777) == 0;
    soak->disks = made && disk_case_isolate() && disk_case_mount(soak->disk, DISK_KB);
    return made && mkdir(soak->state, 0777) == 0 && copy_sample("rgb.png", soak->pictures, "leaf.png") &&
           copy_sample("alpha.png", soak->pictures, "alpha.png") &&
           copy_sample("lossy.webp", soak->pictures, "lossy.webp");
}

static struct exhibit *read_exhibit(struct soak *soak)
{
    struct script_def def = script_default_def();
    struct report report;
    def.load = pictures_load;
    report_init(&report, soak->file);
    struct exhibit *exhibit = exhibit_read(soak->file, &def, &report);
    report_print(&report, stdout);
    report_finish(&report);
    return exhibit;
}

bool soak_open(struct soak *soak, uint32_t seed)
{
    struct display_def display_def = display_default_def();
    struct device_error error = {""};
    *soak = (struct soak){.random = seed ? seed : 1, .began_us = now_us()};
    setenv("TZ", "UTC", 1);
    if (!make_folders(soak)) {
        soak_say("%s: no folder for a soak: %s", soak->root, strerror(errno));
        return false;
    }
    soak_write_exhibit(soak, true);
    display_def.kind = DISPLAY_HEADLESS;
    display_def.width = SOAK_WIDTH;
    display_def.height = SOAK_HEIGHT;
    display_def.refresh_mhz = REFRESH_MHZ;
    soak->display = display_create(&display_def, &error);
    struct exhibit *exhibit = soak->display ? read_exhibit(soak) : NULL;
    if (!exhibit) {
        soak_say("%s", error.text);
        return false;
    }
    live_kiosk_fit(exhibit, SOAK_WIDTH, SOAK_HEIGHT);
    soak->def = live_default_def();
    soak->def.engine = ENGINE_CPU;
    soak->def.exhibit = exhibit;
    soak->def.state = soak->state;
    soak->def.ticks_per_second = TICKS_PER_SECOND;
    soak->def.clock = (struct live_clock){kiosk_us, wall, soak};
    bool good = live_open(&soak->live, exhibit->scenes[0].script, soak->display, &soak->def);
    if (good) {
        plug_in(soak);
    }
    return good;
}

static void count_refused(struct soak *soak)
{
    uint64_t refused = soak->live.input.refused;
    soak->refused += refused > soak->refused_before ? refused - soak->refused_before : 0;
    soak->refused_before = refused;
}

bool soak_turn(struct soak *soak)
{
    double from = bench_wall_s();
    bool good = live_turn(&soak->live);
    soak->turn_s = bench_wall_s() - from;
    soak->turn_most_s = soak->turn_s > soak->turn_most_s ? soak->turn_s : soak->turn_most_s;
    soak->turns++;
    soak->slow_turns += soak->turn_s > SLOW_S;
    count_refused(soak);
    plug_in(soak);
    struct kiosk *kiosk = soak->live.kiosk.kiosk;
    if (kiosk->leaves) { /* somebody was let into the staff's view, and out: frond.service would start it again */
        kiosk->leaves = false;
        soak->exits++;
    }
    if (!good) {
        soak_fail(soak, "the loop has ended");
    }
    return good && !live_over(&soak->live);
}

void soak_close(struct soak *soak)
{
    if (soak->display) {
        live_close(&soak->live);
        display_destroy(soak->display);
    }
    if (soak->disks) {
        disk_case_unmount(soak->disk);
    }
    folder_case_remove(soak->root);
}
