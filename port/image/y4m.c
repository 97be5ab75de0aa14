/* y4m.c - YUV4MPEG2 films, as mjpegtools and ffmpeg read them: for each frame all Y, all U, all V (4:4:4). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image/codec.h"
#include "ports.h"

/* The planes that wait while rows of Y are written. */
struct y4m_state {
    unsigned char *u, *v;
};

static void release(struct image *image)
{
    struct y4m_state *state = image->state;
    if (state != NULL) {
        free(state->u);
        free(state->v);
    }
    free(state);
    image->state = NULL;
}

static int begin(struct image *image)
{
    const struct image_film *film = &image->film;
    size_t pixels = (size_t)image->width * image->height;
    struct y4m_state *state = calloc(1, sizeof *state);
    char header[120];
    image->state = state;
    if (state != NULL) {
        state->u = malloc(pixels);
        state->v = malloc(pixels);
    }
    if (state == NULL || state->u == NULL || state->v == NULL) {
        (void)snprintf(image->sink.why, PORT_WHY, "memory: exhausted");
        return TIA_ERR_MEMORY;
    }
    int length = snprintf(header, sizeof header, "YUV4MPEG2 W%u H%u F%u:%u Ip A1:1 C444 XCOLORRANGE=LIMITED\n",
                          image->width, image->height, (unsigned)film->rate[0], (unsigned)film->rate[1]);
    return sink_write(&image->sink, header, (size_t)length);
}

/* ITU-R BT.601 with Y in 16..235, U and V in 16..240: coefficients in 1/256, to nearest. White and black are
 * exact, and the sums stay within 0..65535: the 128s of U and V are added before the shift. */
static void convert(const unsigned char *rgb, unsigned char *y, unsigned char *u, unsigned char *v)
{
    int r = rgb[0], g = rgb[1], b = rgb[2], half = 128, middle = 128 * 256;
    *y = (unsigned char)((66 * r + 129 * g + 25 * b + half + 16 * 256) / 256);
    *u = (unsigned char)((-38 * r - 74 * g + 112 * b + half + middle) / 256);
    *v = (unsigned char)((112 * r - 94 * g - 18 * b + half + middle) / 256);
}

static int row(struct image *image, const tia_rgb565 *pixels)
{
    struct y4m_state *state = image->state;
    size_t line = (size_t)(image->rows % image->height), at = line * image->width;
    unsigned char *y = image->line; /* over the row's own red, green and blue, behind those that are read */
    image_expand(image->line, pixels, image->width);
    for (unsigned x = 0; x < image->width; x++) {
        unsigned char rgb[3] = {image->line[3 * x], image->line[3 * x + 1], image->line[3 * x + 2]};
        convert(rgb, &y[x], &state->u[at + x], &state->v[at + x]);
    }
    int status = line == 0 ? sink_write(&image->sink, "FRAME\n", 6) : TIA_OK;
    if (status == TIA_OK) {
        status = sink_write(&image->sink, y, image->width);
    }
    if (status == TIA_OK && line + 1 == image->height) {
        size_t plane = (size_t)image->width * image->height;
        status = sink_write(&image->sink, state->u, plane);
        return status == TIA_OK ? sink_write(&image->sink, state->v, plane) : status;
    }
    return status;
}

static int end(struct image *image)
{
    (void)image;
    return TIA_OK;
}

const struct image_codec image_codec_y4m = {.name = "y4m", .begin = begin, .row = row, .end = end, .free = release};
