/* temporary.h - the unfinished file beside the one that it will become, removed however the program ends.
 *
 * Its name is .tia-HASH-N, HASH of the final name: so the next run for the same name finds what a killed run has left,
 * and removes it. Whoever writes such a file holds a lock on it, so that no other run takes it for left behind.
 */
#ifndef TOOLS_TEMPORARY_H
#define TOOLS_TEMPORARY_H

#include <sys/stat.h>

#include "signals.h"

struct temporary {
    char *name; /* NULL: there is none */
    struct signals_cleanup cleanup;
};

/* The file that `name` stands for: symbolic links are followed, also to a file that is not there. NULL and errno. */
char *temporary_target(const char *name);

/* Creates a file beside `path`, and removes those that are left there. If `before` is not NULL, it is the file that
 * will be replaced: the new one gets its mode and, where that is allowed, its owner. A descriptor, or -1 and errno. */
int temporary_create(struct temporary *temporary, const char *path, const struct stat *before);

/* Gives it its final name. 0, or -1 and errno: it is still there. */
int temporary_rename(struct temporary *temporary, const char *path);

/* Does nothing where there is none. */
void temporary_remove(struct temporary *temporary);

#endif
