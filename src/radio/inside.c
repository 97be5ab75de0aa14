/* inside.c - finds the objects that contain a point. */
#include "search.h"

static int side_of(const struct tia_radio *radio, uint32_t face, struct tia_vec3 point)
{
    const struct radio_plane *plane = &radio->planes[radio->faces[face].plane];
    const int64_t at[3] = {point.x, point.y, point.z};
    int side = wide_sign(wide_difference(wide_dot(plane->n, at), radio_get(plane->d)));

    return radio->faces[face].turned ? -side : side;
}

/* True if the point is in the box to which face *face belongs. Advances *face past the box's faces, which are
 * consecutive: six, or fewer in a box so thin that rounded corners are collinear. */
static bool in_box(const struct tia_radio *radio, uint32_t *face, struct tia_vec3 point)
{
    uint32_t object = radio->faces[*face].object;
    bool inside = true;

    for (; *face < radio->face_count && radio->faces[*face].object == object; ++*face)
        inside &= side_of(radio, *face, point) <= 0;
    return inside;
}

uint32_t tia_radio_inside(const struct tia_radio *radio, struct tia_vec3 point)
{
    struct number room[3];
    struct spot at;

    if (!radio)
        return TIA_RADIO_NO_OBJECT;
    tia_radio_spot(&at, point);
    for (uint32_t f = 0; f < radio->face_count;) {
        uint32_t object = radio->faces[f].object;
        if (radio->faces[f].solid) {
            if (in_box(radio, &f, point))
                return object;
        } else if (side_of(radio, f, point) == 0 && tia_radio_on_face(radio, &radio->faces[f], &at, room)) {
            return object;
        } else {
            f++;
        }
    }
    return TIA_RADIO_NO_OBJECT;
}
