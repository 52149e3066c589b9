#include <string.h>

#include "exhibit_read.h"
#include "file_rows.h"
#include "script_read.h"
#include "transition.h"

enum { ID_BYTES = 40, TOPIC_BYTES = 100 };

static const char *const ENGINES[] = {"auto", "cpu", "gpu", NULL};
static const char *const TURNS[] = {"0", "90", "180", "270", NULL};
static const char *const SIDES[] = {"left", "right", "bottom", "none", NULL};

#define TOOL_NAME(tool, name, kind) name,
#define TOOL_KIND(tool, name, kind) kind,
const char *const exhibit_tool_names[] = {EXHIBIT_TOOLS(TOOL_NAME) NULL};
const enum scene_kind exhibit_tool_kinds[TOOLS] = {EXHIBIT_TOOLS(TOOL_KIND)};
const char *const corner_names[] = {"top left", "top right", "bottom right", "bottom left", NULL};
const char *const day_names[] = {"mon", "tue", "wed", "thu", "fri", "sat", "sun", NULL};

_Static_assert(offsetof(struct exhibit_display, mode_height) ==
                   offsetof(struct exhibit_display, mode_width) + sizeof(int),
               "KEY_SIZE is two ints, one after the other");

#define ZONE(name, type, field, top, need, text)                                                                       \
    {                                                                                                                  \
        name, KEY_ZONE, "of the sheet", 0, 1, top, NULL, offsetof(type, field), need, text                             \
    }
#define TIME(name, type, field, text)                                                                                  \
    {                                                                                                                  \
        name, KEY_TIME, "", 0, 1440, 0, NULL, offsetof(type, field), true, text                                        \
    }

#define EXHIBIT struct exhibit
const struct key exhibit_keys[] = {
    WHOLE("exhibit", EXHIBIT, version, "", EXHIBIT_VERSION, EXHIBIT_VERSION, EXHIBIT_VERSION, true,
          "The version of the exhibit file."),
    SECTION("title", "What the exhibit is called, by language: {en: ..., fr: ...}."),
    SECTION("display", "The screen, and where it hangs or lies."),
    SECTION("sheet", "The grid that is painted on."),
    CHOICE("engine", EXHIBIT, engine, ENGINES, ENGINE_AUTO, false,
           "What computes the painting; auto: the faster of the two on this machine."),
    SECTION("languages", "A list of the languages that visitors may choose, the first one shown first; [en] if left "
                         "out."),
    SECTION("texts", "What visitors read, each by language: {invite: {en: ..., fr: ...}}; the shipped words where a "
                     "text is left out."),
    SECTION("palettes", "A list of palettes of the exhibit's own, for its scenes."),
    SECTION("scenes", "A list of what is painted, one scene after the other; a single one with every default if left "
                      "out."),
    TEXT("pictures", EXHIBIT, pictures, "the path of a folder", EXHIBIT_PATH_BYTES, false,
         "A folder of pictures: scenes of trees grow over them, and along their edges every second painting that the "
         "sheet paints by itself."),
    SECTION("sessions", "A list of recorded sessions, by their paths, that are painted while nobody else paints."),
    SECTION("palette", "The buttons at the edge of the sheet."),
    SECTION("seats", "A list of places for visitors side by side; one place for all if left out."),
    SECTION("inputs", "Devices and what they do, as in an inputs file; fingers paint if left out."),
    SECTION("visit", "How long everything takes."),
    SECTION("access", "Ways to paint for those who cannot reach, cannot hold still, or have one switch."),
    SECTION("schedule", "A list of opening hours; always open if left out."),
    WHOLE("wake", EXHIBIT, wake, "minutes", 0, 600, 0, false,
          "How long a touch opens the exhibit while it is closed; 0: it stays closed."),
    SECTION("gallery", "Where finished pictures are kept."),
    SECTION("staff",
            "The staff's way to the status view and out: corners tapped one after another, the last one held."),
    SECTION("mqtt", "A broker that is told how the exhibit is, and tells a group of them what to show; none if left "
                    "out."),
    END,
};

