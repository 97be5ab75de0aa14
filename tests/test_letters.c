/* A picture whose orientation is visible: four texels, red and green above blue and white, on every shape, as
 * tia/shape.h defines.
 *
 * From the side that the normal points to they are seen as they are stored; from the other side mirrored. The colours
 * expected here follow from that definition and from each camera's position alone. */
#include "reading.h"
#include <tia/tia.h>

#define SIDE 8
#define FRONT "camera orthographic eye 0 0 9 look 0 0 0 window -1 1 -1 1\n"
#define BEHIND "camera orthographic eye 0 0 -9 look 0 0 0 window -1 1 -1 1\n"
#define RIGHT "camera orthographic eye 9 0 0 look 0 0 0 window -1 1 -1 1\n"
#define LEFT "camera orthographic eye -9 0 0 look 0 0 0 window -1 1 -1 1\n"
#define ABOVE "camera orthographic eye 0 9 0 look 0 0 0 up 0 0 -1 window -1 1 -1 1\n"
#define BELOW "camera orthographic eye 0 -9 0 look 0 0 0 up 0 0 1 window -1 1 -1 1\n"
#define INSIDE(towards) "camera eye 0 0 0 look " towards " fov 60\n"
#define BOX "box min -1 -1 -1 max 1 1 1 material m\n"
#define TUBE "cylinder base 0 -1 0 top 0 1 0 radius 1 capped material m\n"
#define CONE "cone base 0 -1 0 top 0 1 0 radii 1 0.8 capped material m\n"
#define SAIL "mesh sail\nvertex -1 -1 0\nvertex 1 -1 0\nvertex 1 1 0\nvertex -1 1 0\nuv 0 0\nuv 1 0\nuv 1 1\nuv 0 1\n"

static const uint8_t texels[12] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};

static int fetch(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    (void)ctx, (void)name, (void)why;
    texture->width = texture->height = 2;
    texture->texels = texels;
    return TIA_OK;
}

static char letter(tia_rgb565 pixel)
{
    return pixel == 0xf800 ? 'R' : pixel == 0x07e0 ? 'G' : pixel == 0x001f ? 'B' : pixel == 0xffff ? 'W' : '.';
}

static void draw(const struct tia_scene *scene, tia_rgb565 pixels[SIDE * SIDE])
{
    const struct tia_tile all = {0, 0, SIDE, SIDE};
    const struct tia_surface surface = {.pixels = pixels, .step = sizeof *pixels, .pitch = SIDE * sizeof *pixels};
    size_t view_size = tia_view_size(scene, scene->light_count), hits_size = tia_hits_size(scene, all);
    void *view_memory = malloc(view_size), *hits_memory = malloc(hits_size);
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(tia_view_init(&view, view_memory, view_size, scene, scene->light_count, SIDE, SIDE, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, all), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, all, &surface, NULL), TIA_OK);
    free(view_memory);
    free(hits_memory);
}

/* Checks the colours at 3/8 of the window from its middle: upper left, upper right, lower left, lower right. */
static void check_seen(const char *camera, const char *field, const char *shape, const char *want)
{
    static const char head[] = "material m colour 1 texture t\nlight ambient\ntexture t image f ";
    char text[1000], seen[5] = "";
    tia_rgb565 pixels[SIDE * SIDE];

    (void)snprintf(text, sizeof text, "%s%s\n%s%s", head, field, camera, shape);
    struct reading r = {.reader = {.text = text, .length = strlen(text), .image = fetch}};
    read_begin(&r);
    CHECK_MSG(!r.status, "%s", r.reader.error.text);
    if (!r.status) {
        draw(&r.scene, pixels);
        for (int i = 0; i < 4; i++)
            seen[i] = letter(pixels[SIDE * (i < 2 ? 2 : 5) + (i % 2 ? 5 : 2)]);
    }
    CHECK_MSG(!strcmp(seen, want), "%s, not %s: %s%s", seen, want, camera, shape);
    read_end(&r);
}

/* At +x u is 1/2, and at +z 1/4: only the colours at the left are visible. */
TEST(sphere)
{
    check_seen(RIGHT, "", "sphere radius 1 material m\n", "RGBW");
    check_seen(FRONT, "", "sphere radius 1 material m\n", "RRBB");
    check_seen(BEHIND, "", "sphere radius 1 material m\n", "GGWW");
    check_seen(FRONT, "", "sphere radius 1 rotate 0 -90 0 material m\n", "RGBW");
    check_seen(INSIDE("1 0 0"), "", "sphere radius 1 material m\n", "GRWB");
    check_seen(ABOVE, "", "sphere radius 1 material m\n", "GGRR"); /* the back, -z, is above */
}

TEST(box)
{
    check_seen(FRONT, "", BOX, "RGBW");
    check_seen(BEHIND, "", BOX, "RGBW");
    check_seen(LEFT, "", BOX, "RGBW");
    check_seen(RIGHT, "", BOX, "RGBW");
    check_seen(ABOVE, "", BOX, "RGBW");
    check_seen(BELOW, "", BOX, "RGBW");
    check_seen(INSIDE("0 0 1"), "", BOX, "GRWB");
    check_seen(INSIDE("-1 0 0"), "", BOX, "GRWB");
}

