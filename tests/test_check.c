/* tia_scene_check on a scene's parts, cameras, materials and textures: each rule at its limit and one step beyond. */
#include "refusals.h"

#define ONE 65536
#define UNIT "each channel must be in 0..1"

static struct tia_material material;
static struct tia_texture texture;
static const uint8_t texels[3];

static void set_up(void)
{
    material = (struct tia_material){0};
    texture = (struct tia_texture){.repeat = {ONE, ONE}, .width = 1, .height = 1, .texels = texels};
    scene = (struct tia_scene){.camera = {.fov = 25 * ONE},
                               .materials = &material,
                               .material_count = 1,
                               .textures = &texture,
                               .texture_count = 1};
}

TEST(arrays)
{
    const char *rule = "an array with a count must not be NULL";

    set_up();
    scene.shape_count = 1;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.transform_count = 1;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.textures = NULL;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.mesh_count = 1;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.grid_count = 1;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.track_count = 1;
    check_refused("scene", 0, "arrays", rule);
}

TEST(depth)
{
    set_up();
    scene.depth = 16;
    check_accepted();
    scene.depth = 17;
    check_refused("scene", 0, "depth", "must be in 1..16");
}

TEST(fog)
{
    struct tia_fog fog = {.colour = {TIA_Q30_ONE, 0, 0}, .distance = TIA_Q16(2)};

    set_up();
    scene.fog = &fog;
    check_accepted();
    fog.colour.g = TIA_Q30_ONE + 1;
    check_refused("fog", 0, "colour", "each channel must be in 0..1");
    fog.colour.g = -1;
    check_refused("fog", 0, "colour", "each channel must be in 0..1");
    fog.colour.g = 0;
    check_range(&fog.distance, TIA_RADIUS_MIN, INT32_MAX, "fog", 0, "distance", "must be at least 2^-10");
    fog.distance = TIA_Q16(2);
    check_range(&fog.height, TIA_RADIUS_MIN, INT32_MAX, "fog", 0, "height", "must be 0 or at least 2^-10");
    fog.height = 0;
    scene.shadows = TIA_SHADOWS_ZFAIL;
    check_refused("fog", 0, "distance", "needs traced rays for shadows");
    scene.shadows = TIA_SHADOWS_TRACED;
    check_accepted();
}

TEST(lens)
{
    struct tia_lens lens = {TIA_Q16(0.5), TIA_Q16(2)};

    set_up();
    scene.lens = &lens;
    check_accepted();
    check_range(&lens.radius, 1, TIA_Q16(2), "lens", 0, "radius", "must be above 0 and at most focus");
    lens.radius = 1;
    check_range(&lens.focus, TIA_RADIUS_MIN, INT32_MAX, "lens", 0, "focus", "must be at least 2^-10");
    lens.focus = TIA_Q16(2);
    scene.shadows = TIA_SHADOWS_MAP;
    check_refused("lens", 0, "radius", "needs traced rays for shadows");
    scene.shadows = TIA_SHADOWS_TRACED;
    check_accepted();
}

TEST(integration)
{
    struct tia_integration *how = &scene.integration;

    set_up();
    how->integrator = (enum tia_integrator)3;
    check_refused("scene", 0, "integration.integrator", "must be an integrator");
    how->integrator = TIA_PATHS;
    how->spp = TIA_SPP_MAX;
    how->bounces = TIA_BOUNCES_MAX;
    how->without = TIA_STRATEGY_SCATTERING;
    how->tone = TIA_TONE_SRGB;
    check_accepted();
    check_range(&how->distance, 0, INT32_MAX, "scene", 0, "integration.distance", "must be at least 0");
    check_range(&how->exposure, -TIA_EXPOSURE_MAX, TIA_EXPOSURE_MAX, "scene", 0, "integration.exposure",
                "must be in -24..24");
    how->spp++;
    check_refused("scene", 0, "integration.spp", "must be at most 2^24");
    how->spp = 0;
    how->bounces++;
    check_refused("scene", 0, "integration.bounces", "must be at most 1024");
    how->bounces = 0;
    how->without++;
    check_refused("scene", 0, "integration.without", "must be a strategy");
    how->without = 0;
    how->tone = (enum tia_tone)3;
    check_refused("scene", 0, "integration.tone", "must be a tone");
}

TEST(scale_bits)
{
    set_up();
    scene.scale_bits = 16;
    check_accepted();
    scene.scale_bits = -16;
    check_accepted();
    scene.scale_bits = 17;
    check_refused("scene", 0, "scale_bits", "must be in -16..16");
    scene.scale_bits = -17;
    check_refused("scene", 0, "scale_bits", "must be in -16..16");
}

