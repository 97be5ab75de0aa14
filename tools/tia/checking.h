/* checking.h - draws rows of a picture, a film or a part again and compares them with the file: tia-verify, and
 * tia-join
 * --verify. */
#ifndef TOOLS_TIA_CHECKING_H
#define TOOLS_TIA_CHECKING_H

#include <stdio.h>

#include "common/verify/choice.h"
#include "options.h"

/* The exit statuses: as drawn; it differs; it cannot be read, drawn or compared, after an error message. */
enum { CHECK_SAME, CHECK_DIFFERS, CHECK_FAILED };

/* What is to be verified, and how it is reported. */
struct checking_wish {
    struct choice_wish choice;
    FILE *out;
    const char *before; /* begins each line of the report */
    const char *from;   /* ends lines that name a forged file: ", drawn by NODE"; "": not known */
    bool quiet;         /* only what differs is reported */
    uint64_t seen;      /* increases by the rows that were drawn again */
};

/* Verifies the file `path`, which was drawn with `options` as they were parsed (command_parse), of the scenes argv. */
int checking_picture(const struct options *options, int argc, char **argv, const char *path,
                     struct checking_wish *wish);

#endif
