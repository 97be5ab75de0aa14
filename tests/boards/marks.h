/* marks.h - the marks between which instructions are counted: the emulator gets their addresses, see count.py. A file
 * that includes this one defines them. */
#ifndef TESTS_BOARDS_MARKS_H
#define TESTS_BOARDS_MARKS_H

void count_begin(void);
void count_end(void);
__attribute__((noinline)) void count_begin(void)
{
    __asm__ volatile("nop" ::: "memory");
}
__attribute__((noinline)) void count_end(void)
{
    __asm__ volatile("nop; nop" ::: "memory");
}

#endif
