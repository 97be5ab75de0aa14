#include "media.h"

static tia_q16 last(const struct media *media)
{
    return media->count == 0 ? TIA_Q16_ONE : media->index[media->count - 1];
}

static bool is_same(struct tia_vec3 a, struct tia_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static struct tia_vec3 corner(const struct tia_mesh *mesh, uint32_t n)
{
    return mesh->vertices[mesh->faces[n / 3].corner[n % 3].vertex];
}

/* Returns the number of edges that run from a to b. */
static uint32_t edges(const struct tia_mesh *mesh, struct tia_vec3 a, struct tia_vec3 b)
{
    uint32_t count = 0;

    for (uint32_t n = 0; n < 3 * mesh->face_count; n++)
        count += is_same(corner(mesh, n), a) && is_same(corner(mesh, n - n % 3 + (n + 1) % 3), b);
    return count;
}

static bool is_closed(const struct tia_mesh *mesh)
{
    for (uint32_t n = 0; n < 3 * mesh->face_count; n++) {
        struct tia_vec3 a = corner(mesh, n), b = corner(mesh, n - n % 3 + (n + 1) % 3);
        if (edges(mesh, a, b) != edges(mesh, b, a))
            return false;
    }
    return true;
}

bool media_has_inside(const struct tia_scene *scene, uint32_t object)
{
    if (object < scene->sphere_count)
        return true;
    const struct tia_shape *s = &scene->shapes[object - scene->sphere_count];
    if (s->kind == TIA_MESH)
        return is_closed(&scene->meshes[s->mesh]);
    if (s->kind == TIA_CYLINDER)
        return s->cylinder.capped;
    if (s->kind == TIA_CONE)
        return s->cone.capped;
    return s->kind != TIA_DISC && s->kind != TIA_TRIANGLE;
}

static bool is_grid(const struct tia_scene *scene, uint32_t object)
{
    return object >= scene->sphere_count && scene->shapes[object - scene->sphere_count].kind == TIA_GRID;
}

/* Returns the index of the object's last entry, or -1. */
static int entry(const struct media *media, uint32_t object)
{
    int at = -1;

    for (unsigned i = 0; i < media->count; i++)
        if (media->object[i] == object)
            at = (int)i;
    return at;
}

static void leave(struct media *media, int at)
{
    for (unsigned i = (unsigned)at; i + 1 < media->count; i++) {
        media->object[i] = media->object[i + 1];
        media->index[i] = media->index[i + 1];
    }
    media->count--;
}

static void enter(struct media *media, uint32_t object, tia_q16 index)
{
    if (media->count == TIA_MEDIA_MAX)
        return;
    media->object[media->count] = object;
    media->index[media->count] = index;
    media->count++;
}

struct crossing media_cross(const struct tia_scene *scene, struct media *media, uint32_t object, bool front,
                            const struct tia_material *material)
{
    tia_q16 index = material->index;
    struct crossing c = {last(media), index};
    int at = entry(media, object);

    if (front) {
        if (at >= 0 && is_grid(scene, object))
            leave(media, at);
        if (media_has_inside(scene, object) && material->opacity == 0)
            enter(media, object, index);
        return c;
    }
    if (at < 0)
        return (struct crossing){index, last(media)};
    bool was_last = at == (int)media->count - 1;
    leave(media, at);
    return (struct crossing){was_last ? index : last(media), last(media)};
}
