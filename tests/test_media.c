/* Rays through media: nested media, straight layers and shadows, each case worked out by hand, in fixed point, in
 * double precision and by the oracle. */
#include "media_scene.h"

static double tangent_of_sine(double sine)
{
    return sine / sqrt(1 - sine * sine);
}

/* Checks that the ray from the origin at 30 degrees, behind the layers, is at y = height where z = -depth: a lamp of
 * radius 0.01 is visible there, but not if it is moved by 0.025. */
static void arrives(double height, double depth)
{
    add_ball(height, -depth, 0.01, LAMP);
    see(0, 0, 0, 30, RED);
    shapes[scene.shape_count - 1].sphere.centre.y += Q16(0.025);
    see(0, 0, 0, 30, 0);
}

/* Tangents of the ray's angle in each medium: n sin is the same in all parallel layers, and sin is 1/2 in air, 1/3 in
 * glass, 2/5 in water. */
#define IN_AIR tangent_of_sine(0.5)
#define IN_GLASS tangent_of_sine(0.5 / 1.5)
#define IN_WATER tangent_of_sine(0.5 / 1.25)

TEST(water_in_glass)
{
    begin();
    add_slab(2, 6, GLASS);
    add_slab(3, 5, WATER);
    arrives(4 * IN_AIR + 2 * IN_GLASS + 2 * IN_WATER, 8);
}

/* A ray goes from an index to one eight times as large and back. */
TEST(water_in_what_is_thinner_than_air)
{
    double sine = sin(10 * DEGREES), in_air = tangent_of_sine(sine);

    begin();
    materials[AIR].index = TIA_Q16(0.25);
    materials[WATER].index = TIA_Q16(2);
    add_slab(2, 6, AIR);
    add_slab(3, 5, WATER);
    add_ball(4 * in_air + 2 * tangent_of_sine(sine / 0.25) + 2 * tangent_of_sine(sine / 2), -8, 0.01, LAMP);
    see(0, 0, 0, 10, RED);
}

/* Where two objects overlap, the one entered last counts until the ray leaves it. */
TEST(overlaps)
{
    begin();
    add_slab(2, 4, GLASS);
    add_slab(3, 5, WATER);
    arrives(5 * IN_AIR + 1 * IN_GLASS + 2 * IN_WATER, 8);
}

/* More objects are entered than a ray's list holds: the ninth is ignored, and the medium behind it is the eighth's. */
TEST(nine_deep)
{
    begin();
    for (int i = 0; i < TIA_MEDIA_MAX; i++)
        add_slab(1 + 0.125 * i, 9 - 0.125 * i, i % 2 ? GLASS : AIR);
    add_slab(3, 7, WATER);
    arrives(IN_AIR * (1 + 4 * 0.125 + 4 * 0.125 + 1) +
                IN_GLASS * (3 * 0.125 + 3 * 0.125 + 2 - 7 * 0.125 + 2 - 7 * 0.125) + 4 * IN_WATER,
            10);
}

/* A ray that passes concentric balls at the distance b from their centre is turned at each by the difference of
 * the angles there, whose sines are b/(n r), and is as far from the centre behind them. */
TEST(bubble)
{
    const double b = 0.5, outer = 1.2, inner = 0.7;
    double turned = 2 * (asin(b / outer) - asin(b / 1.5 / outer) + asin(b / 1.5 / inner) - asin(b / inner));

    begin();
    add_ball(0, -10, outer, GLASS);
    add_ball(0, -10, inner, AIR);
    /* behind the balls, 8 along the new direction from the point nearest to the centre; the ray has turned downwards by
     * `turned` */
    add_ball(b * cos(turned) - 8 * sin(turned), -10 - b * sin(turned) - 8 * cos(turned), 0.01, LAMP);
    see(0, b, 0, 0, RED);
    scene.shape_count = 3;
    shapes[2].sphere.centre.y += Q16(0.03);
    see(0, b, 0, 0, 0);
}

