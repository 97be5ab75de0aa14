/* without_f64.h - replaces a test in double precision in a build without that core: it is skipped. */
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
