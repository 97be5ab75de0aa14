/* start-riscv.S - a RISC-V processor starts at the first instruction of the image. */
        .option arch, +zicsr
        .section .start, "ax"
        .globl board_reset
board_reset:
        la      sp, board_stack_end
        la      t0, board_fault
        csrw    mtvec, t0
        j       board_start

        .balign 4
board_fault:
        la      a0, fault_text
        call    board_print
        li      a0, 70
        j       board_exit

        .section .rodata
fault_text:
        .asciz  "fault: the processor stopped the program\n"
