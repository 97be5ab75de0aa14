/* read.h - any bytes as a scene file: the result is an error with a text, or a scene that tia_scene_check accepts, in
 * exactly the memory that the reader required. The bytes after the first zero byte are the text of each library, and of
 * each of up to 64 files that a .tia file includes, and of up to 256 models. */
#ifndef TESTS_FUZZ_READ_H
#define TESTS_FUZZ_READ_H

#include <stdio.h>
#include <string.h>

#include "bytes.h"

struct rest {
    const char *text;
    size_t length;
};

static int fetch_library(void *ctx, const char *name, const char **text, size_t *length, const char **why)
{
    const struct rest *rest = ctx;
    *why = "no such file";
    *text = rest->text;
    *length = rest->length;
    return *name == 'x' ? TIA_ERR_DEVICE : TIA_OK;
}

static int fetch_image(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    static const uint8_t texels[12];
    (void)ctx;
    *why = "no such file";
    texture->width = texture->height = 2;
    texture->texels = texels;
    texture->mip_levels = texture->footprint ? texels : NULL;
    return *name == 'x' ? TIA_ERR_DEVICE : TIA_OK;
}

static int fetch_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture,
                         const char **why)
{
    MUST(channel >= TIA_CHANNEL_OPACITY && channel < TIA_CHANNELS);
    return fetch_image(ctx, name, texture, why);
}

/* Checks that each warning has a text and a place in one of the texts. */
static void must_warn(const struct tia_read_warning *warnings, size_t size)
{
    for (unsigned i = 0; i < TIA_WARNINGS; i++)
        MUST(!warnings[i].count || (*warnings[i].at.text && warnings[i].count <= size + 1 &&
                                    warnings[i].at.line <= size + 1 && warnings[i].at.column <= size + 1));
}

/* Counts a mistake, and checks its place and its line of text. */
static void must_tell(void *ctx, const struct tia_read_error *error)
{
    unsigned sum = 0;

    (void)ctx;
    for (uint32_t i = 0; i < error->source_length; i++)
        sum += (unsigned char)error->source[i]; /* is readable */
    MUST(sum <= 255 * error->source_length && *error->text && memchr(error->text, 0, sizeof error->text));
    MUST(!error->source || (error->line && error->column - 1 + error->length <= error->source_length));
    for (const char *c = error->text; *c; c++)
        MUST(*c >= ' ' && *c < 127);
}

static inline void read_any(enum tia_format format, const uint8_t *data, size_t size)
{
    const uint8_t *zero = size ? memchr(data, 0, size) : NULL;
    bool has_parts = format == TIA_FORMAT_TIA || format == TIA_FORMAT_OBJ;
    size_t length = has_parts && zero ? (size_t)(zero - data) : size;
    struct rest rest = {(const char *)data + length, size - length};
    struct tia_read_warning warnings[TIA_WARNINGS];
    struct tia_reader reader = {.format = format,
                                .text = (const char *)data,
                                .length = length,
                                .ctx = &rest,
                                .strict = size % 4 == 1,
                                .mistake = must_tell,
                                .warnings = warnings};
    struct tia_scene scene;
    void *memory = NULL;
    size_t need = 1, again = 1;

    if (rest.length) {
        rest.text++;
        rest.length--;
    }
    if (size % 16) {
        reader.library = fetch_library;
        reader.image = fetch_image;
        reader.opacity = fetch_opacity;
    }
    int status = tia_read(&reader, &scene, NULL, 0, &need);
    if (status == TIA_ERR_MEMORY) {
        /* a model has at most a part for each two bytes, and an instance needs ten */
        size_t more = format == TIA_FORMAT_TIA ? 256 * rest.length + length / 10 * (rest.length / 2) : 0;
        MUST(need > 0 && need < 110 * (size + more) + 1000);
        memory = malloc(need);
        MUST(tia_read(&reader, &scene, memory, need - 1, &again) == TIA_ERR_MEMORY && again == need);
        status = tia_read(&reader, &scene, memory, need, &again);
        MUST(status ? again >= need : again == need);
    } else if (status == TIA_ERR_RANGE && need) { /* with memory, all mistakes are told */
        MUST(need < 200 * (size + 256 * rest.length + length / 10 * (rest.length / 2)) + 1000);
        memory = malloc(need);
        status = tia_read(&reader, &scene, memory, need, &again);
        MUST(status == TIA_ERR_RANGE && reader.mistakes);
    }
    if (!status)
        must_warn(warnings, size);
    if (!status)
        MUST(!tia_scene_check(&scene, NULL));
    else
        MUST(status == TIA_ERR_RANGE && reader.mistakes && reader.mistakes <= TIA_MISTAKES_MAX + 1 &&
             *reader.error.text && reader.error.line <= size + 1 && reader.error.column <= size + 1);
    free(memory);
}

#endif
