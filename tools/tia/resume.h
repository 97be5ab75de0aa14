/* resume.h - a file of finished rows that grows as a picture is drawn, so that an interrupted run loses little: see
 * common/image/sums.h. */
#ifndef TOOLS_TIA_RESUME_H
#define TOOLS_TIA_RESUME_H

#include "common/image/sums.h"

/* All zero: there is none. */
struct resume {
    const char *path; /* NULL: none */
    struct sums sums;
    size_t header;
    unsigned rows; /* in the file, from the top */
    int fd;
};

/* Opens the file, or creates it. TIA_ERR_RANGE, with the reason in `why`: it is of another scene, or of other samples.
 */
int resume_open(struct resume *resume, const char *path, const struct sums *sums, char *why);

/* Reads rows that are in the file; appends those that are not, if they are the next ones. */
int resume_read(const struct resume *resume, unsigned y, unsigned rows, struct tia_sum *band, char *why);
int resume_append(struct resume *resume, unsigned y, unsigned rows, const struct tia_sum *band, char *why);

void resume_close(struct resume *resume);

#endif
