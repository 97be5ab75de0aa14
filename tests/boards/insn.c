/* insn.c - a plugin for QEMU that counts the instructions executed between two marks.
 *
 *   qemu-system-arm ... -plugin insn.so,begin=0x1234,end=0x1250,text=0x0:0x8000,passages=80 -d plugin -D FILE
 *
 * begin and end are the addresses of two functions' first instructions. The instructions from the one to the other are
 * a passage, for which FILE gets the line "passage N". If `text` is given, a line "at ADDRESS N" follows at the end for
 * each instruction of that range that was executed in a passage, and "taken ADDRESS N" if another than the next one
 * followed N times; of the first `passages` passages, or of all. For calls=ADDRESS, which may be given up to CALLED
 * times, each passage gets a line "calls N ..." as well: how often the instructions at these addresses, such as the
 * first ones of functions, were executed in it. One processor is assumed.
 *
 * Debian's QEMU 7.2 supports plugins but has no header for them: the functions of version 1 are declared here. */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

typedef uint64_t qemu_plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
struct qemu_info;
typedef void executed(unsigned int cpu, void *user);

enum { CB_NO_REGS = 0 };
struct block {
    uint64_t first, last, next; /* addresses of its first and last instruction, and behind it */
};
enum { INLINE_ADD_U64 = 0 };

extern void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id,
                                                  void (*translated)(qemu_plugin_id_t, struct qemu_plugin_tb *));
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *insn, executed *callback, int flags,
                                                   void *user);
extern void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *insn, int operation, void *counter,
                                                       uint64_t value);
extern void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *tb, executed *callback, int flags, void *user);
extern size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *insn);
extern size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *tb);
extern struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *tb, size_t index);
extern uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *insn);
extern void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, void (*ended)(qemu_plugin_id_t, void *), void *user);
extern void qemu_plugin_outs(const char *text);

EXPORT int qemu_plugin_version = 1;
int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info, int argc, char **argv);

static uint64_t begin_at = UINT64_MAX, end_at = UINT64_MAX;
static uint64_t executed_all, executed_before;

/* Numbers of an event at each halfword of `text`: in all, before this passage, and in passages. */
struct events {
    uint64_t *all, *before, *passages;
};
static struct events executions, jumps;
static uint64_t text_start, text_count, passages_left = UINT64_MAX;
static const struct block *last_block;
enum { CALLED = 8 };
static uint64_t called_at[CALLED], calls_all[CALLED], calls_before[CALLED];
static int called_count;

static void say(const char *what, uint64_t address, uint64_t count)
{
    char line[80];
    if (address)
        (void)snprintf(line, sizeof line, "%s %#" PRIx64 " %" PRIu64 "\n", what, address, count);
    else
        (void)snprintf(line, sizeof line, "%s %" PRIu64 "\n", what, count);
    qemu_plugin_outs(line);
}

static void say_calls(void)
{
    char line[24 * CALLED + 8] = "calls";
    size_t at = strlen(line);

    for (int i = 0; i < called_count; i++)
        at += (size_t)snprintf(line + at, sizeof line - at, " %" PRIu64, calls_all[i] - calls_before[i]);
    (void)snprintf(line + at, sizeof line - at, "\n");
    qemu_plugin_outs(line);
}

static void on_begin(unsigned int cpu, void *user)
{
    (void)cpu, (void)user;
    executed_before = executed_all;
    memcpy(calls_before, calls_all, sizeof calls_before);
    if (text_count) {
        memcpy(executions.before, executions.all, text_count * sizeof(uint64_t));
        memcpy(jumps.before, jumps.all, text_count * sizeof(uint64_t));
    }
}

static void on_end(unsigned int cpu, void *user)
{
    (void)cpu, (void)user;
    say("passage", 0, executed_all - executed_before);
    if (called_count)
        say_calls();
    if (!passages_left)
        return;
    passages_left--;
    for (uint64_t i = 0; i < text_count; i++) {
        executions.passages[i] += executions.all[i] - executions.before[i];
        jumps.passages[i] += jumps.all[i] - jumps.before[i];
    }
}

/* True if `address` is behind the block. Before an Arm instruction that crosses a page, QEMU ends the block, and counts
 * the first half of that instruction as a part of the one before. */
