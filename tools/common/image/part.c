#include "part.h"

#include <stdio.h>
#include <string.h>

#include <tia/debug.h>
#include <tia/render.h>

#include "bytes.h"
#include "codec.h"

size_t image_part_print(char text[IMAGE_PART_HEADER], const struct image_film *film)
{
    return (size_t)snprintf(text, IMAGE_PART_HEADER, "TIAPART2 W%u H%u R%u+%u N%u+%u/%u F%u:%u S%08x\n", film->width,
                            film->height, film->first_row, film->rows, (unsigned)film->first_frame,
                            (unsigned)film->frames, (unsigned)film->all_frames, (unsigned)film->rate[0],
                            (unsigned)film->rate[1], (unsigned)film->crc);
}

size_t image_y4m_print(char text[IMAGE_PART_HEADER], const struct image_film *film)
{
    return (size_t)snprintf(
        text, IMAGE_PART_HEADER, "YUV4MPEG2 W%u H%u F%u:%u Ip A1:1 C444 XCOLORRANGE=LIMITED XTIA=N%u+%u/%u:S%08x\n",
        film->width, film->height, (unsigned)film->rate[0], (unsigned)film->rate[1], (unsigned)film->first_frame,
        (unsigned)film->frames, (unsigned)film->all_frames, (unsigned)film->crc);
}

static bool makes_sense(const struct image_film *film)
{
    return film->width >= 1 && film->width <= TIA_SIZE_MAX && film->height >= 1 && film->height <= TIA_SIZE_MAX &&
           film->rows >= 1 && film->first_row < film->height && film->rows <= film->height - film->first_row &&
           film->frames >= 1 && film->first_frame < film->all_frames &&
           film->frames <= film->all_frames - film->first_frame && film->rate[0] >= 1 && film->rate[1] >= 1;
}

/* Returns `printed` if printing the parsed values gives the same line again, else 0: only one spelling is valid. */
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
    if (sscanf(line, "TIAPART2 W%u H%u R%u+%u N%u+%u/%u F%u:%u S%8x", &n[0], &n[1], &n[2], &n[3], &n[4], &n[5], &n[6],
               &n[7], &n[8], &n[9]) != 10)
        return 0;
    *film = (struct image_film){.width = n[0],
                                .height = n[1],
                                .first_row = n[2],
                                .rows = n[3],
                                .first_frame = n[4],
                                .frames = n[5],
                                .all_frames = n[6],
                                .rate = {n[7], n[8]},
                                .crc = n[9]};
    return check_spelling(film, line, again, image_part_print(again, film));
}

size_t image_y4m_parse(struct image_film *film, const char *text, size_t length)
{
    char line[IMAGE_PART_HEADER + 1], again[IMAGE_PART_HEADER];
    unsigned n[8];
    take_line(line, text, length);
    if (sscanf(line, "YUV4MPEG2 W%u H%u F%u:%u Ip A1:1 C444 XCOLORRANGE=LIMITED XTIA=N%u+%u/%u:S%8x", &n[0], &n[1],
               &n[2], &n[3], &n[4], &n[5], &n[6], &n[7]) != 8)
        return 0;
    *film = (struct image_film){.width = n[0],
                                .height = n[1],
                                .rows = n[1],
                                .first_frame = n[4],
                                .frames = n[5],
                                .all_frames = n[6],
                                .rate = {n[2], n[3]},
                                .crc = n[7]};
    return check_spelling(film, line, again, image_y4m_print(again, film));
}

/* ---- the frames' checksums ---- */

uint32_t image_part_begin_sum(const struct image_film *film, uint32_t frame)
{
    const uint32_t place[] = {frame, film->first_row, film->rows, film->crc};
    tia_rgb565 halves[8];
    for (unsigned i = 0; i < 8; i++)
        halves[i] = (tia_rgb565)(place[i / 2] >> 16 * (i & 1) & 0xffffu);
    return tia_crc32(0, halves, 8);
}

bool image_part_add(struct image *image, const tia_rgb565 *pixels)
{
    uint64_t row = image->rows % image->height;
    if (row == 0) {
        uint32_t frame = image->film.first_frame + (uint32_t)(image->rows / image->height);
        image->sum = image_part_begin_sum(&image->film, frame);
    }
    image->sum = tia_crc32(image->sum, pixels, image->width);
    return row + 1 == image->height;
}

void image_part_put_sum(unsigned char bytes[IMAGE_PART_SUM], uint32_t sum)
{
    (void)put_bytes(bytes, sum, IMAGE_PART_SUM);
}

void image_y4m_put_frame(unsigned char bytes[IMAGE_Y4M_FRAME], uint32_t sum)
{
    char line[IMAGE_Y4M_FRAME + 1];
    (void)snprintf(line, sizeof line, "FRAME XTIA=%08lx\n", (unsigned long)sum);
    memcpy(bytes, line, IMAGE_Y4M_FRAME);
}
