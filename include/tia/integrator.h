/* integrator.h - integrators of the light along a ray, and the conversion of their sums to pixels.
 *
 * TIA_WHITTED is tia/material.h's model. The others estimate a mean: each pixel is the mean of `spp` samples, and a
 * sample depends only on the scene, the pixel and the sample's number. A sample's radiance is clamped to 0..2^14 and
 * rounded once, to 2^-24, and samples are added in 64 bits. So a picture does not depend on the order, the machine or
 * the parts in which its samples are drawn: the sums of samples a..b - 1 and of samples b..c - 1 add up exactly to
 * those of samples a..c - 1.
 *
 * TIA_OCCLUSION shows the openness of a point: the share of rays from that point that meet no object within a distance.
 * The rays start at the point that a pixel shows; their directions have the density cos t/pi around the normal N there.
 * Rays that point below the surface count as blocked. Where a pixel shows no object, the openness is 1.
 *
 * TIA_PATHS follows light along random paths (Kajiya, "The rendering equation", 1986). From tia/material.h it uses
 *   - colour and texture: Lambert's law; specular: Phong's lobe specular (n + 2)/(2 pi) cos^n, normalised (Lafortune
 *     and Willems 1994);
 *   - mirror, refraction, index, fresnel, opacity and media as they are; at a surface with several of these, one is
 *     chosen at random;
 *   - emission times 2^emission_bits, and facing: radiance that a surface emits to both sides.
 *
 * transmission is ignored. The background is radiance from all directions. Rectangle, disc and sphere lights are
 * surfaces that emit the radiance emission 2^emission_bits to all sides, without attenuation, and absorb the rays that
 * meet them. Point, spot and directional lights light surfaces as in light.h; if such a light has a surface, that is
 * visible only directly, or through mirrors and refraction. Ambient lights are ignored, since paths replace them.
 *
 * At each diffuse or glossy point one light or emitting sphere of the scene is chosen, each with the same probability,
 * and a point on it: on a sphere, within the cone of directions that it fills; else uniformly on the surface. The path
 * itself continues along one of the material's lobes. Both ways of reaching a light are combined by the balance
 * heuristic (Veach 1997). Other emitting shapes contribute only where a path happens to hit them. From the fourth
 * bounce on, paths end by Russian roulette, at the latest after the scene's largest number of bounces.
 *
 * Samples use Owen-scrambled Sobol points, see src/samples/sobol.h: a sample's first numbers determine its position in
 * the pixel, uniformly, and its first direction. Rays start 2^-26 off a surface.
 */
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

/* A path's strategies for finding lights: pictures with only one of them have the same mean, and more noise. */
enum tia_strategy { TIA_STRATEGY_NONE, TIA_STRATEGY_LIGHTS, TIA_STRATEGY_SCATTERING };

/* A scene's integrator. All zero: Whitted's, which ignores the other fields. */
struct tia_integration {
    enum tia_integrator integrator;
    uint32_t spp;     /* samples per pixel, 1..TIA_SPP_MAX; 0 means TIA_SPP_DEFAULT */
    uint32_t seed;    /* seed of the random samples */
    uint16_t bounces; /* TIA_PATHS: largest number of bounces, 1..TIA_BOUNCES_MAX; 0 means TIA_BOUNCES_MAX */
    uint16_t without; /* TIA_PATHS, for comparison: the enum tia_strategy to leave out */
    tia_q16 distance; /* TIA_OCCLUSION: length up to which objects count; 0: all count */
    enum tia_tone tone;
    tia_q16 exposure; /* pixels show 2^exposure times the radiance: -TIA_EXPOSURE_MAX..TIA_EXPOSURE_MAX */
};

/* A pixel's samples, added up: red, green and blue in units of 2^-24. */
struct tia_sum {
    int64_t rgb[3];
};

/* Properties of the first surface that each of a pixel's samples meets behind mirrors and glass, added up like the
 * samples. They guide a denoiser, see denoise.h. */
struct tia_guide {
    int64_t normal[3]; /* unit normal on the visible side, in units of 2^-24; 0 for the background */
    int64_t depth;     /* length of the path to the surface, in units of 2^-16; 0 for the background */
    int64_t albedo[3]; /* reflectance, all lobes together, plus the emission of the surface or of a light; in units of
                          2^-24 */
};

/* The arrays to which samples are added. */
struct tia_gathered {
    struct tia_sum *sums;
    struct tia_guide *guides; /* or NULL */
    uint64_t *squares;        /* or NULL: the squares of (red + 2 green + blue)/4, in units of 2^-32, up to 2^64 - 1 */
    size_t pitch;             /* elements from one row of the tile to the next, in each array */
};

struct tia_view;
struct tia_tile;
struct tia_surface;

/* A sampling integrator in one arithmetic, for the views of one core; its functions return TIA_ERR_ARGUMENT for the
 * views of other cores. */
struct tia_estimator {
    const char *name; /* name of the core whose views it accepts */

    /* Adds samples first..end - 1 of each pixel of the tile to the pixel's sum; a row of sums begins `pitch` sums after
     * the one before. TIA_ERR_UNSUPPORTED: the scene's integrator has no samples. TIA_ERR_ARGUMENT when the tile is not
     * inside the image, first is beyond end, or end beyond TIA_SPP_MAX. TIA_STOPPED: see tia/job.h; the sums are then
     * undefined.
     */
    int (*sample)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end, struct tia_sum *sums,
                  size_t pitch);

    /* Adds samples as `sample` does, and gathers their guides and squares. */
    int (*gather)(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                  const struct tia_gathered *gathered);

    /* Returns the opaque object that encloses light number `light` of the view, but not the eye, so that the light
     * reaches nothing else; TIA_NO_OBJECT: none, no such light, a scene without samples, or a view of
     * another core. The test consists of 14
     * rays from the light.
     */
    uint32_t (*enclosing)(const struct tia_view *view, uint32_t light);

    /* Writes the pixels of a row, a tile of height 1, from their sums of `count` samples each, 1..TIA_SPP_MAX. With all
     * of the scene's samples, the pixels are the same as by tia_view_light. Errors as for `sample`. */
    int (*show)(const struct tia_view *view, struct tia_tile row, const struct tia_sum *sums, uint32_t count,
                const struct tia_surface *surface, bool dither);
};

extern const struct tia_estimator tia_estimator_q16;
extern const struct tia_estimator tia_estimator_f64; /* the estimator for tia_core_f64 */

#ifdef __cplusplus
}
#endif

#endif
