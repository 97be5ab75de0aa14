#include "choose.h"

#include "scene/colour.h"

static bool is_matt(const struct tia_material *m)
{
    return !m->texture && colour_is_black(&m->specular) && colour_is_black(&m->mirror) &&
           colour_is_black(&m->refraction) && colour_is_black(&m->facing);
}

static bool is_plain_light(const struct tia_light *l)
{
    return l->kind == TIA_POINT_LIGHT && !l->constant && !l->linear && !l->quadratic;
}

static bool is_plain_camera(const struct tia_camera *c)
{
    return c->projection == TIA_PERSPECTIVE && !c->up.x && !c->up.y && !c->up.z && c->samples <= 1;
}

bool scene_needs_rays(const struct tia_scene *scene)
{
    bool plain = !scene->shape_count && scene->sphere_count <= TIA_SPAN_SPHERES && is_plain_camera(&scene->camera);

    for (uint32_t i = 0; plain && i < scene->material_count; i++)
        plain = is_matt(&scene->materials[i]);
    for (uint32_t i = 0; plain && i < scene->light_count; i++)
        plain = is_plain_light(&scene->lights[i]);
    for (uint32_t i = 0; plain && i < scene->binding_count; i++)
        plain = is_plain_light(&scene->bindings[i].state);
    return !plain;
}
