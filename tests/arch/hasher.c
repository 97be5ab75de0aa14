/* hasher.c - prints the checksums of tests/arch/frames.h: `hasher`, or, built with TIA_HAVE_F32, `hasher f32` for the
 * same frames in single precision. Needs nothing but the libraries, so that it is built for any machine. */
#include "frames.h"

static void print(void *ctx, const char *name, uint32_t crc)
{
    (void)ctx;
    printf("%s %08lx\n", name, (unsigned long)crc);
}

int main(int argc, char **argv)
{
    const struct tia_core *core = &tia_core_q16;

#ifdef TIA_HAVE_F32
    if (argc > 1 && !strcmp(argv[1], "f32"))
        core = &tia_core_f32;
#else
    (void)argc, (void)argv;
#endif
    frames_all(core, print, NULL);
    return 0;
}
