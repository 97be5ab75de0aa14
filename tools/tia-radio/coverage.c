#include "coverage.h"

#include <inttypes.h>
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/bvh.h>
#include <tia/text.h>

#include "common/image/codec.h"
#include "common/image/stored.h"
#include "common/text_file.h"
#include "common/verify/report.h"
#include "common/views/palette.h"
#include "path_picture.h"
#include "ports.h"
#include "refuse.h"

#define INSIDE 0x8410  /* grey, for pixels inside a wall */
#define NOTHING 0x0000 /* black, for pixels without a path */

struct map {
    const struct options *options;
    const struct site *site;
    const struct search *search;
    struct sequences sequences[PLACES_MOST]; /* for the hybrid method: the sequences of each transmitter */
    int across[2];                           /* numbers of the axes to the right and up */
    bool down;                               /* the second axis grows downwards */
    double area[4];
    unsigned first_row, rows;
    double *gain; /* gains in dB by row, pixel and transmitter; NAN inside a wall, -INFINITY without a path */
    atomic_bool exhausted;
    const struct choice *choice; /* NULL, or the rows to compute */
};

/* ---- axes ---- */

/* Chooses the axes. The plane is seen from the positive side of its normal's axis. In a view from above, north, -z, is
 * up. */
static void choose_axes(struct map *map)
{
    int axis = map->options->map.axis;

    map->across[0] = axis == 0 ? 2 : 0;
    map->across[1] = axis == 1 ? 2 : 1;
    map->down = axis == 1;
}

static double coordinate(const struct map *map, const struct tia_vec3 *v, int k)
{
    return metres_of(&map->site->world, k == 0 ? v->x : k == 1 ? v->y : v->z);
}

static int choose_area(struct map *map)
{
    const struct tia_scene *scene = &map->site->file.scene;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

    memcpy(map->area, map->options->area, sizeof map->area);
    if (map->options->has_area)
        return FINE;
    for (uint32_t i = 0; i < scene->sphere_count + scene->shape_count; i++) {
        struct tia_bounds b = tia_object_bounds(scene, i);
        for (int k = 0; k < 2 && b.min.x <= b.max.x; k++) {
            low[k] = fmin(low[k], coordinate(map, &b.min, map->across[k]));
            high[k] = fmax(high[k], coordinate(map, &b.max, map->across[k]));
        }
    }
    for (int k = 0; k < 2; k++) {
        map->area[k] = low[k];
        map->area[k + 2] = high[k];
    }
    return low[0] < high[0] && low[1] < high[1]
               ? FINE
               : refuse(REFUSED, "--area: is missing, and the scene has only infinite planes");
}

static bool place_of(const struct map *map, unsigned x, unsigned y, struct tia_vec3 *place)
{
    const struct options *o = map->options;
    double part[2] = {(x + 0.5) / o->width, map->down ? (y + 0.5) / o->height : 1 - (y + 0.5) / o->height}, at[3];

    at[o->map.axis] = o->map.at;
    for (int k = 0; k < 2; k++)
        at[map->across[k]] = map->area[k] + part[k] * (map->area[k + 2] - map->area[k]);
    *place = place_at(&map->site->world, at);
    return tia_radio_inside(map->site->radio, *place) == TIA_RADIO_NO_OBJECT;
}

/* ---- gains ---- */

