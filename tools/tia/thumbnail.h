/* thumbnail.h - a small picture of any scene or model within a second or a few, also of files that nobody trusts.
 *
 * A process of its own reads and draws the scene: see confine.h for what it may do, file_door.h for what it may read.
 * It writes each picture that it completes, coarse ones first, to memory that both processes share. This process waits
 * for the last one or for the end of the time, ends the other process, and writes the file. */
#ifndef TOOLS_TIA_THUMBNAIL_H
#define TOOLS_TIA_THUMBNAIL_H

#include "options.h"

/* Draws options->output. Returns the exit status, after an error message if it is not 0. */
int thumbnail(struct options *options);

#endif
