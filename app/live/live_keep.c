#define _GNU_SOURCE /* memfd_create */
#include "live_keep.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "script_sheet.h"

/* Whether the painting that was found can be gone on with in a scene: its inks are the same, in the same order. */
static bool suits(const struct keep_found *found, const struct exhibit_scene *scene)
{
    const struct script *script = scene->script;
    bool same = found->sheet.ink_count == script->ink_count && found->sheet.mode == script->mode &&
                strcmp(found->sheet.scene, scene->id) == 0;
    for (int i = 0; same && i < script->ink_count; i++) {
        same = found->sheet.inks[i] == script->inks[i];
    }
    return same;
}

static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

void live_keep_open(struct live_keep *keep, const char *state, const struct exhibit *exhibit, enum engine_kind engine,
                    struct live_scene *scene)
{
    char folder[1200];
    *keep = (struct live_keep){.scene = -1};
    if (!state || !exhibit) {
        return;
    }
    struct keep_def def = keep_default_def();
    snprintf(folder, sizeof folder, "%s/painting", state);
    snprintf(def.head.version, sizeof def.head.version, "%s", FROND_VERSION);
    snprintf(def.head.engine, sizeof def.head.engine, "%s", engine_kind_name(engine));
    snprintf(def.head.exhibit, sizeof def.head.exhibit, "%s", name_of(exhibit->path));
    def.folder = folder;
    bool found = keep_find(folder, KEEP_REPEAT_S, &keep->found);
    for (int i = 0; found && i < exhibit->scene_count; i++) {
        keep->scene = suits(&keep->found, &exhibit->scenes[i]) ? i : keep->scene;
    }
    const struct exhibit_scene *taken = keep->scene >= 0 ? &exhibit->scenes[keep->scene] : NULL;
    if (taken && taken->kind != SCENE_PAINTING) { /* the journal is the keep's from now on */
        live_scene_resume(scene, taken->script, (enum scene_kind)taken->kind, taken->id, keep->found.journal.data,
                          keep->found.journal.size);
    }
    keep->keep = keep_create(&def, keep->scene >= 0 ? &keep->found : NULL);
}

void live_keep_close(struct live_keep *keep)
{
    keep_destroy(keep->keep);
    keep_found_finish(&keep->found);
    *keep = (struct live_keep){.scene = -1};
}

void live_keep_studio(struct live_keep *keep, const struct exhibit *exhibit, struct studio_def *def)
{
    if (keep->keep) {
        def->teller = (struct studio_teller){keep_tell, keep->keep};
    }
    if (keep->scene >= 0) {
        def->script = exhibit->scenes[keep->scene].script;
        def->from = &keep->found.checkpoint;
        def->from_ticked = keep->found.ticked;
    }
}

void live_keep_visit(struct live_keep *keep, bool on)
{
    if (keep->keep) {
        keep_visit(keep->keep, on);
    }
}

void live_keep_scene(struct live_keep *keep, const struct exhibit_scene *scene)
{
    if (keep->keep) {
        keep_scene(keep->keep, scene->id);
    }
}

int live_keep_journal(struct live_keep *keep)
{
    struct bytes journal = {.data = NULL};
    int fd = -1;
    if (keep->keep && keep_journal(keep->keep, &journal)) {
        fd = memfd_create("journal", MFD_CLOEXEC);
        if (fd >= 0 && !file_write_whole(fd, journal.data, journal.size)) {
            close(fd);
            fd = -1;
        }
    }
    bytes_finish(&journal);
    return fd;
}

bool live_keep_log(struct live_keep *keep, char *line, int size)
{
    if (!keep->said) {
        keep->said = true;
        snprintf(line, (size_t)size, "%s%s", keep->found.line,
                 keep->found.line[0] && keep->scene < 0 && keep->found.checkpoint.planes
                     ? "; the exhibit is another one"
                     : "");
        if (line[0]) {
            return true;
        }
    }
    return keep->keep && keep_log(keep->keep, line, size);
}
