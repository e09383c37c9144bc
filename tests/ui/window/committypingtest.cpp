// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "document/edits.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "editing/newtest.h"
#include "ui/dialogs/reportdialog.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QUndoStack>
#include <functional>

using namespace palmer;
using namespace palmer::ui;

namespace {

/// One test of each kind.
Document everyKind() {
    Document document;
    insertTest(document, 0, testdata::example1988("ISO 230-2:1988"));
    Test circles = *openDocument(examplePath("iso230-4-full-circles-xy")).tests.at(0);
    circles.instruments.clear(); // of another file
    for (Arc &arc : std::get<CircularMeasurement>(circles.measurement).arcs) {
        constexpr std::size_t step = 50; // few points do, and are drawn in each of two hundred windows
        const std::size_t points = arc.angles.size() / step;
        for (std::size_t i = 0; i < points; ++i) {
            arc.angles[i] = arc.angles[i * step];
            arc.radialDeviations[i] = arc.radialDeviations[i * step];
        }
        arc.angles.resize(points);
        arc.radialDeviations.resize(points);
        arc.sampleInterval = std::nullopt;
    }
    insertTest(document, 1, circles);
    Test drift = newDriftTest(Axis());
    auto &readings = std::get<DriftMeasurement>(drift.measurement);
    readings.times = {0, 60, 120};
    readings.deviations = {0, 0.001, 0.002};
    insertTest(document, 2, drift);
    return document;
}

template <class Measurement>
const Measurement &of(const Document &document, std::size_t test) {
    return std::get<Measurement>(document.tests.at(test)->measurement);
}

/// A cell or field that something can be typed in, and whether the document has what was typed.
struct Place {
    const char *name;
    std::size_t test;
    Page page;
    const char *widget; ///< table or field
    int row, column;    ///< −1: a field
    const char *typed;
    std::function<bool(const Document &)> isTaken;
};

const std::vector<Place> &places() {
    static const std::vector<Place> all{
        {"reading", 0, Page::readings, "readings", 2, 3, "7.25",
         [](const Document &d) {
             return of<PositioningMeasurement>(d, 0).runs.at(1).deviations.at(2) == 0.00725;
         }},
        {"target", 0, Page::readings, "readings", 2, 1, "310.5",
         [](const Document &d) { return of<PositioningMeasurement>(d, 0).targets.at(2) == 310.5; }},
        {"reading that is no number", 0, Page::readings, "readings", 2, 3, "4,,8",
         [](const Document &d) {
             const auto &refused = of<PositioningMeasurement>(d, 0).refused;
             return refused.size() == 1 && refused[0].text == "4,,8";
         }},
        {"angle of a point", 1, Page::readings, "points", 0, 1, "0.05",
         [](const Document &d) { return of<CircularMeasurement>(d, 1).arcs.at(0).angles.at(0) == 0.05; }},
        {"deviation of a point", 1, Page::readings, "points", 3, 2, "1.25",
         [](const Document &d) {
             return of<CircularMeasurement>(d, 1).arcs.at(0).radialDeviations.at(3) == 0.00125;
         }},
        {"nominal radius", 1, Page::readings, "nominalRadius", -1, -1, "151.25",
         [](const Document &d) { return of<CircularMeasurement>(d, 1).nominalRadius == 151.25; }},
        {"contouring feed", 1, Page::readings, "contouringFeed", -1, -1, "1234",
         [](const Document &d) { return of<CircularMeasurement>(d, 1).feed == 1234; }},
        {"evaluated range", 1, Page::readings, "evaluatedFrom", -1, -1, "12.5",
         [](const Document &d) {
             const auto &range = of<CircularMeasurement>(d, 1).arcs.at(0).evaluated;
             return range && range->from == 12.5;
         }},
        {"time of drift", 2, Page::readings, "driftReadings", 1, 0, "61",
         [](const Document &d) { return of<DriftMeasurement>(d, 2).times.at(1) == 61; }},
        {"deviation of drift", 2, Page::readings, "driftReadings", 1, 1, "5.5",
         [](const Document &d) { return of<DriftMeasurement>(d, 2).deviations.at(1) == 0.0055; }},
        {"condition", 0, Page::conditions, "airHumidity", -1, -1, "44.5",
         [](const Document &d) { return of<PositioningMeasurement>(d, 0).conditions.airHumidity == 44.5; }},
    };
    return all;
}

/// Answers every question that comes up, each by its name; remembers which came.
class Answers : public QObject {
public:
    explicit Answers(QString path)
        : m_path(std::move(path)) {
        again();
    }
    QStringList asked;
    std::function<void(const ReportDialog &)> lookAt;

private:
    /// A timer of its own each time: one that repeats is silent while a box asks from within an answer.
    void again() { QTimer::singleShot(20, this, &Answers::answer); }

