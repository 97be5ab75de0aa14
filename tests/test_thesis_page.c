/* The figures of docs/thesis.md: the number of pixels of the built-in scene that change where tia differs from the
 * texts that it is based on. The oracle draws both pictures. */
#include "check.h"
#include "common/corpus/corpus.h"
#include "oracle/oracle.h"

#include <math.h>

#include <tia/viewer.h>

enum { WIDTH = 640, HEIGHT = 480, PIXELS = WIDTH * HEIGHT, KEYS = 3, FIRST_MOVE = 18, MOVES = 5 };

#define PI 3.14159265358979323846

static const char *const keys[KEYS] = {"a", "s", "w"}; /* key d's pictures are mirror images of key a's */
static struct oracle_pixel pictures[KEYS][PIXELS];
static char page[1 << 16];

static bool read_page(void)
{
    FILE *file = fopen("docs/thesis.md", "r");
    size_t size = file ? fread(page, 1, sizeof page - 1, file) : 0;

    page[size] = '\0';
    return file && !fclose(file) && size > 0 && size < sizeof page - 1;
}

static void check_page(const char *text)
{
    CHECK_MSG(strstr(page, text) != NULL, "docs/thesis.md does not have: %s", text + strspn(text, "\n"));
}

static struct oracle_pixel draw(const struct tia_scene *scene, struct oracle_variant variant, unsigned i)
{
    return oracle_variant_pixel(scene, variant, WIDTH, HEIGHT, i % WIDTH, i / WIDTH);
}

static unsigned count(const char *key, struct oracle_variant variant, const struct oracle_pixel *picture)
{
    struct corpus_scene c;
    unsigned differ = 0;

    CHECK_EQ(corpus_thesis(&c, key, WIDTH, HEIGHT), TIA_OK);
    for (unsigned i = 0; i < PIXELS; i++)
        differ += draw(&c.scene, variant, i).colour != picture[i].colour;
    return differ;
}

static void check_row(const char *label, const unsigned differ[KEYS])
{
    char row[200];

    (void)snprintf(row, sizeof row, "\n| %s | %u | %u | %u |\n", label, differ[0], differ[1], differ[2]);
    check_page(row);
}

static void check_variant(const char *label, struct oracle_variant variant)
{
    unsigned differ[KEYS];

    for (unsigned k = 0; k < KEYS; k++)
        differ[k] = count(keys[k], variant, pictures[k]);
    check_row(label, differ);
}

TEST(pictures_are_the_oracles)
{
    struct corpus_scene c;

    for (unsigned k = 0; k < KEYS; k++) {
        CHECK_EQ(corpus_thesis(&c, keys[k], WIDTH, HEIGHT), TIA_OK);
        for (unsigned i = 0; i < PIXELS; i++) {
            pictures[k][i] = oracle_pixel(&c.scene, WIDTH, HEIGHT, i % WIDTH, i / WIDTH, false);
            CHECK_EQ(draw(&c.scene, (struct oracle_variant){.bias = ORACLE_BIAS}, i).colour, pictures[k][i].colour);
        }
    }
}

TEST(colours_of_blockers)
{
    check_variant("a blocker's colour is multiplied in",
                  (struct oracle_variant){.bias = ORACLE_BIAS, .colour_passes = true});
}

TEST(directions)
{
    check_variant("directions and normals in Q16.16",
                  (struct oracle_variant){.bias = ORACLE_BIAS, .direction_bits = 16});
    check_variant("directions and normals in Q2.30",
                  (struct oracle_variant){.bias = ORACLE_BIAS, .direction_bits = 30});
}

TEST(biases)
{
    check_variant("bias 2^-2", (struct oracle_variant){.bias = 0.25});
    check_variant("bias 2^-6", (struct oracle_variant){.bias = 1.0 / 64});
    check_variant("bias 2^-10", (struct oracle_variant){.bias = 1.0 / 1024});
    check_variant("bias 0.0001", (struct oracle_variant){.bias = 0.0001});
    check_variant("no bias", (struct oracle_variant){.bias = 0});
}

