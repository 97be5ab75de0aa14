#include "merkle.h"

#include <string.h>

void merkle_node(unsigned char node[SHA256_BYTES], const unsigned char left[SHA256_BYTES],
                 const unsigned char right[SHA256_BYTES])
{
    struct sha256 sha;

    sha256_begin(&sha);
    sha256_add(&sha, &(unsigned char){1}, 1);
    sha256_add(&sha, left, SHA256_BYTES);
    sha256_add(&sha, right, SHA256_BYTES);
    sha256_end(&sha, node);
}

/* A complete subtree: the hash over 2^level leaves. */
struct subtree {
    unsigned level;
    bool on_path; /* it has the leaf whose path is sought */
    unsigned char hash[SHA256_BYTES];
};

/* Subtrees of falling levels, as RFC 6962 divides any number of leaves. */
struct forest {
    struct subtree trees[MERKLE_DEEPEST];
    unsigned count;
    struct merkle_step *path;
    unsigned length;
};

static void add_step(struct forest *f, const struct subtree *beside, bool left)
{
    struct merkle_step *step = &f->path[f->length++];

    step->left = left;
    memcpy(step->hash, beside->hash, SHA256_BYTES);
}

/* Replaces the last two subtrees by the node above them. */
static void merge(struct forest *f)
{
    struct subtree *left = &f->trees[f->count - 2], *right = &f->trees[f->count - 1];

    if (left->on_path)
        add_step(f, right, false);
    else if (right->on_path)
        add_step(f, left, true);
    merkle_node(left->hash, left->hash, right->hash);
    left->on_path = left->on_path || right->on_path;
    left->level++;
    f->count--;
}

unsigned merkle_path(unsigned char root[SHA256_BYTES], struct merkle_step path[MERKLE_DEEPEST], merkle_leaf *leaf,
                     const void *leaves, size_t count, size_t index)
{
    struct forest f = {.path = path};

    for (size_t i = 0; i < count; i++) {
        struct subtree *last = &f.trees[f.count++];
        *last = (struct subtree){.on_path = i == index};
        memcpy(last->hash, leaf(leaves, i), SHA256_BYTES);
        while (f.count > 1 && f.trees[f.count - 2].level == f.trees[f.count - 1].level)
            merge(&f);
    }
    while (f.count > 1)
        merge(&f);
    memcpy(root, f.trees[0].hash, SHA256_BYTES);
    return f.length;
}
