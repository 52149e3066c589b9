/* What a visitor sees beside the painting, in each state of a visit, language, hand and on three screens, over a real
 * painting; compared, over plain grey, with kept pictures of a quarter of the size (tests/data/visit). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cairo.h>

#include "figure.h"
#include "hud_case.h"
#include "hud_draw.h"
#include "hud_map.h"
#include "hud_told.h"

enum { LANGUAGES = 4, QUARTER = 4, GAP = 8, LABEL = 18 }; /* columns; size of what is kept; pixels */

static const struct hud_screen SCREENS[] = {
    {"7 inches", 154, 86, 800, 448, false},
    {"22 inches upright", 273, 485, 720, 1280, false},
    {"24 inches", 530, 300, 1280, 724, false},
};
static const char *const SCREEN_FILES[] = {"7", "22-upright", "24"};

enum scene {
    TOUCH,
    INVITE,
    LEFT,
    RIGHT,
    BOTTOM,
    SCANNED,
    OPEN,
    TREES,
    STORM,
    DISH,
    MAP,
    COUNTDOWN,
    THANKS,
    CLOSED,
    STATUS,
    SCENES
};
static const char *const SCENE_NAMES[SCENES] = {
    [TOUCH] = "attract, a touch",
    [INVITE] = "attract",
    [LEFT] = "painting, left",
    [RIGHT] = "painting, other hand",
    [BOTTOM] = "painting, below",
    [SCANNED] = "one switch",
    [OPEN] = "a group opened",
    [COUNTDOWN] = "countdown",
    [TREES] = "trees",
    [STORM] = "lightning",
    [DISH] = "chemistry",
    [MAP] = "map",
    [THANKS] = "thanks",
    [CLOSED] = "closed soon",
    [STATUS] = "staff",
};
static const char STATUS_LINES[] = "exhibit\tconfig/exhibits/table.yaml\nstate\tpainting, 41 s\nvisits\t1284\n"
                                   "frames\t16.7 ms median, 17.1 ms p95\nengine\tgpu, 720x405\ntemperature\t61.5 C\n"
                                   "touch\tILITEK Multi-Touch-V5000\ncontrollers\t2\ngallery\t37 pictures, 212 MB\n"
                                   "open\tuntil 18:00\nuptime\t12 d 4 h\n"
                                   "problem\ttable.yaml:14:9: palette.target: 9 is too small; 15 to 60 mm are allowed";

/* What is laid over the painting. */
static void lay_over(cairo_t *cairo, const struct hud_image *image, double x, double y)
{
    if (!image->rgba) {
        return;
    }
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image->width, image->height);
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
        figure_stop("picture", "no memory");
    }
    unsigned char *pixels = cairo_image_surface_get_data(surface);
    int stride = cairo_image_surface_get_stride(surface);
    const uint8_t *p = image->rgba;
    for (int row = 0; row < image->height; row++) {
        for (int column = 0; column < image->width; column++, p += 4) {
            uint32_t pixel = (uint32_t)p[3] << 24 | (uint32_t)p[0] << 16 | (uint32_t)p[1] << 8 | p[2];
            memcpy(pixels + (ptrdiff_t)row * stride + (ptrdiff_t)column * 4, &pixel, sizeof pixel);
        }
    }
    cairo_surface_mark_dirty(surface);
    cairo_set_source_surface(cairo, surface, x, y);
    cairo_paint(cairo);
    cairo_surface_destroy(surface);
}

/* What was turned last, and the map. */
static void draw_beside(struct hud *hud, enum scene scene, struct hud_image *image, cairo_t *cairo)
{
    struct scene_options options = scene_options_default(SCENE_CHEMISTRY);
    options.chemistry.reaction.feed = 0.0367f;
    options.chemistry.reaction.kill = 0.0619f;
    hud_map_stand(hud, &options);
    if (scene == MAP) {
        hud_draw_map(hud, 0, image);
        lay_over(cairo, image, image->x, image->y);
    } else if (scene == STORM) {
        hud_tell(hud, key_find(storm_keys, "eta"), 3.25f, 0);
        hud_tell(hud, key_find(storm_keys, "kind"), BOLT_CORAL, 0);
    } else if (scene == DISH || scene == LEFT) {
        bool dish = scene == DISH;
        hud_tell(hud, dish ? key_find(dish_keys, "feed") : key_find(coefficient_keys, "s_max"), 0.0367f, 0);
    }
    if (hud->told_count > 0) {
        hud_draw_told(hud, 0, image);
        lay_over(cairo, image, image->x, image->y);
    }
}

