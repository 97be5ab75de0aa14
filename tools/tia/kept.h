/* kept.h - the file in which --resume keeps what an interrupted run has finished. It is written from its beginning to
 * its end, so a run that is killed leaves a beginning of it. */
#ifndef TOOLS_TIA_KEPT_H
#define TOOLS_TIA_KEPT_H

#include <stddef.h>
#include <stdint.h>

struct kept {
    const char *path; /* NULL: there is none */
    char *why;        /* [PORT_WHY], for all that fails */
    int fd;
};

/* Opens the file, or creates it, and finds its size. No other run can use it until kept_close. `why` must outlive the
 * file. */
int kept_open(struct kept *kept, const char *path, uint64_t *size, char *why);

/* `kept` all zero does nothing. */
void kept_close(struct kept *kept);

/* What the file has at an offset; *got is less than `length` at its end. */
int kept_read(const struct kept *kept, void *bytes, size_t length, uint64_t at, size_t *got);
int kept_write(const struct kept *kept, const void *bytes, size_t length, uint64_t at);

/* Forgets what is behind that offset. */
int kept_cut(const struct kept *kept, uint64_t size);

/* Say why and return TIA_ERR_DEVICE: it cannot be read or written; or TIA_ERR_RANGE: it is of something else. */
int kept_failed(const struct kept *kept, const char *reason);
int kept_refused(const struct kept *kept, const char *reason);

#endif
