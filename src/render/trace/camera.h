/* camera.h - the ray through each sample of each pixel, see tia/camera.h. */
#ifndef TIA_RENDER_TRACE_CAMERA_H
#define TIA_RENDER_TRACE_CAMERA_H

#include "render/geometry/shape.h"
#include "scene/lightfield.h"

struct ray_camera {
    struct num_point eye;
    struct num_dir u, v, n;
    enum tia_projection projection;
    int width, height, side; /* of the image, see ray_camera_pixel; side^2 samples a pixel */
    int channels;            /* 3: red, green and blue have rays of their own; else 1 */
    struct light_grid grid;  /* without a field: the image is all there is */
    struct tia_window window;
    num_length depth;                        /* of the image plane before the eye */
    num_length left, bottom, across, upward; /* the window and its sizes */
    num_divisor columns, rows;               /* of samples' places in the image */
    struct num_point ahead;                  /* from the eye to the image plane */
};

void ray_camera_prepare(struct ray_camera *camera, const struct tia_scene *scene, int width, int height);

/* What a channel of pixel (x, y) of the picture shows: a pixel of an image from an eye of its own. Elsewhere that is
 * the pixel itself, seen from the eye. False: nothing, it is black. All that depends on a pixel's place, samples too,
 * goes by the place in the image, so that a light field has the bits of ordinary pictures. */
bool ray_camera_pixel(const struct ray_camera *camera, int x, int y, int channel, struct light_pixel *pixel);

static inline struct light_pixel ray_pixel_at(int x, int y)
{
    return (struct light_pixel){x, y, 0};
}

/* Sample number `sample` of the pixel. */
void ray_camera_ray(const struct ray_camera *camera, const struct light_pixel *pixel, int sample, struct ray *ray);

/* Through the place (u + 1/2)/2^32 of the pixel, from its upper left corner. */
void ray_camera_ray_within(const struct ray_camera *camera, const struct light_pixel *pixel, const uint32_t u[2],
                           struct ray *ray);

#endif
