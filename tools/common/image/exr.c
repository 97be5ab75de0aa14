/* exr.c - writes OpenEXR, version 2: one part of scan lines without compression, from the top. The channels B, G and R,
 * and Z, N.X, N.Y and N.Z where surfaces are known, are floats, and id is an unsigned integer. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bytes.h"
#include "codec.h"
#include "ports.h"

enum { MAGIC = 20000630, VERSION = 2, TYPE_UINT = 0, TYPE_FLOAT = 2 };
enum { NUMBER = 4, LINE_HEAD = 8, OFFSET = 8, HEADER_MOST = 512 };

/* The channels, in the order of the file: by name. A line has all numbers of one channel, then of the next. */
static const struct {
    const char *name;
    bool of_surface; /* a channel of struct image_surface */
    unsigned type;
} channels[] = {{"B", false, TYPE_FLOAT},  {"G", false, TYPE_FLOAT},  {"N.X", true, TYPE_FLOAT},
                {"N.Y", true, TYPE_FLOAT}, {"N.Z", true, TYPE_FLOAT}, {"R", false, TYPE_FLOAT},
                {"Z", true, TYPE_FLOAT},   {"id", true, TYPE_UINT}};

enum { CHANNELS = sizeof channels / sizeof *channels };

static unsigned channel_count(const struct image *image)
{
    return image->film.surfaces ? CHANNELS : 3;
}

static size_t line_bytes(const struct image *image)
{
    return (size_t)image->width * channel_count(image) * NUMBER;
}

/* ---- the header ---- */

static unsigned char *put_text(unsigned char *at, const char *text)
{
    size_t length = strlen(text) + 1;

    memcpy(at, text, length);
    return at + length;
}

/* Begins an attribute of `bytes` bytes. */
static unsigned char *put_attribute(unsigned char *at, const char *name, const char *type, unsigned bytes)
{
    return put_bytes(put_text(put_text(at, name), type), bytes, NUMBER);
}

static unsigned char *put_channels(unsigned char *at, const struct image *image)
{
    unsigned char list[HEADER_MOST], *end = list;

    for (unsigned c = 0; c < CHANNELS; c++)
        if (!channels[c].of_surface || image->film.surfaces) {
            end = put_text(end, channels[c].name);
            end =
                put_bytes(put_bytes(end, channels[c].type, NUMBER), 0, NUMBER); /* perceptually linear: no; reserved */
            end = put_bytes(put_bytes(end, 1, NUMBER), 1, NUMBER);              /* samples of every pixel */
        }
    end = put_bytes(end, 0, 1);
    at = put_attribute(at, "channels", "chlist", (unsigned)(end - list));
    memcpy(at, list, (size_t)(end - list));
    return at + (end - list);
}

static unsigned char *put_window(unsigned char *at, const char *name, const struct image *image)
{
    at = put_bytes(put_attribute(at, name, "box2i", 4 * NUMBER), 0, 2 * NUMBER);
    return put_bytes(put_bytes(at, image->width - 1, NUMBER), image->height - 1, NUMBER);
}

static size_t put_header(unsigned char *header, const struct image *image)
{
    unsigned char *at = put_bytes(put_bytes(header, MAGIC, NUMBER), VERSION, NUMBER);

    at = put_channels(at, image);
    at = put_bytes(put_attribute(at, "compression", "compression", 1), 0, 1);
    at = put_window(at, "dataWindow", image);
    at = put_window(at, "displayWindow", image);
    at = put_bytes(put_attribute(at, "lineOrder", "lineOrder", 1), 0, 1);
    at = put_float_bytes(put_attribute(at, "pixelAspectRatio", "float", NUMBER), 1);
    at = put_bytes(put_attribute(at, "screenWindowCenter", "v2f", 2 * NUMBER), 0, 2 * NUMBER);
    at = put_float_bytes(put_attribute(at, "screenWindowWidth", "float", NUMBER), 1);
    return (size_t)(put_bytes(at, 0, 1) - header);
}

static int begin(struct image *image)
{
    unsigned char header[HEADER_MOST], offset[OFFSET];
    size_t used = put_header(header, image);
    uint64_t at = used + (uint64_t)image->height * OFFSET;

    image->state = malloc(LINE_HEAD + line_bytes(image));
    if (!image->state) {
        (void)snprintf(image->sink.why, PORT_WHY, "memory: exhausted");
        return TIA_ERR_MEMORY;
    }
    int status = sink_write(&image->sink, header, used);
    for (unsigned y = 0; y < image->height && !status; y++, at += LINE_HEAD + line_bytes(image)) {
        (void)put_bytes(offset, at, OFFSET);
        status = sink_write(&image->sink, offset, sizeof offset);
    }
    return status;
}

/* ---- the lines ---- */

static unsigned char *put_colours(unsigned char *at, const unsigned char *row, unsigned width, unsigned colour)
{
    for (unsigned x = 0; x < width; x++, at += NUMBER)
        memcpy(at, row + (size_t)NUMBER * (3 * x + colour), NUMBER);
    return at;
}

static unsigned char *put_surfaces(unsigned char *at, const struct image_surface *row, unsigned width, unsigned channel)
{
    for (unsigned x = 0; x < width; x++) {
        const char *name = channels[channel].name;
        if (channels[channel].type == TYPE_UINT)
            at = put_bytes(at, row[x].object, NUMBER);
        else
            at = put_float_bytes(at, *name == 'Z' ? row[x].depth : row[x].normal[name[2] - 'X']);
    }
    return at;
}

static int bytes(struct image *image, const unsigned char *row)
{
    unsigned y = (unsigned)image->rows, width = image->width;
    const struct image_surface *surfaces = image->film.surfaces ? image->film.surfaces + (size_t)y * width : NULL;
    unsigned char *line = image->state, *at = put_bytes(put_bytes(line, y, NUMBER), line_bytes(image), NUMBER);

    for (unsigned c = 0; c < CHANNELS; c++)
        if (!channels[c].of_surface)
            at = put_colours(at, row, width, *channels[c].name == 'R' ? 0 : *channels[c].name == 'G' ? 1 : 2);
        else if (surfaces)
            at = put_surfaces(at, surfaces, width, c);
    return sink_write(&image->sink, line, LINE_HEAD + line_bytes(image));
}

static int end(struct image *image)
{
    (void)image;
    return TIA_OK;
}

static void release(struct image *image)
{
    free(image->state);
    image->state = NULL;
}

const struct image_codec image_codec_exr = {.name = "exr", .begin = begin, .bytes = bytes, .end = end, .free = release};
