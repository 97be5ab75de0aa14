#include "parts.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <tia/debug.h>
#include <tia/render.h>

#include "common/inputs.h"
#include "common/regular.h"
#include "part.h"

__attribute__((format(printf, 2, 3))) static int failed(struct parts *parts, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    (void)vsnprintf(parts->why, PARTS_WHY, format, values);
    va_end(values);
    return -1;
}

/* ---- a single part ---- */

static uint64_t frame_bytes(const struct part *part)
{
    uint64_t pixels = (uint64_t)part->film.width * part->film.rows;
    return part->is_y4m ? IMAGE_Y4M_FRAME + 3 * pixels : sizeof(tia_rgb565) * pixels + IMAGE_PART_SUM;
}

static int read_at(struct parts *parts, const struct part *part, int fd, void *bytes, size_t count, uint64_t offset)
{
    return regular_read(fd, bytes, count, offset) ? failed(parts, "%.300s: %s", part->path, regular_reason()) : 0;
}

static int open_part(struct parts *parts, const struct part *part, uint64_t *length)
{
    struct stat status;
    int fd = regular_open(part->path, &status);

    if (fd < 0)
        return failed(parts, "%.300s: %s", part->path, regular_reason());
    *length = (uint64_t)status.st_size;
    inputs_add(&status);
    return fd;
}

static int check_same(struct parts *parts, const struct part *part)
{
    const struct part *first = &parts->array[0];
    const struct image_film *a = &first->film, *b = &part->film;
    if (a->width != b->width || a->height != b->height) {
        return failed(parts, "%.150s: of pictures of %ux%u, %.150s of %ux%u", part->path, b->width, b->height,
                      first->path, a->width, a->height);
    }
    if (a->all_frames != b->all_frames || a->rate[0] != b->rate[0] || a->rate[1] != b->rate[1]) {
        return failed(parts, "%.150s: of a film of %u frames at %u/%u, %.150s of %u at %u/%u", part->path,
                      (unsigned)b->all_frames, (unsigned)b->rate[0], (unsigned)b->rate[1], first->path,
                      (unsigned)a->all_frames, (unsigned)a->rate[0], (unsigned)a->rate[1]);
    }
    if (a->crc != b->crc) {
        return failed(parts, "%.150s: of another scene, or drawn with other options, than %.150s", part->path,
                      first->path);
    }
    return 0;
}

/* Reads the first line of the part that begins at offset `at` of the file. Returns the offset of the part's end; 0 on
 * failure. */
static uint64_t read_header(struct parts *parts, struct part *part, int fd, uint64_t at, uint64_t length)
{
    char text[IMAGE_PART_HEADER];
    size_t count = length - at < sizeof text ? (size_t)(length - at) : sizeof text;
    if (read_at(parts, part, fd, text, count, at) != 0)
        return 0;
    size_t header = image_part_parse(&part->film, text, count);
    if (header == 0 && at == 0) {
        header = image_y4m_parse(&part->film, text, count);
        part->is_y4m = header != 0;
    }
    part->frames = at + header;
    uint64_t end = part->frames + frame_bytes(part) * part->film.frames;
    if (header == 0) {
        (void)failed(parts, "%.300s: not a part (.tiapart, or .y4m by tia)", part->path);
    } else if (length < end || (part->is_y4m && length > end)) {
        (void)failed(parts, "%.300s: %llu bytes, not the %llu of its header", part->path, (unsigned long long)length,
                     (unsigned long long)end);
    } else {
        return end;
    }
    return 0;
}

static struct part *add_part(struct parts *parts, const char *path)
{
    if (parts->count == parts->capacity) {
        unsigned capacity = 2 * parts->capacity + 1;
        struct part *array = realloc(parts->array, capacity * sizeof *array);
        if (!array) {
            (void)failed(parts, "memory: exhausted");
            return NULL;
        }
        parts->array = array;
        parts->capacity = capacity;
    }
    parts->array[parts->count] = (struct part){.path = path};
    return &parts->array[parts->count++];
}

/* Reads a file, which may be several parts one after the other, as tia --resume writes them. */
static int read_file(struct parts *parts, const char *path)
{
    const struct part file = {.path = path};
    uint64_t length = 0, at = 0;
    int fd = open_part(parts, &file, &length), result = fd < 0 ? -1 : 0;
    do {
        struct part *part = result == 0 ? add_part(parts, path) : NULL;
        at = part ? read_header(parts, part, fd, at, length) : 0;
        if (at == 0 || check_same(parts, part) != 0)
            result = -1;
    } while (result == 0 && at < length);
    if (fd >= 0)
        (void)close(fd);
    return result;
}

