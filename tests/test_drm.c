/* The choice of connector, mode, CRTC and format, from structs like those of real cards. */
#include "check.h"

#ifdef TIA_HAVE_DRM

#include "drm/card.h"

#include <drm_fourcc.h>
#include <stddef.h>

/* A card with two encoders (the first may use either CRTC, the second only CRTC 41) and three
 * connectors: VGA-1 with a dark screen, HDMI-A-1 that is lit, DP-2 with nothing on it. */
static uint32_t crtcs[] = {40, 41}, connector_ids[] = {50, 51, 52}, encoder_ids[] = {60, 61};
static drmModeRes resources = {.count_crtcs = 2,
                               .crtcs = crtcs,
                               .count_connectors = 3,
                               .connectors = connector_ids,
                               .count_encoders = 2,
                               .encoders = encoder_ids};
static drmModeModeInfo modes[4], no_modes[1];
static drmModeEncoder encoder_a, encoder_b;
static drmModeConnector vga, hdmi, dp;
static drmModeConnector *connectors[] = {&vga, &hdmi, &dp};
static drmModeEncoder *encoders[] = {&encoder_a, &encoder_b};
static const struct drm_parts parts = {&resources, connectors, encoders};
static char why[PORT_WHY];

static drmModeModeInfo mode(uint16_t width, uint16_t height, uint32_t rate, uint32_t type)
{
    return (drmModeModeInfo){.hdisplay = width, .vdisplay = height, .vrefresh = rate, .type = type};
}

static drmModeConnector connector(uint32_t id, uint32_t type, uint32_t number)
{
    return (drmModeConnector){.connector_id = id,
                              .connector_type = type,
                              .connector_type_id = number,
                              .connection = DRM_MODE_CONNECTED,
                              .count_modes = 4,
                              .modes = modes,
                              .count_encoders = 2,
                              .encoders = encoder_ids};
}

static void set_up(void)
{
    modes[0] = mode(1920, 1080, 60, DRM_MODE_TYPE_DRIVER);
    modes[1] = mode(1280, 800, 75, DRM_MODE_TYPE_DRIVER | DRM_MODE_TYPE_PREFERRED);
    modes[2] = mode(640, 480, 75, DRM_MODE_TYPE_DRIVER);
    modes[3] = mode(640, 480, 60, DRM_MODE_TYPE_DRIVER);
    encoder_a = (drmModeEncoder){.encoder_id = 60, .possible_crtcs = 3};
    encoder_b = (drmModeEncoder){.encoder_id = 61, .possible_crtcs = 2, .crtc_id = 41};
    vga = connector(50, DRM_MODE_CONNECTOR_VGA, 1);
    hdmi = connector(51, DRM_MODE_CONNECTOR_HDMIA, 1);
    hdmi.encoder_id = 61;
    dp = connector(52, DRM_MODE_CONNECTOR_DisplayPort, 2);
    dp.connection = DRM_MODE_DISCONNECTED;
    connectors[0] = &vga;
    connectors[1] = &hdmi;
    encoders[0] = &encoder_a;
    why[0] = '\0';
}

TEST(a_lit_connector_comes_first)
{
    set_up();
    CHECK(pick_connector(&parts, NULL, why) == &hdmi);
    hdmi.connection = DRM_MODE_DISCONNECTED;
    CHECK(pick_connector(&parts, NULL, why) == &vga);
    vga.count_modes = 0;
    CHECK(!pick_connector(&parts, NULL, why));
    CHECK(strcmp(why, "no connector has a screen with a mode") == 0);
}

TEST(connectors_have_the_kernels_names)
{
    set_up();
    CHECK(pick_connector(&parts, "VGA-1", why) == &vga);
    CHECK(pick_connector(&parts, "HDMI-A-1", why) == &hdmi);
    CHECK(!pick_connector(&parts, "DP-2", why));
    CHECK(strcmp(why, "connector DP-2: nothing is connected to it") == 0);
    CHECK(!pick_connector(&parts, "VGA-2", why));
    CHECK(strcmp(why, "connector VGA-2: no such connector (there are: VGA-1, HDMI-A-1, DP-2)") == 0);
    vga.modes = no_modes;
    vga.count_modes = 0;
    CHECK(!pick_connector(&parts, "VGA-1", why));
    CHECK(strstr(why, "no mode"));
}

TEST(unknown_connection_is_none)
{
    set_up();
    hdmi.connection = vga.connection = DRM_MODE_UNKNOWNCONNECTION;
    CHECK(!pick_connector(&parts, NULL, why));
}

