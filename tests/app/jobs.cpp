// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/jobs.h"

#include <QTest>
#include <array>
#include <csignal>
#include <cstdio>
#include <poll.h>
#include <random>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

QByteArray printed; // by the parent, in order

} // namespace

// The one thing that the jobs need of the program.
namespace palmer {
void printOut(const QByteArray &bytes);
void printOut(const QByteArray &bytes) {
    printed += bytes;
}
} // namespace palmer

using namespace palmer;

class JobsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { printed.clear(); }
    void everyInputIsHeardOnceAndInOrder_data();
    void everyInputIsHeardOnceAndInOrder();
    void whatEndsInTheMiddleTakesNothingAlong();
    void answersOfAnySizeComeWhole();
    void oneInputStaysInThisProcess();
    void resultsAreParted();
    void nobodyWorksOnForACommandThatWasEnded();
};

void JobsTest::everyInputIsHeardOnceAndInOrder_data() {
    QTest::addColumn<int>("jobs");
    for (const int jobs : {1, 2, 3, 8, 40})
        QTest::addRow("%d at a time", jobs) << jobs;
}

void JobsTest::everyInputIsHeardOnceAndInOrder() {
    QFETCH(int, jobs);
    constexpr int count = 30;
    std::vector<int> heard;
    QByteArray expected;
    for (int i = 0; i < count; ++i)
        expected += QByteArray::number(i) + '\n';
    eachJob(count, jobs,
            {[](int i) -> JobResult {
                 if (i % 3 == 0)
                     ::usleep(2000); // the others are done earlier
                 std::printf("%d\n", i);
                 return {i % 4, QByteArray("row ") + QByteArray::number(i)};
             },
             [&](int i, const JobResult &result) {
                 heard.push_back(i);
                 QCOMPARE(result.code, i % 4);
                 QCOMPARE(result.rows, QByteArray("row ") + QByteArray::number(i));
             },
             [](int) { return -1; }});
    QCOMPARE(printed, expected);
    QCOMPARE(heard.size(), std::size_t(count));
    for (int i = 0; i < count; ++i)
        QCOMPARE(heard[static_cast<std::size_t>(i)], i);
}

/// Processes that are killed, abort or leave at random: what they had answered counts, the input they were at
/// is said, all others are done.
void JobsTest::whatEndsInTheMiddleTakesNothingAlong() {
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        const int count = 2 + static_cast<int>(random() % 12);
        const int jobs = 1 + static_cast<int>(random() % 4);
        std::vector<int> fate(static_cast<std::size_t>(count));
        for (int &one : fate)
            one = static_cast<int>(random() % 6);
        std::vector<int> codes;
        std::vector<int> said;
        eachJob(count, jobs,
                {[&](int i) -> JobResult {
                     const int one = fate[static_cast<std::size_t>(i)];
                     std::printf("%d.", i);
                     if (one == 0)
                         ::raise(SIGKILL);
                     if (one == 1)
                         ::_exit(0);
                     return {10 + i, {}};
                 },
                 [&](int i, const JobResult &result) {
                     QCOMPARE(i, static_cast<int>(codes.size()));
                     codes.push_back(result.code);
                 },
                 [&](int i) {
                     said.push_back(i);
                     return 3;
                 }});
        QCOMPARE(codes.size(), std::size_t(count));
        for (int i = 0; i < count; ++i) {
            const bool breaks = fate[static_cast<std::size_t>(i)] < 2;
            QCOMPARE(codes[static_cast<std::size_t>(i)], breaks ? 3 : 10 + i);
            QCOMPARE(std::ranges::count(said, i), breaks ? 1 : 0);
        }
    }
}

void JobsTest::answersOfAnySizeComeWhole() {
    constexpr std::array sizes{0, 1, 47, 48, 49, 65535, 65536, 65537, 1 << 20};
    int heard = 0;
    eachJob(static_cast<int>(sizes.size()), 2,
            {[&](int i) -> JobResult {
                 const auto size = sizes.at(static_cast<std::size_t>(i));
                 const QByteArray text(size, static_cast<char>('a' + i));
                 std::fwrite(text.constData(), 1, static_cast<std::size_t>(size), stdout);
                 return {0, text + '.'};
             },
             [&](int i, const JobResult &result) {
                 const QByteArray text(sizes.at(static_cast<std::size_t>(i)), static_cast<char>('a' + i));
                 QVERIFY(result.rows == text + '.');
                 QVERIFY(printed == text);
                 printed.clear();
                 ++heard;
             },
             [](int) { return 3; }});
    QCOMPARE(heard, static_cast<int>(sizes.size()));
}

void JobsTest::oneInputStaysInThisProcess() {
    const pid_t own = ::getpid();
    pid_t worked = -1;
    eachJob(1, 4,
            {[&](int) -> JobResult {
                 worked = ::getpid();
                 return {};
             },
             [](int, const JobResult &) {}, [](int) { return 3; }});
    QCOMPARE(worked, own);
}

void JobsTest::resultsAreParted() {
    Jobs jobs{[](int i) -> JobResult {
                  if (i != 1) // one has nothing to say
                      std::printf("%d\n", i);
                  return {};
              },
              [](int, const JobResult &) {}, [](int) { return 3; }, true};
    eachJob(4, 2, jobs);
    QCOMPARE(printed, QByteArray("0\n\n2\n\n3\n"));
}

void JobsTest::nobodyWorksOnForACommandThatWasEnded() {
    std::array<int, 2> ends{}; // the writing end is open as long as a process has it
    QCOMPARE(::pipe(ends.data()), 0);
    const pid_t command = ::fork();
    if (command == 0) {
        eachJob(2, 2,
                {[&](int) -> JobResult {
                     for (char begun = 'b'; ::write(ends[1], &begun, 1) == 1;)
                         ::sleep(1000);
                     return {};
                 },
                 [](int, const JobResult &) {}, [](int) { return 3; }});
        ::_exit(0);
    }
    ::close(ends[1]);
    char begun = 0;
    for (int workers = 0; workers < 2; ++workers)
        QCOMPARE(::read(ends[0], &begun, 1), ssize_t(1));
    QVERIFY(::kill(command, SIGKILL) == 0 && ::waitpid(command, nullptr, 0) == command);
    pollfd open{ends[0], POLLIN, 0};
    QCOMPARE(::poll(&open, 1, 30'000), 1);
    QCOMPARE(::read(ends[0], &begun, 1), ssize_t(0)); // nobody has it any more
    ::close(ends[0]);
}

QTEST_GUILESS_MAIN(JobsTest)
#include "jobs.moc"
