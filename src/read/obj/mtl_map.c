/* mtl_map.c - the images of a material, with options before the file's name:
 *
 *     -s U V [W]          scale, by which texture coordinates are multiplied
 *     -o U V [W]          offset, which is then added, as in all programs
 *     -imfchan r|g|b|m|l  of map_d: the channel that holds the opacity; m is alpha. The format defines no default. Here
 *                         it is alpha or, in an image without alpha, luminance
 *
 * Other options cause a warning if they would change the picture: images repeat, and their values are not modified. */
#include "mtl.h"

struct map {
    struct tia_word name;
    tia_q16 scale[2], offset[2];
    enum tia_channel channel;
};

static int not_supported(struct mtl *m, const struct tia_word *option)
{
    (void)tia_text_error(&m->text, option, "has no effect here", "-s, -o or -imfchan");
    return tia_obj_forgive(m->obj, TIA_WARN_OPTION);
}

/* Reads up to three numbers; the others stay unchanged. If `scales`, the first two must be in 1/1024..1024. */
static int read_numbers(struct mtl *m, tia_q16 numbers[3], bool scales)
{
    for (int i = 0; i < 3 && tia_text_has_number(&m->text); i++) {
        struct tia_word word;
        (void)tia_text_peek(&m->text, &word);
        int status = tia_text_q16(&m->text, &numbers[i]);
        if (status)
            return status;
        if (scales && i < 2 && (numbers[i] < TIA_Q16_ONE / 1024 || numbers[i] > TIA_Q16(1024)))
            return tia_text_error(&m->text, &word, "is out of range", "a number from 1/1024 to 1024");
    }
    return TIA_OK;
}

/* Reads the numbers of an option; *found is false if it is an option without numbers. */
static int read_numeric(struct mtl *m, const struct tia_word *option, struct map *map, bool *found)
{
    static const struct {
        const char *name;
        tia_q16 standard[3];
    } kinds[] = {
        {"-s", {TIA_Q16_ONE, TIA_Q16_ONE, 0}}, {"-o", {0, 0, 0}}, {"-t", {0, 0, 0}}, {"-mm", {0, TIA_Q16_ONE, 0}}};
    size_t i = 0;

    while (i < sizeof kinds / sizeof *kinds && !tia_word_is(option, kinds[i].name))
        i++;
    *found = i < sizeof kinds / sizeof *kinds;
    if (!*found)
        return TIA_OK;
    const tia_q16 *standard = kinds[i].standard;
    tia_q16 numbers[3] = {standard[0], standard[1], standard[2]}, *kept = i == 0 ? map->scale : map->offset;
    int status = read_numbers(m, numbers, i == 0);
    if (status)
        return status;
    if (i > 1)
        return numbers[0] == standard[0] && numbers[1] == standard[1] && (numbers[2] == 0) ? TIA_OK
                                                                                           : not_supported(m, option);
    kept[0] = numbers[0];
    kept[1] = numbers[1];
    return TIA_OK;
}

static int read_channel(struct mtl *m, const struct tia_word *option, const struct tia_word *word, struct map *map)
{
    static const char *const names[TIA_CHANNELS] = {"", "r", "g", "b", "m", "l"};

    for (int i = TIA_CHANNEL_RED; i < TIA_CHANNELS; i++)
        if (tia_word_is(word, names[i])) {
            map->channel = (enum tia_channel)i;
            return TIA_OK;
        }
    return not_supported(m, option);
}

/* Reads the rest of an option: numbers or a word. An unknown option is assumed to have a word. */
static int read_option(struct mtl *m, const struct tia_word *option, struct map *map)
{
    static const char *const standard[][2] = {{"-clamp", "off"}, {"-cc", "off"}, {"-blendu", "on"}, {"-blendv", "on"}};
    struct tia_word word;
    bool numeric;
    int status = read_numeric(m, option, map, &numeric);

    if (status || numeric || !tia_text_word(&m->text, &word))
        return status;
    if (tia_word_is(option, "-imfchan"))
        return read_channel(m, option, &word, map);
    for (size_t i = 0; i < sizeof standard / sizeof *standard; i++)
        if (tia_word_is(option, standard[i][0]) && !tia_word_is(&word, standard[i][1]))
            return not_supported(m, option);
    return TIA_OK;
}

