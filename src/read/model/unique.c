/* unique.c - removes faces that are given again, if there are many.
 *
 * No hierarchy separates faces in the same place: a ray tests all of them, at about 10 ns each. So a mesh with more
 * than COPIES_MOST of them is drawn without. A few copies are left as they are. A face is the same as one before it if
 * its corners have the same positions, in the same order, and the same normals and texture coordinates, and if both are
 * in the same group. Then the one before it wins every ray.
 *
 * The search for a face's place in the hash table ends after some steps, so that its time does not depend on the file;
 * a face whose place is not found is kept.
 *
 * Most meshes have no copies, and a table of all faces does not fit into the processor's caches. So the faces are first
 * counted in small cells by their hashes: a face that is alone in its cell has no copies. With CELLS cells a face, one
 * in CELLS faces is not alone by chance, and only these are searched for in a table.
 */
#include "model.h"

#define SEARCH 16
#define COPIES_MOST 4096
#define CELLS 16 /* two bits each, in a word for each face */

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

/* Returns the number, 0 to count - 1, at which a hash lies. */
static uint64_t scale(uint32_t hash, uint64_t count)
{
    return (uint64_t)hash * count >> 32;
}

/* ---- cells ---- */

/* Counts a hash in one of `count` * CELLS cells: 1, or 2 for more. */
static void count_in_cell(uint32_t *cells, uint32_t count, uint32_t hash)
{
    uint64_t cell = scale(hash, (uint64_t)count * CELLS);
    uint32_t *word = &cells[cell / CELLS], bits = (uint32_t)(cell % CELLS) * 2, seen = *word >> bits & 3;

    *word |= (seen ? UINT32_C(2) : UINT32_C(1)) << bits;
}

static bool is_alone(const uint32_t *cells, uint32_t count, uint32_t hash)
{
    uint64_t cell = scale(hash, (uint64_t)count * CELLS);

    return !(cells[cell / CELLS] >> (cell % CELLS * 2) & 2);
}

/* ---- the table ---- */

/* True if face `index` is the same as one that is kept. Otherwise enters it in the table. */
static bool is_known(const struct unique *u, uint32_t index)
{
    uint32_t slot = (uint32_t)scale(hash(u, &u->faces[index]), u->slots);

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
    return face_count + face_count / 2;
}

static void count_in_cells(const struct unique *u, uint32_t *cells, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        cells[i] = 0;
    for (uint32_t i = 0; i < count; i++)
        count_in_cell(cells, count, hash(u, &u->faces[i]));
}

/* Returns how many faces are the same as one before them, or COPIES_MOST + 1 when there are more. Does not search for
 * faces that are alone in `cells`, unless it is NULL, and returns UINT32_MAX when more than `most` others are left. */
static uint32_t count_copies(const struct unique *u, uint32_t count, const uint32_t *cells, uint32_t most)
{
    uint32_t searched = 0, copies = 0;

    clear(u);
    for (uint32_t i = 0; i < count && copies <= COPIES_MOST; i++)
        if (!cells || !is_alone(cells, count, hash(u, &u->faces[i]))) {
            if (searched++ == most)
                return UINT32_MAX;
            copies += is_known(u, i);
        }
    return copies;
}

/* True if more than COPIES_MOST faces are the same as one before them. */
static bool has_copies(const struct unique *u, uint32_t count)
{
    struct unique few = *u;

    few.table += count; /* behind the cells */
    few.slots -= count;
    count_in_cells(u, u->table, count);
    uint32_t copies = count_copies(&few, count, u->table, few.slots / 2);
    if (copies == UINT32_MAX)
        copies = count_copies(u, count, NULL, count);
    return copies > COPIES_MOST;
}

uint32_t tia_model_unique(struct tia_face *faces, uint32_t *groups, uint32_t count, const struct tia_vec3 *vertices,
                          uint32_t *table)
{
    const struct unique u = {faces, vertices, groups, table, tia_model_slots(count)};
    uint32_t kept = 0;

    if (count <= COPIES_MOST || !has_copies(&u, count)) /* a face is no copy of itself */
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
