// Cells of Gray-Scott: u and v side by side, row by row, without rims.
layout(location = 0) uniform ivec4 sheet; // width and height, cells; 1: no flux over the border, else periodic; 0

const float LEAST = 1e-15; // gray_scott_kernel.h

// The cell that counts where (x, y) lies beyond the border, up to a sheet's size away or many.
int wrapped(int at, int size)
{
    if (at >= 0 && at < size) {
        return at;
    }
    int period = sheet.z == 1 ? 2 * size : size;
    int place = at < 0 ? period - 1 - (-at - 1) % period : at % period; // of what is not negative alone is it defined
    return place < size ? place : period - 1 - place;
}

int cell_of(ivec2 at)
{
    return wrapped(at.y, sheet.y) * sheet.x + wrapped(at.x, sheet.x);
}
