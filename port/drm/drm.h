/* drm.h - a screen through the kernel's DRM: two dumb buffers and page flips. Needs no GPU, and no library except
 * libdrm. Frames are drawn straight into the buffers if the driver accepts RGB565; otherwise they are drawn in memory
 * and expanded into the buffers. */
#ifndef PORT_DRM_DRM_H
#define PORT_DRM_DRM_H

#include "device.h"

extern const struct tia_display port_drm_display;
void *port_drm_create(const struct port_wish *wish);
void port_drm_destroy(void *ctx);
void port_drm_list(port_line *line, void *arg);

#endif
