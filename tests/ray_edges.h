/* ray_edges.h - for test_ray_edges.c: small worlds, and rays close to places where their hits change. */
#ifndef TESTS_RAY_EDGES_H
#define TESTS_RAY_EDGES_H

#include <math.h>

#include "check.h"
#include "random.h"
#include "reading.h"

#include "one_lane.h"

static struct reading reading;
static struct tia_view *prepared;
static const struct ray_view *view;
static const struct sure_scene *scene;
static void *memory[3];
static struct light_room lights;
static long double unit; /* the unit of length of the scene's file */

static const char common[] = "camera perspective eye 0 0 9 look 0 0 0 fov 40\n"
                             "texture squares checker even 0.2 0.3 0.2 odd 0.9 0.8 0.7 scale 0.3 0.3\n"
                             "material plain colour 0.7 0.6 0.5 specular 0.5 0.4 0.3 exponent 12.5 facing 0.1\n"
                             "material squares texture squares colour 0.8 1 0.7 refraction 0.9 index 1.4 fresnel\n"
                             "material mirror colour 0.5 mirror 0.5 specular 0.4 exponent 3\n"
                             "material matte colour 1\nmaterial shiny colour 0 specular 1 exponent 1\n"
                             "material thin colour 0.2 refraction 0.8 index 0.6 transmission 0.5 0.6 0.5\n"
                             "light point at 1 2 3 emission 0.6\n";

