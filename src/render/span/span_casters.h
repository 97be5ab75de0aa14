/* span_casters.h - lists of casters, for each sphere and light: the spheres that may block the light somewhere on the
 * sphere, found once for all pixels when the lights are set. */
#ifndef TIA_RENDER_SPAN_SPAN_CASTERS_H
#define TIA_RENDER_SPAN_SPAN_CASTERS_H

#include "scene/cancel.h"
#include "span_sphere.h"

/* Up to so many lights a sphere has a list for each. Further lights share the last one, which has the casters of all of
 * them. */
#define CASTER_ROWS 64

/* A ball in quarters of the scene's unit, exponent 14: each number is off by up to half a unit. */
struct coarse_ball {
    num x, y, z, radius;
};

struct span_casters {
    const struct span_sphere *spheres; /* the scene's spheres, then the lights' */
    struct coarse_ball *coarse;        /* the same balls */
    uint8_t *lists;                    /* a bit for each sphere of the scene */
    uint32_t count, rows;              /* number of spheres, and of lists for each */
};

/* Returns the size of the memory for the coarse balls and lists, in bytes. */
uint64_t span_casters_size(uint32_t spheres, uint32_t lights);

/* Places the coarse balls and lists in that memory, for `count` of the spheres and at most so many lights. */
void span_casters_place(struct span_casters *casters, const struct span_sphere *spheres, uint32_t count,
                        uint32_t lights, void *memory);

/* Sets the coarse ball of sphere n, which is prepared. */
void span_casters_put(const struct span_casters *casters, uint32_t n);

/* Makes the lists of a light, whose coarse ball is set; those of light 0 first. */
void span_casters_find(const struct span_casters *casters, uint32_t light, struct cancel *cancel);

/* Points of a sphere, whose casters are visited. */
struct span_lit {
    const struct span_casters *casters;
    uint32_t object;           /* the sphere */
    bool surrounded;           /* all points are in `around` */
    struct coarse_ball around; /* points as the kernels compute them, or exact ones */
};

/* Returns the first sphere from number `from` on that may block the light at some of the points; the number of spheres
 * if there is none. `lit` is a struct span_lit. */
uint32_t span_next_caster(const void *lit, uint32_t light, uint32_t from);

/* Returns the list of the spheres that may block the light at some point of a sphere: a bit for each of the scene. */
const uint8_t *span_list_of(const struct span_casters *casters, uint32_t sphere, uint32_t light);

/* Returns the first sphere from number `from` on in a list of bits; the number of spheres if there is none. */
uint32_t span_next_in(const struct span_casters *casters, const uint8_t *list, uint32_t from);

/* The hull of a ball and a light: L, r and Q of the derivation in span_casters.c. */
struct span_hull {
    num x, y, z, radius; /* the ball */
    num gx, gy, gz;      /* G */
    num_wide a;          /* A */
    int down;            /* A 2^-down is below 2^30 */
    num a_down;          /* A 2^-down, and less */
};

void span_hull_of(const struct coarse_ball *ball, const struct coarse_ball *light, struct span_hull *hull);

/* True if the caster certainly blocks no shadow ray in the hull, unless it encloses the eye. Only where
 * NUM_CERTIFIED. */
bool span_hull_clears(const struct span_hull *hull, const struct coarse_ball *caster);

/* Surrounds the point of pixel (x, y) of a sphere, whose distance is about t; false if t is too inaccurate. `doubt`
 * bounds the error of the ball's centre; 0: t says how large it is. */
bool span_coarse_point(const struct primary_rays *primary, const struct span_sphere *sphere, int x, int y, num_u t,
                       num doubt, struct coarse_ball *ball);

#endif
