/* tia_scene_check on shapes and transforms: each rule at its limit and one step beyond. */
#include "refused_shapes.h"

#define FLAT "too flat for its size: the radius around it, over the least scale, must be below 32768"

/* The counts are refused before any sphere is read: the array has fewer than sphere_count. */
TEST(counts)
{
    const char *rule = "spheres and shapes must be at most 2^24";
    static const struct tia_sphere sphere;

    set_up(TIA_BOX);
    scene.spheres = &sphere;
    scene.sphere_count = 1u << 24;
    check_refused("scene", 0, "counts", rule);
    scene.sphere_count = 1;
    scene.shape_count = 1u << 24;
    check_refused("scene", 0, "counts", rule);
    scene.sphere_count = 5;
    scene.shape_count = UINT32_MAX;
    check_refused("scene", 0, "counts", rule);
}

TEST(what_all_shapes_have)
{
    for (int kind = 0; kind <= TIA_ROUNDED; kind++) {
        set_up((enum tia_shape_kind)kind);
        shape->material = 2;
        check_accepted();
        shape->material = 3;
        check_refused("shape", 0, "material", "must be the index of a material");
        shape->material = 0;
        shape->transform = 1;
        if (kind == TIA_PLANE)
            check_refused("shape", 0, "transform", "must be 0 for a plane");
        else
            check_accepted();
        shape->transform = 2;
        check_refused("shape", 0, "transform", "must be 0 or the number of a transform");
        set_up((enum tia_shape_kind)kind);
        shapes[1] = sample((enum tia_shape_kind)kind);
        scene.shape_count = 2;
        check_accepted();
        shapes[1].material = UINT32_MAX;
        check_refused("shape", 1, "material", "must be the index of a material");
    }
    shape->kind = (enum tia_shape_kind)(TIA_ROUNDED + 1);
    check_refused("shape", 0, "kind", "must be a kind of shape");
    shape->kind = (enum tia_shape_kind) - 1;
    check_refused("shape", 0, "kind", "must be a kind of shape");
}

TEST(radii)
{
    tia_q16 *const radius[] = {&shape->sphere.radius, &shape->disc.radius, &shape->cylinder.radius};
    const enum tia_shape_kind kind[] = {TIA_SPHERE, TIA_DISC, TIA_CYLINDER};

    for (int i = 0; i < 3; i++) {
        const tia_q16 bad[] = {63, 0, -1, -64, INT32_MIN};
        set_up(kind[i]);
        *radius[i] = 64;
        check_accepted();
        for (int k = 0; k < 5; k++) {
            *radius[i] = bad[k];
            check_refused("shape", 0, "radius", RADIUS);
        }
    }
}

TEST(cones)
{
    const char *rule = "must be 0 or at least 2^-10";

    set_up(TIA_CONE);
    shape->cone.base_radius = 63;
    check_refused("shape", 0, "base_radius", rule);
    shape->cone.base_radius = -64;
    check_refused("shape", 0, "base_radius", rule);
    shape->cone.base_radius = 64;
    check_accepted();
    shape->cone.top_radius = 64;
    check_refused("shape", 0, "top_radius", "must differ from the base's");
    shape->cone.top_radius = 65;
    check_accepted();
    shape->cone.top_radius = 63;
    check_refused("shape", 0, "top_radius", rule);
    shape->cone.top_radius = 64;
    shape->cone.base_radius = 0;
    check_accepted();
    shape->cone.top_radius = 0;
    check_refused("shape", 0, "top_radius", "must differ from the base's");
}

TEST(tori)
{
    set_up(TIA_TORUS);
    shape->torus.axis.y = TIA_Q30_ONE / 2 - 1;
    check_refused("shape", 0, "axis", LENGTH);
    shape->torus.axis.y = TIA_Q30_ONE / 2;
    check_accepted();
    shape->torus.minor = 63;
    check_refused("shape", 0, "minor", RADIUS);
    shape->torus.minor = INT32_MIN;
    check_refused("shape", 0, "minor", RADIUS);
    shape->torus.minor = 64;
    shape->torus.major = 128;
    check_accepted();
    shape->torus.major = 127;
    check_refused("shape", 0, "major", "must be at least 2^-10 above minor");
    shape->torus.major = INT32_MIN;
    check_refused("shape", 0, "major", "must be at least 2^-10 above minor");
    shape->torus.major = INT32_MAX;
    shape->torus.minor = INT32_MAX - 64;
    check_refused("shape", 0, "place", FAR);
}

