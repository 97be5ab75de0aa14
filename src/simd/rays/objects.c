/* objects.c - conversion of spheres and shapes to double precision. */
#include "grids.h"
#include "scene/colour.h"
#include "sure_faces.h"

static void set_sphere(struct sure_object *o, struct num_point centre, num_length radius)
{
    o->kind = SURE_SPHERE;
    sure_point(o->at, centre);
    o->radius = sure_length(radius);
}

static void set_flat(struct sure_object *o, enum sure_kind kind, const struct shape *shape)
{
    const struct prepared_plane *plane = &shape->plane;

    o->kind = kind;
    sure_point(o->at, plane->point);
    sure_dir(o->normal, plane->normal);
    sure_dir(o->axes[0], plane->tangents[0]);
    sure_dir(o->axes[1], plane->tangents[1]);
    o->radius = sure_length(plane->radius);
    o->unit = sure_two_to(shape->uv_bits);
}

static void set_round(struct sure_object *o, struct sure_round *to, const struct prepared_cone *from)
{
    sure_dir(to->axis, from->axis);
    sure_dir(to->across[0], from->across[0]);
    sure_dir(to->across[1], from->across[1]);
    sure_point(to->base, from->base);
    sure_point(to->anchor, from->anchor);
    to->anchored = sure_length(from->anchored);
    to->reach = sure_length(from->reach);
    to->length = sure_length(from->length);
    to->base_radius = sure_length(from->base_radius);
    to->top_radius = sure_length(from->top_radius);
    to->cosine = sure_cosine(from->slope_cosine);
    to->sine = sure_cosine(from->slope_sine);
    to->capped = from->capped;
    o->kind = SURE_ROUND;
    o->round = to;
}

static void set_kind(const struct sure_scene *s, struct sure_object *o, const struct tia_shape *given,
                     const struct shape *shape, struct sure_round *round, struct sure_face *face)
{
    switch (given->kind) {
    case TIA_MESH:
        o->kind = SURE_MESH;
        o->mesh = &s->meshes[given->mesh];
        o->faces = &s->view->scene->meshes[given->mesh];
        break;
    case TIA_SPHERE:
        set_sphere(o, shape->sphere.centre, shape->sphere.radius);
        break;
    case TIA_PLANE:
        set_flat(o, SURE_PLANE, shape);
        break;
    case TIA_DISC:
        set_flat(o, SURE_DISC, shape);
        break;
    case TIA_CYLINDER:
    case TIA_CONE:
        set_round(o, round, &shape->cone);
        break;
    case TIA_BOX:
        o->kind = SURE_BOX;
        sure_point(o->at, shape->box.min);
        sure_point(o->normal, shape->box.max);
        break;
    case TIA_TRIANGLE:
        o->kind = SURE_TRIANGLE;
        tia_sure_set_face(face, given->triangle.corner);
        o->face = face;
        break;
    default:
        break;
    }
}

/* Decides whether a grid is opaque: all materials that its cells may have must be opaque. The transmission of any other
 * grid is undecided. */
static void set_cells(struct sure_object *o, const struct tia_scene *scene)
{
    for (uint32_t m = o->material; m < scene->material_count && m - o->material < UINT8_MAX; m++)
        o->opaque = o->opaque && colour_is_black(&scene->materials[m].transmission);
    o->unclear = !o->opaque;
}

/* Sets an object's transmission. Objects with an opacity and meshes with groups may filter a ray more than once: the
 * transmission of the former is undecided, and the latter are `grouped`. */
static void set_filter(struct sure_object *o, const struct tia_scene *scene, bool layered, bool grouped)
{
    const struct tia_material *m = &scene->materials[o->material];

    sure_rgb(o->transmission, &m->transmission);
    o->opaque = colour_is_black(&m->transmission) && !layered;
    o->layered = o->unclear = layered;
    o->grouped = grouped && !o->opaque && !layered && o->kind == SURE_MESH;
    o->unclear = o->unclear || (grouped && !o->opaque && !o->grouped);
}

static void set_instance(struct sure_instance *to, const struct instance *from)
{
    sure_point(to->position, from->position);
    to->least = to->most = sure_length(from->scale[0]);
    to->size = to->extent = 0;
    for (int i = 0; i < 3; i++) {
        double min = sure_length(from->min[i]), max = sure_length(from->max[i]), scale = sure_length(from->scale[i]);
        sure_dir(to->axes[i], from->axes[i]);
        to->scale[i] = scale;
        to->inverse[i] = 1 / scale;
        to->least = scale < to->least ? scale : to->least;
        to->most = scale > to->most ? scale : to->most;
        to->size += __builtin_fabs(min) + __builtin_fabs(max);
        to->centre[i] = (min + max) / 2 / scale;
        to->extent += (max - min) / 2 / scale;
    }
}

/* Sets a grid; its cubes are the next ones at *empty. */
static void set_grid(struct sure_object *o, struct sure_grid *to, const struct prepared_grid *from, uint8_t **empty)
{
    uint32_t cells = sure_grid_cells(from->grid);

    *to = (struct sure_grid){.from = from->grid, .edge = sure_length(from->cell)};
    sure_point(to->corner, from->corner);
    if (cells) {
        tia_sure_set_empty(*empty, from->grid);
        to->empty = *empty;
        *empty += 8 * (size_t)cells;
    }
    o->kind = SURE_GRID;
    o->grid = to;
}

static void set_shape(struct sure_scene *s, uint32_t i, const struct sure_places *p, uint8_t **empty)
{
    const struct tia_scene *scene = s->view->scene;
    const struct tia_shape *given = &scene->shapes[i];
    const struct shape *shape = &s->view->shapes[i];
    struct sure_object *o = &p->objects[scene->sphere_count + i];
    bool several = given->kind == TIA_GRID || shape->instance;

    *o = (struct sure_object){.kind = SURE_UNKNOWN, .material = given->material};
    set_kind(s, o, given, shape, &p->rounds[i], &p->faces[i]);
    if (given->kind == TIA_GRID)
        set_grid(o, &p->grids[i], &shape->grid, empty);
    if (shape->instance) {
        set_instance(&p->instances[i], shape->instance);
        o->placed = &p->instances[i];
    }
    set_filter(o, scene, shape->layered, given->kind == TIA_MESH && scene->meshes[given->mesh].groups);
    o->unclear = o->unclear || (several && o->grouped);
    o->grouped = o->grouped && !several;
    if (given->kind == TIA_GRID)
        set_cells(o, scene);
    if (given->kind == TIA_SOLID) { /* its members have their own materials */
        o->opaque = false;
        o->unclear = true;
    }
}

void tia_sure_set_objects(struct sure_scene *s, const struct sure_places *places)
{
    const struct tia_scene *scene = s->view->scene;
    static const struct tia_fine_sphere none;
    uint8_t *empty = places->empty;

    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *given = &scene->spheres[i];
        const struct tia_fine_sphere *fine = scene->fine ? &scene->fine->spheres[i] : &none;
        struct num_point centre = num_point_add(num_point_of(given->centre), num_point_fine(fine->centre));
        struct sure_object *o = &places->objects[i];

        *o = (struct sure_object){.material = given->material};
        set_sphere(o, centre, num_length_of(given->radius) + num_fine(fine->radius));
        set_filter(o, scene, scene->materials[given->material].opacity, false);
    }
    for (uint32_t i = 0; i < scene->shape_count; i++)
        set_shape(s, i, places, &empty);
}
