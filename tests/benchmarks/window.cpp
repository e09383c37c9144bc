// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "longestturn.h"

#include "document/savedocument.h"
#include "document/writedocument.h"
#include "editing/editreadings.h"
#include "ui/circles.h"
#include "ui/circles/arccurvesview.h"
#include "ui/dialogs/reportdialog.h"
#include "ui/examples.h"
#include "ui/figures/circlecanvas.h"
#include "ui/figures/figurecanvas.h"
#include "ui/figures/figureview.h"
#include "ui/import/importassistant.h"
#include "ui/readings/readingspage.h"
#include "ui/readings/targetcard.h"
#include "ui/results/explanationcard.h"
#include "ui/results/findingspanel.h"
#include "ui/results/resultspanel.h"
#include "ui/window/mainwindow.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QEventLoop>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <functional>

using namespace palmer;
using namespace palmer::ui;

namespace {

/// The parts of the window that follow the pointer, as large as in a window of 1 600 × 1 000.
class Parts {
public:
    explicit Parts(const EvaluatedDocument &evaluated)
        : m_evaluated(evaluated) {
        auto *columns = new QHBoxLayout(&m_window);
        auto *left = new QVBoxLayout;
        auto *right = new QVBoxLayout;
        columns->addLayout(left);
        columns->addLayout(right);
        left->addWidget(&m_readings, 1);
        left->addWidget(&m_card);
        right->addWidget(&m_figure, 1);
        right->addWidget(&m_results);
        right->addWidget(&m_findings);
        m_window.resize(1416, 870);
    }

    void show() {
        m_readings.show(m_evaluated, 0);
        m_card.show(m_evaluated, 0);
        m_figure.show(m_evaluated, 0);
        m_results.show(m_evaluated, 0);
        m_findings.show(m_evaluated, 0);
        m_window.show();
        paint();
        auto *canvas = m_figure.findChild<FigureCanvas *>();
        while (!canvas->placeOf({0, 0})) // the figure of a large test is made in the background
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        paint();
    }

    /// Everything that waits to be painted is painted.
    static void paint() {
        QApplication::processEvents();
        QApplication::sendPostedEvents();
        QApplication::processEvents();
    }

    void moveOver(const ReadingPlace &reading) {
        auto *canvas = m_figure.findChild<FigureCanvas *>();
        if (const auto at = canvas->placeOf(reading)) {
            QMouseEvent event(QEvent::MouseMove, *at, canvas->mapToGlobal(*at), Qt::NoButton, Qt::NoButton,
                              Qt::NoModifier);
            QApplication::sendEvent(canvas, &event);
        }
    }

    void press(int key) {
        QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
        QApplication::sendEvent(m_figure.findChild<FigureCanvas *>(), &event);
    }

    void scroll(int by) {
        auto *bar = m_readings.findChild<QTableView *>(QStringLiteral("readings"))->verticalScrollBar();
        bar->setValue(bar->value() + by > bar->maximum() ? 0 : bar->value() + by);
    }

