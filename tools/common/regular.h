/* regular.h - regular files. Others could block, or have their bytes only once. */
#ifndef TOOLS_COMMON_REGULAR_H
#define TOOLS_COMMON_REGULAR_H

#include <stddef.h>
#include <stdint.h>
#include <sys/stat.h>

/* Opens a regular file to read it. Returns -1 with errno on failure; EINVAL if it is not regular. */
int regular_open(const char *path, struct stat *status);

/* Reads `count` bytes at an offset. Returns 0; -1 with errno on failure, 0 if the file ends before. */
int regular_read(int fd, void *bytes, size_t count, uint64_t offset);

/* Returns the reason of errno after a failure of these functions: a static string. */
const char *regular_reason(void);

#endif
