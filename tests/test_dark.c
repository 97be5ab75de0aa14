/* Scenes too dark to see: a warning below 2^-13, which is 131072 in Q2.30, and none from there on. */
#include <string.h>

#include <tia/motion.h>
#include <tia/read.h>

#include "check.h"

enum { LIMIT = 131072 };

static struct tia_material material;
static struct tia_light light;
static struct tia_binding key;
static const struct tia_sphere ball = {.centre = TIA_VEC3(0, 0, -5), .radius = TIA_Q16(1)};
static struct tia_scene scene;

static void begin(void)
{
    material = (struct tia_material){.colour = TIA_RGB(1, 0.5, 0)};
    light = (struct tia_light){.centre = TIA_VEC3(3, 3, 0), .emission = TIA_RGB(1, 1, 1)};
    key = (struct tia_binding){.key = 'a', .state = light};
    scene = (struct tia_scene){.camera = {.fov = TIA_Q16(40)},
                               .materials = &material,
                               .spheres = &ball,
                               .lights = &light,
                               .bindings = &key,
                               .material_count = 1,
                               .sphere_count = 1,
                               .light_count = 1};
}

/* Returns the `thing` of tia_scene_check's warning, or "" if there is none. */
static const char *warned(void)
{
    struct tia_fault fault = {"untouched", 7, "", ""};

    CHECK_EQ(tia_scene_check(&scene, &fault), TIA_OK);
    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
    CHECK(!fault.thing || (*fault.field && strstr(fault.rule, "2^-13")));
    return fault.thing ? fault.thing : "";
}

static bool light_is_told(int32_t emission)
{
    light.emission = (struct tia_rgb){1, emission, 0};
    return !strcmp(warned(), "light");
}

TEST(lights)
{
    begin();
    CHECK(!strcmp(warned(), ""));
    CHECK(light_is_told(LIMIT - 1));
    CHECK(!light_is_told(LIMIT));
    CHECK(light_is_told(1));
    light.emission = (struct tia_rgb){0, 0, 0}; /* intended: a hidden light has no emission */
    CHECK(!strcmp(warned(), ""));
    CHECK(light_is_told(TIA_Q16(1.99))); /* a colour written as a length */
    light.quadratic = 1;                 /* makes it 2^16 times as bright at the distance 1 */
    CHECK(!light_is_told(TIA_Q16(1.99)));
}

TEST(lights_of_keys)
{
    begin();
    scene.light_count = 0;
    scene.binding_count = 1;
    key.state.emission = (struct tia_rgb){0, 0, LIMIT - 1};
    CHECK(!strcmp(warned(), "key"));
    key.state.emission.b = LIMIT;
    CHECK(!strcmp(warned(), ""));
    key.state.emission.b = LIMIT - 1;
    scene.light_count = 1; /* a bright light */
    CHECK(!strcmp(warned(), ""));
}

TEST(exposure_and_bits)
{
    begin();
    CHECK(light_is_told(LIMIT - 1));
    scene.integration =
        (struct tia_integration){.exposure = TIA_Q16(1)}; /* Whitted's integrator ignores the exposure */
    CHECK(light_is_told(LIMIT - 1));
    scene.integration.integrator = TIA_PATHS;
    CHECK(light_is_told(LIMIT / 2 - 1));
    CHECK(!light_is_told(LIMIT / 2));
    scene.integration.exposure = 0;
    light.emission_bits = 3;
    CHECK(light_is_told(LIMIT / 8 - 1));
    CHECK(!light_is_told(LIMIT / 8));
}

TEST(materials)
{
    const struct tia_rgb dark = {LIMIT - 1, 0, 0}, seen = {0, 0, LIMIT};
    struct tia_rgb *const colours[] = {&material.colour,     &material.specular, &material.mirror,
                                       &material.refraction, &material.facing,   &material.emission};
    static const struct tia_keyframe keyframe = {.time = 0, .value = {LIMIT, 0, 0}};
    const struct tia_track track = {.target = TIA_SETS_COLOUR, .keys = &keyframe, .key_count = 1};

    begin();
    for (unsigned i = 0; i < sizeof colours / sizeof *colours; i++) {
        material = (struct tia_material){.index = TIA_Q16(1), .exponent = TIA_Q16(1)};
        CHECK(!strcmp(warned(), ""));
        *colours[i] = dark;
        CHECK(!strcmp(warned(), "material"));
        *colours[i] = seen;
        CHECK(!strcmp(warned(), ""));
    }
    material.emission = dark;
    scene.tracks = &track;
    scene.track_count = 1;
    CHECK(!strcmp(warned(), ""));
}

static int read_text(const char *text, bool strict, struct tia_read_warning *warnings)
{
    static uint64_t memory[4096];
    struct tia_reader reader = {.text = text, .length = strlen(text), .strict = strict, .warnings = warnings};
    struct tia_scene read;
    size_t need;
    int status = tia_read(&reader, &read, memory, sizeof memory, &need);

    if (status && warnings)
        warnings[TIA_WARN_DARK].at = reader.error;
    return status;
}

/* Scene files cause the warning, too: 2^-13 is 0.0001220703125. */
TEST(files)
{
    static struct tia_read_warning warnings[TIA_WARNINGS];
    const char *dark = "material m colour 0.5 0.5 0.5\nsphere centre 0 0 -5 radius 1 material m\n"
                       "light point at 3 3 0 emission 0.000122 0 0\n",
               *seen = "material m colour 0.5 0.5 0.5\nsphere centre 0 0 -5 radius 1 material m\n"
                       "light point at 3 3 0 emission 0.0001221 0 0\n";

    CHECK_EQ(read_text(seen, true, warnings), TIA_OK);
    CHECK_EQ(warnings[TIA_WARN_DARK].count, 0);
    CHECK_EQ(read_text(dark, false, NULL), TIA_OK);
    CHECK_EQ(read_text(dark, false, warnings), TIA_OK);
    CHECK_EQ(warnings[TIA_WARN_DARK].count, 1);
    CHECK_EQ(warnings[TIA_WARN_DARK].at.line, 3);
    CHECK(strstr(warnings[TIA_WARN_DARK].at.text, "2^-13"));
    CHECK_EQ(read_text(dark, true, warnings), TIA_ERR_RANGE);
    CHECK_EQ(warnings[TIA_WARN_DARK].at.line, 3);
}

int main(void)
{
    RUN(lights);
    RUN(lights_of_keys);
    RUN(exposure_and_bits);
    RUN(materials);
    RUN(files);
    return check_status();
}
