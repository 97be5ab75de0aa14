/* drivers.h - tests against Mesa's software drivers. */
#ifndef TESTS_GL_DRIVERS_H
#define TESTS_GL_DRIVERS_H

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"
#include "gl/gl_raster.h"
#include "ports.h"

/* Opens OSMesa with a driver; returns NULL, and skips the case, if the driver is missing. */
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

/* Runs a case in a process of its own, since the driver must be chosen before the library is loaded. `before` is the
 * status of the process before, 0 for the first. Returns the exit status; 2: neither process has a case of the chosen
 * name. */
static inline int gl_in_process(const char *driver, void (*run)(void), int before)
{
    int status = 1;

    (void)fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        (void)setenv("GALLIUM_DRIVER", driver, 1);
        (void)setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        run();
        (void)fflush(stdout);
        if (!check_failures && check_asked[0] && !check_found && before != 2)
            _exit(2);
        _exit(check_status());
    }
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return 1;
    return WEXITSTATUS(status);
}

/* Runs a test with both drivers; returns its status. */
static inline int gl_in_both(void (*by_llvmpipe)(void), void (*by_softpipe)(void))
{
    int first = gl_in_process("llvmpipe", by_llvmpipe, 0), second = gl_in_process("softpipe", by_softpipe, first);

    if (first == 1 || second == 1)
        return 1;
    return first && second ? 2 : 0;
}

#endif