static void draw_panel(struct hud *hud, enum scene scene, cairo_t *cairo)
{
    struct hud_image image = {.rgba = NULL};
    struct hud_press press;
    struct hud_panel *panel = &hud->panels[0];
    static const int TOOLS_CHOSEN[SCENES] = {
        [TREES] = TOOL_TEND, [STORM] = TOOL_STRIKE, [DISH] = TOOL_DOSE, [MAP] = TOOL_MAP, [RIGHT] = TOOL_BRUSH};
    panel->can_undo = true;
    hud_choose(hud, 0, TOOLS_CHOSEN[scene], scene == RIGHT ? 2 : 1);
    panel->scanned = scene == SCANNED ? panel->count / 2 : -1;
    for (int i = 0; i < panel->count && scene == OPEN; i++) {
        if (panel->buttons[i].folded && !hud_press(hud, 0, i, 0, &press)) {
            break;
        }
    }
    hud_draw_panel(hud, 0, &image);
    lay_over(cairo, &image, image.x, image.y);
    draw_beside(hud, scene, &image, cairo);
    hud_draw_cursor(hud, panel->ink, scene == SCANNED ? 0.6f : 0, &image);
    lay_over(cairo, &image, 0.55 * hud->def.width - 0.5 * image.width, 0.4 * hud->def.height - 0.5 * image.height);
    hud_draw_mark(hud, &image);
    lay_over(cairo, &image, image.x, image.y);
    hud_image_finish(&image);
}

/* A face, of two discs. */
static void show_picture(struct hud *hud)
{
    enum { SIDE = 96 };
    float values[SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        float x = (float)(i % SIDE) - 48, y = (float)(i / SIDE) - 44;
        float face = hypotf(x, 0.8f * y), hair = hypotf(x, y + 12);
        values[i] = face < 26 ? 0.7f - 0.01f * x : hair < 36 ? 0.05f : 0.35f;
    }
    hud_show_picture(hud, &(struct action_raster){values, SIDE, SIDE, 1});
}

static void draw_scene(const struct hud_screen *screen, enum scene scene, int language, cairo_t *cairo)
{
    struct hud_case place;
    struct hud hud;
    struct hud_image image = {.rgba = NULL};
    hud_case_init(&place, screen, scene == BOTTOM ? SIDE_OF_BOTTOM : SIDE_OF_LEFT);
    place.exhibit.scenes[0].kind = scene == TREES                  ? SCENE_TREES
                                   : scene == STORM                ? SCENE_LIGHTNING
                                   : scene == DISH || scene == MAP ? SCENE_CHEMISTRY
                                                                   : SCENE_PAINTING;
    place.exhibit.pictures = "pictures";
    struct hud_def def = hud_case_def(&place, screen);
    hud_init(&hud, &def);
    if (language > 0) {
        show_picture(&hud); /* in the first it is not read yet */
    }
    hud.language = language;
    hud.panels[0].swapped = scene == RIGHT;
    hud_layout(&hud);
    switch (scene) {
    case TOUCH:
    case INVITE:
        hud_draw_invite(&hud, scene == TOUCH ? 8 : 18, &image);
        break;
    case COUNTDOWN:
        hud_draw_countdown(&hud, 12, 0.8f, &image);
        break;
    case THANKS:
    case CLOSED:
        hud_draw_sentence(&hud, scene == THANKS ? TEXT_THANKS : TEXT_CLOSED, &image);
        break;
    case STATUS:
        hud_draw_status(&hud, STATUS_LINES, &image);
        break;
    default:
        draw_panel(&hud, scene, cairo);
        break;
    }
    lay_over(cairo, &image, image.x, image.y);
    hud_image_finish(&image);
}

