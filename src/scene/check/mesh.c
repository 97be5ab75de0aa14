/* mesh.c - checks each mesh and grid once, then the shapes that use them. */
#include "scene/object_bounds.h"
#include "scene_check.h"

/* True if every corner has a valid index, or none has one. */
static bool are_indices(uint32_t a, uint32_t b, uint32_t c, uint32_t count)
{
    bool none = a == TIA_NO_INDEX && b == TIA_NO_INDEX && c == TIA_NO_INDEX;
    return none || (a < count && b < count && c < count);
}

static int check_face(const struct check *check, const struct tia_mesh *mesh, const struct tia_corner *c)
{
    for (int i = 0; i < 3; i++)
        REQUIRE(c[i].vertex < mesh->vertex_count, "face", "each vertex must be the index of a vertex");
    REQUIRE(are_indices(c[0].normal, c[1].normal, c[2].normal, mesh->normal_count), "face",
            "each normal must be the index of a normal, or none have one");
    REQUIRE(are_indices(c[0].uv, c[1].uv, c[2].uv, mesh->uv_count), "face",
            "each uv must be the index of a uv, or none have one");
    return TIA_OK;
}

int tia_check_mesh(const struct check *check)
{
    const struct tia_mesh *m = &check->scene->meshes[check->index];
    int status = TIA_OK;

    REQUIRE((m->vertices || !m->vertex_count) && (m->normals || !m->normal_count) && (m->uvs || !m->uv_count) &&
                (m->faces || !m->face_count),
            "arrays", "an array with a count must not be NULL");
    REQUIRE(m->face_count <= TIA_OBJECTS_MAX, "faces", "must be at most 2^24");
    for (uint32_t i = 0; i < m->normal_count && !cancelled(check->cancel, 1); i++)
        REQUIRE(tia_check_is_direction(&m->normals[i]), "normal", CHECK_LENGTH);
    for (uint32_t i = 0; !status && i < m->face_count && !cancelled(check->cancel, 1); i++)
        status = check_face(check, m, m->faces[i].corner);
    return check->cancel->stopped ? TIA_STOPPED : status;
}

static bool is_grid_end(tia_q16 corner, uint16_t size, tia_q16 cell)
{
    return corner + (int64_t)size * cell <= INT32_MAX;
}

int tia_check_grid(const struct check *check)
{
    const struct tia_grid *g = &check->scene->grids[check->index];
    const uint16_t *n = g->size;

    for (int k = 0; k < 3; k++)
        REQUIRE(tia_check_is_between(n[k], 1, TIA_GRID_MAX), "size", "must be in 1..1024");
    REQUIRE((uint64_t)n[0] * n[1] * n[2] <= TIA_GRID_CELLS_MAX, "size", "must be at most 2^28 cells in all");
    REQUIRE(g->cell >= TIA_RADIUS_MIN, "cell", "must be at least 2^-10");
    REQUIRE(is_grid_end(g->corner.x, n[0], g->cell) && is_grid_end(g->corner.y, n[1], g->cell) &&
                is_grid_end(g->corner.z, n[2], g->cell),
            "cell", "all cells must end below 32768");
    REQUIRE(g->cells, "cells", "must not be NULL");
    return TIA_OK;
}

/* Properties of a mesh or grid that the checks of shapes need, computed once for all shapes. */
struct part {
    struct tia_bounds box; /* box of a mesh */
    uint32_t materials;    /* number of consecutive materials that a grid needs; the first is the shape's own */
};

/* Number of parts per pass over the shapes: they fit on the stack, and one pass is usually enough. */
#define PARTS 16

static struct part mesh_part(const struct check *check, uint32_t i)
{
    return (struct part){tia_bounds_of_mesh(&check->scene->meshes[i], check->cancel), 1};
}

static struct part grid_part(const struct check *check, uint32_t i)
{
    const struct tia_grid *g = &check->scene->grids[i];
    uint32_t count = (uint32_t)g->size[0] * g->size[1] * g->size[2];
    struct part part = {BOUNDS_NOTHING, 1};

