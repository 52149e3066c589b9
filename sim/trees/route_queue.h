/* The frontier of path planning: a priority queue for keys that never go below the last one taken. Keys are sorted into
 * buckets; the bucket in work is a heap, and what is pushed into it a ring of finer buckets. */
#ifndef FROND_ROUTE_QUEUE_H
#define FROND_ROUTE_QUEUE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    ROUTE_BUCKETS = 16384,
    ROUTE_RING = 128,
    ROUTE_CHUNK = 15,
    ROUTE_FINE_BITS = 8, /* keys of a bucket of the ring differ in so many bits: by less than a step */
};

struct route_entry {
    uint64_t key;
    int32_t node;
};

/* Entries of a bucket, never empty; a list of single ones would wait for memory at each. */
struct route_chunk {
    int32_t next, count;
    struct route_entry entries[ROUTE_CHUNK];
};

struct route_queue {
    struct route_chunk *pool;
    struct route_entry *heap;
    size_t pool_room, heap_room, heap_count;
    int32_t pool_count, unused; /* of the pool; the first of the free ones, -1 */
    int32_t *heads;             /* of the buckets; -1: empty */
    int cursor, shift;
    int32_t ring[ROUTE_RING]; /* first of each bucket, -1 */
    int32_t ring_count;
    uint64_t ring_low; /* bucket of the last key taken */
    bool fine;         /* the ring is in use */
    bool failed;       /* memory was short: what was pushed since is lost */
};

bool route_queue_init(struct route_queue *queue);
void route_queue_finish(struct route_queue *queue); /* takes zeroed */
/* Empties it; from now on, keys that agree but for the last `shift` bits share a bucket, and all beyond the last.
 * `fine`: keys less than 2^ROUTE_FINE_BITS apart may come in any order; nothing below the last key taken is pushed
 * then. */
void route_queue_start(struct route_queue *queue, int shift, bool fine);
void route_queue_push(struct route_queue *queue, uint64_t key, int32_t node);
/* The least key and its node; false when it is empty. `labels` not NULL: entries whose key is not that of their node
 * are dropped without order. */
bool route_queue_pop(struct route_queue *queue, const uint64_t *labels, uint64_t *key, int32_t *node);

/* A node that is likely to be taken soon, or -1: to fetch it early. */
static inline int32_t route_queue_peek(const struct route_queue *queue)
{
    int32_t at = queue->ring[queue->ring_low % ROUTE_RING];
    return at >= 0                 ? queue->pool[at].entries[queue->pool[at].count - 1].node
           : queue->heap_count > 0 ? queue->heap[0].node
                                   : -1;
}

#endif
