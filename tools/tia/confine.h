/* confine.h - takes from this process what a damaged or hostile file could misuse. */
#ifndef TOOLS_TIA_CONFINE_H
#define TOOLS_TIA_CONFINE_H

#include <stdbool.h>
#include <stdint.h>

/* Leaves the process no descriptor but `kept`: 0 to 2 are /dev/null, all others are closed. The process ends with its
 * parent, and signals have their default effects. Returns false if /dev/null cannot be opened. */
bool confine_descriptors(int kept);

/* Limits the address space to `memory` bytes (not where pointers have 32 bits, nor with sanitizers) and the processor
 * time to `seconds`; no core dumps. From then on neither the process nor its threads gain privileges.
 *
 * With the kernel's seccomp a filter permits only system calls that a computation needs: memory without execution, new
 * threads, the clock, transfers through descriptors that are open or received. All others fail with EPERM, such as
 * opening and creating files, sockets, new processes, execution of programs and signals to others. Returns true with
 * this filter, false without it: on other processors than x86, ARM, RISC-V, POWER and s390x, and if the kernel has
 * none. */
bool confine(uint64_t memory, unsigned seconds);

#endif
