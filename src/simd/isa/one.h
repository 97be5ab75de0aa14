/* one.h - any processor: one double. */
#ifndef TIA_SIMD_ISA_ONE_H
#define TIA_SIMD_ISA_ONE_H

#include <stdint.h>

#include "isa.h"

#define LANES 1
typedef double vd;
typedef int64_t vi;
typedef unsigned vm; /* 0 or 1 */
LANE_OP vd vset(double x)
{
    return x;
}
LANE_OP vd vsqrt(vd a)
{
    return __builtin_sqrt(a);
}
LANE_OP vd vabs(vd a)
{
    return __builtin_fabs(a);
}
LANE_OP vd vmin(vd a, vd b)
{
    return a < b ? a : b;
}
LANE_OP vd vmax(vd a, vd b)
{
    return a > b ? a : b;
}
LANE_OP vm vlt(vd a, vd b)
{
    return a < b;
}
LANE_OP vm vle(vd a, vd b)
{
    return a <= b;
}
LANE_OP vd vsel(vm m, vd a, vd b)
{
    return m ? a : b;
}
LANE_OP vm mand(vm a, vm b)
{
    return a & b;
}
LANE_OP vm mor(vm a, vm b)
{
    return a | b;
}
LANE_OP vm mnot(vm a)
{
    return a ^ 1;
}
LANE_OP unsigned mbits(vm m)
{
    return m;
}
LANE_OP vm mof(unsigned bits)
{
    return bits & 1;
}

typedef float vp __attribute__((vector_size(8)));
LANE_OP vp vp_set(float x)
{
    return (vp){x, x};
}
LANE_OP vp vp_of(vd a)
{
    return vp_set((float)a);
}
LANE_OP vp vp_load(const float *p)
{
    return (vp){p[0], p[1]};
}
LANE_OP vp vp_min(vp a, vp b)
{
    return (vp){a[0] < b[0] ? a[0] : b[0], a[1] < b[1] ? a[1] : b[1]};
}
LANE_OP vp vp_max(vp a, vp b)
{
    return (vp){a[0] > b[0] ? a[0] : b[0], a[1] > b[1] ? a[1] : b[1]};
}
LANE_OP unsigned vp_le(vp a, vp b)
{
    return (unsigned)(a[0] <= b[0]) | (unsigned)(a[1] <= b[1]) << 1;
}
LANE_OP vp vp_swap(vp a)
{
    return (vp){a[1], a[0]};
}

#endif
