/* lights.c - the lights of a model.
 *
 * Formats differ in the unit of light, and often it is none: candela, watts, or 1 for white. So the lights of a file
 * keep their proportions, and together they bring LIGHT_ALL to the model's middle, as if nothing were in between.
 */
#include <math.h>

#include "convert.h"

#define LIGHT_ALL 0.8
#define LIGHT_SHADOWS 0.2 /* the ambient light of a file that has none */
#define LIGHTS_MOST 64

/* A light, with the factor that its emission is multiplied by on the way to the middle. */
struct shining {
    const struct aiLight *from;
    struct affine place;
    double at[3], distance; /* in the file's unit, from the middle */
    double colour[3], arrives;
};

static bool has_place(const struct shining *s)
{
    return s->from->mType == aiLightSource_POINT || s->from->mType == aiLightSource_SPOT ||
           s->from->mType == aiLightSource_AREA;
}

/* Returns what divides the light at the middle; 0: nothing does. */
static double divisor_of(const struct shining *s)
{
    double d = s->distance, sum = (double)s->from->mAttenuationConstant + (double)s->from->mAttenuationLinear * d +
                                  (double)s->from->mAttenuationQuadratic * d * d;
    bool whole =
        s->from->mAttenuationConstant >= 0 && s->from->mAttenuationLinear >= 0 && s->from->mAttenuationQuadratic >= 0;
    return has_place(s) && whole && sum > 0 && isfinite(sum) ? sum : 0;
}

static bool take(const struct convert *c, const struct aiLight *from, struct shining *s)
{
    const struct aiColor3D *colour = from->mType == aiLightSource_AMBIENT ? &from->mColorAmbient : &from->mColorDiffuse;
    double own[3] = {(double)from->mPosition.x, (double)from->mPosition.y, (double)from->mPosition.z}, to[3];

    *s = (struct shining){.from = from, .colour = {(double)colour->r, (double)colour->g, (double)colour->b}};
    (void)convert_node_place(c, &from->mName, &s->place);
    affine_point(&s->place, own, s->at);
    for (int i = 0; i < 3; i++)
        to[i] = s->at[i] - (c->box.min[i] / 2 + c->box.max[i] / 2);
    s->distance = vector_length(to);
    double divisor = divisor_of(s), most = fmax(s->colour[0], fmax(s->colour[1], s->colour[2]));
    s->arrives = divisor > 0 ? most / divisor : most;
    return s->arrives > 0 && isfinite(s->arrives) && fmin(s->colour[0], fmin(s->colour[1], s->colour[2])) >= 0 &&
           from->mType > aiLightSource_UNDEFINED && from->mType <= aiLightSource_AREA &&
           (!has_place(s) || convert_reaches(c, s->at));
}

/* Sets the attenuation, which is 1 at the middle. Its unit of length is the power of two below the distance, and at
 * least the file's. Factors that are too large for it are left out. */
static void set_attenuation(const struct convert *c, struct tia_light *light, const struct shining *s)
{
    double distance = ldexp(s->distance, c->bits - c->pack.header.scale_bits), divisor = divisor_of(s);

    if (!(divisor > 0) || !(distance > 0x1p-7))
        return;
    int bits = ilogb(distance) > 0 ? ilogb(distance) : 0;
    double by = s->distance / ldexp(distance, -bits);
    light->unit_bits = (int8_t)bits;
    light->constant = convert_fixed((double)s->from->mAttenuationConstant / divisor, TIA_Q16_ONE);
    light->linear = convert_fixed((double)s->from->mAttenuationLinear * by / divisor, TIA_Q16_ONE);
    light->quadratic = convert_fixed((double)s->from->mAttenuationQuadratic * by * by / divisor, TIA_Q16_ONE);
}