TEST(grid)
{
    static const char *const cameras[] = {FRONT, BEHIND, LEFT, RIGHT, ABOVE, BELOW};

    for (size_t i = 0; i < sizeof cameras / sizeof *cameras; i++)
        check_seen(cameras[i], "", "grid g size 1 1 1 corner -1 -1 -1 cell 2\nrow 1\nend\ninstance g material m\n",
                   "RGBW");
}

static void check_round(const char *shape)
{
    check_seen(RIGHT, "", shape, "RGBW");
    check_seen(FRONT, "", shape, "RRBB");
    check_seen(BEHIND, "", shape, "GGWW");
    check_seen(INSIDE("1 0 0"), "", shape, "GRWB");
    check_seen(ABOVE, "", shape, "RGBW"); /* views of the caps */
    check_seen(BELOW, "", shape, "RGBW");
}

TEST(cylinder)
{
    check_round(TUBE);
    /* the axis lies along -x; U is then z, which is at the middle of the picture */
    check_seen("camera orthographic eye 0 0 9 look 0 0 0 up -1 0 0 window -1 1 -1 1\n", "",
               "cylinder base 1 0 0 top -1 0 0 radius 1 material m\n", "RGBW");
    check_seen(RIGHT, "", "cylinder base -1 0 0 top 1 0 0 radius 1 capped material m\n", "RGBW");
    check_seen(LEFT, "", "cylinder base -1 0 0 top 1 0 0 radius 1 capped material m\n", "RGBW");
}

TEST(cone)
{
    check_round(CONE);
}

TEST(disc)
{
    check_seen(FRONT, "", "disc normal 0 0 1 radius 1 material m\n", "RGBW");
    check_seen(BEHIND, "", "disc normal 0 0 1 radius 1 material m\n", "GRWB");
    check_seen(BEHIND, "", "disc normal 0 0 -1 radius 1 material m\n", "RGBW");
    check_seen(LEFT, "", "disc normal -1 0 0 radius 1 material m\n", "RGBW");
    check_seen(ABOVE, "", "disc normal 0 1 0 radius 1 material m\n", "RGBW");
    check_seen(BELOW, "", "disc normal 0 -1 0 radius 1 material m\n", "RGBW");
    check_seen(FRONT, "", "disc normal 0.2 -0.3 1 radius 1 material m\n", "RGBW");
}

/* A unit of the plane shows the picture once, from the plane's point on. */
TEST(plane)
{
    check_seen(FRONT, "repeat 0.5", "plane point -1 -1 0 normal 0 0 1 material m\n", "RGBW");
    check_seen(BEHIND, "repeat 0.5", "plane point -1 -1 0 normal 0 0 1 material m\n", "GRWB");
    check_seen(ABOVE, "repeat 0.5", "plane point -1 0 1 normal 0 1 0 material m\n", "RGBW");
    check_seen(BELOW, "repeat 0.5", "plane point -1 0 -1 normal 0 -1 0 material m\n", "RGBW");
    check_seen(RIGHT, "repeat 0.5", "plane point 0 -1 1 normal 1 0 0 material m\n", "RGBW");
}

/* The picture's lower left corner is at a, b is to the right of it, c above; the half beyond b and c is empty. */
TEST(triangle)
{
    check_seen(FRONT, "", "triangle a -2 -2 0 b 2.5 -2 0 c -2 2.5 0 material m\n", "R.BW");
    check_seen(BEHIND, "", "triangle a -2 -2 0 b 2.5 -2 0 c -2 2.5 0 material m\n", ".RWB");
}

TEST(mesh)
{
    check_seen(FRONT, "", SAIL "face 1/1 2/2 3/3 4/4\nend\ninstance sail material m\n", "RGBW");
    check_seen(BEHIND, "", SAIL "face 1/1 2/2 3/3 4/4\nend\ninstance sail material m\n", "GRWB");
}

/* Only at their centres do the texels keep their own colours. */
TEST(bilinear)
{
    check_seen(FRONT, "bilinear offset -0.0625 0.0625", "disc normal 0 0 1 radius 1 material m\n", "...W");
    check_seen(FRONT, "bilinear repeat 1.3333333 offset 0.125 0.125", "disc normal 0 0 1 radius 1 material m\n",
               "RGBW");
}

/* The pixel in the middle moves by half a picture to the right and up. */
TEST(offset_and_scale)
{
    check_seen(FRONT, "offset 0.5 0", "disc normal 0 0 1 radius 1 material m\n", "GRWB");
    check_seen(FRONT, "offset 0 0.5", "disc normal 0 0 1 radius 1 material m\n", "BWRG");
    check_seen(FRONT, "offset 0.25 0 repeat 2", "disc normal 0 0 1 radius 1 material m\n", "BWRG");
    check_seen(FRONT, "scale 2", "disc normal 0 0 1 radius 1 material m\n", "BBBB");
    check_seen(FRONT, "scale 2 offset 0.5 -0.5", "disc normal 0 0 1 radius 1 material m\n", "GRWB");
    check_seen(FRONT, "scale 1 2 offset 0 -1", "disc normal 0 0 1 radius 1 material m\n", "RGRG");
}

int main(void)
{
    RUN(sphere);
    RUN(box);
    RUN(grid);
    RUN(cylinder);
    RUN(cone);
    RUN(disc);
    RUN(plane);
    RUN(triangle);
    RUN(mesh);
    RUN(bilinear);
    RUN(offset_and_scale);
    return check_status();
}