static const struct world {
    const char *name, *text;
} worlds[] = {
    {"spheres",
     "sphere centre 0.3 0 0 radius 0.9 material plain\nsphere centre -1 0.2 0.3 radius 0.4 material squares\n"
     "sphere centre 0.1 0.9 -0.3 radius 0.02 material mirror\n"},
    {"flat", "plane point 0 -0.5 0 normal 0.1 1 0 material squares\n"
             "disc centre 0.2 0.3 0 normal 0.5 0.1 1 radius 0.8 material mirror\n"
             "disc centre -0.6 0.3 0.2 normal 0 1 0 radius 0.3 material plain\n"},
    {"faces", "triangle a -0.8 0 -0.5 b 0.7 0.1 0.5 c 0.1 0.9 0.1 material squares\n"
              "triangle a -0.02 0 1 b 0.01 0.02 1 c 0 -0.03 1.01 material mirror\n"
              "instance gem name jewel material thin\nmesh gem\nvertex 1 0 0.2\nvertex -0.5 0 0.9\nvertex -0.5 0 -0.9\n"
              "vertex 0 0.7 0\nnormal 0.9 0.4 0\nnormal -0.5 0.4 0.8\nnormal -0.5 0.4 -0.8\nnormal 0 1 0\n"
              "face 1//1 4//4 2//2\nface 2//2 4//4 3//3\nface 3//3 4//4 1//1\nend\n"},
    {"boxes",
     "box min -0.4 -0.3 -0.5 max 0.5 0.4 0.2 material squares\nbox min -1 -0.2 0.1 max -0.7 0.8 0.2 material mirror\n"},
    {"cylinders", "cylinder base -0.4 -0.1 0 top 0.5 0.5 0.2 radius 0.3 capped material squares\n"
                  "cylinder base 0 -0.9 0.2 top 0.1 0.7 0.1 radius 0.6 material mirror\n"},
    {"upright cylinders", "cylinder base 0.3 -0.5 0 top 0.3 0.6 0 radius 0.7 capped material squares\n"
                          "cylinder base 0 0 -1.3 top 0 0 1.3 radius 0.9 material mirror\n"},
    {"cones", "cone base -0.4 -0.1 0 top 0.5 0.5 0.2 radii 0.5 0.2 capped material squares\n"
              "cone base 0.6 -0.7 0 top 0.6 0.2 0.1 radii 0.1 0.7 capped material thin\n"
              "cone base -0.2 -0.9 0.2 top 0 0.7 0.1 radii 0.8 0 material mirror\n"},
    {"tori", "torus centre 0.1 0 0 axis 0.2 0.5 1 major 0.7 minor 0.2 material squares\n"
             "torus axis 0 1 0 major 1 minor 0.001 material mirror\n"
             "sphere centre 0.3 0 0.1 radius 0.3 material plain\n"},
    {"rounded boxes", "rounded min -0.4 -0.3 -0.5 max 0.5 0.4 0.2 radius 0.1 material squares\n"
                      "rounded min -1 -0.2 0.1 max -0.7 0.8 0.4 radius 0.15 material mirror\n"
                      "sphere centre 0.3 0 0.3 radius 0.3 material plain\n"},
    {"grid",
     "instance steps material mirror\ngrid steps size 3 3 2 corner -0.7 -0.7 -0.5 cell 0.5\nrow 1 2 0\nrow 0 2 1\n"
     "row 0 1 1\nrow 1 0 2\nrow 1 0 0\nrow 0 2 2\nend\nsphere centre 0.3 0 0.1 radius 0.3 material plain\n"},
    {"instances", "sphere radius 0.7 at 0.1 0.2 0 rotate 10 20 30 scale 1 0.4 1.3 material squares\n"
                  "box min -1 -1 -1 max 1 1 1 at -0.8 -0.2 0.3 rotate 30 40 10 scale 0.2 0.5 0.3 material mirror\n"
                  "cylinder base 0 0 0 top 0 1 0 radius 0.4 capped at 0.2 -0.9 0.2 rotate 5 70 10 scale 0.6 0.8 0.6 "
                  "material thin\n"},
    {"thin", /* the distant object keeps the reader from enlarging the scene */
     "sphere centre 0 0 -20000 radius 1 material plain\n"
     "sphere radius 0.1 at 0 0.2 0 rotate 10 20 30 scale 4 0.001 4 material thin\n"
     "cone base -0.4 -0.002 0 top -0.4 0 0 radii 0.4 0 capped material thin\n"
     "cone base 0.4 0 0 top 0.4 0.3 0 radii 0.1 0.4 capped material thin\n"
     "box min -1 -0.1 -1 max 1 -0.09995 1 material thin\n"},
    {"spots", "light spot at 0.3 1.6 0.5 direction -0.1 -0.8 -0.2 inner 10 outer 14 emission 0.5\n"
              "light spot at -0.3 1 -0.5 direction 0.1 -0.8 0.2 inner 20 outer 60 emission 0.5\n"
              "plane point 0 -0.5 0 normal 0.1 1 0 material matte\n"},
    {"fades", "light point at 0.3 0.2 0.5 emission 0.5 attenuation 0.1 0 2\n"
              "light point at -0.6 0.4 -0.1 emission 0.9 attenuation 0.1 1.5 0\n"
              "plane point 0 -0.5 0 normal 0.1 1 0 material matte\n"},
    {"shiny", "plane point 0 -0.5 0 normal 0.1 1 0 material shiny\nsphere centre 0 0 0 radius 0.5 material shiny\n"},
    {"areas", "light sphere at -0.3 0.2 0.1 radius 0.5 emission 0.9 samples 4\n"
              "plane point 0 -0.5 0 normal 0.1 1 0 material matte\ndisc centre 0.1 0.2 0 normal 1 0.3 0.2 radius 0.3 "
              "material matte\n"},
    {"lights",
     "light rectangle at 0 0.6 0 sides 0.5 0 0  0 0.2 0.5 emission 0.3 samples 5\n"
     "light disc at 0.4 0.3 0 direction -1 -1 0 radius 0.4 emission 0.3 samples 3\n"
     "light sphere at -0.3 0.2 0.1 radius 0.3 emission 0.3 samples 4\n"
     "light spot at 0.3 1.6 0.5 direction -0.1 -0.8 -0.2 inner 10 outer 35 emission 0.5 attenuation 0.5 0.2 0.1\n"
     "light directional direction 0.3 -1 -0.2 emission 0.2\n"
     "light point at -1 2 1 emission 0.6 attenuation 1 0.2 0.4\n"
     "plane point 0 -0.5 0 normal 0.1 1 0 material squares\nsphere centre 0.6 -0.3 0.1 radius 0.4 material plain\n"
     "box min -0.9 -0.5 -0.4 max -0.5 0.1 -0.1 material mirror\n"},
    {"hindered",
     "light ambient emission 0.5 occlusion 0.5 samples 3\nplane point 0 -0.5 0 normal 0.1 1 0 material matte\n"
     "sphere centre 0 0 0 radius 0.5 material matte\n"},
    {"long cylinders", "cylinder base -30000 -20 1 top 30000 20 -1 radius 0.3 capped material squares\n"
                       "cylinder base -2 -20000 1 top 3 20000 -1 radius 0.4 material thin\n"},
    {"flat cylinders", "sphere centre 20000 0 0 radius 1 material plain\n"
                       "cylinder base 0.3 0.2 0 top 0.31 0.201 0 radius 0.4 capped material thin\n"
                       "cylinder base -0.3 0.2 0 top -0.3 0.201 0 radius 0.4 material thin\n"},
    {"large faces",
     "instance floor name floor material mirror\nmesh floor\nvertex 10000 0 0.2\nvertex -10000 0 10000\n"
     "vertex -10000 0.5 -10000\nnormal 0.9 0.4 0\nnormal -0.9 0.4 0.8\nnormal -0.5 -0.4 -0.8\nface 1//1 2//2 3//3\n"
     "end\n"},
};

static void open_world(const struct world *world)
{
    char text[8192];

    (void)snprintf(text, sizeof text, "%s%s", common, world->text);
    read_string(&reading, TIA_FORMAT_TIA, text);
    CHECK_MSG(reading.status == TIA_OK, "%s: %u: %s", world->name, reading.reader.error.line,
              reading.reader.error.text);
    struct tia_scene *s = &reading.scene;
    size_t size = tia_bvh_size(s), more;
    memory[0] = malloc(size);
    CHECK_EQ(tia_bvh_build(&s->bvh, memory[0], size, NULL, s, NULL), TIA_OK);
    size = tia_view_size(s, s->light_count);
    more = tia_sure_size(s, s->light_count);
    memory[1] = malloc(size);
    memory[2] = malloc(more);
    CHECK_EQ(tia_view_init(&prepared, memory[1], size, s, s->light_count, 64, 64, NULL), TIA_OK);
    prepared->simd_memory = memory[2];
    view = prepared->prepared;
    tia_sure_prepare(prepared);
    tia_sure_set_lights(prepared);
    scene = tia_sure_scene(prepared);
    unit = ldexpl(1, (int)s->scale_bits);
}

