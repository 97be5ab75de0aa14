// spheres - a ball on the ground, ray-traced row by row for an ILI9341 panel on the SPI bus. Each row's CRC-32 appears on the
// serial line: they are the same on every machine.
#include <tia.h>
#include <tia_ili9341.h>
#include <tia_thesis.h> // memory of the built-in scene, with its 4 keys' lights one at a time; of others: tia-compile --memory

static uint64_t memory[TIA_WORDS(THESIS_ROWS_320 - THESIS_HITS_320x1 + THESIS_HITS_64x1 - 40 * 8)]; // 24 columns at once, of 8 bytes
static tia_ili9341 panel(9, 10, 8);

static int send_row(void *, unsigned, const tia_rgb565 *pixels, unsigned width)
{
    panel.row(pixels, width);
    Serial.println(tia_crc32(0, pixels, width), HEX);
    return TIA_OK;
}

void setup()
{
    const struct tia_rows rows = {&tia_core_spheres_small, &tia_thesis_scene, &tia_thesis_scene.bindings[0].state, 1, 320, 240, 24, false};
    Serial.begin(115200);
    panel.begin(rows.width, rows.height);
    Serial.println(tia_draw_rows(&rows, memory, sizeof memory, send_row, NULL) == TIA_OK ? "done" : "failed");
}
void loop() {}
