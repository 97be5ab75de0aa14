#include "sides.h"

#include "math/wide.h"

static int sign(wide a)
{
    return wide_is_negative(a) ? -1 : wide_bits(a) != 0;
}

int tia_flat_orientation(const int64_t a[3], const int64_t b[3], const int64_t c[3])
{
    wide sum = wide_product(0, 0);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        wide n = wide_difference(wide_product(a[j], b[k]), wide_product(a[k], b[j]));
        sum = wide_sum(sum, wide_times(n, c[i]));
    }
    return sign(sum);
}

/* Gives the vector from a face's first corner, which is a point, to v; if v is a direction, gives v. */
static void relative(const struct tia_flat_scene *flat, const struct tia_flat_face *face,
                     const struct tia_raster_vertex *v, int64_t out[3])
{
    int64_t first[3];

    tia_flat_affine(flat, v, out);
    if (tia_flat_is_direction(flat, v))
        return;
    tia_flat_affine(flat, tia_face_corner(flat, face, 0), first);
    for (int i = 0; i < 3; i++)
        out[i] -= first[i];
}

/* the axes x, y, w are left-handed, x, y, h right-handed */
int tia_flat_side(const struct tia_flat_scene *flat, const struct tia_flat_face *face, const tia_flat_light *light)
{
    int64_t a[3], b[3], c[3];

    relative(flat, face, tia_face_corner(flat, face, 1), a);
    relative(flat, face, tia_face_corner(flat, face, 2), b);
    relative(flat, face, light, c);
    int turn = tia_flat_orientation(a, b, c);
    return flat->eye.projection == TIA_ORTHOGRAPHIC ? turn : -turn;
}

/* The eye. In all projections, only its fourth coordinate is not 0. */
static const struct tia_raster_vertex eye = {0, 0, 0, 1};

int tia_flat_side_of_eye(const struct tia_flat_scene *flat, const struct tia_flat_face *face)
{
    return tia_flat_side(flat, face, &eye);
}

bool tia_flat_is_visible(const struct tia_flat_scene *flat, uint32_t face, int side)
{
    return side && side == tia_flat_side_of_eye(flat, &flat->faces[face]);
}

bool tia_flat_is_turned(const struct tia_flat_scene *flat, uint32_t face, const tia_flat_light *light)
{
    return tia_flat_is_visible(flat, face, tia_flat_side(flat, &flat->faces[face], light));
}

/* ---- objects ---- */

/* In perspective, all visible points are on the eye's side of the plane, or in it. In orthographic views rays start at
 * the window, which the plane may cross. */
bool tia_flat_hides_nothing(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            const tia_flat_light *light)
{
    const struct tia_flat_face *face = &flat->faces[object->first_face];

    return object->kind == TIA_PLANE && flat->eye.projection != TIA_ORTHOGRAPHIC &&
           tia_flat_side(flat, face, light) * tia_flat_side_of_eye(flat, face) > 0;
}

static bool is_between(const int64_t low[3], const int64_t at[3], const int64_t high[3])
{
    return low[0] <= at[0] && at[0] <= high[0] && low[1] <= at[1] && at[1] <= high[1] && low[2] <= at[2] &&
           at[2] <= high[2];
}

/* True if the eye is outside the object's box; in orthographic views, where the eye is at infinity, if the box is in
 * front of the window. */
static bool is_seen_whole(const struct tia_flat_scene *flat, const struct tia_flat_object *object)
{
    static const int64_t here[3] = {0, 0, 0};

    return flat->eye.projection == TIA_ORTHOGRAPHIC ? object->high[2] <= 0
                                                    : !is_between(object->low, here, object->high);
}

bool tia_flat_has_silhouette(const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                             const tia_flat_light *light)
{
    int64_t at[3];

    tia_flat_affine(flat, light, at);
    return object->closed && is_seen_whole(flat, object) &&
           (tia_flat_is_direction(flat, light) || !is_between(object->low, at, object->high));
}
