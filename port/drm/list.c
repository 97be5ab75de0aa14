/* list.c - prints every card, connector, mode and format. */
#include <stdio.h>
#include <string.h>
#include <xf86drm.h>

#include "card.h"
#include "console/console.h"
#include "console/node.h"
#include "drm.h"

#define LINE 100

/* Words to be printed on lines of at most LINE characters, each beginning with `start`. */
struct words {
    port_line *line;
    void *arg;
    const char *start;
    char text[LINE + 1];
};

static void end_words(struct words *w)
{
    if (w->text[0] != '\0')
        w->line(w->arg, w->text);
    w->text[0] = '\0';
}

static void add_word(struct words *w, const char *word)
{
    size_t length = strlen(w->text);

    if (length + 1 + strlen(word) > LINE) {
        end_words(w);
        length = 0;
    }
    (void)snprintf(w->text + length, sizeof w->text - length, "%s %s", length == 0 ? w->start : "", word);
}

static void list_modes(const drmModeConnector *c, port_line *line, void *arg)
{
    struct words w = {.line = line, .arg = arg, .start = "    modes:"};
    char name[PICK_NAME + 1], last[PICK_NAME + 1] = "";

    for (int i = 0; i < c->count_modes; i++) {
        (void)pick_mode_name(&c->modes[i], name);
        if (strcmp(name, last) == 0)
            continue;
        (void)strcpy(last, name);
        if (c->modes[i].type & DRM_MODE_TYPE_PREFERRED)
            (void)strcat(name, "*");
        add_word(&w, name);
    }
    end_words(&w);
}

static void list_formats(const struct card *card, uint32_t crtc, port_line *line, void *arg)
{
    struct words w = {.line = line, .arg = arg, .start = "    formats:"};
    struct card_format format;
    char name[PIXEL_NAME];

    for (int n = 0; card_format(card, crtc, n, true, &format); n++)
        add_word(&w, pixel_name(format.pixel, name));
    end_words(&w);
}

static void list_connector(const struct card *card, const drmModeConnector *c, port_line *line, void *arg)
{
    char text[PORT_WHY], name[PICK_NAME];
    uint32_t crtc = pick_crtc(&card->parts, c);

    if (c->connection != DRM_MODE_CONNECTED || c->count_modes == 0) {
        (void)snprintf(text, sizeof text, "  %s: %s", pick_name(c, name),
                       c->connection == DRM_MODE_CONNECTED ? "no modes" : "not connected");
        line(arg, text);
        return;
    }
    if (crtc != 0)
        (void)snprintf(text, sizeof text, "  %s: connected, CRTC %u", pick_name(c, name), crtc);
    else
        (void)snprintf(text, sizeof text, "  %s: connected, no CRTC is free for it", pick_name(c, name));
    line(arg, text);
    list_modes(c, line, arg);
    list_formats(card, crtc, line, arg);
}

struct list {
    port_line *line;
    void *arg;
};

static bool list_card(void *arg, const char *path)
{
    const struct list *l = arg;
    struct card card;
    drmVersion *version;
    char text[PORT_WHY];

    if (card_open(&card, path, text)) {
        l->line(l->arg, text);
        return false;
    }
    version = drmGetVersion(card.fd);
    if (!card_become_master(&card, text))
        (void)snprintf(text, sizeof text, "%s: driver %.40s", path, version ? version->name : "unknown");
    drmFreeVersion(version);
    l->line(l->arg, text);
    for (int i = 0; i < card.parts.resources->count_connectors; i++)
        if (card.parts.connectors[i])
            list_connector(&card, card.parts.connectors[i], l->line, l->arg);
    card_close(&card);
    return false;
}

void port_drm_list(port_line *line, void *arg)
{
    struct list list = {line, arg};

    if (node_each(CARD, CARDS, list_card, &list) == 0)
        line(arg, "no " CARD "*: this kernel has no DRM device (load a driver)");
    else
        console_list(line, arg);
}
