/* temporary.h - an unfinished file in the directory of the final one, removed however the program ends.
 *
 * Its name is .tia-HASH-N, with a hash of the final name, so that the next run with the same output finds and removes
 * the file that a killed run has left. A run holds a lock on its file, so that others do not remove it.
 */
#ifndef TOOLS_TEMPORARY_H
#define TOOLS_TEMPORARY_H

#include <sys/stat.h>

#include "signals.h"

struct temporary {
    char *name; /* name of the file; NULL: there is none */
    struct signals_cleanup cleanup;
};

/* Returns the path of the file that `name` refers to, to be freed by free(). Follows symbolic links, even to a file
 * that does not exist. Returns NULL and errno on failure. */
char *temporary_target(const char *name);

/* Creates a file in the directory of `path`, and removes those that killed runs have left for the same output.
 * `before`, if not NULL, is the file that will be replaced: the new one gets its mode and, if permitted, its owner.
 * Returns a descriptor, or -1 and errno. */
int temporary_create(struct temporary *temporary, const char *path, const struct stat *before);

/* Gives the file its final name. Returns 0; or -1 and errno, and the file must still be removed. */
int temporary_rename(struct temporary *temporary, const char *path);

/* Removes the file; does nothing if there is none. */
void temporary_remove(struct temporary *temporary);

#endif
