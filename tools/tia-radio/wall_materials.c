#include "wall_materials.h"

#include <ctype.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

#define PI 3.14159265358979323846
#define EPSILON0 8.8541878128e-12 /* farads a metre, CODATA 2018 */

/* Recommendation ITU-R P.2040-3 (08/2023), Table 3, after the copy in Sionna RT 1, sionna/rt/radio_materials/itu.py;
 * docs/radio.md names the other copies that it was compared with. */
const struct itu_row itu_rows[] = {
    {"vacuum", 0.001, 100, 1, 0, 0, 0},
    {"concrete", 1, 100, 5.24, 0, 0.0462, 0.7822},
    {"brick", 1, 40, 3.91, 0, 0.0238, 0.16},
    {"plasterboard", 1, 100, 2.73, 0, 0.0085, 0.9395},
    {"wood", 0.001, 100, 1.99, 0, 0.0047, 1.0718},
    {"glass", 0.1, 100, 6.31, 0, 0.0036, 1.3394},
    {"glass", 220, 450, 5.79, 0, 0.0004, 1.658},
    {"ceiling board", 1, 100, 1.48, 0, 0.0011, 1.0750},
    {"ceiling board", 220, 450, 1.52, 0, 0.0029, 1.029},
    {"chipboard", 1, 100, 2.58, 0, 0.0217, 0.78},
    {"plywood", 1, 40, 2.71, 0, 0.33, 0},
    {"marble", 1, 60, 7.074, 0, 0.0055, 0.9262},
    {"floorboard", 50, 100, 3.66, 0, 0.0044, 1.3515},
    {"metal", 1, 100, 1, 0, 1e7, 0},
    {"very dry ground", 1, 10, 3, 0, 0.00015, 2.52},
    {"medium dry ground", 1, 10, 15, -0.1, 0.035, 1.63},
    {"wet ground", 1, 10, 30, -0.4, 0.15, 1.30},
    {NULL, 0, 0, 0, 0, 0, 0},
};

double complex medium_eta(double permittivity, double conductivity, double frequency)
{
    return permittivity - I * (conductivity / (2 * PI * frequency * EPSILON0));
}

static bool is_blank(char c)
{
    return c == '-' || c == '_' || c == ' ';
}

static bool is_named(const char *name, const char *row)
{
    if (strncasecmp(name, "itu", 3) == 0 && is_blank(name[3]))
        name += 4;
    while (*name != '\0' && (is_blank(*name) ? *row == ' ' : tolower((unsigned char)*name) == *row)) {
        name++;
        row++;
    }
    return *name == '\0' && *row == '\0';
}

bool itu_has(const char *name)
{
    for (const struct itu_row *row = itu_rows; row->name; row++)
        if (is_named(name, row->name))
            return true;
    return false;
}

bool itu_medium(const char *name, double frequency, struct medium *medium, double *low, double *high)
{
    double f = frequency / 1e9;

    *low = *high = 0;
    for (const struct itu_row *row = itu_rows; row->name; row++) {
        if (!is_named(name, row->name))
            continue;
        if (f >= row->low && f <= row->high) {
            medium->permittivity = row->a * pow(f, row->b);
            medium->conductivity = row->c * pow(f, row->d);
            medium->eta = medium_eta(medium->permittivity, medium->conductivity, frequency);
            return true;
        }
        *low = *low == 0 ? row->low : *low;
        *high = row->high;
    }
    return false;
}
