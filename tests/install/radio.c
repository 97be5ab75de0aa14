/* radio.c - a program that uses the installed library for radio waves, in C and in C++: counts the flat faces of a box.
 */
#include <stdio.h>
#include <tia/radio.h>

int main(void)
{
    static uint64_t memory[4096];
    static struct tia_material wall;
    static struct tia_shape box;
    static struct tia_scene scene;
    struct tia_radio *radio;
    const struct tia_vec3 corner = TIA_VEC3(4, 3, 2.5);

    box.kind = TIA_BOX;
    box.box.max = corner;
    scene.camera.fov = TIA_FOV_MIN;
    scene.materials = &wall;
    scene.material_count = 1;
    scene.shapes = &box;
    scene.shape_count = 1;
    if (tia_radio_size(&scene) > sizeof memory || tia_radio_init(&radio, memory, sizeof memory, &scene, NULL))
        return 1;
    printf("%u faces in %u planes\n", (unsigned)tia_radio_count(radio).faces, (unsigned)tia_radio_count(radio).planes);
    return 0;
}
