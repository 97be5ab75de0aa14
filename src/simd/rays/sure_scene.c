/* sure_scene.c - conversion of the fixed-point scene to double precision. */
#include <tia/motion.h>

#include "grids.h"
#include "render/geometry/triangle.h"
#include "scene/bvh/tree.h"
#include "scene/colour.h"
#include "sure_faces.h"

#define ALIGN64(n) (((n) + 63) / 64 * 64)

/* Allocator of arrays in the caller's memory. If `start` is NULL, it only adds up their sizes. */
struct room {
    char *start;
    uint64_t used;
};

static void *take(struct room *room, uint64_t count, size_t size)
{
    char *place = room->start ? room->start + room->used : NULL;

    room->used += ALIGN64(count * size);
    return place;
}

struct places {
    struct sure_scene *scene;
    struct sure_node *nodes;
    struct sure_wide *wides;
    double *leaves;
    uint32_t *wide_of;
    struct sure_tree *meshes;
    struct sure_flat *faces; /* the faces of all meshes, mesh by mesh */
    double (*normals)[3];    /* the normals of all meshes, likewise */
    struct sure_pair *pairs; /* pairs of meshes */
    struct sure_places of;
    struct sure_material *materials;
    struct sure_light *lights;
    double (*places)[16][2][SURE_PLACES];
};

static bool has_wide(const struct tia_scene *scene)
{
    return scene->sphere_count >= SURE_SCATTERED && scene->sphere_count <= SURE_MOST_SPHERES;
}

static void take_wide(struct room *room, uint64_t spheres, uint64_t nodes, struct places *p)
{
    p->wides = take(room, SURE_WIDES(spheres), sizeof *p->wides);
    p->leaves = take(room, SURE_LEAVES(spheres), sizeof *p->leaves);
    p->wide_of = take(room, nodes, sizeof *p->wide_of);
}

/* Returns the number of faces of a mesh for each of which struct sure_flat is stored. */
static uint32_t stored_faces(const struct tia_mesh *mesh)
{
    return mesh->face_count > BVH_LARGE_MESH ? 0 : mesh->face_count;
}

/* Divides the memory; returns the bytes used. If objects move, they suffice for the hierarchy at any time. */
static uint64_t divide(struct room *room, const struct tia_scene *scene, uint32_t light_capacity, struct places *p)
{
    uint64_t objects = (uint64_t)scene->sphere_count + scene->shape_count, faces = 0, pairs = 0, normals = 0;
    uint64_t nodes = SURE_NODES(tia_scene_moves(scene) ? TREE_NODES(objects) : scene->bvh->objects.node_count);
    uint64_t top = nodes, cells = 0;

    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        nodes += SURE_NODES((uint64_t)scene->bvh->meshes[i].node_count);
        faces += stored_faces(&scene->meshes[i]);
        normals += scene->meshes[i].normal_count;
        pairs += SURE_PAIRS((uint64_t)scene->bvh->meshes[i].item_count, scene->bvh->meshes[i].node_count);
    }
    for (uint32_t i = 0; i < scene->shape_count; i++)
        if (scene->shapes[i].kind == TIA_GRID)
            cells += 8 * (uint64_t)sure_grid_cells(&scene->grids[scene->shapes[i].grid]);
    p->scene = take(room, 1, sizeof *p->scene);
    p->nodes = take(room, nodes, sizeof *p->nodes);
    if (has_wide(scene))
        take_wide(room, scene->sphere_count, top, p);
    p->meshes = take(room, scene->mesh_count, sizeof *p->meshes);
    p->faces = take(room, faces, sizeof *p->faces);
    p->normals = take(room, normals, sizeof *p->normals);
    p->pairs = take(room, pairs, sizeof *p->pairs);
    p->of.objects = take(room, objects, sizeof *p->of.objects);
    p->of.faces = take(room, scene->shape_count, sizeof *p->of.faces);
    p->of.rounds = take(room, scene->shape_count, sizeof *p->of.rounds);
    p->of.grids = take(room, scene->shape_count, sizeof *p->of.grids);
    p->of.empty = take(room, cells, 1);
    p->of.instances = take(room, scene->shape_count, sizeof *p->of.instances);
    p->materials = take(room, scene->material_count, sizeof *p->materials);
    p->lights = take(room, light_capacity, sizeof *p->lights);
    p->places = take(room, light_capacity < SURE_AREAS ? light_capacity : SURE_AREAS, sizeof *p->places);
    return room->used;
}

size_t tia_sure_size(const struct tia_scene *scene, uint32_t light_capacity)
{
    struct room room = {NULL, 64};
    struct places places;

    if (!scene->bvh)
        return 0;
    uint64_t size = divide(&room, scene, light_capacity, &places);
    return size < SIZE_MAX / 2 ? (size_t)size : SIZE_MAX;
}

