/* Bad exhibits, and word for word what is said of them (app/exhibit/exhibit.h): the hall and its hours, visitors,
 * devices. Scenes, pictures and sessions: test_exhibit_bad_scenes.c. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "exhibit_case.h"
#include "script_case.h"
#include "yaml.h"

#define EXHIBIT_KEYS                                                                                                   \
    "exhibit, title, display, sheet, engine, languages, texts, palettes, scenes, pictures, sessions, palette, seats, " \
    "inputs, visit, access, schedule, wake, gallery, staff, mqtt"
#define TEXT_KEYS                                                                                                      \
    "invite, inks, drop, brush, guide, pour, mask, rewind, plant, tend, thin, strike, "                                \
    "repel, stroke, dose, erase, map, picture, "                                                                       \
    "metaphor, undo, redo, finish, hand, seated, language, countdown, "                                                \
    "stay, thanks, closed"
#define LANGUAGE_TAGS "en, fr, ar, ja, de, es, it, zh"

static const struct script_case BAD[] = {
    {"nothing", BYTES(""), "s.yaml:1:1: the file is empty; exhibit: 1\n"},
    {"a comment", BYTES("# exhibit: 1\n"), "s.yaml:1:1: the file is empty; exhibit: 1\n"},
    {"a list", BYTES("- exhibit: 1\n"), "s.yaml:1:1: a list where an exhibit should be; exhibit: 1, and its keys\n"},
    {"no version", BYTES("title: {en: Frost}\n"), "s.yaml:1:1: exhibit: missing; only 1\n"},
    {"another version", BYTES("exhibit: 2\n"), "s.yaml:1:10: exhibit: 2 is out of range; only 1\n"},
    {"the version as a text", BYTES("exhibit: '1'\n"),
     "s.yaml:1:10: exhibit: '1' is text, not a number: leave the quotes out; only 1\n"},
    {"unknown key",
     BYTES("exhibit: 1\n"
           "scene: []\n"),
     "s.yaml:2:1: scene: unknown key; did you mean scenes? One of " EXHIBIT_KEYS "\n"},
    {"a key twice",
     BYTES("exhibit: 1\n"
           "wake: 5\n"
           "wake: 6\n"),
     "s.yaml:3:1: wake: given twice, first on line 2; once is enough\n"},
    {"no YAML",
     BYTES("exhibit: 1\n"
           "title: {en: Frost\n"),
     "s.yaml:3:1: missing comma in flow mapping\n"},
    {"a bomb of aliases",
     BYTES("exhibit: 1\n"
           "seats: &a [1, 1]\n"
           "scenes: [*a, *a, *a]\n"),
     "s.yaml:2:9: an anchor; write the value out\n"
     "s.yaml:2:12: seats[0]: '1'; {zone: [0, 0, 0.5, 1], ink: INK, side: left}\n"
     "s.yaml:2:15: seats[1]: '1'; {zone: [0, 0, 0.5, 1], ink: INK, side: left}\n"
     "s.yaml:3:11: an alias; write the value out\n"
     "s.yaml:3:15: an alias; write the value out\n"
     "s.yaml:3:19: an alias; write the value out\n"},
    {"a bomb of lists",
     BYTES("exhibit: 1\n"
           "scenes: [[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]]\n"),
     "s.yaml:2:24: nested too deep; at most 16 deep\n"},
    {"merge keys",
     BYTES("exhibit: 1\n"
           "visit: {<<: {idle: 5}}\n"),
     "s.yaml:2:9: a merge key; write the keys out\n"},
    {"a tag",
     BYTES("exhibit: 1\n"
           "visit: !!python/object {idle: 5}\n"),
     "s.yaml:2:8: a tag; write the value out\n"},
    {"a title without a language",
     BYTES("exhibit: 1\n"
           "title: Frost\n"),
     "s.yaml:2:8: title: 'Frost'; a text by language: {en: TEXT, fr: TEXT}\n"},
    {"a title in a language that is not shown",
     BYTES("exhibit: 1\n"
           "title: {fr: Givre}\n"),
     "s.yaml:2:9: title.fr: not among the exhibit's languages; one of en\n"},
    {"an unknown language",
     BYTES("exhibit: 1\n"
           "languages: [en, eng]\n"),
     "s.yaml:2:17: languages[1]: unknown language 'eng'; did you mean en? One of " LANGUAGE_TAGS "\n"},
    {"a language twice",
     BYTES("exhibit: 1\n"
           "languages: [fr, fr]\n"),
     "s.yaml:2:17: languages[1]: 'fr' is there already; each language once\n"},
    {"languages as a word",
     BYTES("exhibit: 1\n"
           "languages: en\n"),
     "s.yaml:2:12: languages: 'en'; a list of languages: [en, fr]\n"},
    {"a text for nobody",
     BYTES("exhibit: 1\n"
           "texts: {invit: {en: Come}}\n"),
     "s.yaml:2:9: texts.invit: unknown key; did you mean invite? One of " TEXT_KEYS "\n"},
    {"a text without a language",
     BYTES("exhibit: 1\n"
           "texts: {invite: Come}\n"),
     "s.yaml:2:17: texts.invite: 'Come'; a text by language: {en: TEXT, fr: TEXT}\n"},
    {"a text in two languages that are not shown",
     BYTES("exhibit: 1\n"
           "languages: [ja]\n"
           "texts: {invite: {en: Come, xy: Come}}\n"),
     "s.yaml:3:18: texts.invite.en: not among the exhibit's languages; one of ja\n"
     "s.yaml:3:28: texts.invite.xy: unknown language; one of " LANGUAGE_TAGS "\n"},
    {"an empty text",
     BYTES("exhibit: 1\n"
           "texts: {invite: {en: ''}}\n"),
     "s.yaml:2:22: texts.invite.en: a text of 0 bytes; text, 1 to 300 bytes\n"},
    {"a text twice",
     BYTES("exhibit: 1\n"
           "texts: {invite: {en: Come, en: Go}}\n"),
     "s.yaml:2:28: texts.invite.en: given twice; once is enough\n"},
    {"a countdown that does not count",
     BYTES("exhibit: 1\n"
           "texts:\n"
           "  countdown: {en: Soon}\n"),
     "s.yaml:3:19: texts.countdown.en: has no {seconds}; a sentence with {seconds} where the number is to stand\n"},
    {"texts as a list",
     BYTES("exhibit: 1\n"
           "texts: [invite]\n"),
     "s.yaml:2:8: texts: a list; texts by their names: {invite: {en: TEXT, fr: TEXT}, ...}\n"},
    {"a display as a word",
     BYTES("exhibit: 1\n"
           "display: HDMI-A-1\n"),
     "s.yaml:2:10: display: 'HDMI-A-1'; {key: value, ...}, of keys that are one of connector, mode, refresh, rotation, "
     "width, floor, lying\n"},
    {"a rotation",
     BYTES("exhibit: 1\n"
           "display: {rotation: 45}\n"),
     "s.yaml:2:21: display.rotation: unknown choice '45'; one of 0, 90, 180, 270\n"},
    {"a mode",
     BYTES("exhibit: 1\n"
           "display: {mode: 1920}\n"),
     "s.yaml:2:17: display.mode: '1920' is not it; WxH, each 1 to 8192 pixels\n"},
    {"a mode that is too large",
     BYTES("exhibit: 1\n"
           "display: {mode: 19200x1080}\n"),
     "s.yaml:2:17: display.mode: '19200x1080' is not it; WxH, each 1 to 8192 pixels\n"},
    {"a width in cm",
     BYTES("exhibit: 1\n"
           "display: {width: 53}\n"),
     "s.yaml:2:18: display.width: 53 is out of range; 100 to 5000 mm\n"},
    {"a number with its unit",
     BYTES("exhibit: 1\n"
           "display: {width: 530 mm}\n"),
     "s.yaml:2:18: display.width: '530 mm' is not a decimal number; 100 to 5000 mm\n"},
    {"a flag",
     BYTES("exhibit: 1\n"
           "display: {lying: yes}\n"),
     "s.yaml:2:18: display.lying: 'yes' is neither; true or false\n"},
    {"a sheet that is too large",
     BYTES("exhibit: 1\n"
           "sheet: {cells: 16777216, margin: 300}\n"),
     "s.yaml:2:16: sheet.cells: 16777216 is out of range; 16384 to 4194304 cells\n"
     "s.yaml:2:34: sheet.margin: 300 is out of range; 0 to 256 cells\n"},
    {"half a cell",
     BYTES("exhibit: 1\n"
           "sheet: {cells: 345600.5}\n"),
     "s.yaml:2:16: sheet.cells: 345600.5 is not a whole number; 16384 to 4194304 cells\n"},
    {"an engine",
     BYTES("exhibit: 1\n"
           "engine: vulkan\n"),
     "s.yaml:2:9: engine: unknown choice 'vulkan'; one of auto, cpu, gpu\n"},
    {"a palette of three",
     BYTES("exhibit: 1\n"
           "palettes:\n"
           "  - {id: mine, inks: [ochre, cyan, black]}\n"),
     "s.yaml:3:22: palettes[0].inks: a list of 3; a list of 4 inks, by name\n"},
    {"a palette without inks or name",
     BYTES("exhibit: 1\n"
           "palettes:\n"
           "  - {}\n"),
     "s.yaml:3:5: palettes[0].id: missing; a word, 1 to 40 bytes\n"
     "s.yaml:3:5: palettes[0].inks: missing; a list of 4 inks, by name\n"},
    {"a palette twice",
     BYTES("exhibit: 1\n"
           "palettes:\n"
           "  - {id: mine, inks: [ochre, cyan, black, magenta]}\n"
           "  - {id: mine, inks: [ochre, cyan, black, yellow]}\n"),
     "s.yaml:4:10: palettes[1].id: 'mine' is there already; another word\n"},
    {"a palette that comes with Frond",
     BYTES("exhibit: 1\n"
           "palettes:\n"
           "  - {id: dusk, inks: [ochre, cyan, black, magenta]}\n"),
     "s.yaml:3:10: palettes[0].id: 'dusk' is a palette that comes with Frond; another word\n"},
    {"tools",
     BYTES("exhibit: 1\n"
           "palette: {tools: [brush, rewnd]}\n"),
     "s.yaml:2:26: palette.tools[1]: unknown tool 'rewnd'; did you mean rewind? One of drop, brush, guide, pour, mask, "
     "rewind, plant, tend, thin, strike, repel, stroke, dose, erase, map\n"},
    {"small buttons",
     BYTES("exhibit: 1\n"
           "palette: {target: 10}\n"),
     "s.yaml:2:19: palette.target: 10 is out of range; 15 to 60 mm\n"},
    {"seats that overlap",
     BYTES("exhibit: 1\n"
           "seats:\n"
           "  - {zone: [0, 0, 0.6, 1]}\n"
           "  - {zone: [0.5, 0, 1, 1]}\n"),
     "s.yaml:4:12: seats[1].zone: overlaps that of seats[0]; zones that share nothing but edges\n"},
    {"a zone without area",
     BYTES("exhibit: 1\n"
           "seats:\n"
           "  - {zone: [0.5, 0, 0.5, 1]}\n"),
     "s.yaml:3:12: seats[0].zone: a zone without area; [left, top, right, bottom], left < right and top < bottom\n"},
    {"a zone of two",
     BYTES("exhibit: 1\n"
           "seats:\n"
           "  - {zone: [0, 1]}\n"
           "  - {zone: all}\n"
           "  - {side: left}\n"),
     "s.yaml:3:12: seats[0].zone: a list of 2 where a zone should be; [left, top, right, bottom], each 0 to 1 of the "
     "sheet\n"
     "s.yaml:4:12: seats[1].zone: 'all' where a zone should be; [left, top, right, bottom], each 0 to 1 of the sheet\n"
     "s.yaml:5:5: seats[2].zone: missing; [left, top, right, bottom], each 0 to 1 of the sheet\n"},
    {"an ink of no scene",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, inks: [cyan, yellow]}\n"
           "seats:\n"
           "  - {zone: [0, 0, 1, 1], ink: magenta}\n"),
     "s.yaml:5:31: seats[0].ink: 'magenta' is not among the first scene's inks; one of cyan, yellow\n"},
    {"an ink of one scene",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, inks: [cyan, yellow]}\n"
           "  - {id: dusk, inks: [yellow, cyan]}\n"
           "  - {id: night, inks: [cyan]}\n"
           "seats:\n"
           "  - {zone: [0, 0, 1, 1], ink: yellow}\n"),
     "s.yaml:7:31: seats[0].ink: yellow is not ink 2 of the scene 'dusk'; an ink that every scene has in the same "
     "place of its list\n"},
    {"a binding's ink",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, inks: [cyan, yellow]}\n"
           "  - {id: night, inks: [cyan, black]}\n"
           "inputs:\n"
           "  bindings:\n"
           "    - {touch: press, drop: {ink: cyan}}\n"
           "    - {touch: drag, brush_ink: {ink: yellow}}\n"),
     "s.yaml:8:38: inputs.bindings[1].brush_ink.ink: yellow is not ink 2 of the scene 'night'; an ink that every scene "
     "has in the same place of its list\n"},
    {"a binding's ink of no scene",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, inks: [cyan, yellow]}\n"
           "inputs:\n"
           "  bindings:\n"
           "    - {touch: press, drop: {ink: black}}\n"),
     "s.yaml:6:34: inputs.bindings[0].drop.ink: 'black' is not among the first scene's inks; one of cyan, yellow\n"},
    {"inputs with their version",
     BYTES("exhibit: 1\n"
           "inputs: {inputs: 1}\n"),
     "s.yaml:2:10: inputs.inputs: unknown key; one of visitors, touch, keyboards, controllers, other_controllers, "
     "gpio, bindings\n"},
    {"inputs as a path",
     BYTES("exhibit: 1\n"
           "inputs: inputs.yaml\n"),
     "s.yaml:2:9: inputs: 'inputs.yaml'; a mapping as an inputs file is: {bindings: [...], gpio: {...}, ...}\n"},
    {"a lamp of no button",
     BYTES("exhibit: 1\n"
           "inputs: {gpio: {lamps: [{id: red lamp, line: GPIO4, button: red}]}}\n"),
     "s.yaml:2:61: inputs.gpio.lamps[0].button: unknown button 'red'; there are none in gpio.buttons\n"},
    {"a binding of no button",
     BYTES("exhibit: 1\n"
           "inputs:\n"
           "  gpio: {buttons: [{id: red, line: GPIO17}]}\n"
           "  bindings:\n"
           "    - {button: rde, drop: {}}\n"),
     "s.yaml:5:16: inputs.bindings[0].button: unknown button 'rde'; one of red\n"},
    {"times of a visit",
     BYTES("exhibit: 1\n"
           "visit: {idle: 0, countdown: soon, wsh: 5}\n"),
     "s.yaml:2:15: visit.idle: 0 is out of range; 5 to 3600 s\n"
     "s.yaml:2:29: visit.countdown: 'soon' is not a decimal number; 3 to 120 s\n"
     "s.yaml:2:35: visit.wsh: unknown key; did you mean wash? One of idle, countdown, thanks, wash, attract, "
     "next_scene, hide\n"},
    {"access",
     BYTES("exhibit: 1\n"
           "access: {dwell: -1, zone: [0.2, 0.8, 0.8, 0.4]}\n"),
     "s.yaml:2:17: access.dwell: -1 is out of range; 0 to 10 s\n"
     "s.yaml:2:27: access.zone: a zone without area; [left, top, right, bottom], left < right and top < bottom\n"},
    {"one-switch play without a switch", BYTES("exhibit: 1\naccess: {scan: 8}\n"),
     "s.yaml:2:16: access.scan: a line that nothing stops; 0, or a binding of the switch: {button: ID, switch: {}}\n"},
    {"hours that are no times",
     BYTES("exhibit: 1\n"
           "schedule:\n"
           "  - {days: mon-fri, open: 9, close: 18:60}\n"
           "  - {open: '24:01', close: noon}\n"),
     "s.yaml:3:27: schedule[0].open: '9' is no time; a time of day, 0:00 to 24:00\n"
     "s.yaml:3:37: schedule[0].close: '18:60' is no time; a time of day, 0:00 to 24:00\n"
     "s.yaml:4:12: schedule[1].open: '24:01' is no time; a time of day, 0:00 to 24:00\n"
     "s.yaml:4:28: schedule[1].close: 'noon' is no time; a time of day, 0:00 to 24:00\n"},
    {"days",
     BYTES("exhibit: 1\n"
           "schedule:\n"
           "  - {days: mon-fry, open: 9:00, close: 18:00}\n"
           "  - {days: [], open: 9:00, close: 18:00}\n"
           "  - {days: [monday], open: 9:00, close: 18:00}\n"),
     "s.yaml:3:12: schedule[0].days: 'mon-fry' is no day; one of mon, tue, wed, thu, fri, sat, sun, or a span: "
     "mon-fri\n"
     "s.yaml:4:12: schedule[1].days: a list of 0; at least one day, or no list for every day\n"
     "s.yaml:5:13: schedule[2].days[0]: 'monday' is no day; one of mon, tue, wed, thu, fri, sat, sun, or a span: "
     "mon-fri\n"},
    {"hours without an end",
     BYTES("exhibit: 1\n"
           "schedule:\n"
           "  - {days: sat, open: 9:00}\n"),
     "s.yaml:3:5: schedule[0].close: missing; a time of day, 0:00 to 24:00\n"},
    {"a broker whose files are elsewhere, and names that are no part of a topic",
     BYTES("exhibit: 1\n"
           "mqtt: {host: a, topic: \"a/#\", name: b/c, group: \"+\", ca: /etc/ca.pem, key: ../key}\n"),
     "s.yaml:2:24: mqtt.topic: 'a/#' is no part of a topic; a text without + and #\n"
     "s.yaml:2:37: mqtt.name: 'b/c' is no part of a topic; a text without /, + and #\n"
     "s.yaml:2:49: mqtt.group: '+' is no part of a topic; a text without /, + and #\n"
     "s.yaml:2:58: mqtt.ca: '/etc/ca.pem' is not beside this file; a path without .. and without / before it\n"
     "s.yaml:2:76: mqtt.key: '../key' is not beside this file; a path without .. and without / before it\n"},
    {"a gallery elsewhere",
     BYTES("exhibit: 1\n"
           "gallery: {folder: ../pictures, pictures: 0}\n"),
     "s.yaml:2:19: gallery.folder: '../pictures' is no name of a folder in the state folder; a word without / and "
     "without a dot before it\n"
     "s.yaml:2:42: gallery.pictures: 0 is out of range; 1 to 100000 pictures\n"},
    {"a short chain",
     BYTES("exhibit: 1\n"
           "staff: {taps: [top left, top right]}\n"),
     "s.yaml:2:15: staff.taps: a list of 2; at least 3 corners, so that no visitor gets there\n"},
    {"a long chain",
     BYTES(
         "exhibit: 1\n"
         "staff: {taps: [top left, top left, top left, top left, top left, top left, top left, top left, top left]}\n"),
     "s.yaml:2:15: staff.taps: a list of 9; at most 8\n"},
    {"corners",
     BYTES("exhibit: 1\n"
           "staff: {taps: [top left, top rigth, bottom], hold: 0}\n"),
     "s.yaml:2:26: staff.taps[1]: unknown corner 'top rigth'; did you mean top right? One of top left, top right, "
     "bottom right, bottom left\n"
     "s.yaml:2:37: staff.taps[2]: unknown corner 'bottom'; one of top left, top right, bottom right, bottom left\n"
     "s.yaml:2:52: staff.hold: 0 is out of range; 0.5 to 10 s\n"},
    {"many at once",
     BYTES("exhibit: 1\n"
           "title: Frost\n"
           "engine: fast\n"
           "visit: {idle: 1}\n"
           "staff: {hold: no}\n"),
     "s.yaml:2:8: title: 'Frost'; a text by language: {en: TEXT, fr: TEXT}\n"
     "s.yaml:3:9: engine: unknown choice 'fast'; one of auto, cpu, gpu\n"
     "s.yaml:4:15: visit.idle: 1 is out of range; 5 to 3600 s\n"
     "s.yaml:5:15: staff.hold: 'no' is not a decimal number; 0.5 to 10 s\n"},
};

static void bad_files_are_told_word_for_word(void **state)
{
    (void)state;
    exhibit_case_told(BAD, sizeof BAD / sizeof *BAD);
}

static void a_file_that_is_too_large_is_not_read(void **state)
{
    (void)state;
    char *text = malloc(YAML_SIZE_MAX + 1);
    assert_non_null(text);
    memset(text, '#', YAML_SIZE_MAX + 1);
    const struct script_case large = {"too large", text, YAML_SIZE_MAX + 1,
                                      "s.yaml: the file is larger than 1 MiB; a script is at most 1 MiB\n"};
    exhibit_case_told(&large, 1);
    free(text);
}

/* Whatever is wrong with a long file, memory and report have an end. */
static void problems_without_end_are_counted(void **state)
{
    (void)state;
    enum { LINES = 20000, ROOM = 16 * LINES };
    char *text = malloc(ROOM);
    assert_non_null(text);
    size_t size = (size_t)snprintf(text, ROOM, "exhibit: 1\n");
    for (int i = 0; i < LINES; i++) {
        size += (size_t)snprintf(text + size, ROOM - size, "x%d: 1\n", i);
    }
    struct report report;
    report_init(&report, "s.yaml");
    assert_null(exhibit_case_parse(text, size, &report));
    assert_int_equal(report.count, REPORT_PROBLEMS_MAX);
    assert_int_equal(report.dropped, LINES - REPORT_PROBLEMS_MAX);
    report_finish(&report);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_files_are_told_word_for_word),
        cmocka_unit_test(a_file_that_is_too_large_is_not_read),
        cmocka_unit_test(problems_without_end_are_counted),
    };
    return cmocka_run_group_tests(tests, exhibit_case_begin, exhibit_case_end);
}
