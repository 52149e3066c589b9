/* A finished sheet, kept as a texture with row 0 at its top, put onto a panel and turned. Private to the pictures. */
#ifndef FROND_SHOW_H
#define FROND_SHOW_H

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
/* Binds a framebuffer, its viewport, and nothing between the fragments and its pixels. */
void show_target(unsigned framebuffer, int width, int height);

#endif
