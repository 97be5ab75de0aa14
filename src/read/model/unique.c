/* unique.c - removes faces that are given again, if there are many.
 *
 * No hierarchy separates faces in the same place: a ray tests all of them, at about 10 ns each. So a mesh with more
 * than COPIES_MOST of them is drawn without. A few copies are left as they are. A face is the same as one before it if
 * its corners have the same positions, in the same order, and the same normals and texture coordinates, and if both are
 * in the same group. Then the one before it wins every ray.
 *
 * The search for a face's place in the hash table ends after some steps, so that its time does not depend on the file;
 * a face whose place is not found is kept.
 */
#include "model.h"

#define SEARCH 16
#define COPIES_MOST 4096
#define AHEAD 8 /* faces whose place in the table is fetched before it is needed */

#ifdef __GNUC__
#define PREFETCH(address) __builtin_prefetch(address, 1)
#else
#define PREFETCH(address) ((void)(address))
#endif

/* The faces, and the hash table of the indices of those that are kept. */
struct unique {
    struct tia_face *faces;
    const struct tia_vec3 *vertices;
    const uint32_t *groups; /* NULL: none */
    uint32_t *table, slots;
};

static const struct tia_vec3 *at(const struct unique *u, const struct tia_face *face, int corner)
{
    return &u->vertices[face->corner[corner].vertex];
}

static uint32_t hash(const struct unique *u, const struct tia_face *face)
{
    uint64_t h = 0;

    for (int i = 0; i < 3; i++) {
        const struct tia_vec3 *v = at(u, face, i);
        h = (h ^ (h >> 29) ^ (uint32_t)v->x) * UINT64_C(0x9e3779b97f4a7c15);
        h = (h ^ (h >> 31) ^ (uint32_t)v->y) * UINT64_C(0xbf58476d1ce4e5b9);
        h = (h ^ (h >> 30) ^ (uint32_t)v->z) * UINT64_C(0x94d049bb133111eb);
    }
    return (uint32_t)(h >> 32);
}

static bool is_same(const struct unique *u, uint32_t a, uint32_t b)
{
    if (u->groups && u->groups[a] != u->groups[b])
        return false;
    for (int i = 0; i < 3; i++) {
        const struct tia_corner *c = &u->faces[a].corner[i], *d = &u->faces[b].corner[i];
        const struct tia_vec3 *v = &u->vertices[c->vertex], *w = &u->vertices[d->vertex];
        if (v->x != w->x || v->y != w->y || v->z != w->z || c->normal != d->normal || c->uv != d->uv)
            return false;
    }
    return true;
}

/* Returns the place in the table at which the search for a face begins. */
static uint32_t place_of(const struct unique *u, uint32_t index)
{
    return (uint32_t)((uint64_t)hash(u, &u->faces[index]) * u->slots >> 32);
}

/* True if face `index` is the same as one that is kept. Otherwise enters it in the table. */
static bool is_known(const struct unique *u, uint32_t index)
{
    uint32_t slot = place_of(u, index);

    for (int i = 0; i < SEARCH; i++) {
        uint32_t *entry = &u->table[slot];
        if (*entry == TIA_NO_INDEX) {
            *entry = index;
            return false;
        }
        if (is_same(u, index, *entry))
            return true;
        slot = slot + 1 < u->slots ? slot + 1 : 0;
    }
    return false;
}

static void clear(const struct unique *u)
{
    for (uint32_t i = 0; i < u->slots; i++)
        u->table[i] = TIA_NO_INDEX;
}

uint32_t tia_model_slots(uint32_t face_count)
{
    if (face_count <= COPIES_MOST)
        return 0;
    return face_count < UINT32_MAX / 2 ? face_count + face_count / 2 : face_count;
}

uint32_t tia_model_unique(struct tia_face *faces, uint32_t *groups, uint32_t count, const struct tia_vec3 *vertices,
                          uint32_t *table)
{
    const struct unique u = {faces, vertices, groups, table, tia_model_slots(count)};
    uint32_t kept = 0, copies = 0;

    if (count <= COPIES_MOST) /* a face is no copy of itself */
        return count;
    clear(&u);
    for (uint32_t i = 0; i < count; i++) {
        if (i + AHEAD < count)
            PREFETCH(&u.table[place_of(&u, i + AHEAD)]);
        copies += is_known(&u, i);
    }
    if (copies <= COPIES_MOST)
        return count;
    clear(&u);
    for (uint32_t i = 0; i < count; i++) {
        faces[kept] = faces[i];
        if (groups)
            groups[kept] = groups[i];
        kept += !is_known(&u, kept);
    }
    return kept;
}
