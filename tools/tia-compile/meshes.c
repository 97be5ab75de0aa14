#include "unit.h"

static void write_vertices(struct unit *unit, uint32_t index, const struct tia_mesh *m)
{
    if (m->vertex_count == 0)
        return;
    table_begin(unit, "struct tia_vec3", "vertices_%u", index);
    for (uint32_t i = 0; i < m->vertex_count; i++)
        text_word(&unit->text, "{%d, %d, %d},", m->vertices[i].x, m->vertices[i].y, m->vertices[i].z);
    table_end(unit);
}

static void write_normals(struct unit *unit, uint32_t index, const struct tia_mesh *m)
{
    if (m->normal_count == 0)
        return;
    table_begin(unit, "struct tia_dir3", "normals_%u", index);
    for (uint32_t i = 0; i < m->normal_count; i++)
        text_word(&unit->text, "{%d, %d, %d},", m->normals[i].x, m->normals[i].y, m->normals[i].z);
    table_end(unit);
}

static void write_uvs(struct unit *unit, uint32_t index, const struct tia_mesh *m)
{
    if (m->uv_count == 0)
        return;
    table_begin(unit, "struct tia_uv", "uvs_%u", index);
    for (uint32_t i = 0; i < m->uv_count; i++)
        text_word(&unit->text, "{%d, %d},", m->uvs[i].u, m->uvs[i].v);
    table_end(unit);
}

static void write_faces(struct unit *unit, uint32_t index, const struct tia_mesh *m)
{
    if (m->face_count == 0)
        return;
    table_begin(unit, "struct tia_face", "faces_%u", index);
    for (uint32_t i = 0; i < m->face_count; i++) {
        const struct tia_corner *c = m->faces[i].corner;
        text_word(&unit->text, "{{{%uu, %uu, %uu}, {%uu, %uu, %uu}, {%uu, %uu, %uu}}},", c[0].vertex, c[0].normal,
                  c[0].uv, c[1].vertex, c[1].normal, c[1].uv, c[2].vertex, c[2].normal, c[2].uv);
    }
    table_end(unit);
}

static void write_groups(struct unit *unit, uint32_t index, const struct tia_mesh *m)
{
    if (!m->groups || m->face_count == 0)
        return;
    table_begin(unit, "uint32_t", "groups_%u", index);
    for (uint32_t i = 0; i < m->face_count; i++)
        text_word(&unit->text, "%uu,", m->groups[i]);
    table_end(unit);
}

static void write_mesh(struct unit *unit, uint32_t index, const struct tia_mesh *m)
{
    text_word(&unit->text, "{");
    field_table(unit, "vertices", m->vertex_count, "vertices_%u", index);
    field_table(unit, "normals", m->normal_count, "normals_%u", index);
    field_table(unit, "uvs", m->uv_count, "uvs_%u", index);
    field_table(unit, "faces", m->face_count, "faces_%u", index);
    field_table(unit, "groups", !m->groups ? 0 : m->face_count, "groups_%u", index);
    text_word(&unit->text, ".vertex_count = %uu,", m->vertex_count);
    field_unsigned(unit, "normal_count", m->normal_count);
    field_unsigned(unit, "uv_count", m->uv_count);
    field_unsigned(unit, "face_count", m->face_count);
    text_print(&unit->text, "},\n");
}

void unit_meshes(struct unit *unit)
{
    const struct tia_scene *scene = unit->scene;

    for (uint32_t i = 0; i < scene->mesh_count; i++) {
        write_vertices(unit, i, &scene->meshes[i]);
        write_normals(unit, i, &scene->meshes[i]);
        write_uvs(unit, i, &scene->meshes[i]);
        write_faces(unit, i, &scene->meshes[i]);
        write_groups(unit, i, &scene->meshes[i]);
    }
    if (scene->mesh_count == 0)
        return;
    table_begin(unit, "struct tia_mesh", "meshes");
    for (uint32_t i = 0; i < scene->mesh_count; i++)
        write_mesh(unit, i, &scene->meshes[i]);
    table_end(unit);
}
