#include "nff.h"

#include <stdlib.h>
#include <string.h>

struct reading {
    const char *at;
    struct nff *nff;
    unsigned body; /* body of the polygons since the last f; 0: none yet */
    bool bad;
};

/* Makes room for one more item; arrays double when they are full. */
static void *grow(void *items, unsigned count, size_t size)
{
    return count & (count - 1) ? items : realloc(items, (count ? 2 * count : 1) * size);
}

static double number(struct reading *r)
{
    char *end;
    double x = strtod(r->at, &end);

    r->bad = r->bad || end == r->at;
    r->at = end;
    return x;
}

static struct oracle_vec vector(struct reading *r)
{
    double x = number(r), y = number(r), z = number(r);

    return (struct oracle_vec){x, y, z};
}

static bool has_number(const struct reading *r)
{
    const char *p = r->at + strspn(r->at, " \t");

    return *p && strchr("+-.0123456789", *p);
}

static void colour(struct reading *r, double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = number(r);
}

static struct nff_material *new_material(struct nff *nff)
{
    nff->materials = grow(nff->materials, nff->material_count, sizeof *nff->materials);
    return &nff->materials[nff->material_count++];
}

static void read_f(struct reading *r)
{
    struct nff_material *m = new_material(r->nff);

    colour(r, m->colour);
    double kd = number(r);
    for (int i = 0; i < 3; i++)
        m->colour[i] *= kd;
    m->ks = number(r);
    m->shine = number(r);
    m->t = number(r);
    m->index = number(r);
    m->shines = m->ks > 0 && m->shine > 0;
    m->shine = fmin(fmax(m->shine, 1), 10000);
    m->index = m->t > 0 && m->index > 0 ? m->index : 1;
    r->body = 0;
}

static void read_l(struct reading *r)
{
    struct nff *nff = r->nff;

    nff->lights = grow(nff->lights, nff->light_count, sizeof *nff->lights);
    struct nff_light *l = &nff->lights[nff->light_count++];
    l->at = vector(r);
    l->coloured = has_number(r);
    if (l->coloured)
        colour(r, l->emission);
}

static unsigned new_body(struct nff *nff, bool closed)
{
    nff->closed = grow(nff->closed, nff->body_count, sizeof *nff->closed);
    nff->closed[nff->body_count] = closed;
    return nff->body_count++;
}

static struct nff_thing *new_thing(struct reading *r, enum nff_kind kind)
{
    struct nff *nff = r->nff;

    if (!nff->material_count)
        *new_material(nff) = (struct nff_material){.colour = {1, 1, 1}, .index = 1};
    nff->things = grow(nff->things, nff->thing_count, sizeof *nff->things);
    struct nff_thing *t = &nff->things[nff->thing_count++];
    *t = (struct nff_thing){.kind = kind,
                            .material = nff->material_count - 1,
                            .min = {INFINITY, INFINITY, INFINITY},
                            .max = {-INFINITY, -INFINITY, -INFINITY}};
    return t;
}

/* Extends the object's box to enclose a ball. */
static void cover(struct nff_thing *t, struct oracle_vec p, double r)
{
    t->min = (struct oracle_vec){fmin(t->min.x, p.x - r), fmin(t->min.y, p.y - r), fmin(t->min.z, p.z - r)};
    t->max = (struct oracle_vec){fmax(t->max.x, p.x + r), fmax(t->max.y, p.y + r), fmax(t->max.z, p.z + r)};
}

static void read_round(struct reading *r, bool cone)
{
    struct nff_thing *t = new_thing(r, cone ? NFF_CONE : NFF_SPHERE);

    for (int i = 0; i <= cone; i++) {
        t->point[i] = vector(r);
        t->radius[i] = fabs(number(r));
        cover(t, t->point[i], t->radius[i]);
    }
    t->body = new_body(r->nff, !cone);
}

/* Returns Newell's normal: the sum of the cross products of a fan of triangles. */
static struct oracle_vec normal_of(const struct oracle_vec *corner, unsigned count)
{
    struct oracle_vec n = {0, 0, 0};

    for (unsigned i = 2; i < count; i++)
        n = along(n, 1, cross(sub(corner[i - 1], corner[0]), sub(corner[i], corner[0])));
    return unit(n);
}

