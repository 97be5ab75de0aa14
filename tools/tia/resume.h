/* resume.h - a file of finished rows of samples that grows while a picture is drawn, so that an interrupted run loses
 * little: see common/image/sums.h. finished.h does the same for pictures in RGB565. */
#ifndef TOOLS_TIA_RESUME_H
#define TOOLS_TIA_RESUME_H

#include "common/image/sums.h"
#include "resume_file.h"

/* A file of finished rows; all zero: no file. */
struct resume {
    struct kept kept;
    struct sums sums;
    size_t header;
    unsigned rows; /* number of rows in the file, from the top */
};

/* Opens the file, or creates it. TIA_ERR_RANGE, with the reason in `why`: the file belongs to another scene, or to
 * other samples. The other functions use `why`, too. */
int resume_open(struct resume *resume, const char *path, const struct sums *sums, char *why);

/* Reads rows that are in the file. */
int resume_read(const struct resume *resume, unsigned y, unsigned rows, const struct tia_gathered *band);
/* Appends those of the rows that directly follow the rows in the file. */
int resume_append(struct resume *resume, unsigned y, unsigned rows, const struct tia_gathered *band);

void resume_close(struct resume *resume);

#endif