static bool follows(const struct block *block, uint64_t address)
{
    enum { PAGE = 1024 };
    return address == block->next || (block->next % PAGE == 0 && address == block->next - 2);
}

/* Counts a jump at the end of the block before, if this one does not follow it in memory. */
static void on_block(unsigned int cpu, void *user)
{
    const struct block *block = user;
    (void)cpu;
    if (last_block && !follows(last_block, block->first)) {
        uint64_t at = (last_block->last - text_start) / 2;
        if (last_block->last >= text_start && at < text_count)
            jumps.all[at]++;
    }
    last_block = block;
}

static void watch_block(struct qemu_plugin_tb *tb)
{
    struct qemu_plugin_insn *last = qemu_plugin_tb_get_insn(tb, qemu_plugin_tb_n_insns(tb) - 1);
    struct block *block = malloc(sizeof *block);
    if (!block)
        exit(1);
    block->first = qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(tb, 0));
    block->last = qemu_plugin_insn_vaddr(last);
    block->next = block->last + qemu_plugin_insn_size(last);
    qemu_plugin_register_vcpu_tb_exec_cb(tb, on_block, CB_NO_REGS, block);
}

static void on_translated(qemu_plugin_id_t id, struct qemu_plugin_tb *tb)
{
    (void)id;
    if (text_count)
        watch_block(tb);
    for (size_t i = 0; i < qemu_plugin_tb_n_insns(tb); i++) {
        struct qemu_plugin_insn *insn = qemu_plugin_tb_get_insn(tb, i);
        uint64_t address = qemu_plugin_insn_vaddr(insn), at = (address - text_start) / 2;
        if (address == begin_at)
            qemu_plugin_register_vcpu_insn_exec_cb(insn, on_begin, CB_NO_REGS, NULL);
        if (address == end_at)
            qemu_plugin_register_vcpu_insn_exec_cb(insn, on_end, CB_NO_REGS, NULL);
        qemu_plugin_register_vcpu_insn_exec_inline(insn, INLINE_ADD_U64, &executed_all, 1);
        for (int j = 0; j < called_count; j++)
            if (address == called_at[j])
                qemu_plugin_register_vcpu_insn_exec_inline(insn, INLINE_ADD_U64, &calls_all[j], 1);
        if (address >= text_start && at < text_count)
            qemu_plugin_register_vcpu_insn_exec_inline(insn, INLINE_ADD_U64, &executions.all[at], 1);
    }
}

static void on_ended(qemu_plugin_id_t id, void *user)
{
    (void)id, (void)user;
    for (uint64_t i = 0; i < text_count; i++) {
        if (executions.passages[i])
            say("at", text_start + 2 * i, executions.passages[i]);
        if (jumps.passages[i])
            say("taken", text_start + 2 * i, jumps.passages[i]);
    }
}

static int take_events(struct events *events)
{
    events->all = calloc(3 * text_count, sizeof *events->all);
    events->before = events->all + text_count;
    events->passages = events->before + text_count;
    return events->all ? 0 : -1;
}

static int take_text(const char *range)
{
    char *colon;
    text_start = strtoull(range, &colon, 0);
    text_count = (strtoull(colon + 1, NULL, 0) - text_start) / 2;
    return take_events(&executions) || take_events(&jumps);
}

EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info, int argc, char **argv)
{
    (void)info;
    for (int i = 0; i < argc; i++) {
        if (!strncmp(argv[i], "begin=", 6))
            begin_at = strtoull(argv[i] + 6, NULL, 0);
        if (!strncmp(argv[i], "end=", 4))
            end_at = strtoull(argv[i] + 4, NULL, 0);
        if (!strncmp(argv[i], "passages=", 9))
            passages_left = strtoull(argv[i] + 9, NULL, 0);
        if (!strncmp(argv[i], "calls=", 6) && called_count < CALLED)
            called_at[called_count++] = strtoull(argv[i] + 6, NULL, 0);
        if (!strncmp(argv[i], "text=", 5) && take_text(argv[i] + 5))
            return -1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_translated);
    qemu_plugin_register_atexit_cb(id, on_ended, NULL);
    return 0;
}
