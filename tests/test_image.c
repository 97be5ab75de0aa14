/* Picture files: their bytes; and a file exists completely or not at all. */
#include "common/image/image.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"
#include "ports.h"

/* 3 x 2 pixels: the primary colours, then the smallest steps and a mixture. */
static const tia_rgb565 pixels[6] = {0xf800, 0x07e0, 0x001f, 0x0821, 0xffff, 0xabcd};

static char directory[64], path[128], why[PORT_WHY];
static unsigned char bytes[4096];

/* Returns the file's length, or -1 if there is no file. */
static long slurp(const char *name)
{
    FILE *file = fopen(name, "rb");
    if (!file)
        return -1;
    size_t length = fread(bytes, 1, sizeof bytes, file);
    (void)fclose(file);
    return (long)length;
}

static int entries(void)
{
    int count = 0;
    DIR *open = opendir(directory);
    for (struct dirent *entry; open && (entry = readdir(open)) != NULL;)
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    if (open)
        (void)closedir(open);
    return count;
}

/* Writes the pixels, one row a band. */
static int write_image(const char *name, enum image_format format)
{
    why[0] = '\0';
    struct image *image = image_create(name, format, 3, 2, why);
    if (!image)
        return TIA_ERR_DEVICE;
    for (unsigned i = 0; i < 2; i++) {
        unsigned row = image_bottom_up(image) ? 1 - i : i;
        (void)image_band(image, pixels + 3 * row, 1);
    }
    return image_finish(image);
}

/* ---- formats ---- */

TEST(names)
{
    CHECK_EQ(image_format_of("a.png"), IMAGE_PNG);
    CHECK_EQ(image_format_of("dir.ppm/a.b.PPM"), IMAGE_PPM);
    CHECK_EQ(image_format_of("a.bmp"), IMAGE_BMP);
    CHECK_EQ(image_format_of(".565"), IMAGE_565);
    CHECK_EQ(image_format_of("a.gif"), IMAGE_UNKNOWN);
    CHECK_EQ(image_format_of("png"), IMAGE_UNKNOWN);
    CHECK_EQ(image_format_of("a.png/b"), IMAGE_UNKNOWN);
    CHECK_EQ(image_format_called(""), IMAGE_UNKNOWN);
    CHECK(strcmp(image_format_name(IMAGE_565), "565") == 0);
}

TEST(raw_is_little_endian)
{
    static const unsigned char expected[] = {0x00, 0xf8, 0xe0, 0x07, 0x1f, 0x00, 0x21, 0x08, 0xff, 0xff, 0xcd, 0xab};
    CHECK_EQ(write_image(path, IMAGE_565), TIA_OK);
    CHECK_EQ(slurp(path), sizeof expected);
    CHECK(memcmp(bytes, expected, sizeof expected) == 0);
}

/* round(255 v / 31) and round(255 v / 63) give the replicated bits, as 0xabcd shows: 21, 30, 13. */
TEST(ppm_replicates_bits)
{
    static const char header[] = "P6\n3 2\n255\n";
    static const unsigned char expected[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 8, 4, 8, 255, 255, 255, 173, 121, 107};
    CHECK_EQ(write_image(path, IMAGE_PPM), TIA_OK);
    CHECK_EQ(slurp(path), sizeof header - 1 + sizeof expected);
    CHECK(memcmp(bytes, header, sizeof header - 1) == 0);
    CHECK(memcmp(bytes + sizeof header - 1, expected, sizeof expected) == 0);
}

static unsigned long get32(size_t at)
{
    return bytes[at] | (unsigned long)bytes[at + 1] << 8 | (unsigned long)bytes[at + 2] << 16 |
           (unsigned long)bytes[at + 3] << 24;
}

