#include <errno.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bolt_charge_text.h"
#include "bolt_order.h"
#include "command.h"
#include "easel.h"
#include "explain.h"
#include "ink.h"
#include "option.h"
#include "script_value.h"

static const char HELP[] =
    "usage: frond bolt [--kind KIND] -o FILE [OPTIONS]\n\n"
    "Grows lightning, coral, rivers and the like by Laplacian growth (Kim, Sewall, Sud and Lin).\n\n"
    "  -o, --output FILE          .png; .svg: a path for each branch; .obj, .ply: tubes. May be given again\n"
    "      --size WxH             pixels of what is written; default 1024x1024\n"
    "      --potential FILE.png   the potential as bands of colour (eq. 10)\n"
    "      --height FILE.png      the potential as heights, 16 bits: mountains, or what rivers and cracks cut\n"
    "      --frames DIR           a film of how it came\n"
    "      --stats FILE.json      particles, seconds, dimensions, branches, every parameter\n"
    "      --attractor CHARGE     it grows towards; may be given again\n"
    "      --repulsor CHARGE      it grows away from; may be given again. Either is\n"
    "                                 X,Y[,Z]             a point\n"
    "                                 line:X,Y/DX,DY      through a place, along a direction\n"
    "                                 plane:X,Y/DX,DY     through a place, upright on a direction\n"
    "                                 cylinder:X,Y/DX,DY/RADIUS\n"
    "                                 stroke:X,Y;X,Y;...  painted\n"
    "                             then :CHARGE in those of a particle, then ! if growth ends where it touches it\n"
    "      --seed-at X,Y[/X,Y]    where it begins, in the place of the kind's own; may be given again\n"
    "      --colour #RRGGBB       of branches; --core of their hot middle and of leaves, --ground behind them\n"
    "      --projection XYZ       which three of the axes x y z w v u are seen, of more than three dimensions\n"
    "      --help                 this\n\n"
    "Places are in cells from the middle of the picture, x right, y down, z away; --span says how many cells there\n"
    "are across it. Pictures lie over that span; what is above half of white's light is light. Defaults are those of\n"
    "the kind, of which there are:\n";

enum {
    ROWS_MAX = 96,
    FIRST_ROW = 1000,
    OUTPUT = 'o',
    SIZE = 256,
    POTENTIAL,
    HEIGHT,
    FRAMES,
    STATS,
    ATTRACTOR,
    REPULSOR,
    SEED_AT,
    COLOUR,
    CORE,
    GROUND,
    PROJECTION,
    HELP_ASKED
};

static const struct option OWN[] = {{"output", required_argument, NULL, OUTPUT},
                                    {"size", required_argument, NULL, SIZE},
                                    {"potential", required_argument, NULL, POTENTIAL},
                                    {"height", required_argument, NULL, HEIGHT},
                                    {"frames", required_argument, NULL, FRAMES},
                                    {"stats", required_argument, NULL, STATS},
                                    {"attractor", required_argument, NULL, ATTRACTOR},
                                    {"repulsor", required_argument, NULL, REPULSOR},
                                    {"seed-at", required_argument, NULL, SEED_AT},
                                    {"colour", required_argument, NULL, COLOUR},
                                    {"core", required_argument, NULL, CORE},
                                    {"ground", required_argument, NULL, GROUND},
                                    {"projection", required_argument, NULL, PROJECTION},
                                    {"help", no_argument, NULL, HELP_ASKED}};
enum { OWN_COUNT = sizeof OWN / sizeof *OWN };

/* The tables as one row of options. */
struct row {
    const struct key *key;
    size_t offset; /* of the struct that the table describes */
    bool own;      /* its default is the table's, not the kind's */
    bool plant;    /* of plants alone */
    int turn;      /* options are taken in this order: what others go by comes first */
    char name[32];
};

struct options {
    struct row rows[ROWS_MAX];
    int count;
    struct option listed[OWN_COUNT + ROWS_MAX + 1];
};

enum { TURNS = 3 };

