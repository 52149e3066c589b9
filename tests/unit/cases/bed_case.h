/* What mocks have in common that umockdev makes devices for. */
#ifndef FROND_BED_CASE_H
#define FROND_BED_CASE_H

#include <umockdev.h>

/* Lets a process of another user open `count` devices, /dev/NAME0 and up. */
void bed_case_open_to_all(UMockdevTestbed *bed, const char *name, int count);
/* Gives /dev/NAMEnumber the permissions `mode`. */
void bed_case_permit(UMockdevTestbed *bed, const char *name, int number, unsigned mode);

#endif