#define DISPLAY struct exhibit_display
const struct key display_keys[] = {
    TEXT("connector", DISPLAY, connector, "a connector's name", ID_BYTES, false,
         "The socket of the screen, HDMI-A-1; the first one with a screen if left out."),
    {"mode", KEY_SIZE, "pixels", 1, 8192, 0, NULL, offsetof(DISPLAY, mode_width), false,
     "What the screen shows, 1920x1080; what it prefers if left out."},
    NUMBER("refresh", DISPLAY, refresh, "Hz", 0, 240, 0, false, "Pictures a second; 0: what the screen prefers."),
    CHOICE("rotation", DISPLAY, rotation, TURNS, 0, false,
           "Degrees clockwise that picture and touch are turned, together."),
    NUMBER("width", DISPLAY, width, "mm", 100, 5000, 530, false,
           "Width of the picture as it is looked at; what makes a button as large as a fingertip."),
    NUMBER("floor", DISPLAY, floor, "mm", 0, 3000, 800, false,
           "Height of its lower edge over the floor; buttons stay within reach of a wheelchair."),
    FLAG("lying", DISPLAY, lying, 0, "Whether the screen lies as a table: nothing is out of reach by its height."),
    END,
};

#define SHEET struct exhibit_sheet
const struct key sheet_keys[] = {
    WHOLE("cells", SHEET, cells, "cells", EXHIBIT_CELLS_MIN, EXHIBIT_CELLS_MAX, 345600, false,
          "How fine the whole sheet is, which has the shape of the screen; more is finer, and slower."),
    WHOLE("margin", SHEET, margin, "cells", 0, CANVAS_MARGIN_MAX, 0, false,
          "Cells simulated beyond each side, so that growth does not turn square there."),
    WHOLE("seed", SHEET, seed, "", 0, 2147483647, 1, false, "Seed of everything random: another one is another paper."),
    WHOLE("rate", SHEET, rate, "ticks a second", 10, 240, 60, false, "How fast the painting grows."),
    END,
};

#define PALETTE struct exhibit_inks
const struct key palettes_keys[] = {
    TEXT("id", PALETTE, id, "a word", ID_BYTES, true, "What scenes call the palette."),
    SECTION("inks", "A list of four inks, by name."),
    END,
};

#define SCENE                                  struct exhibit_scene
#define SCENE_SECTION(kind, name, type, about) SECTION(name, about),
const struct key scene_keys[] = {
    TEXT("id", SCENE, id, "a word", ID_BYTES, true, "What the staff's view and the log call the scene."),
    SECTION("title", "What visitors call it, by language: {en: ..., fr: ...}."),
    CHOICE("kind", SCENE, kind, scene_kind_names, SCENE_PAINTING, false,
           "What it is: ink on a wet sheet, trees and dendrites that grow over pictures, lightning and all else that "
           "grows as it does, or chemicals that react."),
    CHOICE("leave", SCENE, leave, transition_names, TRANSITION_WASH, false,
           "How it goes when another scene comes or the visit ends: water washes it down, the sheet dries from its "
           "edges, or frost grows over it and melts."),
    SCENE_TYPES(SCENE_SECTION) /* one for each kind */
    SECTION("inks", "A list of one to four inks, by name."),
    SECTION("palette", "Four inks at once, by the id of a palette of the exhibit's own or the name of a shipped one, "
                       "instead of inks; the first shipped one if both are left out."),
    {"mode", KEY_CHOICE, "", 0, 0, 0, script_modes, offsetof(struct script, mode), false,
     "How inks are shown: as pigment, in which blue and yellow make green, or subtracted as in the paper."},
    SECTION("painting", "Coefficients of the painting, by name."),
    TEXT("guide", SCENE, guide, "the path of a picture", EXHIBIT_PATH_BYTES, false,
         "A picture along whose edges everything grows, beside this file."),
    TEXT("mask", SCENE, mask, "the path of a picture", EXHIBIT_PATH_BYTES, false,
         "A picture whose dark parts stay free, beside this file."),
    SECTION("structures", "A list of what `frond grow` grows over pictures, for the painting to grow along: at most "
                          "four, with the options of trees."),
    SECTION("inputs", "A list of what comes from other scenes, at most eight: {from: SCENE, of: dark, as: mask}."),
    SECTION("opening", "A list of what is done on every fresh sheet of the scene, at most 64 actions as in scripts, "
                       "without their ticks."),
    END,
};

