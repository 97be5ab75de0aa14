/* beam_tmpl.h - blocks of pixels that see only the background, decided for all their rays at once.
 *
 * Parameters: the doubles of isa/isa.h. Defines: sees_background(), store_background().
 *
 * The camera rays of a block lie in the pyramid whose edges are the rays through the block's corners: the vector to a
 * position in the image is linear in the position. A side of the pyramid that contains the corners' vectors A and B has
 * the normal N = A x B, turned outward. Points of the pyramid have N.(P - eye) <= 0. A fixed-point ray is no farther
 * than `pad` from one in the pyramid (slabs_tmpl.h), so it enters no box all of whose points have N.(P - eye) > |N| pad
 * for one of the four sides. The block sees the background where this is so for boxes that contain all objects. */
#ifndef TIA_SIMD_RAYS_BEAM_TMPL_H
#define TIA_SIMD_RAYS_BEAM_TMPL_H

#include "paths_tmpl.h"

#define BEAM_SIDES 4
#define BEAM_PARTS (LANES < BEAM_SIDES ? BEAM_SIDES / LANES : 1)

/* Most nodes that are visited for a block, and that wait. A choice: a block that needs more sees an object, or passes
 * close to many. */
#define BEAM_VISITS 64
#define BEAM_WAITS 32

/* A pyramid of rays, with its sides in the lanes: a box is outside of a side if N.P > limit for all its points. */
struct pyramid {
    vd normal[BEAM_PARTS][3], limit[BEAM_PARTS];
};

struct pyramid_node {
    const struct sure_tree *tree;
    uint32_t node;
};

static double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double sum3(const double a[3])
{
    return __builtin_fabs(a[0]) + __builtin_fabs(a[1]) + __builtin_fabs(a[2]);
}

/* Sets the vector from the eye to a position in the image; returns the sizes of its parts. */
static double image_point(const struct sure_camera *c, double x, double y, double to[3])
{
    double h = c->left + c->across * x, v = c->top - c->upward * y;

    for (int i = 0; i < 3; i++)
        to[i] = c->u[i] * h + c->v[i] * v - c->n[i] * c->away;
    return __builtin_fabs(c->left) + c->across + __builtin_fabs(c->top) + c->upward + c->away;
}

/* Sets the vectors to the block's corners, in order around it; returns the largest sizes of their parts. */
static double beam_corners(const struct sure_block *b, double corner[BEAM_SIDES][3])
{
    const struct sure_camera *c = &b->scene->camera;
    double size = 0;

    for (int k = 0; k < BEAM_SIDES; k++) {
        int x = k == 1 || k == 2 ? b->x + b->width : b->x, y = k < 2 ? b->y : b->y + b->height;
        size = image_point(c, (double)x / c->width, (double)y / c->height, corner[k]);
    }
    return size;
}

/* Returns the largest error of the directions in a block whose corners' vectors have parts of this size. The shortest
 * vector is at least as long as that to a corner, less the sides of the block at the corner. */
static double beam_turn(double size, double corner[BEAM_SIDES][3])
{
    double way = BOUND_OF(CAMERA_DIRECTION, 2 * size * BOUND(CAMERA_WAY) + BOUND(CAMERA_WAY_UNITS)), sides = 0;

    for (int i = 0; i < 3; i++)
        sides += __builtin_fabs(corner[1][i] - corner[0][i]) + __builtin_fabs(corner[3][i] - corner[0][i]);
    double least = __builtin_sqrt(dot3(corner[0], corner[0])) - sides;
    return least > 16 * way ? way / least * BOUND(UNIT_CHORD) + BOUND(UNIT_ROUNDING) : INFINITE;
}

/* Sets the sides. `reach` is the largest distance of an object from the eye, and `pad` is that of packet_start(), which
 * covers the roundings of N.P too. `middle` is a vector inside the pyramid. */
