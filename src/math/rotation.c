#include "rotation.h"

#include "atan2.h"
#include "trig.h"
#include "wide.h"

#define RIGHT (90 * TIA_Q16_ONE)

void tia_sincos(tia_q16 degrees, int64_t *sine, int64_t *cosine)
{
    int32_t rest = degrees % (4 * RIGHT);
    uint32_t angle = (uint32_t)(rest < 0 ? rest + 4 * RIGHT : rest);
    uint32_t quadrant = angle / RIGHT, z = angle % RIGHT;
    bool beyond = z > RIGHT / 2; /* 45 degrees: sin x = cos(90 - x) */
    uint64_t s63, c63;

    tia_octant(2 * (beyond ? RIGHT - z : z), &s63, &c63);
    int64_t s = (int64_t)((s63 + 1) >> 1), c = (int64_t)((c63 + 1) >> 1);
    /* Each quadrant swaps sine and cosine, and so does the reflection at 45 degrees. */
    bool swap = beyond != (quadrant % 2 == 1);
    *sine = swap ? c : s;
    *cosine = swap ? s : c;
    if (quadrant >= 2)
        *sine = -*sine;
    if (quadrant == 1 || quadrant == 2)
        *cosine = -*cosine;
}

static int64_t product(int64_t a, int64_t b)
{
    return tia_scaled_product(a, b, 62);
}

void tia_rotation_axes(struct tia_vec3 rotation, int64_t axes[3][3])
{
    int64_t sx, cx, sy, cy, sz, cz;

    tia_sincos(rotation.x, &sx, &cx);
    tia_sincos(rotation.y, &sy, &cy);
    tia_sincos(rotation.z, &sz, &cz);
    /* axes after the rotations about x and y, before that about z */
    const int64_t tilted[3][3] = {
        {cy, 0, -sy}, {product(sy, sx), cx, product(cy, sx)}, {product(sy, cx), -sx, product(cy, cx)}};
    for (int i = 0; i < 3; i++) {
        axes[i][0] = product(cz, tilted[i][0]) - product(sz, tilted[i][1]);
        axes[i][1] = product(sz, tilted[i][0]) + product(cz, tilted[i][1]);
        axes[i][2] = tilted[i][2];
    }
}

/* Returns the angle of (x, y) in degrees, rounded to nearest: 360 times the angle in turns, Q1.62. */
static tia_q16 degrees(int64_t y, int64_t x)
{
    return (tia_q16)wide_round(wide_product(tia_atan2(y, x), 360), 46);
}

/* axes[0] is (cz cy, sz cy, -sy), and the z components of axes[1] and axes[2] are cy sx and cy cx. If cy is only a
 * rounding error, rotations about x and about z have the same effect. The angle about z is then 0, and axes[1] is (sy
 * sx, cx, 0). */
void tia_rotation_angles(const int64_t axes[3][3], struct tia_vec3 *rotation)
{
    int64_t horizontal =
        wide_sqrt(wide_sum(wide_product(axes[0][0], axes[0][0]), wide_product(axes[0][1], axes[0][1])));
    int64_t up = -axes[0][2];

    rotation->y = degrees(up, horizontal);
    rotation->z = 0;
    rotation->x = degrees(up < 0 ? -axes[1][0] : axes[1][0], axes[1][1]);
    if (horizontal < INT64_C(1) << 38) /* 2^-24 radians, below the unit of angles */
        return;
    rotation->z = degrees(axes[0][1], axes[0][0]);
    rotation->x = degrees(axes[1][2], axes[2][2]);
}
