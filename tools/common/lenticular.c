#include "lenticular.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <tia/render.h>

#define ONE_40 1099511627776.0

/* Rounds to the nearest 2^-40. Multiplying by 2^40 is exact, so every machine rounds alike. */
bool lenticular_set(struct tia_lenticular *lens, double pitch, double rise, double centre)
{
    const double most = (double)TIA_PITCH_MAX / ONE_40;

    if (!(fabs(pitch) < most && fabs(rise) < most && fabs(centre) < most) || pitch == 0)
        return false;
    lens->pitch = llround(pitch * ONE_40);
    lens->rise = llround(rise * ONE_40);
    lens->centre = llround(centre * ONE_40);
    return lens->pitch != 0 && llabs(lens->pitch) < TIA_PITCH_MAX && llabs(lens->rise) < TIA_PITCH_MAX;
}

struct numbers {
    double pitch, slope, centre;
    bool has_pitch, has_slope;
};

static bool number(const char *text, double *value)
{
    char *end;

    *value = strtod(text, &end);
    return end != text && *end == '\0' && isfinite(*value);
}

static bool is_after(const char *field, const char *name, const char **value)
{
    size_t length = strlen(name);

    *value = field + length;
    return strncmp(field, name, length) == 0;
}

static bool set_subpixels(struct tia_lenticular *lens, const char *name)
{
    static const char *const names[] = {"rgb", "bgr", "none"};

    for (unsigned i = 0; i < 3; i++)
        if (!strcmp(name, names[i])) {
            lens->subpixels = (enum tia_subpixels)i;
            return true;
        }
    return false;
}

static bool set_field(struct tia_lenticular *lens, struct numbers *n, const char *field)
{
    const char *value;

    if (is_after(field, "pitch=", &value))
        return n->has_pitch = number(value, &n->pitch);
    if (is_after(field, "slope=", &value))
        return n->has_slope = number(value, &n->slope) && n->slope != 0;
    if (is_after(field, "center=", &value) || is_after(field, "centre=", &value))
        return number(value, &n->centre);
    if (is_after(field, "subpixels=", &value))
        return set_subpixels(lens, value);
    if (!strcmp(field, "flip"))
        return lens->flipped = true;
    if (!strcmp(field, "invert"))
        return lens->inverted = true;
    return false;
}

static int wrong(struct lenticular *panel, const char *value, const char *rule)
{
    (void)snprintf(panel->why, sizeof panel->why, "--lenticular '%.200s': %s", value, rule);
    return TIA_ERR_RANGE;
}

static int set_fields(struct lenticular *panel, struct numbers *n, const char *text)
{
    char *copy = strdup(text), *rest = copy, *field;
    int status = copy ? TIA_OK : TIA_ERR_MEMORY;

    if (!copy)
        (void)snprintf(panel->why, sizeof panel->why, "memory: exhausted");
    while (!status && (field = strsep(&rest, ",")) != NULL)
        if (!set_field(&panel->lens, n, field))
            status = wrong(panel, field, "not pitch=P, slope=S, center=C, subpixels=rgb|bgr|none, flip or invert");
    free(copy);
    return status;
}

int lenticular_parse(struct lenticular *panel, const char *text)
{
    struct numbers n = {0, 0, 0, false, false};

    *panel = (struct lenticular){.width = 0};
    int status = set_fields(panel, &n, text);
    if (status)
        return status;
    if (!n.has_pitch)
        return wrong(panel, text, "has no pitch (pitch=50.2: lenses to the picture's width)");
    return lenticular_set(&panel->lens, n.pitch, n.has_slope ? n.pitch / n.slope : 0, n.centre)
               ? TIA_OK
               : wrong(panel, text, "pitch, pitch/slope and center must be below 1048576, and pitch not 0");
}
