/* What the kernel tells of its displays, through udev: something was plugged in or out. */
#ifndef FROND_KMS_WATCH_H
#define FROND_KMS_WATCH_H

#include <stdbool.h>

struct kms_watch;

/* NULL when there is no such thing here; looking now and then has to do. */
struct kms_watch *kms_watch_create(void);
void kms_watch_destroy(struct kms_watch *watch); /* takes NULL */
int kms_watch_fd(const struct kms_watch *watch); /* readable when there is news; -1: takes NULL */
/* Whether there was news of any display since the last call. Never waits; takes NULL. */
bool kms_watch_read(struct kms_watch *watch);

#endif
