/* material.h - materials and textures: the shading model (Whitted's, with Phong highlights).
 *
 * At a point P with the normal N towards the viewer, V the direction to the viewer and R its mirror
 * image 2(N.V)N - V, the colour is
 *
 *     emission + facing max(0, N.V)
 *       + the sum over the lights of T a E (colour texture max(0, N.L) + specular max(0, R.L)^exponent)
 *       + kr (the colour along R) + kt (the colour along the refracted ray)
 *
 * where E is the light's emission, a its attenuation, L the direction to it, and T the transmittance of the objects in
 * between. An ambient light adds the product colour texture E.
 *
 * Without `fresnel`, kr is mirror and kt is refraction. With it, kr is mirror + F refraction and kt is
 * (1 - F) refraction, where F is the reflectance by Fresnel's equations for unpolarised light. On total
 * internal reflection F = 1, with or without `fresnel`.
 *
 * N is the shading normal: interpolated on a mesh that has normals, elsewhere the geometric normal G; a material's bump
 * perturbs it (Blinn, "Simulation of wrinkled surfaces", 1978) as if the surface were moved outwards by a height, the
 * value of the bump's texture times its depth: N - grad h, normalised. That value is 0 or 1 in a checker's even and odd
 * cells, with a ramp of a sixteenth of a cell on both sides of an edge; the mean of the channels of a picture, blended
 * bilinearly; the value of a noise, not clamped. Where N.V would be below 1/64, N is turned towards V until N.V is
 * 1/64, but not beyond the unperturbed normal. Where the ray hits the back of the surface both are negated. Shadow rays
 * and reflected rays start at P + b G, and refracted rays at P - b G, so that rounding cannot make them hit the surface
 * that they leave; b is 2^-13, or 2^-26 in scenes that have `fine`. A shadow ray ends exactly at the light's sample,
 * but in the span renderer b G beside it. A light contributes nothing where G.L <= 0 or N.L <= 0. Where an interpolated
 * normal has N.V <= 0, F = 1. T is the product of `transmission` over the objects that the shadow ray hits before the
 * light. Each object counts once, however often the ray hits it: a grid counts by the first cell hit, and a mesh that
 * has groups once for each group hit.
 *
 * An opacity texture makes parts of a surface invisible. Where its value at P is o, the colour is o times the one above
 * plus 1 - o times the colour seen behind the surface, along a ray that goes straight on from P - b V. Where the
 * refracted ray goes straight on as well, one ray with the factor o kt + 1 - o replaces the two. At each surface with
 * an opacity texture, a shadow ray is multiplied by o transmission + 1 - o, and continues at the distance b behind it;
 * T is 0 behind more than TIA_LAYERS_MAX such surfaces of one object. The cells of a grid without an opacity texture
 * count once, by the first one hit.
 *
 * Media nest. Each ray has a list of the objects that it has entered and not left, at most TIA_MEDIA_MAX; its
 * medium is the object entered last, or air of index 1 when the list is empty. Camera rays start with an empty
 * list, wherever the eye is. When a refracted ray hits
 *   - a front side, it goes from its medium to the material, and the object is added to the list; a grid
 *     that is on the list already is removed first;
 *   - a back side of the object entered last, it goes from the material to the medium before that one, and
 *     the object is removed;
 *   - a back side of an object entered earlier, it goes straight on, and the object is removed;
 *   - a back side of an object that is not on the list, it goes from the material to its medium.
 * A reflected ray keeps the list. Objects without an inside are never added: discs, triangles, cylinders and cones
 * without caps, and open meshes. A mesh is closed if for each edge of a face, from one corner to the next, a face has
 * the same edge in the opposite direction; corners are equal if their coordinates are. Nor is an object added where it
 * has an opacity texture, or to a full list. A ray that goes straight on behind an opacity texture has the list that a
 * refracted ray would have. A ray may miss one of two surfaces less than b apart, so objects that touch should overlap
 * instead.
 *
 * Where the indices of refraction on both sides are equal, F = 0 whatever N.V is, and the refracted ray goes straight
 * on from P - b V. Such surfaces, and those that a ray passes because of an opacity texture, are called layers: they do
 * not count as bounces, and a path may have TIA_LAYERS_MAX of them.
 *
 * A ray's throughput is the product of the kr and kt along its path. A ray is not traced when its throughput is below
 * 2^-16 in every channel, after scene.depth bounces or TIA_LAYERS_MAX layers, or when TIA_RAYS_MAX rays of its sample
 * have been traced, in the order of path_hash in debug.h (without layers a sample never has more). A ray that hits
 * nothing sees the background. Only a sample's final colour is clamped; no intermediate value exceeds 2^17.
 */
#ifndef TIA_MATERIAL_H
#define TIA_MATERIAL_H

#include <tia/vec.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_EXPONENT_MAX TIA_Q16(10000)
#define TIA_INDEX_MIN TIA_Q16(0.25) /* index of refraction */
#define TIA_INDEX_MAX TIA_Q16(4)
#define TIA_EMISSION_BITS_MAX 13
#define TIA_MEDIA_MAX 8                  /* entered objects in a ray's list */
#define TIA_LAYERS_MAX 256               /* layers in a path, see above */
#define TIA_RAYS_MAX (UINT32_C(1) << 17) /* rays of a sample, without shadow rays */

