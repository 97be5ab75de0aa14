/* sha256.h - SHA-256, FIPS 180-4. */
#ifndef TOOLS_RECORD_SHA256_H
#define TOOLS_RECORD_SHA256_H

#include <stddef.h>
#include <stdint.h>

#define SHA256_BYTES 32
#define SHA256_TEXT (2 * SHA256_BYTES + 1)

struct sha256 {
    uint32_t state[8];
    uint64_t length; /* bytes so far */
    unsigned char block[64];
};

void sha256_begin(struct sha256 *sha);
void sha256_add(struct sha256 *sha, const void *bytes, size_t count);
void sha256_end(struct sha256 *sha, unsigned char hash[SHA256_BYTES]);

/* Writes a hash as 64 hexadecimal digits, in lower case. */
void sha256_print(char text[SHA256_TEXT], const unsigned char hash[SHA256_BYTES]);

/* Hashes the file `path`, which must be a regular one; *size receives its length. Returns 0; or -1 and errno. */
int sha256_file(const char *path, unsigned char hash[SHA256_BYTES], uint64_t *size);

#endif