/* Kind and size choose the preset; span and dimensions say what places mean. */
static int turn_of(const char *name)
{
    static const char *const NAMES[] = {"kind", "bare", "lsystem", "span", "dimensions"};
    for (int i = 0; i < 5; i++) {
        if (strcmp(name, NAMES[i]) == 0) {
            return i < 3 ? 0 : 1;
        }
    }
    return 2;
}

static bool is_listed(const struct options *options, const char *name)
{
    for (int i = 0; i < options->count; i++) {
        if (strcmp(options->rows[i].key->name, name) == 0) {
            return true;
        }
    }
    return false;
}

static void list_table(struct options *options, const struct key *keys, size_t offset)
{
    for (const struct key *key = keys; key->name; key++) {
        struct row *row = &options->rows[options->count];
        if (is_listed(options, key->name)) {
            continue;
        }
        *row = (struct row){.key = key,
                            .offset = offset,
                            .own = keys == bolt_order_keys,
                            .plant = keys == lsystem_keys,
                            .turn = turn_of(key->name)};
        snprintf(row->name, sizeof row->name, "%s", key->name);
        for (char *at = row->name; *at; at++) {
            if (*at == '_') {
                *at = '-';
            }
        }
        options->listed[OWN_COUNT + options->count] = (struct option){
            row->name, key->type == KEY_FLAG ? no_argument : required_argument, NULL, FIRST_ROW + options->count};
        options->count++;
    }
}

static void list_options(struct options *options)
{
    *options = (struct options){.count = 0};
    memcpy(options->listed, OWN, sizeof OWN);
    list_table(options, bolt_order_keys, 0);
    list_table(options, laplacian_keys, offsetof(struct bolt_order, bolt.growth));
    list_table(options, bolt_look_keys, offsetof(struct bolt_order, bolt.look));
    list_table(options, lsystem_keys, offsetof(struct bolt_order, plant.growth));
}

static void print_plants(void)
{
    printf("\nPlants (--lsystem):\n");
    for (int i = 0; i < LSYSTEM_KINDS; i++) {
        printf("      %-22s %s\n", lsystem_kind_names[i], lsystem_kind_meanings[i]);
    }
    printf("\nOf plants, which take --dimensions, --eta, --seed and --environment too:\n");
}

static void print_help(const struct options *options)
{
    fputs(HELP, stdout);
    for (int i = 0; i < BOLT_KINDS; i++) {
        printf("      %-22s %s\n", bolt_kind_names[i], bolt_kind_meanings[i]);
    }
    printf("\n");
    for (int i = 0; i < options->count; i++) {
        char range[1400], name[48];
        const struct row *row = &options->rows[i];
        if (row->plant && !options->rows[i - 1].plant) {
            print_plants();
        }
        const char *value = row->key->type == KEY_FLAG ? "" : row->key->type == KEY_PICTURE ? " PICTURE" : " VALUE";
        snprintf(name, sizeof name, "--%s%s", row->name, value);
        printf("      %-22s %s\n", name, row->key->meaning);
        if (row->key->type != KEY_FLAG && row->key->type != KEY_PICTURE) {
            printf("      %-22s %s\n", "",
                   row->own ? explain_range(row->key, range, sizeof range)
                            : value_allowed(row->key, range, sizeof range));
        }
    }
}

static bool wrong(const char *option, const char *found, const char *allowed)
{
    fprintf(stderr, "frond bolt: --%s: '%s' is not it; %s\n", option, found, allowed);
    return false;
}

static bool take_number(const struct key *key, const char *text, float *field)
{
    char *end = NULL;
    errno = 0;
    double number = strtod(text, &end);
    bool good = end != text && *end == '\0' && !errno && number >= key->min && number <= key->max;
    *field = good ? (float)number : *field;
    return good;
}

static void take_picture(struct bolt_order *order, const char *name, const char *path)
{
    for (int i = 0; i < BOLT_PICTURES; i++) {
        if (strcmp(bolt_picture_names[i], name) == 0) {
            order->pictures[i] = path;
        }
    }
}

