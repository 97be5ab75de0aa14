/* The fields by which files and tools read and write each kind of shape. */
#include <string.h>

#include "check.h"
#include "scene/shapes/description.h"

static size_t size_of(const struct tia_shape_field *f)
{
    const size_t sizes[] = {sizeof(tia_q16), sizeof(struct tia_vec3), sizeof(struct tia_dir3), sizeof(bool)};

    return f->value < sizeof sizes / sizeof *sizes ? sizes[f->value] : 0;
}

/* Checks that the fields cover the struct, and no byte twice; of a flag's word the first byte is enough. */
static void check_cover(enum tia_shape_kind kind, size_t start, size_t size)
{
    unsigned char covered[sizeof(struct tia_shape)] = {0};
    unsigned count = 0;

    for (const struct tia_shape_field *f = tia_shape_fields(kind); f->member && count <= SHAPE_FIELDS_MAX;
         f++, count++) {
        CHECK_MSG(size_of(f) && f->offset >= start && f->offset + size_of(f) <= start + size, "%s", f->member);
        for (size_t i = 0; i < size_of(f) && f->offset + i < sizeof covered; i++)
            CHECK_MSG(!covered[f->offset + i]++, "kind %d: %s: its bytes are another's", (int)kind, f->member);
    }
    CHECK_MSG(count > 0 && count <= SHAPE_FIELDS_MAX, "kind %d: the list does not end", (int)kind);
    for (size_t i = start; i < start + size; i += sizeof(int32_t))
        CHECK_MSG(covered[i], "kind %d: byte %zu is no field's", (int)kind, i - start);
}

TEST(fields_cover_their_structs)
{
    for (unsigned kind = 0; tia_shape_description((enum tia_shape_kind)kind); kind++) {
#define COVER(KIND, name)                                                                                              \
    if (kind == KIND && KIND < TIA_MESH)                                                                               \
        check_cover(KIND, offsetof(struct tia_shape, name), sizeof(((struct tia_shape *)NULL)->name));
        TIA_SHAPES(COVER)
#undef COVER
    }
}

TEST(meshes_and_grids_are_indices)
{
    CHECK(!tia_shape_fields(TIA_MESH)->member && !tia_shape_fields(TIA_GRID)->member);
    CHECK(!tia_shape_fields(TIA_SOLID)->member);
}

/* A field without a word is the second number of the field before it: both are Q16.16 and adjacent in memory. */
TEST(a_field_without_a_word_follows_the_one_before)
{
    for (unsigned kind = 0; tia_shape_description((enum tia_shape_kind)kind); kind++) {
        const struct tia_shape_field *f = tia_shape_fields((enum tia_shape_kind)kind);
        for (unsigned i = 0; f[i].member; i++)
            CHECK(f[i].word || (i > 0 && f[i].value == TIA_SHAPE_Q16 && f[i - 1].value == TIA_SHAPE_Q16 &&
                                f[i].offset == f[i - 1].offset + sizeof(tia_q16)));
    }
}

TEST(words_are_statements)
{
    for (unsigned kind = 0; tia_shape_description((enum tia_shape_kind)kind); kind++) {
        const struct shape_description *d = tia_shape_description((enum tia_shape_kind)kind);
        CHECK(!d->word == !d->fields[0].member && d->what && d->check);
        CHECK(!d->word || strstr(d->what, d->word));
    }
}

int main(void)
{
    RUN(fields_cover_their_structs);
    RUN(meshes_and_grids_are_indices);
    RUN(a_field_without_a_word_follows_the_one_before);
    RUN(words_are_statements);
    return check_status();
}
