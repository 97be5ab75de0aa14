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

/* The remainder of a position below the last bit of Q16.16, in units of 2^-32; see struct tia_fine. */
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

/* Initialisers of a position, of a direction of length 1, and of a colour with channels from 0, black, to 1, white.
 * Each names its members or, in C++, its type, so that a position in place of a colour does not compile, nor the
 * reverse. */
#ifndef __cplusplus
#define TIA_VEC3(X, Y, Z)                                                                                              \
    {                                                                                                                  \
        .x = TIA_Q16(X), .y = TIA_Q16(Y), .z = TIA_Q16(Z)                                                              \
    }
#define TIA_DIR3(X, Y, Z)                                                                                              \
    {                                                                                                                  \
        .x = TIA_Q30(X), .y = TIA_Q30(Y), .z = TIA_Q30(Z)                                                              \
    }
#define TIA_RGB(R, G, B)                                                                                               \
    {                                                                                                                  \
        .r = TIA_Q30(R), .g = TIA_Q30(G), .b = TIA_Q30(B)                                                              \
    }
#else
#define TIA_VEC3(x, y, z) (tia_vec3{TIA_Q16(x), TIA_Q16(y), TIA_Q16(z)})
#define TIA_DIR3(x, y, z) (tia_dir3{TIA_Q30(x), TIA_Q30(y), TIA_Q30(z)})
#define TIA_RGB(r, g, b) (tia_rgb{TIA_Q30(r), TIA_Q30(g), TIA_Q30(b)})
#endif

#ifdef __cplusplus
}
#endif

#endif