/* Reads the options, and then the file's name. */
static int read_map(struct mtl *m, struct map *map)
{
    struct tia_word word;
    int status = TIA_OK;

    *map = (struct map){.scale = {TIA_Q16_ONE, TIA_Q16_ONE}};
    while (!status && tia_text_peek(&m->text, &word) && *word.at == '-' && word.length > 1) {
        (void)tia_text_word(&m->text, &word);
        status = read_option(m, &word, map);
    }
    return status ? status : tia_obj_name(&m->text, &map->name, "an image's file name");
}

/* Returns the image in *texture. An image that is named several times is fetched only once. */
static int fetch_image(struct obj *o, const struct tia_name *name, struct tia_texture *texture, const char **why)
{
    struct tia_reader *reader = o->reader;
    struct tia_name *known =
        tia_names_find((struct tia_name *)(void *)o->names.items, o->names.capacity, name->kind, &name->word);
    char file[TIA_NAME_MAX + 1];
    int status = TIA_ERR_ARGUMENT;

    if (known->index < o->textures.count) {
        *texture = ((struct tia_texture *)(void *)o->textures.items)[known->index];
        return TIA_OK;
    }
    *texture = (struct tia_texture){.kind = name->kind == OBJ_IMAGE ? TIA_IMAGE : TIA_OPACITY};
    tia_word_copy(file, &name->word);
    if (texture->kind == TIA_IMAGE && reader->image)
        status = reader->image(reader->ctx, file, texture, why);
    else if (texture->kind == TIA_OPACITY && reader->opacity)
        status = reader->opacity(reader->ctx, file, (enum tia_channel)(name->kind - OBJ_OPACITY), texture, why);
    if (!status)
        known->index = o->textures.count;
    return status;
}

/* Converts an offset that is added to the scaled coordinates to a texture's offset, which is a position on the surface.
 * Images repeat, so only the fraction of `added` counts. */
static tia_q16 offset_of(tia_q16 added, tia_q16 scale)
{
    int64_t fraction = (int64_t)(added & (TIA_Q16_ONE - 1)) * TIA_Q16_ONE;

    return (tia_q16) - ((fraction + scale / 2) / scale);
}

/* Adds a texture and sets *number to its number, from 1. The earlier passes have counted the texture. So if its image
 * cannot be read, an unused texture is added, and *number does not change. */
static int add_texture(struct mtl *m, const struct map *map, unsigned kind, uint32_t *number)
{
    static const struct tia_texture unused = {.kind = TIA_CHECKER, .repeat = {TIA_Q16_ONE, TIA_Q16_ONE}};
    struct tia_texture texture = unused;
    struct tia_name name = {.word = map->name, .kind = kind, .index = UINT32_MAX};
    const char *why = "no files can be loaded here";
    int fetched = TIA_OK;

    if (m->obj->pass == OBJ_FILL)
        fetched = fetch_image(m->obj, &name, &texture, &why);
    else
        tia_array_add(&m->obj->names, &name);
    if (fetched) {
        tia_array_add(&m->obj->textures, &unused);
        return tia_obj_unreadable(m->obj, &m->text, &name.word, fetched, why, TIA_WARN_IMAGE);
    }
    texture.bilinear = true;
    for (int i = 0; i < 2; i++) {
        texture.repeat[i] = map->scale[i];
        texture.offset[i] = offset_of(map->offset[i], map->scale[i]);
    }
    tia_array_add(&m->obj->textures, &texture);
    *number = m->obj->textures.count;
    return TIA_OK;
}

int tia_mtl_map_kd(struct mtl *m)
{
    struct map map;
    int status = read_map(m, &map);

    return status ? status : add_texture(m, &map, OBJ_IMAGE, &m->texture);
}

/* True if the opacity is 1 everywhere: a texture would only cost time. Many files name an image without transparency
 * for map_d, too. */
static bool is_opaque(const struct tia_texture *t)
{
    size_t count = (size_t)t->width * t->height, i = 0;

    while (i < count && t->texels[i] == 255)
        i++;
    return i == count;
}

int tia_mtl_map_d(struct mtl *m)
{
    struct map map;
    uint32_t number = 0;
    int status = read_map(m, &map);

    status = status ? status : add_texture(m, &map, OBJ_OPACITY + (unsigned)map.channel, &number);
    if (!status && number && m->obj->pass == OBJ_FILL &&
        !is_opaque(&((struct tia_texture *)(void *)m->obj->textures.items)[number - 1]))
        m->opacity_texture = number;
    return status;
}
