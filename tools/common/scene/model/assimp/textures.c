#include "textures.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/image/decode.h"

/* ---- properties ---- */

const struct aiMaterialProperty *property_of(const struct aiMaterial *from, const char *key,
                                             enum aiTextureType semantic)
{
    for (unsigned i = 0; i < from->mNumProperties; i++) {
        const struct aiMaterialProperty *property = from->mProperties[i];
        if (property && property->mSemantic == (unsigned)semantic && property->mIndex == 0 &&
            strcmp(property->mKey.data, key) == 0)
            return property;
    }
    return NULL;
}

/* A string is stored as its length in 4 bytes, then the text and a zero. */
bool property_text(const struct aiMaterialProperty *property, char *to, size_t size)
{
    if (!property || property->mType != aiPTI_String || property->mDataLength <= 4)
        return false;
    (void)snprintf(to, size, "%.*s", (int)property->mDataLength - 4, property->mData + 4);
    return true;
}

/* Reads an integer; an enum is stored as bytes. */
static int property_integer(const struct aiMaterialProperty *property, int otherwise)
{
    int value = otherwise;

    if (property && (property->mType == aiPTI_Integer || property->mType == aiPTI_Buffer) &&
        property->mDataLength == sizeof value)
        memcpy(&value, property->mData, sizeof value);
    return value;
}

static enum aiTextureType chosen(const struct aiMaterial *from, const enum aiTextureType kinds[2])
{
    return property_of(from, "$tex.file", kinds[0]) ? kinds[0] : kinds[1];
}

unsigned texture_channel(const struct aiMaterial *from)
{
    const enum aiTextureType kinds[2] = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
    int channel = property_integer(property_of(from, "$tex.uvwsrc", chosen(from, kinds)), 0);
    return channel > 0 && channel < AI_MAX_NUMBER_OF_TEXTURECOORDS ? (unsigned)channel : 0;
}

/* ---- images ---- */

/* Finds the image that the model itself has under that name: "*" and its number, or its file name. */
static const struct aiTexture *embedded(const struct convert *c, const char *name)
{
    if (name[0] == '*') {
        unsigned long number = strtoul(name + 1, NULL, 10);
        return number < c->from->mNumTextures ? c->from->mTextures[number] : NULL;
    }
    for (unsigned i = 0; i < c->from->mNumTextures; i++)
        if (c->from->mTextures[i]->mFilename.length && strcmp(c->from->mTextures[i]->mFilename.data, name) == 0)
            return c->from->mTextures[i];
    return NULL;
}

/* Copies texels that are stored as they are. */
static int copy_texels(struct image_texels *texels, const struct aiTexture *from, size_t most, const char **why)
{
    int status = image_room(texels, from->mWidth, from->mHeight, TIA_TEXTURE_MAX, most, why);
    size_t count = (size_t)from->mWidth * from->mHeight;

    for (size_t i = 0; !status && i < count; i++) {
        const struct aiTexel *texel = &from->pcData[i];
        texels->rgb[3 * i] = texel->r;
        texels->rgb[3 * i + 1] = texel->g;
        texels->rgb[3 * i + 2] = texel->b;
    }
    return status;
}

static int load(struct convert *c, const char *name, struct image_texels *texels, const char **why)
{
    const struct aiTexture *own = embedded(c, name);
    struct whole whole;

    if (own && own->mHeight > 0)
        return copy_texels(texels, own, c->files.left, why);
    if (own)
        return image_decode(texels, own->pcData, own->mWidth, TIA_TEXTURE_MAX, c->files.left, why);
    int status = model_files_read_named(&c->files, name, &whole, why);
    if (status)
        return status;
    status = image_decode(texels, whole.bytes, whole.length, TIA_TEXTURE_MAX, c->files.left, why);
    free(whole.bytes);
    return status;
}

/* Loads the texture of that kind. Returns false without one, or with a warning if it cannot be read. */
static bool load_kind(struct convert *c, const struct aiMaterial *from, enum aiTextureType kind, char name[1100],
                      struct image_texels *texels)
{
    const char *why = "";

    *texels = (struct image_texels){.rgb = NULL};
    if (!property_text(property_of(from, "$tex.file", kind), name, 1100))
        return false;
    if (!load(c, name, texels, &why) && texels->width > 0)
        return true;
    convert_warn(c, TIA_WARN_IMAGE, "texture '%.150s': %s: left out", name, why);
    return false;
}

