/* resume.c - files of interrupted runs, for --resume: any bytes, or a file of rows that was cut or changed at any
 * place. The rows that are accepted are correct, and the file can be continued and read again. */
#include <string.h>

#include "files.h"
#include "ports.h"
#include "tia/finished.h"
#include "tia/resume.h"

enum { WIDTH = 5, HEIGHT = 7, FRAMES = 3 };

static struct memory_file file;
static char why[PORT_WHY];
static const struct image_film film = {.width = WIDTH,
                                       .height = HEIGHT,
                                       .rows = HEIGHT,
                                       .frames = FRAMES,
                                       .all_frames = FRAMES,
                                       .rate = {25, 1},
                                       .crc = 0x1234567};
static const struct sums sums = {WIDTH, HEIGHT, 0, 16, TIA_TONE_SRGB, 0, 0x1234567, false};

static void must_say(int status)
{
    MUST(status == TIA_ERR_RANGE || status == TIA_ERR_DEVICE || status == TIA_ERR_MEMORY);
    MUST(*why && memchr(why, '\0', sizeof why) && !strchr(why, '\n'));
}

/* ---- rows of RGB565 ---- */

static void draw_rows(tia_rgb565 *pixels, uint32_t frame, unsigned y, unsigned rows)
{
    for (unsigned i = 0; i < rows * WIDTH; i++)
        pixels[i] = (tia_rgb565)(frame * 20011 + (y * WIDTH + i) * 509);
}

static void append_rows(struct finished *f, uint32_t frame, unsigned y, unsigned rows)
{
    tia_rgb565 pixels[WIDTH * HEIGHT];

    draw_rows(pixels, frame, y, rows);
    MUST(finished_append(f, frame, y, rows, pixels) == TIA_OK);
}

static void must_read_rows(struct finished *f, uint32_t frame, bool raw)
{
    tia_rgb565 pixels[WIDTH * HEIGHT], drawn[WIDTH * HEIGHT];

    draw_rows(drawn, frame, 0, HEIGHT);
    MUST(finished_has(f, frame, 0, HEIGHT));
    int status = finished_read(f, frame, 0, HEIGHT, pixels);
    if (status)
        must_say(status);
    else
        MUST(raw || memcmp(pixels, drawn, sizeof drawn) == 0);
}

/* Checks that the file has all rows after all have been appended, whatever it contained before; or that an error is
 * reported. */
static void must_finish(bool raw)
{
    struct finished f;
    int status = finished_open(&f, file.path, &film, why);

    if (!status) {
        for (uint32_t frame = 0; frame < FRAMES; frame++)
            append_rows(&f, frame, 0, HEIGHT);
        finished_close(&f);
        MUST(finished_open(&f, file.path, &film, why) == TIA_OK);
        for (uint32_t frame = 0; frame < FRAMES; frame++)
            must_read_rows(&f, frame, raw);
    } else {
        must_say(status);
    }
    finished_close(&f);
}

static void begin_rows(struct bytes *b)
{
    struct finished f;
    unsigned steps = take_byte(b) % 8;

    MUST(finished_open(&f, file.path, &film, why) == TIA_OK);
    for (unsigned i = 0; i < steps; i++) {
        unsigned place = take_byte(b), y = place % HEIGHT, rows = place / HEIGHT % (HEIGHT - y) + 1;
        append_rows(&f, take_byte(b) % FRAMES, y, rows);
    }
    finished_close(&f);
}

/* ---- rows of sums ---- */

struct band {
    struct tia_sum sums[WIDTH * HEIGHT];
    struct tia_guide guides[WIDTH * HEIGHT];
    uint64_t squares[WIDTH * HEIGHT];
};

static struct tia_gathered gathered(struct band *band, bool guided)
{
    return (struct tia_gathered){band->sums, guided ? band->guides : NULL, guided ? band->squares : NULL, WIDTH};
}

static void draw_band(struct band *band, unsigned y, unsigned rows)
{
    *band = (struct band){.squares = {0}};
    for (unsigned i = 0; i < rows * WIDTH; i++) {
        unsigned at = y * WIDTH + i;
        band->sums[i] = (struct tia_sum){{(int64_t)at << 24, (int64_t)1 << 42, 5}};
        band->guides[i] = (struct tia_guide){{at, -(int64_t)at, 16 << 24}, at << 16, {at, 7, 16 << 24}};
        band->squares[i] = UINT64_MAX - at;
    }
}

static struct sums kept_sums(bool guided)
{
    struct sums kept = sums;

    kept.guided = guided;
    return kept;
}

static void append_band(struct resume *r, unsigned y, unsigned rows)
{
    static struct band band;

    draw_band(&band, y, rows);
    const struct tia_gathered from = gathered(&band, r->sums.guided);
    MUST(resume_append(r, y, rows, &from) == TIA_OK);
}

static int must_read_band(struct resume *r, bool raw)
{
    static struct band band, drawn;
    struct tia_gathered to = gathered(&band, r->sums.guided);
    int status = resume_read(r, 0, HEIGHT, &to);

    draw_band(&drawn, 0, HEIGHT);
    if (!status && !raw) {
        MUST(memcmp(band.sums, drawn.sums, sizeof band.sums) == 0);
        MUST(!to.guides || memcmp(band.guides, drawn.guides, sizeof band.guides) == 0);
        MUST(!to.squares || memcmp(band.squares, drawn.squares, sizeof band.squares) == 0);
    }
    return status;
}

static void must_resume(bool raw, bool guided)
{
    const struct sums kept = kept_sums(guided);
    struct resume r;
    int status = resume_open(&r, file.path, &kept, why);

    if (!status) {
        MUST(r.rows <= HEIGHT);
        append_band(&r, 0, HEIGHT);
        resume_close(&r);
        MUST(resume_open(&r, file.path, &kept, why) == TIA_OK && r.rows == HEIGHT);
        status = must_read_band(&r, raw);
    }
    if (status)
        must_say(status);
    resume_close(&r);
}

static void begin_sums(struct bytes *b, bool guided)
{
    const struct sums kept = kept_sums(guided);
    struct resume r;

    MUST(resume_open(&r, file.path, &kept, why) == TIA_OK);
    append_band(&r, 0, take_byte(b) % (HEIGHT + 1));
    resume_close(&r);
}

/* ---- changes of the file ---- */

static void cut(struct bytes *b)
{
    off_t size = lseek(file.fd, 0, SEEK_END);

    MUST(ftruncate(file.fd, (off_t)(take_word(b) % ((uint32_t)size + 1))) == 0);
}

static void change(struct bytes *b)
{
    off_t size = lseek(file.fd, 0, SEEK_END);

    if (size)
        MUST(pwrite(file.fd, &(uint8_t){take_byte(b)}, 1, (off_t)(take_word(b) % (uint32_t)size)) == 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct bytes bytes = {data, size};
    uint8_t how = take_byte(&bytes);
    bool of_sums = how & 1, raw = how & 2, guided = how & 16;

    if (raw)
        memory_file_write(&file, bytes.next, bytes.left);
    memory_file_save(&file);
    if (!raw && of_sums)
        begin_sums(&bytes, guided);
    else if (!raw)
        begin_rows(&bytes);
    if (how & 4)
        cut(&bytes);
    if (how & 8)
        change(&bytes);
    if (of_sums)
        must_resume(raw, guided);
    else
        must_finish(raw);
    return 0;
}
