/* replay.c - a fuzzer without libFuzzer: gives the function under test each file of a corpus, and changed copies of
 * them, which are the same in each run.
 *
 *   replay CORPUS RUNS     RUNS: how many changed copies
 *
 * The input that breaks something is written to standard error in hexadecimal. */
#include <dirent.h>
#include <inttypes.h>
#include <sanitizer/common_interface_defs.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/corpus/dice.h"

#define INPUT_MOST 600 /* bytes */
#define FILES_MOST 512

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

struct input {
    size_t size;
    uint8_t bytes[INPUT_MOST];
};

static struct input files[FILES_MOST], input;
static size_t file_count;

static void tell(void)
{
    fprintf(stderr, "the input:");
    for (size_t i = 0; i < input.size; i++)
        fprintf(stderr, " %02x", input.bytes[i]);
    fprintf(stderr, "\n");
}

static void on_abort(int number)
{
    tell();
    (void)signal(number, SIG_DFL);
    (void)raise(number);
}

/* Tests a copy that has no byte more than the input, so that reads behind its end are noticed. */
static void test(void)
{
    uint8_t *copy = malloc(input.size ? input.size : 1);

    if (!copy)
        exit(1);
    memcpy(copy, input.bytes, input.size);
    (void)LLVMFuzzerTestOneInput(copy, input.size);
    free(copy);
}

static int by_name(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

static int is_file(const struct dirent *entry)
{
    return entry->d_name[0] != '.';
}

/* Reads the first FILES_MOST files. */
static void read_corpus(const char *path)
{
    struct dirent **entries;
    int count = scandir(path, &entries, is_file, by_name);
    int most = count < FILES_MOST ? count : FILES_MOST;

    for (int i = 0; i < most; i++) {
        char name[4096];
        (void)snprintf(name, sizeof name, "%s/%s", path, entries[i]->d_name);
        FILE *file = fopen(name, "rb");
        free(entries[i]);
        if (!file)
            continue;
        files[file_count].size = fread(files[file_count].bytes, 1, INPUT_MOST, file);
        file_count++;
        (void)fclose(file);
    }
    if (count >= 0)
        free(entries);
}

static size_t below(uint64_t *random, size_t limit)
{
    return (size_t)(dice_next(random) % limit);
}

/* Changes a byte, a bit or a number, cuts the input, or takes a piece of another one. */
static void change(uint64_t *random)
{
    const struct input *other = &files[below(random, file_count)];
    size_t at = input.size ? below(random, input.size) : 0, room = INPUT_MOST - at;

    switch (below(random, 6)) {
    case 0:
        input.bytes[at] = (uint8_t)below(random, 256);
        break;
    case 1:
        input.bytes[at] ^= (uint8_t)(1u << below(random, 8));
        break;
    case 2:
        input.bytes[at] = (uint8_t) "09-.\0\xff \n"[below(random, 8)];
        break;
    case 3:
        input.size = at;
        break;
    case 4:
        room = room < other->size ? room : other->size;
        memcpy(input.bytes + at, other->bytes, room);
        input.size = input.size > at + room ? input.size : at + room;
        break;
    default:
        room = room > input.size - at ? input.size - at : room;
        memmove(input.bytes + at / 2, input.bytes + at, room);
        break;
    }
}

int main(int argc, char **argv)
{
    uint64_t random = 1;
    uint64_t runs = argc > 2 ? strtoull(argv[2], NULL, 10) : 0;

    (void)signal(SIGABRT, on_abort);
    __sanitizer_set_death_callback(tell);
    if (argc > 1)
        read_corpus(argv[1]);
    if (file_count == 0) {
        fprintf(stderr, "no corpus\n");
        return 1;
    }
    for (uint64_t i = 0; i < file_count + runs; i++) {
        input = files[i < file_count ? i : below(&random, file_count)];
        for (size_t n = i < file_count ? 0 : 1 + below(&random, 4); n > 0; n--)
            change(&random);
        test();
    }
    return 0;
}
