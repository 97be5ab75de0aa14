/* obj_files.h - reads models, with libraries from strings or from scenes/obj, and with made-up images. */
#ifndef TESTS_OBJ_FILES_H
#define TESTS_OBJ_FILES_H

#include "reading.h"

#define SCENES "scenes/obj/"

/* Files that a model names, as strings; files that are not among them are read from scenes/obj. */
struct files {
    const char *names[20], *texts[20];
    char *loaded[4];
    unsigned loaded_count, libraries, images, opacities;
    bool strict;
    struct tia_read_warning warnings[TIA_WARNINGS];
};

static inline int fetch_library(void *ctx, const char *name, const char **text, size_t *length, const char **why)
{
    struct files *files = ctx;
    char path[300];

    files->libraries++;
    for (int i = 0; files->names[i]; i++)
        if (!strcmp(files->names[i], name)) {
            *text = files->texts[i];
            *length = strlen(*text);
            return TIA_OK;
        }
    (void)snprintf(path, sizeof path, SCENES "%s", name);
    char *found = files->loaded_count < 4 ? load_file(path, length) : NULL;
    *why = "no such file";
    if (found)
        *text = files->loaded[files->loaded_count++] = found;
    return found ? TIA_OK : TIA_ERR_ARGUMENT;
}

/* Fetches an image, whatever its name: two texels, (1, 2, 3) and (4, 5, 6). */
static inline int fetch_image(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    static const uint8_t texels[] = {1, 2, 3, 4, 5, 6};
    struct files *files = ctx;

    files->images++;
    *why = "no such picture";
    if (!strstr(name, ".ppm"))
        return TIA_ERR_ARGUMENT;
    texture->width = 2;
    texture->height = 1;
    texture->texels = texels;
    return TIA_OK;
}

/* Fetches an opacity of one texel. Its value is the number of the channel; 255 for every channel of "whole.ppm". */
static inline int fetch_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture,
                                const char **why)
{
    static const uint8_t texels[] = {0, 1, 2, 3, 4, 5, 255, 255, 255, 255, 255, 255};
    struct files *files = ctx;

    files->opacities++;
    *why = "no such picture";
    texture->width = texture->height = 1;
    texture->texels = texels + (int)channel + (strstr(name, "whole") ? 6 : 0);
    return strstr(name, ".ppm") ? TIA_OK : TIA_ERR_ARGUMENT;
}

static inline void read_obj(struct reading *r, struct files *files, const char *text, size_t length)
{
    *r = (struct reading){.reader = {.format = TIA_FORMAT_OBJ,
                                     .text = text,
                                     .length = length,
                                     .library = fetch_library,
                                     .image = fetch_image,
                                     .opacity = fetch_opacity,
                                     .ctx = files,
                                     .strict = files->strict,
                                     .warnings = files->warnings}};
    read_begin(r);
}

static inline void read_model(struct reading *r, struct files *files, const char *text)
{
    read_obj(r, files, text, strlen(text));
    CHECK_MSG(!r->status, "%u:%u: %s", (unsigned)r->reader.error.line, (unsigned)r->reader.error.column,
              r->reader.error.text);
}

static inline bool load(struct reading *r, struct files *files, char **text, const char *path)
{
    size_t length = 0;

    *r = (struct reading){.status = TIA_ERR_ARGUMENT};
    *text = load_file(path, &length);
    CHECK_MSG(*text, "no %s", path);
    if (*text)
        read_obj(r, files, *text, length);
    CHECK_MSG(*text && !r->status, "%s: %u:%u: %s", path, (unsigned)r->reader.error.line,
              (unsigned)r->reader.error.column, r->reader.error.text);
    return *text && !r->status;
}

static inline void finish(struct reading *r, struct files *files)
{
    read_end(r);
    while (files->loaded_count)
        free(files->loaded[--files->loaded_count]);
}

#define TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

struct wrong {
    const char *text, *want;
};

#endif
