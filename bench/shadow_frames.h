/* shadow_frames.h - measures whole frames of the scene in shadow_scene.h with each technique for shadows. */
#ifndef BENCH_SHADOW_FRAMES_H
#define BENCH_SHADOW_FRAMES_H

void bench_shadow_frames(void);

/* The same for scene files, beside traced rays. */
void bench_shadow_files(void);

#endif
