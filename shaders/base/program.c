#include "program.h"

#include <dirent.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <GLES3/gl31.h>

#include "variant.h"

enum { INCLUDES_MOST = 32, SOURCE_MOST = 1 << 20, PATH_MOST = 1024 };

/* Integers and floats whole: 16 bits of precision are not enough for any field. */
static const char PREAMBLE[] = "#version 310 es\n"
                               "precision highp float;\n"
                               "precision highp int;\n"
                               "precision highp sampler2D;\n"
                               "precision highp sampler2DArray;\n"
                               "precision highp usampler2D;\n"
                               "precision highp image2D;\n"
                               "precision highp image2DArray;\n";

bool shader_fail(struct shader_error *error, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error->text, sizeof error->text, format, arguments);
    va_end(arguments);
    return false;
}

struct text {
    char *bytes;
    size_t length, size;
    bool short_of_memory;
};

static void append(struct text *text, const char *bytes, size_t count)
{
    if (text->length + count + 1 > text->size) {
        size_t size = 2 * (text->length + count + 1);
        char *larger = realloc(text->bytes, size);
        if (!larger) {
            text->short_of_memory = true;
            return;
        }
        text->bytes = larger;
        text->size = size;
    }
    memcpy(text->bytes + text->length, bytes, count);
    text->length += count;
    text->bytes[text->length] = '\0';
}

static FILE *open_in(const char *folder, const char *name)
{
    char path[PATH_MOST];
    int length = snprintf(path, sizeof path, "%s/%s", folder, name);
    return length > 0 && length < PATH_MOST ? fopen(path, "rb") : NULL;
}

/* In the folder itself, or in one of its own. */
static FILE *open_source(const char *folder, const char *name)
{
    FILE *file = open_in(folder, name);
    DIR *directory = file ? NULL : opendir(folder);
    for (struct dirent *entry; directory && !file && (entry = readdir(directory));) {
        char below[PATH_MOST];
        if (entry->d_name[0] != '.' && snprintf(below, sizeof below, "%s/%s", folder, entry->d_name) < PATH_MOST) {
            file = open_in(below, name);
        }
    }
    if (directory) {
        closedir(directory);
    }
    return file;
}

static char *read_source(const char *folder, const char *name)
{
    FILE *file = open_source(folder, name);
    char *bytes = file ? malloc(SOURCE_MOST + 1) : NULL;
    size_t count = bytes ? fread(bytes, 1, SOURCE_MOST, file) : 0;
    if (file) {
        fclose(file);
    }
    if (bytes) {
        bytes[count] = '\0';
    }
    return bytes;
}

static char *copy_embedded(const char *name)
{
    for (const struct shader_source *source = shader_sources; source->name; source++) {
        if (strcmp(source->name, name) == 0) {
            return strdup(source->text);
        }
    }
    return NULL;
}

static char *load_source(const struct shader_folder *folder, const char *name)
{
    return folder && folder->path ? read_source(folder->path, name) : copy_embedded(name);
}

bool shader_variant(const struct shader_folder *folder, const char *name, int index, char defines[VARIANT_TEXT])
{
    char *source = load_source(folder, name);
    bool found = source && variant_defines(source, index, defines);
    free(source);
    return found;
}

/* Of what lies in a folder, and `depth` folders further down; ns. */
static long long newest_in(const char *folder, int depth)
{
    DIR *directory = opendir(folder);
    long long newest = 0;
    for (struct dirent *entry; directory && (entry = readdir(directory));) {
        char path[PATH_MOST];
        struct stat status;
        if (entry->d_name[0] == '.' || snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) >= PATH_MOST ||
            stat(path, &status) != 0) {
            continue;
        }
        long long time = (long long)status.st_mtim.tv_sec * 1000000000 + status.st_mtim.tv_nsec;
        long long below = depth > 0 && S_ISDIR(status.st_mode) ? newest_in(path, depth - 1) : 0;
        time = below > time ? below : time;
        newest = time > newest ? time : newest;
    }
    if (directory) {
        closedir(directory);
    }
    return newest;
}

long long shader_folder_stamp(const struct shader_folder *folder)
{
    return folder && folder->path ? newest_in(folder->path, 1) : 0;
}

struct assembly {
    const struct shader_folder *folder;
    struct text text;
    char included[INCLUDES_MOST][64]; /* the number of a file in #line is its place here */
    int count;
    const char *defines;
    struct shader_error *error;
};

static bool add_source(struct assembly *assembly, const char *name, const char *from);

/* `#include "NAME"`: the name, or false. */
static bool parse_include(const char *line, char name[64])
{
    return sscanf(line, " # include \"%63[^\"]\"", name) == 1;
}

