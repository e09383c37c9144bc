// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/writedocument.h"
#include "report/words/accordancetext.h"
#include "ui/forms/field.h"
#include "ui/model/page.h"
#include "ui/navigation/navigationmodel.h"
#include "ui/testname.h"
#include "ui/welcome/examples.h"
#include "ui/welcome/recentfiles.h"
#include "ui/welcome/startlist.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QSplitter>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>
#include <set>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

QString dataOf(const QAbstractItemModel &model) {
    QStringList rows;
    for (int row = 0; row < model.rowCount(); ++row)
        rows += model.index(row, 0).data(Qt::AccessibleTextRole).toString();
    return rows.join(u'\n');
}

void choose(QComboBox *box, const QString &word) {
    const int index = box->findData(word);
    QVERIFY2(index >= 0, qPrintable(word));
    box->setCurrentIndex(index);
    emit box->activated(index);
}

QMessageBox *errorBox() {
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (widget->objectName() == QLatin1StringView("errorBox") && widget->isVisible())
            return qobject_cast<QMessageBox *>(widget);
    }
    return nullptr;
}

int countWindows() {
    int count = 0;
    for (QWidget *widget : QApplication::topLevelWidgets())
        count += qobject_cast<MainWindow *>(widget) != nullptr;
    return count;
}

} // namespace

class MainWindowTest : public QObject {
    Q_OBJECT

private slots:
    void theHistoryIsAList();
    void aPlanNeedsNoFile();
    void theStatusCountsWhatIsMissing();
    void eachChoiceOfAMenuIsMarked();
    void initTestCase();
    void init();
    void everyExampleIsListed();
    void pagesAreMadeWhenTheyAreNeeded();
    void theTypeExampleShowsItsMachines();
    void opensEveryExample_data();
    void opensEveryExample();
    void opensASecondFileInAWindowOfItsOwn();
    void aSecondWindowStaysWithinTheScreen();
    void bringsAnOpenFileToTheFront();
    void showsAnEditionAsAView();
    void setsTheEditionOfTheTest();
    void keepsLimitsWithTheEditionTheyWereAgreedFor();
    void theStatusSaysWhatWasTyped();
    void switchesTheLanguage();
    void saves();
    void saysWhySavingFailed();
    void saysWhyAFileCannotBeOpened_data();
    void saysWhyAFileCannotBeOpened();
    void remembersFiles();
    void asksOnceBeforeClosing();
    void takesDroppedFiles();
    void walksMissingStatements();
    void maximisesTheFigure();
    void arrangesForTheSizeThereIs_data();
    void arrangesForTheSizeThereIs();
    void remembersTheWidthsOfItsParts();
    void thePagesTakeTheKeyboard();
    void offersThePagesOfTheTest();
    void startsACircularTest();
    void followsThePalette();
    void leavesUnfocusedFieldsToTheWheel();
    void modelsKeepTheirPromises();
};

/// Steps can be gone back to at once; their names are those of undo.
void MainWindowTest::theHistoryIsAList() {
    const ShownWindow shown(examplePath("rotary-axis"));
    auto *history = shown.find<QAction>("undo")->menu();
    for (const QAction *action : shown.window->menuBar()->actions()) {
        for (QAction *inner : action->menu()->actions()) {
            if (inner->menu() && inner->text().remove(u'&') == u"History"_s)
                history = inner->menu();
        }
    }
    QVERIFY(history);
    const auto opened = shown.window->model().document();
    for (const char *title : {"one", "two", "three"})
        shown.window->model().edit("rename the test", [&](Document &document) {
            auto test = std::make_shared<Test>(*document.tests[0]);
            test->title = title;
            document.tests[0] = std::move(test);
        });
    emit history->aboutToShow();
    QCOMPARE(history->actions().size(), 4);
    QVERIFY(history->actions()[0]->isChecked());
    QCOMPARE(history->actions()[0]->text(), u"rename the test"_s);
    QCOMPARE(history->actions()[3]->text(), u"As opened"_s);
    history->actions()[2]->trigger();
    QCOMPARE(shown.window->model().document()->tests[0]->title, "one");
    emit history->aboutToShow();
    QVERIFY(history->actions()[2]->isChecked());
    history->actions()[3]->trigger();
    QVERIFY(*shown.window->model().document() == *opened);
}

