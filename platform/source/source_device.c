#include "source_device.h"

#include <errno.h>
#include <grp.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

static bool contains(const char *text, const char *part)
{
    size_t length = strlen(part);
    for (; *text; text++) {
        if (strncasecmp(text, part, length) == 0) {
            return true;
        }
    }
    return length == 0;
}

bool device_matches(const struct device_match *match, uint16_t vendor, uint16_t product, const char *name)
{
    return (!match->vendor || match->vendor == vendor) && (!match->product || match->product == product) &&
           (!match->name || contains(name, match->name));
}

void device_clean_text(char *text)
{
    for (unsigned char *c = (unsigned char *)text; *c; c++) {
        bool c1 = c[0] == 0xc2 && c[1] >= 0x80 && c[1] < 0xa0; /* U+0080 to U+009F */
        if (*c < 0x20 || *c == 0x7f || c1) {
            c[c1] = '?';
            c[0] = '?';
        }
    }
}

void device_copy_text(char *to, size_t size, const char *from)
{
    snprintf(to, size, "%s", from ? from : "");
    device_clean_text(to);
}

void device_explain(char *text, size_t size, const char *path, int code, const char *rule)
{
    struct stat status;
    struct group group, *found = NULL;
    char names[1024];
    if (code != EACCES && code != EPERM) {
        snprintf(text, size, "cannot be opened: %s", strerror(code));
        return;
    }
    if (stat(path, &status) == 0 && status.st_gid != 0 && status.st_mode & S_IRGRP) {
        getgrgid_r(status.st_gid, &group, names, sizeof names, &found);
    }
    if (found) {
        snprintf(text, size, "no permission: Frond's user must be in the group '%.32s' (SupplementaryGroups=%.32s)",
                 found->gr_name, found->gr_name);
    } else {
        snprintf(text, size, "no permission; add the udev rule %s", rule);
    }
}
