/* number.c - converts decimal numbers to fixed point, without floating point.
 *
 * The result is correctly rounded, ties away from zero, for any number of digits. For the magnitude x it is floor(x
 * 2^bits + 1/2), which follows from floor(y), y = x 2^(bits + 1). The comparison of y with an integer k depends only on
 * the first bits + 1 decimals of x, since k / 2^(bits + 1) has no more decimals. So all further digits are skipped.
 */
#include "constants.h"

#define LIMB UINT64_C(1000000000)
#define LIMBS 6 /* groups of nine digits: 53 bits and the rounding bit need 54 digits */
#define STEP 32 /* largest number of bits by which the limbs are multiplied at once */
#define WHOLE_MAX (UINT64_C(1) << 32)

/* The digits of a number, and the position of its point: "12.5e3" has the digits 125, and the point after 2 + 3
 * digits. */
struct digits {
    const char *at, *end; /* the numeral's characters, with the point */
    int64_t point;
    bool negative;
};

static bool is_digit(const char *p, const char *end)
{
    return p < end && *p >= '0' && *p <= '9';
}

static const char *skip_digits(const char *p, const char *end)
{
    while (is_digit(p, end))
        p++;
    return p;
}

static const char *skip_sign(const char *p, const char *end, bool *negative)
{
    *negative = p < end && *p == '-';
    return p < end && (*p == '-' || *p == '+') ? p + 1 : p;
}

/* Parses the exponent in p..end. Its size is clamped to 2^33: no text has as many digits, so larger exponents have the
 * same result. Returns false if there is no exponent. */
static bool parse_exponent(const char *p, const char *end, int64_t *exponent)
{
    const int64_t limit = INT64_C(1) << 33;
    bool negative;

    p = skip_sign(p, end, &negative);
    if (!is_digit(p, end))
        return false;
    for (*exponent = 0; is_digit(p, end); p++)
        *exponent = *exponent < limit / 10 ? *exponent * 10 + (*p - '0') : limit;
    if (negative)
        *exponent = -*exponent;
    return p == end;
}

static bool parse_digits(struct digits *d, const struct tia_word *word)
{
    const char *end = word->at + word->length;
    int64_t exponent = 0;

    d->at = skip_sign(word->at, end, &d->negative);
    const char *point = skip_digits(d->at, end);
    d->end = point < end && *point == '.' ? skip_digits(point + 1, end) : point;
    if (d->end == d->at || (d->end == d->at + 1 && *d->at == '.'))
        return false;
    if (d->end < end && ((*d->end != 'e' && *d->end != 'E') || !parse_exponent(d->end + 1, end, &exponent)))
        return false;
    d->point = point - d->at + exponent;
    return true;
}

/* Returns the next digit, or 0 after the last one. */
static uint32_t next_digit(const char **p, const char *end)
{
    if (*p < end && **p == '.')
        ++*p;
    return *p < end ? (uint32_t)(*(*p)++ - '0') : 0;
}

/* Parses the integer part, at most WHOLE_MAX. */
static uint64_t parse_whole(const char **p, const struct digits *d)
{
    uint64_t whole = 0;

    for (int64_t i = 0; i < d->point && whole < WHOLE_MAX && (*p < d->end || whole); i++)
        whole = whole * 10 + next_digit(p, d->end);
    return whole < WHOLE_MAX ? whole : WHOLE_MAX;
}

/* Returns the fraction times 2^bits, rounded down; bits is in 1..54. Each step multiplies the limbs, nine digits each,
 * from the last to the first by at most 2^32. Carries are below 2^32, and a product plus a carry is below LIMB 2^32 <
 * 2^62. The limbs then hold the fraction of the product. */
