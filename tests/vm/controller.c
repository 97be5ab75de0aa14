/* controller.c - compares the display controller's own checksum with one computed from tia's pixels: the example of
 * docs/trust.md. Runs where Linux' vkms drives the screen, whose checksums of composed frames are in debugfs.
 *
 *     controller DIRECTORY      such as /sys/kernel/debug/dri/0/crtc-0/crc
 *
 * Draws the built-in scene in each of its states, and once more with a wrong pixel. Prints a line for each frame.
 * Ends with 0 if the controller reports the checksum of each and that of the wrong frame is another. */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <tia/debug.h>
#include <tia/tia.h>
#include <tia/trust.h>

#include "ports.h"

/* FRAMES: number of the controller's checksums to wait for. A slow vkms reports that of an old frame many times, once
 * for each vertical blank that it has missed. */
enum { WIDTH = 640, HEIGHT = 480, FRAMES = 1200 };

static uint64_t view_memory[320], hits_memory[WIDTH * HEIGHT + 64];
static struct tia_seal seal;
static const struct tia_sealed sealed = {.view = view_memory,
                                         .view_size = sizeof view_memory,
                                         .hits = hits_memory,
                                         .hits_size = sizeof hits_memory,
                                         .seal = &seal};
static const struct tia_tile frame = {0, 0, WIDTH, HEIGHT};
static tia_rgb565 pixels[WIDTH * HEIGHT];

/* ---- the controller's checksum ---- */

/* A channel of 16 bits, as vkms composes it: 65535 value/most, rounded. */
static uint16_t channel(unsigned value, unsigned most)
{
    return (uint16_t)((2 * 65535u * value + most) / (2 * most));
}

/* Returns the checksum that vkms reports for `pixels`: the kernel's crc32_le over alpha, red, green, blue of 16 bits
 * each, which begins with 0 and is not inverted. */
static uint32_t expected(void)
{
    uint32_t crc = UINT32_MAX;

    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        unsigned p = pixels[i];
        const uint16_t composed[4] = {0xffff, channel(p >> 11, 31), channel(p >> 5 & 63, 63), channel(p & 31, 31)};
        crc = tia_crc32(crc, composed, 4);
    }
    return ~crc;
}

static bool write_word(const char *directory, const char *name, const char *word)
{
    char path[256];

    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    int file = open(path, O_WRONLY);
    bool fine = file >= 0 && write(file, word, strlen(word)) == (ssize_t)strlen(word);
    if (file >= 0)
        (void)close(file);
    return fine;
}

/* True if the controller reports this checksum for one of the next frames: "0x0000002a 0x89abcdef". */
static bool reports(const char *directory, uint32_t crc)
{
    char path[256], line[64];
    bool found = false;

    (void)snprintf(path, sizeof path, "%s/data", directory);
    int file = write_word(directory, "control", "auto") ? open(path, O_RDONLY) : -1;
    for (int i = 0; i < FRAMES && file >= 0 && !found; i++) {
        ssize_t length = read(file, line, sizeof line - 1);
        if (length <= 0)
            break;
        line[length] = '\0';
        const char *number = strchr(line, ' ');
        found = number && strtoul(number, NULL, 16) == crc;
    }
    if (file >= 0)
        (void)close(file);
    return found;
}

/* ---- frames ---- */

/* Copies the pixels to the display. */
static int show(const struct port_display *display, void *screen)
{
    struct tia_surface surface = {.pixels = NULL};
    int status = display->ops->acquire(screen, frame, &surface);

    for (unsigned y = 0; y < HEIGHT && !status; y++)
        for (unsigned x = 0; x < WIDTH; x++)
            *(tia_rgb565 *)(void *)((char *)surface.pixels + (ptrdiff_t)y * surface.pitch +
                                    (ptrdiff_t)x * surface.step) = pixels[y * WIDTH + x];
    if (!status)
        status = display->ops->submit(screen, frame);
    return status ? status : display->ops->present(screen);
}

static int draw(uint32_t state)
{
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * WIDTH};
    const struct tia_binding *key = state ? &tia_thesis_scene.bindings[state - 1] : NULL;
    int status = tia_view_set_lights_checked(&sealed, key ? &key->state : NULL, key ? 1 : 0);

    return status ? status : tia_view_draw_checked(&sealed, frame, &surface, NULL);
}

/* Shows the frame of a state, with a wrong bit in one pixel or not. Gives its checksum; true if the controller reports
 * that. */
static bool is_reported(const struct port_display *display, void *screen, const char *directory, uint32_t state,
                        bool wrong, uint32_t *crc)
{
    if (draw(state) != TIA_OK)
        return false;
    pixels[HEIGHT / 2 * WIDTH + WIDTH / 3] ^= wrong;
    *crc = expected();
    bool reported = show(display, screen) == TIA_OK && reports(directory, *crc);
    printf("state %u, %s: %08x %s\n", (unsigned)state, wrong ? "a pixel changed" : "as drawn", (unsigned)*crc,
           reported ? "is what the controller reports" : "is not reported");
    return reported;
}

static bool all_frames(const struct port_display *display, void *screen, const char *directory)
{
    uint32_t crc = 0, right = 0;
    bool fine = true;

    for (uint32_t state = 0; state <= tia_thesis_scene.binding_count; state++) {
        fine = is_reported(display, screen, directory, state, false, &crc) && fine;
        right = state == 1 ? crc : right;
    }
    return is_reported(display, screen, directory, 1, true, &crc) && crc != right && fine;
}

static const struct port_display *find_drm(void)
{
    const struct port_display *display = port_displays;

    while (display->name && strcmp(display->name, "drm") != 0)
        display++;
    return display->name ? display : NULL;
}

int main(int argc, char **argv)
{
    char why[PORT_WHY] = "this build has no drm display";
    const struct port_wish wish = {.mode = "640x480", .why = why};
    const struct port_display *display = find_drm();
    void *screen = argc == 2 && display ? display->create(&wish) : NULL;
    struct tia_mode mode;
    struct tia_view *view;

    int status = tia_view_init(&view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, WIDTH, HEIGHT, NULL);
    status = status ? status : tia_view_seal(&sealed);
    if (status || !screen || display->ops->open(screen, &mode) != TIA_OK || mode.width != WIDTH ||
        mode.height != HEIGHT) {
        (void)fprintf(stderr, "controller: %s\n", why);
        return 2;
    }
    bool fine = all_frames(display, screen, argv[1]);
    display->ops->close(screen);
    display->destroy(screen);
    return fine ? 0 : 1;
}
