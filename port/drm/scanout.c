#include "scanout.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <xf86drm.h>

#include "console/node.h"

/* Time limit for a page flip. On a working screen a flip takes one frame at most: 42 ms in the slowest modes, at 24
 * frames per second. */
#define FLIP_MS 1000

#ifndef DRM_MODE_CONNECTOR_SPI /* in headers of Linux 5.10 and later */
#define DRM_MODE_CONNECTOR_SPI 19
#define DRM_MODE_CONNECTOR_USB 20
#endif

/* ---- saving and restoring the CRTC's state ---- */

static void remember(struct scanout *s)
{
    const struct drm_parts *parts = &s->card->parts;

    s->old = drmModeGetCrtc(s->card->fd, s->crtc);
    s->old_count = 0;
    for (int i = 0; i < parts->resources->count_connectors && s->old_count < SCANOUT_CONNECTORS; i++)
        if (parts->connectors[i] && pick_current_crtc(parts, parts->connectors[i]) == s->crtc)
            s->old_connectors[s->old_count++] = parts->connectors[i]->connector_id;
}

static void put_back(struct scanout *s)
{
    drmModeCrtc *old = s->old;
    int fd = s->card->fd;

    if (old && drmIsMaster(fd)) {
        if (old->mode_valid && old->buffer_id != 0 && s->old_count > 0)
            (void)drmModeSetCrtc(fd, old->crtc_id, old->buffer_id, old->x, old->y, s->old_connectors, s->old_count,
                                 &old->mode);
        else
            (void)drmModeSetCrtc(fd, old->crtc_id, 0, 0, 0, NULL, 0, NULL);
    }
    drmModeFreeCrtc(old);
    s->old = NULL;
}

/* ---- setting a mode: try, then fall back ---- */

static int set_crtc(struct scanout *s, int buffer)
{
    return drmModeSetCrtc(s->card->fd, s->crtc, s->buffers[buffer].fb, 0, 0, &s->connector, 1, &s->mode);
}

static void free_buffers(struct scanout *s)
{
    int error = errno;

    for (int i = 0; i < 2; i++)
        card_buffer_destroy(s->card, &s->buffers[i]);
    errno = error;
}

/* Tries one mode with one format. Returns 0, or -1 with errno and the failed step in *what; a driver that does not
 * support RGB565 may fail at any of these calls. */
static int try(struct scanout *s, const char **what)
{
    for (int i = 0; i < 2; i++)
        if (card_buffer_create(s->card, &s->buffers[i], s->mode.hdisplay, s->mode.vdisplay, &s->format, what) != 0) {
            free_buffers(s);
            return -1;
        }
    *what = "the mode cannot be set";
    if (set_crtc(s, 0) == 0)
        return 0;
    free_buffers(s);
    return -1;
}

/* True for an error that no other mode or format can avoid. */
static bool hopeless(int error)
{
    return error == ENODEV || error == EACCES || error == EPERM || error == ENOMEM;
}

static int refused(const struct scanout *s, const char *mode_wish, const char *what, char why[PORT_WHY])
{
    char name[PICK_NAME], reason[PORT_WHY];
    bool choice = !hopeless(errno);

    (void)snprintf(why, PORT_WHY, "%s: mode %s: %s: %.80s%s", s->card->path, pick_mode_name(&s->mode, name), what,
                   node_error(errno, reason), choice && mode_wish ? " (choose another with --mode)" : "");
    return choice ? TIA_ERR_UNSUPPORTED : TIA_ERR_DEVICE;
}

/* Tries one mode with each format. Returns 0 on success, 1 when the driver rejects all formats, or a negative status
 * after a hopeless error. *status and `why` are set by the first failure and by a hopeless error. */
static int try_mode(struct scanout *s, const char *mode_wish, int *status, char why[PORT_WHY])
{
    const char *what;

    for (int n = 0; card_format(s->card, s->crtc, n, false, &s->format); n++) {
        if (try(s, &what) == 0)
            return 0;
        int error = errno;
        if (!*status || hopeless(error))
            *status = refused(s, mode_wish, what, why);
        if (hopeless(error))
            return *status;
    }
    return 1;
}

