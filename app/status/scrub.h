/* Takes out of texts what is nobody else's business: words that were learnt (host name, users, serial numbers),
 * wherever they stand as words of their own, in whatever case; and what looks like a network address, a hardware
 * address, an e-mail address or a unique number (UUID, machine id). */
#ifndef FROND_SCRUB_H
#define FROND_SCRUB_H

#include <stdbool.h>
#include <stddef.h>

struct scrub;

/* NULL when memory is short. */
struct scrub *scrub_create(void);
void scrub_destroy(struct scrub *scrub); /* takes NULL */
/* `word` becomes `instead` ("[host]"), which must live as long as the scrub. Blanks around it do not count; a word of
 * one character, or without a letter or digit, is not learnt. False when memory is short. */
bool scrub_learn(struct scrub *scrub, const char *word, const char *instead);
/* The host name, users of this machine that are people, serial numbers of the board and of what is plugged in, as far
 * as this process may read them. False when memory is short. */
bool scrub_learn_machine(struct scrub *scrub);
/* A clean copy, for the caller to free; NULL when memory is short. */
char *scrub_text(const struct scrub *scrub, const char *text);

#endif
