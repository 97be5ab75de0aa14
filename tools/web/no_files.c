/* no_files.c - stubs for the system calls that wasi-libc needs to write to a stream. Only printing a long double would
 * call them, and the module never does. With the stubs it imports nothing but the functions of port/web/web.c. */
#include <stdint.h>

enum { BAD_DESCRIPTOR = 8 }; /* __WASI_ERRNO_BADF */

int32_t __imported_wasi_snapshot_preview1_fd_close(int32_t fd);
int32_t __imported_wasi_snapshot_preview1_fd_close(int32_t fd)
{
    (void)fd;
    return BAD_DESCRIPTOR;
}

int32_t __imported_wasi_snapshot_preview1_fd_seek(int32_t fd, int64_t by, int32_t whence, int32_t at);
int32_t __imported_wasi_snapshot_preview1_fd_seek(int32_t fd, int64_t by, int32_t whence, int32_t at)
{
    (void)fd;
    (void)by;
    (void)whence;
    (void)at;
    return BAD_DESCRIPTOR;
}

int32_t __imported_wasi_snapshot_preview1_fd_write(int32_t fd, int32_t parts, int32_t count, int32_t written);
int32_t __imported_wasi_snapshot_preview1_fd_write(int32_t fd, int32_t parts, int32_t count, int32_t written)
{
    (void)fd;
    (void)parts;
    (void)count;
    (void)written;
    return BAD_DESCRIPTOR;
}
