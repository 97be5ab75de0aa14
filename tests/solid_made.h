/* solid_made.h - a scene of one solid, made member by member. */
#ifndef TESTS_SOLID_MADE_H
#define TESTS_SOLID_MADE_H

#include <string.h>
#include <tia/tia.h>

enum { M = TIA_SOLID_MEMBER, U = TIA_SOLID_UNION, I = TIA_SOLID_INTERSECTION, D = TIA_SOLID_DIFFERENCE };

static struct tia_material materials[TIA_SOLID_MEMBERS];
static struct tia_shape members[TIA_SOLID_MEMBERS + 1], shapes[1];
static uint8_t steps[TIA_SOLID_STEPS];
static struct tia_solid solid;
static struct tia_scene scene;
static struct tia_transform transforms[2];

/* Begins a solid of no members; member i has material i. */
static inline void begin(void)
{
    memset(members, 0, sizeof members);
    for (uint32_t i = 0; i <= TIA_SOLID_MEMBERS; i++)
        members[i].material = i % TIA_SOLID_MEMBERS;
    solid = (struct tia_solid){members, steps, 0, 0};
    shapes[0] = (struct tia_shape){.kind = TIA_SOLID};
    scene = (struct tia_scene){.camera = {.eye = {0, 0, TIA_Q16(100)}, .fov = TIA_Q16(40)},
                               .materials = materials,
                               .material_count = TIA_SOLID_MEMBERS,
                               .shapes = shapes,
                               .shape_count = 1,
                               .transforms = transforms,
                               .solids = &solid,
                               .solid_count = 1};
}

static inline struct tia_vec3 q16s(double x, double y, double z)
{
    return (struct tia_vec3){(tia_q16)(x * 65536), (tia_q16)(y * 65536), (tia_q16)(z * 65536)};
}

static inline void step(uint8_t kind)
{
    steps[solid.step_count++] = kind;
}

static inline struct tia_shape *member(enum tia_shape_kind kind)
{
    step(M);
    members[solid.member_count].kind = kind;
    return &members[solid.member_count++];
}

static inline void box(double x0, double y0, double z0, double x1, double y1, double z1)
{
    member(TIA_BOX)->box = (struct tia_box){q16s(x0, y0, z0), q16s(x1, y1, z1)};
}

static inline void ball(double x, double y, double z, double radius)
{
    struct tia_shape *s = member(TIA_SPHERE);

    s->sphere.centre = q16s(x, y, z);
    s->sphere.radius = (tia_q16)(radius * 65536);
}

static inline void cylinder(struct tia_vec3 base, struct tia_vec3 top, double radius)
{
    member(TIA_CYLINDER)->cylinder = (struct tia_cylinder){base, top, (tia_q16)(radius * 65536), true};
}

#endif
