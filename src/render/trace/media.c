#include "media.h"

#define OBJECT (TIA_OBJECTS_MAX - 1)
#define MATERIAL_STEP TIA_OBJECTS_MAX

/* Returns the solid that an object is, or NULL. */
static const struct tia_solid *solid_of(const struct tia_scene *scene, uint32_t object)
{
    const struct tia_shape *shape = object < scene->sphere_count ? NULL : &scene->shapes[object - scene->sphere_count];

    return shape && shape->kind == TIA_SOLID ? &scene->solids[shape->solid] : NULL;
}

/* Returns the material of an object; for a grid, its first material. */
static const struct tia_material *material_of(const struct tia_scene *scene, uint32_t object)
{
    uint32_t spheres = scene->sphere_count;

    return &scene->materials[object < spheres ? scene->spheres[object].material
                                              : scene->shapes[object - spheres].material];
}

static tia_q16 index_in(const struct tia_scene *scene, const struct media *media)
{
    if (!media->count)
        return TIA_Q16_ONE;
    uint32_t last = media->entered[media->count - 1];
    const struct tia_solid *solid = solid_of(scene, last & OBJECT);
    if (solid)
        return scene->materials[solid->members[last / MATERIAL_STEP].material].index;
    return material_of(scene, last & OBJECT)[last / MATERIAL_STEP].index;
}

/* Returns the number of an object's material, from 0: for a grid, counted from its first material; for a solid, the
 * number of the first member that has it. */
static uint32_t number_of(const struct tia_scene *scene, uint32_t object, const struct tia_material *material)
{
    const struct tia_solid *solid = solid_of(scene, object);
    uint32_t i = 0;

    if (!solid)
        return (uint32_t)(material - material_of(scene, object));
    while (i + 1 < solid->member_count && &scene->materials[solid->members[i].material] != material)
        i++;
    return i;
}

/* Removes the latest entry of an object. Returns false if there is none. */
static bool leave(struct media *media, uint32_t object)
{
    uint32_t i = media->count;

    while (i > 0 && (media->entered[i - 1] & OBJECT) != object)
        i--;
    if (i == 0)
        return false;
    for (; i < media->count; i++)
        media->entered[i - 1] = media->entered[i];
    media->count--;
    return true;
}

struct boundary media_cross(const struct ray_view *view, struct media *media, uint32_t object,
                            const struct tia_material *material, bool back)
{
    const struct tia_scene *scene = view->scene;
    bool is_in = media->count && (media->entered[media->count - 1] & OBJECT) == object;
    tia_q16 from = index_in(scene, media);
    enum inside inside = ray_inside(view, object);

    if (back) {
        bool left = leave(media, object);
        return (struct boundary){left && !is_in ? from : material->index, index_in(scene, media)};
    }
    if (inside == INSIDE_CELLS)
        (void)leave(media, object);
    if (inside != INSIDE_NONE && !material->opacity && media->count < TIA_MEDIA_MAX)
        media->entered[media->count++] = object + number_of(scene, object, material) * MATERIAL_STEP;
    return (struct boundary){from, material->index};
}
