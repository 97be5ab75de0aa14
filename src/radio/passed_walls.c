/* passed_walls.c - finds the walls that a segment passes through. */
#include "near.h"
#include "search.h"

/* Indices into room->exact.number. */
enum { SCRATCH, START_FROM = 3, START_TO, END_FROM, END_TO, FROM, TO, LEFT, RIGHT };

/* The segment after `number` reflections, on the line from `a` to `b`. */
struct segment {
    struct tia_radio_room *room;
    uint32_t number, start, end; /* number of the segment; planes of its ends, or NO_PLANE */
    const struct spot *a, *b;
    struct near near;
};

/* Returns the order of a line's intersections with two planes: the sign of |from_a| / |to_a| - |from_b| / |to_b|. The
 * arguments are indices into room->exact.number. */
static int order_of(struct tia_radio_room *room, int from_a, int to_a, int from_b, int to_b)
{
    struct number *n = room->exact.number;

    tia_number_multiply(&n[LEFT], &n[from_a], &n[to_b]);
    tia_number_multiply(&n[RIGHT], &n[from_b], &n[to_a]);
    return tia_number_compare_sizes(&n[LEFT], &n[RIGHT]);
}

/* True if the segment crosses the plane strictly between the segment's ends; room->exact.met is then the
 * intersection. */
static bool crosses(const struct segment *s, const struct radio_plane *plane)
{
    struct tia_radio_room *room = s->room;
    struct number *n = room->exact.number;

    tia_radio_side(&n[FROM], plane, s->a, &n[SCRATCH]);
    tia_radio_side(&n[TO], plane, s->b, &n[SCRATCH]);
    if (n[FROM].sign * n[TO].sign >= 0)
        return false;
    if (s->start != NO_PLANE && order_of(room, FROM, TO, START_FROM, START_TO) <= 0)
        return false;
    if (s->end != NO_PLANE && order_of(room, FROM, TO, END_FROM, END_TO) >= 0)
        return false;
    tia_radio_meet(&room->exact.met, s->a, s->b, &n[FROM], &n[TO], &n[SCRATCH]);
    return true;
}

/* ---- counting walls ---- */

static bool is_same_wall(const struct tia_radio *radio, uint32_t a, uint32_t b)
{
    const struct radio_face *f = &radio->faces[a], *g = &radio->faces[b];

    return f->solid && g->solid ? f->object == g->object : f->plane == g->plane && !f->solid && !g->solid;
}

/* Adds a wall. Returns false if the link allows no more. For a box, stores the face through which the path enters; at
 * an edge, the face with the lower number. */
static bool add_wall(const struct segment *s, uint32_t face)
{
    struct tia_radio_path *path = &s->room->path;

    for (uint32_t i = 0; i < path->wall_count; i++) {
        struct tia_radio_wall *wall = &path->wall[i];
        if (wall->segment == s->number && is_same_wall(s->room->radio, wall->face, face)) {
            wall->face = wall->face < face ? wall->face : face;
            return true;
        }
    }
    if (path->wall_count == s->room->link->walls)
        return false;
    path->wall[path->wall_count++] = (struct tia_radio_wall){face, s->number};
    return true;
}

/* Adds a wall if the segment passes through the face. Faces through which it leaves a box are skipped: its entry is
 * counted. Returns false if there are too many walls. */
static bool test_face(const struct segment *s, uint32_t number)
{
    const struct tia_radio *radio = s->room->radio;
    const struct radio_face *face = &radio->faces[number];

    if (face->plane == s->start || face->plane == s->end || !crosses(s, &radio->planes[face->plane]))
        return true;
    if (face->solid && (s->room->exact.number[FROM].sign > 0) == face->turned)
        return true;
    return !tia_radio_on_face(radio, face, &s->room->exact.met, &s->room->exact.number[SCRATCH]) || add_wall(s, number);
}

/* ---- faces near the segment ---- */

static bool test_tree(const struct segment *s)
{
    const struct tia_bvh_tree *tree = &s->room->radio->tree;
    uint32_t stack[TIA_BVH_DEPTH_MAX + 2], count = 0;

    if (tree->node_count > 0)
        stack[count++] = 0;
    while (count > 0) {
        uint32_t at = stack[--count];
        const struct tia_bvh_node *node = &tree->nodes[at];
        if (!near_box(&s->near, &node->bounds))
            continue;
        for (uint32_t i = 0; i < node->count; i++)
            if (near_box(&s->near, &s->room->radio->boxes[tree->items[node->index + i]]) &&
                !test_face(s, tree->items[node->index + i]))
                return false;
        if (node->count == 0) {
            stack[count++] = at + 1;
            stack[count++] = node->index;
        }
    }
    return true;
}

static void begin(struct segment *s, uint32_t order, uint32_t i)
{
    const struct tia_radio_link *link = s->room->link;
    const struct tia_vec3 *from = i > 0 ? &s->room->path.point[i - 1] : &link->from;
    const struct tia_vec3 *to = i < order ? &s->room->path.point[i] : &link->to;
    int64_t ends[2][3];

    for (int k = 0; k < 3; k++) {
        ends[0][k] = radio_axis(from, k);
        ends[1][k] = radio_axis(to, k);
    }
    near_begin(&s->near, ends[0], ends[1]);
}

bool tia_radio_pass(struct tia_radio_room *room, uint32_t order, uint32_t i)
{
    const struct tia_radio *radio = room->radio;
    struct number *n = room->exact.number;
    struct segment s = {
        room, i, NO_PLANE, NO_PLANE, &room->exact.sent[i], &room->exact.got[order - i], {{0}, {0}, {0}, {0}}};

    begin(&s, order, i);
    if (i > 0) {
        s.start = search_plane(room, order, i - 1);
        tia_radio_side(&n[START_FROM], &radio->planes[s.start], s.a, &n[SCRATCH]);
        tia_radio_side(&n[START_TO], &radio->planes[s.start], s.b, &n[SCRATCH]);
    }
    if (i < order) {
        s.end = search_plane(room, order, i);
        tia_radio_side(&n[END_FROM], &radio->planes[s.end], s.a, &n[SCRATCH]);
        tia_radio_side(&n[END_TO], &radio->planes[s.end], s.b, &n[SCRATCH]);
    }
    for (uint32_t k = 0; k < radio->endless_count; k++)
        if (!test_face(&s, radio->endless[k]))
            return false;
    return test_tree(&s);
}
