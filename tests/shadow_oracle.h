/* shadow_oracle.h - finds the visible face of a pixel, and whether light reaches it, by testing every face in integers
 * of 128 bits. */
#ifndef TESTS_SHADOW_ORACLE_H
#define TESTS_SHADOW_ORACLE_H

#include "shadow/volume.h"

__extension__ typedef __int128 big;

#define SIZE 24 /* side of the image */

struct big3 {
    big x, y, z;
};

/* The value of a linear function of the direction at a pixel, and its steps to the right and down. */
struct at_pixel {
    big value, right, down;
};

static struct big3 vector(const struct tia_raster_vertex *v)
{
    return (struct big3){v->x, v->y, v->w};
}

static struct big3 cross(struct big3 a, struct big3 b)
{
    return (struct big3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static big dot(struct big3 a, struct big3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static int sign(big a)
{
    return (a > 0) - (a < 0);
}

static int sign_at(struct at_pixel a)
{
    return a.value ? sign(a.value) : a.right ? sign(a.right) : sign(a.down);
}

/* Evaluates n.D at pixel (i, j) of a square image, whose direction D is (2 i + 1 - SIZE, SIZE - 1 - 2 j, SIZE). */
static struct at_pixel along(struct big3 n, int i, int j)
{
    return (struct at_pixel){dot(n, (struct big3){2 * i + 1 - SIZE, SIZE - 1 - 2 * j, SIZE}), 2 * n.x, -2 * n.y};
}

/* The plane n.(x, y, w) = d h. At a pixel with the direction D its point is (D, s), with the nearness s = n.D/d,
 * whatever the projection. */
struct plane {
    struct big3 n;
    big d;
};

static struct plane through(const struct tia_raster_vertex *a, const struct tia_raster_vertex *b,
                            const struct tia_raster_vertex *c)
{
    struct big3 p = vector(a), q = vector(b), r = vector(c), u = cross(q, r), v = cross(r, p), w = cross(p, q);

    return (struct plane){{a->h * u.x + b->h * v.x + c->h * w.x, a->h * u.y + b->h * v.y + c->h * w.y,
                           a->h * u.z + b->h * v.z + c->h * w.z},
                          dot(u, p)};
}

static int side(struct plane p, const struct tia_raster_vertex *v)
{
    return sign(dot(p.n, vector(v)) - p.d * v->h);
}

/* Returns the side of plane p on which the point of plane `seen` at pixel (i, j) lies: the sign of n.D - d s, with s =
 * seen.n.D/seen.d. */
static int side_of_seen(struct plane p, struct plane seen, int i, int j)
{
    struct at_pixel a = along(p.n, i, j), b = along(seen.n, i, j);
    struct at_pixel difference = {a.value * seen.d - p.d * b.value, a.right * seen.d - p.d * b.right,
                                  a.down * seen.d - p.d * b.down};

    return sign_at(difference) * sign(seen.d);
}

struct world {
    struct tia_flat_scene flat;
    tia_flat_light light;
};

static unsigned sides_of(const struct world *w, uint32_t f)
{
    return tia_face_sides(&w->flat.faces[f]);
}

static const struct tia_raster_vertex *corner(const struct world *w, uint32_t f, unsigned k)
{
    return &w->flat.points[w->flat.faces[f].corner[k % sides_of(w, f)]];
}

static struct plane plane_of(const struct world *w, uint32_t f)
{
    return through(corner(w, f, 0), corner(w, f, 1), corner(w, f, 2));
}

static bool covers(const struct world *w, uint32_t f, int i, int j)
{
    int turn = sign(plane_of(w, f).d);

    if (w->flat.eye.projection == TIA_ORTHOGRAPHIC && along(plane_of(w, f).n, i, j).value * turn > 0)
        return false; /* the point is behind the window */
    for (unsigned k = 0; turn && k < sides_of(w, f); k++)
        if (sign_at(along(cross(vector(corner(w, f, k)), vector(corner(w, f, k + 1))), i, j)) != turn)
            return false;
    return turn != 0;
}

/* True if face f is nearer than g at a pixel that both cover. If both are in one plane, the face with the lower number
 * counts as nearer. */
static bool is_nearer(const struct world *w, uint32_t f, uint32_t g, int i, int j)
{
    int order = side_of_seen(plane_of(w, f), plane_of(w, g), i, j) * sign(plane_of(w, f).d);

    return order ? order > 0 : f < g;
}

static inline uint32_t find_seen(const struct world *w, int i, int j)
{
    uint32_t seen = TIA_NO_FACE;

    for (uint32_t f = 0; f < w->flat.face_count; f++)
        if (covers(w, f, i, j) && (seen == TIA_NO_FACE || is_nearer(w, f, seen, i, j)))
            seen = f;
    return seen;
}

/* True if face f is between the visible point and the light. */
static bool hides(const struct world *w, uint32_t f, struct plane seen, int i, int j)
{
    struct plane cap = plane_of(w, f);
    int toward = side(cap, &w->light), first = 0;

    if (!toward || side_of_seen(cap, seen, i, j) != -toward)
        return false;
    for (unsigned k = 0; k < sides_of(w, f); k++) {
        int at = side_of_seen(through(corner(w, f, k), corner(w, f, k + 1), &w->light), seen, i, j);
        if (at == 0 || (k > 0 && at != first))
            return false;
        first = at;
    }
    return true;
}

static inline bool is_lit(const struct world *w, uint32_t face, int i, int j)
{
    static const struct tia_raster_vertex eye = {0, 0, 0, 1};
    struct plane seen = plane_of(w, face);

    if (!seen.d || side(seen, &w->light) != side(seen, &eye))
        return false;
    for (uint32_t f = 0; f < w->flat.face_count; f++)
        if (f != face && hides(w, f, seen, i, j))
            return false;
    return true;
}

#endif
