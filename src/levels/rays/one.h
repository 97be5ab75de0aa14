/* one.h - one double: any processor. */
#include "lanes.h"

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

#include "tracer.h"
