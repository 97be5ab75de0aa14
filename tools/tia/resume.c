#include "resume.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ports.h"

static int failed(const struct resume *r, const char *reason, char *why)
{
    (void)snprintf(why, PORT_WHY, "%.150s: %s", r->path, reason);
    return TIA_ERR_DEVICE;
}

static int refused(const struct resume *r, const char *reason, char *why)
{
    (void)failed(r, reason, why);
    return TIA_ERR_RANGE;
}

static off_t place_of(const struct resume *r, unsigned y)
{
    return (off_t)(r->header + y * sums_row_bytes(&r->sums));
}

static int write_all(const struct resume *r, const void *bytes, size_t length, off_t at, char *why)
{
    for (size_t done = 0; done < length;) {
        ssize_t wrote = pwrite(r->fd, (const char *)bytes + done, length - done, at + (off_t)done);
        if (wrote < 0 && errno == EINTR)
            continue;
        if (wrote < 0)
            return failed(r, strerror(errno), why);
        done += (size_t)wrote;
    }
    return TIA_OK;
}

/* A new file, or what is in an old one. A row that was being written is drawn again. */
static int read_header(struct resume *r, off_t size, char *why)
{
    char text[SUMS_HEADER], wanted[SUMS_HEADER];
    ssize_t got = pread(r->fd, text, sizeof text, 0);
    struct sums old;

    r->header = sums_print(wanted, &r->sums);
    if (got < 0)
        return failed(r, strerror(errno), why);
    if (got == 0)
        return write_all(r, wanted, r->header, 0, why);
    if (!sums_parse(&old, text, (size_t)got))
        return refused(r, "no part that an interrupted run has left", why);
    if (old.crc != r->sums.crc || old.width != r->sums.width || old.height != r->sums.height)
        return refused(r, "a part of another scene, size or integrator", why);
    if (old.first != r->sums.first || old.count != r->sums.count)
        return refused(r, "has other samples (--spp, --samples-range)", why);
    r->header = sums_print(wanted, &old); /* its tone and exposure do not matter */
    uint64_t rows = ((uint64_t)size - r->header) / sums_row_bytes(&r->sums);
    r->rows = rows < r->sums.height ? (unsigned)rows : r->sums.height;
    return TIA_OK;
}

int resume_open(struct resume *r, const char *path, const struct sums *sums, char *why)
{
    struct stat status;

    *r = (struct resume){.path = path, .sums = *sums};
    r->fd = open(path, O_RDWR | O_CREAT | O_NONBLOCK | O_CLOEXEC | O_NOCTTY, 0666);
    if (r->fd < 0 || fstat(r->fd, &status) != 0)
        return failed(r, strerror(errno), why);
    if (!S_ISREG(status.st_mode))
        return failed(r, "not a regular file", why);
    return read_header(r, status.st_size, why);
}

int resume_read(const struct resume *r, unsigned y, unsigned rows, struct tia_sum *band, char *why)
{
    size_t length = sums_row_bytes(&r->sums);
    unsigned char *bytes = malloc(length);
    int status = bytes ? TIA_OK : TIA_ERR_MEMORY;

    memset(band, 0, (size_t)rows * r->sums.width * sizeof *band);
    for (unsigned i = 0; i < rows && !status; i++)
        if (pread(r->fd, bytes, length, place_of(r, y + i)) != (ssize_t)length)
            status = failed(r, "cannot be read", why);
        else if (!sums_add_row(band + (size_t)i * r->sums.width, &r->sums, y + i, bytes))
            status = refused(r, "is damaged", why);
    free(bytes);
    return status;
}

int resume_append(struct resume *r, unsigned y, unsigned rows, const struct tia_sum *band, char *why)
{
    size_t length = sums_row_bytes(&r->sums);
    unsigned char *bytes = r->path ? malloc(length) : NULL;
    int status = bytes || !r->path ? TIA_OK : TIA_ERR_MEMORY;

    for (unsigned i = 0; r->path && i < rows && !status; i++) {
        if (y + i != r->rows)
            continue;
        sums_put_row(bytes, &r->sums, y + i, band + (size_t)i * r->sums.width);
        status = write_all(r, bytes, length, place_of(r, y + i), why);
        r->rows++;
    }
    free(bytes);
    return status;
}

void resume_close(struct resume *r)
{
    if (r->path && r->fd >= 0)
        (void)close(r->fd);
}
