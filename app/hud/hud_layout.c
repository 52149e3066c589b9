#include "hud_layout.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static const float REACH_LOW = 380, REACH_HIGH = 1220, REACH_ACROSS = 600; /* mm: ADA 308.2.1, 308.2.2, reversed */
static const float LABELLED_SHARE = 0.18f, SHARE = 0.25f;                  /* of the zone, at most */
static const float LABELLED_WIDEST = 30;                                   /* mm of a button */
static const float LABELLED_NARROW = 23;                                   /* wider words take two lines */
static const float GROUP_GAP = 2.5f;                                       /* mm more between groups */

enum group { GROUP_INKS, GROUP_TOOLS, GROUP_CHOICES, GROUP_DEEDS, GROUP_OTHERS };
enum { FOLDS = 4 }; /* nothing, the others, tools too, inks too */

struct list {
    struct hud_button buttons[HUD_BUTTONS];
    enum group groups[HUD_BUTTONS];
    int count;
};

struct bounds {
    float left, top, right, bottom; /* pixels */
};

/* How the buttons of a list are set. */
struct grid {
    bool labelled, grouped;
    int labels;          /* lines of words */
    float target;        /* mm */
    int lines, rows;     /* across, along the strip */
    float width, height; /* of a button */
    float gap, along;    /* gap; the strip's length without its padding */
};

int hud_kind_of_scene(const struct hud *hud)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    int scene = hud->def.scene;
    return scene >= 0 && scene < exhibit->scene_count ? exhibit->scenes[scene].kind : SCENE_PAINTING;
}

int hud_inks(const struct hud *hud)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    int scene = hud->def.scene;
    const struct script *script = scene >= 0 && scene < exhibit->scene_count ? exhibit->scenes[scene].script : NULL;
    return script && exhibit->scenes[scene].kind == SCENE_PAINTING ? script->ink_count : 0;
}

const char *hud_label(const struct hud *hud, const struct hud_button *button, int *language)
{
    static const enum exhibit_text TEXTS_OF[HUD_KINDS] = {
        [HUD_UNDO] = TEXT_UNDO,       [HUD_REDO] = TEXT_REDO,         [HUD_FINISH] = TEXT_FINISH,
        [HUD_SEATED] = TEXT_SEATED,   [HUD_HAND] = TEXT_HAND,         [HUD_LANGUAGE] = TEXT_LANGUAGE,
        [HUD_PICTURE] = TEXT_PICTURE, [HUD_METAPHOR] = TEXT_METAPHOR,
    };
    *language = hud->language;
    switch (button->kind) {
    case HUD_TOOL:
        return words_of(hud->def.exhibit->texts, (enum exhibit_text)(TEXT_DROP + button->value), *language);
    case HUD_LANGUAGE:
        *language = button->value;
        break;
    case HUD_UNDO:
    case HUD_REDO:
    case HUD_FINISH:
    case HUD_PICTURE:
    case HUD_METAPHOR:
    case HUD_HAND:
    case HUD_SEATED:
        break;
    default:
        return "";
    }
    return words_of(hud->def.exhibit->texts, TEXTS_OF[button->kind], *language);
}

static void add(struct list *list, enum group group, enum hud_kind kind, int value)
{
    if (list->count < HUD_BUTTONS) {
        list->groups[list->count] = group;
        list->buttons[list->count++] = (struct hud_button){.kind = kind, .value = value};
    }
}

static void list_inks(const struct hud *hud, int panel, struct list *list)
{
    int inks = hud_inks(hud);
    for (int i = 0; i < inks && inks > 1 && hud->def.exhibit->seats[panel].ink < 0; i++) {
        add(list, GROUP_INKS, HUD_INK, i);
    }
}

static void list_tools(const struct hud *hud, struct list *list)
{
    const struct exhibit_palette *palette = &hud->def.exhibit->palette;
    int kind = hud_kind_of_scene(hud), first = (int)tool_first(kind);
    bool any = false;
    for (int i = first + 1; i < TOOLS; i++) {
        any = any || (tool_fits(i, kind) && palette->tools[i]);
    }
    for (int i = first; i < TOOLS && any; i++) {
        if (i == first || (tool_fits(i, kind) && palette->tools[i])) {
            add(list, GROUP_TOOLS, HUD_TOOL, i);
        }
    }
}

