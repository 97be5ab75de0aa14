#include "pick.h"

#include <stdio.h>
#include <string.h>

const char *pick_name(const drmModeConnector *connector, char name[PICK_NAME])
{
    const char *type = drmModeGetConnectorTypeName(connector->connector_type);

    (void)snprintf(name, PICK_NAME, "%.16s-%u", type ? type : "Unknown", connector->connector_type_id);
    return name;
}

const char *pick_mode_name(const drmModeModeInfo *mode, char name[PICK_NAME])
{
    (void)snprintf(name, PICK_NAME, "%ux%u@%u", mode->hdisplay, mode->vdisplay, mode->vrefresh);
    return name;
}

static const drmModeEncoder *encoder(const struct drm_parts *parts, uint32_t id)
{
    for (int i = 0; id != 0 && i < parts->resources->count_encoders; i++)
        if (parts->encoders[i] && parts->encoders[i]->encoder_id == id)
            return parts->encoders[i];
    return NULL;
}

uint32_t pick_current_crtc(const struct drm_parts *parts, const drmModeConnector *connector)
{
    const drmModeEncoder *e = encoder(parts, connector->encoder_id);

    return e ? e->crtc_id : 0;
}

/* ---- connector ---- */

static bool usable(const drmModeConnector *c)
{
    return c->connection == DRM_MODE_CONNECTED && c->count_modes > 0;
}

static const drmModeConnector *first_usable(const struct drm_parts *parts, bool lit)
{
    for (int i = 0; i < parts->resources->count_connectors; i++) {
        const drmModeConnector *c = parts->connectors[i];
        if (c && usable(c) && (!lit || pick_current_crtc(parts, c) != 0))
            return c;
    }
    return NULL;
}

static void append(char *text, size_t size, const char *word)
{
    size_t length = strlen(text);

    if (length < size)
        (void)snprintf(text + length, size - length, "%s%s", length == 0 ? "" : ", ", word);
}

static const drmModeConnector *named(const struct drm_parts *parts, const char *wish, char why[PORT_WHY])
{
    char name[PICK_NAME], there[128] = "";

    for (int i = 0; i < parts->resources->count_connectors; i++) {
        const drmModeConnector *c = parts->connectors[i];
        if (!c)
            continue;
        append(there, sizeof there, pick_name(c, name));
        if (strcmp(name, wish) != 0)
            continue;
        if (usable(c))
            return c;
        (void)snprintf(why, PORT_WHY, "connector %s: %s", name,
                       c->connection == DRM_MODE_CONNECTED ? "its screen offers no mode"
                                                           : "nothing is connected to it");
        return NULL;
    }
    (void)snprintf(why, PORT_WHY, "connector %.32s: no such connector (there are: %s)", wish, there);
    return NULL;
}

const drmModeConnector *pick_connector(const struct drm_parts *parts, const char *wish, char why[PORT_WHY])
{
    const drmModeConnector *c;

    if (wish)
        return named(parts, wish, why);
    c = first_usable(parts, true);
    if (!c)
        c = first_usable(parts, false);
    if (!c)
        (void)snprintf(why, PORT_WHY, "no connector has a screen with a mode");
    return c;
}

/* ---- mode ---- */

static const drmModeModeInfo *preferred(const drmModeConnector *c)
{
    for (int i = 0; i < c->count_modes; i++)
        if (c->modes[i].type & DRM_MODE_TYPE_PREFERRED)
            return &c->modes[i];
    return c->count_modes > 0 ? &c->modes[0] : NULL;
}

/* True if the mode matches "WxH" or "WxH@R"; false for any other wish. */
static bool matches(const drmModeModeInfo *mode, const char *wish)
{
    char full[PICK_NAME];
    size_t size = strcspn(pick_mode_name(mode, full), "@");

    return strcmp(wish, full) == 0 || (strlen(wish) == size && strncmp(wish, full, size) == 0);
}

static bool drawable(const drmModeModeInfo *mode)
{
    return mode->hdisplay <= TIA_SIZE_MAX && mode->vdisplay <= TIA_SIZE_MAX;
}

const drmModeModeInfo *pick_mode(const drmModeConnector *connector, const char *wish, int n)
{
    const drmModeModeInfo *best = preferred(connector);

    if (best && (!wish || strcmp(wish, "preferred") == 0)) {
        if (drawable(best) && n-- == 0)
            return best;
        if (wish)
            return NULL;
    }
    for (int i = 0; i < connector->count_modes; i++) {
        const drmModeModeInfo *m = &connector->modes[i];
        if (drawable(m) && (wish ? matches(m, wish) : m != best) && n-- == 0)
            return m;
    }
    return NULL;
}

/* ---- CRTC ---- */

static bool lights_another(const struct drm_parts *parts, uint32_t crtc, const drmModeConnector *than)
{
    for (int i = 0; i < parts->resources->count_connectors; i++) {
        const drmModeConnector *c = parts->connectors[i];
        if (c && c->connector_id != than->connector_id && pick_current_crtc(parts, c) == crtc)
            return true;
    }
    return false;
}

uint32_t pick_crtc(const struct drm_parts *parts, const drmModeConnector *connector)
{
    uint32_t current = pick_current_crtc(parts, connector);

    for (int i = 0; current == 0 && i < connector->count_encoders; i++) {
        const drmModeEncoder *e = encoder(parts, connector->encoders[i]);
        for (int bit = 0; e && current == 0 && bit < parts->resources->count_crtcs && bit < 32; bit++) {
            uint32_t crtc = parts->resources->crtcs[bit];
            if ((e->possible_crtcs >> bit & 1) != 0 && !lights_another(parts, crtc, connector))
                current = crtc;
        }
    }
    return current;
}
