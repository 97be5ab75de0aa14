#include "library.h"

#include <dlfcn.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define LIBRARY "libassimp.so.5"

static const struct {
    const char *name;
    size_t offset;
} functions[] = {
    {"aiImportFileExWithProperties", offsetof(struct assimp_library, import)},
    {"aiGetErrorString", offsetof(struct assimp_library, error)},
    {"aiCreatePropertyStore", offsetof(struct assimp_library, create_properties)},
    {"aiSetImportPropertyInteger", offsetof(struct assimp_library, set_integer)},
    {"aiGetVersionMajor", offsetof(struct assimp_library, major)},
    {"aiGetVersionMinor", offsetof(struct assimp_library, minor)},
};

/* Copies the bytes of a pointer: ISO C has no conversion from data to function pointers, but POSIX guarantees the same
 * representation. */
bool assimp_load(struct assimp_library *library, const char **why)
{
    static char text[120];
    void *loaded = dlopen(LIBRARY, RTLD_NOW | RTLD_LOCAL);

    *why = "no " LIBRARY ", which reads such files (install libassimp5)";
    if (!loaded)
        return false;
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        void *symbol = dlsym(loaded, functions[i].name);
        *why = LIBRARY " lacks functions";
        if (!symbol)
            return false;
        memcpy((char *)library + functions[i].offset, &symbol, sizeof symbol);
    }
    /* structures grow from one minor version to the next */
    (void)snprintf(text, sizeof text, "libassimp is version %u.%u, expected " ASSIMP_VERSION, library->major(),
                   library->minor());
    *why = text;
    return strncmp(strstr(text, "expected ") + 9, strstr(text, "version ") + 8,
                   strcspn(strstr(text, "version ") + 8, ",")) == 0;
}
