#define _XOPEN_SOURCE 700 /* nftw */
#include "folder_case.h"

#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static int remove_one(const char *path, const struct stat *status, int type, struct FTW *at)
{
    (void)status;
    (void)type;
    (void)at;
    return remove(path);
}

bool folder_case_remove(const char *folder)
{
    return nftw(folder, remove_one, 16, FTW_DEPTH | FTW_PHYS) == 0;
}

int folder_case_enter(void **state)
{
    (void)state;
    char folder[] = "/tmp/frond-case-XXXXXX";
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

int folder_case_leave(void **state)
{
    (void)state;
    char folder[256];
    return getcwd(folder, sizeof folder) && chdir("/") == 0 && folder_case_remove(folder) ? 0 : -1;
}