/* Whether there are several kinds of what grows or reacts. */
static bool has_kinds(const struct hud *hud)
{
    enum scene_kind kind = (enum scene_kind)hud_kind_of_scene(hud);
    const struct key *key = scene_options_keys(kind);
    while (key->name && !(key->type == KEY_CHOICE && scene_option_brings(kind, key))) {
        key++;
    }
    return key->name;
}

/* What grows, and over what. */
static void list_choices(const struct hud *hud, struct list *list)
{
    if (hud->def.exhibit->pictures && hud_kind_of_scene(hud) == SCENE_TREES) {
        add(list, GROUP_CHOICES, HUD_PICTURE, 0);
    }
    if (has_kinds(hud)) {
        add(list, GROUP_CHOICES, HUD_METAPHOR, 0);
    }
}

static void list_others(const struct hud *hud, struct list *list)
{
    const struct exhibit_palette *palette = &hud->def.exhibit->palette;
    if (palette->hand) {
        add(list, GROUP_OTHERS, HUD_HAND, 0);
    }
    if (palette->seated) {
        add(list, GROUP_OTHERS, HUD_SEATED, 0);
    }
    if (palette->language && hud->def.exhibit->language_count > 1) {
        add(list, GROUP_OTHERS, HUD_LANGUAGE, hud_next_language(hud));
    }
}

/* Puts one button in place of the last of a list from `from` on, if it is two or more. */
static void fold(struct list *list, int from, enum hud_kind kind, int value)
{
    if (list->count - from >= 2) {
        list->count = from;
        add(list, kind == HUD_MORE ? GROUP_DEEDS : GROUP_INKS, kind, value);
        list->buttons[from].folded = true;
    }
}

/* What a panel shows when so much is folded. */
static struct list list_all(const struct hud *hud, int panel, int folds)
{
    struct list list = {.count = 0};
    const struct exhibit_palette *palette = &hud->def.exhibit->palette;
    list_inks(hud, panel, &list);
    if (folds > 2) {
        fold(&list, 0, HUD_INK, hud->panels[panel].ink);
    }
    int from = list.count;
    list_tools(hud, &list);
    if (folds > 1) {
        fold(&list, from, HUD_TOOL, hud->panels[panel].tool);
    }
    from = list.count;
    list_choices(hud, &list);
    if (folds > 2) {
        fold(&list, from, HUD_PICTURE, 0);
    }
    if (palette->undo) {
        add(&list, GROUP_DEEDS, HUD_UNDO, 0);
        add(&list, GROUP_DEEDS, HUD_REDO, 0);
    }
    if (palette->finish) {
        add(&list, GROUP_DEEDS, HUD_FINISH, 0);
    }
    from = list.count;
    list_others(hud, &list);
    if (folds > 0) {
        fold(&list, from, HUD_MORE, 0);
    }
    return list;
}

/* What it shows while a group is open. */
static struct list list_open(const struct hud *hud, int panel)
{
    struct list list = {.count = 0};
    int open = hud->panels[panel].open;
    if (open == HUD_INK) {
        list_inks(hud, panel, &list);
    } else if (open == HUD_TOOL) {
        list_tools(hud, &list);
    } else if (open == HUD_PICTURE) {
        list_choices(hud, &list);
    } else if (open == HUD_MORE) {
        add(&list, GROUP_OTHERS, HUD_MORE, 0); /* the way back */
        list_others(hud, &list);
    }
    return list;
}

/* mm that a character takes, about: a guess, which needs no fonts. 0 within a character. */
static float guess_width(unsigned char c)
{
    return HUD_TEXT * (c == ' ' ? 0.3f : c < 0x80 ? 0.6f : c < 0xc0 ? 0 : c < 0xe2 ? 0.55f : 1.0f);
}

/* mm of a text in one line, and of the longer half where it is best broken in two: at a space, or anywhere between
 * characters that have the width of a square. */
static void guess_lines(const char *text, float *one, float *two)
{
    float all = 0, done = 0;
    for (const char *c = text; *c; c++) {
        all += guess_width((unsigned char)*c);
    }
    *one = *two = all;
    for (const char *c = text; *c; c++) {
        if (*c == ' ' || (c > text && (unsigned char)*c >= 0xe2)) {
            *two = fminf(*two, fmaxf(done, all - done));
        }
        done += guess_width((unsigned char)*c);
    }
}

