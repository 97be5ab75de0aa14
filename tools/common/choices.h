/* choices.h - the arguments of options that several commands have; words are in the order of their enumeration. */
#ifndef TOOLS_COMMON_CHOICES_H
#define TOOLS_COMMON_CHOICES_H

#define IMAGE_FORMATS "png|ppm|bmp|565|y4m|tiapart|pfm|exr"                   /* enum image_format from IMAGE_PNG */
#define SCENE_FORMATS "tia|nff|obj|stl|ply|off|pgm"                           /* enum tia_format */
#define SHADOW_TECHNIQUES "traced|rays|zpass|zfail|map|map-exact|zpass-plain" /* enum tia_shadows */

#define LENTICULAR_KEYS "pitch=50.2,slope=-7.1,center=0.3 and ,subpixels=rgb|bgr|none ,flip ,invert"
#define MODULES_KEYS "M[,distance=D,spacing=L]"

#endif
