/* ray_camera.h - the ray through each sample of each pixel, see tia/camera.h. */
#ifndef TIA_RENDER_TRACE_RAY_CAMERA_H
#define TIA_RENDER_TRACE_RAY_CAMERA_H

#include "render/geometry/shape.h"
#include "scene/light_grid.h"

struct ray_camera {
    struct num_point eye;
    struct num_dir u, v, n;
    enum tia_projection projection;
    int width, height, side; /* size of the image, see ray_camera_pixel; side^2 samples per pixel */
    int channels;            /* 3 if red, green and blue have rays of their own, else 1 */
    struct light_grid grid;  /* the light field's map; grid.field is NULL without a light field */
    struct tia_window window;
    num_length depth;                        /* distance of the image plane from the eye */
    num_length left, bottom, across, upward; /* lower left corner and size of the window */
    num_divisor columns, rows;               /* divisors of the samples' positions in the image */
    struct num_point ahead;                  /* vector from the eye to the image plane */
    num_length lens, focus;                  /* radius and distance in focus of the lens; 0: a pinhole */
    uint32_t seed;                           /* of the points of the lens */
};

void ray_camera_prepare(struct ray_camera *camera, const struct tia_scene *scene, int width, int height);

/* Writes the pixel that a channel of pixel (x, y) of the picture shows. In a light field, that is a pixel of an image
 * with an eye of its own; otherwise, the pixel itself, with the camera's eye. Returns false if the channel shows no
 * pixel and is black. Samples and all else that depends on a pixel's position use its position in the image, so that
 * the images of a light field are bit for bit ordinary pictures. */
bool ray_camera_pixel(const struct ray_camera *camera, int x, int y, int channel, struct light_pixel *pixel);

static inline struct light_pixel ray_pixel_at(int x, int y)
{
    return (struct light_pixel){x, y, 0};
}

/* Writes the ray of sample number `sample` of the pixel. */
void ray_camera_ray(const struct ray_camera *camera, const struct light_pixel *pixel, int sample, struct ray *ray);

/* Writes the ray next to that of a sample, at the distance of samples: along the row for axis 0, along the column for
 * axis 1, always towards the middle of the image. */
void ray_camera_next(const struct ray_camera *camera, const struct light_pixel *pixel, int sample, int axis,
                     struct ray *ray);

/* Writes the ray of sample number `sample` through the point (u + 1/2)/2^32 of the pixel, measured from its upper left
 * corner. */
void ray_camera_ray_within(const struct ray_camera *camera, const struct light_pixel *pixel, uint32_t sample,
                           const uint32_t u[2], struct ray *ray);

/* True for a camera in perspective without a lens: all rays of a pixel start at the same point. */
bool ray_camera_is_pinhole(const struct ray_camera *camera);

/* Returns the vector along ray_camera_ray_within's ray from its origin to the image plane, for a pinhole camera. */
struct num_point ray_camera_way_within(const struct ray_camera *camera, const struct light_pixel *pixel,
                                       const uint32_t u[2]);

#endif
