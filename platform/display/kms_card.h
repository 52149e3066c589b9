/* A card of the kernel: /dev/dri/card*, through libdrm. */
#ifndef FROND_KMS_CARD_H
#define FROND_KMS_CARD_H

#include "display.h"
#include "kms_calls.h"
#include "kms_choice.h"

/* `path`, or of /dev/dri/card* the one that serves the wish best (kms_card_score), the first of those that serve alike;
 * a card that only renders is passed over. `legacy` leaves atomic mode setting alone where there is one. NULL with the
 * reason in `error`; a card with nothing plugged in is no reason. */
struct kms_card *kms_card_open(const char *path, const struct kms_wish *wish, bool legacy, struct device_error *error);
void kms_card_close(struct kms_card *card); /* takes NULL */

#endif
