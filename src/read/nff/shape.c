/* shape.c - spheres, cylinders, cones and polygons of a .nff scene. */
#include "nff.h"

/* Returns the index of the current material. */
static uint32_t material(struct nff *n)
{
    static const struct tia_material white = {
        .colour = {TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE}, .exponent = TIA_Q16_ONE, .index = TIA_Q16_ONE};

    if (!n->materials.count)
        tia_array_add(&n->materials, &white);
    return n->materials.count - 1;
}

/* Reads a radius and drops its sign: a negative radius would show the inside only. */
static int read_radius(struct tia_text *t, tia_q16 *out, int16_t *digits)
{
    int status = tia_text_fine_length(t, out, digits);

    if (!status && *out < 0) {
        *out = *out == INT32_MIN ? INT32_MAX : -*out;
        *digits = *digits == INT16_MIN ? INT16_MAX : (int16_t) - *digits;
    }
    return status;
}

int tia_nff_s(struct nff *n)
{
    struct tia_sphere s = {.material = material(n)};
    struct tia_fine_sphere fine = {{0, 0, 0}, 0};
    int status = tia_text_fine_place(&n->text, &s.centre, &fine.centre);

    status = status ? status : read_radius(&n->text, &s.radius, &fine.radius);
    tia_lengths_cover(&n->lengths, s.centre, s.radius);
    tia_array_add(&n->spheres, &s);
    tia_array_add(&n->fine_spheres, &fine);
    return status;
}

int tia_nff_c(struct nff *n)
{
    struct tia_shape shape = {.kind = TIA_CONE, .material = material(n)};
    struct tia_cone cone = {.capped = false};
    struct tia_fine_ends fine = {.base_radius = 0};
    int status = tia_text_fine_place(&n->text, &cone.base, &fine.base);

    status = status ? status : read_radius(&n->text, &cone.base_radius, &fine.base_radius);
    status = status ? status : tia_text_fine_place(&n->text, &cone.top, &fine.top);
    status = status ? status : read_radius(&n->text, &cone.top_radius, &fine.top_radius);
    tia_lengths_cover(&n->lengths, cone.base, cone.base_radius);
    tia_lengths_cover(&n->lengths, cone.top, cone.top_radius);
    shape.cone = cone;
    if (cone.base_radius == cone.top_radius) {
        shape.kind = TIA_CYLINDER;
        shape.cylinder = (struct tia_cylinder){.base = cone.base, .top = cone.top, .radius = cone.base_radius};
    }
    tia_array_add(&n->shapes, &shape);
    tia_array_add(&n->fine_shapes, &fine);
    return status;
}

void tia_nff_close_mesh(struct nff *n)
{
    if (n->mesh.vertex_count)
        tia_array_add(&n->meshes, &n->mesh);
    n->mesh.vertex_count = 0;
}

/* Returns the address of the array's next item. */
static const void *next_item(const struct tia_array *array)
{
    return array->items ? array->items + array->count * array->item : NULL;
}

static void open_mesh(struct nff *n)
{
    static const struct tia_fine_ends none = {0};
    struct tia_shape shape = {.kind = TIA_MESH, .material = material(n), .mesh = n->meshes.count};

    if (n->mesh.vertex_count)
        return;
    tia_array_add(&n->shapes, &shape);
    tia_array_add(&n->fine_shapes, &none);
    n->mesh = (struct tia_mesh){
        .vertices = next_item(&n->vertices), .normals = next_item(&n->normals), .faces = next_item(&n->faces)};
    if (n->transmits)
        n->mesh.groups = next_item(&n->groups);
}

/* Adds a face of polygon number n->polygons. */
static void add_face(struct nff *n, const struct tia_face *face)
{
    tia_array_add(&n->faces, face);
    if (n->transmits)
        tia_array_add(&n->groups, &n->polygons);
}

/* Triangulates the polygon of the last `count` vertices and adds its faces. */
static void add_faces(struct nff *n, uint32_t count, bool has_normals)
{
    struct tia_face face = {0};
    struct polygon polygon;
    uint32_t triangle[3];

    n->mesh.face_count += count - 2;
    n->polygons++;
    if (!n->corners) {
        n->most_corners = count > n->most_corners ? count : n->most_corners;
        for (uint32_t i = 0; i < count - 2; i++)
            add_face(n, &face);
        return;
    }
    uint32_t vertex = n->mesh.vertex_count - count, normal = n->mesh.normal_count - count;
    for (uint32_t i = 0; i < count; i++)
        n->corners[i].point = n->mesh.vertices[vertex + i];
    tia_polygon_begin(&polygon, n->corners, count);
    while (tia_polygon_next(&polygon, triangle)) {
        for (int i = 0; i < 3; i++)
            face.corner[i] = (struct tia_corner){vertex + triangle[i],
                                                 has_normals ? normal + triangle[i] : TIA_NO_INDEX, TIA_NO_INDEX};
        add_face(n, &face);
    }
}

/* Reads a vertex, on this line or a later one, and its normal if it has one. */
static int read_vertex(struct nff *n, bool has_normal)
{
    struct tia_vec3 vertex = {0, 0, 0};
    struct tia_dir3 normal = {0, 0, 0};
    struct tia_word word;

    if (!tia_text_peek(&n->text, &word))
        (void)tia_text_line(&n->text);
    int status = tia_text_place(&n->text, &vertex);
    tia_lengths_cover(&n->lengths, vertex, 0);
    if (!status && has_normal)
        status = tia_text_dir3(&n->text, &normal);
    tia_array_add(&n->vertices, &vertex);
    n->mesh.vertex_count++;
    if (has_normal) {
        tia_array_add(&n->normals, &normal);
        n->mesh.normal_count++;
    }
    return status;
}

static int read_polygon(struct nff *n, bool has_normals)
{
    int64_t count;
    int status = tia_text_integer(&n->text, &count, 3, POLYGON_MAX);

    if (status)
        return status;
    open_mesh(n);
    for (int64_t i = 0; i < count; i++) {
        status = read_vertex(n, has_normals);
        if (status)
            return status;
    }
    add_faces(n, (uint32_t)count, has_normals);
    return TIA_OK;
}

int tia_nff_p(struct nff *n)
{
    return read_polygon(n, false);
}

int tia_nff_pp(struct nff *n)
{
    return read_polygon(n, true);
}
