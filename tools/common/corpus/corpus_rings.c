/* corpus_rings.c - tori and rounded boxes in random scenes. */
#include "corpus_rays.h"

#include "dice.h"

/* Makes a disc a torus around it. */
static void make_torus(uint64_t *state, struct tia_shape *shape)
{
    struct tia_disc disc = shape->disc;
    tia_q16 minor =
        dice_one_in(state, 4) ? disc.radius / 200 : dice_between(state, disc.radius / 16, disc.radius / 10 * 9);

    shape->kind = TIA_TORUS;
    shape->torus = (struct tia_torus){disc.centre, disc.normal, disc.radius, minor};
}

/* Rounds a box by at most half of its shortest edge. */
static void make_rounded(uint64_t *state, struct tia_shape *shape)
{
    struct tia_box box = shape->box;
    tia_q16 x = box.max.x - box.min.x, y = box.max.y - box.min.y, z = box.max.z - box.min.z;
    tia_q16 least = x < y ? x : y;

    least = least < z ? least : z;
    shape->kind = TIA_ROUNDED;
    shape->rounded = (struct tia_rounded){box.min, box.max, dice_between(state, least / 64, least / 2)};
}

/* Makes some of a solid's balls tori, and some of its boxes rounded. */
static void round_members(uint64_t *state, struct tia_shape *members, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        struct tia_shape *s = &members[i];
        if (s->kind == TIA_SPHERE && dice_one_in(state, 2)) {
            s->disc = (struct tia_disc){s->sphere.centre, parts_random_direction(state), s->sphere.radius};
            make_torus(state, s);
        } else if (s->kind == TIA_BOX && dice_one_in(state, 3)) {
            make_rounded(state, s);
        }
    }
}

void corpus_add_rings(struct corpus_rays *out, uint64_t seed)
{
    uint64_t state = seed;

    for (uint32_t i = 0; i < out->scene.shape_count; i++)
        if (out->shapes[i].kind == TIA_DISC)
            make_torus(&state, &out->shapes[i]);
        else if (out->shapes[i].kind == TIA_BOX)
            make_rounded(&state, &out->shapes[i]);
    for (uint32_t i = 0; i < out->scene.solid_count; i++)
        round_members(&state, out->members[i], out->solids[i].member_count);
}
