// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/lanes.h"
#include "kernel/numerics/runinbackground.h"
#include "kernel/simulation/simulate.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <span>
#include <thread>
#include <vector>

namespace palmer {

/// Counts values in many narrow intervals over mean ± 8 u of the first block: narrow enough to read an
/// interval of 95.45 % from the counts, which do not depend on the order of the trials.
struct FineCounts {
    static constexpr int count = 8192;
    static constexpr double reach = 8; ///< u on either side; fewer than 1/64 of the values lie beyond
    double from = 0;
    double width = 0; ///< 0: all values are equal

    /// `perWidth`: 1/width.
    [[nodiscard]] std::size_t index(double value, double perWidth) const {
        const double place = (value - from) * perWidth;
        return static_cast<std::size_t>(smaller(larger(place, 0.0), double(count - 1)));
    }
};

struct CoverageInterval {
    double low = 0;
    double high = 0;
};

/// Returns the shortest interval that contains 95.45 % of the counted values, assumed to be evenly spread
/// within each interval of the counts.
[[nodiscard]] CoverageInterval shortestInterval(const FineCounts &fine, std::span<const long long> counts);

/// Returns the counts in 64 intervals over mean ± 4 u, for a figure.
[[nodiscard]] Histogram histogram(const FineCounts &fine, std::span<const long long> counts);

/// Averages of the blocks of a run: what is stable, and the uncertainty of the whole (JCGM 101, 7.9.4).
struct BlockAverages {
    std::vector<double> means; ///< of d = Y − evaluated value
    std::vector<double> u;
    std::vector<double> low; ///< ends of the shortest interval
    std::vector<double> high;
    std::vector<double> expanded;

    /// True if twice the standard deviation of each average is at most `tolerance`, or so small that it is
    /// rounding; false for one block.
    [[nodiscard]] bool stable(double tolerance) const;
};

/// Returns the standard deviation of the average of values, one per block; null for fewer than two.
[[nodiscard]] std::optional<double> errorOfAverage(std::span<const double> blocks);

inline constexpr long long mostBlocks = 1000;

/// Returns the block size for a fixed number of trials: 10⁴, or more to keep to `mostBlocks` blocks.
[[nodiscard]] constexpr long long fixedBlock(long long trials) {
    constexpr long long most = mostBlocks * trialsPerBlock;
    return trialsPerBlock * std::max(1LL, (trials + most - 1) / most);
}

/// Sums over trials of d = Y − evaluated value.
struct Moments {
    double sum = 0;
    double squares = 0;
    long long count = 0;

    void add(const Moments &more) {
        sum += more.sum;
        squares += more.squares;
        count += more.count;
    }
    [[nodiscard]] double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
    [[nodiscard]] double deviation() const {
        if (count < 2)
            return 0;
        const auto n = static_cast<double>(count);
        return std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1));
    }
};

/// Returns how many consecutive chunks are summed together, of `chunks` in all: one up to 4096 chunks, then
/// as many as keep the number of groups at 4096. The stored sums take a megabyte or so for any number of
/// trials.
[[nodiscard]] constexpr long long chunksInGroup(long long chunks) {
    constexpr long long mostGroups = 4096;
    return chunks <= mostGroups ? 1 : (chunks + mostGroups - 1) / mostGroups;
}

/// Runs the trials of a model on several threads and sums them up. `Model`: parameters(), chunk(),
/// buffers(), run(first, buffers, values, stop) as in PositioningTrials. Null if stopped.
template <class Model>
class TrialRun {
public:
    TrialRun(const Model &model, const SimulationOptions &options, std::stop_token stop,
             const std::function<void(const SimulationProgress &)> &progress)
        : m_model(model)
        , m_options(options)
        , m_stop(std::move(stop))
        , m_progress(progress)
        , m_parameters(model.parameters().size())
        , m_chunk(model.chunk())
        , m_fine(m_parameters)
        , m_counts(m_parameters * FineCounts::count)
        , m_moments(m_parameters) {
        int threads =
            options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
        constexpr int mostThreads = 256;
        threads = std::clamp(threads, 1, mostThreads);
        for (int k = 0; k < threads; ++k)
            m_workers.push_back({model.buffers(), std::vector<double>(m_parameters * size_t(m_chunk)),
                                 std::vector<std::uint32_t>(m_parameters * FineCounts::count)});
    }