/* A hierarchy of another scene is refused. */
TEST(bvh)
{
    struct tia_bvh bvh = {.unbounded_count = 1};

    set_up();
    scene.bvh = &bvh;
    check_refused("scene", 0, "bvh", "must be of this scene");
    bvh.unbounded_count = 0;
    check_accepted();
    bvh.objects.item_count = UINT32_MAX;
    bvh.unbounded_count = 1; /* 2^32 items in all */
    check_refused("scene", 0, "bvh", "must be of this scene");
}

TEST(samples)
{
    set_up();
    for (uint32_t n = 0; n < 300; n++) {
        scene.camera.samples = n;
        if (n == 0 || n == 1 || n == 4 || n == 16)
            check_accepted();
        else
            check_refused("camera", 0, "samples", "must be 1, 4 or 16");
    }
}

TEST(projections)
{
    const char *rule = "must be perspective, frustum or orthographic";

    set_up();
    scene.camera.window = (struct tia_window){-ONE, ONE, -ONE, ONE, 1};
    scene.camera.projection = (enum tia_projection)3;
    check_refused("camera", 0, "projection", rule);
    scene.camera.projection = (enum tia_projection)255;
    check_refused("camera", 0, "projection", rule);
    scene.camera.fov = 0; /* the field of view is only for perspective */
    scene.camera.projection = TIA_FRUSTUM;
    check_accepted();
    scene.camera.window.near = 0;
    check_refused("camera", 0, "window", "near must be above 0");
    scene.camera.projection = TIA_ORTHOGRAPHIC;
    check_accepted();
}

TEST(windows)
{
    for (int ortho = 0; ortho < 2; ortho++) {
        set_up();
        scene.camera.projection = ortho ? TIA_ORTHOGRAPHIC : TIA_FRUSTUM;
        scene.camera.window = (struct tia_window){-5, -4, 7, 8, ONE};
        check_accepted();
        scene.camera.window.top = 7;
        check_refused("camera", 0, "window", "bottom must be below top");
        scene.camera.window.top = 8;
        scene.camera.window.right = -5;
        check_refused("camera", 0, "window", "left must be below right, or both 0");
        scene.camera.window.left = scene.camera.window.right = 0;
        check_accepted();
        scene.camera.window.left = 1;
        check_refused("camera", 0, "window", "left must be below right, or both 0");
    }
}

/* With a 3, 4, 5 triangle the corner at 5 k is 2^31 - 3. */
TEST(orthographic_corners)
{
    const tia_q16 k = INT32_MAX / 5;

    set_up();
    scene.camera.projection = TIA_ORTHOGRAPHIC;
    scene.camera.window = (struct tia_window){-3 * k, 0, 0, 4 * k, 0};
    check_accepted();
    scene.camera.window = (struct tia_window){-3 * k, 0, -4 * k - 4, 4 * k, 0};
    check_refused("camera", 0, "window", FAR);
    scene.camera.window = (struct tia_window){INT32_MIN, 0, 0, 1, 0};
    check_refused("camera", 0, "window", FAR);
    scene.camera.projection = TIA_FRUSTUM;
    scene.camera.window.near = 1;
    check_accepted();
}

TEST(line_of_sight)
{
    const char *rule = "must be at least 0.056 degrees off the line of sight";

    set_up();
    check_accepted(); /* the reference coincides with the eye, but is not used */
    scene.camera.up = (struct tia_vec3){0, 0, 1};
    check_refused("camera", 0, "reference", "must not be the eye");
    scene.camera.reference = (struct tia_vec3){0, 1, 0};
    check_accepted();
    scene.camera.reference = (struct tia_vec3){0, 0, -7};
    check_refused("camera", 0, "up", rule);
    /* The tangent and the sine of this angle are the same to 2^-31: 1/1024, and a thousandth less. */
    scene.camera.up = (struct tia_vec3){0, 1001, 1024000};
    check_accepted();
    scene.camera.up = (struct tia_vec3){0, 999, -1024000};
    check_refused("camera", 0, "up", rule);
    scene.camera.up = (struct tia_vec3){-999, 0, 1024000};
    check_refused("camera", 0, "up", rule);
    scene.camera.up = (struct tia_vec3){-1001, 0, 1024000};
    check_accepted();
    scene.camera.reference = (struct tia_vec3){INT32_MAX, 0, 0};
    check_refused("camera", 0, "reference", FAR);
    scene.camera.reference.x = INT32_MAX - 1;
    check_accepted();
    scene.camera.eye.x = -1;
    check_refused("camera", 0, "reference", FAR);
}

