#include "bolt_light_target.h"

#include <GLES3/gl31.h>

#include "texture.h"

static bool make(struct bolt_targets *targets, struct bolt_target *target, enum texture_filter filter, int width,
                 int height)
{
    const struct texture_def def = {.format = TEXTURE_RGBA8, .filter = filter, .width = width, .height = height};
    target->texture = texture_create(&def);
    target->width = width;
    target->height = height;
    glGenFramebuffers(1, &target->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->texture, 0);
    targets->bytes += 4 * (size_t)width * (size_t)height;
    return target->texture && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

static void finish(struct bolt_target *target)
{
    glDeleteFramebuffers(1, &target->framebuffer);
    texture_delete(&target->texture);
}

void bolt_targets_finish(struct bolt_targets *targets)
{
    finish(&targets->samples);
    finish(&targets->picture);
    texture_delete(&targets->depths);
    glDeleteRenderbuffers(1, &targets->depth);
    for (int level = 1; level <= BOLT_LEVELS; level++) {
        finish(&targets->level[level]);
        finish(&targets->sum[level]);
    }
    *targets = (struct bolt_targets){0};
}

/* Bodies: a second texture, and a test of depth. */
static bool deepen(struct bolt_targets *targets, int width, int height)
{
    static const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    const struct texture_def def = {
        .format = TEXTURE_RGBA8, .filter = TEXTURE_NEAREST, .width = width, .height = height};
    targets->depths = texture_create(&def);
    glGenRenderbuffers(1, &targets->depth);
    glBindRenderbuffer(GL_RENDERBUFFER, targets->depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, targets->samples.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, targets->depths, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, targets->depth);
    glDrawBuffers(2, both);
    targets->bytes += 8 * (size_t)width * (size_t)height;
    return targets->depths && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool bolt_targets_fit(struct bolt_targets *targets, int style, int width, int height, bool picture)
{
    if (targets->samples.texture && picture == (targets->picture.texture > 0) && targets->style == style &&
        targets->samples.width == width && targets->samples.height == height) {
        return true;
    }
    bolt_targets_finish(targets);
    targets->style = style;
    glActiveTexture(GL_TEXTURE0);
    bool good = make(targets, &targets->samples, TEXTURE_NEAREST, width, height) &&
                (style != BOLT_BODY || deepen(targets, width, height)) &&
                (!picture || make(targets, &targets->picture, TEXTURE_LINEAR, width, height));
    targets->levels = style == BOLT_LINE ? 0 : bolt_levels(width, height);
    for (int level = 1; level <= targets->levels && good; level++) {
        width = (width + 1) / 2;
        height = (height + 1) / 2;
        good = make(targets, &targets->level[level], TEXTURE_NEAREST, width, height) &&
               make(targets, &targets->sum[level], TEXTURE_NEAREST, width, height);
    }
    if (!good) {
        bolt_targets_finish(targets);
    }
    return good;
}
