/* buffer.c - pixel formats of a card, and dumb buffers. */
#include <drm_fourcc.h>
#include <errno.h>
#include <string.h>
#include <sys/mman.h>
#include <xf86drm.h>

#include "card.h"

/* Formats, in the order in which they are tried. A format with `always` is also tried on planes that do not list it.
 * DRM's format codes denote little-endian pixels. */
static const struct {
    struct card_format format;
    bool always;
} known[] = {
    {{DRM_FORMAT_RGB565, &pixel_rgb565}, true},
    {{DRM_FORMAT_BGR565, &pixel_bgr565}, false},
    {{DRM_FORMAT_XRGB8888, &pixel_xrgb8888}, true},
    {{DRM_FORMAT_XBGR8888, &pixel_xbgr8888}, false},
};

static bool in(const uint32_t *list, size_t count, uint32_t fourcc)
{
    for (size_t i = 0; i < count; i++)
        if (list[i] == fourcc)
            return true;
    return false;
}

bool card_format_of(const uint32_t *plane, size_t count, int n, bool listed, struct card_format *format)
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        bool try = (known[i].always && !listed) || in(plane, count, known[i].format.fourcc);
        if (try && n-- == 0) {
            *format = known[i].format;
            return true;
        }
    }
    return false;
}

static bool is_primary(int fd, uint32_t plane)
{
    drmModeObjectProperties *list = drmModeObjectGetProperties(fd, plane, DRM_MODE_OBJECT_PLANE);
    bool primary = false;

    for (uint32_t i = 0; list && i < list->count_props; i++) {
        drmModePropertyRes *property = drmModeGetProperty(fd, list->props[i]);
        if (property && strcmp(property->name, "type") == 0)
            primary = list->prop_values[i] == DRM_PLANE_TYPE_PRIMARY;
        drmModeFreeProperty(property);
    }
    drmModeFreeObjectProperties(list);
    return primary;
}

/* Returns the primary plane that the CRTC can use; NULL when the driver lists none. */
static drmModePlane *primary_plane(const struct card *card, uint32_t crtc)
{
    drmModePlaneRes *planes = drmModeGetPlaneResources(card->fd);
    drmModePlane *found = NULL;
    int index = 0;

    while (index < card->parts.resources->count_crtcs && card->parts.resources->crtcs[index] != crtc)
        index++;
    for (uint32_t i = 0; planes && !found && i < planes->count_planes; i++) {
        drmModePlane *plane = drmModeGetPlane(card->fd, planes->planes[i]);
        if (plane && (plane->possible_crtcs >> index & 1) != 0 && is_primary(card->fd, plane->plane_id))
            found = plane;
        else
            drmModeFreePlane(plane);
    }
    drmModeFreePlaneResources(planes);
    return found;
}

bool card_format(const struct card *card, uint32_t crtc, int n, bool listed, struct card_format *format)
{
    drmModePlane *plane = primary_plane(card, crtc);
    bool found = card_format_of(plane ? plane->formats : NULL, plane ? plane->count_formats : 0, n, listed, format);

    drmModeFreePlane(plane);
    return found;
}

/* ---- buffers ---- */

static int create(int fd, struct card_buffer *b, unsigned width, unsigned height, unsigned bits)
{
    struct drm_mode_create_dumb dumb = {.width = width, .height = height, .bpp = bits};

    if (drmIoctl(fd, DRM_IOCTL_MODE_CREATE_DUMB, &dumb) != 0)
        return -1;
    b->handle = dumb.handle;
    b->pitch = dumb.pitch;
    b->size = dumb.size;
    return 0;
}

static int add_fb(int fd, struct card_buffer *b, unsigned width, unsigned height, uint32_t fourcc)
{
    const uint32_t handles[4] = {b->handle}, pitches[4] = {b->pitch}, offsets[4] = {0};

    return drmModeAddFB2(fd, width, height, fourcc, handles, pitches, offsets, &b->fb, 0) != 0 ? -1 : 0;
}

static int map(int fd, struct card_buffer *b)
{
    struct drm_mode_map_dumb where = {.handle = b->handle};
    void *memory;

    if (drmIoctl(fd, DRM_IOCTL_MODE_MAP_DUMB, &where) != 0)
        return -1;
    memory = mmap(NULL, b->size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_POPULATE, fd, (off_t)where.offset);
    if (memory == MAP_FAILED)
        return -1;
    b->map = memory;
    return 0;
}

int card_buffer_create(const struct card *card, struct card_buffer *buffer, unsigned width, unsigned height,
                       const struct card_format *format, const char **what)
{
    int error;

    *buffer = (struct card_buffer){0};
    *what = "no such buffer";
    if (create(card->fd, buffer, width, height, format->pixel->bits) == 0) {
        *what = "no such framebuffer";
        if (add_fb(card->fd, buffer, width, height, format->fourcc) == 0) {
            *what = "the buffer cannot be mapped";
            if (map(card->fd, buffer) == 0)
                return 0;
        }
    }
    error = errno;
    card_buffer_destroy(card, buffer);
    errno = error;
    return -1;
}

/* Unmaps the buffer before destroying it: a buffer that is still mapped when its file is closed stays on the CRTC. */
void card_buffer_destroy(const struct card *card, struct card_buffer *buffer)
{
    struct drm_mode_destroy_dumb dumb = {.handle = buffer->handle};

    if (buffer->map)
        (void)munmap(buffer->map, buffer->size);
    if (buffer->fb != 0)
        (void)drmModeRmFB(card->fd, buffer->fb);
    if (buffer->handle != 0)
        (void)drmIoctl(card->fd, DRM_IOCTL_MODE_DESTROY_DUMB, &dumb);
    *buffer = (struct card_buffer){0};
}
