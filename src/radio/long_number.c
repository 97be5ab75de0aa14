#include "long_number.h"

static void trim(struct number *a)
{
    while (a->count > 0 && a->word[a->count - 1] == 0)
        a->count--;
    if (a->count == 0)
        a->sign = 0;
}

void tia_number_set(struct number *out, int64_t a)
{
    out->sign = a < 0 ? -1 : a > 0;
    out->count = a != 0;
    out->word[0] = a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
}

void tia_number_copy(struct number *out, const struct number *a)
{
    out->sign = a->sign;
    out->count = a->count;
    for (unsigned i = 0; i < a->count; i++)
        out->word[i] = a->word[i];
}

/* Adds a b 2^(64 at) to `out`, where a is one word: a row of long multiplication. */
static void add_row(struct number *out, const struct number *b, uint64_t a, unsigned at)
{
    uint64_t carry = 0;

    for (unsigned k = 0; k < b->count; k++) {
        struct tia_wide p = tia_wide_product(a, b->word[k]);
        uint64_t low = p.low + carry;
        p.high += low < carry;
        out->word[at + k] += low;
        carry = p.high + (out->word[at + k] < low);
    }
    out->word[at + b->count] = carry;
}

void tia_number_multiply(struct number *out, const struct number *a, const struct number *b)
{
    out->sign = a->sign * b->sign;
    out->count = out->sign ? a->count + b->count : 0;
    if (!out->sign)
        return;
    for (unsigned i = 0; i < b->count; i++)
        out->word[i] = 0;
    for (unsigned i = 0; i < a->count; i++)
        add_row(out, b, a->word[i], i);
    trim(out);
}

void tia_number_times(struct number *out, const struct number *a, int64_t b)
{
    out->sign = b < 0 ? -a->sign : b > 0 ? a->sign : 0;
    out->count = out->sign ? a->count + 1 : 0;
    if (!out->sign)
        return;
    for (unsigned i = 0; i < a->count; i++)
        out->word[i] = 0;
    add_row(out, a, b < 0 ? 0 - (uint64_t)b : (uint64_t)b, 0);
    trim(out);
}

void tia_number_times_wide(struct number *out, const struct number *a, wide b)
{
    wide size = wide_size(b);

    out->sign = a->sign * wide_sign(b);
    out->count = out->sign ? a->count + 2 : 0;
    if (!out->sign)
        return;
    for (unsigned i = 0; i < a->count; i++)
        out->word[i] = 0;
    add_row(out, a, wide_low(size), 0);
    add_row(out, a, (uint64_t)wide_high(size), 1);
    trim(out);
}

int tia_number_compare_sizes(const struct number *a, const struct number *b)
{
    if (a->count != b->count)
        return a->count > b->count ? 1 : -1;
    for (unsigned i = a->count; i-- > 0;)
        if (a->word[i] != b->word[i])
            return a->word[i] > b->word[i] ? 1 : -1;
    return 0;
}

static void add_sizes(struct number *out, const struct number *a)
{
    unsigned count = out->count > a->count ? out->count : a->count;
    uint64_t carry = 0;

    for (unsigned i = 0; i < count; i++) {
        uint64_t x = i < out->count ? out->word[i] : 0, y = i < a->count ? a->word[i] : 0;
        uint64_t sum = x + carry;
        carry = sum < carry;
        out->word[i] = sum + y;
        carry += out->word[i] < y;
    }
    out->count = count;
    if (carry)
        out->word[out->count++] = carry;
}

/* Sets out to |large| - |small|; `out` may be either operand. */
static void subtract_sizes(struct number *out, const struct number *large, const struct number *small)
{
    uint64_t borrow = 0;
    unsigned count = large->count;

    for (unsigned i = 0; i < count; i++) {
        uint64_t x = large->word[i], y = i < small->count ? small->word[i] : 0;
        uint64_t rest = x - y, less = rest - borrow;
        borrow = (x < y) | (rest < borrow);
        out->word[i] = less;
    }
    out->count = count;
    trim(out);
}

void tia_number_add(struct number *out, const struct number *a, int s)
{
    int sign = a->sign * s;

    if (!sign)
        return;
    if (!out->sign) {
        tia_number_copy(out, a);
        out->sign = sign;
    } else if (out->sign == sign) {
        add_sizes(out, a);
    } else if (tia_number_compare_sizes(out, a) >= 0) {
        subtract_sizes(out, out, a);
    } else {
        subtract_sizes(out, a, out);
        out->sign = sign;
    }
}

int tia_number_bits(const struct number *a)
{
    return a->count ? (int)a->count * 64 - (int)tia_clz64(a->word[a->count - 1]) : 0;
}

static uint64_t word_at(const struct number *a, int i)
{
    return i >= 0 && i < (int)a->count ? a->word[i] : 0;
}

uint64_t tia_number_part(const struct number *a, int shift)
{
    int i = shift >= 0 ? shift / 64 : -((63 - shift) / 64);
    unsigned s = (unsigned)(shift - i * 64);

    return s ? word_at(a, i) >> s | word_at(a, i + 1) << (64 - s) : word_at(a, i);
}

static void double_it(struct number *a)
{
    uint64_t carry = 0;

    for (unsigned i = 0; i < a->count; i++) {
        uint64_t next = a->word[i] >> 63;
        a->word[i] = a->word[i] << 1 | carry;
        carry = next;
    }
    if (carry)
        a->word[a->count++] = 1;
}

static void halve(struct number *a)
{
    for (unsigned i = 0; i < a->count; i++)
        a->word[i] = a->word[i] >> 1 | (i + 1 < a->count ? a->word[i + 1] << 63 : 0);
    trim(a);
}

/* Computes floor((2a + b) / 2b), bit by bit; if 2a + b is negative, the quotient of absolute values is rounded up. */
int64_t tia_number_quotient(const struct number *a, const struct number *b, struct number room[2])
{
    const int most = 40;
    struct number *rest = &room[0], *step = &room[1];
    int64_t q = 0;

    tia_number_copy(rest, a);
    double_it(rest);
    tia_number_copy(step, b);
    tia_number_add(rest, step, 1);
    bool negative = rest->sign < 0;
    int digits = tia_number_bits(rest) - tia_number_bits(b);
    if (digits > most)
        return negative ? -(INT64_C(1) << most) : INT64_C(1) << most;
    for (int i = 0; i <= digits; i++)
        double_it(step);
    for (int i = 0; i <= digits; i++, q *= 2, halve(step))
        if (tia_number_compare_sizes(rest, step) >= 0) {
            subtract_sizes(rest, rest, step);
            q++;
        }
    q /= 2;
    return negative ? -(q + (rest->count > 0)) : q;
}
