/* wall_materials.h - electrical properties of the materials of walls: ITU-R P.2040-3. */
#ifndef TOOLS_RADIO_WALL_MATERIALS_H
#define TOOLS_RADIO_WALL_MATERIALS_H

#include <complex.h>
#include <stdbool.h>

#define THICKNESS_DEFAULT 0.1 /* metres; for objects that are not boxes and so have no thickness of their own */

/* A material at the frequency of interest. */
struct medium {
    double permittivity, conductivity; /* relative permittivity; conductivity in siemens a metre */
    double thickness;                  /* metres; 0: not given */
    double complex eta;                /* the complex relative permittivity */
};

/* Returns epsilon' - j sigma / (2 pi f epsilon0), for time as exp(j omega t). */
double complex medium_eta(double permittivity, double conductivity, double frequency);

/* A row of the table. A material may have several rows, for different frequencies. */
struct itu_row {
    const char *name;
    double low, high;  /* GHz */
    double a, b, c, d; /* a f^b, c f^d with f in GHz */
};
extern const struct itu_row itu_rows[];

/* True if the table has a material of that name. Blanks, '-' and '_' are equivalent, and a leading "itu" is ignored. */
bool itu_has(const char *name);

/* Computes the named material's values. Returns false if the frequency, in hertz, is outside the material's range,
 * which is *low to *high in GHz. */
bool itu_medium(const char *name, double frequency, struct medium *medium, double *low, double *high);

#endif