/* Glass within the same glass is invisible: no pixel changes. */
TEST(same_index)
{
    static tia_rgb565 with[64 * 64], without[64 * 64];
    static const struct tia_texture checker = {
        .kind = TIA_CHECKER, .repeat = {TIA_Q16(4), TIA_Q16(4)}, .cells = {TIA_RGB(1, 1, 1), TIA_RGB(0.2, 0, 0)}};

    begin();
    scene.camera.eye = (struct tia_vec3)TIA_VEC3(0, 1, 0);
    scene.camera.reference = (struct tia_vec3)TIA_VEC3(0, 0.5, -8);
    materials[FLOOR].texture = 1;
    materials[GLASS].fresnel = true;
    scene.textures = &checker;
    scene.texture_count = scene.light_count = 1;
    light.kind = TIA_AMBIENT_LIGHT;
    add(TIA_PLANE, FLOOR)->plane = (struct tia_plane){TIA_VEC3(0, -1, 0), {0, TIA_Q30(1), 0}};
    add_ball(0.3, -8, 1.2, GLASS);
    for (size_t i = 0; i < sizeof cores / sizeof cores[0]; i++) {
        scene.shape_count = 2;
        draw(cores[i], 64, without);
        add_ball(0.4, -8.2, 0.7, GLASS);
        draw(cores[i], 64, with);
        CHECK(without[32 * 64 + 32] != without[0]);
        for (int k = 0; k < 64 * 64; k++)
            CHECK_EQ(with[k], without[k]);
    }
}

/* A ray from an eye in a medium has entered nothing: from water it goes to index 1, then from glass to 1. */
TEST(eye_inside)
{
    double sine = 1.25 * 0.5;

    begin();
    add_slab(-4, 4, GLASS);
    add_slab(-2, 2, WATER);
    add_ball(2 * IN_AIR + 2 * tangent_of_sine(sine) + 3 * tangent_of_sine(1.5 * sine), -7, 0.02, LAMP);
    see(0, 0, 0, 30, RED);
}

/* A shape without an inside bends a ray, but the ray is still outside. */
TEST(open_shapes_are_not_entered)
{
    static const struct tia_vec3 corners[4] = {TIA_VEC3(-50, -50, 0), TIA_VEC3(50, -50, 0), TIA_VEC3(50, 50, 0),
                                               TIA_VEC3(-50, 50, 0)};
    static const struct tia_face faces[2] = {
        {{{0, TIA_NO_INDEX, TIA_NO_INDEX}, {1, TIA_NO_INDEX, TIA_NO_INDEX}, {2, TIA_NO_INDEX, TIA_NO_INDEX}}},
        {{{0, TIA_NO_INDEX, TIA_NO_INDEX}, {2, TIA_NO_INDEX, TIA_NO_INDEX}, {3, TIA_NO_INDEX, TIA_NO_INDEX}}}};
    static const struct tia_transform behind = {TIA_VEC3(0, 0, -1), TIA_VEC3(0, 0, 0), TIA_VEC3(1, 1, 1)};
    const double sine = 0.5 / 1.5 / 1.5; /* from 1 to 1.5 at the disc and at the mesh */

    begin();
    mesh = (struct tia_mesh){.vertices = corners, .faces = faces, .vertex_count = 4, .face_count = 2};
    scene.transforms = &behind;
    scene.mesh_count = 1;
    scene.transform_count = 1;
    add(TIA_DISC, GLASS)->disc = (struct tia_disc){TIA_VEC3(0, 0, -0.5), {0, 0, TIA_Q30(1)}, TIA_Q16(50)};
    add(TIA_MESH, GLASS)->transform = 1;
    add_slab(2, 6, WATER);
    arrives(0.5 * IN_AIR + 0.5 * IN_GLASS + 3 * tangent_of_sine(sine) + 4 * tangent_of_sine(sine / 1.25), 8);
}

