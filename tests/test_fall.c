/* Balls that fall, against closed forms and against fall_oracle.h. */
#include "fall_oracle.h"
#include "fall_world.h"
#include "random.h"

/* The position is x + v t + g t^2 / 2, to half a unit, at times within ticks as well. */
TEST(free_fall)
{
    open_world("sphere name a centre 1 100 -2 radius 0.5 material m\ngravity 0.5 -9.75 0.25 until 5\n"
               "fall a velocity 3 2.5 -1\n");
    for (int n = 0; n < 300; n++) {
        double t = n * 1111 % (5 * 65536) / 65536.;
        check_place(0, t, 1 + 3 * t + 0.25 * t * t, 100 + 2.5 * t - 4.875 * t * t, -2 - t + 0.125 * t * t, ULP);
    }
    check_place(0, -1, 1, 100, -2, 0);
    check_place(0, 9, 1 + 15 + 6.25, 100 + 12.5 - 121.875, -2 - 5 + 3.125, ULP);
    CHECK_EQ(tia_scene_duration(&world.scene), 5 * TIA_Q16_ONE);
    read_end(&world);
}

/* The balls meet at 1 s, 1 apart, and each continues with the other's velocity. */
TEST(equal_masses_exchange_velocities)
{
    open_world(
        "sphere name a centre -3.5 0 0 radius 0.5 material m\nsphere name b centre 1.5 0 0 radius 0.5 material m\n"
        "fall a velocity 3 0 0\nfall b velocity -1 0 0\n");
    check_place(0, 0.5, -2, 0, 0, ULP);
    check_place(0, 1, -0.5, 0, 0, ULP);
    check_place(0, 3, -0.5 - 2, 0, 0, 1e-5);
    check_place(1, 3, 0.5 + 6, 0, 0, 1e-5);
    read_end(&world);
}

/* v1' = (m1 - e m2) v1 / (m1 + m2), v2' = (1 + e) m1 v1 / (m1 + m2) */
TEST(masses_and_restitution)
{
    open_world("sphere name a centre -3 0 0 radius 0.5 material m\nsphere name b centre 0 0 0 radius 0.5 material m\n"
               "fall a velocity 2 0 0 mass 3 restitution 0.9\nfall b restitution 0.5\n");
    check_place(0, 3, -1 + 2 * (3 - 0.5) * 2 / 4, 0, 0, 2e-5);
    check_place(1, 3, 2 * 1.5 * 3 * 2 / 4, 0, 0, 2e-5);
    read_end(&world);
}

/* A ball meets one of a quarter of its mass at 45 degrees: only the component along the line of centres is
 * exchanged. */
TEST(along_the_line_of_centres)
{
    open_world("sphere name a centre -2 0 0 radius 0.5 material m\n"
               "sphere name b centre 0 0.70710678118 0 radius 0.5 material m\nfall a velocity 1 0 0\nfall b\n");
    double met = 2 - sqrt(0.5);
    check_place(0, 3, -sqrt(0.5) + (3 - met) / 2, -(3 - met) / 2, 0, 2e-5);
    check_place(1, 3, (3 - met) / 2, sqrt(0.5) + (3 - met) / 2, 0, 2e-5);
    read_end(&world);
}

/* With restitution 1 a ball returns to its height each time, 2 sqrt(2 h / g) apart: no energy is lost. */
TEST(energy_stays)
{
    open_world(FLOOR "sphere name a centre 0 2.5 0 radius 0.5 material m\ngravity 0 -10 0 until 60\nfall a\n");
    double period = 2 * sqrt(2 * 2 / 10.);
    for (int n = 1; n < 40; n++) {
        check_place(0, n * period, 0, 2.5, 0, 1e-4);
        check_place(0, (n + 0.25) * period, 0, 2.5 - 5 * period * period / 16, 0, n * 3e-5);
    }
    read_end(&world);
}

