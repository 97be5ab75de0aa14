/* name_table.h - lookup of names in logarithmic time, even in hostile texts: no hash, so no collisions to provoke.
 *
 * One pass collects the names in a tia_array of struct tia_name. They are then sorted, so that later passes can
 * find them; a definition sets the index of its name.
 */
#ifndef TIA_READ_TEXT_NAME_TABLE_H
#define TIA_READ_TEXT_NAME_TABLE_H

#include "arena.h"
#include "text_lines.h"

struct tia_name {
    struct tia_word word;
    uint32_t kind;  /* material, light, ...: each kind has its own name space */
    uint32_t index; /* for the reader's use */
    uint32_t order; /* number of earlier names, where they come from several files; else 0 */
};

/* Sorts names[0] .. names[count - 1]. */
void tia_names_sort(struct tia_name *names, uint32_t count);

/* Finds the first of that kind and word among sorted names; NULL: none. */
struct tia_name *tia_names_find(struct tia_name *names, uint32_t count, uint32_t kind, const struct tia_word *word);

/* Finds a name defined twice among sorted names, the later one in the text; NULL: none. */
const struct tia_name *tia_names_twice(const struct tia_name *names, uint32_t count);

#endif