/* Meshes of a box's faces, with each edge once in each direction, are entered: water in them is in glass. */
TEST(closed_meshes_are_entered)
{
    static const uint8_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    static struct tia_vec3 corners[8];
    static struct tia_face faces[12];

    begin();
    for (int i = 0; i < 8; i++)
        corners[i] = (struct tia_vec3){TIA_Q16(i & 1 ? 50 : -50), TIA_Q16(i & 2 ? 50 : -50), TIA_Q16(i & 4 ? -2 : -6)};
    for (int i = 0; i < 12; i++)
        for (int k = 0; k < 3; k++)
            faces[i].corner[k] = (struct tia_corner){quads[i / 2][k ? k + i % 2 : 0], TIA_NO_INDEX, TIA_NO_INDEX};
    mesh = (struct tia_mesh){.vertices = corners, .faces = faces, .vertex_count = 8, .face_count = 12};
    scene.mesh_count = 1;
    add(TIA_MESH, GLASS);
    add_slab(3, 5, WATER);
    arrives(4 * IN_AIR + 2 * IN_GLASS + 2 * IN_WATER, 8);
}

/* A ray goes from a cell of glass to one of water and out. */
TEST(cells)
{
    static const uint8_t cells[2] = {2, 1};

    begin();
    grid = (struct tia_grid){.corner = TIA_VEC3(-16, -16, -34), .cell = TIA_Q16(16), .size = {1, 1, 2}, .cells = cells};
    scene.grid_count = 1;
    add(TIA_GRID, GLASS)->transform = 1;
    scene.transforms = &(const struct tia_transform){TIA_VEC3(8, 8, 0), TIA_VEC3(0, 0, 0), TIA_VEC3(4, 4, 0.125)};
    scene.transform_count = 1;
    arrives((0.25 + 0.75) * IN_AIR + 2 * IN_GLASS + 2 * IN_WATER, 5);
}

static void add_panes(int count, uint32_t material)
{
    for (int i = 0; i < count; i++)
        add(TIA_DISC, material)->disc = (struct tia_disc){{0, 0, Q16(-1 - i / 64.0)}, {0, 0, TIA_Q30(1)}, TIA_Q16(9)};
}

/* Panes cost no reflection, but their number is limited. Halves of white: 1/2^6 is half a level of red. */
TEST(panes)
{
    begin();
    scene.depth = 1;
    scene.background = (struct tia_rgb)TIA_RGB(1, 1, 1);
    add_panes(TIA_LAYERS_MAX, PANE);
    see(0, 0, 0, 0, 0xffff);
    add_panes(1, PANE);
    shapes[TIA_LAYERS_MAX].disc.centre.z = Q16(-7);
    see(0, 0, 0, 0, 0);
    scene.shape_count = 5;
    materials[PANE].refraction = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
    see(0, 0, 0, 0, 1 << 11 | 2 << 5 | 1); /* 1/32 */
    materials[PANE].index = TIA_Q16(1.5);  /* now each pane is a refraction */
    see(0, 0, 0, 0, 0);
}

/* Two facing mirrors glow, with a pane before each: 1/4 (1 + 1/2 + 1/4 ...), one term more than the depth. */
TEST(panes_before_mirrors)
{
    begin();
    scene.depth = 3;
    materials[FLOOR] = (struct tia_material){.mirror = TIA_RGB(0.5, 0.5, 0.5), .emission = TIA_RGB(0.25, 0, 0)};
    add(TIA_PLANE, FLOOR)->plane = (struct tia_plane){TIA_VEC3(0, 0, -3), {0, 0, TIA_Q30(1)}};
    add(TIA_PLANE, FLOOR)->plane = (struct tia_plane){TIA_VEC3(0, 0, 3), {0, 0, TIA_Q30(-1)}};
    add_panes(2, PANE);
    shapes[3].disc.centre.z = Q16(2);
    see(0, 0, 0, 0, 15 << 11); /* 31 * 15/32 = 14.53 */
}

/* ---- shadows ---- */

