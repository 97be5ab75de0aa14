/* objects.c - the objects of a scene: shapes with their materials, and grids cell by cell. */
#include "pov.h"

/* Writes a part of a shape. The block stays open, for a transform. */
static void write_part(struct pov *pov, const struct tia_shape *s, bool unseen)
{
    pov_geometry(pov, s);
    if (unseen) {
        pov_shadow_material(pov, s->material, s);
    } else {
        text_word(&pov->text, pov_has_shadow(pov, s->material) ? "no_shadow" : "");
        pov_material(pov, s->material, s);
    }
}

static void write_object(struct pov *pov, const struct tia_shape *s)
{
    struct tia_shape parts[3];
    unsigned count = pov_parts(pov, s, parts);
    bool shadow = pov_has_shadow(pov, s->material);

    for (int unseen = 0; unseen <= shadow; unseen++) {
        text_word(&pov->text, count > 0 ? "union {" : "");
        for (unsigned i = 0; i < count; i++) {
            write_part(pov, &parts[i], unseen);
            text_print(&pov->text, " }\n");
        }
        if (count == 0)
            write_part(pov, s, unseen);
        pov_transform(pov, s->transform);
        text_print(&pov->text, " }\n");
    }
}

/* Returns the number of equal cells along x that can be one box; 1 with a texture, since a texture repeats in each
 * cell. */
static uint32_t run_length(const struct pov *pov, const uint8_t *cells, uint32_t count, uint32_t material)
{
    uint32_t n = 1;

    while (n < count && cells[n] == cells[0] && !pov_textured(pov, material))
        n++;
    return n;
}

static void write_cells(struct pov *pov, const struct tia_grid *g, uint32_t row, uint32_t x, uint32_t n,
                        uint32_t material)
{
    uint32_t y = row % g->size[1], z = row / g->size[1];
    struct tia_vec3 min = {g->corner.x + (tia_q16)x * g->cell, g->corner.y + (tia_q16)y * g->cell,
                           g->corner.z + (tia_q16)z * g->cell};
    struct tia_vec3 max = {min.x + (tia_q16)n * g->cell, min.y + g->cell, min.z + g->cell};

    const struct tia_shape box = {.kind = TIA_BOX, .material = material, .box = {min, max}};

    pov_geometry(pov, &box);
    pov_material(pov, material, NULL);
    text_print(&pov->text, " }\n");
}

static void write_grid(struct pov *pov, const struct tia_shape *s)
{
    const struct tia_grid *g = &pov->scene->grids[s->grid];

    text_print(&pov->text, "union {\n");
    for (uint32_t row = 0; row < (uint32_t)g->size[1] * g->size[2]; row++) {
        const uint8_t *cells = g->cells + (size_t)row * g->size[0];
        for (uint32_t x = 0, n; x < g->size[0]; x += n) {
            uint32_t material = s->material + cells[x] - 1;
            n = cells[x] == 0 ? 1 : run_length(pov, cells + x, g->size[0] - x, material);
            if (cells[x] != 0)
                write_cells(pov, g, row, x, n, material);
        }
    }
    pov_transform(pov, s->transform);
    text_print(&pov->text, "\n}\n");
}

static void note_grid(struct pov *pov, uint32_t index, const struct tia_shape *s)
{
    const struct tia_grid *g = &pov->scene->grids[s->grid];
    size_t count = (size_t)g->size[0] * g->size[1] * g->size[2];

    for (size_t i = 0; i < count; i++) {
        if (g->cells[i] == 0 || !pov_has_shadow(pov, s->material + g->cells[i] - 1))
            continue;
        pov_note(pov, "shape %u: its cells filter shadow rays cell by cell here", index);
        break;
    }
    for (size_t i = 0; i < count; i++) {
        if (g->cells[i] == 0 || pov->scene->materials[s->material + g->cells[i] - 1].opacity == 0)
            continue;
        pov_note(pov, "shape %u: faces between equal cells are visible here through its opacity", index);
        return;
    }
}

/* Notes a difference: tia's object filters a shadow ray once, POV-Ray's once at each face or part. */
static void note_shadow(struct pov *pov, uint32_t index, const struct tia_shape *s)
{
    struct tia_shape parts[3];

    if (s->kind == TIA_GRID || s->kind == TIA_SOLID || !pov_has_shadow(pov, s->material) ||
        pov->scene->materials[s->material].opacity != 0)
        return;
    if (s->kind == TIA_MESH && pov->scene->meshes[s->mesh].groups)
        pov_note(pov, "shape %u: its groups of faces filter shadow rays face by face here", index);
    else if (pov_parts(pov, s, parts) > 0)
        pov_note(pov, "shape %u: its side and caps filter shadow rays one by one here", index);
}

void pov_shapes(struct pov *pov)
{
    const struct tia_scene *scene = pov->scene;

    for (uint32_t i = 0; i < scene->sphere_count; i++) {
        const struct tia_sphere *s = &scene->spheres[i];
        const struct tia_shape shape = {.kind = TIA_SPHERE, .material = s->material, .sphere = {s->centre, s->radius}};
        write_object(pov, &shape);
    }
    for (uint32_t i = 0; i < scene->shape_count; i++) {
        if (scene->shapes[i].kind == TIA_MESH && !scene->meshes[scene->shapes[i].mesh].face_count)
            continue; /* POV-Ray refuses a mesh without faces */
        note_shadow(pov, i, &scene->shapes[i]);
        switch (scene->shapes[i].kind) {
        case TIA_GRID:
            note_grid(pov, i, &scene->shapes[i]);
            write_grid(pov, &scene->shapes[i]);
            break;
        case TIA_SOLID:
            pov_solid(pov, &scene->shapes[i]);
            break;
        default:
            write_object(pov, &scene->shapes[i]);
        }
    }
}
