/* A confined process: what it can no longer do, what it still can, and the files that it gets. */
#include "tia/confine.c"
#include "tia/file_door.c"

#include <pthread.h>
#include <sys/wait.h>

#include "check.h"

enum { MEMORY = 512 << 20, SECONDS = 20, UNFILTERED = 77 };

/* Runs `work` in a process that confine() confines. Returns its exit status; -1: it was killed. */
static int confined(int (*work)(int socket), int socket)
{
    (void)fflush(stdout);
    pid_t child = fork();
    int ended = 0;

    if (child == 0) {
        bool closed = confine_descriptors(socket);
        if (!confine(MEMORY, SECONDS))
            _exit(UNFILTERED);
        _exit(closed ? work(socket) : 1);
    }
    (void)waitpid(child, &ended, 0);
    return WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
}

/* Checks that `work` returns 0; without seccomp there is nothing to check. */
#define CHECK_CONFINED(work)                                                                                           \
    do {                                                                                                               \
        int check_status_ = confined(work, -1);                                                                        \
        if (check_status_ == UNFILTERED)                                                                               \
            SKIP("no seccomp on this machine");                                                                        \
        else                                                                                                           \
            CHECK_EQ(check_status_, 0);                                                                                \
    } while (0)

/* Returns `number` if the call was not refused. */
#define REFUSED(number, call)                                                                                          \
    do {                                                                                                               \
        errno = 0;                                                                                                     \
        if ((call) >= 0 || errno != EPERM)                                                                             \
            return number;                                                                                             \
    } while (0)

static int misbehave(int unused)
{
    char *none[] = {NULL};
    struct stat status;

    (void)unused;
    REFUSED(1, open("/etc/passwd", O_RDONLY));
    REFUSED(2, open("/tmp/tia-confined", O_WRONLY | O_CREAT, 0600));
    REFUSED(3, socket(AF_INET, SOCK_STREAM, 0));
    REFUSED(4, socket(AF_UNIX, SOCK_STREAM, 0));
    REFUSED(5, execve("/bin/true", none, none));
    REFUSED(6, fork());
    REFUSED(7, kill(getppid(), 0));
    REFUSED(8, unlink("/tmp/tia-confined"));
    REFUSED(9, stat("/etc/passwd", &status));
    REFUSED(10, syscall(SYS_ptrace, 0, 0, 0, 0));
    REFUSED(11, mprotect((void *)((uintptr_t)misbehave & ~(uintptr_t)4095), 4096, PROT_READ | PROT_WRITE | PROT_EXEC));
    REFUSED(12, mmap(NULL, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED ? -1 : 0);
    REFUSED(13, prctl(PR_SET_NAME, "other"));
    REFUSED(14, setrlimit(RLIMIT_CPU, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY}));
#ifdef __x86_64__
    REFUSED(15, syscall(0x40000000 | __NR_open, "/etc/passwd", O_RDONLY)); /* of the x32 interface */
#endif
    return 0;
}

TEST(what_is_refused)
{
    CHECK_CONFINED(misbehave);
}

static void *count(void *number)
{
    ++*(int *)number;
    return NULL;
}

static int compute(int unused)
{
    int number = 0;
    pthread_t thread;
    char *memory = malloc(1 << 24);

    (void)unused;
    if (!memory || pthread_create(&thread, NULL, count, &number) != 0 || pthread_join(thread, NULL) != 0)
        return 1;
    memset(memory, 1, 1 << 24);
    int fd = memfd_create("memory", MFD_CLOEXEC);
    if (fd < 0 || ftruncate(fd, 4096) != 0 || write(fd, memory, 10) != 10)
        return 2;
    if (mmap(NULL, 4096, PROT_READ, MAP_PRIVATE, fd, 0) == MAP_FAILED)
        return 3;
    free(memory);
    return number == 1 ? 0 : 4;
}

TEST(what_is_permitted)
{
    CHECK_CONFINED(compute);
}

static int take_memory(int unused)
{
    (void)unused;
    return malloc((size_t)MEMORY + (1 << 20)) ? 1 : 0;
}

