/* inputs.h - the files that this process has read, so that no output replaces one of them. */
#ifndef TOOLS_INPUTS_H
#define TOOLS_INPUTS_H

#include <stdbool.h>
#include <sys/stat.h>

/* Adds a file by its device and inode, so that all its links count as the same file. Does nothing if memory is
 * short. */
void inputs_add(const struct stat *status);

/* True for a file that was added. */
bool inputs_have(const struct stat *status);

#endif