static void read_polygon(struct reading *r, bool patch)
{
    struct nff_thing *t = new_thing(r, NFF_POLYGON);
    double count = number(r);
    unsigned n = count >= 3 && count <= 4096 ? (unsigned)count : 3;
    struct oracle_vec *corner = calloc(2 * (size_t)n, sizeof *corner), *normals = corner + n;

    for (unsigned i = 0; i < n; i++) {
        corner[i] = vector(r);
        normals[i] = patch ? vector(r) : corner[i];
        if (patch)
            normals[i] = unit(normals[i]);
        cover(t, corner[i], 0);
    }
    r->bad = r->bad || (patch && n > 3);
    t->corner = corner;
    t->normals = patch ? normals : NULL;
    t->count = n;
    t->normal = normal_of(corner, n);
    if (!r->body)
        r->body = new_body(r->nff, true) + 1;
    t->body = r->body - 1;
}

static void skip_line(struct reading *r)
{
    r->at += strcspn(r->at, "\n");
}

static void read_statement(struct reading *r, const char *word, size_t length)
{
#define IS(string) (length == sizeof(string) - 1 && !memcmp(word, string, length))
    if (IS("from"))
        r->nff->eye = vector(r);
    else if (IS("at"))
        r->nff->look = vector(r);
    else if (IS("up"))
        r->nff->up = vector(r);
    else if (IS("angle"))
        r->nff->angle = number(r) * PI / 180;
    else if (IS("b"))
        colour(r, r->nff->background);
    else if (IS("l"))
        read_l(r);
    else if (IS("f"))
        read_f(r);
    else if (IS("s") || IS("c"))
        read_round(r, IS("c"));
    else if (IS("p") || IS("pp"))
        read_polygon(r, IS("pp"));
    else if (IS("v") || IS("hither") || IS("resolution") || *word == '#')
        skip_line(r);
    else
        r->bad = true;
#undef IS
}

static bool is_same(struct oracle_vec a, struct oracle_vec b)
{
    return !(length(sub(a, b)) > 0);
}

/* True if any polygon of the body has the edge from a to b. */
static bool has_edge(const struct nff *nff, unsigned body, struct oracle_vec a, struct oracle_vec b)
{
    for (unsigned i = 0; i < nff->thing_count; i++) {
        const struct nff_thing *t = &nff->things[i];
        for (unsigned k = 0; t->body == body && k < t->count; k++)
            if (is_same(t->corner[k], a) && is_same(t->corner[(k + 1) % t->count], b))
                return true;
    }
    return false;
}

/* Finds the closed bodies: a body of transparent polygons is closed if each edge has a counterpart in the opposite
 * direction. */
static void find_closed(struct nff *nff)
{
    for (unsigned i = 0; i < nff->thing_count; i++) {
        const struct nff_thing *t = &nff->things[i];
        for (unsigned k = 0; k < t->count && nff->materials[t->material].t > 0 && nff->closed[t->body]; k++)
            nff->closed[t->body] = has_edge(nff, t->body, t->corner[(k + 1) % t->count], t->corner[k]);
    }
}

static void finish(struct nff *nff)
{
    struct nff_thing all = {.min = nff->eye, .max = nff->eye};

    for (unsigned i = 0; i < nff->light_count; i++)
        for (int k = 0; k < 3 && !nff->lights[i].coloured; k++)
            nff->lights[i].emission[k] = 1 / sqrt(nff->light_count);
    for (unsigned i = 0; i < nff->thing_count; i++) {
        cover(&all, nff->things[i].min, 0);
        cover(&all, nff->things[i].max, 0);
    }
    nff->extent = length(sub(all.max, all.min));
    find_closed(nff);
    nff_plant(nff);
}

struct nff *nff_read(const char *text)
{
    struct reading r = {text, calloc(1, sizeof *r.nff), 0, false};

    while (!r.bad && *(r.at += strspn(r.at, " \t\r\n"))) {
        size_t length = strcspn(r.at, " \t\r\n");
        r.at += length;
        read_statement(&r, r.at - length, length);
    }
    if (!r.bad)
        finish(r.nff);
    if (!r.bad)
        return r.nff;
    nff_free(r.nff);
    return NULL;
}

void nff_free(struct nff *nff)
{
    for (unsigned i = 0; i < nff->thing_count; i++)
        free((void *)(uintptr_t)nff->things[i].corner);
    free(nff->materials);
    free(nff->lights);
    free(nff->things);
    free(nff->trees);
    free(nff->closed);
    free(nff);
}
