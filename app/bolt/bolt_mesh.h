/* Branches as a mesh for those who print or render it: tubes, closed and of one sense each, or lines with radii.
 * Lengths are pixels from the middle of the picture, x right, y up, z towards the viewer. */
#ifndef FROND_BOLT_MESH_H
#define FROND_BOLT_MESH_H

#include "bolt_shape.h"
#include "file.h"

struct bolt_mesh_def {
    const struct bolt_shape *shape;
    const struct bolt_look *look; /* leaves */
    int width, height;            /* pixels */
    int sides;                    /* of a tube, 3..64 */
    bool lines;
};

/* Wavefront: a group a branch ("g branch12") and a leaf. Of lines, the radius is the texture coordinate of a vertex. */
bool bolt_write_obj(const struct bolt_mesh_def *def, const char *path, struct file_error *error);
/* Binary, little endian: vertices x y z radius branch, and triangles or edges. */
bool bolt_write_ply(const struct bolt_mesh_def *def, const char *path, struct file_error *error);

#endif