/* Every channel of a material's colours lies in [0, 1]. */
struct tia_material {
    struct tia_rgb colour;       /* diffuse reflectance (albedo) */
    struct tia_rgb transmission; /* factor of the light that passes through to other surfaces; black blocks it */
    struct tia_rgb emission;     /* glow; lights other objects only with TIA_PATHS */
    struct tia_rgb specular;     /* colour of the Phong highlight */
    tia_q16 exponent;            /* exponent of the highlight, 1..TIA_EXPONENT_MAX; ignored when specular is black */
    struct tia_rgb mirror;       /* reflectance of the mirrored ray */
    struct tia_rgb refraction;   /* transmittance of the ray refracted by Snell's law */
    /* Index of refraction inside the object, TIA_INDEX_MIN..TIA_INDEX_MAX (outside it is 1); ignored when refraction is
     * black. */
    tia_q16 index;
    bool fresnel;
    uint8_t emission_bits; /* TIA_PATHS: emission is 2^emission_bits times as large, 0..TIA_EMISSION_BITS_MAX */
    uint16_t bump;         /* 0: smooth; n: the scene's texture n - 1 is the height of the surface, see its `depth` */
    struct tia_rgb facing; /* weight of the facing ratio N.V */
    uint32_t texture;      /* texture of the colour. 0: none; n: the scene's texture n - 1, any but a TIA_OPACITY */
    uint32_t opacity;      /* 0: opaque; n: the scene's texture n - 1, of the kind TIA_OPACITY */
};

enum tia_texture_kind { TIA_CHECKER, TIA_IMAGE, TIA_OPACITY, TIA_NOISE };

#define TIA_TEXTURE_BITS_MIN (-8)
#define TIA_TEXTURE_BITS_MAX 12
#define TIA_OCTAVES_MAX 8
#define TIA_BUMP_MAX TIA_Q16(64)

/* A texture. Its value is taken at repeat (u - offset), repeat (v - offset) of the surface coordinates u, v: see
 * shape.h.
 *
 * TIA_NOISE fills space: it is taken at a point of the shape's own axes, before the transform, relative to the centre
 * for spheres, in the file's units. x and z are multiplied by repeat[0], y by repeat[1]; offset[0] is subtracted from x
 * before, offset[1] from y. At the point p
 *
 *     value = 1/2 + 3/4 sum_o 2^-o n_o(2^o p), clamped to 0..1, o = 0..octaves - 1
 *     colour = cells[0] + value (cells[1] - cells[0])
 *
 * where n_o is gradient noise after Perlin, "Improving noise" (2002), between -1.04 and 1.04, with the mean 0. The
 * eight corners c of the cube of integers around q contribute g_c.(q - c), blended along the axes by the fade
 * polynomial f(t) = t^3 (t (6 t - 15) + 10) of the position t in the cube. g_c is one of the twelve vectors from the
 * middle of a cube to the middles of its edges. Their permutation is an integer hash of c modulo 2^31 and o, modulo
 * 2^32:
 *
 *     h = 0x9e3779b1 c.x + 0x85ebca77 c.y + 0xc2b2ae3d c.z + 0x27d4eb2f o
 *     h = (h ^ h >> 16) 0x21f0aaad,  h = (h ^ h >> 15) 0x735a2d97,  h = h ^ h >> 15
 *     i = floor(12 floor(h / 2^16) / 2^16)
 *     g = (0, a, b) for i = 0..3, (a, 0, b) for 4..7, (a, b, 0) for 8..11; a = -1 if i is odd, b = -1 if i & 2, else 1
 */
struct tia_texture {
    enum tia_texture_kind kind;
    tia_q16 repeat[2]; /* repetitions per unit of u and v, times 2^-repeat_bits, TIA_Q16(1/1024)..INT32_MAX */
    tia_q16 offset[2]; /* position of the texture's (0, 0) on the surface, times 2^-offset_bits */

    /* TIA_CHECKER: cells of 1 x 1, cells[0] where floor(u) + floor(v) is even. TIA_NOISE: see above. Channels in
     * [0, 1]. */
    struct tia_rgb cells[2];

    /* TIA_IMAGE, TIA_OPACITY: covers 1 x 1 and repeats, its first row at the top, v = 1. The centre of texel (x, y),
     * counted from the upper left, is at u = (x + 1/2)/width, v = 1 - (y + 1/2)/height. */
    bool bilinear; /* false: nearest texel */

    /* Rays see the mean over the part of the surface that their sample stands for, instead of the value at a point: of
     * an image or opacity with `mip_levels`, of a noise, of a checker. Shadow rays, bumps, TIA_OCCLUSION, TIA_PATHS and
     * libraries made without footprints see the value at a point. */
    bool footprint;

    uint16_t width, height; /* 1..TIA_TEXTURE_MAX */
    const uint8_t *texels;  /* row by row: red, green, blue, or for TIA_OPACITY one byte; 255 is 1.0 */

    int8_t repeat_bits, offset_bits; /* TIA_TEXTURE_BITS_MIN..TIA_TEXTURE_BITS_MAX */

    uint8_t octaves; /* TIA_NOISE: 1..TIA_OCTAVES_MAX */

    /* As a material's bump: the height of the surface where the value is 1, above where it is 0, in the file's units,
     * -TIA_BUMP_MAX..TIA_BUMP_MAX. */
    tia_q16 depth;

    const uint8_t *mip_levels; /* TIA_IMAGE, TIA_OPACITY: NULL, or what tia_mip_build of mip.h has made */
};

#define TIA_TEXTURE_MAX 16384

#ifdef __cplusplus
}
#endif

#endif
