/* checking.h - draws rows of a picture, a film or a part again and compares them with the file: tia-verify, and
 * tia-join
 * --verify. */
#ifndef TOOLS_TIA_CHECKING_H
#define TOOLS_TIA_CHECKING_H

#include "common/verify/choice.h"
#include "options.h"

/* The exit statuses: as drawn; it differs; it cannot be read, drawn or compared, after an error message. */
enum { CHECK_SAME, CHECK_DIFFERS, CHECK_FAILED };

/* Verifies the file `path`, which was drawn with `options` as they were parsed (command_parse), of the scenes argv.
 * Prints what was looked at and what differs to standard output. `from` names in messages who drew it; "": nobody is
 * named. */
int checking_picture(const struct options *options, int argc, char **argv, const char *path,
                     const struct choice_wish *wish, const char *from);

#endif
