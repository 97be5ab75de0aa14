#include "scene_part.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/checksum.h"
#include "common/image/decode.h"
#include "whole_file.h"

#include <tia/mip.h>

/* Kinds of parts. The last one stands for several: PART_OPACITY + c for each enum tia_channel c. */
enum { PART_LIBRARY, PART_IMAGE, PART_OPACITY };

struct scene_part {
    struct scene_part *next;
    unsigned kind;
    struct whole text;          /* text of a library */
    struct image_texels texels; /* texels of an image or opacity */
    uint8_t *mip_levels;        /* their smaller levels, or NULL */
    char name[];                /* the name in the scene */
};

char *part_path(const struct scene_file *file, const char *name)
{
    const char *slash = strrchr(file->path, '/');
    int folder = slash && name[0] != '/' ? (int)(slash + 1 - file->path) : 0;
    char *path;
    return asprintf(&path, "%.*s%s", folder, file->path, name) >= 0 ? path : NULL;
}

static struct scene_part *find(const struct scene_file *file, const char *name, unsigned kind)
{
    struct scene_part *part = file->parts;
    while (part && (part->kind != kind || strcmp(part->name, name) != 0))
        part = part->next;
    return part;
}

static void release(struct scene_part *part)
{
    free(part->text.bytes);
    image_free(&part->texels);
    free(part->mip_levels);
    free(part);
}

/* Replaces the bytes of a picture file by its texels. */
static int decode(struct scene_part *part, size_t most, const char **why)
{
    const struct whole *text = &part->text;
    int status = image_decode(&part->texels, text->bytes, text->length, TIA_TEXTURE_MAX, most, why);
    if (!status && part->kind >= PART_OPACITY)
        image_channel(&part->texels, (enum tia_channel)(part->kind - PART_OPACITY));
    else
        image_drop_alpha(&part->texels);
    free(part->text.bytes);
    part->text = (struct whole){NULL, 0};
    return status;
}

static int open_path(const struct scene_file *file, struct scene_part *part, const char *path, size_t most,
                     const char **why)
{
    if (!scene_opens(file, path)) {
        *why = SCENE_REFUSED;
        return TIA_ERR_RANGE;
    }
    return whole_read(&part->text, path, most, why);
}

/* Reads the file. If it does not exist and its name has backslashes, as on Windows, reads the file whose name has
 * slashes instead. */
static int read_path(const struct scene_file *file, struct scene_part *part, size_t most, const char **why)
{
    char *path = part_path(file, part->name);
    *why = "memory: exhausted";
    int status = path ? open_path(file, part, path, most, why) : TIA_ERR_MEMORY;
    if (status == TIA_ERR_DEVICE && strchr(path, '\\')) {
        for (char *at = path; (at = strchr(at, '\\')) != NULL;)
            *at = '/';
        status = open_path(file, part, path, most, why);
    }
    free(path);
    return status;
}

static int load(struct scene_file *file, struct scene_part *part, const char **why)
{
    size_t left = SCENE_NAMED_MOST - file->named_bytes;
    int status = read_path(file, part, left, why);
    if (!status && file->wish->hashed)
        file->crc = checksum_bytes(file->crc, part->text.bytes, part->text.length);
    if (!status && part->kind != PART_LIBRARY)
        status = decode(part, left, why);
    file->named_bytes +=
        part->text.length + (size_t)part->texels.width * part->texels.height * (part->texels.rgb ? 3 : 1);
    return status;
}

/* Stores the part called `name` in *found. Its file is loaded on first use. */
static int fetch(struct scene_file *file, const char *name, unsigned kind, struct scene_part **found, const char **why)
{
    struct scene_part *part = *found = find(file, name, kind);
    if (part)
        return TIA_OK;
    part = calloc(1, sizeof *part + strlen(name) + 1);
    if (!part) {
        *why = "memory: exhausted";
        return TIA_ERR_MEMORY;
    }
    strcpy(part->name, name);
    part->kind = kind;
    int status = load(file, part, why);
    if (status) {
        release(part);
        return status;
    }
    part->next = file->parts;
    file->parts = *found = part;
    return TIA_OK;
}

int part_library(void *ctx, const char *name, const char **text, size_t *length, const char **why)
{
    struct scene_part *part;
    int status = fetch(ctx, name, PART_LIBRARY, &part, why);
    if (!status) {
        *text = part->text.bytes;
        *length = part->text.length;
    }
    return status;
}

/* Makes the levels of a texture that is filtered, once for each file. */
static int add_mips(struct scene_part *part, struct tia_texture *texture, const char **why)
{
    size_t size = tia_mip_size(texture);
    if (!texture->footprint || size == 0)
        return TIA_OK;
    if (!part->mip_levels) {
        part->mip_levels = malloc(size);
        if (!part->mip_levels) {
            *why = "memory: exhausted";
            return TIA_ERR_MEMORY;
        }
        tia_mip_build(texture, part->mip_levels);
    }
    texture->mip_levels = part->mip_levels;
    return TIA_OK;
}

static int fetch_texels(struct scene_file *file, const char *name, unsigned kind, struct tia_texture *texture,
                        const char **why)
{
    struct scene_part *part;
    int status = fetch(file, name, kind, &part, why);
    if (!status) {
        texture->width = (uint16_t)part->texels.width;
        texture->height = (uint16_t)part->texels.height;
        texture->texels = kind == PART_IMAGE ? part->texels.rgb : part->texels.alpha;
        status = add_mips(part, texture, why);
    }
    return status;
}

int part_image(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    return fetch_texels(ctx, name, PART_IMAGE, texture, why);
}

int part_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture, const char **why)
{
    return fetch_texels(ctx, name, PART_OPACITY + (unsigned)channel, texture, why);
}

void part_free_all(struct scene_file *file)
{
    while (file->parts) {
        struct scene_part *part = file->parts;
        file->parts = part->next;
        release(part);
    }
}
