/* Pictures into a film, by ffmpeg where it is installed. */
#ifndef FROND_VIDEO_H
#define FROND_VIDEO_H

#include <stdbool.h>
#include <stdint.h>

#include "file.h"

enum { VIDEO_RATE = 30 }; /* pictures a second */

struct video;

/* Begins a film of this size. Its name ends in .mp4 (H.264) or .webm (VP9). NULL with one line in `error`. */
struct video *video_open(const char *path, int width, int height, struct file_error *error);
/* One picture: width * height * 3 bytes, sRGB, from the top left. */
bool video_put(struct video *video, const uint8_t *rgb, struct file_error *error);
/* Ends it. Only now the file has its name; `keep` false, or a failure: nothing is left behind. Takes NULL (true). */
bool video_close(struct video *video, bool keep, struct file_error *error);
/* Whether a film can have this name; `error` says what names there are. */
bool video_name(const char *path, struct file_error *error);

#endif
