/* spi_panel.h - a small panel on a serial bus as a display: ILI9341, ST7735, ST7789 and their kin.
 *
 * Such a panel keeps the picture itself. It gets commands of one byte, with the D/C line low, and
 * data behind them, with D/C high; pixels are RGB565, high byte first. The program draws a strip
 * of rows in one of two buffers while the other one is on the wire.
 */
#ifndef PORT_SPI_PANEL_H
#define PORT_SPI_PANEL_H

#include <tia/port.h>

/* The wires. Both functions return 0, or anything else when the bus failed. */
struct spi_panel_bus {
    /* Sends a command byte, D/C low. Waits for the data before it first. */
    int (*command)(void *bus, uint8_t command);
    /* Sends the data of the last command, D/C high. It may return while a DMA controller still
     * sends: the bytes stay as they are until the next call of `command` has returned. */
    int (*data)(void *bus, const uint8_t *bytes, size_t count);
};

/* What is written to the panel's register 36h, MADCTL: how its memory maps to the glass. */
enum {
    SPI_PANEL_FLIP_ROWS = 0x80,    /* MY */
    SPI_PANEL_FLIP_COLUMNS = 0x40, /* MX */
    SPI_PANEL_SWAP_AXES = 0x20,    /* MV: landscape on a panel that is made upright */
    SPI_PANEL_BGR = 0x08           /* the glass has blue where the controller puts red: most have */
};

struct spi_panel {
    /* The caller's, set before open. */
    const struct spi_panel_bus *ops;
    void *bus;
    const struct tia_clock *clock; /* for the pauses that the controller asks for */
    void *clock_ctx;
    uint16_t width, height; /* as seen with `orientation` */
    uint16_t left, top;     /* where the glass begins in the controller's memory */
    uint8_t orientation;    /* SPI_PANEL_... */
    bool inverted;          /* IPS glass: 21h (INVON) is sent */
    const uint8_t *setup;   /* the maker's own registers, or NULL: for each the command, the */
    size_t setup_size;      /* number of its parameters, and these */
    tia_rgb565 *strips;     /* two strips, one after the other */
    size_t strips_size;     /* bytes; each strip has as many whole rows as fit in the half */

    /* The port's own. */
    const char *why; /* after a failure: its reason, in one line */
    uint16_t rows;   /* of a strip */
    uint8_t strip;   /* the one to be drawn next */
    bool awake, shown;
    uint8_t range[4]; /* on the wire */
};

/* Its context is a struct spi_panel. */
extern const struct tia_display spi_panel_display;

#endif
