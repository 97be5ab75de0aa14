/* parts.c - input of tia-join: up to three files of any bytes, or of parts as tia writes them with some numbers and
 * bytes changed. Parts that are accepted have every pixel of every frame. */
#include <string.h>
#include <tia/debug.h>

#include "common/image/part.h"
#include "common/image/parts.h"
#include "common/image/sums.h"
#include "files.h"
#include "tia-join/join_sums.h"

enum { FILES = 3, SIDE = 8, FRAMES = 4 };
enum kind { RAW, PART, SUMS, PLANES };

static struct memory_file files[FILES];

/* ---- parts as tia writes them ---- */

static void take_rows(struct bytes *b, struct image_film *film)
{
    uint8_t place = take_byte(b), frames = take_byte(b);

    film->first_row = place % SIDE;
    film->rows = place / SIDE % SIDE + 1u;
    film->first_frame = frames % FRAMES;
    film->frames = frames / FRAMES % FRAMES + 1u;
}

/* Takes a film, the same for all parts but for one number in one part of eight. */
static struct image_film take_film(struct bytes *b, uint8_t shape)
{
    struct image_film film = {.width = shape % SIDE + 1u,
                              .height = shape / SIDE % SIDE + 1u,
                              .all_frames = shape / 64 + 1u,
                              .rate = {25, 1},
                              .crc = 0x89abcdef};
    uint8_t other = take_byte(b);

    take_rows(b, &film);
    if (other % 8 == 7)
        *(unsigned *[]){&film.width, &film.height, &film.rate[0], &film.crc, &film.all_frames}[other / 8 % 5] =
            take_word(b);
    return film;
}

static tia_rgb565 pixel_of(uint32_t frame, unsigned row, unsigned column)
{
    return (tia_rgb565)(frame * 20011 + row * 509 + column * 7);
}

static void write_part_frame(struct memory_file *file, const struct image_film *film, uint32_t frame)
{
    tia_rgb565 row[SIDE];
    unsigned char sum[IMAGE_PART_SUM], bytes[2];
    uint32_t crc = image_part_begin_sum(film, frame);

    for (unsigned y = film->first_row; y < film->first_row + film->rows; y++) {
        for (unsigned x = 0; x < film->width % (SIDE + 1); x++) {
            row[x] = pixel_of(frame, y, x);
            bytes[0] = (unsigned char)(row[x] & 255);
            bytes[1] = (unsigned char)(row[x] >> 8);
            memory_file_write(file, bytes, sizeof bytes);
        }
        crc = tia_crc32(crc, row, film->width % (SIDE + 1));
    }
    image_part_put_sum(sum, crc);
    memory_file_write(file, sum, sizeof sum);
}

static void write_planes(struct memory_file *file, const struct image_film *film, uint32_t frame)
{
    unsigned width = film->width % (SIDE + 1), height = film->height % (SIDE + 1);
    unsigned char head[IMAGE_Y4M_FRAME + 1];
    tia_rgb565 pixels[SIDE * SIDE];

    for (unsigned i = 0; i < width * height; i++)
        pixels[i] = pixel_of(frame, i / width, i % width);
    image_y4m_put_frame(head, tia_crc32(image_part_begin_sum(film, frame), pixels, (size_t)width * height));
    memory_file_write(file, head, IMAGE_Y4M_FRAME);
    for (unsigned shift = 16; shift <= 16; shift -= 8)
        for (unsigned i = 0; i < width * height; i++)
            memory_file_write(file, &(unsigned char){(unsigned char)(image_y4m_colour(pixels[i]) >> shift)}, 1);
}

static void write_part(struct bytes *b, struct memory_file *file, uint8_t shape, bool planes)
{
    struct image_film film = take_film(b, shape);
    char text[IMAGE_PART_HEADER];

    if (planes) {
        film.first_row = 0;
        film.rows = film.height;
    }
    memory_file_write(file, text, planes ? image_y4m_print(text, &film) : image_part_print(text, &film));
    for (uint32_t i = 0; i < film.frames; i++)
        if (planes)
            write_planes(file, &film, film.first_frame + i);
        else
            write_part_frame(file, &film, film.first_frame + i);
}

