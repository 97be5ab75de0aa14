/* corpus_rays.h - random scenes for the ray renderer, the same on every machine. */
#ifndef TOOLS_COMMON_CORPUS_CORPUS_RAYS_H
#define TOOLS_COMMON_CORPUS_CORPUS_RAYS_H

#include "corpus_parts.h"

/* Makes random scene number `index` of the series `seed`: 1 to 12 objects of any shape, many of them instances, on a
 * ground of any of four kinds or none; matt, textured, glossy, mirrors and glass; 1 to 4 lights of any kind; in one of
 * three scenes 2 to 10 more shapes that are within each other, overlap or stand behind each other, of glass of any
 * index or without refraction; any camera, 1, 4 or 16 samples a pixel; an image of 120x90 to 640x480. tia_scene_check
 * accepts all of them. */
void corpus_random_rays(struct corpus_rays *out, uint64_t seed, unsigned index);

/* Gives on average half of the materials of such a scene an opacity texture, with holes and half-transparent texels. */
void corpus_add_opacity(struct corpus_rays *out, uint64_t seed);

/* Makes about half of the textures of such a scene's colours noise. */
void corpus_add_noise(struct corpus_rays *out, uint64_t seed);

/* Gives on average half of the materials of such a scene a bump, of any of its textures. */
void corpus_add_bumps(struct corpus_rays *out, uint64_t seed);

/* Makes at most 6 of such a scene's shapes solids, of 1 to 7 members each: of random members, some with coinciding
 * faces, combined at random. */
void corpus_add_solids(struct corpus_rays *out, uint64_t seed);

/* Makes such a scene's discs tori and its boxes rounded ones. */
void corpus_add_rings(struct corpus_rays *out, uint64_t seed);

/* Gives such a scene fog, thin or thick; in half of all scenes with a height. */
void corpus_add_fog(struct corpus_rays *out, uint64_t seed);

#endif
