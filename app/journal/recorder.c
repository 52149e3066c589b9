#include "recorder.h"

#include <stdio.h>

struct journal_sheet recorder_sheet(const struct studio_event *event, const char *scene)
{
    struct journal_sheet sheet = journal_sheet_of(event->script, &event->def);
    sheet.history = event->history;
    snprintf(sheet.scene, sizeof sheet.scene, "%s", scene);
    return sheet;
}

void recorder_write(struct journal_writer *writer, const struct studio_event *event, int64_t since, const char *scene)
{
    int64_t ticked = event->ticked - since;
    struct journal_sheet sheet;
    switch (event->kind) {
    case STUDIO_SHEET:
        sheet = recorder_sheet(event, scene);
        journal_sheet(writer, ticked, &sheet);
        break;
    case STUDIO_SCENE:
        sheet = recorder_sheet(event, scene);
        journal_scene(writer, ticked, &sheet);
        break;
    case STUDIO_GRID:
        journal_grid(writer, ticked, event->def.width, event->def.height, event->def.margin);
        break;
    case STUDIO_ACTION:
        journal_action(writer, ticked, event->action);
        break;
    case STUDIO_RESTORED:
        journal_restored(writer, ticked, event->lost);
        break;
    case STUDIO_TICKED:
    case STUDIO_TAKING:
    case STUDIO_WHOLE:
        break;
    }
}
