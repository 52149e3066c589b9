#include "inputs.h"

const char *inputs_default_text(void)
{
    return "inputs: 1\n"
           "touch: {touchscreens: true, pointers: true}\n"
           "bindings:\n"
           "  - {touch: press, drop: {}}\n"
           "  - {touch: drag, brush_solvent: {}}\n"
           "  - {touch: drag, brush_ink: {}}\n"
           "  # Gamepads and joysticks: a point that the stick or the cross moves.\n"
           "  - {usage: X, cursor: {axis: x, dead_zone: 0.15, curve: square}}\n"
           "  - {usage: Y, cursor: {axis: y, dead_zone: 0.15, curve: square}}\n"
           "  - {usage: Hat switch, cursor: {axis: both, speed: 0.2}}\n"
           "  - {usage: Button 1, drop: {}}\n"
           "  - {usage: Button 2, brush_solvent: {}}\n"
           "  - {usage: Button 2, brush_ink: {}}\n"
           "  - {usage: Button 3, next_ink: {}}\n"
           "  - {usage: Button 4, undo: {}}\n"
           "  # Space mice: a twist; knobs: a turn.\n"
           "  - {usage: Rz, turn: {coefficient: s_max, from: 0.1, to: 0.6, dead_zone: 0.15}}\n"
           "  - {usage: Dial, turn: {coefficient: s_max, from: 0.1, to: 0.6}}\n"
           "  - {usage: Wheel, turn: {coefficient: s_max, from: 0.1, to: 0.6}}\n";
}
