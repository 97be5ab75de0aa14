/* The frames of tests/arch/frames.h against the checksums in tests/golden/frames.crc, on this machine;
 * tests/slow/arch does the same for others. */
#include "arch/frames.h"
#include "check.h"

#define GOLDEN "tests/golden/frames.crc"

static struct {
    char name[80];
    unsigned long crc;
} pinned[128];
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

int main(void)
{
    read_pinned();
    RUN(pinned_frames);
    return check_status();
}