TEST(bmp_is_bottom_up_and_padded)
{
    static const unsigned char expected[] = {0x21, 0x08, 0xff, 0xff, 0xcd, 0xab, 0, 0,
                                             0x00, 0xf8, 0xe0, 0x07, 0x1f, 0x00, 0, 0};
    CHECK_EQ(write_image(path, IMAGE_BMP), TIA_OK);
    CHECK_EQ(slurp(path), 66 + sizeof expected);
    CHECK(bytes[0] == 'B' && bytes[1] == 'M');
    CHECK_EQ(get32(2), 66 + sizeof expected);
    CHECK_EQ(get32(10), 66);
    CHECK_EQ(get32(14), 40);
    CHECK_EQ(get32(18), 3);
    CHECK_EQ(get32(22), 2);
    CHECK_EQ(get32(26), 1 | 16 << 16);
    CHECK_EQ(get32(30), 3);
    CHECK_EQ(get32(34), sizeof expected);
    CHECK(get32(54) == 0xf800 && get32(58) == 0x7e0 && get32(62) == 0x1f);
    CHECK(memcmp(bytes + 66, expected, sizeof expected) == 0);
}

TEST(png_header)
{
    /* Signature, IHDR of 13 bytes: 3 x 2, 8 bits, RGB, not interlaced. */
    static const unsigned char expected[] = {0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D',
                                             'R',  0,   0,   0,   3,  0,  0,  0,  2, 8, 2, 0,  0,   0};
    if (!image_format_built(IMAGE_PNG)) {
        SKIP("built without libpng (libpng-dev)");
        return;
    }
    CHECK_EQ(write_image(path, IMAGE_PNG), TIA_OK);
    CHECK(slurp(path) > (long)sizeof expected);
    CHECK(memcmp(bytes, expected, sizeof expected) == 0);
}

/* ---- complete or not at all ---- */

TEST(a_file_appears_only_when_finished)
{
    (void)unlink(path);
    struct image *image = image_create(path, IMAGE_PPM, 3, 2, why);
    CHECK(image && entries() == 1);
    (void)image_band(image, pixels, 2);
    CHECK_EQ(slurp(path), -1);
    CHECK_EQ(image_finish(image), TIA_OK);
    CHECK(slurp(path) > 0);
    CHECK_EQ(entries(), 1);
}

TEST(a_discarded_file_leaves_the_old_one)
{
    CHECK_EQ(write_image(path, IMAGE_565), TIA_OK);
    struct image *image = image_create(path, IMAGE_BMP, 3, 2, why);
    (void)image_band(image, pixels, 1);
    image_discard(image);
    CHECK_EQ(slurp(path), 12);
    CHECK_EQ(entries(), 1);
}

TEST(missing_rows_are_an_error)
{
    (void)unlink(path);
    for (enum image_format format = IMAGE_PNG; format <= IMAGE_565; format++) {
        if (!image_format_built(format))
            continue;
        struct image *image = image_create(path, format, 3, 2, why);
        (void)image_band(image, pixels, 1);
        CHECK(image_finish(image) < 0);
        CHECK(strstr(why, "1 rows of 2"));
    }
    CHECK_EQ(entries(), 0);
}

TEST(permissions_follow_the_umask)
{
    (void)unlink(path);
    mode_t before = umask(027);
    CHECK_EQ(write_image(path, IMAGE_565), TIA_OK);
    (void)umask(before);
    struct stat status;
    CHECK(stat(path, &status) == 0);
    CHECK_EQ(status.st_mode & 0777, 0640);
}

TEST(a_link_stays_a_link)
{
    char link[140];
    (void)snprintf(link, sizeof link, "%s-link", path);
    CHECK_EQ(write_image(path, IMAGE_565), TIA_OK);
    CHECK(symlink(path, link) == 0);
    CHECK_EQ(write_image(link, IMAGE_PPM), TIA_OK);
    struct stat status;
    CHECK(lstat(link, &status) == 0 && S_ISLNK(status.st_mode));
    CHECK_EQ(slurp(path), 29);
    CHECK_EQ(entries(), 2);
    (void)unlink(link);
}

