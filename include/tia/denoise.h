/* denoise.h - removes noise from a picture of samples: an edge-avoiding a-trous wavelet (Dammertz et al. 2010), guided
 * by the surface that each pixel sees and by the standard error of its mean (the spatial part of Schied et al. 2017),
 * in integers.
 *
 *     sums, guides --tia_denoise_put--> pixels  --tia_denoise_pass, TIA_DENOISE_PASSES times--> pixels
 *     pixels --tia_denoise_get--> sums of the picture without the noise
 *
 * All three take tiles, which may have any size and come in any order, from several threads at once: the bits are the
 * same. Each step must finish the whole picture before the next begins, and take each pixel once.
 *
 * Light is divided by albedo, so that textures stay sharp, and multiplied by it again at the end. Pass n (0, 1, 2)
 * replaces each pixel p by the mean of 5x5 pixels q, 2^n apart, with the weights
 *
 *     h(p, q) max(0, N(p).N(q))^8 2^-x,
 *     x = |z(q) - z(p) - z'(p).(q - p)|/(max |z'(p)| |p - q|_1/8 + z(p)/512) + 4 |a(p) - a(q)|_1
 *         + |l(p) - l(q)|/(3 s(p))
 *
 * where h is the outer product of (1 4 6 4 1), N the normal, z the depth and z' its slopes from pixel to pixel, a the
 * albedo, l the luminance of the divided light and s its standard error, over 3x3 pixels; each pass updates it as the
 * standard error of a weighted mean.
 *
 * Weights that depend on the light favour pixels that noise has made similar: of many dark samples and a few bright
 * ones the bright are left out, and the mean falls. So the light that three such passes have removed from each pixel is
 * averaged by three more, whose weights lack the last term of x, and added: the mean of a surface stays.
 */
#ifndef TIA_DENOISE_H
#define TIA_DENOISE_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_DENOISE_PASSES 6

struct tia_denoiser; /* in the caller's memory */

/* Returns the bytes for a picture: 68 a pixel and a few; SIZE_MAX when there are too many. */
size_t tia_denoise_size(unsigned width, unsigned height);

/* Creates a denoiser in `memory`, aligned for uint64_t; every pixel is black until it is put in. TIA_ERR_ARGUMENT for
 * sizes that are not 1..TIA_SIZE_MAX, TIA_ERR_MEMORY when `size` is too small. */
int tia_denoise_init(struct tia_denoiser **denoiser, void *memory, size_t size, unsigned width, unsigned height);

/* Puts in the sums, guides and squares of `count` samples (1..TIA_SPP_MAX) of each pixel of the tile. TIA_ERR_ARGUMENT
 * when the tile is not inside the picture, here and below, and when one of the three is NULL. */
int tia_denoise_put(struct tia_denoiser *denoiser, struct tia_tile tile, const struct tia_gathered *gathered,
                    uint32_t count);

/* Runs pass 0, 1, ... of TIA_DENOISE_PASSES. */
int tia_denoise_pass(struct tia_denoiser *denoiser, unsigned pass, struct tia_tile tile);

/* Gives the sums that `count` samples without noise would have; `pitch` sums from row to row. */
int tia_denoise_get(const struct tia_denoiser *denoiser, struct tia_tile tile, uint32_t count, struct tia_sum *sums,
                    size_t pitch);

/* ---- pictures of a denoiser's guides ---- */

/* The guides' means, normals as (N + 1)/2, and the standard error of the luminance. */
enum tia_shown_guide { TIA_SHOW_NOTHING, TIA_SHOW_NORMAL, TIA_SHOW_DEPTH, TIA_SHOW_ALBEDO, TIA_SHOW_ERROR };

/* Returns "normal", "depth", "albedo", "error"; NULL for others. */
const char *tia_shown_guide_name(unsigned shown);

/* Returns the sum that `count` samples would have if they showed that guide of the pixel with the index `at` in
 * `gathered`, the albedo for other guides. 0 where sums or guides, or squares for the error, are NULL, or the count is
 * not in 1..TIA_SPP_MAX. */
struct tia_sum tia_guide_shown(enum tia_shown_guide shown, const struct tia_gathered *gathered, size_t at,
                               uint32_t count);

/* Returns the estimated standard error of a pixel's mean luminance (red + 2 green + blue)/4, in units of 2^-16, from
 * the spread of its samples; for one sample, that luminance, for none 0. Sobol points are more even than random ones,
 * so the estimate tends to be too large. */
uint32_t tia_standard_error(const struct tia_sum *sum, uint64_t squares, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif
