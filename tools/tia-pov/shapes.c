/* shapes.c - each shape, and how a texture lies on it. */
#include "pov.h"

#include <stdio.h>

static void write_transform(struct pov *pov, uint32_t transform)
{
    if (transform == 0)
        return;
    const struct tia_transform *t = &pov->scene->transforms[transform - 1];
    pov_triple(pov, "scale", pov_vec3(t->scale));
    pov_triple(pov, "rotate", pov_vec3(t->rotation));
    pov_triple(pov, "translate", pov_vec3(t->position));
}

static void write_plane(struct pov *pov, const struct tia_plane *p)
{
    struct point n = pov_dir3(p->normal), at = pov_vec3(p->point);

    pov_triple(pov, "plane {", n);
    text_word(&pov->text, ", %.10g", n.x * at.x + n.y * at.y + n.z * at.z);
}

/* Writes a cylinder or a cone. */
static void write_tapered(struct pov *pov, const char *name, struct tia_vec3 base, struct tia_vec3 top, double radius,
                          const tia_q16 *base_radius)
{
    pov_triple(pov, name, pov_vec3(base));
    if (base_radius != NULL)
        text_word(&pov->text, ", %.10g", pov_q16(*base_radius));
    pov_triple(pov, ",", pov_vec3(top));
    text_word(&pov->text, ", %.10g", radius);
}

static void write_ball(struct pov *pov, struct tia_vec3 centre, tia_q16 radius)
{
    pov_triple(pov, "sphere {", pov_vec3(centre));
    text_word(&pov->text, ", %.10g", pov_q16(radius));
}

static void write_box(struct pov *pov, struct tia_vec3 min, struct tia_vec3 max, uint32_t material)
{
    if (pov_textured(pov, material)) {
        pov_box(pov, min, max);
        return;
    }
    pov_triple(pov, "box {", pov_vec3(min));
    pov_triple(pov, ",", pov_vec3(max));
}

/* Writes the shape without its material. */
static void write_geometry(struct pov *pov, const struct tia_shape *s)
{
    switch (s->kind) {
    case TIA_SPHERE:
        write_ball(pov, s->sphere.centre, s->sphere.radius);
        break;
    case TIA_PLANE:
        write_plane(pov, &s->plane);
        break;
    case TIA_DISC:
        pov_triple(pov, "disc {", pov_vec3(s->disc.centre));
        pov_triple(pov, ",", pov_dir3(s->disc.normal));
        text_word(&pov->text, ", %.10g", pov_q16(s->disc.radius));
        break;
    case TIA_CYLINDER:
        write_tapered(pov, "cylinder {", s->cylinder.base, s->cylinder.top, pov_q16(s->cylinder.radius), NULL);
        text_word(&pov->text, s->cylinder.capped ? "" : "open");
        break;
    case TIA_CONE:
        write_tapered(pov, "cone {", s->cone.base, s->cone.top, pov_q16(s->cone.top_radius), &s->cone.base_radius);
        text_word(&pov->text, s->cone.capped ? "" : "open");
        break;
    case TIA_BOX:
        write_box(pov, s->box.min, s->box.max, s->material);
        break;
    case TIA_TRIANGLE:
        pov_triangle(pov, &s->triangle);
        break;
    case TIA_MESH:
        pov_mesh(pov, &pov->scene->meshes[s->mesh]);
        break;
    case TIA_GRID: /* write_grid */
        break;
    }
}

static bool is_closed(const struct tia_shape *s)
{
    return s->kind == TIA_SPHERE || s->kind == TIA_BOX || s->kind == TIA_MESH || s->kind == TIA_GRID ||
           (s->kind == TIA_CYLINDER && s->cylinder.capped) || (s->kind == TIA_CONE && s->cone.capped);
}

bool pov_flat(const struct tia_shape *s)
{
    return s != NULL && (s->kind == TIA_PLANE || s->kind == TIA_DISC);
}

static void write_frame(struct pov *pov, struct point normal, struct point origin, double scale)
{
    struct point a, b;

    pov_axes(normal, &a, &b);
    text_word(&pov->text, "scale %.10g matrix <%.10g, %.10g, %.10g, %.10g, %.10g, %.10g,", scale, a.x, a.y, a.z, b.x,
              b.y, b.z);
    text_word(&pov->text, "%.10g, %.10g, %.10g, %.10g, %.10g, %.10g>", normal.x, normal.y, normal.z, origin.x, origin.y,
              origin.z);
}

void pov_mapping(struct pov *pov, uint32_t material, const struct tia_shape *s)
{
    if (s == NULL)
        return;
    switch (s->kind) {
    case TIA_SPHERE:
        text_word(&pov->text, "scale <1, -1, 1> translate <-0.5, 1, 0>");
        if (!pov_closes(pov, material))
            pov_note(pov, "material %u: half of its texture is shifted on spheres here", material);
        break;
    case TIA_PLANE:
        write_frame(pov, pov_dir3(s->plane.normal), pov_vec3(s->plane.point), 1);
        break;
    case TIA_DISC:
        write_frame(pov, pov_dir3(s->disc.normal), pov_vec3(s->disc.centre), pov_q16(s->disc.radius));
        break;
    case TIA_CYLINDER:
    case TIA_CONE:
        pov_note(pov, "material %u: its texture lies otherwise on cylinders and cones here", material);
        break;
    case TIA_BOX:
    case TIA_TRIANGLE:
    case TIA_MESH:
    case TIA_GRID:
        break; /* meshes with tia's coordinates */
    }
}

static void write_object(struct pov *pov, const struct tia_shape *s)
{
    bool shadow = pov_has_shadow(pov, s->material);

    for (int unseen = 0; unseen <= shadow; unseen++) {
        write_geometry(pov, s);
        if (unseen) {
            pov_shadow_material(pov, s->material, is_closed(s));
        } else {
            text_word(&pov->text, shadow ? "no_shadow" : "");
            pov_material(pov, s->material, s);
        }
        write_transform(pov, s->transform);
        text_print(&pov->text, " }\n");
    }
}

/* The number of equal cells along x that can be one box; 1 if textured, since the texture repeats per cell. */
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

    write_box(pov, min, max, material);
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
    write_transform(pov, s->transform);
    text_print(&pov->text, "\n}\n");
}

static void note_grid(struct pov *pov, uint32_t index, const struct tia_shape *s)
{
    const struct tia_grid *g = &pov->scene->grids[s->grid];
    size_t count = (size_t)g->size[0] * g->size[1] * g->size[2];

    for (size_t i = 0; i < count; i++) {
        if (g->cells[i] == 0 || !pov_has_shadow(pov, s->material + g->cells[i] - 1))
            continue;
        pov_note(pov, "shape %u: what its cells let through, they let through cell by cell here", index);
        return;
    }
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
        if (scene->shapes[i].kind != TIA_GRID) {
            write_object(pov, &scene->shapes[i]);
            continue;
        }
        note_grid(pov, i, &scene->shapes[i]);
        write_grid(pov, &scene->shapes[i]);
    }
}
