// spheres - a ball on the ground, ray-traced row by row for an ILI9341 panel, or one like it, on the SPI bus. The light is
// that of key `a`; tia_thesis_scene has three more. Each row's CRC-32 appears on the serial line: they are the same on
// every machine.
#include <SPI.h>
#include <tia.h>

#ifndef WIDTH
#define WIDTH 320
#define HEIGHT 240
#endif

static const uint8_t DC = 9, CS = 10, RESET = 8;

// For a view of this scene and a row's hits on processors of up to 32 bits: tia-compile --memory.
static uint64_t view_memory[72], hits_memory[WIDTH + 4];
static tia_rgb565 row[WIDTH];

static void command(uint8_t code, const uint8_t *data, uint8_t count)
{
    digitalWrite(DC, LOW);
    SPI.transfer(code);
    digitalWrite(DC, HIGH);
    while (count--)
        SPI.transfer(*data++);
}

static void window(uint8_t code, uint16_t last)
{
    const uint8_t range[] = {0, 0, (uint8_t)(last >> 8), (uint8_t)last};
    command(code, range, sizeof range);
}

static void start_panel()
{
    static const uint8_t pixels[] = {0x55}, orientation[] = {0x28}; // RGB565; landscape, blue and red swapped
    pinMode(DC, OUTPUT);
    pinMode(CS, OUTPUT);
    pinMode(RESET, OUTPUT);
    digitalWrite(RESET, LOW);
    delay(10);
    digitalWrite(RESET, HIGH);
    delay(120);
    SPI.begin();
    SPI.beginTransaction(SPISettings(8000000, MSBFIRST, SPI_MODE0));
    digitalWrite(CS, LOW);
    command(0x11, NULL, 0); // sleep out
    delay(120);
    command(0x3a, pixels, sizeof pixels);
    command(0x36, orientation, sizeof orientation);
    command(0x29, NULL, 0); // display on
    window(0x2a, WIDTH - 1);
    window(0x2b, HEIGHT - 1);
    command(0x2c, NULL, 0); // memory write: all rows follow
}

static int draw()
{
    const struct tia_surface surface = {.pixels = row, .step = 2, .pitch = sizeof row};
    struct tia_view *view;
    struct tia_hits *hits;
#ifdef __AVR__
    const struct tia_core *core = &tia_core_spheres_small; // slower, in less flash
#else
    const struct tia_core *core = &tia_core_spheres; // tia_core_q16 draws any scene, in five times the flash
#endif
    int status = core->view_init(core, &view, view_memory, sizeof view_memory, &tia_thesis_scene, 1, WIDTH, HEIGHT, NULL);
    if (status == TIA_OK)
        status = tia_view_set_lights(view, &tia_thesis_scene.bindings[0].state, 1);
    for (uint16_t y = 0; y < HEIGHT && status == TIA_OK; y++) {
        const struct tia_tile tile = {.x = 0, .y = y, .width = WIDTH, .height = 1};
        status = tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile);
        if (status == TIA_OK)
            status = tia_view_draw(view, hits, tile, &surface, NULL);
        for (uint16_t x = 0; x < WIDTH; x++) {
            SPI.transfer(row[x] >> 8);
            SPI.transfer(row[x] & 255);
        }
        Serial.println(tia_crc32(0, row, WIDTH), HEX);
    }
    return status;
}

void setup()
{
    Serial.begin(115200);
    start_panel();
    int status = draw();
    digitalWrite(CS, HIGH);
    Serial.println(status == TIA_OK ? "done" : "failed");
}

void loop()
{
}
