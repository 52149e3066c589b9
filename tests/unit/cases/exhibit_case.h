/* A folder as exhibits lie in: sessions, pictures, a link that leads out. */
#ifndef FROND_EXHIBIT_CASE_H
#define FROND_EXHIBIT_CASE_H

#include <stddef.h>

#include "exhibit.h"

struct script_case;

/* Makes the folder anew, below /tmp; its path comes back, good until exhibit_case_remove. */
const char *exhibit_case_folder(void);
void exhibit_case_remove(void);
/* Both for a group of tests, which finds the path in its state. */
int exhibit_case_begin(void **state);
int exhibit_case_end(void **state);
/* Reads s.yaml there from a text. Pictures are taken for good where their name begins with "good". */
struct exhibit *exhibit_case_parse(const char *text, size_t size, struct report *report);
/* The same for what is right: fails with the report when it is not. */
struct exhibit *exhibit_case_good(const char *text);
/* And for what is wrong: shows each whose report is another, and fails where there is one. */
void exhibit_case_told(const struct script_case *cases, size_t count);

#endif