/* Begins a wall at z = -4, with a light on the eye's side at z = -1. */
static void begin_shadow(void)
{
    begin();
    scene.light_count = 1;
    light.centre = (struct tia_vec3)TIA_VEC3(0, 0, -1);
    add(TIA_PLANE, FLOOR)->plane = (struct tia_plane){TIA_VEC3(0, 0, -4), {0, 0, TIA_Q30(1)}};
}

/* Adds `count` small faces at z = -2, -2.03, ... on the axis. */
static void add_faces(uint32_t count, const uint32_t *groups)
{
    static struct tia_vec3 corners[3 * 40];
    static struct tia_face faces[40];

    for (uint32_t i = 0; i < 3 * count; i++) {
        corners[i] = (struct tia_vec3){Q16(i % 3 == 1 ? 0.1 : -0.1), Q16(i % 3 == 2 ? 0.1 : -0.1),
                                       Q16(-2 - (double)(i / 3) * 0.03)};
        faces[i / 3].corner[i % 3] = (struct tia_corner){i, TIA_NO_INDEX, TIA_NO_INDEX};
    }
    mesh = (struct tia_mesh){
        .vertices = corners, .faces = faces, .vertex_count = 3 * count, .face_count = count, .groups = groups};
    scene.mesh_count = 1;
    add(TIA_MESH, PANE);
}

/* A mesh filters light once, and one with groups once for each group. The eye is behind the faces. */
TEST(groups_filter_one_by_one)
{
    static const uint32_t groups[5] = {7, 3, 7, 900000, 3};
    static uint32_t many[40];

    begin_shadow();
    add_faces(5, NULL);
    see(0, 0, -3, 0, 16 << 11 | 32 << 5 | 16); /* 1/2 */
    mesh.groups = groups;
    see(0, 0, -3, 0, 4 << 11 | 8 << 5 | 4); /* 1/8 */
    for (uint32_t i = 0; i < 30; i++)
        many[i] = i * 7919 % 29 + i / 29; /* 29 groups: as 29 is a prime, all of them, and one twice */
    materials[PANE].transmission = (struct tia_rgb)TIA_RGB(0.9, 0.95, 0.98);
    scene.shape_count = 1;
    add_faces(30, many);
    tia_rgb565 want = (tia_rgb565)((int)(31 * pow(0.9, 29) + 0.5) << 11 | (int)(63 * pow(0.95, 29) + 0.5) << 5 |
                                   (int)(31 * pow(0.98, 29) + 0.5));
    see(0, 0, -3, 0, want);
}

/* The shadow ray runs from 2^-13 above the wall to the light itself. A ball of 2^-10 just before the light is 2^-14
 * away from this ray. A ray from the same point, but parallel to the line from the wall itself, would end 2^-13 beside
 * the light and meet the ball. */
TEST(shadow_rays_end_in_the_light)
{
    const double bias = 1 / 8192.0, radius = 1 / 1024.0, along = 0.99;
    double y = 6, z = 1 - bias, length = sqrt(y * y + z * z), free = radius + bias / 2;

    begin_shadow();
    light.centre = (struct tia_vec3)TIA_VEC3(0, 6, -3);
    see(0, 0, -3, 0, 5 << 11 | 10 << 5 | 5); /* 1/sqrt(37) */
    add_ball(along * y - free * z / length, -4 + bias + along * z + free * y / length, radius, LAMP);
    see(0, 0, -3, 0, 5 << 11 | 10 << 5 | 5);
    shapes[1].sphere.centre.z -= Q16(bias); /* moved across the line by 2^-13 */
    see(0, 0, -3, 0, 0);
}

int main(void)
{
    RUN(water_in_glass);
    RUN(water_in_what_is_thinner_than_air);
    RUN(overlaps);
    RUN(nine_deep);
    RUN(bubble);
    RUN(same_index);
    RUN(eye_inside);
    RUN(open_shapes_are_not_entered);
    RUN(closed_meshes_are_entered);
    RUN(cells);
    RUN(panes);
    RUN(panes_before_mirrors);
    RUN(groups_filter_one_by_one);
    RUN(shadow_rays_end_in_the_light);
    return check_status();
}
