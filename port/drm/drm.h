/* drm.h - a screen through the kernel's DRM: two dumb buffers, shown in turn by page flips. Needs
 * no GPU and no library but libdrm. Frames are drawn straight into the buffers where the driver
 * takes RGB565, else in memory, and expanded into them. */
#ifndef PORT_DRM_DRM_H
#define PORT_DRM_DRM_H

#include "ports.h"

extern const struct tia_display port_drm_display;
void *port_drm_create(const struct port_wish *wish);
void port_drm_destroy(void *ctx);
void port_drm_list(port_line *line, void *arg);

#endif
