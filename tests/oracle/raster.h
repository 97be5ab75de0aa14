/* raster.h - draws polygons pixel by pixel, from the definitions in <tia/raster.h> and OpenGL's specification. */
#ifndef TESTS_ORACLE_RASTER_H
#define TESTS_ORACLE_RASTER_H

#include <tia/raster.h>

#define ORACLE_FACES 512

struct oracle_image {
    enum tia_projection projection;
    int width, height, samples, sample;
};

struct oracle_raster {
    struct oracle_image image;
    struct tia_tile area;
    uint32_t *face;
    uint8_t *stencil;
    uint16_t *colour;
    struct tia_raster_vertex planes[ORACLE_FACES][3];
};

/* True if the polygon covers the pixel. */
bool oracle_covers(const struct oracle_image *image, const struct tia_raster_vertex *v, int count, int x, int y);

/* Returns 1 if the plane of a is nearer than that of b at the pixel, -1 if it is farther, 0 if the planes are the same.
 */
int oracle_order(const struct oracle_image *image, const struct tia_raster_vertex *a, const struct tia_raster_vertex *b,
                 int x, int y);

/* Returns 1/t. The plane's point at the pixel is t times a direction whose third coordinate is w. */
long double oracle_nearness(const struct oracle_image *image, const struct tia_raster_vertex *v, int x, int y, long w);

void oracle_draw(struct oracle_raster *raster, const struct tia_raster_state *state, const struct tia_raster_vertex *v,
                 int count, uint32_t face);

/* Returns the values a[i] at the corners, interpolated to the pixel, rounded to nearest, ties up, and clamped to 32
 * bits. */
int32_t oracle_blend(const struct oracle_image *image, const struct tia_raster_vertex v[3], int x, int y,
                     const int32_t a[3]);

#endif
