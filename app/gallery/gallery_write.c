#include "gallery_write.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "image.h"
#include "plan.h"

enum { PATH_MOST = 4096, JOURNAL_MOST = 256 << 20 };

void gallery_work_finish(struct gallery_work *work)
{
    free(work->picture.rgb);
    free(work->picture.depth);
    if (work->journal >= 0) {
        close(work->journal);
    }
    *work = (struct gallery_work){.journal = -1};
}

static void path_of(const struct gallery_def *def, const char *stem, enum gallery_part part, char path[PATH_MOST])
{
    snprintf(path, PATH_MOST, "%s/%s%s", def->folder, stem, gallery_endings[part]);
}

static bool read_whole(int file, char *bytes, size_t size)
{
    size_t have = 0;
    while (have < size) {
        ssize_t count = pread(file, bytes + have, size - have, (off_t)have);
        if (count == 0) {
            errno = EIO; /* it was cut meanwhile */
        }
        if (count <= 0 && errno != EINTR) {
            return false;
        }
        have += count > 0 ? (size_t)count : 0;
    }
    return true;
}

static bool write_journal(const struct gallery_def *def, int journal, const char *stem, struct file_error *error)
{
    char path[PATH_MOST];
    struct stat status;
    path_of(def, stem, GALLERY_JOURNAL, path);
    if (fstat(journal, &status) != 0) {
        return file_fail_code(error, path, errno);
    }
    if (status.st_size > JOURNAL_MOST) {
        return file_fail(error, path, "is a journal of %lld MB: at most %d MB", (long long)status.st_size >> 20,
                         JOURNAL_MOST >> 20);
    }
    size_t size = (size_t)status.st_size;
    char *bytes = malloc(size + 1);
    if (!bytes) {
        return file_fail_code(error, path, ENOMEM);
    }
    bool good = read_whole(journal, bytes, size) ? file_write_atomic(path, bytes, size, error)
                                                 : file_fail_code(error, path, errno);
    free(bytes);
    return good;
}

static bool write_plan(const struct gallery_def *def, const struct gallery_picture *picture, const char *stem,
                       struct file_error *error)
{
    char path[PATH_MOST];
    size_t size;
    double paper = picture->paper_mm > 0 ? picture->paper_mm : PLAN_PAPER_MM;
    path_of(def, stem, GALLERY_SVG, path);
    char *text = plan_svg(picture->depth, picture->cells_x, picture->cells_y, paper, &size);
    bool good = text ? file_write_atomic(path, text, size, error) : file_fail_code(error, path, ENOMEM);
    free(text);
    return good;
}

static bool has_room(const struct gallery_def *def, struct file_error *error)
{
    struct statvfs disk;
    if (statvfs(def->folder, &disk) != 0) {
        return file_fail_code(error, def->folder, errno);
    }
    return (int64_t)disk.f_bavail * (int64_t)disk.f_frsize >= def->spare || file_fail_code(error, def->folder, ENOSPC);
}

bool gallery_write(const struct gallery_def *def, const struct gallery_work *work, const char *stem,
                   struct file_error *error)
{
    const struct gallery_picture *picture = &work->picture;
    struct image_def image = image_default_def();
    char path[PATH_MOST];
    image.helper = def->helper;
    if (!has_room(def, error)) {
        return false;
    }
    path_of(def, stem, GALLERY_PNG, path);
    bool good = (work->journal < 0 || write_journal(def, work->journal, stem, error)) &&
                (!picture->depth || write_plan(def, picture, stem, error)) &&
                image_write_png(path, picture->rgb, picture->width, picture->height, &image, error);
    if (!good) {
        gallery_remove(def->folder, stem, NULL);
    }
    return good;
}
