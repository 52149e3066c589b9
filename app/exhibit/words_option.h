/* What visitors call values that dials turn, and the choices of them: short, for a label beside the palette. Staff and
 * files know them by the names of their keys. */
#ifndef FROND_WORDS_OPTION_H
#define FROND_WORDS_OPTION_H

#include "key.h"

/* The word for the name of a key or of a choice in a language of words.h; where there is none the English one, else
 * the name itself, its first letter a capital and each _ a space, written to `text`. Never NULL. */
const char *words_option(const char *name, int language, char *text, int size);
/* A value of a key: a word of a choice, a number in the digits of the language with as many places as matter. */
void words_value(const struct key *key, float value, int language, char *text, int size);

#endif