    void answer() {
        again();
        QWidget *box = QApplication::activeModalWidget();
        if (!box)
            return;
        asked << box->objectName();
        if (auto *file = qobject_cast<QFileDialog *>(box); file && m_path.isEmpty()) {
            file->reject(); // what is exported is tested elsewhere
        } else if (file) {
            // A file that is selected in the list wins over a name that is only set, not typed.
            file->findChild<QAbstractItemView *>("listView")->selectionModel()->clear();
            file->findChild<QLineEdit *>("fileNameEdit")->setText(m_path);
            QMetaObject::invokeMethod(file, "accept");
        } else if (auto *question = qobject_cast<QMessageBox *>(box)) {
            for (const auto button : {QMessageBox::Save, QMessageBox::Discard}) {
                if (question->button(button))
                    return question->button(button)->click();
            }
        } else if (auto *report = qobject_cast<ReportDialog *>(box)) {
            if (lookAt)
                lookAt(*report);
            report->reject();
        } else if (auto *dialog = qobject_cast<QDialog *>(box)) {
            dialog->reject();
        }
    }

    QString m_path;
};

struct Action {
    const char *name;
    std::function<void(const ShownWindow &)> act;
    bool saves;
    bool closes;
};

void press(const ShownWindow &shown, Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(shown.window->windowHandle(), key, modifiers); // as the system delivers it
}

const std::vector<Action> &actions() {
    static const auto menu = [](const char *name) {
        return [name](const ShownWindow &shown) { shown.find<QAction>(name)->trigger(); };
    };
    static const std::vector<Action> all{
        {"Ctrl+S", [](const ShownWindow &s) { press(s, Qt::Key_S, Qt::ControlModifier); }, true, false},
        {"Save as",
         [](const ShownWindow &s) { press(s, Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier); }, true,
         false},
        {"the button Save",
         [](const ShownWindow &s) { QTest::mouseClick(s.find<QToolButton>("saveButton"), Qt::LeftButton); },
         true, false},
        {"Ctrl+W", [](const ShownWindow &s) { press(s, Qt::Key_W, Qt::ControlModifier); }, true, true},
        {"Ctrl+Q", [](const ShownWindow &s) { press(s, Qt::Key_Q, Qt::ControlModifier); }, true, true},
        {"the cross of the window", [](const ShownWindow &s) { s.window->close(); }, true, true},
        {"the report", [](const ShownWindow &s) { press(s, Qt::Key_P, Qt::ControlModifier); }, false, false},
        {"export of readings", menu("exportReadings"), false, false},
        {"export of the figure", menu("exportFigure"), false, false},
        {"the figure copied",
         [](const ShownWindow &s) { QTest::mouseClick(s.find<QToolButton>("copyFigure"), Qt::LeftButton); },
         false, false},
        {"the next test", menu("nextTest"), false, false},
        {"the next test by key",
         [](const ShownWindow &s) { press(s, Qt::Key_PageDown, Qt::ControlModifier); }, false, false},
        {"the test before by key",
         [](const ShownWindow &s) { press(s, Qt::Key_PageUp, Qt::ControlModifier); }, false, false},
        {"another page by key", [](const ShownWindow &s) { press(s, Qt::Key_4, Qt::ControlModifier); }, false,
         false},
        {"another page by its tab",
         [](const ShownWindow &s) {
             auto *tabs = s.find<QTabBar>("pageTabs");
             QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(3).center());
         },
         false, false},
        {"a page of the report", [](const ShownWindow &s) { s.window->workplace().showPage(Page::machine); },
         false, false},
        {"another edition",
         [](const ShownWindow &s) {
             auto *edition = s.find<QComboBox>("edition");
             QTest::mouseClick(edition, Qt::LeftButton);
             QTest::keyClick(edition->view(), Qt::Key_Down);
             QTest::keyClick(edition->view(), Qt::Key_Return);
         },
         false, false},
    };
    return all;
}

} // namespace

