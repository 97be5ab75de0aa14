#include "math/fast.h"

#include "kernels.h"

#include "math/integer.h"
#include "math/noinline.h"

static void sphere(const struct sphere_line *line, num_u *t)
{
    num_wide b = line->b;
    struct row_square v = line->square;

    for (int i = 0; i < line->count; i++) {
        num_u top = num_top_u(b);
        num_u root = num_sqrt(num_excess(num_mul_u(top, top), num_mul_u(line->c_disc, num_top_u(v.start))));
        num_u sum = top + root;
        t[i] = num_quotient(line->c_top, sum > 0 ? sum : NUM_LEAST, line->t_shift);
        b += line->b_step;
        v.start += v.step;
        v.step += v.twice;
    }
}

/* Returns 'half' of the pixel's num_normal. */
static inline int light_pixel(const struct light_line *line, num_wide facing, num_wide square, struct lit *lit, int i)
{
    num_wide positive = square > 0 ? square : NUM_LEAST;
    struct num_normal n = num_normal(positive);

    lit->facing[i] = num_scale_within(facing, line->scale + n.half);
    lit->square[i] = positive;
    lit->near[i] = num_normal_top(n);
    lit->inverse[i] = n.inverse;
    lit->half[i] = (uint8_t)n.half;
    return n.half;
}

/* Returns the first pixel from i on, where the accumulator of G.v is `g`, that may face the light, or the number of
 * pixels. Of those before it nothing else need be computed. */
static ONCE_IN_FLASH int pass_turned(const struct light_line *line, const num_u *distance, int i, num_wide g,
                                     num_u *facing)
{
    num_wide least = -line->facing_doubt;

    for (; i < line->count; i++, g += line->g_step) {
        if (line->facing + num_mul(num_signed(distance[i]), num_top(g)) > least)
            break;
        facing[i] = 0;
    }
    return i;
}

static bool light(const struct light_line *line, const num_u *distance, struct lit *lit)
{
    num_wide g = line->g, q = line->q, least = -line->facing_doubt;
    struct row_square v = line->square;
    int most_half = -1;

    lit->open = 0;
    for (int i = 0, next = 0;; i++) {
        if (i == next) {
            num t = num_signed(distance[i]);
            num_wide facing = line->facing + num_mul(t, num_top(g));
            next++;
            if (facing > 0) {
                lit->reach[i] = light_reach(line, t, v.start);
                int half = light_pixel(line, facing, light_square(line, t, q, lit->reach[i]), lit, i);
                most_half = half > most_half ? half : most_half;
            } else if (NUM_CERTIFIED && facing > least) {
                lit->facing[i] = 0;
                lit->open |= PIXEL_BIT(i);
            } else {
                lit->facing[i] = 0;
                next = pass_turned(line, distance, i + 1, g + line->g_step, lit->facing);
            }
        }
        if (next >= line->count)
            break;
        g += line->g_step;
        q += line->q_step;
        v.start += v.step;
        v.step += v.twice;
    }
    lit->most_half = (uint8_t)(most_half < 0 ? 0 : most_half);
    return most_half >= 0;
}

static void lambert(const struct lit *lit, num_u inverse, int count, num_u *lambert)
{
    for (int i = 0; i < count; i++)
        lambert[i] = lit->facing[i] > 0 ? num_lambert(num_mul_top(lit->facing[i], lit->inverse[i]), inverse) : 0;
}

/* Verdicts of a shadow; those in doubt say what the integers find. */
enum verdict { LIT, DARK, MAYBE_LIT, MAYBE_DARK };

/* Compares (A'.w)^2 with |w|^2 (|A'|^2 - R^2). */
static ONCE_IN_FLASH int cover_order(const struct shadow_line *line, num_wide a, num_wide k, const struct lit *lit,
                                     int i, int margin)
{
    return num_cover_order(a, lit->near[i], lit->half[i], k, line->swell, line->exponent, margin);
}