bool texture_mean(struct convert *c, const struct aiMaterial *from, const enum aiTextureType kinds[2], double mean[3],
                  double otherwise)
{
    enum aiTextureType kind = chosen(from, kinds);
    struct image_texels texels;
    char name[1100];

    mean[0] = mean[1] = mean[2] = otherwise;
    if (!property_of(from, "$tex.file", kind))
        return false;
    if (!load_kind(c, from, kind, name, &texels))
        return true;
    size_t count = (size_t)texels.width * texels.height;
    uint64_t sums[3] = {0, 0, 0};
    for (size_t i = 0; i < 3 * count; i++)
        sums[i % 3] += texels.rgb[i];
    for (int k = 0; k < 3; k++)
        mean[k] = (double)sums[k] / 255 / (double)count;
    image_free(&texels);
    return true;
}

/* ---- textures of the scene ---- */

/* A texture of the scene, to be found again. */
struct texture_key {
    char name[1100];
    bool opacities, smooth;
    enum tia_channel channel;
    double threshold;
};

static bool is_same(const struct texture_key *a, const struct texture_key *b)
{
    return a->opacities == b->opacities && a->smooth == b->smooth && a->channel == b->channel &&
           !(a->threshold < b->threshold) && !(a->threshold > b->threshold) && strcmp(a->name, b->name) == 0;
}

/* Returns the texture of that key; 0: none. */
static uint32_t find_texture(const struct convert *c, const struct texture_key *key)
{
    for (uint32_t i = 0; i < c->texture_key_count; i++)
        if (is_same(&c->texture_keys[i], key))
            return i + 1;
    return 0;
}

static bool keep_key(struct convert *c, const struct texture_key *key)
{
    struct texture_key *keys = realloc(c->texture_keys, (c->texture_key_count + (size_t)1) * sizeof *keys);

    if (!keys)
        return false;
    c->texture_keys = keys;
    keys[c->texture_key_count++] = *key;
    return true;
}

/* Reduces a picture to opacities. Returns false where it has none. */
static bool reduce(struct image_texels *texels, const struct texture_key *key)
{
    size_t count = (size_t)texels->width * texels->height;

    if (key->channel == TIA_CHANNEL_ALPHA && !texels->alpha)
        return false;
    image_channel(texels, key->channel);
    for (size_t i = 0; key->threshold > 0 && i < count; i++)
        texels->alpha[i] = texels->alpha[i] >= key->threshold * 255 ? 255 : 0;
    return texels->alpha;
}

static uint32_t store(struct convert *c, const struct texture_key *key, const struct image_texels *texels)
{
    size_t bytes = (size_t)texels->width * texels->height * (key->opacities ? 1 : 3);
    struct model_texture texture;
    unsigned char *to = bytes <= c->files.left ? pack_grow(&c->pack.arrays[MODEL_TEXELS], bytes) : NULL;

    if (!to) {
        convert_warn(c, TIA_WARN_IMAGE, "texture '%.150s': too large: left out", key->name);
        return 0;
    }
    c->files.left -= bytes;
    memcpy(to, key->opacities ? texels->alpha : texels->rgb, bytes);
    memset(&texture, 0, sizeof texture);
    texture.texture = (struct tia_texture){.kind = key->opacities ? TIA_OPACITY : TIA_IMAGE,
                                           .repeat = {TIA_Q16_ONE, TIA_Q16_ONE},
                                           .bilinear = key->smooth,
                                           .width = (uint16_t)texels->width,
                                           .height = (uint16_t)texels->height};
    texture.texels = (struct model_range){c->pack.arrays[MODEL_TEXELS].count - bytes, bytes};
    if (!pack_add(&c->pack.arrays[MODEL_TEXTURES], &texture) || !keep_key(c, key))
        return 0;
    return c->texture_key_count;
}

uint32_t texture_add(struct convert *c, const struct aiMaterial *from, const enum aiTextureType kinds[2],
                     bool opacities, enum tia_channel channel, double threshold)
{
    enum aiTextureType kind = chosen(from, kinds);
    struct texture_key key = {.opacities = opacities, .channel = channel, .threshold = threshold};
    struct image_texels texels;
    char name[1100];

    /* 9728 is OpenGL's GL_NEAREST, which glTF names filters by */
    key.smooth = property_integer(property_of(from, "$tex.mappingfiltermag", kind), 0) != 9728;
    if (!property_text(property_of(from, "$tex.file", kind), key.name, sizeof key.name))
        return 0;
    uint32_t found = find_texture(c, &key);
    if (found || !load_kind(c, from, kind, name, &texels))
        return found;
    if (!opacities || reduce(&texels, &key))
        found = store(c, &key, &texels);
    image_free(&texels);
    return found;
}
