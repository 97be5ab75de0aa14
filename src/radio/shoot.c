/* shoot.c - shooting and bouncing rays. Rays only find the sequences of planes that paths may use, so rounded numbers
 * are enough: positions in Q16.16, directions in Q2.62. */
#include "near.h"
#include "search.h"

#define FAR (INT64_C(1) << 33) /* a distance beyond any scene, Q16.16 */
#define COVER INT64_C(50066)   /* 0.76394 in units of 2^-16, rounded up: see tia_radio_shoot */
#define LENGTH_SHIFT (TIA_RADIO_LENGTH_BITS - 16)

/* A ray's hit. */
struct hit {
    int64_t t; /* distance along the ray, Q16.16 */
    uint32_t face;
    int64_t at[3];
};

struct shot {
    struct tia_radio_room *room;
    uint32_t density;
    bool everywhere;
    bool (*received)(void *ctx, const struct tia_radio_ray *ray);
    void *ctx;
};

static void go(const struct search_ray *ray, int64_t t, int64_t at[3])
{
    const int64_t *d = ray->result.path.direction[ray->result.path.order];

    for (int k = 0; k < 3; k++)
        at[k] = ray->at[k] + wide_round(wide_product(t, d[k]), 62);
}

/* ---- intersections ---- */

static bool in_polygon(const struct tia_radio *radio, const struct radio_face *face, const int64_t at[3])
{
    const uint8_t *across = radio->planes[face->plane].across;
    int u = across[0], v = across[1];
    bool left = false, right = false;

    for (unsigned i = 0; i < face->count; i++) {
        const struct tia_vec3 *a = &radio->corners[face->corner[i]];
        const struct tia_vec3 *b = &radio->corners[face->corner[(i + 1) % face->count]];
        int side =
            wide_sign(wide_difference(wide_product(radio_axis(b, u) - radio_axis(a, u), at[v] - radio_axis(a, v)),
                                      wide_product(radio_axis(b, v) - radio_axis(a, v), at[u] - radio_axis(a, u))));
        left |= side > 0;
        right |= side < 0;
    }
    return !(left && right);
}

static bool on_disc(const struct tia_radio *radio, const struct radio_face *face, const int64_t at[3])
{
    int64_t v[3];

    for (int k = 0; k < 3; k++)
        v[k] = at[k] - radio_axis(&radio->corners[face->corner[0]], k);
    return !wide_is_negative(wide_difference(wide_product(face->radius, face->radius), wide_dot(v, v)));
}

/* True if a ray meets a face. If so, writes the hit. The distance is n.(corner - at) / n.d. The two products have 78
 * and 124 fractional bits, and are rounded to 32 and 60; their quotient times 2^44 has 16. */
static bool meets(const struct tia_radio *radio, const struct search_ray *ray, uint32_t number, struct hit *hit)
{
    const struct radio_face *face = &radio->faces[number];
    const int64_t *d = ray->result.path.direction[ray->result.path.order];
    int64_t n[3], to[3];

    if (face->plane == ray->last)
        return false;
    (void)wide_normalise(radio->planes[face->plane].n, n);
    for (int k = 0; k < 3; k++)
        to[k] = radio_axis(&radio->corners[face->corner[0]], k) - ray->at[k];
    int64_t along = wide_round(wide_dot(n, d), 64);
    if (along == 0 || (face->solid && (along > 0) != face->turned))
        return false;
    hit->t = wide_quotient(wide_round(wide_dot(n, to), 46), along, 44);
    hit->face = number;
    if (hit->t <= 0 || hit->t >= FAR)
        return false;
    go(ray, hit->t, hit->at);
    return face->kind == RADIO_POLYGON ? in_polygon(radio, face, hit->at)
           : face->kind == RADIO_DISC  ? on_disc(radio, face, hit->at)
                                       : true;
}

/* Tests a face, and updates the nearest hit. Of equally near hits, the one with the lowest face number counts. */
static void meet_face(const struct tia_radio *radio, const struct search_ray *ray, uint32_t face, struct hit *nearest)
{
    struct hit hit;

    if (meets(radio, ray, face, &hit) && (hit.t < nearest->t || (hit.t == nearest->t && hit.face < nearest->face)))
        *nearest = hit;
}

static struct hit nearest_of(const struct tia_radio *radio, const struct search_ray *ray)
{
    struct hit nearest = {.t = FAR, .face = TIA_NO_INDEX};
    uint32_t stack[TIA_BVH_DEPTH_MAX + 2], count = 0;
    struct near near;

    for (uint32_t i = 0; i < radio->endless_count; i++)
        meet_face(radio, ray, radio->endless[i], &nearest);
    if (nearest.face == TIA_NO_INDEX)
        go(ray, FAR, nearest.at);
    near_begin(&near, ray->at, nearest.at);
    if (radio->tree.node_count > 0)
        stack[count++] = 0;
    while (count > 0) {
        uint32_t at = stack[--count];
        const struct tia_bvh_node *node = &radio->tree.nodes[at];
        if (!near_box(&near, &node->bounds))
            continue;
        int64_t before = nearest.t;
        for (uint32_t i = 0; i < node->count; i++)
            meet_face(radio, ray, radio->tree.items[node->index + i], &nearest);
        if (nearest.t < before)
            near_begin(&near, ray->at, nearest.at);
        if (node->count == 0) {
            stack[count++] = at + 1;
            stack[count++] = node->index;
        }
    }
    return nearest;
}

