/* Memory of the models: taken once, large pieces on huge pages. */
#ifndef FROND_MEMORY_H
#define FROND_MEMORY_H

#include <stddef.h>

/* Zeroed memory for `count` things of `size` bytes, at least 64-byte aligned; its bytes are added to `bytes`. Release
 * with free. NULL when memory is short. */
void *memory_take(size_t count, size_t size, size_t *bytes);

#endif
