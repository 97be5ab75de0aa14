/* simavr.c - runs an AVR program in simavr, prints its serial output, and ends with its status. SIGTERM ends the
 * program earlier, with a line on standard error: "stack N", the bytes of RAM from the lowest that it has changed
 * above its variables to the end.
 *
 *   simavr IMAGE                     as fast as possible
 *   simavr IMAGE BEGIN END LOG       counts instructions between two marks
 *
 * BEGIN and END are the addresses of two functions' first instructions. The instructions from the one to the other are
 * a passage, for which LOG gets the line "passage INSTRUCTIONS CYCLES". Counting takes twice the time. */
#include <avr_uart.h>
#include <inttypes.h>
#include <signal.h>
#include <sim_avr.h>
#include <sim_elf.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef MCU
#define MCU "atmega1284p"
#endif
#define STATUS 0x3e                          /* GPIOR0: board_exit writes the status there and sleeps for ever */
#define LIMIT (UINT64_C(16000000) * 60 * 60) /* an hour of the processor's time */

#define PAINT 0xac

static volatile sig_atomic_t ended;
static uint32_t free_ram; /* address of the first byte above the variables */

static void on_signal(int number)
{
    (void)number;
    ended = 1;
}

static void on_byte(struct avr_irq_t *irq, uint32_t value, void *user)
{
    (void)irq, (void)user;
    putchar((int)value);
    fflush(stdout);
}

static void quiet(avr_t *avr, const int level, const char *format, va_list arguments)
{
    (void)avr;
    if (level <= LOG_ERROR)
        vfprintf(stderr, format, arguments);
}

static avr_t *load(char *image)
{
    elf_firmware_t firmware = {0};
    avr_t *avr = avr_make_mcu_by_name(MCU);
    uint32_t flags = 0;

    avr_global_logger_set(quiet);
    if (!avr || elf_read_firmware(image, &firmware))
        return NULL;
    avr_init(avr);
    firmware.frequency = 16000000;
    avr_load_firmware(avr, &firmware);
    free_ram = (uint32_t)avr->ioend + 1 + firmware.datasize + firmware.bsssize;
    memset(avr->data + free_ram, PAINT, avr->ramend + 1 - free_ram);
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_byte, NULL);
    return avr;
}

static void print_stack(const avr_t *avr)
{
    uint32_t at = free_ram;

    while (at <= avr->ramend && avr->data[at] == PAINT)
        at++;
    fprintf(stderr, "stack %" PRIu32 "\n", (uint32_t)avr->ramend + 1 - at);
}

static int run(avr_t *avr)
{
    int state = cpu_Running;

    while (!ended && state != cpu_Done && state != cpu_Crashed && avr->cycle < LIMIT)
        state = avr_run(avr);
    return state;
}

/* Runs the program one instruction at a time, and counts. */
static int run_and_count(avr_t *avr, uint32_t begin, uint32_t end, FILE *log)
{
    uint64_t executed = 0, executed_before = 0, cycle_before = 0;
    int state = cpu_Running;

    for (avr->run_cycle_limit = 1; state != cpu_Done && state != cpu_Crashed && avr->cycle < LIMIT; executed++) {
        if (avr->pc == begin) {
            executed_before = executed;
            cycle_before = avr->cycle;
        }
        if (avr->pc == end)
            fprintf(log, "passage %" PRIu64 " %" PRIu64 "\n", executed - executed_before, avr->cycle - cycle_before);
        state = avr_run(avr);
    }
    return state;
}

int main(int argc, char **argv)
{
    if (argc != 2 && argc != 5)
        return 2;
    avr_t *avr = load(argv[1]);
    FILE *log = argc == 5 ? fopen(argv[4], "w") : NULL;

    if (!avr || (argc == 5 && !log)) {
        fprintf(stderr, "simavr: %s cannot be run\n", argv[1]);
        return 1;
    }
    signal(SIGTERM, on_signal);
    int state = log ? run_and_count(avr, (uint32_t)strtoul(argv[2], NULL, 0), (uint32_t)strtoul(argv[3], NULL, 0), log)
                    : run(avr);
    if (log && fclose(log))
        return 1;
    if (ended)
        print_stack(avr);
    else if (state != cpu_Done)
        fprintf(stderr, "simavr: the program %s\n", state == cpu_Crashed ? "crashed" : "did not end");
    return state == cpu_Done ? avr->data[STATUS] : 1;
}
