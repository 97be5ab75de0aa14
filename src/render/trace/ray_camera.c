#include "ray_camera.h"

#include "math/noinline.h"
#include "math/trig.h"
#include "samples/direction.h"
#include "samples/sobol.h"

#define LENS_QUAD UINT32_C(0x50000000) /* of the random numbers of the lens */

static struct num_point finely(struct tia_vec3 place, const struct tia_fine_place *fine)
{
    struct num_point p = num_point_of(place);

    return fine ? num_point_add(p, num_point_fine(*fine)) : p;
}

static void look(struct ray_camera *c, const struct tia_camera *given, const struct tia_fine *fine)
{
    struct num_point reference = finely(given->reference, fine ? &fine->reference : NULL);
    struct num_point back = num_point_sub(c->eye, reference), up = num_point_of(given->up);
    struct num_dir towards;

    c->u = (struct num_dir){NUM_UNIT_ONE, 0, 0};
    c->v = (struct num_dir){0, NUM_UNIT_ONE, 0};
    c->n = (struct num_dir){0, 0, NUM_UNIT_ONE};
    if (!given->up.x && !given->up.y && !given->up.z)
        return;
    (void)num_normalise(back, &c->n);
    (void)num_normalise(up, &towards);
    c->u = num_dir_normalised(num_dir_cross(towards, c->n));
    c->v = num_dir_cross(c->n, c->u);
}

/* Sets the window and its distance, `depth`. In perspective, they are in the pixel coordinates of span/primary.h,
 * divided by 128: height cot(fov/2) is below 2^20, and tia_cotangent's result is Q8.56. */
static void open_window(struct ray_camera *c, const struct tia_camera *given)
{
    const struct tia_window *w = &given->window;

    if (c->projection == TIA_PERSPECTIVE) {
        c->across = num_integer(c->width) / 64;
        c->upward = num_integer(c->height) / 64;
        c->left = -c->across / 2;
        c->bottom = -c->upward / 2;
        c->depth = num_times(num_integer(c->height), num_unit_of_q62((int64_t)(tia_cotangent(given->fov) >> 1)));
        return;
    }
    c->depth = num_length_of(w->near);
    c->bottom = num_length_of(w->bottom);
    c->upward = num_length_of(w->top) - c->bottom;
    c->left = num_length_of(w->left);
    c->across = num_length_of(w->right) - c->left;
    if (!w->left && !w->right) {
        num_length across = num_product_within(c->upward, num_ratio(num_integer(c->width), num_integer(c->height)));
        c->across = across < NUM_LENGTH_FAR ? across : NUM_LENGTH_FAR;
        c->left = -c->across / 2;
    }
}

static void set_grid(struct ray_camera *c, const struct tia_scene *scene, int width, int height)
{
    c->width = width;
    c->height = height;
    c->channels = 1;
    c->grid.field = NULL;
    if (!scene->field)
        return;
    tia_light_grid_init(&c->grid, scene, width, height);
    c->width = c->grid.ordinary_width;
    c->height = c->grid.ordinary_height;
    c->channels = c->grid.channels;
}

/* Returns n 2^-5: an image may be three times as wide as a picture, too wide for num_integer. */
static num_length small(int64_t n)
{
    return num_length_of_q45(n * (INT64_C(1) << 40));
}

void ray_camera_prepare(struct ray_camera *c, const struct tia_scene *scene, int width, int height)
{
    const struct tia_camera *given = &scene->camera;
    const struct tia_fine *fine = scene->fine;

    c->eye = finely(given->eye, fine ? &fine->eye : NULL);
    c->projection = given->projection;
    set_grid(c, scene, width, height);
    c->window = given->window;
    c->side = given->samples == 16 ? 4 : given->samples == 4 ? 2 : 1;
    c->columns = num_divisor_of(small(2 * c->side * c->side * (int64_t)c->width));
    c->rows = num_divisor_of(small(2 * c->side * c->side * (int64_t)c->height));
    c->lens = scene->lens ? num_length_of(scene->lens->radius) : 0;
    c->focus = scene->lens ? num_length_of(scene->lens->focus) : 0;
    c->seed = scene->integration.seed;
    look(c, given, fine);
    open_window(c, given);
    c->ahead = num_point_sub((struct num_point){0, 0, 0}, num_point_along(c->n, c->depth));
}

bool ray_camera_pixel(const struct ray_camera *c, int x, int y, int channel, struct light_pixel *pixel)
{
    *pixel = ray_pixel_at(x, y);
    return !c->grid.field || tia_light_grid_pixel(&c->grid, x, y, channel, pixel);
}

/* Returns the vector from the middle of the image plane to a point of the image, for the eye at `place`; `right` and
 * `down` are fractions of the image's width and height. */
static INLINED_IN_WORDS struct num_point aside_of(const struct ray_camera *c, tia_q16 place, num_unit right,
                                                  num_unit down)
{
    num_length left = place ? num_length_of(c->window.left - place) : c->left;
    num_length h = left + num_times(c->across, right), v = c->bottom + c->upward - num_times(c->upward, down);

    return num_point_add(num_point_along(c->u, h), num_point_along(c->v, v));
}

