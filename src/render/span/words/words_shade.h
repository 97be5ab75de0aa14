/* words_shade.h - words.h for span_shade.h. */
#ifndef TIA_RENDER_SPAN_WORDS_WORDS_SHADE_H
#define TIA_RENDER_SPAN_WORDS_WORDS_SHADE_H

#include "render/span/span_shading.h"

/* Adds all lights. */
void words_lights(struct span_shading *s);

/* Adds a light's cosines, of which a part in each channel is `product`; false if the kernels are to do it. */
bool words_add(struct span_shading *s, const num_u *lambert, const struct tia_light *light, const num_u product[3]);

#endif
