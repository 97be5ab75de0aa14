/* radio.c - the command line of tia-radio: any bytes, a newline between arguments. Accepted options keep their limits.
 */
#include <math.h>

#include "common/image/image.h"
#include "tia-radio/options.h"
#include "tia-radio/refuse.h"
#include "tia-radio/wall_materials.h"
#include "words.h"

static void must_be_material(const struct naming *naming)
{
    MUST(memchr(naming->name, '\0', sizeof naming->name) && memchr(naming->itu, '\0', sizeof naming->itu));
    MUST(*naming->itu ? itu_has(naming->itu) : naming->permittivity >= 1);
    MUST(naming->permittivity == 0 || (naming->permittivity >= 1 && naming->permittivity <= 1e6));
    MUST(naming->conductivity >= 0 && naming->conductivity <= 1e12);
    MUST(naming->thickness >= 0 && naming->thickness <= 1000);
}

static void must_be_map(const struct options *o)
{
    MUST(o->map.axis <= 2 && !o->rx.count && !o->json && o->method != METHOD_SBR && (o->output || o->csv));
    MUST(o->width >= 1 && o->width <= TIA_SIZE_MAX && o->height >= 1 && o->height <= TIA_SIZE_MAX);
    MUST(!o->has_rows || (o->first_row <= o->last_row && o->last_row < o->height));
    MUST(!o->has_area || (o->area[0] < o->area[2] && o->area[1] < o->area[3]));
    MUST(o->range[0] < o->range[1] && isfinite(o->range[0]) && isfinite(o->range[1]));
}

static void must_keep_limits(const struct options *o)
{
    MUST(o->scene && o->tx.count >= 1 && o->tx.count <= PLACES_MOST && o->rx.count <= PLACES_MOST);
    MUST(o->frequency >= 1e6 && o->frequency <= 1e12 && o->method < METHODS && (o->up == 1 || o->up == 2));
    MUST(o->order <= TIA_RADIO_ORDER_MAX && o->walls <= TIA_RADIO_WALLS_MAX && o->threads >= 1);
    MUST(o->density >= 1 && o->density <= TIA_RADIO_DENSITY_MAX && o->namings.count <= NAMES_MOST);
    for (unsigned i = 0; i < o->namings.count; i++)
        must_be_material(&o->namings.array[i]);
    if (o->map.axis >= 0)
        must_be_map(o);
    else
        MUST(o->rx.count >= 1 && !o->csv && !o->has_rows);
    MUST(!o->output || image_format_built(o->format));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct words words = take_words("tia-radio", data, size);
    static struct options options;
    int status = options_parse(&options, words.argc, words.argv);

    MUST(status == FINE || status == REFUSED || status == FAILED || status == COMMAND_RUN);
    if (status == COMMAND_RUN)
        must_keep_limits(&options);
    free(words.text);
    return 0;
}