TEST(memory)
{
    if (IS_SANITIZED || sizeof(void *) == 4)
        SKIP("addresses are not limited here");
    else
        CHECK_CONFINED(take_memory);
}

/* Descriptors 0 to 2 are /dev/null, and all others are closed. */
static int look_at_descriptors(int kept)
{
    struct stat status;

    for (int fd = 0; fd < 3; fd++)
        if (fstat(fd, &status) != 0 || !S_ISCHR(status.st_mode))
            return 1;
    for (int fd = 3; fd < 200; fd++)
        if (fd != kept && fstat(fd, &status) == 0)
            return 2;
    return kept >= 0 && fstat(kept, &status) != 0 ? 3 : 0;
}

TEST(descriptors)
{
    int fd = open("/dev/zero", O_RDONLY);

    CHECK(fd >= 0);
    CHECK_CONFINED(look_at_descriptors);
    (void)close(fd);
}

/* ---- files ---- */

static const struct {
    const char *path;
    int error; /* 0: it is opened */
} questions[] = {{"models/a.obj", 0},
                 {"models/a.mtl", 0},
                 {"models/inner/texture.ppm", 0},
                 {"models/./inner//texture.ppm", 0},
                 {"models/none.mtl", ENOENT},
                 {"models/../secret", EACCES},
                 {"models/inner/../../secret", EACCES},
                 {"secret", EACCES},
                 {"/etc/passwd", EACCES},
                 {"models//etc/passwd", EACCES},
                 {"models/link", EACCES},
                 {"models/away/secret", EACCES},
                 {"models/pipe", EACCES},
                 {"models/inner", EACCES},
                 {"models/..", EACCES},
                 {"models/", ENOENT}};

static int ask(int socket)
{
    char byte;

    for (size_t i = 0; i < sizeof questions / sizeof *questions; i++) {
        int fd = file_door_open(&socket, questions[i].path);
        int error = fd >= 0 ? 0 : errno;
        if (error != questions[i].error || (fd >= 0 && read(fd, &byte, 1) != 1))
            return (int)i + 1;
        if (fd >= 0 && write(fd, &byte, 1) >= 0)
            return 100;
        if (fd >= 0)
            (void)close(fd);
    }
    return file_door_open(&socket, "") < 0 ? 0 : 101;
}

static bool put(const char *path)
{
    FILE *file = fopen(path, "w");
    return file && fputs("text\n", file) >= 0 && fclose(file) == 0;
}

static bool make_files(char *folder)
{
    return mkdtemp(folder) && chdir(folder) == 0 && mkdir("models", 0700) == 0 && mkdir("models/inner", 0700) == 0 &&
           put("models/a.obj") && put("models/a.mtl") && put("models/inner/texture.ppm") && put("secret") &&
           symlink("../secret", "models/link") == 0 && symlink("..", "models/away") == 0 &&
           mkfifo("models/pipe", 0600) == 0;
}

TEST(files)
{
    char folder[] = "/tmp/tia-test-XXXXXX", command[80];
    int ends[2], status = -1, ended = 0;
    bool made = make_files(folder) && socketpair(AF_UNIX, SOCK_SEQPACKET, 0, ends) == 0;
    struct file_door door = {.socket = ends[0], .model = "models/a.obj"};

    CHECK(made);
    (void)fflush(stdout);
    pid_t child = made ? fork() : -1;
    if (child == 0) {
        (void)close(ends[0]);
        status = confined(ask, ends[1]);
        _exit(status);
    }
    (void)close(ends[1]);
    while (made && file_door_serve(&door))
        continue;
    (void)waitpid(child, &ended, 0);
    status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    if (status == UNFILTERED)
        SKIP("no seccomp on this machine");
    else
        CHECK_EQ(status, 0);
    (void)snprintf(command, sizeof command, "rm -rf %s", folder);
    CHECK(system(command) == 0);
}

int main(void)
{
    RUN(what_is_refused);
    RUN(what_is_permitted);
    RUN(memory);
    RUN(descriptors);
    RUN(files);
    return check_status();
}
