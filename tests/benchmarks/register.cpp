// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "register/register.h"
#include "register/due.h"
#include "register/machinetrend.h"
#include "register/queries.h"
#include "register/registeredtest.h"
#include "register/scan.h"
#include "register/writer.h"
#include "ui/register/registerservice.h"
#include "ui/register/registerwindow.h"
#include "ui/window/shownwindow.h"

#include <QAbstractItemView>
#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <benchmark/benchmark.h>

namespace {

using namespace palmer;

constexpr int files = 10'000;
constexpr int tests100k = 100'000;

/// The files of the script, made once.
const QString &folder() {
    static const QTemporaryDir dir;
    static const QString path = [] {
        QProcess::execute(QStringLiteral("python3"),
                          {QStringLiteral(PALMER_SOURCE_DIR "/tests/benchmarks/registerfiles.py"), dir.path(),
                           QStringLiteral("--files"), QString::number(files)});
        return dir.path();
    }();
    return path;
}

/// 10 000 files of 11 × 5 × 2 from cold. Goal: 20 s.
void registerScan(benchmark::State &state) {
    const QTemporaryDir dir;
    (void)folder();
    for (auto _ : state) {
        Register reg(dir.filePath(QStringLiteral("cold.sqlite")), Register::Open::rebuild);
        benchmark::DoNotOptimize(scan(reg, {folder()}));
    }
    Register reg(dir.filePath(QStringLiteral("cold.sqlite")));
    const auto pages = reg.database().first(QStringLiteral("pragma page_count"))->toDouble();
    const auto page = reg.database().first(QStringLiteral("pragma page_size"))->toDouble();
    state.counters["bytes/test"] = pages * page / files;
}
BENCHMARK(registerScan)->Name("RegisterScan")->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();

/// The same again, unchanged. Goal: 1 s.
void registerScanUnchanged(benchmark::State &state) {
    const QTemporaryDir dir;
    Register reg(dir.filePath(QStringLiteral("warm.sqlite")));
    (void)scan(reg, {folder()});
    for (auto _ : state)
        benchmark::DoNotOptimize(scan(reg, {folder()}));
}
BENCHMARK(registerScanUnchanged)->Name("RegisterScanUnchanged")->Unit(benchmark::kMillisecond)->UseRealTime();

QString addressOfLarge() {
    static const QTemporaryDir dir;
    return dir.filePath(QStringLiteral("large.sqlite"));
}

/// A register of 100 000 tests of 300 machines, made from one file.
Database &large() {
    static Register &reg = *new Register(addressOfLarge()); // lives to the end
    static const bool isFilled = [] {
        const QTemporaryDir dir;
        Register small(dir.filePath(QStringLiteral("small.sqlite")));
        const QString first = QDir(folder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).constFirst();
        (void)scan(small, {folder() + u'/' + first});
        const RegisteredTest sample = tests(small.database(), {}).front().test;
        RegisterWriter writer(reg.database());
        Transaction transaction(reg.database());
        writer.begin();
        for (int i = 0; i < tests100k; ++i) {
            RegisteredTest test = sample;
            test.serialNumber = std::to_string(i % 300);
            test.machineName = "Machine " + test.serialNumber;
            test.axis = std::string(1, static_cast<char>('X' + i / 300 % 3));
            test.date = QDate(2016, 1, 1).addDays(i / 30).toString(Qt::ISODate).toStdString();
            test.results.front().value = 0.009 + 1e-6 * (i % 977);
            test.digest = QString::number(i);
            test.fingerprint = test.digest;
            writer.put(
                {0, QStringLiteral("/f/%1.palmer").arg(i), 0, 0, {}, {}, sourceWord(SourceState::read), {}},
                {test});
        }
        writer.finish();
        transaction.commit();
        return true;
    }();
    benchmark::DoNotOptimize(isFilled);
    return reg.database();
}

/// The tests of a machine and axis among 100 000. Goal: 50 ms.
void registerList(benchmark::State &state) {
    Database &database = large();
    TestFilter filter;
    filter.machines = {machines(database).front().id};
    filter.axis = QStringLiteral("X");
    for (auto _ : state)
        benchmark::DoNotOptimize(tests(database, filter));
}
BENCHMARK(registerList)->Name("RegisterList")->Unit(benchmark::kMillisecond);

/// The trend of one axis of it. Goal: 20 ms.
void registerTrend(benchmark::State &state) {
    Database &database = large();
    TestFilter filter;
    filter.machines = {machines(database).front().id};
    filter.axis = QStringLiteral("X");
    const auto list = tests(database, filter);
    for (auto _ : state)
        benchmark::DoNotOptimize(machineTrend(list, "A"));
}
BENCHMARK(registerTrend)->Name("RegisterTrend")->Unit(benchmark::kMillisecond);

/// What the window reads before it is shown: machines, states of their axes, what is due. Goal: 150 ms.
void registerMachines(benchmark::State &state) {
    Database &database = large();
    for (auto _ : state) {
        const auto list = machines(database);
        benchmark::DoNotOptimize(axisStates(database));
        benchmark::DoNotOptimize(dueDates(database, list));
    }
}
BENCHMARK(registerMachines)->Name("RegisterMachines")->Unit(benchmark::kMillisecond);

/// The window of it, from its making to machines, tests and trend painted. Goal: 150 ms.
void registerWindow(benchmark::State &state) {
    (void)large();
    prepareApplication();
    ui::RegisterService service(addressOfLarge(), {});
    for (auto _ : state) {
        ui::RegisterWindow window(service);
        window.show();
        while (!window.isQuiet())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QApplication::processEvents();
        QApplication::sendPostedEvents();
        QApplication::processEvents();
        if (window.findChild<QAbstractItemView *>(QStringLiteral("tests"))->model()->rowCount() == 0)
            state.SkipWithError("no test is shown");
    }
}
BENCHMARK(registerWindow)->Name("RegisterWindow")->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
