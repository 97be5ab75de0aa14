/* The unit of length of .tia scenes: random scenes at the limits of the accepted ranges stay accepted in a finer
 * unit. */
#include "check.h"
#include "random.h"
#include "reading.h"

#include <math.h>

/* Two growing texts; each length is a multiple of 2^-16 plus digits that Q16.16 drops. */
static char whole[4000], tiny[4000], *whole_end, *tiny_end;

static void add_word(const char *word)
{
    whole_end += sprintf(whole_end, "%s ", word);
    tiny_end += sprintf(tiny_end, "%s ", word);
}

static double any_size(int least, int most)
{
    int exponent = least + (int)(random_u32() % (uint32_t)(most - least));

    return ldexp(1 + (random_u32() % 1024) / 1024.0, exponent);
}

static void add_lengths(int count, int most, bool sign)
{
    for (int i = 0; i < count; i++) {
        double length = any_size(-6, most) * (sign && random_u32() % 2 ? -1 : 1);
        whole_end += sprintf(whole_end, "%.16f ", length);
        tiny_end += sprintf(tiny_end, "%.16f ", length + 1e-6);
    }
}

static void add_scale(void)
{
    char words[100];

    (void)sprintf(words, random_u32() % 2 ? "scale %.6f" : "scale %.6f %.6f %.6f", any_size(-7, 7), any_size(-7, 7),
                  any_size(-7, 7));
    add_word(words);
}

/* Adds a position, a rotation and a scale, each only in some cases. */
static void add_transform(int most)
{
    if (random_u32() % 2) {
        add_word("at");
        add_lengths(3, most, true);
    }
    if (random_u32() % 3 == 0)
        add_word("rotate 10 20 30");
    if (random_u32() % 2)
        add_scale();
}

static void add_shape(int most)
{
    static const char *const solids[] = {"instance x material m", "instance g material m"};
    uint32_t kind = random_u32() % 5;

    if (kind < 2)
        add_word(solids[kind]);
    if (kind == 2) {
        add_word("sphere material m centre");
        add_lengths(3, most, true);
        add_word("radius");
        add_lengths(1, most, false);
    } else if (kind == 3) {
        add_word("triangle material m a");
        add_lengths(3, most, true);
        add_word("b");
        add_lengths(3, most, true);
        add_word("c");
        add_lengths(3, most, true);
    } else if (kind == 4) {
        add_word("cylinder material m base");
        add_lengths(3, most, true);
        add_word("top");
        add_lengths(3, most, true);
        add_word("radius");
        add_lengths(1, most, false);
    }
    add_transform(most);
    add_word("\n");
}

static void add_solids(int most)
{
    add_word("mesh x\nvertex");
    add_lengths(3, most, true);
    add_word("\nvertex");
    add_lengths(3, most, true);
    add_word("\nvertex 0 0 0\nface 1 2 3\nend\ngrid g size 1 2 1 corner");
    add_lengths(3, most, true);
    add_word("cell");
    add_lengths(1, most, false);
    add_word("\nrow 1\nrow 1\nend\n");
}

static void add_camera(int most)
{
    static const char *const kinds[] = {"camera eye", "camera orthographic window", "camera frustum near 1 window"};
    uint32_t kind = random_u32() % 3;

    add_word(kinds[kind]);
    if (kind)
        add_word(random_u32() % 2 ? "-1 1 -2 2 eye" : "0 0 -3 3 eye");
    add_lengths(3, most, true);
    add_word("look");
    add_lengths(3, most, true);
    add_word("\n");
}

static void add_motion(int most)
{
    add_word("box name b material m min -1 -1 -1 max 1 1 1\nlight name l at");
    add_lengths(3, most, true);
    add_word(random_u32() % 2 ? "\nanimate b at smooth" : "\nanimate l at");
    for (int i = 0; i < 3; i++) {
        add_word(i == 0 ? "0:" : i == 1 ? "1:" : "5:");
        add_lengths(3, most, true);
    }
    add_word(random_u32() % 2 ? "\nanimate b scale 0: 1 1: 3 2 1\n"
                              : "\nanimate camera eye smooth 0: 0 0 0 1: 9 9 9\n");
}

static void make_text(void)
{
    int most = 1 + (int)(random_u32() % 13);

    whole_end = whole;
    tiny_end = tiny;
    add_word("material m colour 1\n");
    add_camera(most);
    add_solids(most);
    if (random_u32() % 2)
        add_motion(most);
    for (uint32_t groups = random_u32() % 3, left = groups; left <= groups; left--) {
        add_shape(most);
        if (left > 0) {
            add_word("group");
            add_transform(most);
            add_word("\n");
        } else {
            for (uint32_t i = 0; i < groups; i++)
                add_word("end\n");
            break;
        }
    }
}

/* A scene that is accepted in the file's unit stays accepted in the chosen one. */
TEST(no_scene_is_refused_for_its_unit)
{
    unsigned accepted = 0, finer = 0;

    for (unsigned i = 0; i < check_count(20000); i++) {
        struct reading r;
        make_text();
        read_string(&r, TIA_FORMAT_TIA, whole);
        bool fine = !r.status;
        CHECK(r.status || r.scene.scale_bits <= 0);
        read_end(&r);
        if (!fine)
            continue;
        read_string(&r, TIA_FORMAT_TIA, tiny);
        CHECK_MSG(!r.status, "%u:%u: %s in\n%.100s", (unsigned)r.reader.error.line, (unsigned)r.reader.error.column,
                  r.reader.error.text, tiny);
        accepted++;
        finer += r.scene.scale_bits > 0;
        read_end(&r);
    }
    CHECK_MSG(accepted > check_count(2000) && finer > check_count(1000), "%u accepted, %u of them finer", accepted,
              finer);
}

int main(void)
{
    RUN(no_scene_is_refused_for_its_unit);
    return check_status();
}
