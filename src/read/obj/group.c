/* group.c - o and g lines. The faces that follow lines of the same name, anywhere in the file, form a group, which
 * filters a shadow ray only once. */
#include "obj.h"

/* Reads the rest of the line, which may be long or empty. */
static void take_name(struct tia_text *t, struct tia_word *name)
{
    struct tia_word word;

    (void)tia_text_word(t, name);
    while (tia_text_word(t, &word))
        name->length = (uint32_t)(word.at - name->at) + word.length;
}

static int read_line(struct obj *o, enum obj_name kind)
{
    struct tia_name *lines = (struct tia_name *)(void *)o->group_lines.items, name = {.kind = kind};

    take_name(&o->text, &name.word);
    if (o->pass != OBJ_FILL)
        tia_array_add(&o->group_lines, &name);
    else if (lines)
        o->face_group =
            (uint32_t)(tia_names_find(lines, o->group_lines.capacity, (uint32_t)kind, &name.word) - lines) + 1;
    return TIA_OK;
}

int tia_obj_o(struct obj *o)
{
    return read_line(o, OBJ_OBJECT);
}

int tia_obj_g(struct obj *o)
{
    return read_line(o, OBJ_GROUP);
}
