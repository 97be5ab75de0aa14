/* The frames of tests/arch/frames.h against the checksums in tests/golden/frames.crc, on this machine;
 * tests/slow/arch does the same for others. */
#include <stdlib.h>

#include <tia/simd.h>

#include "arch/frames.h"
#include "check.h"

#define GOLDEN "tests/golden/frames.crc"

static struct {
    char name[80];
    unsigned long crc;
} pinned[160];
static size_t pinned_count, frame_count;

static void read_pinned(void)
{
    FILE *file = fopen(GOLDEN, "r");
    char line[200];

    while (file && fgets(line, sizeof line, file))
        if (line[0] != '#' && pinned_count < sizeof pinned / sizeof pinned[0] &&
            sscanf(line, "%79s %lx", pinned[pinned_count].name, &pinned[pinned_count].crc) == 2)
            pinned_count++;
    if (file)
        (void)fclose(file);
}

static void compare(void *ctx, const char *name, uint32_t crc)
{
    size_t i = frame_count++;

    (void)ctx;
    CHECK_MSG(i < pinned_count && !strcmp(name, pinned[i].name), "%s is not in its place in %s", name, GOLDEN);
    CHECK_MSG(i < pinned_count && crc == pinned[i].crc, "%s: %08lx, pinned %08lx", name, (unsigned long)crc,
              pinned[i].crc);
}

TEST(pinned_frames)
{
    frames_all(&tia_core_q16, compare, NULL);
    CHECK_EQ(frame_count, pinned_count);
}

/* Instruction set that the core below sets for its views. */
static const struct tia_simd *simd;
static void *simd_memory[1000];
static size_t memory_count, simd_count;

static int view_init_with_simd(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                               const struct tia_scene *scene, uint32_t light_capacity, unsigned width, unsigned height,
                               const struct tia_job *job)
{
    size_t more = tia_simd_size(simd, scene, light_capacity, 1);
    int status = tia_core_q16.view_init(core, view, memory, size, scene, light_capacity, width, height, job);

    if (status || memory_count == sizeof simd_memory / sizeof *simd_memory)
        return status;
    void *constants = simd_memory[memory_count++] = malloc(more + 1);
    status = tia_view_set_simd(*view, simd, constants, more);
    simd_count += strcmp(tia_view_simd(*view), "plain") != 0;
    return status;
}

TEST(pinned_frames_by_a_level)
{
    struct tia_core core = tia_core_q16;

    core.view_init = view_init_with_simd;
    frame_count = memory_count = simd_count = 0;
    frames_all(&core, compare, NULL);
    CHECK_EQ(frame_count, pinned_count);
    CHECK(simd_count > 5);
    while (memory_count > 0)
        free(simd_memory[--memory_count]);
}

int main(void)
{
    read_pinned();
    RUN(pinned_frames);
    for (unsigned i = 0; (simd = tia_simd_at(i)); i++)
        if (!check_is_quick() || simd == tia_simd_best()) /* in make check-quick only the best one */
            RUN(pinned_frames_by_a_level);
    return check_status();
}