/* Each bounce reaches e^2 of the height before; the ball lies still in the end, on the floor and not in it. */
TEST(restitution_of_the_floor)
{
    open_world(FLOOR "sphere name a centre 0 2.5 0 radius 0.5 material m\ngravity 0 -10 0 until 60\n"
                     "fall a restitution 0.5 velocity 0.25 0 0\n");
    double down = sqrt(2 * 2 / 10.), v = 10 * down;
    check_place(0, down + v / 2 / 10, 0.25 * (down + v / 20), 0.5 + 2 * 0.25, 0, 1e-4);
    check_place(0, down + v / 10 + v / 40, 0.25 * (down + v / 10 + v / 40), 0.5 + 2 * 0.0625, 0, 1e-4);
    check_place(0, 10, 2.5, 0.5, 0, 2e-5);
    check_place(0, 60, 15, 0.5, 0, 2e-5);
    read_end(&world);
}

/* Contacts are found to 2^-20 s and never late: a ball of 1000 a second is at the wall 2^-10 early at most. */
TEST(contacts_are_never_late)
{
    for (int n = 0; n < 50; n++) {
        char text[300];
        double start = 1 + n * 0.0137;
        (void)snprintf(text, sizeof text,
                       FLOOR "sphere name a centre 0 %.6f 0 radius 0.5 material m\n"
                             "fall a velocity 0 -1000 0\n",
                       start);
        open_world(text);
        double after = ball_at(0, 656).y / 65536., exact = 0.5 - (start - 0.5 - 1000 * 656 / 65536.);
        CHECK_MSG(after - exact > -3e-5 && after - exact < 2 * 1000. / 1048576 + 3e-5, "%f, not %f", after, exact);
        read_end(&world);
    }
}

/* A cradle within one tick: ball 0 hits ball 1, which had no contact ahead before, and ball 1 hits ball 2. */
TEST(one_contact_makes_the_next)
{
    open_world("sphere name a centre -1.5 0 0 radius 0.5 material m\nsphere name b centre 0 0 0 radius 0.5 material m\n"
               "sphere name c centre 1.25 0 0 radius 0.5 material m\nfall a velocity 512 0 0\nfall b\nfall c\n"
               "gravity 0 0 0 until 1\n");
    check_place(0, 1, -1, 0, 0, 2e-3);
    check_place(1, 1, 0.25, 0, 0, 2e-3);
    check_place(2, 1, 1.25 + 512 - 0.75, 0, 0, 4e-3);
    read_end(&world);
}

/* Balls 0 and 1 would meet in this tick, but 2 pushes 1 out of the way before: 0 continues straight. */
TEST(a_partner_that_is_gone)
{
    open_world("sphere name a centre -1 0 0 radius 0.25 material m\nsphere name b centre 0 0 0 radius 0.25 material m\n"
               "sphere name c centre 0 -0.75 0 radius 0.25 material m\n"
               "fall a velocity 200 0 0\nfall b\nfall c velocity 0 900 0\ngravity 0 0 0 until 1\n");
    check_place(0, 0.00390625, -1 + 200 / 256., 0, 0, ULP);
    check_place(0, 0.25, -1 + 50, 0, 0, ULP);
    check_place(1, 0.25, 0, 900 * 0.25 - 0.25, 0, 2e-3);
    check_place(2, 0.25, 0, -0.5, 0, 2e-3);
    read_end(&world);
}

/* Balls bounce off the side of a box that is turned by 45 degrees, and off its edge, where the line to the centre is
 * the normal. */
TEST(boxes)
{
    open_world("box name b min -2 -2 -2 max 2 2 2 scale 0.5 rotate 0 0 45 material m\n"
               "sphere name a centre 5 0.5 0 radius 0.25 material m\nfall a velocity -2 0 0\ngravity 0 0 0 until 5\n"
               "sphere name c centre -5 0 0 radius 0.25 material m\nfall c velocity 2 0 0\n");
    double face = sqrt(2) * (1 + 0.25) - 0.5, met = (5 - face) / 2, edge = sqrt(2) + 0.25, met_edge = (5 - edge) / 2;
    check_place(0, 4, face, 0.5 + 2 * (4 - met), 0, 3e-5);
    check_place(1, 4, -edge - 2 * (4 - met_edge), 0, 0, 3e-5);
    read_end(&world);
}

