#include "constants.h"

const struct tia_constant *tia_constant_find(const struct tia_constants *constants, const char *name, uint32_t length)
{
    for (uint32_t i = 0; i < constants->count; i++) {
        const struct tia_constant *c = &constants->at[i];
        uint32_t same = 0;
        while (c->length == length && same < length && c->name[same] == name[same])
            same++;
        if (c->length == length && same == length)
            return c;
    }
    return NULL;
}

bool tia_constant_named(const char *name)
{
    return *name >= 'A' && *name <= 'Z';
}

bool tia_constant_use(struct tia_text *t, const struct tia_word *word)
{
    bool negated = word->length > 1 && *word->at == '-';
    const char *name = word->at + negated;
    uint32_t length = word->length - negated;
    const struct tia_constant *constant;

    if (!t->constants || !length || !tia_constant_named(name) || t->numbers)
        return false;
    constant = tia_constant_find(t->constants, name, length);
    if (!constant || !constant->end)
        return false;
    t->numbers = constant->name + constant->length;
    t->numbers_end = constant->end;
    t->use = *word;
    t->negated = negated;
    return true;
}
