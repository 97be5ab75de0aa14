/* materials.c - materials, which tia has fewer parameters for.
 *
 *     metallic-roughness (glTF, and others that have a base colour and a metallic factor), with the base colour c, the
 *     metallic factor m, the roughness r, the smoothness s = (1 - r)^2 and the reflectance f = 0.04 (1 - m) + c m:
 *         colour      c (1 - m s)
 *         mirror      c m s
 *         specular    min(1, f (n + 2)/2), the peak of a normalised lobe with the exponent
 *         exponent    n = (2/r^4 - 2)/4, from 1 to 10000: Blinn's exponent, a fourth of it for Phong's lobe
 *     others:         colour, specular and exponent as they are
 *     emission        as it is; above 1 with emission_bits
 *     opacity         as in .mtl: the colour is multiplied by it, refraction and transmission are 1 - opacity
 *     transmission    the colour is multiplied by 1 - t, refraction and transmission are c t
 */
#include <math.h>
#include <string.h>

#include "textures.h"

struct surface {
    const struct aiMaterial *from;
    double base[4], specular[3], emission[3];
    double metallic, roughness, exponent, opacity, transmission;
    bool physical;
};

static const struct aiMaterialProperty *find(const struct aiMaterial *from, const char *key)
{
    return property_of(from, key, AI_TEXTURE_NONE);
}

/* Reads up to `count` numbers. Returns false, without a change, for a property that does not exist, is not of numbers
 * or has one that is not finite. */
static bool numbers(const struct aiMaterial *from, const char *key, double *to, unsigned count)
{
    const struct aiMaterialProperty *property = find(from, key);
    unsigned size = !property ? 0 : property->mType == aiPTI_Float ? 4 : property->mType == aiPTI_Double ? 8 : 0;
    double read[4];

    if (!size || property->mDataLength < size)
        return false;
    count = property->mDataLength / size < count ? property->mDataLength / size : count;
    for (unsigned i = 0; i < count; i++) {
        float single = 0;
        memcpy(size == 4 ? (void *)&single : (void *)&read[i], property->mData + (size_t)i * size, size);
        read[i] = size == 4 ? (double)single : read[i];
        if (!isfinite(read[i]))
            return false;
    }
    memcpy(to, read, count * sizeof *to);
    return true;
}

static double unit(double x)
{
    return x > 0 ? fmin(x, 1) : 0;
}

static struct surface surface_of(const struct aiMaterial *from)
{
    struct surface s = {.from = from, .base = {0.8, 0.8, 0.8, 1}, .roughness = 1, .opacity = 1};

    s.physical = find(from, "$mat.metallicFactor") && find(from, "$clr.base");
    (void)numbers(from, s.physical ? "$clr.base" : "$clr.diffuse", s.base, s.physical ? 4 : 3);
    (void)numbers(from, "$clr.specular", s.specular, 3);
    (void)numbers(from, "$clr.emissive", s.emission, 3);
    (void)numbers(from, "$mat.metallicFactor", &s.metallic, 1);
    (void)numbers(from, "$mat.roughnessFactor", &s.roughness, 1);
    (void)numbers(from, "$mat.shininess", &s.exponent, 1);
    (void)numbers(from, "$mat.opacity", &s.opacity, 1);
    (void)numbers(from, "$mat.transmission.factor", &s.transmission, 1);
    s.metallic = unit(s.metallic);
    s.roughness = unit(s.roughness);
    s.transmission = unit(s.transmission);
    /* many programs write 0 for opaque materials */
    s.opacity = unit(s.opacity) > 0 ? unit(s.opacity) : 1;
    return s;
}

/* The kinds of textures, each the same one by two names. */
static const enum aiTextureType colours[] = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE},
                                glows[] = {aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR},
                                metals[] = {aiTextureType_UNKNOWN, aiTextureType_METALNESS},
                                opacities[] = {aiTextureType_OPACITY, aiTextureType_OPACITY};

/* Multiplies factors by the means of textures that tia has no counterpart of. */
static void take_means(struct convert *c, struct surface *s)
{
    double mean[3];

    if (s->physical && texture_mean(c, s->from, metals, mean, 1)) {
        s->roughness *= mean[1];
        s->metallic *= mean[2];
    }
    if (s->emission[0] + s->emission[1] + s->emission[2] > 0 && texture_mean(c, s->from, glows, mean, 0))
        for (int i = 0; i < 3; i++)
            s->emission[i] *= mean[i];
}

