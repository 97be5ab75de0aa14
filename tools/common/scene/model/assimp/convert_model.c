/* convert_model.c - the steps of a conversion.
 *
 * A mesh that several nodes use is an instance of each, if the node's map has neither shear nor mirroring. The vertices
 * of others are placed by their node, and the faces of one material make one mesh, as those of an .obj file do. */
#include "convert_model.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <stdlib.h>

#include "convert.h"

/* ---- the library ---- */

#define STEPS                                                                                                          \
    (aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices | aiProcess_GenUVCoords |         \
     aiProcess_TransformUVCoords | aiProcess_ValidateDataStructure)

static int import(struct convert *c)
{
    struct aiPropertyStore *properties = c->library.create_properties();
    struct whole whole;
    const char *why;

    int status = model_files_read(&c->files, c->files.file->path, &whole, &why);
    if (status)
        return convert_fail(c, status, "%s", why);
    free(whole.bytes);
    c->files.left += whole.length;
    c->library.set_integer(properties, AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    c->from = c->library.import(c->files.file->path, STEPS, &c->files.io, properties);
    if (!c->from)
        return convert_fail(c, TIA_ERR_RANGE, "libassimp: %.400s", c->library.error());
    return TIA_OK;
}

static int convert_all(struct convert *c)
{
    int (*const steps[])(struct convert *) = {import,         convert_nodes,     convert_measure, convert_fit,
                                              convert_meshes, convert_materials, convert_view};

    for (size_t i = 0; i < sizeof steps / sizeof *steps; i++) {
        int status = steps[i](c);
        if (status)
            return status;
    }
    return TIA_OK;
}

int convert_model(int fd, const struct scene_file *file)
{
    static struct convert c;
    const char *why;

    pack_init(&c.pack);
    c.pack.header.status = MODEL_UNFINISHED;
    if (!pack_write(&c.pack, fd))
        return TIA_ERR_MEMORY;
    model_files_init(&c.files, file, &c.pack.arrays[MODEL_FILES]);
    if (!assimp_load(&c.library, &why))
        (void)convert_fail(&c, TIA_ERR_DEVICE, "%s", why);
    else if (!convert_all(&c))
        c.pack.header.status = TIA_OK;
    if (!pack_write(&c.pack, fd))
        (void)convert_exhausted(&c);
    else
        return c.pack.header.status;
    for (unsigned i = 0; i < MODEL_ARRAYS; i++)
        c.pack.arrays[i].count = 0;
    (void)pack_write(&c.pack, fd);
    return TIA_ERR_MEMORY;
}
