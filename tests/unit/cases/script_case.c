#include "script_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "script.h"

void script_cases_check(const struct script_case *cases, size_t count)
{
    struct script_def def = script_default_def();
    for (size_t i = 0; i < count; i++) {
        struct report report;
        report_init(&report, "s.yaml");
        struct script *script = script_parse(cases[i].text, cases[i].size, ".", &def, &report);
        char *text = report_text(&report);
        if (script || !text || strcmp(text, cases[i].expected) != 0) {
            print_error("%s:\nexpected:\n%sfound:\n%s", cases[i].name, cases[i].expected, text ? text : "nothing");
            fail();
        }
        free(text);
        script_destroy(script);
        report_finish(&report);
    }
}
