/* spi_model.h - a model of a panel on an SPI bus, which decodes the commands by the data sheets and thus receives a
 * picture. Its DMA is as late as the contract allows, so that drawing too early into a strip is detected; and the bus
 * has a clock, by which it sends. */
#ifndef TESTS_SPI_MODEL_H
#define TESTS_SPI_MODEL_H

#include "check.h"
#include "spi-panel/spi_panel.h"
#include <tia/tia.h>

enum { MEMORY_WIDTH = 240, MEMORY_HEIGHT = 320, MEMORY = MEMORY_WIDTH * MEMORY_HEIGHT, LOG = 4096 };

/* The model: the bus, the controller and its glass. */
static struct model {
    /* the bus */
    const uint8_t *pending; /* data that DMA has not read yet */
    size_t pending_count;
    uint8_t before[2 * 40 * MEMORY_HEIGHT]; /* that data when the transfer began */
    unsigned disturbed;                     /* number of transfers whose data changed meanwhile */
    size_t sent;                            /* bytes, commands included */
    uint64_t byte_ns, bus_ns, end_ns;       /* time of a byte; the processor's time; end of the transfer */
    uint8_t log[LOG];                       /* log of the commands */
    size_t commands;
    int fails_after; /* number of calls until the bus fails; -1: never */
    uint64_t now_us;
    /* the controller */
    uint8_t command;
    size_t parameter;
    bool asleep, on, inverted;
    uint8_t madctl, colmod, gamma[3];
    uint16_t range[2][2];      /* range of columns and of rows: first, last */
    unsigned column, row;      /* position of the next pixel */
    int high;                  /* a pixel's first byte, or -1 */
    uint64_t not_before;       /* end of the last command's pause */
    unsigned early;            /* number of commands during such a pause */
    tia_rgb565 memory[MEMORY]; /* pixels by the glass's own columns and rows */
} model;

static void put_pixel(tia_rgb565 pixel)
{
    unsigned column = model.column, row = model.row;
    if (model.madctl & TIA_SPI_PANEL_SWAP_AXES) {
        unsigned other = column;
        column = row, row = other;
    }
    if (model.madctl & TIA_SPI_PANEL_FLIP_COLUMNS)
        column = MEMORY_WIDTH - 1 - column;
    if (model.madctl & TIA_SPI_PANEL_FLIP_ROWS)
        row = MEMORY_HEIGHT - 1 - row;
    if (column < MEMORY_WIDTH && row < MEMORY_HEIGHT)
        model.memory[row * MEMORY_WIDTH + column] = pixel;
    if (model.column++ == model.range[0][1]) {
        model.column = model.range[0][0];
        if (model.row++ == model.range[1][1])
            model.row = model.range[1][0];
    }
}

static void obey_range(uint16_t range[2], uint8_t byte)
{
    uint16_t *value = &range[model.parameter / 2];
    *value = (uint16_t)(model.parameter % 2 ? (*value & 0xff00) | byte : byte << 8);
}

static void obey_data(uint8_t byte)
{
    switch (model.command) {
    case 0x2a:
        obey_range(model.range[0], byte);
        break;
    case 0x2b:
        obey_range(model.range[1], byte);
        break;
    case 0x2c:
        if (model.parameter % 2)
            put_pixel((tia_rgb565)(model.high << 8 | byte));
        model.high = byte;
        break;
    case 0x36:
        model.madctl = byte;
        break;
    case 0x3a:
        model.colmod = byte;
        break;
    case 0xb1:
        if (model.parameter < sizeof model.gamma)
            model.gamma[model.parameter] = byte;
        break;
    default:
        break;
    }
    model.parameter++;
}

static void obey_command(uint8_t command)
{
    model.early += model.now_us < model.not_before;
    model.command = command;
    model.parameter = 0;
    switch (command) {
    case 0x01:
        model.asleep = true, model.on = model.inverted = false;
        model.madctl = model.colmod = 0;
        model.not_before = model.now_us + 120000;
        break;
    case 0x10:
    case 0x11:
        model.asleep = command == 0x10;
        model.not_before = model.now_us + 5000;
        break;
    case 0x21:
        model.inverted = true;
        break;
    case 0x28:
    case 0x29:
        model.on = command == 0x29;
        break;
    case 0x2c:
        model.column = model.range[0][0], model.row = model.range[1][0];
        break;
    default:
        break;
    }
}

static void finish_dma(void)
{
    if (model.bus_ns < model.end_ns)
        model.bus_ns = model.end_ns;
    model.disturbed += model.pending_count && memcmp(model.before, model.pending, model.pending_count) != 0;
    for (size_t i = 0; i < model.pending_count; i++)
        obey_data(model.pending[i]);
    model.pending_count = 0;
}

static int refuse(void)
{
    return model.fails_after >= 0 && model.fails_after-- == 0;
}

static int bus_command(void *bus, uint8_t command)
{
    (void)bus;
    if (refuse())
        return -1;
    finish_dma();
    model.sent++;
    model.bus_ns += model.byte_ns;
    if (model.commands < LOG)
        model.log[model.commands++] = command;
    obey_command(command);
    return 0;
}

static int bus_data(void *bus, const uint8_t *bytes, size_t count)
{
    (void)bus;
    if (refuse())
        return -1;
    finish_dma();
    model.pending = bytes;
    model.pending_count = count;
    model.sent += count;
    model.end_ns = model.bus_ns + count * model.byte_ns;
    if (count <= sizeof model.before)
        memcpy(model.before, bytes, count);
    else
        model.disturbed++;
    return 0;
}

static uint64_t now_us(void *ctx)
{
    (void)ctx;
    return model.now_us += 100;
}

static const struct tia_spi_panel_bus bus = {bus_command, bus_data};
static const struct tia_clock clock_of_model = {now_us};
static tia_rgb565 strips[2 * 10 * MEMORY_HEIGHT];

static struct tia_spi_panel make_panel(uint16_t width, uint16_t height, uint8_t orientation)
{
    memset(&model, 0, sizeof model);
    model.fails_after = -1;
    struct tia_spi_panel panel = {
        .ops = &bus,
        .clock = &clock_of_model,
        .width = width,
        .height = height,
        .orientation = orientation,
        .strips = strips,
        .strips_size = sizeof strips,
    };
    return panel;
}

/* Writes a pixel: if surfaces have `swap`, high byte first, as the panel's have it on every processor. */
static void put_pixel_into(const struct tia_surface *surface, unsigned x, unsigned y, tia_rgb565 pixel)
{
    char *at = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch + (ptrdiff_t)x * surface->step;
#if TIA_SWAP
    const tia_rgb565 one = 1;
    const uint8_t bytes[2] = {(uint8_t)(pixel >> 8), (uint8_t)pixel};
    CHECK(surface->swap == (*(const uint8_t *)&one == 1));
    memcpy(at, bytes, sizeof bytes);
#else
    memcpy(at, &pixel, sizeof pixel);
#endif
}

#endif
