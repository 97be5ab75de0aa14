#include "ball.h"

#include <stddef.h>

#include "math/target.h"
#include "math/wide.h"

/* ---- radii, always rounded up ---- */

/* Returns an upper bound of x 2^e. */
static struct ball_radius radius_of(uint32_t x, int e)
{
    if (!x)
        return (struct ball_radius){0, 0};
    int down = 17 - (int)tia_clz32(x);
    x = down > 0 ? ((x - 1) >> down) + 1 : x << -down;
    bool carry = x >> 15; /* x is 2^15 at most */
    return (struct ball_radius){x >> carry, e + down + carry};
}

static struct ball_radius radius_add(struct ball_radius a, struct ball_radius b)
{
    bool first = !b.m || (a.m && a.e >= b.e);
    struct ball_radius large = first ? a : b, small = first ? b : a;
    int down = large.e - small.e;

    return small.m ? radius_of(large.m + (down > 15 ? 1 : ((small.m - 1) >> down) + 1), large.e) : large;
}

static struct ball_radius radius_mul(struct ball_radius a, struct ball_radius b)
{
    return radius_of(a.m * b.m, a.e + b.e);
}

/* Returns an upper bound of the sizes |x| of a ball's numbers. */
static struct ball_radius most_of(int n, const struct ball *a)
{
    return radius_add(radius_of(a->sign ? (a->m[n - 1] >> 16) + 1 : 0, a->e + 32 * n - 16), a->radius);
}

/* ---- integers of n words, the lowest first ---- */

static uint32_t word_at(const uint32_t *m, int n, int i)
{
    return i >= 0 && i < n ? m[i] : 0;
}

/* Returns 32 bits of m from bit `at` on. Bits outside of m are 0. */
static uint32_t window(const uint32_t *m, int n, int at)
{
    int word = at >> 5, bit = at & 31;
    uint32_t low = word_at(m, n, word) >> bit;

    return bit ? low | word_at(m, n, word + 1) << (32 - bit) : low;
}

static bool any_below(const uint32_t *m, int n, int bits)
{
    for (int i = 0; i < n && 32 * i < bits; i++)
        if (bits - 32 * i >= 32 ? m[i] : m[i] << (32 - (bits - 32 * i)))
            return true;
    return false;
}

static int length_of(const uint32_t *m, int n)
{
    while (n > 0 && !m[n - 1])
        n--;
    return n ? 32 * n - (int)tia_clz32(m[n - 1]) : 0;
}

/* Adds a 2^(32 up) to p, of `count` words; if all bits of `flip` are set, sets p to a 2^(32 up) - p. Returns the carry,
 * which is 0 where that difference is negative. */
static uint32_t add(uint32_t *p, int count, const uint32_t *a, int n, int up, uint32_t flip)
{
    uint32_t carry = flip & 1;

    for (int i = 0; i < count; i++) {
        uint32_t x = word_at(a, n, i - up) + carry, y = p[i] ^ flip;
        carry = x < carry;
        p[i] = x + y;
        carry += p[i] < y;
    }
    return carry;
}

static void shift_in(uint32_t *m, int n, uint32_t low, int bits)
{
    for (int i = n - 1; i > 0; i--)
        m[i] = m[i] << bits | m[i - 1] >> (32 - bits);
    m[0] = m[0] << bits | low;
}

/* ---- balls ---- */

/* Sets r to sign m 2^e, m of `count` words, cut to n words. The radius grows by a last bit where bits other than 0 are
 * cut. */
static void put(int n, struct ball *r, int sign, const uint32_t *m, int count, int e, struct ball_radius radius)
{
    int down = length_of(m, count) - 32 * n;

    r->sign = down > -32 * n ? sign : 0;
    r->e = e + down;
    r->radius = any_below(m, count, down) ? radius_add(radius, radius_of(1, e + down)) : radius;
    for (int i = 0; i < n; i++)
        r->m[i] = window(m, count, 32 * i + down);
}

static int bits64(uint64_t x)
{
    return x ? 64 - (int)tia_clz64(x) : 0;
}

