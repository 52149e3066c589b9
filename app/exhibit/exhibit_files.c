/* The files that an exhibit names: recorded sessions, and the folder of pictures. */
#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "beneath.h"
#include "exhibit_read.h"
#include "script_include.h"

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
        struct script *script = script_include(reader, item, session.path);
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
static DIR *open_folder(const char *folder, const char *path, struct file_error *error)
{
    int fd = beneath_open(folder, path, "a folder", error);
    DIR *list = fd >= 0 ? fdopendir(fd) : NULL;
    if (fd >= 0 && !list) {
        snprintf(error->text, sizeof error->text, "'%.100s' is no folder; a folder in this file's folder or below",
                 path);
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
    struct file_error error;
    struct exhibit_pictures pictures = {0};
    DIR *list = exhibit->pictures ? open_folder(exhibit->folder, exhibit->pictures, &error) : NULL;
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
    struct file_error error;
    DIR *list = exhibit->pictures ? open_folder(exhibit->folder, exhibit->pictures, &error) : NULL;
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
    struct file_error error;
    struct script_picture picture = {0};
    if (!reader->def->load) {
        reader_problem(reader, at, "pictures cannot be read here");
    } else if (!reader->def->load(reader->def->data, reader->folder, path, &picture, &error)) {
        reader_problem(reader, at, "%s", error.text);
    }
    free(picture.values);
}

static void check_pictures(struct reader *reader, const struct yaml_node *at, const char *path)
{
    struct file_error error;
    DIR *list = open_folder(reader->folder, path, &error);
    if (!list) {
        reader_problem(reader, at, "%s", error.text);
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
