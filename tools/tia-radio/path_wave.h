/* path_wave.h - computes the wave along a path, in double precision. */
#ifndef TOOLS_RADIO_PATH_WAVE_H
#define TOOLS_RADIO_PATH_WAVE_H

#include <tia/radio.h>

#include "wall_materials.h"

#define LIGHT_SPEED 299792458.0 /* metres a second */

enum { VERTICAL, HORIZONTAL, POLARISATIONS };

struct world {
    const struct tia_radio *radio;
    const struct medium *media; /* media of the scene's materials */
    double frequency;           /* hertz */
    int up;                     /* number of the vertical axis: 1 for y, 2 for z */
    int scale_bits;             /* scale_bits of the scene */
};

/* Coefficients of a surface for the field perpendicular to the plane of incidence (TE), and for the field in that plane
 * (TM). */
struct coefficients {
    double complex te, tm;
};

/* Returns Fresnel's reflection coefficients of a half space of relative permittivity eta; `cosine` is that of the angle
 * of incidence. */
struct coefficients fresnel(double complex eta, double cosine);

/* Returns the transmission coefficients of a slab, relative to the same thickness of air; `thickness` in metres,
 * `frequency` in hertz. */
struct coefficients slab(double complex eta, double thickness, double cosine, double frequency);

struct field {
    double length, delay;                                  /* metres, seconds */
    struct coefficients reflection[TIA_RADIO_ORDER_MAX];   /* coefficients at each face */
    struct coefficients transmission[TIA_RADIO_WALLS_MAX]; /* coefficients through each wall */
    double complex gain[POLARISATIONS];                    /* gain between isotropic antennas of each polarisation */
    /* azimuth and elevation, in degrees, of the direction in which the wave leaves the transmitter, and of the
     * direction from which it reaches the receiver */
    double departure[2], arrival[2];
};

/* Converts a coordinate in the scene's unit to metres. */
double metres_of(const struct world *world, tia_q16 at);
/* Converts a position in metres to the nearest one in the scene's unit. */
struct tia_vec3 place_at(const struct world *world, const double metres[3]);

void field_of(const struct world *world, const struct tia_radio_path *path, struct field *field);

/* Totals over all paths of a link. */
struct summary {
    double coherent[POLARISATIONS], incoherent[POLARISATIONS]; /* sums of gains in power */
    double delay_spread[POLARISATIONS];                        /* seconds, root mean square */
    double rician[POLARISATIONS]; /* power of the line of sight divided by that of the other paths; 0: no line of
                                     sight */
};

void summarise(const struct field *fields, const struct tia_radio_path *paths, unsigned count, struct summary *summary);

double decibels(double power);

#endif
