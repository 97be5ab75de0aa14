/* names.h - the things of a text by their names, found in logarithmic time whatever the names are.
 *
 * A pass collects them in a tia_array of struct tia_name, with tia_array_add; sorted after it, they are
 * found in later passes, in which those that define them tell their indices.
 */
#ifndef TIA_SRC_READ_NAMES_H
#define TIA_SRC_READ_NAMES_H

#include "arena.h"
#include "text.h"

struct tia_name {
    struct tia_word word;
    uint32_t kind;  /* materials, lights, ...: each kind has its own names */
    uint32_t index; /* whatever the reader wants to know */
};

/* Sorts names[0] .. names[count - 1]. */
void tia_names_sort(struct tia_name *names, uint32_t count);

/* Of sorted names the first one of that kind and word; NULL: none. */
struct tia_name *tia_names_find(struct tia_name *names, uint32_t count, uint32_t kind, const struct tia_word *word);

/* Of sorted names one that is there twice, the later one in the text; NULL: none. */
const struct tia_name *tia_names_twice(const struct tia_name *names, uint32_t count);

#endif
