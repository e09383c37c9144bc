// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before the C library (LD_PRELOAD): lets one of the system calls that change FAULT_FOLDER or its
// files fail, or kills the program instead of it. FAULT_AT: which, from 1; FAULT_KIND: error or kill. Each
// call adds its name as a line to FAULT_LOG, which is outside of that folder.
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <limits.h>
#include <string>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

namespace {

const char *setting(const char *name) {
    const char *value = std::getenv(name);
    return value ? value : "";
}

bool isInside(const char *path) {
    const char *folder = setting("FAULT_FOLDER");
    if (*folder == '\0' || !path)
        return false;
    std::string whole = path;
    if (*path != '/') {
        char here[PATH_MAX];
        whole = std::string(::getcwd(here, sizeof here) ? here : "") + "/" + path;
    }
    return whole.rfind(folder, 0) == 0;
}

bool isInside(int file) {
    char path[PATH_MAX];
    const std::string link = "/proc/self/fd/" + std::to_string(file);
    const ssize_t size = ::readlink(link.c_str(), path, sizeof path - 1);
    if (size < 0)
        return false;
    path[size] = '\0';
    return *path == '/' && isInside(path); // pipes and the like have no path
}

/// True if this call is to fail.
bool fails(const char *name) {
    static int calls = 0;
    const std::string line = std::string(name) + "\n";
    const int log = static_cast<int>(
        ::syscall(SYS_openat, AT_FDCWD, setting("FAULT_LOG"), O_WRONLY | O_CREAT | O_APPEND, 0600));
    ::syscall(SYS_write, log, line.data(), line.size());
    ::syscall(SYS_close, log);
    if (++calls != std::atoi(setting("FAULT_AT")))
        return false;
    if (std::strcmp(setting("FAULT_KIND"), "kill") == 0)
        ::raise(SIGKILL);
    errno = EIO;
    return true;
}

template <typename Function>
Function next(const char *name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

bool writes(int flags) {
    return (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC)) != 0;
}

mode_t modeOf(int flags, va_list rest) {
    return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(rest, mode_t) : 0;
}

} // namespace

#define OPENS(name)                                                                                          \
    extern "C" int name(const char *path, int flags, ...) {                                                  \
        va_list rest;                                                                                        \
        va_start(rest, flags);                                                                               \
        const mode_t mode = modeOf(flags, rest);                                                             \
        va_end(rest);                                                                                        \
        static const auto original = next<int (*)(const char *, int, ...)>(#name);                           \
        return writes(flags) && isInside(path) && fails(#name) ? -1 : original(path, flags, mode);           \
    }
OPENS(open)
OPENS(open64)

#define OPENS_AT(name)                                                                                       \
    extern "C" int name(int folder, const char *path, int flags, ...) {                                      \
        va_list rest;                                                                                        \
        va_start(rest, flags);                                                                               \
        const mode_t mode = modeOf(flags, rest);                                                             \
        va_end(rest);                                                                                        \
        static const auto original = next<int (*)(int, const char *, int, ...)>(#name);                      \
        return writes(flags) && isInside(path) && fails(#name) ? -1 : original(folder, path, flags, mode);   \
    }
OPENS_AT(openat)
OPENS_AT(openat64)

// A call whose first argument, a path or a descriptor, says whether it counts.
#define CALLS(type, name, first, rest, arguments)                                                            \
    extern "C" type name(first subject rest) {                                                               \
        static const auto original = next<type (*)(first rest)>(#name);                                      \
        return isInside(subject) && fails(#name) ? -1 : original(subject arguments);                         \
    }
#define AND ,
CALLS(ssize_t, write, int, AND const void *bytes AND size_t size, AND bytes AND size)
CALLS(ssize_t, pwrite64, int, AND const void *bytes AND size_t size AND off64_t at, AND bytes AND size AND at)
CALLS(int, fsync, int, , )
CALLS(int, fdatasync, int, , )
CALLS(int, ftruncate, int, AND off_t size, AND size)
CALLS(int, ftruncate64, int, AND off64_t size, AND size)
CALLS(int, fchmod, int, AND mode_t mode, AND mode)
CALLS(int, mkdir, const char *, AND mode_t mode, AND mode)
CALLS(int, unlink, const char *, , )
CALLS(int, rename, const char *, AND const char *to, AND to)
CALLS(int, link, const char *, AND const char *to, AND to)

extern "C" int linkat(int from, const char *path, int to, const char *name, int flags) {
    static const auto original = next<int (*)(int, const char *, int, const char *, int)>("linkat");
    return isInside(name) && fails("linkat") ? -1 : original(from, path, to, name, flags);
}

extern "C" int renameat2(int from, const char *path, int to, const char *name, unsigned flags) {
    static const auto original = next<int (*)(int, const char *, int, const char *, unsigned)>("renameat2");
    return isInside(name) && fails("renameat2") ? -1 : original(from, path, to, name, flags);
}
