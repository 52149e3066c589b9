/* figures [NAME...] [--out DIR] [--keep]: draws the contact sheets and checks what is on them.
 * Exit status: 0 all checks hold, 1 some do not, 2 usage, memory or files. */
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "figure.h"

static const struct figure_group GROUPS[] = {
    {"accept", "the default dendrite, four seeds, in every band", figure_accept},
    {"exponent", "figure 4: the exponent k", figure_exponent},
    {"diffusion", "figure 5: alpha_a and alpha_y", figure_diffusion},
    {"reaction", "figure 6: beta_a and beta_y", figure_reaction},
    {"noise", "figure 7: the noise", figure_noise},
    {"stencil", "figure 8: stencils, and other things that are no dendrites", figure_stencil},
    {"round", "rounder than the paper, eight seeds", figure_round},
    {"ink", "figure 9: plain pattern and flowing ink", figure_ink},
    {"seam", "neighbours keep apart, and merge in a flood", figure_seam},
    {"second", "figure 13: a second ink follows what was carved", figure_second},
    {"session", "figures 1 and 13: a whole session", figure_session},
    {"drawing", "figure 10: drawings and dendrites", figure_drawing},
    {"guidance", "figure 11: growth along a field", figure_guidance},
    {"mask", "figure 12: growth inside a shape", figure_mask},
    {"pour", "figure 14: growth inwards after pouring", figure_pour},
    {"edge", "hard, soft and ragged drops", figure_edge},
    {"wet", "solvent loosens dry ink", figure_wet},
    {"extent", "more solvent, larger dendrite", figure_extent},
    {"mass", "solvent and ink are conserved", figure_mass},
    {"random", "random actions leave sound fields", figure_random},
    {"brushes", "the six brushes", figure_brushes},
    {"margin", "growth over the edge of the sheet", figure_margin},
    {"rest", "a finished painting comes to rest", figure_rest},
    {"wash", "water washes a sheet", figure_wash},
    {"transition", "a sheet freezes over, or dries, and the next one comes", figure_transition},
    {"visit", "what a visitor sees, in every state, language, hand", figure_visit},
    {"vision", "palettes for colour-blind eyes", figure_vision},
    {"attract", "what the sheet paints by itself", figure_attract},
    {"history", "undo, redo and the time brush", figure_history},
    {"dendrites", "dendrites from pictures: metrics, endpoints, emphasis", figure_dendrites},
    {"metaphors", "ink, vine, lightning, winter, frost, cracks", figure_metaphors},
    {"trees", "trees, and pictures in trees", figure_trees},
    {"composites", "trees in landscapes", figure_composites},
    {"garden", "a picture grows live, from seeds, round hands", figure_garden},
    {"photographs", "dendrites from real photographs", figure_photographs},
    {"hidden", "real photographs in trees", figure_hidden},
    {"portrait", "a portrait as growing ink", figure_portrait},
    {"laplacian", "bolts, coral, attractors, masks, light", figure_laplacian},
    {"storm", "a strike over time, a coral with hands, rivers that keep clear", figure_storm},
    {"bolts", "every kind of Laplacian growth as it looks", figure_bolts},
    {"lsystem", "plants that bend to light, keep clear of walls, climb", figure_lsystem},
    {"light", "Laplacian growth as light, lines and bodies", figure_light},
    {"chemistry", "Gray-Scott: the figures of the article", figure_chemistry},
    {"classes", "Gray-Scott: Pearson's classes and the map of feed and kill", figure_classes},
    {"composition", "One scene as what another grows from", figure_composition},
    {"dish", "A dish: what visitors do to the chemistry", figure_dish},
    {"gpu", "the GPU engine grows the same dendrite", figure_gpu},
};
enum { GROUP_COUNT = sizeof GROUPS / sizeof GROUPS[0] };

bool figure_check(struct figure *figure, bool holds, const char *text, ...)
{
    va_list arguments;
    va_start(arguments, text);
    printf("%-5s%s: ", holds ? "ok" : "FAIL", figure->name);
    vprintf(text, arguments);
    putchar('\n');
    va_end(arguments);
    figure->checks++;
    figure->failures += !holds;
    return holds;
}

void figure_note(const struct figure *figure, const char *text, ...)
{
    va_list arguments;
    va_start(arguments, text);
    printf("     %s: ", figure->name);
    vprintf(text, arguments);
    putchar('\n');
    va_end(arguments);
}

void figure_stop(const char *what, const char *why)
{
    fprintf(stderr, "figures: %s: %s\n", what, why);
    exit(2);
}

static void print_help(void)
{
    puts("figures [NAME...] [--out DIR] [--keep]\n"
         "  Draws contact sheets (DIR/NAME.png, default " FIGURES_OUT ") and checks what is on them.\n"
         "  --keep: what is drawn of figure visit is what it is compared with from now on.\n"
         "  Without a name, all of them:");
    for (int i = 0; i < GROUP_COUNT; i++) {
        printf("    %-10s %s\n", GROUPS[i].name, GROUPS[i].meaning);
    }
}

static int find_group(const char *name)
{
    int group = 0;
    while (group < GROUP_COUNT && strcmp(GROUPS[group].name, name) != 0) {
        group++;
    }
    return group;
}

/* Marks the groups that are wanted; false after a complaint. */
static bool read_arguments(int count, char **arguments, bool *wanted, const char **out, bool *keep)
{
    bool any = false;
    for (int i = 1; i < count; i++) {
        if (strcmp(arguments[i], "--out") == 0) {
            if (++i == count) {
                fputs("figures: --out wants a folder\n", stderr);
                return false;
            }
            *out = arguments[i];
            continue;
        }
        if (strcmp(arguments[i], "--keep") == 0) {
            *keep = true;
            continue;
        }
        int group = find_group(arguments[i]);
        if (group == GROUP_COUNT) {
            fprintf(stderr, "figures: unknown figure %s; --help lists them\n", arguments[i]);
            return false;
        }
        wanted[group] = any = true;
    }
    for (int i = 0; i < GROUP_COUNT && !any; i++) {
        wanted[i] = true;
    }
    return true;
}

/* The folder and those above it. */
static void make_folder(const char *path)
{
    char *part = strdup(path);
    if (!part) {
        figure_stop("name of a folder", "no memory");
    }
    for (char *slash = part + 1; (slash = strchr(slash, '/')); *slash++ = '/') {
        *slash = '\0';
        (void)mkdir(part, 0777); /* that the last one is there is what counts */
    }
    if (mkdir(part, 0777) != 0 && errno != EEXIST) {
        figure_stop(part, strerror(errno));
    }
    free(part);
}

int main(int count, char **arguments)
{
    bool wanted[GROUP_COUNT] = {false}, keep = false;
    const char *out = FIGURES_OUT;
    for (int i = 1; i < count; i++) {
        if (strcmp(arguments[i], "--help") == 0) {
            print_help();
            return 0;
        }
    }
    if (!read_arguments(count, arguments, wanted, &out, &keep)) {
        return 2;
    }
    make_folder(out);
    int checks = 0, failures = 0, skipped = 0;
    for (int i = 0; i < GROUP_COUNT; i++) {
        if (wanted[i]) {
            struct figure figure = {.name = GROUPS[i].name, .out = out, .keep = keep};
            GROUPS[i].draw(&figure);
            fflush(stdout);
            checks += figure.checks;
            failures += figure.failures;
            skipped += figure.skipped;
        }
    }
    printf("%d checks, %d failed; sheets in %s\n", checks, failures, out);
    return failures > 0 ? 1 : checks > 0 ? 0 : skipped > 0 ? 77 : 1;
}
