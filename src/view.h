/* view.h - a scene prepared for one image size. The only state that tracing and lighting share.
 *
 * Everything is relative to the eye, and the pixel's direction v is the unnormalised lattice
 * vector (2x+1-width, height-2y-1, -height/tan(fov/2)); its exponent is chosen so that |v| < 2^30.
 * A point seen by the pixel is P = t v.
 */
#ifndef TIA_VIEW_H
#define TIA_VIEW_H

#include "num.h"
#include "slice.h"

#define CHUNK 64 /* pixels that a kernel works on at once */

/* A sphere of the scene, or the sphere that a light is seen as. */
struct body {
    struct num_vec centre; /* L */
    num_wide c;            /* L.L - r^2, exponent 32: negative when the eye is inside */
    num_wide radius;       /* exponent 16 */
    num_u inverse;         /* num_inverse(radius) */
    int radius_bits;       /* num_bits(radius) */

    /* The exponents and constants of the kernels that compute t, see shape/sphere.c. */
    int b_shift;         /* L.v * 2^b_shift fills an accumulator */
    num_u c_disc, c_top; /* c as the discriminant and the quotient take it */
    int t_shift;         /* what num_quotient is given */
    int t_exponent;      /* the exponent of t */
    struct run rows;     /* the rows that may see it; empty: no pixel does */
};

struct tia_view {
    const struct tia_scene *scene;
    struct tia_light *lights; /* our copy */
    struct body *bodies;      /* the spheres, then the lights */
    uint32_t light_count, light_capacity;

    int width, height;
    int exponent;              /* f, of lattice numbers */
    num_wide x_reach, y_reach; /* beyond every |X| and |Y| of the image */
    num_wide depth;            /* height/tan(fov/2) */
    int square_shift;          /* v.v * 2^square_shift fills an accumulator */
    bool tinted;               /* some material lets shadow rays through */
    bool grey_shadows;         /* what they keep on their way is grey */
    bool grey;                 /* and all lights are */
};

/* A product a.v along a row as an accumulator: start at the first pixel, then add step. */
struct row_form {
    num_wide start, step;
};

/* v.v along a row: start at pixel x, then add step, then add twice to step. */
struct row_square {
    num_wide start, step, twice;
};

/* The largest |a.v| that a pixel of the image can have: it is met in a corner. */
num_wide view_reach(const struct tia_view *view, struct num_vec a);

/* a.v * 2^shift from pixel (x, y) on, as num_top takes it. */
struct row_form view_row_form(const struct tia_view *view, struct num_vec a, int x, int y, int shift);

/* v.v * 2^square_shift from pixel (x, y) on. */
struct row_square view_row_square(const struct tia_view *view, int x, int y);

/* height - 2y - 1, as a lattice number. */
num_wide view_lattice_y(const struct tia_view *view, int y);

/* Whether `tile` is not empty and lies in an area that starts at (x, y). */
bool view_tile_inside(struct tia_tile tile, unsigned x, unsigned y, unsigned width, unsigned height);

#endif
