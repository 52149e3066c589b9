/* Another program, fed through its standard input. Its messages go where ours go. */
#ifndef FROND_FEED_H
#define FROND_FEED_H

#include <stdbool.h>
#include <stddef.h>

#include "file.h"

struct feed;

/* Starts `arguments[0]`, looked for along PATH; `arguments` ends with NULL. NULL with one line in `error` when it is
 * not there or cannot be started. */
struct feed *feed_open(char *const arguments[], struct file_error *error);
/* Gives it all of it; waits as long as it is busy. False when it has gone, which raises no signal. */
bool feed_put(struct feed *feed, const void *data, size_t size);
/* Tells it that this was all, and waits for its end. Whether it ended well; takes NULL (false). */
bool feed_close(struct feed *feed);

#endif
