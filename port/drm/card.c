#include "card.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include <xf86drm.h>

#include "console/node.h"

int card_failed(const struct card *card, const char *what, char why[PORT_WHY])
{
    char reason[PORT_WHY];

    (void)snprintf(why, PORT_WHY, "%s: %s: %.100s", card->path, what, node_error(errno, reason));
    return TIA_ERR_DEVICE;
}

/* Reads the connectors and encoders. Connectors of DisplayPort hubs come and go, so a listed connector may be gone by
 * now. */
static int read_parts(struct drm_parts *p, int fd)
{
    p->resources = drmModeGetResources(fd);
    if (!p->resources)
        return -1;
    p->connectors = calloc((size_t)p->resources->count_connectors + 1, sizeof(drmModeConnector *));
    p->encoders = calloc((size_t)p->resources->count_encoders + 1, sizeof(drmModeEncoder *));
    if (!p->connectors || !p->encoders)
        return -1;
    for (int i = 0; i < p->resources->count_connectors; i++)
        p->connectors[i] = drmModeGetConnector(fd, p->resources->connectors[i]);
    for (int i = 0; i < p->resources->count_encoders; i++)
        p->encoders[i] = drmModeGetEncoder(fd, p->resources->encoders[i]);
    return 0;
}

static void free_parts(struct drm_parts *p)
{
    for (int i = 0; p->connectors && i < p->resources->count_connectors; i++)
        drmModeFreeConnector(p->connectors[i]);
    for (int i = 0; p->encoders && i < p->resources->count_encoders; i++)
        drmModeFreeEncoder(p->encoders[i]);
    free(p->connectors);
    free(p->encoders);
    drmModeFreeResources(p->resources);
    *p = (struct drm_parts){0};
}

int card_open(struct card *card, const char *path, char why[PORT_WHY])
{
    uint64_t dumb = 0;
    int status = TIA_OK;

    *card = (struct card){.fd = node_open(path, O_RDWR, why)};
    if (card->fd < 0)
        return TIA_ERR_DEVICE;
    (void)snprintf(card->path, sizeof card->path, "%s", path);
    if (drmGetCap(card->fd, DRM_CAP_DUMB_BUFFER, &dumb) != 0 || dumb == 0) {
        (void)snprintf(why, PORT_WHY, "%s: its driver has no dumb buffers", path);
        status = TIA_ERR_UNSUPPORTED;
    } else {
        /* Without this capability the kernel hides primary planes, and with them the formats. */
        (void)drmSetClientCap(card->fd, DRM_CLIENT_CAP_UNIVERSAL_PLANES, 1);
        if (read_parts(&card->parts, card->fd) != 0)
            status = card_failed(card, "it drives no screens", why);
    }
    if (status)
        card_close(card);
    return status;
}

void card_close(struct card *card)
{
    if (card->fd < 0)
        return;
    free_parts(&card->parts);
    (void)close(card->fd);
    card->fd = -1;
}

int card_become_master(const struct card *card, char why[PORT_WHY])
{
    char holder[NODE_HOLDER];

    if (drmIsMaster(card->fd) || drmSetMaster(card->fd) == 0)
        return TIA_OK;
    (void)snprintf(why, PORT_WHY, "%s: in use by %s (end it, or choose another display)", card->path,
                   node_holder(card->path, holder));
    return TIA_ERR_DEVICE;
}
