#include "part.h"

#include <stdio.h>
#include <string.h>

#include <tia/render.h>

#include "codec.h"

size_t image_part_print(char text[IMAGE_PART_HEADER], const struct image_film *film)
{
    return (size_t)snprintf(text, IMAGE_PART_HEADER, "TIAPART1 W%u H%u R%u+%u N%u+%u/%u F%u:%u S%08x\n", film->width,
                            film->height, film->first_row, film->rows, (unsigned)film->first_frame,
                            (unsigned)film->frames, (unsigned)film->all_frames, (unsigned)film->rate[0],
                            (unsigned)film->rate[1], (unsigned)film->crc);
}

static bool makes_sense(const struct image_film *film)
{
    return film->width >= 1 && film->width <= TIA_SIZE_MAX && film->height >= 1 && film->height <= TIA_SIZE_MAX &&
           film->rows >= 1 && film->first_row < film->height && film->rows <= film->height - film->first_row &&
           film->frames >= 1 && film->first_frame < film->all_frames &&
           film->frames <= film->all_frames - film->first_frame && film->rate[0] >= 1 && film->rate[1] >= 1;
}

/* Printing what was read must give the same line again: only one spelling is valid. */
static size_t check_spelling(const struct image_film *film, const char *line, const char *again, size_t printed)
{
    return makes_sense(film) && strncmp(line, again, printed) == 0 ? printed : 0;
}

static void take_line(char line[IMAGE_PART_HEADER + 1], const char *text, size_t length)
{
    size_t most = length < IMAGE_PART_HEADER ? length : IMAGE_PART_HEADER;
    memcpy(line, text, most);
    line[most] = '\0';
}

size_t image_part_parse(struct image_film *film, const char *text, size_t length)
{
    char line[IMAGE_PART_HEADER + 1], again[IMAGE_PART_HEADER];
    unsigned n[10];
    take_line(line, text, length);
    if (sscanf(line, "TIAPART1 W%u H%u R%u+%u N%u+%u/%u F%u:%u S%8x", &n[0], &n[1], &n[2], &n[3], &n[4], &n[5], &n[6],
               &n[7], &n[8], &n[9]) != 10) {
        return 0;
    }
    *film = (struct image_film){n[0], n[1], n[2], n[3], n[4], n[5], n[6], {n[7], n[8]}, n[9]};
    return check_spelling(film, line, again, image_part_print(again, film));
}

size_t image_y4m_parse(struct image_film *film, const char *text, size_t length)
{
    char line[IMAGE_PART_HEADER + 1], again[IMAGE_PART_HEADER];
    unsigned n[8];
    take_line(line, text, length);
    if (sscanf(line, "YUV4MPEG2 W%u H%u F%u:%u Ip A1:1 C444 XCOLORRANGE=LIMITED XTIA=N%u+%u/%u:S%8x", &n[0], &n[1],
               &n[2], &n[3], &n[4], &n[5], &n[6], &n[7]) != 8) {
        return 0;
    }
    *film = (struct image_film){n[0], n[1], 0, n[1], n[4], n[5], n[6], {n[2], n[3]}, n[7]};
    return check_spelling(film, line, again, image_y4m_print(again, film));
}

/* ---- writing a part ---- */

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
    size_t bytes = image_put565(image->line, pixels, image->width);
    return sink_write(&image->sink, image->line, bytes);
}

static int end(struct image *image)
{
    (void)image;
    return TIA_OK;
}

const struct image_codec image_codec_part = {
    .name = "tiapart", .begin = begin, .row = row, .end = end, .free = nothing};
