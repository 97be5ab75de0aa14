/* model_view.c - the camera and the lights of models that have none. */
#include <tia/read.h>

#include "math/integer.h"

/* Components of the direction to the camera: 35 degrees to the right of +z and 25 degrees above the horizon. */
#define TOWARDS_X INT32_C(558170729) /* 0.519837; TIA_Q30(0.519837) would lose bits where double has only 32 */
#define TOWARDS_Y INT32_C(453782622) /* 0.422618 */
#define TOWARDS_Z INT32_C(797149151) /* 0.742403 */
/* The camera's distance in radii, 1/sin 20 degrees: the sphere around the model touches the edges of a field of view of
 * 40 degrees. */
#define DISTANCE TIA_Q16(2.9238044)

static void set_lights(struct tia_light lights[TIA_MODEL_LIGHTS])
{
    lights[0] = (struct tia_light){.emission = TIA_RGB(0.75, 0.75, 0.75),
                                   .kind = TIA_DIRECTIONAL_LIGHT,
                                   .direction = {TIA_Q30(0.36), TIA_Q30(-0.8), TIA_Q30(-0.48)}};
    lights[1] = (struct tia_light){.emission = TIA_RGB(0.25, 0.25, 0.25), .kind = TIA_AMBIENT_LIGHT};
}

struct tia_camera tia_model_view(struct tia_vec3 centre, uint64_t radius, struct tia_light lights[TIA_MODEL_LIGHTS])
{
    int64_t distance = (int64_t)((radius * (uint64_t)DISTANCE + 65535) >> 16);

    if (lights)
        set_lights(lights);
    return (struct tia_camera){.eye = {centre.x + (tia_q16)tia_round_shift(distance * TOWARDS_X, 30),
                                       centre.y + (tia_q16)tia_round_shift(distance * TOWARDS_Y, 30),
                                       centre.z + (tia_q16)tia_round_shift(distance * TOWARDS_Z, 30)},
                               .fov = TIA_Q16(40),
                               .reference = centre,
                               .up = {0, TIA_Q16_ONE, 0}};
}
