/* simd_frames_all.h - a scene's frame by each instruction set that this processor has. */
#ifndef TESTS_SIMD_FRAMES_ALL_H
#define TESTS_SIMD_FRAMES_ALL_H

#include <tia/simd.h>

#include "check.h"
#include "simd/simd.h"
#include "simd_frames.h"

/* Checks that each instruction set that this processor has draws the scene as plain C does. */
static inline void simd_frames_check_all(const struct tia_scene *scene, unsigned width, unsigned height,
                                         unsigned number)
{
    const struct tia_simd *simd;

    for (unsigned n = 0; (simd = tia_simd_at(n)); n++) {
        struct simd_frames f;
        CHECK(simd_frames_open(&f, simd, scene, width, height));
        CHECK_MSG(simd_frames_differ(&f, true, false) == 0, "%s, scene %u: %s", simd->name, number,
                  simd_frames_where(&f));
        simd_frames_close(&f);
    }
}

#endif