/// What is still in its editor is part of the document before anything is done with that.
class CommitTypingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }

    void everywhere_data() {
        QTest::addColumn<std::size_t>("place");
        QTest::addColumn<std::size_t>("action");
        // A window for each pair takes long: a third of them, in which each place and each action occurs, or
        // all.
        const bool all = qEnvironmentVariableIsSet("PALMER_ALL");
        for (std::size_t i = 0; i < places().size(); ++i) {
            for (std::size_t k = 0; k < actions().size(); ++k) {
                if (!all && (i + k) % 3 != 0)
                    continue;
                const QString action = actions()[k].name;
                // The drift test is the last one, with one page and no edition.
                if (places()[i].test == 2 && (action.startsWith("the next") || action.startsWith("another")))
                    continue;
                QTest::addRow("%s, %s", places()[i].name, actions()[k].name) << i << k;
            }
        }
    }

    void everywhere() {
        QFETCH(std::size_t, place);
        QFETCH(std::size_t, action);
        const Place &typed = places()[place];
        const Action &done = actions()[action];
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        saveDocument(everyKind(), path);
        const ShownWindow shown(path);
        QVERIFY2(shown.window->hasDocument(), qPrintable(whyNot()));
        shown.window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        type(shown, typed);
        const QPointer<MainWindow> window = shown.window;
        const QString name = done.name;
        Answers answers(name.startsWith("export") ? QString() : folder.filePath("other.palmer"));
        done.act(shown);
        if (done.closes) {
            QTRY_VERIFY(!window || !window->isVisible());
            QVERIFY(answers.asked.contains("closeBox")); // it is a change, and was asked about
        } else {
            QTRY_VERIFY(!QApplication::activeModalWidget());
            QVERIFY(typed.isTaken(*window->model().document()));
        }
        if (done.saves) {
            const bool other = name == "Save as";
            const QString file = other ? folder.filePath("other.palmer") : path;
            QTRY_VERIFY(QFile::exists(file));
            QVERIFY(typed.isTaken(openDocument(file)));
        }
    }

    /// A text that the document cannot take stays where it was typed, also behind other tests, and closing
    /// asks.
    void whatIsRefusedIsNotLost_data() {
        QTest::addColumn<std::size_t>("test");
        QTest::addColumn<int>("page");
        QTest::addColumn<QString>("widget");
        QTest::addColumn<int>("row");
        QTest::addColumn<int>("column");
        const int readings = static_cast<int>(Page::readings);
        QTest::newRow("target") << std::size_t{0} << readings << "readings" << 2 << 1;
        QTest::newRow("angle of a point") << std::size_t{1} << readings << "points" << 0 << 1;
        QTest::newRow("deviation of a point") << std::size_t{1} << readings << "points" << 3 << 2;
        QTest::newRow("radius") << std::size_t{1} << readings << "nominalRadius" << -1 << -1;
        QTest::newRow("range") << std::size_t{1} << readings << "evaluatedTo" << -1 << -1;
        QTest::newRow("drift") << std::size_t{2} << readings << "driftReadings" << 1 << 1;
        QTest::newRow("half a reading of drift") << std::size_t{2} << readings << "driftReadings" << 3 << 0;
        QTest::newRow("condition") << std::size_t{0} << static_cast<int>(Page::conditions) << "airHumidity"
                                   << -1 << -1;
    }

    void whatIsRefusedIsNotLost() {
        QFETCH(std::size_t, test);
        QFETCH(int, page);
        QFETCH(QString, widget);
        QFETCH(int, row);
        QFETCH(int, column);
        const bool half = row == 3 && column == 0;
        const QString text = half ? "61" : "4,,8";
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.palmer");
        saveDocument(everyKind(), path);
        const ShownWindow shown(path);
        QVERIFY2(shown.window->hasDocument(), qPrintable(whyNot()));
        shown.window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(shown.window));
        const QByteArray name = widget.toUtf8();
        const Place place{"", test, static_cast<Page>(page), name.constData(), row, column, "", {}};
        type(shown, place, text);
        const auto isThere = [&] {
            if (row < 0)
                return field(shown, place)->text() == text;
            auto *table = shown.find<QTableView>(name.constData());
            return table->model()->index(row, column).data().toString() == text;
        };
        press(shown, Qt::Key_S, Qt::ControlModifier);
        QVERIFY(isThere());
        QVERIFY(shown.find<QLabel>("noticeSentence")->text().contains(text)); // what was saved is without it
        shown.window->workplace().showTest(test == 0 ? 1 : 0);
        shown.window->workplace().showTest(test);
        shown.window->workplace().showPage(place.page);
        QVERIFY(isThere());
        QCOMPARE(shown.window->workplace().refusedTexts(), QStringList{text});
        while (shown.window->model().undoStack()->canUndo()) // nothing but the text is unsaved
            shown.window->model().undoStack()->undo();
        QVERIFY(isThere());
        QString said;
        QTimer::singleShot(0, shown.window, [&said] {
            auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
            QVERIFY(box && box->objectName() == "closeBox");
            said = box->informativeText();
            box->button(QMessageBox::Cancel)->click();
        });
        shown.window->close();
        QVERIFY(shown.window->isVisible());
        QVERIFY2(said.contains(text), qPrintable(said));
    }

