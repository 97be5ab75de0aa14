/* shapes.c - each shape, and the mapping of textures onto it. */
#include "pov.h"

#include <math.h>

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

static void write_box(struct pov *pov, const struct tia_box *box)
{
    pov_triple(pov, "box {", pov_place(pov, box->min));
    pov_triple(pov, ",", pov_place(pov, box->max));
}

void pov_solid_geometry(struct pov *pov, const struct tia_shape *s)
{
    if (s->kind == TIA_BOX)
        write_box(pov, &s->box);
    else
        pov_geometry(pov, s);
}

/* Computes the tangents of a unit normal, as in tia/shape.h. */
static void tangents(struct point n, struct point *u, struct point *v)
{
    *u = n.x == 0 && n.z == 0 ? (struct point){1, 0, 0} : pov_unit((struct point){n.z, 0, -n.x});
    *v = pov_cross(n, *u);
}

/* Writes a torus, which POV-Ray has around the y axis: x, y, z become the tangent U, the axis and -V. */
static void write_torus(struct pov *pov, const struct tia_torus *t)
{
    struct point n = pov_dir3(t->axis), at = pov_place(pov, t->centre), u, v;

    tangents(n, &u, &v);
    text_word(&pov->text, "torus { %.10g, %.10g sturm", pov_length(pov, t->major), pov_length(pov, t->minor));
    text_word(&pov->text, "matrix <%.10g, %.10g, %.10g, %.10g, %.10g, %.10g, %.10g, %.10g, %.10g,", u.x, u.y, u.z, n.x,
              n.y, n.z, -v.x, -v.y, -v.z);
    text_word(&pov->text, "%.10g, %.10g, %.10g>", at.x, at.y, at.z);
}

/* Returns the place with the coordinates of `high` where the bits of `which` are set, else those of `low`. */
static struct tia_vec3 chosen(struct tia_vec3 low, struct tia_vec3 high, unsigned which)
{
    return (struct tia_vec3){which & 1 ? high.x : low.x, which & 2 ? high.y : low.y, which & 4 ? high.z : low.z};
}

/* Writes the balls and cylinders of a rounded box, and the boxes between its faces, as one shape without inner
 * surfaces. `low` and `high` are the inner box. */
static void write_rounded(struct pov *pov, const struct tia_rounded *b)
{
    tia_q16 r = b->radius;
    struct tia_vec3 low = {b->min.x + r, b->min.y + r, b->min.z + r}, high = {b->max.x - r, b->max.y - r, b->max.z - r};

    /* Of corners that coincide one is written: POV-Ray loses points of surfaces that do. */
    unsigned flat = (low.x == high.x ? 1u : 0u) | (low.y == high.y ? 2u : 0u) | (low.z == high.z ? 4u : 0u);

    text_print(&pov->text, "merge {\n");
    for (unsigned i = 0; i < 8; i++) {
        if (i & flat)
            continue;
        write_ball(pov, chosen(low, high, i), r);
        text_print(&pov->text, " }\n");
        for (unsigned axis = 1; axis < 8; axis *= 2) {
            struct tia_vec3 from = chosen(low, high, i), to = chosen(low, high, i | axis);
            if ((i | flat) & axis)
                continue;
            write_tapered(pov, "cylinder {", from, to, pov_length(pov, r), NULL);
            text_print(&pov->text, " }\n");
        }
    }
    for (unsigned axis = 1; axis < 8; axis *= 2) {
        struct tia_vec3 min = chosen(low, b->min, axis), max = chosen(high, b->max, axis);
        if (min.x == max.x || min.y == max.y || min.z == max.z)
            continue;
        pov_triple(pov, "box {", pov_place(pov, min));
        pov_triple(pov, ",", pov_place(pov, max));
        text_print(&pov->text, " }\n");
    }
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
        if (pov_textured(pov, s->material))
            pov_box(pov, s->box.min, s->box.max);
        else
            write_box(pov, &s->box);
        break;
    case TIA_TRIANGLE:
        pov_triangle(pov, &s->triangle);
        break;
    case TIA_MESH:
        pov_mesh(pov, &pov->scene->meshes[s->mesh]);
        break;
    case TIA_TORUS:
        write_torus(pov, &s->torus);
        break;
    case TIA_ROUNDED:
        write_rounded(pov, &s->rounded);
        break;
    case TIA_GRID: /* grids are written by objects.c, cell by cell; solids by solids.c */
    case TIA_SOLID:
        break;
    }
}

bool pov_closed(const struct tia_scene *scene, const struct tia_shape *s)
{
    return s->kind == TIA_SPHERE || s->kind == TIA_BOX || s->kind == TIA_GRID || s->kind == TIA_TORUS ||
           s->kind == TIA_ROUNDED || (s->kind == TIA_MESH && !scene->meshes[s->mesh].groups) ||
           (s->kind == TIA_CYLINDER && s->cylinder.capped) || (s->kind == TIA_CONE && s->cone.capped);
}

bool pov_plain(const struct tia_shape *s)
{
    return s && (s->kind == TIA_PLANE || s->kind == TIA_DISC || s->kind == TIA_CYLINDER || s->kind == TIA_CONE);
}

/* Maps the unit square of the pattern to a square with the given side in the plane with the given normal. Its corner is
 * at `origin`; with `around`, its centre. */
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

