#include "values.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/tia.h>

#include "fail.h"
#include "materials.h"

int wrong(const char *option, const char *value, const char *rule)
{
    return refuse(REFUSED, "%s: %.200s: %s", option, value, rule);
}

/* ---- numbers ---- */

/* A decimal number at *text, which goes on behind it. */
static bool take_number(const char **text, double *value)
{
    char *end;

    *value = strtod(*text, &end);
    if (end == *text || !isfinite(*value))
        return false;
    *text = end;
    return true;
}

/* As many numbers with commas between them, and nothing else. */
bool parse_numbers(const char *text, double *values, int count)
{
    for (int i = 0; i < count; i++)
        if ((i > 0 && *text++ != ',') || !take_number(&text, &values[i]))
            return false;
    return *text == '\0';
}

static bool is_near(double metres)
{
    return fabs(metres * 65536) < 2147483647.0;
}

int parse_place(const char *option, const char *text, double (*places)[3], unsigned *count)
{
    double at[3];

    if (*count == PLACES_MOST)
        return wrong(option, text, "one too many (at most 16)");
    if (!parse_numbers(text, at, 3) || !is_near(at[0]) || !is_near(at[1]) || !is_near(at[2]))
        return wrong(option, text, "not X,Y,Z in metres, within 32767 (1.5,2,-3)");
    memcpy(places[(*count)++], at, sizeof at);
    return FINE;
}

int parse_count(const char *option, const char *text, uint32_t low, uint32_t high, uint32_t *value)
{
    char *end;
    unsigned long number = strtoul(text, &end, 10);

    if (*text < '0' || *text > '9' || *end != '\0' || number < low || number > high)
        return refuse(REFUSED, "%s: %.200s: not a number from %u to %u", option, text, (unsigned)low, (unsigned)high);
    *value = (uint32_t)number;
    return FINE;
}

int parse_frequency(const char *text, double *frequency)
{
    static const char units[] = "kMG";
    static const double factors[] = {1e3, 1e6, 1e9};
    const char *at = text;
    bool fine = take_number(&at, frequency);
    const char *unit = fine && *at != '\0' ? strchr(units, *at) : NULL;

    if (unit) {
        *frequency *= factors[unit - units];
        at++;
    }
    if (!fine || *at != '\0' || *frequency < 1e6 || *frequency > 1e12)
        return wrong("--frequency", text, "not a frequency from 1M to 1000G (2.4G)");
    return FINE;
}

int parse_size(const char *text, struct options *o)
{
    unsigned width, height;
    char rest;

    if (text[0] < '1' || text[0] > '9' || sscanf(text, "%5ux%5u%c", &width, &height, &rest) != 2 || height == 0 ||
        width > TIA_SIZE_MAX || height > TIA_SIZE_MAX)
        return wrong("--size", text, "not WIDTHxHEIGHT, each 1 to 8192");
    o->width = (uint16_t)width;
    o->height = (uint16_t)height;
    return FINE;
}

int parse_map(const char *text, struct options *o)
{
    double at;

    if (text[0] < 'x' || text[0] > 'z' || text[1] != '=' || !parse_numbers(text + 2, &at, 1) || !is_near(at))
        return wrong("--map", text, "not x=, y= or z= and a number (y=1.5)");
    o->map_at = at;
    o->map_axis = text[0] - 'x';
    return FINE;
}

int parse_rows(const char *text, struct options *o)
{
    unsigned first, last;
    char rest;

    if (text[0] < '0' || text[0] > '9' || sscanf(text, "%5u-%5u%c", &first, &last, &rest) != 2 || first > last ||
        last >= TIA_SIZE_MAX)
        return wrong("--tile-rows", text, "not FIRST-LAST (0-99)");
    o->has_rows = true;
    o->first_row = (uint16_t)first;
    o->last_row = (uint16_t)last;
    return FINE;
}

/* ---- materials ---- */

/* One of "permittivity:5", "conductivity:0.1", "thickness:0.2". */
static bool parse_property(const char *text, size_t length, struct naming *naming)
{
    static const char *const words[] = {"permittivity:", "conductivity:", "thickness:"};
    static const double most[] = {1e6, 1e12, 1000};
    double *values[] = {&naming->permittivity, &naming->conductivity, &naming->thickness};

    for (int i = 0; i < 3; i++) {
        size_t word = strlen(words[i]);
        const char *at = text + word;
        if (length > word && strncmp(text, words[i], word) == 0)
            return take_number(&at, values[i]) && at == text + length && *values[i] >= (i == 0 ? 1 : 0) &&
                   *values[i] <= most[i] && (i < 2 || *values[i] > 0);
    }
    return false;
}

int parse_material(const char *text, struct options *o)
{
    static const char rule[] = "not [NAME=]MATERIAL[,thickness:M] or [NAME=]permittivity:E,conductivity:S";
    const char *equals = strchr(text, '='), *at = equals ? equals + 1 : text;
    struct naming *naming = &o->namings[o->naming_count];

    if (o->naming_count == NAMES_MOST)
        return wrong("--material", text, "one too many (at most 64)");
    *naming = (struct naming){.permittivity = 0};
    if (equals && (equals == text || (size_t)(equals - text) >= sizeof naming->name))
        return wrong("--material", text, rule);
    if (equals)
        memcpy(naming->name, text, (size_t)(equals - text));
    for (bool first = true; *at != '\0'; first = false) {
        size_t length = strcspn(at, ",");
        if (!parse_property(at, length, naming)) {
            if (!first || length == 0 || length >= sizeof naming->itu || memchr(at, ':', length))
                return wrong("--material", text, rule);
            memcpy(naming->itu, at, length);
            if (!itu_has(naming->itu))
                return refuse(REFUSED, "--material: %.100s: no such material (--materials lists them)", naming->itu);
        }
        at += length;
        at += *at == ',' && at[1] != '\0';
        if (*at == ',')
            return wrong("--material", text, rule);
    }
    if (naming->itu[0] == '\0' && naming->permittivity == 0)
        return wrong("--material", text, rule);
    o->naming_count++;
    return FINE;
}
