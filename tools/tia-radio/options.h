/* options.h - tia-radio's options. */
#ifndef TOOLS_RADIO_OPTIONS_H
#define TOOLS_RADIO_OPTIONS_H

#include "common/command_line.h"
#include "common/image/film.h"
#include "links.h"

enum { PLACES_MOST = 16, NAMES_MOST = 64 };

/* Properties of a material of the scene, or of all of them when name is NULL. */
struct naming {
    char name[256]; /* name of the material; "": all */
    char itu[64];   /* name in ITU-R P.2040-3; "": given by numbers */
    double permittivity, conductivity, thickness;
};

struct options {
    const char *scene, *output, *csv;
    double tx_at[PLACES_MOST][3], rx_at[PLACES_MOST][3]; /* positions in metres; and in the scene's unit, once that is
                                                            known: */
    struct tia_vec3 tx[PLACES_MOST], rx[PLACES_MOST];
    unsigned tx_count, rx_count, naming_count;
    struct naming namings[NAMES_MOST];
    double frequency;
    uint32_t order, walls, density;
    enum method method;
    unsigned threads;
    bool lists, json, best_server, horizontal;
    int up;         /* number of the vertical axis */
    int map_axis;   /* axis of the map's normal; -1: no map */
    double map_at;  /* metres */
    double area[4]; /* area of the map, metres; then in the scene's unit */
    bool has_area, has_size;
    uint16_t width, height;
    double low, high; /* range of the map's colours, dB */
    bool has_rows;
    uint16_t first_row, last_row; /* rows of the map */
    enum image_format format;
};

#endif
