// The layout of planes, as painting_gpu_state.h says it. Blocks are declared by each shader, in words or in fours.
const int TILE = 32;
const int APRON = 4;

// Planes of the fluids.
const int SOLVENT = 0;
const int INK = 9;
const int WET = 18;
// Planes of the pattern.
const int ACTIVE = 0;
const int CATALYST = 1;
const int CARVED = 2;
// Planes of the sheet.
const int ALPHA_A_XI = 0;
const int BETA_A_S_MAX = 1;
const int ALPHA_Y_REST = 2;
const int GUIDE = 3;
const int DENSITY = 4;
const int OPEN_SOLVENT = 5;
const int OPEN_INK = 6;
const int DRY = 7;

const float CLOSED = -4.0;

// Units of the packed ground: sim/painting/kernel.h.
const float UNIT_XI = 1.0 / 16384.0;
const float UNIT_S_MAX = 1.0 / 32768.0;
const float UNIT_WEIGHT = 1.0 / 1020.0;
const float UNIT_GUIDE = 1.0 / 8192.0;

layout(location = 0) uniform ivec4 planes; // width and height of the sheet, cells; stride, words; words of a plane

int word_of(ivec2 cell)
{
    return (cell.y + APRON) * planes.z + cell.x + APRON;
}

bool on_sheet(ivec2 cell)
{
    return all(greaterThanEqual(cell, ivec2(0))) && all(lessThan(cell, planes.xy));
}