/// From the welcome page; only a test made from it opens a file.
void MainWindowTest::aPlanNeedsNoFile() {
    const ShownWindow shown;
    const auto plan = [&](const char *button) {
        QTimer::singleShot(0, shown.window, [button] {
            QWidget *dialog = QApplication::activeModalWidget();
            for (auto *each : dialog->findChildren<QPushButton *>()) {
                if (each->isVisible() && each->text() == QLatin1StringView(button))
                    return each->click();
            }
            qFatal("no %s", button);
        });
        shown.find<QAbstractButton>("welcomePlan")->click();
    };
    plan("&Close");
    QVERIFY(!shown.window->hasDocument());
    plan("&New test");
    QVERIFY(shown.window->hasDocument());
    QCOMPARE(shown.window->model().document()->tests.size(), std::size_t(1));
    QVERIFY(shown.window->model().path().isEmpty() && shown.window->isWindowModified());
}

/// The sum of the badges, and the way to the list.
void MainWindowTest::theStatusCountsWhatIsMissing() {
    const ShownWindow shown(examplePath("x-axis-as-found-as-left"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    auto *lack = shown.find<QPushButton>("statusLack");
    const EvaluatedDocument &evaluated = shown.window->evaluator().current();
    int missing = 0;
    for (Page page = Page::identification; page <= Page::uncertainty;
         page = static_cast<Page>(static_cast<int>(page) + 1))
        missing += countMissing(evaluated, 0, page);
    QVERIFY(missing > 0 && lack->isVisible());
    static const QRegularExpression counts(
        u"([0-9]+) requirements not met, ([0-9]+) not declared · ([0-9]+) other required"_s); // unmet:
                                                                                              // unstated
    const auto said = counts.match(lack->text());
    QVERIFY2(said.captured(1).toInt() + said.captured(2).toInt() + said.captured(3).toInt() == missing,
             qPrintable(QString::number(missing) + u": "_s + lack->text()));
    QVERIFY(lack->text().startsWith(requirementsText(*evaluated.tests[0], Language(Language::Id::english))));
    QVERIFY(shown.find<QLabel>("findingsSummary")->text().startsWith(lack->text()));
    lack->setFocus();
    QTest::keyClick(lack, Qt::Key_Space);
    QTRY_VERIFY(shown.find("findings")->hasFocus());
}

void MainWindowTest::initTestCase() {
    prepareApplication();
}

void MainWindowTest::init() {
    QSettings().clear();
    setWindowLanguage(Language::Id::english);
}

void MainWindowTest::opensEveryExample_data() {
    QTest::addColumn<QString>("path");
    for (const Example &example : examples())
        QTest::newRow(qPrintable(example.name)) << example.path;
}

void MainWindowTest::pagesAreMadeWhenTheyAreNeeded() {
    const ShownWindow shown;
    QVERIFY(!shown.window->findChild<Workplace *>());
    shown.find<QAction>("shortcuts")->trigger(); // lists those of the pages, too
    QVERIFY(shown.window->findChild<Workplace *>());
    QVERIFY(shown.find("welcome")->isVisible());
    shown.window->openFile(examplePath("rotary-axis"));
    QVERIFY(shown.window->workplace().isVisible());
    QCOMPARE(shown.window->findChildren<Workplace *>().size(), 1);
}

void MainWindowTest::everyExampleIsListed() {
    QStringList listed;
    for (const Example &example : examples())
        listed << example.path.section(u'/', -1);
    QCOMPARE(listed, QDir(":/examples").entryList({"*.palmer"}, QDir::Files, QDir::Name));
}

/// The example of a type test is a folder: its dialog shows the machines of all its files.
void MainWindowTest::theTypeExampleShowsItsMachines() {
    const ShownWindow shown;
    QVERIFY(isExample(typeExample().path));
    QVERIFY(!exampleDetail(typeExample().path).isEmpty());
    shown.window->openFile(typeExample().path);
    QTRY_VERIFY(shown.window->findChild<QDialog *>("typeDialog"));
    const auto *dialog = shown.window->findChild<QDialog *>("typeDialog");
    QCOMPARE(dialog->findChild<QComboBox *>("typeParameter")->currentText(), "X · A");
    const QString text = dialog->findChild<QTextBrowser *>("typeText")->toPlainText();
    for (const QFileInfo &file : QDir(typeExample().path).entryInfoList({"*.palmer"}))
        QVERIFY2(text.contains("Machine " + file.baseName().section('-', 1)), qPrintable(text));
    QVERIFY(!shown.window->hasDocument());
}

void MainWindowTest::opensEveryExample() {
    QFETCH(QString, path);
    const ShownWindow shown(path);
    QVERIFY(shown.window->hasDocument());
    const Document &document = *shown.window->model().document();
    const std::vector<Example> all = examples();
    const auto listed = std::ranges::find(all, path, &Example::path);
    QVERIFY(listed != all.end());
    const Test &first = *document.tests.front();
    QVERIFY(first.edition.ends_with(":" + listed->year.toStdString()));
    QCOMPARE(listed->circular, std::holds_alternative<CircularMeasurement>(first.measurement));
    QVERIFY(exampleDetail(path).startsWith(QString::fromStdString(first.edition)));
    auto *navigation = shown.find<QListView>("navigation");
    QCOMPARE(navigation->model()->rowCount(), static_cast<int>(document.tests.size()) + 6);
    for (std::size_t test = 0; test < document.tests.size(); ++test) {
        shown.window->workplace().showTest(test);
        QCOMPARE(shown.find<QLabel>("testTitle")->accessibleName(), testName(*document.tests[test]));
        const bool isDrift = std::holds_alternative<DriftMeasurement>(document.tests[test]->measurement);
        QVERIFY(isDrift || shown.find<QComboBox>("edition")->currentText() ==
                               QString::fromStdString(document.tests[test]->edition));
        QCOMPARE(shown.window->evaluator().current().tests[test]->parameters.empty(), isDrift);
        for (const Page page : {Page::identification, Page::machine, Page::instruments, Page::readings,
                                Page::conditions, Page::agreedPoints, Page::limits}) {
            shown.window->workplace().showPage(page);
            QVERIFY(!shown.window->grab().isNull());
        }
    }
    QVERIFY(!shown.window->isWindowModified());
}

void MainWindowTest::opensASecondFileInAWindowOfItsOwn() {
    const ShownWindow shown(examplePath("rotary-axis"));
    const int before = countWindows();
    const auto document = shown.window->model().document();
    shown.window->openFile(examplePath("one-direction"));
    QCOMPARE(countWindows(), before + 1);
    QVERIFY(shown.window->model().document() == document);
    QList<QWidget *> others; // first collected: with a window its menus go, which are in the list, too
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        if (qobject_cast<MainWindow *>(widget) && widget != shown.window)
            others += widget;
    }
    QCOMPARE(others.size(), 1);
    qDeleteAll(others);
}

/// Also beside a window that fills the screen.
void MainWindowTest::aSecondWindowStaysWithinTheScreen() {
    for (const bool fills : {false, true}) {
        const ShownWindow shown(examplePath("rotary-axis"));
        const QRect room = shown.window->screen()->availableGeometry();
        if (fills)
            shown.window->showMaximized();
        else
            shown.window->setGeometry(room.adjusted(room.width() / 2, room.height() / 2, 0, 0));
        QCoreApplication::processEvents();
        shown.window->openFile(examplePath("one-direction"));
        QList<QWidget *> others;
        for (QWidget *widget : QApplication::topLevelWidgets()) {
            if (qobject_cast<MainWindow *>(widget) && widget != shown.window)
                others += widget;
        }
        QCOMPARE(others.size(), 1);
        const QRect place(others.front()->pos(), others.front()->size());
        qDeleteAll(others);
        QVERIFY2(room.contains(place), qPrintable(QString("%1, %2: %3 × %4 in %5 × %6")
                                                      .arg(place.x())
                                                      .arg(place.y())
                                                      .arg(place.width())
                                                      .arg(place.height())
                                                      .arg(room.width())
                                                      .arg(room.height())));
    }
}

void MainWindowTest::bringsAnOpenFileToTheFront() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("one.palmer"));
    saveDocument(openDocument(examplePath("rotary-axis")), path);
    const ShownWindow first(path);
    const ShownWindow second;
    const int before = countWindows();
    second.window->openFile(path);
    QCOMPARE(countWindows(), before);
    QVERIFY(!second.window->hasDocument());
}