    for (uint32_t k = 0; k < count && !cancelled(check->cancel, 1); k++)
        part.materials = g->cells[k] > part.materials ? g->cells[k] : part.materials;
    return part;
}

static int check_use(const struct check *check, const struct part *part)
{
    const struct tia_scene *scene = check->scene;
    const struct tia_shape *s = &scene->shapes[check->index];
    struct bounds_wide box;

    REQUIRE((uint64_t)s->material + part->materials <= scene->material_count, "material",
            "there must be one for every cell");
    if (!tia_bounds_in_world(scene, scene->sphere_count + check->index, &part->box, &box))
        return TIA_OK;
    return tia_check_placed(check, s, &box);
}

/* Checks the shapes that use one of `count` parts; the first of these is part number `first`. */
static int check_shapes(struct check *check, enum tia_shape_kind kind, uint32_t first, uint32_t count,
                        const struct part *parts)
{
    const struct tia_scene *scene = check->scene;

    for (uint32_t i = 0; i < scene->shape_count && !cancelled(check->cancel, 1); i++) {
        const struct tia_shape *s = &scene->shapes[i];
        uint32_t which = s->kind == TIA_MESH ? s->mesh : s->grid;

        if (s->kind != kind || which < first || which - first >= count)
            continue;
        check->index = i;
        int status = check_use(check, &parts[which - first]);
        if (status)
            return status;
    }
    return check->cancel->stopped ? TIA_STOPPED : TIA_OK;
}

static int check_parts(struct check *check, enum tia_shape_kind kind, uint32_t count)
{
    struct part parts[PARTS];
    int status = TIA_OK;

    for (uint32_t first = 0; !status && first < count; first += PARTS) {
        uint32_t n = count - first < PARTS ? count - first : PARTS;
        for (uint32_t i = 0; i < n; i++)
            parts[i] = kind == TIA_MESH ? mesh_part(check, first + i) : grid_part(check, first + i);
        status = check_shapes(check, kind, first, n, parts);
        if (count - first <= PARTS)
            break; /* first + PARTS could overflow */
    }
    return status;
}

static bool is_fine(const struct tia_scene *scene)
{
    const struct tia_fine *fine = scene->fine;
    return !fine || ((fine->spheres || !scene->sphere_count) && (fine->shapes || !scene->shape_count));
}

static bool has_unit(const struct tia_scene *scene, const struct tia_light *l)
{
    bool fades = l->constant || l->linear || l->quadratic;
    return !fades || tia_check_is_between(scene->scale_bits + l->unit_bits, 0, 30);
}

static int check_units(struct check *check)
{
    const struct tia_scene *scene = check->scene;

    REQUIRE(tia_check_is_between(scene->scale_bits, -TIA_SCALE_BITS_MAX, TIA_SCALE_BITS_MAX), "scale_bits",
            "must be in -16..16");
    check->thing = "light";
    for (check->index = 0; check->index < scene->light_count; check->index++)
        REQUIRE(has_unit(scene, &scene->lights[check->index]), "unit_bits", "must be in 0..30 with scale_bits");
    check->thing = "key";
    for (check->index = 0; check->index < scene->binding_count; check->index++)
        REQUIRE(has_unit(scene, &scene->bindings[check->index].state), "unit_bits", "must be in 0..30 with scale_bits");
    return TIA_OK;
}

int tia_check_uses(struct check *check)
{
    int status = check_parts(check, TIA_MESH, check->scene->mesh_count);
    status = status ? status : check_parts(check, TIA_GRID, check->scene->grid_count);
    check->thing = "scene";
    check->index = 0;
    status = status ? status : check_units(check);
    check->thing = "scene";
    check->index = 0;
    if (!status)
        REQUIRE(is_fine(check->scene), "fine", "an array of as many must not be NULL");
    return status;
}
