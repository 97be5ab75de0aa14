#include "mesh_scene.h"

#include <math.h>

static void add(struct mesh *m, struct point a, struct point b, struct point c)
{
    struct point *face = m->corner[m->count++];

    face[0] = a;
    face[1] = b;
    face[2] = c;
}

static void add_quad(struct mesh *m, struct point a, struct point b, struct point c, struct point d)
{
    add(m, a, b, c);
    add(m, a, c, d);
}

static struct point placed(struct point centre, double x, double y, double z)
{
    return (struct point){centre.x + x, centre.y + y, centre.z + z};
}

static const struct point ball_centre = {-1.7, 1.6, 0.2};
#define BALL_RADIUS 1.2

static struct point on_ball(struct point p)
{
    double scale = BALL_RADIUS / sqrt(p.x * p.x + p.y * p.y + p.z * p.z);

    return (struct point){p.x * scale, p.y * scale, p.z * scale};
}

static struct point middle(struct point a, struct point b)
{
    return on_ball((struct point){a.x + b.x, a.y + b.y, a.z + b.z});
}

static void add_ball_part(struct mesh *m, struct point a, struct point b, struct point c, int depth)
{
    if (depth == 0) {
        add(m, placed(ball_centre, a.x, a.y, a.z), placed(ball_centre, b.x, b.y, b.z),
            placed(ball_centre, c.x, c.y, c.z));
        return;
    }
    struct point ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    add_ball_part(m, a, ab, ca, depth - 1);
    add_ball_part(m, b, bc, ab, depth - 1);
    add_ball_part(m, c, ca, bc, depth - 1);
    add_ball_part(m, ab, bc, ca, depth - 1);
}

/* Adds an icosahedron, its faces divided into four `depth` times. */
static void add_ball(struct mesh *m, int depth)
{
    static const double g = 1.618033988749895;
    static const uint8_t face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    const struct point p[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};

    for (int i = 0; i < 20; i++)
        add_ball_part(m, on_ball(p[face[i][0]]), on_ball(p[face[i][1]]), on_ball(p[face[i][2]]), depth);
}

static struct point on_ring(double u, double v)
{
    static const struct point centre = {0.4, 1.3, 2.0};
    double tau = 6.283185307179586, away = 0.9 + 0.3 * cos(tau * v);
    double x = away * cos(tau * u), z = away * sin(tau * u), y = 0.3 * sin(tau * v);

    return placed(centre, x, y * cos(1.0) - z * sin(1.0), y * sin(1.0) + z * cos(1.0));
}

static void add_ring(struct mesh *m, int around, int across)
{
    for (int i = 0; i < around; i++)
        for (int k = 0; k < across; k++) {
            double u = (double)i / around, v = (double)k / across;
            double next_u = (double)(i + 1) / around, next_v = (double)(k + 1) / across;
            add_quad(m, on_ring(u, v), on_ring(u, next_v), on_ring(next_u, next_v), on_ring(next_u, v));
        }
}

static void add_box(struct mesh *m)
{
    static const uint8_t side[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                                       {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    struct point p[8];

    for (int i = 0; i < 8; i++) {
        double x = i & 4 ? 0.8 : -0.8, y = i & 2 ? 1.7 : 0, z = i & 1 ? 0.7 : -0.7;
        p[i] = (struct point){1.9 + x * cos(0.5) + z * sin(0.5), y, -0.6 - x * sin(0.5) + z * cos(0.5)};
    }
    for (int i = 0; i < 6; i++)
        add_quad(m, p[side[i][0]], p[side[i][1]], p[side[i][2]], p[side[i][3]]);
}

void bench_mesh(struct mesh *m, int depth)
{
    m->count = 0;
    add_quad(m, (struct point){-12, 0, -12}, (struct point){-12, 0, 12}, (struct point){12, 0, 12},
             (struct point){12, 0, -12});
    m->first[0] = m->count;
    add_ball(m, depth);
    m->first[1] = m->count;
    add_box(m);
    m->first[2] = m->count;
    add_ring(m, 8 << depth, 4 << depth);
    m->first[3] = m->count;
}
