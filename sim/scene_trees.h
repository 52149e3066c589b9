/* A garden (garden.h) as a scene, planned after every tick that asks for it, with the plate that shows it. */
#ifndef FROND_SCENE_TREES_H
#define FROND_SCENE_TREES_H

#include "scene.h"

extern const struct scene_type trees_type;

#endif
