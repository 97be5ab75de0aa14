/* material.h - materials and textures: the shading model (Whitted's, with Phong highlights).
 *
 * At a point P with the normal N towards the viewer, V the direction to the viewer and R its mirror
 * image 2(N.V)N - V, the colour is
 *
 *     emission + facing max(0, N.V)
 *       + the sum over the lights of T a E (colour texture max(0, N.L) + specular max(0, R.L)^exponent)
 *       + kr (the colour along R) + kt (the colour along the refracted ray)
 *
 * where E is the light's emission, a its attenuation, L the direction to it, and T the transmittance of the
 * objects in between. An ambient light adds colour texture E.
 *
 * Without `fresnel`, kr is mirror and kt is refraction. With it, kr is mirror + F refraction and kt is
 * (1 - F) refraction, where F is the reflectance by Fresnel's equations for unpolarised light. On total
 * internal reflection F = 1, with or without `fresnel`.
 *
 * N is the shading normal: interpolated on a mesh that has normals, elsewhere the geometric normal G. Where
 * the ray hits the back of the surface both are negated. Shadow rays and reflected rays start at P + 2^-13 G,
 * refracted rays at P - 2^-13 G, so that rounding cannot make them hit their own surface. A light gives
 * nothing where G.L <= 0 or N.L <= 0. Where an interpolated normal has N.V <= 0, F = 1. T is the product of
 * `transmission` over the objects that the shadow ray hits before the light, each counted once; a grid counts
 * with the first cell that the ray hits.
 *
 * A ray that hits a front side goes from the index of refraction 1 to the material's, one that hits a back
 * side from the material's to 1: media do not nest. A ray's throughput is the product of the kr and kt along
 * its path. A ray is not traced when its throughput is below 2^-16 in every channel, or after scene.depth
 * bounces. A ray that hits nothing sees the background. Only a sample's final colour is clamped; no
 * intermediate value exceeds 2^17.
 */
#ifndef TIA_MATERIAL_H
#define TIA_MATERIAL_H

#include <tia/vec.h>

#define TIA_EXPONENT_MAX TIA_Q16(10000)
#define TIA_INDEX_MIN TIA_Q16(0.25) /* of refraction */
#define TIA_INDEX_MAX TIA_Q16(4)

/* Every channel of a material's colours lies in [0, 1]. */
struct tia_material {
    struct tia_rgb colour;       /* diffuse reflectance (albedo) */
    struct tia_rgb transmission; /* filter for light on its way to other surfaces: black is opaque */
    struct tia_rgb emission;     /* glow; does not light other objects */
    struct tia_rgb specular;     /* of the Phong highlight */
    tia_q16 exponent;            /* of the highlight, 1..TIA_EXPONENT_MAX; ignored when specular is black */
    struct tia_rgb mirror;       /* reflectance of the mirrored ray */
    struct tia_rgb refraction;   /* transmittance of the ray refracted by Snell's law */
    tia_q16 index;               /* of refraction inside the object, TIA_INDEX_MIN..TIA_INDEX_MAX (outside it
                                    is 1); ignored when refraction is black */
    bool fresnel;
    struct tia_rgb facing; /* weight of the facing ratio N.V */
    uint32_t texture;      /* 0: none; n: the scene's texture n - 1 */
};

enum tia_texture_kind { TIA_CHECKER, TIA_IMAGE };

/* Multiplies a material's colour at repeat (u - offset), repeat (v - offset) of the surface coordinates u, v: see
 * shape.h. */
struct tia_texture {
    enum tia_texture_kind kind;
    tia_q16 repeat[2]; /* of u and v, TIA_Q16(1/1024)..TIA_Q16(1024) */
    tia_q16 offset[2]; /* where on the surface the texture's (0, 0) lies */

    /* TIA_CHECKER: cells of 1 x 1, cells[0] where floor(u) + floor(v) is even. Channels in [0, 1]. */
    struct tia_rgb cells[2];

    /* TIA_IMAGE: covers 1 x 1 and repeats, its first row at the top, v = 1. The centre of texel (x, y), counted from
     * the upper left, is at u = (x + 1/2)/width, v = 1 - (y + 1/2)/height. */
    bool bilinear;          /* false: nearest texel */
    uint16_t width, height; /* 1..TIA_TEXTURE_MAX */
    const uint8_t *texels;  /* red, green, blue; row by row; 255 is 1.0 */
};

#define TIA_TEXTURE_MAX 16384

#endif
