/* without_f64.h - what a test in double precision is in a build without it. */
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
