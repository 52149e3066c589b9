#include "team.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

enum {
    MOST_THREADS = 64,
    PATIENCE = 4000, /* looks at the other side before sleeping: some 10 us, what a wake-up costs */
};

struct team {
    pthread_mutex_t mutex;
    pthread_cond_t start, finished;
    pthread_t threads[MOST_THREADS];
    int size;
    bool leaving;
    team_work *work;
    void *context;
    int pieces;
    atomic_int next;  /* piece to take */
    atomic_int round; /* counts calls of team_run */
    atomic_int busy;  /* members other than the caller still at work */
};

struct member {
    struct team *team;
    int index;
};

static void relax(void)
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

static void take_pieces(struct team *team, int member)
{
    for (;;) {
        int piece = atomic_fetch_add_explicit(&team->next, 1, memory_order_relaxed);
        if (piece >= team->pieces) {
            return;
        }
        team->work(team->context, piece, member);
    }
}

static void await_round(struct team *team, int seen)
{
    for (int i = 0; i < PATIENCE; i++) {
        if (atomic_load_explicit(&team->round, memory_order_acquire) != seen) {
            return;
        }
        relax();
    }
    pthread_mutex_lock(&team->mutex);
    while (atomic_load_explicit(&team->round, memory_order_acquire) == seen) {
        pthread_cond_wait(&team->start, &team->mutex);
    }
    pthread_mutex_unlock(&team->mutex);
}

static void *member_main(void *argument)
{
    struct member *member = argument;
    struct team *team = member->team;
    int index = member->index;
    free(member);
    for (int seen = 0;; seen++) {
        await_round(team, seen);
        if (team->leaving) {
            return NULL;
        }
        take_pieces(team, index);
        if (atomic_fetch_sub_explicit(&team->busy, 1, memory_order_acq_rel) == 1) {
            pthread_mutex_lock(&team->mutex);
            pthread_cond_signal(&team->finished);
            pthread_mutex_unlock(&team->mutex);
        }
    }
}

static void call_round(struct team *team)
{
    pthread_mutex_lock(&team->mutex);
    atomic_fetch_add_explicit(&team->round, 1, memory_order_release);
    pthread_cond_broadcast(&team->start);
    pthread_mutex_unlock(&team->mutex);
}

struct team *team_create(int threads)
{
    struct team *team = calloc(1, sizeof *team);
    if (!team) {
        return NULL;
    }
    if (threads <= 0) {
        threads = (int)sysconf(_SC_NPROCESSORS_ONLN);
    }
    threads = threads < 1 ? 1 : threads;
    threads = threads > MOST_THREADS ? MOST_THREADS : threads;
    pthread_mutex_init(&team->mutex, NULL);
    pthread_cond_init(&team->start, NULL);
    pthread_cond_init(&team->finished, NULL);
    team->size = 1;
    for (int i = 1; i < threads; i++) {
        struct member *member = malloc(sizeof *member);
        if (member) {
            *member = (struct member){team, i};
        }
        if (!member || pthread_create(&team->threads[i], NULL, member_main, member) != 0) {
            free(member);
            team_destroy(team);
            return NULL;
        }
        team->size++;
    }
    return team;
}

void team_destroy(struct team *team)
{
    if (!team) {
        return;
    }
    team->leaving = true;
    call_round(team);
    for (int i = 1; i < team->size; i++) {
        pthread_join(team->threads[i], NULL);
    }
    pthread_cond_destroy(&team->finished);
    pthread_cond_destroy(&team->start);
    pthread_mutex_destroy(&team->mutex);
    free(team);
}

int team_size(const struct team *team)
{
    return team->size;
}

void team_run(struct team *team, team_work *work, void *context, int pieces)
{
    if (team->size == 1 || pieces <= 1) {
        for (int piece = 0; piece < pieces; piece++) {
            work(context, piece, 0);
        }
        return;
    }
    team->work = work;
    team->context = context;
    team->pieces = pieces;
    atomic_store_explicit(&team->next, 0, memory_order_relaxed);
    atomic_store_explicit(&team->busy, team->size - 1, memory_order_relaxed);
    call_round(team);
    take_pieces(team, 0);
    for (int i = 0; i < PATIENCE; i++) {
        if (atomic_load_explicit(&team->busy, memory_order_acquire) == 0) {
            return;
        }
        relax();
    }
    pthread_mutex_lock(&team->mutex);
    while (atomic_load_explicit(&team->busy, memory_order_acquire) != 0) {
        pthread_cond_wait(&team->finished, &team->mutex);
    }
    pthread_mutex_unlock(&team->mutex);
}
