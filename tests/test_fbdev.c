/* The pixel formats of framebuffer devices: real drivers' descriptions, and the odd ones that the kernel's
 * documentation allows (Documentation/fb/api.rst). */
#include "check.h"
#include "fbdev/screen.h"

struct answer {
    unsigned width, height, bits, row, memory, type, visual;
    struct fb_bitfield r, g, b, a;
};

#define TRUE_COLOUR FB_TYPE_PACKED_PIXELS, FB_VISUAL_TRUECOLOR
#define DIRECT_COLOUR FB_TYPE_PACKED_PIXELS, FB_VISUAL_DIRECTCOLOR

static int format_of(const struct answer *a, struct pixel_format *format, char reason[PORT_WHY])
{
    struct fb_var_screeninfo var = {.xres = a->width,
                                    .yres = a->height,
                                    .bits_per_pixel = a->bits,
                                    .red = a->r,
                                    .green = a->g,
                                    .blue = a->b,
                                    .transp = a->a};
    struct fb_fix_screeninfo fix = {.smem_len = a->memory, .type = a->type, .visual = a->visual, .line_length = a->row};

    return fb_format(&var, &fix, format, reason);
}

static void is(const char *name, struct answer a)
{
    struct pixel_format format;
    char reason[PORT_WHY] = "", text[PIXEL_NAME];

    CHECK_MSG(!format_of(&a, &format, reason), "%s is refused: %s", name, reason);
    CHECK_MSG(strcmp(pixel_name(&format, text), name) == 0, "%s is taken for %s", name, text);
}

TEST(real_drivers)
{
    is("RGB565", (struct answer){640, 480, 16, 1280, 614400, TRUE_COLOUR, {11, 5, 0}, {5, 6, 0}, {0, 5, 0}, {0}});
    is("BGR565", (struct answer){640, 480, 16, 1280, 1048576, TRUE_COLOUR, {0, 5, 0}, {5, 6, 0}, {11, 5, 0}, {0}});
    is("RGB555",
       (struct answer){640, 480, 15, 1280, 614400, TRUE_COLOUR, {10, 5, 0}, {5, 5, 0}, {0, 5, 0}, {15, 1, 0}});
    is("RGB555", (struct answer){640, 480, 16, 1280, 614400, DIRECT_COLOUR, {10, 5, 0}, {5, 5, 0}, {0, 5, 0}, {0}});
    is("RGB888", (struct answer){800, 600, 24, 2400, 1440000, TRUE_COLOUR, {16, 8, 0}, {8, 8, 0}, {0, 8, 0}, {0}});
    is("XRGB8888", (struct answer){1280, 800, 32, 5120, 4096000, TRUE_COLOUR, {16, 8, 0}, {8, 8, 0}, {0, 8, 0}, {0}});
    is("XBGR8888",
       (struct answer){720, 480, 32, 2944, 1413120, TRUE_COLOUR, {0, 8, 0}, {8, 8, 0}, {16, 8, 0}, {24, 8, 0}});
}

static void refused(const char *part, struct answer a)
{
    struct pixel_format format;
    char reason[PORT_WHY] = "";

    CHECK_MSG(format_of(&a, &format, reason) == TIA_ERR_UNSUPPORTED, "%s: accepted", part);
    CHECK_MSG(strstr(reason, part), "no '%s' in '%s'", part, reason);
}