/* Returns the mantissa of two words. */
static uint64_t two(const struct ball *a)
{
    return (uint64_t)a->m[1] << 32 | a->m[0];
}

/* Sets r, of two words, to sign (high 2^64 + low) 2^e, cut as by put(). */
static void put_two(struct ball *r, int sign, uint64_t high, uint64_t low, int e, struct ball_radius radius)
{
    int up = 64 - bits64(high);

    if (up == 64) {
        high = low;
        low = 0;
        e -= 64;
        up = 64 - bits64(high);
    }
    if (up && up < 64) {
        high = high << up | low >> (64 - up);
        low <<= up;
    }
    r->m[0] = (uint32_t)high;
    r->m[1] = (uint32_t)(high >> 32);
    r->sign = high ? sign : 0;
    r->e = e + 64 - up;
    r->radius = low ? radius_add(radius, radius_of(1, r->e)) : radius;
}

void tia_ball_set(int words, struct ball *r, int64_t x, int e)
{
    uint64_t size = x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
    uint32_t m[2] = {(uint32_t)size, (uint32_t)(size >> 32)};

    put(words, r, x < 0 ? -1 : 1, m, 2, e, radius_of(0, 0));
}

void tia_ball_convert(int words, struct ball *r, int from_words, const struct ball *from)
{
    put(words, r, from->sign, from->m, from->sign ? from_words : 0, from->e, from->radius);
}

/* Sets r, of two words, to the sum of `large` with the sign `sign` and `small` with the sign small_sign, where large->e
 * >= small->e. Bits of `small` below `low` need no radius of their own unless `low` is 0: otherwise put_two() cuts bits
 * and adds a last bit, which is more than all of them. Where a carry shifts `low` down, its last bit is 0. */
static void sum_two(struct ball *r, const struct ball *large, const struct ball *small, int sign, int small_sign,
                    struct ball_radius radius)
{
    int down = large->e - small->e;
    uint64_t a = two(large), b = two(small), high = down < 64 ? b >> down : 0;
    uint64_t low = down == 0 || down > 127 ? 0 : down < 64 ? b << (64 - down) : b >> (down - 64);

    if (down > 127)
        radius = radius_add(radius, radius_of(1, large->e - 64));
    if (sign == small_sign) {
        high += a;
        if (high < a) { /* the carry becomes the top bit */
            put_two(r, sign, high >> 1 | UINT64_C(1) << 63, high << 63 | low >> 1, large->e - 63, radius);
            return;
        }
        put_two(r, sign, high, low, large->e - 64, radius);
    } else if (a > high || (a == high && !low)) {
        put_two(r, sign, a - high - (low != 0), 0 - low, large->e - 64, radius);
    } else { /* down is 0 */
        put_two(r, small_sign, high - a, low, large->e - 64, radius);
    }
}

/* As sum_two(), of n words. One word of `small` below the last bit of `large` is kept. Where `small` has bits below
 * that, it is less than 2^-31 of `large`, so that the sum has n words without them. */
static void sum_words(int n, struct ball *r, const struct ball *large, const struct ball *small, int sign,
                      int small_sign, struct ball_radius radius)
{
    uint32_t p[TIA_BALL_WORDS + 2];
    int down = large->e - small->e, e = large->e - 32;

    down = down < 32 * n + 32 ? down : 32 * n + 32;
    for (int i = 0; i < n + 2; i++)
        p[i] = window(small->m, n, 32 * (i - 1) + down);
    if (any_below(small->m, n, down - 32))
        radius = radius_add(radius, radius_of(1, e));
    if (!add(p, n + 2, large->m, n, 1, sign == small_sign ? 0 : UINT32_MAX) && sign != small_sign) {
        add(p, n + 2, p, 0, 0, UINT32_MAX);
        sign = small_sign;
    }
    put(n, r, sign, p, n + 2, e, radius);
}