#define HUD struct exhibit_palette
const struct key hud_keys[] = {
    SECTION("tools",
            "A list of what a finger may do, of drop, brush, guide, pour, mask, rewind, in scenes of trees plant, "
            "tend, thin, of lightning strike, repel, stroke, of chemistry dose, erase, map; all if left out, and the "
            "first of each always."),
    FLAG("undo", HUD, undo, 1, "Whether there are buttons that take back, and bring back, what a visitor did last."),
    FLAG("finish", HUD, finish, 1, "Whether there is a button for a picture that is finished."),
    FLAG("hand", HUD, hand, 1,
         "Whether there is a button that moves the palette to the other side, for the other hand."),
    FLAG("seated", HUD, seated, 1,
         "Whether there is a button that brings the whole sheet within a seated visitor's reach."),
    FLAG("language", HUD, language, 1, "Whether there is a button for the next language, where there are several."),
    NUMBER("target", HUD, target, "mm", 15, 60, 18, false, "Side of a button."),
    NUMBER("opacity", HUD, opacity, "", 0.3, 1, 0.85, false, "How solid the palette is while nobody touches it."),
    END,
};

#define SEAT struct exhibit_seat
const struct key seat_keys[] = {
    ZONE("zone", SEAT, zone, 0, true, "The part of the sheet whose fingers are this visitor's."),
    {"ink", KEY_INK, "", 0, 0, -1, NULL, offsetof(SEAT, ink), false,
     "The only ink of this place, one of every scene; chosen on the palette if left out."},
    CHOICE("side", SEAT, side, SIDES, SIDE_OF_LEFT, false,
           "The side of the zone where its palette is; none: it has none."),
    END,
};

#define VISIT struct exhibit_visit
const struct key visit_keys[] = {
    NUMBER("idle", VISIT, idle, "s", 5, 3600, 60, false, "How long nobody does anything until the countdown begins."),
    NUMBER("countdown", VISIT, countdown, "s", 3, 120, 15, false, "How long the countdown is; any input ends it."),
    NUMBER("thanks", VISIT, thanks, "s", 0, 60, 6, false,
           "How long a finished picture is looked at before it is washed away."),
    NUMBER("wash", VISIT, wash, "s", 1, 30, 5, false,
           "How long the water takes across the sheet; a sheet that dries or freezes, three seconds at the least."),
    NUMBER("attract", VISIT, attract, "s", 20, 1800, 120, false,
           "How long a painting takes that the sheet paints by itself, with the rest after it."),
    WHOLE("next_scene", VISIT, next_scene, "paintings", 0, 1000, 1, false,
          "After how many of those the next scene comes; 0: the scene stays."),
    NUMBER("hide", VISIT, hide, "s", 0, 60, 1.5, false,
           "How long hands are busy until the palette goes out of their way."),
    END,
};

#define ACCESS struct exhibit_access
const struct key access_keys[] = {
    NUMBER("scan", ACCESS, scan, "s", 0, 60, 0, false,
           "How long a line takes across the sheet, for those who have one switch; 0: there is none."),
    NUMBER("dwell", ACCESS, dwell, "s", 0, 10, 0, false,
           "How long a finger or a cursor rests until a drop falls; 0: none falls."),
    NUMBER("dwell_radius", ACCESS, dwell_radius, "mm", 2, 60, 12, false, "How far it may stray and still rests."),
    ZONE("zone", ACCESS, zone, 0.5, false, "The part of the sheet that stands for all of it to a seated visitor."),
    END,
};

