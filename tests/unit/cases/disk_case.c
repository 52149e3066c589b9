#define _GNU_SOURCE /* unshare */
#include "disk_case.h"

#include <sched.h>
#include <stdio.h>
#include <sys/mount.h>
#include <unistd.h>

static bool put(const char *path, const char *format, unsigned id)
{
    FILE *file = fopen(path, "w");
    bool good = file && fprintf(file, format, id) > 0;
    return file && fclose(file) == 0 && good;
}

/* As nobody in particular a process may be root of a namespace of its own. */
static bool become_root(void)
{
    unsigned user = getuid(), group = getgid();
    return unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0 && put("/proc/self/uid_map", "0 %u 1\n", user) &&
           put("/proc/self/setgroups", "deny\n", 0) && put("/proc/self/gid_map", "0 %u 1\n", group);
}

bool disk_case_isolate(void)
{
    return (unshare(CLONE_NEWNS) == 0 || become_root()) && mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL) == 0;
}

bool disk_case_mount(const char *folder, int kilobytes)
{
    char options[32];
    snprintf(options, sizeof options, "size=%dk", kilobytes);
    return mount("frond-test", folder, "tmpfs", MS_NOSUID | MS_NODEV | MS_NOEXEC, options) == 0;
}

bool disk_case_read_only(const char *folder, bool read_only)
{
    return mount(NULL, folder, NULL, MS_REMOUNT | (read_only ? MS_RDONLY : 0UL), NULL) == 0;
}

void disk_case_unmount(const char *folder)
{
    umount2(folder, MNT_DETACH);
}
