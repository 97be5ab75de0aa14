/* obj.c - scenes in the format .obj. */
#include "read/readers.h"

int tia_read_obj(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena)
{
    (void)scene, (void)arena;
    tia_say(&reader->error, "the format .obj cannot be read yet, expected .tia");
    return TIA_ERR_RANGE;
}

void tia_locate_obj(struct tia_reader *reader, const struct tia_fault *fault)
{
    (void)reader, (void)fault;
}
