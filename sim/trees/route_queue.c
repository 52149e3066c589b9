#include "route_queue.h"

#include <stdlib.h>
#include <string.h>

bool route_queue_init(struct route_queue *queue)
{
    memset(queue, 0, sizeof *queue);
    queue->pool_room = queue->heap_room = 2048;
    queue->pool = malloc(queue->pool_room * sizeof *queue->pool);
    queue->heap = malloc(queue->heap_room * sizeof *queue->heap);
    queue->heads = malloc((ROUTE_BUCKETS + 1) * sizeof *queue->heads);
    return queue->pool && queue->heap && queue->heads;
}

void route_queue_finish(struct route_queue *queue)
{
    free(queue->pool);
    free(queue->heap);
    free(queue->heads);
}

void route_queue_start(struct route_queue *queue, int shift, bool fine)
{
    memset(queue->ring, 0xff, sizeof queue->ring);
    queue->ring_count = 0;
    queue->ring_low = 0;
    queue->fine = fine;
    memset(queue->heads, 0xff, (ROUTE_BUCKETS + 1) * sizeof *queue->heads);
    queue->heap_count = 0;
    queue->pool_count = 0;
    queue->unused = -1;
    queue->cursor = -1;
    queue->shift = shift;
    queue->failed = false;
}

static bool grow_heap(struct route_queue *queue)
{
    struct route_entry *more = realloc(queue->heap, 2 * queue->heap_room * sizeof *more);
    if (more) {
        queue->heap = more;
        queue->heap_room *= 2;
    }
    return more;
}

static bool grow_pool(struct route_queue *queue)
{
    struct route_chunk *more = realloc(queue->pool, 2 * queue->pool_room * sizeof *more);
    if (more) {
        queue->pool = more;
        queue->pool_room *= 2;
    }
    return more;
}

static void heap_up(struct route_queue *queue, uint64_t key, int32_t node)
{
    if (queue->heap_count == queue->heap_room && !grow_heap(queue)) {
        queue->failed = true;
        return;
    }
    struct route_entry *heap = queue->heap;
    size_t at = queue->heap_count++;
    while (at > 0 && heap[(at - 1) / 2].key > key) {
        heap[at] = heap[(at - 1) / 2];
        at = (at - 1) / 2;
    }
    heap[at].key = key;
    heap[at].node = node;
}

static void heap_down(struct route_entry *heap, size_t count, size_t at, struct route_entry entry)
{
    for (size_t child; (child = 2 * at + 1) < count; at = child) {
        child += child + 1 < count && heap[child + 1].key < heap[child].key;
        if (heap[child].key >= entry.key) {
            break;
        }
        heap[at] = heap[child];
    }
    heap[at] = entry;
}

/* A chunk at the head of a list; -1: memory is short. */
static int32_t add_chunk(struct route_queue *queue, int32_t *head)
{
    int32_t at = queue->unused;
    if (at >= 0) {
        queue->unused = queue->pool[at].next;
    } else if ((size_t)queue->pool_count == queue->pool_room && !grow_pool(queue)) {
        queue->failed = true;
        return -1;
    } else {
        at = queue->pool_count++;
    }
    queue->pool[at].next = *head;
    queue->pool[at].count = 0;
    *head = at;
    return at;
}

static void chain(struct route_queue *queue, int32_t *head, uint64_t key, int32_t node)
{
    int32_t at = *head;
    if (at < 0 || queue->pool[at].count == ROUTE_CHUNK) {
        at = add_chunk(queue, head);
    }
    if (at >= 0) {
        struct route_chunk *chunk = &queue->pool[at];
        chunk->entries[chunk->count++] = (struct route_entry){key, node};
    }
}

void route_queue_push(struct route_queue *queue, uint64_t key, int32_t node)
{
    uint64_t bucket = key >> queue->shift, fine = key >> ROUTE_FINE_BITS;
    bucket = bucket < ROUTE_BUCKETS ? bucket : ROUTE_BUCKETS;
    if ((int)bucket > queue->cursor) {
        chain(queue, &queue->heads[bucket], key, node);
    } else if (queue->fine && fine - queue->ring_low < ROUTE_RING) {
        chain(queue, &queue->ring[fine % ROUTE_RING], key, node);
        queue->ring_count++;
    } else {
        heap_up(queue, key, node);
    }
}

/* Makes the next bucket that holds anything the heap. */
static void open_bucket(struct route_queue *queue, const uint64_t *labels)
{
    int32_t at = queue->heads[queue->cursor];
    queue->heads[queue->cursor] = -1;
    while (at >= 0) {
        struct route_chunk *chunk = &queue->pool[at];
        int32_t next = chunk->next;
        while (queue->heap_room < queue->heap_count + ROUTE_CHUNK) {
            if (!grow_heap(queue)) {
                queue->failed = true;
                return;
            }
        }
        for (int32_t i = 0; i < chunk->count; i++) {
            queue->heap[queue->heap_count] = chunk->entries[i];
            queue->heap_count += !labels || labels[chunk->entries[i].node] == chunk->entries[i].key;
        }
        chunk->next = queue->unused;
        queue->unused = at;
        at = next;
    }
    for (size_t i = queue->heap_count / 2; i-- > 0;) {
        heap_down(queue->heap, queue->heap_count, i, queue->heap[i]);
    }
}

static void take_first(struct route_queue *queue, uint64_t *key, int32_t *node)
{
    *key = queue->heap[0].key;
    *node = queue->heap[0].node;
    queue->heap_count--;
    if (queue->heap_count > 0) {
        heap_down(queue->heap, queue->heap_count, 0, queue->heap[queue->heap_count]);
    }
    queue->ring_low = *key >> ROUTE_FINE_BITS;
}

static void take_from_ring(struct route_queue *queue, uint64_t low, uint64_t *key, int32_t *node)
{
    int32_t *head = &queue->ring[low % ROUTE_RING], at = *head;
    struct route_chunk *chunk = &queue->pool[at];
    *key = chunk->entries[--chunk->count].key;
    *node = chunk->entries[chunk->count].node;
    if (chunk->count == 0) {
        *head = chunk->next;
        chunk->next = queue->unused;
        queue->unused = at;
    }
    queue->ring_count--;
    queue->ring_low = low;
}

bool route_queue_pop(struct route_queue *queue, const uint64_t *labels, uint64_t *key, int32_t *node)
{
    while (queue->heap_count == 0 && queue->ring_count == 0) {
        do {
            if (++queue->cursor > ROUTE_BUCKETS) {
                queue->cursor = ROUTE_BUCKETS;
                return false;
            }
        } while (queue->heads[queue->cursor] < 0);
        open_bucket(queue, labels);
    }
    if (queue->ring_count == 0) {
        take_first(queue, key, node);
        return true;
    }
    uint64_t low = queue->ring_low;
    while (queue->ring[low % ROUTE_RING] < 0) {
        low++;
    }
    if (queue->heap_count > 0 && queue->heap[0].key >> ROUTE_FINE_BITS <= low) {
        take_first(queue, key, node);
    } else {
        take_from_ring(queue, low, key, node);
    }
    return true;
}
