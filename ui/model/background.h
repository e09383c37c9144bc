// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace palmer::ui {

/// A lane of work beside the window: its jobs run one after another on a thread of their own, what they tell
/// is heard on the thread of the window. A job that was cancelled before it began is left out, one that runs
/// is asked to stop, and of neither anything is heard any more: where only the latest counts, cancel before
/// starting. The end of the lane cancels and waits.
class Background {
public:
    /// What a job knows of its lane.
    class Job {
    public:
        [[nodiscard]] const std::stop_token &stop() const { return m_stop; }
        /// Calls `hear` on the thread of the window, unless the job is cancelled before.
        void tell(std::function<void()> hear) const;

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

    /// Does `work(const Job &)` and then `hear(result)` on the thread of the window; `hear()` where there is
    /// no result.
    template <class Work, class Hear>
    void start(Work work, Hear hear);

    /// Nothing is heard any more of what was started. Returns at once.
    void cancel();

    /// Something was started that is neither cancelled nor heard.
    [[nodiscard]] bool isBusy() const { return m_open > 0; }

    /// Until all jobs have ended; what they tell is heard later.
    void wait() { m_thread.waitForDone(); }

private:
    Q_DISABLE_COPY_MOVE(Background)

    QObject m_place; ///< where jobs are heard
    QThreadPool m_thread;
    std::stop_source m_stop;
    int m_open = 0;
};

template <class Work, class Hear>
void Background::start(Work work, Hear hear) {
    ++m_open;
    const Job job(m_place, m_stop.get_token());
    m_thread.start([this, job, work = std::move(work), hear = std::move(hear)]() mutable {
        if (job.stop().stop_requested())
            return;
        using Result = std::invoke_result_t<Work, const Job &>;
        if constexpr (std::is_void_v<Result>) {
            work(job);
            job.tell([this, hear = std::move(hear)]() mutable {
                --m_open;
                hear();
            });
        } else {
            auto result = std::make_shared<Result>(work(job));
            job.tell([this, result, hear = std::move(hear)]() mutable {
                --m_open;
                hear(std::move(*result));
            });
        }
    });
}

} // namespace palmer::ui