static bool add_lines(struct assembly *assembly, const char *source, int number)
{
    int line = 1;
    char mark[32], name[64];
    for (const char *at = source; *at; line++) {
        const char *end = strchr(at, '\n');
        size_t length = end ? (size_t)(end - at) + 1 : strlen(at);
        if (variant_is_line(at)) {
            append(&assembly->text, "\n", 1);
        } else if (!parse_include(at, name)) {
            append(&assembly->text, at, length);
        } else if (!add_source(assembly, name, assembly->included[number])) {
            return false;
        } else {
            snprintf(mark, sizeof mark, "#line %d %d\n", line + 1, number);
            append(&assembly->text, mark, strlen(mark));
        }
        at += length;
    }
    append(&assembly->text, "\n", 1);
    return true;
}

/* A stage has the defines of one of its variants; only a stage has variants. */
static bool check_variant(const struct assembly *assembly, const char *name, const char *source, bool stage)
{
    char label[VARIANT_TEXT];
    if (stage && !variant_admits(source, assembly->defines)) {
        variant_label(assembly->defines, label);
        return shader_fail(assembly->error, "%s: none of its #variant lines has '%s'", name, label);
    }
    for (const char *line = stage ? NULL : source; line; line = strchr(line, '\n')) {
        line += *line == '\n';
        if (variant_is_line(line)) {
            return shader_fail(assembly->error, "%s: #variant belongs into a stage", name);
        }
    }
    return true;
}

static bool add_source(struct assembly *assembly, const char *name, const char *from)
{
    char mark[96];
    for (int i = 0; i < assembly->count; i++) {
        if (strcmp(assembly->included[i], name) == 0) {
            return true;
        }
    }
    if (assembly->count == INCLUDES_MOST || strlen(name) >= sizeof assembly->included[0]) {
        return shader_fail(assembly->error, "%s: too many includes, or too long a name", name);
    }
    char *source = load_source(assembly->folder, name);
    if (!source) {
        return shader_fail(assembly->error, "%s: no such shader source%s%s", name, from ? ", included by " : "",
                           from ? from : "");
    }
    int number = assembly->count++;
    snprintf(assembly->included[number], sizeof assembly->included[number], "%s", name);
    snprintf(mark, sizeof mark, "// %d: %s\n#line 1 %d\n", number, name, number);
    append(&assembly->text, mark, strlen(mark));
    bool good = check_variant(assembly, name, source, !from) && add_lines(assembly, source, number);
    free(source);
    return good;
}

char *shader_text(const struct shader_folder *folder, const char *name, const char *defines, struct shader_error *error)
{
    struct assembly assembly = {.folder = folder, .defines = defines, .error = error};
    append(&assembly.text, PREAMBLE, strlen(PREAMBLE));
    if (defines) {
        append(&assembly.text, defines, strlen(defines));
        append(&assembly.text, "\n", 1);
    }
    bool good = add_source(&assembly, name, NULL);
    if (good && assembly.text.short_of_memory) {
        good = shader_fail(error, "%s: memory is short", name);
    }
    if (!good) {
        free(assembly.text.bytes);
        return NULL;
    }
    return assembly.text.bytes;
}

static GLuint compile(GLenum type, const struct shader_folder *folder, const char *name, const char *defines,
                      struct shader_error *error)
{
    char *text = shader_text(folder, name, defines, error);
    if (!text) {
        return 0;
    }
    GLuint shader = glCreateShader(type);
    GLint good = GL_FALSE;
    char log[800] = "";
    const char *parts[1] = {text};
    glShaderSource(shader, 1, parts, NULL);
    glCompileShader(shader);
    free(text);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        shader_fail(error, "%s: %s", name, log);
        glDeleteShader(shader);
        return 0;
    }
    return shader;
}

static unsigned link_stages(GLuint first, GLuint second, const char *name, struct shader_error *error)
{
    GLuint program = glCreateProgram();
    GLint good = GL_FALSE;
    char log[800] = "";
    glAttachShader(program, first);
    if (second) {
        glAttachShader(program, second);
    }
    glLinkProgram(program);
    glDeleteShader(first);
    glDeleteShader(second);
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) {
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        shader_fail(error, "%s: %s", name, log);
        glDeleteProgram(program);
        return 0;
    }
    return program;
}

unsigned program_compute(const struct shader_folder *folder, const char *name, const char *defines,
                         struct shader_error *error)
{
    GLuint shader = compile(GL_COMPUTE_SHADER, folder, name, defines, error);
    return shader ? link_stages(shader, 0, name, error) : 0;
}

unsigned program_draw(const struct shader_folder *folder, const char *vertex, const char *fragment, const char *defines,
                      struct shader_error *error)
{
    char *source = load_source(folder, vertex);
    const char *common = source && variant_admits(source, defines) ? defines : NULL;
    free(source);
    GLuint first = compile(GL_VERTEX_SHADER, folder, vertex, common, error);
    GLuint second = first ? compile(GL_FRAGMENT_SHADER, folder, fragment, defines, error) : 0;
    if (!second) {
        glDeleteShader(first);
        return 0;
    }
    return link_stages(first, second, fragment, error);
}
