#include "parse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool parse_wide(const char *text, const char **end, uint64_t min, uint64_t max, uint64_t *value)
{
    uint64_t sum = 0;
    const char *at = text;
    for (; *at >= '0' && *at <= '9'; at++) {
        uint64_t digit = (uint64_t)(*at - '0');
        if (digit > max || sum > (max - digit) / 10)
            return false;
        sum = sum * 10 + digit;
    }
    if (at == text || sum < min || (!end && *at != '\0'))
        return false;
    if (end)
        *end = at;
    *value = sum;
    return true;
}

bool parse_number(const char *text, const char **end, uint32_t min, uint32_t max, uint32_t *value)
{
    uint64_t wide;
    bool fine = parse_wide(text, end, min, max, &wide);

    if (fine)
        *value = (uint32_t)wide;
    return fine;
}

bool parse_size(const char *text, const char **end, uint32_t max, uint16_t *width, uint16_t *height)
{
    uint32_t w, h;
    const char *rest;
    if (!parse_number(text, &rest, 1, max, &w) || *rest != 'x' || !parse_number(rest + 1, end, 1, max, &h))
        return false;
    *width = (uint16_t)w;
    *height = (uint16_t)h;
    return true;
}

bool parse_mode(const char *text)
{
    uint16_t width, height;
    uint32_t hertz;
    const char *rest;
    if (strcmp(text, "preferred") == 0)
        return true;
    if (!parse_size(text, &rest, UINT16_MAX, &width, &height))
        return false;
    return *rest == '\0' || (*rest == '@' && parse_number(rest + 1, NULL, 1, 1000, &hertz));
}

enum { FRACTION_DIGITS = 40 };

/* Returns 0.DIGITS with `places` bits, at most 32, rounded to nearest, ties up. The result is exact: the decimal digits
 * are doubled once for each bit. */
static uint64_t fraction(const char *text, size_t count, unsigned places)
{
    unsigned char digits[FRACTION_DIGITS];
    uint64_t bits = 0;
    for (size_t i = 0; i < count; i++)
        digits[i] = (unsigned char)(text[i] - '0');
    for (unsigned bit = 0; bit < places + 1; bit++) {
        unsigned carry = 0;
        for (size_t i = count; i-- > 0;) {
            unsigned twice = digits[i] * 2u + carry;
            digits[i] = (unsigned char)(twice % 10);
            carry = twice / 10;
        }
        bits = bits * 2 + carry;
    }
    return (bits + 1) / 2;
}

/* Parses a number whose integer part is at most `most`, with `places` bits after the point; *end receives its end. */
static bool parse_fixed(const char *text, const char **end, uint32_t most, unsigned places, uint64_t *value)
{
    uint32_t whole;
    if (!parse_number(text, end, 0, most, &whole))
        return false;
    *value = (uint64_t)whole << places;
    if (**end != '.')
        return true;
    const char *digits = *end + 1;
    size_t count = strspn(digits, "0123456789");
    if (count == 0 || count > FRACTION_DIGITS)
        return false;
    *value += fraction(digits, count, places);
    *end = digits + count;
    return true;
}

bool parse_scaled(const char *text, int bits, tia_q16 *value)
{
    const char *rest;
    uint64_t sum;
    if (!parse_fixed(text, &rest, bits < 0 ? INT32_MAX : 32767, (unsigned)(16 + bits), &sum))
        return false;
    *value = (tia_q16)(sum & INT32_MAX);
    return *rest == '\0' && sum <= INT32_MAX;
}

bool parse_long(const char *text, const char **end, int64_t *value)
{
    bool minus = *text == '-';
    const char *rest;
    uint64_t sum;
    if (!parse_fixed(text + minus, &rest, INT32_MAX, 32, &sum) || (!end && *rest != '\0') || sum > INT64_MAX)
        return false;
    if (end)
        *end = rest;
    *value = minus ? -(int64_t)sum : (int64_t)sum;
    return true;
}

bool parse_place(const char *text, int64_t place[3])
{
    for (int i = 0; i < 3; i++) {
        const char *rest;
        if (!parse_long(text, &rest, &place[i]) || *rest != (i < 2 ? ',' : '\0'))
            return false;
        text = rest + 1;
    }
    return true;
}

unsigned parse_longest(int bits)
{
    return bits < 0 ? (32768u << -bits) - 1 : 32767u >> bits;
}

bool parse_seconds(const char *text, tia_q16 *seconds)
{
    return parse_scaled(text, 0, seconds);
}

bool parse_rate(const char *text, uint32_t rate[2])
{
    const char *rest;
    rate[1] = 1;
    if (!parse_number(text, &rest, 1, 1000000, &rate[0]))
        return false;
    return *rest == '\0' || (*rest == '/' && parse_number(rest + 1, NULL, 1, 1000000, &rate[1]));
}

bool parse_real(const char **text, double *value)
{
    char *end;

    *value = strtod(*text, &end);
    if (end == *text || !isfinite(*value))
        return false;
    *text = end;
    return true;
}

bool parse_reals(const char *text, double limit, double *values, int count)
{
    for (int i = 0; i < count; i++)
        if ((i > 0 && *text++ != ',') || !parse_real(&text, &values[i]) || fabs(values[i]) >= limit)
            return false;
    return *text == '\0';
}
