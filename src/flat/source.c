#include "source.h"

static const struct tia_shape *shape_of(const struct tia_scene *scene, uint32_t object)
{
    return object < scene->sphere_count ? NULL : &scene->shapes[object - scene->sphere_count];
}

bool tia_flat_is_empty(const struct tia_scene *scene, uint32_t object)
{
    const struct tia_shape *shape = shape_of(scene, object);

    return shape && shape->kind == TIA_MESH && scene->meshes[shape->mesh].face_count == 0;
}

bool tia_flat_takes(const struct tia_scene *scene, uint32_t object)
{
    const struct tia_shape *shape = shape_of(scene, object);

    if (!shape)
        return scene->tessellated != 0;
    switch (shape->kind) {
    case TIA_PLANE:
    case TIA_BOX:
    case TIA_TRIANGLE:
        return true;
    case TIA_MESH:
        return !tia_flat_is_empty(scene, object);
    case TIA_GRID:
    case TIA_SOLID:
        return false;
    default:
        return scene->tessellated != 0;
    }
}

void tia_flat_count(const struct tia_scene *scene, uint32_t object, uint64_t *points, uint64_t *faces)
{
    const struct tia_shape *shape = shape_of(scene, object);
    struct tia_facets facets;

    if (tia_facets_of(scene, object, &facets)) {
        *points = facets.points;
        *faces = facets.faces;
        return;
    }
    switch (shape->kind) {
    case TIA_PLANE:
        *points = TIA_PLANE_POINTS;
        *faces = TIA_PLANE_FACES;
        return;
    case TIA_BOX:
        *points = 8;
        *faces = 12;
        return;
    case TIA_TRIANGLE:
        *points = 3;
        *faces = 1;
        return;
    default:
        *points = scene->meshes[shape->mesh].vertex_count;
        *faces = scene->meshes[shape->mesh].face_count;
    }
}

void tia_flat_source_init(struct tia_flat_source *s, const struct tia_scene *scene, uint32_t object)
{
    const struct tia_shape *shape = shape_of(scene, object);
    struct tia_facets facets;
    uint64_t points, faces;

    tia_flat_count(scene, object, &points, &faces);
    s->scene = scene;
    s->shape = shape;
    s->kind = shape ? shape->kind : TIA_SPHERE;
    s->points = (uint32_t)points;
    s->faces = (uint32_t)faces;
    s->divided = tia_facets_of(scene, object, &facets);
    s->parts[0] = UINT32_MAX;
    s->parts[1] = 0;
    if (s->divided) {
        tia_facet_shape_init(&s->facets, scene, object);
        tia_facet_parts(&s->facets, s->parts);
    }
    tia_frame_prepare(&s->frame, shape && shape->transform ? &scene->transforms[shape->transform - 1] : NULL);
}

static struct tia_vec3 point_of(const struct tia_flat_source *s, uint32_t i)
{
    const struct tia_box *box = &s->shape->box;

    switch (s->kind) {
    case TIA_PLANE:
        return s->shape->plane.point;
    case TIA_BOX:
        return (struct tia_vec3){i & 1 ? box->max.x : box->min.x, i & 2 ? box->max.y : box->min.y,
                                 i & 4 ? box->max.z : box->min.z};
    case TIA_TRIANGLE:
        return s->shape->triangle.corner[i];
    default:
        return s->scene->meshes[s->shape->mesh].vertices[i];
    }
}

void tia_flat_source_point(const struct tia_flat_source *s, uint32_t i, int64_t world[3])
{
    int64_t own[3];

    if (s->divided)
        tia_facet_point(&s->facets, i, own);
    for (int k = 0; k < 3; k++)
        world[k] =
            s->divided ? tia_frame_place_finely(&s->frame, k, own) : tia_frame_place(&s->frame, k, point_of(s, i));
}

/* A box has triangles, since four rounded corners need not lie in one plane. A plane has quadrilaterals: their
 * directions are exact opposites. */
struct tia_flat_face tia_flat_source_face(const struct tia_flat_source *s, uint32_t i)
{
    static const struct tia_flat_face plane[TIA_PLANE_FACES] = {{{0, 1, 2, 3}}, {{0, 3, 4, 1}}};
    static const uint8_t box[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                      {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    const uint8_t *q = box[i / 2 % 6];

    if (s->divided)
        return tia_facet_face(&s->facets, i);
    if (s->kind == TIA_PLANE)
        return plane[i];
    if (s->kind == TIA_BOX)
        return (struct tia_flat_face){{q[0], q[i % 2 ? 2 : 1], q[i % 2 ? 3 : 2], TIA_NO_CORNER}};
    if (s->kind == TIA_TRIANGLE)
        return (struct tia_flat_face){{0, 1, 2, TIA_NO_CORNER}};
    const struct tia_corner *c = s->scene->meshes[s->shape->mesh].faces[i].corner;
    return (struct tia_flat_face){{c[0].vertex, c[1].vertex, c[2].vertex, TIA_NO_CORNER}};
}