/* ---- all parts together ---- */

static bool overlap(const struct image_film *a, const struct image_film *b)
{
    return a->first_row < b->first_row + b->rows && b->first_row < a->first_row + a->rows &&
           a->first_frame < (uint64_t)b->first_frame + b->frames &&
           b->first_frame < (uint64_t)a->first_frame + a->frames;
}

const struct part *parts_find(const struct parts *parts, uint32_t frame, unsigned row)
{
    const struct image_film pixel = {.first_row = row, .rows = 1, .first_frame = frame, .frames = 1};
    for (unsigned i = 0; i < parts->count; i++)
        if (overlap(&parts->array[i].film, &pixel))
            return &parts->array[i];
    return NULL;
}

uint64_t parts_rows(const struct parts *parts)
{
    uint64_t rows = 0;

    for (unsigned i = 0; i < parts->count; i++)
        rows += (uint64_t)parts->array[i].film.rows * parts->array[i].film.frames;
    return rows;
}

/* Checks for gaps. Parts that do not overlap and together have as many rows as the film leave no gap. If they have
 * fewer rows, there is a gap at the first row of a frame or after the end of a part; the first gap is reported. */
static int check_gaps(struct parts *parts)
{
    const struct image_film *film = &parts->array[0].film;
    if (parts_rows(parts) == (uint64_t)film->height * film->all_frames)
        return 0;
    for (uint32_t frame = 0; frame < film->all_frames; frame++) {
        for (unsigned row = 0; row < film->height;) {
            const struct part *part = parts_find(parts, frame, row);
            if (!part)
                return failed(parts, "row %u of frame %u is in no part", row, (unsigned)frame);
            row = part->film.first_row + part->film.rows;
        }
    }
    return failed(parts, "the parts do not fit together");
}

static int check_overlaps(struct parts *parts)
{
    for (unsigned i = 0; i < parts->count; i++) {
        for (unsigned j = 0; j < i; j++) {
            const struct part *a = &parts->array[i], *b = &parts->array[j];
            if (overlap(&a->film, &b->film))
                return failed(parts, "%.200s and %.200s: both have the same rows", b->path, a->path);
        }
    }
    return 0;
}

int parts_read(struct parts *parts, const char *path)
{
    *parts = (struct parts){0};
    return read_file(parts, path) != 0 ? -1 : check_overlaps(parts);
}

int parts_open(struct parts *parts, char *const *paths, unsigned count)
{
    *parts = (struct parts){0};
    for (unsigned i = 0; i < count; i++)
        if (read_file(parts, paths[i]) != 0)
            return -1;
    return check_overlaps(parts) != 0 ? -1 : check_gaps(parts);
}

void parts_close(struct parts *parts)
{
    free(parts->array);
    free(parts->colours);
    parts->array = NULL;
    parts->colours = NULL;
}

/* ---- pixels ---- */

static int compare(const void *left, const void *right)
{
    uint64_t a = *(const uint64_t *)left, b = *(const uint64_t *)right;
    return (a > b) - (a < b);
}

static bool learn_colours(struct parts *parts)
{
    if (!parts->colours) {
        parts->colours = malloc(65536 * sizeof *parts->colours);
        for (uint32_t i = 0; parts->colours && i < 65536; i++)
            parts->colours[i] = (uint64_t)image_y4m_colour((tia_rgb565)i) << 16 | i;
        if (parts->colours)
            qsort(parts->colours, 65536, sizeof *parts->colours, compare);
    }
    return parts->colours;
}

/* Finds the pixel with the given Y, U, V by binary search. Returns false if no pixel has it. */
static bool find_pixel(const uint64_t *colours, uint32_t colour, tia_rgb565 *pixel)
{
    const uint64_t *at = colours;
    for (unsigned step = 32768; step > 0; step /= 2)
        at += at[step] >> 16 <= colour ? step : 0;
    *pixel = (tia_rgb565)(*at & 65535);
    return *at >> 16 == colour;
}

