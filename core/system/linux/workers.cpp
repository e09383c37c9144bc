// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/workers.h"

#include "system/workeranswers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace palmer {

namespace {

/// Number of the next input, shared by all processes.
class SharedCounter {
public:
    SharedCounter()
        : m_place(::mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                         MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (m_place == MAP_FAILED)
            throw std::bad_alloc();
        m_next = new (m_place) std::atomic<int>(0);
    }
    ~SharedCounter() { ::munmap(m_place, sizeof(std::atomic<int>)); }
    SharedCounter(const SharedCounter &) = delete;
    SharedCounter &operator=(const SharedCounter &) = delete;

    int claim() { return m_next->fetch_add(1); }
    [[nodiscard]] int claimed() const { return m_next->load(); }

private:
    void *m_place;
    std::atomic<int> *m_next = nullptr;
};

bool writeAll(int file, const QByteArray &bytes) {
    for (qsizetype at = 0; at < bytes.size();) {
        const ssize_t written =
            ::write(file, bytes.constData() + at, static_cast<std::size_t>(bytes.size() - at));
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        at += written;
    }
    return true;
}

/// Returns the content of a memory file and clears it.
QByteArray taken(int file) {
    const off_t size = ::lseek(file, 0, SEEK_CUR);
    QByteArray bytes(std::max<off_t>(size, 0), Qt::Uninitialized);
    if (size > 0 && ::pread(file, bytes.data(), static_cast<std::size_t>(size), 0) != size)
        bytes.clear();
    if (::ftruncate(file, 0) != 0 || ::lseek(file, 0, SEEK_SET) != 0)
        ::_exit(1); // never happens
    return bytes;
}

/// Main loop of a worker process: processes inputs and sends each answer immediately.
[[noreturn]] void serve(int pipe, SharedCounter &next, int count, const std::function<JobResult(int)> &work) {
    const int out = ::memfd_create("out", 0);
    const int errors = ::memfd_create("errors", 0);
    if (out < 0 || errors < 0 || ::dup2(out, STDOUT_FILENO) < 0 || ::dup2(errors, STDERR_FILENO) < 0)
        ::_exit(1);
    for (int input = next.claim(); input < count; input = next.claim()) {
        if (!writeAll(pipe, bytesOf(WorkerAnswer{.input = input})))
            ::_exit(1);
        FinishedJob job{work(input), {}, {}};
        std::fflush(stdout);
        std::fflush(stderr);
        job.printed = taken(out);
        job.errors = taken(errors);
        if (!writeAll(pipe, bytesOf(input, job)))
            ::_exit(1);
    }
    ::_exit(0);
}

/// A worker process, as seen by the parent.
struct Worker {
    pid_t process = -1;
    int pipe = -1;
    QByteArray bytes;              ///< read, but not a complete answer yet
    std::optional<int> input = {}; ///< being processed
};

class Pool : public Workers {
public:
    Pool(int count, std::function<JobResult(int)> work)
        : m_count(count)
        , m_work(std::move(work)) {}
    ~Pool() override {
        for (const Worker &worker : m_workers)
            end(worker);
    }
    Pool(const Pool &) = delete;
    Pool &operator=(const Pool &) = delete;

    bool keepUp(int jobs) override {
        while (std::cmp_less(m_workers.size(), jobs) && m_next.claimed() < m_count) {
            if (!start())
                break;
        }
        return !m_workers.empty();
    }

    void listen(FinishedJobs &ended) override {
        std::vector<pollfd> pipes;
        for (const Worker &worker : m_workers)
            pipes.push_back({worker.pipe, POLLIN, 0});
        if (::poll(pipes.data(), pipes.size(), -1) < 0)
            return; // interrupted by a signal
        for (std::size_t i = pipes.size(); i-- > 0;) {
            if (pipes[i].revents == 0)
                continue;
            std::array<char, 1 << 16> block{};
            const ssize_t size = ::read(pipes[i].fd, block.data(), block.size());
            if (size < 0)
                continue;
            Worker &worker = m_workers[i];
            worker.bytes.append(block.data(), size);
            takeAnswers(worker.bytes, worker.input, ended);
            if (size > 0)
                continue;
            if (worker.input)
                ended.emplace(*worker.input, std::nullopt);
            end(worker);
            m_workers.erase(m_workers.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }

private:
    static void end(const Worker &worker) {
        ::close(worker.pipe);
        ::waitpid(worker.process, nullptr, 0);
    }

    bool start() {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0)
            return false;
        std::fflush(stdout);
        std::fflush(stderr);
        const pid_t parent = ::getpid();
        const pid_t process = ::fork();
        if (process == 0) {
            // Ends with the command, however long its work is.
            if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != parent)
                ::_exit(1);
            ::close(ends[0]);
            for (const Worker &other : m_workers)
                ::close(other.pipe);
            serve(ends[1], m_next, m_count, m_work);
        }
        ::close(ends[1]);
        if (process < 0) {
            ::close(ends[0]);
            return false;
        }
        m_workers.push_back({process, ends[0], {}, {}});
        return true;
    }

    int m_count;
    std::function<JobResult(int)> m_work;
    SharedCounter m_next;
    std::vector<Worker> m_workers;
};

} // namespace

std::unique_ptr<Workers> workersFor(int count, std::function<JobResult(int)> work) {
    return std::make_unique<Pool>(count, std::move(work));
}

} // namespace palmer
