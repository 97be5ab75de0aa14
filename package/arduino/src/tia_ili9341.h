// tia_ili9341.h - a panel with an ILI9341 or a similar controller on the SPI bus, in landscape, to which rows are sent from top
// to bottom. Libraries such as TFT_eSPI drive more panels, and faster: see the examples.
#ifndef TIA_ILI9341_H
#define TIA_ILI9341_H

#include <SPI.h>

class tia_ili9341
{
  public:
    // The pins D/C, chip select and reset.
    tia_ili9341(uint8_t dc, uint8_t cs, uint8_t reset) : dc(dc), cs(cs), reset(reset)
    {
    }

    // Starts the panel, which then waits for height rows of width pixels. The bus stays the panel's.
    void begin(uint16_t width, uint16_t height)
    {
        static const uint8_t pixels[] = {0x55}, orientation[] = {0x28}; // RGB565; landscape, blue and red swapped

        wake();
        command(0x3a, pixels, sizeof pixels);
        command(0x36, orientation, sizeof orientation);
        command(0x29, NULL, 0); // display on
        range(0x2a, width - 1);
        range(0x2b, height - 1);
        command(0x2c, NULL, 0); // memory write: all rows follow
    }

    // Sends a row's pixels, high byte first.
    void row(const uint16_t *pixels, unsigned width)
    {
        for (unsigned x = 0; x < width; x++) {
            SPI.transfer(pixels[x] >> 8);
            SPI.transfer(pixels[x] & 255);
        }
    }

  private:
    const uint8_t dc, cs, reset;

    void wake()
    {
        pinMode(dc, OUTPUT);
        pinMode(cs, OUTPUT);
        pinMode(reset, OUTPUT);
        digitalWrite(reset, LOW);
        delay(10);
        digitalWrite(reset, HIGH);
        delay(120);
        SPI.begin();
        SPI.beginTransaction(SPISettings(8000000, MSBFIRST, SPI_MODE0));
        digitalWrite(cs, LOW);
        command(0x11, NULL, 0); // sleep out
        delay(120);
    }

    void command(uint8_t code, const uint8_t *data, uint8_t count)
    {
        digitalWrite(dc, LOW);
        SPI.transfer(code);
        digitalWrite(dc, HIGH);
        while (count--)
            SPI.transfer(*data++);
    }

    // The columns or rows 0..last.
    void range(uint8_t code, uint16_t last)
    {
        const uint8_t data[] = {0, 0, (uint8_t)(last >> 8), (uint8_t)last};
        command(code, data, sizeof data);
    }
};

#endif