/* Decides a pixel near the shadow's edge, or whose a or k is so small that its error matters, by the ends of their
 * ranges; `beyond` is |w|^2 - A'.w. */
static NOINLINE enum verdict decide(const struct shadow_line *line, num_wide a, num_wide beyond, num_wide k,
                                    const struct lit *lit, int i)
{
    num_wide a_most = a + line->a_doubt, a_least = a - line->a_doubt;
    num_wide k_most = k + line->k_doubt, k_least = k - line->k_doubt;

    if (a_most <= 0 || (k_least > 0 && cover_order(line, a_most, k_least, lit, i, line->margin) < 0))
        return LIT;
    bool before = line->enclosed || beyond > line->beyond_doubt;
    if (a_least > 0 && before && (k_most <= 0 || cover_order(line, a_least, k_most, lit, i, line->margin) > 0))
        return DARK;
    before = a > 0 && (line->enclosed || beyond > 0);
    return before && (k <= 0 || cover_order(line, a, k, lit, i, 26) >= 0) ? MAYBE_DARK : MAYBE_LIT;
}

/* Decides whether the sphere blocks the light; `product` is t (C + Q).v and `turn` t C.v. */
static enum verdict meets(const struct shadow_line *line, num_wide product, num_wide turn, const struct lit *lit, int i)
{
    num_wide a = shadow_toward(line, product, lit->reach[i]);

    if (a <= -line->a_doubt)
        return LIT;
    a -= shadow_bias(line, lit->facing[i], lit->half[i]);
    if (a <= -line->a_doubt)
        return LIT;
    num_wide beyond = num_down(lit->square[i], line->square_down) - num_down(a, line->product_down);
    if (!line->enclosed && beyond <= -line->beyond_doubt)
        return LIT;
    num_wide k = shadow_power(line, turn, lit->reach[i]);
    int order = 0;
    if (!NUM_CERTIFIED && k <= 0)
        return DARK;
    if (!NUM_CERTIFIED || (a > line->a_clear && k > line->k_clear))
        order = cover_order(line, a, k, lit, i, 14);
    if (order < 0)
        return LIT;
    if (order > 0 && (line->enclosed || !NUM_CERTIFIED || beyond > line->beyond_doubt))
        return DARK;
    return decide(line, a, beyond, k, lit, i);
}

static void shadow(const struct shadow_line *line, const num_u *t, struct lit *lit)
{
    num_wide a = line->a + (num_wide)line->first * line->a_step, c = line->c + (num_wide)line->first * line->c_step;

    for (int i = line->first; i < line->count; i++) {
        num distance = num_signed(t[i]);
        if (lit->facing[i] > 0) {
            enum verdict verdict = meets(line, num_mul(distance, num_top(a)), num_mul(distance, num_top(c)), lit, i);
            if (verdict >= MAYBE_LIT)
                lit->open |= PIXEL_BIT(i);
            if (verdict == DARK || verdict == MAYBE_DARK)
                lit->facing[i] = 0;
        }
        a += line->a_step;
        c += line->c_step;
    }
}

static void add(num_u *sum, const num_u *lambert, num_u colour, int count)
{
    for (int i = 0; i < count; i++)
        sum[i] = num_clamp(sum[i] + num_colour_product(lambert[i], colour));
}

/* The levels of a pixel's channels, and whether another level is near. */
struct packed {
    num_level_word pixel, near;
};

static inline struct packed pack_levels(num_u r, num_u g, num_u b, num_u margin)
{
    num_level_word near = num_is_near_level(r, margin);

    near |= num_is_near_level(g, margin);
    near |= num_is_near_level(b, margin);
    return (struct packed){num_floor_level(r) << 11 | num_floor_level(g) << 5 | num_floor_level(b), near};
}

