/* known_tmpl.h - direct light where a shadow technique has found what arrives: no shadow rays are traced.
 *
 * Parameters: the doubles and 64-bit integers of isa/isa.h. Defines: add_known(), set_known(), struct known_lights. */
#ifndef TIA_SIMD_RAYS_KNOWN_TMPL_H
#define TIA_SIMD_RAYS_KNOWN_TMPL_H

#include "reflect_tmpl.h"

#if LANES > 1
typedef uint64_t known_bits __attribute__((vector_size(8 * LANES)));
#else
typedef uint64_t known_bits;
#endif

/* The samples that reach the points, see struct sure_seen. */
struct known_lights {
    const struct sure_seen *seen;
    uint32_t slot[LANES];
    known_bits lit; /* a bit for each sample */
};

/* Sets `lit` for the slots. */
LANE_OP void set_known(struct known_lights *known)
{
#define LIT(k) known->seen->lit[known->slot[k]]
    known->lit = (known_bits){EACH_LANE(LIT)};
#undef LIT
}

/* Returns the number of the bit of a light's sample. */
LANE_OP unsigned known_bit(const struct known_lights *known, uint32_t light, unsigned sample)
{
    return known->seen->first_bit[light] + (known->seen->whole ? 0 : sample);
}

/* Returns the lanes that a sample's light reaches: the bit becomes the sign of a double. */
LANE_OP vm known_lanes(const struct known_lights *known, unsigned bit)
{
    known_bits sign = known->lit << (63 - bit) & (known_bits)as_integers(vset(-0.0));

    return vlt(as_doubles((vi)(sign | (known_bits)as_integers(vset(1)))), vset(0));
}

/* Gives the part of a sample's light that arrives, with the error of its product with the reflected part. */
LANE_OP vd known_share(const struct known_lights *known, unsigned bit, vm lit, vd *e)
{
    unsigned on = mbits(lit);

    *e = vset(0);
    if (!known->seen->shared)
        return vset(1);
#define SHARE(k) (on >> (k)&1 ? known->seen->shares[known->slot[k]][bit] : 0)
    vd share = (vd){EACH_LANE(SHARE)} * (1.0 / (1 << SURE_SHARE_BITS));
#undef SHARE
    *e = vset(BOUND(THROUGH_UNIT));
    return share;
}

/* Adds the samples of light n one after another. */
static __attribute__((noinline)) void add_known_samples(uint32_t n, const struct sure_light *l, const struct aim *aim,
                                                        const struct shade *h, vm lanes, struct lit *sum)
{
    struct picked pick = {.run = false, .class = {0}};
    struct sample *s = &sum->room->sample;

    for (pick.sample = 0; pick.sample < l->from->samples; pick.sample++) {
        unsigned bit = known_bit(sum->known, n, pick.sample);
        struct lambert lambert;
        vm lit = mand(lanes, known_lanes(sum->known, bit));
        if (!any(lit))
            continue;
        sample_of(l, aim, h, &pick, s);
        find_falloff(l, s);
        lit = find_lambert(h, s, lit, &lambert, sum);
        if (!any(lit))
            continue;
        vd e, share = known_share(sum->known, bit, lit, &e), through[3] = {share, share, share};
        add_reflected(l, h, s, &lambert, lit, through, e, sum);
    }
}

/* Sums over the samples of area light n. */
static __attribute__((noinline)) void sum_known(uint32_t n, const struct area *a, const struct shade *h,
                                                const struct known_lights *known, vm lanes, struct area_sum *result)
{
    const struct sure_light *l = a->light;
    struct area_sum sum = {.unsure = mnone()};
    struct area_terms t;

    area_terms_of(a, h, mbits(lanes), &t);
    for (unsigned i = 0; i < l->from->samples; i++) {
        struct area_sample s = {.x = vset(l->place[0][0][i]), .y = vset(l->place[0][1][i])};
        unsigned bit = known_bit(known, n, i);
        vm reached = mand(lanes, known_lanes(known, bit));
        if (!any(reached))
            continue;
        s.inverse = inverse_root(square_at(&a->seen, s.x, s.y));
        find_turned(&t, 0, reached, &s, &sum);
        vd e;
        s.through[0] = s.through[1] = s.through[2] = known_share(known, bit, s.lit, &e);
        s.filters = e * (1 / BOUND(THROUGH_UNIT));
        add_to_sum(&t, &s, 1, &sum);
    }
    sum.lambert[1] = sum.lambert[2] = sum.lambert[0];
    *result = sum;
}

/* Adds light n as a whole, if it is an area, and returns the other lanes. */
LANE_OP vm add_known_area(uint32_t n, const struct sure_light *l, const struct aim *aim, const struct shade *h,
                          vm lanes, struct lit *sum)
{
    struct area *a = &sum->room->area;

    if (!is_plain_area(l))
        return lanes;
    set_area_seen(l, aim, h, a);
    vm turned = mand(mand(lanes, a->fine), mnot(turned_away(a, h)));
    if (any(turned)) {
        sum_known(n, a, h, sum->known, turned, &sum->room->area_sum);
        add_area_sum(a, &sum->room->area_sum, h, turned, sum);
    }
    return mand(lanes, mnot(a->fine));
}

/* Adds light n. */
static __attribute__((noinline)) void add_known(uint32_t n, const struct sure_light *l, const struct aim *aim,
                                                const struct shade *h, vm lanes, struct lit *sum)
{
    vm left = add_known_area(n, l, aim, h, lanes, sum);

    if (any(left))
        add_known_samples(n, l, aim, h, left, sum);
}

#endif
