/* The checking build over the built-in scene and random ones: no number leaves its range, and the pixels are those of
 * q16. Sums that overflow end the program: the compiler checks them. */
#include "arch/frames.h"
#include "check.h"
#include "reports.h"

static unsigned scene_count = 60; /* default, or the program's argument */

static void draw_both(const struct tia_scene *scene, unsigned width, unsigned height, bool dither)
{
    uint32_t crc = frames_checksum(&tia_core_q16, scene, width, height, dither);

    reports = 0;
    CHECK_EQ(frames_checksum(&tia_core_chk, scene, width, height, dither), crc);
    CHECK_MSG(reports == 0, "%u reports, the first %s", reports, first_report);
}

TEST(thesis_scene_keeps_its_ranges)
{
    static const char *const keys[] = {"", "a", "d", "s", "w"};
    static const uint16_t sizes[][2] = {{160, 120}, {1, 1}, {641, 1}, {2, 480}, {8192, 1}, {1, 8192}};
    struct corpus_scene scene;

    for (size_t i = 0; i < sizeof keys / sizeof keys[0] * (sizeof sizes / sizeof sizes[0]); i++) {
        const uint16_t *size = sizes[i / (sizeof keys / sizeof keys[0])];
        CHECK_EQ(corpus_thesis(&scene, keys[i % (sizeof keys / sizeof keys[0])], size[0], size[1]), TIA_OK);
        draw_both(&scene.scene, size[0], size[1], i % 2 == 1);
    }
}

TEST(random_scenes_keep_their_ranges)
{
    struct corpus_scene scene;

    for (unsigned i = 0; i < check_count(scene_count); i++) {
        corpus_random(&scene, 17, i);
        draw_both(&scene.scene, 40 + 3 * i, 150 - 2 * i, i % 3 == 0);
    }
}

TEST(random_general_scenes_keep_their_ranges)
{
    static struct corpus_rays scene;

    for (unsigned i = 0; i < check_count(scene_count); i++) {
        corpus_random_rays(&scene, 3, i);
        draw_both(&scene.scene, 32, 24, i % 2 == 1);
    }
}

/* Scenes found by fuzzing, each of which was once beyond some range: a light nearer to a surface than its distance is
 * known, an image of two pixels, v.v that rounds to nothing in one 8000 times as wide as high, a caster with its centre
 * at the eye, and L.L - r^2 = 2^48 - 2^12, which rounds up to a power of two. In units of 2^-16. */
static const struct {
    struct tia_vec3 eye;
    tia_q16 fov;
    struct tia_sphere spheres[3];
    uint32_t sphere_count;
    struct tia_light lights[3];
    uint32_t light_count;
    uint16_t width, height;
} found[] = {
    {{65430, 65430, 65430},
     TIA_Q16(150),
     {{{65430, 65430, 65430}, 65430, 0}, {{65430, 65430, 65645}, 65430, 0}},
     2,
     {{{65430, 65539, 0}, 0, TIA_RGB(1, 1, 1)}, {{0, 0, 0}, 0, TIA_RGB(1, 1, 1)}},
     2,
     7957,
     1},
    {{0, 11141082, 11141082},
     TIA_Q16(97),
     {{{11141082, 11141082, 11141082}, 11141082, 0}},
     1,
     {{{0, 0, 0}, 0, TIA_RGB(1, 1, 1)}},
     1,
     2,
     1},
    {{11141230, 11141086, 11141082},
     11141082,
     {{{11141119, 1617952769, 65480}, 11141082, 0}},
     1,
     {{{11141082, 11141082, 11141082}, 11141120, TIA_RGB(1, 1, 1)}, {{0, 0, 0}, 0, TIA_RGB(1, 1, 1)}},
     2,
     8161,
     1},
    {{65430, 65430, 65430},
     TIA_Q16(150),
     {{{65539, -106, 65430}, 65430, 0}, {{65430, 65430, 0}, 65430, 0}, {{65430, 65430, 65430}, 65430, 0}},
     3,
     {{{65430, 65430, 65430}, 65430, TIA_RGB(1, 1, 1)}, {{65645, 65430, 620756630}, 65430, TIA_RGB(1, 1, 1)}},
     2,
     6325,
     1},
    {{0, 0, 0}, TIA_Q16(1), {{{0, 0, -16777216}, 64, 0}}, 1, {{{0, 0, 0}, 0, TIA_RGB(1, 1, 1)}}, 1, 161, 8191},
};

TEST(found_scenes_keep_their_ranges)
{
    static const struct tia_material white = {.colour = TIA_RGB(1, 1, 1)};

    for (size_t i = 0; i < sizeof found / sizeof found[0]; i++) {
        struct tia_scene scene = {.camera = {found[i].eye, found[i].fov},
                                  .materials = &white,
                                  .spheres = found[i].spheres,
                                  .lights = found[i].lights,
                                  .material_count = 1,
                                  .sphere_count = found[i].sphere_count,
                                  .light_count = found[i].light_count};
        draw_both(&scene, found[i].width, found[i].height, false);
    }
}

int main(int argc, char **argv)
{
    scene_count = (unsigned)check_number(argc, argv, 1, scene_count);
    RUN(thesis_scene_keeps_its_ranges);
    RUN(random_scenes_keep_their_ranges);
    RUN_LONG(random_general_scenes_keep_their_ranges);
    RUN(found_scenes_keep_their_ranges);
    return check_status();
}
