/* The files that an exhibit names: recorded sessions, and the folder of pictures. */
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "beneath.h"
#include "exhibit_read.h"

/* One byte more than is allowed, so that yaml_parse can tell. NULL: see `error`. */
static char *load(const char *folder, const char *path, size_t *size, char *error, size_t error_size)
{
    struct stat status;
    int fd = beneath_open(folder, path, "a session", error, error_size);
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
        snprintf(error, error_size, "'%.100s' %s; a session script", path,
                 !file   ? "is no file"
                 : !text ? "is too much: memory is short"
                         : "cannot be read");
        free(text);
        text = NULL;
    }
    close(fd);
    return text;
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

static struct script *read_script(struct reader *reader, const struct yaml_node *at, const char *path)
{
    char error[300] = "";
    size_t size = 0;
    struct report inner;
    struct script_def def = *reader->def;
    char *text = load(reader->folder, path, &size, error, sizeof error);
    char *folder = text ? folder_of(reader->folder, path) : NULL;
    struct script *script = NULL;
    def.raster_values_max -= reader->raster_values;
    report_init(&inner, path);
    if (!text) {
        reader_problem(reader, at, "%s", error);
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

static void read_session(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    static const struct key PATH = {
        .name = "", .type = KEY_TEXT, .unit = "the path of a session script", .min = 1, .max = EXHIBIT_PATH_BYTES};
    struct exhibit *exhibit = context;
    struct {
        const char *path;
    } session = {NULL};
    (void)index;
    if (value_read(reader, &PATH, item, &session)) {
        struct script *script = read_script(reader, item, session.path);
        if (script) {
            exhibit->sessions[exhibit->session_count] = session.path;
            exhibit->recorded[exhibit->session_count++] = script;
        }
    }
}

static bool is_picture(const char *name)
{
    static const char *const ENDS[] = {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".webp"};
    const char *end = strrchr(name, '.');
    for (size_t i = 0; end && end != name && i < sizeof ENDS / sizeof *ENDS; i++) {
        if (strcasecmp(end, ENDS[i]) == 0) {
            return true;
        }
    }
    return false;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* NULL, with a sentence in `error`, when there is no such folder. */
static DIR *open_folder(const char *folder, const char *path, char *error, size_t size)
{
    int fd = beneath_open(folder, path, "a folder", error, size);
    DIR *list = fd >= 0 ? fdopendir(fd) : NULL;
    if (fd >= 0 && !list) {
        snprintf(error, size, "'%.100s' is no folder; a folder in this file's folder or below", path);
        close(fd);
    }
    return list;
}

/* One more path; false when memory is short. */
static bool add(struct exhibit_pictures *pictures, int *room, const char *folder, const char *name)
{
    size_t size = strlen(folder) + strlen(name) + 2;
    if (pictures->count == *room) {
        int wanted = *room ? 2 * *room : 64;
        char **grown = realloc(pictures->paths, (size_t)wanted * sizeof *grown);
        if (!grown) {
            return false;
        }
        pictures->paths = grown;
        *room = wanted;
    }
    char *path = malloc(size);
    if (path) {
        snprintf(path, size, "%s/%s", folder, name);
        pictures->paths[pictures->count++] = path;
    }
    return path;
}

static struct exhibit_pictures list_pictures(DIR *list, const char *path)
{
    struct exhibit_pictures pictures = {0};
    int room = 0;
    for (struct dirent *entry = readdir(list); entry; entry = readdir(list)) {
        if (is_picture(entry->d_name) && !add(&pictures, &room, path, entry->d_name)) {
            break;
        }
    }
    if (pictures.count > 1) {
        qsort(pictures.paths, (size_t)pictures.count, sizeof *pictures.paths, by_name);
    }
    while (pictures.count > EXHIBIT_PICTURES) {
        free(pictures.paths[--pictures.count]);
        pictures.more++;
    }
    return pictures;
}

struct exhibit_pictures exhibit_pictures(const struct exhibit *exhibit)
{
    char error[300];
    struct exhibit_pictures pictures = {0};
    DIR *list = exhibit->pictures ? open_folder(exhibit->folder, exhibit->pictures, error, sizeof error) : NULL;
    if (list) {
        pictures = list_pictures(list, exhibit->pictures);
        closedir(list);
    }
    return pictures;
}

void exhibit_pictures_finish(struct exhibit_pictures *pictures)
{
    for (int i = 0; i < pictures->count; i++) {
        free(pictures->paths[i]);
    }
    free(pictures->paths);
    *pictures = (struct exhibit_pictures){0};
}

bool exhibit_is_bare(const struct exhibit *exhibit)
{
    char error[300];
    DIR *list = exhibit->pictures ? open_folder(exhibit->folder, exhibit->pictures, error, sizeof error) : NULL;
    if (!list) {
        return !exhibit->pictures;
    }
    struct exhibit_pictures pictures = list_pictures(list, exhibit->pictures);
    bool bare = pictures.count == 0;
    exhibit_pictures_finish(&pictures);
    closedir(list);
    return bare;
}

void exhibit_check_picture(struct reader *reader, const struct yaml_node *at, const char *path)
{
    char error[300] = "";
    struct script_picture picture = {0};
    if (!reader->def->load) {
        reader_problem(reader, at, "pictures cannot be read here");
    } else if (!reader->def->load(reader->def->data, reader->folder, path, &picture, error, sizeof error)) {
        reader_problem(reader, at, "%s", error);
    }
    free(picture.values);
}

static void check_pictures(struct reader *reader, const struct yaml_node *at, const char *path)
{
    char error[300];
    DIR *list = open_folder(reader->folder, path, error, sizeof error);
    if (!list) {
        reader_problem(reader, at, "%s", error);
        return;
    }
    struct exhibit_pictures pictures = list_pictures(list, path);
    if (pictures.more > 0) {
        reader_problem(reader, at, "%d pictures in '%.100s'; at most %d", pictures.count + pictures.more, path,
                       EXHIBIT_PICTURES);
    }
    for (int i = 0; i < pictures.count && !pictures.more && reader->def->every_picture && reader->def->load; i++) {
        exhibit_check_picture(reader, at, pictures.paths[i]);
    }
    exhibit_pictures_finish(&pictures);
    closedir(list);
}

void exhibit_read_files(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    inputs_list(reader, root, "sessions", EXHIBIT_SESSIONS, "a list of paths of session scripts", read_session,
                exhibit);
    if (exhibit->pictures) {
        size_t length = reader_enter(reader, "pictures");
        check_pictures(reader, yaml_get(root, "pictures"), exhibit->pictures);
        reader_leave(reader, length);
    }
}
