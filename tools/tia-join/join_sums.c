#include "join_sums.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common/image/sums.h"
#include "common/inputs.h"
#include "common/regular.h"
#include "common/sink.h"
#include "ports.h"

/* Bytes of the rows that are added at once. Parts are open only while they are read, so that neither the memory nor the
 * number of open files grows with their number, apart from a struct summand each. */
enum { BAND_BYTES = 1 << 20 };

struct summand {
    const char *path;
    struct sums sums;
};

struct addition {
    struct summand *summands;
    unsigned count;
    struct sums sums; /* description of the result */
    struct image *image;
    struct sink *sink;
    struct tia_sum *band;
    unsigned char *bytes; /* bytes of the band in a file, or of a row in a picture */
    unsigned band_rows;
    unsigned depth;
    char written[PORT_WHY];
    char *why;
};

enum { FINE, NOT_WRITTEN, REFUSED };

static int refuse(struct addition *a, const char *path, const char *reason)
{
    (void)snprintf(a->why, SUMS_WHY, "%.300s: %s", path, reason);
    return REFUSED;
}

/* Opens a part. */
static FILE *open_part(const char *path)
{
    struct stat status;
    int fd = regular_open(path, &status);

    if (fd < 0)
        return NULL;
    inputs_add(&status);
    return fdopen(fd, "rb");
}

bool is_sums(const char *path)
{
    static const char magic[] = "TIASUMS1 ";
    char text[sizeof magic - 1];
    FILE *file = open_part(path);
    bool is = file && fread(text, 1, sizeof text, file) == sizeof text && !memcmp(text, magic, sizeof text);

    if (file)
        (void)fclose(file);
    return is;
}

static int check_one(struct addition *a, struct summand *s, FILE *file)
{
    char text[SUMS_HEADER];
    size_t header = sums_parse(&s->sums, text, fread(text, 1, sizeof text, file));

    if (!header || s->sums.guided)
        return refuse(a, s->path, "not a part of samples");
    if (fseek(file, 0, SEEK_END) != 0 ||
        (uint64_t)ftell(file) != header + (uint64_t)s->sums.height * sums_row_bytes(&s->sums))
        return refuse(a, s->path, "is not complete (tia --resume goes on with it)");
    const struct sums *first = &a->summands[0].sums, *this = &s->sums;
    if (this->crc != first->crc || this->width != first->width || this->height != first->height)
        return refuse(a, s->path, "a part of another scene, size or integrator");
    return FINE;
}

static int open_one(struct addition *a, struct summand *s, const char *path)
{
    FILE *file = open_part(path);

    s->path = path;
    if (!file)
        return refuse(a, path, strerror(errno));
    int result = check_one(a, s, file);
    (void)fclose(file);
    return result;
}

static int by_first(const void *a, const void *b)
{
    const struct summand *x = a, *y = b;

    return (x->sums.first > y->sums.first) - (x->sums.first < y->sums.first);
}

static int follow(struct addition *a)
{
    char reason[80];

    qsort(a->summands, a->count, sizeof *a->summands, by_first);
    a->sums = a->summands[0].sums;
    for (unsigned i = 1; i < a->count; i++) {
        const struct sums *s = &a->summands[i].sums;
        uint32_t end = a->sums.first + a->sums.count;
        if (s->first != end) {
            (void)snprintf(reason, sizeof reason, "samples %u to %u are %s",
                           (unsigned)(s->first < end ? s->first : end), (unsigned)(s->first < end ? end : s->first) - 1,
                           s->first < end ? "given twice" : "missing");
            return refuse(a, a->summands[i].path, reason);
        }
        a->sums.count += s->count;
    }
    return FINE;
}

static int open_output(struct addition *a, const char *output, enum image_format format)
{
    char header[SUMS_HEADER];
    struct image_film film = {.width = a->sums.width,
                              .height = a->sums.height,
                              .rows = a->sums.height,
                              .frames = 1,
                              .all_frames = 1,
                              .rate = {1, 1}};

    if (format == IMAGE_PART) {
        a->sink = calloc(1, sizeof *a->sink);
        if (!a->sink || sink_open(a->sink, output, a->written)) {
            free(a->sink);
            a->sink = NULL;
            return NOT_WRITTEN;
        }
        return sink_write(a->sink, header, sums_print(header, &a->sums)) ? NOT_WRITTEN : FINE;
    }
    a->depth = image_format_has(format, 32) ? 32 : 8;
    if (!image_format_has(format, a->depth))
        return refuse(a, output, "samples make a .png, .ppm, .pfm, .exr or .tiapart");
    if (a->sums.first)
        return refuse(a, a->summands[0].path, "a picture needs sample 0");
    film.depth = a->depth;
    film.transfer = sums_transfer(&a->sums, a->depth);
    a->image = image_create_film(output, format, &film, a->written);
    return a->image ? FINE : NOT_WRITTEN;
}

