/* record_check.h - verifies records. */
#ifndef TOOLS_VERIFY_RECORD_CHECK_H
#define TOOLS_VERIFY_RECORD_CHECK_H

#include "common/verify/choice.h"

struct record_wish {
    struct choice_wish choice; /* all zero: all rows */
    const char *root;          /* NULL, or the root that the record must have, in hexadecimal digits */
    unsigned threads;
};

/* Draws the picture of the record `path` again, or some groups of its rows, from the files that the record names. With
 * chosen rows the path from each group to the root is printed. Returns a status of tia/checking.h. */
int record_check(const char *path, const struct record_wish *wish);

/* Compares the rows of a picture with the record, without drawing. Returns as record_check. */
int record_compare(const char *picture, const char *path, const struct record_wish *wish);

#endif