static inline struct packed pack_pixel(const num_u *const rgb[3], int i, num_u threshold, num_u margin)
{
    return pack_levels(num_level(rgb[0][i], 31, threshold), num_level(rgb[1][i], 63, threshold),
                       num_level(rgb[2][i], 31, threshold), margin);
}

static inline struct packed pack_grey(num_u grey, num_u threshold, num_u margin)
{
    num_u level = num_level(grey, 31, threshold);

    return pack_levels(level, num_further_level(level, grey, 32, threshold), level, margin);
}

/* Eight pixels at a time, in arrays of their own, which compilers convert to vectors. */
static inline pixel_set pack_eights(const num_u *const rgb[3], num_u margin, const num_u *threshold, int x, int count,
                                    tia_rgb565 *out)
{
    bool swap = span_swaps(threshold);
    num_u from[8];
    pixel_set open = 0;

    for (int j = 0; j < 8; j++)
        from[j] = num_level_threshold(threshold[(x + j) & 7], margin);

    for (int i = 0; i < count; i += 8) {
        num_level_word pixel[8], near[8], any = 0;
        int rest = count - i < 8 ? count - i : 8;
        for (int j = 0; j < 8; j++) {
            struct packed packed = pack_pixel(rgb, i + j, from[j], margin);
            pixel[j] = packed.pixel;
            near[j] = packed.near;
        }
        for (int j = 0; swap && j < 8; j++)
            pixel[j] = pixel_order((tia_rgb565)pixel[j], true);
        for (int j = 0; j < rest; j++) {
            out[i + j] = (tia_rgb565)pixel[j];
            any |= near[j];
        }
        for (int j = 0; any && j < rest; j++)
            open |= (pixel_set)near[j] << (i + j);
    }
    return open;
}

/* Pixel by pixel, which is faster on processors of 32 bits and less, without vectors. True if a pixel is near a level.
 */
static inline bool pack_singly(const num_u *const rgb[3], num_u margin, const num_u *threshold, int x, int count,
                               tia_rgb565 *out)
{
    bool grey = rgb[0] == rgb[1]; /* often */
    num_level_word any = 0;

    for (int i = 0; !grey && i < count; i++) {
        struct packed packed = pack_pixel(rgb, i, num_level_threshold(threshold[(x + i) & 7], margin), margin);
        out[i] = span_order(threshold, (tia_rgb565)packed.pixel);
        any |= packed.near;
    }
    for (int i = 0; grey && i < count; i++) {
        struct packed packed = pack_grey(rgb[0][i], num_level_threshold(threshold[(x + i) & 7], margin), margin);
        out[i] = span_order(threshold, (tia_rgb565)packed.pixel);
        any |= packed.near;
    }
    return any;
}

static NOINLINE pixel_set find_near(const num_u *const rgb[3], num_u margin, const num_u *threshold, int x, int count)
{
    pixel_set open = 0;

    for (int i = 0; i < count; i++)
        if (pack_pixel(rgb, i, num_level_threshold(threshold[(x + i) & 7], margin), margin).near)
            open |= PIXEL_BIT(i);
    return open;
}

static pixel_set pack(const num_u *const rgb[3], num_u doubt, const num_u *threshold, int x, int count, tia_rgb565 *out)
{
    num_u margin = num_level_doubt(doubt, 63);

    if (UINTPTR_MAX > UINT32_MAX)
        return pack_eights(rgb, margin, threshold, x, count, out);
    return pack_singly(rgb, margin, threshold, x, count, out) ? find_near(rgb, margin, threshold, x, count) : 0;
}

tia_rgb565 span_pixel(const num_u rgb[3], num_u threshold)
{
    return (tia_rgb565)(num_quantise(num_clamp(rgb[0]), 31, threshold) << 11 |
                        num_quantise(num_clamp(rgb[1]), 63, threshold) << 5 |
                        num_quantise(num_clamp(rgb[2]), 31, threshold));
}

const struct span_kernels span_kernels_plain = {sphere, span_sphere_inside, light, shadow, lambert, add, pack};
