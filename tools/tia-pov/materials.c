#include "pov.h"

#include <math.h>
#include <stdio.h>

/* Returns the transmission. POV-Ray has one colour for diffuse reflection and for transmission; tia has two.
 * Transmission alone can have a colour; together with diffuse reflection it must be grey. */
static double transmit_of(const struct tia_material *m)
{
    return pov_black(m->colour) ? 0 : pov_mean(pov_rgb(m->refraction));
}

static bool is_grey(struct tia_rgb c)
{
    return c.r == c.g && c.g == c.b;
}

static double ratio(double part, double whole)
{
    return whole > 0 ? part / whole : 0;
}

static bool lacks(double part, double whole)
{
    return part > 0 && whole <= 0;
}

/* Writes the emission, divided by the pigment and by the part that is not transmitted: POV-Ray multiplies it by
 * both. */
static void write_emission(struct pov *pov, const struct tia_material *m)
{
    struct point e = pov_rgb(m->emission), c = pov_rgb(m->colour);

    if (pov_black(m->emission))
        return;
    if (pov_black(m->colour)) {
        text_word(&pov->text, "emission 1");
        return;
    }
    c = pov_scaled(c, 1 - transmit_of(m));
    pov_triple(pov, "emission rgb", (struct point){ratio(e.x, c.x), ratio(e.y, c.y), ratio(e.z, c.z)});
}

/* Writes kr = mirror + F refraction: POV-Ray interpolates between two reflection colours by F. */
static void write_reflection(struct pov *pov, const struct tia_material *m)
{
    struct point mirror = pov_rgb(m->mirror);
    bool fresnel = m->fresnel && !pov_black(m->refraction);

    if (pov_black(m->mirror) && !fresnel)
        return;
    pov_triple(pov, "reflection { rgb", mirror);
    if (fresnel)
        pov_triple(pov, ", rgb", pov_sum(mirror, pov_rgb(m->refraction)));
    text_word(&pov->text, fresnel ? "fresnel on } conserve_energy" : "}");
}

static void write_finish(struct pov *pov, const struct tia_material *m)
{
    double transmit = transmit_of(m);

    text_word(&pov->text, "finish {");
    text_word(&pov->text, "ambient %d diffuse %.10g", !pov_black(m->colour),
              pov_black(m->colour) || transmit >= 1 ? 0 : 1 / (1 - transmit));
    write_emission(pov, m);
    if (!pov_black(m->specular))
        text_word(&pov->text, "phong %.10g phong_size %.10g", pov_mean(pov_rgb(m->specular)), pov_q16(m->exponent));
    write_reflection(pov, m);
    text_word(&pov->text, "}");
}

static void write_pigment(struct pov *pov, const struct tia_material *m)
{
    if (!pov_black(m->colour)) {
        pov_triple(pov, "pigment { rgb", pov_rgb(m->colour));
        text_word(&pov->text, "transmit %.10g }", transmit_of(m));
    } else if (!pov_black(m->refraction)) {
        pov_triple(pov, "pigment { rgb", pov_rgb(m->refraction));
        text_word(&pov->text, "filter 1 }");
    } else {
        pov_triple(pov, "pigment { rgb", pov_rgb(m->emission));
        text_word(&pov->text, "}");
    }
}

/* Notes the properties of a material that POV-Ray cannot express. */
static void note_material(struct pov *pov, uint32_t index, const struct tia_material *m)
{
    struct point e = pov_rgb(m->emission), c = pov_rgb(m->colour);
    bool scatters = !pov_black(m->colour), glass = !pov_black(m->refraction);

    if (!is_grey(m->specular))
        pov_note(pov, "material %u: its highlight is grey here", index);
    if (!pov_black(m->facing))
        pov_note(pov, "material %u: no facing ratio here", index);
    if (scatters && glass && (!is_grey(m->refraction) || m->refraction.r == TIA_Q30_ONE))
        pov_note(pov, "material %u: scattering and transmission cannot both be right here", index);
    if (scatters ? lacks(e.x, c.x) || lacks(e.y, c.y) || lacks(e.z, c.z) : glass && !pov_black(m->emission))
        pov_note(pov, "material %u: its emission is lost here beside its other colours", index);
    if (scatters && m->texture != 0 && !pov_black(m->emission))
        pov_note(pov, "material %u: its emission takes the texture here", index);
    if (glass && (m->refraction.r != TIA_Q30_ONE || !is_grey(m->refraction)))
        pov_note(pov, "material %u: its total internal reflection is not tinted here", index);
    if (m->bump != 0)
        pov_note(pov, "material %u: %s", index,
                 pov->scene->textures[m->bump - 1].kind == TIA_NOISE ? "its bumps are POV-Ray's here, at other places"
                                                                     : "smooth here: only bumps of noise are written");
    if (m->opacity != 0 && !pov_has_opacity(pov, index))
        pov_note(pov, "material %u: opaque here: a picture needs a file beside the scene's", index);
    if (m->opacity != 0 && glass && m->index != TIA_Q16_ONE)
        pov_note(pov, "material %u: the view through its opacity texture is refracted here", index);
    if (m->fresnel && glass && (m->refraction.r != TIA_Q30_ONE || !is_grey(m->refraction) || !pov_black(m->mirror)))
        pov_note(pov, "material %u: its transmission by Fresnel's equations is mixed differently here", index);
}

