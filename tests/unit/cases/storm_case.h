/* A storm on a small sheet, for tests. */
#ifndef STORM_CASE_H
#define STORM_CASE_H

#include "storm_state.h"

enum { STORM_CASE_WIDTH = 240, STORM_CASE_HEIGHT = 150 };

struct storm *storm_case_of(enum bolt_kind kind);
void storm_case_set(struct storm *storm, int64_t tick, const char *key, float value);
void storm_case_strike(struct storm *storm, int64_t tick, int visitor, float x, float y);
void storm_case_attract(struct storm *storm, int64_t tick, int visitor, float x, float y, float amount);
void storm_case_by(struct storm *storm, int64_t tick, enum action_verb verb, int visitor);
/* Ticks from..to, without `to`. */
void storm_case_ticks(struct storm *storm, int64_t from, int64_t to);
/* The tick after which it is calm, or `to`. */
int64_t storm_case_until_calm(struct storm *storm, int64_t from, int64_t to);

#endif