/* How wide labelled buttons of a list are, mm, and how many lines of words they bear. */
static float guess_labels(const struct hud *hud, const struct list *list, int *lines)
{
    float widest = 0;
    *lines = 1;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < list->count; i++) {
            int language;
            float one, two;
            guess_lines(hud_label(hud, &list->buttons[i], &language), &one, &two);
            if (pass == 0) {
                widest = fmaxf(widest, one <= LABELLED_NARROW ? one : two);
            } else if (one > widest) {
                *lines = 2;
            }
        }
    }
    return fminf(widest + 2, LABELLED_WIDEST);
}

static struct bounds cut(struct bounds a, struct bounds b)
{
    return (struct bounds){fmaxf(a.left, b.left), fmaxf(a.top, b.top), fminf(a.right, b.right),
                           fminf(a.bottom, b.bottom)};
}

static struct bounds of_sheet(const struct hud *hud, const float zone[4])
{
    float width = (float)hud->def.width, height = (float)hud->def.height;
    return (struct bounds){zone[0] * width, zone[1] * height, zone[2] * width, zone[3] * height};
}

/* Whether at least one row of buttons finds room. */
static bool roomy(const struct hud *hud, struct bounds bounds)
{
    float least = (HUD_TARGET + 2 * (HUD_PAD + HUD_EDGE)) * hud->mm + 6; /* each of them rounded up */
    return bounds.right - bounds.left >= least && bounds.bottom - bounds.top >= least;
}

/* Of a zone, what hands reach from a wheelchair. Where a screen hangs so that nothing is, the nearest of it. */
static struct bounds reach(const struct hud *hud, struct bounds zone)
{
    const struct exhibit_display *display = &hud->def.exhibit->display;
    float height = (float)hud->def.height, mm = hud->mm;
    struct bounds near = zone;
    if (display->lying) {
        bool far = zone.bottom < height - mm && zone.top < mm; /* the seat is at the other side of the table */
        if (far) {
            near.bottom = fminf(zone.bottom, REACH_ACROSS * mm);
        } else if (zone.bottom >= height - mm) {
            near.top = fmaxf(zone.top, height - REACH_ACROSS * mm);
        }
        return near;
    }
    near.top = fmaxf(zone.top, height - (REACH_HIGH - display->floor) * mm);
    near.bottom = fminf(zone.bottom, height - (REACH_LOW - display->floor) * mm);
    if (roomy(hud, near)) {
        return near;
    }
    /* As near as can be: the lower end of what hangs too high, the upper end of what stands too low. */
    float least = (HUD_TARGET + 2 * (HUD_PAD + HUD_EDGE)) * mm + 6;
    near = zone;
    if (height - (REACH_HIGH - display->floor) * mm > 0.5f * (zone.top + zone.bottom)) {
        near.top = fmaxf(zone.top, zone.bottom - 2 * least);
    } else {
        near.bottom = fminf(zone.bottom, zone.top + 2 * least);
    }
    return near;
}

static struct bounds bounds_of(const struct hud *hud, int panel)
{
    const struct exhibit *exhibit = hud->def.exhibit;
    struct bounds zone = reach(hud, of_sheet(hud, exhibit->seats[panel].zone));
    if (hud->seated) {
        struct bounds seated = cut(zone, of_sheet(hud, exhibit->access.zone));
        zone = roomy(hud, seated) ? seated : zone;
    }
    return zone;
}

/* Rows that a list takes in so many lines; where groups begin a row, and how many more than one there are. */
static int count_rows(const struct list *list, const struct grid *grid, int *borders)
{
    int rows = 0, line = 0;
    *borders = 0;
    for (int i = 0; i < list->count; i++) {
        bool border = grid->grouped && i > 0 && list->groups[i] != list->groups[i - 1];
        if (i == 0 || border || line == grid->lines) {
            rows++;
            line = 0;
        }
        *borders += border;
        line++;
    }
    return rows;
}

