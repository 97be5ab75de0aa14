#include "finished.h"

#include <stdlib.h>
#include <string.h>

#include <tia/debug.h>
#include <tia/render.h>

#include "common/image/part.h"

/* The rows of a frame in a part. */
struct finished_rows {
    uint32_t frame;
    unsigned first, count;
    uint64_t at;  /* offset of the pixels in the file */
    bool checked; /* their checksum was verified */
};

static size_t row_bytes(const struct finished *f)
{
    return f->film.width * sizeof(tia_rgb565);
}

static uint64_t frame_bytes(const struct finished *f, unsigned rows)
{
    return (uint64_t)rows * row_bytes(f) + IMAGE_PART_SUM;
}

/* ---- the parts in the file ---- */

static int add_frames(struct finished *f, const struct image_film *part, uint64_t at)
{
    if (f->capacity - f->count < part->frames) {
        size_t capacity = 2 * f->capacity + part->frames;
        struct finished_rows *rows = realloc(f->rows, capacity * sizeof *rows);
        if (!rows)
            return TIA_ERR_MEMORY;
        f->rows = rows;
        f->capacity = capacity;
    }
    for (uint32_t i = 0; i < part->frames; i++)
        f->rows[f->count++] = (struct finished_rows){.frame = part->first_frame + i,
                                                     .first = part->first_row,
                                                     .count = part->rows,
                                                     .at = at + i * frame_bytes(f, part->rows)};
    return TIA_OK;
}

static const char *differs(const struct image_film *a, const struct image_film *b)
{
    if (a->width != b->width || a->height != b->height)
        return "of pictures of another size";
    if (a->crc != b->crc)
        return "of another scene, or drawn with other options";
    if (a->all_frames != b->all_frames || a->rate[0] != b->rate[0] || a->rate[1] != b->rate[1])
        return "of a film with other frames";
    return NULL;
}

/* True if the text is the beginning of a part's first line, as a killed run may leave it. */
static bool is_torn(const char *text, size_t length)
{
    static const char magic[] = "TIAPART2 ";
    size_t most = length < sizeof magic - 1 ? length : sizeof magic - 1;

    return length < IMAGE_PART_HEADER && !memchr(text, '\n', length) && !memcmp(text, magic, most);
}

/* Adds the part at offset `at` of the file. *next receives the end of the part, or `at` if the part is incomplete. */
static int read_part(struct finished *f, uint64_t at, uint64_t size, uint64_t *next)
{
    char text[IMAGE_PART_HEADER];
    struct image_film part;
    size_t got;
    int status = kept_read(&f->kept, text, sizeof text, at, &got);

    *next = at;
    if (status)
        return status;
    size_t header = image_part_parse(&part, text, got);
    if (!header && !is_torn(text, got))
        return kept_refused(&f->kept, at ? "is damaged" : "not a part left by an interrupted run");
    const char *other = header ? differs(&part, &f->film) : NULL;
    if (other)
        return kept_refused(&f->kept, other);
    uint64_t end = header ? at + header + part.frames * frame_bytes(f, part.rows) : UINT64_MAX;
    if (end > size)
        return TIA_OK;
    *next = end;
    return add_frames(f, &part, at + header);
}

static int compare(const void *left, const void *right)
{
    const struct finished_rows *a = left, *b = right;

    if (a->frame != b->frame)
        return a->frame < b->frame ? -1 : 1;
    return (a->first > b->first) - (a->first < b->first);
}

static int read_parts(struct finished *f, uint64_t size)
{
    int status = TIA_OK;

    for (uint64_t at = UINT64_MAX; f->end < size && f->end != at && !status;) {
        at = f->end;
        status = read_part(f, at, size, &f->end);
    }
    if (f->count)
        qsort(f->rows, f->count, sizeof *f->rows, compare);
    return !status && f->end < size ? kept_cut(&f->kept, f->end) : status;
}

int finished_open(struct finished *f, const char *path, const struct image_film *film, char *why)
{
    uint64_t size;

    *f = (struct finished){.film = *film};
    int status = kept_open(&f->kept, path, &size, why);
    return status ? status : read_parts(f, size);
}

void finished_close(struct finished *f)
{
    kept_close(&f->kept);
    free(f->rows);
    f->rows = NULL;
    f->count = 0;
}

/* ---- rows ---- */

/* Returns the rows of a part that include row `y` of the frame; NULL: none. */
static struct finished_rows *find(const struct finished *f, uint32_t frame, unsigned y)
{
    const struct finished_rows wanted = {.frame = frame, .first = y};
    size_t low = 0, high = f->count; /* elements before `low` begin at row y of the frame or earlier */

    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (compare(&f->rows[middle], &wanted) <= 0)
            low = middle + 1;
        else
            high = middle;
    }
    if (!low)
        return NULL;
    struct finished_rows *last = &f->rows[low - 1];
    return last->frame == frame && y - last->first < last->count ? last : NULL;
}

