/* camera.h - the ray through each sample of each pixel, see tia/camera.h. */
#ifndef TIA_RENDER_TRACE_CAMERA_H
#define TIA_RENDER_TRACE_CAMERA_H

#include "render/geometry/shape.h"

struct ray_camera {
    struct num_point eye;
    struct num_dir u, v, n;
    enum tia_projection projection;
    int width, height, side;                 /* of the image; side^2 samples a pixel */
    num_length depth;                        /* of the image plane before the eye */
    num_length left, bottom, across, upward; /* the window and its sizes */
    num_divisor columns, rows;               /* of samples' places in the image */
    struct num_point ahead;                  /* from the eye to the image plane */
};

void ray_camera_prepare(struct ray_camera *camera, const struct tia_scene *scene, int width, int height);

/* Sample number `sample` of pixel (x, y). */
void ray_camera_ray(const struct ray_camera *camera, int x, int y, int sample, struct ray *ray);

/* Through the place (u + 1/2)/2^32 of pixel (x, y), from its upper left corner. */
void ray_camera_ray_within(const struct ray_camera *camera, int x, int y, const uint32_t u[2], struct ray *ray);

#endif
