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
#include "common/sink.h"
#include "ports.h"

struct summand {
    const char *path;
    FILE *file;
    struct sums sums;
};

struct addition {
    struct summand *summands;
    unsigned count;
    struct sums sums; /* description of the result */
    struct image *image;
    struct sink *sink;
    struct tia_sum *row;
    unsigned char *bytes; /* bytes of a row, in a file or in a picture */
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

/* Opens a regular file; all parts must be regular files, as a FIFO would block. */
static FILE *open_regular(const char *path)
{
    int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    struct stat status;

    if (fd < 0)
        return NULL;
    if (fstat(fd, &status) == 0 && S_ISREG(status.st_mode)) {
        inputs_add(&status);
        return fdopen(fd, "rb");
    }
    (void)close(fd);
    errno = EINVAL;
    return NULL;
}

bool is_sums(const char *path)
{
    static const char magic[] = "TIASUMS1 ";
    char text[sizeof magic - 1];
    FILE *file = open_regular(path);
    bool is = file && fread(text, 1, sizeof text, file) == sizeof text && !memcmp(text, magic, sizeof text);

    if (file)
        (void)fclose(file);
    return is;
}

static int open_one(struct addition *a, struct summand *s, const char *path)
{
    char text[SUMS_HEADER];

    s->path = path;
    s->file = open_regular(path);
    if (!s->file)
        return refuse(a, path, strerror(errno));
    size_t header = sums_parse(&s->sums, text, fread(text, 1, sizeof text, s->file));
    if (!header || s->sums.guided)
        return refuse(a, path, "not a part of samples");
    if (fseek(s->file, 0, SEEK_END) != 0 ||
        (uint64_t)ftell(s->file) != header + (uint64_t)s->sums.height * sums_row_bytes(&s->sums))
        return refuse(a, path, "is not complete (tia --resume goes on with it)");
    if (fseek(s->file, (long)header, SEEK_SET) != 0)
        return refuse(a, path, strerror(errno));
    const struct sums *first = &a->summands[0].sums, *this = &s->sums;
    if (this->crc != first->crc || this->width != first->width || this->height != first->height)
        return refuse(a, path, "a part of another scene, size or integrator");
    return FINE;
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

static int add_row(struct addition *a, unsigned y)
{
    memset(a->row, 0, a->sums.width * sizeof *a->row);
    for (unsigned i = 0; i < a->count; i++) {
        struct summand *s = &a->summands[i];
        size_t length = sums_row_bytes(&s->sums);
        /* counted from the end: a .pfm stores the bottom row first */
        long back = -(long)((uint64_t)(s->sums.height - y) * length);
        if (fseek(s->file, back, SEEK_END) != 0 || fread(a->bytes, 1, length, s->file) != length)
            return refuse(a, s->path, "cannot be read");
        if (!sums_add_row(a->row, &s->sums, y, a->bytes))
            return refuse(a, s->path, "is damaged");
    }
    return FINE;
}

static int write_row(struct addition *a, unsigned y)
{
    if (a->sink) {
        sums_put_row(a->bytes, &a->sums, y, a->row);
        return sink_write(a->sink, a->bytes, sums_row_bytes(&a->sums)) ? NOT_WRITTEN : FINE;
    }
    sums_develop(a->bytes, &a->sums, a->row, a->depth);
    return image_rows(a->image, a->bytes, 1) ? NOT_WRITTEN : FINE;
}

static int add_rows(struct addition *a)
{
    unsigned height = a->sums.height;
    int result = FINE;

    a->row = malloc(a->sums.width * sizeof *a->row);
    a->bytes = malloc(sums_row_bytes(&a->sums));
    if (!a->row || !a->bytes)
        return NOT_WRITTEN;
    for (unsigned i = 0; i < height && result == FINE; i++) {
        unsigned y = a->image && image_bottom_up(a->image) ? height - 1 - i : i;
        result = add_row(a, y);
        result = result == FINE ? write_row(a, y) : result;
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
    result = result == FINE ? add_rows(a) : result;
    return finish(a, result);
}

int join_sums(char *const *paths, unsigned count, const char *output, enum image_format format, char *why)
{
    struct addition a = {.summands = calloc(count, sizeof(struct summand)), .count = count, .why = why};
    int result = a.summands ? add(&a, paths, output, format) : NOT_WRITTEN;

    for (unsigned i = 0; a.summands && i < count; i++)
        if (a.summands[i].file)
            (void)fclose(a.summands[i].file);
    if (result == NOT_WRITTEN)
        (void)snprintf(why, SUMS_WHY, "%s", a.written[0] ? a.written : "memory: exhausted");
    free(a.summands);
    free(a.row);
    free(a.bytes);
    return result;
}