static void write_sums(struct bytes *b, struct memory_file *file, uint8_t shape)
{
    uint8_t samples = take_byte(b), other = take_byte(b);
    struct sums sums = {shape % SIDE + 1u,  shape / SIDE % SIDE + 1u,
                        samples % 16,       samples / 16u + 1,
                        TIA_TONE_SRGB,      0,
                        other == 7 ? 7 : 5, false};
    unsigned char bytes[SIDE * 24 + 4];
    struct tia_sum row[SIDE];
    char text[SUMS_HEADER];

    memory_file_write(file, text, sums_print(text, &sums));
    for (unsigned y = 0; y < sums.height; y++) {
        for (unsigned x = 0; x < sums.width; x++)
            row[x] = (struct tia_sum){{take_byte(b), (int64_t)take_byte(b) << 20, (int64_t)sums.count << 38}};
        sums_put_row(bytes, &sums, y, row);
        memory_file_write(file, bytes, sums_row_bytes(&sums));
    }
}

/* Changes a byte of one file in four, or cuts the file. */
static void damage(struct bytes *b, struct memory_file *file)
{
    uint8_t how = take_byte(b);

    if (how % 4 != 3 || file->size == 0)
        return;
    size_t at = take_word(b) % file->size;
    if (how & 4)
        file->size = at;
    else
        file->bytes[at] = take_byte(b);
}

static void take_raw(struct bytes *b, struct memory_file *file)
{
    size_t size = (size_t)take_byte(b) * 2;

    size = size < b->left ? size : b->left;
    memory_file_write(file, b->next, size);
    b->next += size;
    b->left -= size;
}

static void fill(struct bytes *b, struct memory_file *file, enum kind kind, uint8_t shape)
{
    unsigned parts = kind == PART ? 1 + take_byte(b) % 3u : 1;

    for (unsigned i = 0; i < parts; i++)
        if (kind == RAW)
            take_raw(b, file);
        else if (kind == SUMS)
            write_sums(b, file, shape);
        else
            write_part(b, file, shape, kind == PLANES);
    damage(b, file);
    memory_file_save(file);
}

/* ---- reading ---- */

static void must_be_drawn(const tia_rgb565 *pixels, const struct image_film *film, uint32_t frame)
{
    for (unsigned i = 0; i < film->width * film->height; i++)
        MUST(pixels[i] == pixel_of(frame, i / film->width, i % film->width));
}

/* Checks that every pixel is written, since the picture is the same over two backgrounds, and that it is the one that
 * was drawn. */
static void must_fill(struct parts *parts, uint32_t frame, bool raw)
{
    const struct image_film *film = &parts->array[0].film;
    size_t count = (size_t)film->width * film->height;
    tia_rgb565 *one = malloc(count * sizeof *one), *two = malloc(count * sizeof *two);

    MUST(one && two);
    memset(one, 0, count * sizeof *one);
    memset(two, 255, count * sizeof *two);
    if (parts_frame(parts, frame, one) == 0) {
        MUST(parts_frame(parts, frame, two) == 0 && memcmp(one, two, count * sizeof *one) == 0);
        if (!raw)
            must_be_drawn(one, film, frame);
    } else {
        MUST(*parts->why && memchr(parts->why, '\0', PARTS_WHY) && !strchr(parts->why, '\n'));
    }
    free(one);
    free(two);
}

/* Takes a kind of part; planes are rare, since reading them sorts 65536 colours. */
static enum kind take_kind(struct bytes *b)
{
    uint8_t kind = take_byte(b) % 64;

    return kind == 63 ? PLANES : (enum kind)(kind % PLANES);
}

static void must_join(char *const *paths, unsigned count, bool raw)
{
    struct parts parts;

    if (parts_open(&parts, paths, count)) {
        MUST(*parts.why && memchr(parts.why, '\0', PARTS_WHY));
    } else {
        uint32_t frames = parts.array[0].film.all_frames;
        for (uint32_t i = 0; i < frames && i < FRAMES; i++)
            must_fill(&parts, i, raw);
    }
    parts_close(&parts);
}

static void must_add(char *const *paths, unsigned count, uint8_t how)
{
    static const enum image_format formats[] = {IMAGE_PPM, IMAGE_PFM, IMAGE_PART, IMAGE_EXR};
    char why[SUMS_WHY] = "";
    int result = join_sums(paths, count, "/dev/null", formats[how % 4], why);

    MUST(result >= 0 && result <= 2 && !result == !*why && memchr(why, '\0', sizeof why));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes bytes = {data, size};
    uint8_t how = take_byte(&bytes), shape = take_byte(&bytes);
    unsigned count = how % FILES + 1u;
    char *paths[FILES];
    bool raw = false;

    for (unsigned i = 0; i < count; i++) {
        enum kind kind = take_kind(&bytes);
        fill(&bytes, &files[i], kind, shape);
        paths[i] = files[i].path;
        raw = raw || kind == RAW;
    }
    must_join(paths, count, raw);
    if (is_sums(paths[0]))
        must_add(paths, count, how);
    return 0;
}
