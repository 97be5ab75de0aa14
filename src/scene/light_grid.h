/* light_grid.h - maps a light field's pixels to pixels of ordinary pictures, see tia/lightfield.h. */
#ifndef TIA_SCENE_LIGHT_GRID_H
#define TIA_SCENE_LIGHT_GRID_H

#include <tia/scene.h>

/* The map of a scene's light field at one size. */
struct light_grid {
    const struct tia_light_field *field;
    const struct tia_camera *camera;
    int64_t u[3];                        /* the camera's axis u, Q1.62 */
    int width, height;                   /* size of the light field */
    int ordinary_width, ordinary_height; /* size of the ordinary pictures */
    uint64_t first, right, up; /* phases of a panel, in units of 2^-64: that of subpixel 0 in the lowest row; the steps
                                * to the next subpixel and to the next row up */
    int channels;              /* 3 if the channels of a pixel come from different pictures, else 1 */
};

struct light_pixel {
    int x, y;      /* position in the ordinary picture */
    tia_q16 place; /* position of the picture's eye, along u */
};

/* Prepares the map of a scene that has a light field. */
void tia_light_grid_init(struct light_grid *grid, const struct tia_scene *scene, int width, int height);

/* Writes the pixel of an ordinary picture that a channel of pixel (x, y) shows. Returns false if the pixel is black. */
bool tia_light_grid_pixel(const struct light_grid *grid, int x, int y, int channel, struct light_pixel *pixel);

/* Returns the vector from the middle of the observer line to the eye at `place`. */
struct tia_vec3 tia_light_offset(const int64_t u[3], tia_q16 place);

#endif
