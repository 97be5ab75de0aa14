/* denoise.h - removes noise from a picture of samples: an edge-avoiding a-trous wavelet (Dammertz et al. 2010), guided
 * by the visible surface of each pixel and by the standard error of its mean (the spatial part of Schied et al. 2017),
 * in integers.
 *
 *     sums, guides --tia_denoise_put--> pixels  --tia_denoise_pass, TIA_DENOISE_PASSES times--> pixels
 *     pixels --tia_denoise_get--> sums of the picture without the noise
 *
 * All three functions process tiles, of any size, in any order and on several threads at once; the result is the same.
 * Each step must process each pixel of the picture once, and end before the next step begins.
 *
 * Light is divided by albedo, so that textures stay sharp, and multiplied by it again at the end. Pass n (0, 1, 2)
 * replaces each pixel p by the mean of 5x5 pixels q, 2^n apart, with the weights
 *
 *     h(p, q) max(0, N(p).N(q))^8 2^-x,
 *     x = |z(q) - z(p) - z'(p).(q - p)|/(max |z'(p)| |p - q|_1/8 + z(p)/512) + 4 |a(p) - a(q)|_1
 *         + |l(p) - l(q)|/(3 s(p))
 *
 * where h is the outer product of (1 4 6 4 1), N the normal, z the depth and z' its slopes from pixel to pixel, a the
 * albedo, l the luminance of the divided light and s the luminance's standard error, over 3x3 pixels; each pass updates
 * s as the standard error of a weighted mean.
 *
 * Weights that depend on the light favour pixels that noise has made similar: of many dark samples and a few bright
 * ones, the bright ones are left out, and the mean falls. So three more passes, whose weights lack the last term of x,
 * average the light that the first three have removed from each pixel. The average is added, so that a surface's mean
 * does not change.
 */
#ifndef TIA_DENOISE_H
#define TIA_DENOISE_H

#include <tia/render.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_DENOISE_PASSES 6

struct tia_denoiser; /* in the caller's memory */

/* Returns the number of bytes for a picture: 68 a pixel and a small constant; SIZE_MAX when that number does not
 * fit. */
size_t tia_denoise_size(unsigned width, unsigned height);

/* Creates a denoiser in `memory`, aligned for uint64_t; every pixel is black until tia_denoise_put sets it.
 * TIA_ERR_ARGUMENT for sizes that are not 1..TIA_SIZE_MAX, TIA_ERR_MEMORY when `size` is too small. */
int tia_denoise_init(struct tia_denoiser **denoiser, void *memory, size_t size, unsigned width, unsigned height);

/* Sets the tile's pixels from the sums, guides and squares of `count` samples each, 1..TIA_SPP_MAX. TIA_ERR_ARGUMENT
 * when one of these arrays is NULL or, here and below, the tile is not inside the picture. */
int tia_denoise_put(struct tia_denoiser *denoiser, struct tia_tile tile, const struct tia_gathered *gathered,
                    uint32_t count);

/* Runs pass number `pass` on a tile; the passes are 0..TIA_DENOISE_PASSES - 1, in this order. */
int tia_denoise_pass(struct tia_denoiser *denoiser, unsigned pass, struct tia_tile tile);

/* Writes to `sums` the sums that `count` samples without noise would have; a row begins `pitch` sums after the one
 * before. */
int tia_denoise_get(const struct tia_denoiser *denoiser, struct tia_tile tile, uint32_t count, struct tia_sum *sums,
                    size_t pitch);

#ifdef __cplusplus
}
#endif

#endif