/* The sizes of a grid; false where it is larger than the bounds or than its share of the zone. */
static bool size_grid(const struct hud *hud, int panel, const struct list *list, const struct bounds *bounds,
                      float share, struct grid *grid)
{
    const struct hud_panel *of = &hud->panels[panel];
    bool lies = of->side == SIDE_OF_BOTTOM;
    float mm = hud->mm, target = ceilf(grid->target * mm);
    int borders = 0;
    grid->gap = ceilf(HUD_GAP * mm);
    grid->width = grid->height = target;
    grid->labels = 0;
    if (grid->labelled) {
        grid->width = fmaxf(target, ceilf(guess_labels(hud, list, &grid->labels) * mm));
        grid->height = target + ceilf((HUD_LABEL + (float)(grid->labels - 1) * HUD_LINE) * mm);
    }
    grid->rows = count_rows(list, grid, &borders);
    float step = (lies ? grid->width : grid->height) + grid->gap;
    float line = (lies ? grid->height : grid->width) + grid->gap;
    grid->along = (float)grid->rows * step - grid->gap + (float)borders * ceilf(GROUP_GAP * mm);
    float across = (float)grid->lines * line - grid->gap;
    float pad = 2 * ceilf(HUD_PAD * mm), edge = 2 * ceilf(HUD_EDGE * mm);
    float width = (lies ? grid->along : across) + pad, height = (lies ? across : grid->along) + pad;
    struct bounds zone = of_sheet(hud, hud->def.exhibit->seats[panel].zone);
    float area = (zone.right - zone.left) * (zone.bottom - zone.top);
    return width + edge <= bounds->right - bounds->left && height + edge <= bounds->bottom - bounds->top &&
           width * height <= share * area;
}

/* Across and along the strip become places on the sheet. */
static void place_buttons(struct hud *hud, int panel, const struct list *list, const struct grid *grid)
{
    struct hud_panel *of = &hud->panels[panel];
    bool lies = of->side == SIDE_OF_BOTTOM;
    /* A right-to-left language begins at the right; so does a strip at the bottom for the other hand. */
    bool mirrored = words_languages[hud->language].from_right != (lies && of->swapped);
    float pad = ceilf(HUD_PAD * hud->mm), along = 0;
    int line = 0;
    for (int i = 0; i < list->count; i++) {
        bool border = grid->grouped && i > 0 && list->groups[i] != list->groups[i - 1];
        if (i > 0 && (border || line == grid->lines)) {
            along += (lies ? grid->width : grid->height) + grid->gap + (border ? ceilf(GROUP_GAP * hud->mm) : 0);
            line = 0;
        }
        struct hud_button *button = &of->buttons[i];
        *button = list->buttons[i];
        button->width = grid->width;
        button->height = grid->height;
        button->x = lies ? along : (float)line * (grid->width + grid->gap);
        button->y = lies ? (float)line * (grid->height + grid->gap) : along;
        if (mirrored) {
            button->x = of->width - 2 * pad - button->width - button->x;
        }
        button->x += of->x + pad;
        button->y += of->y + pad;
        line++;
    }
    of->count = list->count;
}

static void place_strip(struct hud *hud, int panel, const struct grid *grid, const struct bounds *bounds)
{
    struct hud_panel *of = &hud->panels[panel];
    bool lies = of->side == SIDE_OF_BOTTOM;
    float line = (lies ? grid->height : grid->width) + grid->gap, pad = 2 * ceilf(HUD_PAD * hud->mm);
    float across = (float)grid->lines * line - grid->gap + pad, edge = ceilf(HUD_EDGE * hud->mm);
    of->width = lies ? grid->along + pad : across;
    of->height = lies ? across : grid->along + pad;
    of->x = roundf(0.5f * (bounds->left + bounds->right - of->width));
    of->y = roundf(0.5f * (bounds->top + bounds->bottom - of->height));
    if (lies) {
        of->y = floorf(bounds->bottom) - edge - of->height;
    } else if (of->side == SIDE_OF_LEFT) {
        of->x = ceilf(bounds->left) + edge;
    } else {
        of->x = floorf(bounds->right) - edge - of->width;
    }
    of->labels = grid->labels;
    of->lines = grid->lines;
}

