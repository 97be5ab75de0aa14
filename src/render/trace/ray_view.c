/* ray_view.c - prepares a scene for general rays: the camera, the lights, shapes and their instances. */
#include "math/align.h"
#include "scene/colour.h"
#include "scene/object_bounds.h"
#include "trace.h"

/* Properties of a mesh that its shapes need, computed at the first use: many shapes may share a mesh. */
struct mesh_facts {
    struct tia_bounds box;
    bool has_box, has_edges, is_closed;
};

/* Returns the number of members of all solids. */
static uint64_t solid_members(const struct tia_scene *scene)
{
    uint64_t count = 0;

    for (uint32_t i = 0; i < scene->solid_count; i++)
        count += scene->solids[i].member_count;
    return count;
}

size_t ray_prepared_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    uint64_t size = ALIGN(sizeof(struct ray_view)) + ALIGN((uint64_t)light_capacity * sizeof(struct ray_light)) +
                    (scene->shape_count + solid_members(scene)) * (sizeof(struct shape) + sizeof(struct instance)) +
                    (uint64_t)scene->mesh_count * sizeof(struct mesh_facts) +
                    (uint64_t)scene->solid_count * sizeof(struct shape *);

    return size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

/* A scene being prepared. */
struct preparation {
    const struct tia_scene *scene;
    struct mesh_facts *meshes;
    const struct shape **solids; /* the first member of each solid */
    struct instance *instance;   /* the next one to use */
    struct cancel cancel;
};

static const struct tia_bounds *mesh_box(struct preparation *p, uint32_t mesh)
{
    struct mesh_facts *facts = &p->meshes[mesh];

    if (!facts->has_box)
        facts->box = tia_bounds_of_mesh(&p->scene->meshes[mesh], &p->cancel);
    facts->has_box = true;
    return &facts->box;
}

static bool is_closed(struct preparation *p, uint32_t mesh)
{
    struct mesh_facts *facts = &p->meshes[mesh];

    if (!facts->has_edges)
        facts->is_closed = mesh_is_closed(&p->scene->meshes[mesh], &p->cancel);
    facts->has_edges = true;
    return facts->is_closed;
}

/* Returns the part of a shape that refracted rays can enter. */
static enum inside inside_of(struct preparation *p, const struct tia_shape *given)
{
    bool refracts = !colour_is_black(&p->scene->materials[given->material].refraction);

    switch (given->kind) {
    case TIA_GRID:
        return INSIDE_CELLS;
    case TIA_CYLINDER:
        return given->cylinder.capped ? INSIDE_WHOLE : INSIDE_NONE;
    case TIA_CONE:
        return given->cone.capped ? INSIDE_WHOLE : INSIDE_NONE;
    case TIA_MESH:
        return refracts && is_closed(p, given->mesh) ? INSIDE_WHOLE : INSIDE_NONE;
    case TIA_DISC:
    case TIA_TRIANGLE:
        return INSIDE_NONE;
    default:
        return INSIDE_WHOLE;
    }
}

/* True if one of `count` materials, beginning with number `first`, has an opacity texture. */
static bool have_opacity(const struct tia_scene *scene, uint32_t first, uint32_t count)
{
    bool found = false;

    for (uint32_t m = first; m < scene->material_count && m - first < count; m++)
        found = found || scene->materials[m].opacity;
    return found;
}

static bool have_footprints(const struct tia_scene *scene)
{
    bool found = false;

    for (uint32_t i = 0; TIA_FOOTPRINTS && i < scene->texture_count; i++)
        found = found || scene->textures[i].footprint;
    return found;
}

/* True if a member of the solid has an opacity texture. */
static bool solid_has_opacity(const struct tia_scene *scene, const struct tia_solid *solid)
{
    bool found = false;

    for (uint32_t i = 0; i < solid->member_count; i++)
        found = found || have_opacity(scene, solid->members[i].material, 1);
    return found;
}