static void sum(int n, struct ball *r, const struct ball *a, const struct ball *b, int b_sign)
{
    struct ball_radius radius = radius_add(a->radius, b->radius);
    bool first = !b_sign || (a->sign && a->e >= b->e);
    const struct ball *large = first ? a : b, *small = first ? b : a;
    int sign = first ? a->sign : b_sign, small_sign = first ? b_sign : a->sign;

    if (!small_sign) {
        *r = *large;
        r->sign = sign;
        r->radius = radius;
    } else if (TIA_WORD_PAIRS && n == 2) {
        sum_two(r, large, small, sign, small_sign, radius);
    } else {
        sum_words(n, r, large, small, sign, small_sign, radius);
    }
}

void tia_ball_add(int words, struct ball *r, const struct ball *a, const struct ball *b)
{
    sum(words, r, a, b, b->sign);
}

void tia_ball_sub(int words, struct ball *r, const struct ball *a, const struct ball *b)
{
    sum(words, r, a, b, -b->sign);
}

/* Returns a bound of |x y - a b| for numbers x in a ball and y in another, whose midpoints are a and b: |a| rb + |b| ra
 * + ra rb, the last of which is counted twice. */
static struct ball_radius product_radius(int n, const struct ball *a, const struct ball *b)
{
    struct ball_radius r = b->radius.m ? radius_mul(most_of(n, a), b->radius) : b->radius;

    return a->radius.m ? radius_add(r, radius_mul(most_of(n, b), a->radius)) : r;
}