void MainWindowTest::showsAnEditionAsAView() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    const auto document = shown.window->model().document();
    auto *set = shown.find<QPushButton>("setEdition");
    QVERIFY(!set->isVisible());
    choose(shown.find<QComboBox>("edition"), QStringLiteral("ISO 230-2:2014"));
    QVERIFY(set->isVisible());
    QVERIFY(shown.find<QLabel>("testSummary")->accessibleName().contains(QStringLiteral("ISO 230-2:1988")));
    const TestEvaluation &view = *shown.window->evaluator().current().tests[0];
    QVERIFY(view.view && !view.verdict);
    QVERIFY(shown.window->model().document() == document);
    QVERIFY(!shown.window->isWindowModified());
    shown.find<QAction>("ownEdition")->trigger();
    QVERIFY(!shown.window->evaluator().current().tests[0]->view);
    QVERIFY(!set->isVisible());
}

void MainWindowTest::setsTheEditionOfTheTest() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    choose(shown.find<QComboBox>("edition"), QStringLiteral("ISO 230-2:2014"));
    shown.find<QPushButton>("setEdition")->click();
    QCOMPARE(shown.window->model().document()->tests[0]->edition, std::string("ISO 230-2:2014"));
    QVERIFY(!shown.window->evaluator().current().tests[0]->view);
    QVERIFY(shown.window->isWindowModified());
    auto *undo = shown.find<QAction>("undo");
    QCOMPARE(undo->text(), QStringLiteral("&Undo: set the edition of the test"));
    undo->trigger();
    QCOMPARE(shown.window->model().document()->tests[0]->edition, std::string("ISO 230-2:1988"));
    QCOMPARE(shown.find<QComboBox>("edition")->currentText(), QStringLiteral("ISO 230-2:1988"));
    QVERIFY(!shown.window->isWindowModified());
}