static uint64_t parse_fraction(const char *p, const struct digits *d, unsigned bits)
{
    uint32_t limbs[LIMBS] = {0};
    uint64_t result = 0;
    int64_t zeros = d->point < 0 ? -d->point : 0;

    for (unsigned i = 0; i < LIMBS * 9 && (p < d->end || i % 9); i++)
        limbs[i / 9] = limbs[i / 9] * 10 + (i < zeros ? 0 : next_digit(&p, d->end));
    for (unsigned step; bits > 0; bits -= step) {
        uint64_t carry = 0;
        step = bits < STEP ? bits : STEP;
        for (unsigned i = LIMBS; i-- > 0; carry /= LIMB) {
            carry += (uint64_t)limbs[i] << step;
            limbs[i] = (uint32_t)(carry % LIMB);
        }
        result = result << step | carry;
    }
    return result;
}

/* Returns half of a number, rounded up. */
static uint64_t half_of(uint64_t doubled)
{
    return (doubled >> 1) + (doubled & 1);
}

#define SHORT_DIGITS 9 /* below 2^30 */
#define SHORT_BITS 32  /* a fraction of SHORT_DIGITS times 2^(SHORT_BITS + 1) is below 2^63 */

/* Reads up to SHORT_DIGITS digits and advances *p; returns their number, which is larger if there are more. */
static unsigned take_digits(const char **p, const char *end, uint32_t *value)
{
    const char *start = *p, *at = start;
    uint32_t sum = 0;

    for (; is_digit(at, end); at++)
        sum = sum * 10 + (uint32_t)(*at - '0');
    *p = at;
    *value = sum;
    return (unsigned)(at - start > SHORT_DIGITS ? SHORT_DIGITS + 1 : at - start);
}

/* Computes what tia_decimal does for a numeral of at most SHORT_DIGITS digits on either side of the point, without an
 * exponent, as most are: one quotient instead of limbs. Returns false for other words. */
static bool parse_short(int64_t *out, const struct tia_word *word, unsigned bits)
{
    static const uint32_t powers[SHORT_DIGITS + 1] = {1,      10,      100,      1000,      10000,
                                                      100000, 1000000, 10000000, 100000000, 1000000000};
    const char *end = word->at + word->length;
    uint32_t whole, fraction = 0;
    unsigned decimals = 0;
    bool negative;
    const char *p = skip_sign(word->at, end, &negative);
    unsigned digits = take_digits(&p, end, &whole);

    if (p < end && *p == '.') {
        p++;
        decimals = take_digits(&p, end, &fraction);
    }
    if (p < end || digits + decimals == 0 || digits > SHORT_DIGITS || decimals > SHORT_DIGITS || bits > SHORT_BITS)
        return false;
    uint64_t doubled = ((uint64_t)whole << (bits + 1)) + ((uint64_t)fraction << (bits + 1)) / powers[decimals];
    int64_t rounded = (int64_t)half_of(doubled);
    *out = negative ? -rounded : rounded;
    return true;
}

enum tia_decimal tia_decimal(int64_t *out, const struct tia_word *word, unsigned bits)
{
    struct digits d;

    if (parse_short(out, word, bits))
        return TIA_DECIMAL_FINE;
    if (!parse_digits(&d, word))
        return TIA_DECIMAL_NONE;
    const char *p = d.at;
    uint64_t whole = parse_whole(&p, &d);
    if (whole >= UINT64_C(1) << (63 - bits) || whole == WHOLE_MAX)
        return TIA_DECIMAL_RANGE;
    uint64_t doubled = (whole << (bits + 1)) + parse_fraction(p, &d, bits + 1);
    uint64_t rounded = half_of(doubled);
    if (rounded > INT64_MAX)
        return TIA_DECIMAL_RANGE;
    *out = d.negative ? -(int64_t)rounded : (int64_t)rounded;
    return TIA_DECIMAL_FINE;
}

bool tia_text_has_number(const struct tia_text *t)
{
    struct tia_word word;
    struct digits d;

    if (!t->numbers && t->next < t->end && *t->next == '\n')
        return false; /* the usual case: without a copy */
    struct tia_text copy = *t;
    return tia_text_word(&copy, &word) && (tia_constant_use(&copy, &word) || parse_digits(&d, &word));
}

/* Reads the next word, or the first number of a constant. */
static void read_numeral(struct tia_text *t, struct tia_word *word)
{
    (void)tia_text_word(t, word);
    if (tia_constant_use(t, word))
        (void)tia_text_word(t, word);
}

