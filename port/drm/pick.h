/* pick.h - which connector, mode and CRTC: choices from what libdrm's structs say. */
#ifndef PORT_DRM_PICK_H
#define PORT_DRM_PICK_H

#include <xf86drmMode.h>

#include "ports.h"

/* A card's connectors and encoders; places may be NULL. */
struct drm_parts {
    drmModeRes *resources;
    drmModeConnector **connectors; /* resources->count_connectors */
    drmModeEncoder **encoders;     /* resources->count_encoders */
};

/* "HDMI-A-1", as the kernel names it too. */
#define PICK_NAME 32
const char *pick_name(const drmModeConnector *connector, char name[PICK_NAME]);
/* "1024x768@60". */
const char *pick_mode_name(const drmModeModeInfo *mode, char name[PICK_NAME]);

/* Connected and with modes: the one named `wish`, else one that is lit, else the first. NULL and
 * the reason in `why`. */
const drmModeConnector *pick_connector(const struct drm_parts *parts, const char *wish, char why[PORT_WHY]);

/* The modes to try, best first, by n = 0, 1, ...; NULL after the last. `wish` NULL: the preferred
 * one, then all others in the driver's order; "preferred": only that; "WxH" or "WxH@R": only those
 * of that size (and rate). */
const drmModeModeInfo *pick_mode(const drmModeConnector *connector, const char *wish, int n);

/* The CRTC that the connector's encoder is on, else the first possible one that lights no other
 * connector; 0: none. */
uint32_t pick_crtc(const struct drm_parts *parts, const drmModeConnector *connector);
/* The CRTC that lights the connector now, or 0. */
uint32_t pick_current_crtc(const struct drm_parts *parts, const drmModeConnector *connector);

#endif