/* Writes the ray from the eye at `place` through a point of the image, see aside_of. */
static void through(const struct ray_camera *c, tia_q16 place, struct num_point aside, struct ray *ray)
{
    ray->origin = place ? num_point_add(c->eye, num_point_of(tia_light_offset(c->grid.u, place))) : c->eye;
    ray_watch(ray, NULL);
    ray->direction = num_dir_negated(c->n);
    if (c->projection == TIA_ORTHOGRAPHIC)
        ray->origin = num_point_add(c->eye, aside);
    else
        (void)num_normalise(num_point_add(aside, c->ahead), &ray->direction);
}

/* Moves the ray's origin to the sample's point of the lens. With n the axis towards the eye's back, the ray meets the
 * plane in focus at the distance focus/-n.d. */
static void bend(const struct ray_camera *c, const struct light_pixel *pixel, uint32_t sample, struct ray *ray)
{
    uint32_t u[2];
    int64_t place[2];

    if (c->lens <= 0)
        return;
    const struct sampler sampler = sampler_of(c->seed, pixel->x, pixel->y, sample);
    num_length way = num_div(c->focus, -num_dir_dot(ray->direction, c->n));
    sampler_pair(&sampler, LENS_QUAD, 0, u);
    tia_sample_disc(u, place);
    const struct num_point aside = num_point_add(num_point_along(c->u, num_times(c->lens, num_unit_of_q62(place[0]))),
                                                 num_point_along(c->v, num_times(c->lens, num_unit_of_q62(place[1]))));
    ray->origin = num_point_add(ray->origin, aside);
    const struct num_point to = num_point_sub(num_point_along(ray->direction, way), aside);
    (void)num_normalise(to, &ray->direction);
}

/* Gives the sample's position in the image, in units of 1/(2 n^2): in its pixel, (n i + j + 1/2)/n^2 to the right and
 * (n j + n - i - 1/2)/n^2 down. */
static void place_sample(const struct ray_camera *c, const struct light_pixel *pixel, int sample, int32_t place[2])
{
    int32_t n = c->side, i = sample % n, j = sample / n;

    place[0] = 2 * n * n * pixel->x + 2 * n * i + 2 * j + 1;
    place[1] = 2 * n * n * pixel->y + 2 * n * j + 2 * n - 2 * i - 1;
}

static void through_sample(const struct ray_camera *c, tia_q16 eye, const int32_t place[2], struct ray *ray)
{
    num_unit right = num_fraction_by(small(place[0]), c->columns), down = num_fraction_by(small(place[1]), c->rows);

    through(c, eye, aside_of(c, eye, right, down), ray);
}

void ray_camera_ray(const struct ray_camera *c, const struct light_pixel *pixel, int sample, struct ray *ray)
{
    int32_t place[2];

    place_sample(c, pixel, sample, place);
    through_sample(c, pixel->place, place, ray);
    bend(c, pixel, (uint32_t)sample, ray);
}

void ray_camera_next(const struct ray_camera *c, const struct light_pixel *pixel, int sample, int axis, struct ray *ray)
{
    int32_t n = c->side, middle = n * n * (axis ? c->height : c->width), place[2];

    place_sample(c, pixel, sample, place);
    place[axis] += place[axis] < middle ? 2 * n : -2 * n;
    through_sample(c, pixel->place, place, ray);
    bend(c, pixel, (uint32_t)sample, ray);
}

/* Returns the part of the image up to x + (u + 1/2)/2^32 pixels, `size` being the divisor of its columns or rows. */
static num_unit fraction_within(const struct ray_camera *c, int x, uint32_t u, num_divisor size)
{
    int64_t twice = ((int64_t)x << 41) + ((int64_t)u << 9) + (1 << 8); /* see small() */

    return num_fraction_by(num_length_of_q45(c->side * c->side * twice), size);
}

static struct num_point aside_within(const struct ray_camera *c, const struct light_pixel *pixel, const uint32_t u[2])
{
    return aside_of(c, pixel->place, fraction_within(c, pixel->x, u[0], c->columns),
                    fraction_within(c, pixel->y, u[1], c->rows));
}

void ray_camera_ray_within(const struct ray_camera *c, const struct light_pixel *pixel, uint32_t sample,
                           const uint32_t u[2], struct ray *ray)
{
    through(c, pixel->place, aside_within(c, pixel, u), ray);
    bend(c, pixel, sample, ray);
}

bool ray_camera_is_pinhole(const struct ray_camera *c)
{
    return c->projection == TIA_PERSPECTIVE && c->lens <= 0;
}

struct num_point ray_camera_way_within(const struct ray_camera *c, const struct light_pixel *pixel, const uint32_t u[2])
{
    return num_point_add(aside_within(c, pixel, u), c->ahead);
}
