#include "confine.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <signal.h>
#include <stddef.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "common/sanitized.h"

/* ---- limits ---- */

/* Lowers a limit to `most`, and keeps it where it is lower. */
static void limit(int resource, rlim_t most)
{
    struct rlimit now;

    if (getrlimit((__rlimit_resource_t)resource, &now) == 0) {
        now.rlim_cur = now.rlim_cur > most ? most : now.rlim_cur; /* RLIM_INFINITY is the largest number */
        now.rlim_max = now.rlim_max > most ? most : now.rlim_max;
        (void)setrlimit((__rlimit_resource_t)resource, &now);
    }
}

bool confine_descriptors(int kept)
{
    int null = open("/dev/null", O_RDWR | O_CLOEXEC);
    struct rlimit open_files;

    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (int number = 1; number < NSIG; number++)
        (void)signal(number, SIG_DFL);
    if (null < 0)
        return false;
    for (int fd = 0; fd < 3; fd++)
        (void)dup2(null, fd);
    rlim_t most =
        getrlimit(RLIMIT_NOFILE, &open_files) == 0 && open_files.rlim_cur < 65536 ? open_files.rlim_cur : 65536;
    for (int fd = 3; fd < (int)most; fd++)
        if (fd != kept)
            (void)close(fd);
    return true;
}

/* ---- the filter ---- */

#if defined(__x86_64__) && !defined(__ILP32__)
#define ARCH AUDIT_ARCH_X86_64
#elif defined(__i386__)
#define ARCH AUDIT_ARCH_I386
#elif defined(__aarch64__) && defined(__AARCH64EL__)
#define ARCH AUDIT_ARCH_AARCH64
#elif defined(__arm__) && defined(__ARM_EABI__)
#define ARCH AUDIT_ARCH_ARM
#elif defined(__riscv) && __riscv_xlen == 64
#define ARCH AUDIT_ARCH_RISCV64
#elif defined(__powerpc64__) && defined(__LITTLE_ENDIAN__)
#define ARCH AUDIT_ARCH_PPC64LE
#elif defined(__s390x__)
#define ARCH AUDIT_ARCH_S390X
#endif

#ifdef ARCH
/* The lower word of an argument, and the argument of clone that has the flags. */
#define WORD_AT(n)                                                                                                     \
    (uint32_t)(offsetof(struct seccomp_data, args[n]) + (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__ ? sizeof(uint32_t) : 0))
#ifdef __s390x__
#define CLONE_FLAGS 1
#else
#define CLONE_FLAGS 0
#endif

#define LOAD(place) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, (place))
#define END(action) BPF_STMT(BPF_RET | BPF_K, (action))
#define REFUSE(error) (SECCOMP_RET_ERRNO | (error))
/* Goes on, or permits the call. */
#define PERMIT(name) BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_##name, 0, 1), END(SECCOMP_RET_ALLOW)
/* Goes on, or permits the call if the argument has all, or none, of the bits. */
#define PERMIT_WITH(name, argument, bits)                                                                              \
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_##name, 0, 4), LOAD(WORD_AT(argument)),                                   \
        BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, (bits), 0, 1), END(SECCOMP_RET_ALLOW), END(REFUSE(EPERM))
#define PERMIT_WITHOUT(name, argument, bits)                                                                           \
    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_##name, 0, 4), LOAD(WORD_AT(argument)),                                   \
        BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, (bits), 1, 0), END(SECCOMP_RET_ALLOW), END(REFUSE(EPERM))

/* The filter. glibc makes threads by clone where clone3, whose flags are in memory, seems not to exist. */
static const struct sock_filter filter[] = {
    LOAD(offsetof(struct seccomp_data, arch)), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, ARCH, 1, 0), END(REFUSE(EPERM)),
    LOAD(offsetof(struct seccomp_data, nr)),
    /* memory */
    PERMIT(brk), PERMIT(munmap), PERMIT(mremap), PERMIT(madvise), PERMIT_WITHOUT(mprotect, 2, PROT_EXEC),
#ifdef __NR_mmap
    PERMIT_WITHOUT(mmap, 2, PROT_EXEC),
#endif
#ifdef __NR_mmap2
    PERMIT_WITHOUT(mmap2, 2, PROT_EXEC),
#endif
    PERMIT(memfd_create), PERMIT(ftruncate),
#ifdef __NR_ftruncate64
    PERMIT(ftruncate64),
#endif
    /* threads and their signals */
    PERMIT_WITH(clone, CLONE_FLAGS, CLONE_THREAD), BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_clone3, 0, 1),
    END(REFUSE(ENOSYS)), PERMIT(futex), PERMIT(set_robust_list), PERMIT(sched_yield), PERMIT(sched_getaffinity),
#ifdef __NR_futex_time64
    PERMIT(futex_time64),
#endif
#ifdef __NR_rseq
    PERMIT(rseq),
#endif
    PERMIT(rt_sigaction), PERMIT(rt_sigprocmask), PERMIT(rt_sigreturn), PERMIT(sigaltstack), PERMIT(restart_syscall),
#ifdef __NR_sigreturn
    PERMIT(sigreturn),
#endif
    PERMIT(exit), PERMIT(exit_group),
    /* the process itself; abort ends it by an illegal instruction without tgkill */
    PERMIT(getpid), PERMIT(gettid), PERMIT(getrandom),
    /* the clock */
    PERMIT(clock_gettime), PERMIT(gettimeofday), PERMIT(nanosleep), PERMIT(clock_nanosleep),
#ifdef __NR_clock_gettime64
    PERMIT(clock_gettime64), PERMIT(clock_nanosleep_time64),
#endif
    /* open descriptors */
    PERMIT(read), PERMIT(readv), PERMIT(pread64), PERMIT(write), PERMIT(writev), PERMIT(pwrite64), PERMIT(lseek),
#ifdef __NR__llseek
    PERMIT(_llseek),
#endif
    PERMIT(close), PERMIT(recvmsg),
#ifdef __NR_fstat
    PERMIT(fstat),
#endif
#ifdef __NR_fstat64
    PERMIT(fstat64),
#endif
#ifdef __NR_newfstatat
    PERMIT_WITH(newfstatat, 3, AT_EMPTY_PATH),
#endif
#ifdef __NR_statx
    PERMIT_WITH(statx, 2, AT_EMPTY_PATH),
#endif
    END(REFUSE(EPERM))};

static bool set_filter(void)
{
    const struct sock_fprog program = {.len = sizeof filter / sizeof *filter, .filter = (struct sock_filter *)filter};

    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}
#else
static bool set_filter(void)
{
    return false;
}
#endif

bool confine(uint64_t memory, unsigned seconds)
{
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, seconds);
    if (!IS_SANITIZED && sizeof(void *) > 4)
        limit(RLIMIT_AS, (rlim_t)memory);
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && set_filter();
}
