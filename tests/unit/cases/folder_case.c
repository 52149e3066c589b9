#define _XOPEN_SOURCE 700 /* nftw */
#include "folder_case.h"

#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

bool folder_case_make(char path[FOLDER_CASE_PATH])
{
    snprintf(path, FOLDER_CASE_PATH, "/tmp/frond-test-XXXXXX");
    return mkdtemp(path);
}

static int remove_one(const char *path, const struct stat *status, int type, struct FTW *at)
{
    (void)status;
    (void)type;
    (void)at;
    return remove(path);
}

bool folder_case_remove(const char *path)
{
    return !path || !*path || nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS) == 0;
}

bool folder_case_put(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    bool good = file && fputs(text, file) >= 0;
    return file && fclose(file) == 0 && good;
}

int folder_case_enter(void **state)
{
    (void)state;
    char folder[FOLDER_CASE_PATH];
    return folder_case_make(folder) && chdir(folder) == 0 ? 0 : -1;
}

int folder_case_leave(void **state)
{
    (void)state;
    char folder[256];
    return getcwd(folder, sizeof folder) && chdir("/") == 0 && folder_case_remove(folder) ? 0 : -1;
}
