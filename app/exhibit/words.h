/* What a visitor reads, in the languages of an exhibit. Every sentence is in the exhibit file; the shipped ones stand
 * in words.c, in English, French, Arabic and Japanese, for whatever a file leaves out. */
#ifndef FROND_WORDS_H
#define FROND_WORDS_H

#include <stdbool.h>

enum { WORDS_LANGUAGES = 8 };

/* A text in several languages: UTF-8, by the index of the language in words_languages; NULL: not in that one. */
struct words {
    const char *in[WORDS_LANGUAGES];
};

enum exhibit_text {
    TEXT_INVITE, /* attract: "Touch the paper" */
    TEXT_INKS,   /* what a screen reader would say of the buttons, and the staff's help; shown where there is room */
    TEXT_DROP,
    TEXT_BRUSH,
    TEXT_GUIDE,
    TEXT_POUR,
    TEXT_MASK,
    TEXT_REWIND,
    TEXT_PLANT,
    TEXT_TEND,
    TEXT_THIN,
    TEXT_STRIKE,
    TEXT_REPEL,
    TEXT_STROKE,
    TEXT_DOSE,
    TEXT_ERASE,
    TEXT_MAP,
    TEXT_PICTURE,
    TEXT_METAPHOR,
    TEXT_UNDO,
    TEXT_REDO,
    TEXT_FINISH,
    TEXT_HAND,
    TEXT_SEATED,
    TEXT_LANGUAGE,  /* the language's own name */
    TEXT_COUNTDOWN, /* with {seconds}: "The paper is washed in {seconds} seconds" */
    TEXT_STAY,      /* under it: "Touch to go on" */
    TEXT_THANKS,    /* a finished picture */
    TEXT_CLOSED,    /* a moment before the screen darkens */
    TEXTS,
};

struct words_language {
    const char *tag;  /* BCP 47: "en" */
    const char *name; /* in itself: "English" */
    bool from_right;  /* written from right to left */
};
/* Those that Frond knows, WORDS_LANGUAGES of them; ends with a tag NULL where there are fewer. */
extern const struct words_language words_languages[WORDS_LANGUAGES];

/* The index of a tag, or -1. */
int words_find(const char *tag);
/* "invite", "countdown": as exhibits write it. */
const char *words_key(enum exhibit_text text);
/* The shipped text; every text is there in the first four languages, NULL in the others. */
const char *words_shipped(enum exhibit_text text, int language);
/* A text of an exhibit in a language: its own, else the shipped one, else both in English. Never NULL. */
const char *words_of(const struct words texts[TEXTS], enum exhibit_text text, int language);

#endif