/* Reads a number times 2^bits; the product must be in min..max. */
static int read_number(struct tia_text *t, int64_t *out, unsigned bits, int64_t min, int64_t max, const char *expected)
{
    struct tia_word word;

    read_numeral(t, &word);
    enum tia_decimal result = tia_decimal(out, &word, bits);
    if (result == TIA_DECIMAL_NONE)
        return tia_text_error(t, &word, "is not a number", expected);
    *out = t->negated && result == TIA_DECIMAL_FINE ? -*out : *out;
    if (result == TIA_DECIMAL_RANGE || *out < min || *out > max)
        return tia_text_error(t, &word, "is out of range", expected);
    return TIA_OK;
}

static int read_number32(struct tia_text *t, int32_t *out, unsigned bits, int32_t min, int32_t max,
                         const char *expected)
{
    int64_t wide;
    int status = read_number(t, &wide, bits, min, max, expected);

    if (!status)
        *out = (int32_t)wide;
    return status;
}

int tia_text_q16(struct tia_text *t, tia_q16 *out)
{
    return tia_text_scaled(t, out, 0);
}

int tia_text_long(struct tia_text *t, int64_t *out, unsigned bits)
{
    int64_t most = bits < 32 ? (INT64_C(1) << (31 + bits)) - 1 : INT64_MAX;

    return read_number(t, out, bits, -most, most, "a number below 2147483648");
}

int tia_text_fine(struct tia_text *t, int64_t *out, int bits)
{
    return read_number(t, out, (unsigned)(32 + bits), -(INT64_C(1) << 47), (INT64_C(1) << 47) - 1,
                       "a number from -32768 to below 32768");
}

int tia_text_scaled(struct tia_text *t, tia_q16 *out, int bits)
{
    return read_number32(t, out, (unsigned)(16 + bits), INT32_MIN, INT32_MAX, "a number from -32768 to below 32768");
}

int tia_text_q30(struct tia_text *t, tia_q30 *out)
{
    return read_number32(t, out, 30, INT32_MIN, INT32_MAX, "a number from -2 to below 2");
}

int tia_text_unit(struct tia_text *t, tia_q30 *out)
{
    return read_number32(t, out, 30, 0, TIA_Q30_ONE, "a number from 0 to 1");
}

int tia_text_bright(struct tia_text *t, tia_q30 *out)
{
    return read_number32(t, out, 30, 0, INT32_MAX, "a number from 0 to below 2");
}

int tia_text_radiance(struct tia_text *t, tia_q30 most, int64_t *out)
{
    if (most == TIA_Q30_ONE)
        return read_number(t, out, 30, 0, INT64_C(1) << 43, "a number from 0 to 8192");
    return read_number(t, out, 30, 0, (INT64_C(1) << 44) - 1, "a number from 0 to below 16384");
}

int tia_text_q32(struct tia_text *t, int64_t *out)
{
    return read_number(t, out, 32, -INT64_MAX, INT64_MAX, "a number below 2147483648");
}

/* True if the word is an integer without point and exponent: "1e3" is an error. */
static bool is_whole(const struct tia_word *word)
{
    const char *end = word->at + word->length;
    bool negative;
    const char *p = skip_sign(word->at, end, &negative);

    return p < end && skip_digits(p, end) == end;
}

int tia_text_integer(struct tia_text *t, int64_t *out, int64_t min, int64_t max)
{
    struct tia_word word;

    read_numeral(t, &word);
    bool whole = is_whole(&word);
    if (whole && tia_decimal(out, &word, 0) == TIA_DECIMAL_FINE) {
        *out = t->negated ? -*out : *out;
        if (*out >= min && *out <= max)
            return TIA_OK;
    }
    (void)tia_text_error(t, &word, whole ? "is out of range" : "is not a whole number", "a whole number from ");
    tia_say_number(t->error, min);
    tia_say(t->error, " to ");
    tia_say_number(t->error, max);
    return TIA_ERR_RANGE;
}