TEST(materials)
{
    set_up();
    material.specular.r = 1;
    check_refused("material", 0, "exponent", "must be in 1..10000");
    material.exponent = ONE;
    check_accepted();
    material.refraction.r = 1;
    check_refused("material", 0, "index", "must be in 0.25..4");
    material.index = ONE;
    check_accepted();
    check_colour(&material.specular, TIA_Q30_ONE, "material", 0, "specular", UNIT);
    check_colour(&material.mirror, TIA_Q30_ONE, "material", 0, "mirror", UNIT);
    check_colour(&material.refraction, TIA_Q30_ONE, "material", 0, "refraction", UNIT);
    check_colour(&material.facing, TIA_Q30_ONE, "material", 0, "facing", UNIT);
    material.specular.b = material.refraction.g = 1;
    check_range(&material.exponent, ONE, 10000 * ONE, "material", 0, "exponent", "must be in 1..10000");
    check_range(&material.index, ONE / 4, 4 * ONE, "material", 0, "index", "must be in 0.25..4");
    material.texture = 1;
    check_accepted();
    material.texture = 2;
    check_refused("material", 0, "texture", "must be 0 or the number of a checker, an image or a noise");
    material.texture = 0;
    for (material.opacity = 1; material.opacity < 3; material.opacity++)
        check_refused("material", 0, "opacity", "must be 0 or the number of an opacity texture");
    texture.kind = TIA_OPACITY;
    check_refused("material", 0, "opacity", "must be 0 or the number of an opacity texture");
    material.opacity = 1;
    check_accepted();
    material.bump = 2;
    check_refused("material", 0, "bump", "must be 0 or the number of a texture");
    material.bump = 1;
    check_accepted();
    material.texture = 1;
    check_refused("material", 0, "texture", "must be 0 or the number of a checker, an image or a noise");
}

TEST(textures)
{
    set_up();
    texture.kind = (enum tia_texture_kind)4;
    check_refused("texture", 0, "kind", "must be a checker, an image, an opacity or a noise");
    texture.octaves = 1;
    for (int kind = 0; kind < 4; kind++) {
        texture.kind = (enum tia_texture_kind)kind;
        for (int i = 0; i < 2; i++)
            check_range(&texture.repeat[i], 64, INT32_MAX, "texture", 0, "repeat", "must be 1/1024 or more");
    }
    check_range(&texture.depth, -64 * ONE, 64 * ONE, "texture", 0, "depth", "must be in -64..64");
    texture.depth = 0;
    texture.octaves = 8;
    check_accepted();
    texture.octaves = 9;
    check_refused("texture", 0, "octaves", "must be in 1..8");
    texture.octaves = 0;
    check_refused("texture", 0, "octaves", "must be in 1..8");
    texture.kind = TIA_OPACITY;
    texture.cells[0].r = -1; /* cells are only for checkers */
    check_accepted();
    texture.cells[0].r = 0;
    texture.width = 16384;
    texture.height = 16384;
    check_accepted();
    texture.width = 16385;
    check_refused("texture", 0, "width", "must be in 1..16384");
    texture.width = 0;
    check_refused("texture", 0, "width", "must be in 1..16384");
    texture.width = 1;
    texture.height = 0;
    check_refused("texture", 0, "height", "must be in 1..16384");
    texture.height = 16385;
    check_refused("texture", 0, "height", "must be in 1..16384");
    texture.height = 1;
    texture.texels = NULL;
    check_refused("texture", 0, "texels", "must not be NULL");
    texture.octaves = 1;
    for (int kind = 0; kind < 2; kind++) {
        texture.kind = kind ? TIA_NOISE : TIA_CHECKER;
        check_colour(&texture.cells[0], TIA_Q30_ONE, "texture", 0, "cells", UNIT);
        check_colour(&texture.cells[1], TIA_Q30_ONE, "texture", 0, "cells", UNIT);
    }
}

int main(void)
{
    RUN(arrays);
    RUN(depth);
    RUN(fog);
    RUN(lens);
    RUN(integration);
    RUN(scale_bits);
    RUN(bvh);
    RUN(samples);
    RUN(projections);
    RUN(windows);
    RUN(orthographic_corners);
    RUN(line_of_sight);
    RUN(materials);
    RUN(textures);
    return check_status();
}
