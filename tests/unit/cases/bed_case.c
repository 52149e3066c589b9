#include "bed_case.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

static void permit(const char *path, unsigned mode)
{
    if (chmod(path, mode) != 0) {
        perror(path);
        abort();
    }
}

void bed_case_permit(UMockdevTestbed *bed, const char *name, int number, unsigned mode)
{
    char path[300];
    char *root = umockdev_testbed_get_root_dir(bed);
    snprintf(path, sizeof path, "%s/dev/%s%d", root, name, number);
    g_free(root);
    permit(path, mode);
}

void bed_case_open_to_all(UMockdevTestbed *bed, const char *name, int count)
{
    char path[300];
    char *root = umockdev_testbed_get_root_dir(bed);
    permit(root, 0777);
    for (int i = 0; i < count; i++) {
        snprintf(path, sizeof path, "%s/ioctl/dev/%s%d", root, name, i);
        permit(path, 0777);
    }
    g_free(root);
}