void MainWindowTest::keepsLimitsWithTheEditionTheyWereAgreedFor() {
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(shown.window->evaluator().current().tests[0]->verdict);
    choose(shown.find<QComboBox>("edition"), QStringLiteral("ISO 230-2:1988"));
    shown.find<QPushButton>("setEdition")->click();
    const Test &test = *shown.window->model().document()->tests[0];
    QVERIFY(!test.limits.empty());
    for (const auto &[id, limit] : test.limits)
        QCOMPARE(limit.edition, std::optional<std::string>("ISO 230-2:2014"));
    QVERIFY(shown.window->evaluator().current().tests[0]->verdict == Verdict::notProven);
}

/// 8.88 seconds are no such number of degrees: the last bits are nobody's.
void MainWindowTest::theStatusSaysWhatWasTyped() {
    setWindowLanguage(Language::Id::english);
    const ShownWindow shown(examplePath("rotary-axis"));
    for (const double typed : {8.88, 9.99, 0.07}) {
        shown.window->model().edit("enter a reading", [typed](Document &document) {
            auto test = std::make_shared<palmer::Test>(*document.tests[0]);
            std::get<PositioningMeasurement>(test->measurement).runs[1].deviations[2] = typed / 3600;
            document.tests[0] = std::move(test);
        });
        shown.window->workplace().selection().setReading({});
        shown.window->workplace().selection().setReading(ReadingPlace{1, 2});
        const QString hint = shown.find<QLabel>("statusHint")->text();
        QVERIFY2(hint.contains(QStringLiteral(": %1″").arg(typed)), qPrintable(hint));
    }
}

void MainWindowTest::switchesTheLanguage() {
    const ShownWindow shown(examplePath("rotary-axis"));
    auto *tabs = shown.find<QTabBar>("pageTabs");
    QCOMPARE(tabs->tabText(0), QStringLiteral("&Readings"));
    QVERIFY(shown.find<QLabel>("testSummary")->accessibleName().startsWith(QStringLiteral("rotary")));
    const QByteArray bytes = writeDocument(*shown.window->model().document());
    const auto switches = shown.window->findChildren<QToolButton *>(QStringLiteral("french"));
    QVERIFY(!switches.isEmpty());
    switches.constFirst()->click();
    QTRY_COMPARE(tabs->tabText(0), QStringLiteral("&Relevés"));
    QCOMPARE(shown.window->menuBar()->actions().constFirst()->text(), QStringLiteral("&Fichier"));
    QVERIFY(dataOf(*shown.find<QListView>("navigation")->model()).contains(QStringLiteral("Identification")));
    QVERIFY(dataOf(*shown.find<QListView>("navigation")->model())
                .contains(Language(Language::Id::french).shortDate("2026-11-20")));
    QVERIFY(shown.find<QLabel>("testSummary")->accessibleName().startsWith(QStringLiteral("rotatif")));
    QCOMPARE(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Annuler"));
    QCOMPARE(writeDocument(*shown.window->model().document()), bytes);
    QVERIFY(!shown.window->isWindowModified());
    QCOMPARE(QSettings().value(QStringLiteral("window/language")).toString(), QStringLiteral("fr"));
    shown.find<QAction>("speakEnglish")->trigger();
    QTRY_COMPARE(tabs->tabText(0), QStringLiteral("&Readings"));
    restoreWindowLanguage();
    QCOMPARE(windowLanguage().id(), Language::Id::english);
}

void MainWindowTest::saves() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("saved.palmer"));
    const ShownWindow shown(examplePath("rotary-axis"));
    choose(shown.find<QComboBox>("edition"), QStringLiteral("ISO 230-2:2006"));
    shown.find<QPushButton>("setEdition")->click();
    QVERIFY(shown.window->saveTo(path));
    QVERIFY(!shown.window->isWindowModified());
    QVERIFY(openDocument(path) == *shown.window->model().document());
    QVERIFY(shown.window->windowTitle().startsWith(QStringLiteral("saved.palmer")));
    QVERIFY(shown.find<QLabel>("statusState")->text().startsWith(QStringLiteral("Saved at ")));
}

