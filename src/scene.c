#include <tia/scene.h>

#include "math.h"

#define FAR_RULE "every point must be nearer to the eye than 32768"
#define UNIT_RULE "each channel must be in 0..1"

static int refuse(struct tia_fault *fault, const char *thing, uint32_t index, const char *field, const char *rule)
{
    if (fault) {
        fault->thing = thing;
        fault->index = index;
        fault->field = field;
        fault->rule = rule;
    }
    return TIA_ERR_RANGE;
}

static bool is_unit(const struct tia_rgb *c)
{
    return c->r >= 0 && c->r <= TIA_Q30_ONE && c->g >= 0 && c->g <= TIA_Q30_ONE && c->b >= 0 && c->b <= TIA_Q30_ONE;
}

/* |centre - eye| + radius < 32768, exactly: with d2 = |centre - eye|^2 that is d2 < (32768 - radius)^2. */
static bool is_near(const struct tia_scene *scene, struct tia_vec3 centre, tia_q16 radius)
{
    const struct tia_vec3 *eye = &scene->camera.eye;
    int64_t offset[3] = {(int64_t)centre.x - eye->x, (int64_t)centre.y - eye->y, (int64_t)centre.z - eye->z};
    int64_t left = (INT64_C(1) << 31) - radius, square = 0;

    for (int i = 0; i < 3; i++) {
        if (offset[i] >= INT32_MAX || offset[i] <= -INT32_MAX)
            return false;
        if (square > INT64_MAX - offset[i] * offset[i])
            return false;
        square += offset[i] * offset[i];
    }
    return left > 0 && square < left * left;
}

static int check_material(const struct tia_scene *scene, uint32_t i, struct tia_fault *fault)
{
    const struct tia_material *m = &scene->materials[i];

    if (!is_unit(&m->colour))
        return refuse(fault, "material", i, "colour", UNIT_RULE);
    if (!is_unit(&m->transmission))
        return refuse(fault, "material", i, "transmission", UNIT_RULE);
    if (!is_unit(&m->emission))
        return refuse(fault, "material", i, "emission", UNIT_RULE);
    return TIA_OK;
}

static int check_sphere(const struct tia_scene *scene, uint32_t i, struct tia_fault *fault)
{
    const struct tia_sphere *s = &scene->spheres[i];

    if (s->radius < TIA_RADIUS_MIN)
        return refuse(fault, "sphere", i, "radius", "must be at least 2^-10");
    if (!is_near(scene, s->centre, s->radius))
        return refuse(fault, "sphere", i, "centre", FAR_RULE);
    if (s->material >= scene->material_count)
        return refuse(fault, "sphere", i, "material", "must be the index of a material");
    return TIA_OK;
}

static int check_light(const struct tia_scene *scene, const struct tia_light *l, const char *thing, uint32_t i,
                       struct tia_fault *fault)
{
    if (l->radius < 0 || (l->radius > 0 && l->radius < TIA_RADIUS_MIN))
        return refuse(fault, thing, i, "radius", "must be 0 or at least 2^-10");
    if (!is_near(scene, l->centre, l->radius))
        return refuse(fault, thing, i, "centre", FAR_RULE);
    if (l->emission.r < 0 || l->emission.g < 0 || l->emission.b < 0)
        return refuse(fault, thing, i, "emission", "each channel must be in 0..2");
    return TIA_OK;
}

static int check_scene(const struct tia_scene *scene, struct tia_fault *fault)
{
    if ((scene->material_count && !scene->materials) || (scene->sphere_count && !scene->spheres) ||
        (scene->light_count && !scene->lights) || (scene->binding_count && !scene->bindings))
        return refuse(fault, "scene", 0, "arrays", "an array with a count must not be NULL");
    if ((uint64_t)scene->sphere_count + scene->light_count > INT32_MAX)
        return refuse(fault, "scene", 0, "counts", "spheres and lights must be fewer than 2^31");
    if (scene->camera.fov < TIA_FOV_MIN || scene->camera.fov > TIA_FOV_MAX)
        return refuse(fault, "camera", 0, "fov", "must be in 1..170 degrees");
    if (!is_unit(&scene->background))
        return refuse(fault, "scene", 0, "background", UNIT_RULE);
    return TIA_OK;
}

int tia_scene_check(const struct tia_scene *scene, struct tia_fault *fault)
{
    int status = check_scene(scene, fault);

    for (uint32_t i = 0; !status && i < scene->material_count; i++)
        status = check_material(scene, i, fault);
    for (uint32_t i = 0; !status && i < scene->sphere_count; i++)
        status = check_sphere(scene, i, fault);
    for (uint32_t i = 0; !status && i < scene->light_count; i++)
        status = check_light(scene, &scene->lights[i], "light", i, fault);
    for (uint32_t i = 0; !status && i < scene->binding_count; i++)
        status = check_light(scene, &scene->bindings[i].state, "key", i, fault);
    return status;
}