/* The first of the grids, by preference, that a list fits in. */
static bool find_grid(const struct hud *hud, int panel, const struct list *list, const struct bounds *bounds,
                      struct grid wanted, int lines, struct grid *grid)
{
    for (int line = 1; line <= lines; line++) {
        for (int grouped = 1; grouped >= 0; grouped--) {
            *grid = wanted;
            grid->grouped = grouped;
            grid->lines = line;
            if (size_grid(hud, panel, list, bounds, wanted.labelled ? LABELLED_SHARE : SHARE, grid)) {
                return true;
            }
        }
    }
    return false;
}

/* What a panel shows, folded so far. */
static struct list list_of(const struct hud *hud, int panel, int folds)
{
    return hud->panels[panel].open >= 0 ? list_open(hud, panel) : list_all(hud, panel, folds);
}

/* With words, without, then folded more and more; then with buttons that are smaller than the curator wants. */
static bool find_list(const struct hud *hud, int panel, const struct bounds *bounds, struct list *list,
                      struct grid *grid)
{
    int lines = hud->panels[panel].open >= 0 ? 3 : 2;
    struct grid wanted = {.labelled = true, .target = fmaxf(hud->def.exhibit->palette.target, HUD_TARGET)};
    *list = list_of(hud, panel, 0);
    if (find_grid(hud, panel, list, bounds, wanted, 2, grid)) {
        return true;
    }
    wanted.labelled = false;
    for (;;) {
        for (int folds = 0; folds < FOLDS; folds++) {
            *list = list_of(hud, panel, folds);
            if (find_grid(hud, panel, list, bounds, wanted, lines, grid)) {
                return true;
            }
        }
        if (wanted.target <= HUD_TARGET) {
            return false;
        }
        wanted.target = fmaxf(0.9f * wanted.target, HUD_TARGET);
    }
}

/* Where even the folded list finds no room in its share: as many lines as it takes, and so many buttons left out at
 * most. */
static bool squeeze(const struct hud *hud, int panel, const struct bounds *bounds, int most_left_out, struct list *list,
                    struct grid *grid)
{
    for (int left_out = 0; left_out <= most_left_out && list->count > 0; left_out++, list->count--) {
        for (int lines = 1; lines <= list->count; lines++) {
            *grid = (struct grid){.lines = lines, .target = HUD_TARGET};
            if (size_grid(hud, panel, list, bounds, 1, grid)) {
                return true;
            }
        }
    }
    return false;
}

static int side_of(const struct hud *hud, int panel)
{
    int side = hud->def.exhibit->seats[panel].side;
    if (hud->panels[panel].swapped && side == SIDE_OF_LEFT) {
        return SIDE_OF_RIGHT;
    }
    return hud->panels[panel].swapped && side == SIDE_OF_RIGHT ? SIDE_OF_LEFT : side;
}

void hud_layout_panel(struct hud *hud, int panel)
{
    struct hud_panel *of = &hud->panels[panel];
    of->side = side_of(hud, panel);
    of->count = 0;
    of->x = of->y = of->width = of->height = 0;
    if (of->side == SIDE_OF_NONE) {
        return;
    }
    struct bounds bounds = bounds_of(hud, panel);
    struct list list;
    struct grid grid;
    if (!find_list(hud, panel, &bounds, &list, &grid) && !squeeze(hud, panel, &bounds, 0, &list, &grid)) {
        bounds = of_sheet(hud, hud->def.exhibit->seats[panel].zone); /* out of reach is better than not there */
        if (!find_list(hud, panel, &bounds, &list, &grid)) {
            squeeze(hud, panel, &bounds, HUD_BUTTONS, &list, &grid);
        }
    }
    if (list.count > 0) {
        place_strip(hud, panel, &grid, &bounds);
        place_buttons(hud, panel, &list, &grid);
    }
}

void hud_layout_staff(struct hud *hud)
{
    float mm = hud->mm, gap = ceilf(2 * HUD_GAP * mm), edge = ceilf(6 * mm);
    float width = fminf(ceilf(60 * mm), 0.5f * ((float)hud->def.width - gap) - edge), height = ceilf(18 * mm);
    float y = floorf((float)hud->def.height - edge - height);
    float middle = 0.5f * (float)hud->def.width;
    hud->staff[0] = (struct hud_button){HUD_BACK, 0, false, floorf(middle - 0.5f * gap - width), y, width, height};
    hud->staff[1] = (struct hud_button){HUD_EXIT, 0, false, ceilf(middle + 0.5f * gap), y, width, height};
}