#define HOURS struct exhibit_hours
const struct key schedule_keys[] = {
    SECTION("days", "A list of mon, tue, wed, thu, fri, sat, sun, or a span of them: mon-fri; every day if left out."),
    TIME("open", HOURS, from, "When the exhibit opens."),
    TIME("close", HOURS, to, "When it closes; not after `open`: on the next day."),
    END,
};

#define GALLERY struct exhibit_gallery
const struct key gallery_keys[] = {
    TEXT("folder", GALLERY, folder, "a word", ID_BYTES, false,
         "A folder in Frond's state folder for finished pictures; nothing is kept if left out."),
    WHOLE("pictures", GALLERY, pictures, "pictures", 1, 100000, 500, false,
          "How many are kept; the oldest one goes first."),
    WHOLE("megabytes", GALLERY, megabytes, "MB", 1, 100000, 500, false, "How much all of them may take together."),
    NUMBER("slides", GALLERY, slides, "s", 0, 120, 8, false,
           "How long one of them is shown between two paintings that the sheet paints by itself; 0: none is."),
    TEXT("stick", GALLERY, stick, "a word", ID_BYTES, false,
         "The folder on a USB stick of the staff that the gallery is copied to; frond-gallery if left out."),
    END,
};

#define STAFF struct exhibit_staff
const struct key staff_keys[] = {
    SECTION("taps",
            "A list of 3 to 8 corners: top left, top right, bottom right, bottom left; these four in this order "
            "if left out."),
    NUMBER("within", STAFF, within, "s", 0.3, 10, 2, false, "How long it may take from one tap to the next."),
    NUMBER("hold", STAFF, hold, "s", 0.5, 10, 3, false, "How long the last corner is held."),
    END,
};

#define MQTT struct exhibit_mqtt
const struct key mqtt_keys[] = {
    TEXT("host", MQTT, host, "a name or an address", 255, true, "The broker."),
    WHOLE("port", MQTT, port, "", 1, 65535, 8883, false, "Where it listens; 1883 is usual without TLS."),
    TEXT("topic", MQTT, topic, "a topic", TOPIC_BYTES, true, "What stands before all topics: frond, museum/frond."),
    TEXT("name", MQTT, name, "a word", ID_BYTES, true, "What this one is called: TOPIC/NAME/status."),
    TEXT("group", MQTT, group, "a word", ID_BYTES, false,
         "Those that are told together: TOPIC/GROUP/scene, TOPIC/GROUP/hours."),
    WHOLE("every", MQTT, every, "s", 5, 3600, 60, false, "How often the status is said."),
    TEXT("ca", MQTT, ca, "the path of a file", EXHIBIT_PATH_BYTES, false,
         "Who has signed the broker's certificate (PEM), beside this file; without it nothing is encrypted."),
    TEXT("certificate", MQTT, certificate, "the path of a file", EXHIBIT_PATH_BYTES, false,
         "The certificate of this one (PEM), beside this file."),
    TEXT("key", MQTT, key, "the path of a file", EXHIBIT_PATH_BYTES, false, "Its key (PEM), beside this file."),
    TEXT("credentials", MQTT, credentials, "the path of a file", EXHIBIT_PATH_BYTES, false,
         "A file of two lines, user and password, beside this file."),
    END,
};

