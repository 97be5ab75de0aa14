/* nff.c - scenes in the format .nff. */
#include "read/readers.h"

int tia_read_nff(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena)
{
    (void)scene, (void)arena;
    tia_say(&reader->error, "the format .nff cannot be read yet, expected .tia");
    return TIA_ERR_RANGE;
}

void tia_locate_nff(struct tia_reader *reader, const struct tia_fault *fault)
{
    (void)reader, (void)fault;
}
