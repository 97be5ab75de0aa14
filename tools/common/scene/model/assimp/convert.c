#include "convert.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- errors ---- */

/* Replaces what is not printable: the names and messages come from the file. */
static void clean(char *text)
{
    for (char *at = text; *at; at++)
        if ((unsigned char)*at < ' ' || *at == 127)
            *at = ' ';
    for (size_t length = strlen(text); length > 0 && text[length - 1] == ' ';)
        text[--length] = '\0';
}

int convert_fail(struct convert *c, int status, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    if (c->pack.header.status == MODEL_UNFINISHED)
        (void)vsnprintf(c->pack.header.why, MODEL_WHY, format, arguments);
    va_end(arguments);
    clean(c->pack.header.why);
    c->pack.header.status = status;
    return status;
}

int convert_exhausted(struct convert *c)
{
    return convert_fail(c, TIA_ERR_MEMORY, "memory: exhausted");
}

void convert_warn(struct convert *c, enum tia_read_warning_kind kind, const char *format, ...)
{
    struct tia_read_warning *warning = &c->pack.header.warnings[kind];
    va_list arguments;

    va_start(arguments, format);
    if (warning->count++ == 0) {
        (void)vsnprintf(warning->at.text, sizeof warning->at.text, format, arguments);
        clean(warning->at.text);
    }
    va_end(arguments);
}

/* ---- numbers ---- */

int32_t convert_fixed(double x, double one)
{
    double scaled = floor(x * one + 0.5);
    return scaled >= INT32_MAX ? INT32_MAX : scaled > INT32_MIN ? (int32_t)scaled : isnan(scaled) ? 0 : INT32_MIN;
}

struct tia_vec3 convert_place(const struct convert *c, const double at[3])
{
    double one = ldexp(TIA_Q16_ONE, c->bits);
    return (struct tia_vec3){convert_fixed(at[0] - c->origin[0], one), convert_fixed(at[1] - c->origin[1], one),
                             convert_fixed(at[2] - c->origin[2], one)};
}

struct tia_dir3 convert_direction(const double d[3])
{
    return (struct tia_dir3){convert_fixed(d[0], TIA_Q30_ONE), convert_fixed(d[1], TIA_Q30_ONE),
                             convert_fixed(d[2], TIA_Q30_ONE)};
}

struct tia_rgb convert_colour(const double rgb[3], double most)
{
    tia_q30 channel[3];

    for (int i = 0; i < 3; i++)
        channel[i] = convert_fixed(rgb[i] > 0 ? fmin(rgb[i], most) : 0, TIA_Q30_ONE);
    return (struct tia_rgb){channel[0], channel[1], channel[2]};
}
