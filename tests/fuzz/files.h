/* files.h - files in memory for readers that open files by name. */
#ifndef TESTS_FUZZ_FILES_H
#define TESTS_FUZZ_FILES_H

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include "bytes.h"

#define MEMORY_FILE_MOST 16384

/* A file in memory; all zero at first. Its inode is the same for each input, since readers remember the files that they
 * have read. */
struct memory_file {
    char path[32];
    int fd;
    size_t size;
    uint8_t bytes[MEMORY_FILE_MOST]; /* bytes that memory_file_save writes at once */
};

static inline void memory_file_write(struct memory_file *file, const void *bytes, size_t size)
{
    MUST(size <= MEMORY_FILE_MOST - file->size);
    memcpy(file->bytes + file->size, bytes, size);
    file->size += size;
}

/* Replaces the file's contents by the bytes that were written since the last call. */
static inline void memory_file_save(struct memory_file *file)
{
    if (!*file->path) {
        file->fd = memfd_create("fuzz", MFD_CLOEXEC);
        MUST(file->fd >= 0);
        MUST(snprintf(file->path, sizeof file->path, "/proc/self/fd/%d", file->fd) > 0);
    }
    MUST(ftruncate(file->fd, 0) == 0 && pwrite(file->fd, file->bytes, file->size, 0) == (ssize_t)file->size);
    file->size = 0;
}

#endif
