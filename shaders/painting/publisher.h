/* Hands the fields of a painting from the thread that simulates it to the thread that shows it. Two sets of textures:
 * one is being shown, the other is filled, and they change places when the GPU has it ready. Neither thread ever waits
 * for the other: the simulation finds that its last picture has not been taken yet and goes on, the display finds
 * nothing new and shows what it has. Both threads have GL contexts of their own that share objects. */
#ifndef FROND_PUBLISHER_H
#define FROND_PUBLISHER_H

#include "engine.h"
#include "fields.h"

struct publisher;

/* In either context. `xray`: the textures of the X-ray view as well. NULL when memory is short. */
struct publisher *publisher_create(bool xray);
/* Takes NULL. In a context that still lives its textures are deleted; `lost`: they are gone already. */
void publisher_destroy(struct publisher *publisher, bool lost);

/* Simulation: publishes what the engine holds now, unless what was published last has not been taken: then false. The
 * sheet may have another size than the time before. The fields carry `number`. */
bool publisher_publish(struct publisher *publisher, struct engine *engine, uint64_t number);
/* Display: the newest fields that are ready, theirs to read until the next call; NULL before the first. `fresh` says
 * whether they are others than the last time. */
const struct fields *publisher_newest(struct publisher *publisher, bool *fresh);

#endif