TEST(rounded_boxes)
{
    const char *rule = "must be at least twice the radius above min";
    tia_q16 *const max[] = {&shape->rounded.max.x, &shape->rounded.max.y, &shape->rounded.max.z};

    set_up(TIA_ROUNDED);
    shape->rounded.radius = 63;
    check_refused("shape", 0, "radius", RADIUS);
    shape->rounded.radius = 64;
    check_accepted();
    shape->rounded.radius = ONE / 2;
    check_accepted();
    for (int i = 0; i < 3; i++) {
        const tia_q16 bad[] = {ONE - 1, 0, INT32_MIN};
        for (int k = 0; k < 3; k++) {
            *max[i] = bad[k];
            check_refused("shape", 0, "max", rule);
        }
        *max[i] = ONE;
    }
    shape->rounded = (struct tia_rounded){{INT32_MIN, 0, 0}, {INT32_MAX, ONE, ONE}, 64};
    check_refused("shape", 0, "place", FAR);
}

/* Ends are 64 units of 2^-16 apart: along an axis, and at 2, 3, 6 times 9 and a little, |.| = 63 and more. */
static void check_ends(struct tia_vec3 *base, struct tia_vec3 *top)
{
    const char *rule = "must be at least 2^-10 from the base";

    *base = (struct tia_vec3){10, 20, 30};
    *top = (struct tia_vec3){10, -44, 30};
    check_accepted();
    top->y = -43;
    check_refused("shape", 0, "top", rule);
    *top = (struct tia_vec3){10 + 18, 20 + 27, 30 - 54}; /* 63 */
    check_refused("shape", 0, "top", rule);
    top->x = 10 - 21; /* 21^2 + 27^2 + 54^2 = 4086 < 4096 */
    check_refused("shape", 0, "top", rule);
    top->x = 10 - 22;
    check_accepted();
    *top = *base;
    check_refused("shape", 0, "top", rule);
    *base = (struct tia_vec3){INT32_MIN, 0, 0};
    *top = (struct tia_vec3){INT32_MAX, 0, 0};
    check_refused("shape", 0, "place", FAR);
}

TEST(ends_of_axes)
{
    set_up(TIA_CYLINDER);
    check_ends(&shape->cylinder.base, &shape->cylinder.top);
    set_up(TIA_CONE);
    check_ends(&shape->cone.base, &shape->cone.top);
}

TEST(normals_of_shapes)
{
    set_up(TIA_PLANE);
    shape->plane.normal = (struct tia_dir3){0, TIA_Q30_ONE / 2 - 1, 0};
    check_refused("shape", 0, "normal", LENGTH);
    shape->plane.normal.x = 1 << 16;
    check_accepted();
    set_up(TIA_DISC);
    shape->disc.normal = (struct tia_dir3){0, -TIA_Q30_ONE / 2 * 3 - 1, 0};
    check_refused("shape", 0, "normal", LENGTH);
    shape->disc.normal.y++;
    check_accepted();
}

TEST(boxes)
{
    tia_q16 *const max[] = {&shape->box.max.x, &shape->box.max.y, &shape->box.max.z};

    set_up(TIA_BOX);
    for (int i = 0; i < 3; i++) {
        *max[i] = 1;
        check_accepted();
        *max[i] = 0;
        check_refused("shape", 0, "max", "must be above min");
        *max[i] = -1;
        check_refused("shape", 0, "max", "must be above min");
        *max[i] = ONE;
    }
}

TEST(triangles)
{
    const char *rule = "must not be on one line";
    struct tia_vec3 *c = shape->triangle.corner;

    set_up(TIA_TRIANGLE);
    c[2] = c[1];
    check_refused("shape", 0, "corners", rule);
    c[2] = c[0];
    check_refused("shape", 0, "corners", rule);
    c[2] = c[1];
    c[1] = c[0];
    check_refused("shape", 0, "corners", rule);
    c[0] = (struct tia_vec3){-1000000000, 500000000, 7};
    c[1] = (struct tia_vec3){1000000000, -500000000, 7};
    c[2] = (struct tia_vec3){0, 0, 7};
    check_refused("shape", 0, "corners", rule);
    c[2].x = 1;
    check_accepted();
    c[2] = (struct tia_vec3){-2, 0, 7};
    check_accepted();
    c[2] = (struct tia_vec3){-2, 1, 7};
    check_refused("shape", 0, "corners", rule);
    c[2].z = 8;
    check_accepted();
    c[0] = (struct tia_vec3){0, 0, 0};
    c[1] = (struct tia_vec3){1, 1, 0};
    c[2] = (struct tia_vec3){1, -1, 0}; /* 1 * -1 and 1 * 1 differ only by their sign */
    check_accepted();
    /* differences of 33 bits, which no scale makes small enough */
    shape->transform = 1;
    transform.scale = (struct tia_vec3){ONE / 4, ONE / 4, ONE / 4};
    c[0] = (struct tia_vec3){INT32_MIN, INT32_MIN, 1};
    c[1] = (struct tia_vec3){INT32_MAX, INT32_MAX, 1};
    c[2] = (struct tia_vec3){0, 0, 1};
    check_refused("shape", 0, "corners", rule);
    c[2].x = -1;
    check_refused("shape", 0, "transform", FLAT);
}

