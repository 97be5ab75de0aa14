/* choices.h - the words of options that several commands have, each in the order of its enumeration. */
#ifndef TOOLS_COMMON_CHOICES_H
#define TOOLS_COMMON_CHOICES_H

#define IMAGE_FORMATS "png|ppm|bmp|565|y4m|tiapart|pfm"                       /* enum image_format from IMAGE_PNG */
#define SCENE_FORMATS "tia|nff|obj"                                           /* enum tia_format */
#define SHADOW_TECHNIQUES "traced|rays|zpass|zfail|map|map-exact|zpass-plain" /* enum tia_shadows */

#endif
