/* shapes.c - each shape, and how a texture lies on it. */
#include "pov.h"

static void write_plane(struct pov *pov, const struct tia_plane *p)
{
    struct point n = pov_dir3(p->normal), at = pov_place(pov, p->point);

    pov_triple(pov, "plane {", n);
    text_word(&pov->text, ", %.10g", n.x * at.x + n.y * at.y + n.z * at.z);
}

/* Writes a cylinder or a cone. */
static void write_tapered(struct pov *pov, const char *name, struct tia_vec3 base, struct tia_vec3 top, double radius,
                          const tia_q16 *base_radius)
{
    pov_triple(pov, name, pov_place(pov, base));
    if (base_radius)
        text_word(&pov->text, ", %.10g", pov_length(pov, *base_radius));
    pov_triple(pov, ",", pov_place(pov, top));
    text_word(&pov->text, ", %.10g", radius);
}

static void write_ball(struct pov *pov, struct tia_vec3 centre, tia_q16 radius)
{
    pov_triple(pov, "sphere {", pov_place(pov, centre));
    text_word(&pov->text, ", %.10g", pov_length(pov, radius));
}

static void write_box(struct pov *pov, struct tia_vec3 min, struct tia_vec3 max, uint32_t material)
{
    if (pov_textured(pov, material)) {
        pov_box(pov, min, max);
        return;
    }
    pov_triple(pov, "box {", pov_place(pov, min));
    pov_triple(pov, ",", pov_place(pov, max));
}

void pov_geometry(struct pov *pov, const struct tia_shape *s)
{
    switch (s->kind) {
    case TIA_SPHERE:
        write_ball(pov, s->sphere.centre, s->sphere.radius);
        break;
    case TIA_PLANE:
        write_plane(pov, &s->plane);
        break;
    case TIA_DISC:
        pov_triple(pov, "disc {", pov_place(pov, s->disc.centre));
        pov_triple(pov, ",", pov_dir3(s->disc.normal));
        text_word(&pov->text, ", %.10g", pov_length(pov, s->disc.radius));
        break;
    case TIA_CYLINDER:
        write_tapered(pov, "cylinder {", s->cylinder.base, s->cylinder.top, pov_length(pov, s->cylinder.radius), NULL);
        text_word(&pov->text, s->cylinder.capped ? "" : "open");
        break;
    case TIA_CONE:
        write_tapered(pov, "cone {", s->cone.base, s->cone.top, pov_length(pov, s->cone.top_radius),
                      &s->cone.base_radius);
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
    case TIA_GRID: /* objects.c, cell by cell */
        break;
    }
}

bool pov_closed(const struct tia_scene *scene, const struct tia_shape *s)
{
    return s->kind == TIA_SPHERE || s->kind == TIA_BOX || s->kind == TIA_GRID ||
           (s->kind == TIA_MESH && !scene->meshes[s->mesh].groups) || (s->kind == TIA_CYLINDER && s->cylinder.capped) ||
           (s->kind == TIA_CONE && s->cone.capped);
}

bool pov_flat(const struct tia_shape *s)
{
    return s && (s->kind == TIA_PLANE || s->kind == TIA_DISC);
}

/* tia/shape.h's tangents of a unit normal. */
static void tangents(struct point n, struct point *u, struct point *v)
{
    *u = n.x == 0 && n.z == 0 ? (struct point){1, 0, 0} : pov_unit((struct point){n.z, 0, -n.x});
    *v = pov_cross(n, *u);
}

/* Maps the unit square of the pattern to a square of that side, its corner or (`around`) its centre at the origin. */
static void write_frame(struct pov *pov, struct point normal, struct point origin, double side, bool around)
{
    struct point a, b;

    tangents(normal, &a, &b);
    text_word(&pov->text, around ? "translate <-0.5, -0.5, 0>" : "");
    text_word(&pov->text, "scale %.10g matrix <%.10g, %.10g, %.10g, %.10g, %.10g, %.10g,", side, a.x, a.y, a.z, b.x,
              b.y, b.z);
    text_word(&pov->text, "%.10g, %.10g, %.10g, %.10g, %.10g, %.10g>", normal.x, normal.y, normal.z, origin.x, origin.y,
              origin.z);
}

void pov_mapping(struct pov *pov, uint32_t material, const struct tia_shape *s)
{
    if (!s)
        return;
    switch (s->kind) {
    case TIA_SPHERE:
        text_word(&pov->text, "scale <-1, 1, 1> translate <0.5, 0, 0>");
        if (!pov_closes(pov, material))
            pov_note(pov, "material %u: half of its texture is shifted on spheres here", material);
        break;
    case TIA_PLANE:
        write_frame(pov, pov_dir3(s->plane.normal), pov_place(pov, s->plane.point), 1, false);
        break;
    case TIA_DISC:
        write_frame(pov, pov_dir3(s->disc.normal), pov_place(pov, s->disc.centre), 2 * pov_length(pov, s->disc.radius),
                    true);
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
