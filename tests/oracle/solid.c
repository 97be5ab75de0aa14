/* solid.c - solids: members' crossings with the line of a ray, and an inside test between each two of them. */
#include "shape.h"

#include <string.h>

#define BEHIND 4096.0 /* members are nearer than this to a ray's origin, in units */

#define CHORDS 2 /* the most parts of a line inside a member */

/* A crossing of a member's surface. */
struct edge {
    struct hit hit;
    uint32_t member;
};

/* A part of a line inside a member. */
struct interval {
    struct hit enter, leave;
    bool exists;
};

/* Returns the interval behind a plane. */
static struct interval behind(const struct tia_plane *plane, struct ray ray)
{
    struct oracle_vec n = direction(plane->normal);
    double slope = dot(ray.direction, n), height = dot(sub(position(plane->point), ray.origin), n);
    struct interval i = {{.t = -INFINITY}, {.t = INFINITY}, slope != 0 || height > 0};
    struct hit *hit = slope < 0 ? &i.enter : &i.leave;

    if (slope == 0)
        return i;
    /* a ray from a point in front of the crossing meets the plane there */
    double t = height / slope;
    (void)shape_plane((struct ray){at(ray, t - 1), ray.direction}, position(plane->point), n, hit);
    hit->t = t;
    return i;
}

/* Finds the part inside a convex member by two rays, which come from both ends of the line. */
static struct interval inside_of(const struct tia_scene *scene, const struct tia_shape *member, struct ray ray)
{
    double far = BEHIND / length(ray.direction);
    struct interval i = {.exists = false};

    i.exists = shape_hit(scene, member, (struct ray){at(ray, -far), ray.direction}, &i.enter) &&
               shape_hit(scene, member, (struct ray){at(ray, far), scaled(ray.direction, -1)}, &i.leave);
    i.enter.t -= far;
    i.leave.t = far - i.leave.t;
    return i;
}

/* Finds the next hit beyond t; a shorter way than 2^-24 of a unit is not seen. */
static bool hit_beyond(const struct tia_scene *scene, const struct tia_shape *member, struct ray ray, double t,
                       struct hit *hit)
{
    t += ldexp(1, -24) / length(ray.direction);
    bool found = shape_hit(scene, member, (struct ray){at(ray, t), ray.direction}, hit);
    hit->t += t;
    return found;
}

/* Finds all parts of a line inside a member. */
static void find_parts(const struct tia_scene *scene, const struct tia_shape *member, struct ray ray,
                       struct interval parts[CHORDS])
{
    double t = -BEHIND / length(ray.direction);

    parts[0] = parts[1] = (struct interval){.exists = false};
    if (member->kind == TIA_PLANE)
        parts[0] = behind(&member->plane, ray);
    else if (member->kind != TIA_TORUS)
        parts[0] = inside_of(scene, member, ray);
    for (int k = 0; k < CHORDS && member->kind == TIA_TORUS; k++) {
        struct interval *part = &parts[k];
        part->exists = hit_beyond(scene, member, ray, t, &part->enter) &&
                       hit_beyond(scene, member, ray, part->enter.t, &part->leave);
        if (!part->exists)
            break;
        t = part->leave.t;
    }
}

/* Evaluates the solid's expression. */
static bool holds(const struct tia_solid *solid, const bool *inside)
{
    bool stack[TIA_SOLID_DEPTH];
    int depth = 0;

    for (uint32_t i = 0; i < solid->step_count; i++) {
        if (solid->steps[i] == TIA_SOLID_MEMBER) {
            stack[depth++] = *inside++;
            continue;
        }
        bool b = stack[--depth], a = stack[depth - 1];
        stack[depth - 1] = solid->steps[i] == TIA_SOLID_UNION          ? a || b
                           : solid->steps[i] == TIA_SOLID_INTERSECTION ? a && b
                                                                       : a && !b;
    }
    return stack[0];
}

