#include "volume_casters.h"

#define KNOWN_SIDES 256

/* Bits of a role: the face's side of the light plus one, whether a part of its object begins with it, and which of its
 * sides are part of the silhouette. */
#define ROLE_SIDE 3
#define ROLE_BEGINS 4
#define ROLE_SILHOUETTE_SHIFT 3
#define ROLE_SILHOUETTE ((1u << TIA_SIDES) - 1)

/* Sides of the light that were computed last: neighbours of a face ask for them again. */
struct known_sides {
    struct tia_shadow_light light;
    uint32_t face[KNOWN_SIDES];
    int8_t side[KNOWN_SIDES];
};

static void known_sides_init(struct known_sides *known, struct tia_shadow_light light)
{
    known->light = light;
    for (int i = 0; i < KNOWN_SIDES && !light.roles; i++)
        known->face[i] = TIA_NO_FACE;
}

/* Returns tia_flat_side() of face f. */
static int known_side(struct known_sides *known, const struct tia_flat_scene *flat, uint32_t f)
{
    uint32_t at = f % KNOWN_SIDES;

    if (known->light.roles)
        return tia_shadow_side(flat, f, known->light);
    if (known->face[at] != f) {
        known->face[at] = f;
        known->side[at] = (int8_t)tia_flat_side(flat, &flat->faces[f], known->light.at);
    }
    return known->side[at];
}

/* Returns the sides of face f that are part of the object's silhouette. */
static unsigned silhouette_of(const struct tia_flat_scene *flat, uint32_t f, bool closed, struct known_sides *known)
{
    unsigned sides = tia_face_sides(&flat->faces[f]), silhouette = 0;

    for (unsigned k = 0; k < sides; k++) {
        uint32_t other = flat->across[TIA_SIDES * f + k];
        silhouette |= (unsigned)(!closed || known_side(known, flat, other / TIA_SIDES) <= 0) << k;
    }
    return silhouette;
}

/* Sets the rest of *c and returns true if face f casts a shadow. Faces of closed objects cast one only when turned to
 * the light. */
static bool casts(const struct tia_flat_scene *flat, uint32_t f, struct known_sides *known, struct tia_volume_caster *c)
{
    const uint8_t *kept = known->light.roles;
    int side = known_side(known, flat, f);

    if (side == 0 || (c->closed && side < 0))
        return false;
    c->face = &flat->faces[f];
    c->sides = tia_face_sides(c->face);
    c->turned = side < 0;
    c->silhouette =
        kept ? kept[f] >> ROLE_SILHOUETTE_SHIFT & ROLE_SILHOUETTE : silhouette_of(flat, f, c->closed, known);
    return true;
}

int tia_volume_casters(const struct tia_flat_scene *flat, struct tia_shadow_light light, bool silhouettes,
                       tia_caster_function *call, void *ctx, struct cancel *cancel)
{
    struct known_sides known;
    int status = TIA_OK;

    known_sides_init(&known, light);
    for (uint32_t i = 0; i < flat->object_count; i++) {
        const struct tia_flat_object *object = &flat->objects[i];
        struct tia_volume_caster c = {.part = object->first_face,
                                      .closed = tia_flat_has_silhouette(flat, object, light.at)};
        if (tia_flat_hides_nothing(flat, object, light.at))
            continue;
        for (uint32_t n = 0, f = object->first_face; !status && n < object->face_count; n++, f++) {
            if (cancelled(cancel, 1))
                return TIA_STOPPED;
            c.part = light.roles && (light.roles[f] & ROLE_BEGINS) ? f : c.part;
            if (silhouettes && light.roles && !(light.roles[f] >> ROLE_SILHOUETTE_SHIFT))
                continue;
            if (casts(flat, f, &known, &c) && (c.silhouette || !silhouettes))
                status = call(ctx, &c, f);
        }
    }
    return status;
}

/* ---- roles ---- */

/* Returns the last of the neighbours of face f. */
static uint32_t last_neighbour(const struct tia_flat_scene *flat, uint32_t f)
{
    uint32_t last = 0;

    for (unsigned k = 0; k < tia_face_sides(&flat->faces[f]); k++) {
        uint32_t other = flat->across[TIA_SIDES * f + k] / TIA_SIDES;
        last = other > last ? other : last;
    }
    return last;
}

/* Keeps the silhouette of a closed object, and its parts: one begins behind all neighbours of the faces before. */
static void keep_silhouette(uint8_t *roles, const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            struct known_sides *known, struct cancel *cancel)
{
    uint32_t first = object->first_face, last = first;

    for (uint32_t f = first; f < first + object->face_count && !cancelled(cancel, 1); f++) {
        uint32_t neighbour = last_neighbour(flat, f);
        roles[f] |= f > last ? ROLE_BEGINS : 0;
        last = neighbour > last ? neighbour : last;
        if (known_side(known, flat, f) > 0)
            roles[f] |= (uint8_t)(silhouette_of(flat, f, true, known) << ROLE_SILHOUETTE_SHIFT);
    }
}

/* Keeps the casters of an object whose faces cast volumes of their own. */
static void keep_all_sides(uint8_t *roles, const struct tia_flat_scene *flat, const struct tia_flat_object *object)
{
    for (uint32_t n = 0, f = object->first_face; n < object->face_count; n++, f++)
        roles[f] |= (uint8_t)(((1u << tia_face_sides(&flat->faces[f])) - 1) << ROLE_SILHOUETTE_SHIFT);
}

int tia_shadow_keep_roles(uint8_t *roles, const struct tia_flat_scene *flat, const tia_flat_light *light,
                          struct cancel *cancel)
{
    struct known_sides known;

    for (uint32_t f = 0; f < flat->face_count && !cancelled(cancel, 1); f++)
        roles[f] = (uint8_t)(tia_flat_side(flat, &flat->faces[f], light) + 1);
    known_sides_init(&known, (struct tia_shadow_light){light, roles});
    for (uint32_t i = 0; i < flat->object_count && !cancel->stopped; i++) {
        const struct tia_flat_object *object = &flat->objects[i];
        if (tia_flat_has_silhouette(flat, object, light))
            keep_silhouette(roles, flat, object, &known, cancel);
        else
            keep_all_sides(roles, flat, object);
    }
    return cancel->stopped ? TIA_STOPPED : TIA_OK;
}

int tia_shadow_side(const struct tia_flat_scene *flat, uint32_t face, struct tia_shadow_light light)
{
    return light.roles ? (light.roles[face] & ROLE_SIDE) - 1 : tia_flat_side(flat, &flat->faces[face], light.at);
}
