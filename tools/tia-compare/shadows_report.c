#include "shadows_report.h"

#include <inttypes.h>
#include <stdio.h>

#include "report.h"

static void print_fault(const struct tia_fault *fault)
{
    if (fault->field)
        printf("%s %" PRIu32 ": %s: %s", fault->thing, fault->index, fault->field, fault->rule);
    else
        printf("a point is too far away");
}

static void print_row(const struct shadows_row *row)
{
    printf("%-12s ", row->name);
    if (!row->fits) {
        printf("does not qualify: ");
        print_fault(&row->fault);
        putchar('\n');
        return;
    }
    printf("%8" PRIu64 " %8" PRIu64 " %8" PRIu64 " %8" PRIu64 " %10.3f %10.3f %10" PRIu64 "\n", row->objects, row->dark,
           row->lit, row->colours, (double)row->wall_us / 1000, (double)row->cpu_us / 1000, (row->bytes + 1023) / 1024);
}

static void print_table(const struct shadows_table *t)
{
    printf("%s, %ux%u, %" PRIu64 " pixels see an object", t->scene, t->width, t->height, t->seen);
    if (t->light)
        printf("; light %u alone", t->light);
    printf("\n%-12s %8s %8s %8s %8s %10s %10s %10s\n", "", "object", "dark", "lit", "colour", "wall ms", "CPU ms",
           "KiB");
    for (unsigned i = 0; i < t->count; i++)
        print_row(&t->rows[i]);
    for (uint32_t i = 0; i < t->meshes; i++)
        if (!t->is_closed[i])
            printf("mesh %" PRIu32 " does not close: it casts face by face\n", i);
}

static void json_row(const struct shadows_row *row)
{
    printf("\n  {\"technique\": \"%s\", ", row->name);
    if (!row->fits) {
        printf("\"refused\": \"");
        print_fault(&row->fault);
        printf("\"}");
        return;
    }
    printf("\"object\": %" PRIu64 ", \"dark\": %" PRIu64 ", \"lit\": %" PRIu64 ", \"colour\": %" PRIu64
           ", \"wall_ms\": %.3f, \"cpu_ms\": %.3f, \"bytes\": %" PRIu64 "}",
           row->objects, row->dark, row->lit, row->colours, (double)row->wall_us / 1000, (double)row->cpu_us / 1000,
           row->bytes);
}

static void json_table(const struct shadows_table *t)
{
    printf("{\"scene\": ");
    report_json_string(t->scene);
    printf(", \"width\": %u, \"height\": %u, \"reference\": \"%s\", \"seen\": %" PRIu64 ", \"light\": ", t->width,
           t->height, t->reference, t->seen);
    if (t->light)
        printf("%u", t->light);
    else
        printf("null");
    printf(", \"techniques\": [");
    for (unsigned i = 0; i < t->count; i++) {
        (void)fputs(i ? "," : "", stdout);
        json_row(&t->rows[i]);
    }
    printf("], \"open\": [");
    for (uint32_t i = 0, n = 0; i < t->meshes; i++)
        if (!t->is_closed[i])
            printf(n++ ? ", %" PRIu32 : "%" PRIu32, i);
    printf("]}");
}

void shadows_report_begin(const struct shadows_report *report)
{
    if (report->json)
        printf("{\"scenes\": [\n");
}

void shadows_report_scene(struct shadows_report *report, const struct shadows_table *table)
{
    if (report->scenes++)
        printf(report->json ? ",\n" : "\n");
    if (report->json)
        json_table(table);
    else
        print_table(table);
    (void)fflush(stdout);
}

void shadows_report_end(const struct shadows_report *report)
{
    if (report->json)
        printf("]}\n");
    else
        printf("\npixels where a technique differs from the first row: object: another one is seen;\n"
               "dark, lit: light is missing, or arrives, wrongly; colour: for any reason.\n");
}
