/* Groups and repeat blocks: their transforms and refusals. */
#include <math.h>

#include "oracle/shape.h"
#include "scene_texts.h"

/* ---- groups ---- */

TEST(groups_move_and_scale)
{
    check_reads(M "group at 1 2 3 scale 2\n  sphere radius 1 centre 0 1 0 material m\n"
                  "  group at 1 0 0 scale 1 3 1\n    box min 0 0 0 max 1 1 1 at 0 1 0 scale 0.5 material m\n  end\n"
                  "  mesh x\n  vertex 0 0 0\n  end\nend\nsphere radius 1 material m\n");
    CHECK(now.scene.shape_count == 2 && now.scene.transform_count == 2 && now.scene.sphere_count == 1);
    CHECK(is_vec(now.scene.transforms[0].position, 1, 2, 3) && is_vec(now.scene.transforms[0].scale, 2, 2, 2));
    CHECK(is_vec(now.scene.transforms[1].position, 3, 8, 3) && is_vec(now.scene.transforms[1].scale, 1, 3, 1));
    CHECK(is_vec(now.scene.transforms[1].rotation, 0, 0, 0));
}

/* Angles from a single line are unchanged, those about one axis add up, and right angles are exact. */
TEST(groups_rotate)
{
    check_reads(
        M "group rotate 10.3 20.7 -30.1\nsphere radius 1 at 1 0 0 material m\nend\n"
          "group at 5 0 0\nsphere radius 1 rotate 77 123 -170 material m\nend\n"
          "group rotate 0 30.25 0\nsphere radius 1 rotate 0 20.5 0 material m\nend\n"
          "group rotate 0 90 0 scale 1 2 3\nsphere radius 1 at 1 0 0 rotate 0 0 90 scale 4 5 6 material m\nend\n");
    const struct tia_transform *t = now.scene.transforms;
    CHECK(is_vec(t[0].rotation, 10.3, 20.7, -30.1) && is_vec(t[1].rotation, 77, 123, -170));
    CHECK(is_vec(t[2].rotation, 0, 50.75, 0));
    /* x becomes y, and so is scaled by 2, y becomes x and is scaled by 1; then x becomes -z */
    CHECK(is_vec(t[3].position, 0, 0, -1) && is_vec(t[3].scale, 8, 5, 18));
}

static uint32_t seed = 1;

static double any(double least, double most)
{
    seed = seed * 1664525 + 1013904223;
    return least + (most - least) * (seed >> 8) / (double)(1 << 24);
}

static struct tia_transform any_transform(double uneven)
{
    double s = any(0.5, 2);

    return (struct tia_transform){
        {(tia_q16)(any(-9, 9) * 65536), (tia_q16)(any(-9, 9) * 65536), (tia_q16)(any(-9, 9) * 65536)},
        {(tia_q16)(any(-200, 200) * 65536), (tia_q16)(any(-200, 200) * 65536), (tia_q16)(any(-200, 200) * 65536)},
        {(tia_q16)(s * 65536), (tia_q16)(s * (1 + uneven) * 65536), (tia_q16)(s * (1 + uneven / 2) * 65536)}};
}

static char *say(char *to, const char *what, const struct tia_transform *t)
{
    return to + sprintf(to, "%s at %.9f %.9f %.9f rotate %.9f %.9f %.9f scale %.9f %.9f %.9f\n", what,
                        t->position.x / 65536.0, t->position.y / 65536.0, t->position.z / 65536.0,
                        t->rotation.x / 65536.0, t->rotation.y / 65536.0, t->rotation.z / 65536.0, t->scale.x / 65536.0,
                        t->scale.y / 65536.0, t->scale.z / 65536.0);
}

/* Compares a point placed by the oracle's transforms, one after the other, with the point placed by the single
 * transform that was read. Positions and scales are half of 2^-16 off, three angles half of 2^-16 degrees each: at 2 by
 * 8 from the position 1.6e-5. */
