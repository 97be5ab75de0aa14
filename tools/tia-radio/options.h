/* options.h - the command line of tia-radio. */
#ifndef TOOLS_RADIO_OPTIONS_H
#define TOOLS_RADIO_OPTIONS_H

#include "common/command_line.h"
#include "common/image/film.h"
#include "common/verify/choice.h"
#include "links.h"

enum { PLACES_MOST = 16, NAMES_MOST = 64 };

/* Properties of a material of the scene, or of all materials. */
struct naming {
    char name[256]; /* name of the material; "": all */
    char itu[64];   /* name in ITU-R P.2040-3; "": given by numbers */
    double permittivity, conductivity, thickness;
};

struct namings {
    struct naming array[NAMES_MOST];
    unsigned count;
};

struct places {
    double metres[PLACES_MOST][3];
    struct tia_vec3 array[PLACES_MOST]; /* the same in the scene's unit; set by site_place */
    unsigned count;
};

/* The plane of a map. */
struct plane {
    int axis;  /* -1: no map */
    double at; /* metres */
};

struct options {
    const char *scene, *output, *csv;
    struct places tx, rx;
    struct namings namings;
    double frequency;
    uint32_t order, walls, density;
    enum method method;
    unsigned threads;
    bool lists, json, best_server, horizontal;
    int up; /* number of the vertical axis */
    struct plane map;
    double area[4];  /* area of the map: in metres, after site_place in the scene's unit */
    double range[2]; /* range of the map's colours, dB */
    bool has_area, has_size;
    uint16_t width, height;
    bool has_rows;
    uint16_t first_row, last_row; /* rows of the map */
    enum image_format format;
    const char *verify; /* NULL, or a picture of the map to be verified */
    struct choice_wish choice;
};

/* Parses the command line. Returns COMMAND_RUN; or the exit status: FINE after --help and --version, any other after an
 * error message. */
int options_parse(struct options *options, int argc, char **argv);

#endif
