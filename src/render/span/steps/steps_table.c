/* steps_table.c - the steps of a ball's colour, by mantissas of 32 bits. */
#include "steps_row.h"

#include "math/noinline.h"
#include "render/span/span_shift.h"
#include "scene/colour.h"

/* m 2^-e; m has its highest bit set, or is 0. Each function cuts its result off. */
struct mantissa {
    uint32_t m;
    int e;
};

static struct mantissa mantissa_of(uint64_t x, int e)
{
    unsigned zeros = x ? tia_clz64(x) : 0;

    return (struct mantissa){(uint32_t)(tia_shift_to_top(x, zeros) >> 32), e + (int)zeros - 32};
}

static NOINLINE struct mantissa product(struct mantissa a, struct mantissa b)
{
    return mantissa_of(tia_mul_u32(a.m, b.m), a.e + b.e);
}

/* Returns 1/a; a is not 0. */
static struct mantissa inverse(struct mantissa a)
{
    return (struct mantissa){tia_reciprocal(a.m), 63 - a.e};
}

static NOINLINE struct mantissa sum(struct mantissa a, struct mantissa b)
{
    struct mantissa large = a.e < b.e ? a : b, small = a.e < b.e ? b : a;
    int apart = small.e - large.e;

    if (!a.m || !b.m)
        return a.m ? a : b;
    return mantissa_of(((uint64_t)large.m << 31) + (apart < 63 ? ((uint64_t)small.m << 31) >> apart : 0), large.e + 31);
}

/* Returns the square root of a, not 0. */
static struct mantissa root(struct mantissa a)
{
    unsigned odd = (unsigned)a.e & 1;
    uint32_t m = tia_sqrt_normalised((uint64_t)a.m << 32 >> odd);

    return (struct mantissa){m, (a.e + 32 - (int)odd) / 2};
}

/* Returns a 2^e, which is below 2^63, cut off. */
static uint64_t integer_of(struct mantissa a, int e)
{
    int up = e - a.e;

    return up >= 0 ? (uint64_t)a.m << up : up > -32 ? a.m >> -up : 0;
}

/* A ball and a light, for the steps. */
struct lit_ball {
    struct mantissa radius, power, near; /* r, p, and 1/c */
    int64_t facing;                      /* f, with the exponent 32 */
    int word;                            /* exponent of W */
};

/* Returns u, with the exponent 32, where the cosine is lambda. */
static int64_t quantity_at(const struct lit_ball *ball, struct mantissa lambda)
{
    struct mantissa r = product(ball->radius, lambda), square = sum(product(r, r), ball->power);
    struct mantissa away = product(ball->power, inverse(sum(root(square), r)));

    return (int64_t)integer_of(product(r, away), 32) - ball->facing;
}

/* Returns the size of u/c. */
static struct mantissa word_of(const struct lit_ball *ball, int64_t u)
{
    return product(mantissa_of(u < 0 ? 0 - (uint64_t)u : (uint64_t)u, 32), ball->near);
}

static int32_t step_at(const struct lit_ball *ball, struct mantissa lambda)
{
    int64_t u = quantity_at(ball, lambda);
    int32_t word = (int32_t)integer_of(word_of(ball, u), ball->word);

    return u < 0 ? -word : word;
}

/* ---- channels ---- */

#define UNIT(levels) ((UINT64_C(1) << 53) / (levels)) /* half a level, with the exponent 54 */

/* A channel's levels that the light reaches. */
struct levels {
    uint64_t unit, emission; /* half a level and the emission, with the exponent 54 */
    uint64_t light;          /* colour times light, with the exponent 54; 0: there are no more levels */
    struct mantissa inverse; /* of `light` */
    int level, most;         /* the level of the next step, and the last one */
    int32_t next;            /* W of the next step */
};

/* Finds the next step. The level's light is at most the channel's light, and a little more for rounding. */
static void find_next(const struct lit_ball *ball, struct levels *l)
{
    uint64_t share = (2 * (uint64_t)l->level - 1) * l->unit - l->emission;

    if (l->level > l->most || share > l->light + (l->light >> 20))
        l->light = 0;
    else
        l->next = step_at(ball, product(mantissa_of(share, 54), l->inverse));
}

/* Begins a channel; false if its light is so dim that steps are inaccurate. */
static bool begin_levels(const struct lit_ball *ball, tia_q30 colour, tia_q30 light, tia_q30 emission, unsigned most,
                         struct levels *l)
{
    l->unit = most == 31 ? UNIT(31) : UNIT(63);
    l->emission = (uint64_t)(uint32_t)emission << 24;
    l->light = tia_mul_u32((uint32_t)colour, (uint32_t)light) >> 6;
    l->most = (int)most;
    l->level = (int)num_quantise(num_clamp(num_colour(emission)), most, NUM_ROUND) + 1;
    if (!l->light)
        return true;
    l->inverse = inverse(mantissa_of(l->light, 54));
    bool dim = l->light >> (54 - 10) == 0;
    find_next(ball, l);
    return !dim || !l->light;
}

/* What a level of red, green, blue, and of red and blue together, adds to a pixel. */
static const TIA_FLASH uint16_t grown[4] = {0x0800, 0x0020, 0x0001, 0x0801};

/* Merges the channels' steps. */
static void merge(const struct lit_ball *ball, struct levels levels[3], bool grey, struct colour_steps *steps)
{
    for (steps->count = 0; steps->count < COLOUR_STEPS; steps->count++) {
        int first = -1;
        for (int c = 0; c < (grey ? 2 : 3); c++)
            if (levels[c].light && (first < 0 || levels[c].next < levels[first].next))
                first = c;
        if (first < 0)
            return;
        steps->at[steps->count] = levels[first].next;
        steps->pixel[steps->count + 1] =
            (tia_rgb565)(steps->pixel[steps->count] + grown[grey && first == 0 ? 3 : first]);
        levels[first].level++;
        find_next(ball, &levels[first]);
    }
}

