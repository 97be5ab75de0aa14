/* material.c - usemtl and mtllib: the materials that a model uses, and their libraries. */
#include "obj.h"

/* Reads the rest of the line as a name; it may be empty, since some programs leave out the name of a material. */
static int read_name(struct obj *o, struct tia_word *name)
{
    if (!o->reader->strict && !tia_text_peek(&o->text, name))
        return TIA_OK;
    return tia_obj_name(&o->text, name, "a material's name");
}

int tia_obj_usemtl(struct obj *o)
{
    struct tia_word word;
    int status = read_name(o, &word);

    o->material_uses++;
    o->group = 0;
    if (status) {
        tia_obj_skip(&o->text);
        return tia_obj_forgive(o, TIA_WARN_MATERIAL);
    }
    if (o->pass == OBJ_COUNT)
        return TIA_OK;
    const struct tia_name *name =
        tia_names_find((struct tia_name *)(void *)o->names.items, o->names.capacity, OBJ_MATERIAL, &word);
    if (!name) {
        (void)tia_text_error(&o->text, &word, "is not a material", "one that a mtllib has");
        return tia_obj_forgive(o, TIA_WARN_MATERIAL);
    }
    o->group = name->index;
    return TIA_OK;
}

/* ---- libraries ---- */

static bool is_same(const struct tia_word *a, const struct tia_word *b)
{
    uint32_t i = 0;

    while (i < a->length && i < b->length && a->at[i] == b->at[i])
        i++;
    return i == a->length && i == b->length;
}

static bool is_known(const struct obj *o, const struct tia_word *word)
{
    for (uint32_t i = 0; i < o->library_count; i++)
        if (is_same(word, &o->libraries[i].name))
            return true;
    return false;
}

/* Loads a library and appends it; it is not parsed yet. */
static int fetch(struct obj *o, const struct tia_word *word, const char **why)
{
    struct obj_library *library = &o->libraries[o->library_count];
    char name[TIA_NAME_MAX + 1];

    *library = (struct obj_library){.name = *word};
    tia_word_copy(name, word);
    *why = "no files can be loaded here";
    int status = o->reader->library ? o->reader->library(o->reader->ctx, name, &library->text, &library->length, why)
                                    : TIA_ERR_ARGUMENT;
    if (status < 0)
        return status;
    *why = "too long";
    if (tia_text_is_too_long(library->length))
        return TIA_ERR_ARGUMENT;
    o->library_count++;
    return TIA_OK;
}

/* Fetches the library whose name is the rest of the line: some names have blanks and are not in quotes. Returns false
 * if there is no such file.
 */
static bool fetch_line(struct obj *o, struct tia_text line)
{
    struct tia_word name;
    const char *why;

    if (tia_obj_name(&line, &name, "a file's name") || (!is_known(o, &name) && fetch(o, &name, &why)))
        return false;
    o->text = line;
    return true;
}

static int add_library(struct obj *o, const struct tia_word *word, const struct tia_text *line)
{
    uint32_t count = o->library_count;
    const char *why;

    if (count == OBJ_LIBRARIES) {
        (void)tia_text_error(&o->text, word, "is one too many", "at most 16 material libraries");
        return tia_obj_forgive(o, TIA_WARN_LIBRARY);
    }
    int status = fetch(o, word, &why);
    if (status && !fetch_line(o, *line))
        return tia_obj_unreadable(o, &o->text, word, status, why, TIA_WARN_LIBRARY);
    return o->library_count > count ? tia_mtl_read(o, &o->libraries[count]) : TIA_OK;
}

/* In the first pass, fetches and reads the libraries that are named here for the first time. */
int tia_obj_mtllib(struct obj *o)
{
    struct tia_text line = o->text;
    struct tia_word word;

    if (o->pass != OBJ_COUNT) {
        tia_obj_skip(&o->text);
        return TIA_OK;
    }
    do {
        int status = tia_text_file(&o->text, &word, "a file's name");
        if (status) {
            tia_obj_skip(&o->text);
            return tia_obj_forgive(o, TIA_WARN_LIBRARY);
        }
        status = is_known(o, &word) ? TIA_OK : add_library(o, &word, &line);
        if (status)
            return status;
        line = o->text;
    } while (tia_text_peek(&o->text, &word));
    return TIA_OK;
}
