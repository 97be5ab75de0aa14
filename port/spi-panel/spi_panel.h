/* spi_panel.h - a small panel on a serial bus: ILI9341, ST7735, ST7789 and compatible ones.
 *
 * Such a panel has its own frame memory. It receives one-byte commands with the D/C line low, followed by data with
 * D/C high; pixels are RGB565, high byte first. The program draws a strip of rows into one of two buffers while
 * the other one is being sent.
 *
 * tia_spi_panel_changes sends of each strip only the rectangle that has changed, see tia/damage.h.
 */
#ifndef PORT_SPI_PANEL_H
#define PORT_SPI_PANEL_H

#include <tia/damage.h>
#include <tia/port.h>

/* The bus. Both functions return 0, or anything else on failure. */
struct tia_spi_panel_bus {
    /* Waits until previous data has been sent, then sends a command byte, D/C low. */
    int (*command)(void *bus, uint8_t command);
    /* Sends the last command's data, D/C high. It may return while DMA is still sending: the bytes do not change
     * until the next call of `command` has returned. */
    int (*data)(void *bus, const uint8_t *bytes, size_t count);
};

/* Bits of the panel's register 36h, MADCTL, which maps its memory to the glass. */
enum {
    TIA_SPI_PANEL_FLIP_ROWS = 0x80,    /* MY */
    TIA_SPI_PANEL_FLIP_COLUMNS = 0x40, /* MX */
    TIA_SPI_PANEL_SWAP_AXES = 0x20,    /* MV: landscape on a portrait panel */
    TIA_SPI_PANEL_BGR = 0x08           /* most panels have red and blue swapped */
};

struct tia_spi_panel {
    /* Set by the caller before open. */
    const struct tia_spi_panel_bus *ops;
    void *bus;
    const struct tia_clock *clock; /* clock for the pauses that the controller needs */
    void *clock_ctx;
    uint16_t width, height; /* size after applying `orientation` */
    uint16_t left, top;     /* position of the glass in the controller's memory */
    uint8_t orientation;    /* bits TIA_SPI_PANEL_... */
    bool inverted;          /* IPS glass: send 21h (INVON) */
    const uint8_t *setup;   /* vendor registers, each as command, number of parameters, parameters; or NULL */
    size_t setup_size;      /* bytes of `setup` */
    tia_rgb565 *strips;     /* two strips, one after the other */
    size_t strips_size;     /* bytes of `strips`; a strip consists of the whole rows that fit into half of them */
    uint16_t columns;       /* a strip's width in pixels; 0, or more than `width`: whole rows */
    void *shown_memory;     /* tia_spi_panel_changes: memory for what the panel shows, aligned for uint16_t */
    size_t shown_size;      /* bytes of `shown_memory`: tia_damage_size of the blocks that it is to have */

    /* Private to the port, except `why`. */
    const char *why;       /* reason for the last failure, one line */
    uint16_t across, rows; /* pixels and rows of a strip */
    uint8_t strip;         /* index of the strip to draw next */
    bool awake, shown;
    uint8_t range[4]; /* CASET's or PASET's parameters, being sent */
    bool torn;        /* a part of this frame was not sent */
    struct tia_damage damage;
};

/* The context is a struct tia_spi_panel. A program links tia/damage.h's code only with tia_spi_panel_changes. */
extern const struct tia_display tia_spi_panel_display, tia_spi_panel_changes;

#endif
