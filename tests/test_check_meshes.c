/* tia_scene_check on meshes and grids: each rule at its limit and one step beyond. */
#include "refused_shapes.h"

TEST(arrays_of_meshes)
{
    const char *rule = "an array with a count must not be NULL";

    set_up(TIA_BOX);
    meshes[0].vertices = NULL;
    check_refused("mesh", 0, "arrays", rule);
    set_up(TIA_BOX);
    meshes[0].normals = NULL;
    check_refused("mesh", 0, "arrays", rule);
    set_up(TIA_BOX);
    meshes[0].uvs = NULL;
    check_refused("mesh", 0, "arrays", rule);
    set_up(TIA_BOX);
    meshes[0].faces = NULL;
    check_refused("mesh", 0, "arrays", rule);
    set_up(TIA_BOX);
    meshes[0].face_count = (1u << 24) + 1;
    check_refused("mesh", 0, "faces", "must be at most 2^24");
    meshes[0] = (struct tia_mesh){.face_count = 0};
    check_accepted();
}

TEST(faces)
{
    const char *vertex = "each vertex must be the index of a vertex";
    const char *normal = "each normal must be the index of a normal, or none have one";
    const char *uv = "each uv must be the index of a uv, or none have one";

    for (int i = 0; i < 3; i++) {
        set_up(TIA_MESH);
        face.corner[i].vertex = 3;
        check_refused("mesh", 0, "face", vertex);
        face.corner[i].vertex = TIA_NO_INDEX;
        check_refused("mesh", 0, "face", vertex);
        face.corner[i].vertex = 0;
        check_accepted();
        face.corner[i].normal = 0;
        check_refused("mesh", 0, "face", normal);
        face.corner[i].normal = TIA_NO_INDEX;
        face.corner[i].uv = 0;
        check_refused("mesh", 0, "face", uv);
        for (int k = 0; k < 3; k++)
            face.corner[k].normal = face.corner[k].uv = 1;
        check_accepted();
        face.corner[i].normal = 2;
        check_refused("mesh", 0, "face", normal);
        face.corner[i].normal = TIA_NO_INDEX;
        check_refused("mesh", 0, "face", normal);
        face.corner[i].normal = 0;
        face.corner[i].uv = 2;
        check_refused("mesh", 0, "face", uv);
        face.corner[i].uv = TIA_NO_INDEX;
        check_refused("mesh", 0, "face", uv);
        normals[1].z = 5;
        check_refused("mesh", 0, "normal", LENGTH);
    }
}

TEST(grids_themselves)
{
    set_up(TIA_GRID);
    for (int i = 0; i < 3; i++) {
        uint16_t old = grids[0].size[i];
        grids[0].size[i] = 0;
        check_refused("grid", 0, "size", "must be in 1..1024");
        grids[0].size[i] = 1025;
        check_refused("grid", 0, "size", "must be in 1..1024");
        grids[0].size[i] = old;
    }
    for (int i = 0; i < 3; i++) {
        grids[0].size[i] = 257; /* 257 * 1024 * 1024 */
        grids[0].size[(i + 1) % 3] = grids[0].size[(i + 2) % 3] = 1024;
        check_refused("grid", 0, "size", "must be at most 2^28 cells in all");
    }
    set_up(TIA_GRID);
    grids[0].cell = 64;
    check_accepted();
    grids[0].cell = 63;
    check_refused("grid", 0, "cell", RADIUS);
    grids[0].cell = 100;
    scene.shape_count = 0;
    grids[0].corner = (struct tia_vec3){INT32_MAX - 200, INT32_MAX - 100, INT32_MAX - 200};
    check_accepted();
    for (int i = 0; i < 3; i++) {
        tia_q16 *along = i == 0 ? &grids[0].corner.x : i == 1 ? &grids[0].corner.y : &grids[0].corner.z;
        ++*along;
        check_refused("grid", 0, "cell", "all cells must end below 32768");
        --*along;
    }
    grids[0].cells = NULL;
    check_refused("grid", 0, "cells", "must not be NULL");
}

/* A grid of the largest size, with a fault in its last cells. */
TEST(the_largest_grid)
{
    static uint8_t many[1024 * 1024];

    set_up(TIA_GRID);
    grids[0].size[0] = grids[0].size[2] = 1024;
    grids[0].cells = many;
    check_accepted();
    many[sizeof many - 1] = 4;
    check_refused("shape", 0, "material", "there must be one for every cell");
}

TEST(indices_of_parts)
{
    set_up(TIA_MESH);
    shape->mesh = 1;
    check_refused("shape", 0, "mesh", "must be the index of a mesh");
    set_up(TIA_GRID);
    shape->grid = UINT32_MAX;
    check_refused("shape", 0, "grid", "must be the index of a grid");
}

TEST(materials_of_cells)
{
    const char *rule = "there must be one for every cell";

    set_up(TIA_GRID);
    cells[3] = 3;
    check_accepted();
    cells[3] = 4;
    check_refused("shape", 0, "material", rule);
    cells[3] = 1;
    cells[1] = 4;
    check_refused("shape", 0, "material", rule);
    cells[1] = 2;
    shape->material = 1;
    check_accepted();
    shape->material = 2;
    check_refused("shape", 0, "material", rule);
}

/* There are more meshes and grids than the check stores at a time: each shape has its own. */
TEST(many_meshes_and_grids)
{
    static struct tia_vec3 corners[PARTS][3];
    static uint8_t fills[PARTS][1];

    set_up(TIA_BOX);
    for (uint32_t i = 0; i < PARTS; i++) {
        corners[i][0] = corners[i][1] = corners[i][2] = (struct tia_vec3){0, 0, 0};
        meshes[i] = meshes[0];
        meshes[i].vertices = corners[i];
        grids[i] = (struct tia_grid){{0, 0, 0}, 64, {1, 1, 1}, fills[i]};
    }
    scene.mesh_count = scene.grid_count = scene.shape_count = PARTS;
    for (uint32_t i = 0; i < PARTS; i++) {
        for (uint32_t k = 0; k < PARTS; k++)
            shapes[k] = (struct tia_shape){.kind = TIA_MESH, .mesh = (k + 7) % PARTS};
        check_accepted();
        corners[i][2].x = INT32_MIN;
        check_refused("shape", (i + PARTS - 7) % PARTS, "place", FAR);
        corners[i][2].x = 0;
        for (uint32_t k = 0; k < PARTS; k++)
            shapes[k] = (struct tia_shape){.kind = TIA_GRID, .grid = (k + 9) % PARTS};
        check_accepted();
        fills[i][0] = 200;
        check_refused("shape", (i + PARTS - 9) % PARTS, "material", "there must be one for every cell");
        fills[i][0] = 0;
    }
}

int main(void)
{
    RUN(arrays_of_meshes);
    RUN(faces);
    RUN(grids_themselves);
    RUN(the_largest_grid);
    RUN(indices_of_parts);
    RUN(materials_of_cells);
    RUN(many_meshes_and_grids);
    return check_status();
}
