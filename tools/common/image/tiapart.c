/* tiapart.c - writes a .tiapart, see part.h. */
#include "codec.h"
#include "part.h"

static void nothing(struct image *image)
{
    (void)image;
}

static int begin(struct image *image)
{
    char text[IMAGE_PART_HEADER];
    size_t length = image_part_print(text, &image->film);
    return sink_write(&image->sink, text, length);
}

static int row(struct image *image, const tia_rgb565 *pixels)
{
    unsigned char sum[IMAGE_PART_SUM];
    size_t bytes = image_put565(image->line, pixels, image->width);
    int status = sink_write(&image->sink, image->line, bytes);
    if (!image_part_add(image, pixels) || status)
        return status;
    image_part_put_sum(sum, image->sum);
    return sink_write(&image->sink, sum, sizeof sum);
}

static int end(struct image *image)
{
    (void)image;
    return TIA_OK;
}

const struct image_codec image_codec_part = {
    .name = "tiapart", .begin = begin, .row = row, .end = end, .free = nothing};
