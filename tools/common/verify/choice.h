/* choice.h - which rows of a picture are drawn again to verify it. */
#ifndef TOOLS_VERIFY_CHOICE_H
#define TOOLS_VERIFY_CHOICE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/command_line.h"

/* What is asked for; all zero: a random share of 1 %. */
struct choice_wish {
    uint32_t share; /* parts of a million; 0: not given */
    uint32_t count; /* number of random rows; 0: not given */
    bool all, has_rows, seeded;
    uint32_t first_row, last_row; /* with has_rows: exactly these rows, of each frame */
    uint64_t seed;                /* with `seeded`: else it is random */
};

/* True if any of it is given. */
static inline bool choice_given(const struct choice_wish *wish)
{
    return wish->share || wish->count || wish->all || wish->has_rows || wish->seeded;
}

/* The options for it, for tables of options in a struct of type `type` with a member `wish`. */
#define CHOICE_ROWS(type, wish)                                                                                        \
    {"share",                                                                                                          \
     0,                                                                                                                \
     OPTION_PARSED,                                                                                                    \
     "PERCENT",                                                                                                        \
     "draw this random share of the rows again (default 1%)",                                                          \
     OPTION_TO(type, wish.share),                                                                                      \
     .parse = choice_parse_share,                                                                                      \
     .rule = "not a share above 0 % and up to 100 %, of at most 4 decimals (1%)"},                                     \
        {"count",                                                                                                      \
         0,                                                                                                            \
         OPTION_NUMBER,                                                                                                \
         "N",                                                                                                          \
         "draw this number of random rows again",                                                                      \
         OPTION_TO(type, wish.count),                                                                                  \
         .min = 1,                                                                                                     \
         .max = UINT32_MAX},                                                                                           \
        {"rows",                                                                                                       \
         0,                                                                                                            \
         OPTION_RANGE,                                                                                                 \
         "FIRST-LAST",                                                                                                 \
         "draw exactly these rows again, of each frame, counted from 0",                                               \
         OPTION_PAIR(type, wish.first_row, wish.last_row),                                                             \
         .given = offsetof(type, wish.has_rows),                                                                       \
         .max = UINT32_MAX - 1},                                                                                       \
        {"all", 0, OPTION_FLAG, NULL, "draw all rows again", OPTION_TO(type, wish.all)},                               \
    {                                                                                                                  \
        "seed", 0, OPTION_NUMBER, "N", "choose the rows by this number, as a report names it; default a random one",   \
            OPTION_TO(type, wish.seed), .given = offsetof(type, wish.seeded), .max = UINT64_MAX                        \
    }

/* Parses "1%", "0.5 %" or "2.5", for `parse` of an option. */
const char *choice_parse_share(void *share, char *text);

/* Returns NULL, or why the wish contradicts itself. */
const char *choice_check(const struct choice_wish *wish);

/* The chosen rows: each a key, in ascending order. */
struct choice {
    uint64_t *keys;
    uint64_t total, count; /* rows in all, and chosen ones */
    uint64_t seed;
    bool random;
};

static inline uint64_t choice_key(uint32_t frame, unsigned y)
{
    return (uint64_t)frame << 32 | y;
}

/* Gives the frame and row of row number `index`. */
typedef void choice_place(const void *rows, uint64_t index, uint32_t *frame, unsigned *y);

/* Chooses of `total` rows, whose places `place` gives. Returns 0; -1 without memory. A choice can have no row. */
int choice_make(struct choice *choice, const struct choice_wish *wish, uint64_t total, choice_place *place,
                const void *rows);
void choice_free(struct choice *choice);

/* True if the row was chosen. */
bool choice_has(const struct choice *choice, uint32_t frame, unsigned y);

/* Returns the chance that none of the chosen rows is among the forged ones, if the share `forged` of all is forged:
 * (1 - forged)^count, and 0 if all rows were chosen. Random rows are all different, so the chance is not above it. */
double choice_unseen(const struct choice *choice, double forged);

#endif
