/* Bad scenes of exhibits, their pictures and sessions, and word for word what is said of them (app/exhibit/exhibit.h).
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "exhibit_case.h"
#include "script_case.h"

#define TREES_KEYS                                                                                                     \
    "one of over, metaphor, tree, metric, emphasis, endpoints, seed, gradient, intensity, blur, light, base, "         \
    "picture, "                                                                                                        \
    "random, upward, sideways, smooth, jitter, tip, gain, power, window, branch, step, trunk, mix, leaves, "           \
    "tendrils, needles, iterations, primary, layers, side, radius, spacing, crown"

static const struct script_case BAD[] = {
    {"a scene without a name",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {inks: [cyan]}\n"),
     "s.yaml:3:5: scenes[0].id: missing; a word, 1 to 40 bytes\n"},
    {"a scene twice",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn}\n"
           "  - {id: dawn}\n"),
     "s.yaml:4:10: scenes[1].id: 'dawn' is there already; another word\n"},
    {"a scene as a word",
     BYTES("exhibit: 1\n"
           "scenes: [dawn]\n"),
     "s.yaml:2:10: scenes[0]: 'dawn'; {id: WORD, inks: [...], painting: {...}}; see frond explain scenes\n"},
    {"scenes as a mapping",
     BYTES("exhibit: 1\n"
           "scenes: {id: dawn}\n"),
     "s.yaml:2:9: scenes: a mapping; a list of {id: WORD, inks: [...], painting: {...}}\n"},
    {"too many scenes",
     BYTES("exhibit: 1\n"
           "scenes: [{id: s0}, {id: s1}, {id: s2}, {id: s3}, {id: s4}, {id: s5}, {id: s6}, {id: s7}, {id: s8}, {id: "
           "s9}, {id: s10}, {id: s11}, {id: s12}, {id: s13}, {id: s14}, {id: s15}, {id: s16}]\n"),
     "s.yaml:2:9: scenes: a list of 17; at most 16\n"},
    {"a kind of scene",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: wood, kind: tree}\n"),
     "s.yaml:3:22: scenes[0].kind: unknown choice 'tree'; did you mean trees? One of painting, trees, lightning, "
     "chemistry\n"},
    {"a way to leave",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: pane, leave: frieze}\n"
           "  - {id: sheet, leave: [dry]}\n"),
     "s.yaml:3:23: scenes[0].leave: unknown choice 'frieze'; did you mean freeze? One of wash, dry, freeze\n"
     "s.yaml:4:24: scenes[1].leave: a list where a name should be; one of wash, dry, freeze\n"},
    {"trees of a painting",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: wood, trees: {metaphor: vine}}\n"),
     "s.yaml:3:23: scenes[0].trees: in a scene of paintings; kind: trees, or no trees\n"},
    {"trees without a picture",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: wood, kind: trees}\n"
           "  - {id: dusk, kind: trees, trees: {metaphor: vine}}\n"),
     "s.yaml:3:5: scenes[0].trees.over: no picture to grow over; a path, or pictures: FOLDER in this file's folder, "
     "with one in it\n"
     "s.yaml:4:36: scenes[1].trees.over: no picture to grow over; a path, or pictures: FOLDER in this file's folder, "
     "with one in it\n"},
    {"trees over nothing",
     BYTES("exhibit: 1\n"
           "scenes: [{id: wood, kind: trees, trees: {over: text.png}}, {id: dusk, kind: trees, trees: 3}]\n"),
     "s.yaml:2:48: scenes[0].trees.over: 'text.png' is broken; a PNG, JPEG, TIFF, EXR or WebP picture\n"
     "s.yaml:2:91: scenes[1].trees.over: no picture to grow over; a path, or pictures: FOLDER in this file's folder, "
     "with one in it\n"
     "s.yaml:2:91: scenes[1].trees: '3'; {metaphor: ink, ...}; see frond explain trees\n"},
    {"how trees grow",
     BYTES("exhibit: 1\n"
           "pictures: fine\n"
           "scenes:\n"
           "  - id: wood\n"
           "    kind: trees\n"
           "    trees: {metaphor: vines, endpoints: 2.5, gian: 2, branch: 65, light: maybe, plant: [[0, 0]]}\n"),
     "s.yaml:6:23: scenes[0].trees.metaphor: unknown choice 'vines'; did you mean vine? One of ink, vine, lightning, "
     "winter, frost, cracks, painted\n"
     "s.yaml:6:41: scenes[0].trees.endpoints: 2.5 is not a whole number; 1 to 200000\n"
     "s.yaml:6:46: scenes[0].trees.gian: unknown key; " TREES_KEYS "\n"
     "s.yaml:6:63: scenes[0].trees.branch: 65 is out of range; 0 to 64 pixels\n"
     "s.yaml:6:74: scenes[0].trees.light: 'maybe' is neither; true or false\n"
     "s.yaml:6:81: scenes[0].trees.plant: unknown key; " TREES_KEYS "\n"},
    {"options of another kind",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: a, kind: chemistry, lightning: {eta: 3}}\n"
           "  - {id: b, kind: lightning, chemistry: {feed: 0.03}}\n"
           "  - {id: c, lightning: {eta: 3}}\n"
           "  - {id: d, kind: lightning, lightning: storm}\n"
           "  - {id: e, kind: chemistry, structures: [{over: good.png}]}\n"),
     "s.yaml:3:41: scenes[0].lightning: in a scene of chemistry; kind: lightning, or no lightning\n"
     "s.yaml:4:41: scenes[1].chemistry: in a scene of lightning; kind: chemistry, or no chemistry\n"
     "s.yaml:5:24: scenes[2].lightning: in a scene of paintings; kind: lightning, or no lightning\n"
     "s.yaml:6:41: scenes[3].lightning: 'storm'; {kind: lightning, ...}; see frond explain lightning\n"
     "s.yaml:7:42: scenes[4].structures: in a scene of chemistry; chemistry, or kind: painting\n"},
    {"how lightning grows",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: a, kind: lightning, lightning: {kind: corall, eta: 21}}\n"),
     "s.yaml:3:48: scenes[0].lightning.kind: unknown choice 'corall'; did you mean coral? One of lightning, tesla, "
     "tree, lichen, coral, river, snow, fracture, vessels, city, lichtenberg, frost\n"
     "s.yaml:3:61: scenes[0].lightning.eta: 21 is out of range; 0 to 20\n"},
    {"how chemicals react",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: a, kind: chemistry, chemistry: {feed: 0.2, kill: much}}\n"),
     "s.yaml:3:48: scenes[0].chemistry.feed: 0.2 is out of range; 0 to 0.15 per unit of time\n"
     "s.yaml:3:59: scenes[0].chemistry.kill: 'much' is not a decimal number; 0 to 0.1 per unit of time\n"},
    {"an opening",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - id: a\n"
           "    kind: chemistry\n"
           "    opening:\n"
           "      - strike: {at: [0.5, 0.5]}\n"
           "      - {tick: 3, dose: {at: [0.5, 0.5]}}\n"
           "      - undo: {}\n"
           "      - dose: {at: [0.5, 0.5], radius: 0}\n"
           "      - dose\n"
           "  - {id: b, opening: {drop: {}}}\n"),
     "s.yaml:6:9: scenes[0].opening[0].strike: does nothing to a fresh sheet of a scene of chemistry; another verb\n"
     "s.yaml:7:10: scenes[0].opening[1].tick: it is done at once on a fresh sheet; an action without a tick\n"
     "s.yaml:8:9: scenes[0].opening[2].undo: does nothing to a fresh sheet of a scene of chemistry; another verb\n"
     "s.yaml:9:40: scenes[0].opening[3].dose.radius: 0 is out of range; 0.5 to 512 cells\n"
     "s.yaml:10:9: scenes[0].opening[4]: 'dose' where an action should be; {verb: {...}}\n"
     "s.yaml:11:22: scenes[1].opening: a mapping; a list of {verb: {...}}\n"},
    {"a palette of nobody",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, palette: earht}\n"),
     "s.yaml:3:25: scenes[0].palette: unknown palette 'earht'; did you mean earth? One of reef, garden, dusk, earth, "
     "press, harbour, kingfisher, lantern\n"},
    {"inks and a palette",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, palette: earth, inks: [cyan]}\n"),
     "s.yaml:3:25: scenes[0].palette: inks are given too; one of the two\n"},
    {"an ink",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, inks: [cyna, 5]}\n"),
     "s.yaml:3:23: scenes[0].inks[0]: unknown ink 'cyna'; one of " INKS "\n"
     "s.yaml:3:29: scenes[0].inks[1]: unknown ink '5'; one of " INKS "\n"},
    {"a coefficient",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, painting: {s_max: 9, alfa_a: 1}}\n"),
     "s.yaml:3:34: scenes[0].painting.s_max: 9 is out of range; 0 to 1.5 density per cell\n"
     "s.yaml:3:37: scenes[0].painting.alfa_a: unknown key; did you mean alpha_a? One of " COEFFICIENTS "\n"},
    {"a mode of inks",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, mode: rgb}\n"),
     "s.yaml:3:22: scenes[0].mode: unknown choice 'rgb'; one of pigment, cmy\n"},
    {"pictures of a scene",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, guide: ../a.png, mask: no.png}\n"
           "  - {id: noon, guide: text.png, mask: [a]}\n"),
     "s.yaml:3:23: scenes[0].guide: '../a.png' leads out of this file's folder; a picture lies in it or below\n"
     "s.yaml:3:39: scenes[0].mask: 'no.png' is not there; a picture in this file's folder or below\n"
     "s.yaml:4:23: scenes[1].guide: 'text.png' is broken; a PNG, JPEG, TIFF, EXR or WebP picture\n"
     "s.yaml:4:39: scenes[1].mask: a list where a text should be; the path of a picture, 1 to 200 bytes\n"},
    {"a link out of the folder",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: dawn, guide: out/passwd}\n"
           "pictures: out\n"),
     "s.yaml:3:23: scenes[0].guide: 'out/passwd' leads out of this file's folder; a picture lies in it or below\n"
     "s.yaml:4:11: pictures: 'out' leads out of this file's folder; a folder lies in it or below\n"},
    {"a folder of pictures that is not there",
     BYTES("exhibit: 1\n"
           "pictures: stok\n"),
     "s.yaml:2:11: pictures: 'stok' is not there; a folder in this file's folder or below\n"},
    {"a folder that is a file",
     BYTES("exhibit: 1\n"
           "pictures: good.yaml\n"),
     "s.yaml:2:11: pictures: 'good.yaml' is no folder; a folder in this file's folder or below\n"},
    {"a broken picture",
     BYTES("exhibit: 1\n"
           "pictures: stock\n"),
     "s.yaml:2:11: pictures: 'stock/text.png' is broken; a PNG, JPEG, TIFF, EXR or WebP picture\n"},
    {"too many pictures",
     BYTES("exhibit: 1\n"
           "pictures: many\n"),
     "s.yaml:2:11: pictures: 201 pictures in 'many'; at most 200\n"},
    {"sessions",
     BYTES("exhibit: 1\n"
           "sessions: [good.yaml, no.yaml, /etc/passwd, stock, wrong.yaml]\n"),
     "s.yaml:2:23: sessions[1]: 'no.yaml' is not there; a session in this file's folder or below\n"
     "s.yaml:2:32: sessions[2]: '/etc/passwd' leads out of this file's folder; a session lies in it or below\n"
     "s.yaml:2:45: sessions[3]: 'stock' is no file; a session script\n"
     "s.yaml:2:52: sessions[4]: wrong.yaml:2:8: ticks: 'x' is not a decimal number; 0 to 10000000 ticks\n"
     "s.yaml:2:52: sessions[4]: wrong.yaml:4:21: actions[0].drop.at: missing; [x, y], each 0 to 1 of the sheet\n"},
    {"a session that is too large",
     BYTES("exhibit: 1\n"
           "sessions: [huge.yaml]\n"),
     "s.yaml:2:12: sessions[0]: huge.yaml: the file is larger than 1 MiB; a script is at most 1 MiB\n"},
    {"a session as a mapping",
     BYTES("exhibit: 1\n"
           "sessions: [{path: good.yaml}]\n"),
     "s.yaml:2:12: sessions[0]: a mapping where a text should be; the path of a session script, 1 to 200 bytes\n"},
    {"a structure that is nothing",
     BYTES("exhibit: 1\n"
           "scenes:\n"
           "  - {id: a, structures: [{over: good.png, as: face}, {as: mask}, {over: no.png}]}\n"
           "  - {id: b, kind: trees, trees: {over: good.png}, structures: [{over: good.png}]}\n"),
     "s.yaml:3:47: scenes[0].structures[0].as: unknown choice 'face'; one of guide, mask, ink, relief\n"
     "s.yaml:3:54: scenes[0].structures[1].over: missing; the path of a picture in this file's folder, 1 to 1000 "
     "bytes\n"
     "s.yaml:3:73: scenes[0].structures[2].over: 'no.png' is not there; a picture in this file's folder or below\n"
     "s.yaml:4:63: scenes[1].structures: in a scene of trees; trees, or kind: painting\n"},
};

static void bad_scenes_are_told_word_for_word(void **state)
{
    (void)state;
    exhibit_case_told(BAD, sizeof BAD / sizeof *BAD);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bad_scenes_are_told_word_for_word)};
    return cmocka_run_group_tests(tests, exhibit_case_begin, exhibit_case_end);
}
