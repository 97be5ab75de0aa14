/* y4m.c - YUV4MPEG2 films, readable by mjpegtools and ffmpeg: 4:4:4, the planes Y, U and V of each frame. */
#include <stdio.h>
#include <stdlib.h>

#include "codec.h"
#include "part.h"
#include "ports.h"

static void release(struct image *image)
{
    free(image->state);
    image->state = NULL;
}

/* Begins a frame; its planes are stored until it is complete, since its checksum comes before them. */
static int begin(struct image *image)
{
    char header[IMAGE_PART_HEADER];
    image->state = malloc((size_t)image->width * image->height * 3);
    if (!image->state) {
        (void)snprintf(image->sink.why, PORT_WHY, "memory: exhausted");
        return TIA_ERR_MEMORY;
    }
    size_t length = image_y4m_print(header, &image->film);
    return sink_write(&image->sink, header, length);
}

/* Returns the pixel's colour by ITU-R BT.601 with Y in 16..235, U and V in 16..240, and coefficients rounded to 1/256.
 * White and black are exact. The offset 128 of U and V is added before the division, so that the sums stay in
 * 0..65535. */
uint32_t image_y4m_colour(tia_rgb565 pixel)
{
    unsigned char rgb[3];
    image_expand(rgb, &pixel, 1);
    int r = rgb[0], g = rgb[1], b = rgb[2], half = 128, middle = 128 * 256;
    int y = (66 * r + 129 * g + 25 * b + half + 16 * 256) / 256;
    int u = (-38 * r - 74 * g + 112 * b + half + middle) / 256;
    int v = (112 * r - 94 * g - 18 * b + half + middle) / 256;
    return (uint32_t)y << 16 | (uint32_t)u << 8 | (uint32_t)v;
}

static int row(struct image *image, const tia_rgb565 *pixels)
{
    size_t plane = (size_t)image->width * image->height;
    unsigned char *at = (unsigned char *)image->state + image->rows % image->height * image->width;
    unsigned char line[IMAGE_Y4M_FRAME];
    for (unsigned x = 0; x < image->width; x++, at++) {
        uint32_t colour = image_y4m_colour(pixels[x]);
        at[0] = (unsigned char)(colour >> 16);
        at[plane] = (unsigned char)(colour >> 8 & 255);
        at[2 * plane] = (unsigned char)(colour & 255);
    }
    if (!image_part_add(image, pixels))
        return TIA_OK;
    image_y4m_put_frame(line, image->sum);
    int status = sink_write(&image->sink, line, sizeof line);
    return !status ? sink_write(&image->sink, image->state, 3 * plane) : status;
}

static int end(struct image *image)
{
    (void)image;
    return TIA_OK;
}

const struct image_codec image_codec_y4m = {.name = "y4m", .begin = begin, .row = row, .end = end, .free = release};
