#include "fields.h"

#include "texture.h"

static struct texture_def def_of(const struct fields *fields)
{
    return (struct texture_def){.format = TEXTURE_RGBA32F, .width = fields->width, .height = fields->height};
}

bool fields_create(struct fields *fields, int width, int height, bool xray)
{
    *fields = (struct fields){.width = width, .height = height};
    struct texture_def def = def_of(fields);
    for (int i = 0; i < (xray ? FIELDS_COUNT : FIELDS_PICTURE_COUNT); i++) {
        fields->texture[i] = texture_create(&def);
        if (!fields->texture[i]) {
            fields_finish(fields);
            return false;
        }
    }
    return true;
}

void fields_finish(struct fields *fields)
{
    for (int i = 0; i < FIELDS_COUNT; i++) {
        if (fields->texture[i]) {
            texture_delete(&fields->texture[i]);
        }
    }
    *fields = (struct fields){0};
}

void fields_upload(const struct fields *fields, const float *const texels[FIELDS_COUNT])
{
    struct texture_def def = def_of(fields);
    for (int i = 0; i < FIELDS_COUNT; i++) {
        if (texels[i] && fields->texture[i]) {
            texture_upload(fields->texture[i], &def, 0, 0, 0, fields->width, fields->height, texels[i]);
        }
    }
}
