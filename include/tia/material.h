/* material.h - what surfaces look like.
 *
 * At a point P with the normal N towards the viewer, V the direction to the viewer and R its mirror
 * image 2(N.V)N - V:
 *
 *     emission + facing max(0, N.V)
 *       + the sum over the lights of T a E (colour texture max(0, N.L) + specular max(0, R.L)^exponent)
 *       + kr (what is seen along R) + kt (what is seen along the refracted ray)
 *
 * with the light's emission E, its attenuation a, the transmission T of what stands before it, and L
 * the direction to it. An ambient light adds colour texture E. Without `fresnel` kr is mirror and kt is
 * refraction. With it, F being the fraction that Fresnel's equations for unpolarised light reflect, kr
 * is mirror + F refraction and kt (1 - F) refraction: F of what would enter is reflected instead. Total
 * internal reflection is F = 1, with or without `fresnel`.
 *
 * N is the shading normal: a mesh's interpolated one, else the geometric one, G; where the ray meets the
 * back of the surface both are turned. Shadow rays and reflected rays start at P + 2^-13 G, refracted rays
 * at P - 2^-13 G, whatever their direction. A light gives nothing where G.L <= 0 or N.L <= 0. Where an
 * interpolated normal has N.V <= 0, F = 1 with or without `fresnel`. T is the product of `transmission`
 * over the objects that the shadow ray meets before the light, each taken once, a grid by the first cell
 * that it meets.
 *
 * A ray that meets a front goes from the index 1 to the material's, one that meets a back from the
 * material's to 1: media do not nest. A ray's weight is the product of the kr and kt that led to it; below
 * 2^-16 in every channel it is not traced, nor when it was reflected or refracted scene.depth times
 * already. What meets nothing sees the background. Only the sum, the colour of a sample, is clamped; no
 * product or sum on the way to it exceeds 2^17.
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
    struct tia_rgb transmission; /* what a shadow ray keeps on its way through: black is opaque */
    struct tia_rgb emission;     /* added to what the surface reflects; lights nothing else */
    struct tia_rgb specular;     /* Phong's highlight */
    tia_q16 exponent;            /* of the highlight, 1..TIA_EXPONENT_MAX; with black specular anything */
    struct tia_rgb mirror;       /* what is reflected */
    struct tia_rgb refraction;   /* what is let through, bent by Snell's law */
    tia_q16 index;               /* of refraction inside the object, TIA_INDEX_MIN..TIA_INDEX_MAX; 1 outside
                                    of all objects; with black refraction anything */
    bool fresnel;
    struct tia_rgb facing; /* weight of the facing ratio */
    uint32_t texture;      /* 0: none; n: the scene's texture n - 1 */
};

enum tia_texture_kind { TIA_CHECKER, TIA_IMAGE };

/* Multiplies a material's colour. u and v, see shape.h, are first multiplied by `repeat`. */
struct tia_texture {
    enum tia_texture_kind kind;
    tia_q16 repeat[2]; /* of u and v, TIA_Q16(1/1024)..TIA_Q16(1024) */

    /* A checker's cells are 1 x 1: where floor(u) + floor(v) is even the first colour, each in [0, 1]. */
    struct tia_rgb cells[2];

    /* An image covers 1 x 1 and repeats: texel (x, y), from the upper left, is centred on u = (x +
     * 1/2)/width, v = (y + 1/2)/height. */
    bool bilinear;          /* else the nearest texel */
    uint16_t width, height; /* 1..TIA_TEXTURE_MAX */
    const uint8_t *texels;  /* red, green, blue; row by row; 255 is 1.0 */
};

#define TIA_TEXTURE_MAX 16384

#endif
