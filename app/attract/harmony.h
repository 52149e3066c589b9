/* Which inks go together: those of a scene by hue. One leads, its neighbour runs through it, the one that is farthest
 * away is an accent. */
#ifndef FROND_HARMONY_H
#define FROND_HARMONY_H

#include "dice.h"
#include "painting.h"

struct harmony {
    int count;
    float hue[PAINTING_INKS], colour[PAINTING_INKS]; /* turns; how strong, 0 is grey */
    float mixed[PAINTING_INKS][PAINTING_INKS];       /* how strong the colour of two together is */
    int lead, near, accent;                          /* inks of the scene */
};

struct harmony_pair {
    int first, second, third; /* inks of the scene */
    float share;              /* of the second, beside the first: 0..1 */
};

/* `indices`: of the scene's inks, as of ink_find(); 1..PAINTING_INKS of them. */
void harmony_init(struct harmony *harmony, const int *indices, int count, struct dice *dice);
/* For the bloom of that number; `weight`: 1 for the one that leads. */
struct harmony_pair harmony_choose(const struct harmony *harmony, float weight, int number, struct dice *dice);
int harmony_any(const struct harmony *harmony, struct dice *dice);

#endif
