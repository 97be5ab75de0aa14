/* Solids in .tia files: members, steps, places, and refusals. */
#include "scene_texts.h"

static void check_steps(const struct tia_solid *solid, const char *steps)
{
    static const char letters[] = "MUID";

    CHECK_EQ(solid->step_count, strlen(steps));
    for (uint32_t i = 0; i < solid->step_count; i++)
        CHECK_MSG(letters[solid->steps[i]] == steps[i], "step %u is %c, not %c", (unsigned)i, letters[solid->steps[i]],
                  steps[i]);
}

#define BALL "sphere radius 1 material m\n"
#define TWO "difference\n" BALL BALL "end\n"

TEST(operations_become_steps)
{
    check_reads(M "difference\n" BALL "union\n" BALL BALL BALL "end\nintersection\n" BALL
                  "plane normal 0 1 0 material m\n"
                  "end\nend\n" TWO "union\n" BALL "end\n");
    CHECK(now.scene.solid_count == 3 && now.scene.shape_count == 3 && now.scene.sphere_count == 0);
    check_steps(&now.scene.solids[0], "MMMUMUDMMID");
    check_steps(&now.scene.solids[1], "MMD");
    check_steps(&now.scene.solids[2], "M");
    CHECK(now.scene.solids[0].member_count == 6 && now.scene.solids[0].members[5].kind == TIA_PLANE);
    for (uint32_t i = 0; i < 3; i++)
        CHECK(now.scene.shapes[i].kind == TIA_SOLID && now.scene.shapes[i].solid == i &&
              !now.scene.shapes[i].transform);
    CHECK(now.scene.transform_count == 0);
}

/* The solid has its own place and that of the groups around it; members have theirs and those of what is in the solid.
 */
TEST(places)
{
    check_reads(M "group at 0 5 0\ndifference at 1 0 0 scale 2\nsphere radius 1 at 3 0 0 material m\n"
                  "union at 0 0 4\n" BALL "group scale 3\nsphere radius 1 at 1 0 0 material m\nend\nend\n"
                  "repeat 2 at 0 1 0\n" BALL "end\nend\nend\n" BALL);
    const struct tia_solid *s = now.scene.solids;
    const struct tia_transform *t = now.scene.transforms;
    CHECK(now.scene.solid_count == 1 && s->member_count == 5 && now.scene.shape_count == 1);
    check_steps(s, "MMMUDMDMD");
    CHECK(now.scene.shapes[0].transform == 1 && is_vec(t[0].position, 1, 5, 0) && is_vec(t[0].scale, 2, 2, 2));
    CHECK(is_vec(t[s->members[0].transform - 1].position, 3, 0, 0));
    CHECK(is_vec(t[s->members[1].transform - 1].position, 0, 0, 4));
    CHECK(is_vec(t[s->members[2].transform - 1].position, 3, 0, 4));
    CHECK(is_vec(t[s->members[2].transform - 1].scale, 3, 3, 3));
    CHECK(!s->members[3].transform && is_vec(t[s->members[4].transform - 1].position, 0, 1, 0));
    CHECK_EQ(now.scene.sphere_count, 1);
}

TEST(solids_move_and_appear)
{
    check_reads(M "union name u appears 2\n" BALL "end\nanimate u at 0: 0 0 0  1: 1 0 0\n");
    CHECK(now.scene.shapes[0].transform == 1 && now.scene.track_count == 2);
    check_reads(M "repeat 3 at 2 0 0\n" TWO "end\n");
    CHECK(now.scene.solid_count == 3 && now.scene.shapes[2].transform == 3);
    check_steps(&now.scene.solids[2], "MMD");
}

/* Long solids, far apart: the unit of length has room for all members. */
TEST(large_members)
{
    check_reads(
        M "intersection\nbox min -1 -1 -1 max 1 1 1 material m\nsphere radius 100000 at 100000 0 0 material m\nend\n");
    CHECK(now.scene.scale_bits < 0);
}

TEST(refusals)
{
    check_refused(M "union\nend", "3:1: 'end' ends a solid without members, expected a shape before it");
    check_refused(M "union\n" BALL, "2:1: union of line 2 has no end");
    check_refused(M "union\nlight at 0 0 0\nend",
                  "3:1: 'light' is not a part of a solid, expected members, operations, groups or end");
    check_refused(M "union\ndisc radius 1 normal 0 1 0 material m\nend",
                  "3:1: 'disc' cannot be a member of a solid, expected a sphere, plane, box or torus, or a cylinder or "
                  "cone that is capped");
    check_refused(
        M "union\ncylinder base 0 0 0 top 0 1 0 radius 1 material m\nend",
        "3:1: 'cylinder' cannot be a member of a solid, expected a sphere, plane, box or torus, or a cylinder "
        "or cone that is capped");
    check_refused(
        M "union\nsphere radius 1 material m name x\nend",
        "3:1: 'sphere' is a member, which has no name, no appears and no vanishes, expected them in the first "
        "line of the solid");
    check_refused(M "union\nrepeat 33 at 1 0 0\n" BALL "end\nend",
                  "4:1: 'sphere' is a member too many, expected at most 32 in a solid");
    check_refused(M "union\nunion at 1 0 0\nplane normal 0 1 0 material m\nend\nend",
                  "4:1: 'plane' is not moved by groups, expected it outside of them");
    check_refused(M "union\nplane normal 0 1 0 material m\nend",
                  "2:1: union: must be bounded: a box or the like must be intersected");
    check_refused(M "difference material m\nend",
                  "2:12: 'material' is not a field of a solid, expected appears, vanishes, name, at, rotate or scale");
}

int main(void)
{
    RUN(operations_become_steps);
    RUN(places);
    RUN(solids_move_and_appear);
    RUN(large_members);
    RUN(refusals);
    read_end(&now);
    return check_status();
}
