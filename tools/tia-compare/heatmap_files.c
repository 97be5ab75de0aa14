#include "heatmap_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

/* Raises the limit of open files as far as the system allows, since each unfinished picture is an open file. */
static void allow_files(void)
{
    struct rlimit limit;

    if (getrlimit(RLIMIT_NOFILE, &limit) == 0) {
        limit.rlim_cur = limit.rlim_max;
        (void)setrlimit(RLIMIT_NOFILE, &limit);
    }
}

bool pictures_begin(struct pictures *pictures, const char *name, unsigned most)
{
    *pictures = (struct pictures){.name = name, .most = most, .why = "out of memory"};
    pictures->images = calloc(most, sizeof(struct image *));
    pictures->paths = calloc(most, sizeof(char *));
    allow_files();
    return pictures->images && pictures->paths;
}

/* Returns FILE.png, or FILE-N.png for the Nth of several frames. */
static char *path_of(const struct pictures *pictures)
{
    const char *name = pictures->name, *dot = strrchr(name, '.');
    int stem = (int)(dot && !strchr(dot, '/') ? dot - name : (ptrdiff_t)strlen(name));
    char *path;

    if (pictures->most == 1)
        return strdup(name);
    return asprintf(&path, "%.*s-%u%s", stem, name, pictures->count + 1, name + stem) >= 0 ? path : NULL;
}

int pictures_add(struct pictures *pictures, const struct heatmap *map)
{
    char *path = path_of(pictures);

    if (!path)
        return TIA_ERR_MEMORY;
    pictures->paths[pictures->count] = path;
    return heatmap_draw(map, path, pictures->why, &pictures->images[pictures->count++]);
}

int pictures_publish(struct pictures *pictures)
{
    int status = TIA_OK;

    for (unsigned i = 0; i < pictures->count && !status; i++) {
        status = image_publish(pictures->images[i]);
        pictures->images[i] = NULL;
    }
    return status;
}

void pictures_end(struct pictures *pictures)
{
    for (unsigned i = 0; i < pictures->count; i++) {
        if (pictures->images[i])
            image_discard(pictures->images[i]);
        free(pictures->paths[i]);
    }
    free(pictures->images);
    free(pictures->paths);
}
