#include "cpu.h"

#include <stdio.h>
#include <string.h>

/* Copies what follows the colon of the first line of /proc/cpuinfo that begins with `key`. */
static int find(const char *key, char *name, size_t size)
{
    FILE *file = fopen("/proc/cpuinfo", "re");
    char line[512];
    size_t length = strlen(key);
    int found = 0;

    while (file && !found && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        found = strncmp(line, key, length) == 0 &&
                (line[length] == '\t' || line[length] == ' ' || line[length] == ':') && colon;
        if (found)
            (void)snprintf(name, size, "%.*s", (int)strcspn(colon + 1, "\n"), colon + 1);
    }
    if (file)
        (void)fclose(file);
    return found;
}

static int find_board(char *name, size_t size)
{
    FILE *file = fopen("/proc/device-tree/model", "re");
    int found = file && fgets(name, (int)size, file);

    if (file)
        (void)fclose(file);
    return found;
}

void benchmark_cpu(char *name, size_t size)
{
    /* x86; ARM and RISC-V boards; MIPS; POWER */
    if (find("model name", name, size) || find_board(name, size) || find("cpu model", name, size) ||
        find("cpu", name, size))
        return;
    (void)snprintf(name, size, "unknown");
}
