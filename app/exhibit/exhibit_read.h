/* The parts of reading an exhibit. Private to exhibit*.c. */
#ifndef FROND_EXHIBIT_READ_H
#define FROND_EXHIBIT_READ_H

#include "exhibit.h"
#include "inputs_read.h"
#include "script_value.h"

enum {
    EXHIBIT_CELLS_MIN = 16384,
    EXHIBIT_CELLS_MAX = 4194304,
    EXHIBIT_TAPS_MIN = 3,
    TEXT_BYTES = 300, /* of one text in one language */
    EXHIBIT_PATH_BYTES = 200,
    EXHIBIT_STRUCTURES = 4, /* of a scene */
    EXHIBIT_OPENING = 64,   /* actions of a scene */
};

/* A palette of the exhibit's own: needed while its scenes are read. */
struct exhibit_inks {
    const char *id;
    int inks[PAINTING_INKS], count;
};

extern const struct key exhibit_keys[];         /* over struct exhibit; lists and mappings have the unit "section" */
extern const struct key display_keys[];         /* over struct exhibit_display */
extern const struct key sheet_keys[];           /* over struct exhibit_sheet */
extern const struct key palettes_keys[];        /* over struct exhibit_inks */
extern const struct key scene_keys[];           /* over struct exhibit_scene; `mode` over struct script */
extern const struct key scene_structure_keys[]; /* beside those of a script's structure, over what is theirs alone */
extern const struct key scene_feed_keys[];      /* over struct exhibit_feed */
extern const struct key hud_keys[];             /* over struct exhibit_palette */
extern const struct key seat_keys[];            /* over struct exhibit_seat */
extern const struct key visit_keys[];           /* over struct exhibit_visit */
extern const struct key access_keys[];          /* over struct exhibit_access */
extern const struct key schedule_keys[];        /* over struct exhibit_hours */
extern const struct key gallery_keys[];         /* over struct exhibit_gallery */
extern const struct key staff_keys[];           /* over struct exhibit_staff */
extern const struct key mqtt_keys[];            /* over struct exhibit_mqtt */
extern const struct key text_keys[];            /* by enum exhibit_text; over struct words, a language at a time */
extern const char *const corner_names[];        /* these two end with NULL */
extern const char *const day_names[];

/* Defaults of all values that are no sections, over `object`. */
void exhibit_defaults(const struct key *keys, void *object);
/* The mapping under `name`, with its sections passed over; NULL when there is none. */
const struct yaml_node *exhibit_mapping(struct reader *reader, const struct yaml_node *root, const char *name,
                                        const struct key *keys, void *object);
/* A problem with the part `name` of where the reader is. */
void exhibit_problem(struct reader *reader, const char *name, const struct yaml_node *at, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* An item of a list as a mapping; false when it is none, which is then in the report. */
bool exhibit_item(struct reader *reader, const struct yaml_node *item, const struct key *keys, void *object,
                  const char *allowed);

void exhibit_read_languages(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
void exhibit_read_words(struct reader *reader, const struct yaml_node *root, const char *name,
                        const struct exhibit *exhibit, struct words *words);
void exhibit_read_texts(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
/* After languages and sheet. */
void exhibit_read_scenes(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
/* The section of its kind (`trees`, ...) of a scene that has been read as far as its kind. */
void exhibit_read_options(struct reader *reader, const struct yaml_node *item, const struct exhibit *exhibit,
                          struct exhibit_scene *scene);
/* `opening` of a scene that has been read as far as its inks. */
void exhibit_read_opening(struct reader *reader, const struct yaml_node *item, struct exhibit_scene *scene);
/* What a report says that a scene is of: "paintings", "trees". */
const char *exhibit_kind_of_scene(int kind);
/* `structures` of a scene that has been read as far as its coefficients. */
void exhibit_read_structures(struct reader *reader, const struct yaml_node *item, struct exhibit_scene *scene);
/* `inputs` of a scene, that has been read as far as its inks: all but which scenes they are from. */
void exhibit_read_feeds(struct reader *reader, const struct yaml_node *item, struct exhibit_scene *scene);
/* Whether a scene, of which nothing may have been read, has an input of this port. */
bool exhibit_is_fed(const struct yaml_node *item, enum graph_port port);
/* After the scenes: what feeds what, its types, and that nothing feeds itself. */
void exhibit_check_feeds(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
void exhibit_read_files(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
/* A picture can be read; if not, that is reported. */
void exhibit_check_picture(struct reader *reader, const struct yaml_node *at, const char *path);
/* Whether the folder `pictures` can be read and holds none. */
bool exhibit_is_bare(const struct exhibit *exhibit);
void exhibit_read_palette(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
void exhibit_read_hours(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
void exhibit_read_staff(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
/* After the scenes, whose inks they name. */
void exhibit_read_seats(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
void exhibit_read_inputs(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit);
/* Whether an ink of the first scene, by its place there, is at that place in all others; if not, that is reported. */
void exhibit_same_ink(struct reader *reader, const struct yaml_node *at, const struct exhibit *exhibit, int ink);

#endif
