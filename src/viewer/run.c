/* run.c - the viewer of any scene. */
#include "loop.h"
#include "scene/check/scene_check.h"

static const struct viewer_more more = {
    .check = tia_check_scene,
    .play_begin = tia_viewer_play_begin,
    .play = tia_viewer_play,
    .is_moving = tia_viewer_is_moving,
    .gaze = tia_viewer_gaze,
    .strip_rows = tia_viewer_strip_rows,
    .canvas_size = tia_viewer_canvas_size,
    .set_canvas = tia_viewer_set_canvas,
    .refines = tia_viewer_refines,
    .draw_passes = tia_viewer_draw_passes,
    .whole_us = tia_viewer_whole_us,
    .copy = tia_viewer_copy,
    .copy_last = tia_viewer_copy_last,
    .effect = tia_viewer_effect,
    .control = tia_viewer_control,
    .go_back = tia_viewer_go_back,
    .joins = tia_viewer_joins,
    .switch_shadows = tia_viewer_switch,
};

int tia_viewer_run(struct tia_viewer *viewer)
{
    return tia_viewer_loop(viewer, &tia_core_q16, &more);
}
