/* check.h - the checks of all C tests. A test program runs its cases one by one and prints a line
 * for each: "ok NAME", "FAIL NAME: FILE:LINE: WHAT" or "skip NAME: WHY". tests/run counts them.
 *
 *     TEST(square_root_of_4) { CHECK(root(4) == 2); CHECK_EQ(root(5), 2); }
 *     int main(void) { RUN(square_root_of_4); return check_status(); }
 *
 * The first CHECK of a case that fails is reported; the case goes on. `PROGRAM NAME` runs one case, see check_case.h.
 */
#ifndef TESTS_CHECK_H
#define TESTS_CHECK_H

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check_case.h"

/* Suppresses a report of -fsanitize=address: OSMesa leaks about 100 bytes for each context. */
#if defined __SANITIZE_ADDRESS__ || defined __clang__
__attribute__((weak)) const char *__lsan_default_suppressions(void);
__attribute__((weak)) const char *__lsan_default_suppressions(void)
{
    return "leak:libOSMesa.so\n";
}
#endif

static int check_failed, check_failures;
static char check_why[500];

#define TEST(name) static void name(void)
#define SKIP(...) ((void)snprintf(check_why, sizeof check_why, __VA_ARGS__), check_failed = -1)
#define CHECK_MSG(condition, ...)                                                                                      \
    do {                                                                                                               \
        if (!(condition) && check_failed <= 0) {                                                                       \
            int check_n = snprintf(check_why, sizeof check_why, "%s:%d: ", __FILE__, __LINE__);                        \
            (void)snprintf(check_why + check_n, sizeof check_why - (size_t)check_n, __VA_ARGS__);                      \
            check_failed = 1;                                                                                          \
        }                                                                                                              \
    } while (0)
#define CHECK(condition) CHECK_MSG(condition, "%s", #condition)
#define CHECK_EQ(got, want)                                                                                            \
    do {                                                                                                               \
        intmax_t check_got = (intmax_t)(got), check_want = (intmax_t)(want);                                           \
        CHECK_MSG(check_got == check_want, "%s is %jd, not %jd", #got, check_got, check_want);                         \
    } while (0)

/* True in make check-quick, in which tests omit long cases. */
static inline bool check_is_quick(void)
{
    return getenv("CHECK_QUICK") != NULL;
}

/* Returns the number of random cases: `full`, or with CHECK_QUICK a part of it: a quarter, or less if it is
 * a number larger than 4: 16 stands for one in 16. */
static inline unsigned check_count(unsigned full)
{
    const char *quick = getenv("CHECK_QUICK");
    unsigned named = quick ? (unsigned)strtoul(quick, NULL, 10) : 0, part = named > 1 ? named : quick ? 4 : 1;

    return full / part + (full % part > 0);
}

static inline void check_run(const char *name, void (*test)(void))
{
    bool asked = check_is_asked(name);

    if (!asked && (!check_ordered || check_found))
        return;
    check_failed = 0;
    test();
    if (!asked)
        return;
    if (check_failed > 0) {
        check_failures++;
        printf("FAIL %s: %s\n", name, check_why);
    } else if (check_failed < 0) {
        printf("skip %s: %s\n", name, check_why);
    } else {
        printf("ok %s\n", name);
    }
    (void)fflush(stdout);
}

#define RUN(name) check_run(#name, name)

/* Runs a case that takes half a second or more; make check-quick omits it, unless it is the chosen one. */
#define RUN_LONG(name)                                                                                                 \
    do {                                                                                                               \
        if (!check_is_quick() || check_chooses())                                                                      \
            RUN(name);                                                                                                 \
    } while (0)

static inline int check_status(void)
{
    return check_failures ? 1 : check_unmet();
}

#endif
