/* test_drm_changes.c - what the DRM display tells the driver: which buffer is shown, and which rectangles have changed.
 * The functions of libdrm that are called are replaced. */
#include "check.h"

#ifdef TIA_HAVE_DRM

#include <errno.h>
#include <unistd.h>
#include <xf86drm.h>

#include "drm/scanout.h"

/* The driver. */
static struct driver {
    int error;           /* of DirtyFB; 0: none */
    bool refuses_clips;  /* EINVAL for rectangles */
    uint32_t flipped_to; /* framebuffer of the last flip; 0: none */
    unsigned flips, dirty_calls, clips;
    drmModeClip clip[4];
    uint32_t dirty;
    void *waiting; /* of the flip whose event has not been read */
    int events[2];
} driver;

int drmModeDirtyFB(int fd, uint32_t fb, drmModeClipPtr clips, uint32_t count)
{
    (void)fd;
    driver.dirty_calls++;
    errno = driver.error ? driver.error : EINVAL;
    if (driver.error || (clips && driver.refuses_clips))
        return -1;
    driver.dirty = fb;
    driver.clips = clips ? count : 0;
    for (uint32_t i = 0; clips && i < count && i < 4; i++)
        driver.clip[i] = clips[i];
    return 0;
}

int drmModePageFlip(int fd, uint32_t crtc, uint32_t fb, uint32_t flags, void *arg)
{
    (void)fd, (void)crtc, (void)flags;
    driver.flipped_to = fb;
    driver.flips++;
    driver.waiting = arg;
    return write(driver.events[1], "x", 1) == 1 ? 0 : -1;
}

int drmHandleEvent(int fd, drmEventContextPtr context)
{
    char byte;

    CHECK_EQ(read(fd, &byte, 1), 1);
    context->page_flip_handler(fd, 0, 0, 0, driver.waiting);
    return 0;
}

static struct card card;
static char why[PORT_WHY];

static struct scanout plug(bool copied)
{
    struct scanout s = {.card = &card, .flips = true, .copied = copied};

    driver = (struct driver){.error = 0};
    CHECK_EQ(pipe(driver.events), 0);
    card.fd = driver.events[0];
    s.buffers[0].fb = 100;
    s.buffers[1].fb = 101;
    return s;
}

static void unplug(void)
{
    (void)close(driver.events[0]);
    (void)close(driver.events[1]);
}

TEST(two_buffers_are_shown_by_turns)
{
    struct scanout s = plug(false);
    drmModeClip clips[2] = {{1, 2, 3, 4}, {5, 6, 7, 8}};

    CHECK_EQ(scanout_drawn(&s), 1);
    CHECK_EQ(scanout_swap(&s, clips, 2, why), TIA_OK);
    CHECK(driver.flipped_to == 101 && driver.dirty == 101 && driver.clips == 2);
    CHECK(!memcmp(driver.clip, clips, sizeof clips));
    CHECK_EQ(scanout_drawn(&s), 0);
    CHECK_EQ(scanout_swap(&s, NULL, 0, why), TIA_OK); /* any pixel */
    CHECK(driver.flipped_to == 100 && driver.dirty == 100 && driver.clips == 0);
    CHECK_EQ(scanout_swap(&s, clips, 0, why), TIA_OK); /* none */
    CHECK(driver.flips == 3 && driver.dirty_calls == 2);
    unplug();
}

/* A panel with memory of its own: the driver sends only what has changed of the one buffer. */
TEST(one_buffer_is_copied_to_the_screen)
{
    struct scanout s = plug(true);
    drmModeClip clips[1] = {{10, 20, 30, 40}};

    for (int frame = 0; frame < 3; frame++) {
        CHECK_EQ(scanout_drawn(&s), 0);
        CHECK_EQ(scanout_swap(&s, clips, 1, why), TIA_OK);
        CHECK(driver.flips == 0 && driver.dirty == 100 && driver.clips == 1 && driver.clip[0].x2 == 30);
    }
    CHECK_EQ(scanout_swap(&s, clips, 0, why), TIA_OK);
    CHECK_EQ(driver.dirty_calls, 3);
    unplug();
}

TEST(drivers_without_rectangles)
{
    struct scanout s = plug(true);
    drmModeClip clips[1] = {{10, 20, 30, 40}};

    driver.refuses_clips = true;
    CHECK_EQ(scanout_swap(&s, clips, 1, why), TIA_OK);
    CHECK(driver.dirty == 100 && driver.clips == 0 && s.copied);
    driver.error = ENOSYS; /* then it shows the buffer itself */
    CHECK_EQ(scanout_swap(&s, clips, 1, why), TIA_OK);
    CHECK_EQ(scanout_drawn(&s), 1);
    CHECK_EQ(scanout_swap(&s, clips, 1, why), TIA_OK);
    CHECK_EQ(driver.flipped_to, 101);
    driver.error = ENODEV; /* unplugged */
    CHECK_EQ(scanout_swap(&s, clips, 1, why), TIA_ERR_DEVICE);
    unplug();
}

int main(void)
{
    RUN(two_buffers_are_shown_by_turns);
    RUN(one_buffer_is_copied_to_the_screen);
    RUN(drivers_without_rectangles);
    return check_status();
}

#else
#include "no_drm.h"
#endif
