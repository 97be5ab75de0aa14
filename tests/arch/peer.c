/* peer.c - one of two players in lockstep, for tests/slow/lockstep: plays the scene of frames_steps.h with inputs that
 * only it knows, and exchanges them with the other player, together with the hash of the state, before each step.
 *
 *     peer 0 STEPS listen         waits for the other player, on a port of 127.0.0.1 that it prints
 *     peer 1 STEPS PORT [BREAK]   joins; at step BREAK one bit of its state changes
 *
 * Prints the last hash and how often the state was saved and restored. Status 1 at the first hash that differs. Now and
 * then a player computes steps ahead without the other's inputs, and goes back. Sometimes player 1 goes on with
 * the state that player 0 has sent. */
#include "frames_steps.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <stdio.h>
#include <sys/socket.h>
#include <unistd.h>

enum { MESSAGE = 4 + 8 + 4 + STEPS_PUSHES * 16, SENT_APART = 128 };

struct player {
    int socket, number;
    uint64_t dice;
    struct tia_steps steps;
    uint32_t restored;
};

static void fail(const char *what)
{
    perror(what);
    exit(2);
}

static void send_all(int to, const uint8_t *bytes, size_t size)
{
    for (ssize_t n; size; size -= (size_t)n, bytes += n)
        if ((n = send(to, bytes, size, MSG_NOSIGNAL)) <= 0)
            fail("send");
}

static void receive_all(int from, uint8_t *bytes, size_t size)
{
    for (ssize_t n; size; size -= (size_t)n, bytes += n)
        if ((n = recv(from, bytes, size, 0)) <= 0)
            fail("recv");
}

static uint8_t *put(uint8_t *to, uint64_t number, int count)
{
    for (int i = 0; i < count; i++)
        *to++ = (uint8_t)(number >> 8 * i);
    return to;
}

static uint64_t get(const uint8_t **from, int count)
{
    uint64_t number = 0;

    for (int i = 0; i < count; i++)
        number |= (uint64_t) * (*from)++ << 8 * i;
    return number;
}

static void send_inputs(const struct player *p, uint32_t step, uint64_t hash, const struct tia_push *pushes,
                        uint32_t count)
{
    uint8_t message[MESSAGE] = {0}, *to = put(put(put(message, step, 4), hash, 8), count, 4);

    for (uint32_t i = 0; i < count; i++) {
        const struct tia_vec3 *v = &pushes[i].velocity;
        to = put(to, pushes[i].ball, 4);
        to = put(put(put(to, (uint32_t)v->x, 4), (uint32_t)v->y, 4), (uint32_t)v->z, 4);
    }
    send_all(p->socket, message, sizeof message);
}

/* Returns the number of the other player's inputs; ends the program if its step or hash differ. */
static uint32_t receive_inputs(const struct player *p, uint32_t step, uint64_t hash, struct tia_push *pushes)
{
    uint8_t message[MESSAGE];
    const uint8_t *from = message;

    receive_all(p->socket, message, sizeof message);
    uint32_t other_step = (uint32_t)get(&from, 4);
    uint64_t other = get(&from, 8);
    uint32_t count = (uint32_t)get(&from, 4);
    if (other_step != step || other != hash || count > STEPS_PUSHES) {
        printf("step %u: %016llx, not %016llx\n", (unsigned)step, (unsigned long long)hash, (unsigned long long)other);
        exit(1);
    }
    for (uint32_t i = 0; i < count; i++) {
        pushes[i].ball = (uint32_t)get(&from, 4);
        pushes[i].velocity.x = (int32_t)get(&from, 4);
        pushes[i].velocity.y = (int32_t)get(&from, 4);
        pushes[i].velocity.z = (int32_t)get(&from, 4);
    }
    return count;
}

static void save(const struct player *p, uint8_t state[STEPS_STATE])
{
    if (tia_steps_save(&p->steps, state, STEPS_STATE))
        abort();
}