/* At 900 a second, which is 3.5 in a tick, a ball of 0.25 never passes through a wall of 0.1. */
TEST(fast_balls_and_thin_walls)
{
    for (int n = 0; n < 40; n++) {
        char text[300];
        double start = 3 + n * 0.11;
        (void)snprintf(text, sizeof text,
                       "box min 0 -5 -5 max 0.1 5 5 material m\n"
                       "sphere name a centre %.3f 0 0 radius 0.25 material m\n"
                       "fall a velocity -900 0 0\n",
                       start);
        open_world(text);
        check_place(0, 0.125, 0.35 + 900 * 0.125 - (start - 0.35), 0, 0, 4e-3);
        read_end(&world);
    }
}

/* The bits do not depend on earlier computations, nor on the end of the film. */
TEST(any_frame_by_itself)
{
    static const char balls[] =
        FLOOR "box min -3 -1 -3 max -2 9 3 rotate 0 10 5 material m\n"
              "sphere name a centre 0 3 0 radius 0.5 material m\nsphere name b centre 0.25 5 0 radius 0.5 material m\n"
              "sphere name c centre -0.5 7 0.125 radius 0.5 material m\nfall a restitution 0.75\n"
              "fall b velocity -3 0 0 restitution 0.75\nfall c restitution 0.875 mass 0.5\ngravity 0 -9.8 0 until ";
    struct tia_vec3 whole[40][3];
    char text[1000];

    (void)snprintf(text, sizeof text, "%s 5\n", balls);
    open_world(text);
    for (int n = 0; n < 40; n++)
        for (uint32_t i = 0; i < 3; i++)
            whole[n][i] = ball_at(i, n * 8111);
    for (int n = 39; n >= 0; n--)
        for (uint32_t i = 0; i < 3; i++) {
            memset(memory, n * 7, sizeof memory);
            struct tia_vec3 again = ball_at(i, n * 8111);
            CHECK(!memcmp(&again, &whole[n][i], sizeof again));
        }
    read_end(&world);
    for (int n = 0; n < 40; n++) {
        (void)snprintf(text, sizeof text, "%s %.16f\n", balls, n * 8111 / 65536.);
        open_world(text);
        for (uint32_t i = 0; i < 3; i++) {
            struct tia_vec3 last = ball_at(i, 6 * TIA_Q16_ONE);
            CHECK(!memcmp(&last, &whole[n][i], sizeof last));
        }
        read_end(&world);
    }
}

/* ---- random balls between six walls, against the oracle ---- */

static double near_16(double x)
{
    return round(x * 65536) / 65536;
}

static char *say_ball(char *to, const char *end, int i, const struct oracle_ball *b)
{
    const double *x = b->place, *v = b->velocity;
    int n = snprintf(to, (size_t)(end - to),
                     "sphere name b%d centre %.16f %.16f %.16f radius %.16f material m\n"
                     "fall b%d velocity %.16f %.16f %.16f restitution %.16f mass %.16f\n",
                     i, x[0], x[1], x[2], b->radius, i, v[0], v[1], v[2], b->restitution, b->mass);
    return to + n;
}

static void make_room(struct oracle_falling *o)
{
    *o = (struct oracle_falling){.gravity = {0, -9.75, 0}, .ball_count = 4, .plane_count = 6};
    for (int p = 0; p < 6; p++) {
        o->planes[p][p / 2] = p % 2 ? -1 : 1;
        o->planes[p][3] = -3;
    }
    for (int i = 0; i < 4; i++) {
        struct oracle_ball *b = &o->balls[i];
        b->radius = near_16(0.6 + 0.3 * random_double());
        b->mass = near_16(1.5 + random_double());
        b->restitution = near_16(0.9 + 0.1 * random_double());
        for (int k = 0; k < 3; k++) {
            b->place[k] = near_16((i >> k & 1 ? 1.5 : -1.5) + 0.5 * random_double());
            b->velocity[k] = near_16(6 * random_double());
        }
    }
}

