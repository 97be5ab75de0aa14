/* scatter_tmpl.h - BSDF sampling and evaluation: render/path/scatter.c in doubles.
 *
 * Parameters: the doubles of isa/isa.h. Defines: lobes_of(), lobes_mirror(), cosines_of(), respond(),
 * reflectance_error(), phong_direction(), struct lobes, struct cosines, struct response.
 *
 * The chances of a material's lobes are equal to those of the fixed-point code, or undecided. */
#ifndef TIA_SIMD_RAYS_SCATTER_TMPL_H
#define TIA_SIMD_RAYS_SCATTER_TMPL_H

#include "emitters_tmpl.h"

enum { CHANCE_MIRROR, CHANCE_GLASS, CHANCE_GLOSSY, CHANCE_DIFFUSE };

struct lobes {
    const struct sure_lobes *of[LANES]; /* lobes of each lane's material; unused lanes have those of another lane */
    struct sure_lobes mine[LANES];      /* lobes of lanes with textured materials, whose chances depend on the texel */
    vd chance[4], spread;
    unsigned glossy; /* lanes with a glossy lobe */
    struct v3 mirrored;
    vd emirrored;
};

/* Computes the chances of a material's lobes from their parts `part`, the last one within e, and cuts them to 32 bits
 * as the fixed-point code does. A chance is a difference of two numbers, each in the middle between `below` and `upto`,
 * so `spread` is the largest difference of these. */
static void cut_chances(const double part[4], double e, struct sure_lobes *to)
{
    double sum = part[0] + part[1] + part[2] + part[3], before = 0, last = 0;

    to->known = part[3] > BOUND(CHANCE_KNOWN) * e;
    to->spread = 0;
    for (int i = 0; i < 3; i++) {
        before += part[i];
        double share = before / sum,
               error = BOUND_OF(CHANCE, share * (e / sum * BOUND(CHANCE_QUOTIENT) + BOUND(CHANCE_ROUNDING)));
        double low = (share - error) * 4294967296.0, high = (share + error) * 4294967296.0;
        to->known = to->known && (before == 0 || (low >= 1 && high < 4294967295.0));
        to->below[i] = to->known && before > 0 ? (uint32_t)low : 0;
        to->upto[i] = to->known && before > 0 ? (uint32_t)high : 0;
        double middle = ((double)to->below[i] + to->upto[i]) / 2, spread = (to->upto[i] - to->below[i]) * SURE_Q32;
        to->chance[i] = (middle - last) * SURE_Q32;
        to->spread = spread > to->spread ? spread : to->spread;
        last = middle;
    }
    to->chance[CHANCE_DIFFUSE] = 1 - last * SURE_Q32;
}

/* True if a random number may choose several lobes. */
LANE_OP bool lobe_is_open(const struct sure_lobes *l, uint32_t number)
{
    bool open = false;

    for (int i = 0; i < 3; i++)
        open = open || (l->below[i] <= number && number < l->upto[i]);
    return open;
}

static void cut_textured(const struct sure_paths *paths, const struct shade *h, unsigned lanes, struct lobes *l)
{
    double part[4][LANES], e[LANES];

    vstore(part[0], most3(h->mirror));
    vstore(part[1], most3(h->refraction));
    vstore(part[2], most3(h->specular));
    vstore(part[3], most3(h->colour));
    vstore(e, h->ecolour + BOUND(CHANCE_UNIT));
    for (int k = 0; k < LANES; k++) {
        const double mine[4] = {part[0][k], part[1][k], part[2][k], part[3][k]};
        if (!(lanes >> k & 1) || paths->lobes[h->material[k]].known)
            continue;
        l->mine[k] = paths->lobes[h->material[k]];
        cut_chances(mine, e[k], &l->mine[k]);
        l->of[k] = &l->mine[k];
    }
}