void tia_ball_mul(int words, struct ball *r, const struct ball *a, const struct ball *b)
{
    struct ball_radius radius = product_radius(words, a, b);
    uint32_t p[2 * TIA_BALL_WORDS];
    int sign = a->sign * b->sign, e = a->e + b->e;

    if (TIA_WORD_PAIRS && words == 2) {
        struct tia_wide q = tia_wide_product(sign ? two(a) : 0, sign ? two(b) : 0);
        put_two(r, sign, q.high, q.low, e, radius);
        return;
    }
    for (int i = 0; i < 2 * words; i++)
        p[i] = 0;
    for (int i = 0; sign && i < words; i++) {
        uint64_t carry = 0;
        for (int j = 0; a->m[i] && j < words; j++) {
            carry += tia_mul_u32(a->m[i], b->m[j]) + p[i + j];
            p[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        p[i + words] = (uint32_t)carry;
    }
    put(words, r, sign, p, 2 * words, e, radius);
}

/* Sets r to sign q 2^e, where q has `count` bits and is rounded down: the quotient m 2^(count - 1)/by or, if `by` is
 * NULL, the root of m 2^(64n - 2 - at). Each step finds a bit of q from the next bits of m, one for a quotient and two
 * for a root, from bit `at` of m downwards. */
static void find_digits(int n, struct ball *r, int sign, int e, const uint32_t *m, int at, int count,
                        const uint32_t *by)
{
    uint32_t rest[TIA_BALL_WORDS + 1], trial[TIA_BALL_WORDS + 1], q[TIA_BALL_WORDS + 1];
    int step = by ? 1 : 2;

    for (int i = 0; i <= n; i++) {
        rest[i] = window(m, n, 32 * i + at + step);
        q[i] = 0;
    }
    for (; count > 0; count--, at -= step) {
        shift_in(rest, n + 1, window(m, n, at) & (by ? 1 : 3), step);
        for (int i = 0; i <= n; i++)
            trial[i] = by ? word_at(by, n, i) : q[i];
        if (!by)
            shift_in(trial, n + 1, 1, 2);
        uint32_t fits = add(trial, n + 1, rest, n + 1, 0, UINT32_MAX);
        for (int i = 0; fits && i <= n; i++)
            rest[i] = trial[i];
        shift_in(q, n + 1, fits, 1);
    }
    put(n, r, sign, q, n + 1, e, radius_of(length_of(rest, n + 1) != 0, e));
}

/* Sets r to a/b, of two words, without the radii of a and b. The reciprocal of b is 2^126/b (1 + d), |d| < 2^-60;
 * put_two() counts the bits of the product that are cut. */
static void divide_two(struct ball *r, const struct ball *a, const struct ball *b)
{
    struct tia_wide p = tia_wide_product(two(a), (uint64_t)wide_reciprocal(two(b)));

    put_two(r, a->sign * b->sign, p.high, p.low, a->e - b->e - 126, radius_of(0, 0));
    struct ball_radius off = most_of(2, r);
    off.e -= 59;
    r->radius = radius_add(r->radius, off);
}

/* Adds to the radius of r = a/b what the radii of a and b contribute: (ra + |r| rb)/(|b| - rb). As rb is at most |b|/4
 * and |b| at least 2^k, its top bit, that is at most 4/3 of (ra + |r| rb)/2^k; twice that is added. */
static void add_quotient_radius(int n, struct ball *r, const struct ball *a, const struct ball *b)
{
    struct ball_radius off = radius_add(a->radius, radius_mul(most_of(n, r), b->radius));

    off.e -= b->e + 32 * n - 2;
    r->radius = radius_add(r->radius, off);
}

/* True if the midpoint's size is certainly above 2^up times the radius. */
static bool is_clear(int n, const struct ball *a, int up)
{
    int e = a->e + 32 * n - 15 - up;

    return a->sign && (!a->radius.m || e > a->radius.e || (e == a->radius.e && a->m[n - 1] >> 17 > a->radius.m));
}

void tia_ball_div(int words, struct ball *r, const struct ball *a, const struct ball *b)
{
    struct ball q;

    tia_ball_set(words, &q, 0, 0);
    if (!is_clear(words, b, 2)) {
        q.radius = radius_of(1, 1 << 13);
    } else {
        if (a->sign && TIA_WORD_PAIRS && words == 2)
            divide_two(&q, a, b);
        else if (a->sign)
            find_digits(words, &q, a->sign * b->sign, a->e - b->e - 32 * words, a->m, 0, 32 * words + 1, b->m);
        add_quotient_radius(words, &q, a, b);
    }
    *r = q;
}

/* Sets r, of two words, to 2^e times the root of m 2^(62 - odd), which has 125 or 126 bits. */
static void root_two(struct ball *r, uint64_t m, int odd, int e)
{
    wide square = wide_up(wide_of_halves(0, m), (unsigned)(62 - odd));
    int64_t q = wide_sqrt(square);
    bool exact = wide_sign(wide_difference(square, wide_product(q, q))) == 0;

    put_two(r, 1, 0, (uint64_t)q, e, exact ? radius_of(0, 0) : radius_of(1, e));
}

/* The radius of a contributes sqrt(a) - sqrt(a - ra) <= ra/sqrt(a), and sqrt(a) is at least 2^floor(k/2) for the top
 * bit 2^k of a. */
void tia_ball_sqrt(int words, struct ball *r, const struct ball *a)
{
    struct ball_radius off = a->radius;
    int up = TIA_WORD_PAIRS && words == 2 ? 62 : 32 * words, odd = (a->e - up) & 1, e = (a->e - up + odd) / 2;

    if (tia_ball_sign(words, a) != BALL_ABOVE) { /* from 0 to the root of the largest number */
        off = a->sign > 0 ? most_of(words, a) : off;
        off = off.m ? radius_of(1, (off.e + 16) >> 1) : off;
        tia_ball_set(words, r, 0, 0);
    } else {
        off.e -= (a->e + 32 * words - 1) >> 1;
        if (TIA_WORD_PAIRS && words == 2)
            root_two(r, two(a), odd, e);
        else
            find_digits(words, r, 1, e, a->m, 32 * words - 2 + odd, 32 * words, NULL);
    }
    r->radius = radius_add(r->radius, off);
}

int tia_ball_sign(int words, const struct ball *a)
{
    return !a->radius.m || is_clear(words, a, 0) ? a->sign : BALL_OPEN;
}

int32_t tia_ball_floor(int words, const struct ball *a)
{
    int32_t whole = a->sign ? (int32_t)window(a->m, words, -a->e) : 0;
    bool part = a->sign && any_below(a->m, words, -a->e);

    return a->sign < 0 ? -whole - part : whole;
}
