/* The calls of kms_calls.h on a card of the kernel, through libdrm. */
#ifndef FROND_KMS_IOCTL_H
#define FROND_KMS_IOCTL_H

#include "kms_calls.h"

struct kms_ioctl_card {
    struct kms_card card; /* first */
    bool probed;
    struct kms_scan last; /* probe */
};

/* Of a kms_ioctl_card, whose fd is open without blocking. */
extern const struct kms_calls kms_ioctl_calls;

#endif
