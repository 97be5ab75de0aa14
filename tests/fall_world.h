/* fall_world.h - scenes with falling balls, read from texts. */
#ifndef TESTS_FALL_WORLD_H
#define TESTS_FALL_WORLD_H

#include <math.h>
#include <tia/motion.h>

#include "reading.h"

#define START "camera eye 0 0 20\nmaterial m colour 1\n"
#define FLOOR "plane point 0 0 0 normal 0 1 0 material m\n"

static struct reading world;
static uint64_t memory[8192];

static inline void open_world(const char *text)
{
    static char whole[4100];

    (void)snprintf(whole, sizeof whole, START "%.4000s", text);
    read_string(&world, TIA_FORMAT_TIA, whole);
    CHECK_MSG(!world.status, "%u: %s", (unsigned)world.reader.error.line, world.reader.error.text);
}

/* Returns a ball's centre in units of 2^-16. */
static inline struct tia_vec3 centre(const struct tia_scene *scene, uint32_t ball)
{
    const struct tia_shape *s = &world.scene.shapes[world.scene.falling->balls[ball].shape];
    const struct tia_transform *t = &scene->transforms[s->transform - 1];

    return (struct tia_vec3){t->position.x + s->sphere.centre.x, t->position.y + s->sphere.centre.y,
                             t->position.z + s->sphere.centre.z};
}

static inline struct tia_vec3 ball_at(uint32_t ball, tia_q16 time)
{
    struct tia_scene out;

    CHECK(tia_scene_at_size(&world.scene) <= sizeof memory);
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &world.scene, time, NULL), TIA_OK);
    return centre(&out, ball);
}

static inline void check_place(uint32_t ball, double time, double x, double y, double z, double within)
{
    struct tia_vec3 c = ball_at(ball, (tia_q16)(time * 65536));
    double off = fmax(fabs(c.x / 65536. - x), fmax(fabs(c.y / 65536. - y), fabs(c.z / 65536. - z)));

    CHECK_MSG(off <= within, "ball %u at %.5f s: %.6f %.6f %.6f, not %.6f %.6f %.6f", (unsigned)ball, time,
              c.x / 65536., c.y / 65536., c.z / 65536., x, y, z);
}

#define ULP (0.5001 / 65536)

#endif
