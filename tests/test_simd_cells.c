/* The cells of src/simd against each of their pixels: the movement of points, the error of a line between samples, and
 * where shadows begin; and stored bounds against those of a run alone. No error exceeds its bound, and the worst has
 * more than a tenth of it, so that a bound of a tenth of the right size is detected here. */
#include <float.h>

#include "float_modes.h"
#include "simd/span/proved.h"
#include "simd_runs.h"
#include "simd_used.h"
#include "vector_floats.h"

#include "simd/span/kernel_tmpl.h"

enum { SQUARE, TURN, FIRST, SECOND, SAG, LINE, LEVELS_31, LEVELS_63, BOUNDS };
static struct used bounds[BOUNDS] = {{"|w|^2", 0, 0},
                                     {"|S'|", 0, 0},
                                     {"|P'|", 0, 0},
                                     {"|P''|", 0, 0},
                                     {"D below two samples", 0, 0},
                                     {"a line between samples", 0, 0},
                                     {"a level of 31", 0, 0},
                                     {"a level of 63", 0, 0}};
static unsigned long lit, dark, flat;

/* ---- the exact values of a pixel ---- */

struct truth {
    real depth, s, vv;
};

static struct truth truth_at(const struct simd_fine *f, real x)
{
    const double *b = f->seen.b, *d = f->seen.d;
    struct truth o = {d[0] + x * (d[1] + x * d[2]), 0, f->place.v0 + x * (f->place.v1 + x * f->place.v2)};

    o.s = (b[0] + b[1] * x + sqrtl(o.depth)) / f->seen.c;
    return o;
}

/* Returns constant + (linear[0] + linear[1] x)/s + v.v/s^2. */
static real form(real constant, const double linear[2], real x, const struct truth *o)
{
    return constant + (linear[0] + linear[1] * x + o->vv / o->s) / o->s;
}

static real lambert(const struct simd_fine_light *light, real x, const struct truth *o)
{
    real w = form(light->lamp->qq, light->q, x, o);

    return (light->lamp->k + (light->g[0] + light->g[1] * x) / o->s) * light->lamp->per_r / sqrtl(w);
}

static bool is_dark(const struct simd_fine *f, const struct simd_fine_light *light, real x, const struct truth *o)
{
    const struct simd_fine_cast *cast = &f->cast[light->first];
    real w = form(light->lamp->qq, light->q, x, o), a = form(cast->a[0], cast->a + 1, x, o);

    return a > 0 && (a < w || light->lamp->cast[0].encloses) &&
           a * a > w * form(cast->k[0], cast->k + 1, x, o) * (1 + light->lamp->swell);
}

/* ---- colour levels ---- */

/* Checks a channel of a pixel. y, the channel times `levels` before it is rounded, is within 1/2 - `near` of the exact
 * result for the exact cosine `whole`, and of the result for the kernel's `cosine` +- `bound`. */
static void try_level(int which, real y, real levels, real near, const tia_q30 part[3], real whole, real cosine,
                      real bound)
{
    real product = (real)part[1] * (real)part[2] * 0x1p-30L;

    CHECK(fabsl(y - levels * fminl(((real)part[0] + fmaxl(whole, 0) * product) * 0x1p-30L, 1)) <= .5L - near);
    for (int sign = -1; sign <= 1; sign += 2) {
        real off = fminl(fmaxl(cosine + (real)sign * bound, 0), 1);
        off = fminl(((real)part[0] + off * product) * 0x1p-30L, 1);
        use(&bounds[which], fmaxl(y - levels * off, 0), .5L - near);
    }
}