/* Adds rows y to y + rows - 1 of one part to the band. */
static int add_rows_of(struct addition *a, const struct summand *s, unsigned y, unsigned rows)
{
    size_t length = sums_row_bytes(&s->sums);
    long back = -(long)((uint64_t)(s->sums.height - y) * length);
    FILE *file = open_part(s->path);

    bool is_read = file && fseek(file, back, SEEK_END) == 0 && fread(a->bytes, 1, rows * length, file) == rows * length;
    if (file)
        (void)fclose(file);
    if (!is_read)
        return refuse(a, s->path, "cannot be read");
    for (unsigned i = 0; i < rows; i++)
        if (!sums_add_row(a->band + (size_t)i * a->sums.width, &s->sums, y + i, a->bytes + i * length))
            return refuse(a, s->path, "is damaged");
    return FINE;
}

static int write_row(struct addition *a, unsigned y, const struct tia_sum *row)
{
    if (a->sink) {
        sums_put_row(a->bytes, &a->sums, y, row);
        return sink_write(a->sink, a->bytes, sums_row_bytes(&a->sums)) ? NOT_WRITTEN : FINE;
    }
    sums_develop(a->bytes, &a->sums, row, a->depth);
    return image_rows(a->image, a->bytes, 1) ? NOT_WRITTEN : FINE;
}

/* Adds and writes rows y to y + rows - 1, with `upwards` the last one first. */
static int add_band(struct addition *a, unsigned y, unsigned rows, bool upwards)
{
    int result = FINE;

    memset(a->band, 0, (size_t)rows * a->sums.width * sizeof *a->band);
    for (unsigned i = 0; i < a->count && result == FINE; i++)
        result = add_rows_of(a, &a->summands[i], y, rows);
    for (unsigned i = 0; i < rows && result == FINE; i++) {
        unsigned row = upwards ? rows - 1 - i : i;
        result = write_row(a, y + row, a->band + (size_t)row * a->sums.width);
    }
    return result;
}

static int add_bands(struct addition *a)
{
    unsigned height = a->sums.height, most = (unsigned)(BAND_BYTES / sums_row_bytes(&a->sums));
    bool upwards = a->image && image_bottom_up(a->image); /* as a .pfm, which stores the bottom row first */
    int result = FINE;

    a->band_rows = most < 1 ? 1 : most < height ? most : height;
    a->band = malloc((size_t)a->band_rows * a->sums.width * sizeof *a->band);
    a->bytes = malloc(a->band_rows * sums_row_bytes(&a->sums));
    if (!a->band || !a->bytes)
        return NOT_WRITTEN;
    for (unsigned done = 0; done < height && result == FINE; done += a->band_rows) {
        unsigned rows = height - done < a->band_rows ? height - done : a->band_rows;
        result = add_band(a, upwards ? height - done - rows : done, rows, upwards);
    }
    return result;
}

static int finish(struct addition *a, int result)
{
    int status = TIA_OK;

    if (a->sink && result == FINE)
        status = sink_commit(a->sink);
    else if (a->sink)
        sink_discard(a->sink);
    else if (a->image && result == FINE)
        status = image_finish(a->image);
    else if (a->image)
        image_discard(a->image);
    free(a->sink);
    return status ? NOT_WRITTEN : result;
}

static int add(struct addition *a, char *const *paths, const char *output, enum image_format format)
{
    int result = FINE;

    for (unsigned i = 0; i < a->count && result == FINE; i++)
        result = open_one(a, &a->summands[i], paths[i]);
    result = result == FINE ? follow(a) : result;
    result = result == FINE ? open_output(a, output, format) : result;
    result = result == FINE ? add_bands(a) : result;
    return finish(a, result);
}

int join_sums(char *const *paths, unsigned count, const char *output, enum image_format format, char *why)
{
    struct addition a = {.summands = calloc(count, sizeof(struct summand)), .count = count, .why = why};
    int result = a.summands ? add(&a, paths, output, format) : NOT_WRITTEN;

    if (result == NOT_WRITTEN)
        (void)snprintf(why, SUMS_WHY, "%s", a.written[0] ? a.written : "memory: exhausted");
    free(a.summands);
    free(a.band);
    free(a.bytes);
    return result;
}