/* Gives a shape its instance, if the shape has a transform. */
static void place(struct preparation *p, const struct tia_shape *given, struct shape *shape)
{
    struct bounds_wide box;

    shape->instance = NULL;
    if (!given->transform)
        return;
    tia_bounds_in_own_axes(p->scene, given, given->kind == TIA_MESH ? mesh_box(p, given->mesh) : NULL, &box);
    instance_prepare(p->instance, &p->scene->transforms[given->transform - 1], &box);
    shape->instance = p->instance++;
}

static void prepare_shape(struct preparation *p, const struct tia_shape *given, struct shape *shape)
{
    const struct tia_scene *scene = p->scene;

    shape->material = given->material;
    shape->inside = inside_of(p, given);
    shape->layered = have_opacity(scene, given->material, given->kind == TIA_GRID ? UINT8_MAX : 1);
    shape_prepare(shape, scene, given);
    place(p, given, shape);
    if (given->kind == TIA_SOLID) {
        shape->solid.members = p->solids[given->solid];
        shape->layered = solid_has_opacity(scene, shape->solid.solid);
    }
}

/* Prepares the members of all solids. */
static void prepare_solids(struct shape *members, struct preparation *p)
{
    const struct tia_scene *scene = p->scene;

    for (uint32_t i = 0; i < scene->solid_count && !cancelled(&p->cancel, 1); i++) {
        p->solids[i] = members;
        for (uint32_t k = 0; k < scene->solids[i].member_count; k++)
            prepare_shape(p, &scene->solids[i].members[k], members++);
    }
}

static int prepare_shapes(struct ray_view *view, struct preparation *p)
{
    const struct tia_scene *scene = p->scene;

    for (uint32_t i = 0; i < scene->mesh_count; i++)
        p->meshes[i].has_box = p->meshes[i].has_edges = false;
    prepare_solids(view->shapes + scene->shape_count, p);
    for (uint32_t i = 0; i < scene->shape_count && !cancelled(&p->cancel, 1); i++)
        prepare_shape(p, &scene->shapes[i], &view->shapes[i]);
    return p->cancel.stopped ? TIA_STOPPED : TIA_OK;
}

int ray_prepare(struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;
    struct ray_view *rays = view->prepared;
    struct preparation preparation = {.scene = scene, .cancel = view_cancel(view)};
    size_t shapes = (size_t)(scene->shape_count + solid_members(scene));

    rays->view = view;
    rays->scene = scene;
    rays->lights = (struct ray_light *)(void *)((char *)view->prepared + ALIGN(sizeof *rays));
    rays->shapes = (struct shape *)(void *)((char *)rays->lights + ALIGN(view->light_capacity * sizeof *rays->lights));
    rays->instances = preparation.instance = (struct instance *)(rays->shapes + shapes);
    preparation.solids = (const struct shape **)(void *)(rays->instances + shapes);
    preparation.meshes = (struct mesh_facts *)(void *)(preparation.solids + scene->solid_count);
    rays->light_count = 0;
    rays->depth = scene->depth ? scene->depth : TIA_DEPTH_DEFAULT;
    ray_camera_prepare(&rays->camera, scene, view->width, view->height);
    rays->bias = num_scene_bias(scene->fine, scene->scale_bits);
    rays->layered = have_opacity(scene, 0, scene->material_count);
    rays->filtered = have_footprints(scene);
    return prepare_shapes(rays, &preparation);
}

int ray_set_lights(struct tia_view *view)
{
    struct ray_view *rays = view->prepared;
    struct cancel cancel = view_cancel(view);

    rays->light_count = view->light_count;
    rays->lit = false;
    for (uint32_t i = 0; i < view->light_count && !cancelled(&cancel, 1); i++) {
        ray_light_prepare(&rays->lights[i], &view->lights[i], view->scene->scale_bits);
        rays->lit = rays->lit || ray_light_is_seen(&rays->lights[i]);
    }
    return cancel.stopped ? TIA_STOPPED : TIA_OK;
}
