/* Names of the keys of a keyboard, by their codes of linux/input-event-codes.h. Pure. */
#ifndef FROND_KEY_NAMES_H
#define FROND_KEY_NAMES_H

#include <stdint.h>

/* "a", "7", "F1", "space"; NULL: it has no name here. */
const char *key_name_of(uint32_t code);
/* The code of a name, case aside; 0: none. */
uint32_t key_code_of(const char *name);

#endif
