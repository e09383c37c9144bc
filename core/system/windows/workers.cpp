// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/workers.h"

#include "system/process.h"
#include "system/windows/worker.h"
#include "system/workeranswers.h"

#include <QCoreApplication>
#include <QDir>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryFile>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <io.h>
#include <limits>
#include <new>
#include <sys/stat.h>
#include <utility>
#include <vector>
#include <windows.h>

namespace palmer {

namespace {

// In the environment of a worker: the name of the counter that it shares, and the file for its answers. A
// pipe would be shorter, but under Wine QProcess now and then does not hear of bytes in it.
constexpr const char *counterVariable = "PALMER_WORKER";
constexpr const char *answersVariable = "PALMER_WORKER_ANSWERS";

/// Number of the next input, shared by all processes.
class SharedCounter {
public:
    explicit SharedCounter(const QString &name)
        : m_mapping(::CreateFileMappingW(INVALID_HANDLE_VALUE, nullptr, PAGE_READWRITE, 0, sizeof(LONG),
                                         name.toStdWString().c_str()))
        , m_next(m_mapping ? ::MapViewOfFile(m_mapping, FILE_MAP_ALL_ACCESS, 0, 0, sizeof(LONG)) : nullptr) {
        if (!m_next)
            throw std::bad_alloc();
    }
    ~SharedCounter() {
        ::UnmapViewOfFile(m_next);
        ::CloseHandle(m_mapping);
    }
    SharedCounter(const SharedCounter &) = delete;
    SharedCounter &operator=(const SharedCounter &) = delete;

    int claim() { return ::InterlockedExchangeAdd(static_cast<LONG *>(m_next), 1); }
    [[nodiscard]] int claimed() const { return ::InterlockedExchangeAdd(static_cast<LONG *>(m_next), 0); }

private:
    HANDLE m_mapping;
    void *m_next;
};

/// Takes the place of a standard stream; removed with the process.
class TakenStream {
public:
    TakenStream(std::FILE *stream, const char *name)
        : m_stream(stream) {
        const QString path =
            QDir::tempPath() +
            QStringLiteral("/palmer-%1-%2").arg(::GetCurrentProcessId()).arg(QLatin1StringView(name));
        const int file =
            ::_wopen(path.toStdWString().c_str(), _O_RDWR | _O_CREAT | _O_TRUNC | _O_BINARY | _O_TEMPORARY,
                     _S_IREAD | _S_IWRITE);
        if (file < 0 || ::_dup2(file, ::_fileno(stream)) != 0)
            std::_Exit(1);
        ::_close(file);
    }

    /// The output since the last call.
    [[nodiscard]] QByteArray take() const {
        std::fflush(m_stream);
        const int file = ::_fileno(m_stream);
        const long size = ::_lseek(file, 0, SEEK_CUR);
        QByteArray bytes(std::max(size, 0L), Qt::Uninitialized);
        ::_lseek(file, 0, SEEK_SET);
        if (size > 0 && ::_read(file, bytes.data(), static_cast<unsigned>(size)) != size)
            bytes.clear();
        ::_lseek(file, 0, SEEK_SET);
        return bytes;
    }

private:
    std::FILE *m_stream;
};

/// The streams of a worker.
struct WorkerStreams {
    int answers = ::_wopen(qEnvironmentVariable(answersVariable).toStdWString().c_str(),
                           _O_WRONLY | _O_APPEND | _O_BINARY);
    TakenStream printed{stdout, "out"};
    TakenStream errors{stderr, "errors"};

