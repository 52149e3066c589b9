/* A garden (garden.h) as a scene, planned after every tick that asks for it, with the plate that shows it. */
#ifndef FROND_SCENE_TREES_H
#define FROND_SCENE_TREES_H

#include "scene.h"

extern const struct scene_type trees_type;

struct garden;
/* The garden of a scene of this kind, the scene's. */
struct garden *trees_garden(void *scene);

#endif