private:
    static QString whyNot() {
        const auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
        return box ? box->informativeText() : QString();
    }
    static QLineEdit *field(const ShownWindow &shown, const Place &place) {
        for (auto *edit : shown.window->findChildren<QLineEdit *>()) {
            const QString name = edit->objectName();
            if (edit->isVisible() &&
                (name == place.widget || name.startsWith(QString("field.%1.").arg(place.widget)) ||
                 name.startsWith(QString("%1.").arg(place.widget))))
                return edit;
        }
        return nullptr;
    }

    /// Types into the place by keys, and leaves it in its editor.
    static void type(const ShownWindow &shown, const Place &place, const QString &text) {
        shown.window->workplace().showTest(place.test);
        shown.window->workplace().showPage(place.page);
        if (place.row >= 0) {
            auto *table = shown.find<QTableView>(place.widget);
            QTRY_VERIFY(table->isVisible()); // a page that was shown just now has its places later
            table->setFocus();
            QTRY_VERIFY(table->hasFocus());
            table->setCurrentIndex(table->model()->index(place.row, place.column));
        } else {
            QLineEdit *edit = field(shown, place);
            QVERIFY(edit);
            edit->setFocus();
            edit->selectAll();
        }
        for (const QChar c : text)
            QTest::keyClick(shown.window->windowHandle(), c.toLatin1());
    }
    static void type(const ShownWindow &shown, const Place &place) { type(shown, place, place.typed); }
};

QTEST_MAIN(CommitTypingTest)
#include "committypingtest.moc"
