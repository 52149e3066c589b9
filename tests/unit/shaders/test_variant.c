/* The variants that a shader names, and that no other is put together. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "folder_case.h"
#include "program.h"

static const char SOURCE[] = "// A stage.\n"
                             "#variant STEPS=1|2 GUIDED=0|1\n"
                             "  # variant FLAT STEPS=8 \r\n"
                             "#variants NONE=1\n"
                             "#variant\n"
                             "void main() {}";

static void a_line_is_a_product(void **state)
{
    (void)state;
    static const char *const expected[] = {
        "#define STEPS 1\n#define GUIDED 0\n", "#define STEPS 2\n#define GUIDED 0\n",
        "#define STEPS 1\n#define GUIDED 1\n", "#define STEPS 2\n#define GUIDED 1\n",
        "#define FLAT\n#define STEPS 8\n",     "",
    };
    char defines[VARIANT_TEXT], label[VARIANT_TEXT];
    for (int i = 0; i < 6; i++) {
        assert_true(variant_defines(SOURCE, i, defines));
        assert_string_equal(defines, expected[i]);
        assert_true(variant_admits(SOURCE, defines));
    }
    assert_false(variant_defines(SOURCE, 6, defines));
    variant_label(expected[4], label);
    assert_string_equal(label, "FLAT STEPS=8");
}

static void a_stage_without_variants_takes_no_defines(void **state)
{
    (void)state;
    char defines[VARIANT_TEXT];
    assert_true(variant_defines("void main() {}\n", 0, defines));
    assert_string_equal(defines, "");
    assert_false(variant_defines("void main() {}\n", 1, defines));
    assert_true(variant_admits("void main() {}\n", NULL));
    assert_true(variant_admits("void main() {}\n", "\n"));
    assert_false(variant_admits("void main() {}\n", "#define A\n"));
}

static void only_variants_are_admitted(void **state)
{
    (void)state;
    assert_true(variant_admits(SOURCE, "#define GUIDED 1\n  #define  STEPS  2  \n\n"));
    assert_true(variant_admits(SOURCE, NULL));
    assert_false(variant_admits(SOURCE, "#define STEPS 2\n"));
    assert_false(variant_admits(SOURCE, "#define STEPS 3\n#define GUIDED 1\n"));
    assert_false(variant_admits(SOURCE, "#define STEPS\n#define GUIDED 1\n"));
    assert_false(variant_admits(SOURCE, "#define STEPS 2\n#define GUIDED 1\n#define FLAT\n"));
    assert_false(variant_admits(SOURCE, "#define FLAT\n#define STEPS 80\n"));
    assert_false(variant_admits(SOURCE, "#define FLA\n#define STEPS 8\n"));
    assert_false(variant_admits(SOURCE, "#define NONE 1\n"));
    assert_false(variant_admits(SOURCE, "float a;\n"));
}

static void write_file(const char *folder, const char *name, const char *text)
{
    char path[300];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_true(folder_case_put(path, text));
}

static void only_variants_are_put_together(void **state)
{
    (void)state;
    char path[FOLDER_CASE_PATH], defines[VARIANT_TEXT];
    struct shader_error error = {""};
    assert_true(folder_case_make(path));
    const struct shader_folder folder = {path};
    write_file(path, "a.comp", "#variant STEPS=4\n#include \"b.glsl\"\nvoid main() {}\n");
    write_file(path, "b.glsl", "float b;\n");
    write_file(path, "c.comp", "#include \"a.comp\"\n");

    char *text = shader_text(&folder, "a.comp", "#define STEPS 4\n", &error);
    assert_non_null(text);
    const char *from = strstr(text, "// 0: a.comp\n");
    assert_non_null(from); /* the line of #variant is empty: those below keep their numbers */
    assert_string_equal(from, "// 0: a.comp\n#line 1 0\n\n// 1: b.glsl\n#line 1 1\nfloat b;\n\n#line 3 0\n"
                              "void main() {}\n\n");
    free(text);
    assert_null(shader_text(&folder, "a.comp", NULL, &error));
    assert_string_equal(error.text, "a.comp: none of its #variant lines has ''");
    assert_null(shader_text(&folder, "a.comp", "#define STEPS 5\n", &error));
    assert_string_equal(error.text, "a.comp: none of its #variant lines has 'STEPS=5'");
    assert_null(shader_text(&folder, "c.comp", NULL, &error));
    assert_string_equal(error.text, "a.comp: #variant belongs into a stage");
    assert_true(shader_variant(&folder, "a.comp", 0, defines));
    assert_string_equal(defines, "#define STEPS 4\n");
    assert_false(shader_variant(&folder, "a.comp", 1, defines));
    assert_false(shader_variant(&folder, "none.comp", 0, defines));
    assert_true(folder_case_remove(path));
}

/* shaders/ has folders; so may one's own. */
static void sources_are_found_in_folders_of_the_folder(void **state)
{
    (void)state;
    char path[FOLDER_CASE_PATH], below[FOLDER_CASE_PATH + 16];
    struct shader_error error = {""};
    assert_true(folder_case_make(path));
    snprintf(below, sizeof below, "%s/painting", path);
    assert_int_equal(mkdir(below, 0700), 0);
    const struct shader_folder folder = {path};
    write_file(path, "a.comp", "#include \"b.glsl\"\nvoid main() {}\n");
    write_file(below, "b.glsl", "float b;\n");
    char *text = shader_text(&folder, "a.comp", NULL, &error);
    assert_non_null(text);
    assert_non_null(strstr(text, "float b;"));
    free(text);
    char file[300];
    snprintf(file, sizeof file, "%s/b.glsl", below);
    const struct timespec later[2] = {{4000000000, 0}, {4000000000, 5}};
    assert_int_equal(utimensat(AT_FDCWD, file, later, 0), 0);
    assert_true(shader_folder_stamp(&folder) == 4000000000000000005);
    assert_true(folder_case_remove(path));
}

/* A folder of a working copy stands for what is embedded. */
static void the_tree_has_every_embedded_source(void **state)
{
    (void)state;
    const struct shader_folder tree = {FROND_SHADERS};
    for (const struct shader_source *source = shader_sources; source->name; source++) {
        char defines[VARIANT_TEXT];
        struct shader_error error = {""};
        assert_true(shader_variant(NULL, source->name, 0, defines));
        char *embedded = shader_text(NULL, source->name, defines, &error);
        char *found = shader_text(&tree, source->name, defines, &error);
        if (!embedded || !found) {
            fail_msg("%s", error.text);
            return;
        }
        assert_string_equal(found, embedded);
        free(found);
        free(embedded);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_is_a_product),
        cmocka_unit_test(a_stage_without_variants_takes_no_defines),
        cmocka_unit_test(only_variants_are_admitted),
        cmocka_unit_test(only_variants_are_put_together),
        cmocka_unit_test(sources_are_found_in_folders_of_the_folder),
        cmocka_unit_test(the_tree_has_every_embedded_source),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
