/* Opacity textures, in fixed point, in double precision and by the oracle: values worked out by hand. */
#include "media_scene.h"

static tia_rgb565 grey(double x)
{
    return (tia_rgb565)((int)(31 * x + 0.5) << 11 | (int)(63 * x + 0.5) << 5 | (int)(31 * x + 0.5));
}

static uint8_t texels[4];
static struct tia_texture texture;

/* Begins a scene with a white background; PANE has the opacity of one texel, and all other properties of a surface. */
static void begin_opacity(uint8_t value)
{
    begin();
    texels[0] = texels[1] = texels[2] = texels[3] = value;
    texture = (struct tia_texture){
        .kind = TIA_OPACITY, .repeat = {TIA_Q16_ONE, TIA_Q16_ONE}, .width = 2, .height = 2, .texels = texels};
    scene.textures = &texture;
    scene.texture_count = 1;
    scene.background = (struct tia_rgb)TIA_RGB(1, 1, 1);
    materials[PANE] = (struct tia_material){.opacity = 1};
}

static struct tia_shape *add_disc(double z, uint32_t material)
{
    struct tia_shape *s = add(TIA_DISC, material);

    s->disc = (struct tia_disc){{0, 0, Q16(z)}, {0, 0, TIA_Q30(1)}, TIA_Q16(9)};
    return s;
}

/* Where the opacity is 0, there is no surface, whatever its material. */
TEST(holes)
{
    begin_opacity(0);
    for (int i = 0; i < 3; i++)
        add_disc(-1 - i, i < 2 ? PANE : GLASS);
    materials[GLASS].opacity = materials[LAMP].opacity = 1;
    materials[GLASS].fresnel = true;
    materials[PANE].colour = materials[PANE].emission = materials[PANE].facing = (struct tia_rgb)TIA_RGB(1, 0, 0);
    materials[PANE].mirror = materials[PANE].specular = (struct tia_rgb)TIA_RGB(1, 0, 0);
    materials[PANE].exponent = TIA_Q16(1);
    add_ball(0, -10, 2, LAMP);
    scene.light_count = 1;
    see(0, 0, 0, 0, 0xffff);
    see(0, 0, 0, 30, 0xffff);
    memset(texels, 255, sizeof texels);
    see(0, 0, -5, 0, RED);
    for (int bilinear = 0; bilinear < 2; bilinear++) { /* texels are counted from the upper left */
        texture.bilinear = bilinear;
        memset(texels, 0, sizeof texels);
        scene.shape_count = 0;
        add_disc(-1, LAMP);
        texels[1] = 255;
        see(0, -4.5, 0, 0, 0xffff);
        see(-0.5, 4.5, 0, 0, bilinear ? 31 << 11 | 35 << 5 | 17 : 0xffff);
        see(0.5, 4.5, 0, 0, bilinear ? 31 << 11 | 28 << 5 | 14 : RED); /* 1/2, and 1/18 of it more: u = 1/2 + 1/36 */
    }
}

/* A half opacity shows half of the surface's colour and half of the background. */
TEST(halves)
{
    begin_opacity(128);
    add_disc(-1, PANE);
    see(0, 0, 0, 0, grey(127 / 255.0));
    materials[PANE].emission = (struct tia_rgb)TIA_RGB(1, 1, 1);
    see(0, 0, 0, 0, 0xffff);
    scene.background = (struct tia_rgb)TIA_RGB(0, 0, 0);
    see(0, 0, 0, 0, grey(128 / 255.0));
    materials[PANE] = (struct tia_material){.mirror = TIA_RGB(1, 1, 1), .opacity = 1};
    add_disc(5, LAMP); /* behind the eye */
    see(0, 0, 0, 0, 16 << 11);
    scene.background = (struct tia_rgb)TIA_RGB(1, 1, 1);
    materials[PANE] = materials[AIR]; /* refracted straight on: 128/255 of 0.5, and the rest of the light */
    materials[PANE].refraction = (struct tia_rgb)TIA_RGB(0.5, 0, 1);
    materials[PANE].opacity = 1;
    see(0, 0, 0, 0, 23 << 11 | 31 << 5 | 31);
}

