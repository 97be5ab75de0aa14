#include "nearest.h"

void tia_nearest_try_word(struct tia_nearest *nearest, const struct tia_word *candidate)
{
    const struct tia_word *word = nearest->word;
    uint32_t distance = tia_spelling_distance(word->at, (size_t)word->length, candidate->at, (size_t)candidate->length);

    if (distance > TIA_NEAR || (nearest->candidate.length && distance >= nearest->distance))
        return;
    nearest->candidate = *candidate;
    nearest->distance = distance;
}

void tia_nearest_try(struct tia_nearest *nearest, const char *candidate)
{
    struct tia_word word = {candidate, 0, 0, 0};

    while (candidate[word.length])
        word.length++;
    tia_nearest_try_word(nearest, &word);
}

/* Takes the next word of "a, b or c" from the front of `list`. Returns false at its end. */
static bool take(const char **list, struct tia_word *word)
{
    const char *at = *list;

    *word = (struct tia_word){at, 0, 0, 0};
    while (at[word->length] && at[word->length] != ',' && at[word->length] != ' ')
        word->length++;
    at += word->length;
    if (at[0] == ',' && at[1] == ' ')
        at += 2;
    else if (at[0] == ' ' && at[1] == 'o' && at[2] == 'r' && at[3] == ' ')
        at += 4;
    else
        while (*at)
            at++;
    *list = at;
    return word->length > 0;
}

int tia_text_error_of(struct tia_text *t, const struct tia_word *word, const char *what, const char *list,
                      struct tia_word *meant)
{
    struct tia_nearest nearest = {.word = word};
    struct tia_word candidate;
    const char *rest = list;

    while (take(&rest, &candidate))
        tia_nearest_try_word(&nearest, &candidate);
    (void)tia_text_error(t, word, what, nearest.candidate.length ? "" : list);
    tia_say_plain(t->error, &nearest.candidate);
    if (meant)
        *meant = nearest.candidate;
    return TIA_ERR_RANGE;
}
