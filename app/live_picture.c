#include "live_picture.h"

#include <stdio.h>
#include <string.h>

#include "legend.h"
#include "picture_gpu.h"
#include "script_sheet.h"
#include "xray_gpu.h"

void live_picture_init(struct live_picture *picture, const struct script *script, bool xray,
                       const struct shader_folder *folder)
{
    *picture = (struct live_picture){.script = script, .folder = folder, .xray = xray};
    picture->stamp = shader_folder_stamp(folder);
}

void live_picture_finish(struct live_picture *picture, bool lost)
{
    picture_gpu_destroy(picture->picture, lost);
    xray_gpu_destroy(picture->layers, lost);
    picture->picture = NULL;
    picture->layers = NULL;
}
