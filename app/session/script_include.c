#include "script_include.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "beneath.h"

/* One byte more than is allowed, so that yaml_parse can tell. NULL: see `error`. */
static char *load(const char *folder, const char *path, size_t *size, struct script_within *self,
                  struct file_error *error)
{
    struct stat status = {0};
    int fd = beneath_open(folder, path, "a session", error);
    if (fd < 0) {
        return NULL;
    }
    char *text = malloc(YAML_SIZE_MAX + 1);
    ssize_t got = 0;
    *size = 0;
    bool file = fstat(fd, &status) == 0 && S_ISREG(status.st_mode);
    do {
        got = file && text ? read(fd, text + *size, YAML_SIZE_MAX + 1 - *size) : 0;
        *size += got > 0 ? (size_t)got : 0;
    } while (got > 0 && *size < YAML_SIZE_MAX + 1);
    if (!file || !text || got < 0) {
        snprintf(error->text, sizeof error->text, "'%.100s' %s; a session script", path,
                 !file   ? "is no file"
                 : !text ? "is too much: memory is short"
                         : "cannot be read");
        free(text);
        text = NULL;
    }
    self->device = (uint64_t)status.st_dev;
    self->node = (uint64_t)status.st_ino;
    close(fd);
    return text;
}

static struct script_within root_of(const struct report *report)
{
    struct stat status = {0};
    bool found = report->file && stat(report->file, &status) == 0;
    return (struct script_within){.device = found ? (uint64_t)status.st_dev : 0,
                                  .node = found ? (uint64_t)status.st_ino : 0};
}

/* How deep a file is, or -1 where it is inside itself. */
static int depth_of(const struct script_within *self)
{
    int depth = 1;
    for (const struct script_within *outer = self->outer; outer; outer = outer->outer) {
        if (outer->node == self->node && outer->device == self->device) {
            return -1;
        }
        depth++;
    }
    return depth;
}

/* The folder of `path`, which is relative to `folder`; for the caller to free. */
static char *folder_of(const char *folder, const char *path)
{
    size_t size = strlen(folder) + strlen(path) + 2;
    char *whole = malloc(size), *result = NULL;
    if (whole) {
        snprintf(whole, size, "%s/%s", folder, path);
        result = script_folder(whole);
    }
    free(whole);
    return result;
}

static size_t values_of(const struct script *script)
{
    size_t values = 0;
    for (int i = 0; i < script->action_count; i++) {
        const struct action_raster *rasters[] = {&script->actions[i].formula, &script->actions[i].picture};
        for (int k = 0; k < 2; k++) {
            values += rasters[k]->values
                          ? (size_t)rasters[k]->width * (size_t)rasters[k]->height * (size_t)rasters[k]->channels
                          : 0;
        }
    }
    return values;
}

/* What is wrong with a session is told where the exhibit names it, with the place in the session's own file. */
static void pass_on(struct reader *reader, const struct yaml_node *at, const struct report *inner)
{
    for (int i = 0; i < inner->count; i++) {
        const struct problem *problem = &inner->problems[i];
        if (problem->line > 0) {
            reader_problem(reader, at, "%s:%d:%d: %s", inner->file, problem->line, problem->column, problem->text);
        } else {
            reader_problem(reader, at, "%s: %s", inner->file, problem->text);
        }
    }
    reader->report->dropped += inner->dropped;
}

struct script *script_include(struct reader *reader, const struct yaml_node *at, const char *path)
{
    struct file_error error;
    size_t size = 0;
    struct report inner;
    struct script_def def = *reader->def;
    struct script_within root = root_of(reader->report), self = {.outer = def.within ? def.within : &root};
    reader_names(reader, path);
    char *text = load(reader->folder, path, &size, &self, &error);
    int depth = text ? depth_of(&self) : 0;
    char *folder = text ? folder_of(reader->folder, path) : NULL;
    struct script *script = NULL;
    def.raster_values_max -= reader->raster_values;
    def.within = &self;
    def.spent = def.spent ? def.spent : &reader->spent;
    report_init(&inner, path);
    if (!text) {
        reader_problem(reader, at, "%s", error.text);
    } else if (depth < 0) {
        reader_problem(reader, at, "'%.100s' is inside itself; another session", path);
    } else if (depth > SCRIPT_DEPTH) {
        reader_problem(reader, at, "'%.100s' is %d deep in other sessions; at most %d", path, depth, SCRIPT_DEPTH);
    } else if (!folder) {
        reader_problem(reader, at, "memory is short");
    } else {
        script = script_parse(text, size, folder, &def, &inner);
        pass_on(reader, at, &inner);
    }
    if (script) {
        reader->raster_values += values_of(script);
    }
    report_finish(&inner);
    free(folder);
    free(text);
    return script;
}