static void check_composed(const struct tia_transform t[3], const struct tia_transform *read, int bits)
{
    for (int i = 0; i < 8; i++) {
        struct oracle_vec v = {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        struct oracle_vec want = transform_point(&t[0], transform_point(&t[1], transform_point(&t[2], v)));
        struct oracle_vec got = transform_point(read, scaled(v, ldexp(1, bits)));
        double off = length(sub(scaled(got, ldexp(1, -bits)), want));
        CHECK_MSG(off < 5e-5, "%g off", off);
    }
}

TEST(groups_within_groups)
{
    for (int i = 0; i < 300; i++) {
        char text[1000], *end = text + sprintf(text, M);
        struct tia_transform t[3] = {any_transform(0), any_transform(0), any_transform(0.5)};
        if (i % 3 == 0) /* the innermost group is uneven along the axis about which the shape turns */
            t[1].scale.y += TIA_Q16_ONE, t[2].rotation.x = t[2].rotation.z = 0;
        if (i % 3 == 1) /* near the poles of the angles */
            t[0].rotation.y = TIA_Q16(90), t[1].rotation.x = t[1].rotation.z = 0, t[1].rotation.y = i % 2 * 3,
            t[2].rotation.y = i - 150;
        end = say(say(end, "group", &t[0]), "group", &t[1]);
        end = say(end, "box min 0 0 0 max 1 1 1 material m", &t[2]);
        (void)sprintf(end, "end\nend\n");
        check_reads(text);
        if (!now.status)
            check_composed(t, &now.scene.transforms[0], (int)now.scene.scale_bits);
    }
}

TEST(groups_refused)
{
    const char *deep = "group\ngroup\ngroup\ngroup\ngroup\ngroup\ngroup\ngroup\n";
    char text[200];

    check_refused("group", "1:1: group of line 1 has no end");
    check_refused("group\nend\nend", "3:1: 'end' ends nothing, expected a group before it, in the same file");
    check_refused("group name x\nend", "1:7: 'name' is not a field of a group, expected at, rotate or scale");
    check_refused(
        M "group scale 1 2 1\nsphere radius 1 rotate 0 0 30 material m\nend",
        "3:1: 'sphere' would be sheared: it is rotated in a group that is scaled unevenly, expected one scale "
        "for that group, or the rotation around it");
    check_refused(M "group scale 1 2 1\n group rotate 1 0 0\nend\nend",
                  "3:2: 'group' would be sheared: it is rotated in a group that is scaled unevenly, expected one scale "
                  "for that group, or the rotation around it");
    check_refused("group scale 0\nend", "1:1: 'group' is scaled out of range, expected 1/1024 to 1024");
    check_refused("group scale 100\ngroup scale 100\nend\nend",
                  "2:1: 'group' is scaled out of range with its groups, expected 1/1024 to 1024 in all");
    check_refused("group scale 1000\ngroup at 2e9 0 0\nend\nend",
                  "2:1: 'group' is moved out of range by its groups, expected a place nearer to 0");
    check_refused("group scale 1000\ngroup at 0 0 -2e9\nend\nend",
                  "2:1: 'group' is moved out of range by its groups, expected a place nearer to 0");
    check_refused(M "group scale 100\nsphere radius 1 at 0 0 4e7 material m\nend",
                  "3:1: 'sphere' is moved out of range by its groups, expected a place nearer to 0");
    check_refused("group\nlight at 0 1 0\nend", "2:1: 'light' is not moved by groups, expected it outside of them");
    check_refused(M "group\nplane normal 0 1 0 material m\nend",
                  "3:1: 'plane' is not moved by groups, expected it outside of them");
    check_refused("group\ncamera eye 0 0 0\nend", "2:1: 'camera' is not moved by groups, expected it outside of them");
    check_refused("group\nkey a light 1 ambient\nend",
                  "2:1: 'key' is not moved by groups, expected it outside of them");
    check_refused(M "group\nsphere radius 1 name ball material m\nend\nanimate ball at 0: 0 0 0",
                  "3:22: 'ball' moves, expected it outside of groups");
    (void)sprintf(text, "%sgroup\n%s", deep, "end\nend\nend\nend\nend\nend\nend\nend\nend");
    check_refused(text, "9:1: 'group' is one too deep, expected at most 8 groups within each other");
}

/* ---- repeat ---- */

TEST(copies_of_a_block)
{
    check_reads(M "repeat 3 at 1 0 0\n  sphere radius 1 material m\n  repeat 2 at 0 2 0 scale 0.5\n"
                  "    box min 0 0 0 max 1 1 1 at 0 0 4 material m\n  end\nend\nsphere radius 1 material m\n");
    CHECK(now.scene.shape_count == 9 && now.scene.transform_count == 9 && now.scene.sphere_count == 1);
    for (int i = 0; i < 3 && now.scene.transform_count == 9; i++) {
        const struct tia_transform *t = &now.scene.transforms[3 * i];
        CHECK(is_vec(t[0].position, i, 0, 0) && is_vec(t[0].scale, 1, 1, 1));
        CHECK(is_vec(t[1].position, i, 0, 4) && is_vec(t[1].scale, 1, 1, 1));
        CHECK(is_vec(t[2].position, i, 2, 2) && is_vec(t[2].scale, 0.5, 0.5, 0.5));
    }
    check_reads(M "group at 5 0 0\nrepeat 1 at 1 1 1\nsphere radius 1 material m\nend\nend");
    CHECK(now.scene.shape_count == 1 && is_vec(now.scene.transforms[0].position, 5, 0, 0));
}

/* Copy k of a point is placed k times by the oracle's transform; see check_composed() for the error. */
TEST(copies_are_placed_in_turn)
{
    for (int i = 0; i < 100; i++) {
        char text[1000], *end = text + sprintf(text, M);
        struct tia_transform none = {.scale = {TIA_Q16_ONE, TIA_Q16_ONE, TIA_Q16_ONE}};
        struct tia_transform t[3] = {none, any_transform(0), any_transform(0)};
        t[1].scale.x = t[1].scale.y = t[1].scale.z = (tia_q16)(any(0.9, 1.05) * 65536);
        end = say(say(end, "repeat 3", &t[1]), "box min 0 0 0 max 1 1 1 material m", &t[2]);
        (void)sprintf(end, "end\n");
        check_reads(text);
        if (now.status || now.scene.transform_count != 3) {
            CHECK(!"three copies");
            continue;
        }
        check_composed(t, &now.scene.transforms[1], (int)now.scene.scale_bits);
        t[0] = t[1];
        check_composed(t, &now.scene.transforms[2], (int)now.scene.scale_bits);
    }
}

TEST(copies_refused)
{
    check_refused("repeat\nend", "1:7: the line ends here, expected a whole number from 1 to 65536");
    check_refused("repeat 0\nend", "1:8: '0' is out of range, expected a whole number from 1 to 65536");
    check_refused("repeat 65537\nend", "1:8: '65537' is out of range, expected a whole number from 1 to 65536");
    check_refused("repeat 2 name x\nend",
                  "1:10: 'name' is not a field of a repeat block, expected at, rotate or scale");
    check_refused("repeat 2 scale 0\nend", "1:1: 'repeat' is scaled out of range, expected 1/1024 to 1024");
    check_refused("repeat 12 scale 2\nend",
                  "1:1: 'repeat' is scaled out of range with its groups, expected 1/1024 to 1024 in all");
    check_refused("repeat 2", "1:1: repeat of line 1 has no end");
    check_refused("repeat 2\nend 1", "2:5: '1' is too much, expected the end of the line");
    check_refused("repeat 2\nmaterial m\nend", "2:1: 'material' is not repeated, expected it outside of repeat blocks");
    check_refused("repeat 2\ngroup\ninclude x\nend\nend",
                  "3:1: 'include' is not repeated, expected it outside of repeat blocks");
    check_refused(M "repeat 2\nsphere radius 1 name a material m\nend",
                  "3:22: 'a' is already defined, expected another name");
}

TEST(too_many_copied_lines)
{
    check_refused("repeat 65536\nrepeat 128\nend\nend\nrepeat 65536\nrepeat 128\nend\nend",
                  "7:1: 'end' is a line too many, expected at most 16777216 in repeat blocks");
}

int main(void)
{
    RUN(groups_move_and_scale);
    RUN(groups_rotate);
    RUN(groups_within_groups);
    RUN(groups_refused);
    RUN(copies_of_a_block);
    RUN(copies_are_placed_in_turn);
    RUN(copies_refused);
    RUN_LONG(too_many_copied_lines);
    read_end(&now);
    return check_status();
}