    void page(bool down) {
        QKeyEvent event(QEvent::KeyPress, down ? Qt::Key_PageDown : Qt::Key_PageUp, Qt::NoModifier);
        QApplication::sendEvent(m_readings.findChild<QTableView *>(QStringLiteral("readings")), &event);
    }

private:
    EvaluatedDocument m_evaluated;
    DocumentModel m_model;
    Selection m_selection;
    QWidget m_window;
    ReadingsPage m_readings{m_model, m_selection};
    TargetCard m_card{m_selection};
    FigureView m_figure{m_selection};
    ResultsPanel m_results{m_selection};
    FindingsPanel m_findings{m_selection};
};

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point from) {
    return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

Test largeTest(int readings, int targets = 1000) {
    const int runs = readings / targets / 2; // each way
    std::vector<double> positions;
    std::vector<std::vector<double>> up(static_cast<std::size_t>(runs));
    std::vector<std::vector<double>> down(static_cast<std::size_t>(runs));
    for (int i = 0; i < targets; ++i) {
        positions.push_back(6.006006 * i);
        for (int j = 0; j < runs; ++j) {
            up[static_cast<std::size_t>(j)].push_back(0.0017 * ((i * 37 + j * 101) % 5113) - 5);
            down[static_cast<std::size_t>(j)].push_back(0.0013 * ((i * 53 + j * 71) % 4097) - 3);
        }
    }
    return testdata::positioningTest("ISO 230-2:2006", positions, up, down);
}

/// Times a frame each: what `change` does and its painting, in processor time.
void frames(benchmark::State &state, const Test &test, const std::function<void(Parts &)> &change) {
    Parts parts(testdata::evaluatedDocument(test));
    parts.show();
    double longest = 0;
    for (auto _ : state) {
        const double before = benchmarks::processorTime();
        change(parts);
        Parts::paint();
        longest = std::max(longest, benchmarks::processorTime() - before);
    }
    state.counters["longest_frame_ms"] = longest;
}

/// Goal: no frame above 16 ms.
void hoverOverLargeTest(benchmark::State &state) {
    frames(state, testdata::largeTest(), [target = std::size_t(0)](Parts &parts) mutable {
        parts.moveOver({3, target++ % 400});
    });
}
BENCHMARK(hoverOverLargeTest)->Iterations(400)->Unit(benchmark::kMillisecond);

/// Goal: no frame above 16 ms.
void scrollLargeTest(benchmark::State &state) {
    frames(state, testdata::largeTest(), [](Parts &parts) { parts.scroll(47); });
}
BENCHMARK(scrollLargeTest)->Iterations(400)->Unit(benchmark::kMillisecond);

/// PageDown and PageUp in a table of 10⁴ columns. Goal: no frame above 16 ms.
void pageThroughColumns(benchmark::State &state) {
    frames(state, largeTest(1'000'000, 100), [down = true](Parts &parts) mutable {
        parts.page(down);
        down = !down;
    });
}
BENCHMARK(pageThroughColumns)->Iterations(100)->Unit(benchmark::kMillisecond);

/// A frame of zooming, where the figure is drawn anew. Goal: no frame above 16 ms.
void zoomLargeTest(benchmark::State &state) {
    frames(state, largeTest(static_cast<int>(state.range(0))), [in = true](Parts &parts) mutable {
        parts.press(in ? Qt::Key_Plus : Qt::Key_Minus);
        in = !in;
    });
}
BENCHMARK(zoomLargeTest)->Arg(80'000)->Arg(1'000'000)->Iterations(40)->Unit(benchmark::kMillisecond);

/// Until the window has nothing to do any more.
void resolve(MainWindow &window) {
    const auto isMaking = [](const auto &views) {
        return std::ranges::any_of(views, [](const auto *view) { return view->isMaking(); });
    };
    while (window.evaluator().isBusy() || isMaking(window.findChildren<CircleCanvas *>()) ||
           isMaking(window.findChildren<ArcCurvesView *>()))
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    Parts::paint();
}

/// Goal: 16 ms from a reading typed to results and figure of 11 × 5 × 2 painted, in the whole window; 20 ms
/// of processor time among 1 000 such tests.
void editExample(benchmark::State &state) {
    QStandardPaths::setTestModeEnabled(true);
    auto *window = new MainWindow;
    window->resize(1280, 800);
    window->show();
    window->openFile(QStringLiteral(":/examples/iso230-2-1988-example.palmer"));
    window->model().edit("prepare", [&](Document &document) {
        const std::vector first = document.tests;
        document.tests.assign(static_cast<std::size_t>(state.range(0)), first[0]);
    });
    resolve(*window);
    double longest = 0;
    int number = 0;
    for (auto _ : state) {
        const double before = benchmarks::processorTime();
        window->model().edit("type a reading", [&](Document &document) {
            editReadings(document, 0, [&](PositioningMeasurement &m) {
                setReading(m, {3, 4}, 1e-4 * (++number % 100));
            });
        });
        Parts::paint();
        longest = std::max(longest, benchmarks::processorTime() - before);
    }
    state.counters["longest_ms"] = longest;
    delete window;
}
BENCHMARK(editExample)->Arg(1)->Arg(1000)->Iterations(200)->Unit(benchmark::kMillisecond);

/// Goal: 100 ms from another evaluated range to results and figure of a circle of 10⁵ points painted, in the
/// whole window, and none of it keeps the window from its user for more than 50 ms.
void editCircle(benchmark::State &state) {
    QStandardPaths::setTestModeEnabled(true);
    auto *window = new MainWindow;
    window->resize(1280, 800);
    window->show();
    window->openFile(QStringLiteral(":/examples/iso230-4-full-circles-xy.palmer"));
    if (!window->hasDocument()) {
        state.SkipWithError("no example of a circle");
        return;
    }
    const auto large = std::make_shared<const Test>(testdata::longPair(static_cast<int>(state.range(0)) / 2));
    window->model().edit("prepare", [&](Document &document) { document.tests = {large}; });
    resolve(*window);
    const benchmarks::LongestTurn turns;
    double longest = 0;
    int number = 0;
    for (auto _ : state) {
        const auto from = Clock::now();
        window->model().edit("change the range", [&](Document &document) {
            auto test = std::make_shared<Test>(*document.tests[0]);
            std::get<CircularMeasurement>(test->measurement).arcs[0].evaluated =
                Interval{1.0 + 0.1 * (++number % 10), 359};
            document.tests[0] = std::move(test);
        });
        resolve(*window);
        longest = std::max(longest, milliseconds(from));
    }
    state.counters["longest_ms"] = longest;
    state.counters["longest_turn_ms"] = turns.longest();
    delete window;
}
BENCHMARK(editCircle)->Arg(100'000)->Arg(1'000'000)->Iterations(20)->Unit(benchmark::kMillisecond);

QByteArray testFileOf(const Test &test) {
    Document document;
    document.tests.push_back(std::make_shared<const Test>(test));
    return writeDocument(document);
}

QByteArray millionLines() {
    QByteArray text = "P mm;run;direction;deviation µm\n";
    for (int j = 1; j <= 500; ++j)
        for (const char *direction : {"+", "-"})
            for (int i = 0; i < 1000; ++i)
                text += QByteArray::number(i) + ';' + QByteArray::number(j) + ';' + direction + ';' +
                        QByteArray::number(0.01 * ((i * 37 + j * 101) % 1113), 'f', 2) + '\n';
    return text;
}

/// A file that is read beside the window, until all that is seen of it is painted. Goal: no turn above 50 ms.
void openLarge(benchmark::State &state, const QByteArray &bytes, const QString &ending) {
    QStandardPaths::setTestModeEnabled(true);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.") + ending);
    saveBytes(bytes, path);
    double longest = 0;
    for (auto _ : state) {
        state.PauseTiming();
        auto *window = new MainWindow;
        window->resize(1280, 800);
        window->show();
        Parts::paint();
        state.ResumeTiming();
        const benchmarks::LongestTurn turns;
        window->openFile(path);
        const QDialog *assistant = nullptr;
        while (!window->hasDocument() && !assistant) {
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
            assistant = window->findChild<ImportAssistant *>();
        }
        resolve(*window);
        QEventLoop later; // what a window does when there is time
        QTimer::singleShot(1000, &later, &QEventLoop::quit);
        later.exec();
        longest = std::max(longest, turns.longest());
        state.PauseTiming();
        delete window;
        state.ResumeTiming();
    }
    state.counters["longest_turn_ms"] = longest;
}

void openLargeTest(benchmark::State &state) {
    openLarge(state, testFileOf(largeTest(static_cast<int>(state.range(0)))), QStringLiteral("palmer"));
}
BENCHMARK(openLargeTest)->Arg(1'000'000)->Arg(3'000'000)->Iterations(5)->Unit(benchmark::kMillisecond);

void openLargeCircle(benchmark::State &state) {
    openLarge(state, testFileOf(testdata::longPair(500'000)), QStringLiteral("palmer"));
}
BENCHMARK(openLargeCircle)->Iterations(5)->Unit(benchmark::kMillisecond);

void importLargeTable(benchmark::State &state) {
    openLarge(state, millionLines(), QStringLiteral("csv"));
}
BENCHMARK(importLargeTable)->Iterations(5)->Unit(benchmark::kMillisecond);

/// Closes each window that opens beside that one, once it has been shown for a while.
class Closer : public QObject {
public:
    explicit Closer(const MainWindow &window)
        : m_window(window) {
        startTimer(50);
    }
    [[nodiscard]] QList<QWidget *> open() const {
        QList<QWidget *> found;
        for (QWidget *widget : QApplication::topLevelWidgets()) {
            if (widget != &m_window && widget->isVisible() && !qobject_cast<QMenu *>(widget))
                found << widget;
        }
        return found;
    }

private:
    /// Closes the upper one first where two are modal.
    void timerEvent(QTimerEvent *) override {
        constexpr int looks = 8;
        QWidget *modal = QApplication::activeModalWidget();
        const QList<QWidget *> all = open();
        QWidget *next = modal ? modal : all.value(0);
        m_looks = next && next == m_seen ? m_looks + 1 : 0;
        m_seen = next;
        if (m_looks >= looks)
            next->close();
    }

    const MainWindow &m_window;
    const QWidget *m_seen = nullptr;
    int m_looks = 0;
};

/// Every action of the menus, with all that follows until the window rests and what opened is closed. 0
/// tests: one of 10⁶ readings. Goal: no turn above 100 ms.
void actionTurns(benchmark::State &state) {
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    constexpr int million = 1'000'000;
    const auto count = static_cast<std::size_t>(state.range(0));
    Document document;
    document.tests.assign(
        std::max<std::size_t>(count, 1),
        std::make_shared<const Test>(count == 0 ? largeTest(million) : testdata::decidedExample()));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("actions.palmer"));
    saveBytes(writeDocument(document), path);
    for (auto _ : state) {
        auto *window = new MainWindow;
        window->resize(1280, 800);
        window->show();
        window->openFile(path);
        while (!window->hasDocument())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        resolve(*window);
        const Closer closer(*window);
        const auto rest = [&] {
            QEventLoop later;
            QTimer::singleShot(100, &later, &QEventLoop::quit);
            later.exec();
            resolve(*window);
            while (!closer.open().isEmpty())
                QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        };
        auto *undo = window->findChild<QAction *>(QStringLiteral("undo"));
        double longest = 0;
        double edited = 0;
        double undone = 0;
        QStringList slow;
        int tried = 0;
        for (QAction *action : window->findChildren<QAction *>()) {
            const QString name = action->objectName();
            if (name.isEmpty() || action->menu() || name == u"quit" || name == u"close")
                continue;
            {
                const benchmarks::LongestTurn turns;
                window->model().edit("title", [](Document &changed) {
                    auto test = std::make_shared<Test>(*changed.tests[0]);
                    test->title += ".";
                    changed.tests[0] = std::move(test);
                });
                resolve(*window);
                edited = std::max(edited, turns.longest());
            }
            if (name == u"redo")
                undo->trigger();
            if (!action->isEnabled())
                continue;
            ++tried;
            double turn = 0;
            {
                const benchmarks::LongestTurn turns;
                action->trigger();
                rest();
                turn = turns.longest();
            }
            undone = name == u"undo" ? turn : undone;
            longest = std::max(longest, turn);
            constexpr double worthSaying = 50;
            if (turn > worthSaying)
                slow << QStringLiteral("%1 %2").arg(name).arg(turn, 0, 'f', 0);
            if (name == u"maximiseFigure")
                action->trigger();
            while (undo->isEnabled())
                undo->trigger();
            resolve(*window);
        }
        state.counters["actions"] = tried;
        state.counters["longest_turn_ms"] = longest;
        state.counters["edit_ms"] = edited;
        state.counters["undo_ms"] = undone;
        state.SetLabel(slow.join(QStringLiteral(", ")).toStdString());
        delete window;
    }
}
BENCHMARK(actionTurns)->Arg(1)->Arg(100)->Arg(1000)->Arg(0)->Iterations(1)->Unit(benchmark::kSecond);

/// The report dialog: ms until the first page is there, and until all are, after it is opened, after a
/// section is left out, in another language, and after these choices are taken back. Goals: 200 ms to the
/// first page of 1 000 tests, 300 ms after a choice with 300.
void chooseInReport(benchmark::State &state) {
    QStandardPaths::setTestModeEnabled(true);
    DocumentModel model;
    Document document;
    document.tests.assign(static_cast<std::size_t>(state.range(0)),
                          std::make_shared<const Test>(testdata::decidedExample()));
    model.setDocument(std::move(document), {});
    Evaluator evaluator;
    evaluator.setDocument(model.document());
    QObject::connect(&model, &DocumentModel::changed, &evaluator,
                     [&] { evaluator.setDocument(model.document()); });
    while (evaluator.isBusy())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    for (auto _ : state) {
        ReportDialog dialog(model, evaluator);
        const auto measure = [&](const char *name, const std::function<void()> &act) {
            const auto from = Clock::now();
            const int before = dialog.pageCount(); // that of the first page is another
            act();
            while (dialog.pageCount() == before && dialog.isComposing())
                QApplication::processEvents(QEventLoop::WaitForMoreEvents);
            state.counters[std::string(name) + "_first"] = milliseconds(from);
            while (dialog.isComposing())
                QApplication::processEvents(QEventLoop::WaitForMoreEvents);
            state.counters[std::string(name) + "_all"] = milliseconds(from);
        };
        const auto click = [&](const char *name) {
            return [&dialog, name] { dialog.findChild<QAbstractButton *>(QLatin1StringView(name))->click(); };
        };
        measure("open", [&] { dialog.show(); });
        measure("section", click("partReadings"));
        measure("language", click("reportEnglish"));
        measure("back", [&] { model.undoStack()->undo(); });
    }
}
BENCHMARK(chooseInReport)->Arg(100)->Arg(300)->Arg(1000)->Iterations(1)->Unit(benchmark::kSecond);

/// Goal: 100 ms from the document to the finished figure.
void showExample(benchmark::State &state) {
    const Test test = testdata::decidedExample();
    for (auto _ : state) {
        Parts parts(testdata::evaluatedDocument(test));
        parts.show();
    }
}
BENCHMARK(showExample)->Unit(benchmark::kMillisecond);

} // namespace
