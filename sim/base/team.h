/* A team of threads that share numbered pieces of work. Which thread does which piece is not fixed, so pieces must not
 * depend on one another. */
#ifndef FROND_TEAM_H
#define FROND_TEAM_H

struct team;

/* One piece of work: `piece` in 0..pieces-1, by thread `member` in 0..team_size-1. */
typedef void team_work(void *context, int piece, int member);

/* `threads` workers, the caller counted as one; 0: one for each processor. NULL when a thread or memory cannot be had.
 */
struct team *team_create(int threads);
void team_destroy(struct team *team); /* takes NULL */
int team_size(const struct team *team);
/* Does all pieces and returns when the last is done. */
void team_run(struct team *team, team_work *work, void *context, int pieces);

#endif