static bool find_steps(const struct lit_ball *ball, const struct tia_rgb *light, const struct tia_material *material,
                       struct colour_steps *steps)
{
    const struct tia_rgb *colour = &material->colour, *emission = &material->emission;
    bool grey = colour_is_grey(light) && colour_is_grey(colour) && colour_is_grey(emission);
    struct levels levels[3];
    bool known = begin_levels(ball, colour->r, light->r, emission->r, 31, &levels[0]) &&
                 begin_levels(ball, colour->g, light->g, emission->g, 63, &levels[1]) &&
                 begin_levels(ball, colour->b, light->b, emission->b, 31, &levels[2]);

    if (known) {
        steps->pixel[0] =
            (tia_rgb565)((levels[0].level - 1) << 11 | (levels[1].level - 1) << 5 | (levels[2].level - 1));
        merge(ball, levels, grey, steps);
    }
    return known;
}

/* ---- exponents and bounds ---- */

/* Sets the exponent of W, which keeps W below 2^30.1 and G.v below 2^30; false if none is accurate. */
static bool find_exponent(const struct primary_rays *primary, const struct span_sphere *sphere, struct lit_ball *ball,
                          struct colour_steps *steps)
{
    int64_t most = quantity_at(ball, (struct mantissa){UINT32_C(1) << 31, 31}), least = ball->facing;
    uint64_t high = (uint64_t)(most < 0 ? -most : most), low = (uint64_t)(least < 0 ? -least : least);
    uint64_t size = high > low ? high : low;
    int by_form = 94 - span_bits(primary_reach(primary, &steps->to_light)) - sphere->b_shift;

    if (size >> 29 == 0)
        return false;
    ball->word = word_of(ball, (int64_t)size).e - 2;
    ball->word = ball->word < by_form ? ball->word : by_form;
    int shift = ball->word + sphere->b_shift - 32;
    steps->form_shift = (int8_t)shift;
    return shift >= -64 && shift <= 63;
}

/* Returns the bound of the error of A^2 - (W S)^2, upper words, for all steps. A and W S are off by up to `doubt` in
 * all, D's upper word by up to `above`. Where they are in the wrong order, A is at most W S + doubt. */
static int32_t margin_of(const struct colour_steps *steps, int32_t doubt, int32_t above)
{
    int32_t first = steps->count ? steps->at[0] : 0, last = steps->count ? steps->at[steps->count - 1] : 0;
    int32_t most = -first > last ? -first : last; /* |W| */
    int64_t size = (tia_mul_s32(most, steps->root_most) >> 31) + 2, weight = (tia_mul_s32(most, most) >> 32) + 1;

    return (int32_t)(((size + doubt) * doubt) >> 32) + (int32_t)((weight * above) >> 32) + STEPS_PRODUCTS;
}

/* Sets the bounds that hold for all of the ball's pixels. */
static void find_bounds(const struct primary_rays *primary, const struct span_sphere *sphere,
                        struct colour_steps *steps)
{
    int64_t root = (int64_t)span_shift(sphere->radius, sphere->b_shift - 2);
    int32_t turned = primary->exact ? 0 : (int32_t)1 << num_limited(31 - span_bits(primary->depth), 0, 20);
    int32_t steady = STEPS_BOUND(STEPS_WORD) + STEPS_BOUND(STEPS_TURNED) * turned;
    int32_t coarse = STEPS_BOUND(STEPS_COARSE) + steady;

    steps->root_most = root < INT32_MAX ? (int32_t)root : INT32_MAX;
    steps->depth_doubt = STEPS_BOUND(STEPS_DEPTH) + STEPS_BOUND(STEPS_DEPTH_TURNED) * turned;
    steps->fine_doubt = STEPS_BOUND(STEPS_FINE) + steady;
    steps->margin = margin_of(steps, coarse, 2 * steps->depth_doubt);
    steps->walk_doubt = coarse;
    steps->walk_margin = margin_of(steps, coarse, steps_above(steps));
    steps->turn_doubt = STEPS_BOUND(STEPS_WAY) + turned + steps->depth_doubt;
    steps->turn_shift = (int)span_bits((num_wide)primary->width) - 3;
    steps->turn_shift = steps->turn_shift > 0 ? steps->turn_shift : 0;
}

void steps_prepare(const struct primary_rays *primary, const struct light_source *source,
                   const struct tia_rgb *emission, const struct tia_material *material, struct colour_steps *steps)
{
    const struct span_sphere *sphere = source->sphere;
    num_wide facing = sphere->c - span_dot(&sphere->centre, &source->light);
    struct lit_ball ball;

    steps->usable = false;
    steps->to_light = span_difference(&source->light, &sphere->centre);
    num_wide power = span_square30(&steps->to_light) - span_shift(num_square(sphere->radius), -2);
    if (sphere->c <= 0 || span_bits(power) > 58 || span_bits(power) < 20 || power < 0 || span_bits(facing) > 60)
        return;
    power = span_dot(&steps->to_light, &steps->to_light) - num_square(sphere->radius);
    ball.radius = mantissa_of((uint64_t)sphere->radius, 16);
    ball.power = mantissa_of((uint64_t)power, 32);
    ball.near = inverse(mantissa_of((uint64_t)sphere->c, 32));
    ball.facing = (int64_t)facing;
    if (!find_exponent(primary, sphere, &ball, steps))
        return;
    steps->usable = find_steps(&ball, emission, material, steps);
    if (steps->usable)
        find_bounds(primary, sphere, steps);
}
