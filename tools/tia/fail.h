/* fail.h - what the command says when something is wrong: one line, "tia: WHAT: WHY". */
#ifndef TOOLS_TIA_FAIL_H
#define TOOLS_TIA_FAIL_H

/* The exit statuses. */
enum { EXIT_FINE, EXIT_RUNNING, EXIT_USAGE, EXIT_DISPLAY, EXIT_INPUT };

/* Prints "tia: " and the text on standard error, always as one line: control characters, which
 * a file's name may hold, become '?'. Returns `status`. */
__attribute__((format(printf, 2, 3))) int fail(int status, const char *format, ...);

/* For an option's value that breaks `rule`: EXIT_USAGE. */
int wrong(const char *option, const char *value, const char *rule);

/* For a failed write to standard output: EXIT_RUNNING, errno says why. */
int fail_output(void);

/* What a tia_status says of a drawing that gave no reason. */
const char *fail_reason(int status);

/* Prints such a line for what is no error. */
__attribute__((format(printf, 1, 2))) void note(const char *format, ...);

#endif
