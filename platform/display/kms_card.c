#include "kms_card.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include "display_source.h"
#include "kms_ioctl.h"

enum { MAJOR = 226, CARDS = 64 }; /* numbers of the nodes: admin-guide/devices.txt of the kernel */

void kms_card_close(struct kms_card *card)
{
    if (card) {
        close(card->fd);
        free(card); /* the first member of what was allocated */
    }
}

/* NULL with errno. */
static struct kms_card *open_path(const char *path, bool legacy)
{
    struct kms_ioctl_card *device = calloc(1, sizeof *device);
    if (!device) {
        return NULL;
    }
    struct kms_card *card = &device->card;
    card->calls = &kms_ioctl_calls;
    card->fd = open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (card->fd < 0) {
        int code = errno;
        free(device);
        errno = code;
        return NULL;
    }
    snprintf(card->path, sizeof card->path, "%s", path);
    struct stat node;
    if (fstat(card->fd, &node) == 0 && major(node.st_rdev) == MAJOR && minor(node.st_rdev) < CARDS) {
        /* not that of a link in /dev/dri/by-path: sysfs goes by the name of the node */
        snprintf(card->path, sizeof card->path, "/dev/dri/card%u", minor(node.st_rdev));
    }
    card->atomic = !legacy && drmSetClientCap(card->fd, DRM_CLIENT_CAP_ATOMIC, 1) == 0;
    drmSetClientCap(card->fd, DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1);
    uint64_t value = 0;
    card->modifiers = drmGetCap(card->fd, DRM_CAP_ADDFB2_MODIFIERS, &value) == 0 && value != 0;
    drmVersionPtr version = drmGetVersion(card->fd);
    snprintf(card->driver, sizeof card->driver, "%s", version && version->name ? version->name : "unknown");
    drmFreeVersion(version);
    return card;
}

static struct kms_card *open_named(const char *path, const struct kms_wish *wish, bool legacy, struct kms_scan *scan,
                                   struct device_error *error)
{
    struct kms_card *card = open_path(path, legacy);
    if (!card) {
        device_fail(error, "%s: %s", path, strerror(errno));
        return NULL;
    }
    int code = card->calls->scan(card, true, scan);
    if (code != 0 || scan->connector_count == 0) {
        device_fail(error, "%s (%s): %s", path, card->driver,
                    code == 0 || code == EOPNOTSUPP ? "it has no connectors, it only renders" : strerror(code));
    } else if (kms_card_score(scan, wish) == 0) {
        char names[KMS_CONNECTORS * KMS_NAME];
        kms_connector_names(scan, names, sizeof names);
        device_fail(error, "%s (%s): it has no connector %s, but %.120s", path, card->driver,
                    wish->connector ? wish->connector : "for a screen", names);
    } else {
        return card;
    }
    kms_card_close(card);
    return NULL;
}

/* A card that is opened while nobody is master becomes it: those not taken are closed, and let go of it. */
static struct kms_card *open_best(const struct kms_wish *wish, bool legacy, struct kms_scan *scan,
                                  struct device_error *error)
{
    struct kms_card *best = NULL;
    int best_score = 0;
    struct device_error reasons = {""}, why;
    for (int number = 0; number < CARDS; number++) {
        char path[32];
        snprintf(path, sizeof path, "/dev/dri/card%d", number);
        if (access(path, F_OK) != 0) {
            continue;
        }
        struct kms_card *card = open_named(path, wish, legacy, scan, &why);
        int score = card ? kms_card_score(scan, wish) : 0;
        if (!card) {
            device_fail_too(&reasons, &why);
        }
        if (score > best_score) {
            kms_card_close(best);
            best = card;
            best_score = score;
        } else {
            kms_card_close(card);
        }
    }
    if (!best) {
        device_fail(error, "kms: %.280s", reasons.text[0] ? reasons.text : "no /dev/dri/card* on this machine");
    }
    return best;
}

struct kms_card *kms_card_open(const char *path, const struct kms_wish *wish, bool legacy, struct device_error *error)
{
    struct kms_scan *scan = calloc(1, sizeof *scan);
    if (!scan) {
        device_fail(error, "kms: memory is short");
        return NULL;
    }
    struct kms_card *card = NULL;
    struct device_error why;
    if (!path) {
        card = open_best(wish, legacy, scan, error);
    } else if (!(card = open_named(path, wish, legacy, scan, &why))) {
        device_fail(error, "kms: %.280s", why.text);
    }
    free(scan);
    return card;
}