/* ---- receivers ---- */

static bool receive(const struct shot *shot, struct search_ray *ray, int64_t t)
{
    const struct tia_vec3 *receiver = &shot->room->link->to;
    const int64_t *d = ray->result.path.direction[ray->result.path.order];
    int64_t to[3], at[3];

    for (int k = 0; k < 3; k++)
        to[k] = radio_axis(receiver, k) - ray->at[k];
    int64_t along = wide_round(wide_dot(to, d), 62);
    along = along < 0 ? 0 : along > t ? t : along;
    go(ray, along, at);
    for (int k = 0; k < 3; k++)
        to[k] = radio_axis(receiver, k) - at[k];
    int64_t way = ray->way + along, radius = (way * COVER >> 16) / shot->density + 1;
    wide miss = wide_dot(to, to);
    if (wide_is_negative(wide_difference(wide_product(radius, radius), miss)))
        return true;
    ray->result.path.length = way << LENGTH_SHIFT;
    ray->result.miss = wide_high(miss) != 0 || wide_low(miss) >> 63 != 0 ? INT64_MAX : (int64_t)wide_low(miss);
    return shot->received(shot->ctx, &ray->result);
}

/* ---- reflection ---- */

static struct tia_vec3 place_of(const int64_t at[3])
{
    return (struct tia_vec3){(tia_q16)at[0], (tia_q16)at[1], (tia_q16)at[2]};
}

static void move(struct search_ray *ray, const struct tia_radio *radio, const struct hit *hit)
{
    for (int k = 0; k < 3; k++)
        ray->at[k] = hit->at[k];
    ray->way += hit->t;
    ray->last = radio->faces[hit->face].plane;
}

/* Reflects the ray's direction d: d - 2 (n.d) n, halved and then normalised; n.d is Q.61. */
static void reflect(struct search_ray *ray, const struct tia_radio *radio, const struct hit *hit)
{
    struct tia_radio_path *path = &ray->result.path;
    const int64_t *d = path->direction[path->order];
    int64_t n[3], v[3];

    (void)wide_normalise(radio->planes[radio->faces[hit->face].plane].n, n);
    int64_t along = wide_round(wide_dot(n, d), 63);
    for (int k = 0; k < 3; k++)
        v[k] = (d[k] >> 1) - wide_round(wide_product(along, n[k]), 61);
    ray->result.plane[path->order] = radio->faces[hit->face].plane;
    path->face[path->order] = hit->face;
    path->point[path->order] = place_of(hit->at);
    path->order++;
    (void)wide_normalise(v, path->direction[path->order]);
}

static void pass(struct search_ray *ray, const struct hit *hit)
{
    struct tia_radio_path *path = &ray->result.path;

    path->wall[path->wall_count++] = (struct tia_radio_wall){hit->face, path->order};
}

static bool is_in_range(const struct hit *hit)
{
    for (int k = 0; k < 3; k++)
        if (hit->at[k] < INT32_MIN || hit->at[k] > INT32_MAX)
            return false;
    return hit->face != TIA_NO_INDEX;
}

/* Moves the ray on top of the stack to its next hit. There the reflected ray and the ray that passes through replace
 * it, if the link allows them. So the stack never has more than link->order + link->walls + 1 rays. Returns false if
 * stopped. */
static bool follow(const struct shot *shot, struct search_ray *stack, uint32_t *count)
{
    const struct tia_radio_link *link = shot->room->link;
    const struct tia_radio *radio = shot->room->radio;
    struct search_ray *ray = &stack[*count - 1];
    struct hit hit = nearest_of(radio, ray);
    struct tia_radio_path *path = &ray->result.path;

    if (!shot->everywhere && !receive(shot, ray, hit.t))
        return false;
    bool reflects = is_in_range(&hit) && path->order < link->order;
    bool passes = is_in_range(&hit) && path->wall_count < link->walls;
    --*count;
    if (!reflects && !passes)
        return true;
    move(ray, radio, &hit);
    if (passes && reflects)
        stack[*count + 1] = *ray;
    if (passes)
        pass(&stack[(*count)++], &hit);
    if (!reflects)
        return true;
    ray = &stack[(*count)++];
    reflect(ray, radio, &hit);
    return !shot->everywhere || shot->received(shot->ctx, &ray->result);
}

int tia_radio_shoot(const struct tia_radio *radio, struct tia_radio_room *room, const struct tia_radio_link *link,
                    uint32_t density, uint32_t i, bool everywhere,
                    bool (*received)(void *ctx, const struct tia_radio_ray *ray), void *ctx)
{
    struct shot shot = {room, density, everywhere, received, ctx};
    if (!tia_radio_can_search(radio, room, link) || !(everywhere || tia_radio_has_ends(link)) ||
        i >= tia_radio_directions(density) || !received)
        return TIA_ERR_ARGUMENT;
    struct search_ray *ray = &room->rays[0];
    uint32_t count = 1;

    room->radio = radio;
    room->link = link;
    ray->way = 0;
    ray->last = NO_PLANE;
    ray->result.miss = 0;
    ray->result.path.order = ray->result.path.wall_count = 0;
    for (int k = 0; k < 3; k++)
        ray->at[k] = radio_axis(&link->from, k);
    (void)tia_radio_direction(density, i, ray->result.path.direction[0]);
    while (count > 0)
        if (!follow(&shot, room->rays, &count))
            return TIA_STOPPED;
    return TIA_OK;
}
