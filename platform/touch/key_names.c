#include "key_names.h"

#include <stddef.h>
#include <strings.h>

#include <linux/input-event-codes.h>

static const struct {
    uint32_t code;
    const char *name;
} KEYS[] = {
    {KEY_A, "a"},
    {KEY_B, "b"},
    {KEY_C, "c"},
    {KEY_D, "d"},
    {KEY_E, "e"},
    {KEY_F, "f"},
    {KEY_G, "g"},
    {KEY_H, "h"},
    {KEY_I, "i"},
    {KEY_J, "j"},
    {KEY_K, "k"},
    {KEY_L, "l"},
    {KEY_M, "m"},
    {KEY_N, "n"},
    {KEY_O, "o"},
    {KEY_P, "p"},
    {KEY_Q, "q"},
    {KEY_R, "r"},
    {KEY_S, "s"},
    {KEY_T, "t"},
    {KEY_U, "u"},
    {KEY_V, "v"},
    {KEY_W, "w"},
    {KEY_X, "x"},
    {KEY_Y, "y"},
    {KEY_Z, "z"},
    {KEY_0, "0"},
    {KEY_1, "1"},
    {KEY_2, "2"},
    {KEY_3, "3"},
    {KEY_4, "4"},
    {KEY_5, "5"},
    {KEY_6, "6"},
    {KEY_7, "7"},
    {KEY_8, "8"},
    {KEY_9, "9"},
    {KEY_F1, "F1"},
    {KEY_F2, "F2"},
    {KEY_F3, "F3"},
    {KEY_F4, "F4"},
    {KEY_F5, "F5"},
    {KEY_F6, "F6"},
    {KEY_F7, "F7"},
    {KEY_F8, "F8"},
    {KEY_F9, "F9"},
    {KEY_F10, "F10"},
    {KEY_F11, "F11"},
    {KEY_F12, "F12"},
    {KEY_SPACE, "space"},
    {KEY_ENTER, "enter"},
    {KEY_ESC, "escape"},
    {KEY_TAB, "tab"},
    {KEY_BACKSPACE, "backspace"},
    {KEY_DELETE, "delete"},
    {KEY_INSERT, "insert"},
    {KEY_HOME, "home"},
    {KEY_END, "end"},
    {KEY_PAGEUP, "page up"},
    {KEY_PAGEDOWN, "page down"},
    {KEY_LEFT, "left"},
    {KEY_RIGHT, "right"},
    {KEY_UP, "up"},
    {KEY_DOWN, "down"},
    {KEY_MINUS, "minus"},
    {KEY_EQUAL, "equal"},
    {KEY_COMMA, "comma"},
    {KEY_DOT, "dot"},
};

const char *key_name_of(uint32_t code)
{
    for (size_t i = 0; i < sizeof KEYS / sizeof *KEYS; i++) {
        if (KEYS[i].code == code) {
            return KEYS[i].name;
        }
    }
    return NULL;
}

uint32_t key_code_of(const char *name)
{
    for (size_t i = 0; i < sizeof KEYS / sizeof *KEYS; i++) {
        if (strcasecmp(KEYS[i].name, name) == 0) {
            return KEYS[i].code;
        }
    }
    return 0;
}