static void beam_open(const struct sure_block *b, struct pyramid *beam)
{
    const struct sure_scene *s = b->scene;
    const double *eye = s->camera.eye, far[3] = {eye[0] - s->centre[0], eye[1] - s->centre[1], eye[2] - s->centre[2]};
    double corner[BEAM_SIDES][3], normal[3][BEAM_SIDES + LANES], limit[BEAM_SIDES + LANES], middle[3];
    double size = beam_corners(b, corner), reach = sum3(far) + s->extent;
    double pad = BOUND_OF(SLABS_APART, BOUND(CAMERA_EYE) + reach * beam_turn(size, corner)) +
                 (sum3(eye) + reach) * BOUND(SLABS_FLOATS);

    for (int i = 0; i < 3; i++)
        middle[i] = corner[0][i] + corner[2][i];
    for (int k = 0; k < BEAM_SIDES + LANES; k++) {
        const double *from = corner[k % BEAM_SIDES], *to = corner[(k + 1) % BEAM_SIDES];
        double n[3] = {from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2],
                       from[0] * to[1] - from[1] * to[0]};
        double out = dot3(n, middle) < 0 ? 1 : -1;
        for (int i = 0; i < 3; i++)
            normal[i][k] = n[i] *= out;
        limit[k] = dot3(n, eye) + sum3(n) * pad + BOUND_OF(BEAM_SIDE, size * size * reach * BOUND(BEAM_NORMAL));
    }
    for (int p = 0; p < BEAM_PARTS; p++) {
        for (int i = 0; i < 3; i++)
            beam->normal[p][i] = vload(&normal[i][p * LANES]);
        beam->limit[p] = vload(&limit[p * LANES]);
    }
}

/* True if the beam certainly enters no child of this node at `place`. */
LANE_OP bool passes_by(const struct pyramid *beam, const struct sure_node *n, int place)
{
    bool by = false;

    for (int p = 0; p < BEAM_PARTS; p++) {
        vd least = vset(0);
        for (int i = 0; i < 3; i++)
            least = least + vmin(beam->normal[p][i] * vset((double)n->box[i][place]),
                                 beam->normal[p][i] * vset((double)n->box[i + 3][place]));
        by = by || any(vlt(beam->limit[p], least));
    }
    return by;
}

/* Queues the trees of a leaf's meshes. False if the leaf has anything else, or there are too many. */
static bool wait_for_meshes(const struct sure_scene *s, const struct sure_tree *tree, const struct sure_node *n,
                            int place, struct pyramid_node *waits, int *count)
{
    if (tree != &s->objects)
        return false;
    for (uint32_t i = n->index[place]; i < n->index[place] + n->count[place]; i++) {
        const struct sure_object *o = &s->object[tree->items[i]];
        if (o->kind != SURE_MESH || o->placed || *count == BEAM_WAITS)
            return false;
        if (o->mesh->node_count)
            waits[(*count)++] = (struct pyramid_node){o->mesh, 0};
    }
    return true;
}

/* Visits the nodes that the beam may enter. Returns true if no leaf is among them. */
static bool beam_is_free(const struct sure_scene *s, const struct pyramid *beam, uint32_t *visits)
{
    struct pyramid_node waits[BEAM_WAITS + 2];
    int count = 0;

    if (s->objects.node_count)
        waits[count++] = (struct pyramid_node){&s->objects, 0};
    for (*visits = 0; count && *visits < BEAM_VISITS; ++*visits) {
        const struct pyramid_node v = waits[--count];
        const struct sure_node *n = &v.tree->nodes[v.node];
        for (int place = 0; place < 2; place++) {
            if (passes_by(beam, n, place))
                continue;
            if (n->count[place] == SURE_INNER && count < BEAM_WAITS)
                waits[count++] = (struct pyramid_node){v.tree, n->index[place]};
            else if (n->count[place] == SURE_INNER || !wait_for_meshes(s, v.tree, n, place, waits, &count))
                return false;
        }
    }
    return !count;
}

/* True if no ray of the block meets an object or a light. */
static bool sees_background(struct sure_block *b)
{
    const struct sure_scene *s = b->scene;
    struct pyramid beam;
    uint32_t visits;

    if (s->camera.orthographic || s->unbounded_count || s->view->lit)
        return false;
    beam_open(b, &beam);
    bool is_free = beam_is_free(s, &beam, &visits);
    (void)cancelled(&b->cancel, visits);
    return is_free;
}

/* Stores the background's colour in all samples. */
static void store_background(struct sure_block *b)
{
    const double *rgb = b->scene->background, error = BOUND(COLOUR_UNITS) * (1 + sure_most3(rgb));

    b->rest_count = 0;
    for (int i = 0; i < SURE_SLOTS; i++) {
        for (int c = 0; c < 3; c++)
            b->colour[c][i] = rgb[c];
        b->error[i] = error;
        b->unsure[i] = false;
    }
}

#endif
