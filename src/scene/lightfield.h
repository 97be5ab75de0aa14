/* lightfield.h - which pixel of which ordinary picture a pixel of a light field is, see tia/lightfield.h. */
#ifndef TIA_SCENE_LIGHTFIELD_H
#define TIA_SCENE_LIGHTFIELD_H

#include <tia/scene.h>

/* Of one scene, for one size. */
struct light_grid {
    const struct tia_light_field *field;
    const struct tia_camera *camera;
    int64_t u[3];                        /* the camera's axis, Q1.62 */
    int width, height;                   /* of the light field */
    int ordinary_width, ordinary_height; /* of the pictures that it is made of */
    uint64_t first, right,
        up;       /* phases of a panel, 2^-64: of subpixel 0 of the lowest row; to the next one; a row up */
    int channels; /* 3: red, green and blue are pixels of different pictures; else 1 */
};

struct light_pixel {
    int x, y;      /* in the ordinary picture */
    tia_q16 place; /* of its eye, along u */
};

/* The scene has a light field. */
void tia_light_grid_init(struct light_grid *grid, const struct tia_scene *scene, int width, int height);

/* False: it is black. */
bool tia_light_grid_pixel(const struct light_grid *grid, int x, int y, int channel, struct light_pixel *pixel);

/* From the eye in the line's middle to the one at a place. */
struct tia_vec3 tia_light_offset(const int64_t u[3], tia_q16 place);

#endif
