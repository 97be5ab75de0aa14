/* Solids: rays with known hits, coinciding faces, boxes, refusals. */
#include "check.h"
#include "random.h"
#include "scene/solid.h"
#include "solid_rays.h"

#include <math.h>
#include <string.h>
#include <tia/tia.h>

/* Two overlapping balls of radius 2 at x = -1 and 1, along their axis: -3 -1 1 3. */
TEST(two_balls)
{
    const struct {
        uint8_t step;
        double at[2]; /* where a ray from x = -10 enters, and then leaves */
        uint32_t materials[2];
    } cases[] = {{U, {7, 13}, {0, 1}}, {I, {9, 11}, {1, 0}}, {D, {7, 9}, {0, 1}}};

    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        double in = cases[n].at[0], out = cases[n].at[1];
        begin();
        ball(-1, 0, 0, 2);
        ball(1, 0, 0, 2);
        step(cases[n].step);
        open_view();
        expect(ray_of(-10, 0, 0, 1, 0, 0), in, cases[n].materials[0], true);
        expect(ray_of(-10 + (in + out) / 2, 0, 0, 1, 0, 0), (out - in) / 2, cases[n].materials[1], false);
        expect(ray_of(-10 + out + 1, 0, 0, 1, 0, 0), -1, 0, true);
        expect(ray_of(10, 0, 0, -1, 0, 0), 20 - out, cases[n].materials[1], true);
        expect(ray_of(10, 2.5, 0, -1, 0, 0), -1, 0, true);
    }
}

/* A box with a bore along x and a ball taken out of the middle: a nested expression with all three operations. */
static void bored_box(void)
{
    begin();
    box(-2, -2, -2, 2, 2, 2);
    cylinder(q16s(-3, 0, 0), q16s(3, 0, 0), 0.5);
    ball(0, 0, 0, 1);
    step(U);
    step(D);
    ball(0, 0, 0, 3);
    step(I);
    open_view();
}

TEST(nested)
{
    bored_box();
    expect(ray_of(-10, 0, 0, 1, 0, 0), -1, 0, true);                        /* through the bore */
    expect(ray_of(-10, 0.75, 0, 1, 0, 0), 8, 0, true);                      /* the box's face */
    expect(ray_of(-1.5, 0.75, 0, 1, 0, 0), 1.5 - sqrt(7.0 / 16), 2, false); /* the ball's hollow, from the wall */
    expect(ray_of(0, 0, 0, 0, 1, 0), 1, 2, true);                           /* from the hollow */
    expect(ray_of(1.5, 0, 0, 0, 0, 1), 0.5, 1, true);                       /* from the bore */
    expect(ray_of(-10, 1.9, 1.9, 1, 0, 0), 10 - sqrt(9 - 2 * 1.9 * 1.9), 3, true); /* a corner that is rounded off */
    expect(ray_of(-10, 1.9, 1.95, 0.5, 0, 0), 10 - sqrt(9 - 1.9 * 1.9 - 1.95 * 1.95), 3, true);
    struct found wall = cast(ray_of(0, 0, 0, 0, 1, 0));
    NEAR((double)wall.normal.y / (double)NUM_UNIT_ONE, -1); /* the ball's normal, turned round */
}

/* A half-space cuts a ball; a ray within the plane's distance of the ball meets the cut. */
TEST(half_spaces)
{
    begin();
    ball(0, 0, 0, 2);
    member(TIA_PLANE)->plane = (struct tia_plane){q16s(0, 1, 0), {0, TIA_Q30_ONE, 0}};
    step(I);
    open_view();
    expect(ray_of(0.25, 10, 0, 0, -1, 0), 9, 1, true);
    expect(ray_of(0.25, 1.5, 0, 0, -1, 0), 0.5, 1, true);
    expect(ray_of(-10, 1.5, 0, 1, 0, 0), -1, 0, true);
    expect(ray_of(-10, 0, 0, 1, 0, 0), 8, 0, true);
    expect(ray_of(0, 0, 0, 0, 1, 0), 1, 1, false);
    steps[2] = D;
    open_view();
    expect(ray_of(0, -10, 0, 0, 1, 0), 11, 1, true);
    expect(ray_of(0, 10, 0, 0, -1, 0), 8, 0, true);
}

