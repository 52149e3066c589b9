#include "memory.h"

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum { HUGE_PAGE = 2 << 20 };

/* Large pieces begin on a huge page: rows of many fields otherwise exhaust the TLB. */
void *memory_take(size_t count, size_t size, size_t *bytes)
{
    size_t whole = count * size, align = whole >= HUGE_PAGE ? HUGE_PAGE : 64;
    void *memory = aligned_alloc(align, (whole + align - 1) / align * align);
    if (memory) {
        if (align == HUGE_PAGE) {
            (void)madvise(memory, whole, MADV_HUGEPAGE); /* advice: nothing is lost where it is not taken */
        }
        memset(memory, 0, whole);
        *bytes += whole;
    }
    return memory;
}
