/* finished.h - finished rows in RGB565 in a file that grows while a picture or film is drawn, so that an interrupted
 * run loses little. The file is a sequence of parts, each with its own first line and checksum, see
 * common/image/part.h. When the file is complete, tia-join reads it like any other part. */
#ifndef TOOLS_TIA_FINISHED_H
#define TOOLS_TIA_FINISHED_H

#include <stdbool.h>

#include "common/image/film.h"
#include "resume_file.h"

struct finished_rows;

/* A file of finished rows; all zero: no file. */
struct finished {
    struct kept kept;
    struct image_film film;     /* the film being drawn */
    struct finished_rows *rows; /* rows that were in the file when it was opened, sorted by frame and row */
    size_t count, capacity;
    uint64_t end; /* end of the last complete part */
};

/* Opens the file, or creates it. An incomplete part, left by a killed run, is cut off. TIA_ERR_RANGE, with the reason
 * in `why`: the file is damaged, or belongs to another scene, size or film. The other functions use `why`, too. */
int finished_open(struct finished *finished, const char *path, const struct image_film *film, char *why);
void finished_close(struct finished *finished);

/* True if the file had all these rows when it was opened. */
bool finished_has(const struct finished *finished, uint32_t frame, unsigned y, unsigned rows);

/* Reads rows that the file had when it was opened. */
int finished_read(struct finished *finished, uint32_t frame, unsigned y, unsigned rows, tia_rgb565 *pixels);

/* Appends those of the rows that the file did not have when it was opened; does nothing without a file. */
int finished_append(struct finished *finished, uint32_t frame, unsigned y, unsigned rows, const tia_rgb565 *pixels);

#endif