/* Reads `count` pixels of a frame, from pixel `first` of the part on. */
static int read_planes(struct parts *parts, const struct part *part, int fd, uint64_t offset, size_t first,
                       size_t count, tia_rgb565 *rows)
{
    size_t plane = (size_t)part->film.width * part->film.rows;
    unsigned char *bytes = malloc(3 * count);
    if (!bytes || !learn_colours(parts)) {
        free(bytes);
        return failed(parts, "memory: exhausted");
    }
    int result = 0;
    for (size_t i = 0; i < 3 && result == 0; i++)
        result = read_at(parts, part, fd, bytes + i * count, count, offset + IMAGE_Y4M_FRAME + i * plane + first);
    for (size_t i = 0; i < count && result == 0; i++) {
        uint32_t colour = (uint32_t)bytes[i] << 16 | (uint32_t)bytes[count + i] << 8 | bytes[2 * count + i];
        if (!find_pixel(parts->colours, colour, &rows[i]))
            result = failed(parts, "%.300s: a colour that tia does not write", part->path);
    }
    free(bytes);
    return result;
}

/* Reads pixels as read_planes does. */
static int read_pixels(struct parts *parts, const struct part *part, int fd, uint64_t offset, size_t first,
                       size_t count, tia_rgb565 *rows)
{
    unsigned char *bytes = (unsigned char *)rows;
    int result = read_at(parts, part, fd, bytes, count * sizeof *rows, offset + first * sizeof *rows);
    for (size_t i = 0; i < count && result == 0; i++) /* converts little-endian bytes in place */
        rows[i] = (tia_rgb565)(bytes[2 * i] | bytes[2 * i + 1] << 8);
    return result;
}

/* Compares the checksum of a part's rows of a frame with `found`, the checksum in the file. */
static int check_sum(struct parts *parts, const struct part *part, uint32_t frame, const tia_rgb565 *rows,
                     const unsigned char *found)
{
    unsigned char wanted[IMAGE_Y4M_FRAME];
    size_t length = part->is_y4m ? IMAGE_Y4M_FRAME : IMAGE_PART_SUM;
    uint32_t sum = image_part_begin_sum(&part->film, frame);
    sum = tia_crc32(sum, rows, (size_t)part->film.width * part->film.rows);
    if (part->is_y4m)
        image_y4m_put_frame(wanted, sum);
    else
        image_part_put_sum(wanted, sum);
    if (memcmp(found, wanted, length) != 0)
        return failed(parts, "%.300s: frame %u is damaged: its checksum is another", part->path, (unsigned)frame);
    return 0;
}

/* Reads some rows of a frame, from row `first` of the part on. */
static int read_some(struct parts *parts, const struct part *part, int fd, uint32_t frame, size_t first, size_t rows,
                     tia_rgb565 *pixels)
{
    uint64_t at = part->frames + frame_bytes(part) * (frame - part->film.first_frame);
    size_t width = part->film.width;

    return part->is_y4m ? read_planes(parts, part, fd, at, first * width, rows * width, pixels)
                        : read_pixels(parts, part, fd, at, first * width, rows * width, pixels);
}

static int read_frame(struct parts *parts, const struct part *part, int fd, uint32_t frame, tia_rgb565 *rows)
{
    unsigned char sum[IMAGE_Y4M_FRAME];
    uint64_t bytes = frame_bytes(part), at = part->frames + bytes * (frame - part->film.first_frame);
    int result = read_some(parts, part, fd, frame, 0, part->film.rows, rows);
    if (result == 0) {
        result = part->is_y4m ? read_at(parts, part, fd, sum, IMAGE_Y4M_FRAME, at)
                              : read_at(parts, part, fd, sum, IMAGE_PART_SUM, at + bytes - IMAGE_PART_SUM);
    }
    return result == 0 ? check_sum(parts, part, frame, rows, sum) : result;
}

static int read_rows(struct parts *parts, const struct part *part, uint32_t frame, tia_rgb565 *pixels)
{
    const struct image_film *film = &part->film;
    tia_rgb565 *rows = pixels + (size_t)film->first_row * film->width;
    uint64_t length;
    int fd = open_part(parts, part, &length);
    if (fd < 0)
        return -1;
    int result = read_frame(parts, part, fd, frame, rows);
    (void)close(fd);
    return result;
}

int parts_frame(struct parts *parts, uint32_t frame, tia_rgb565 *pixels)
{
    for (unsigned i = 0; i < parts->count; i++) {
        const struct image_film *film = &parts->array[i].film;
        if (frame >= film->first_frame && frame - film->first_frame < film->frames &&
            read_rows(parts, &parts->array[i], frame, pixels) != 0)
            return -1;
    }
    return 0;
}

int parts_row(struct parts *parts, const struct part *part, int fd, uint32_t frame, unsigned y, tia_rgb565 *pixels)
{
    return read_some(parts, part, fd, frame, y - part->film.first_row, 1, pixels);
}