/* What is shown, on the sheets that people look at. */
static void write_labels(cairo_t *cairo, const struct hud_screen *screen, int share)
{
    int width = screen->columns / share, height = screen->rows / share;
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_BOLD);
    cairo_set_font_size(cairo, 12);
    for (int i = 0; i < LANGUAGES * SCENES; i++) {
        char text[80];
        snprintf(text, sizeof text, "%s: %s", words_languages[i % LANGUAGES].tag, SCENE_NAMES[i / LANGUAGES]);
        int column = i % LANGUAGES, row = i / LANGUAGES;
        cairo_move_to(cairo, GAP + column * (width + GAP), GAP + LABEL - 5 + row * (height + GAP + LABEL));
        cairo_set_source_rgb(cairo, 1, 1, 1);
        cairo_show_text(cairo, text);
    }
}

/* A sheet of all scenes and languages at a share of their size. `ground`: the painting; NULL: plain grey. */
static cairo_surface_t *draw_sheet(const struct hud_screen *screen, cairo_surface_t *ground, int share)
{
    int width = screen->columns / share, height = screen->rows / share, label = ground ? LABEL : 0;
    cairo_surface_t *sheet = cairo_image_surface_create(CAIRO_FORMAT_RGB24, LANGUAGES * (width + GAP) + GAP,
                                                        SCENES * (height + GAP + label) + GAP);
    cairo_surface_t *full = cairo_image_surface_create(CAIRO_FORMAT_RGB24, screen->columns, screen->rows);
    cairo_t *cairo = cairo_create(sheet);
    if (cairo_status(cairo) != CAIRO_STATUS_SUCCESS || cairo_surface_status(full) != CAIRO_STATUS_SUCCESS) {
        figure_stop("sheet", "no memory");
    }
    cairo_set_source_rgb(cairo, 0.35, 0.35, 0.37);
    cairo_paint(cairo);
    for (int i = 0; i < LANGUAGES * SCENES; i++) {
        cairo_t *inner = cairo_create(full);
        cairo_set_source_rgb(inner, 0.72, 0.72, 0.72);
        cairo_paint(inner);
        if (ground) { /* as much of it as covers the screen */
            double across = (double)screen->columns / cairo_image_surface_get_width(ground);
            double down = (double)screen->rows / cairo_image_surface_get_height(ground);
            cairo_save(inner);
            cairo_scale(inner, fmax(across, down), fmax(across, down));
            cairo_set_source_surface(inner, ground, 0, 0);
            cairo_paint(inner);
            cairo_restore(inner);
        }
        draw_scene(screen, (enum scene)(i / LANGUAGES), i % LANGUAGES, inner);
        cairo_destroy(inner);
        cairo_save(cairo);
        int column = i % LANGUAGES, row = i / LANGUAGES;
        cairo_translate(cairo, GAP + column * (width + GAP), GAP + label + row * (height + GAP + label));
        cairo_rectangle(cairo, 0, 0, width, height);
        cairo_clip(cairo);
        cairo_scale(cairo, 1.0 / share, 1.0 / share);
        cairo_set_source_surface(cairo, full, 0, 0);
        cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_GOOD);
        cairo_paint(cairo);
        cairo_restore(cairo);
    }
    if (ground) {
        write_labels(cairo, screen, share);
    }
    cairo_destroy(cairo);
    cairo_surface_destroy(full);
    return sheet;
}

/* Mean over a window of pixels of the difference of two pictures, 0..255, a channel. */
static double window_difference(cairo_surface_t *a, cairo_surface_t *b, int x, int y, int side)
{
    const unsigned char *pixels[2] = {cairo_image_surface_get_data(a), cairo_image_surface_get_data(b)};
    int strides[2] = {cairo_image_surface_get_stride(a), cairo_image_surface_get_stride(b)};
    double most = 0;
    for (int channel = 0; channel < 3; channel++) {
        double sum = 0;
        for (int j = y; j < y + side; j++) {
            for (int i = x; i < x + side; i++) {
                uint32_t values[2];
                for (int k = 0; k < 2; k++) {
                    memcpy(&values[k], pixels[k] + (ptrdiff_t)j * strides[k] + (ptrdiff_t)i * 4, sizeof values[k]);
                }
                sum += (double)(values[0] >> 8 * channel & 255) - (double)(values[1] >> 8 * channel & 255);
            }
        }
        most = fmax(most, fabs(sum) / (side * side));
    }
    return most;
}

