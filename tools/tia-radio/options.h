/* options.h - tia-radio's options. */
#ifndef TOOLS_RADIO_OPTIONS_H
#define TOOLS_RADIO_OPTIONS_H

#include "common/command_line.h"
#include "common/image/film.h"
#include "links.h"

enum { PLACES_MOST = 16, NAMES_MOST = 64 };

/* A material of the scene, or all of them when name is NULL, and what it is for waves. */
struct naming {
    char name[256]; /* "": all */
    char itu[64];   /* "": given by numbers */
    double permittivity, conductivity, thickness;
};

struct options {
    const char *scene, *output, *csv;
    double tx_at[PLACES_MOST][3], rx_at[PLACES_MOST][3]; /* metres; and in the scene's unit, once that is known: */
    struct tia_vec3 tx[PLACES_MOST], rx[PLACES_MOST];
    unsigned tx_count, rx_count, naming_count;
    struct naming namings[NAMES_MOST];
    double frequency;
    uint32_t order, walls, density;
    enum method method;
    unsigned threads;
    bool lists, json, best_server, horizontal;
    int up;         /* the axis */
    int map_axis;   /* -1: no map */
    double map_at;  /* metres */
    double area[4]; /* of the map, metres; */
    bool has_area, has_size;
    uint16_t width, height;
    double low, high; /* of the map's colours, dB */
    bool has_rows;
    uint16_t first_row, last_row; /* of the map */
    enum image_format format;
};

#endif