LANE_OP void lobes_of(const struct sure_paths *paths, const struct shade *h, unsigned lanes, struct lobes *l)
{
    uint32_t first = h->material[__builtin_ctz(lanes)];
    const double *chance[LANES];
    bool known = true;

    l->glossy = 0;
    for (int k = 0; k < LANES; k++) {
        l->of[k] = &paths->lobes[lanes >> k & 1 ? h->material[k] : first];
        known = known && l->of[k]->known;
    }
    if (!known)
        cut_textured(paths, h, lanes, l);
    for (int k = 0; k < LANES; k++) {
        chance[k] = l->of[k]->chance;
        l->glossy |= (unsigned)(chance[k][CHANCE_GLOSSY] > 0) << k & lanes;
    }
    for (int i = 0; i < 4; i++)
        l->chance[i] = vgather(chance, i);
#define SPREAD(k) l->of[k]->spread
    l->spread = (vd){EACH_LANE(SPREAD)};
#undef SPREAD
}

/* Sets the mirrored directions and their bounds. */
LANE_OP void lobes_mirror(const struct shade *h, struct lobes *l)
{
    l->mirrored = mirrored_at(h, &l->emirrored);
}

/* The part of the light from a direction that is reflected, times the cosine x: N = x (C + H p). p is the cosine to the
 * mirrored direction, raised to the material's exponent n. C is the colour; H = (n + 2)/2 specular; 0 without a glossy
 * lobe, as is p. `density` is that of the direction, D = B x + G p. */
struct response {
    vd rgb[3];
    struct ve density;
    vd cosine, ecosine, power, epower; /* x, p, and their errors */
    vd broad[3], narrow, diffuse;      /* H, G, B */
    vd ergb, edensity;                 /* errors of N and D other than by x and p */
};

/* A direction's cosines to the normal and to the mirrored direction, with their errors. */
struct cosines {
    vd normal, enormal, mirrored, emirrored;
};

/* Sets the cosines of a direction. */
LANE_OP struct cosines cosines_of(const struct shade *h, const struct lobes *l, struct v3 to, vd eto)
{
    return (struct cosines){v3_dot(to, h->normal), BOUND_OF(LAMBERT, eto + h->en + BOUND(COSINE)),
                            v3_dot(l->mirrored, to), BOUND_OF(LOBE_COSINE, l->emirrored + eto + BOUND(COSINE))};
}

static void add_glossy(const struct shade *h, const struct lobes *l, const struct cosines *of, struct response *r)
{
    vm m = mof(l->glossy), away = vlt(of->mirrored, -of->emirrored);
    vd x = vmin(vmax(of->mirrored, vset(0)), vset(1)), n = h->exponent, p = power(x, n);
    vd ep = BOUND_OF(LOBE_POWER, power_turn(x, of->emirrored, n, p)) + vset(BOUND(POWER));
    vd broad = 0.5 * (n + 2), narrow = 0.5 * (n + 1);

    r->power = vsel(m, p, vset(0));
    r->epower = vsel(mand(m, mnot(away)), ep, vset(0)); /* both powers are 0 in directions away from the mirrored one */
    r->narrow = vsel(m, l->chance[CHANCE_GLOSSY] * narrow, vset(0));
    for (int c = 0; c < 3; c++) {
        r->broad[c] = vsel(m, h->specular[c] * broad, vset(0));
        r->rgb[c] = r->rgb[c] + r->broad[c] * r->power * r->cosine;
    }
    r->density.v = r->density.v + r->narrow * r->power;
    r->ergb = r->ergb + vsel(m, BOUND(LOBE_UNITS) * (1 + most3(h->specular)), vset(0));
    r->edensity =
        r->edensity +
        vsel(m, BOUND_OF(LOBE_SPREAD, l->spread * narrow * (r->power + r->epower)) + BOUND(LOBE_DENSITY_UNITS),
             vset(0));
}

