/* solids.c - solids as POV-Ray's own CSG: from steps in postfix order to blocks within blocks. */
#include "pov.h"

/* A solid that is being written. */
struct writing {
    struct pov *pov;
    const struct tia_solid *solid;
    bool unseen; /* as the invisible object for the shadow */
    bool whole;  /* the solid's material is written for it as a whole */
};

static const struct tia_shape *member_at(const struct tia_solid *solid, uint32_t step)
{
    uint32_t i = 0;

    for (uint32_t k = 0; k < step; k++)
        i += solid->steps[k] == TIA_SOLID_MEMBER;
    return &solid->members[i];
}

/* Returns the first step of the operand whose last step is `last`. */
static uint32_t first_of(const struct tia_solid *solid, uint32_t last)
{
    uint32_t operands = 1;

    for (;; last--) {
        operands += solid->steps[last] == TIA_SOLID_MEMBER ? UINT32_MAX : 1;
        if (!operands)
            return last;
    }
}

static void write_material(const struct writing *w, const struct tia_shape *s)
{
    if (w->unseen)
        pov_shadow_material(w->pov, s->material, s);
    else
        pov_material(w->pov, s->material, s);
}

static void write_member(const struct writing *w, const struct tia_shape *s)
{
    struct pov *pov = w->pov;
    struct tia_shape parts[3];

    pov_solid_geometry(pov, s);
    if (pov_textured(pov, s->material) && (s->kind == TIA_BOX || pov_parts(pov, s, parts) > 0))
        pov_note(pov, "material %u: its texture lies otherwise on boxes and caps in solids here", s->material);
    if (!w->whole)
        write_material(w, s);
    pov_transform(pov, s->transform);
    text_print(&pov->text, " }\n");
}

/* Writes the operand whose last step is `last`. The recursion is as deep as the solid's expression. */
static void write_operand(const struct writing *w, uint32_t last)
{
    static const char *const words[] = {"", "merge {\n", "intersection {\n", "difference {\n"};
    const struct tia_solid *solid = w->solid;

    if (solid->steps[last] == TIA_SOLID_MEMBER) {
        write_member(w, member_at(solid, last));
        return;
    }
    text_print(&w->pov->text, "%s", words[solid->steps[last]]);
    write_operand(w, first_of(solid, last - 1) - 1);
    write_operand(w, last - 1);
    text_print(&w->pov->text, "}\n");
}

/* True if a member's correct shadow needs a separate object. */
static bool has_shadow(const struct pov *pov, const struct tia_solid *solid)
{
    bool found = false;

    for (uint32_t i = 0; i < solid->member_count; i++)
        found = found || pov_has_shadow(pov, solid->members[i].material);
    return found;
}

/* True if all members have one material without a texture. POV-Ray's rays enter and leave the interior of one object:
 * glass must be that of the whole. */
static bool is_whole(struct pov *pov, const struct tia_solid *solid)
{
    uint32_t material = solid->members[0].material;
    bool refracts = false, same = true;

    for (uint32_t i = 0; i < solid->member_count; i++) {
        refracts = refracts || !pov_black(pov->scene->materials[solid->members[i].material].refraction);
        same = same && solid->members[i].material == material;
    }
    bool whole = same && !pov_textured(pov, material);
    if (refracts && !whole)
        pov_note(pov, "material %u: solids with it and others, or with its texture, refract otherwise here", material);
    return whole;
}

void pov_solid(struct pov *pov, const struct tia_shape *s)
{
    const struct tia_solid *solid = &pov->scene->solids[s->solid];
    bool shadow = has_shadow(pov, solid), whole = is_whole(pov, solid);

    for (int unseen = 0; unseen <= shadow; unseen++) {
        const struct writing w = {pov, solid, unseen, whole};
        text_print(&pov->text, "object {\n");
        write_operand(&w, solid->step_count - 1);
        text_word(&pov->text, unseen ? "no_image no_reflection" : shadow ? "no_shadow" : "");
        if (whole)
            write_material(&w, &solid->members[0]);
        pov_transform(pov, s->transform);
        text_print(&pov->text, " }\n");
    }
}
