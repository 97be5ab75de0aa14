/* integrator.h - integrators of the light along a ray, and the conversion of their sums to pixels.
 *
 * TIA_WHITTED is tia/material.h's model. The others estimate a mean: each pixel is the mean of `spp` samples, and a
 * sample is a function of the scene, the pixel and its number alone. A sample's radiance is clamped to 0..2^14 and
 * rounded once, to 2^-24, and samples are added in 64 bits. So a picture does not depend on the order, the place or the
 * parts in which its samples are drawn: the sums of samples a..b and of b..c are those of a..c, exactly.
 *
 * TIA_OCCLUSION shows the openness of a point: the share of rays from it that meet no object up to a distance. These
 * rays start at a pixel's visible point, their directions have the density cos t/pi around its normal N; those below
 * the surface meet it. Where a pixel shows no object it is 1.
 *
 * TIA_PATHS follows light along random paths (Kajiya, "The rendering equation", 1986). Of tia/material.h it takes
 *   - colour and texture: Lambert's law; specular: Phong's lobe specular (n + 2)/(2 pi) cos^n, normalised (Lafortune
 * and Willems 1994);
 *   - mirror, refraction, index, fresnel, opacity and media as they are; where a ray meets several, chance decides;
 *   - emission, 2^emission_bits times, and facing: radiance, to both sides of a surface. transmission is
 * ignored. The background is radiance from everywhere. Rectangle, disc and sphere lights are surfaces of the radiance
 * emission 2^emission_bits to all sides, without attenuation, which absorb what meets them. Point, spot and directional
 * lights light as in light.h; where they have a radius, only the eye sees it, directly or by mirrors and refraction.
 * Ambient lights, which stand for paths, are ignored.
 *
 * At each diffuse or glossy point one light or emitting sphere of the scene is chosen, all with the same chance, and a
 * point of it (of spheres within the cone that they fill, else evenly on the surface); and the path goes on by one of
 * the material's lobes. The two are combined by the balance heuristic (Veach 1997). Other emitting shapes are met by
 * chance. From the fourth bounce on paths end by roulette, at the latest after TIA_BOUNCES_MAX.
 *
 * Samples draw Owen-scrambled Sobol points, src/samples/sobol.h: a pixel's first numbers are its place in the pixel,
 * without a filter, and the first direction. Rays start 2^-26 off a surface.
 * */
#ifndef TIA_INTEGRATOR_H
#define TIA_INTEGRATOR_H

#include <tia/fixed.h>

#ifdef __cplusplus
extern "C" {
#endif

enum tia_integrator { TIA_WHITTED, TIA_OCCLUSION, TIA_PATHS };

/* Returns "whitted", "ao", "path"; NULL beyond the last. */
const char *tia_integrator_name(unsigned integrator);

/* The conversion of radiance to a pixel's value, 0..1: linear, or by the transfer function of sRGB, IEC 61966-2-1. */
enum tia_tone {
    TIA_TONE_DEFAULT, /* TIA_TONE_SRGB for TIA_PATHS, else TIA_TONE_LINEAR */
    TIA_TONE_LINEAR,
    TIA_TONE_SRGB
};

/* Returns "linear" and "srgb" for TIA_TONE_LINEAR and TIA_TONE_SRGB; NULL for others. */
const char *tia_tone_name(unsigned tone);

#define TIA_SPP_DEFAULT 16 /* samples per pixel */
#define TIA_SPP_MAX (UINT32_C(1) << 24)
#define TIA_BOUNCES_MAX 1024
#define TIA_EXPOSURE_MAX TIA_Q16(24)

/* A path's strategies for finding lights: with one alone, pictures have the same mean and more noise. */
enum tia_strategy { TIA_STRATEGY_NONE, TIA_STRATEGY_LIGHTS, TIA_STRATEGY_SCATTERING };

/* A scene's integrator. All zero: Whitted's, which ignores the other fields. */
struct tia_integration {
    enum tia_integrator integrator;
    uint32_t spp;     /* samples per pixel, 1..TIA_SPP_MAX; 0 means TIA_SPP_DEFAULT */
    uint32_t seed;    /* seed of the random samples */
    uint16_t bounces; /* TIA_PATHS: the maximum, 1..TIA_BOUNCES_MAX; 0 means TIA_BOUNCES_MAX */
    uint16_t without; /* TIA_PATHS, for comparison: the enum tia_strategy to leave out */
    tia_q16 distance; /* TIA_OCCLUSION: farther objects do not count; 0: all count */
    enum tia_tone tone;
    tia_q16 exposure; /* pixels show 2^exposure times the radiance: -TIA_EXPOSURE_MAX..TIA_EXPOSURE_MAX */
};

/* A pixel's samples, added up: red, green and blue in units of 2^-24. */
struct tia_sum {
    int64_t rgb[3];
};

/* The first surface that a pixel's samples meet, past mirrors and glass, added up like them. It guides a denoiser, see
 * denoise.h.
 * */
struct tia_guide {
    int64_t normal[3]; /* unit normal on the visible side, 2^-24; 0 for the background */
    int64_t depth;     /* path length to it, 2^-16; 0 for the background */
    int64_t albedo[3]; /* reflectance, all lobes together, plus the emission of it or of a light there; 2^-24 */
};

/* The arrays to which samples are added. */
struct tia_gathered {
    struct tia_sum *sums;
    struct tia_guide *guides; /* or NULL */
    uint64_t *squares;        /* or NULL: the squares of (red + 2 green + blue)/4, in units of 2^-32, up to 2^64 - 1 */
    size_t pitch;             /* elements from one row of the tile to the next, in each of them */
};

struct tia_view;
struct tia_tile;
struct tia_surface;

/* A sampling integrator in one arithmetic, for the views of its core; of others' TIA_ERR_ARGUMENT. */
struct tia_estimator {
    const char *name; /* name of the core whose views it accepts */

    /* Adds samples first..end - 1 of each pixel of the tile to its sum, row by row, the next row `pitch` sums on.
     * TIA_ERR_UNSUPPORTED: the scene is drawn by an integrator without samples. TIA_ERR_ARGUMENT when the tile is not
     * inside the image, first is beyond end, or end beyond TIA_SPP_MAX. TIA_STOPPED: see tia/job.h; the sums are not
     * defined.
     */
    int (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end, struct tia_sum *sums,
                  size_t pitch);

    /* Adds samples as `sample` does, and gathers their guides and squares. */
    int (*gather)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                  const struct tia_gathered *gathered);

    /* Returns the opaque object that encloses light number `light` of the view, but not the eye, so that the light
     * reaches nothing else; TIA_NO_OBJECT: none, no such light, or a scene without samples. Decided by 14 rays from the
     * light.
     */
    uint32_t (*enclosing)(const struct tia_view *view, uint32_t light);

    /* Writes the pixels of a row, a tile of height 1, from their sums of `count` samples each, 1..TIA_SPP_MAX. With all
     * samples of the scene they are those of tia_view_light. Errors as for `sample`. */
    int (*show)(const struct tia_view *view, struct tia_tile row, const struct tia_sum *sums, uint32_t count,
                const struct tia_surface *surface, bool dither);
};

extern const struct tia_estimator tia_estimator_q16;
extern const struct tia_estimator tia_estimator_f64; /* the estimator for tia_core_f64 */

#ifdef __cplusplus
}
#endif

#endif
