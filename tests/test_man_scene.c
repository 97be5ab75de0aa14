/* The examples of tia-scene(5): each is a scene, and together they show every statement. */
#include "reading.h"

static const uint8_t texels[3];

static int fetch(void *ctx, const char *name, struct tia_texture *texture, const char **why)
{
    (void)ctx, (void)name, (void)why;
    texture->width = texture->height = 1;
    texture->texels = texels;
    return TIA_OK;
}

static int fetch_opacity(void *ctx, const char *name, enum tia_channel channel, struct tia_texture *texture,
                         const char **why)
{
    (void)channel;
    return fetch(ctx, name, texture, why);
}

/* Fetches the files that the page's scenes include and take a mesh from. */
static int fetch_chair(void *ctx, const char *name, const char **text, size_t *length, const char **why)
{
    (void)ctx;
    *why = "no such file";
    *text = strcmp(name, "models/dragon.off") ? "box min 0 0 0 max 1 1 1 material wood\n"
                                              : "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    *length = strlen(*text);
    return strcmp(name, "models/chair.tia") && strcmp(name, "models/dragon.off") ? TIA_ERR_DEVICE : TIA_OK;
}

static char examples[65536];

/* Copies a line of an example as the page shows it: "\-" is "-", "\e" a backslash. */
static char *copy_line(char *to, const char *line, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (line[i] == '\\' && i + 1 < length)
            *to++ = line[++i] == 'e' ? '\\' : line[i];
        else
            *to++ = line[i];
    return to;
}

static void check_example(const char *example)
{
    struct reading r = {.reader = {.text = example,
                                   .length = strlen(example),
                                   .library = fetch_chair,
                                   .image = fetch,
                                   .opacity = fetch_opacity}};

    read_begin(&r);
    CHECK_MSG(!r.status, "%u:%u: %s: %.60s", (unsigned)r.reader.error.line, (unsigned)r.reader.error.column,
              r.reader.error.text, example);
    read_end(&r);
}

static unsigned check_page(const char *page)
{
    unsigned count = 0;
    char *start = NULL, *end = examples + 1;

    examples[0] = '\n';
    for (const char *line = page; *line; line += strcspn(line, "\n") + 1) {
        if (!strncmp(line, ".Bd -literal", 12)) {
            start = end;
            count++;
        } else if (!strncmp(line, ".Ed", 3) && start) {
            *end = 0;
            check_example(start);
            start = NULL;
        } else if (start) {
            end = copy_line(end, line, strcspn(line, "\n") + 1);
        }
    }
    return count;
}

TEST(examples_are_scenes)
{
    static const char *const words[] = {"camera",  "samples",  "background", "depth",    "material", "texture",
                                        "sphere",  "plane",    "disc",       "cylinder", "cone",     "box",
                                        "mesh",    "triangle", "instance",   "grid",     "light",    "key",
                                        "animate", "group",    "define",     "include"};
    size_t length = 0;
    char *page = load_file("man/tia-scene.5", &length), line[20];

    CHECK(page && length < sizeof examples);
    if (!page || length >= sizeof examples)
        return;
    CHECK(check_page(page) > 15);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        (void)snprintf(line, sizeof line, "\n%s ", words[i]);
        CHECK_MSG(strstr(examples, line), "no example of %s", words[i]);
    }
    CHECK(strstr(examples, " opacity leaf.png") && strstr(examples, " opacity holes\n"));
    free(page);
}

int main(void)
{
    RUN(examples_are_scenes);
    return check_status();
}