/* Random rays at a solid with coinciding faces never see what would be a sliver between them. */
static void never(double at_axis, int axis, uint32_t material)
{
    random_state = 3;
    for (int i = 0; i < 40000; i++) {
        double p[3] = {random_double() * 6, random_double() * 6, random_double() * 6}, q[3];
        for (int k = 0; k < 3; k++)
            q[k] = random_double() * 0.9;
        q[axis] = at_axis;
        p[axis] += p[axis] > 0 ? 3 : -3;
        double d[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, most = fmax(fabs(d[0]), fmax(fabs(d[1]), fabs(d[2])));
        struct found found = cast(ray_of(p[0], p[1], p[2], d[0] / most, d[1] / most, d[2] / most));
        CHECK_MSG(!found.met || found.material != material, "ray %d meets member %u at %.12g", i, material, found.t);
    }
}

TEST(faces_that_coincide)
{
    begin(); /* a bore that ends in the box's faces: its caps are never seen */
    box(-1, -1, -1, 1, 1, 1);
    cylinder(q16s(0, -1, 0), q16s(0, 1, 0), 0.9);
    step(D);
    open_view();
    random_state = 3;
    for (int i = 0; i < 40000; i++) {
        double x = random_double() * 3, z = random_double() * 3, a = random_double() * 0.5, b = random_double() * 0.5;
        struct found found = cast(ray_of(x, 5, z, (a - x) / 10, -0.4, (b - z) / 10));
        double y = found.met ? 5 - found.t * 0.4 / sqrt(pow((a - x) / 10, 2) + 0.16 + pow((b - z) / 10, 2)) : 0;
        CHECK_MSG(!found.met || found.material != 1 || fabs(y) < 1 - 1e-6, "ray %d meets a cap", i);
    }
    begin(); /* what is taken out of itself is empty */
    ball(0, 0, 0, 1);
    ball(0, 0, 0, 1);
    step(D);
    open_view();
    never(0, 1, 0);
    never(0, 1, 1);
    begin(); /* boxes side by side: the faces between them are never seen, and of equal faces the first is */
    box(-1, -1, -1, 0, 1, 1);
    box(0, -1, -1, 1, 1, 1);
    step(U);
    box(-1, -1, -1, 1, 1, 1);
    step(U);
    open_view();
    never(1, 1, 2);
    expect(ray_of(-0.5, 0.5, 0, 1, 0, 0), 1.5, 1, false);
}

/* A disc that is thinner than 2^-16 is not seen; one that is thicker is. */
TEST(thin_parts)
{
    for (int units = 0; units <= 4; units += 4) {
        begin();
        box(-1, -1, -1, 1, 1, 1);
        box(-1, -1, -1, 1, 1 - units / 65536.0, 1);
        step(D);
        open_view();
        expect(ray_of(0.25, 5, 0.25, 0, -1, 0), units ? 4 : -1, 0, true);
    }
}

/* The solid as a whole, and a member, are scaled, turned and moved: a box of 2 x 4 x 2 about (0, 10, 0) with a ball. */
TEST(placed)
{
    begin();
    box(-1, -1, -1, 1, 1, 1);
    ball(0, 0, 0, 1);
    step(D);
    transforms[0] = (struct tia_transform){q16s(0, 10, 0), q16s(0, 90, 0), q16s(1, 2, 1)};
    transforms[1] = (struct tia_transform){q16s(1, 0, 0), q16s(0, 0, 0), q16s(0.5, 0.5, 0.5)};
    scene.transform_count = 2;
    shapes[0].transform = 1;
    members[1].transform = 2;
    open_view();
    /* the ball's centre is (1, 0, 0) in the solid's axes, (0, 10, -1) in the world: an ellipsoid of 0.5 x 1 x 0.5 */
    expect(ray_of(0, 10, -5, 0, 0, 1), 4.5, 1, true);
    expect(ray_of(0, 10, 5, 0, 0, -1), 4, 0, true);
    expect(ray_of(0, 20, -0.75, 0, -1, 0), 8, 0, true);
    expect(ray_of(0, 10, -0.875, 0, 1, 0), sqrt(1 - 1.0 / 16), 1, true);
}

/* 32 members: balls in a row, of which every second one is taken out of the union of all before it. */
TEST(most_members)
{
    begin();
    for (int i = 0; i < TIA_SOLID_MEMBERS; i++) {
        ball(i, 0, 0, 0.75);
        if (i)
            step(i % 2 ? D : U);
    }
    open_view();
    expect(ray_of(-10, 0, 0, 1, 0, 0), 9.25, 0, true);
    expect(ray_of(0, 0, 0, 1, 0, 0), 0.25, 1, false);
    expect(ray_of(1, 0, 0, 1, 0, 0), 0.25, 2, true);
    expect(ray_of(40, 0, 0, -1, 0, 0), 40 - 30.25, 31, true);
}

static void box_is(double x0, double y0, double z0, double x1, double y1, double z1)
{
    struct tia_bounds b = tia_solid_box(&scene, &solid);
    struct tia_vec3 low = q16s(x0, y0, z0), high = q16s(x1, y1, z1);

    CHECK(b.min.x == low.x && b.min.y == low.y && b.min.z == low.z);
    CHECK(b.max.x == high.x && b.max.y == high.y && b.max.z == high.z);
}

TEST(boxes_around)
{
    begin();
    box(-1, -1, -1, 1, 1, 1);
    ball(1, 0, 0, 0.5);
    step(U);
    box_is(-1, -1, -1, 1.5, 1, 1);
    steps[2] = I;
    box_is(0.5, -0.5, -0.5, 1, 0.5, 0.5);
    steps[2] = D;
    box_is(-1, -1, -1, 1, 1, 1);
    member(TIA_PLANE)->plane = (struct tia_plane){q16s(0, 0.25, 0), {0, TIA_Q30_ONE, 0}};
    step(I);
    box_is(-1, -1, -1, 1, 0.25, 1);
    begin(); /* balls apart: nothing of a size */
    ball(0, 0, 0, 1);
    ball(5, 0, 0, 1);
    step(I);
    box_is(4, -1, -1, 4, 1, 1);
    open_view();
    expect(ray_of(-10, 0, 0, 1, 0, 0), -1, 0, true);
}

static void refused(const char *field)
{
    struct tia_fault fault = {0};

    CHECK_EQ(tia_scene_check(&scene, &fault), TIA_ERR_RANGE);
    CHECK_MSG(strcmp(fault.field, field) == 0, "%s %u: %s: %s", fault.thing, fault.index, fault.field, fault.rule);
}

TEST(refused_solids)
{
    begin();
    refused("members");
    ball(0, 0, 0, 1);
    shapes[0].solid = 1;
    refused("solid");
    shapes[0].solid = 0;
    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
    solid.members = NULL;
    refused("arrays");
    solid.members = members;
    members[0].material = TIA_SOLID_MEMBERS;
    refused("material");
    members[0].material = 0;
    members[0].transform = 1;
    refused("transform");
    members[0].transform = 0;
    members[0].sphere.radius = 1;
    refused("radius");
    members[0].sphere.radius = TIA_Q16(32767);
    members[0].sphere.centre.x = TIA_Q16(2);
    refused("place");
    members[0].kind = TIA_DISC;
    refused("kind");
    members[0].kind = TIA_CYLINDER;
    refused("kind");
    members[0].kind = TIA_SOLID;
    refused("kind");
    begin();
    member(TIA_PLANE)->plane.normal.y = TIA_Q30_ONE;
    refused("place");
    ball(0, 0, 0, 1);
    step(U);
    refused("place");
    steps[2] = I;
    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
    steps[2] = 4;
    refused("steps");
    steps[2] = M;
    refused("steps");
    steps[1] = I;
    refused("steps");
    solid.step_count = 2;
    refused("steps");
    begin(); /* one more operand than may wait */
    for (int i = 0; i <= TIA_SOLID_DEPTH; i++)
        ball(0, 0, 0, 1);
    for (int i = 0; i < TIA_SOLID_DEPTH; i++)
        step(U);
    refused("steps");
    begin();
    for (int i = 0; i <= TIA_SOLID_MEMBERS; i++)
        solid.member_count++;
    refused("members");
}

/* Half the diagonal of a box of 65536^3 is 56756: too much for a scale below 1, though a sphere of that width is not.
 */
TEST(members_of_the_largest_size)
{
    begin();
    member(TIA_BOX)->box = (struct tia_box){{-INT32_MAX, -INT32_MAX, -INT32_MAX}, {INT32_MAX, INT32_MAX, INT32_MAX}};
    transforms[0].scale = q16s(0.999, 0.999, 0.999);
    scene.transform_count = 1;
    members[0].transform = 1;
    refused("transform");
    members[0].box = (struct tia_box){q16s(-15000, -15000, -15000), q16s(15000, 15000, 15000)};
    struct tia_fault fault = {0};
    CHECK_MSG(!tia_scene_check(&scene, &fault), "%s: %s", fault.field, fault.rule);
}

int main(void)
{
    RUN(two_balls);
    RUN(nested);
    RUN(half_spaces);
    RUN(faces_that_coincide);
    RUN(thin_parts);
    RUN(placed);
    RUN(most_members);
    RUN(boxes_around);
    RUN(refused_solids);
    RUN(members_of_the_largest_size);
    close_view();
    return check_status();
}
