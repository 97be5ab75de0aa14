/* hasher.c - prints the checksums of tests/arch/frames.h: `hasher`, or `hasher f32` for the same
 * frames in single precision. Needs nothing but the libraries, so that it is built for any machine. */
#include "frames.h"

static void print(void *ctx, const char *name, uint32_t crc)
{
    (void)ctx;
    printf("%s %08lx\n", name, (unsigned long)crc);
}

int main(int argc, char **argv)
{
    frames_all(argc > 1 && !strcmp(argv[1], "f32") ? &tia_core_f32 : &tia_core_q16, print, NULL);
    return 0;
}