    std::optional<Simulation> run() {
        const bool adaptive = !m_options.trials;
        if (!adaptive)
            m_total = std::max(1LL, *m_options.trials);
        const long long most = m_total.value_or(mostBlocks * trialsPerBlock);
        const long long block = fixedBlock(most);
        Simulation result;
        result.seed = m_options.seed;
        result.adaptive = adaptive;
        result.stable = false;
        long long done = 0;
        while (done < most && !(adaptive && result.stable)) {
            const bool first = done == 0;
            const long long next = std::min(first ? trialsPerBlock : block, most - done);
            if (!(first ? firstBlock(next) : stage(done, next)))
                return std::nullopt;
            done += next;
            finishBlock(next == block); // only blocks of this size are averaged; all count in the total
            result.stable = done >= fewestDecidingTrials && stable();
        }
        result.trials = done;
        result.parameters = m_model.parameters();
        for (std::size_t p = 0; p < m_parameters; ++p) {
            SimulatedParameter &parameter = result.parameters[p];
            parameter.mean = parameter.value + m_moments[p].mean();
            parameter.u = m_moments[p].deviation();
            const CoverageInterval interval = shortestInterval(m_fine[p], counts(m_counts, p));
            parameter.low = parameter.value + interval.low;
            parameter.high = parameter.value + interval.high;
            parameter.histogram = histogram(m_fine[p], counts(m_counts, p));
            parameter.histogram.from += parameter.value;
            if (p < m_averages.size())
                parameter.expandedError = errorOfAverage(m_averages[p].expanded);
        }
        return result;
    }

private:
    struct Worker {
        typename Model::Buffers buffers;
        std::vector<double> values;        ///< of one chunk
        std::vector<std::uint32_t> counts; ///< of one stage
    };

    template <class Counts>
    static auto counts(Counts &all, std::size_t parameter) {
        return std::span(all).subspan(parameter * FineCounts::count, FineCounts::count);
    }

    [[nodiscard]] static std::size_t size_t(int number) { return static_cast<std::size_t>(number); }

    /// Processes the chunks on all threads, each group sequentially on one; `work(worker, group, offset,
    /// trials)`. Returns false if stopped. The groups depend only on the number of trials, so that sums over
    /// a group do not depend on the number of threads, and their number is limited.
    template <class Work>
    bool onAllThreads(long long first, long long trials, Work work) {
        const long long chunks = (trials + m_chunk - 1) / m_chunk;
        const long long together = chunksInGroup(chunks);
        const auto groups = static_cast<long long>(groupsOf(trials));
        std::atomic<long long> next = 0;
        std::atomic<long long> done = 0;
        const auto loop = [&](Worker &worker, bool reports) {
            while (!m_stop.stop_requested()) {
                const long long group = next++;
                if (group >= groups)
                    return;
                const long long end = std::min(chunks, (group + 1) * together);
                for (long long chunk = group * together; chunk < end; ++chunk) {
                    if (m_stop.stop_requested())
                        return;
                    const long long offset = chunk * m_chunk;
                    m_model.run(first + offset, worker.buffers, worker.values, m_stop);
                    const long long count = std::min<long long>(m_chunk, trials - offset);
                    work(worker, static_cast<std::size_t>(group), offset, count);
                    done += count;
                    if (reports && m_progress)
                        m_progress({first + done, m_total});
                }
            }
        };
        const auto threads = std::min<long long>(static_cast<long long>(m_workers.size()), groups);
        std::vector<std::future<void>> others; // if a thread is unavailable, nothing is left for it to do
        for (long long k = 1; k < threads; ++k)
            others.push_back(
                runInBackground(true, [&, k] { loop(m_workers[static_cast<std::size_t>(k)], false); }));
        loop(m_workers.front(), true);
        for (std::future<void> &other : others)
            other.get();
        return !m_stop.stop_requested();
    }

    /// Returns d = Y − evaluated value for the first trials of a worker's chunk.
    [[nodiscard]] std::span<double> deviations(Worker &worker, std::size_t p, long long count) const {
        const std::span<double> values =
            std::span(worker.values).subspan(p * size_t(m_chunk), static_cast<std::size_t>(count));
        for (double &value : values)
            value -= m_model.parameters()[p].value;
        return values;
    }

    static Moments momentsOf(std::span<const double> values) {
        Moments result;
        for (const double d : values) {
            result.sum += d;
            result.squares += d * d;
        }
        result.count = static_cast<long long>(values.size());
        return result;
    }

    /// Runs the first block and keeps its values, which determine the range of the counts.
    bool firstBlock(long long trials) {
        const auto n = static_cast<std::size_t>(trials);
        std::vector<double> values(m_parameters * n);
        m_groupMoments.assign(m_parameters * groupsOf(trials), {});
        const bool ready = onAllThreads(
            0, trials, [&](Worker &worker, std::size_t group, long long offset, long long count) {
                for (std::size_t p = 0; p < m_parameters; ++p) {
                    const auto of = deviations(worker, p, count);
                    m_groupMoments[group * m_parameters + p].add(momentsOf(of));
                    std::ranges::copy(of, values.begin() + static_cast<std::ptrdiff_t>(p * n) + offset);
                }
            });
        if (!ready)
            return false;
        m_block.assign(m_parameters, {});
        sumGroups();
        for (std::size_t p = 0; p < m_parameters; ++p) {
            FineCounts &fine = m_fine[p];
            const double u = m_block[p].deviation();
            fine.from = m_block[p].mean() - FineCounts::reach * u;
            fine.width = 2 * FineCounts::reach * u / FineCounts::count;
            if (!(fine.width > 0))
                fine = {m_block[p].mean(), 0};
            count(fine, std::span(values).subspan(p * n, n), counts(m_workers.front().counts, p));
        }
        return true;
    }

