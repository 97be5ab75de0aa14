/* corpus_solids.c - random solids. */
#include "corpus_rays.h"
#include "dice.h"

#define ONE TIA_Q16(1)

/* Makes a member about 1 large near the solid's origin. A coordinate is often a whole number, so that faces coincide.
 */
static void random_member(uint64_t *state, struct tia_shape *s)
{
    static const enum tia_shape_kind kinds[] = {TIA_SPHERE, TIA_BOX, TIA_BOX, TIA_CYLINDER, TIA_CONE};
    static const struct tia_vec3 near[2] = {TIA_VEC3(-0.7, -0.7, -0.7), TIA_VEC3(0.7, 0.7, 0.7)};
    static const struct tia_vec3 sizes[2] = {TIA_VEC3(0.3, 0.3, 0.3), TIA_VEC3(1, 1, 1)};
    struct tia_vec3 centre = dice_vec3(state, near[0], near[1]), half = dice_vec3(state, sizes[0], sizes[1]);
    struct tia_vec3 top = {centre.x, ONE, centre.z};
    bool upright = dice_one_in(state, 2);

    s->kind = kinds[dice_next(state) % (sizeof kinds / sizeof kinds[0])];
    switch (s->kind) {
    case TIA_SPHERE:
        s->sphere.centre = centre;
        s->sphere.radius = half.x;
        break;
    case TIA_BOX:
        s->box.min = parts_moved(centre, half, -1);
        s->box.max = parts_moved(centre, half, 1);
        s->box.max.y = upright ? ONE : s->box.max.y;
        s->box.min.x = dice_one_in(state, 2) ? -ONE : s->box.min.x;
        s->box.max.x = s->box.max.x < -ONE / 2 ? -ONE / 2 : s->box.max.x;
        break;
    case TIA_CYLINDER:
        s->cylinder.base = (struct tia_vec3){centre.x, -ONE, centre.z};
        s->cylinder.top = upright ? top : parts_moved(top, half, 1);
        s->cylinder.radius = half.y;
        s->cylinder.capped = true;
        break;
    default:
        s->cone.base = (struct tia_vec3){centre.x, -ONE, centre.z};
        s->cone.top = upright ? top : parts_moved(top, half, 1);
        s->cone.base_radius = half.y;
        s->cone.top_radius = dice_one_in(state, 3) ? 0 : half.y / 2;
        s->cone.capped = true;
    }
}

static void random_half_space(uint64_t *state, struct tia_shape *s)
{
    static const struct tia_vec3 near[2] = {TIA_VEC3(-0.5, -0.5, -0.5), TIA_VEC3(0.5, 0.5, 0.5)};

    s->kind = TIA_PLANE;
    s->plane.point = dice_vec3(state, near[0], near[1]);
    s->plane.normal = dice_one_in(state, 2) ? (struct tia_dir3){0, TIA_Q30(-1), 0} : parts_random_direction(state);
}

/* Gives a member a transform: turned or only moved, and stretched or not. */
static void random_place(uint64_t *state, struct corpus_rays *out, struct tia_shape *s)
{
    static const struct tia_vec3 places[2] = {TIA_VEC3(-0.3, -0.3, -0.3), TIA_VEC3(0.3, 0.3, 0.3)};
    static const struct tia_vec3 turns[2] = {TIA_VEC3(-180, -180, -180), TIA_VEC3(180, 180, 180)};
    static const struct tia_vec3 scales[2] = {TIA_VEC3(0.6, 0.6, 0.6), TIA_VEC3(1.2, 1.2, 1.2)};
    struct tia_transform *t = &out->transforms[out->scene.transform_count];

    *t = (struct tia_transform){.scale = {ONE, ONE, ONE}};
    t->position = dice_vec3(state, places[0], places[1]);
    if (dice_one_in(state, 2))
        t->rotation = dice_vec3(state, turns[0], turns[1]);
    if (dice_one_in(state, 2))
        t->scale = dice_vec3(state, scales[0], scales[1]);
    s->transform = ++out->scene.transform_count;
}

/* Adds one step, of a member or of an operation; a half-space bounds the operand before it. Returns the change of the
 * number of operands. */
static int random_step(uint64_t *state, struct corpus_rays *out, struct tia_solid *solid, uint8_t *steps, int operands)
{
    struct tia_shape *member = &out->members[solid - out->solids][solid->member_count];

    if (operands > 1 && dice_one_in(state, 2)) {
        steps[solid->step_count++] = (uint8_t)(TIA_SOLID_UNION + dice_next(state) % 3);
        return -1;
    }
    member->material = (uint32_t)dice_between(state, 0, CORPUS_RAYS_OBJECTS + 2);
    steps[solid->step_count++] = TIA_SOLID_MEMBER;
    solid->member_count++;
    if (operands && dice_one_in(state, 4)) {
        random_half_space(state, member);
        steps[solid->step_count++] = (uint8_t)(TIA_SOLID_INTERSECTION + dice_next(state) % 2);
        return 0;
    }
    random_member(state, member);
    if (dice_one_in(state, 3))
        random_place(state, out, member);
    return 1;
}

static void random_solid(uint64_t *state, struct corpus_rays *out, struct tia_solid *solid)
{
    uint8_t *steps = out->steps[solid - out->solids];
    uint32_t most = (uint32_t)dice_between(state, 1, CORPUS_RAYS_MEMBERS);
    int operands = 0;

    *solid = (struct tia_solid){.members = out->members[solid - out->solids], .steps = steps};
    while (solid->member_count < most)
        operands += random_step(state, out, solid, steps, operands);
    for (; operands > 1; operands--)
        steps[solid->step_count++] = (uint8_t)(TIA_SOLID_UNION + dice_next(state) % 3);
}

/* The ground is no solid, nor is a shape without a transform: the solid takes the place of an instance. */
void corpus_add_solids(struct corpus_rays *out, uint64_t seed)
{
    struct tia_scene *s = &out->scene;
    uint64_t state = seed;

    s->solids = out->solids;
    for (uint32_t i = 0; i < s->shape_count && s->solid_count < CORPUS_RAYS_SOLIDS; i++) {
        struct tia_shape *shape = &out->shapes[i];
        if (!shape->transform)
            continue;
        shape->kind = TIA_SOLID;
        shape->solid = s->solid_count;
        if (dice_one_in(&state, 4))
            shape->transform = 0;
        random_solid(&state, out, &out->solids[s->solid_count++]);
    }
}
