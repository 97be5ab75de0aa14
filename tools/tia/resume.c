#include "resume.h"

#include <stdlib.h>
#include <string.h>

static uint64_t place_of(const struct resume *r, unsigned y)
{
    return r->header + (uint64_t)y * sums_row_bytes(&r->sums);
}

/* Reads the header of an old file, or begins a new one. An incomplete last row is ignored, and drawn again. */
static int read_header(struct resume *r, uint64_t size)
{
    char text[SUMS_HEADER], wanted[SUMS_HEADER];
    struct sums old;
    size_t got;

    r->header = sums_print(wanted, &r->sums);
    int status = kept_read(&r->kept, text, sizeof text, 0, &got);
    if (status)
        return status;
    if (got < r->header && !memcmp(text, wanted, got)) /* the file is new, or the run was killed while it wrote the
                                                          first line */
        return kept_write(&r->kept, wanted, r->header, 0);
    if (!sums_parse(&old, text, got))
        return kept_refused(&r->kept, "not a part left by an interrupted run");
    if (old.crc != r->sums.crc || old.width != r->sums.width || old.height != r->sums.height)
        return kept_refused(&r->kept, "a part of another scene, size or integrator");
    if (old.guided != r->sums.guided)
        return kept_refused(&r->kept, old.guided ? "is of a run with --denoise or --guide"
                                                 : "is of a run without --denoise and --guide");
    if (old.first != r->sums.first || old.count != r->sums.count)
        return kept_refused(&r->kept, "has other samples (--spp, --samples-range)");
    r->header = sums_print(wanted, &old); /* tone and exposure of the old file do not matter */
    uint64_t rows = (size - r->header) / sums_row_bytes(&r->sums);
    r->rows = rows < r->sums.height ? (unsigned)rows : r->sums.height;
    return TIA_OK;
}

int resume_open(struct resume *r, const char *path, const struct sums *sums, char *why)
{
    uint64_t size;

    *r = (struct resume){.sums = *sums};
    int status = kept_open(&r->kept, path, &size, why);
    return status ? status : read_header(r, size);
}

int resume_read(const struct resume *r, unsigned y, unsigned rows, const struct tia_gathered *band)
{
    size_t length = sums_row_bytes(&r->sums), got = 0;
    unsigned char *bytes = malloc(length);
    int status = bytes ? TIA_OK : TIA_ERR_MEMORY;

    for (unsigned i = 0; i < rows && !status; i++) {
        const struct tia_gathered row = gathered_at(band, (size_t)i * r->sums.width);
        status = kept_read(&r->kept, bytes, length, place_of(r, y + i), &got);
        if (!status && (got < length || !sums_get_gathered(&row, &r->sums, y + i, bytes)))
            status = kept_refused(&r->kept, "is damaged");
    }
    free(bytes);
    return status;
}

int resume_append(struct resume *r, unsigned y, unsigned rows, const struct tia_gathered *band)
{
    size_t length = sums_row_bytes(&r->sums);
    unsigned char *bytes = r->kept.path ? malloc(length) : NULL;
    int status = bytes || !r->kept.path ? TIA_OK : TIA_ERR_MEMORY;

    for (unsigned i = 0; r->kept.path && i < rows && !status; i++) {
        if (y + i != r->rows)
            continue;
        const struct tia_gathered row = gathered_at(band, (size_t)i * r->sums.width);
        sums_put_gathered(bytes, &r->sums, y + i, &row);
        status = kept_write(&r->kept, bytes, length, place_of(r, y + i));
        r->rows++;
    }
    free(bytes);
    return status;
}

void resume_close(struct resume *r)
{
    kept_close(&r->kept);
}
