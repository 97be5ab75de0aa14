/* lights.c - lights in double precision, and the upper limit of rays' colours. */
#include "bounds.h"
#include "math/trig.h"

static void set_area(struct sure_light *to, const struct ray_light *l)
{
    for (int i = 0; i < 2; i++) {
        if (tia_light_has(l->kind, TIA_LIGHT_SIDES))
            sure_point(to->axes[i], l->side[i]);
        else
            sure_dir(to->axes[i], l->axes[i]);
        sure_dir(to->across[i], l->across[i]);
        to->reach[i] = __builtin_fabs(sure_length(num_point_dot(l->side[i], l->across[i])));
    }
}

static void set_light(struct sure_light *to, const struct ray_light *l)
{
    to->from = l;
    to->radius = sure_length(l->radius);
    for (int c = 0; c < 3; c++)
        to->emission[c] = sure_length(l->emission[c]);
    to->brightest = sure_most3(to->emission);
    sure_point(to->at, l->centre);
    sure_dir(to->normal, l->direction);
    to->seen = ray_light_is_seen(l);
    to->inner = sure_cosine(l->inner);
    to->outer = sure_cosine(l->outer);
    to->constant = sure_length(l->constant);
    to->linear = sure_length(l->linear);
    to->quadratic = sure_length(l->quadratic);
    to->unit = sure_cosine(l->unit);
    if (tia_light_has(l->kind, TIA_LIGHT_AREA))
        set_area(to, l);
}

/* Returns the four bits of i in reverse order. */
static unsigned mirrored(unsigned i)
{
    return (i & 1) << 3 | (i & 2) << 1 | (i & 4) >> 1 | (i & 8) >> 3;
}

static double sine(unsigned v)
{
    unsigned place = v & 63;
    double s = sure_cosine(tia_sines[v & 64 ? 64 - place : place]);

    return v & 128 ? -s : s;
}

void tia_sure_place(const struct sure_light *l, unsigned i, unsigned class, double at[2])
{
    unsigned n = l->from->samples;
    double u = (double)((32 * i + 16 + 2 * n * class) % (32 * n)) / (32 * n);
    unsigned v = (16 * mirrored(i & 15) + mirrored(i >> 4) + 16 * mirrored(class)) & 255;

    if (tia_light_has(l->from->kind, TIA_LIGHT_SIDES)) {
        at[0] = u * 2 - 1;
        at[1] = ((double)v - 128) / 128;
        return;
    }
    double r = l->radius * __builtin_sqrt(u);
    at[0] = r * sine(v + 64);
    at[1] = r * sine(v);
}

/* Sets the positions of a light's samples along its axes. Those behind the last sample are 0, since they are read for
 * unused lanes. */
static void set_places(struct sure_light *l, double (*places)[2][SURE_PLACES])
{
    l->place = NULL;
    if (!places || !tia_light_has(l->from->kind, TIA_LIGHT_AREA) || l->from->samples > SURE_PLACES)
        return;
    for (unsigned class = 0; class < 16; class ++)
        for (unsigned i = 0; i < SURE_PLACES; i++) {
            double at[2] = {0, 0};
            if (i < l->from->samples)
                tia_sure_place(l, i, class, at);
            places[class][0][i] = at[0];
            places[class][1][i] = at[1];
        }
    l->place = places;
}

/* Upper limits over all surfaces: `own`, of emitted light and of the light reflected from lights; `back`, of the part
 * of a reflected or refracted ray's light that a surface passes on. */
struct brightness {
    double own, back;
    bool refracts;
};

static struct brightness brightness_of(const struct sure_scene *s)
{
    struct brightness most = {sure_most3(s->background), 0, false};
    double light = 0;

    for (uint32_t i = 0; i < s->light_count; i++) {
        const struct sure_light *l = &s->lights[i];
        double seen = l->brightest;
        light += l->from->fades && l->constant > 0 ? seen / l->constant : seen;
        most.own = seen > most.own ? seen : most.own;
    }
    for (uint32_t i = 0; i < s->view->scene->material_count; i++) {
        const struct sure_material *m = &s->materials[i];
        const double *c = m->column;
        double reflects = sure_most3(c + SURE_COLOUR) + sure_most3(c + SURE_SPECULAR);
        double own = sure_most3(c + SURE_EMISSION) + sure_most3(c + SURE_FACING) + light * reflects;
        double back = sure_most3(c + SURE_MIRROR) + sure_most3(c + SURE_REFRACTION);
        most.own = own > most.own ? own : most.own;
        most.back = back > most.back ? back : most.back;
        most.refracts = most.refracts || m->refracts || !m->known;
    }
    return most;
}

/* Sets the upper limits of rays' colours, for each number of bounces. A ray's colour is at most the sum of own back^n
 * over the ray's generations n: one for each bounce that is left and, where a material refracts or transmits, up to
 * TIA_LAYERS_MAX more. There is no limit if attenuation may make a light brighter, or if `back` is above 1 where
 * materials refract. */
static void set_brightest(struct sure_scene *s)
{
    struct brightness most = brightness_of(s);
    double sum = 0, part = 1, layers = most.refracts ? TIA_LAYERS_MAX : 0;

    s->generations = s->depth + 1 + layers;
    for (double i = 1; i <= s->generations; i++) {
        sum += part * most.own;
        part *= most.back;
        if (i > layers)
            s->brightest[(uint32_t)(s->generations - i)] = BOUND(BRIGHTEST) * sum + BOUND(BRIGHTEST_UNITS);
    }
    if (most.refracts && most.back > 1)
        s->generations = 0;
    for (uint32_t i = 0; i < s->light_count; i++)
        if (s->lights[i].from->fades && !(s->lights[i].constant > 0))
            s->generations = 0;
}

void tia_sure_set_lights(struct tia_view *view)
{
    struct sure_scene *s = tia_sure_scene(view);

    s->light_count = s->view->light_count;
    s->areas = s->occluded = false;
    s->fixed_only = s->view->scene->fog || s->view->scene->lens;
    for (uint32_t i = 0; i < s->light_count; i++) {
        set_light(&s->lights[i], &s->view->lights[i]);
        enum tia_light_kind kind = s->view->lights[i].kind;
        s->areas = s->areas || tia_light_has(kind, TIA_LIGHT_AREA);
        s->occluded = s->occluded || (tia_light_has(kind, TIA_LIGHT_EVERYWHERE) && s->lights[i].radius > 0);
        s->fixed_only = s->fixed_only || !tia_light_has(kind, TIA_LIGHT_SIMD);
        set_places(&s->lights[i], i < SURE_AREAS ? s->places[i] : NULL);
    }
    set_brightest(s);
}
