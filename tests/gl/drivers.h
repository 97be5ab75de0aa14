/* drivers.h - tests beside Mesa's software drivers. */
#ifndef TESTS_GL_DRIVERS_H
#define TESTS_GL_DRIVERS_H

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "gl/raster.h"
#include "ports.h"

/* NULL: the case is skipped, for the driver is not there. */
static inline struct gl_raster *gl_opened(const char *driver, unsigned width, unsigned height)
{
    static char why[PORT_WHY];
    struct gl_raster *gl = gl_raster_open("osmesa", width, height, why);

    if (!gl)
        SKIP("%s", why);
    else if (!strstr(gl_raster_driver(), driver)) {
        SKIP("OSMesa draws with %s, not with %s (install libosmesa6)", gl_raster_driver(), driver);
        gl_raster_close(gl);
        return NULL;
    }
    return gl;
}

/* Each driver has a process of its own, which must have chosen it before the library is loaded. */
static inline int gl_in_process(const char *driver, void (*run)(void))
{
    int status = 1;

    (void)fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        (void)setenv("GALLIUM_DRIVER", driver, 1);
        (void)setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        run();
        (void)fflush(stdout);
        _exit(check_status());
    }
    if (child < 0 || waitpid(child, &status, 0) != child || status)
        return 1;
    return 0;
}

#endif