TEST(roots_of_the_quadratic)
{
    check_variant("the roots of the quadratic", (struct oracle_variant){.bias = ORACLE_BIAS, .quadratic = true});
}

/* The number of points that are rounded to the inner side of their surface depends on the compiler, so the page says
 * "some". */
TEST(roots_without_a_bias)
{
    unsigned differ = count("a", (struct oracle_variant){.quadratic = true}, pictures[0]);

    CHECK_MSG(differ > 60000 && differ < 80000, "%u pixels differ", differ);
    check_page("some 70,000");
}

TEST(signs)
{
    unsigned y[KEYS] = {0}, normal[KEYS] = {0};

    for (unsigned k = 0; k < KEYS; k++) {
        for (unsigned i = 0; i < PIXELS; i++) {
            unsigned mirrored = (HEIGHT - 1 - i / WIDTH) * WIDTH + i % WIDTH;
            y[k] += pictures[k][i].colour != pictures[k][mirrored].colour;
            normal[k] += pictures[k][i].path_hash != 0 && pictures[k][i].colour != 0;
        }
    }
    check_row("y downwards", y);
    check_row("normals inwards", normal);
}

/* The light moves down from the height of the ball's top, 2, to -2. */
TEST(blockers_beyond_the_light)
{
    struct oracle_variant tia = {.bias = ORACLE_BIAS}, variant = {.bias = ORACLE_BIAS, .beyond_light = true};
    unsigned wrong = 0, length;
    struct corpus_scene c;
    char text[200];

    check_variant("blockers beyond the light count", variant);
    for (unsigned k = 0; k < KEYS; k++) {
        length = (unsigned)snprintf(text, sizeof text, "\n| %s |", keys[k]);
        CHECK_EQ(corpus_thesis(&c, keys[k], WIDTH, HEIGHT), TIA_OK);
        for (unsigned n = 1; n < FIRST_MOVE + MOVES; n++) {
            unsigned differ = 0;
            CHECK_EQ(tia_viewer_press(&c.scene, c.lights, &c.scene.light_count, CORPUS_LIGHTS, TIA_KEY_PAGE_DOWN), 1);
            for (unsigned i = 0; n >= FIRST_MOVE && i < PIXELS; i++)
                differ += draw(&c.scene, tia, i).colour != draw(&c.scene, variant, i).colour;
            wrong += differ > 0;
            if (n >= FIRST_MOVE)
                length += (unsigned)snprintf(text + length, sizeof text - length, " %u |", differ);
        }
        check_page(text);
    }
    (void)snprintf(text, sizeof text, "%u of %u moved lights", wrong, KEYS * MOVES);
    check_page(text);
}

/* Rows of a checker with 8 rows, by the angle from the pole and by its cosine alone. */
TEST(texture_coordinates_without_acos)
{
    unsigned ball = 0, differ = 0;
    char text[200];

    for (unsigned i = 0; i < PIXELS; i++) {
        struct oracle_vec d = oracle_direction(&tia_thesis_scene.camera, WIDTH, HEIGHT, i % WIDTH, i / WIDTH);
        double cosine = (pictures[0][i].depth * d.y + 1) / 3; /* centre (0, -1, -20), radius 3 */
        if (pictures[0][i].object != 1)
            continue;
        ball++;
        differ += fmod(floor(8 * (1 - acos(cosine) / PI)) - floor(8 * (1 - cosine / PI)), 2) != 0;
    }
    (void)snprintf(text, sizeof text, "%u of the ball's %u pixels", differ, ball);
    check_page(text);
}

int main(void)
{
    if (!read_page()) {
        printf("FAIL the_page: docs/thesis.md cannot be read\n");
        return 1;
    }
    RUN(pictures_are_the_oracles);
    RUN(colours_of_blockers);
    RUN(directions);
    RUN_LONG(biases);
    RUN(roots_of_the_quadratic);
    RUN(roots_without_a_bias);
    RUN(signs);
    RUN_LONG(blockers_beyond_the_light);
    RUN(texture_coordinates_without_acos);
    return check_status();
}
