// What the passes of the picture share: sim/picture.h on the GPU. Fields of cells come in, 8-bit sRGB goes out:
//   picture_count.comp   how many carved cells are how deep
//   picture_tone.comp    from that the depth of a well carved branch
//   picture_across.comp  relief; what is blurred, blurred across
//   picture_down.comp    blurred down; shares of ink: three layers of cells
//   picture_rows.comp    the layers resampled down to rows of pixels
//   picture_shade.frag   resampled across, and shaded
// Layers, four values a texel, as sim/picture_work.h names them: relief, line, body, film; inks 0..3; hollow, wet, mask.
const int BINS = 1024;
const float DEEPEST = 2.0;
const float CARVED = 0.1;

float smooth_between(float low, float high, float x)
{
    float t = clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}