static bool is_same_place(struct tia_vec3 a, struct tia_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Returns the gain in dB by the coherent sum over the paths; NAN at the transmitter, -INFINITY without a path. The
 * paths are sorted, so that every method and thread computes the same bits. */
static double gain_at(struct map *map, struct tia_radio_room *room, struct path_list *list, unsigned tx,
                      struct tia_vec3 place)
{
    const struct options *o = map->options;
    double complex sum = 0;

    list->count = 0;
    if (is_same_place(o->tx.array[tx], place))
        return NAN;
    if (!links_try(map->search, room, o->method == METHOD_HYBRID ? &map->sequences[tx] : NULL, o->tx.array[tx], place,
                   list))
        atomic_store(&map->exhausted, true);
    links_sort(list);
    for (unsigned i = 0; i < list->count; i++) {
        struct field field;
        field_of(&map->site->world, &list->paths[i], &field);
        sum += field.gain[o->horizontal ? HORIZONTAL : VERTICAL];
    }
    return list->count > 0 ? 20 * log10(cabs(sum)) : -INFINITY;
}

static void fill_row(void *arg, unsigned row)
{
    struct map *map = arg;
    const struct options *o = map->options;
    struct tia_radio_room *room = malloc(tia_radio_room_size());
    struct path_list list = {.paths = NULL};
    double *gain = map->gain + (size_t)row * o->width * o->tx.count;
    bool wanted = !map->choice || choice_has(map->choice, 0, map->first_row + row);

    for (unsigned x = 0; wanted && x < o->width && room && !atomic_load(&map->exhausted); x++) {
        struct tia_vec3 place;
        bool outside = place_of(map, x, map->first_row + row, &place);
        for (unsigned tx = 0; tx < o->tx.count; tx++)
            *gain++ = outside ? gain_at(map, room, &list, tx, place) : NAN;
    }
    if (!room)
        atomic_store(&map->exhausted, true);
    free(list.paths);
    free(room);
}

static unsigned best_of(const double *gain, unsigned count)
{
    unsigned best = 0;

    for (unsigned i = 1; i < count; i++)
        best = gain[i] > gain[best] || isnan(gain[best]) ? i : best;
    return best;
}

/* ---- the picture ---- */

static tia_rgb565 colour_of(const struct options *o, const double *gain)
{
    unsigned best = best_of(gain, o->tx.count);

    if (isnan(gain[best]))
        return INSIDE;
    if (isinf(gain[best]))
        return NOTHING;
    return o->best_server ? palette_number(best)
                          : palette_heat(0.08 + 0.92 * (gain[best] - o->range[0]) / (o->range[1] - o->range[0]));
}

static void draw_label(const struct options *o, unsigned line, unsigned lines, tia_rgb565 paper, const char *text,
                       struct tia_tile tile, const struct tia_surface *surface)
{
    unsigned scale = o->height / 320 > 1 ? o->height / 320u : 1, step = (TIA_TEXT_HEIGHT + 1) * scale;
    unsigned brightness = 2u * (paper >> 11) + 2u * (paper >> 5 & 63) + (paper & 31u);
    struct tia_text label = {
        text, 0, (uint16_t)(o->height - (lines - line) * step), (uint16_t)scale, brightness > 100 ? 0 : 0xffff, paper};

    if (lines * step <= o->height)
        tia_text_draw(&label, tile, surface);
}

static void draw_legend(const struct options *o, struct tia_tile tile, const struct tia_surface *surface)
{
    unsigned lines = o->best_server ? o->tx.count : 6;

    for (unsigned i = 0; i < lines; i++) {
        double part = i / 5.0, db = o->range[1] + part * (o->range[0] - o->range[1]);
        char text[40];
        if (o->best_server)
            (void)snprintf(text, sizeof text, " tx %u ", i + 1);
        else
            (void)snprintf(text, sizeof text, " %6.1f dB ", db);
        draw_label(o, i, lines, o->best_server ? palette_number(i) : palette_heat(0.08 + 0.92 * (1 - part)), text, tile,
                   surface);
    }
}

/* Colours rows of the map, from row `y` of the picture on. */
static void colour_rows(const struct map *map, unsigned y, unsigned rows, tia_rgb565 *pixels)
{
    const struct options *o = map->options;
    const double *gain = map->gain + (size_t)(y - map->first_row) * o->width * o->tx.count;
    struct tia_tile tile = {0, (uint16_t)y, o->width, (uint16_t)rows};
    struct tia_surface surface = {
        .pixels = pixels, .step = sizeof *pixels, .pitch = (ptrdiff_t)(o->width * sizeof *pixels)};

    for (size_t i = 0; i < (size_t)o->width * rows; i++)
        pixels[i] = colour_of(o, gain + i * o->tx.count);
    draw_legend(o, tile, &surface);
}

static int write_picture(const struct map *map)
{
    const struct options *o = map->options;
    tia_rgb565 *pixels = malloc((size_t)o->width * map->rows * sizeof *pixels);

    if (!pixels)
        return refuse(FAILED, "memory: exhausted");
    colour_rows(map, map->first_row, map->rows, pixels);
    int result = picture_write(o, pixels, map->first_row, map->rows, map->site->file.crc);
    free(pixels);
    return result;
}

/* ---- the numbers ---- */

static void write_pixel(const struct map *map, struct text *text, unsigned x, unsigned y)
{
    const struct options *o = map->options;
    const double *gain = map->gain + ((size_t)y * o->width + x) * o->tx.count;
    struct tia_vec3 place;

    (void)place_of(map, x, map->first_row + y, &place);
    text_print(text, "%.9f,%.9f,%.9f", coordinate(map, &place, 0), coordinate(map, &place, 1),
               coordinate(map, &place, 2));
    for (unsigned i = 0; i < o->tx.count; i++)
        if (isfinite(gain[i]))
            text_print(text, ",%.6f", gain[i]);
        else
            text_print(text, ",%s", isnan(gain[i]) ? "wall" : "none");
    unsigned best = best_of(gain, o->tx.count);
    text_print(text, ",%u\n", isfinite(gain[best]) ? best + 1 : 0);
}

static int write_csv(const struct map *map)
{
    const struct options *o = map->options;
    static struct text text; /* too large for the stack */
    char why[PORT_WHY];

    if (text_open(&text, o->csv, why))
        return refuse(FAILED, "%s", why);
    if (map->first_row == 0) {
        text_print(&text, "x,y,z");
        for (unsigned i = 0; i < o->tx.count; i++)
            text_print(&text, ",tx%u_dB", i + 1);
        text_print(&text, ",best\n");
    }
    for (unsigned y = 0; y < map->rows; y++)
        for (unsigned x = 0; x < o->width; x++)
            write_pixel(map, &text, x, y);
    return text_close(&text) ? refuse(FAILED, "%s", why) : FINE;
}

/* ---- the whole map ---- */

static bool compute(struct map *map)
{
    const struct options *o = map->options;
    bool fine = true;

    map->gain = malloc((size_t)o->width * map->rows * o->tx.count * sizeof *map->gain);
    for (unsigned tx = 0; tx < o->tx.count && fine && o->method == METHOD_HYBRID; tx++)
        fine = sequences_shoot(map->search, o->tx.array[tx], &map->sequences[tx]);
    if (!map->gain || !fine)
        return false;
    threads_run(map->search->pool, fill_row, map, map->rows);
    return !atomic_load(&map->exhausted);
}

/* Chooses the area and computes the map. */
static int prepare(struct map *map)
{
    choose_axes(map);
    int result = choose_area(map);

    return result == FINE && !compute(map) ? refuse(FAILED, "memory: exhausted") : result;
}

static void release(struct map *map)
{
    for (unsigned i = 0; i < PLACES_MOST; i++)
        free(map->sequences[i].array);
    free(map->gain);
}

int map_draw(const struct options *o, const struct site *site, const struct search *search)
{
    static struct map map;

    map = (struct map){.options = o, .site = site, .search = search, .rows = o->height};
    if (o->has_rows) {
        map.first_row = o->first_row;
        map.rows = o->last_row - o->first_row + 1u;
    }
    int result = prepare(&map);
    if (result == FINE && o->output)
        result = write_picture(&map);
    if (result == FINE && o->csv)
        result = write_csv(&map);
    release(&map);
    return result;
}

/* ---- a map to be verified ---- */

static void place_in(const void *rows, uint64_t index, uint32_t *frame, unsigned *y)
{
    stored_place(rows, index, frame, y);
}

/* Compares the chosen rows. */
static int compare(struct map *map, struct stored *stored, struct report *report)
{
    const struct options *o = map->options;
    tia_rgb565 *pixels = malloc(o->width * sizeof *pixels);
    unsigned char *bytes = malloc(2 * o->width * sizeof *pixels);
    int result = pixels && bytes ? FINE : refuse(REFUSED, "memory: exhausted");
    bool exact;

    for (uint64_t i = 0; i < map->choice->count && result == FINE; i++) {
        unsigned y = (unsigned)map->choice->keys[i];
        colour_rows(map, y, 1, pixels);
        size_t length = image_put565(bytes, pixels, o->width);
        if (stored_row(stored, 0, y, bytes + length, &exact))
            result = refuse(REFUSED, "%s", stored->why);
        else
            report_row(report, 0, y, bytes + length, bytes, length, exact);
    }
    free(pixels);
    free(bytes);
    return result != FINE ? result : report_end(report, map->choice) ? FINE : FAILED;
}

/* Checks the size of the picture, and that a part is of this scene. */
static int check_stored(const struct map *map, struct stored *stored)
{
    const struct options *o = map->options;

    if (stored->film.width != o->width || stored->film.height != o->height)
        return refuse(FAILED, "%.200s: is of %ux%u, not %ux%u", o->verify, stored->film.width, stored->film.height,
                      o->width, o->height);
    if (stored->is_sums || (!stored->is_part && stored_depth(stored, 0)))
        return refuse(REFUSED, "%.200s: not a map", o->verify);
    if (stored->is_part && (stored->film.crc != map->site->file.crc || stored->film.all_frames != 1))
        return refuse(FAILED, "%.200s: is a map of another scene", o->verify);
    return FINE;
}

static int verify(struct map *map, struct stored *stored)
{
    const struct options *o = map->options;
    struct choice choice = {.keys = NULL};
    struct report report = {
        .out = stdout, .name = o->verify, .unit = "rows", .done = "drawn again", .from = "", .pixels = o->width};
    int result = check_stored(map, stored);

    if (result == FINE && choice_make(&choice, &o->choice, stored_rows(stored), place_in, stored))
        result = refuse(REFUSED, "memory: exhausted");
    if (result == FINE && !choice.count)
        result = refuse(REFUSED, "--rows: none of them is in %.200s", o->verify);
    map->choice = &choice;
    result = result == FINE ? prepare(map) : result;
    result = result == FINE ? compare(map, stored, &report) : result;
    choice_free(&choice);
    return result;
}

int map_verify(struct options *o, const struct site *site, const struct search *search)
{
    static struct map map;
    struct stored stored;
    int result = REFUSED;

    if (stored_open(&stored, o->verify, image_format_of(o->verify), o->width, o->height)) {
        (void)refuse(REFUSED, "%s", stored.why);
    } else {
        o->width = o->has_size ? o->width : (uint16_t)stored.film.width;
        o->height = o->has_size ? o->height : (uint16_t)stored.film.height;
        map = (struct map){.options = o, .site = site, .search = search, .rows = o->height};
        result = verify(&map, &stored);
        release(&map);
    }
    stored_close(&stored);
    return result;
}