/* The farthest corner of the box is 7 m = 2^31 - 2 away. */
TEST(distances)
{
    const tia_q16 m = INT32_MAX / 7;

    for (int i = 0; i < 8; i++) {
        tia_q16 x = i & 1 ? 2 * m : -2 * m, y = i & 2 ? 3 * m : -3 * m, z = i & 4 ? 6 * m : -6 * m;
        tia_q16 out = i & 1 ? 8 : -8;
        set_up(TIA_BOX);
        shape->box = (struct tia_box){{x < 0 ? x : 0, y < 0 ? y : 0, z < 0 ? z : 0},
                                      {x > 0 ? x : 1, y > 0 ? y : 1, z > 0 ? z : 1}};
        check_accepted();
        *(i & 1 ? &shape->box.max.x : &shape->box.min.x) += out;
        check_refused("shape", 0, "place", FAR);
        scene.camera.eye.x = out;
        check_accepted();
        set_up(TIA_MESH);
        vertices[1] = (struct tia_vec3){x, y, z};
        check_accepted();
        vertices[1].x += out;
        check_refused("shape", 0, "place", FAR);
        shapes[0].kind = TIA_BOX; /* without a transform it may be anywhere */
        shapes[0].box = (struct tia_box){{0, 0, 0}, {ONE, ONE, ONE}};
        check_accepted();
    }
}

TEST(places)
{
    set_up(TIA_PLANE);
    shape->plane.point.z = INT32_MAX - 1;
    check_accepted();
    shape->plane.point.z++;
    check_refused("shape", 0, "point", FAR);
    set_up(TIA_SPHERE); /* exact, like the scene's own spheres */
    shape->sphere.radius = INT32_MAX;
    check_accepted();
    shape->sphere.centre.y = 1;
    check_refused("shape", 0, "centre", FAR);
    shape->transform = 1;
    check_refused("shape", 0, "place", FAR);
    set_up(TIA_GRID);
    grids[0].corner.x = INT32_MIN + 2 * ONE;
    check_accepted();
    grids[0].corner.x = INT32_MIN;
    check_refused("shape", 0, "place", FAR);
    for (int kind = TIA_DISC; kind <= TIA_GRID; kind++) {
        set_up((enum tia_shape_kind)kind);
        shape->transform = 1;
        transform.position.y = INT32_MIN + 3 * ONE;
        check_accepted();
        transform.position.y = INT32_MAX - ONE / 2;
        if (kind != TIA_DISC)
            check_refused("shape", 0, "place", FAR);
    }
}

/* Positions are also checked for a transform that no shape uses. */
TEST(positions)
{
    set_up(TIA_BOX);
    scene.shape_count = 0;
    transform.position.z = INT32_MIN + 2;
    check_accepted();
    transform.position.z--;
    check_refused("transform", 0, "position", FAR);
    transform.position = (struct tia_vec3){0, 3 * (INT32_MAX / 5), 4 * (INT32_MAX / 5)}; /* 2^31 - 3 */
    check_accepted();
    scene.camera.eye.y = -8;
    check_refused("transform", 0, "position", FAR);
}

TEST(scales)
{
    tia_q16 *const scale[] = {&transform.scale.x, &transform.scale.y, &transform.scale.z};

    set_up(TIA_BOX);
    scene.shape_count = 0;
    for (int i = 0; i < 3; i++)
        check_range(scale[i], 64, 1024 * ONE, "transform", 0, "scale", "must be in 2^-10..1024");
}

/* A square with the side 2 a is scaled by 2^-k across: a sqrt 2 must be below 2^(31 - k), that is a below 1448.2 where
 * that is 2048. */
TEST(flatness)
{
    for (int k = 1; k <= 10; k++) {
        tia_q16 unit = 1 << (20 - k);
        set_up(TIA_BOX);
        shape->transform = 1;
        transform.scale.x = ONE >> k;
        shape->box = (struct tia_box){{0, -1448 * unit, -1448 * unit}, {1, 1448 * unit, 1448 * unit}};
        check_accepted();
        shape->box.max.y = shape->box.max.z = 1449 * unit;
        check_refused("shape", 0, "transform", FLAT);
        transform.scale.x += ONE >> (k + 4);
        check_accepted();
    }
}

int main(void)
{
    RUN(counts);
    RUN(what_all_shapes_have);
    RUN(radii);
    RUN(cones);
    RUN(tori);
    RUN(rounded_boxes);
    RUN(ends_of_axes);
    RUN(normals_of_shapes);
    RUN(boxes);
    RUN(triangles);
    RUN(distances);
    RUN(places);
    RUN(positions);
    RUN(scales);
    RUN(flatness);
    return check_status();
}
