/* hasher.c - prints the checksums of tests/arch/frames.h: `hasher` or, built with TIA_HAVE_F32, `hasher f32` for the
 * same frames in single precision. `hasher sums FIRST END` prints those sums of samples instead, of occlusion and then
 * of paths. `hasher steps` prints the hashes of frames_steps.h. Built with HASHER_SIMD, the program draws with the
 * vector units named by TIA_SIMD, and fails if these are not available. It needs only the libraries, so that it can be
 * built for any machine. */
#include "frames.h"
#include "frames_steps.h"

static void print(void *ctx, const char *name, uint32_t crc)
{
    (void)ctx;
    printf("%s %08lx\n", name, (unsigned long)crc);
}

static void print_sums(uint32_t first, uint32_t end)
{
    static struct tia_sum sums[FRAMES_SUMS_WIDTH * FRAMES_SUMS_HEIGHT];

    for (int integrator = TIA_OCCLUSION; integrator <= TIA_PATHS; integrator++) {
        memset(sums, 0, sizeof sums);
        frames_add_samples((enum tia_integrator)integrator, first, end, sums);
        for (unsigned i = 0; i < FRAMES_SUMS_WIDTH * FRAMES_SUMS_HEIGHT * 3; i++)
            printf("%lld\n", (long long)sums[i / 3].rgb[i % 3]);
    }
}

static void print_hash(void *ctx, uint32_t step, uint64_t hash)
{
    (void)ctx;
    printf("%lu %016llx\n", (unsigned long)step, (unsigned long long)hash);
}

#ifdef HASHER_SIMD
#include <tia/simd.h>

#define LEAST_VIEWS 10 /* least number of views that vector units must draw: scalar draws spheres by plain C */

static const struct tia_simd *simd;
static unsigned simd_count;

/* Opens a view that draws with the vector units, and counts it if they draw it. Their memory is not freed, since the
 * program ends soon. */
static int view_init_with_simd(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                               const struct tia_scene *scene, uint32_t light_capacity, unsigned width, unsigned height,
                               const struct tia_job *job)
{
    size_t more = tia_simd_size(simd, scene, light_capacity, 1);
    int status = tia_core_q16.view_init(core, view, memory, size, scene, light_capacity, width, height, job);

    if (!status)
        status = tia_view_set_simd(*view, simd, malloc(more + 1), more);
    simd_count += !status && strcmp(tia_view_simd(*view), "plain") != 0;
    return status;
}

static int hash_by_simd(void)
{
    const char *name = getenv("TIA_SIMD");
    struct tia_core core = tia_core_q16;

    if (!name || tia_simd_named(name, &simd) || !simd) {
        (void)fprintf(stderr, "error: no vector units %s here\n", name ? name : "is named by TIA_SIMD");
        return 1;
    }
    core.view_init = view_init_with_simd;
    frames_all(&core, print, NULL);
    if (simd_count < LEAST_VIEWS)
        (void)fprintf(stderr, "error: %s drew only %u views\n", name, simd_count);
    return simd_count < LEAST_VIEWS;
}
#endif

int main(int argc, char **argv)
{
    const struct tia_core *core = &tia_core_q16;

    if (argc == 4 && !strcmp(argv[1], "sums")) {
        print_sums((uint32_t)strtoul(argv[2], NULL, 10), (uint32_t)strtoul(argv[3], NULL, 10));
        return 0;
    }
    if (argc == 2 && !strcmp(argv[1], "steps")) {
        steps_all(print_hash, NULL);
        return 0;
    }
#ifdef HASHER_SIMD
    (void)core;
    return hash_by_simd();
#else
#ifdef TIA_HAVE_F32
    if (argc > 1 && !strcmp(argv[1], "f32"))
        core = &tia_core_f32;
#endif
    frames_all(core, print, NULL);
    return 0;
#endif
}
