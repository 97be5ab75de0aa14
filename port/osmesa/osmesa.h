/* osmesa.h - off-screen OpenGL as a display, for tests.
 *
 * present() draws the frame through GL, from RGB565 to RGB565, so that every pixel arrives unchanged. Two libraries can
 * draw it: OSMesa or, where that is missing (Mesa 25.1 dropped it), EGL on Mesa's surfaceless platform. They are not
 * linked, but loaded when the display is opened. A linked OSMesa would load LLVM and some 20 other libraries at every
 * start of the program, clash with the gl* symbols of another GL, and keep the program from starting where it is not
 * installed.
 *
 * GL contexts belong to threads: call open, present, read and close on the same one.
 */
#ifndef PORT_OSMESA_H
#define PORT_OSMESA_H

#include "device.h"

extern const struct tia_display port_osmesa_display;

/* Creates the display that wish->device names: "osmesa" or "egl"; NULL: the first that opens. The default size is
 * 640x480. */
void *port_osmesa_create(const struct port_wish *wish);
void port_osmesa_destroy(void *ctx);
void port_osmesa_list(port_line *line, void *arg);

/* Returns an open display's frame buffer from GL, top row first, without gaps; valid until the next call. NULL when GL
 * fails. */
const tia_rgb565 *port_osmesa_read(void *ctx);

/* Returns an open display's GL function by name, for programs that draw on their own; NULL if GL has none. */
void (*port_osmesa_proc(void *ctx, const char *name))(void);

#endif
