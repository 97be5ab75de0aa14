#include "stored.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "codec.h"
#include "common/inputs.h"
#include "common/regular.h"
#include "stored_files.h"

static int open_file(struct stored *s, uint64_t *length)
{
    struct stat status;

    s->fd = regular_open(s->path, &status);
    if (s->fd < 0)
        return stored_failed(s, "%s", regular_reason());
    *length = (uint64_t)status.st_size;
    inputs_add(&status);
    return 0;
}

/* ---- parts ---- */

static int open_sums(struct stored *s, size_t header, uint64_t length)
{
    if (s->sums.guided)
        return stored_failed(s, "has guides of --denoise or --guide, which are not verified (the picture is)");
    s->is_sums = true;
    s->at = header;
    s->stride = sums_row_bytes(&s->sums);
    s->film = (struct image_film){.width = s->sums.width,
                                  .height = s->sums.height,
                                  .rows = (unsigned)((length - header) / s->stride),
                                  .frames = 1,
                                  .all_frames = 1,
                                  .rate = {1, 1},
                                  .crc = s->sums.crc};
    return s->film.rows <= s->film.height ? 0 : stored_failed(s, "is longer than its header says");
}

static int open_part(struct stored *s, uint64_t length)
{
    char text[SUMS_HEADER];
    size_t count = length < sizeof text ? (size_t)length : sizeof text;

    s->is_part = true;
    if (stored_read_at(s, text, count, 0))
        return -1;
    size_t header = sums_parse(&s->sums, text, count);
    if (header)
        return open_sums(s, header, length);
    if (parts_read(&s->parts, s->path)) {
        (void)snprintf(s->why, STORED_WHY, "%s", s->parts.why);
        return -1;
    }
    s->film = s->parts.array[0].film;
    return 0;
}

static int part_row(struct stored *s, uint32_t frame, unsigned y, unsigned char *bytes)
{
    const struct part *part = parts_find(&s->parts, frame, y);
    tia_rgb565 *pixels = (tia_rgb565 *)(void *)s->line;

    if (!part)
        return stored_failed(s, "row %u of frame %u is not in it", y, (unsigned)frame);
    if (parts_row(&s->parts, part, s->fd, frame, y, pixels)) {
        (void)snprintf(s->why, STORED_WHY, "%s", s->parts.why);
        return -1;
    }
    (void)image_put565(bytes, pixels, s->film.width);
    return 0;
}

/* ---- all files ---- */

static int open_kind(struct stored *s, enum image_format format, unsigned width, unsigned height)
{
    uint64_t length = 0;

    if (open_file(s, &length))
        return -1;
    if (format == IMAGE_PART || format == IMAGE_Y4M)
        return open_part(s, length);
    s->film = (struct image_film){.width = width, .height = height, .frames = 1, .all_frames = 1, .rate = {1, 1}};
    if (stored_open_picture(s, format, length))
        return -1;
    s->film.rows = s->film.height;
    return 0;
}

int stored_open(struct stored *s, const char *path, enum image_format format, unsigned width, unsigned height)
{
    *s = (struct stored){.path = path, .format = format, .fd = -1};
    int result = open_kind(s, format, width, height);

    if (result)
        return result;
    s->line = malloc((size_t)s->film.width * 12 + 4);
    return s->line ? 0 : stored_failed(s, "no memory for it");
}

void stored_close(struct stored *s)
{
    if (s->fd >= 0)
        (void)close(s->fd);
    parts_close(&s->parts);
    free(s->pixels);
    free(s->line);
    s->fd = -1;
    s->pixels = s->line = NULL;
}

int stored_depth(struct stored *s, unsigned depth)
{
    unsigned bits = depth ? depth : s->bits == 8 ? 8 : 0;

    s->film.depth = depth;
    if (s->is_part || bits == s->bits)
        return 0;
    return stored_failed(s, "has %u bits a channel, the options draw %u", s->bits ? s->bits : 5, depth ? depth : 5);
}

uint64_t stored_rows(const struct stored *s)
{
    return s->is_part && !s->is_sums ? parts_rows(&s->parts) : s->film.rows;
}

void stored_place(const struct stored *s, uint64_t index, uint32_t *frame, unsigned *y)
{
    *frame = 0;
    *y = (unsigned)index;
    for (unsigned i = 0; i < s->parts.count; i++) {
        const struct image_film *film = &s->parts.array[i].film;
        uint64_t rows = (uint64_t)film->rows * film->frames;
        if (index < rows) {
            *frame = film->first_frame + (uint32_t)(index / film->rows);
            *y = film->first_row + (unsigned)(index % film->rows);
            return;
        }
        index -= rows;
    }
}

size_t stored_row_bytes(const struct stored *s)
{
    if (s->is_sums)
        return sums_row_bytes(&s->sums);
    return s->film.depth ? (size_t)s->film.width * 3 * s->film.depth / 8 : s->film.width * sizeof(tia_rgb565);
}

/* Packs colours of 8 bits into RGB565, to the nearest below. Returns true if each is an expanded pixel. */
static bool pack(unsigned char *bytes, const unsigned char *rgb, unsigned width)
{
    bool exact = true;

    for (unsigned x = 0; x < width; x++, rgb += 3) {
        tia_rgb565 pixel = (tia_rgb565)((rgb[0] >> 3) << 11 | (rgb[1] >> 2) << 5 | rgb[2] >> 3);
        unsigned char again[3];
        image_expand(again, &pixel, 1);
        exact = exact && !memcmp(again, rgb, sizeof again);
        (void)image_put565(bytes + 2 * (size_t)x, &pixel, 1);
    }
    return exact;
}

int stored_row(struct stored *s, uint32_t frame, unsigned y, unsigned char *bytes, bool *exact)
{
    uint64_t place = s->bottom_up ? s->film.height - 1 - y : y;
    size_t length = stored_row_bytes(s);
    bool packs = s->bits == 8 && !s->film.depth;
    unsigned char *to = packs ? s->line : bytes;

    *exact = true;
    if (s->is_part && !s->is_sums)
        return part_row(s, frame, y, bytes);
    length = packs ? (size_t)s->film.width * 3 : length;
    if (s->pixels)
        memcpy(to, s->pixels + place * s->stride, length);
    else if (stored_read_at(s, to, length, s->at + place * s->stride))
        return -1;
    if (packs)
        *exact = pack(bytes, to, s->film.width);
    return 0;
}
