// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/jobs.h"

#include "commandline/streams.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <map>
#include <new>
#include <optional>
#include <poll.h>
#include <string>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace palmer {

namespace {

constexpr std::int32_t atWork = -1; ///< in place of a code: the input was started

/// Header of an answer on the pipe to the parent.
struct Answer {
    std::int32_t input = 0;
    std::int32_t code = 0;
    std::int64_t printed = 0; ///< bytes on stdout
    std::int64_t errors = 0;  ///< bytes on stderr
    std::int64_t rows = 0;
};

struct Finished {
    JobResult result;
    QByteArray printed;
    QByteArray errors;
};

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

QByteArray bytesOf(const Answer &answer) {
    const auto bytes = std::bit_cast<std::array<char, sizeof(Answer)>>(answer);
    return {bytes.data(), sizeof(Answer)};
}

Answer answerOf(const QByteArray &bytes) {
    std::array<char, sizeof(Answer)> head{};
    std::ranges::copy(bytes.first(sizeof(Answer)), head.begin());
    return std::bit_cast<Answer>(head);
}

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
        if (!writeAll(pipe, bytesOf({input, atWork, 0, 0, 0})))
            ::_exit(1);
        const JobResult result = work(input);
        std::fflush(stdout);
        std::fflush(stderr);
        const QByteArray printed = taken(out);
        const QByteArray said = taken(errors);
        const Answer answer{input, result.code, printed.size(), said.size(), result.rows.size()};
        if (!writeAll(pipe, bytesOf(answer) + printed + said + result.rows))
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

/// Extracts the complete answers from the bytes of a worker.
void readAnswers(Worker &worker, std::map<int, std::optional<Finished>> &ended) {
    while (worker.bytes.size() >= qsizetype(sizeof(Answer))) {
        const Answer answer = answerOf(worker.bytes);
        worker.input = answer.input;
        qsizetype at = sizeof answer;
        if (answer.code != atWork) {
            if (worker.bytes.size() < at + answer.printed + answer.errors + answer.rows)
                return;
            Finished done;
            done.printed = worker.bytes.mid(at, answer.printed);
            done.errors = worker.bytes.mid(at += answer.printed, answer.errors);
            done.result = {answer.code, worker.bytes.mid(at += answer.errors, answer.rows)};
            at += answer.rows;
            ended.emplace(answer.input, std::move(done));
            worker.input.reset();
        }
        worker.bytes.remove(0, at);
    }
}

class Workers {
public:
    Workers(int count, const std::function<JobResult(int)> &work)
        : m_count(count)
        , m_work(work) {}

    /// Starts processes while inputs are left; returns false if none is running.
    bool keepUp(int jobs) {
        while (std::cmp_less(m_workers.size(), jobs) && m_next.claimed() < m_count) {
            if (!start())
                break;
        }
        return !m_workers.empty();
    }

    /// Waits for output of a worker.
    void listen(std::map<int, std::optional<Finished>> &ended) {
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
            readAnswers(worker, ended);
            if (size > 0)
                continue;
            if (worker.input)
                ended.emplace(*worker.input, std::nullopt);
            end(worker);
            m_workers.erase(m_workers.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }

    void end() {
        for (const Worker &worker : m_workers)
            end(worker);
        m_workers.clear();
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
        const pid_t process = ::fork();
        if (process == 0) {
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
    const std::function<JobResult(int)> &m_work;
    SharedCounter m_next;
    std::vector<Worker> m_workers;
};

bool isTerminal() {
    return ::isatty(STDERR_FILENO) != 0;
}

void printWhat(const Finished &finished, bool parted) {
    std::fwrite(finished.errors.constData(), 1, static_cast<std::size_t>(finished.errors.size()), stderr);
    if (!finished.printed.isEmpty())
        printOut((parted ? QByteArray("\n") : QByteArray()) + finished.printed);
}

} // namespace

void showProgress(int done, int count) {
    if (isTerminal())
        std::fputs(("\r" + std::to_string(done) + " / " + std::to_string(count)).c_str(), stderr);
}

void clearProgress() {
    if (isTerminal())
        std::fputs("\r\x1b[K", stderr);
}

int defaultJobs() {
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

void eachJob(int count, int jobs, const Jobs &tell) {
    if (count == 1) {
        tell.heard(0, tell.work(0));
        return;
    }
    Workers workers(count, tell.work);
    std::map<int, std::optional<Finished>> ended; ///< not reported yet; null: the process crashed
    bool hasPrinted = false;
    int next = 0;
    while (next < count) {
        if (workers.keepUp(jobs)) {
            workers.listen(ended);
        } else if (!ended.contains(next)) { // no process available: process it here
            tell.heard(next, tell.work(next));
            ++next;
        }
        for (auto one = ended.find(next); one != ended.end(); one = ended.find(next)) {
            clearProgress();
            if (one->second) {
                printWhat(*one->second, tell.parted && hasPrinted);
                hasPrinted = hasPrinted || !one->second->printed.isEmpty();
            }
            tell.heard(next, one->second ? one->second->result : JobResult{tell.broken(next), {}});
            ended.erase(one);
            ++next;
        }
        showProgress(next, count);
    }
    clearProgress();
    workers.end();
}

} // namespace palmer
