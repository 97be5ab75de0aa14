/* resume_file.h - the file of --resume, in which finished data are stored. It is written from beginning to end, so a
 * killed run leaves a file that is complete up to some byte. */
#ifndef TOOLS_TIA_RESUME_FILE_H
#define TOOLS_TIA_RESUME_FILE_H

#include <stddef.h>
#include <stdint.h>

struct kept {
    const char *path; /* path of the file; NULL: no file */
    char *why;        /* receives the reason for any failure, [PORT_WHY] */
    int fd;
};

/* Opens the file, or creates it, and locks it until kept_close; *size receives its size. `why` must outlive the
 * file. */
int kept_open(struct kept *kept, const char *path, uint64_t *size, char *why);

/* Closes the file; does nothing if `kept` is all zero. */
void kept_close(struct kept *kept);

/* Reads the file at an offset. *got receives the number of bytes read, less than `length` only at the end of the
 * file. */
int kept_read(const struct kept *kept, void *bytes, size_t length, uint64_t at, size_t *got);
int kept_write(const struct kept *kept, const void *bytes, size_t length, uint64_t at);

/* Cuts the file off after `size` bytes. */
int kept_cut(const struct kept *kept, uint64_t size);

/* Stores the reason and returns TIA_ERR_DEVICE: the file cannot be read or written. */
int kept_failed(const struct kept *kept, const char *reason);
/* Stores the reason and returns TIA_ERR_RANGE: the file belongs to another drawing. */
int kept_refused(const struct kept *kept, const char *reason);

#endif
