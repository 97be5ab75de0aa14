/* start-arm.S - classic Arm processors start at the first instruction of the image. */
        .section .start, "ax"
        .globl board_reset
board_reset:
        ldr     sp, =board_stack_end
        b       board_start
