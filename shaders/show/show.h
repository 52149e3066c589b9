/* A finished sheet, kept as a texture with row 0 at its top, put onto a panel and turned. Private to what is drawn on
 * panels. */
#ifndef FROND_SHOW_H
#define FROND_SHOW_H

#include <stdbool.h>

#include "program.h"

/* GL name of the program; 0 with the reason in `error`. */
unsigned show_program(const struct shader_folder *folder, struct shader_error *error);

struct show {
    unsigned program, texture;
    int width, height; /* pixels of the texture */
    float opacity;     /* 1: it covers what was there */
    bool clear;        /* it covers as its own alpha says, which it is multiplied by */
};
/* Onto all of a framebuffer of panel_width x panel_height pixels; `turn` as picture_gpu_present. */
void show_sheet(const struct show *show, unsigned framebuffer, int panel_width, int panel_height, const float turn[4]);
/* Whether pixels of a sheet of width x height, turned so, are those of the panel. */
bool show_is_exact(int width, int height, int panel_width, int panel_height, const float turn[4]);
/* What is drawn from here on covers as its own alpha says, which it is multiplied by; until show_target or
 * glDisable(GL_BLEND). */
void show_over(void);
/* Whether a turn is by a quarter: the panel's width is along the sheet's height. */
bool show_is_turned(const float turn[4]);
/* Binds a framebuffer, its viewport, and nothing between the fragments and its pixels. */
void show_target(unsigned framebuffer, int width, int height);

#endif