static char *aligned(void *memory)
{
    return (char *)memory + (64 - (uintptr_t)memory % 64) % 64;
}

struct sure_scene *tia_sure_scene(const struct tia_view *view)
{
    return (struct sure_scene *)(void *)aligned(view->simd_memory);
}

static struct sure_tree tree_of(const struct tia_bvh_tree *tree, struct sure_node **nodes, uint32_t few)
{
    struct sure_tree t = {.nodes = *nodes, .items = tree->items, .node_count = tia_sure_set_nodes(*nodes, tree, few)};
    static const struct tia_bounds none;
    const struct tia_bounds *b = tree->node_count ? &tree->nodes[0].bounds : &none;
    const tia_q16 least[3] = {b->min.x, b->min.y, b->min.z}, most[3] = {b->max.x, b->max.y, b->max.z};

    for (int k = 0; k < 3; k++) {
        t.centre[k] = ((double)least[k] + most[k]) / 2 * SURE_Q16;
        t.extent += ((double)most[k] - least[k]) / 2 * SURE_Q16;
    }
    *nodes += t.node_count;
    return t;
}

/* Returns a mesh's tree. A mesh of few faces is one leaf: testing all of them takes less time than traversing a
 * hierarchy. */
static struct sure_tree mesh_tree_of(const struct tia_bvh_tree *tree, struct sure_node **nodes)
{
    struct tia_bvh_tree whole = *tree;
    struct tia_bvh_node leaf;
    uint32_t faces = 0;

    for (uint32_t i = 0; i < tree->node_count; i++)
        faces += tree->nodes[i].count;
    if (faces && faces <= SURE_LEAF) {
        leaf = (struct tia_bvh_node){tree->nodes[0].bounds, 0, faces};
        whole.nodes = &leaf;
        whole.node_count = 1;
    }
    return tree_of(&whole, nodes, SURE_FEW);
}

void tia_sure_set_face(struct sure_face *to, const struct tia_vec3 corner[3])
{
    const struct triangle_corners corners = {{corner[0], corner[1], corner[2]}};
    struct num_dir normal;

    for (int i = 0; i < 3; i++)
        sure_point(to->at[i], num_point_of(corner[i]));
    to->any = triangle_normal(&corners, &normal);
    sure_dir(to->normal, normal);
    to->extent = 0;
    for (int i = 1; i < 3; i++) {
        double extent = 0;
        for (int k = 0; k < 3; k++)
            extent += __builtin_fabs(to->at[i][k] - to->at[0][k]);
        to->extent = extent > to->extent ? extent : to->extent;
    }
}

void tia_sure_set_flat(struct sure_flat *to, const struct tia_mesh *mesh, uint32_t face)
{
    const struct tia_corner *c = mesh->faces[face].corner;
    const struct tia_vec3 at[3] = {mesh->vertices[c[0].vertex], mesh->vertices[c[1].vertex],
                                   mesh->vertices[c[2].vertex]};
    struct sure_face whole;

    tia_sure_set_face(&whole, at);
    for (int k = 0; k < 3; k++)
        to->normal[k] = whole.normal[k];
    to->corner = at[0];
    to->extent = (float)(whole.extent * (1 + 0x1p-22)); /* more than what rounding to float may take */
    to->extent = whole.any ? to->extent : -to->extent;
}

/* Finds the axis, if any, along which all vertices of a mesh have the same coordinate. */
static void set_level(struct sure_tree *to, const struct tia_mesh *mesh)
{
    const struct tia_vec3 *v = mesh->vertices;
    bool same[3] = {true, true, true};

    if (!mesh->vertex_count)
        return;
    for (uint32_t i = 0; i < mesh->vertex_count && (same[0] || same[1] || same[2]); i++) {
        same[0] = same[0] && v[i].x == v->x;
        same[1] = same[1] && v[i].y == v->y;
        same[2] = same[2] && v[i].z == v->z;
    }
    to->axis = same[0] ? 0 : same[1] ? 1 : 2;
    to->level = same[to->axis];
    to->height = (double)(to->axis == 0 ? v->x : to->axis == 1 ? v->y : v->z) * SURE_Q16;
}

