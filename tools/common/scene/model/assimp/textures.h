/* textures.h - the textures of a material. */
#ifndef TOOLS_SCENE_MODEL_ASSIMP_TEXTURES_H
#define TOOLS_SCENE_MODEL_ASSIMP_TEXTURES_H

#include "convert.h"

/* Finds the first property of that key and kind of texture; AI_TEXTURE_NONE for other properties. */
const struct aiMaterialProperty *property_of(const struct aiMaterial *from, const char *key,
                                             enum aiTextureType semantic);
#define AI_TEXTURE_NONE ((enum aiTextureType)0)

/* Copies the text of a property. Returns false without one. */
bool property_text(const struct aiMaterialProperty *property, char *to, size_t size);

/* Returns the material's texture of the first of two kinds that it has, as the number that struct tia_material has; 0:
 * none, or it cannot be read, which is a warning. If `opacities`, it is one of opacities: `channel` of the image, and
 * with a threshold above 0, 255 from there and 0 below. */
uint32_t texture_add(struct convert *c, const struct aiMaterial *from, const enum aiTextureType kinds[2],
                     bool opacities, enum tia_channel channel, double threshold);

/* Sets the mean of the texture's channels. Returns false without such a texture; if it cannot be read, the mean is
 * `otherwise`. */
bool texture_mean(struct convert *c, const struct aiMaterial *from, const enum aiTextureType kinds[2], double mean[3],
                  double otherwise);

/* Returns the set of texture coordinates that the material's colours use. */
unsigned texture_channel(const struct aiMaterial *from);

#endif