#define WORDS(name, text) TEXT(name, struct words, in[0], "a text in each language", TEXT_BYTES, false, text)
const struct key text_keys[TEXTS + 1] = {
    [TEXT_INVITE] = WORDS("invite", "What invites visitors while nobody paints."),
    [TEXT_INKS] = WORDS("inks", "What stands over the inks."),
    [TEXT_DROP] = WORDS("drop", "On the button for drops."),
    [TEXT_BRUSH] = WORDS("brush", "On the button for the brush."),
    [TEXT_GUIDE] = WORDS("guide", "On the button for guiding growth."),
    [TEXT_POUR] = WORDS("pour", "On the button for pouring."),
    [TEXT_MASK] = WORDS("mask", "On the button for places that stay free."),
    [TEXT_REWIND] = WORDS("rewind", "On the button for the time brush."),
    [TEXT_PLANT] = WORDS("plant", "On the button for planting, in scenes of trees."),
    [TEXT_TEND] = WORDS("tend", "On the button that makes a place of the picture more important."),
    [TEXT_THIN] = WORDS("thin", "On the button that makes a place less important."),
    [TEXT_STRIKE] = WORDS("strike", "On the button for lightning, in scenes of it."),
    [TEXT_REPEL] = WORDS("repel", "On the button for a hand that bolts turn away from."),
    [TEXT_STROKE] = WORDS("stroke", "On the button for painting lines that bolts grow towards."),
    [TEXT_DOSE] = WORDS("dose", "On the button for chemicals, in scenes of chemistry."),
    [TEXT_ERASE] = WORDS("erase", "On the button that takes chemicals away."),
    [TEXT_MAP] = WORDS("map", "On the button for the map of reactions."),
    [TEXT_PICTURE] = WORDS("picture", "On the button for the next picture."),
    [TEXT_METAPHOR] = WORDS("metaphor", "On the button for another kind of what grows or reacts."),
    [TEXT_UNDO] = WORDS("undo", "On the button that takes back what was done last."),
    [TEXT_REDO] = WORDS("redo", "On the button that brings it back."),
    [TEXT_FINISH] = WORDS("finish", "On the button for a finished picture."),
    [TEXT_HAND] = WORDS("hand", "On the button that moves the palette to the other side."),
    [TEXT_SEATED] = WORDS("seated", "On the button that brings everything within a seated visitor's reach."),
    [TEXT_LANGUAGE] = WORDS("language", "On the button for the next language; the language's own name."),
    [TEXT_COUNTDOWN] = WORDS("countdown", "What is shown before the paper is washed; {seconds} becomes the number."),
    [TEXT_STAY] = WORDS("stay", "What stands under the countdown: how to go on."),
    [TEXT_THANKS] = WORDS("thanks", "What stands under a finished picture."),
    [TEXT_CLOSED] = WORDS("closed", "What is shown a moment before the screen darkens."),
    [TEXTS] = END,
};

const struct inputs_table exhibit_tables[] = {
    {"exhibit", "An exhibit file in YAML: everything that a curator decides.", exhibit_keys},
    {"display", "The screen of an exhibit.", display_keys},
    {"sheet", "The grid of an exhibit.", sheet_keys},
    {"texts", "What visitors read, each by language.", text_keys},
    {"palettes", "A palette of an exhibit's own.", palettes_keys},
    {"scenes", "A scene: inks, coefficients, and pictures that growth keeps to.", scene_keys},
    {"structures", "What grows over a picture, for a scene of ink.", scene_structure_keys},
    {"scene_inputs", "What a scene takes from another, on every fresh sheet.", scene_feed_keys},
    {"palette", "The buttons at the edge of the sheet.", hud_keys},
    {"seats", "A visitor's place.", seat_keys},
    {"visit", "How long everything takes.", visit_keys},
    {"access", "For those who cannot reach, cannot hold still, or have one switch.", access_keys},
    {"schedule", "Opening hours on some days.", schedule_keys},
    {"gallery", "Finished pictures.", gallery_keys},
    {"staff", "The staff's gesture.", staff_keys},
    {"mqtt", "A broker, for those who look after many exhibits.", mqtt_keys},
    {.name = NULL},
};
