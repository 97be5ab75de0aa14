#include <inttypes.h>
#include <stdio.h>
#include <tia/step.h>
#include <tia/tia.h>

static char text[] = "camera eye 0 1 9\nmaterial m colour 1\nplane point 0 0 0 normal 0 1 0 material m\n"
                     "sphere name ball centre 0 5 0 radius 1 material m\ngravity 0 -9.75 0 until 60\n"
                     "fall ball restitution 0.9\n";
static uint64_t scene_memory[1000], memory[100];

int main(void)
{
    struct tia_reader reader = {.format = TIA_FORMAT_TIA, .text = text, .length = sizeof text - 1};
    const struct tia_push kick = {0, TIA_VEC3(1, 0, 0)};
    struct tia_scene scene;
    struct tia_steps steps;
    size_t need;

    if (tia_read(&reader, &scene, scene_memory, sizeof scene_memory, &need) ||
        tia_steps_init(&steps, memory, sizeof memory, &scene))
        return 1;
    for (int n = 1; n <= 1024 && !tia_scene_step(&steps, &kick, n % 256 == 1); n++)
        if (n % 256 == 0)
            printf("%d s: %016" PRIx64 "\n", n / 256, tia_steps_hash(&steps));
    return 0;
}