/* Adds the textures of colour and opacity. */
static void set_textures(struct convert *c, struct surface *s, struct tia_material *made)
{
    char mode[16] = "";
    double cut = 0.5;

    made->texture = texture_add(c, s->from, colours, false, TIA_CHANNEL_OPACITY, 0);
    /* many programs write black where the image alone is the colour */
    bool black = !(s->base[0] + s->base[1] + s->base[2] > 0);
    for (int i = 0; i < 3 && made->texture && black; i++)
        s->base[i] = 1;
    (void)numbers(s->from, "$mat.gltf.alphaCutoff", &cut, 1);
    if (property_text(find(s->from, "$mat.gltf.alphaMode"), mode, sizeof mode)) {
        bool masked = strcmp(mode, "MASK") == 0;
        s->opacity *= strcmp(mode, "BLEND") == 0 ? unit(s->base[3]) : 1;
        if (masked || strcmp(mode, "BLEND") == 0)
            made->opacity = texture_add(c, s->from, colours, true, TIA_CHANNEL_ALPHA, masked ? cut : 0);
    } else {
        made->opacity = texture_add(c, s->from, opacities, true, TIA_CHANNEL_OPACITY, 0);
    }
}

static void set_reflection(struct tia_material *made, const struct surface *s)
{
    double smooth = (1 - s->roughness) * (1 - s->roughness), r4 = pow(s->roughness, 4);
    double exponent = r4 > 1e-6 ? fmin(10000, fmax(1, (2 / r4 - 2) / 4)) : 10000;
    double mirror[3], highlight[3];

    for (int i = 0; i < 3; i++) {
        mirror[i] = s->base[i] * s->metallic * smooth;
        highlight[i] = (0.04 * (1 - s->metallic) + s->base[i] * s->metallic) * (exponent + 2) / 2;
    }
    made->mirror = convert_colour(mirror, 1);
    made->specular = convert_colour(highlight, 1);
    made->exponent = convert_fixed(exponent, TIA_Q16_ONE);
}

static void set_highlight(struct tia_material *made, const struct surface *s)
{
    if (!(s->exponent > 0))
        return;
    made->specular = convert_colour(s->specular, 1);
    made->exponent = convert_fixed(fmin(10000, fmax(1, s->exponent)), TIA_Q16_ONE);
}

static void set_emission(struct tia_material *made, const struct surface *s)
{
    double most = fmax(s->emission[0], fmax(s->emission[1], s->emission[2])), emission[3];
    int bits = most > 1 ? (int)fmin(TIA_EMISSION_BITS_MAX, ceil(log2(most))) : 0;

    for (int i = 0; i < 3; i++)
        emission[i] = ldexp(s->emission[i], -bits);
    made->emission = convert_colour(emission, 1);
    made->emission_bits = (uint8_t)bits;
}

static void set_colour(struct tia_material *made, const struct surface *s)
{
    double smooth = (1 - s->roughness) * (1 - s->roughness), colour[3], behind[3];
    double opacity = s->opacity, through = s->transmission;

    for (int i = 0; i < 3; i++) {
        double whole = s->base[i] * (s->physical ? 1 - s->metallic * smooth : 1);
        colour[i] = whole * opacity * (1 - through);
        behind[i] = 1 - opacity + opacity * through * unit(s->base[i]);
    }
    made->colour = convert_colour(colour, 1);
    made->refraction = made->transmission = convert_colour(behind, 1);
}

static struct tia_material make_material(struct convert *c, struct surface *s)
{
    struct tia_material made;

    memset(&made, 0, sizeof made); /* padding, too: the model's checksum covers it */
    made.index = TIA_Q16_ONE;
    take_means(c, s);
    set_textures(c, s, &made);
    set_colour(&made, s);
    set_emission(&made, s);
    if (s->physical)
        set_reflection(&made, s);
    else
        set_highlight(&made, s);
    return made;
}

static void name_material(struct model_name *name, const struct aiMaterial *from)
{
    (void)property_text(find(from, "?mat.name"), name->text, sizeof name->text);
}

int convert_materials(struct convert *c)
{
    unsigned count = c->from->mNumMaterials;
    struct tia_material *made = pack_grow(&c->pack.arrays[MODEL_MATERIALS], count + (uint64_t)1);
    struct model_name *names = pack_grow(&c->pack.arrays[MODEL_NAMES], count + (uint64_t)1);

    if (!made || !names)
        return convert_exhausted(c);
    for (unsigned i = 0; i < count; i++) {
        struct surface s = surface_of(c->from->mMaterials[i]);
        made[i] = make_material(c, &s);
        name_material(&names[i], c->from->mMaterials[i]);
    }
    /* of meshes without a material */
    made[count] = (struct tia_material){.colour = TIA_RGB(0.8, 0.8, 0.8), .index = TIA_Q16_ONE};
    return TIA_OK;
}
