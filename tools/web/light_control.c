/* light_control.c - the light that keys and the pointer can move. */
#include "page.h"

#include "common/views/projected.h"

uint32_t light_chosen(void)
{
    uint32_t count = session.state.light_count, first = session.state.light < count ? session.state.light : 0;
    uint32_t light = tia_viewer_key_light(&session.scene, session.lights.array + first, count - first, TIA_KEY_LEFT);

    return light == TIA_NO_LIGHT ? light : light + first;
}

static int32_t part_of(double pixels, unsigned size)
{
    double part = pixels / size * 65536;

    return (int32_t)(part < -1e9 ? -1e9 : part > 1e9 ? 1e9 : part);
}

void light_tell(struct web_frame *frame)
{
    uint32_t light = light_chosen();
    double ends[2][2];

    frame->light_count = session.state.light_count;
    frame->light = -1;
    if (light == TIA_NO_LIGHT || tia_light_has(session.lights.array[light].kind, TIA_LIGHT_FAR))
        return;
    frame->light = (int32_t)light;
    frame->light_x = frame->light_y = 0;
    struct tia_vec3 centre = session.lights.array[light].centre;
    if (!projected_segment(session_camera(), session.screen.width, session.screen.height, centre, centre, ends))
        return;
    frame->light_x = part_of(ends[0][0] + 0.5, session.screen.width);
    frame->light_y = part_of(ends[0][1] + 0.5, session.screen.height);
}

/* Drags the light. The last binding is the pointer's, so that a light that it moves counts as set by a key. */
bool light_drag(int32_t right, int32_t down)
{
    unsigned width = session.screen.width, height = session.screen.height;
    uint32_t light = light_chosen();

    if (light == TIA_NO_LIGHT || !session.bindings)
        return false;
    struct tia_light moved = session.lights.array[light];
    struct tia_scene alone = {.camera = *session_camera(), .lights = &moved, .light_count = 1};
    if (tia_light_has(moved.kind, TIA_LIGHT_FAR))
        return false;
    moved.centre =
        projected_dragged(&alone.camera, width, height, moved.centre, right / 65536.0 * width, down / 65536.0 * height);
    if (tia_scene_check(&alone, NULL))
        return false;
    session.bindings[session.scene.binding_count - 1] =
        (struct tia_binding){.key = WEB_DRAGGED, .light = (uint16_t)light, .state = moved};
    return true;
}
