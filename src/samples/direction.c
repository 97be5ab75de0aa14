#include "direction.h"

#include "math/power.h"
#include "math/wide.h"

#define ONE (INT64_C(1) << 62)
#define TURN INT64_C(0x6487ed5110b4611a) /* 2 pi 2^60 */

static int64_t product(int64_t a, int64_t b)
{
    return wide_round(wide_product(a, b), 62);
}

/* Returns sqrt(1 - x^2), |x| <= 1; Q1.62. */
static int64_t rest_of_circle(int64_t x)
{
    return wide_sqrt(wide_product(ONE - x, ONE + x));
}

static int64_t unit_of(uint32_t u)
{
    return ((int64_t)u << 30) + (INT64_C(1) << 29);
}

/* Writes the sine and cosine of t 2^-64 turns, Q1.62. A table has the sines of 256 angles. The difference d from the
 * nearest of these angles is below 2^-6.3. The series in d stop where the next term is below 2^-62. */
static void turn(uint64_t t, int64_t *sine, int64_t *cosine)
{
    uint64_t nearest = (t + (UINT64_C(1) << 55)) >> 56;
    unsigned i = (unsigned)nearest & 63, quarter = (unsigned)nearest >> 6 & 3;
    int64_t d = wide_round(wide_product((int64_t)(t - (nearest << 56)), TURN), 62), q = product(d, d);
    int64_t s = product(d, ONE - product(q / 6, ONE - product(q / 20, ONE - q / 42)));
    int64_t c = ONE - product(q / 2, ONE - product(q / 12, ONE - product(q / 30, ONE - q / 56)));
    int64_t x = wide_round(wide_difference(wide_product(tia_sines[64 - i], c), wide_product(tia_sines[i], s)), 62);
    int64_t y = wide_round(wide_sum(wide_product(tia_sines[i], c), wide_product(tia_sines[64 - i], s)), 62);

    *cosine = quarter == 0 ? x : quarter == 1 ? -y : quarter == 2 ? -x : y;
    *sine = quarter == 0 ? y : quarter == 1 ? x : quarter == 2 ? -y : -x;
}

void tia_sample_turn(uint32_t u, int64_t *sine, int64_t *cosine)
{
    turn((uint64_t)u << 32 | UINT64_C(1) << 31, sine, cosine);
}

/* Maps u, as a and b in -1..1, to a point of the disc: the one that is larger in size is the radius, and the ratio of
 * the other one to it is an angle of up to an eighth of a turn. Neither is ever 0. Returns the radius, with its
 * sign. */
static int64_t concentric(const uint32_t u[2], int64_t place[2])
{
    int64_t a = 2 * unit_of(u[0]) - ONE, b = 2 * unit_of(u[1]) - ONE, s, c;
    bool longer = (a < 0 ? -a : a) > (b < 0 ? -b : b);
    int64_t radius = longer ? a : b, share = wide_quotient(longer ? b : a, radius, 62);

    turn((uint64_t)(share / 2), &s, &c);
    place[0] = product(radius, longer ? c : s);
    place[1] = product(radius, longer ? s : c);
    return radius;
}

void tia_sample_cosine(const uint32_t u[2], int64_t direction[3])
{
    direction[2] = rest_of_circle(concentric(u, direction));
}

void tia_sample_disc(const uint32_t u[2], int64_t place[2])
{
    (void)concentric(u, place);
}

/* Derivation: the density (n + 1)/(2 pi) cos^n t has cos t = u^(1/(n + 1)). */
void tia_sample_phong(const uint32_t u[2], tia_q16 exponent, int64_t direction[3])
{
    int64_t s, c, z = tia_exp2(ONE, wide_quotient(tia_log2(unit_of(u[0])), (int64_t)exponent + TIA_Q16_ONE, 16));

    z = z < ONE ? z : ONE - 1;
    int64_t r = rest_of_circle(z);

    tia_sample_turn(u[1], &s, &c);
    direction[0] = product(r, c);
    direction[1] = product(r, s);
    direction[2] = z;
}
