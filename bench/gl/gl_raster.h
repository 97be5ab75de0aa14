/* gl_raster.h - polygons drawn by OpenGL with the states of <tia/raster.h>, for comparison. */
#ifndef BENCH_GL_GL_RASTER_H
#define BENCH_GL_GL_RASTER_H

#include <tia/raster.h>

struct gl_raster;

/* Opens an image with a face, a 24-bit depth and a stencil value for each pixel. `library` is the library of the osmesa
 * display that draws it: "osmesa" or "egl". Pixels on edges follow the top-left rule, as in tia. Only one image can be
 * open at a time. Returns NULL on failure, with the reason in `why`, PORT_WHY characters. */
struct gl_raster *gl_raster_open(const char *library, unsigned width, unsigned height, char *why);
void gl_raster_close(struct gl_raster *r);

/* Returns the driver's name. */
const char *gl_raster_driver(void);

void gl_raster_clear(struct gl_raster *r, uint8_t stencil);

/* Begins polygons with one state. GL draws many polygons between one begin and end much faster than by as many calls of
 * gl_raster_draw. */
void gl_raster_begin(struct gl_raster *r, const struct tia_raster_state *state);
/* Draws a convex polygon in clip coordinates x, y, z, w. Pixels that pass all tests get `face`, if the state writes
 * red. */
void gl_raster_polygon(struct gl_raster *r, const double (*corners)[4], unsigned count, uint32_t face);
/* Ends the polygons of gl_raster_begin. */
void gl_raster_end(struct gl_raster *r);
/* Draws one polygon by the three functions above. */
void gl_raster_draw(struct gl_raster *r, const struct tia_raster_state *state, const double (*corners)[4],
                    unsigned count, uint32_t face);

/* Waits until all polygons are drawn. */
void gl_raster_finish(void);

/* Reads the buffers, top row first; empty pixels have TIA_NO_FACE. Returns false if GL has had an error since the last
 * call. */
bool gl_raster_read(struct gl_raster *r, uint32_t *face, uint8_t *stencil);

#endif
