#include "report.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "common/message.h"

enum { LINES_MOST = 10, BYTES_MOST = 24 };

/* Writes bytes as hexadecimal digits, at most BYTES_MOST. */
static void format_bytes(char *text, const unsigned char *bytes, size_t count)
{
    for (size_t i = 0; i < count && i < BYTES_MOST; i++)
        (void)snprintf(text + 2 * i, 3, "%02x", bytes[i]);
}

void report_name(const struct report *r)
{
    char name[300];

    (void)snprintf(name, sizeof name, "%s", r->name);
    message_clean(name);
    (void)fprintf(r->out, "%s%s: ", r->before ? r->before : "", name);
}

static void print_row(const struct report *r, uint32_t frame, unsigned y, const unsigned char *stored,
                      const unsigned char *drawn, size_t length, bool exact)
{
    size_t each = length / r->pixels, pixels = 0, first = length;
    char old[2 * BYTES_MOST + 1] = "", new[2 * BYTES_MOST + 1] = "";

    for (size_t at = 0; at + each <= length; at += each)
        if (memcmp(stored + at, drawn + at, each) != 0)
            first = pixels++ ? first : at;
    report_name(r);
    if (r->film)
        (void)fprintf(r->out, "frame %u, ", (unsigned)frame);
    if (!pixels) {
        (void)fprintf(r->out, "row %u differs: %s\n", y,
                      exact ? "its checksum is another" : "a colour that RGB565 does not have");
        return;
    }
    format_bytes(old, stored + first, each);
    format_bytes(new, drawn + first, each);
    (void)fprintf(r->out, "row %u: %zu pixel%s differ%s, the first is %zu: %s, drawn again %s\n", y, pixels,
                  pixels == 1 ? "" : "s", pixels == 1 ? "s" : "", first / each, old, new);
}

void report_row(struct report *r, uint32_t frame, unsigned y, const unsigned char *stored, const unsigned char *drawn,
                size_t length, bool exact)
{
    r->seen++;
    if (exact && !memcmp(stored, drawn, length))
        return;
    if (++r->wrong <= LINES_MOST)
        print_row(r, frame, y, stored, drawn, length, exact);
}

static void print_chance(const struct report *r, const struct choice *choice)
{
    static const double forged[] = {0.001, 0.01, 0.1, 0.5};

    (void)fprintf(r->out, "a forgery of");
    for (unsigned i = 0; i < sizeof forged / sizeof *forged; i++)
        (void)fprintf(r->out, "%s %g %%", i ? "," : "", 100 * forged[i]);
    (void)fprintf(r->out, " of the %s stays unseen with a chance of", r->unit);
    for (unsigned i = 0; i < sizeof forged / sizeof *forged; i++)
        (void)fprintf(r->out, "%s %.3g %%", i ? "," : "", 100 * choice_unseen(choice, forged[i]));
    (void)fprintf(r->out, "\n");
}

bool report_end(const struct report *r, const struct choice *choice)
{
    if (r->quiet && !r->wrong)
        return true;
    report_name(r);
    (void)fprintf(r->out, "%" PRIu64 " of %" PRIu64 " %s %s: ", r->seen, choice->total, r->unit, r->done);
    if (r->wrong)
        (void)fprintf(r->out, "%" PRIu64 " differ%s%s", r->wrong, r->wrong == 1 ? "s" : "", r->from);
    else
        (void)fprintf(r->out, "all the same");
    if (choice->random && choice->count < choice->total)
        (void)fprintf(r->out, "; --seed %" PRIu64, choice->seed);
    (void)fprintf(r->out, "\n");
    if (!r->wrong && choice->random && choice->count < choice->total) {
        report_name(r);
        print_chance(r, choice);
    }
    return !r->wrong;
}