/* The layers of a tree's leaves lie behind one another; one more is too many. */
TEST(layers)
{
    begin_opacity(0);
    scene.depth = 1;
    for (int i = 0; i < TIA_LAYERS_MAX; i++)
        add_disc(-1 - i / 64.0, PANE);
    see(0, 0, 0, 0, 0xffff);
    add_disc(-7, PANE);
    see(0, 0, 0, 0, 0);
}

/* Each surface spawns three rays: mirrored, refracted and past it; the first two have 16 bounces. */
TEST(three_ways)
{
    tia_rgb565 want = 0;

    begin_opacity(128);
    materials[GLASS].opacity = 1;
    materials[GLASS].mirror = (struct tia_rgb)TIA_RGB(0.25, 0.25, 0.25);
    scene.background = (struct tia_rgb)TIA_RGB(0.5, 0.5, 0.5);
    add_disc(-1, GLASS);
    see(0, 0, 0, 0, grey(0.5 + 0.25 * 128 / 255 * 0.5));
    for (int i = 1; i < 20; i++)
        add_disc(-1 - i, GLASS);
    draw(&oracle_core, 1, &want);
    CHECK(want);
    see(0, 0, 0, 0, want);
}

/* A ball of glass with holes acts as two panes: no ray is ever inside it. Otherwise rays would go from glass to
 * glass. */
TEST(media)
{
    begin_opacity(255);
    scene.background = (struct tia_rgb)TIA_RGB(0, 0, 0);
    materials[GLASS].opacity = materials[WATER].opacity = 1;
    materials[WATER].index = materials[GLASS].index;
    add_ball(0, -4, 2, GLASS);
    add_ball(0, -4, 1, WATER);
    add_ball(0, -40, 1, LAMP);
    see(0, 0, 0, 0, RED);
    materials[PANE] = materials[GLASS]; /* a slab: at 40 degrees a ray leaves it in its old direction */
    scene.shape_count = 0;
    double shift = 1 * (tan(40 * DEGREES) - tan(asin(sin(40 * DEGREES) / 1.5)));
    add_slab(2, 3, PANE);
    add_ball(10 * tan(40 * DEGREES) - shift, -10, 0.05, LAMP);
    see(0, 0, 0, 40, RED);
    memset(texels, 0, sizeof texels);
    see(0, 0, 0, 40, 0);
    shapes[1].sphere.centre.y += Q16(shift);
    see(0, 0, 0, 40, RED);
}

/* ---- shadows ---- */

/* Begins a wall at z = -4 with a light at z = -1 before it, seen from z = -3. */
static void begin_shadow(uint8_t value)
{
    begin_opacity(value);
    scene.light_count = 1;
    light.centre = (struct tia_vec3)TIA_VEC3(0, 0, -1);
    add(TIA_PLANE, FLOOR)->plane = (struct tia_plane){TIA_VEC3(0, 0, -4), {0, 0, TIA_Q30(1)}};
}

/* Each surface filters the light, including several of one object; without opacity an object filters it once. */
TEST(shadows_surface_by_surface)
{
    const double o = 51 / 255.0;

    begin_shadow(51);
    add_disc(-2, PANE);
    see(0, 0, -3, 0, grey(1 - o));
    shapes[1] = (struct tia_shape){.kind = TIA_SPHERE, .material = PANE};
    shapes[1].sphere.centre.z = TIA_Q16(-2);
    shapes[1].sphere.radius = TIA_Q16(0.5);
    see(0, 0, -3, 0, grey((1 - o) * (1 - o)));
    materials[PANE].transmission = (struct tia_rgb)TIA_RGB(0.25, 0.25, 0.25);
    see(0, 0, -3, 0, grey((1 - 0.75 * o) * (1 - 0.75 * o)));
    materials[PANE].opacity = 0;
    see(0, 0, -3, 0, grey(0.25));
    materials[PANE].opacity = 1;
    add_disc(-1.25, PANE);
    see(0, 0, -3, 0, grey((1 - 0.75 * o) * (1 - 0.75 * o) * (1 - 0.75 * o)));
    memset(texels, 255, sizeof texels);
    see(0, 0, -3, 0, grey(0.25 * 0.25 * 0.25));
    materials[PANE].transmission = (struct tia_rgb)TIA_RGB(0, 0, 0);
    see(0, 0, -3, 0, 0);
}

