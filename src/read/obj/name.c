/* name.c - names in .obj and .mtl files. */
#include "obj.h"

int tia_obj_name(struct tia_text *t, struct tia_word *name, const char *expected)
{
    struct tia_word word;
    int status = tia_text_file(t, name, expected);

    while (!status && tia_text_word(t, &word)) {
        if (word.line != name->line)
            return tia_text_error(t, &word, "is on another line", expected);
        name->length = (uint32_t)(word.at - name->at) + word.length;
        if (name->length > TIA_NAME_MAX)
            return tia_text_error(t, name, "is longer than 255 bytes", expected);
    }
    return status;
}
