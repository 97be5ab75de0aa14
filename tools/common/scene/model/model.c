#include "model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "common/checksum.h"
#include "common/inputs.h"
#include "model_map.h"

/* The extensions of libassimp 5.2 and its optional importers, without those of formats that tia reads itself. */
static const char extensions[] =
    " 3d 3ds 3mf ac ac3d acc amf ase ask assbin b3d blend bsp bvh cob csm dae dxf enff fbx glb gltf hmp ifc ifczip iqm "
    "irr irrmesh lwo lws lxo m3d md2 md3 md5anim md5camera md5mesh mdc mdl mesh mot ms3d ndo ogex pk3 pmx prj "
    "q3o q3s raw scn sib smd step stp ter uc vrml vta wrl x x3d x3db xgl xml zae zgl ";

bool model_is_extension(const char *extension)
{
    size_t length = strlen(extension);

    for (const char *at = extensions + 1; *at; at = strchr(at, ' ') + 1)
        if (strncasecmp(at, extension, length) == 0 && at[length] == ' ')
            return length > 0;
    return false;
}

#ifdef TIA_HAVE_ASSIMP
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <tia/fit.h>

#include "assimp/import.h"

/* Maps the file `fd`, which the importing process wrote. The file must not change while it is mapped. */
static int map_file(struct scene_file *file, int fd)
{
    struct stat status;

    if (fstat(fd, &status) != 0 || (uint64_t)status.st_size < sizeof(struct model_header))
        return TIA_ERR_RANGE;
    void *map = mmap(NULL, (size_t)status.st_size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (map == MAP_FAILED)
        return TIA_ERR_MEMORY;
    file->map = map;
    file->map_bytes = (size_t)status.st_size;
    return TIA_OK;
}

static int say(struct scene_file *file, int status, const char *why)
{
    (void)snprintf(file->why, SCENE_WHY, "%.300s: %.*s", file->path, MODEL_WHY, why);
    return status;
}

/* Passes on the files that the importing process has read. What it asked scene_opens about was forgotten with it. */
static void take_files(const struct scene_file *file, const struct model_header *header)
{
    const struct model_input *inputs = model_map_array(header, MODEL_FILES);

    for (uint64_t i = 0; i < header->count[MODEL_FILES]; i++) {
        inputs_add(&(struct stat){.st_dev = inputs[i].device, .st_ino = inputs[i].inode});
        if (memchr(inputs[i].path, '\0', sizeof inputs[i].path) && strcmp(inputs[i].path, file->path) != 0)
            (void)scene_opens(file, inputs[i].path);
    }
}

/* Returns the CRC of the scene: of all but warnings and names of files, which depend on the model's folder. */
static uint32_t scene_crc(const struct model_header *header)
{
    const char *from = (const char *)&header->camera, *to = model_map_array(header, MODEL_FILES);
    uint32_t crc = checksum_bytes(0, (const char *)&header->scale_bits, sizeof header->scale_bits);

    return checksum_bytes(crc, from, (size_t)(to - from));
}

/* Passes on what the importing process knows besides the scene. */
static void take_notes(struct scene_file *file, const struct model_header *header)
{
    const struct model_name *names = model_map_array(header, MODEL_NAMES);

    memcpy(file->warnings, header->warnings, sizeof file->warnings);
    take_files(file, header);
    for (uint32_t i = 0; file->wish->material && i < header->count[MODEL_NAMES]; i++)
        file->wish->material(file->wish->ctx, i, names[i].text);
    if (file->wish->hashed)
        file->crc = scene_crc(header);
}

static int check_scene(struct scene_file *file)
{
    struct tia_fault fault;
    char why[MODEL_WHY];
    int status = tia_scene_check(&file->scene, &fault);

    if (!status)
        return TIA_OK;
    (void)snprintf(why, sizeof why, "%s %u: %s%s%s", fault.thing, fault.index, fault.field, *fault.field ? ": " : "",
                   fault.rule);
    return say(file, status, why);
}

static int take(struct scene_file *file, bool strict)
{
    const struct model_header *header = file->map;
    int status = model_map(&file->scene, &file->tables, header, file->map_bytes);
    char line[SCENE_WHY];

    if (status)
        return say(file, status, status == TIA_ERR_MEMORY ? "memory: exhausted" : "the import is damaged");
    take_notes(file, header);
    for (unsigned i = 0; strict && i < TIA_WARNINGS; i++)
        if (header->warnings[i].count) {
            (void)snprintf(line, sizeof line, "%s", header->warnings[i].at.text);
            return say(file, TIA_ERR_RANGE, line);
        }
    file->placement = header->placement;
    tia_camera_alter(&file->scene.camera, file->wish->camera, &file->placement);
    return check_scene(file);
}

int model_open(struct scene_file *file, bool strict)
{
    struct import_result result;

    if (!scene_opens(file, file->path))
        return say(file, TIA_ERR_DEVICE, SCENE_REFUSED);
    int status = import_run(&result, file);
    if (!status)
        status = map_file(file, result.fd);
    if (result.fd >= 0)
        (void)close(result.fd);
    if (result.why[0] != '\0')
        return say(file, status, result.why);
    return status ? say(file, status, "memory: exhausted") : take(file, strict);
}

void model_confine(void)
{
    import_here();
}

void model_close(struct scene_file *file)
{
    if (file->map)
        (void)munmap(file->map, file->map_bytes);
    free(file->tables);
    file->map = file->tables = NULL;
}
#else
void model_confine(void) {}

int model_open(struct scene_file *file, bool strict)
{
    (void)strict;
    (void)snprintf(file->why, SCENE_WHY, "%.300s: built without libassimp, which reads such files", file->path);
    return TIA_ERR_DEVICE;
}

void model_close(struct scene_file *file)
{
    (void)file;
}
#endif
