/* Textures filtered over the footprints of rays, on each shape. */
#include <math.h>

#include "footprint_draw.h"

#define TILES                                                                                                          \
    "filter footprint\ntexture tiles checker even 0.875 odd 0.125 repeat 400\nmaterial m texture tiles "               \
    "colour 1\nlight ambient emission 1\ncamera eye 0 0 8\n"

#define DOWN "filter footprint\nlight ambient emission 1\ncamera eye 0.25 1 0.4 look 2 -3.5 -4 fov 50\n"
#define TILED "texture tiles checker even 0.875 odd 0.125"

/* Draws a floor as a plane, a mesh or a triangle, whose coordinates continue beyond the edges. */
TEST(flat_shapes_are_as_planes)
{
    static const char *const floors[] = {
        DOWN TILED "\nmaterial m texture tiles colour 1\nplane normal 0 1 0 material m\n",
        DOWN TILED "\nmaterial m texture tiles colour 1\nmesh f\nvertex -4 0 8\nvertex 8 0 0\nvertex 2 0 -24\n"
                   "vertex -16 0 -8\nuv -4 -8\nuv 8 0\nuv 2 24\nuv -16 8\nface 1/1 2/2 3/3 4/4\nend\n"
                   "instance f material m\n",
        DOWN TILED " repeat 128\nmaterial m texture tiles colour 1\ntriangle a -32 0 64 b 96 0 64 c -32 0 -64 "
                   "material m\n",
        DOWN TILED "\nmaterial m texture tiles colour 1\nmesh f\nvertex -1 4 0\nvertex 1 4 0\nvertex 1 4 1\n"
                   "vertex -1 4 1\nuv -40 40\nuv 40 40\nuv 40 -20\nuv -40 -20\nface 1/1 2/2 3/3\nface 1/1 3/3 4/4\n"
                   "end\ninstance f at 0 -4 -40 scale 40 1 60 material m\n",
    };
    static double plane[PIXELS], red[PIXELS];

    draw_red(&tia_core_q16, floors[0], NULL, plane);
    for (size_t i = 1; i < sizeof floors / sizeof *floors; i++) {
        for (int k = 0; k < 2; k++) {
            draw_red(k ? &tia_core_f64 : &tia_core_q16, floors[i], NULL, red);
            for (int p = 0; p < PIXELS; p++)
                CHECK_MSG(fabs(red[p] - plane[p]) < 1e-3, "floor %zu, pixel %d %d: %.4f, not %.4f", i, p % WIDTH,
                          p / WIDTH, red[p], plane[p]);
        }
    }
}

/* Where cells are far smaller than pixels, a pixel inside the outline is their mean. */
TEST(shapes)
{
    static const char *const shapes[] = {
        TILES "sphere centre 0 0 0 radius 1 material m\n",
        TILES "box min -1 -1 -1 max 1 1 1 material m\n",
        TILES "disc centre 0 0 0 normal 0.3 0.2 1 radius 1.5 material m\n",
        TILES "cylinder base 0 -2 0 top 0 2 0 radius 1 material m\n",
        TILES "cone base 0 -2 0 top 0 3 0 radii 1 0 material m\n",
        TILES "cylinder base 0 0 -1 top 0 0 1 radius 1.5 capped material m\n",
        TILES "box min -1 -1 -1 max 1 1 1 material m rotate 20 30 0 scale 1.5\n",
        TILES "triangle a -4 -4 0 b 4 -4 0 c 0 6 0.5 material m\n",
        TILES "torus centre 1 0 0 axis 0.1 0.2 1 major 1 minor 0.8 material m\n",
        TILES "rounded min -1 -1 -1 max 1 1 1 radius 0.2 material m\n",
        TILES "difference\nbox min -1 -1 -1 max 1 1 1 material m\nsphere centre 0 0 2.5 radius 2 material m\nend\n",
        TILES "grid g size 1 1 1 corner -1 -1 -1 cell 2\nrow 1\nend\ninstance g material m\n",
    };
    static double red[PIXELS];

    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        draw_red(&tia_core_q16, shapes[i], NULL, red);
        for (int y = HEIGHT / 2 - 5; y < HEIGHT / 2 + 5; y++)
            for (int x = WIDTH / 2 - 5; x < WIDTH / 2 + 5; x++)
                CHECK_MSG(fabs(red[y * WIDTH + x] - 0.5) < 0.1, "shape %zu at %d %d: %.4f", i, x, y,
                          red[y * WIDTH + x]);
    }
}

/* Where u goes from 1 to 0, on a sphere's or cylinder's side towards -x, a picture is as on the opposite side. */
TEST(seams)
{
    static const char *const shapes[] = {"sphere centre 0 0 0 radius 1", "cylinder base 0 -2 0 top 0 2 0 radius 1",
                                         "cone base 0 -2 0 top 0 3 0 radii 1 0"};
    static double seam[PIXELS], opposite[PIXELS];
    char text[600];

    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        for (int side = 0; side < 2; side++) {
            (void)snprintf(
                text, sizeof text,
                "filter footprint\ntexture t checker even 0.875 odd 0.125 repeat 8\nlight ambient emission 1\n"
                "material m texture t colour 1\ncamera eye %d 0 0 look 0 0 0 fov 12\n%s material m\n",
                side ? 8 : -8, shapes[i]);
            draw_red(&tia_core_q16, text, NULL, side ? opposite : seam);
        }
        for (int k = 0; k < PIXELS; k++)
            CHECK_MSG(fabs(seam[k] - opposite[k]) < 1e-3, "shape %zu, pixel %d: %.4f, not %.4f", i, k, seam[k],
                      opposite[k]);
    }
}

int main(void)
{
    RUN(flat_shapes_are_as_planes);
    RUN(shapes);
    RUN(seams);
    return check_status();
}
