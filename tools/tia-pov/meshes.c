#include "pov.h"

#include <stdio.h>

static void begin_list(struct pov *pov, const char *name, uint32_t count)
{
    text_print(&pov->text, "\n    %s { %u", name, count);
}

/* Writes an item of a list: a comma and a vector. */
static void item(struct pov *pov, struct point p)
{
    text_print(&pov->text, ",");
    pov_triple(pov, "", p);
}

static void end_list(struct pov *pov)
{
    text_print(&pov->text, " }");
}

static const struct tia_vec3 *vertex(const struct tia_mesh *m, const struct tia_face *f, int corner)
{
    return &m->vertices[f->corner[corner].vertex];
}

/* Returns the normal of a face without normals; an arbitrary one if its corners are collinear. */
static struct point flat_normal(const struct tia_mesh *m, const struct tia_face *f)
{
    struct point a = pov_vec3(*vertex(m, f, 0)), minus_a = pov_scaled(a, -1);
    struct point n =
        pov_cross(pov_sum(pov_vec3(*vertex(m, f, 1)), minus_a), pov_sum(pov_vec3(*vertex(m, f, 2)), minus_a));

    return n.x == 0 && n.y == 0 && n.z == 0 ? (struct point){0, 1, 0} : pov_unit(n);
}

static bool has_normals(const struct tia_face *f)
{
    return f->corner[0].normal != TIA_NO_INDEX;
}

/* Counts the faces without normals. POV-Ray needs normals for all faces or for none, so normals for these faces are
 * appended to those of the mesh. */
static uint32_t count_flat(const struct tia_mesh *m)
{
    uint32_t flat = 0;

    for (uint32_t i = 0; i < m->face_count; i++)
        flat += !has_normals(&m->faces[i]);
    return flat;
}

static void write_normals(struct pov *pov, const struct tia_mesh *m, uint32_t flat)
{
    begin_list(pov, "normal_vectors", m->normal_count + flat);
    for (uint32_t i = 0; i < m->normal_count; i++)
        item(pov, pov_dir3(m->normals[i]));
    for (uint32_t i = 0; i < m->face_count; i++)
        if (!has_normals(&m->faces[i]))
            item(pov, flat_normal(m, &m->faces[i]));
    end_list(pov);
}

static void indices(struct pov *pov, uint32_t a, uint32_t b, uint32_t c)
{
    text_word(&pov->text, ", <%u, %u, %u>", a, b, c);
}

static void write_normal_indices(struct pov *pov, const struct tia_mesh *m)
{
    uint32_t next = m->normal_count;

    begin_list(pov, "normal_indices", m->face_count);
    for (uint32_t i = 0; i < m->face_count; i++) {
        const struct tia_corner *c = m->faces[i].corner;
        if (has_normals(&m->faces[i]))
            indices(pov, c[0].normal, c[1].normal, c[2].normal);
        else
            indices(pov, next, next, next);
        next += !has_normals(&m->faces[i]);
    }
    end_list(pov);
}

/* Writes the texture coordinates. Those of a triangle are appended, (0, 0), (1, 0), (0, 1), for faces without
 * coordinates. */
static void write_uvs(struct pov *pov, const struct tia_mesh *m)
{
    begin_list(pov, "uv_vectors", m->uv_count + 3);
    for (uint32_t i = 0; i < m->uv_count; i++)
        text_word(&pov->text, ", <%.10g, %.10g>", pov_q16(m->uvs[i].u), pov_q16(m->uvs[i].v));
    text_word(&pov->text, ", <0, 0>, <1, 0>, <0, 1>");
    end_list(pov);
}

static void write_uv_indices(struct pov *pov, const struct tia_mesh *m)
{
    begin_list(pov, "uv_indices", m->face_count);
    for (uint32_t i = 0; i < m->face_count; i++) {
        const struct tia_corner *c = m->faces[i].corner;
        if (c[0].uv != TIA_NO_INDEX)
            indices(pov, c[0].uv, c[1].uv, c[2].uv);
        else
            indices(pov, m->uv_count, m->uv_count + 1, m->uv_count + 2);
    }
    end_list(pov);
}

static void write_faces(struct pov *pov, const struct tia_mesh *m)
{
    begin_list(pov, "face_indices", m->face_count);
    for (uint32_t i = 0; i < m->face_count; i++) {
        const struct tia_corner *c = m->faces[i].corner;
        indices(pov, c[0].vertex, c[1].vertex, c[2].vertex);
    }
    end_list(pov);
}

static void write_vertices(struct pov *pov, const struct tia_mesh *m)
{
    begin_list(pov, "vertex_vectors", m->vertex_count);
    for (uint32_t i = 0; i < m->vertex_count; i++)
        item(pov, pov_place(pov, m->vertices[i]));
    end_list(pov);
}

/* Writes a mesh; POV-Ray requires this order of the lists. */
void pov_mesh(struct pov *pov, const struct tia_mesh *m)
{
    uint32_t flat = count_flat(m);
    bool smooth = flat < m->face_count;

    text_word(&pov->text, "mesh2 {");
    write_vertices(pov, m);
    if (smooth)
        write_normals(pov, m, flat);
    write_uvs(pov, m);
    write_faces(pov, m);
    write_uv_indices(pov, m);
    if (smooth)
        write_normal_indices(pov, m);
}

void pov_triangle(struct pov *pov, const struct tia_triangle *t)
{
    static const struct tia_face face = {
        {{0, TIA_NO_INDEX, TIA_NO_INDEX}, {1, TIA_NO_INDEX, TIA_NO_INDEX}, {2, TIA_NO_INDEX, TIA_NO_INDEX}}};
    const struct tia_mesh mesh = {.vertices = t->corner, .faces = &face, .vertex_count = 3, .face_count = 1};

    pov_mesh(pov, &mesh);
}

/* The corners of each face, in the order of their texture coordinates (0, 0), (1, 0), (1, 1), (0, 1). A corner has
 * three numbers, for x, y and z: 0 for the box's minimum, 1 for its maximum. The directions of u and v on both faces
 * stand behind each row. */
static const uint8_t box_corners[6][4][3] = {
    {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}, {{1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}}, /* z, y; -z, y */
    {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{0, 1, 1}, {1, 1, 1}, {1, 1, 0}, {0, 1, 0}}, /* x, z; x, -z */
    {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, /* -x, y; x, y */
};

void pov_box(struct pov *pov, struct tia_vec3 min, struct tia_vec3 max)
{
    static const struct tia_uv uvs[4] = {{0, 0}, {TIA_Q16_ONE, 0}, {TIA_Q16_ONE, TIA_Q16_ONE}, {0, TIA_Q16_ONE}};
    struct tia_vec3 vertices[24];
    struct tia_face faces[12];

    for (uint32_t i = 0; i < 24; i++) {
        const uint8_t *end = box_corners[i / 4][i % 4];
        vertices[i] = (struct tia_vec3){end[0] ? max.x : min.x, end[1] ? max.y : min.y, end[2] ? max.z : min.z};
    }
    for (uint32_t i = 0; i < 12; i++) {
        uint32_t first = i / 2 * 4, second = i % 2;
        for (uint32_t j = 0; j < 3; j++) {
            uint32_t corner = j == 0 ? 0 : j + second;
            faces[i].corner[j] = (struct tia_corner){first + corner, TIA_NO_INDEX, corner};
        }
    }
    const struct tia_mesh mesh = {
        .vertices = vertices, .uvs = uvs, .faces = faces, .vertex_count = 24, .uv_count = 4, .face_count = 12};
    pov_mesh(pov, &mesh);
}
