/* record_file.h - reads a record, and checks the files that it names. */
#ifndef TOOLS_VERIFY_RECORD_FILE_H
#define TOOLS_VERIFY_RECORD_FILE_H

#include "common/record/record.h"

struct record_place {
    const char *path;
    char *given;  /* folder of the record, as given */
    char *folder; /* folder of the record, resolved */
    char **real;  /* resolved paths of its files, as many as record.file_count */
    struct record record;
};

/* True if the file begins as a record does. */
bool record_file_is(const char *path);

/* Reads the record `path`, which must be of this tia's version and definition. Returns a status of checking.h; if it is
 * not 0, after a message. record_file_close is to be called in any case. */
int record_file_open(struct record_place *place, const char *path);
void record_file_close(struct record_place *place);

/* Checks that the files that it names are in its folder, and the same. Returns as record_file_open. */
int record_file_inputs(struct record_place *place);

/* True if the path is one of these files, or does not exist. `place`: a struct record_place, for scene_wish.opens. */
bool record_file_allows(void *place, const char *path);

#endif
