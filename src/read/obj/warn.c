/* warn.c - tolerated mistakes. */
#include "obj.h"

/* The remedy for each kind of mistake, and the only pass that reports it, so that each mistake is counted once. */
static const struct {
    const char *remedy;
    enum obj_pass pass;
} warnings[TIA_WARNINGS] = {
    [TIA_WARN_STATEMENT] = {"skipped", OBJ_COUNT},
    [TIA_WARN_LIBRARY] = {"its materials are grey", OBJ_COUNT},
    [TIA_WARN_MATERIAL] = {"grey is used", OBJ_MEASURE},
    [TIA_WARN_IMAGE] = {"left out", OBJ_FILL},
    [TIA_WARN_OPTION] = {"ignored", OBJ_COUNT},
    [TIA_WARN_RANGE] = {"the nearest is used", OBJ_COUNT},
    [TIA_WARN_OPACITY] = {"drawn opaque", OBJ_COUNT},
    [TIA_WARN_NUMBER] = {"0 is used", OBJ_COUNT},
    [TIA_WARN_NORMAL] = {"faces that use it are drawn flat", OBJ_COUNT},
    [TIA_WARN_CORNER] = {"the face is drawn without", OBJ_COUNT},
    [TIA_WARN_FACE] = {"the face is left out", OBJ_COUNT},
};

int tia_obj_forgive(struct obj *o, enum tia_read_warning_kind kind)
{
    return tia_model_forgive(o->reader, kind, warnings[kind].remedy, o->pass == warnings[kind].pass);
}

void tia_obj_skip(struct tia_text *t)
{
    struct tia_word word;

    while (tia_text_word(t, &word)) {
    }
}

int tia_obj_unreadable(struct obj *o, struct tia_text *t, const struct tia_word *word, int status, const char *why,
                       enum tia_read_warning_kind kind)
{
    (void)tia_text_error_at(t, word);
    tia_say_word(t->error, word);
    tia_say(t->error, " cannot be read: ");
    tia_say(t->error, why);
    tia_say(t->error, kind == TIA_WARN_LIBRARY ? ", expected a material library" : ", expected an image");
    return status == TIA_ERR_MEMORY ? TIA_ERR_RANGE : tia_obj_forgive(o, kind);
}
