/* rendering.c - checks a scene's settings for the renderers. */
#include "scene_check.h"

#include <tia/integrator.h>

static int check_integration(const struct check *check)
{
    const struct tia_integration *how = &check->scene->integration;

    REQUIRE(tia_integrator_name((unsigned)how->integrator), "integration.integrator", "must be an integrator");
    REQUIRE(how->spp <= TIA_SPP_MAX, "integration.spp", "must be at most 2^24");
    REQUIRE(how->bounces <= TIA_BOUNCES_MAX, "integration.bounces", "must be at most 1024");
    REQUIRE(how->without <= TIA_STRATEGY_SCATTERING, "integration.without", "must be a strategy");
    REQUIRE(how->distance >= 0, "integration.distance", "must be at least 0");
    REQUIRE(how->tone == TIA_TONE_DEFAULT || tia_tone_name((unsigned)how->tone), "integration.tone", "must be a tone");
    REQUIRE(tia_check_is_between(how->exposure, -TIA_EXPOSURE_MAX, TIA_EXPOSURE_MAX), "integration.exposure",
            "must be in -24..24");
    return TIA_OK;
}

static int check_bright(const struct check *check, uint32_t bits)
{
    REQUIRE(bits <= TIA_EMISSION_BITS_MAX, "emission_bits", "must be in 0..13");
    return TIA_OK;
}

/* Checks the rules that apply only to sampling integrators. */
static int check_emission(struct check *check)
{
    const struct tia_scene *scene = check->scene;
    int status = TIA_OK;

    check->thing = "material";
    for (check->index = 0; !status && check->index < scene->material_count; check->index++)
        status = check_bright(check, scene->materials[check->index].emission_bits);
    check->thing = "light";
    for (check->index = 0; !status && check->index < scene->light_count; check->index++)
        status = check_bright(check, scene->lights[check->index].emission_bits);
    check->thing = "key";
    for (check->index = 0; !status && check->index < scene->binding_count; check->index++)
        status = check_bright(check, scene->bindings[check->index].state.emission_bits);
    return status;
}

static int check_fog(struct check *check)
{
    const struct tia_fog *fog = check->scene->fog;

    check->thing = "fog";
    check->index = 0;
    if (!fog)
        return TIA_OK;
    REQUIRE(tia_check_is_unit(&fog->colour), "colour", CHECK_UNIT);
    REQUIRE(fog->distance >= TIA_RADIUS_MIN, "distance", "must be at least 2^-10");
    REQUIRE(fog->height == 0 || fog->height >= TIA_RADIUS_MIN, "height", "must be 0 or at least 2^-10");
    REQUIRE(check->scene->shadows == TIA_SHADOWS_TRACED, "distance", "needs traced rays for shadows");
    return TIA_OK;
}

static int check_lens(struct check *check)
{
    const struct tia_lens *lens = check->scene->lens;

    check->thing = "lens";
    if (!lens)
        return TIA_OK;
    REQUIRE(lens->focus >= TIA_RADIUS_MIN, "focus", "must be at least 2^-10");
    REQUIRE(tia_check_is_between(lens->radius, 1, lens->focus), "radius", "must be above 0 and at most focus");
    REQUIRE(!check->scene->field, "radius", "must not be in a light field");
    REQUIRE(check->scene->shadows == TIA_SHADOWS_TRACED, "radius", "needs traced rays for shadows");
    return TIA_OK;
}

int tia_check_rendering(struct check *check)
{
    int status = tia_check_light_field(check);

    status = status ? status : check_fog(check);
    status = status ? status : check_lens(check);
    check->index = 0;
    check->thing = "scene";
    status = status ? status : check_integration(check);
    status = status ? status : check_emission(check);
    return status ? status : tia_check_shadows(check);
}
