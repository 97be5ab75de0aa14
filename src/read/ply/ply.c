/* ply.c - Stanford's polygons, .ply: a header that describes elements and their properties, then these as text or in
 * binary, little or big endian.
 *
 *     vertex   x y z, of any type; nx ny nz, normals of any length; u v (or s t, texture_u texture_v);
 *              red green blue, 0 to 255 as integers or 0 to 1
 *     face     vertex_indices (or vertex_index), a list; polygons of 3 to POLYGON_MAX corners
 *
 * A mesh has one material: its colour is the mean of the vertices' colours. Other elements and properties are skipped.
 */
#include "ply.h"

/* ---- vertices ---- */

#define HAS(e, role) ((e)->roles >> (role)&1)

/* Returns the fractional bits with which a property of a vertex is read. */
static unsigned bits_of(const struct ply *ply, const struct ply_property *property)
{
    if (property->role <= PLY_Z)
        return tia_model_bits(&ply->p->model);
    return property->role <= PLY_NZ ? 32 : 16;
}

/* Adds a vertex's colour to the sums. Integers are 0 to 255, others 0 to 1. */
static void add_colour(struct ply *ply, const struct ply_element *e, const int64_t values[PLY_ROLES])
{
    for (unsigned i = e->first; i < e->end; i++) {
        const struct ply_property *property = &ply->properties[i];
        if (property->role < PLY_RED || property->role > PLY_BLUE)
            continue;
        int64_t level = values[property->role];
        level = (property->type >= PLY_F32 ? level * 255 + 32768 : level) >> 16;
        ply->p->colour[property->role - PLY_RED] += (uint64_t)(level < 0 ? 0 : level > 255 ? 255 : level);
    }
    ply->p->colours++;
}

static int add_normal(struct ply *ply, const int64_t values[PLY_ROLES])
{
    struct tia_dir3 normal = {0, 0, 0};
    int status = TIA_OK;

    if (!tia_dir3_of(&normal, &values[PLY_NX])) {
        (void)tia_ply_error(ply, "its normal has no length, expected nx, ny and nz that are not all 0");
        status = tia_plain_forgive(ply->p, TIA_WARN_NORMAL, "faces that use it are drawn flat");
    }
    tia_array_add(&ply->p->normals, &normal);
    return status;
}

static int add_vertex(struct ply *ply, const struct ply_element *e, const int64_t values[PLY_ROLES])
{
    struct tia_vec3 vertex = tia_model_vertex(&ply->p->model, &values[PLY_X]);

    tia_array_add(&ply->p->vertices, &vertex);
    if (HAS(e, PLY_RED) && HAS(e, PLY_GREEN) && HAS(e, PLY_BLUE))
        add_colour(ply, e, values);
    if (HAS(e, PLY_U) && HAS(e, PLY_V)) {
        const struct tia_uv uv = {(tia_q16)values[PLY_U], (tia_q16)values[PLY_V]};
        tia_array_add(&ply->p->uvs, &uv);
    }
    return HAS(e, PLY_NX) && HAS(e, PLY_NY) && HAS(e, PLY_NZ) ? add_normal(ply, values) : TIA_OK;
}

/* ---- lists ---- */

static int read_length(struct ply *ply, const struct ply_property *property, uint32_t *length)
{
    int64_t wide;
    int status = tia_ply_number(ply, property->count_type, 0, &wide);

    if (!status && wide < 0)
        return tia_ply_error(ply, "a list has a negative length, expected 0 or more");
    *length = (uint32_t)wide;
    return status;
}

static int skip_list(struct ply *ply, const struct ply_property *property)
{
    int64_t unused;
    uint32_t length = 0;
    int status = read_length(ply, property, &length);

    for (uint32_t i = 0; !status && i < length; i++)
        status = tia_ply_number(ply, property->type, 0, &unused);
    return status;
}

static int leave_out(struct ply *ply, const char *why)
{
    (void)tia_ply_error(ply, why);
    return tia_plain_forgive(ply->p, TIA_WARN_FACE, "the face is left out");
}

static int read_polygon(struct ply *ply, const struct ply_property *property)
{
    uint32_t length = 0;
    bool bad = false;
    int64_t index;
    int status = read_length(ply, property, &length);

    if (!status && length > POLYGON_MAX)
        return tia_ply_error(ply, "it has too many corners, expected at most 4096");
    for (uint32_t i = 0; !status && i < length; i++) {
        status = tia_ply_number(ply, property->type, 0, &index);
        bad = bad || status || index < 0 || index >= ply->p->vertices.count;
        if (!bad)
            tia_plain_corner(ply->p, i, (uint32_t)index);
    }
    if (status)
        return status;
    if (bad)
        return leave_out(ply, "it refers to a vertex that does not exist, expected one of the file");
    if (length < 3)
        return leave_out(ply, "it has too few corners, expected 3 or more");
    tia_plain_polygon(ply->p, length);
    return TIA_OK;
}

/* ---- elements ---- */

static int read_item(struct ply *ply, const struct ply_element *e)
{
    int64_t values[PLY_ROLES + 2] = {0};
    int status = TIA_OK;

    for (unsigned i = e->first; !status && i < e->end; i++) {
        const struct ply_property *property = &ply->properties[i];
        if (property->role == PLY_CORNERS)
            status = read_polygon(ply, property);
        else if (property->count_type)
            status = skip_list(ply, property);
        else if (property->role == PLY_OTHER && ply->binary)
            status = tia_ply_skip(ply, property->type);
        else
            status = tia_ply_number(ply, property->type, bits_of(ply, property), &values[property->role]);
    }
    return status || e->kind != PLY_VERTEX ? status : add_vertex(ply, e, values);
}

static int read_elements(struct ply *ply)
{
    int status = TIA_OK;

    for (unsigned i = 0; i < ply->element_count; i++) {
        const struct ply_element *e = &ply->elements[i];
        ply->thing = e->kind == PLY_VERTEX ? "vertex" : e->kind == PLY_FACE ? "face" : "element";
        for (uint32_t k = 0; !status && e->first < e->end && k < e->count; k++) {
            ply->number = k + 1;
            status = read_item(ply, e);
        }
    }
    return status;
}

static int read_once(struct tia_plain *p, void *ctx)
{
    struct ply *ply = ctx;

    *ply = (struct ply){.p = p, .text = tia_model_text(&p->model)};
    int status = tia_ply_header(ply);
    return status ? status : read_elements(ply);
}

int tia_read_ply(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena, struct tia_model_use *use)
{
    struct tia_plain p = tia_plain_begin(reader, scene, use, "some faces");
    struct ply ply;

    return tia_plain_read(&p, arena, read_once, &ply);
}
