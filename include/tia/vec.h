/* vec.h - vectors and colours of the public interface. */
#ifndef TIA_VEC_H
#define TIA_VEC_H

#include <tia/fixed.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A position or a displacement, Q16.16. Right-handed: +x right, +y up, the camera looks along -z. */
struct tia_vec3 {
    tia_q16 x, y, z;
};

/* More digits of a position, in units of 2^-32; see struct tia_fine. */
struct tia_fine_place {
    int16_t x, y, z;
};

/* A direction of length 1, Q2.30. */
struct tia_dir3 {
    tia_q30 x, y, z;
};

/* A linear colour, Q2.30 per channel; 1.0 is full intensity. */
struct tia_rgb {
    tia_q30 r, g, b;
};

#define TIA_VEC3(x, y, z)                                                                                              \
    {                                                                                                                  \
        TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)                                                                             \
    }
#define TIA_RGB(r, g, b)                                                                                               \
    {                                                                                                                  \
        TIA_Q30(r), TIA_Q30(g), TIA_Q30(b)                                                                             \
    }

#ifdef __cplusplus
}
#endif

#endif
