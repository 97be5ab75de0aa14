/* coherence_run.h - what the parts of coherence.h share: a run of pixels, samples of it and their bounds. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_RUN_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_RUN_H

#include "render/span/light.h"

#define COHERENCE_CASTERS 2

/* Bounds of what integers err by are powers of two: an `int` here is the logarithm of one, in the scene's unit. */
struct coherence_bounds {
    int t;                 /* relative, of t */
    int mantissa;          /* of t, at most */
    int point;             /* |P| at most */
    int reach;             /* |P|^2, as computed */
    int square;            /* |Q - P|^2, but for what t is off by */
    int facing;            /* r N.(Q - P) */
    int radius;            /* r at least */
    num_wide square_slack; /* more than two values of |Q - P|^2 may differ by their errors, with its exponent */
};

/* A sphere C, R before the light. Lengths have the run's exponent. */
struct coherence_caster {
    struct shadow_line line;
    num_wide a, c;         /* its forms at the image's middle */
    num_wide radius, away; /* R and |C - Q|, at least */
    int scale;             /* A.w 2^(scale + half) is a mantissa */
    int power_exponent;    /* of |A|^2 - R^2 */
    int toward_error, power_error;
};

struct coherence_run {
    const struct primary_rays *primary;
    const struct span_kernels *kernels;
    const struct span_sphere *sphere;
    struct light_source source;
    struct sphere_line body; /* of the pixel that is computed, as all lines here */
    struct light_line light;
    num_wide b, g, q; /* their forms at the image's middle */
    int y, middle;
    num_wide row_square; /* Y^2 + depth^2 */
    int exponent;        /* of lengths: no length that matters reaches 2^30 */
    num_wide v_most;     /* |v| at most */
    num_wide chord;      /* no longer than the diameter of the circle of the run's points */
    num_wide bias;       /* twice the shadow rays' bias, at least */
    struct coherence_bounds bounds;
    int caster_count;
    struct coherence_caster caster[COHERENCE_CASTERS];
};

enum { COHERENCE_LIT, COHERENCE_DARK, COHERENCE_OPEN };

/* What is computed of a pixel: in few bytes, as several wait at once. */
struct coherence_sample {
    num_wide square;                   /* |Q - P|^2 */
    num_wide clear[COHERENCE_CASTERS]; /* how far the shadow ray passes by: h^2 - R^2, with twice the run's exponent */
    num foot[COHERENCE_CASTERS];       /* A'.w/|w|, see kernels.h, with the run's exponent */
    num far;                           /* |w|, w = Q - P */
    num_u t, lambert;                  /* without shadows */
    num_u slack; /* what lambert may be off by from the sample to the left of it on; 0: not known yet */
    int x;
    tia_rgb565 pixel;      /* that lambert makes */
    bool faces;            /* the light; clear, foot and far are undefined otherwise */
    uint8_t shadow;        /* of all pixels from the sample to the left of it on: COHERENCE_LIT, .._DARK or .._OPEN */
    int8_t before, behind; /* whether |Q - P|^2 grows somewhere to the left, or right, of it: 1, falls: -1, or 0 */
};

/* num_shift, num_bits and num_bound out of line: they are called from many places, and flash is scarce. */
num_wide coherence_shift(num_wide x, int s);
int coherence_bits(num_wide x);
num_wide coherence_power(int bits);

/* Moves the lines, without those of casters, to pixel x. */
void coherence_go(struct coherence_run *run, int x);

/* |Q - P|^2 at pixel x; all of a sample but slack, shadow, pixel, before and behind, with what shadows need or without;
 * what arrives past the casters. */
num_wide coherence_square_at(struct coherence_run *run, int x);
void coherence_sample_at(struct coherence_run *run, int x, bool shadows, struct coherence_sample *s);
num_u coherence_lambert_at(struct coherence_run *run, int x);

/* The bounds of pixels first..last; false when t is not known to 2^-12. Needs what comes before v_most, but for the
 * exponent. */
bool coherence_bound(struct coherence_run *run, int first, int last);

/* Of one caster, for a run with bounds, and an exponent. */
void coherence_bound_caster(const struct coherence_run *run, const struct span_sphere *caster,
                            struct coherence_caster *cast);

/* What lambert may differ by, at most, between pixels where |Q - P|^2 is at least `square`; 1 and more: anything. */
num_wide coherence_lambert_slack(const struct coherence_run *run, num_wide square);

/* What integers may err by: of |w| and A'.w/|w|, and of |A'|^2 - R^2. */
struct coherence_slack {
    num_wide length, power;
};
struct coherence_slack coherence_shadow_slack(const struct coherence_run *run, const struct coherence_caster *cast,
                                              num_wide square, num_wide lambert_slack);

/* Finds the run's chord, from two samples. */
void coherence_measure(struct coherence_run *run, const struct coherence_sample *a, const struct coherence_sample *b);

/* How far P may be from the nearer of the two samples' points, in between. */
num_wide coherence_path(const struct coherence_run *run, const struct coherence_sample *a,
                        const struct coherence_sample *b);

#endif
