// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/background.h"

#include <QSemaphore>
#include <QTest>
#include <QThread>
#include <atomic>
#include <optional>
#include <vector>

using palmer::ui::Background;

class BackgroundTest : public QObject {
    Q_OBJECT

private slots:
    void doesJobsInOrderOnAnotherThread();
    void hearsOnTheThreadOfTheWindow();
    void isBusyUntilTheResultIsHeard();
    void hearsWhatAJobTellsBeforeItsResult();
    void leavesOutWhatWasCancelledBeforeItBegan();
    void asksWhatRunsToStopAndHearsNothingOfIt();
    void hearsWhatIsStartedAfterACancel();
    void aCancelledResultThatWaitsToBeHeardIsNotHeard();
    void theEndOfTheLaneCancelsAndWaits();
    void movesResultsThatCannotBeCopied();
};

void BackgroundTest::doesJobsInOrderOnAnotherThread() {
    Background lane;
    std::vector<int> done; // by one thread only: no lock
    std::atomic<bool> onAnother = true;
    int heard = 0;
    for (int i = 0; i < 50; ++i) {
        lane.start(
            [&, i, window = QThread::currentThread()](const Background::Job &) {
                onAnother = onAnother && QThread::currentThread() != window;
                done.push_back(i);
            },
            [&] { ++heard; });
    }
    lane.wait();
    QCOMPARE(heard, 0);
    QTRY_COMPARE(heard, 50);
    QVERIFY(onAnother);
    for (int i = 0; i < 50; ++i)
        QCOMPARE(done[static_cast<std::size_t>(i)], i);
}

void BackgroundTest::hearsOnTheThreadOfTheWindow() {
    Background lane;
    QThread *told = nullptr;
    QThread *heard = nullptr;
    lane.start([&](const Background::Job &job) { job.post([&] { told = QThread::currentThread(); }); },
               [&] { heard = QThread::currentThread(); });
    QTRY_COMPARE(heard, QThread::currentThread());
    QCOMPARE(told, QThread::currentThread());
}

void BackgroundTest::isBusyUntilTheResultIsHeard() {
    Background lane;
    QVERIFY(!lane.isBusy());
    std::optional<bool> busyWhenHeard;
    lane.start([](const Background::Job &) { return 7; },
               [&](int result) {
                   QCOMPARE(result, 7);
                   busyWhenHeard = lane.isBusy();
               });
    QVERIFY(lane.isBusy());
    lane.wait();
    QVERIFY(lane.isBusy()); // done, not heard
    QTRY_VERIFY(busyWhenHeard.has_value());
    QVERIFY(!*busyWhenHeard);
}

void BackgroundTest::hearsWhatAJobTellsBeforeItsResult() {
    Background lane;
    QStringList heard;
    lane.start(
        [&](const Background::Job &job) {
            for (const char *half : {"first half", "second half"})
                job.post([&heard, half] { heard += QString::fromLatin1(half); });
            return QStringLiteral("whole");
        },
        [&](const QString &result) { heard += result; });
    QTRY_COMPARE(heard.size(), 3);
    QCOMPARE(heard, QStringList({QStringLiteral("first half"), QStringLiteral("second half"),
                                 QStringLiteral("whole")}));
}

void BackgroundTest::leavesOutWhatWasCancelledBeforeItBegan() {
    Background lane;
    QSemaphore begun;
    QSemaphore goOn;
    std::atomic<int> done = 0;
    int heard = 0;
    const auto hear = [&] { ++heard; };
    lane.start(
        [&](const Background::Job &) {
            begun.release();
            goOn.acquire();
        },
        hear);
    lane.start([&](const Background::Job &) { ++done; }, hear);
    begun.acquire();
    lane.cancel();
    QVERIFY(!lane.isBusy());
    goOn.release();
    lane.wait();
    QCoreApplication::processEvents();
    QCOMPARE(done.load(), 0);
    QCOMPARE(heard, 0);
}

void BackgroundTest::asksWhatRunsToStopAndHearsNothingOfIt() {
    Background lane;
    QSemaphore begun;
    bool heard = false;
    lane.start(
        [&](const Background::Job &job) {
            job.post([&] { heard = true; }); // waits to be heard when the job is cancelled
            begun.release();
            while (!job.stop().stop_requested())
                QThread::yieldCurrentThread();
            job.post([&] { heard = true; });
        },
        [&] { heard = true; });
    begun.acquire();
    lane.cancel();
    lane.wait();
    QCoreApplication::processEvents();
    QVERIFY(!heard);
}

void BackgroundTest::hearsWhatIsStartedAfterACancel() {
    Background lane;
    QList<int> heard;
    for (int i = 1; i <= 5; ++i) {
        lane.cancel();
        lane.start([i](const Background::Job &) { return i; }, [&](int result) { heard += result; });
    }
    QVERIFY(lane.isBusy());
    QTRY_VERIFY(!lane.isBusy());
    QCOMPARE(heard, QList<int>({5})); // the latest alone
}

void BackgroundTest::aCancelledResultThatWaitsToBeHeardIsNotHeard() {
    Background lane;
    bool heard = false;
    lane.start([](const Background::Job &) {}, [&] { heard = true; });
    lane.wait();
    lane.cancel();
    QVERIFY(!lane.isBusy());
    QCoreApplication::processEvents();
    QVERIFY(!heard);
    QVERIFY(!lane.isBusy());
}

void BackgroundTest::theEndOfTheLaneCancelsAndWaits() {
    std::atomic<bool> ended = false;
    bool heard = false;
    {
        Background lane;
        QSemaphore begun;
        lane.start(
            [&](const Background::Job &job) {
                begun.release();
                while (!job.stop().stop_requested())
                    QThread::yieldCurrentThread();
                ended = true;
            },
            [&] { heard = true; });
        begun.acquire();
    }
    QVERIFY(ended);
    QCoreApplication::processEvents();
    QVERIFY(!heard);
}

void BackgroundTest::movesResultsThatCannotBeCopied() {
    Background lane;
    std::unique_ptr<int> heard;
    lane.start([](const Background::Job &) { return std::make_unique<int>(3); },
               [&](std::unique_ptr<int> result) { heard = std::move(result); });
    QTRY_VERIFY(heard);
    QCOMPARE(*heard, 3);
}

QTEST_GUILESS_MAIN(BackgroundTest)
#include "backgroundtest.moc"
