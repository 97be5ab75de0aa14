/* read_model.c - the readers of models, by format. */
#include "readers.h"

int tia_read_model(struct tia_reader *reader, struct tia_scene *scene, struct tia_arena *arena,
                   struct tia_model_use *use)
{
    switch (reader->format) {
    case TIA_FORMAT_OBJ:
        return tia_read_obj(reader, scene, arena, use);
    case TIA_FORMAT_STL:
        return tia_read_stl(reader, scene, arena, use);
    case TIA_FORMAT_PLY:
        return tia_read_ply(reader, scene, arena, use);
    case TIA_FORMAT_OFF:
        return tia_read_off(reader, scene, arena, use);
    case TIA_FORMAT_PGM:
        return tia_read_pgm(reader, scene, arena, use);
    default:
        return TIA_ERR_ARGUMENT;
    }
}