TEST(the_longest_name_works)
{
    char name[512];
    int length = snprintf(name, sizeof name, "%s/", directory);
    memset(name + length, 'n', 255);
    name[length + 255] = '\0';
    CHECK_EQ(write_image(name, IMAGE_565), TIA_OK);
    CHECK_EQ(slurp(name), 12);
    (void)unlink(name);
}

/* ---- failures ---- */

TEST(a_full_device_says_so)
{
    for (enum image_format format = IMAGE_PNG; format <= IMAGE_565; format++) {
        if (image_format_built(format)) {
            CHECK(write_image("/dev/full", format) < 0);
            CHECK_MSG(strcmp(why, "/dev/full: No space left on device") == 0, "said '%s'", why);
        }
    }
    struct stat status;
    CHECK(stat("/dev/full", &status) == 0 && S_ISCHR(status.st_mode));
}

/* A file that cannot grow is removed: the limit of the file size simulates a disk that becomes full. */
TEST(a_file_that_cannot_grow_is_removed)
{
    struct rlimit before, small = {100, 100};
    CHECK(getrlimit(RLIMIT_FSIZE, &before) == 0);
    small.rlim_max = before.rlim_max;
    (void)unlink(path);
    (void)signal(SIGXFSZ, SIG_IGN);
    (void)setrlimit(RLIMIT_FSIZE, &small);
    static const tia_rgb565 row[200];
    struct image *image = image_create(path, IMAGE_565, 200, 1, why);
    CHECK(image);
    (void)image_band(image, row, 1);
    int status = image_finish(image);
    (void)setrlimit(RLIMIT_FSIZE, &before);
    CHECK(status < 0 && strstr(why, strerror(EFBIG)));
    CHECK_EQ(entries(), 0);
}

TEST(no_directory_no_file)
{
    char name[140];
    (void)snprintf(name, sizeof name, "%s/missing/a.ppm", directory);
    CHECK(write_image(name, IMAGE_PPM) < 0 && strstr(why, strerror(ENOENT)));
    CHECK(write_image(directory, IMAGE_PPM) < 0 && strstr(why, strerror(EISDIR)));
    CHECK_EQ(entries(), 0);
}

TEST(a_closed_pipe_is_an_error)
{
    int ends[2];
    char name[40];
    (void)signal(SIGPIPE, SIG_IGN);
    CHECK(pipe(ends) == 0);
    (void)snprintf(name, sizeof name, "/dev/fd/%d", ends[1]);
    (void)close(ends[0]);
    CHECK(write_image(name, IMAGE_565) < 0);
    CHECK_MSG(strstr(why, strerror(EPIPE)), "said '%s'", why);
    (void)close(ends[1]);
}

int main(void)
{
    (void)snprintf(directory, sizeof directory, "%s/tia-image-XXXXXX", "/tmp");
    if (!mkdtemp(directory)) {
        printf("FAIL set up: %s: %s\n", directory, strerror(errno));
        return 1;
    }
    (void)snprintf(path, sizeof path, "%s/picture", directory);
    RUN(names);
    RUN(raw_is_little_endian);
    RUN(ppm_replicates_bits);
    RUN(bmp_is_bottom_up_and_padded);
    RUN(png_header);
    RUN(a_file_appears_only_when_finished);
    RUN(a_discarded_file_leaves_the_old_one);
    RUN(missing_rows_are_an_error);
    RUN(permissions_follow_the_umask);
    RUN(a_link_stays_a_link);
    RUN(the_longest_name_works);
    (void)unlink(path);
    RUN(a_full_device_says_so);
    RUN(a_file_that_cannot_grow_is_removed);
    RUN(no_directory_no_file);
    RUN(a_closed_pipe_is_an_error);
    (void)unlink(path);
    (void)rmdir(directory);
    return check_status();
}