bool finished_has(const struct finished *f, uint32_t frame, unsigned y, unsigned rows)
{
    for (unsigned end = y + rows; y < end;) {
        const struct finished_rows *found = find(f, frame, y);
        if (!found)
            return false;
        y = found->first + found->count;
    }
    return true;
}

static int read_pixels(const struct finished *f, const struct finished_rows *rows, unsigned y, unsigned count,
                       tia_rgb565 *pixels)
{
    unsigned char *bytes = (unsigned char *)pixels;
    size_t length = count * row_bytes(f), got;
    int status = kept_read(&f->kept, bytes, length, rows->at + (uint64_t)(y - rows->first) * row_bytes(f), &got);

    if (status || got < length)
        return status ? status : kept_refused(&f->kept, "ends too early");
    for (size_t i = 0; i < length / 2; i++) /* converts little-endian bytes in place */
        pixels[i] = (tia_rgb565)(bytes[2 * i] | bytes[2 * i + 1] << 8);
    return TIA_OK;
}

/* Verifies the checksum of a frame's rows and marks them as checked; `line` has room for one row. */
static int check_sum(const struct finished *f, struct finished_rows *rows, tia_rgb565 *line)
{
    const struct image_film part = {.first_row = rows->first, .rows = rows->count, .crc = f->film.crc};
    unsigned char wanted[IMAGE_PART_SUM], sum[IMAGE_PART_SUM] = {0};
    uint32_t crc = image_part_begin_sum(&part, rows->frame);
    size_t got;
    int status = TIA_OK;

    for (unsigned i = 0; i < rows->count && !status; i++) {
        status = read_pixels(f, rows, rows->first + i, 1, line);
        crc = tia_crc32(crc, line, f->film.width);
    }
    image_part_put_sum(wanted, crc);
    if (!status)
        status = kept_read(&f->kept, sum, sizeof sum, rows->at + (uint64_t)rows->count * row_bytes(f), &got);
    if (!status && memcmp(sum, wanted, sizeof sum) != 0)
        status = kept_refused(&f->kept, "is damaged");
    rows->checked = !status;
    return status;
}

int finished_read(struct finished *f, uint32_t frame, unsigned y, unsigned rows, tia_rgb565 *pixels)
{
    int status = TIA_OK;

    for (unsigned end = y + rows; y < end && !status;) {
        struct finished_rows *found = find(f, frame, y);
        if (!found)
            return TIA_ERR_ARGUMENT;
        unsigned left = found->first + found->count - y, count = left < end - y ? left : end - y;
        if (!found->checked)
            status = check_sum(f, found, pixels);
        if (!status)
            status = read_pixels(f, found, y, count, pixels);
        pixels += (size_t)count * f->film.width;
        y += count;
    }
    return status;
}

/* Appends a part with a single write, since a killed run loses an incomplete part. */
static int append_part(struct finished *f, uint32_t frame, unsigned y, unsigned rows, const tia_rgb565 *pixels)
{
    struct image_film part = f->film;
    size_t count = (size_t)rows * f->film.width;
    unsigned char *bytes = malloc(IMAGE_PART_HEADER + (size_t)frame_bytes(f, rows));

    if (!bytes)
        return TIA_ERR_MEMORY;
    part.first_row = y;
    part.rows = rows;
    part.first_frame = frame;
    part.frames = 1;
    size_t length = image_part_print((char *)bytes, &part);
    for (size_t i = 0; i < count; i++) {
        bytes[length++] = (unsigned char)(pixels[i] & 255u);
        bytes[length++] = (unsigned char)(pixels[i] >> 8);
    }
    image_part_put_sum(bytes + length, tia_crc32(image_part_begin_sum(&part, frame), pixels, count));
    length += IMAGE_PART_SUM;
    int status = kept_write(&f->kept, bytes, length, f->end);
    f->end += length;
    free(bytes);
    return status;
}

int finished_append(struct finished *f, uint32_t frame, unsigned y, unsigned rows, const tia_rgb565 *pixels)
{
    int status = TIA_OK;

    for (unsigned i = 0, count; f->kept.path && i < rows && !status; i += count) {
        bool known = finished_has(f, frame, y + i, 1);
        for (count = 1; i + count < rows && finished_has(f, frame, y + i + count, 1) == known;)
            count++;
        if (!known)
            status = append_part(f, frame, y + i, count, pixels + (size_t)i * f->film.width);
    }
    return status;
}
