/* pick.h - chooses connector, mode and CRTC from libdrm's structs. */
#ifndef PORT_DRM_PICK_H
#define PORT_DRM_PICK_H

#include <xf86drmMode.h>

#include "device.h"

/* A card's connectors and encoders; elements may be NULL. */
struct drm_parts {
    drmModeRes *resources;
    drmModeConnector **connectors; /* array of resources->count_connectors */
    drmModeEncoder **encoders;     /* array of resources->count_encoders */
};

#define PICK_NAME 32
/* Writes the connector's name in the kernel's form, such as "HDMI-A-1". */
const char *pick_name(const drmModeConnector *connector, char name[PICK_NAME]);
/* Writes the mode's name, "1024x768@60". */
const char *pick_mode_name(const drmModeModeInfo *mode, char name[PICK_NAME]);

/* Returns a connector that is connected and has modes: the one called `wish`; if wish is NULL, the first that a CRTC
 * drives now, or else the first of all. NULL, with the reason in `why`, if there is none. */
const drmModeConnector *pick_connector(const struct drm_parts *parts, const char *wish, char why[PORT_WHY]);

/* Returns mode n = 0, 1, ... of those to try, best first; NULL after the last. `wish` selects the modes: NULL for the
 * preferred one, then all others in the driver's order; "preferred" for the preferred one alone; "WxH" or "WxH@R" for
 * the modes of that size (and refresh rate). */
const drmModeModeInfo *pick_mode(const drmModeConnector *connector, const char *wish, int n);

/* Returns the CRTC of the connector's present encoder, or else the first possible one that drives no other connector;
 * 0: none. */
uint32_t pick_crtc(const struct drm_parts *parts, const drmModeConnector *connector);
/* Returns the CRTC that drives the connector now, or 0. */
uint32_t pick_current_crtc(const struct drm_parts *parts, const drmModeConnector *connector);

#endif
