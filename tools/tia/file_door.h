/* file_door.h - files for a confined process, which cannot open any: it asks the process that made it, by a socket, and
 * gets descriptors for reading.
 *
 * It gets the model, and regular files in the model's folder and in folders below it. Names that begin at the root or
 * contain "..", and names that lead over symbolic links, are refused with EACCES, and the file after the first 4096
 * with EMFILE. */
#ifndef TOOLS_TIA_FILE_DOOR_H
#define TOOLS_TIA_FILE_DOOR_H

#include <stdbool.h>

/* ---- in the process that opens files ---- */

struct file_door {
    int socket;        /* its end of the socket */
    const char *model; /* path of the model */
    unsigned served;   /* files opened so far */
};

/* Answers the next question. Returns false once the other end is closed. */
bool file_door_serve(struct file_door *door);

/* ---- in the confined process ---- */

/* Asks for the file `path` on the socket to which `ctx`, an int, points. Returns a descriptor; -1, and errno, if there
 * is none. A whole_opener, see common/scene/whole_file.h. */
int file_door_open(void *ctx, const char *path);

#endif
