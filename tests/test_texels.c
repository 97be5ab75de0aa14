/* Textures from picture files: hand-written PPM, PNG files of this program, and files that are refused. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"
#include "common/image/decode.h"
#include "common/image/image.h"
#include "ports.h"

static struct image_texels texels;
static const char *why;

static int decode(const void *bytes, size_t length, unsigned side, size_t most)
{
    texels = (struct image_texels){0, 0, NULL, NULL};
    why = "";
    return image_decode(&texels, bytes, length, side, most, &why);
}

static void check_ppm(const char *text, size_t length, unsigned width, unsigned height, const char *want)
{
    CHECK_EQ(decode(text, length, 100, 10000), TIA_OK);
    CHECK_EQ(texels.width, width);
    CHECK_EQ(texels.height, height);
    if (texels.rgb)
        CHECK_MSG(!memcmp(texels.rgb, want, (size_t)width * height * 3), "%s", text);
    image_free(&texels);
}

#define PPM(text, width, height, want) check_ppm(text, sizeof(text) - 1, width, height, want)

TEST(ppm)
{
    PPM("P6 1 2 255\nabcdef", 1, 2, "abcdef");
    PPM("P6\n# a comment 9\n2 #another\n1\n255\n#bcdef", 2, 1, "#bcdef");
    PPM("P6 1 1 255\nabcdef", 1, 1, "abc"); /* the rest belongs to a second picture */
    PPM("P3 1 1 255 0 1 255", 1, 1, "\0\1\377");
    PPM("P3\n1 1\n255\n1 # one\n2\t3\n", 1, 1, "\1\2\3");
    /* each value times 255 / maximum, rounded to nearest: 1/3 is 85, 127 of 254 is 127.5 */
    PPM("P3 1 1 3 0 1 3", 1, 1, "\0\125\377");
    PPM("P3 1 1 254 127 253 254", 1, 1, "\200\376\377");
    PPM("P6 1 1 65535\n\0\0\377\377\1\1", 1, 1, "\0\377\1");
    PPM("P6 1 1 300\n\1\54\0\0\0\226", 1, 1, "\377\0\200"); /* 300, 0, 150 */
}

static void check_refused(const char *text, size_t length)
{
    CHECK_MSG(decode(text, length, 100, 3000) == TIA_ERR_RANGE && *why && !texels.rgb, "%s", text);
}

#define REFUSED(text) check_refused(text, sizeof(text) - 1)

TEST(what_is_no_picture)
{
    REFUSED("");
    REFUSED("P");
    REFUSED("P6");
    REFUSED("P6 1 1");
    REFUSED("P6 1 1 255");
    REFUSED("P6 1 1 255\nab");
    REFUSED("P6 1 1 65535\nabcde");
    REFUSED("P6 0 1 255\nabc");
    REFUSED("P6 1 0 255\nabc");
    REFUSED("P6 -1 1 255\nabc");
    REFUSED("P6 1 1 0\nabc");
    REFUSED("P6 1 1 65536\nabcdef");
    REFUSED("P6 1 1 100\na\145c"); /* 101, above the maximum 100 */
    REFUSED("P6 99999999999999999999 1 255\nabc");
    REFUSED("P3 1 1 255 0 1");
    REFUSED("P3 1 1 255 0 1 256");
    REFUSED("P3 1 1 255 0 1 x");
    REFUSED("P5 1 1 255\na");
    REFUSED("GIF89a");
    REFUSED("\x89PNG\r\n\x1a\n");
    REFUSED("\x89PNG and no more");
}

static void check_channel(enum tia_channel channel, bool alpha, unsigned char first, unsigned char second)
{
    static const char rgb[] = "\144\310\062\377\377\377"; /* 100, 200, 50 and white */

    texels = (struct image_texels){2, 1, malloc(6), alpha ? malloc(2) : NULL};
    memcpy(texels.rgb, rgb, 6);
    if (alpha)
        memcpy(texels.alpha, "\7\11", 2);
    image_channel(&texels, channel);
    CHECK_MSG(!texels.rgb && texels.alpha[0] == first && texels.alpha[1] == second, "channel %d%s: %u and %u", channel,
              alpha ? " with alpha" : "", texels.alpha[0], texels.alpha[1]);
    image_free(&texels);
}

/* 0.299 100 + 0.587 200 + 0.114 50 is 153. */
TEST(channels)
{
    for (int alpha = 0; alpha < 2; alpha++) {
        check_channel(TIA_CHANNEL_RED, alpha, 100, 255);
        check_channel(TIA_CHANNEL_GREEN, alpha, 200, 255);
        check_channel(TIA_CHANNEL_BLUE, alpha, 50, 255);
        check_channel(TIA_CHANNEL_LUMINANCE, alpha, 153, 255);
        check_channel(TIA_CHANNEL_ALPHA, alpha, alpha ? 7 : 255, alpha ? 9 : 255);
        check_channel(TIA_CHANNEL_OPACITY, alpha, alpha ? 7 : 153, alpha ? 9 : 255);
    }
}

/* A picture that is too large is refused by its size, before any byte is read or allocated. */
TEST(too_large_a_picture)
{
    REFUSED("P6 101 1 255\n");
    REFUSED("P6 1 101 255\n");
    REFUSED("P6 100 100 255\n");
    CHECK(strstr(why, "too large"));
}

#ifdef TIA_HAVE_PNG
static unsigned char file[1 << 16];

static size_t write_png(const tia_rgb565 *pixels, unsigned width, unsigned height)
{
    char name[] = "/tmp/tia-texels-XXXXXX", reason[PORT_WHY];
    int fd = mkstemp(name);
    struct image *image = image_create(name, IMAGE_PNG, width, height, reason);
    ssize_t length = -1;

    CHECK(fd >= 0 && image);
    if (image && !image_band(image, pixels, height) && !image_finish(image)) {
        FILE *written = fopen(name, "rb");
        length = written ? (ssize_t)fread(file, 1, sizeof file, written) : -1;
        if (written)
            (void)fclose(written);
    }
    (void)unlink(name);
    (void)close(fd);
    CHECK(length > 0);
    return length > 0 ? (size_t)length : 0;
}

/* Each channel of RGB565 is written with 8 bits, by repeating its high bits. */
TEST(png)
{
    static const tia_rgb565 pixels[] = {0x0000, 0xffff, 0xf800, 0x07e0, 0x001f, 0x8410};
    static const unsigned char want[] = {0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 132, 130, 132};
    size_t length = write_png(pixels, 3, 2);

    CHECK_EQ(decode(file, length, 3, sizeof want), TIA_OK);
    CHECK(texels.width == 3 && texels.height == 2 && texels.rgb && !memcmp(texels.rgb, want, sizeof want));
    image_free(&texels);
    CHECK_EQ(decode(file, length, 2, sizeof want), TIA_ERR_RANGE);
    CHECK_EQ(decode(file, length, 3, sizeof want - 1), TIA_ERR_RANGE);
    for (size_t cut = 0; cut < length - 12; cut++) /* a picture is complete even without its last chunk */
        CHECK_MSG(decode(file, cut, 3, sizeof want) == TIA_ERR_RANGE && !texels.rgb, "cut to %zu", cut);
}
#else
TEST(png)
{
    SKIP("built without libpng (libpng-dev)");
}
#endif

int main(void)
{
    RUN(ppm);
    RUN(what_is_no_picture);
    RUN(channels);
    RUN(too_large_a_picture);
    RUN(png);
    return check_status();
}
