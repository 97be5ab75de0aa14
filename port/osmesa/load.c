/* load.c - loads functions from shared libraries at run time. */
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "device.h"
#include "gl.h"

int gl_fail(struct gl_screen *screen, int status, const char *format, ...)
{
    int n = snprintf(screen->why, PORT_WHY, "osmesa:%s: ", screen->platform->name);
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(screen->why + n, PORT_WHY - (size_t)n, format, arguments);
    va_end(arguments);
    return status;
}

/* A GL driver leaves threads, exit handlers and thread-local data behind, so unloading it would crash. RTLD_NODELETE
 * prevents unloading, so the handle need not be kept. */
void *gl_library(struct gl_screen *screen, const char *file, const char *package)
{
    void *library = dlopen(file, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);

    if (!library) {
        const char *reason = dlerror();
        (void)gl_fail(screen, TIA_ERR_DEVICE, "%s (install %s)", reason ? reason : file, package);
    }
    return library;
}

/* Copies the bytes of a pointer: ISO C has no conversion from data to function pointers, but POSIX guarantees the same
 * representation. */
bool gl_symbols(struct gl_screen *screen, void *library, void *table, const struct gl_row *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        void *symbol = dlsym(library, rows[i].name);
        if (!symbol) {
            (void)gl_fail(screen, TIA_ERR_UNSUPPORTED, "the library has no %s", rows[i].name);
            return false;
        }
        memcpy((char *)table + rows[i].offset, &symbol, sizeof symbol);
    }
    return true;
}

bool gl_load(struct gl_screen *screen, void *table, const struct gl_row *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        gl_proc proc = screen->platform->proc(screen, rows[i].name);
        if (!proc) {
            (void)gl_fail(screen, TIA_ERR_UNSUPPORTED, "GL has no %s", rows[i].name);
            return false;
        }
        memcpy((char *)table + rows[i].offset, &proc, sizeof proc);
    }
    return true;
}
