/* osmesa.h - OpenGL without a window as a display: for tests, where GL stands in for a screen.
 *
 * present() draws the frame through GL, from RGB565 to RGB565, and every pixel arrives as it was.
 * Two libraries can do it: OSMesa, and EGL on Mesa's surfaceless platform where OSMesa is missing
 * (Mesa 25.1 dropped it). Neither is linked: opening the display loads it. Linked, OSMesa would
 * bring LLVM and some 20 other libraries into every start of the program, its gl* symbols would
 * clash with those of another GL, and without it the program would not start at all.
 *
 * GL contexts belong to threads: open, present, read and close on one of them.
 */
#ifndef PORT_OSMESA_H
#define PORT_OSMESA_H

#include "ports.h"

extern const struct tia_display port_osmesa_display;

/* wish->device is "osmesa", "egl" or NULL: the first that opens. Without a size, 640x480. */
void *port_osmesa_create(const struct port_wish *wish);
void port_osmesa_destroy(void *ctx);
void port_osmesa_list(port_line *line, void *arg);

/* While it is open: the picture as GL shows it, row by row from the top, without gaps; valid
 * until the next call. NULL when GL fails. */
const tia_rgb565 *port_osmesa_read(void *ctx);

/* While it is open: a GL function by name, for programs that draw on their own; NULL: not there. */
void (*port_osmesa_proc(void *ctx, const char *name))(void);

#endif
