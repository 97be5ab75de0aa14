/* shape_runs.h in fixed-point arithmetic that reports numbers out of range. */
#define TIA_NUM_CHK
#include "shape_runs.h"

void tia_chk_report(const char *file, int line, const char *range)
{
    CHECK_MSG(false, "%s:%d: %s", file, line, range);
}