TEST(what_cannot_be_drawn)
{
    const struct fb_bitfield r = {11, 5, 0}, g = {5, 6, 0}, b = {0, 5, 0}, none = {0, 0, 0}, reversed = {11, 5, 1};

    refused("8 bits", (struct answer){640, 480, 8, 640, 614400, TRUE_COLOUR, {0, 8, 0}, {0, 8, 0}, {0, 8, 0}, none});
    refused("palette",
            (struct answer){640, 480, 8, 640, 307200, FB_TYPE_PACKED_PIXELS, FB_VISUAL_PSEUDOCOLOR, r, g, b, none});
    refused("not packed",
            (struct answer){640, 480, 4, 80, 65536, FB_TYPE_VGA_PLANES, FB_VISUAL_PSEUDOCOLOR, r, g, b, none});
    refused("palette", (struct answer){640, 480, 1, 80, 65536, FB_TYPE_PACKED_PIXELS, FB_VISUAL_MONO01, r, g, b, none});
    refused("reverse", (struct answer){640, 480, 16, 1280, 614400, TRUE_COLOUR, reversed, g, b, none});
    refused("overlap", (struct answer){640, 480, 16, 1280, 614400, TRUE_COLOUR, r, r, b, none});
    refused("no bits", (struct answer){640, 480, 16, 1280, 614400, TRUE_COLOUR, r, none, b, none});
    refused("rows", (struct answer){640, 480, 16, 1278, 614400, TRUE_COLOUR, r, g, b, none});
    refused("memory", (struct answer){640, 480, 16, 1280, 614399, TRUE_COLOUR, r, g, b, none});
    refused("size", (struct answer){0, 480, 16, 1280, 614400, TRUE_COLOUR, r, g, b, none});
    refused("size", (struct answer){8193, 1, 16, 20000, 614400, TRUE_COLOUR, r, g, b, none});
}

TEST(grey_and_coded_pixels_are_refused)
{
    struct fb_var_screeninfo var = {
        .xres = 64, .yres = 48, .bits_per_pixel = 16, .red = {11, 5, 0}, .green = {5, 6, 0}, .blue = {0, 5, 0}};
    struct fb_fix_screeninfo fix = {.smem_len = 6144, .visual = FB_VISUAL_TRUECOLOR, .line_length = 128};
    struct pixel_format format;
    char reason[PORT_WHY];

    CHECK_EQ(fb_format(&var, &fix, &format, reason), TIA_OK);
    var.grayscale = 1;
    CHECK_EQ(fb_format(&var, &fix, &format, reason), TIA_ERR_UNSUPPORTED);
    var.grayscale = 0;
    var.nonstd = 1;
    CHECK_EQ(fb_format(&var, &fix, &format, reason), TIA_ERR_UNSUPPORTED);
    var.nonstd = 0;
    var.yoffset = 1; /* the visible part would end behind the memory */
    CHECK_EQ(fb_format(&var, &fix, &format, reason), TIA_ERR_UNSUPPORTED);
}

/* Two pages need the driver's panning, in steps that reach the second, and memory for both. */
TEST(room_for_two_pages)
{
    struct fb_var_screeninfo var = {.xres = 640, .yres = 480};
    struct fb_fix_screeninfo fix = {.smem_len = 2 * 480 * 1280, .line_length = 1280, .ypanstep = 1};

    CHECK(fb_can_pan(&var, &fix));
    fix.ypanstep = 0;
    CHECK(!fb_can_pan(&var, &fix));
    fix.ypanstep = 7;
    CHECK(!fb_can_pan(&var, &fix));
    fix.ypanstep = 8;
    CHECK(fb_can_pan(&var, &fix));
    fix.smem_len--;
    CHECK(!fb_can_pan(&var, &fix));
}

TEST(colour_map_that_changes_nothing)
{
    uint16_t map[256];

    fb_ramp(map, 5);
    CHECK_EQ(map[0], 0);
    CHECK_EQ(map[31], 65535);
    CHECK_EQ(map[1], 2114); /* 65535 / 31 */
    fb_ramp(map, 8);
    CHECK_EQ(map[1], 257);
    CHECK_EQ(map[255], 65535);
}

int main(void)
{
    RUN(real_drivers);
    RUN(what_cannot_be_drawn);
    RUN(grey_and_coded_pixels_are_refused);
    RUN(room_for_two_pages);
    RUN(colour_map_that_changes_nothing);
    return check_status();
}
