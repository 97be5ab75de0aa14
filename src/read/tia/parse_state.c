/* parse_state.c - the arrays and names of a .tia file. */
#include "parse_state.h"
#include "read/text/nearest.h"

uint32_t tia_parse_count(const struct tia_parse *job, enum tia_parse_array array)
{
    return job->arrays[array].count;
}

uint32_t tia_parse_add(struct tia_parse *job, enum tia_parse_array array, const void *item)
{
    uint32_t index = job->arrays[array].count;

    tia_array_add(&job->arrays[array], item);
    return index;
}

const void *tia_parse_at(const struct tia_parse *job, enum tia_parse_array array, uint32_t index)
{
    const struct tia_array *a = &job->arrays[array];
    return a->items ? a->items + index * a->item : NULL;
}

/* Finds a name in an array of names, which is sorted before the last pass. */
static struct tia_name *find(const struct tia_parse *job, enum tia_parse_array array, enum tia_kind_of_name kind,
                             const struct tia_word *name)
{
    const struct tia_array *names = &job->arrays[array];

    if (job->pass != TIA_FILLING || !names->items)
        return NULL;
    return tia_names_find((struct tia_name *)(void *)names->items, names->count, kind, name);
}

/* True if a name is defined in an earlier place. Known in the last pass. */
static bool is_taken(const struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name)
{
    const struct tia_name *first = find(job, TIA_OF_NAMES, kind, name);

    return first && first->word.at != name->at;
}

void tia_parse_name(struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name, uint32_t index)
{
    if (job->mistakes && kind != TIA_NAMED_FAULTY && is_taken(job, kind, name)) {
        (void)tia_text_error(&job->text, name, "is already defined", "another name");
        (void)tia_text_goes_on(&job->text);
    }
    struct tia_name entry = {*name, kind, index, tia_parse_count(job, TIA_OF_NAMES)};

    if (job->pass != TIA_FILLING)
        (void)tia_parse_add(job, TIA_OF_NAMES, &entry);
}

int tia_parse_define(struct tia_parse *job, enum tia_kind_of_name kind, uint32_t index)
{
    struct tia_word name;
    int status = tia_text_name(&job->text, &name, "a name");

    if (!status)
        tia_parse_name(job, kind, &name, index);
    return status;
}

int tia_parse_find(struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name, const char *expected,
                   uint32_t *index)
{
    const struct tia_name *found = find(job, TIA_OF_NAMES, kind, name);

    *index = found ? found->index : 0;
    return !found && job->pass == TIA_FILLING ? tia_parse_undefined(job, kind, name, expected) : TIA_OK;
}

bool tia_parse_has(const struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name)
{
    return find(job, TIA_OF_NAMES, kind, name);
}

int tia_parse_undefined(struct tia_parse *job, enum tia_kind_of_name kind, const struct tia_word *name,
                        const char *expected)
{
    struct tia_nearest nearest = {.word = name};
    const struct tia_name *names = tia_parse_at(job, TIA_OF_NAMES, 0);

    if (job->mistakes && (job->mistakes->lost || tia_parse_has(job, TIA_NAMED_FAULTY, name)))
        job->mistakes->follows = true;
    for (uint32_t i = 0; names && !(job->mistakes && job->mistakes->follows) && i < tia_parse_count(job, TIA_OF_NAMES);
         i++)
        if (names[i].kind == (uint32_t)kind)
            tia_nearest_try_word(&nearest, &names[i].word);
    (void)tia_text_error(&job->text, name, "is not defined", nearest.candidate.length ? "'" : expected);
    tia_say_plain(job->text.error, &nearest.candidate);
    tia_say(job->text.error, nearest.candidate.length ? "'" : "");
    return TIA_ERR_RANGE;
}

void tia_parse_animate(struct tia_parse *job, const struct tia_word *name)
{
    struct tia_name entry = {.word = *name, .kind = TIA_NAMED_MOVER};

    if (job->pass != TIA_FILLING)
        (void)tia_parse_add(job, TIA_OF_ANIMATED, &entry);
}

bool tia_parse_moves(const struct tia_parse *job, const struct tia_word *name)
{
    return find(job, TIA_OF_ANIMATED, TIA_NAMED_MOVER, name);
}

struct tia_name *tia_parse_mover(const struct tia_parse *job, const struct tia_word *name)
{
    return find(job, TIA_OF_NAMES, TIA_NAMED_MOVER, name);
}