/* The largest difference within a cell of the sheet. A window is wide enough for a glyph that sits a fraction of a
 * pixel elsewhere, as another version of FreeType or Pango does, and small enough for a word that is missing. */
static double cell_difference(cairo_surface_t *a, cairo_surface_t *b, int x, int y, int width, int height)
{
    enum { WINDOW = 6, STEP = 2 };
    double most = 0;
    for (int j = 0; j + WINDOW <= height; j += STEP) {
        for (int i = 0; i + WINDOW <= width; i += STEP) {
            most = fmax(most, window_difference(a, b, x + i, y + j, WINDOW));
        }
    }
    return most;
}

static void compare(struct figure *figure, const struct hud_screen *screen, cairo_surface_t *now, const char *path)
{
    static const double TOLERANCE = 11;
    cairo_surface_t *kept = cairo_image_surface_create_from_png(path);
    if (!figure_check(figure, cairo_surface_status(kept) == CAIRO_STATUS_SUCCESS, "%s is kept: %s", path,
                      cairo_status_to_string(cairo_surface_status(kept)))) {
        cairo_surface_destroy(kept);
        return;
    }
    bool same = cairo_image_surface_get_width(kept) == cairo_image_surface_get_width(now) &&
                cairo_image_surface_get_height(kept) == cairo_image_surface_get_height(now);
    figure_check(figure, same, "%s: the sheet has the size of the kept one", screen->name);
    int width = screen->columns / QUARTER, height = screen->rows / QUARTER;
    for (int scene = 0; scene < SCENES && same; scene++) {
        double most = 0;
        int where = 0;
        for (int language = 0; language < LANGUAGES; language++) {
            double difference =
                cell_difference(kept, now, GAP + language * (width + GAP), GAP + scene * (height + GAP), width, height);
            where = difference > most ? language : where;
            most = fmax(most, difference);
        }
        figure_check(figure, most <= TOLERANCE, "%s, %s: as kept within %g of 255; most %.2f, in \"%s\"", screen->name,
                     SCENE_NAMES[scene], TOLERANCE, most, words_languages[where].tag);
    }
    cairo_surface_destroy(kept);
}

static void write_png(cairo_surface_t *sheet, const char *path)
{
    cairo_status_t status = cairo_surface_write_to_png(sheet, path);
    if (status != CAIRO_STATUS_SUCCESS) {
        figure_stop(path, cairo_status_to_string(status));
    }
}

void figure_visit(struct figure *figure)
{
    cairo_surface_t *ground = cairo_image_surface_create_from_png(FIGURES_PAINTING);
    if (cairo_surface_status(ground) != CAIRO_STATUS_SUCCESS) {
        figure_stop(FIGURES_PAINTING, cairo_status_to_string(cairo_surface_status(ground)));
    }
    for (size_t i = 0; i < sizeof SCREENS / sizeof SCREENS[0]; i++) {
        char path[4096];
        cairo_surface_t *sheet = draw_sheet(&SCREENS[i], ground, 2), *plain = draw_sheet(&SCREENS[i], NULL, QUARTER);
        snprintf(path, sizeof path, "%s/visit-%s.png", figure->out, SCREEN_FILES[i]);
        write_png(sheet, path);
        snprintf(path, sizeof path, "%s/%s.png", FIGURES_KEPT, SCREEN_FILES[i]);
        if (figure->keep) {
            write_png(plain, path);
        }
        compare(figure, &SCREENS[i], plain, path);
        cairo_surface_destroy(plain);
        cairo_surface_destroy(sheet);
    }
    cairo_surface_destroy(ground);
}