/* Wraps the unit square of the pattern around an axis. POV-Ray's cylindrical warp runs around y from x to z. It sets z
 * to the distance from the y axis. Checkers are cubes, so z is scaled to make the pattern independent of it. */
static void write_around(struct pov *pov, struct tia_vec3 base, struct tia_vec3 top)
{
    struct point from = pov_place(pov, base), axis = pov_sum(pov_place(pov, top), pov_scaled(from, -1)), a, b;
    struct point n = pov_unit(axis);

    tangents(n, &a, &b);
    text_word(&pov->text,
              "scale <-1, 1, 1000000> translate <0.5, 0, 0> warp { cylindrical } matrix <%.10g, %.10g, %.10g,", a.x,
              a.y, a.z);
    text_word(&pov->text, "%.10g, %.10g, %.10g, %.10g, %.10g, %.10g,", axis.x, axis.y, axis.z, -b.x, -b.y, -b.z);
    text_word(&pov->text, "%.10g, %.10g, %.10g>", from.x, from.y, from.z);
}

/* Wraps the unit square of the pattern around a torus: POV-Ray's warp runs around y from x to z, and around the tube
 * from the outer equator upwards, as far as it is of use here. */
static void write_ring(struct pov *pov, const struct tia_torus *t)
{
    struct point n = pov_dir3(t->axis), at = pov_place(pov, t->centre), a, b;

    tangents(n, &a, &b);
    text_word(&pov->text, "scale <-1, 1, 1000000> translate <0.5, 0.5, 0> warp { toroidal major_radius %.10g }",
              pov_length(pov, t->major));
    text_word(&pov->text, "matrix <%.10g, %.10g, %.10g, %.10g, %.10g, %.10g,", a.x, a.y, a.z, n.x, n.y, n.z);
    text_word(&pov->text, "%.10g, %.10g, %.10g, %.10g, %.10g, %.10g>", -b.x, -b.y, -b.z, at.x, at.y, at.z);
}

static void note_seam(struct pov *pov, uint32_t material)
{
    if (!pov_closes(pov, material))
        pov_note(pov, "material %u: half of its texture is shifted on spheres, cylinders and cones here", material);
}

static struct tia_shape cap(const struct tia_shape *s, struct tia_vec3 centre, struct tia_vec3 other, tia_q16 radius)
{
    struct point n = pov_unit(pov_sum(pov_vec3(centre), pov_scaled(pov_vec3(other), -1)));
    struct tia_dir3 normal = {(tia_q30)lround(n.x * TIA_Q30_ONE), (tia_q30)lround(n.y * TIA_Q30_ONE),
                              (tia_q30)lround(n.z * TIA_Q30_ONE)};

    return (struct tia_shape){.kind = TIA_DISC, .material = s->material, .disc = {centre, normal, radius}};
}

unsigned pov_parts(const struct pov *pov, const struct tia_shape *s, struct tia_shape parts[3])
{
    unsigned count = 0;

    if (!pov_textured(pov, s->material))
        return 0;
    parts[0] = *s;
    if (s->kind == TIA_CYLINDER && s->cylinder.capped) {
        parts[0].cylinder.capped = false;
        parts[1] = cap(s, s->cylinder.base, s->cylinder.top, s->cylinder.radius);
        parts[2] = cap(s, s->cylinder.top, s->cylinder.base, s->cylinder.radius);
        return 3;
    }
    if (s->kind != TIA_CONE || !s->cone.capped)
        return 0;
    parts[count++].cone.capped = false;
    if (s->cone.base_radius > 0)
        parts[count++] = cap(s, s->cone.base, s->cone.top, s->cone.base_radius);
    if (s->cone.top_radius > 0)
        parts[count++] = cap(s, s->cone.top, s->cone.base, s->cone.top_radius);
    return count;
}

void pov_mapping(struct pov *pov, uint32_t material, const struct tia_shape *s)
{
    if (!s)
        return;
    switch (s->kind) {
    case TIA_SPHERE:
        text_word(&pov->text, "scale <-1, 1, 1> translate <0.5, 0, 0>");
        note_seam(pov, material);
        break;
    case TIA_PLANE:
        write_frame(pov, pov_dir3(s->plane.normal), pov_place(pov, s->plane.point), 1, false);
        break;
    case TIA_DISC:
        write_frame(pov, pov_dir3(s->disc.normal), pov_place(pov, s->disc.centre), 2 * pov_length(pov, s->disc.radius),
                    true);
        break;
    case TIA_CYLINDER:
        write_around(pov, s->cylinder.base, s->cylinder.top);
        note_seam(pov, material);
        break;
    case TIA_CONE:
        write_around(pov, s->cone.base, s->cone.top);
        note_seam(pov, material);
        break;
    case TIA_TORUS:
        write_ring(pov, &s->torus);
        note_seam(pov, material);
        break;
    case TIA_ROUNDED:
        if (pov_textured(pov, material))
            pov_note(pov, "material %u: its texture lies on rounded boxes as a solid one here", material);
        break;
    case TIA_BOX:
    case TIA_TRIANGLE:
    case TIA_MESH:
    case TIA_GRID:
    case TIA_SOLID:
        break; /* meshes have tia's coordinates */
    }
}
