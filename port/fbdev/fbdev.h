/* fbdev.h - Linux framebuffer devices, /dev/fbN: a frame is drawn in memory, then copied to the screen. Where the
 * driver can pan, the copy goes to the hidden page. */
#ifndef PORT_FBDEV_FBDEV_H
#define PORT_FBDEV_FBDEV_H

#include "device.h"

extern const struct tia_display port_fbdev_display;
void *port_fbdev_create(const struct port_wish *wish);
void port_fbdev_destroy(void *ctx);
void port_fbdev_list(port_line *line, void *arg);

#endif
