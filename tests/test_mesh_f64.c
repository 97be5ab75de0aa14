/* Meshes in double precision. */
#ifdef TIA_HAVE_F64
#define TIA_NUM_F64
#include "mesh_cases.h"
#else
#include "check.h"

TEST(double_precision)
{
    SKIP("built without it");
}

int main(void)
{
    RUN(double_precision);
    return check_status();
}
#endif
