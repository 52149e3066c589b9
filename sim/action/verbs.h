/* Every verb there is, in the order in which they are listed to people: ACTION_NAME, and `verb_name` that says what it
 * is (verb.h). Journals name the verbs that they use, so that their order is free. */
#ifndef FROND_VERBS_H
#define FROND_VERBS_H

#define ACTION_VERB_LIST(VERB) VERB(DROP, drop) ACTION_OTHER_VERBS(VERB)
#define ACTION_OTHER_VERBS(VERB)                                                                                       \
    VERB(BRUSH_SOLVENT, brush_solvent)                                                                                 \
    VERB(BRUSH_INK, brush_ink)                                                                                         \
    VERB(DRAW, draw)                                                                                                   \
    VERB(GUIDE, guide)                                                                                                 \
    VERB(POUR, pour)                                                                                                   \
    VERB(MASK, mask)                                                                                                   \
    VERB(UNMASK, unmask)                                                                                               \
    VERB(DRY, dry)                                                                                                     \
    VERB(WET, wet)                                                                                                     \
    VERB(RINSE, rinse)                                                                                                 \
    VERB(SET, set)                                                                                                     \
    VERB(CLEAR, clear)                                                                                                 \
    VERB(UNDO, undo)                                                                                                   \
    VERB(REDO, redo)                                                                                                   \
    VERB(REWIND, rewind)                                                                                               \
    VERB(STOCK, stock)                                                                                                 \
    VERB(SHAPE, shape)                                                                                                 \
    VERB(PLANT, plant)                                                                                                 \
    VERB(TEND, tend)                                                                                                   \
    VERB(HOLD, hold)                                                                                                   \
    VERB(STRIKE, strike)                                                                                               \
    VERB(ATTRACT, attract)                                                                                             \
    VERB(CONDUCT, conduct)                                                                                             \
    VERB(DOSE, dose)                                                                                                   \
    VERB(REACT, react)                                                                                                 \
    VERB(STYLE, style)

#endif
