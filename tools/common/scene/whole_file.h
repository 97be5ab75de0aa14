/* whole_file.h - reads a whole file into memory. */
#ifndef TOOLS_SCENE_WHOLE_FILE_H
#define TOOLS_SCENE_WHOLE_FILE_H

#include <tia/fixed.h>

struct whole {
    char *bytes; /* to be freed by free() */
    size_t length;
};

/* Reads the regular file `path` of at most `most` bytes; reading other files might block or never end. TIA_ERR_DEVICE
 * (it cannot be opened or read, or is not regular), TIA_ERR_RANGE (it is too large) or TIA_ERR_MEMORY, with *why, a
 * static string. */
int whole_read(struct whole *whole, const char *path, size_t most, const char **why);

/* Opens a file for whole_read: returns a descriptor, or -1 and errno. */
typedef int whole_opener(void *ctx, const char *path);

/* Sets the function that opens all files from now on, in a process that may not open any itself. */
void whole_open_by(whole_opener *opener, void *ctx);

/* Reads from an open descriptor of any kind, from its current position, as whole_read does. */
int whole_read_from(struct whole *whole, int fd, size_t most, const char **why);

#endif