/* Checks pixels that are lit by one light, without shadows. */
static void try_levels(const struct simd_fine *f, const struct simd_run *r, const struct body *k, int first)
{
    const struct tia_scene *scene = f->view->scene;
    const struct tia_material *material = &scene->materials[scene->spheres[f->sphere].material];
    const struct tia_rgb *own = &material->emission, *colour = &material->colour, *light = &f->view->lights[0].emission;
    const tia_q30 red[3] = {own->r, colour->r, light->r}, green[3] = {own->g, colour->g, light->g};
    const struct simd_light *q = &r->light[0];
    F x = f_add(f_iota(), f_set(r->x0 + (float)first)), half = f_set(r->threshold[0]);
    F sum[3] = {f_set(r->emission[0]), f_set(r->emission[1]), f_set(r->emission[2])};
    struct value o = value_at(k, x);
    F square = square_of(q, x, &o), cosine = lambert_of(q, x, &o, square);
    M good = m_and(o.good, add_light(q, x, &o, sum, 3, 0));
    F y31 = f_fma(sum[0], f_set(31), half), y63 = f_fma(sum[1], f_set(63), half);

    for (int i = 0; i < N && first + i < r->count; i++) {
        if (!(m_bits(good) >> i & 1))
            continue;
        real at_x = x[i], s = o.s[i] / (real)f->seen.c;
        struct truth exact = truth_at(f, at_x);
        real whole = lambert(&f->light[0], at_x, &exact);
        use(&bounds[SQUARE], fabsl(square[i] / (s * s) / form(f->light[0].lamp->qq, f->light[0].q, at_x, &exact) - 1),
            f->light[0].bounds.square);
        try_level(LEVELS_31, (real)y31[i] - half[i], 31, r->near31, red, whole, cosine[i], f->light[0].bounds.lambert);
        try_level(LEVELS_63, (real)y63[i] - half[i], 63, r->near63, green, whole, cosine[i],
                  f->light[0].bounds.lambert);
    }
}

/* Checks S' at a sample where D is not below its cut; near the outline S' is largest. */
static void try_turn(const struct simd_fine *f, const struct simd_run *r, const struct cells *cells, int i)
{
    const double *d = f->seen.d;
    real x = f->place.low + i * SIMD_CELL, root = sqrtl(truth_at(f, x).depth);

    if (cells->at.d[i] >= r->cut)
        use(&bounds[TURN], fabsl(f->seen.b[1] + (d[1] + 2 * x * d[2]) / (2 * root)), cells->at.turn[i]);
}

/* Checks the motion of P = t v with t = c/S: t' = -t S'/S, t'' = t (2 (S'/S)^2 - S''/S). */
static void try_motion(const struct simd_fine *f, real x, real first, real second)
{
    const double *d = f->seen.d;
    struct truth o = truth_at(f, x);
    real sum = o.s * f->seen.c, root = sqrtl(o.depth), bend = (4 * (real)d[0] * d[2] - (real)d[1] * d[1]) / 4;
    real a = (f->seen.b[1] + (d[1] + 2 * x * d[2]) / (2 * root)) / sum, b = bend / (o.depth * root) / sum;
    real t = 1 / o.s, t1 = -t * a, t2 = t * (2 * a * a - b);
    real across = f->place.v1 / 2 + f->place.v2 * x, step = f->place.v2; /* v.v' and v'.v' */

    use(&bounds[FIRST], sqrtl(t1 * t1 * o.vv + 2 * t1 * t * across + t * t * step), first);
    use(&bounds[SECOND], sqrtl(t2 * t2 * o.vv + 4 * t2 * t1 * across + 4 * t1 * t1 * step), second);
}

