#include "exhibit_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>

#include "beneath.h"
#include "folder_case.h"
#include "script_case.h"
#include "yaml.h"

static char folder[FOLDER_CASE_PATH];

static void put(const char *name, const char *text)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_true(folder_case_put(path, text));
}

static void put_folder(const char *name)
{
    char path[256];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_int_equal(mkdir(path, 0755), 0);
}

const char *exhibit_case_folder(void)
{
    char name[96];
    char *huge = malloc(YAML_SIZE_MAX + 2);
    assert_true(folder_case_make(folder));
    assert_non_null(huge);
    memset(huge, '#', YAML_SIZE_MAX + 1);
    huge[YAML_SIZE_MAX + 1] = '\0';
    put("huge.yaml", huge);
    free(huge);
    put("good.yaml", "frond: 1\nticks: 77\nactions:\n  - {tick: 3, drop: {at: [0.5, 0.5]}}\n");
    put("wrong.yaml", "frond: 1\nticks: x\nactions:\n  - {tick: 0, drop: {}}\n");
    put("text.png", "text");
    put("good.png", "a picture");
    put_folder("stock");
    put("stock/text.png", "text");
    put("stock/notes.txt", "not looked at");
    put_folder("fine");
    put("fine/good b.JPG", "a picture");
    put("fine/good a.png", "a picture");
    put_folder("many");
    for (int i = 0; i <= EXHIBIT_PICTURES; i++) {
        snprintf(name, sizeof name, "many/%03d.png", i);
        put(name, "");
    }
    snprintf(name, sizeof name, "%s/out", folder);
    assert_int_equal(symlink("/etc", name), 0);
    return folder;
}

void exhibit_case_remove(void)
{
    assert_true(folder_case_remove(folder));
}

int exhibit_case_begin(void **state)
{
    *state = (void *)(uintptr_t)exhibit_case_folder();
    return 0;
}

int exhibit_case_end(void **state)
{
    (void)state;
    exhibit_case_remove();
    return 0;
}

/* Two by two: dark on the left, light on the right. */
static bool load(void *data, const char *from, const char *path, struct script_picture *picture,
                 struct file_error *error)
{
    static const float VALUES[4] = {0, 1, 0, 1};
    int fd = beneath_open(from, path, "a picture", error);
    const char *name = strrchr(path, '/');
    (void)data;
    if (fd < 0) {
        return false;
    }
    close(fd);
    if (strncmp(name ? name + 1 : path, "good", 4) != 0) {
        snprintf(error->text, sizeof error->text, "'%s' is broken; a PNG, JPEG, TIFF, EXR or WebP picture", path);
        return false;
    }
    *picture = (struct script_picture){2, 2, 1, malloc(sizeof VALUES)};
    assert_non_null(picture->values);
    memcpy(picture->values, VALUES, sizeof VALUES);
    return true;
}

struct exhibit *exhibit_case_parse(const char *text, size_t size, struct report *report)
{
    struct script_def def = script_default_def();
    def.load = load;
    def.every_picture = true;
    return exhibit_parse(text, size, folder, &def, report);
}

struct exhibit *exhibit_case_good(const char *text)
{
    struct report report;
    report_init(&report, "s.yaml");
    struct exhibit *exhibit = exhibit_case_parse(text, strlen(text), &report);
    if (!exhibit) {
        char *told = report_text(&report);
        fail_msg("%s", told ? told : "nothing");
    }
    assert_true(report_empty(&report));
    report_finish(&report);
    return exhibit;
}

void exhibit_case_told(const struct script_case *cases, size_t count)
{
    int wrong = 0;
    for (size_t i = 0; i < count; i++) {
        struct report report;
        report_init(&report, "s.yaml");
        struct exhibit *exhibit = exhibit_case_parse(cases[i].text, cases[i].size, &report);
        char *told = report_text(&report);
        if (exhibit || !told || strcmp(told, cases[i].expected) != 0) {
            print_error("%s:\nexpected:\n%sfound:\n%s", cases[i].name, cases[i].expected, told ? told : "nothing");
            wrong++;
        }
        free(told);
        exhibit_destroy(exhibit);
        report_finish(&report);
    }
    assert_int_equal(wrong, 0);
}
