#define _GNU_SOURCE /* unshare, close_range */
#include "image_sandbox.h"

#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SANITIZED 1
#endif
#endif
#ifndef SANITIZED
#define SANITIZED 0
#endif

/* Calls that need no look at their arguments. The last two: a thread that a library started before the filter may only
 * now begin to run. */
static const int allowed[] = {
    SCMP_SYS(read),           SCMP_SYS(readv),        SCMP_SYS(pread64),       SCMP_SYS(write),
    SCMP_SYS(writev),         SCMP_SYS(pwrite64),     SCMP_SYS(lseek),         SCMP_SYS(_llseek),
    SCMP_SYS(fstat),          SCMP_SYS(fstat64),      SCMP_SYS(close),         SCMP_SYS(brk),
    SCMP_SYS(munmap),         SCMP_SYS(mremap),       SCMP_SYS(madvise),       SCMP_SYS(futex),
    SCMP_SYS(futex_time64),   SCMP_SYS(sched_yield),  SCMP_SYS(clock_gettime), SCMP_SYS(clock_gettime64),
    SCMP_SYS(gettimeofday),   SCMP_SYS(getrandom),    SCMP_SYS(getpid),        SCMP_SYS(gettid),
    SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),   SCMP_SYS(restart_syscall),
    SCMP_SYS(exit),           SCMP_SYS(exit_group),   SCMP_SYS(sysinfo),       SCMP_SYS(set_robust_list),
    SCMP_SYS(rseq),
};

/* Only the sanitizers' own threads and checks call these. */
static const int allowed_sanitizers[] = {
    SCMP_SYS(nanosleep),
    SCMP_SYS(clock_nanosleep),
    SCMP_SYS(sched_getaffinity),
    SCMP_SYS(rt_sigaction),
};

struct image_sandbox_def image_sandbox_default_def(void)
{
    return (struct image_sandbox_def){.memory_megabytes = 512, .cpu_seconds = 10, .file_bytes = 512u << 20};
}

/* Bytes of address space now; 0 when it cannot be told. */
static rlim_t mapped_bytes(void)
{
    FILE *file = fopen("/proc/self/statm", "re");
    char line[128];
    unsigned long pages = 0;
    if (file) {
        if (fgets(line, sizeof line, file)) {
            pages = strtoul(line, NULL, 10); /* the first number: size of the whole program, proc(5) */
        }
        fclose(file);
    }
    return (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

/* Lowers a limit; one that is lower already stays. */
static bool limit(int resource, rlim_t soft, rlim_t hard)
{
    struct rlimit old;
    if (getrlimit((unsigned)resource, &old) != 0) {
        return false;
    }
    hard = old.rlim_max < hard ? old.rlim_max : hard;
    soft = hard < soft ? hard : soft;
    return setrlimit((unsigned)resource, &(struct rlimit){.rlim_cur = soft, .rlim_max = hard}) == 0;
}

static const char *enter_limits(const struct image_sandbox_def *def)
{
    struct rusage used;
    if (getrusage(RUSAGE_SELF, &used) != 0) {
        return "processor time";
    }
    rlim_t seconds = (rlim_t)(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + def->cpu_seconds);
    rlim_t mapped = mapped_bytes();
    rlim_t memory = mapped + ((rlim_t)def->memory_megabytes << 20);
    if (!SANITIZED && (mapped == 0 || !limit(RLIMIT_AS, memory, memory))) {
        return "memory";
    }
    /* The soft limit says SIGXCPU, by which the parent knows why; the hard one SIGKILL. */
    if (!limit(RLIMIT_CPU, seconds, seconds + 1)) {
        return "processor time";
    }
    if (!limit(RLIMIT_FSIZE, def->file_bytes, def->file_bytes) || !limit(RLIMIT_NOFILE, 3, 3) ||
        !limit(RLIMIT_CORE, 0, 0)) {
        return "files";
    }
    return NULL;
}

/* Memory may be mapped and protected, but never made executable. */
static int add_memory_rules(scmp_filter_ctx filter)
{
    int code = seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(mmap), 1, SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0));
    code =
        code ? code
             : seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(mmap2), 1, SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0));
    return code ? code
                : seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(mprotect), 1,
                                   SCMP_A2(SCMP_CMP_MASKED_EQ, PROT_EXEC, 0));
}

static int add_rules(scmp_filter_ctx filter)
{
    /* Libraries may have started threads of their own by now: the filter must hold for all. */
    int code = seccomp_attr_set(filter, SCMP_FLTATR_CTL_TSYNC, 1);
    for (size_t i = 0; !code && i < sizeof allowed / sizeof allowed[0]; i++) {
        code = seccomp_rule_add(filter, SCMP_ACT_ALLOW, allowed[i], 0);
    }
    for (size_t i = 0; SANITIZED && !code && i < sizeof allowed_sanitizers / sizeof allowed_sanitizers[0]; i++) {
        code = seccomp_rule_add(filter, SCMP_ACT_ALLOW, allowed_sanitizers[i], 0);
    }
    code = code ? code : add_memory_rules(filter);
    /* abort() signals the process itself. */
    code = code ? code
                : seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(tgkill), 1,
                                   SCMP_A0(SCMP_CMP_EQ, (scmp_datum_t)getpid(), 0));
    /* fstat() and questions about flags go this way on some machines; a path cannot be opened with it. */
    code = code ? code : seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(fcntl), 1, SCMP_A1(SCMP_CMP_EQ, F_GETFL, 0));
    return code ? code
                : seccomp_rule_add(filter, SCMP_ACT_ALLOW, SCMP_SYS(newfstatat), 1,
                                   SCMP_A3(SCMP_CMP_EQ, AT_EMPTY_PATH, 0));
}

static const char *enter_filter(void)
{
    scmp_filter_ctx filter = seccomp_init(SCMP_ACT_KILL_PROCESS);
    if (!filter) {
        return "memory for the filter";
    }
    bool entered = add_rules(filter) == 0 && seccomp_load(filter) == 0;
    seccomp_release(filter);
    return entered ? NULL : "system calls";
}

const char *image_sandbox_enter(const struct image_sandbox_def *def)
{
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) {
        return "privileges";
    }
    if (prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0) != 0) {
        return "life beyond the parent";
    }
    if (close_range(3, ~0u, 0) != 0 && errno != ENOSYS) {
        return "open files";
    }
    /* An empty network, where this is permitted and no library has started a thread; without it the filter is the wall.
     */
    if (unshare(CLONE_NEWUSER | CLONE_NEWNET | CLONE_NEWIPC) != 0) {
        (void)!unshare(CLONE_NEWNET | CLONE_NEWIPC);
    }
    const char *kept = enter_limits(def);
    if (kept) {
        return kept;
    }
    if (prctl(PR_SET_DUMPABLE, 0, 0, 0, 0) != 0) {
        return "being traced";
    }
    return enter_filter();
}