void MainWindowTest::saysWhySavingFailed() {
    const QTemporaryDir folder;
    const ShownWindow shown(examplePath("rotary-axis"));
    QVERIFY(!shown.window->saveTo(folder.filePath(QStringLiteral("missing/file.palmer"))));
    QMessageBox *box = errorBox();
    QVERIFY(box);
    QVERIFY(!box->informativeText().isEmpty());
    box->close();
    QVERIFY(shown.window->model().path().isEmpty());
}

void MainWindowTest::saysWhyAFileCannotBeOpened_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("said");
    QFile file(examplePath("rotary-axis"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray good = file.readAll();
    QTest::newRow("cut off") << good.left(good.size() / 2) << QStringLiteral(":");
    QTest::newRow("of a newer version")
        << QByteArray(good).replace("\"version\": 2", "\"version\": 99") << QStringLiteral("99");
    QTest::newRow("with a word for a number")
        << QByteArray(good).replace("\"year\": 2021", "\"year\": \"old\"") << QStringLiteral("machine.year");
    QTest::newRow("empty") << QByteArray() << QString();
}

void MainWindowTest::saysWhyAFileCannotBeOpened() {
    QFETCH(QByteArray, content);
    QFETCH(QString, said);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("damaged.palmer"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    const ShownWindow shown(examplePath("rotary-axis"));
    const auto document = shown.window->model().document();
    const QString title = shown.window->windowTitle();
    const int windows = countWindows();
    shown.window->openFile(path);
    QMessageBox *box = errorBox();
    QVERIFY(box);
    QVERIFY(box->text().contains(QStringLiteral("damaged.palmer")));
    QVERIFY2(box->informativeText().contains(said), qPrintable(box->informativeText()));
    box->close();
    QVERIFY(shown.window->model().document() == document);
    QCOMPARE(shown.window->windowTitle(), title);
    QCOMPARE(countWindows(), windows);
    QVERIFY(recentFiles().empty());
}

void MainWindowTest::remembersFiles() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("kept.palmer"));
    saveDocument(openDocument(examplePath("rotary-axis")), path);
    { const ShownWindow shown(path); }
    QCOMPARE(recentFiles().size(), std::size_t{1});
    const RecentFile file = recentFiles().front();
    QCOMPARE(file.path, path);
    QCOMPARE(file.machine, QStringLiteral("Five-axis machining centre"));
    QCOMPARE(file.axes, QStringLiteral("C"));
    QCOMPARE(file.date, QDate(2026, 11, 20));
    QVERIFY(file.verdict);
    const ShownWindow again;
    auto *list = again.find<QListView>("recentList");
    QCOMPARE(list->model()->rowCount(), 1);
    emit static_cast<StartList *>(list)->chosen(path);
    QVERIFY(again.window->hasDocument());
    QVERIFY(QFile::remove(path));
    QVERIFY(recentFiles().empty());
}

void MainWindowTest::asksOnceBeforeClosing() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    choose(shown.find<QComboBox>("edition"), QStringLiteral("ISO 230-2:2014"));
    shown.find<QPushButton>("setEdition")->click();
    int asked = 0;
    const auto answer = [&](QMessageBox::StandardButton button) {
        QTimer::singleShot(0, shown.window, [&asked, button] {
            auto *box = qobject_cast<QMessageBox *>(QApplication::activeModalWidget());
            QVERIFY(box);
            ++asked;
            box->button(button)->click();
        });
    };
    answer(QMessageBox::Cancel);
    QVERIFY(!shown.window->close());
    QCOMPARE(asked, 1);
    answer(QMessageBox::Discard);
    QVERIFY(shown.window->close());
    QCOMPARE(asked, 2);
}

