#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "script_case.h"

static const struct script_case ACTIONS[] = {
    {"unknown verb",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drip: {at: [0.5, 0.5]}}\n"),
     "s.yaml:4:15: actions[0].drip: unknown verb; did you mean drop? One of " VERBS "\n"},
    {"verb like nothing",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, explode: {}}\n"),
     "s.yaml:4:15: actions[0].explode: unknown verb; one of " VERBS "\n"},
    {"two verbs",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, dry: {}, clear: {}}\n"),
     "s.yaml:4:24: actions[0].clear: a second verb, after dry; an action has one\n"},
    {"a verb twice",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, dry: {}, dry: {}}\n"),
     "s.yaml:4:24: actions[0].dry: given twice; once is enough\n"},
    {"radius out of range",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], radius: 5000}}\n"),
     "s.yaml:4:46: actions[0].drop.radius: 5000 is out of range; 0.5 to 512 cells\n"},
    {"at outside",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [1.5, -0.1]}}\n"),
     "s.yaml:4:27: actions[0].drop.at[0]: 1.5 is out of range; 0 to 1 of the sheet\n"
     "s.yaml:4:32: actions[0].drop.at[1]: -0.1 is out of range; 0 to 1 of the sheet\n"},
    {"at missing",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {}}\n"),
     "s.yaml:4:21: actions[0].drop.at: missing; [x, y], each 0 to 1 of the sheet\n"},
    {"at too long",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5, 0.5]}}\n"),
     "s.yaml:4:26: actions[0].drop.at: a list of 3 where a point should be; [x, y], each 0 to 1 of the sheet\n"},
    {"at a number",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, pour: {at: 0.5}}\n"),
     "s.yaml:4:26: actions[0].pour.at: '0.5' where a point should be; [x, y], each 0 to 1 of the sheet\n"},
    {"at of words",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, pour: {at: [left, top]}}\n"),
     "s.yaml:4:27: actions[0].pour.at[0]: 'left' is not a decimal number; 0 to 1 of the sheet\n"
     "s.yaml:4:33: actions[0].pour.at[1]: 'top' is not a decimal number; 0 to 1 of the sheet\n"},
    {"unknown parameter",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], raduis: 5}}\n"),
     "s.yaml:4:38: actions[0].drop.raduis: unknown key; did you mean radius? One of at, ink, radius, solvent, "
     "amount, edge, brush, reach\n"},
    {"parameter of another verb",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, pour: {at: [0.5, 0.5], ink: cyan}}\n"),
     "s.yaml:4:38: actions[0].pour.ink: unknown key; one of at, radius\n"},
    {"parameters not a mapping",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: 5}\n"),
     "s.yaml:4:21: actions[0].drop: '5' where a mapping should be; one of at, ink, radius, solvent, amount, "
     "edge, brush, reach\n"},
    {"parameters a list",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: [0.5, 0.5]}\n"),
     "s.yaml:4:21: actions[0].drop: a list where a mapping should be; one of at, ink, radius, solvent, "
     "amount, edge, brush, reach\n"},
    {"clear takes none",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, clear: {at: [0, 0]}}\n"),
     "s.yaml:4:23: actions[0].clear.at: unknown key; it takes none\n"},
    {"ink not of the session",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], ink: ochre}}\n"),
     "s.yaml:4:43: actions[0].drop.ink: 'ochre' is not among the session's inks; one of cyan, magenta\n"},
    {"unknown ink of a drop",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], ink: magneta}}\n"),
     "s.yaml:4:43: actions[0].drop.ink: unknown ink 'magneta'; did you mean magenta? One of " INKS "\n"},
    {"ink nothing",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], ink: }}\n"),
     "s.yaml:4:38: actions[0].drop.ink: nothing where a name should be; one of cyan, magenta\n"},
    {"unknown brush",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], brush: mos}}\n"),
     "s.yaml:4:45: actions[0].drop.brush: unknown brush 'mos'; did you mean moss? One of moss, fern, coral, "
     "frost, mocha, lichen\n"},
    {"unknown edge",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], edge: [hard]}}\n"),
     "s.yaml:4:44: actions[0].drop.edge: a list where a name should be; one of hard, soft, ragged\n"},
    {"path missing",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, draw: {ink: cyan}}\n"),
     "s.yaml:4:21: actions[0].draw: no place is given; a path, a formula or a picture\n"},
    {"path empty",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, draw: {path: []}}\n"),
     "s.yaml:4:28: actions[0].draw.path: a list of 0 where a path should be; 1 to 10000 points [x, y], each 0 "
     "to 1 of the sheet\n"},
    {"path of numbers",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, draw: {path: [0.1, 0.2]}}\n"),
     "s.yaml:4:29: actions[0].draw.path[0]: '0.1' where a point should be; [x, y], each 0 to 1 of the sheet\n"
     "s.yaml:4:34: actions[0].draw.path[1]: '0.2' where a point should be; [x, y], each 0 to 1 of the sheet\n"},
    {"path point outside",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, draw: {path: [[0.1, 0.2], [0.3, 2]]}}\n"),
     "s.yaml:4:47: actions[0].draw.path[1][1]: 2 is out of range; 0 to 1 of the sheet\n"},
    {"flag",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, unmask: {invert: maybe}}\n"),
     "s.yaml:4:32: actions[0].unmask.invert: 'maybe' is neither; true or false\n"},
    {"mask nowhere",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {}}\n"),
     "s.yaml:4:21: actions[0].mask: no place is given; at, a path, a formula or a picture\n"},
    {"strike nowhere",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, strike: {}}\n"),
     "s.yaml:4:23: actions[0].strike: no place is given; at, a formula or a picture\n"},
    {"rinse nowhere",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, rinse: {flow: [0, 1]}}\n"),
     "s.yaml:4:22: actions[0].rinse: no place is given; at or a path\n"},
    {"rinse here and there",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, rinse: {at: [0.5, 0.5], path: [[0, -1.5], [1, 3.5]]}}\n"),
     "s.yaml:4:22: actions[0].rinse: both at and a path; one of them\n"
     "s.yaml:4:61: actions[0].rinse.path[1][1]: 3.5 is out of range; -2 to 3 of the sheet\n"},
    {"guide nowhere",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, guide: {strength: 1}}\n"),
     "s.yaml:4:22: actions[0].guide: no place is given; a path, a formula or a picture\n"},
    {"bracket",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"sin(6*y\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: character 8: a bracket is not closed; " EXPRESSION "\n"},
    {"unknown name in a formula",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"hypo(x, y)\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: character 1: unknown: 'hypo'; " EXPRESSION "\n"},
    {"operator",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"x +* y\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: character 4: an operator that does not fit there: '*'; " EXPRESSION "\n"},
    {"assignment",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"x = 0.5\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: character 3: a single =; == compares\n"},
    {"empty formula",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: empty; " EXPRESSION "\n"},
    {"two results",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"x, y\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: several values; one expression gives one value\n"},
    {"a division by zero",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"1/(x - x)\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: is inf at x = 0.0006944, y = 0.0006944; -65536 to 65536 "
     "everywhere\n"},
    {"root of a negative",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: \"sqrt(-x)\"}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: is not a number at x = 0.0006944, y = 0.0006944; -65536 to 65536 "
     "everywhere\n"},
    {"formula of a field for a mask",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: [x, y]}}\n"),
     "s.yaml:4:31: actions[0].mask.formula: a list where an expression should be; one in x and y\n"},
    {"one expression for a field",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, guide: {formula: x}}\n"),
     "s.yaml:4:32: actions[0].guide.formula: 'x' where two expressions should be; [x part, y part]\n"},
    {"three expressions",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, guide: {formula: [x, y, x]}}\n"),
     "s.yaml:4:32: actions[0].guide.formula: a list of 3 where two expressions should be; [x part, y part]\n"},
    {"second expression wrong",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, guide: {formula: [x, \"sin(y, x)\"]}}\n"),
     "s.yaml:4:36: actions[0].guide.formula[1]: character 9: too many values for the function: 'sin'; " EXPRESSION
     "\n"},
    {"formula and picture",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {formula: x, picture: a.png}}\n"),
     "s.yaml:4:21: actions[0].mask: both a formula and a picture; one of them\n"
     "s.yaml:4:43: actions[0].mask.picture: pictures cannot be read here; a formula can\n"},
    {"no loader",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, mask: {picture: a.png}}\n"),
     "s.yaml:4:31: actions[0].mask.picture: pictures cannot be read here; a formula can\n"},
    {"set without coefficient",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, set: {value: 1}}\n"),
     "s.yaml:4:20: actions[0].set.coefficient: missing; the name of a coefficient\n"},
    {"set unknown",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, set: {coefficient: alpha_b, value: 1}}\n"),
     "s.yaml:4:34: actions[0].set.coefficient: unknown coefficient 'alpha_b'; did you mean alpha_a? One "
     "of " COEFFICIENTS "\n"},
    {"set out of range",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, set: {coefficient: alpha_a, value: 7}}\n"),
     "s.yaml:4:50: actions[0].set.value: 7 is out of range; 0.01 to 1 cells^2 per unit of time\n"},
    {"set a choice",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, set: {coefficient: noise, value: loud}}\n"),
     "s.yaml:4:48: actions[0].set.value: unknown choice 'loud'; one of uniform, smooth, lognormal\n"},
    {"set without value",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, set: {coefficient: alpha_a}}\n"),
     "s.yaml:4:20: actions[0].set.value: missing; 0.01 to 1 cells^2 per unit of time\n"},
    {"set formula without to",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, set: {coefficient: alpha_a, value: 0.2, formula: x}}\n"),
     "s.yaml:4:20: actions[0].set.to: missing; 0.01 to 1 cells^2 per unit of time\n"},
    {"set half a step",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, set: {coefficient: fluid_steps, value: 1.5}}\n"),
     "s.yaml:4:54: actions[0].set.value: 1.5 is not a whole number; 1 to 4 steps per tick\n"},
    {"a shape out of range",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, shape: {growth: blur, value: 17}}\n"
           "  - {tick: 1, shape: {growth: metaphor, value: 7}}\n"
           "  - {tick: 1, shape: {growth: light, value: 2}}\n"
           "  - {tick: 1, shape: {growth: smooth, value: 1.5}}\n"),
     "s.yaml:4:44: actions[0].shape.value: 17 is out of range; 0 to 16 pixels\n"
     "s.yaml:5:48: actions[1].shape.value: 7 is out of range; 0 to 6\n"
     "s.yaml:6:45: actions[2].shape.value: 2 is out of range; 0 to 1\n"
     "s.yaml:7:46: actions[3].shape.value: 1.5 is not a whole number; 0 to 64 passes\n"},
    {"shapes that are none",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, shape: {growth: metaphor, value: vines}}\n"
           "  - {tick: 1, shape: {growth: plant, value: 1}}\n"
           "  - {tick: 1, shape: {growth: smooth}}\n"
           "  - {tick: 1, shape: {growth: light, value: perhaps}}\n"),
     "s.yaml:4:48: actions[0].shape.value: unknown choice 'vines'; did you mean vine? One of ink, vine, lightning, "
     "winter, frost, cracks, painted\n"
     "s.yaml:5:45: actions[1].shape.value: 'plant' is no value to set; plant says where it grows from\n"
     "s.yaml:6:22: actions[2].shape.value: missing; 0 to 64 passes\n"
     "s.yaml:7:45: actions[3].shape.value: 'perhaps' is neither; true or false\n"},
    {"seeds without a picture",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 5, plant: {at: [0.5, 0.5]}}\n"
           "  - {tick: 3, plant: {at: [0.5, 0.5]}}\n"
           "  - {tick: 1, stock: {}}\n"),
     "s.yaml:6:22: actions[2].stock: no picture is given; the path of one in this file's folder\n"},
    {"seeds before there is a picture",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 5, plant: {at: [0.5, 0.5]}}\n"
           "  - {tick: 3, plant: {at: [0.5, 0.5]}}\n"),
     "s.yaml:5:5: actions[1].plant: there is no picture yet; a stock before it, or at the same tick\n"},
    {"anchor and alias",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, dry: {amount: &a 1, radius: *a}}\n"),
     "s.yaml:4:30: an anchor; write the value out\n"
     "s.yaml:4:44: an alias; write the value out\n"},
    {"tag",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, dry: {amount: !!float 1}}\n"),
     "s.yaml:4:29: a tag; write the value out\n"},
    {"merge key",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, dry: {<<: {amount: 1}}}\n"),
     "s.yaml:4:21: a merge key; write the keys out\n"},
    {"a list for a key",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, dry: {? [a] : 1}}\n"),
     "s.yaml:4:23: a list for a key; a key is a word\n"},
    {"tick missing",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {dry: {}}\n"),
     "s.yaml:4:5: actions[0].tick: missing; 0 to 10000000 ticks\n"},
    {"tick twice",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, tick: 2, dry: {}}\n"),
     "s.yaml:4:15: actions[0].tick: given twice; once is enough\n"},
    {"tick negative",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: -5, dry: {}}\n"),
     "s.yaml:4:12: actions[0].tick: -5 is out of range; 0 to 10000000 ticks\n"},
    {"visitor negative",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, visitor: -1, undo: {}}\n"),
     "s.yaml:4:24: actions[0].visitor: -1 is out of range; 0 to 1000\n"},
    {"visitor twice",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1, visitor: 1, undo: {}, visitor: 2}\n"),
     "s.yaml:4:37: actions[0].visitor: given twice; once is enough\n"},
    {"no verb",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  - {tick: 1}\n"),
     "s.yaml:4:5: actions[0]: no verb; one of " VERBS "\n"},
    {"not a mapping entry",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta]\n"
           "actions:\n"
           "  -\n"),
     "s.yaml:4:3: actions[0]: nothing where an action should be; {tick: N, verb: {...}}\n"},
    {"words that are none",
     BYTES("frond: 1\n"
           "actions:\n"
           "  - {tick: 1, dose: {text: [a]}}\n"
           "  - {tick: 1, dose: {text: {at: [0.5, 2]}}}\n"
           "  - {tick: 1, dose: {text: F, formula: x}}\n"
           "  - {tick: 1, drop: {at: [0.5, 0.5], text: F}}\n"),
     "s.yaml:3:28: actions[0].dose.text: a list; words, or {words: WORDS, at: [x, y], ...}; see frond explain text\n"
     "s.yaml:4:28: actions[1].dose.text.words: missing; text, 1 to 400 bytes\n"
     "s.yaml:4:39: actions[1].dose.text.at[1]: 2 is out of range; 0 to 1 of the sheet\n"
     "s.yaml:5:21: actions[2].dose: both a formula and a text; one of them\n"
     "s.yaml:6:38: actions[3].drop.text: unknown key; one of at, ink, radius, solvent, amount, edge, brush, reach\n"},
    {"all problems, by place",
     BYTES("actions:\n"
           "  - {tick: x, drop: {radius: 0, at: [2, 3]}}\n"
           "ticks: -1\n"
           "frond: 3\n"),
     "s.yaml:2:12: actions[0].tick: 'x' is not a decimal number; 0 to 10000000 ticks\n"
     "s.yaml:2:30: actions[0].drop.radius: 0 is out of range; 0.5 to 512 cells\n"
     "s.yaml:2:38: actions[0].drop.at[0]: 2 is out of range; 0 to 1 of the sheet\n"
     "s.yaml:2:41: actions[0].drop.at[1]: 3 is out of range; 0 to 1 of the sheet\n"
     "s.yaml:3:8: ticks: -1 is out of range; 0 to 10000000 ticks\n"
     "s.yaml:4:8: frond: 3 is out of range; only 1\n"},
};

static void test_actions(void **state)
{
    (void)state;
    script_cases_check(ACTIONS, sizeof ACTIONS / sizeof *ACTIONS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_actions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
