/* merkle.h - the hash tree of RFC 6962, section 2.1. */
#ifndef TOOLS_RECORD_MERKLE_H
#define TOOLS_RECORD_MERKLE_H

#include <stdbool.h>

#include "sha256.h"

#define MERKLE_DEEPEST 64

/* A hash beside the path from a leaf to the root. */
struct merkle_step {
    bool left; /* it is the left one of the two */
    unsigned char hash[SHA256_BYTES];
};

/* Gives hash number `index` of the leaves. */
typedef const unsigned char *merkle_leaf(const void *leaves, size_t index);

/* Computes the hash of a node above two others: SHA-256 of 1, left and right. */
void merkle_node(unsigned char node[SHA256_BYTES], const unsigned char left[SHA256_BYTES],
                 const unsigned char right[SHA256_BYTES]);

/* Computes the root over `count` leaves, 1 or more, and the path of leaf `index`, from the leaf upwards. Returns the
 * length of the path. */
unsigned merkle_path(unsigned char root[SHA256_BYTES], struct merkle_step path[MERKLE_DEEPEST], merkle_leaf *leaf,
                     const void *leaves, size_t count, size_t index);

#endif
