/* scene_texts.h - reads scenes from texts, with other files from memory, and checks what is read or refused. */
#ifndef TIA_TESTS_SCENE_TEXTS_H
#define TIA_TESTS_SCENE_TEXTS_H

#include "obj_files.h"

static struct reading now;
static struct files files;

static inline void read_scene(const char *text)
{
    read_end(&now);
    now = (struct reading){.reader = {.format = TIA_FORMAT_TIA,
                                      .text = text,
                                      .length = strlen(text),
                                      .library = fetch_library,
                                      .image = fetch_image,
                                      .ctx = &files}};
    read_begin(&now);
}

static inline void check_reads(const char *text)
{
    read_scene(text);
    CHECK_MSG(!now.status, "%.60s:%u:%u: %.150s: %.60s", now.reader.error.file, (unsigned)now.reader.error.line,
              (unsigned)now.reader.error.column, now.reader.error.text, text);
}

static inline void check_refused(const char *text, const char *error)
{
    read_scene(text);
    check_read_error(&now, error);
}

static inline bool is_vec(struct tia_vec3 v, double x, double y, double z)
{
    return v.x == TIA_Q16(x) && v.y == TIA_Q16(y) && v.z == TIA_Q16(z);
}

#define M "material m\n"

#endif
