// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEventLoop>
#include <QObject>
#include <QThreadPool>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace palmer::ui {

/// A queue of background jobs: they run one after another on a thread of their own, and their callbacks run
/// on the window's thread. cancel() skips jobs not yet started, asks the running one to stop and drops their
/// callbacks; if only the latest job matters, cancel before starting it. The destructor cancels and waits.
class Background {
public:
    /// A job's access to its queue.
    class Job {
    public:
        [[nodiscard]] const std::stop_token &stop() const { return m_stop; }
        /// Calls `onResult` on the window's thread unless the job is cancelled first.
        void post(std::function<void()> onResult) const;

    private:
        friend class Background;
        Job(QObject &place, std::stop_token stop)
            : m_place(place)
            , m_stop(std::move(stop)) {}

        QObject &m_place;
        std::stop_token m_stop;
    };

    Background();
    ~Background();

    /// Runs `work(const Job &)`, then `onResult(result)` on the window's thread; `onResult()` if there is no
    /// result.
    template <class Work, class OnResult>
    void start(Work work, OnResult onResult);

    /// Discards pending jobs and callbacks. Returns at once.
    void cancel();

    /// True while a job that was not cancelled has yet to call back.
    [[nodiscard]] bool isBusy() const { return m_open > 0; }

    /// Waits until all jobs have ended; their callbacks run later.
    void wait() { m_thread.waitForDone(); }

private:
    Q_DISABLE_COPY_MOVE(Background)

    QObject m_place; ///< context object of the callbacks
    QThreadPool m_thread;
    std::stop_source m_stop;
    int m_open = 0;
};

template <class Work, class OnResult>
void Background::start(Work work, OnResult onResult) {
    ++m_open;
    const Job job(m_place, m_stop.get_token());
    m_thread.start([this, job, work = std::move(work), onResult = std::move(onResult)]() mutable {
        if (job.stop().stop_requested())
            return;
        using Result = std::invoke_result_t<Work, const Job &>;
        if constexpr (std::is_void_v<Result>) {
            work(job);
            job.post([this, onResult = std::move(onResult)]() mutable {
                --m_open;
                onResult();
            });
        } else {
            auto result = std::make_shared<Result>(work(job));
            job.post([this, result, onResult = std::move(onResult)]() mutable {
                --m_open;
                onResult(std::move(*result));
            });
        }
    });
}

/// Runs `work` on a background thread and returns its result or throws its exception. Until then windows are
/// painted but take no input: for what a user has asked for and waits for, whose outcome decides what is
/// next.
template <class Work>
std::invoke_result_t<Work> awaited(Work work) {
    QEventLoop meanwhile;
    std::packaged_task<std::invoke_result_t<Work>()> task(std::move(work));
    auto result = task.get_future();
    QThreadPool thread;
    thread.start([&] {
        task();
        QMetaObject::invokeMethod(&meanwhile, &QEventLoop::quit, Qt::QueuedConnection);
    });
    meanwhile.exec(QEventLoop::ExcludeUserInputEvents);
    return result.get();
}

} // namespace palmer::ui
