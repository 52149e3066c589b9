/* A scene on the display that gives no more than a picture (live_drawer.h): what its `lay` puts over a painting, at the
 * cells of the sheet. What shines through is blended in sRGB. */
#ifndef FROND_LIVE_IMAGE_H
#define FROND_LIVE_IMAGE_H

#include "live_layer.h"
#include "overlay.h"

struct live_image {
    struct live_layer layer;
    struct overlay *overlay; /* two pieces; NULL: not made yet */
    int piece;               /* of what is shown; the other is of what goes */
};

void live_image_init(struct live_image *image, struct live_scene *scene, const struct shader_folder *folder);

#endif
