/* nff_draw.c - computes Whitted's colours of an .nff file by the formulas of tia/material.h. */
#include "nff.h"
#include "oracle.h"

#define OFF 1e-12
#define FAINT (1.0 / 65536.0)

/* History of a ray: its weight; the numbers of bends and of straight layers so far; and the bodies that it has entered,
 * with their indices of refraction. */
struct journey {
    double weight;
    unsigned bounces, layers;
    unsigned count, body[TIA_MEDIA_MAX]; /* entered bodies, the last one at the end */
    double index[TIA_MEDIA_MAX];
};

struct place {
    const struct nff_material *material;
    struct oracle_vec p, g, n, v; /* the point, the normals and the direction to the viewer */
    double cosine;                /* n.v */
    unsigned body;
    bool front;
};

static void trace(const struct nff *nff, struct ray ray, const struct journey *journey, double sum[3]);

static void add_light(const struct nff *nff, const struct nff_light *l, const struct place *s, double sum[3])
{
    struct oracle_vec from = along(s->p, OFF * nff->extent, s->g), to = unit(sub(l->at, s->p));
    double cosine = dot(s->n, to), glare = 0;

    if (!(dot(s->g, to) > 0) || !(cosine > 0))
        return;
    double left = nff_transmission(nff, (struct ray){from, sub(l->at, from)});
    double mirrored = dot(along(scaled(s->v, -1), 2 * s->cosine, s->n), to);
    if (s->material->shines && mirrored > 0)
        glare = s->material->ks * pow(mirrored, s->material->shine);
    for (int i = 0; i < 3; i++)
        sum[i] += left * l->emission[i] * (s->material->colour[i] * cosine + glare);
}

static void add_ray(const struct nff *nff, struct ray ray, double factor, struct journey journey, double sum[3])
{
    double seen[3] = {0, 0, 0};

    journey.weight *= factor;
    if (journey.bounces > TIA_DEPTH_DEFAULT || journey.layers > TIA_LAYERS_MAX || journey.weight < FAINT)
        return;
    trace(nff, ray, &journey, seen);
    for (int i = 0; i < 3; i++)
        sum[i] += factor * seen[i];
}

static double medium(const struct journey *j)
{
    return j->count ? j->index[j->count - 1] : 1;
}

/* Computes the indices of refraction in front of the surface and behind it. The ray crosses the surface, so the bodies
 * of its journey are updated. */
static void cross_over(const struct nff *nff, const struct place *s, struct journey *j, double *from, double *to)
{
    int at = -1;

    for (unsigned i = 0; i < j->count; i++)
        at = j->body[i] == s->body ? (int)i : at;
    *from = medium(j);
    *to = s->material->index;
    if (s->front) {
        if (nff->closed[s->body] && j->count < TIA_MEDIA_MAX) {
            j->body[j->count] = s->body;
            j->index[j->count++] = *to;
        }
        return;
    }
    if (at < 0) {
        *to = *from;
        *from = s->material->index;
        return;
    }
    bool last = (unsigned)at + 1 == j->count;
    j->count--;
    for (unsigned i = (unsigned)at; i < j->count; i++) {
        j->body[i] = j->body[i + 1];
        j->index[i] = j->index[i + 1];
    }
    *to = medium(j);
    *from = last ? s->material->index : *to;
}

static void add_secondary(const struct nff *nff, const struct place *s, const struct journey *journey, double sum[3])
{
    struct journey mirrored = *journey, bent = *journey;
    struct oracle_vec back = along(scaled(s->v, -1), 2 * s->cosine, s->n);
    double kr = s->material->ks, kt = s->material->t, from, to, off = OFF * nff->extent;
    struct ray on = {along(s->p, -off, s->g), scaled(s->v, -1)};

    mirrored.bounces++;
    if (kt > 0) {
        cross_over(nff, s, &bent, &from, &to);
        double ratio = from / to, square = 1 - ratio * ratio * (1 - s->cosine * s->cosine);
        if (from == to) {
            bent.layers++;
        } else {
            bent.bounces++;
            if (s->cosine <= 0 || square < 0) {
                kr += kt;
                kt = 0;
            } else {
                on.direction = along(scaled(s->v, -ratio), ratio * s->cosine - sqrt(square), s->n);
            }
        }
    }
    add_ray(nff, (struct ray){along(s->p, off, s->g), back}, kr, mirrored, sum);
    add_ray(nff, on, kt, bent, sum);
}

static void trace(const struct nff *nff, struct ray ray, const struct journey *journey, double sum[3])
{
    struct hit hit;
    unsigned thing;

    ray.direction = unit(ray.direction);
    thing = nff_nearest(nff, ray, &hit);
    for (int i = 0; i < 3 && thing == nff->thing_count; i++)
        sum[i] += nff->background[i];
    if (thing == nff->thing_count)
        return;
    struct place s = {.material = &nff->materials[nff->things[thing].material],
                      .p = at(ray, hit.t),
                      .v = scaled(ray.direction, -1),
                      .body = nff->things[thing].body};
    s.front = dot(hit.normal, s.v) >= 0;
    s.g = scaled(hit.normal, s.front ? 1 : -1);
    s.n = scaled(hit.smooth, s.front ? 1 : -1);
    s.cosine = dot(s.n, s.v);
    for (unsigned i = 0; i < nff->light_count; i++)
        add_light(nff, &nff->lights[i], &s, sum);
    add_secondary(nff, &s, journey, sum);
}

tia_rgb565 nff_pixel(const struct nff *nff, unsigned width, unsigned height, unsigned x, unsigned y)
{
    struct oracle_vec n = unit(sub(nff->eye, nff->look)), u = unit(cross(nff->up, n)), v = cross(n, u);
    double a = tan(nff->angle / 2), right = (2 * (x + 0.5) / width - 1) * a * width / height;
    double up = (1 - 2 * (y + 0.5) / height) * a;
    struct ray ray = {nff->eye, along(along(scaled(u, right), up, v), -1, n)};
    struct journey journey = {.weight = 1};
    struct oracle_pixel pixel = {0};

    trace(nff, ray, &journey, pixel.linear);
    return oracle_pack(&pixel, x, y, false);
}
