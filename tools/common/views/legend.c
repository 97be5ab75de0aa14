#include "legend.h"

#include <stdio.h>
#include <tia/text.h>

#include "common/views/palette.h"
#include "false_colour.h"

/* A line of the legend, drawn in the colour that it explains. Lines are listed from top to bottom. */
struct legend_line {
    char text[32];
    tia_rgb565 colour;
};

enum { LINES = 8, RAYS = 7 };

tia_rgb565 legend_ray(unsigned kind)
{
    static const tia_rgb565 colours[RAYS] = {0xffff, 0xffe0, 0x07ff, 0xc618, 0x07e0, 0xf800, 0xf81f};

    return colours[kind < RAYS ? kind : 0];
}

static unsigned ray_lines(struct legend_line lines[LINES])
{
    static const char *const names[RAYS] = {"primary",       "reflected",      "refracted", "past an opacity",
                                            "light arrives", "light does not", "normal"};

    for (unsigned i = 0; i < RAYS; i++) {
        (void)snprintf(lines[i].text, sizeof lines[i].text, "%s", names[i]);
        lines[i].colour = legend_ray(i);
    }
    return RAYS;
}

static unsigned depth_lines(const struct legend *legend, struct legend_line lines[LINES])
{
    static const double parts[] = {0.25, 0.5, 1, 2, 4, 8};

    for (unsigned i = 0; i < 6; i++) {
        (void)snprintf(lines[i].text, sizeof lines[i].text, "%.4g", parts[i] * legend->scale);
        lines[i].colour = palette_heat(1 / (parts[i] + 1));
    }
    return 6;
}

static unsigned count_lines(const struct legend *legend, struct legend_line lines[LINES])
{
    for (unsigned i = 0; i < 6; i++) {
        (void)snprintf(lines[i].text, sizeof lines[i].text, "%u %s", 4U << 2 * i,
                       legend->view == VIEW_COST ? "tests" : "rays");
        lines[i].colour = palette_heat((2 * i + 2) / 12.0);
    }
    return 6;
}

static unsigned normal_lines(struct legend_line lines[LINES])
{
    static const char *const names[6] = {"+x", "-x", "+y", "-y", "+z", "-z"};

    for (int i = 0; i < 6; i++) {
        double to = i % 2 ? 0 : 1;
        (void)snprintf(lines[i].text, sizeof lines[i].text, "%s", names[i]);
        lines[i].colour = palette_rgb(i / 2 == 0 ? to : 0.5, i / 2 == 1 ? to : 0.5, i / 2 == 2 ? to : 0.5);
    }
    return 6;
}

static unsigned number_lines(const struct legend *legend, struct legend_line lines[LINES])
{
    bool lights = legend->view == VIEW_LIGHT;
    uint32_t all = lights ? legend->lights : legend->objects, count = all < LINES ? all : LINES;

    for (uint32_t i = 0; i < count; i++) {
        (void)snprintf(lines[i].text, sizeof lines[i].text, "%s %u%s", lights ? "light" : "object", (unsigned)i,
                       i + 1 == LINES && all > LINES ? " ..." : "");
        lines[i].colour = lights ? seen_lights(UINT32_C(1) << i) : palette_number(i);
    }
    return count;
}

static unsigned lines_of(const struct legend *legend, struct legend_line lines[LINES])
{
    switch (legend->view) {
    case VIEW_DEPTH:
        return depth_lines(legend, lines);
    case VIEW_NORMAL:
        return normal_lines(lines);
    case VIEW_COST:
    case VIEW_PATH:
        return count_lines(legend, lines);
    case VIEW_OBJECT:
    case VIEW_LIGHT:
        return number_lines(legend, lines);
    default:
        return legend->rays ? ray_lines(lines) : 0;
    }
}

/* Returns the background of a label: white for dark colours. */
static tia_rgb565 paper_for(tia_rgb565 ink)
{
    unsigned brightness = 2u * (ink >> 11) + 2u * (ink >> 5 & 63) + (ink & 31u);

    return brightness > 64 ? 0 : 0xffff;
}

void legend_draw(const struct legend *legend, struct tia_tile tile, const struct tia_surface *surface)
{
    unsigned scale = legend->height / 320 > 1 ? legend->height / 320 : 1;
    struct legend_line lines[LINES];
    unsigned count = lines_of(legend, lines), step = (TIA_TEXT_HEIGHT + 1) * scale;

    for (unsigned i = 0; i < count && count * step <= legend->height; i++) {
        struct tia_text text = {lines[i].text,
                                0,
                                (uint16_t)(legend->height - (count - i) * step),
                                (uint16_t)scale,
                                lines[i].colour,
                                paper_for(lines[i].colour)};
        tia_text_draw(&text, tile, surface);
    }
}