    void send(const QByteArray &bytes) const {
        for (qsizetype at = 0; at < bytes.size();) {
            constexpr qsizetype most = 1 << 20;
            const int written = ::_write(answers, bytes.constData() + at,
                                         static_cast<unsigned>(std::min(bytes.size() - at, most)));
            if (written <= 0)
                std::_Exit(1);
            at += written;
        }
    }
};

bool isWorker() {
    return qEnvironmentVariableIsSet(counterVariable);
}

const WorkerStreams &workerStreams() {
    static const WorkerStreams streams;
    return streams;
}

/// Main loop of a worker process: processes inputs and sends each answer immediately.
[[noreturn]] void serve(int count, const std::function<JobResult(int)> &work) {
    const WorkerStreams &streams = workerStreams();
    const QString name = qEnvironmentVariable(counterVariable);
    SharedCounter next(name);
    static_cast<void>(streams.printed.take()); // the first process printed the same
    static_cast<void>(streams.errors.take());
    for (int input = next.claim(); input < count; input = next.claim()) {
        streams.send(bytesOf(WorkerAnswer{.input = input}));
        FinishedJob job{work(input), {}, {}};
        job.printed = streams.printed.take();
        job.errors = streams.errors.take();
        streams.send(bytesOf(input, job));
    }
    std::_Exit(0);
}

/// A worker process, as seen by the first.
struct Worker {
    std::unique_ptr<QTemporaryFile> answers;
    std::unique_ptr<QProcess> process;
    QByteArray bytes = {};         ///< read, but not a complete answer yet
    std::optional<int> input = {}; ///< being processed
    bool hasAnswered = false;

    /// Waits a moment for it.
    [[nodiscard]] bool hasNews() const {
        constexpr int pause = 5; // ms
        return answers->bytesAvailable() > 0 || process->waitForFinished(pause) ||
               process->state() == QProcess::NotRunning;
    }
};

} // namespace

void prepareAsWorker() {
    if (isWorker())
        workerStreams();
}

namespace {

class Pool : public Workers {
public:
    explicit Pool(int count)
        : m_count(count)
        , m_name(QStringLiteral("palmer-%1-%2")
                     .arg(::GetCurrentProcessId())
                     .arg(reinterpret_cast<quintptr>(this)))
        , m_next(m_name) {}
    ~Pool() override {
        for (const Worker &worker : m_workers)
            worker.process->waitForFinished(-1);
    }
    Pool(const Pool &) = delete;
    Pool &operator=(const Pool &) = delete;

    bool keepUp(int jobs) override {
        while (m_starts && std::cmp_less(m_workers.size(), jobs) && m_next.claimed() < m_count) {
            if (!start())
                break;
        }
        return !m_workers.empty();
    }

    void listen(FinishedJobs &ended) override {
        while (std::ranges::none_of(m_workers, &Worker::hasNews)) {
        }
        for (std::size_t i = m_workers.size(); i-- > 0;) {
            Worker &worker = m_workers[i];
            const bool hasEnded =
                worker.process->state() == QProcess::NotRunning; // before its last bytes are read
            worker.bytes += worker.answers->readAll();
            worker.hasAnswered = worker.hasAnswered || !worker.bytes.isEmpty();
            takeAnswers(worker.bytes, worker.input, ended);
            if (!hasEnded)
                continue;
            if (worker.input)
                ended.emplace(*worker.input, std::nullopt);
            m_starts = m_starts && worker.hasAnswered; // otherwise others would end as early
            m_workers.erase(m_workers.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }

private:
    bool start() {
        Worker worker{std::make_unique<QTemporaryFile>(), std::make_unique<QProcess>()};
        if (!worker.answers->open())
            return false;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QString::fromLatin1(counterVariable), m_name);
        environment.insert(QString::fromLatin1(answersVariable), worker.answers->fileName());
        worker.process->setProcessEnvironment(environment);
        worker.process->setInputChannelMode(QProcess::ForwardedInputChannel);
        worker.process->setProcessChannelMode(QProcess::ForwardedChannels); // it redirects them itself
        worker.process->start(QCoreApplication::applicationFilePath(),
                              wordsOf(std::numeric_limits<int>::max(), nullptr));
        if (!worker.process->waitForStarted(-1))
            return false;
        m_workers.push_back(std::move(worker));
        return true;
    }

    int m_count;
    QString m_name;
    SharedCounter m_next;
    std::vector<Worker> m_workers;
    bool m_starts = true; ///< processes can be started
};

} // namespace

std::unique_ptr<Workers> workersFor(int count, std::function<JobResult(int)> work) {
    if (isWorker())
        serve(count, work);
    return std::make_unique<Pool>(count);
}

} // namespace palmer
