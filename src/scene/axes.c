#include "axes.h"

#include "math/wide.h"

void tia_axes_cross(const int64_t a[3], const int64_t b[3], int64_t c[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        c[i] = wide_round(wide_difference(wide_product(a[j], b[k]), wide_product(a[k], b[j])), 62);
    }
}

void tia_camera_axes(int64_t axes[3][3], const struct tia_camera *camera, const int64_t back[3])
{
    const int64_t up[3] = {camera->up.x, camera->up.y, camera->up.z};
    int64_t side[3], towards[3];

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            axes[i][k] = i == k ? INT64_C(1) << 62 : 0;
    if (!up[0] && !up[1] && !up[2])
        return;
    (void)wide_normalise(back, axes[2]);
    (void)wide_normalise(up, towards);
    tia_axes_cross(towards, axes[2], side);
    (void)wide_normalise(side, axes[0]);
    tia_axes_cross(axes[2], axes[0], axes[1]);
}
