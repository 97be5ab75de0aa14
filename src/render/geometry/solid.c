/* solid.c - solids: members combined by an expression.
 *
 * The line of a ray is inside each member along chords. A word has a bit for each member that the ray is inside of; the
 * solid's expression of these bits tells whether the ray is inside the solid. At the ray's start the bits are those of
 * the members whose chords have begun, so that they agree with the crossings that follow. Then the crossings are taken
 * in their order along the ray, until the expression changes.
 *
 * Only each member's next chord is kept. Crossings within CLOSE of the first one are taken together: where surfaces
 * coincide, roundings would else leave slivers between them. An intersection's element is 64 times the member's own,
 * plus 32 if the member's normal is turned round, plus the member's number. */
#include "scene/solid.h"
#include "instance.h"
#include "math/noinline.h"

#define CLOSE (NUM_LENGTH_BIAS / 8) /* 2^-16, a unit of the scene's coordinates */

#define TURNED TIA_SOLID_MEMBERS /* the bit of a turned normal in an element */

/* A place on the line of a ray, between two crossings. */
struct passage {
    const struct prepared_solid *solid;
    const struct ray *ray;
    uint32_t inside, left; /* bits of the members that the ray is inside of, and that it has yet to leave */
    num_length enter[TIA_SOLID_MEMBERS]; /* the next chord of each member in `left` */
    num_length leave[TIA_SOLID_MEMBERS];
};

/* Finds a chord of a member, as `chord` of struct shape_kind does. */
NOINLINE static bool member_chord(const struct shape *member, const struct ray *ray, num_length after,
                                  struct chord *chord)
{
    struct instance_ray placed;

    if (!member->instance)
        return member->kind->chord(member, ray, after, chord);
    instance_transform_ray(member->instance, ray, &placed);
    if (placed.start > NUM_LENGTH_MAX)
        return false;
    num_length left = after > placed.start ? instance_distance(&placed, after) : -NUM_LENGTH_LEAST;
    do { /* `left` is rounded, so it may be before the end of the last chord */
        if (!member->kind->chord(member, &placed.ray, left, chord))
            return false;
        left = chord->leave.t;
        chord->leave.t = instance_distance_back(&placed, left);
    } while (chord->leave.t <= after);
    if (chord->enter.t >= 0 || placed.start > 0)
        chord->enter.t = instance_distance_back(&placed, chord->enter.t > 0 ? chord->enter.t : 0);
    return true;
}

/* Finds the next chord of member i, which ends beyond `after`. */
static void take_chord(struct passage *p, uint32_t i, num_length after)
{
    struct chord chord;
    bool found = member_chord(&p->solid->members[i], p->ray, after, &chord) && chord.leave.t > after;

    p->enter[i] = found ? chord.enter.t : 0;
    p->leave[i] = found ? chord.leave.t : 0;
    p->left = (p->left & ~(UINT32_C(1) << i)) | (uint32_t)found << i;
}

static void begin(struct passage *p)
{
    uint32_t count = p->solid->solid->member_count;

    ray_tested(p->ray, count);
    p->inside = p->left = 0;
    for (uint32_t i = 0; i < count; i++) {
        take_chord(p, i, -NUM_LENGTH_LEAST);
        p->inside |= (uint32_t)(p->enter[i] < 0) << i;
    }
}

#define NEVER (NUM_LENGTH_MAX + NUM_LENGTH_ONE)

/* Returns the t of a member's next crossing, or NEVER. */
static num_length next_of(const struct passage *p, uint32_t i)
{
    if (!(p->left >> i & 1))
        return NEVER;
    return p->inside >> i & 1 ? p->leave[i] : p->enter[i];
}

/* Returns the t of the next crossing, or NEVER. */
static num_length nearest(const struct passage *p)
{
    num_length t = NEVER;

    for (uint32_t i = 0; i < p->solid->solid->member_count; i++) {
        num_length next = next_of(p, i);
        t = next < t ? next : t;
    }
    return t;
}