    /// Runs further trials and counts them at once.
    bool stage(long long first, long long trials) {
        m_groupMoments.assign(m_parameters * groupsOf(trials), {});
        const bool ready =
            onAllThreads(first, trials, [&](Worker &worker, std::size_t group, long long, long long number) {
                for (std::size_t p = 0; p < m_parameters; ++p) {
                    const auto of = deviations(worker, p, number);
                    m_groupMoments[group * m_parameters + p].add(momentsOf(of));
                    count(m_fine[p], of, counts(worker.counts, p));
                }
            });
        if (ready)
            sumGroups();
        return ready;
    }

    [[nodiscard]] std::size_t groupsOf(long long trials) const {
        const long long chunks = (trials + m_chunk - 1) / m_chunk;
        const long long together = chunksInGroup(chunks);
        return static_cast<std::size_t>((chunks + together - 1) / together);
    }

    template <class Count>
    static void count(const FineCounts &fine, std::span<const double> values, std::span<Count> into) {
        if (fine.width == 0) {
            into[0] += static_cast<Count>(values.size());
            return;
        }
        const double perWidth = 1 / fine.width;
        for (const double value : values)
            ++into[fine.index(value, perWidth)];
    }

    /// Sums in the order of the trials, whichever thread they ran on.
    void sumGroups() {
        m_block.assign(m_parameters, {});
        for (std::size_t k = 0; k < m_groupMoments.size(); ++k)
            m_block[k % m_parameters].add(m_groupMoments[k]);
    }

    /// Calls `work(p)` for each parameter, on all threads.
    template <class Work>
    void eachParameter(const Work &work) {
        std::atomic<std::size_t> next = 0;
        const auto loop = [&] {
            for (std::size_t p = next++; p < m_parameters; p = next++)
                work(p);
        };
        std::vector<std::future<void>> others;
        for (std::size_t k = 1; k < std::min(m_workers.size(), m_parameters); ++k)
            others.push_back(runInBackground(true, loop));
        loop();
        for (std::future<void> &other : others)
            other.get();
    }

    /// Adds the last block to the total. `averaged`: records its averages to assess stability.
    void finishBlock(bool averaged) {
        if (averaged)
            m_averages.resize(m_parameters);
        eachParameter([&](std::size_t p) {
            std::vector<long long> block(FineCounts::count);
            for (Worker &worker : m_workers) {
                const auto more = counts(worker.counts, p);
                for (std::size_t k = 0; k < block.size(); ++k)
                    block[k] += more[k];
                std::ranges::fill(more, 0);
            }
            if (averaged)
                noteBlock(p, block);
            const auto all = counts(m_counts, p);
            for (std::size_t k = 0; k < block.size(); ++k)
                all[k] += block[k];
            m_moments[p].add(m_block[p]);
        });
        m_block.assign(m_parameters, {});
    }

    void noteBlock(std::size_t p, const std::vector<long long> &block) {
        const CoverageInterval interval = shortestInterval(m_fine[p], block);
        m_averages[p].means.push_back(m_block[p].mean());
        m_averages[p].u.push_back(m_block[p].deviation());
        m_averages[p].low.push_back(interval.low);
        m_averages[p].high.push_back(interval.high);
        m_averages[p].expanded.push_back((interval.high - interval.low) / 2);
    }

    /// True if stable for every parameter that varies, with the tolerance of u of all trials.
    [[nodiscard]] bool stable() const {
        for (std::size_t p = 0; p < m_averages.size(); ++p) {
            const double u = m_moments[p].deviation();
            if (u > 0 && !m_averages[p].stable(numericalTolerance(u)))
                return false;
        }
        return true;
    }

    const Model &m_model;
    const SimulationOptions &m_options;
    std::stop_token m_stop;
    const std::function<void(const SimulationProgress &)> &m_progress;
    std::size_t m_parameters;
    int m_chunk;
    std::optional<long long> m_total;
    std::vector<Worker> m_workers;
    std::vector<FineCounts> m_fine;
    std::vector<long long> m_counts;
    std::vector<Moments> m_moments;
    std::vector<Moments> m_block;
    std::vector<Moments> m_groupMoments; ///< by group of chunks, then parameter
    std::vector<BlockAverages> m_averages;
};

} // namespace palmer
