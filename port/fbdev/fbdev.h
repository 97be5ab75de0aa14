/* fbdev.h - Linux framebuffer devices, /dev/fbN: frames are drawn in memory and copied to the
 * screen once, into the page that is not shown where the driver can pan. */
#ifndef PORT_FBDEV_FBDEV_H
#define PORT_FBDEV_FBDEV_H

#include "device.h"

extern const struct tia_display port_fbdev_display;
void *port_fbdev_create(const struct port_wish *wish);
void port_fbdev_destroy(void *ctx);
void port_fbdev_list(port_line *line, void *arg);

#endif
