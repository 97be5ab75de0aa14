/* resume.c - what an interrupted run has left, for --resume: any bytes, or a file of rows that was cut or
 * changed at any place. What is accepted is right, and can be continued and read again. */
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
static const struct sums sums = {WIDTH, HEIGHT, 0, 16, TIA_TONE_SRGB, 0, 0x1234567};

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

/* Whatever was in the file, after all rows have been appended it has them all. */
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

static void draw_sums(struct tia_sum *band, unsigned y, unsigned rows)
{
    for (unsigned i = 0; i < rows * WIDTH; i++)
        band[i] = (struct tia_sum){{(int64_t)(y * WIDTH + i) << 24, (int64_t)1 << 42, 5}};
}

static void append_sums(struct resume *r, unsigned y, unsigned rows)
{
    struct tia_sum band[WIDTH * HEIGHT];

    draw_sums(band, y, rows);
    MUST(resume_append(r, y, rows, band) == TIA_OK);
}

static void must_resume(bool raw)
{
    struct tia_sum band[WIDTH * HEIGHT], drawn[WIDTH * HEIGHT];
    struct resume r;
    int status = resume_open(&r, file.path, &sums, why);

    if (!status) {
        MUST(r.rows <= HEIGHT);
        append_sums(&r, 0, HEIGHT);
        resume_close(&r);
        MUST(resume_open(&r, file.path, &sums, why) == TIA_OK && r.rows == HEIGHT);
        draw_sums(drawn, 0, HEIGHT);
        status = resume_read(&r, 0, HEIGHT, band);
        MUST(status || raw || memcmp(band, drawn, sizeof drawn) == 0);
    }
    if (status)
        must_say(status);
    resume_close(&r);
}

static void begin_sums(struct bytes *b)
{
    struct resume r;

    MUST(resume_open(&r, file.path, &sums, why) == TIA_OK);
    append_sums(&r, 0, take_byte(b) % (HEIGHT + 1));
    resume_close(&r);
}

/* ---- what happens to the file ---- */

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
    bool of_sums = how & 1, raw = how & 2;

    if (raw)
        memory_file_write(&file, bytes.next, bytes.left);
    memory_file_save(&file);
    if (!raw && of_sums)
        begin_sums(&bytes);
    else if (!raw)
        begin_rows(&bytes);
    if (how & 4)
        cut(&bytes);
    if (how & 8)
        change(&bytes);
    if (of_sums)
        must_resume(raw);
    else
        must_finish(raw);
    return 0;
}