static void declare_material(struct pov *pov, uint32_t i, const struct tia_material *m)
{
    text_print(&pov->text, "#declare Finish_%u =\n", i);
    write_finish(pov, m);
    text_print(&pov->text, "\n#declare Interior_%u = interior { ior %.10g }\n#declare Pigment_%u =\n", i,
               pov_black(m->refraction) ? 1 : pov_q16(m->index), i);
    if (!pov_noise(pov, i, transmit_of(m)) && (!pov_coloured(pov, i) || !pov_texture(pov, i, transmit_of(m))))
        write_pigment(pov, m);
    text_print(&pov->text, "\n#declare Material_%u = material {\n", i);
    text_word(&pov->text, "texture { pigment { Pigment_%u } finish { Finish_%u }", i, i);
    pov_bump(pov, i);
    text_word(&pov->text, "}");
    text_word(&pov->text, "interior { Interior_%u }\n}\n", i);
    if (pov_has_opacity(pov, i))
        pov_write_opacity(pov, i);
}

void pov_materials(struct pov *pov)
{
    for (uint32_t i = 0; i < pov->scene->material_count; i++) {
        note_material(pov, i, &pov->scene->materials[i]);
        declare_material(pov, i, &pov->scene->materials[i]);
    }
    text_print(&pov->text, "\n");
}

/* Begins a texture that is visible in proportion to the opacity. */
static void begin_opacity(struct pov *pov, uint32_t material, const struct tia_shape *shape)
{
    text_word(&pov->text, "texture {%s pigment_pattern { Opacity_%u", pov_plain(shape) ? "" : " uv_mapping", material);
    pov_mapping(pov, material, shape);
    text_word(&pov->text, "} texture_map { [0 pigment { rgbt 1 } finish { ambient 0 diffuse 0 }] [1");
}

void pov_material(struct pov *pov, uint32_t material, const struct tia_shape *shape)
{
    const char *uv = pov_plain(shape) ? "" : " uv_mapping";
    bool opacity = pov_has_opacity(pov, material);

    if (!pov_textured(pov, material)) {
        text_word(&pov->text, "material { Material_%u }", material);
        return;
    }
    if (opacity)
        begin_opacity(pov, material, shape);
    else
        text_word(&pov->text, "texture {%s", uv);
    text_word(&pov->text, "pigment { Pigment_%u", material);
    pov_mapping(pov, material, shape);
    text_word(&pov->text, "} finish { Finish_%u }", material);
    pov_bump(pov, material);
    text_word(&pov->text, "%s}", opacity ? "] } " : "");
    text_word(&pov->text, "interior { Interior_%u }", material);
}

/* True if the shadow needs an object of its own. POV-Ray filters shadow rays by the pigment, at each surface; tia
 * filters them by a separate colour, once per object. The results are equal if the object transmits nothing or
 * everything. */
bool pov_has_shadow(const struct pov *pov, uint32_t material)
{
    const struct tia_material *m = &pov->scene->materials[material];
    struct tia_rgb t = m->transmission, r = m->refraction;
    bool all = is_grey(t) && t.r == TIA_Q30_ONE && is_grey(r) && r.r == TIA_Q30_ONE && pov_black(m->colour);

    return !(pov_black(t) && pov_black(r)) && !all;
}

/* Writes the shadow's material. Each of a closed object's two surfaces has the square root of the filter; with opacity,
 * each surface has the whole filter, as in tia. */
void pov_shadow_material(struct pov *pov, uint32_t material, const struct tia_shape *shape)
{
    struct point t = pov_rgb(pov->scene->materials[material].transmission);
    bool opacity = pov_has_opacity(pov, material);

    if (!opacity && pov_closed(pov->scene, shape))
        t = (struct point){sqrt(t.x), sqrt(t.y), sqrt(t.z)};
    text_word(&pov->text, "no_image no_reflection");
    if (opacity)
        begin_opacity(pov, material, shape);
    pov_triple(pov, "pigment { rgb", t);
    text_word(&pov->text, "filter %d }%s", t.x + t.y + t.z > 0, opacity ? " ] } }" : "");
}