/* Evaluates the response to light from a direction. */
LANE_OP void respond(const struct shade *h, const struct lobes *l, const struct cosines *of, struct response *r)
{
    vd most = of->normal + of->enormal;

    r->cosine = of->normal;
    r->ecosine = of->enormal;
    r->diffuse = l->chance[CHANCE_DIFFUSE];
    r->power = r->epower = r->narrow = vset(0);
    for (int c = 0; c < 3; c++) {
        r->rgb[c] = h->colour[c] * of->normal;
        r->broad[c] = vset(0);
    }
    r->density.v = r->diffuse * of->normal;
    r->ergb = BOUND_OF(DIFFUSE_COLOUR, h->ecolour * most) + BOUND(DIFFUSE_UNITS);
    r->edensity = BOUND_OF(DIFFUSE_SPREAD, l->spread * most);
    if (l->glossy)
        add_glossy(h, l, of, r);
    r->density.e = BOUND_OF(DIFFUSE_DENSITY, r->diffuse * of->enormal) + BOUND_OF(LOBE_DENSITY, r->narrow * r->epower) +
                   BOUND(DIFFUSE_DENSITY_ROUNDING) + r->edensity;
}

/* Takes away the densities of directions in the lanes outside of m. */
LANE_OP void drop_density(vm m, struct response *r)
{
    r->narrow = vsel(m, r->narrow, vset(0));
    r->diffuse = vsel(m, r->diffuse, vset(0));
    r->edensity = vsel(m, r->edensity, vset(0));
    r->density = ve_sel(m, r->density, ve_of(vset(0), vset(0)));
}

/* Returns the error of N/D, D = A + B x + G p being all densities together; `other` is A, `inverse` 1/D, and `share`
 * the largest N/D. N and D depend on the same x and p, so most of their errors cancel: with the fixed-point x', p' and
 * A',
 *
 *     N D' - N' D = (p - p') x (H (A + B x') - G C) + (x - x') (C + H p') (A + G p) + N (A' - A).
 *
 * The errors of C, B and G, and roundings, add (dN + N/D dD)/D'. D' is at least 15/16 D, as D is above 16 times its
 * error. The first term is a difference; what it is rounded by, 4 u H (A + B) at most, is covered by the error of x,
 * which is at least 16 u and multiplies as much. */
LANE_OP vd reflectance_error(const struct shade *h, const struct response *r, struct ve other, vd inverse, vd share)
{
    vd cross = vset(0), lit = vset(0);

    for (int c = 0; c < 3; c++) {
        vd change = vabs(r->broad[c] * (other.v + r->diffuse * r->cosine) - r->narrow * h->colour[c]);
        cross = vmax(cross, change + r->broad[c] * (other.v + r->diffuse) * r->ecosine);
        lit = vmax(lit, h->colour[c] + r->broad[c] * (r->power + r->epower));
    }
    vd turned = BOUND_OF(SHARE_POWER, r->epower * r->cosine * cross) +
                BOUND_OF(SHARE_COSINE, r->ecosine * lit * (other.v + r->narrow * r->power));
    vd e = BOUND_OF(SHARE_REFLECTED, r->ergb) + BOUND_OF(SHARE_DENSITY, share * (r->edensity + other.e));

    return BOUND(SHARE_QUOTIENT) * inverse * (turned * inverse + e) + BOUND(SHARE_UNIT) + share * BOUND(SHARE_ROUNDING);
}

/* Returns directions of Phong's lobe around z, computed by the fixed-point code: a bound of doubles would be wide. */
static struct v3 phong_direction(const struct shade *h, const vu u[2], unsigned lanes)
{
    double d[3][LANES] = {{0}};
    uint32_t numbers[2][LANES];
    double exponent[LANES];

    vstore(exponent, h->exponent);
    vu_store(numbers[0], u[0]);
    vu_store(numbers[1], u[1]);
    for (int k = 0; k < LANES; k++) {
        const uint32_t pair[2] = {numbers[0][k], numbers[1][k]};
        int64_t local[3];
        if (!(lanes >> k & 1))
            continue;
        tia_sample_phong(pair, (tia_q16)(exponent[k] * 65536), local);
        for (int i = 0; i < 3; i++)
            d[i][k] = (double)local[i] * SURE_Q62;
    }
    return (struct v3){vload(d[0]), vload(d[1]), vload(d[2])};
}

#endif
