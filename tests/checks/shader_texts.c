/* shader_texts OUT [FOLDER]: writes every stage of shaders/ (the embedded ones) or of FOLDER into the folder OUT, put
 * together as the library does it, in every variant that the library takes. Prints a line for each: its file, its name,
 * its variant, with tabs between. Exit status 1 with a line on stderr for each that cannot be put together. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "program.h"

struct writer {
    const char *out;
    struct shader_folder folder;
    int count, failures;
};

static const char *stage_of(const char *name)
{
    const char *dot = strrchr(name, '.');
    bool stage = dot && (strcmp(dot, ".comp") == 0 || strcmp(dot, ".vert") == 0 || strcmp(dot, ".frag") == 0);
    return stage ? dot + 1 : NULL;
}

static void write_text(struct writer *writer, const char *name, const char *defines)
{
    char path[1024], label[VARIANT_TEXT];
    struct shader_error error;
    char *text = shader_text(&writer->folder, name, defines, &error);
    snprintf(path, sizeof path, "%s/%d.%s", writer->out, writer->count++, stage_of(name));
    FILE *file = text ? fopen(path, "w") : NULL;
    if (!text) {
        fprintf(stderr, "%s\n", error.text);
        writer->failures++;
    } else if (!file || fputs(text, file) == EOF) {
        fprintf(stderr, "%s: cannot be written\n", path);
        writer->failures++;
    } else {
        variant_label(defines, label);
        printf("%s\t%s\t%s\n", path, name, label);
    }
    if (file && fclose(file) != 0) {
        fprintf(stderr, "%s: cannot be written\n", path);
        writer->failures++;
    }
    free(text);
}

static void write_stage(struct writer *writer, const char *name)
{
    char defines[VARIANT_TEXT];
    if (!stage_of(name)) {
        return;
    }
    for (int i = 0; shader_variant(&writer->folder, name, i, defines); i++) {
        write_text(writer, name, defines);
    }
}

int main(int argc, char *argv[])
{
    if (argc < 2 || argc > 3) {
        fprintf(stderr, "usage: shader_texts OUT [FOLDER]\n");
        return 2;
    }
    struct writer writer = {.out = argv[1], .folder.path = argc > 2 ? argv[2] : NULL};
    if (!writer.folder.path) {
        for (const struct shader_source *source = shader_sources; source->name; source++) {
            write_stage(&writer, source->name);
        }
        return writer.failures > 0;
    }
    DIR *directory = opendir(writer.folder.path);
    if (!directory) {
        fprintf(stderr, "%s: cannot be opened\n", writer.folder.path);
        return 1;
    }
    for (struct dirent *entry; (entry = readdir(directory));) {
        write_stage(&writer, entry->d_name);
    }
    closedir(directory);
    return writer.failures > 0;
}