void MainWindowTest::takesDroppedFiles() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("dropped.palmer"));
    saveDocument(openDocument(examplePath("one-direction")), path);
    const ShownWindow shown;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(shown.window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(shown.window, &drop);
    QVERIFY(shown.window->hasDocument());
    QCOMPARE(shown.window->model().path(), path);
}

void MainWindowTest::walksMissingStatements() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    Selection &selection = shown.window->workplace().selection();
    // One way and back, round and round: where it comes past, in this order.
    using Stop = std::pair<Page, QWidget *>;
    const auto walk = [&](const char *action) {
        std::vector<Stop> stops;
        for (;;) {
            shown.find<QAction>(action)->trigger();
            const Stop stop(selection.page(), shown.window->focusWidget());
            if (!stops.empty() && stop == stops.front())
                return stops;
            stops.push_back(stop);
            if (stops.size() > 200)
                qFatal("the walk does not come round");
        }
    };
    const std::vector<Stop> onward = walk("nextMissing");
    const std::vector<Stop> back = walk("previousMissing");
    QVERIFY(std::ranges::equal(back, std::vector(onward.rbegin(), onward.rend())));
    const auto on = [&](Page page) {
        return std::ranges::count(onward, page, [](const Stop &stop) { return stop.first; });
    };
    // Every field that is marked, also where several are missing under one name.
    std::ptrdiff_t marked = 0;
    for (const auto *field : shown.find("conditionsPage")->findChildren<Field *>())
        marked += field->isRequired();
    QVERIFY(marked > 6);
    QCOMPARE(on(Page::conditions), marked);
    QVERIFY(on(Page::agreedPoints) > 0 && on(Page::identification) + on(Page::machine) > 0);
    std::set<Page> pages;
    std::size_t changes = 0;
    for (std::size_t i = 0; i < onward.size(); ++i) {
        pages.insert(onward[i].first);
        changes += i > 0 && onward[i].first != onward[i - 1].first;
    }
    QVERIFY(changes <= pages.size()); // not to and fro
}

void MainWindowTest::maximisesTheFigure() {
    const ShownWindow shown(examplePath("rotary-axis"));
    auto *right = shown.find("rightSide");
    auto *navigation = shown.find("navigation");
    shown.find<QAction>("maximiseFigure")->trigger();
    QVERIFY(!navigation->isVisible());
    QVERIFY(right->isVisible());
    QTRY_COMPARE(right->width(), shown.window->workplace().width());
    QTest::keyClick(shown.window, Qt::Key_Escape);
    QVERIFY(navigation->isVisible());
    QTRY_VERIFY(right->width() < 600);
}

void MainWindowTest::arrangesForTheSizeThereIs_data() {
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("rail");
    QTest::addColumn<bool>("underneath");
    QTest::addColumn<bool>("folded");
    QTest::newRow("wide") << QSize(1600, 1000) << false << false << false;
    QTest::newRow("as drawn") << QSize(1280, 800) << false << false << false;
    QTest::newRow("narrow") << QSize(1024, 768) << true << false << false;
    QTest::newRow("very narrow") << QSize(900, 900) << true << true << false;
    QTest::newRow("low") << QSize(1280, 700) << false << false << true;
}

void MainWindowTest::arrangesForTheSizeThereIs() {
    QFETCH(QSize, size);
    QFETCH(bool, rail);
    QFETCH(bool, underneath);
    QFETCH(bool, folded);
    const ShownWindow shown(examplePath("rotary-axis"), size);
    QTRY_COMPARE(shown.window->size(), size);
    QTRY_COMPARE(shown.find("navigation")->width(), rail ? 48 : 184);
    auto *right = shown.find("rightSide");
    auto *centre = shown.find("centre");
    QVERIFY(centre->width() >= 560);
    QCOMPARE(right->mapTo(shown.window, QPoint()).y() > centre->mapTo(shown.window, QPoint()).y() + 100,
             underneath);
    QCOMPARE(shown.find("rightTabs")->isVisible(), underneath);
    if (!underneath)
        QCOMPARE(!shown.find("findings")->isVisible(), folded);
    if (size.width() >= 1280)
        QVERIFY(right->width() >= 490);
}

