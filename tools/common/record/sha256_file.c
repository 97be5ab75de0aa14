/* sha256_file.c - the SHA-256 of a file. */
#include <errno.h>
#include <unistd.h>

#include "common/regular.h"
#include "sha256.h"

static int add_file(int fd, unsigned char hash[SHA256_BYTES], uint64_t *size)
{
    unsigned char bytes[1 << 14];
    struct sha256 sha;

    sha256_begin(&sha);
    for (ssize_t got = 1; got > 0;) {
        got = read(fd, bytes, sizeof bytes);
        if (got < 0 && errno != EINTR)
            return -1;
        sha256_add(&sha, bytes, got > 0 ? (size_t)got : 0);
        got = got < 0 ? 1 : got;
    }
    *size = sha.length;
    sha256_end(&sha, hash);
    return 0;
}

int sha256_file(const char *path, unsigned char hash[SHA256_BYTES], uint64_t *size)
{
    struct stat status;
    int fd = regular_open(path, &status), result = fd < 0 ? -1 : add_file(fd, hash, size);

    if (fd >= 0)
        (void)close(fd);
    return result;
}