static void try_pixel(const struct simd_fine *f, const struct simd_run *r, const struct cells *cells, int cell, int i)
{
    real x = f->place.low + cell * SIMD_CELL + i;
    struct truth o = truth_at(f, x);
    const struct simd_light *q = &r->light[0];
    const struct lines *lines = &cells->light[0];
    float at = (float)(i - HALF_CELL), costs = (r->near63 - cells->near63[cell]) / 63;
    float line = lines->middle[cell] + at * lines->turn_of[cell] + fabsf(at) * lines->bend_of[cell];
    real exact = lambert(&f->light[0], x, &o), off = fabsl(line - exact) - q->faint - SIMD_LINE * 0x1p-24L;

    CHECK(fabsf((r->near31 - cells->near31[cell]) / 31 - costs) < 0x1p-20f);
    off *= q->colour_most;
    if (costs > 0x1p-14f)
        use(&bounds[LINE], off > 0 ? off : 0, costs * (1 + 0x1p-8L));
    else
        CHECK(off <= 0x1p-13L);
    if (q->casts != 1 || exact < q->faint || q->cast[0].clear)
        return;
    bool said = lines->weight[0][cell] == 0 && q->colour[0] > 0;
    lit += !said;
    dark += said;
    if (q->colour[0] > 0)
        CHECK_MSG(is_dark(f, &f->light[0], x, &o) == said, "pixel %d of a %s cell is not", i, said ? "dark" : "lit");
}

static void try_cells(const struct simd_fine *f, const struct simd_run *r, struct cells *cells, int count)
{
    const struct body k = body_of(r);

    take_samples(r, &k, count + 1, r->lights, &cells->at, cells->light);
    judge_cells(r, &k, count, r->grey, r->lights, 2, cells);
    for (int i = 0; i <= count; i++)
        try_turn(f, r, cells, i);
    for (int cell = 0; cell < count; cell++) {
        float low = fminf(cells->at.d[cell], cells->at.d[cell + 1]);
        M good;
        if (!(cells->good >> cell & 1) || r->lights == 0)
            continue;
        flat += cells->flat >> cell & 1;
        struct motion motion = motion_over(r, &cells->at, cell, &good);
        for (int i = 0; i <= SIMD_CELL; i += 2) {
            real x = f->place.low + cell * SIMD_CELL + i;
            try_motion(f, x, motion.first[0], motion.second[0]);
            use(&bounds[SAG], fmaxl(low - truth_at(f, x).depth, 0), r->d_sag);
            if (r->lights == 1)
                try_pixel(f, r, cells, cell, i);
        }
    }
}

static void try_run(const struct simd_fine *run)
{
    static struct simd_fine fine;
    static struct simd_run r;
    static struct cells cells;
    struct simd_dither dither;
    int size = run->end - run->first, count = ((size < SIMD_BLOCK ? size : SIMD_BLOCK) - 1) / SIMD_CELL;

    fine = *run;
    if (!tia_simd_fine_bounds(&fine, NULL))
        return;
    tia_simd_dither(false, fine.row->y, &dither);
    tia_simd_run(&fine, &dither, &r);
    const struct body k = body_of(&r);
    bool free =
        run->view->light_count == 1 && r.lights == 1 && r.light[0].casts == 0 && fine.light[0].lamp->shades == 0;
    for (int i = 0; free && i < r.count; i += 5 * N)
        try_levels(&fine, &r, &k, i);
    if (count < 1)
        return;
    cells.at.start = 0;
    cells.at.x0 = r.x0;
    try_cells(&fine, &r, &cells, count);
}

/* Runs the built-in scene, which has shadows and large spheres. */
static void thesis(simd_runs_try *try)
{
    static const char *const keys[] = {"", "a", "d", "s", "w"};
    struct corpus_scene s;

    for (int k = 0; k < 5; k++) {
        CHECK_EQ(corpus_thesis(&s, keys[k], 640, 480), TIA_OK);
        simd_runs_scene(&s.scene, k & 1 ? 640 : 1280, k & 1 ? 480 : 720, try);
    }
}

/* Runs scenes with a ball whose centre is on the ground and a light at its side, or in it: on the ground inside the
 * ball, a shadow begins not at the ball's outline but at the plane across the direction of the light. */