/* One value into its field. Of a plant, what both tables have is the plant's. */
static bool take_value(struct bolt_order *order, const struct row *row, const char *text)
{
    const struct key *key = row->key, *own = key ? key_find(lsystem_keys, key->name) : NULL;
    size_t offset = row->offset;
    if (!key) {
        return false;
    }
    if (order->lsystem > 0 && own && offset == offsetof(struct bolt_order, bolt.growth)) {
        key = own;
        offset = offsetof(struct bolt_order, plant.growth);
    }
    void *field = (char *)order + offset + key->offset;
    char allowed[1200];
    bool good = true;
    if (row->plant && order->lsystem == 0) {
        return wrong(row->name, text, "it is of plants: --lsystem tree, vine, bush or fan");
    }
    if (key->type == KEY_FLAG) {
        *(bool *)field = true;
    } else if (key->type == KEY_CHOICE) {
        struct names names = names_of_choices(key->choices);
        int found = names_find(&names, text);
        good = found >= 0;
        memcpy(field, good ? &found : field, sizeof found);
    } else if (key->type == KEY_INTEGER) {
        good = option_whole(text, (long)key->min, (long)key->max, field);
    } else if (key->type == KEY_PICTURE) {
        take_picture(order, key->name, text);
    } else if (strcmp(key->name, "span") == 0) {
        float span = order->bolt.growth.span;
        good = take_number(key, text, &span);
        bolt_order_respan(order, span);
    } else {
        good = take_number(key, text, field);
    }
    order->bolt.growth.dimensions = order->lsystem > 0 ? order->plant.growth.dimensions : order->bolt.growth.dimensions;
    return good || wrong(row->name, text, value_allowed(key, allowed, sizeof allowed));
}

/* "#1f8fff": sRGB as people write it, linear as it is kept. */
static bool take_colour(const char *option, const char *text, float *linear)
{
    size_t digits = strspn(text[0] == '#' ? text + 1 : text, "0123456789abcdefABCDEF");
    if (text[0] != '#' || digits != 6 || text[7]) {
        return wrong(option, text, "#RRGGBB, each 00 to ff");
    }
    unsigned long value = strtoul(text + 1, NULL, 16);
    for (int c = 0; c < 3; c++) {
        linear[c] = ink_decode((float)(value >> (16 - 8 * c) & 255u) / 255);
    }
    return true;
}

static bool take_projection(struct bolt_order *order, const char *text)
{
    static const char AXES[] = "xyzwvu";
    int dimensions = order->bolt.growth.dimensions > 3 ? order->bolt.growth.dimensions : 3;
    for (int k = 0; k < 3; k++) {
        const char *found = text[k] ? strchr(AXES, text[k]) : NULL;
        if (!found || found - AXES >= dimensions || (k > 0 && strchr(text, text[k]) != text + k) || strlen(text) != 3) {
            char allowed[64];
            snprintf(allowed, sizeof allowed, "three different ones of %.*s", dimensions, AXES);
            return wrong("projection", text, allowed);
        }
        order->axes[k] = (int)(found - AXES);
    }
    return true;
}

static bool take_output(struct bolt_order *order, const char *path)
{
    static const char *const ENDINGS[] = {".png", ".svg", ".obj", ".ply"};
    const char *end = strrchr(path, '.');
    char allowed[64];
    bool known = false;
    for (int i = 0; i < 4; i++) {
        known = known || (end && strcmp(end, ENDINGS[i]) == 0);
    }
    if (!known) {
        return wrong("output", path, "a name that ends with .png, .svg, .obj or .ply");
    }
    if (order->output_count == BOLT_OUTPUTS) {
        snprintf(allowed, sizeof allowed, "no more than %d of them", BOLT_OUTPUTS);
        return wrong("output", path, allowed);
    }
    order->outputs[order->output_count++] = path;
    return true;
}