static void close_world(void)
{
    for (int i = 0; i < 3; i++)
        free(memory[i]);
    read_end(&reading);
}

/* ---- rays ---- */

struct real3 {
    long double v[3];
};

static struct real3 random3(long double size)
{
    return (struct real3){{size * random_real(), size * random_real(), size * random_real()}};
}

/* Returns a point on the unit sphere. */
static struct real3 random_unit(void)
{
    struct real3 a;
    long double n;

    do {
        a = random3(1);
        n = sqrtl(a.v[0] * a.v[0] + a.v[1] * a.v[1] + a.v[2] * a.v[2]);
    } while (n > 1 || n < 0.1L);
    return (struct real3){{a.v[0] / n, a.v[1] / n, a.v[2] / n}};
}

static struct num_dir towards(struct real3 a)
{
    long double n = sqrtl(a.v[0] * a.v[0] + a.v[1] * a.v[1] + a.v[2] * a.v[2]) / (long double)NUM_UNIT_ONE;

    return (struct num_dir){(num_unit)(a.v[0] / n), (num_unit)(a.v[1] / n), (num_unit)(a.v[2] / n)};
}

static struct num_point place(struct real3 a)
{
    const long double one = (long double)NUM_LENGTH_ONE;

    return (struct num_point){(num_length)(a.v[0] * one), (num_length)(a.v[1] * one), (num_length)(a.v[2] * one)};
}

static void meet(const struct ray *ray, struct hit *hit)
{
    ray_intersect(view, ray, hit);
    ray_intersect_lights(view, ray, hit);
}

static bool same(const struct hit *a, const struct hit *b)
{
    return a->object == b->object && a->light == b->light && (a->object == TIA_NO_OBJECT || a->element == b->element);
}

static struct real3 between(struct real3 a, struct real3 b, long double part)
{
    for (int i = 0; i < 3; i++)
        a.v[i] += (b.v[i] - a.v[i]) * part;
    return a;
}

/* Returns a ray from `origin`. In most cases it passes within `gap` of a place where its hit changes. */
static struct ray edge_ray(struct real3 origin, long double gap)
{
    struct real3 a = random3(unit), b = random3(unit);
    struct ray ray = {place(origin), {0, 0, 0}};
    struct hit first, second;

    if (random_bits() % 4 == 0) { /* nearly perpendicular to an axis */
        int i = (int)(random_bits() % 3);
        a.v[i] = origin.v[i] + ldexpl(unit * random_real(), -(int)(random_bits() % 48));
        b.v[i] = origin.v[i] + ldexpl(unit * random_real(), -(int)(random_bits() % 48));
    }
    if (random_bits() % 16 == 0) { /* nearly along an axis */
        int along = (int)(random_bits() % 3);
        for (int i = 0; i < 3; i++) {
            a.v[i] = i == along ? 0 : origin.v[i] + ldexpl(unit * random_real(), -(int)(random_bits() % 64));
            b.v[i] = i == along ? 0 : origin.v[i] + ldexpl(unit * random_real(), -(int)(random_bits() % 64));
        }
    }
    for (int i = 0; i < 3; i++) {
        a.v[i] -= origin.v[i];
        b.v[i] -= origin.v[i];
    }
    ray.direction = towards(b);
    meet(&ray, &second);
    ray.direction = towards(a);
    meet(&ray, &first);
    for (long double far = 1; far > gap && !same(&first, &second); far /= 2) {
        struct real3 c = between(a, b, 0.5L);
        struct hit met;
        ray.direction = towards(c);
        meet(&ray, &met);
        if (same(&met, &first))
            a = c;
        else
            b = c;
    }
    ray.direction = towards(random_bits() % 2 ? a : b);
    return ray;
}

/* Returns a packet for the ray. Its origin differs by eo and its direction by ed from those of `ray`, in random
 * directions. */
static struct packet moved(const struct ray *ray, double eo, double ed)
{
    struct real3 o = random_unit(), d = random_unit();
    struct packet p = {.eo = eo + P2M(50), .ed = ed * 1.0001 + P2M(50), .from = {-1, 0, 0}};
    double at[3], to[3], length;

    sure_point(at, ray->origin);
    sure_dir(to, ray->direction);
    for (int i = 0; i < 3; i++) {
        at[i] += eo * (double)o.v[i];
        to[i] += ed * (double)d.v[i];
    }
    length = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
    p.o = v3_set(at);
    p.d = (struct v3){to[0] / length, to[1] / length, to[2] / length};
    return p;
}

static double random_size(int most, int least)
{
    int bits = -(int)(random_bits() % (unsigned)(least - most + 1)) - most;

    return random_bits() % 3 ? ldexp(1, bits) : 0;
}

#endif