static void say_room(const struct oracle_falling *o)
{
    static char text[3000];
    char *to = text;

    for (int p = 0; p < 6; p++)
        to += sprintf(to, "plane point %d %d %d normal %d %d %d material m\n",
                      p == 0   ? -3
                      : p == 1 ? 3
                               : 0,
                      p == 2   ? -3
                      : p == 3 ? 3
                               : 0,
                      p == 4   ? -3
                      : p == 5 ? 3
                               : 0,
                      (int)o->planes[p][0], (int)o->planes[p][1], (int)o->planes[p][2]);
    to += sprintf(to, "gravity 0 -9.75 0 until 5\n");
    for (int i = 0; i < o->ball_count; i++)
        to = say_ball(to, text + sizeof text, i, &o->balls[i]);
    open_world(text);
}

/* An error grows about tenfold with each contact of two round objects, so the time is short. */
TEST(as_the_oracle_has_it)
{
    int contacts = 0;

    for (int n = 0; n < 150; n++) {
        struct oracle_falling o;
        make_room(&o);
        say_room(&o);
        for (int step = 1; step <= 5; step++) {
            contacts += oracle_fall(&o, 0.125);
            for (int i = 0; i < o.ball_count; i++)
                check_place((uint32_t)i, step * 0.125, o.balls[i].place[0], o.balls[i].place[1], o.balls[i].place[2],
                            1e-3);
        }
        read_end(&world);
    }
    CHECK_MSG(contacts > 500, "only %d contacts", contacts);
}

#define HEAP 12

static void all_at(tia_q16 time, struct tia_vec3 at[HEAP])
{
    struct tia_scene out;

    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &world.scene, time, NULL), TIA_OK);
    for (uint32_t i = 0; i < HEAP; i++)
        at[i] = centre(&out, i);
}

/* Three layers of balls in a box come to rest, none in another or in a wall. */
TEST(a_heap_comes_to_rest)
{
    static char text[4000];
    char *to = text;
    struct tia_vec3 at[HEAP], later[HEAP];

    to += sprintf(to, FLOOR "box min -2 0 -2 max -1 9 2 material m\nbox min 1 0 -2 max 2 9 2 material m\n"
                            "box min -1 0 -2 max 1 9 -1 material m\nbox min -1 0 1 max 1 9 2 material m\n"
                            "gravity 0 -9.8 0 until 9\n");
    for (int i = 0; i < HEAP; i++)
        to += sprintf(to, "sphere name s%d centre %.3f %.3f %.3f radius 0.4 material m\nfall s%d restitution 0.5\n", i,
                      (i & 1 ? 0.5 : -0.5) + i * 0.004, 1 + i / 4 * 1.1, (i & 2 ? 0.45 : -0.5) - i * 0.003, i);
    open_world(text);
    all_at(5 * TIA_Q16_ONE, at);
    all_at(6 * TIA_Q16_ONE, later);
    for (int i = 0; i < HEAP; i++) {
        CHECK_MSG(at[i].y >= 26214 - 2 && at[i].y < 3 * 65536 && abs(at[i].x) <= 39322 + 2 && abs(at[i].z) <= 39322 + 2,
                  "%d: %d %d %d", i, at[i].x, at[i].y, at[i].z);
        CHECK_MSG(abs(at[i].y - later[i].y) < 65536 / 50, "%d still moves: %d", i, later[i].y - at[i].y);
        for (int j = 0; j < i; j++) {
            double x = at[i].x - at[j].x, y = at[i].y - at[j].y, z = at[i].z - at[j].z;
            CHECK_MSG(sqrt(x * x + y * y + z * z) > 0.79998 * 65536, "%d is in %d", i, j);
        }
    }
    read_end(&world);
}

int main(void)
{
    RUN(free_fall);
    RUN(equal_masses_exchange_velocities);
    RUN(masses_and_restitution);
    RUN(along_the_line_of_centres);
    RUN(energy_stays);
    RUN(restitution_of_the_floor);
    RUN(contacts_are_never_late);
    RUN(one_contact_makes_the_next);
    RUN(a_partner_that_is_gone);
    RUN(boxes);
    RUN(fast_balls_and_thin_walls);
    RUN(any_frame_by_itself);
    RUN(as_the_oracle_has_it);
    RUN_LONG(a_heap_comes_to_rest);
    return check_status();
}
