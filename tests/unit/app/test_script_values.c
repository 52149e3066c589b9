#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "script_case.h"

static const struct script_case SESSION[] = {
    {"no version", BYTES("seed: 1\n"), "s.yaml:1:1: frond: missing; only 1\n"},
    {"another version", BYTES("frond: 2\n"), "s.yaml:1:8: frond: 2 is out of range; only 1\n"},
    {"unknown top-level key",
     BYTES("frond: 1\n"
           "sed: 1\n"),
     "s.yaml:2:1: sed: unknown key; did you mean seed? One of " KEYS "\n"},
    {"a key like nothing",
     BYTES("frond: 1\n"
           "colour_of_the_sky: blue\n"),
     "s.yaml:2:1: colour_of_the_sky: unknown key; one of " KEYS "\n"},
    {"duplicate key",
     BYTES("frond: 1\n"
           "seed: 1\n"
           "seed: 2\n"),
     "s.yaml:3:1: seed: given twice, first on line 2; once is enough\n"},
    {"canvas too small",
     BYTES("frond: 1\n"
           "canvas: {width: 8}\n"),
     "s.yaml:2:17: canvas.width: 8 is out of range; 16 to 4096 cells\n"},
    {"canvas too large",
     BYTES("frond: 1\n"
           "canvas: {height: 5000, margin: 257}\n"),
     "s.yaml:2:18: canvas.height: 5000 is out of range; 16 to 4096 cells\n"
     "s.yaml:2:32: canvas.margin: 257 is out of range; 0 to 256 cells\n"},
    {"canvas misspelt",
     BYTES("frond: 1\n"
           "canvas: {heigth: 300}\n"),
     "s.yaml:2:10: canvas.heigth: unknown key; did you mean height? One of width, height, margin\n"},
    {"canvas a list",
     BYTES("frond: 1\n"
           "canvas: [720, 720]\n"),
     "s.yaml:2:9: canvas: a list; {width: cells, height: cells, margin: cells}\n"},
    {"negative seed",
     BYTES("frond: 1\n"
           "seed: -1\n"),
     "s.yaml:2:7: seed: -1 is out of range; 0 to 2147483647\n"},
    {"seed beyond 32 bits",
     BYTES("frond: 1\n"
           "seed: 4294967296\n"),
     "s.yaml:2:7: seed: 4294967296 is out of range; 0 to 2147483647\n"},
    {"huge number",
     BYTES("frond: 1\n"
           "ticks: 1e99\n"),
     "s.yaml:2:8: ticks: 1e99 is out of range; 0 to 10000000 ticks\n"},
    {"endless number",
     BYTES("frond: 1\n"
           "ticks: 1e999\n"),
     "s.yaml:2:8: ticks: 1e999 is out of range; 0 to 10000000 ticks\n"},
    {"a hundred digits",
     BYTES("frond: 1\n"
           "ticks: "
           "9999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999\n"),
     "s.yaml:2:8: ticks: 9999999999999999999999999999999999999999 is out of range; 0 to 10000000 ticks\n"},
    {"half a tick",
     BYTES("frond: 1\n"
           "ticks: 10.5\n"),
     "s.yaml:2:8: ticks: 10.5 is not a whole number; 0 to 10000000 ticks\n"},
    {"hexadecimal",
     BYTES("frond: 1\n"
           "seed: 0x10\n"),
     "s.yaml:2:7: seed: '0x10' is not a decimal number; 0 to 2147483647\n"},
    {"octal",
     BYTES("frond: 1\n"
           "seed: 0o17\n"),
     "s.yaml:2:7: seed: '0o17' is not a decimal number; 0 to 2147483647\n"},
    {"octal of old",
     BYTES("frond: 1\n"
           "seed: 017\n"),
     "s.yaml:2:7: seed: '017' is not a decimal number; 0 to 2147483647\n"},
    {"not a number",
     BYTES("frond: 1\n"
           "painting: {k: .nan}\n"),
     "s.yaml:2:15: painting.k: .nan is not finite; 1 to 4\n"},
    {"infinity",
     BYTES("frond: 1\n"
           "painting: {k: .inf, xi0: -.INF}\n"),
     "s.yaml:2:15: painting.k: .inf is not finite; 1 to 4\n"
     "s.yaml:2:26: painting.xi0: -.INF is not finite; 0 to 1\n"},
    {"nan as C writes it",
     BYTES("frond: 1\n"
           "painting: {k: nan, xi0: infinity}\n"),
     "s.yaml:2:15: painting.k: 'nan' is not a decimal number; 1 to 4\n"
     "s.yaml:2:25: painting.xi0: 'infinity' is not a decimal number; 0 to 1\n"},
    {"quoted number",
     BYTES("frond: 1\n"
           "seed: \"7\"\n"),
     "s.yaml:2:7: seed: '7' is text, not a number: leave the quotes out; 0 to 2147483647\n"},
    {"nothing",
     BYTES("frond: 1\n"
           "seed:\n"
           "ticks: ~\n"),
     "s.yaml:2:1: seed: nothing where a number should be; 0 to 2147483647\n"
     "s.yaml:3:8: ticks: nothing where a number should be; 0 to 10000000 ticks\n"},
    {"number with a unit",
     BYTES("frond: 1\n"
           "ticks: 700 frames\n"),
     "s.yaml:2:8: ticks: '700 frames' is not a decimal number; 0 to 10000000 ticks\n"},
    {"thousands",
     BYTES("frond: 1\n"
           "ticks: 1,000\n"),
     "s.yaml:2:8: ticks: '1,000' is not a decimal number; 0 to 10000000 ticks\n"},
    {"unknown ink",
     BYTES("frond: 1\n"
           "inks: [majenta]\n"),
     "s.yaml:2:8: inks[0]: unknown ink 'majenta'; did you mean magenta? One of " INKS "\n"},
    {"no ink",
     BYTES("frond: 1\n"
           "inks: []\n"),
     "s.yaml:2:7: inks: a list of 0; a list of 1 to 4 inks, by name\n"},
    {"five inks",
     BYTES("frond: 1\n"
           "inks: [cyan, magenta, yellow, black, ochre]\n"),
     "s.yaml:2:7: inks: a list of 5; a list of 1 to 4 inks, by name\n"},
    {"the same ink by another name",
     BYTES("frond: 1\n"
           "inks: [black, carbon black]\n"),
     "s.yaml:2:15: inks[1]: 'carbon black' is there already; different inks\n"},
    {"inks not a list",
     BYTES("frond: 1\n"
           "inks: cyan\n"),
     "s.yaml:2:7: inks: 'cyan'; a list of 1 to 4 inks, by name\n"},
    {"an ink that is a list",
     BYTES("frond: 1\n"
           "inks: [[cyan], magenta]\n"),
     "s.yaml:2:8: inks[0]: a list where a name should be; one of " INKS "\n"},
    {"unknown palette",
     BYTES("frond: 1\n"
           "palette: gardn\n"),
     "s.yaml:2:10: palette: unknown palette 'gardn'; did you mean garden? One of reef, garden, dusk, earth, "
     "press, harbour, kingfisher, lantern\n"},
    {"palette and inks",
     BYTES("frond: 1\n"
           "palette: reef\n"
           "inks: [cyan]\n"),
     "s.yaml:2:10: palette: inks are given too; one of the two\n"},
    {"unknown mode",
     BYTES("frond: 1\n"
           "mode: pigmnt\n"),
     "s.yaml:2:7: mode: unknown choice 'pigmnt'; did you mean pigment? One of pigment, cmy\n"},
    {"unknown coefficient",
     BYTES("frond: 1\n"
           "painting: {alpa_a: 0.25}\n"),
     "s.yaml:2:12: painting.alpa_a: unknown key; did you mean alpha_a? One of " COEFFICIENTS "\n"},
    {"coefficient out of range",
     BYTES("frond: 1\n"
           "painting: {alpha_a: 2}\n"),
     "s.yaml:2:21: painting.alpha_a: 2 is out of range; 0.01 to 1 cells^2 per unit of time\n"},
    {"just beyond both ends, and just at them",
     BYTES("frond: 1\n"
           "painting: {alpha_a: 1.0001}\n"
           "actions:\n"
           "  - {tick: 0, drop: {at: [0, 1], radius: 0.5, solvent: 1000, amount: 0}}\n"
           "  - {tick: 0, drop: {at: [0, 1.0001], radius: 512.001, solvent: -0.001}}\n"),
     "s.yaml:2:21: painting.alpha_a: 1.0001 is out of range; 0.01 to 1 cells^2 per unit of time\n"
     "s.yaml:5:30: actions[1].drop.at[1]: 1.0001 is out of range; 0 to 1 of the sheet\n"
     "s.yaml:5:47: actions[1].drop.radius: 512.001 is out of range; 0.5 to 512 cells\n"
     "s.yaml:5:65: actions[1].drop.solvent: -0.001 is out of range; 0 to 1000 density per cell\n"},
    {"coefficient twice",
     BYTES("frond: 1\n"
           "painting: {k: 2,\n"
           "  k: 3}\n"),
     "s.yaml:3:3: painting.k: given twice, first on line 2; once is enough\n"},
    {"unknown choice",
     BYTES("frond: 1\n"
           "painting: {noise: smoth, stencil: 9}\n"),
     "s.yaml:2:19: painting.noise: unknown choice 'smoth'; did you mean smooth? One of uniform, smooth, "
     "lognormal\n"
     "s.yaml:2:35: painting.stencil: unknown choice '9'; one of isotropic, nine, five, raw\n"},
    {"fraction of a step",
     BYTES("frond: 1\n"
           "painting: {fluid_steps: 2.5}\n"),
     "s.yaml:2:25: painting.fluid_steps: 2.5 is not a whole number; 1 to 4 steps per tick\n"},
    {"actions a mapping",
     BYTES("frond: 1\n"
           "actions: {tick: 1}\n"),
     "s.yaml:2:10: actions: a mapping; a list of {tick: N, verb: {...}}\n"},
    {"an action that is a number",
     BYTES("frond: 1\n"
           "actions: [5]\n"),
     "s.yaml:2:11: actions[0]: '5' where an action should be; {tick: N, verb: {...}}\n"},
};

static void test_session(void **state)
{
    (void)state;
    script_cases_check(SESSION, sizeof SESSION / sizeof *SESSION);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_session),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
