#include "video.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "feed.h"

enum { ARGUMENTS = 48, PATH = 4096 };

struct video {
    struct feed *feed;
    size_t bytes; /* of a picture */
    char path[PATH], part[PATH];
};

/* Good enough for a wall, and played by everything: H.264 in MP4, VP9 in WebM. */
static const struct {
    const char *ending;
    const char *codec[10];
} FORMATS[] = {
    {".mp4", {"-c:v", "libx264", "-preset", "medium", "-crf", "17", "-movflags", "+faststart", NULL}},
    {".webm", {"-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "24", "-row-mt", "1", NULL}},
};

static const char FILTER[] =
    "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=in_range=full:out_range=tv:out_color_matrix=bt709:"
    "flags=accurate_rnd+full_chroma_int,format=yuv420p";

static int find_format(const char *path)
{
    size_t length = strlen(path);
    for (int i = 0; i < (int)(sizeof FORMATS / sizeof FORMATS[0]); i++) {
        size_t ending = strlen(FORMATS[i].ending);
        if (length > ending && strcmp(path + length - ending, FORMATS[i].ending) == 0) {
            return i;
        }
    }
    return -1;
}

bool video_name(const char *path, struct file_error *error)
{
    return find_format(path) >= 0 || file_fail(error, path, "the name of a film ends in .mp4 or .webm");
}

/* What ffmpeg is told. Sides are made even, for colour has half of them; sRGB is said to be BT.709 with its own curve,
 * so that a player shows the colours of the pictures. */
static void order(const struct video *video, int format, const char *size, const char *rate, char *arguments[ARGUMENTS])
{
    static const char *const input[] = {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y",
                                        "-f",     "rawvideo", "-pix_fmt",     "rgb24",     NULL};
    static const char *const filter[] = {
        "-an",   "-vf",        FILTER,         "-colorspace",  "bt709", "-color_primaries",
        "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv",    NULL};
    int count = 0;
    for (int i = 0; input[i]; i++) {
        arguments[count++] = (char *)(uintptr_t)input[i];
    }
    const char *const middle[] = {"-video_size", size, "-framerate", rate, "-i", "pipe:0", NULL};
    for (int i = 0; middle[i]; i++) {
        arguments[count++] = (char *)(uintptr_t)middle[i];
    }
    for (int i = 0; filter[i]; i++) {
        arguments[count++] = (char *)(uintptr_t)filter[i];
    }
    for (int i = 0; FORMATS[format].codec[i]; i++) {
        arguments[count++] = (char *)(uintptr_t)FORMATS[format].codec[i];
    }
    arguments[count++] = (char *)(uintptr_t)video->part;
    arguments[count] = NULL;
}

struct video *video_open(const char *path, int width, int height, struct file_error *error)
{
    char size[32], rate[16], *arguments[ARGUMENTS];
    int format = find_format(path);
    if (format < 0) {
        video_name(path, error);
        return NULL;
    }
    struct video *video = calloc(1, sizeof *video);
    int length = video ? snprintf(video->path, sizeof video->path, "%s", path) : 0;
    /* A name that ffmpeg takes for a file, whatever it begins with. */
    int whole = video ? snprintf(video->part, sizeof video->part, "file:%s.part%s", path, FORMATS[format].ending) : 0;
    if (!video || length >= (int)sizeof video->path || whole >= (int)sizeof video->part) {
        file_fail(error, path, video ? "the name is too long" : "not enough memory");
        free(video);
        return NULL;
    }
    video->bytes = (size_t)width * (size_t)height * 3;
    snprintf(size, sizeof size, "%dx%d", width, height);
    snprintf(rate, sizeof rate, "%d", VIDEO_RATE);
    order(video, format, size, rate, arguments);
    video->feed = feed_open(arguments, error);
    if (!video->feed) {
        free(video);
        return NULL;
    }
    return video;
}

bool video_put(struct video *video, const uint8_t *rgb, struct file_error *error)
{
    return feed_put(video->feed, rgb, video->bytes) || file_fail(error, video->path, "ffmpeg has ended early");
}

bool video_close(struct video *video, bool keep, struct file_error *error)
{
    if (!video) {
        return true;
    }
    const char *part = video->part + strlen("file:");
    bool good = feed_close(video->feed) || (keep && file_fail(error, video->path, "ffmpeg could not make the film"));
    if (!good || !keep) {
        unlink(part);
    } else if (rename(part, video->path) != 0) {
        good = file_fail_code(error, video->path, errno);
        unlink(part);
    }
    free(video);
    return good || !keep;
}
