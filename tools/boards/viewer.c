/* viewer.c - tia's viewer as the only program of a board with a panel and a keyboard. Reports on the serial line. Shows
 * the built-in scene; or SCENE, the symbol of a linked scene that tia-compile has written. */
#include "boards/panel_board.h"
#include <tia/tia.h>

#ifndef SCENE
#define SCENE tia_thesis_scene
#endif
extern const struct tia_scene SCENE;

enum { LIGHTS = 4, ARENA = 8 << 20 };

static uint64_t arena[ARENA / sizeof(uint64_t)];
static uint32_t frames;

static void *take_arena(void *ctx, size_t size)
{
    (void)ctx;
    return size <= ARENA ? arena : NULL;
}

static int tell_frame(void *ctx, const struct tia_frame *frame)
{
    (void)ctx;
    if (frame->block > 1)
        return TIA_OK;
    frames = frame->number + 1;
    board_print("frame ");
    board_print_number(frame->number);
    board_print(frame->relit ? ": relit in " : ": traced in ");
    board_print_number((uint32_t)frame->draw_us);
    board_print(" us\n");
    return TIA_OK;
}

static int view(const char **why)
{
    struct tia_light lights[LIGHTS];
    struct tia_scene scene = SCENE;
    struct tia_viewer viewer = {
        .scene = &scene,
        .lights = {.array = lights, .capacity = LIGHTS},
        .ports = {.display = &panel_display,
                  .display_ctx = why,
                  .input = &panel_keyboard,
                  .input_ctx = why,
                  .clock = &board_clock},
        .hooks = {.memory = take_arena, .frame_done = tell_frame},
    };
    struct tia_mode mode;
    scene.camera.samples = 1; /* one ray per pixel, since such a processor has no time for more */
    int status = panel_keyboard.open(why);
    if (!status)
        status = panel_display.open(why, &mode);
    if (!status)
        status = tia_viewer_run(&viewer);
    panel_display.close(why);
    panel_keyboard.close(why);
    return status;
}

int main(void)
{
    const char *why = "viewer: failed";
    board_print("tia " TIA_VERSION " on ");
    board_print(panel_board.name);
    board_print(": a, d, s, w put the light, arrows and page keys move it, any other key quits\n");
    int status = view(&why);
    if (!status) {
        board_print("a key ended the viewer after ");
        board_print_number(frames);
        board_print(" frames, stack ");
        board_print_number(board_stack_used());
        board_print(" bytes\n");
    } else {
        board_print(why);
        board_print("\n");
    }
    return -status;
}
