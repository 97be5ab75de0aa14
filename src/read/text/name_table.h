/* name_table.h - lookup of names in logarithmic time, even in hostile texts: no hash, so no collisions to provoke.
 *
 * One pass collects the names in a tia_array of struct tia_name. They are then sorted, so that later passes can find
 * them. The reader stores with each name the index of the object that it names.
 */
#ifndef TIA_READ_TEXT_NAME_TABLE_H
#define TIA_READ_TEXT_NAME_TABLE_H

#include "arena.h"
#include "text_lines.h"

struct tia_name {
    struct tia_word word;
    uint32_t kind;  /* material, light, ...: each kind has its own name space */
    uint32_t index; /* for the reader's use */
    uint32_t order; /* number of earlier names, if names come from several files; else 0 */
};

/* Sorts names[0] .. names[count - 1]. */
void tia_names_sort(struct tia_name *names, uint32_t count);

/* Finds the first of the sorted names with that kind and word; NULL if there is none. */
struct tia_name *tia_names_find(struct tia_name *names, uint32_t count, uint32_t kind, const struct tia_word *word);

/* Finds a duplicate among the sorted names, and returns its later occurrence in the text; NULL if there is none. */
const struct tia_name *tia_names_twice(const struct tia_name *names, uint32_t count);

#endif