void MainWindowTest::remembersTheWidthsOfItsParts() {
    const QSize size(1400, 800);
    const auto draw = [](const ShownWindow &shown, const char *name, int by) {
        auto *handle = shown.find<QSplitter>(name)->handle(1);
        const QPoint at = handle->rect().center();
        QTest::mousePress(handle, Qt::LeftButton, {}, at);
        QMouseEvent move(QEvent::MouseMove, at + QPoint(by, 0), handle->mapToGlobal(at + QPoint(by, 0)),
                         Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(handle, &move);
        QTest::mouseRelease(handle, Qt::LeftButton, {}, at);
    };
    int side = 0;
    int right = 0;
    {
        const ShownWindow shown(examplePath("rotary-axis"), size);
        QTRY_COMPARE(shown.find("navigation")->width(), 184);
        draw(shown, "outerSplitter", 40);
        draw(shown, "innerSplitter", -60);
        side = shown.find("navigation")->width();
        right = shown.find("rightSide")->width();
        QVERIFY(side > 200 && right > 520);
    }
    const ShownWindow again(examplePath("one-direction"), size);
    QTRY_COMPARE(again.find("navigation")->width(), side);
    QTRY_COMPARE(again.find("rightSide")->width(), right);
    // A circular test has widths of its own.
    const ShownWindow circular(examplePath("iso230-4-full-circles-xy"), size);
    QTRY_COMPARE(circular.find("navigation")->width(), 184);
    QVERIFY(circular.find("rightSide")->width() < right);
}

void MainWindowTest::thePagesTakeTheKeyboard() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    for (const char *page : {"page4", "page2", "page1"}) {
        shown.find<QAction>(page)->trigger();
        const QWidget *focused = shown.window->focusWidget();
        QVERIFY(focused);
        QVERIFY2(shown.find("centre")->isAncestorOf(focused), page);
        QVERIFY2(focused->isVisible() && !qobject_cast<const QAbstractButton *>(focused), page);
    }
    QCOMPARE(shown.window->focusWidget()->objectName(), QStringLiteral("readings"));
}

/// A page that the kind of test does not have is not offered.
void MainWindowTest::offersThePagesOfTheTest() {
    const auto offered = [](const ShownWindow &shown) {
        QString pages;
        for (int page = 1; page <= 8; ++page)
            pages += QString::number(
                shown.find<QAction>(qPrintable(u"page%1"_s.arg(page)))->isEnabled() ? page : 0);
        return pages;
    };
    QCOMPARE(offered(ShownWindow(examplePath("rotary-axis"))), u"12345070"_s);
    QCOMPARE(offered(ShownWindow(examplePath("iso230-4-full-circles-xy"))), u"12345670"_s);
    const ShownWindow thermal(examplePath("thermal-behaviour"));
    thermal.window->workplace().showTest(1);
    QCOMPARE(offered(thermal), u"10000008"_s);
}

void MainWindowTest::startsACircularTest() {
    const ShownWindow shown;
    QTimer::singleShot(0, shown.window, [] {
        auto *dialog = QApplication::activeModalWidget();
        QVERIFY(dialog);
        auto *radius = dialog->findChild<QLineEdit *>(QStringLiteral("newRadius"));
        auto *create = dialog->findChild<QPushButton *>(QStringLiteral("createCircle"));
        radius->setText(QStringLiteral("-1"));
        QVERIFY(!create->isEnabled());
        radius->setText(QStringLiteral("75,5")); // both decimal marks
        dialog->findChild<QLineEdit *>(QStringLiteral("newFeed"))->setText(QStringLiteral("1500"));
        dialog->findChild<QComboBox *>(QStringLiteral("newPlane"))->setCurrentIndex(2);
        QVERIFY(create->isEnabled());
        QTest::keyClick(dialog, Qt::Key_Return);
    });
    shown.find<QAction>("newCircle")->trigger();
    QVERIFY(shown.window->hasDocument());
    const Document document = *shown.window->model().document();
    QCOMPARE(document.tests.size(), std::size_t{1});
    QCOMPARE(document.tests[0]->edition, std::string("ISO 230-4:2005"));
    QCOMPARE(document.tests[0]->id, std::string("zx1"));
    const auto &circle = std::get<CircularMeasurement>(document.tests[0]->measurement);
    QCOMPARE(circle.nominalRadius, 75.5);
    QCOMPARE(circle.feed, std::optional(1500.0));
    QCOMPARE(circle.plane, (Plane{"Z", "X"}));
    QVERIFY(shown.find("noArcs")->isVisible());
    QVERIFY(readDocument(writeDocument(document)) == document);
}

