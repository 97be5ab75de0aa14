// tft_espi - a ball on the ground, ray-traced row by row for a panel of 320x240 that TFT_eSPI drives.
#include <TFT_eSPI.h>
#include <tia.h>
#include <tia_thesis.h> // memory of the built-in scene; of others: tia-compile --memory

static TFT_eSPI tft;
static uint64_t memory[TIA_WORDS(THESIS_ROWS_320)];

static int send_row(void *, unsigned y, const tia_rgb565 *pixels, unsigned width)
{
    tft.pushImage(0, y, width, 1, pixels);
    return TIA_OK;
}

void setup()
{
    const struct tia_rows rows = {&tia_core_spheres, &tia_thesis_scene, &tia_thesis_scene.bindings[0].state, 1, 320, 240, 0, false};
    tft.init();
    tft.setRotation(1); // landscape
    tft.setSwapBytes(true); // of pixels in the processor's byte order
    tia_draw_rows(&rows, memory, sizeof memory, send_row, NULL);
}
void loop() {}
