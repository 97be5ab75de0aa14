/* Tori and rounded boxes as members of solids: rays with known hits. */
#include "solid_rays.h"

static void torus(double x, double y, double z, double major, double minor)
{
    member(TIA_TORUS)->torus =
        (struct tia_torus){q16s(x, y, z), {0, TIA_Q30_ONE, 0}, (tia_q16)(major * 65536), (tia_q16)(minor * 65536)};
}

/* A line through a torus is inside twice: -5 -3 3 5. A box takes the ring's far half away, a groove is the torus taken
 * out of a plate. */
TEST(rings)
{
    begin();
    torus(0, 0, 0, 4, 1);
    box(0, -2, -6, 6, 2, 6);
    step(D);
    open_view();
    expect(ray_of(-10, 0, 0, 1, 0, 0), 5, 0, true);
    expect(ray_of(-4, 0, 0, 1, 0, 0), 1, 0, false);
    expect(ray_of(-2, 0, 0, 1, 0, 0), -1, 0, true);
    expect(ray_of(10, 0, 0, -1, 0, 0), 13, 0, true);
    expect(ray_of(-0.5, 0, 4, 1, 0, 0), 0.5, 1, false); /* the cut */
    steps[2] = I;
    open_view();
    expect(ray_of(-10, 0, 0, 1, 0, 0), 13, 0, true);
    expect(ray_of(4, 0, 0, 1, 0, 0), 1, 0, false);
    begin();
    box(-6, -3, -6, 6, 0, 6);
    torus(0, 0, 0, 4, 1);
    step(D);
    open_view();
    expect(ray_of(4, 10, 0, 0, -1, 0), 11, 1, true);
    expect(ray_of(0, 10, 0, 0, -1, 0), 10, 0, true);
    expect(ray_of(-10, -0.5, 0, 1, 0, 0), 4, 0, true);
    expect(ray_of(-4, -0.5, 0, 1, 0, 0), sqrt(0.75), 1, true);
    expect(ray_of(-2, -0.5, 0, 1, 0, 0), 6 - sqrt(0.75), 1, false);
}

/* A torus of half the size, moved: its second chord is found behind its first one, whatever the roundings are. */
TEST(placed_ring)
{
    for (int i = 0; i < 50; i++) {
        double angle = i * 0.7, x = cos(angle), z = sin(angle);
        begin();
        torus(0, 0, 0, 4, 1);
        box(-6, -2, -6, 6, 2, 6);
        step(I);
        ball(0, 0, 0, 1);
        step(U);
        transforms[0] = (struct tia_transform){q16s(0, 0, 0), q16s(0, 0, 0), q16s(0.3, 0.3, 0.3)};
        scene.transform_count = 1;
        members[0].transform = 1;
        open_view();
        double scale = transforms[0].scale.x / 65536.0;
        expect(ray_of(-10 * x, 0, -10 * z, x, 0, z), 10 - 5 * scale, 0, true);
        expect(ray_of(-2 * x, 0.5, -2 * z, x, 0, z), 2 - sqrt(0.75), 2, true);
        members[2].sphere.radius = TIA_Q16(0.5);
        open_view();
        expect(ray_of(-0.7 * x, 0, -0.7 * z, x, 0, z), 0.2, 2, true);
        expect(ray_of(0.7 * x, 0, 0.7 * z, x, 0, z), 3 * scale - 0.7, 0, true);
        steps[4] = D; /* the ball has no part in the ring */
        open_view();
        expect(ray_of(0, 0, 0, x, 0, z), 3 * scale, 0, true);
        expect(ray_of(-4 * scale * x, 0, -4 * scale * z, x, 0, z), scale, 0, false);
    }
}

TEST(rounded_member)
{
    begin();
    member(TIA_ROUNDED)->rounded = (struct tia_rounded){q16s(-2, -2, -2), q16s(2, 2, 2), TIA_Q16(1)};
    ball(0, 2, 0, 1);
    step(D);
    open_view();
    expect(ray_of(0, 10, 0, 0, -1, 0), 9, 1, true);
    expect(ray_of(1.5, 10, 0, 0, -1, 0), 9 - sqrt(0.75), 0, true); /* the rounded edge */
    expect(ray_of(0, 0, 0, 1, 0, 0), 2, 0, false);
    expect(ray_of(-10, 1.5, 0, 1, 0, 0), 9 - sqrt(0.75), 0, true);
    expect(ray_of(-1.25, 1.5, 0, 1, 0, 0), 1.25 - sqrt(0.75), 1, false);
}

int main(void)
{
    RUN(rings);
    RUN(placed_ring);
    RUN(rounded_member);
    close_view();
    return check_status();
}
