/* verify_parts.h - --verify: draws rows of parts again before they are joined. */
#ifndef TIA_JOIN_VERIFY_PARTS_H
#define TIA_JOIN_VERIFY_PARTS_H

#include <stdbool.h>

#include "common/verify/choice.h"

struct verify_wish {
    bool asked;
    struct choice_wish choice;
    int argc; /* what follows --: the scene and the options of tia, behind a name for the command; 0: nothing */
    char **argv;
};

/* If an argument before -- is --verify, removes what follows -- from the arguments, and keeps it in `wish`. */
void verify_split(struct verify_wish *wish, int *argc, char **argv);

/* Verifies the parts if that is asked for. Prints a line for each that differs, with the node that drew it if a file
 * PART.node names that. Returns 0; or -1 after messages. */
int verify_parts(const struct verify_wish *wish, char *const *parts, int count);

#endif
