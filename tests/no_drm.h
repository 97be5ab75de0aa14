/* no_drm.h - the main program of a test of the DRM display in a build without libdrm. */
#ifndef TESTS_NO_DRM_H
#define TESTS_NO_DRM_H

#include "check.h"

TEST(drm)
{
    SKIP("built without libdrm (install libdrm-dev)");
}

int main(void)
{
    RUN(drm);
    return check_status();
}

#endif
