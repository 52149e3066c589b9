#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "script_case.h"

static const struct script_case SYNTAX[] = {
    {"empty file", BYTES(""), "s.yaml:1:1: the file is empty; frond: 1, and a list of actions\n"},
    {"only a comment", BYTES("# nothing\n"), "s.yaml:1:1: the file is empty; frond: 1, and a list of actions\n"},
    {"a scalar", BYTES("5\n"), "s.yaml:1:1: '5' where a session should be; frond: 1, and a list of actions\n"},
    {"a list", BYTES("- 1\n"), "s.yaml:1:1: a list where a session should be; frond: 1, and a list of actions\n"},
    {"tab",
     BYTES("frond: 1\n"
           "canvas:\n"
           "\twidth: 300\n"),
     "s.yaml:3:1: tab character may not be used as indentation\n"},
    {"unclosed list",
     BYTES("frond: 1\n"
           "inks: [cyan\n"),
     "s.yaml:3:1: flow sequence without a closing bracket\n"},
    {"unclosed mapping",
     BYTES("frond: 1\n"
           "canvas: {width: 300\n"
           "seed: 1\n"),
     "s.yaml:3:5: missing comma in flow mapping\n"},
    {"unclosed quote", BYTES("frond: \"1\n"), "s.yaml:1:9: double-quoted scalar without closing quote\n"},
    {"indentation",
     BYTES("frond: 1\n"
           "canvas:\n"
           "  width: 300\n"
           " height: 300\n"),
     "s.yaml:4:2: invalid indentation in mapping\n"},
    {"mapping on one line", BYTES("frond: 1: 2\n"), "s.yaml:1:9: invalid nested block mapping on the same line\n"},
    {"two documents",
     BYTES("frond: 1\n"
           "---\n"
           "frond: 1\n"),
     "s.yaml:2:1: a second document; a file holds one\n"},
    {"binary",
     BYTES("\211PNG\r\n"
           "\032\n"
           "\000\000"),
     "s.yaml:1:1: byte 0x89 is not text; a script is UTF-8 text\n"},
    {"NUL",
     BYTES("frond: 1\n"
           "seed: 1\000\n"),
     "s.yaml:2:8: byte 0x00 is not text; a script is UTF-8 text\n"},
    {"Latin-1",
     BYTES("frond: 1\n"
           "# caf\351\n"),
     "s.yaml:2:6: byte 0xe9 is not text; a script is UTF-8 text\n"},
    {"UTF-16", BYTES("\377\376f\000"), "s.yaml:1:1: byte 0xff is not text; a script is UTF-8 text\n"},
    {"escaped NUL",
     BYTES("frond: 1\n"
           "mode: \"cm\\0y\"\n"),
     "s.yaml:2:7: a NUL character; a script is UTF-8 text\n"},
    {"CRLF",
     BYTES("frond: 1\r\n"
           "seed: x\r\n"),
     "s.yaml:2:7: seed: 'x' is not a decimal number; 0 to 2147483647\n"},
    {"BOM",
     BYTES("\357\273\277frond: 1\r\n"
           "seed: x\r\n"),
     "s.yaml:2:7: seed: 'x' is not a decimal number; 0 to 2147483647\n"},
    {"columns count characters",
     BYTES("frond: 1\n"
           "inks: [\"\303\251\", majenta]\n"),
     "s.yaml:2:8: inks[0]: unknown ink '\303\251'; one of " INKS "\n"
     "s.yaml:2:13: inks[1]: unknown ink 'majenta'; did you mean magenta? One of " INKS "\n"},
    {"control characters",
     BYTES("frond: 1\n"
           "mode: \"\\e[31m\\n\"\n"),
     "s.yaml:2:7: mode: unknown choice '?[31m?'; one of pigment, cmy\n"},
    {"long value",
     BYTES("frond: 1\n"
           "mode: abcdefghijabcdefghijabcdefghijabcdefghijabcdefghijabcdefghij\n"),
     "s.yaml:2:7: mode: unknown choice 'abcdefghijabcdefghijabcdefghijabcdefghij...'; one of pigment, cmy\n"},
    {"deep nesting",
     BYTES("frond: 1\n"
           "actions: [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]\n"),
     "s.yaml:2:25: nested too deep; at most 16 deep\n"},
    {"a YAML bomb",
     BYTES("a: &a [x, x]\n"
           "b: &b [*a, *a]\n"),
     "s.yaml:1:1: a: unknown key; one of " KEYS "\n"
     "s.yaml:1:1: frond: missing; only 1\n"
     "s.yaml:1:5: an anchor; write the value out\n"
     "s.yaml:2:1: b: unknown key; one of " KEYS "\n"
     "s.yaml:2:5: an anchor; write the value out\n"
     "s.yaml:2:9: an alias; write the value out\n"
     "s.yaml:2:13: an alias; write the value out\n"},
};

static void test_syntax(void **state)
{
    (void)state;
    script_cases_check(SYNTAX, sizeof SYNTAX / sizeof *SYNTAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_syntax),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
