/* mtl_map.c - the images of a material. */
#include "mtl.h"

/* -s U [V [W]] gives the repeats; every other option takes one to three words. */
static int read_option(struct tia_text *t, const struct tia_word *option, tia_q16 repeat[2])
{
    struct tia_word word;
    bool scales = tia_word_is(option, "-s");

    if (!scales && !tia_word_is(option, "-o") && !tia_word_is(option, "-t") && !tia_word_is(option, "-mm")) {
        (void)tia_text_word(t, &word);
        return TIA_OK;
    }
    for (int i = 0; i < 3 && tia_text_has_number(t); i++) {
        tia_q16 number;
        (void)tia_text_peek(t, &word);
        int status = tia_text_q16(t, &number);
        if (status)
            return status;
        if (scales && i < 2) {
            if (number < TIA_Q16_ONE / 1024 || number > TIA_Q16(1024))
                return tia_text_error(t, &word, "is out of range", "a number from 1/1024 to 1024");
            repeat[i] = number;
        }
    }
    return TIA_OK;
}

/* The options, and then the file's name. */
static int read_map(struct mtl *m, struct tia_word *name, tia_q16 repeat[2])
{
    struct tia_word word;
    int status = TIA_OK;

    while (!status && tia_text_peek(&m->text, &word) && *word.at == '-' && word.length > 1) {
        (void)tia_text_word(&m->text, &word);
        status = read_option(&m->text, &word, repeat);
    }
    return status ? status : tia_obj_name(&m->text, name, "an image's file name");
}

/* The image, fetched once however often it is named. */
static int fetch_image(struct obj *o, const struct tia_word *name, struct tia_texture *texture, const char **why)
{
    struct tia_name *known =
        tia_names_find((struct tia_name *)(void *)o->names.items, o->names.capacity, OBJ_IMAGE, name);
    char file[TIA_NAME_MAX + 1];

    if (known->index < o->textures.count) {
        *texture = ((struct tia_texture *)(void *)o->textures.items)[known->index];
        return TIA_OK;
    }
    *texture = (struct tia_texture){.kind = TIA_IMAGE};
    tia_word_copy(file, name);
    int status = o->reader->image ? o->reader->image(o->reader->ctx, file, texture, why) : TIA_ERR_ARGUMENT;
    if (status < 0)
        return status;
    known->index = o->textures.count;
    return TIA_OK;
}

/* A texture is counted before it is known whether its image can be read: one that cannot stays unused. */
int tia_mtl_map_kd(struct mtl *m)
{
    static const struct tia_texture unused = {.kind = TIA_CHECKER, .repeat = {TIA_Q16_ONE, TIA_Q16_ONE}};
    struct tia_texture texture = unused;
    struct tia_name name = {.kind = OBJ_IMAGE, .index = UINT32_MAX};
    tia_q16 repeat[2] = {TIA_Q16_ONE, TIA_Q16_ONE};
    const char *why = "there is nothing that could";
    int status = read_map(m, &name.word, repeat), fetched = TIA_OK;

    if (status)
        return status;
    if (m->obj->pass == OBJ_FILL)
        fetched = fetch_image(m->obj, &name.word, &texture, &why);
    else
        tia_array_add(&m->obj->names, &name);
    if (fetched) {
        tia_array_add(&m->obj->textures, &unused);
        return tia_obj_unreadable(m->obj, &m->text, &name.word, fetched, why, TIA_WARN_IMAGE);
    }
    texture.bilinear = true;
    texture.repeat[0] = repeat[0];
    texture.repeat[1] = repeat[1];
    tia_array_add(&m->obj->textures, &texture);
    m->texture = m->obj->textures.count;
    return TIA_OK;
}

/* A ray cannot pass through some texels and not through others; the mean looks right from afar. */
int tia_mtl_map_d(struct mtl *m)
{
    struct tia_reader *reader = m->obj->reader;
    tia_q16 repeat[2];
    tia_q30 mean = TIA_Q30_ONE;
    const char *why = "there is nothing that could";
    char file[TIA_NAME_MAX + 1];
    struct tia_word name;
    int status = read_map(m, &name, repeat);

    if (status || m->obj->pass != OBJ_FILL)
        return status;
    tia_word_copy(file, &name);
    status = reader->opacity ? reader->opacity(reader->ctx, file, &mean, &why) : TIA_ERR_ARGUMENT;
    if (status < 0)
        return tia_obj_unreadable(m->obj, &m->text, &name, status, why, TIA_WARN_IMAGE);
    m->mean_opacity = mean < 0 ? 0 : mean > TIA_Q30_ONE ? TIA_Q30_ONE : mean;
    if (m->mean_opacity == TIA_Q30_ONE)
        return TIA_OK;
    (void)tia_text_error(&m->text, &name, "is partly transparent", "an opaque image");
    return tia_obj_forgive(m->obj, TIA_WARN_OPACITY);
}
