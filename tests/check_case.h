/* check_case.h - one case of a test program instead of all: `build/tests/test_math square_root_of_4`.
 *
 * The case is the first argument that is a word; numbers, options and paths are the program's own arguments. Arguments
 * are read from /proc/self/cmdline, since main has no parameters in most programs. If that fails, all cases run. In a
 * program with `static bool check_ordered = true;`, cases use counts or random numbers of earlier cases. The earlier
 * cases then run as well, without a report.
 */
#ifndef TESTS_CHECK_CASE_H
#define TESTS_CHECK_CASE_H

#include <ctype.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CHECK_NAME = 80, CHECK_NEAREST = 3 };

static bool check_ordered;           /* true if cases depend on earlier ones, see above */
static char check_asked[CHECK_NAME]; /* the chosen case; "": all cases */
static bool check_asked_known;
static unsigned check_found; /* number of cases of the chosen name */
static struct check_closest {
    char name[CHECK_NAME];
    unsigned distance;
} check_closest[CHECK_NEAREST]; /* the names most similar to the chosen one, the nearest first */

/* Chooses the case to run, "" for all, in place of the program's arguments. */
static inline void check_choose(const char *name)
{
    (void)snprintf(check_asked, sizeof check_asked, "%s", name);
    check_asked_known = true;
}

/* True if an argument is the name of a case. */
static inline bool check_is_word(const char *argument)
{
    return isalpha((unsigned char)*argument) && !strchr(argument, '/');
}

/* Returns argument i as a number; `otherwise` if there is none, or if it is the name of a case. */
static inline uint64_t check_number(int argc, char **argv, int i, uint64_t otherwise)
{
    return i < argc && !check_is_word(argv[i]) ? strtoull(argv[i], NULL, 10) : otherwise;
}

static inline void check_read_arguments(void)
{
    char text[4096];
    FILE *file = fopen("/proc/self/cmdline", "rb");
    size_t size = file ? fread(text, 1, sizeof text - 1, file) : 0;

    text[size] = 0;
    check_choose("");
    for (char *at = text + strlen(text) + 1; at < text + size && !check_asked[0]; at += strlen(at) + 1)
        if (check_is_word(at))
            check_choose(at);
    if (file)
        (void)fclose(file);
}

/* Returns the number of letters to insert, delete or replace to turn one name into the other; 0 if one is part of the
 * other. */
static inline unsigned check_distance(const char *a, const char *b)
{
    unsigned row[CHECK_NAME + 1], n = (unsigned)strnlen(b, CHECK_NAME);

    if (strstr(a, b) || strstr(b, a))
        return 0;
    for (unsigned j = 0; j <= n; j++)
        row[j] = j;
    for (unsigned i = 0; a[i]; i++) {
        unsigned diagonal = row[0]++;
        for (unsigned j = 1; j <= n; j++) {
            unsigned least = diagonal + (a[i] != b[j - 1]);
            least = row[j] + 1 < least ? row[j] + 1 : least;
            diagonal = row[j];
            row[j] = row[j - 1] + 1 < least ? row[j - 1] + 1 : least;
        }
    }
    return row[n];
}

static inline void check_keep_near(const char *name)
{
    struct check_closest one = {.distance = check_distance(check_asked, name) + 1};

    (void)snprintf(one.name, sizeof one.name, "%s", name);
    for (int i = 0; i < CHECK_NEAREST; i++) {
        struct check_closest other = check_closest[i];
        if (!other.distance || one.distance < other.distance) {
            check_closest[i] = one;
            one = other;
        }
    }
}

/* True if the arguments choose one case. */
static inline bool check_chooses(void)
{
    if (!check_asked_known)
        check_read_arguments();
    return check_asked[0] != 0;
}

/* True if a case is the chosen one. The case "avx2: threads", which runs for each instruction set, can also be chosen
 * as "threads". */
static inline bool check_is_asked(const char *name)
{
    const char *part = strrchr(name, ' ');

    if (!check_chooses())
        return true;
    if (strcmp(check_asked, name) == 0 || (part && strcmp(check_asked, part + 1) == 0)) {
        check_found++;
        return true;
    }
    check_keep_near(name);
    return false;
}

/* Returns 0; or 2, after a line on standard error, if there is no case of the chosen name. */
static inline int check_unmet(void)
{
    if (!check_asked_known || !check_asked[0] || check_found)
        return 0;
    (void)fprintf(stderr, "no case '%s': there is", check_asked);
    for (int i = 0; i < CHECK_NEAREST && check_closest[i].distance; i++)
        (void)fprintf(stderr, "%s %s", i ? "," : "", check_closest[i].name);
    (void)fputs("\n", stderr);
    return 2;
}

#endif
