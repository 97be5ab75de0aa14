#include "trace.h"

/* Computes two unit vectors perpendicular to n and to each other, for any n, without a square root: Duff et al.,
 * "Building an orthonormal basis, revisited" (2017). */
static void basis(struct num_dir n, struct num_dir *t, struct num_dir *b)
{
    bool down = n.z < 0;
    num_unit k = num_fraction(NUM_UNIT_ONE / 2, NUM_UNIT_ONE / 2 + (down ? -n.z : n.z) / 2);
    num_unit xx = num_times(num_times(n.x, n.x), k), yy = num_times(num_times(n.y, n.y), k);
    num_unit xy = num_times(num_times(n.x, n.y), k);

    *t = (struct num_dir){NUM_UNIT_ONE - xx, -xy, down ? n.x : -n.x};
    *b = (struct num_dir){down ? xy : -xy, down ? yy - NUM_UNIT_ONE : NUM_UNIT_ONE - yy, -n.y};
}

struct num_dir ray_around(struct num_dir axis, struct num_dir local)
{
    const num_unit x = local.x, y = local.y, z = local.z;
    struct num_dir t, b;

    basis(axis, &t, &b);
    return num_dir_normalised((struct num_dir){num_dot3(t.x, b.x, axis.x, x, y, z), num_dot3(t.y, b.y, axis.y, x, y, z),
                                               num_dot3(t.z, b.z, axis.z, x, y, z)});
}