int scanout_light(struct scanout *scanout, const struct card *card, const drmModeConnector *connector,
                  const char *mode_wish, char why[PORT_WHY])
{
    const drmModeModeInfo *mode;
    int status = TIA_OK, answer = 1;

    *scanout = (struct scanout){.card = card,
                                .connector = connector->connector_id,
                                .crtc = pick_crtc(&card->parts, connector),
                                .copied = connector->connector_type == DRM_MODE_CONNECTOR_SPI ||
                                          connector->connector_type == DRM_MODE_CONNECTOR_USB,
                                .flips = true};
    remember(scanout);
    for (int n = 0; answer > 0 && (mode = pick_mode(connector, mode_wish, n)) != NULL; n++) {
        scanout->mode = *mode;
        answer = try_mode(scanout, mode_wish, &status, why);
    }
    if (answer == 0)
        return TIA_OK;
    if (!status) {
        (void)snprintf(why, PORT_WHY, "%s: mode %.40s: its screen has no such mode (see --mode help)", card->path,
                       mode_wish ? mode_wish : "preferred");
        status = TIA_ERR_UNSUPPORTED;
    }
    scanout_end(scanout);
    return status;
}

/* ---- flipping ---- */

static void flipped(int fd, unsigned sequence, unsigned seconds, unsigned microseconds, void *arg)
{
    struct scanout *s = arg;

    (void)fd, (void)sequence, (void)seconds, (void)microseconds;
    if (s->pending > 0)
        s->pending--;
}

/* Handles one event; false when none comes within timeout_ms. */
static bool read_event(struct scanout *s, int timeout_ms)
{
    drmEventContext events = {.version = 2, .page_flip_handler = flipped};
    struct pollfd fd = {.fd = s->card->fd, .events = POLLIN};
    int ready;

    do {
        ready = poll(&fd, 1, timeout_ms);
    } while (ready < 0 && errno == EINTR);
    return ready > 0 && (fd.revents & POLLIN) != 0 && drmHandleEvent(s->card->fd, &events) == 0;
}

void scanout_settle(struct scanout *scanout)
{
    while (scanout->pending > 0)
        if (!read_event(scanout, FLIP_MS)) {
            /* The driver has lost an event. Show later frames by setting the mode, which waits by itself. */
            scanout->flips = false;
            scanout->pending = 0;
        }
}

/* Flips to a buffer. Returns 0, or -1 with errno. Retries on EBUSY: the driver is still busy with the previous frame,
 * perhaps that of another program. */
static int flip(struct scanout *s, int buffer)
{
    for (int ms = 0;; ms++) {
        if (drmModePageFlip(s->card->fd, s->crtc, s->buffers[buffer].fb, DRM_MODE_PAGE_FLIP_EVENT, s) == 0)
            break;
        if (errno != EBUSY || ms >= FLIP_MS)
            return -1;
        (void)read_event(s, 1);
    }
    s->pending++;
    scanout_settle(s);
    return 0;
}

/* Shows another buffer. */
static int show(struct scanout *s, int buffer, char why[PORT_WHY])
{
    if (!s->flips || flip(s, buffer) != 0) {
        if (s->flips && hopeless(errno))
            return card_failed(s->card, "the picture cannot be shown", why);
        s->flips = false;
        if (set_crtc(s, buffer) != 0)
            return card_failed(s->card, "the picture cannot be shown", why);
    }
    s->shown = buffer;
    return TIA_OK;
}

/* Marks rectangles of the shown buffer as dirty. Drivers that copy the buffer to the screen (USB, SPI, virtual
 * machines) copy them now; others return ENOSYS. */
static int mark_dirty(struct scanout *s, drmModeClip *changed, unsigned count)
{
    uint32_t fb = s->buffers[s->shown].fb;

    if (changed && count == 0)
        return 0;
    if (changed && drmModeDirtyFB(s->card->fd, fb, changed, count) == 0)
        return 0;
    return drmModeDirtyFB(s->card->fd, fb, NULL, 0);
}

int scanout_swap(struct scanout *scanout, drmModeClip *changed, unsigned count, char why[PORT_WHY])
{
    int status = scanout->copied ? TIA_OK : show(scanout, scanout_drawn(scanout), why);

    if (status || mark_dirty(scanout, changed, count) == 0)
        return status;
    if (errno == ENODEV)
        return card_failed(scanout->card, "the picture cannot be shown", why);
    scanout->copied = false; /* then the screen shows the buffer itself */
    return TIA_OK;
}

int scanout_drawn(const struct scanout *scanout)
{
    return scanout->copied ? scanout->shown : 1 - scanout->shown;
}

int scanout_relight(struct scanout *scanout)
{
    if (set_crtc(scanout, scanout->shown) != 0)
        return -1;
    (void)drmModeDirtyFB(scanout->card->fd, scanout->buffers[scanout->shown].fb, NULL, 0);
    return 0;
}

void scanout_end(struct scanout *scanout)
{
    if (!scanout->card)
        return;
    scanout_settle(scanout);
    put_back(scanout);
    free_buffers(scanout);
    scanout->card = NULL;
}