/* Takes all crossings up to t = `until`. */
static void pass(struct passage *p, num_length until)
{
    for (uint32_t i = 0; i < p->solid->solid->member_count; i++)
        while (next_of(p, i) <= until) {
            p->inside ^= UINT32_C(1) << i;
            if (!(p->inside >> i & 1))
                take_chord(p, i, p->leave[i]);
        }
}

/* Returns the member whose surface it is where the bits change from `before` to `after`, and so does the expression
 * from `was`: the first that changes it alone or, if there is none, the first that changes. */
static uint32_t member_at(const struct tia_solid *solid, uint32_t before, uint32_t after, bool was)
{
    uint32_t changed = before ^ after, first = TIA_SOLID_MEMBERS;

    for (uint32_t i = solid->member_count; i-- > 0;)
        if (changed >> i & 1)
            first = i;
    for (uint32_t i = first; i < solid->member_count; i++)
        if ((changed >> i & 1) && tia_solid_holds(solid, before ^ UINT32_C(1) << i) != was)
            return i;
    return first;
}

/* Gives the crossing of member i at `t` or up to CLOSE beyond. */
static void set_crossing(const struct passage *p, uint32_t i, num_length t, bool is_in,
                         struct intersection *intersection)
{
    bool enters = p->inside >> i & 1;
    num_length after = t > CLOSE ? t - CLOSE : -NUM_LENGTH_LEAST;
    struct chord chord = {{t, 0}, {t, 0}};

    (void)member_chord(&p->solid->members[i], p->ray, after, &chord);
    const struct intersection *at = enters ? &chord.enter : &chord.leave;
    intersection->t = at->t;
    intersection->element = 2 * TIA_SOLID_MEMBERS * at->element + (enters == is_in ? 0 : TURNED) + i;
}

static bool intersect(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection)
{
    const struct tia_solid *solid = shape->solid.solid;
    struct passage p; /* not initialised, since it has many words */

    p.solid = &shape->solid;
    p.ray = ray;
    begin(&p);
    bool was = tia_solid_holds(solid, p.inside), is = was;
    while (is == was) {
        num_length t = nearest(&p);
        uint32_t before = p.inside;

        if (t > limit || t >= NUM_LENGTH_MAX)
            return false;
        pass(&p, t + CLOSE);
        is = tia_solid_holds(solid, p.inside);
        if (is != was)
            set_crossing(&p, member_at(solid, before, p.inside, was), t, is, intersection);
    }
    return intersection->t <= limit && intersection->t < NUM_LENGTH_MAX;
}

static void surface_at(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface)
{
    bool turned = element & TURNED;
    const struct shape *member = shape_part(shape, &element);
    const struct instance *instance = member->instance;

    member->kind->surface(member, instance ? instance_point(instance, point) : point, element, surface);
    if (instance)
        surface->normal = instance_normal(instance, surface->normal);
    if (turned)
        surface->normal = num_dir_negated(surface->normal);
    surface->smooth = surface->normal;
}

static void uv_at(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2])
{
    const struct shape *member = shape_part(shape, &element);

    member->kind->uv(member, member->instance ? instance_point(member->instance, point) : point, element, uv);
}

/* ray_prepare prepares the members, once for all shapes of a solid. */
static void prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given)
{
    shape->solid = (struct prepared_solid){&scene->solids[given->solid], NULL};
}

const struct shape *shape_part(const struct shape *shape, uint32_t *element)
{
    if (shape->kind != &SHAPE_KIND(solid))
        return shape;
    const struct shape *member = &shape->solid.members[*element % TIA_SOLID_MEMBERS];
    *element /= 2 * TIA_SOLID_MEMBERS;
    return member;
}

const struct shape_kind SHAPE_KIND(solid) = {prepare, intersect, shape_occludes, surface_at, uv_at, NULL};
