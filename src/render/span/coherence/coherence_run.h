/* coherence_run.h - data shared by the parts of coherence.h: a run of pixels, its samples and their bounds. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_RUN_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_RUN_H

#include "render/span/span_error.h"

#define COHERENCE_CASTERS 2

/* A sphere C, R that may occlude the light. Lengths have the run's exponent. */
struct coherence_caster {
    const struct span_sphere *sphere;
    struct shadow_line line;
    num_wide a, c;         /* forms of `line` at the image's middle */
    num_wide radius, away; /* upper bounds of R and |C - Q| */
    int scale;             /* A.w 2^(scale + half) is a mantissa */
    int power_exponent;    /* exponent of |A|^2 - R^2 */
    int toward_error, power_error;
};

struct coherence_run {
    const struct primary_rays *primary;
    const struct span_kernels *kernels;
    const struct span_sphere *sphere;
    struct light_source source;
    struct sphere_line body; /* body, light: lines of the pixel being computed */
    struct light_line light;
    num_wide b, g, q; /* forms of body and light at the image's middle */
    int y, middle;
    num_wide row_square;     /* Y^2 + depth^2 */
    int exponent;            /* exponent of lengths: no length that matters reaches 2^30 */
    num_wide v_most;         /* largest |v| */
    num_wide chord;          /* lower limit of the diameter of the circle on which the run's points lie */
    num_wide bias;           /* upper bound of twice the shadow rays' bias */
    struct span_error error; /* but for lambert */
    num_wide square_slack;   /* bound on the error of a difference of two |Q - P|^2, with the exponent of |Q - P|^2 */
    int caster_count;
    struct coherence_caster caster[COHERENCE_CASTERS];
};

enum { COHERENCE_LIT, COHERENCE_DARK, COHERENCE_OPEN };

/* The data computed for a pixel. It is compact, as several samples are pending at once. */
struct coherence_sample {
    num_wide square;                   /* |Q - P|^2 */
    num_wide clear[COHERENCE_CASTERS]; /* clearance of the shadow ray: h^2 - R^2, with twice the run's exponent */
    num foot[COHERENCE_CASTERS];       /* A'.w/|w|, see kernels.h, with the run's exponent */
    num far;                           /* |w|, w = Q - P */
    num_u t, lambert;                  /* lambert without shadows */
    num_u slack;                       /* error bound of lambert from here to the sample to the left; 0: not yet set */
    int x;
    tia_rgb565 pixel;      /* colour for this lambert */
    bool faces;            /* turned to the light; clear, foot and far are undefined otherwise */
    uint8_t shadow;        /* shadow of all pixels back to the sample to the left: COHERENCE_LIT, .._DARK or .._OPEN */
    int8_t before, behind; /* |Q - P|^2 to the left and right: 1 grows somewhere, -1 falls, 0 unknown */
};

/* Moves the lines, except those of casters, to pixel x. */
void coherence_go(struct coherence_run *run, int x);

/* Returns |Q - P|^2 at pixel x. */
num_wide coherence_square_at(struct coherence_run *run, int x);
/* Computes all of a sample except slack, shadow, pixel, before and behind; computes clear, foot and far only if
 * `shadows` is true. */
void coherence_sample_at(struct coherence_run *run, int x, bool shadows, struct coherence_sample *s);
/* Returns lambert at pixel x, 0 in the shadow of a caster. */
num_u coherence_lambert_at(struct coherence_run *run, int x, bool *open);

/* Sets the bounds of pixels first..last; false when t is not accurate to 2^-12. Reads the members before v_most, except
 * `exponent`. */
bool coherence_bound(struct coherence_run *run, int first, int last);

/* Sets the bounds of one caster of a run. The run's source, sphere, bounds and exponent, and cast->line, must be set.
 */
void coherence_bound_caster(const struct coherence_run *run, const struct span_sphere *caster,
                            struct coherence_caster *cast);

/* Returns a bound on the error of the difference of two values of lambert, at pixels where |Q - P|^2 is at least
 * `square`; 1 or more: none is known. */
num_wide coherence_lambert_slack(const struct coherence_run *run, num_wide square);

/* Error bounds: `length` of |w| and A'.w/|w|, with the run's exponent; `power` of |A'|^2 - R^2, with twice this
 * exponent. */
struct coherence_slack {
    num_wide length, power;
};

/* Returns the error bounds of a caster's shadow in pixels where |Q - P|^2 is at least `square`. */
struct coherence_slack coherence_shadow_slack(const struct coherence_run *run, const struct coherence_caster *cast,
                                              num_wide square, num_wide lambert_slack);

/* Sets the run's chord, from the samples at its ends. */
void coherence_measure(struct coherence_run *run, const struct coherence_sample *a, const struct coherence_sample *b);

/* Returns an upper limit of the distance from any point P between two samples to the nearer sample's point. */
num_wide coherence_path(const struct coherence_run *run, const struct coherence_sample *a,
                        const struct coherence_sample *b);

#endif
