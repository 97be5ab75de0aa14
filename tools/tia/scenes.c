#include "scenes.h"

#include <stdio.h>
#include <string.h>

#include "arguments.h"
#include "common/message.h"
#include "fail.h"
#include "lightfield_setup.h"
#include "options_check.h"

/* Loads the scene `next` and closes the current one. Keys of --keys apply only to the first scene. */
static bool load(struct options *options, struct options *next, char *why)
{
    next->scene_format = options->format_of_scenes;
    next->file = (struct scene_file){.path = NULL};
    next->core = options->plain_core;
    next->key_text = NULL;
    fail_into(why, PORT_WHY);
    if (options->watch)
        file_watch_begin(options->watch);
    int status = check_scene(next);
    bool opened = !status;
    status = status ? status : arguments_load(next);
    fail_into(NULL, 0);
    if (status) {
        if (opened)
            scene_close(&next->file);
        return false;
    }
    if (options->watch)
        file_watch_end(options->watch);
    next->key_count = 0;
    scene_close(&options->file);
    *options = *next;
    light_attach(options);
    return true;
}

bool scenes_go(struct options *options, int step, char *why)
{
    struct options next = *options;
    int count = (int)options->scene_count;

    next.scene_index = (uint32_t)(((int)options->scene_index + step + count) % count);
    next.scene_path = options->scene_paths[next.scene_index];
    return load(options, &next, why);
}

bool scenes_read_again(struct options *options, char *why)
{
    struct options next = *options;

    return load(options, &next, why);
}

void scenes_next_view(struct options *options)
{
    options->views.view = (options->views.view + 1) % VIEW_COUNT;
    arguments_set_view(options);
}

void scenes_name(const struct options *options, char *name, size_t size)
{
    const char *path = options->scene_path ? options->scene_path : "", *slash = strrchr(path, '/');

    (void)snprintf(name, size, "%s", strcmp(path, "-") == 0 ? "standard input" : slash ? slash + 1 : path);
    message_clean(name);
}
