#include "display_source.h"

static bool kms_create(struct display *display, struct display_error *error)
{
    (void)display;
    return display_fail(error, "kms: not in this build");
}

static void kms_destroy(struct display *display)
{
    (void)display;
}

const struct display_source display_kms = {.kind = DISPLAY_KMS, .create = kms_create, .destroy = kms_destroy};
