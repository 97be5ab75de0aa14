/* tia-radio - paths of radio waves in a scene, and the waves that arrive along them. */
#include <stdio.h>
#include <stdlib.h>

#include "common/message.h"
#include "common/signals.h"
#include "coverage.h"
#include "link_report.h"
#include "options.h"
#include "path_picture.h"
#include "refuse.h"
#include "site.h"

struct run {
    struct options options;
    struct site site;
    struct search search;
    struct path_list all; /* paths of all links, for a picture */
    struct tia_vec3 (*ends)[2];
};

static int keep_paths(struct run *run, const struct path_list *list, struct tia_vec3 tx, struct tia_vec3 rx)
{
    struct path_list *all = &run->all;
    unsigned count = all->count + list->count;

    if (!run->options.output || list->count == 0)
        return FINE;
    struct tia_radio_path *paths = realloc(all->paths, count * sizeof *paths);
    all->paths = paths ? paths : all->paths;
    struct tia_vec3(*ends)[2] = realloc(run->ends, count * sizeof *ends);
    run->ends = ends ? ends : run->ends;
    if (!paths || !ends)
        return refuse(FAILED, "memory: exhausted");
    for (unsigned i = 0; i < list->count; i++, all->count++) {
        all->paths[all->count] = list->paths[i];
        run->ends[all->count][0] = tx;
        run->ends[all->count][1] = rx;
    }
    return FINE;
}

static int run_link(struct run *run, struct tia_vec3 tx, struct tia_vec3 rx, bool first)
{
    struct path_list list;
    bool fine = links_find(&run->search, tx, rx, &list);
    struct field *fields = fine ? calloc(list.count + 1u, sizeof *fields) : NULL;
    struct link_report report = {&run->options, &run->site.world, tx, rx, list.paths, fields, list.count};
    int result = fields ? FINE : refuse(FAILED, "memory: exhausted");

    for (unsigned i = 0; i < list.count && fields; i++)
        field_of(&run->site.world, &list.paths[i], &fields[i]);
    if (fields && run->options.json)
        report_json(&report, first);
    else if (fields)
        report_table(&report);
    if (result == FINE)
        result = keep_paths(run, &list, tx, rx);
    free(fields);
    free(list.paths);
    return result;
}

static int check_places(const struct run *run)
{
    const struct options *o = &run->options;
    int result = FINE;

    for (unsigned i = 0; i < o->tx.count && result == FINE; i++)
        result = site_check_place(&run->site, "--tx", o->tx.array[i]);
    for (unsigned i = 0; i < o->rx.count && result == FINE; i++)
        result = site_check_place(&run->site, "--rx", o->rx.array[i]);
    for (unsigned i = 0; i < o->tx.count && result == FINE; i++)
        for (unsigned k = 0; k < o->rx.count && result == FINE; k++)
            if (o->tx.array[i].x == o->rx.array[k].x && o->tx.array[i].y == o->rx.array[k].y &&
                o->tx.array[i].z == o->rx.array[k].z)
                result = refuse(REFUSED, "--rx: is where --tx is");
    return result;
}

static int run_links(struct run *run)
{
    const struct options *o = &run->options;
    int result = FINE;

    if (o->json)
        report_json_begin(o, &run->site.world);
    for (unsigned i = 0; i < o->tx.count && result == FINE; i++)
        for (unsigned k = 0; k < o->rx.count && result == FINE; k++)
            result = run_link(run, o->tx.array[i], o->rx.array[k], i + k == 0);
    if (o->json && result == FINE)
        report_json_end();
    if (result == FINE && message_output("tia-radio", ""))
        result = FAILED;
    return result == FINE && o->output ? picture_draw(o, &run->site, run->search.pool, &run->all, run->ends) : result;
}

int main(int argc, char **argv)
{
    static struct run run;
    const struct options *o = &run.options;
    int result = options_parse(&run.options, argc, argv);

    if (result != COMMAND_RUN)
        return result;
    signals_prepare();
    struct threads *pool = threads_create(o->threads);
    run.search = (struct search){NULL, pool, o->method, o->order, o->walls, o->density};
    result = pool ? site_open(&run.site, o) : refuse(FAILED, "memory: exhausted");
    run.search.radio = run.site.radio;
    if (result == FINE)
        site_place(&run.site, &run.options);
    if (result == FINE)
        result = check_places(&run);
    if (result == FINE)
        result = o->verify          ? map_verify(&run.options, &run.site, &run.search)
                 : o->map.axis >= 0 ? map_draw(o, &run.site, &run.search)
                                    : run_links(&run);
    site_close(&run.site);
    free(run.all.paths);
    free(run.ends);
    threads_destroy(pool);
    return result;
}