void MainWindowTest::followsThePalette() {
    const ShownWindow shown(examplePath("rotary-axis"));
    const QPalette light = QApplication::palette();
    const QString sheet = qApp->styleSheet();
    QVERIFY(!sheet.contains(u'@')); // every colour has its value
    QPalette dark = light;
    dark.setColor(QPalette::Window, QColor(0x22, 0x25, 0x28));
    dark.setColor(QPalette::Base, QColor(0x1a, 0x1c, 0x1e));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        dark.setColor(role, QColor(0xe8, 0xea, 0xec));
    QApplication::setPalette(dark);
    QTRY_VERIFY(qApp->styleSheet() != sheet);
    QVERIFY(qApp->styleSheet().contains(QStringLiteral("#6fa8e6")));
    const QImage image = shown.window->grab().toImage();
    QVERIFY(image.pixelColor(shown.window->width() - 40, shown.window->height() - 60).lightness() < 100);
    QApplication::setPalette(light);
    QTRY_COMPARE(qApp->styleSheet(), sheet);
}

void MainWindowTest::leavesUnfocusedFieldsToTheWheel() {
    const ShownWindow shown(examplePath("rotary-axis"));
    auto *edition = shown.find<QComboBox>("edition");
    edition->clearFocus();
    const QString before = edition->currentText();
    const QPoint centre = edition->rect().center();
    QWheelEvent wheel(centre, edition->mapToGlobal(centre), QPoint(), QPoint(0, -120), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(edition, &wheel);
    QCOMPARE(edition->currentText(), before);
    auto *tabs = shown.find<QTabBar>("pageTabs");
    QApplication::sendEvent(tabs, &wheel);
    QCOMPARE(tabs->currentIndex(), 0);
}

void MainWindowTest::modelsKeepTheirPromises() {
    NavigationModel navigation;
    const QAbstractItemModelTester first(&navigation, QAbstractItemModelTester::FailureReportingMode::QtTest);
    StartModel start;
    const QAbstractItemModelTester second(&start, QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (const char *name : {"rotary-axis", "long-axis-with-zone", "one-direction"}) {
        navigation.show(evaluate(std::make_shared<const Document>(openDocument(examplePath(name)))));
        setWindowLanguage(Language::Id::french);
        navigation.retranslate();
    }
    start.setEntries({{QStringLiteral("a"), {}, QStringLiteral("a"), {}, {}, {}}});
    start.setEntries({});
    QCOMPARE(start.rowCount(), 0);
}

void MainWindowTest::eachChoiceOfAMenuIsMarked() {
    setWindowLanguage(Language::Id::english);
    const ShownWindow shown;
    const auto checked = [&](std::initializer_list<const char *> names) {
        QStringList found;
        for (const char *name : names) {
            if (shown.find<QAction>(name)->isChecked())
                found << QLatin1StringView(name);
        }
        return found.join(u' ');
    };
    const auto lengths = [&] { return checked({"lengths1", "lengths2", "lengths3"}); };
    const auto angles = [&] { return checked({"angles1", "angles2"}); };
    const auto languages = [&] { return checked({"speakFrench", "speakEnglish"}); };
    QCOMPARE(lengths(), u"lengths1"_s);
    QCOMPARE(angles(), u"angles1"_s);
    QCOMPARE(languages(), u"speakEnglish"_s);
    shown.find<QAction>("angles2")->trigger();
    QTRY_COMPARE(angles(), u"angles2"_s);
    shown.find<QAction>("lengths2")->trigger();
    QTRY_COMPARE(lengths(), u"lengths2"_s);
    QCOMPARE(angles(), u"angles2"_s);
    shown.find<QAction>("speakFrench")->trigger();
    QTRY_COMPARE(languages(), u"speakFrench"_s);
    QCOMPARE(angles(), u"angles2"_s);
    QCOMPARE(lengths(), u"lengths2"_s);
    shown.find<QAction>("speakEnglish")->trigger();
    shown.find<QAction>("lengths1")->trigger();
    shown.find<QAction>("angles1")->trigger();
    QTRY_COMPARE(angles(), u"angles1"_s);
}

QTEST_MAIN(MainWindowTest)
#include "mainwindowtest.moc"
