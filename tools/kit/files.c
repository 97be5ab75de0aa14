/* files.c - the files of a scene, from the program that calls the kit: WebAssembly imports its two functions, and a
 * shared library gets their addresses by kit_set_files. tools/web/whole_file.c calls them. */
#include "kit.h"
#include "web/web.h"

#ifdef __wasm__
#define HOST(name) __attribute__((import_module("host"), import_name(name)))
HOST("file_size") int32_t host_file_size(const char *name, uint32_t length);
HOST("file_read") void host_file_read(const char *name, uint32_t length, void *bytes);
#else
static int32_t (*host_file_size)(const char *name, uint32_t length);
static void (*host_file_read)(const char *name, uint32_t length, void *bytes);

void kit_set_files(int32_t (*size)(const char *name, uint32_t length),
                   void (*read)(const char *name, uint32_t length, void *bytes))
{
    host_file_size = size;
    host_file_read = read;
}
#endif

int32_t web_file_size(const char *name, uint32_t length)
{
    return host_file_size(name, length);
}

void web_file_read(const char *name, uint32_t length, void *bytes)
{
    host_file_read(name, length, bytes);
}