/* An option that no table has, in the last turn. */
static bool take_own(struct bolt_order *order, int option, bool *seeded)
{
    const char *problem = NULL;
    switch (option) {
    case OUTPUT:
        return take_output(order, optarg);
    case POTENTIAL:
        order->potential = optarg;
        return true;
    case HEIGHT:
        order->height_field = optarg;
        return true;
    case FRAMES:
        order->frames = optarg;
        return true;
    case STATS:
        order->stats = optarg;
        return true;
    case COLOUR:
        return take_colour("colour", optarg, order->bolt.look.colour);
    case CORE:
        return take_colour("core", optarg, order->bolt.look.core);
    case GROUND:
        return take_colour("ground", optarg, order->bolt.look.ground);
    case PROJECTION:
        return take_projection(order, optarg);
    case ATTRACTOR:
    case REPULSOR:
        problem = bolt_charge_take(order, optarg, option == ATTRACTOR);
        return !problem || wrong(option == ATTRACTOR ? "attractor" : "repulsor", optarg, problem);
    case SEED_AT:
        problem = bolt_seed_take(order, optarg, !*seeded);
        *seeded = true;
        return !problem || wrong("seed-at", optarg, problem);
    default:
        return true;
    }
}

static bool take_size(struct bolt_order *order, const char *text)
{
    char allowed[64];
    snprintf(allowed, sizeof allowed, "WxH, each 1 to %d pixels", BOLT_SIDE_MOST);
    return option_size(text, BOLT_SIDE_MOST, &order->width, &order->height) || wrong("size", text, allowed);
}

/* One pass over the options. -1: go on. */
static int take_options(struct bolt_order *order, int argc, char *argv[], const struct options *options, int turn)
{
    bool seeded = false;
    optind = 0;
    for (int option; (option = getopt_long(argc, argv, ":o:h", options->listed, NULL)) != -1;) {
        if (option == '?' || option == ':') {
            return option_usage("bolt", option, argv);
        }
        if (option == HELP_ASKED || option == 'h') {
            print_help(options);
            return EXIT_STATUS_GOOD;
        }
        bool good = true;
        if (option >= FIRST_ROW) {
            const struct row *row = &options->rows[option - FIRST_ROW];
            good = row->turn != turn || take_value(order, row, optarg);
        } else if (option == SIZE) {
            good = turn > 0 || take_size(order, optarg);
        } else if (turn == TURNS - 1) {
            good = take_own(order, option, &seeded);
        }
        if (!good) {
            return EXIT_STATUS_USAGE;
        }
    }
    return -1;
}

/* What can be known to fail before anything grows. -1: nothing. */
static int check(const struct bolt_order *order, int argc, char *argv[])
{
    struct file_error error;
    const char *const files[3] = {order->potential, order->height_field, order->stats};
    if (optind < argc) {
        fprintf(stderr, "frond bolt: '%s' is too much; see frond bolt --help\n", argv[optind]);
        return EXIT_STATUS_USAGE;
    }
    bool asked = order->output_count > 0 || order->frames, good = true;
    for (int i = 0; i < order->output_count && good; i++) {
        good = easel_check_file(order->outputs[i], &error);
    }
    for (int i = 0; i < 3 && good; i++) {
        asked = asked || files[i];
        good = !files[i] || easel_check_file(files[i], &error);
    }
    if (!asked) {
        fprintf(stderr, "frond bolt: nothing is asked for: -o FILE.png; see frond bolt --help\n");
        return EXIT_STATUS_USAGE;
    }
    if (!good || (order->frames && !file_make_folder(order->frames, &error))) {
        fprintf(stderr, "frond bolt: %s\n", error.text);
        return EXIT_STATUS_FAILED;
    }
    return -1;
}

int command_bolt(int argc, char *argv[])
{
    struct options options;
    struct bolt_order order = bolt_order_default();
    list_options(&options);
    int status = -1;
    for (int turn = 0; turn < TURNS && status < 0; turn++) {
        status = take_options(&order, argc, argv, &options, turn);
        if (turn == 0 && status < 0) {
            bolt_order_preset(&order);
        }
    }
    status = status < 0 ? check(&order, argc, argv) : status;
    struct file_error error;
    if (status < 0) {
        bool good = bolt_order_run(&order, &error);
        if (!good) {
            fprintf(stderr, "frond bolt: %s\n", error.text);
        }
        status = good ? EXIT_STATUS_GOOD : EXIT_STATUS_FAILED;
    }
    bolt_order_finish(&order);
    return status;
}