/* Sets the cone. The angles of glTF are from the axis, those of others from side to side. */
static void set_cone(const struct convert *c, struct tia_light *light, const struct aiLight *from)
{
    double degrees = 180 / acos(-1.0) / (convert_is_gltf(c) ? 1 : 2);
    double outer = fmin(90, fmax(1, (double)from->mAngleOuterCone * degrees));
    double inner = fmin(outer, fmax(0, (double)from->mAngleInnerCone * degrees));

    light->outer = convert_fixed(isfinite(outer) ? outer : 45, TIA_Q16_ONE);
    light->inner = convert_fixed(isfinite(inner) ? inner : 0, TIA_Q16_ONE);
}

static bool set_direction(struct tia_light *light, const struct shining *s)
{
    double own[3] = {(double)s->from->mDirection.x, (double)s->from->mDirection.y, (double)s->from->mDirection.z};
    double direction[3];

    affine_vector(&s->place, own, direction);
    if (!vector_normalise(direction))
        return false;
    light->direction = convert_direction(direction);
    return true;
}

/* Fills a light, with the emission times `by`. Returns false for one without a direction that needs it. */
static bool make(const struct convert *c, struct tia_light *light, const struct shining *s, double by)
{
    double divisor = divisor_of(s), colour[3];

    for (int i = 0; i < 3; i++)
        colour[i] = s->colour[i] * by / (divisor > 0 ? divisor : 1);
    light->emission = convert_colour(colour, 1.5);
    light->kind = s->from->mType == aiLightSource_DIRECTIONAL ? TIA_DIRECTIONAL_LIGHT
                  : s->from->mType == aiLightSource_AMBIENT   ? TIA_AMBIENT_LIGHT
                  : s->from->mType == aiLightSource_SPOT      ? TIA_SPOT_LIGHT
                                                              : TIA_POINT_LIGHT;
    if (has_place(s)) {
        light->centre = convert_place(c, s->at);
        set_attenuation(c, light, s);
    }
    if (tia_light_has(light->kind, TIA_LIGHT_CONE))
        set_cone(c, light, s->from);
    return !tia_light_has(light->kind, TIA_LIGHT_DIRECTION) || set_direction(light, s);
}

/* Adds the lights of the file. */
static void add_lights(struct convert *c, struct pack_array *lights, unsigned count, double by, bool *ambient)
{
    for (unsigned i = 0; i < count; i++) {
        struct shining s;
        struct tia_light *light = take(c, c->from->mLights[i], &s) ? pack_grow(lights, 1) : NULL;
        if (light && !make(c, light, &s, by))
            lights->count--;
        else if (light)
            *ambient = *ambient || tia_light_has(light->kind, TIA_LIGHT_EVERYWHERE);
    }
}

/* Adds the lights of a model that has none, or the ambient light of one that has others. */
static bool add_missing(struct pack_array *lights, bool ambient)
{
    bool none = lights->count == 0;
    struct tia_light *more = none || !ambient ? pack_grow(lights, none ? TIA_MODEL_LIGHTS : 1) : NULL;

    if (more && none)
        (void)tia_model_view((struct tia_vec3){0, 0, 0}, TIA_Q16_ONE, more);
    else if (more)
        *more = (struct tia_light){.emission = TIA_RGB(LIGHT_SHADOWS, LIGHT_SHADOWS, LIGHT_SHADOWS),
                                   .kind = TIA_AMBIENT_LIGHT};
    return more || (!none && ambient);
}

bool convert_lights(struct convert *c)
{
    struct pack_array *lights = &c->pack.arrays[MODEL_LIGHTS];
    unsigned count = c->from->mNumLights < LIGHTS_MOST ? c->from->mNumLights : LIGHTS_MOST;
    struct shining s;
    double sum = 0;
    bool ambient = false;

    for (unsigned i = 0; i < count; i++)
        sum += take(c, c->from->mLights[i], &s) ? s.arrives : 0;
    if (sum > 0 && isfinite(sum))
        add_lights(c, lights, count, LIGHT_ALL / sum, &ambient);
    return add_missing(lights, ambient);
}