TEST(preferred_mode_then_the_others)
{
    set_up();
    CHECK(pick_mode(&vga, NULL, 0) == &modes[1]);
    CHECK(pick_mode(&vga, NULL, 1) == &modes[0]);
    CHECK(pick_mode(&vga, NULL, 2) == &modes[2]);
    CHECK(pick_mode(&vga, NULL, 3) == &modes[3]);
    CHECK(!pick_mode(&vga, NULL, 4));
    CHECK(pick_mode(&vga, "preferred", 0) == &modes[1]);
    CHECK(!pick_mode(&vga, "preferred", 1));
    modes[1].type = 0; /* no mode is preferred: the driver's first is chosen */
    CHECK(pick_mode(&vga, "preferred", 0) == &modes[0]);
}

TEST(modes_by_size_and_rate)
{
    set_up();
    CHECK(pick_mode(&vga, "640x480", 0) == &modes[2]);
    CHECK(pick_mode(&vga, "640x480", 1) == &modes[3]);
    CHECK(!pick_mode(&vga, "640x480", 2));
    CHECK(pick_mode(&vga, "640x480@60", 0) == &modes[3]);
    CHECK(!pick_mode(&vga, "640x480@60", 1));
    CHECK(!pick_mode(&vga, "640x480@50", 0));
    CHECK(!pick_mode(&vga, "64", 0));
    CHECK(!pick_mode(&vga, "640x4800", 0));
    CHECK(!pick_mode(&vga, "640x480@6", 0));
    CHECK(!pick_mode(&vga, "", 0));
}

TEST(modes_that_are_too_large_are_left_out)
{
    set_up();
    modes[1] = mode(15360, 8640, 60, DRM_MODE_TYPE_PREFERRED);
    CHECK(pick_mode(&vga, NULL, 0) == &modes[0]);
    CHECK(!pick_mode(&vga, "15360x8640", 0));
}

TEST(crtc_of_the_encoder_or_one_that_is_free)
{
    set_up();
    CHECK_EQ(pick_crtc(&parts, &hdmi), 41);
    CHECK_EQ(pick_current_crtc(&parts, &hdmi), 41);
    CHECK_EQ(pick_crtc(&parts, &vga), 40);
    CHECK_EQ(pick_current_crtc(&parts, &vga), 0);
    encoder_a.possible_crtcs = 2; /* only the CRTC that lights HDMI-A-1 */
    CHECK_EQ(pick_crtc(&parts, &vga), 0);
    encoder_b.crtc_id = 0; /* HDMI-A-1 is dark */
    CHECK_EQ(pick_crtc(&parts, &vga), 41);
}

TEST(parts_that_went_away)
{
    set_up();
    connectors[0] = NULL;
    encoders[0] = NULL;
    CHECK(pick_connector(&parts, NULL, why) == &hdmi);
    CHECK(!pick_connector(&parts, "VGA-1", why));
    CHECK_EQ(pick_crtc(&parts, &vga), 0);
}

static void formats_are(const uint32_t *plane, size_t count, bool listed, const char *want)
{
    char got[100] = "", name[PIXEL_NAME];
    struct card_format f;

    for (int n = 0; card_format_of(plane, count, n, listed, &f); n++) {
        (void)strcat(got, n == 0 ? "" : " ");
        (void)strcat(got, pixel_name(f.pixel, name));
    }
    CHECK_MSG(strcmp(got, want) == 0, "'%s', not '%s'", got, want);
}

TEST(formats_in_the_order_of_trying)
{
    const uint32_t bochs[] = {DRM_FORMAT_XRGB8888, DRM_FORMAT_XBGR8888};
    const uint32_t cirrus[] = {DRM_FORMAT_RGB565, DRM_FORMAT_RGB888, DRM_FORMAT_XRGB8888};
    const uint32_t panel[] = {DRM_FORMAT_BGR565, DRM_FORMAT_XBGR8888};

    formats_are(NULL, 0, false, "RGB565 XRGB8888");
    formats_are(bochs, 2, false, "RGB565 XRGB8888 XBGR8888");
    formats_are(cirrus, 3, false, "RGB565 XRGB8888");
    formats_are(panel, 2, false, "RGB565 BGR565 XRGB8888 XBGR8888");
    formats_are(NULL, 0, true, "");
    formats_are(bochs, 2, true, "XRGB8888 XBGR8888");
    formats_are(cirrus, 3, true, "RGB565 XRGB8888");
}

int main(void)
{
    RUN(a_lit_connector_comes_first);
    RUN(connectors_have_the_kernels_names);
    RUN(unknown_connection_is_none);
    RUN(preferred_mode_then_the_others);
    RUN(modes_by_size_and_rate);
    RUN(modes_that_are_too_large_are_left_out);
    RUN(crtc_of_the_encoder_or_one_that_is_free);
    RUN(parts_that_went_away);
    RUN(formats_in_the_order_of_trying);
    return check_status();
}

#else
#include "no_drm.h"
#endif
