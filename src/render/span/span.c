#include "span.h"

#include "math/align.h"
#include "math/noinline.h"
#include "scene/colour.h"
#include "steps/steps.h"

#define STEPS_SPHERES 8 /* most spheres of a scene that have steps, which take memory, but for the largest one */

/* The sum of grey lights below which they are summed before they get the material's colour: 3, less what cosines by
 * words may be above 1, 2^-8 each. So the light and an emission of 1 are below 4. */
#define DIM (((uint32_t)3 << 30) - ((uint32_t)1 << 24))

static ONCE_IN_FLASH bool is_black(const struct tia_rgb *colour)
{
    return colour_is_black(colour);
}

static bool is_matt(const struct tia_material *m)
{
    return !m->texture && !m->opacity && is_black(&m->specular) && is_black(&m->mirror) && is_black(&m->refraction) &&
           is_black(&m->facing);
}

static ONCE_IN_FLASH bool is_plain_light(const struct tia_light *l)
{
    return tia_light_has(l->kind, TIA_LIGHT_SPANS) && !l->constant && !l->linear && !l->quadratic;
}

static bool is_plain_camera(const struct tia_camera *c)
{
    return c->projection == TIA_PERSPECTIVE && !c->up.x && !c->up.y && !c->up.z && c->samples <= 1;
}

bool span_draws(const struct tia_scene *scene)
{
    bool plain = !scene->integration.integrator && !scene->shape_count && !scene->mesh_count &&
                 scene->sphere_count <= TIA_SPAN_SPHERES && !scene->fog && !scene->lens &&
                 is_plain_camera(&scene->camera);

    for (uint32_t i = 0; plain && i < scene->material_count; i++)
        plain = is_matt(&scene->materials[i]);
    for (uint32_t i = 0; plain && i < scene->light_count; i++)
        plain = is_plain_light(&scene->lights[i]);
    for (uint32_t i = 0; plain && i < scene->binding_count; i++)
        plain = is_plain_light(&scene->bindings[i].state);
    return plain;
}

/* Returns the number of tables of steps: for each sphere, or for the largest one. */
static uint32_t steps_count(const struct tia_scene *scene, uint32_t light_capacity)
{
    if (!NUM_CERTIFIED || light_capacity != 1)
        return 0;
    return scene->sphere_count <= STEPS_SPHERES ? scene->sphere_count : 1;
}

size_t span_prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t spheres = (uint64_t)scene->sphere_count + light_capacity;
    uint64_t size = ALIGN(sizeof(struct span_view)) + spheres * sizeof(struct span_sphere) +
                    ALIGN(span_casters_size(scene->sphere_count, light_capacity)) +
                    steps_count(scene, light_capacity) * (uint64_t)sizeof(struct colour_steps);

    return size > SIZE_MAX / 4 ? SIZE_MAX : (size_t)size;
}

static void prepare_sphere(const struct tia_view *view, uint32_t n, struct tia_vec3 centre, tia_q16 radius)
{
    const struct span_view *spans = view->prepared;

    span_sphere_prepare(&spans->primary, &spans->spheres[n], num_vec_between(view->scene->camera.eye, centre), radius);
    span_casters_put(&spans->casters, n);
    spans->spheres[n].steps = 0;
}

/* Gives the tables of steps to the spheres: the largest one has the only table. */
static void give_steps(const struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;
    struct span_sphere *spheres = span_view_of(view)->spheres, *largest = NULL;
    uint32_t count = steps_count(scene, view->light_capacity);

    for (uint32_t i = 0; i < scene->sphere_count; i++)
        if (spheres[i].c > 0 && count == scene->sphere_count)
            spheres[i].steps = (uint8_t)(i + 1);
        else if (spheres[i].c > 0 && (!largest || spheres[i].radius > largest->radius))
            largest = &spheres[i];
    if (count == 1 && largest)
        largest->steps = 1;
}

int span_prepare(struct tia_view *view, const struct span_coherence *coherence)
{
    const struct tia_scene *scene = view->scene;
    struct span_view *spans = view->prepared;

    spans->kernels = &span_kernels_plain;
    spans->coherence = coherence;
    spans->spheres = (struct span_sphere *)(void *)((char *)view->prepared + ALIGN(sizeof *spans));
    char *after = (char *)(spans->spheres + scene->sphere_count + view->light_capacity);
    span_casters_place(&spans->casters, spans->spheres, scene->sphere_count, view->light_capacity, after);
    after += ALIGN(span_casters_size(scene->sphere_count, view->light_capacity));
    spans->steps = steps_count(scene, view->light_capacity) ? (struct colour_steps *)(void *)after : NULL;
    spans->tinted = false;
    spans->grey_shadows = true;
    primary_prepare(&spans->primary, (unsigned)view->width, (unsigned)view->height, scene->camera.fov);
    tia_exact_depth(&spans->depth, (uint32_t)view->height, scene->camera.fov);
    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        const struct tia_rgb *through = &scene->materials[s->material].transmission;
        prepare_sphere(view, i, s->centre, s->radius);
        spans->tinted = spans->tinted || !colour_is_black(through);
        spans->grey_shadows = spans->grey_shadows && colour_is_grey(through);
    }
    if (!spans->tinted)
        give_steps(view);
    return TIA_OK;
}

/* True if the eye is outside of all spheres. */
static bool is_outside(const struct span_view *spans, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        if (spans->spheres[i].c <= 0)
            return false;
    return true;
}

static void set_steps(const struct tia_view *view)
{
    const struct span_view *spans = view->prepared;
    const struct tia_scene *scene = view->scene;
    bool used = view->light_count == 1 && is_outside(spans, scene->sphere_count);

    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        struct light_source source = {.sphere = &spans->spheres[i], .number = 0};
        struct colour_steps *steps = steps_number(spans->steps, spans->spheres[i].steps);
        if (!steps)
            continue;
        steps->usable = false;
        if (!used)
            continue;
        steps->shaded = span_next_in(&spans->casters, span_list_of(&spans->casters, i, 0), 0) < scene->sphere_count;
        source.light = num_vec_between(scene->camera.eye, view->lights[0].centre);
        steps_prepare(&spans->primary, &source, &view->lights[0].emission,
                      &scene->materials[scene->spheres[i].material], steps);
    }
}

int span_set_lights(struct tia_view *view)
{
    struct span_view *spans = view->prepared;
    struct cancel cancel = view_cancel(view);
    uint32_t left = DIM;

    spans->grey = spans->grey_shadows;
    for (uint32_t i = 0; i < view->light_count && !cancelled(&cancel, 1); i++) {
        const struct tia_light *light = &view->lights[i];
        spans->grey = spans->grey && colour_is_grey(&light->emission);
        bool fits = light->emission.r <= TIA_Q30_ONE && (uint32_t)light->emission.r < left;
        left = fits ? left - (uint32_t)light->emission.r : 0;
        prepare_sphere(view, view->scene->sphere_count + i, light->centre, light->radius);
        span_casters_find(&spans->casters, i, &cancel);
    }
    spans->dim = spans->grey && left > 0;
    if (!cancel.stopped)
        set_steps(view);
    return cancel.stopped ? TIA_STOPPED : TIA_OK;
}

uint64_t span_buffer_size(const struct tia_scene *scene, uint32_t pixels)
{
    (void)scene;
    return (uint64_t)pixels * sizeof(num_u);
}
