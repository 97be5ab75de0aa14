/* The images of a .tia file: the files fetched for a texture, and their texels. */
#include "reading.h"

static struct reading now;
static bool fetches;
static const struct tia_scene *const scene = &now.scene;

static const uint8_t texels[6] = {1, 2, 3, 4, 5, 6};
static int fetched;

static int fetch_image(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    (void)ctx;
    fetched++;
    if (strcmp(name, "two words.png") != 0) {
        *why = "no such file";
        return TIA_ERR_DEVICE;
    }
    texture->width = 2;
    texture->height = 1;
    texture->texels = texels;
    return TIA_OK;
}

static int fetch_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture,
                         const char **why)
{
    int status = fetch_image(ctx, name, texture, why);
    CHECK_EQ(channel, TIA_CHANNEL_OPACITY);
    texture->texels = texels + 3;
    return status;
}

static void read_text(const char *text)
{
    read_end(&now);
    now = (struct reading){.reader = {.format = TIA_FORMAT_TIA, .text = text, .length = strlen(text)}};
    now.reader.image = fetches ? fetch_image : NULL;
    now.reader.opacity = fetches ? fetch_opacity : NULL;
    read_begin(&now);
}

static void check_reads(const char *text)
{
    read_text(text);
    CHECK_MSG(!now.status, "%d, %u:%u: %s", now.status, (unsigned)now.reader.error.line,
              (unsigned)now.reader.error.column, now.reader.error.text);
}

static void check_refused(const char *text, const char *error)
{
    read_text(text);
    check_read_error(&now, error);
}

TEST(images)
{
    const struct tia_texture *t;

    fetches = true;
    fetched = 0;
    check_reads("texture a image \"two words.png\" bilinear repeat 2 0.5\ntexture b image \"two words.png\"");
    t = scene->textures;
    CHECK(scene->texture_count == 2 && t[0].kind == TIA_IMAGE && t[0].bilinear && !t[1].bilinear);
    CHECK(t[0].repeat[0] == TIA_Q16(2) && t[0].repeat[1] == TIA_Q16(0.5) && t[1].repeat[1] == TIA_Q16_ONE);
    CHECK(t[1].width == 2 && t[1].height == 1 && t[1].texels == texels && fetched == 2);
}

TEST(opacities)
{
    const struct tia_texture *t;

    fetches = true;
    check_reads("material m opacity holes texture a\ntexture a image \"two words.png\"\n"
                "texture holes opacity \"two words.png\" bilinear offset 0.5 0 scale 0.5\n");
    t = scene->textures;
    CHECK(scene->materials[0].texture == 1 && scene->materials[0].opacity == 2 && t[1].kind == TIA_OPACITY);
    CHECK(t[1].bilinear && t[1].repeat[1] == TIA_Q16(2) && t[1].offset[0] == TIA_Q16(0.5) && t[1].texels == texels + 3);
}

TEST(missing)
{
    fetches = true;
    check_refused("\ntexture a image x.png", "2:17: 'x.png': no such file, expected a picture");
    check_refused("\ntexture a opacity x.png", "2:19: 'x.png': no such file, expected a picture");
    fetches = false;
    check_refused("texture a image x.png", "1:17: 'x.png' cannot be fetched here, expected a scene without images");
    check_refused("texture a opacity x.png", "1:19: 'x.png' cannot be fetched here, expected a scene without images");
}

int main(void)
{
    RUN(images);
    RUN(opacities);
    RUN(missing);
    read_end(&now);
    return check_status();
}
