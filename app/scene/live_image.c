#include "live_image.h"

static void finish(struct live_layer *layer)
{
    struct live_image *image = (struct live_image *)layer;
    overlay_destroy(image->overlay);
    image->overlay = NULL;
}

static void let_go(struct live_layer *layer)
{
    struct live_image *image = (struct live_image *)layer;
    if (layer->leaves) {
        overlay_set(image->overlay, 1 - image->piece, NULL, 0, 0);
    }
}

static void leave(struct live_layer *layer)
{
    struct live_image *image = (struct live_image *)layer;
    image->piece = 1 - image->piece;
}

static bool set(struct live_layer *layer, bool fresh, struct display *display, struct shader_error *error)
{
    struct live_image *image = (struct live_image *)layer;
    const struct live_picture_view *view = &layer->newest->picture;
    (void)fresh, (void)display;
    if (!image->overlay && !(image->overlay = overlay_create(layer->drawer.folder, error))) {
        return false;
    }
    layer->shown = overlay_set(image->overlay, image->piece, view->rgba, view->width, view->height);
    return true;
}

static void present(struct live_layer *layer, bool gone, const struct live_scene_sheet *sheet, double share,
                    struct display *display)
{
    struct live_image *image = (struct live_image *)layer;
    struct display_size panel = display_panel(display), size = display_sheet(display);
    struct overlay_place place = {.width = (float)size.width, .height = (float)size.height};
    int piece = gone ? 1 - image->piece : image->piece;
    float turn[4];
    (void)sheet;
    display_turn(display, turn);
    overlay_place(image->overlay, 1 - piece, &place); /* the other one another time */
    place.opacity = live_fade_share(share);
    overlay_place(image->overlay, piece, &place);
    overlay_present(image->overlay, display_framebuffer(display), panel.width, panel.height, size.width, size.height,
                    turn);
}

/* RGBA over a picture of another size, by the nearest pixel. */
static void lay(const uint8_t *rgba, int columns, int rows, int width, int height, uint8_t *rgb)
{
    for (int y = 0; y < height; y++) {
        const uint8_t *row = rgba + 4 * (size_t)columns * (size_t)((int64_t)y * rows / height);
        for (int x = 0; x < width; x++, rgb += 3) {
            const uint8_t *over = row + 4 * (size_t)((int64_t)x * columns / width);
            for (int i = 0; i < 3; i++) {
                int sum = over[i] + (rgb[i] * (255 - over[3]) + 127) / 255;
                rgb[i] = (uint8_t)(sum < 255 ? sum : 255);
            }
        }
    }
}

static void reveal(const struct live_drawer *drawer, const struct live_scene_sheet *sheet, uint8_t *rgb, int width,
                   int height)
{
    const struct live_layer *layer = (const struct live_layer *)drawer;
    (void)sheet;
    if (layer->shown) {
        const struct live_picture_view *view = &layer->newest->picture;
        lay(view->rgba, view->width, view->height, width, height, rgb);
    }
}

void live_image_init(struct live_image *image, struct live_scene *scene, const struct shader_folder *folder)
{
    static const struct live_layer_type TYPE = {LIVE_LAYER(SHOW_PICTURE, reveal), set, leave, present, let_go, finish};
    *image = (struct live_image){.layer = {.drawer = {&TYPE.drawer, scene, folder}}};
}