/* Sets the members that the point at t is inside of. */
static void find_inside(const struct tia_solid *solid, struct interval (*of)[CHORDS], double t, bool *inside)
{
    for (uint32_t i = 0; i < solid->member_count; i++) {
        inside[i] = false;
        for (int k = 0; k < CHORDS; k++)
            inside[i] = inside[i] || (of[i][k].exists && of[i][k].enter.t < t && t < of[i][k].leave.t);
    }
}

/* Collects the crossings at t >= 0 in order; returns their number. */
static unsigned sort(const struct tia_solid *solid, struct interval (*of)[CHORDS], struct edge *edges)
{
    unsigned count = 0;

    for (uint32_t i = 0; i < solid->member_count; i++)
        for (int k = 0; k < 2 * CHORDS && of[i][k / 2].exists; k++) {
            struct edge edge = {k % 2 ? of[i][k / 2].leave : of[i][k / 2].enter, i};
            unsigned at = count;
            if (!(edge.hit.t >= 0 && edge.hit.t < INFINITY))
                continue;
            for (; at > 0 && edges[at - 1].hit.t > edge.hit.t; at--)
                edges[at] = edges[at - 1];
            edges[at] = edge;
            count++;
        }
    return count;
}

/* Returns the first of the `count` crossings by which alone the expression changes; if there is none, the first of
 * those whose member is inside on one side only. First are members with low numbers. */
static const struct edge *choose(const struct tia_solid *solid, const struct edge *edges, unsigned count,
                                 const bool *before, const bool *after)
{
    const struct edge *first = NULL;

    for (uint32_t i = solid->member_count; i-- > 0;)
        for (unsigned k = 0; k < count && before[i] != after[i]; k++)
            first = edges[k].member == i ? &edges[k] : first;
    for (uint32_t i = 0; i < solid->member_count; i++) {
        bool alone[TIA_SOLID_MEMBERS];
        memcpy(alone, before, sizeof alone);
        alone[i] = !alone[i];
        for (unsigned k = 0; k < count && before[i] != after[i]; k++)
            if (edges[k].member == i && holds(solid, alone) != holds(solid, before))
                return &edges[k];
    }
    return first;
}

static void set_hit(const struct tia_scene *scene, const struct tia_solid *solid, const struct edge *edge, bool enters,
                    bool is_in, struct hit *hit)
{
    const struct tia_shape *member = &solid->members[edge->member];
    bool turned = enters != is_in;

    *hit = edge->hit;
    hit->material = member->material;
    hit->part = 64 * hit->part + (turned ? 32 : 0) + edge->member;
    hit->normal = scaled(hit->normal, turned ? -1 : 1);
    hit->smooth = hit->normal;
    if (member->kind == TIA_PLANE) {
        hit->u = ldexp(hit->u, -(int)scene->scale_bits);
        hit->v = ldexp(hit->v, -(int)scene->scale_bits);
    }
}

bool shape_solid(const struct tia_scene *scene, const struct tia_solid *solid, struct ray ray, struct hit *hit)
{
    struct interval of[TIA_SOLID_MEMBERS][CHORDS];
    struct edge edges[2 * CHORDS * TIA_SOLID_MEMBERS];
    bool before[TIA_SOLID_MEMBERS], after[TIA_SOLID_MEMBERS];
    double near = ldexp(1, -16) / length(ray.direction);

    for (uint32_t i = 0; i < solid->member_count; i++)
        find_parts(scene, &solid->members[i], ray, of[i]);
    unsigned count = sort(solid, of, edges), next;
    find_inside(solid, of, count && edges[0].hit.t == 0 ? -ldexp(1, -40) : 0, before);
    for (unsigned i = 0; i < count; i = next) {
        for (next = i; next < count && edges[next].hit.t <= edges[i].hit.t + near;)
            next++;
        double last = edges[next - 1].hit.t;
        find_inside(solid, of, next < count ? (last + edges[next].hit.t) / 2 : last + 1, after);
        bool is_in = holds(solid, after);
        if (is_in != holds(solid, before)) {
            const struct edge *edge = choose(solid, &edges[i], next - i, before, after);
            set_hit(scene, solid, edge, after[edge->member], is_in, hit);
            return true;
        }
        memcpy(before, after, sizeof before);
    }
    return false;
}
