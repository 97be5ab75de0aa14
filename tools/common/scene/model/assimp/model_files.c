#include "model_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* An open file: its bytes, which are freed with it. */
struct open_file {
    struct aiFile calls;
    struct whole whole;
    size_t at;
};

static void note(struct model_files *files, const char *path)
{
    struct stat status;
    struct model_input input = {.device = 0};

    if (stat(path, &status) != 0)
        return;
    input.device = (uint64_t)status.st_dev;
    input.inode = (uint64_t)status.st_ino;
    (void)snprintf(input.path, sizeof input.path, "%s", path);
    (void)pack_add(files->noted, &input);
}

int model_files_read(struct model_files *files, const char *path, struct whole *whole, const char **why)
{
    *why = SCENE_REFUSED;
    if (!scene_opens(files->file, path))
        return TIA_ERR_RANGE;
    int result = whole_read(whole, path, files->left, why);
    if (result)
        return result;
    files->left -= whole->length;
    note(files, path);
    return TIA_OK;
}

/* Reads a file of the model's folder or, with a path from the root, that one. */
static int read_beside(struct model_files *files, const char *name, struct whole *whole, const char **why)
{
    const char *model = files->file->path, *slash = strrchr(model, '/');
    int folder = slash && name[0] != '/' ? (int)(slash + 1 - model) : 0;
    char path[MODEL_PATH];

    (void)snprintf(path, sizeof path, "%.*s%s", folder, model, name);
    return model_files_read(files, path, whole, why);
}

int model_files_read_named(struct model_files *files, const char *name, struct whole *whole, const char **why)
{
    char slashed[1100];
    int status = read_beside(files, name, whole, why);

    if (status != TIA_ERR_DEVICE)
        return status;
    (void)snprintf(slashed, sizeof slashed, "%s", name);
    for (char *at = slashed; (at = strchr(at, '\\')) != NULL;)
        *at = '/';
    status = read_beside(files, slashed, whole, why);
    const char *last = strrchr(slashed, '/');
    return status == TIA_ERR_DEVICE && last ? read_beside(files, last + 1, whole, why) : status;
}

/* ---- for the library ---- */

static size_t read_file(struct aiFile *file, char *to, size_t size, size_t count)
{
    struct open_file *open = (void *)file->UserData;
    size_t left = size ? (open->whole.length - open->at) / size : 0, n = count < left ? count : left;

    if (n > 0)
        memcpy(to, open->whole.bytes + open->at, n * size);
    open->at += n * size;
    return n;
}

static size_t write_file(struct aiFile *file, const char *from, size_t size, size_t count)
{
    (void)file, (void)from, (void)size, (void)count;
    return 0;
}

static size_t tell_file(struct aiFile *file)
{
    return ((struct open_file *)(void *)file->UserData)->at;
}

static size_t size_file(struct aiFile *file)
{
    return ((struct open_file *)(void *)file->UserData)->whole.length;
}

/* Offsets are unsigned: a negative one wraps around, and so does the sum. */
static enum aiReturn seek_file(struct aiFile *file, size_t offset, enum aiOrigin origin)
{
    struct open_file *open = (void *)file->UserData;
    size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? open->at : open->whole.length;

    if (from + offset > open->whole.length)
        return aiReturn_FAILURE;
    open->at = from + offset;
    return aiReturn_SUCCESS;
}

static void flush_file(struct aiFile *file)
{
    (void)file;
}

static struct aiFile *open_named(struct aiFileIO *io, const char *path, const char *mode)
{
    struct model_files *files = (void *)io->UserData;
    struct open_file *open = strchr(mode, 'w') ? NULL : calloc(1, sizeof *open);
    const char *why;

    if (!open)
        return NULL;
    if (model_files_read(files, path, &open->whole, &why)) {
        free(open);
        return NULL;
    }
    open->calls = (struct aiFile){.ReadProc = read_file,
                                  .WriteProc = write_file,
                                  .TellProc = tell_file,
                                  .FileSizeProc = size_file,
                                  .SeekProc = seek_file,
                                  .FlushProc = flush_file,
                                  .UserData = (void *)open};
    return &open->calls;
}

/* The bytes count as left again: importers open a file several times. */
static void close_file(struct aiFileIO *io, struct aiFile *file)
{
    struct model_files *files = (void *)io->UserData;
    struct open_file *open = file ? (void *)file->UserData : NULL;

    if (!open)
        return;
    files->left += open->whole.length;
    free(open->whole.bytes);
    free(open);
}

void model_files_init(struct model_files *files, const struct scene_file *file, struct pack_array *noted)
{
    *files = (struct model_files){.file = file, .noted = noted, .left = SCENE_NAMED_MOST};
    files->io = (struct aiFileIO){.OpenProc = open_named, .CloseProc = close_file, .UserData = (void *)files};
}