static void sunk(simd_runs_try *try)
{
    struct corpus_scene s;

    for (int i = 0; i < 12; i++) {
        CHECK_EQ(corpus_thesis(&s, "a", 640, 480), TIA_OK);
        memcpy(s.spheres, s.scene.spheres, 2 * sizeof *s.spheres);
        s.scene.spheres = s.spheres;
        struct tia_sphere *ground = &s.spheres[0], *ball = &s.spheres[1];
        ground->radius = TIA_Q16(20);
        ground->centre = (struct tia_vec3){0, -ground->radius - TIA_Q16_ONE, s.scene.camera.eye.z - 30 * TIA_Q16_ONE};
        ball->centre = ground->centre;
        ball->centre.y += ground->radius;
        ball->centre.z += TIA_Q16(2);
        ball->radius = TIA_Q16(4);
        s.lights[0].centre = ball->centre;
        s.lights[0].centre.x += (i & 1 ? 1 : -1) * TIA_Q16(30);
        s.lights[0].centre.y += TIA_Q16(6) + i * TIA_Q16_ONE;
        s.lights[0].centre.z += (i % 3 - 1) * TIA_Q16(9);
        if (i > 9) { /* in the ball */
            s.lights[0].centre = ball->centre;
            s.lights[0].centre.x += (i - 10) * TIA_Q16(3);
            s.lights[0].centre.y += TIA_Q16(1);
        }
        simd_runs_scene(&s.scene, 640, 480, try);
    }
}

TEST(cells)
{
    simd_runs(1500, 12, try_run);
    thesis(try_run);
    sunk(try_run);
    check_tight(bounds, BOUNDS);
    printf("# %lu pixels in lit cells, %lu in dark ones; %lu flat cells\n", lit, dark, flat);
    CHECK(lit > 10000 && dark > 1000 && flat > 1000);
}

/* ---- stored bounds ---- */

static unsigned long own, kept_ones;

/* Checks that no stored bound is narrower than that of the run alone. */
static void no_less(const struct simd_fine *kept, const struct simd_fine *alone)
{
    const struct simd_depth *a = &kept->depth, *b = &alone->depth;

    CHECK(a->cut >= b->cut);
    if (a->cut > b->cut)
        return; /* it leaves out more pixels, so the other bounds are not comparable */
    CHECK(a->es >= b->es && a->et >= b->et && a->floor <= b->floor);
    CHECK(kept->near31 <= alone->near31 && kept->near63 <= alone->near63);
    CHECK(kept->lights == alone->lights);
    for (int l = 0; l < kept->lights; l++) {
        const struct simd_fine_light *p = &kept->light[l], *q = &alone->light[l];
        CHECK(p->bounds.lambert >= q->bounds.lambert && p->bounds.square >= q->bounds.square);
        CHECK(p->bounds.distance <= q->bounds.distance);
        for (int j = 0; j < p->lamp->casts; j++) {
            const struct simd_cast_bounds *m = &kept->cast[p->first + j].bounds, *n = &alone->cast[q->first + j].bounds;
            CHECK(m->a >= n->a && m->k >= n->k && m->w >= n->w);
        }
    }
}

static void try_kept(const struct simd_fine *run)
{
    static struct simd_fine kept, alone;
    static struct simd_bound_cache cache;
    static const struct tia_scene *scene;

    if (tia_simd_is_crowded(run->view, run->sphere))
        return; /* its bounds are not kept */
    if (scene != run->view->scene || run->row->y < 3)
        cache.known = false;
    scene = run->view->scene;
    kept = alone = *run;
    bool good = tia_simd_fine_bounds(&alone, NULL);
    CHECK(tia_simd_fine_bounds(&kept, &cache) == good || !good);
    if (!good)
        return;
    no_less(&kept, &alone);
    own++;
    kept_ones += kept.depth.es > alone.depth.es;
}

TEST(kept_bounds)
{
    simd_runs(1500, 12, try_kept);
    thesis(try_kept);
    printf("# %lu of %lu bounds are kept ones\n", kept_ones, own);
    CHECK(kept_ones > own / 4);
}

int main(void)
{
    float_mode_of_simd();
#if FLT_EVAL_METHOD == 0
    RUN(cells);
#endif
    RUN(kept_bounds);
    return check_status();
}
