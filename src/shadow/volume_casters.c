#include "volume_casters.h"

/* Bits of a role: the face's side of the light plus one, whether a part of its object begins with it, and which of its
 * sides are part of the silhouette. */
#define ROLE_SIDE 3
#define ROLE_LIT 2
#define ROLE_BEGINS 4
#define ROLE_SILHOUETTE_SHIFT 3
#define ROLE_SILHOUETTE ((1u << TIA_SIDES) - 1)

int tia_shadow_side(const struct tia_flat_scene *flat, uint32_t face, struct tia_shadow_light light)
{
    return light.roles ? (light.roles[face] & ROLE_SIDE) - 1 : tia_flat_side(flat, &flat->faces[face], light.at);
}

/* Returns the sides of face f that are part of the object's silhouette. */
static unsigned silhouette_of(const struct tia_flat_scene *flat, uint32_t f, bool closed, struct tia_shadow_light light)
{
    unsigned sides = tia_face_sides(&flat->faces[f]), silhouette = 0;

    for (unsigned k = 0; k < sides; k++) {
        uint32_t other = flat->across[TIA_SIDES * f + k];
        silhouette |= (unsigned)(!closed || tia_shadow_side(flat, other / TIA_SIDES, light) <= 0) << k;
    }
    return silhouette;
}

/* Sets the rest of *c and returns true if face f casts a shadow. Faces of closed objects cast one only when turned to
 * the light. */
static bool casts(const struct tia_flat_scene *flat, uint32_t f, struct tia_shadow_light light,
                  struct tia_volume_caster *c)
{
    int side = tia_shadow_side(flat, f, light);

    if (side == 0 || (c->closed && side < 0))
        return false;
    c->face = &flat->faces[f];
    c->sides = tia_face_sides(c->face);
    c->turned = side < 0;
    c->silhouette = light.roles ? light.roles[f] >> ROLE_SILHOUETTE_SHIFT & ROLE_SILHOUETTE
                                : silhouette_of(flat, f, c->closed, light);
    return true;
}

int tia_volume_casters(const struct tia_flat_scene *flat, struct tia_shadow_light light, bool silhouettes,
                       tia_caster_function *call, void *ctx, struct cancel *cancel)
{
    int status = TIA_OK;

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
            if (casts(flat, f, light, &c) && (c.silhouette || !silhouettes))
                status = call(ctx, &c, f);
        }
    }
    return status;
}

/* ---- roles ---- */

/* Keeps the silhouette of a closed object, and its parts: one begins behind all neighbours of the faces before. */
static void keep_silhouette(uint8_t *roles, const struct tia_flat_scene *flat, const struct tia_flat_object *object,
                            struct cancel *cancel)
{
    uint32_t first = object->first_face, last = first;

    for (uint32_t f = first; f < first + object->face_count && !cancelled(cancel, 1); f++) {
        bool is_lit = (roles[f] & ROLE_SIDE) == ROLE_LIT;
        unsigned role = f > last ? ROLE_BEGINS : 0;
        for (unsigned k = 0; k < tia_face_sides(&flat->faces[f]); k++) {
            uint32_t other = flat->across[TIA_SIDES * f + k] / TIA_SIDES;
            last = other > last ? other : last;
            role |= (unsigned)(is_lit && (roles[other] & ROLE_SIDE) != ROLE_LIT) << (ROLE_SILHOUETTE_SHIFT + k);
        }
        roles[f] = (uint8_t)(roles[f] | role);
    }
}

/* Keeps the sides of an object whose faces cast volumes of their own: all of them. */
static void keep_all_sides(uint8_t *roles, const struct tia_flat_scene *flat, const struct tia_flat_object *object)
{
    for (uint32_t n = 0, f = object->first_face; n < object->face_count; n++, f++)
        roles[f] |= (uint8_t)(((1u << tia_face_sides(&flat->faces[f])) - 1) << ROLE_SILHOUETTE_SHIFT);
}

int tia_shadow_keep_roles(uint8_t *roles, const struct tia_flat_scene *flat, const tia_flat_light *light,
                          struct cancel *cancel)
{
    for (uint32_t f = 0; f < flat->face_count && !cancelled(cancel, 1); f++)
        roles[f] = (uint8_t)(tia_flat_side(flat, &flat->faces[f], light) + 1);
    for (uint32_t i = 0; i < flat->object_count && !cancel->stopped; i++) {
        const struct tia_flat_object *object = &flat->objects[i];
        if (tia_flat_has_silhouette(flat, object, light))
            keep_silhouette(roles, flat, object, cancel);
        else
            keep_all_sides(roles, flat, object);
    }
    return cancel->stopped ? TIA_STOPPED : TIA_OK;
}
