#include "series.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/sink.h"
#include "ports.h"

enum { DIGITS_MOST = 9 };

/* Finds the first %d or %0Nd; sets *length to its length, *digits to N. NULL if there is none. */
static const char *find_pattern(const char *name, int *length, int *digits)
{
    for (const char *at = strchr(name, '%'); at; at = strchr(at + 1, '%')) {
        bool padded = at[1] == '0' && at[2] >= '1' && at[2] <= '0' + DIGITS_MOST;
        if (at[padded ? 3 : 1] == 'd') {
            *length = padded ? 4 : 2;
            *digits = padded ? at[2] - '0' : 1;
            return at;
        }
    }
    return NULL;
}

bool series_is_pattern(const char *name)
{
    int length, digits;
    return find_pattern(name, &length, &digits);
}

char *series_path(const char *name, uint32_t frame)
{
    int length, digits;
    const char *pattern = find_pattern(name, &length, &digits);
    char *path = NULL;
    if (!pattern)
        return strdup(name);
    if (asprintf(&path, "%.*s%0*u%s", (int)(pattern - name), name, digits, (unsigned)frame, pattern + length) < 0)
        return NULL;
    return path;
}

/* Returns the last part of a path. */
static const char *base_of(const char *path)
{
    const char *slash = strrchr(path, '/');

    return slash ? slash + 1 : path;
}

bool series_has(const char *name, const char *file)
{
    int length, digits;
    const char *pattern = find_pattern(name, &length, &digits), *base = base_of(name), *own = base_of(file);

    if (!pattern)
        return sink_is_same(name, file);
    if (pattern < base || strncmp(base, own, (size_t)(pattern - base)) != 0)
        return false;
    char *path = series_path(name, (uint32_t)strtoul(own + (pattern - base), NULL, 10));
    bool same = path && sink_is_same(path, file);
    free(path);
    return same;
}

static int begin_picture(struct series *series, uint32_t frame)
{
    free(series->path);
    series->path = series_path(series->name, frame);
    if (!series->path) {
        (void)snprintf(series->why, PORT_WHY, "memory: exhausted");
        return TIA_ERR_MEMORY;
    }
    const struct image_film picture = {.width = series->film.width,
                                       .height = series->film.height,
                                       .rows = series->film.height,
                                       .frames = 1,
                                       .all_frames = 1,
                                       .rate = {1, 1},
                                       .depth = series->film.depth,
                                       .transfer = series->film.transfer,
                                       .surfaces = series->film.surfaces};
    series->image = image_create_film(series->path, series->format, &picture, series->why);
    return series->image ? TIA_OK : TIA_ERR_DEVICE;
}

int series_begin(struct series *series, uint32_t frame)
{
    if (!image_format_films(series->format))
        return begin_picture(series, frame);
    if (!series->image)
        series->image = image_create_film(series->name, series->format, &series->film, series->why);
    return series->image ? TIA_OK : TIA_ERR_DEVICE;
}

int series_end(struct series *series)
{
    if (image_format_films(series->format))
        return TIA_OK;
    struct image *image = series->image;
    series->image = NULL;
    return image_finish(image);
}

int series_finish(struct series *series)
{
    int status = TIA_OK;
    if (series->image) {
        status = image_finish(series->image);
        series->image = NULL;
    }
    series_discard(series);
    return status;
}

void series_discard(struct series *series)
{
    if (series->image)
        image_discard(series->image);
    free(series->path);
    series->image = NULL;
    series->path = NULL;
}
