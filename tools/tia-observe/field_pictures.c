#include "field_pictures.h"

#include <stdio.h>
#include <stdlib.h>

#include "common/image/decode.h"
#include "common/image/series.h"
#include "common/quilt.h"
#include "common/scene/whole_file.h"

enum { FILE_MOST = 1 << 30 };

static int refuse(struct pictures *p, int status, const char *path, const char *why)
{
    (void)snprintf(p->why, sizeof p->why, "%.300s: %s", path, why);
    return status;
}

static int load_file(struct pictures *p, const char *path, struct image_texels *texels)
{
    const char *why;
    struct whole whole;
    int status = whole_read(&whole, path, FILE_MOST, &why);

    if (status)
        return refuse(p, status, path, why);
    status = image_decode(texels, whole.bytes, whole.length, TIA_SIZE_MAX, FILE_MOST, &why);
    free(whole.bytes);
    return status ? refuse(p, status, path, why) : TIA_OK;
}

static int load_series(struct pictures *p, const char *name)
{
    int status = TIA_OK;

    for (unsigned i = 0; i < p->file_count && !status; i++) {
        char *path = series_path(name, i);
        if (!path)
            return refuse(p, TIA_ERR_MEMORY, "memory", "exhausted");
        status = load_file(p, path, &p->files[i]);
        if (!status && (p->files[i].width != p->files[0].width || p->files[i].height != p->files[0].height))
            status = refuse(p, TIA_ERR_RANGE, path, "not as large as the first picture");
        free(path);
    }
    return status;
}

int pictures_load(struct pictures *pictures, const char *path, unsigned count)
{
    struct tia_quilt quilt = {0, 0};
    uint32_t aspect;

    *pictures = (struct pictures){.count = count, .file_count = count ? count : 1};
    if (!count && !quilt_named(path, &quilt, &aspect))
        return refuse(pictures, TIA_ERR_RANGE, path,
                      "not a quilt's name (NAME_qs8x6a0.75.png); "
                      "a panel's needs --lenticular or --calibration");
    if (count && !series_is_pattern(path))
        return refuse(pictures, TIA_ERR_RANGE, path, "not a pattern for one picture each (NAME%03d.png)");
    pictures->files = calloc(pictures->file_count, sizeof *pictures->files);
    if (!pictures->files)
        return refuse(pictures, TIA_ERR_MEMORY, "memory", "exhausted");
    int status = count ? load_series(pictures, path) : load_file(pictures, path, pictures->files);
    if (status)
        return status;
    pictures->columns = quilt.columns;
    pictures->rows = quilt.rows;
    pictures->count = count ? count : (unsigned)quilt.columns * quilt.rows;
    pictures->width = pictures->files[0].width / (count ? 1u : quilt.columns);
    pictures->height = pictures->files[0].height / (count ? 1u : quilt.rows);
    return pictures->width && pictures->height ? TIA_OK : refuse(pictures, TIA_ERR_RANGE, path, "has too few pixels");
}

int pictures_load_one(struct pictures *pictures, const char *path)
{
    *pictures = (struct pictures){.count = 1, .file_count = 1, .files = calloc(1, sizeof *pictures->files)};
    int status = pictures->files ? load_file(pictures, path, pictures->files)
                                 : refuse(pictures, TIA_ERR_MEMORY, "memory", "exhausted");
    if (status)
        return status;
    pictures->width = pictures->files->width;
    pictures->height = pictures->files->height;
    return TIA_OK;
}

void pictures_free(struct pictures *pictures)
{
    for (unsigned i = 0; pictures->files && i < pictures->file_count; i++) {
        free(pictures->files[i].rgb);
        free(pictures->files[i].alpha);
    }
    free(pictures->files);
}

/* Converts 0..255 to 0..most, rounded to nearest. */
static unsigned level(unsigned char c, unsigned most)
{
    return (c * most * 2 + 255) / 510;
}

tia_rgb565 pictures_pixel(const struct pictures *p, unsigned picture, unsigned x, unsigned y)
{
    const struct image_texels *file = p->columns ? p->files : &p->files[picture];

    if (p->columns) {
        x += picture % p->columns * p->width;
        y += file->height - (picture / p->columns + 1) * p->height;
    }
    const unsigned char *rgb = file->rgb + 3 * ((size_t)y * file->width + x);
    return (tia_rgb565)(level(rgb[0], 31) << 11 | level(rgb[1], 63) << 5 | level(rgb[2], 31));
}
