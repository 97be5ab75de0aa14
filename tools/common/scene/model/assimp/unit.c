/* unit.c - the unit of length. */
#include <math.h>
#include <string.h>
#include <strings.h>

#include "convert.h"

#define REACH_BITS 11 /* the farthest coordinate is below 2^11 */
#define FAR_AWAY 64   /* extents from the origin, from which a model is moved there */
#define BITS_MOST 120

#define VIEW_FARTHER 4 /* camera and lights may be this many times farther than 2^11 */

static double largest(const struct convert *c, const double at[3])
{
    return fmax(fabs(at[0] - c->origin[0]), fmax(fabs(at[1] - c->origin[1]), fabs(at[2] - c->origin[2])));
}

/* Two of these are less than 2^14 sqrt 3 apart. */
bool convert_reaches(const struct convert *c, const double at[3])
{
    return vector_is_finite(at) && ldexp(largest(c, at), c->bits) <= VIEW_FARTHER * (1 << REACH_BITS);
}

bool convert_is_gltf(const struct convert *c)
{
    const char *dot = strrchr(c->files.file->path, '.');
    return dot && (strcasecmp(dot, ".gltf") == 0 || strcasecmp(dot, ".glb") == 0);
}

static void place_of(const struct convert *c, const struct aiString *name, const struct aiVector3D *position,
                     double at[3])
{
    struct affine place;
    double own[3] = {(double)position->x, (double)position->y, (double)position->z};

    (void)convert_node_place(c, name, &place);
    affine_point(&place, own, at);
}

/* Returns the largest coordinate of the camera and the lights. */
static double reach_of_view(const struct convert *c)
{
    double most = 0, at[3];

    for (unsigned i = 0; i < c->from->mNumCameras && i < 1; i++) {
        place_of(c, &c->from->mCameras[i]->mName, &c->from->mCameras[i]->mPosition, at);
        most = fmax(most, vector_is_finite(at) ? largest(c, at) : 0);
    }
    for (unsigned i = 0; i < c->from->mNumLights; i++) {
        place_of(c, &c->from->mLights[i]->mName, &c->from->mLights[i]->mPosition, at);
        most = fmax(most, vector_is_finite(at) ? largest(c, at) : 0);
    }
    return most;
}

/* The coordinates of the scene are below 2^11, so that the camera of a model without one, some 3 radii away, is within
 * the range. The unit is a power of two of the file's; a model far from its origin is moved there. */
int convert_fit(struct convert *c)
{
    double half = 0, farthest = 0;

    for (int i = 0; i < 3; i++) {
        half = fmax(half, c->box.max[i] / 2 - c->box.min[i] / 2);
        farthest = fmax(farthest, fmax(fabs(c->box.min[i]), fabs(c->box.max[i])));
    }
    for (int i = 0; i < 3 && farthest > FAR_AWAY * half; i++)
        c->origin[i] = c->box.min[i] / 2 + c->box.max[i] / 2;
    if (farthest > FAR_AWAY * half)
        farthest = half;
    farthest = fmax(farthest, fmin(farthest * FAR_AWAY, reach_of_view(c)) / VIEW_FARTHER);
    c->bits = farthest > 0 ? REACH_BITS - 1 - ilogb(farthest) : 0;
    c->bits = c->bits > BITS_MOST ? BITS_MOST : c->bits;
    int bits = c->bits < TIA_SCALE_BITS_MAX ? c->bits : TIA_SCALE_BITS_MAX;
    c->pack.header.scale_bits = bits > -TIA_SCALE_BITS_MAX ? bits : -TIA_SCALE_BITS_MAX;
    for (int i = 0; i < 3; i++)
        c->pack.header.placement.origin[i] = (int64_t)fmax(fmin(ldexp(c->origin[i], 32), 0x1p62), -0x1p62);
    c->pack.header.placement.bits = c->bits;
    return TIA_OK;
}