/* From a ball around the light, only the surface before the light counts, not its inside. */
TEST(shadows_end_in_the_light)
{
    begin_shadow(51);
    shapes[1] = (struct tia_shape){.kind = TIA_SPHERE, .material = PANE};
    shapes[1].sphere.centre.z = TIA_Q16(-1);
    shapes[1].sphere.radius = TIA_Q16(0.5);
    scene.shape_count = 2;
    see(0, 0, -3, 0, grey(0.8));
    shapes[1].sphere.radius = TIA_Q16(9);
    see(0, 0, -3, 0, 0xffff);
}

/* The shadow of a screen has full light where the screen's lower half has holes. */
TEST(shadows_have_holes)
{
    begin_shadow(255);
    texels[2] = texels[3] = 0;
    add_disc(-2, PANE);
    shapes[1].disc.radius = TIA_Q16(2);
    light.kind = TIA_DIRECTIONAL_LIGHT;
    light.direction = (struct tia_dir3){0, 0, -TIA_Q30_ONE};
    see(0, 1, -3, 0, 0);
    see(0, -1, -3, 0, 0xffff);
    see(0, -2.25, -3, 0, 0xffff);
    light.direction = (struct tia_dir3){0, TIA_Q30(-0.6), TIA_Q30(-0.8)}; /* from (-1, -4) through (0.5, -2) */
    see(0, -1, -3, 0, grey(0));
    see(0, -3, -3, 0, grey(0.8));
}

/* A grid has five cells along the axis: three with opacity and, between them, two of a material that filters the light
 * once for both. */
TEST(shadows_of_cells)
{
    static const uint8_t cells[] = {1, 2, 1, 2, 1};
    const double o = 51 / 255.0;

    begin_shadow(51);
    grid = (struct tia_grid){TIA_VEC3(-0.1, -0.1, -2), TIA_Q16(0.2), {1, 1, 5}, cells};
    scene.grid_count = 1;
    materials[FLOOR] = (struct tia_material){.transmission = TIA_RGB(0.5, 0.5, 0.5)};
    materials[AIR] = (struct tia_material){.colour = TIA_RGB(1, 1, 1)};
    shapes[0].material = AIR;
    add(TIA_GRID, PANE);
    /* whole objects towards the light: two cells, and of the first both front and back */
    see(0, 0, -3, 0, grey(0.5 * pow(1 - o, 4)));
}

/* Shadow rays pass as many layers as a ray from the eye. */
TEST(shadows_of_many_layers)
{
    static struct tia_vec3 corners[3 * (TIA_LAYERS_MAX + 1)];
    static struct tia_face faces[TIA_LAYERS_MAX + 1];

    begin_shadow(0);
    for (uint32_t i = 0; i < 3 * (TIA_LAYERS_MAX + 1); i++) {
        corners[i] = (struct tia_vec3){Q16(i % 3 == 1 ? 0.1 : -0.1), Q16(i % 3 == 2 ? 0.1 : -0.1),
                                       Q16(-1.5 - (double)(i / 3) / 512)};
        faces[i / 3].corner[i % 3] = (struct tia_corner){i, TIA_NO_INDEX, TIA_NO_INDEX};
    }
    mesh = (struct tia_mesh){.vertices = corners, .faces = faces, .vertex_count = 3 * (TIA_LAYERS_MAX + 1)};
    mesh.face_count = TIA_LAYERS_MAX;
    scene.mesh_count = 1;
    add(TIA_MESH, PANE);
    see(0, 0, -3, 0, 0xffff);
    mesh.face_count++;
    see(0, 0, -3, 0, 0);
}

int main(void)
{
    RUN(holes);
    RUN(halves);
    RUN(layers);
    RUN(three_ways);
    RUN(media);
    RUN(shadows_surface_by_surface);
    RUN(shadows_end_in_the_light);
    RUN(shadows_have_holes);
    RUN(shadows_of_cells);
    RUN(shadows_of_many_layers);
    return check_status();
}