static void set_trees(struct sure_scene *s, const struct tia_scene *scene, struct places *p)
{
    struct sure_node *nodes = p->nodes;
    struct sure_flat *faces = p->faces;
    struct sure_pair *pairs = p->pairs;
    double(*normals)[3] = p->normals;

    s->objects = tree_of(&scene->bvh->objects, &nodes, 0);
    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        struct sure_node *own = nodes;
        p->meshes[i] = mesh_tree_of(&scene->bvh->meshes[i], &nodes);
        p->meshes[i].faces = stored_faces(&scene->meshes[i]) ? faces : NULL;
        p->meshes[i].mesh = &scene->meshes[i];
        p->meshes[i].groups = scene->meshes[i].groups;
        set_level(&p->meshes[i], &scene->meshes[i]);
        for (uint32_t k = 0; k < stored_faces(&scene->meshes[i]); k++)
            tia_sure_set_flat(faces++, &scene->meshes[i], k);
        p->meshes[i].normals = (const double(*)[3])normals;
        for (uint32_t k = 0; k < scene->meshes[i].normal_count; k++)
            sure_dir(*normals++, num_dir_of(scene->meshes[i].normals[k]));
        p->meshes[i].pairs = pairs;
        pairs += tia_sure_set_pairs(pairs, own, &p->meshes[i]);
    }
    s->meshes = p->meshes;
    tia_sure_set_objects(s, &p->of);
    s->object = p->of.objects;
    if (has_wide(scene))
        tia_sure_widen(&s->objects, s->object, scene->sphere_count, p->wides, p->leaves, p->wide_of);
}

/* Sets a material. A ray that meets a material with an opacity, a bump or a noise is undecided. */
static void set_material(struct sure_material *to, const struct tia_material *m, const struct tia_texture *textures)
{
    const struct tia_texture *t = m->texture && !colour_is_black(&m->colour) ? &textures[m->texture - 1] : NULL;

    *to = (struct sure_material){.known = !m->opacity && !m->bump};
    if (t && t->kind == TIA_NOISE) {
        to->known = false;
        t = NULL;
    }
    to->texture = t;
    for (int i = 0; i < 2 && t; i++) {
        sure_rgb(to->cells[i], &t->cells[i]);
        to->repeat[i] = (double)t->repeat[i] * sure_two_to(-16 - t->repeat_bits);
        to->offset[i] = (double)t->offset[i] * sure_two_to(-16 - t->offset_bits);
    }
    sure_rgb(to->column + SURE_COLOUR, &m->colour);
    sure_rgb(to->column + SURE_SPECULAR, &m->specular);
    sure_rgb(to->column + SURE_MIRROR, &m->mirror);
    sure_rgb(to->column + SURE_REFRACTION, &m->refraction);
    sure_rgb(to->column + SURE_EMISSION, &m->emission);
    sure_rgb(to->column + SURE_FACING, &m->facing);
    to->is_specular = !colour_is_black(&m->specular);
    to->refracts = !colour_is_black(&m->refraction);
    to->fresnel = m->fresnel;
    to->column[SURE_EXPONENT] = (double)m->exponent * SURE_Q16;
    for (uint32_t i = 0; i < SURE_EXPONENT; i++)
        to->groups |= (uint32_t)(to->column[i] > 0) << i / 3;
    to->groups |= (uint32_t)to->is_specular << SURE_EXPONENT / 3;
}

static void set_camera(struct sure_camera *to, const struct ray_camera *c)
{
    sure_point(to->eye, c->eye);
    sure_dir(to->u, c->u);
    sure_dir(to->v, c->v);
    sure_dir(to->n, c->n);
    to->left = sure_length(c->left);
    to->top = sure_length(c->bottom + c->upward);
    to->across = sure_length(c->across);
    to->upward = sure_length(c->upward);
    to->away = sure_length(c->depth);
    to->width = c->width;
    to->height = c->height;
    to->side = c->side;
    to->orthographic = c->projection == TIA_ORTHOGRAPHIC;
}

void tia_sure_prepare(struct tia_view *view)
{
    const struct tia_scene *scene = view->scene;
    struct room room = {aligned(view->simd_memory), 0};
    struct places places;

    (void)divide(&room, scene, view->light_capacity, &places);
    struct sure_scene *s = places.scene;
    s->view = view->prepared;
    set_trees(s, scene, &places);
    for (uint32_t i = 0; i < scene->material_count; i++)
        set_material(&places.materials[i], &scene->materials[i], scene->textures);
    s->materials = places.materials;
    s->lights = places.lights;
    s->places = places.places;
    s->unbounded = scene->bvh->unbounded;
    s->unbounded_count = scene->bvh->unbounded_count;
    s->depth = s->view->depth;
    s->bias = sure_length(s->view->bias);
    s->paths = NULL;
    sure_rgb(s->background, &scene->background);
    set_camera(&s->camera, &s->view->camera);
    s->extent = s->objects.extent;
    for (int k = 0; k < 3; k++)
        s->centre[k] = s->objects.centre[k];
}
