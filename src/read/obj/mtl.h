/* mtl.h - a material whose statements are being read; see mtl.c. */
#ifndef TIA_READ_OBJ_MTL_H
#define TIA_READ_OBJ_MTL_H

#include "obj.h"

struct mtl {
    struct obj *obj;
    struct tia_text text;
    bool open;
    struct tia_rgb kd, ks, ke, tf;
    tia_q30 opacity;
    bool has_d, has_tr, has_filter;
    tia_q16 exponent, index;
    int64_t illum;
    uint32_t texture, opacity_texture;
    struct tia_text opacity_text; /* the text from the number of d or Tr on */
    struct tia_word opacity_word; /* that number */
};

/* mtl_map.c */
int tia_mtl_map_kd(struct mtl *m);
int tia_mtl_map_d(struct mtl *m);

#endif
