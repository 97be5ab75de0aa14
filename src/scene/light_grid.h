/* light_grid.h - maps a light field's pixels to pixels of ordinary pictures, see tia/lightfield.h. */
#ifndef TIA_SCENE_LIGHT_GRID_H
#define TIA_SCENE_LIGHT_GRID_H

#include <tia/scene.h>

/* The map of a light field for one scene and size. */
struct light_grid {
    const struct tia_light_field *field;
    const struct tia_camera *camera;
    int64_t u[3];                        /* the camera's axis, Q1.62 */
    int width, height;                   /* size of the light field */
    int ordinary_width, ordinary_height; /* size of the ordinary pictures */
    uint64_t first, right, up; /* phases of a panel, 2^-64: that of subpixel 0 of the lowest row; the step to the next
                                  subpixel; the step to the next row up */
    int channels;              /* 3 where red, green and blue are pixels of different pictures, else 1 */
};

struct light_pixel {
    int x, y;      /* position in the ordinary picture */
    tia_q16 place; /* position of the picture's eye, along u */
};

/* Prepares the map; the scene has a light field. */
void tia_light_grid_init(struct light_grid *grid, const struct tia_scene *scene, int width, int height);

/* Gives the pixel of the ordinary picture; false: it is black. */
bool tia_light_grid_pixel(const struct light_grid *grid, int x, int y, int channel, struct light_pixel *pixel);

/* Returns the vector from the eye in the line's middle to the eye at `place`. */
struct tia_vec3 tia_light_offset(const int64_t u[3], tia_q16 place);

#endif
