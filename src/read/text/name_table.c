/* name_table.c - heap sort, which needs no memory and no recursion, and binary search. */
#include "name_table.h"

static int compare_words(const struct tia_word *a, const struct tia_word *b)
{
    if (a->length != b->length)
        return a->length < b->length ? -1 : 1;
    for (uint32_t i = 0; i < a->length; i++)
        if (a->at[i] != b->at[i])
            return a->at[i] < b->at[i] ? -1 : 1;
    return 0;
}

static int compare(const struct tia_name *a, const struct tia_name *b)
{
    if (a->kind != b->kind)
        return a->kind < b->kind ? -1 : 1;
    return compare_words(&a->word, &b->word);
}

/* True if a comes before b. Equal names are ordered by their place in the text. */
static bool is_before(const struct tia_name *a, const struct tia_name *b)
{
    int order = compare(a, b);

    if (order || a->order != b->order)
        return order ? order < 0 : a->order < b->order;
    if (a->word.line != b->word.line)
        return a->word.line < b->word.line;
    return a->word.column < b->word.column;
}

/* Restores the heap, whose top is the largest name, by moving names[i] down. */
static void sink(struct tia_name *names, uint32_t i, uint32_t count)
{
    struct tia_name name = names[i];

    while (i < count / 2) { /* while it has at least one child */
        uint32_t child = 2 * i + 1;
        child += child + 1 < count && is_before(&names[child], &names[child + 1]);
        if (!is_before(&name, &names[child]))
            break;
        names[i] = names[child];
        i = child;
    }
    names[i] = name;
}

void tia_names_sort(struct tia_name *names, uint32_t count)
{
    for (uint32_t i = count / 2; i-- > 0;)
        sink(names, i, count);
    for (uint32_t last = count; last-- > 1;) {
        struct tia_name largest = names[0];
        names[0] = names[last];
        names[last] = largest;
        sink(names, 0, last);
    }
}

struct tia_name *tia_names_find(struct tia_name *names, uint32_t count, uint32_t kind, const struct tia_word *word)
{
    struct tia_name sought = {.word = *word, .kind = kind};
    uint32_t low = 0, high = count;

    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (compare(&names[middle], &sought) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && compare(&names[low], &sought) == 0 ? &names[low] : NULL;
}

const struct tia_name *tia_names_twice(const struct tia_name *names, uint32_t count)
{
    for (uint32_t i = 1; i < count; i++)
        if (compare(&names[i - 1], &names[i]) == 0)
            return &names[i];
    return NULL;
}
