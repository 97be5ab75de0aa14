#include "image.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "codec.h"
#include "ports.h"

static const char *const names[] = {
    [IMAGE_UNKNOWN] = "", [IMAGE_PNG] = "png",      [IMAGE_PPM] = "ppm", [IMAGE_BMP] = "bmp", [IMAGE_565] = "565",
    [IMAGE_Y4M] = "y4m",  [IMAGE_PART] = "tiapart", [IMAGE_PFM] = "pfm", [IMAGE_EXR] = "exr"};

static const struct image_codec *const codecs[] = {
#ifdef TIA_HAVE_PNG
    [IMAGE_PNG] = &image_codec_png,
#endif
    [IMAGE_PPM] = &image_codec_ppm, [IMAGE_BMP] = &image_codec_bmp,   [IMAGE_565] = &image_codec_565,
    [IMAGE_Y4M] = &image_codec_y4m, [IMAGE_PART] = &image_codec_part, [IMAGE_PFM] = &image_codec_pfm,
    [IMAGE_EXR] = &image_codec_exr};

enum image_format image_format_called(const char *name)
{
    for (enum image_format format = IMAGE_PNG; format <= IMAGE_EXR; format++)
        if (strcasecmp(name, names[format]) == 0)
            return format;
    return IMAGE_UNKNOWN;
}

enum image_format image_format_of(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot ? image_format_called(dot + 1) : IMAGE_UNKNOWN;
}

const char *image_format_name(enum image_format format)
{
    return names[format];
}

bool image_format_built(enum image_format format)
{
    return codecs[format];
}

bool image_format_films(enum image_format format)
{
    return format == IMAGE_Y4M || format == IMAGE_PART;
}

bool image_format_has(enum image_format format, unsigned depth)
{
    if (format == IMAGE_PFM || format == IMAGE_EXR)
        return depth == 32;
    return depth == 0 || ((format == IMAGE_PNG || format == IMAGE_PPM) && (depth == 8 || depth == 16));
}

bool image_bottom_up(const struct image *image)
{
    return image->codec->bottom_up;
}

static void release(struct image *image)
{
    free(image->line);
    free(image);
}

/* Allocates the picture and memory for a row; NULL, with the reason in `why`, on failure. */
static struct image *allocate(enum image_format format, const struct image_film *film, char *why)
{
    struct image *image = calloc(1, sizeof *image);
    unsigned char *line = malloc((size_t)film->width * 3 + 4);
    if (!image || !line) {
        (void)snprintf(why, PORT_WHY, "memory: exhausted");
        free(image);
        free(line);
        return NULL;
    }
    image->codec = codecs[format];
    image->film = *film;
    image->width = film->width;
    image->height = film->rows;
    image->line = line;
    return image;
}

struct image *image_create(const char *path, enum image_format format, unsigned width, unsigned height, char *why)
{
    const struct image_film picture = {
        .width = width, .height = height, .rows = height, .frames = 1, .all_frames = 1, .rate = {1, 1}};
    return image_create_film(path, format, &picture, why);
}

struct image *image_create_film(const char *path, enum image_format format, const struct image_film *film, char *why)
{
    if (!image_format_built(format)) {
        (void)snprintf(why, PORT_WHY, "%.150s: this build writes no %s files (use .ppm)", path, names[format]);
        return NULL;
    }
    if (!image_format_has(format, film->depth)) {
        (void)snprintf(why, PORT_WHY, "%.150s: .%s files have other colours (use .ppm)", path, names[format]);
        return NULL;
    }
    struct image *image = allocate(format, film, why);
    if (!image)
        return NULL;
    if (sink_open(&image->sink, path, why)) {
        release(image);
        return NULL;
    }
    if (image->codec->begin(image)) {
        image_discard(image);
        return NULL;
    }
    return image;
}

int image_band(struct image *image, const tia_rgb565 *pixels, unsigned count)
{
    for (unsigned i = 0; i < count && !image->status; i++) {
        unsigned row = image->codec->bottom_up ? count - 1 - i : i;
        image->status = image->codec->row(image, pixels + (size_t)row * image->width);
        image->rows++;
    }
    return image->status;
}

int image_rows(struct image *image, const unsigned char *bytes, unsigned count)
{
    size_t length = (size_t)image->width * 3 * image->film.depth / 8;

    for (unsigned i = 0; i < count && !image->status; i++) {
        unsigned row = image->codec->bottom_up ? count - 1 - i : i;
        image->status = image->codec->bytes(image, bytes + row * length);
        image->rows++;
    }
    return image->status;
}

void image_hurry(struct image *image)
{
    if (image->codec->hurry)
        image->codec->hurry(image);
}

int image_seal(struct image *image)
{
    uint64_t rows = (uint64_t)image->height * image->film.frames;
    if (!image->status && image->rows != rows) {
        (void)snprintf(image->sink.why, PORT_WHY, "%.150s: %" PRIu64 " rows of %" PRIu64 " were drawn",
                       image->sink.name, image->rows, rows);
        image->status = TIA_ERR_ARGUMENT;
    }
    if (!image->status)
        image->status = image->codec->end(image);
    int status = image->status;
    if (status) {
        image_discard(image);
        return status;
    }
    status = sink_seal(&image->sink);
    if (status)
        image_discard(image);
    return status;
}

int image_publish(struct image *image)
{
    int status = sink_publish(&image->sink);
    image_discard(image);
    return status;
}

int image_finish(struct image *image)
{
    int status = image_seal(image);
    return !status ? image_publish(image) : status;
}

void image_discard(struct image *image)
{
    image->codec->free(image);
    sink_discard(&image->sink);
    release(image);
}
