/* format.c - the pixel format that a framebuffer device reports: Documentation/fb/api.rst of the kernel. */
#include <stdio.h>

#include "screen.h"

static struct pixel_channel channel(const struct fb_bitfield *f)
{
    /* numbers too large for any pixel become 99, which pixel_fault rejects */
    return (struct pixel_channel){(uint8_t)(f->offset > 99 ? 99 : f->offset),
                                  (uint8_t)(f->length > 99 ? 99 : f->length)};
}

/* Returns a message about a property that a struct pixel_format cannot express; NULL: there is none. */
static const char *odd(const struct fb_var_screeninfo *var, const struct fb_fix_screeninfo *fix)
{
    if (fix->type != FB_TYPE_PACKED_PIXELS)
        return "its pixels are not packed (planes, text or blocks)";
    if (fix->visual != FB_VISUAL_TRUECOLOR && fix->visual != FB_VISUAL_DIRECTCOLOR)
        return "it has a palette or no colours (set a mode of 16 or 32 bits a pixel)";
    if (var->grayscale != 0)
        return "its pixels are grey or coded (set a mode of 16 or 32 bits a pixel)";
    if (var->nonstd != 0)
        return "its pixel format is not a standard one";
    if (var->red.msb_right != 0 || var->green.msb_right != 0 || var->blue.msb_right != 0)
        return "its bits are in reverse order";
    return NULL;
}

static bool fits(const struct fb_var_screeninfo *var, const struct fb_fix_screeninfo *fix, unsigned bytes)
{
    uint64_t row = fix->line_length;

    return ((uint64_t)var->xoffset + var->xres) * bytes <= row &&
           ((uint64_t)var->yoffset + var->yres) * row <= fix->smem_len;
}

int fb_format(const struct fb_var_screeninfo *var, const struct fb_fix_screeninfo *fix, struct pixel_format *format,
              char reason[PORT_WHY])
{
    const char *fault = odd(var, fix);

    *format = (struct pixel_format){
        .bits = (uint8_t)(var->bits_per_pixel > 99 ? 99 : var->bits_per_pixel),
        .red = channel(&var->red),
        .green = channel(&var->green),
        .blue = channel(&var->blue),
        .alpha = channel(&var->transp),
    };
    if (!fault)
        fault = pixel_fault(format);
    if (!fault && (var->xres == 0 || var->yres == 0 || var->xres > TIA_SIZE_MAX || var->yres > TIA_SIZE_MAX))
        fault = "its size is not supported (1 to 8192 pixels)";
    if (!fault && !fits(var, fix, pixel_bytes(format)))
        fault = "its rows or its memory are too short for its mode";
    if (!fault)
        return TIA_OK;
    (void)snprintf(reason, PORT_WHY, "%ux%u, %u bits a pixel: %s", var->xres, var->yres, var->bits_per_pixel, fault);
    return TIA_ERR_UNSUPPORTED;
}

bool fb_can_pan(const struct fb_var_screeninfo *var, const struct fb_fix_screeninfo *fix)
{
    return fix->ypanstep != 0 && var->yres % fix->ypanstep == 0 && (var->vmode & FB_VMODE_YWRAP) == 0 &&
           2 * (uint64_t)var->yres * fix->line_length <= fix->smem_len;
}

void fb_ramp(uint16_t *out, unsigned length)
{
    const uint32_t last = (1u << length) - 1;

    for (uint32_t i = 0; i <= last; i++)
        out[i] = (uint16_t)(last == 0 ? 0 : i * 65535 / last);
}
