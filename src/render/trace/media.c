#include "media.h"

#define OBJECT (TIA_OBJECTS_MAX - 1)
#define MATERIAL_STEP TIA_OBJECTS_MAX

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
    return material_of(scene, last & OBJECT)[last / MATERIAL_STEP].index;
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
        media->entered[media->count++] = object + (uint32_t)(material - material_of(scene, object)) * MATERIAL_STEP;
    return (struct boundary){from, material->index};
}
