/* define.c - names for numbers:  define RADIUS 2.5 */
#include "parse_state.h"

static int check_name(struct tia_parse *job, const struct tia_word *name)
{
    if (!tia_constant_named(name->at))
        return tia_text_error(&job->text, name, "names no number", "a name that begins with a capital letter");
    if (tia_constant_find(&job->constants, name->at, name->length))
        return tia_text_error(&job->text, name, "is already defined", "another name");
    if (job->constants.count == TIA_CONSTANTS_MAX)
        return tia_text_error(&job->text, name, "is one name too many", "at most 128");
    return TIA_OK;
}

int tia_line_define(struct tia_parse *job)
{
    struct tia_text *t = &job->text;
    struct tia_word name, word;
    int64_t value;
    int status = tia_text_name(t, &name, "a name");

    status = status ? status : check_name(job, &name);
    if (status)
        return status;
    do {
        (void)tia_text_word(t, &word);
        if (tia_decimal(&value, &word, 0) == TIA_DECIMAL_NONE)
            status = tia_text_error(t, &word, "is not a number", "numbers");
    } while (!status && tia_text_peek(t, &word));
    if (!status || t->tolerance)
        job->constants.at[job->constants.count++] = (struct tia_constant){name.at, status ? NULL : t->end, name.length};
    return status;
}
