/* counted_exit.c - writes a program's counters before _exit(), which the tests' children end with. */
#if defined(__clang__)
int __llvm_profile_write_file(void);
#define WRITE() ((void)__llvm_profile_write_file())
#else
void __gcov_dump(void);
#define WRITE() __gcov_dump()
#endif

_Noreturn void __real__exit(int status);
_Noreturn void __wrap__exit(int status);

_Noreturn void __wrap__exit(int status)
{
    WRITE();
    __real__exit(status);
}