static void restore(struct player *p, const uint8_t state[STEPS_STATE])
{
    if (tia_steps_restore(&p->steps, state, STEPS_STATE))
        abort();
    p->restored++;
}

/* Computes some steps ahead with the player's own inputs, and goes back. */
static void guess_ahead(struct player *p, const struct tia_push *pushes, uint32_t count)
{
    uint8_t state[STEPS_STATE];

    save(p, state);
    for (int i = dice_between(&p->dice, 1, 6); i > 0; i--, count = 0)
        if (tia_scene_step(&p->steps, pushes, count))
            abort();
    restore(p, state);
}

/* Player 0 sends its state, and player 1 continues with it. */
static void share_state(struct player *p)
{
    uint8_t state[STEPS_STATE], own[STEPS_STATE];

    save(p, own);
    if (p->number == 0) {
        send_all(p->socket, own, sizeof own);
        return;
    }
    receive_all(p->socket, state, sizeof state);
    if (memcmp(state, own, sizeof own)) {
        printf("the saved states differ\n");
        exit(1);
    }
    restore(p, state);
}

static void break_state(struct player *p)
{
    uint8_t state[STEPS_STATE];

    save(p, state);
    state[TIA_STEPS_HEAD + 1] ^= 1;
    restore(p, state);
}

static void play(struct player *p, uint32_t steps, uint32_t broken)
{
    for (uint32_t n = 0; n < steps; n++) {
        struct tia_push pushes[2 * STEPS_PUSHES], own[STEPS_PUSHES], others[STEPS_PUSHES];
        uint64_t hash = tia_steps_hash(&p->steps);
        uint32_t count = steps_pushes(&p->dice, own);
        p->dice ^= hash;
        send_inputs(p, n, hash, own, count);
        if (dice_one_in(&p->dice, 16))
            guess_ahead(p, own, count);
        uint32_t more = receive_inputs(p, n, hash, others);
        if (n % SENT_APART == SENT_APART - 1)
            share_state(p);
        memcpy(pushes, p->number ? others : own, sizeof own);
        uint32_t first = p->number ? more : count;
        memcpy(pushes + first, p->number ? own : others, sizeof own);
        if (tia_scene_step(&p->steps, pushes, count + more))
            abort();
        if (n == broken)
            break_state(p);
    }
    uint64_t last = tia_steps_hash(&p->steps);
    send_inputs(p, steps, last, NULL, 0);
    (void)receive_inputs(p, steps, last, NULL);
}

static int connect_to(const char *port)
{
    struct sockaddr_in at = {.sin_family = AF_INET};
    socklen_t size = sizeof at;
    int wait = socket(AF_INET, SOCK_STREAM, 0), other;

    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    at.sin_port = htons((uint16_t)strtoul(port, NULL, 10));
    if (strcmp(port, "listen") != 0) {
        if (wait < 0 || connect(wait, (struct sockaddr *)&at, sizeof at))
            fail("connect");
        return wait;
    }
    if (wait < 0 || bind(wait, (struct sockaddr *)&at, sizeof at) || listen(wait, 1) ||
        getsockname(wait, (struct sockaddr *)&at, &size))
        fail("listen");
    printf("%u\n", (unsigned)ntohs(at.sin_port));
    (void)fflush(stdout);
    if ((other = accept(wait, NULL, NULL)) < 0)
        fail("accept");
    return other;
}

int main(int argc, char **argv)
{
    static uint64_t memory[1024];
    const struct tia_scene scene = steps_scene();
    struct player p = {0};

    if (argc < 4)
        return 2;
    p.number = argv[1][0] - '0';
    p.dice = (uint64_t)p.number + 1;
    p.socket = connect_to(argv[3]);
    steps_begin(&p.steps, &scene, memory, sizeof memory);
    play(&p, (uint32_t)strtoul(argv[2], NULL, 10), argc > 4 ? (uint32_t)strtoul(argv[4], NULL, 10) : UINT32_MAX);
    printf("%016llx %u\n", (unsigned long long)tia_steps_hash(&p.steps), (unsigned)p.restored);
    return 0;
}
