/* fields.h - from a path to the wave that comes along it, in double precision. */
#ifndef TOOLS_RADIO_FIELDS_H
#define TOOLS_RADIO_FIELDS_H

#include <tia/radio.h>

#include "materials.h"

#define LIGHT_SPEED 299792458.0 /* metres a second */

enum { VERTICAL, HORIZONTAL, POLARISATIONS };

struct world {
    const struct tia_radio *radio;
    const struct medium *media; /* of the scene's materials */
    double frequency;           /* hertz */
    int up;                     /* the axis that is vertical: 1 y, 2 z */
    int scale_bits;             /* of the scene */
};

/* Perpendicular to the plane of incidence (TE), and in it (TM). */
struct coefficients {
    double complex te, tm;
};

/* Fresnel's, at a half space of relative permittivity eta, cosine of the angle of incidence. */
struct coefficients fresnel(double complex eta, double cosine);

/* Through a slab of that thickness, relative to air in its place. */
struct coefficients slab(double complex eta, double thickness, double cosine, double frequency);

struct field {
    double length, delay;                                  /* metres, seconds */
    struct coefficients reflection[TIA_RADIO_ORDER_MAX];   /* at each face */
    struct coefficients transmission[TIA_RADIO_WALLS_MAX]; /* through each wall */
    double complex gain[POLARISATIONS];                    /* between isotropic antennas of that polarisation */
    double departure[2], arrival[2];                       /* azimuth and elevation in degrees: to where the wave
                                                              leaves, from where it comes */
};

/* A place in the scene's unit in metres, and the nearest one to a place in metres. */
double metres_of(const struct world *world, tia_q16 at);
struct tia_vec3 place_at(const struct world *world, const double metres[3]);

void field_of(const struct world *world, const struct tia_radio_path *path, struct field *field);

/* All paths of a link together. */
struct summary {
    double coherent[POLARISATIONS], incoherent[POLARISATIONS]; /* power gains */
    double delay_spread[POLARISATIONS];                        /* seconds, root mean square */
    double rician[POLARISATIONS];                              /* line of sight to the rest; 0: no line of sight */
};

void summarise(const struct field *fields, const struct tia_radio_path *paths, unsigned count, struct summary *summary);

double decibels(double power);

#endif
