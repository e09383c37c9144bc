// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include "document/savedocument.h"
#include "editing/newtest.h"
#include "ui/dialogs/plandialog.h"
#include "ui/dialogs/reportdialog.h"
#include "ui/elidedlabel.h"
#include "ui/forms/field.h"
#include "ui/forms/sectionhead.h"
#include "ui/navigation/navigationmodel.h"
#include "ui/readings/readingsmodel.h"
#include "ui/results/resultsmodel.h"
#include "ui/welcome/examples.h"
#include "ui/window/pagetabs.h"

#include <QCheckBox>
#include <QImage>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QScopeGuard>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

constexpr std::array pages{Page::identification, Page::machine,      Page::instruments, Page::readings,
                           Page::conditions,     Page::agreedPoints, Page::limits,      Page::uncertainty,
                           Page::comparison,     Page::diagnosis};

} // namespace

/// What is in sight in windows of the sizes that are used.
class LayoutTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() {
        QSettings().clear();
        setWindowLanguage(Language::Id::english);
    }
    void elevenTargetsAndFiveRunsNeedNoScrolling_data();
    void elevenTargetsAndFiveRunsNeedNoScrolling();
    void computedColumnsAreThereWhereTheyFit();
    void nothingOfACircleIsCutOff_data();
    void nothingOfACircleIsCutOff();
    void aWideWindowGivesTheFigureItsShare();
    void nothingMovesWhenAResultIsExplained();
    void noDigitOfARulingRowIsCutOff();
    void numbersFitTheirColumnsInAllUnits_data();
    void numbersFitTheirColumnsInAllUnits();
    void lowWindowsHaveRoomForAll_data();
    void lowWindowsHaveRoomForAll();
    void formsEndAt720();
    void sixTargetsAreInSight_data();
    void sixTargetsAreInSight();
    void dialogsHaveRoomOnSmallScreens();
    void limitsStandAsATable();
    void conditionsAreOnePage();
    void theMarkOfWhatIsRequiredHasItsColour();
    void allExamplesAreInSight_data();
    void allExamplesAreInSight();
    void headsAreNotCutInAWord();
    void choicesOfConditionsAreWhole();
    void theEditionOfTheTestIsWholeBesideAView();
    void namesOfLimitsAreWhole();
    void namesOfResultsAreWhole();
    void labelsOfFormsAreWhole();
    void formsHaveRoomInNarrowWindows();
    void toolsAreEvenlySpaced();
    void wideWindowsSayFullNames();
    void wideWindowsShowMoreFindings();
    void startsSayTheirStandard();
    void aDriftTestHasNoEmptyTable();
    void pageAndFigureTakeTurnsInALowWindow_data();
    void pageAndFigureTakeTurnsInALowWindow();
    void pointsThatDoNotApplyAreFoldedAway();
    void agreedPointsBeginWithACapital();
    void agreedPointsAreSeventyHigh();
    void buttonsCanBeHit();
    void theStatusIsNotCutInALetter();
    void sevenTabsAreInSight_data();
    void sevenTabsAreInSight();
    void theNumberOfAnAgreementIsTypedBesideItsText();
    void symbolsInLabelsHaveTheirIndex();
    void textsOfQtAreFrench();
    void boxesAreWideEnoughToRead();
    void choicesOfACircleAreWhole();
    void headOfTheDiagnosisHasAGap();
};

void LayoutTest::elevenTargetsAndFiveRunsNeedNoScrolling_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QSize>("size");
    // 772 and 748: what the title of a window manager leaves of 800 and 768.
    for (const int height : {800, 772, 748}) {
        QTest::addRow("example, %d", height) << examplePath("iso230-2-1988-example") << QSize(1280, height);
        QTest::addRow("fractions of targets, %d", height)
            << QStringLiteral(DOCUMENTS "limits-2006.palmer") << QSize(1280, height);
    }
}

void LayoutTest::elevenTargetsAndFiveRunsNeedNoScrolling() {
    QFETCH(const QString, file);
    QFETCH(const QSize, size);
    const ShownWindow shown(file, size);
    const auto *view = shown.find<QTableView>("readings");
    QTRY_VERIFY(!view->horizontalScrollBar()->isVisible());
    QVERIFY(!view->verticalScrollBar()->isVisible());
    QCOMPARE(view->model()->rowCount(), 11);
    QVERIFY(view->viewport()->rect().contains(view->visualRect(view->model()->index(10, 11))));
}

void LayoutTest::computedColumnsAreThereWhereTheyFit() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"), {1280, 800});
    const auto *view = shown.find<QTableView>("readings");
    const auto *model = qobject_cast<const ReadingsModel *>(view->model());
    const auto hidden = [&] {
        int count = 0;
        for (int column = model->computedColumn(); column < model->columnCount(); ++column)
            count += view->isColumnHidden(column);
        return count;
    };
    const int computed = model->columnCount() - model->computedColumn();
    QVERIFY(computed > 3);
    QTRY_COMPARE(hidden(), computed);
    shown.window->resize(2400, 1000);
    QTRY_COMPARE(hidden(), 0);
    QVERIFY(!view->horizontalScrollBar()->isVisible());
    shown.window->resize(1280, 800);
    QTRY_COMPARE(hidden(), computed);
    for (int column = 0; column < model->computedColumn(); ++column)
        QVERIFY(!view->isColumnHidden(column)); // what was measured is always there
}

void LayoutTest::nothingOfACircleIsCutOff_data() {
    QTest::addColumn<Language::Id>("language");
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(1280, 800), QSize(1180, 768), QSize(1024, 600), QSize(960, 720),
                             QSize(950, 530), QSize(1920, 1080)}) {
        QTest::newRow(qPrintable(u"French, %1"_s.arg(size.width()))) << Language::Id::french << size;
        QTest::newRow(qPrintable(u"English, %1"_s.arg(size.width()))) << Language::Id::english << size;
    }
}

void LayoutTest::nothingOfACircleIsCutOff() {
    QFETCH(Language::Id, language);
    QFETCH(QSize, size);
    setWindowLanguage(language);
    const ShownWindow shown(examplePath("iso230-4-full-circles-xy"), size);
    QCoreApplication::processEvents();
    auto *page = shown.find("circlesPage");
    const auto *place = qobject_cast<QScrollArea *>(page->parentWidget()->parentWidget());
    QVERIFY(place);
    QVERIFY2(page->width() <= place->viewport()->width(),
             qPrintable(u"%1 of %2"_s.arg(page->width()).arg(place->viewport()->width())));
    QCOMPARE(shown.window->size(), size);
    for (const char *part : {"rightSide", "centre", "figureView"}) {
        const auto *widget = shown.find(part);
        const QPoint end = widget->mapTo(shown.window, widget->rect().bottomRight());
        QVERIFY2(shown.window->rect().contains(end), part);
    }
}

void LayoutTest::aWideWindowGivesTheFigureItsShare() {
    const ShownWindow shown(examplePath("rotary-axis"), {1280, 800});
    auto *right = shown.find("rightSide");
    const auto *inner = shown.find("innerSplitter");
    QTRY_COMPARE(right->width(), 496);
    for (const QSize size : {QSize(1600, 900), QSize(1920, 1080), QSize(2560, 1440)}) {
        shown.window->resize(size);
        QTRY_VERIFY(inner->width() > size.width() - 300);
        QTRY_VERIFY2(right->width() >= inner->width() * 40 / 100 &&
                         right->width() <= inner->width() * 45 / 100,
                     qPrintable(QString::number(right->width())));
    }
    shown.window->resize(1280, 800);
    QTRY_COMPARE(right->width(), 496);
}

void LayoutTest::nothingMovesWhenAResultIsExplained() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"), {1280, 800});
    QCoreApplication::processEvents();
    const QRect before = shown.find("readings")->geometry();
    for (const QString &parameter : {u"A"_s, u"Bmean"_s, u"R+"_s}) {
        shown.window->workplace().selection().setParameter(parameter);
        QCoreApplication::processEvents();
        QCOMPARE(shown.find("readings")->geometry(), before);
    }
}

/// Ruling rows are bold where the column has room for it.
void LayoutTest::noDigitOfARulingRowIsCutOff() {
    setWindowLanguage(Language::Id::french);
    const ShownWindow shown(examplePath("rotary-axis"), {1280, 800});
    shown.window->workplace().selection().setParameter(u"A"_s);
    QCoreApplication::processEvents();
    int seen = 0;
    for (auto *view : shown.find("readingsPage")->findChildren<QTableView *>()) {
        for (int row = 0; row < view->model()->rowCount(); ++row) {
            for (int column = 1; column < view->model()->columnCount(); ++column) {
                const QModelIndex index = view->model()->index(row, column);
                const QRect cell = view->visualRect(index);
                if (view->isColumnHidden(column) || !view->viewport()->rect().contains(cell))
                    continue;
                ++seen;
                const QImage drawn = view->viewport()->grab(cell).toImage();
                constexpr int edge = 2; // of the place of the text
                for (int y = 4; y < drawn.height() - 4; ++y)
                    QVERIFY2(drawn.pixel(edge, y) == drawn.pixel(edge, 4),
                             qPrintable(index.data().toString()));
            }
        }
    }
    QVERIFY(seen > 10);
}

void LayoutTest::numbersFitTheirColumnsInAllUnits_data() {
    QTest::addColumn<DisplayUnits>("units");
    QTest::newRow("usual") << DisplayUnits{};
    QTest::newRow("mm, degrees") << DisplayUnits{LengthDisplay::millimetres, AngleDisplay::degrees};
    QTest::newRow("inches") << DisplayUnits{LengthDisplay::inches, AngleDisplay::arcSeconds};
}

/// A number that is cut reads as another one: in all tables of all pages.
void LayoutTest::numbersFitTheirColumnsInAllUnits() {
    QFETCH(const DisplayUnits, units);
    constexpr int mostRows = 30;
    static const QRegularExpression number(u"^[−+<\u00A0]*[0-9\u202F]+([.,][0-9]+)?$"_s);
    int seen = 0;
    for (const char *example : {"rotary-axis", "long-axis-with-zone", "iso230-4-full-circles-xy"}) {
        const ShownWindow shown(examplePath(example), {1366, 768});
        setWindowUnits(units);
        const auto restored = qScopeGuard([] { setWindowUnits({}); });
        for (const Page page : pages) {
            shown.window->workplace().showPage(page);
            QCoreApplication::processEvents();
            for (const QTableView *table : shown.window->findChildren<QTableView *>()) {
                const QAbstractItemModel *model = table->model();
                for (int row = 0; table->isVisible() && row < std::min(model->rowCount(), mostRows); ++row) {
                    for (int column = 0; column < model->columnCount(); ++column) {
                        const QModelIndex cell = model->index(row, column);
                        const QString text = cell.data().toString();
                        if (table->isColumnHidden(column) || !number.match(text).hasMatch())
                            continue;
                        const QVariant font = cell.data(Qt::FontRole);
                        const QFontMetrics metrics(font.isValid() ? font.value<QFont>() : table->font());
                        ++seen;
                        QVERIFY2(
                            metrics.horizontalAdvance(text) + 2 <= table->columnWidth(column),
                            qPrintable(u"%1, page %2, %3, column %4: %5"_s.arg(QLatin1StringView(example))
                                           .arg(int(page))
                                           .arg(table->objectName())
                                           .arg(column)
                                           .arg(text)));
                    }
                }
            }
        }
    }
    QVERIFY(seen > 300);
}

void LayoutTest::lowWindowsHaveRoomForAll_data() {
    QTest::addColumn<QString>("example");
    for (const char *name :
         {"rotary-axis", "iso230-2-1988-example", "iso230-4-full-circles-xy", "one-direction"})
        QTest::newRow(name) << examplePath(name);
}

void LayoutTest::lowWindowsHaveRoomForAll() {
    QFETCH(QString, example);
    for (const QSize size : {QSize(1024, 600), QSize(960, 720), QSize(1280, 720)}) {
        const ShownWindow shown(example, size);
        QCoreApplication::processEvents();
        QCOMPARE(shown.window->size(), size); // nothing pushes it open
        for (const Page page : {Page::readings, Page::conditions, Page::limits, Page::agreedPoints}) {
            shown.window->workplace().showPage(page);
            QCoreApplication::processEvents();
            QCOMPARE(shown.window->size(), size);
        }
        const auto *findings = shown.find("findingsPanel");
        if (findings->isVisible())
            QVERIFY(findings->mapTo(shown.window, QPoint(0, findings->height())).y() <= size.height());
    }
}

/// 1 920 × 1 080 at twice the scale, less the title of the window.
void LayoutTest::dialogsHaveRoomOnSmallScreens() {
    for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
        setWindowLanguage(language);
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        PlanDialog plan(shown.window->model(), 0);
        ReportDialog report(shown.window->model(), shown.window->evaluator());
        for (QDialog *dialog : std::initializer_list<QDialog *>{&plan, &report}) {
            dialog->show();
            QCoreApplication::processEvents();
            const QSize least = dialog->minimumSizeHint();
            QVERIFY2(least.width() <= 950 && least.height() <= 510,
                     qPrintable(
                         u"%1: %2 x %3"_s.arg(dialog->objectName()).arg(least.width()).arg(least.height())));
        }
    }
}

void LayoutTest::limitsStandAsATable() {
    const ShownWindow shown(examplePath("rotary-axis"));
    shown.window->workplace().showPage(Page::limits);
    QCoreApplication::processEvents();
    QList<Field *> limits;
    for (auto *field : shown.find("limitsPage")->findChildren<Field *>()) {
        if (field->edit()->objectName().startsWith(u"field.limits."_s))
            limits << field;
    }
    QVERIFY(limits.size() > 8);
    QCOMPARE(limits[0]->edit()->accessibleName(), u"Limit of A"_s);
    QCOMPARE(limits[0]->findChild<QLabel *>()->text(), u"Limit"_s); // the head of the column of all
    for (qsizetype i = 2; i < limits.size(); ++i) {
        QCOMPARE(limits[i]->x(), limits[1]->x());
        QVERIFY(limits[i]->y() - limits[i - 1]->y() <= 44); // a row, not a form
    }
    // One origin for all that were agreed.
    auto *all = shown.find("limitsPage")->findChildren<Field *>().last();
    QCOMPARE(all->edit()->accessibleName(), u"Origin of all limits"_s);
    auto *edit = qobject_cast<QLineEdit *>(all->edit());
    QVERIFY(edit);
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, u"contract 12"_s);
    int seen = 0;
    for (const auto &[id, limit] : shown.window->model().document()->tests[0]->limits) {
        ++seen;
        QCOMPARE(limit.source, std::string("contract 12"));
    }
    QVERIFY(seen > 1);
}

void LayoutTest::formsEndAt720() {
    const ShownWindow shown(examplePath("rotary-axis"), {2400, 1000});
    for (const auto &[page, name] :
         {std::pair(Page::conditions, "conditionsPage"), std::pair(Page::machine, "machinePage")}) {
        shown.window->workplace().showPage(page);
        QCoreApplication::processEvents();
        auto *form = shown.find(name);
        QVERIFY(form->width() > 900);
        for (const auto *field : form->findChildren<Field *>())
            QVERIFY2(field->mapTo(form, QPoint(field->width(), 0)).x() <= 16 + 720,
                     qPrintable(field->edit()->objectName()));
        // What is beside them is of their colour.
        const QImage drawn = form->grab().toImage();
        QCOMPARE(drawn.pixelColor(drawn.width() - drawn.width() / 20, drawn.height() / 2),
                 form->palette().color(QPalette::Base));
    }
}

/// 950 × 575 is what a screen of 1 920 × 1 200 at twice the scale leaves; below 944 the figure is under the
/// table.
void LayoutTest::sixTargetsAreInSight_data() {
    QTest::addColumn<Language::Id>("language");
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(1024, 600), QSize(960, 600), QSize(950, 575), QSize(960, 720),
                             QSize(990, 900), QSize(960, 1210), QSize(900, 720), QSize(900, 1210)}) {
        QTest::addRow("French, %d x %d", size.width(), size.height()) << Language::Id::french << size;
        QTest::addRow("English, %d x %d", size.width(), size.height()) << Language::Id::english << size;
    }
}

void LayoutTest::sixTargetsAreInSight() {
    QFETCH(Language::Id, language);
    QFETCH(QSize, size);
    setWindowLanguage(language);
    for (const char *example : {"iso230-2-1988-example", "rotary-axis"}) {
        const ShownWindow shown(examplePath(example), size);
        const auto *view = shown.find<QTableView>("readings");
        QTRY_VERIFY(view->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(shown.window->size(), size);
        QVERIFY(view->model()->rowCount() > 6);
        const QRect sixth = view->visualRect(view->model()->index(5, 0));
        QVERIFY2(view->viewport()->rect().contains(sixth),
                 qPrintable(QString::number(view->viewport()->height())));
    }
}

/// A test of which all is stated begins with its title; one that lacks much still needs little scrolling.
void LayoutTest::conditionsAreOnePage() {
    const ShownWindow complete(examplePath("rotary-axis"));
    complete.window->workplace().showPage(Page::conditions);
    QCOMPARE(complete.find("conditionsPage")->findChild<Field *>()->edit()->accessibleName(),
             u"Title of the test"_s);
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        for (const char *example : {"rotary-axis", "iso230-2-1988-example", "iso230-4-full-circles-xy"}) {
            const ShownWindow shown(examplePath(example), {1366, 768});
            shown.window->workplace().showPage(Page::conditions);
            for (auto *head : shown.find("conditionsPage")->findChildren<SectionHead *>()) {
                if (!head->isFolded())
                    head->click();
            }
            auto *fields = shown.find("conditionsFields");
            const int inView = fields->parentWidget()->height();
            QTRY_VERIFY2(
                2 * fields->height() <= 3 * inView,
                qPrintable(
                    u"%1: %2 of %3"_s.arg(QLatin1StringView(example)).arg(fields->height()).arg(inView)));
        }
    }
}

void LayoutTest::theMarkOfWhatIsRequiredHasItsColour() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    shown.window->workplace().showPage(Page::conditions);
    QCoreApplication::processEvents();
    int seen = 0;
    for (const auto *field : shown.find("conditionsPage")->findChildren<Field *>()) {
        for (auto *label : field->findChildren<QLabel *>()) {
            if (!label->isVisible() || !label->text().startsWith(u'●'))
                continue;
            ++seen;
            const QImage drawn = label->grab().toImage();
            const QColor wanted = token(Token::unsure, label->palette());
            bool found = false;
            for (int x = 0; x < drawn.width(); ++x) {
                for (int y = 0; y < drawn.height(); ++y)
                    found = found || drawn.pixelColor(x, y) == wanted;
            }
            QVERIFY2(found, qPrintable(field->edit()->accessibleName()));
        }
    }
    QVERIFY(seen > 5);
}

void LayoutTest::allExamplesAreInSight_data() {
    QTest::addColumn<Language::Id>("language");
    QTest::newRow("in English") << Language::Id::english;
    QTest::newRow("in French") << Language::Id::french;
}

void LayoutTest::allExamplesAreInSight() {
    QFETCH(Language::Id, language);
    setWindowLanguage(language);
    const ShownWindow shown({}, {1280, 770}); // a screen of 1 280 × 800 less the title of the window
    const std::array lists{shown.find<QListView>("examplesList"), shown.find<QListView>("teachingList")};
    QTRY_COMPARE(lists[0]->model()->rowCount() + lists[1]->model()->rowCount(),
                 static_cast<int>(examples().size()) + 1); // that of a type
    QTRY_VERIFY(std::ranges::all_of(lists, [&](const QListView *list) {
        for (int row = 0; row < list->model()->rowCount(); ++row) {
            const QRect place = list->visualRect(list->model()->index(row, 0));
            const QPoint end = list->viewport()->mapTo(shown.window, place.bottomRight());
            if (!list->viewport()->rect().contains(place) || !shown.window->rect().contains(end) ||
                !list->isVisible())
                return false;
        }
        return true;
    }));
    auto *scroll = qobject_cast<QScrollArea *>(shown.find("welcome")->findChild<QScrollArea *>());
    QVERIFY(scroll && !scroll->verticalScrollBar()->isVisible());
}

void LayoutTest::headsAreNotCutInAWord() {
    setWindowLanguage(Language::Id::french);
    for (const int width : {960, 1024, 1280}) {
        const ShownWindow shown(examplePath("iso230-2-1988-example"), {width, 720});
        QTest::qWait(20);
        bool title = false;
        for (const ElidedLabel *label : shown.find("figureView")->findChildren<ElidedLabel *>())
            title |= label->text() == u"Écart de position"_s && label->shownText() == label->text();
        QVERIFY2(title, QByteArray::number(width));
        const auto *summary = shown.find<ElidedLabel>("findingsSummary");
        const QString whole = summary->text();
        QString said = summary->shownText();
        QVERIFY(whole.contains(u" · "_s));
        QVERIFY(!said.isEmpty());
        if (said != whole) {
            QVERIFY2(said.endsWith(u" …"_s), qPrintable(said));
            said.chop(2);
            QVERIFY2(whole.startsWith(said + u" · "_s) || whole.startsWith(said + u", "_s), qPrintable(said));
        }
    }
}

void LayoutTest::choicesOfConditionsAreWhole() {
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        const ShownWindow shown(examplePath("iso230-2-1988-example"), {1280, 770});
        shown.window->workplace().showPage(Page::conditions);
        QTest::qWait(20);
        auto *correction = qobject_cast<ElidedBox *>([&]() -> QWidget * {
            for (auto *box : shown.find("conditionsPage")->findChildren<ElidedBox *>())
                if (box->findText(language == Language::Id::french ? u"appliquée par l’instrument"_s
                                                                   : u"applied by the instrument"_s) >= 0)
                    return box;
            return nullptr;
        }());
        QVERIFY(correction);
        for (int word = 0; word < correction->count(); ++word) {
            correction->setCurrentIndex(word);
            QCOMPARE(correction->shownText(), correction->currentText());
        }
    }
}

void LayoutTest::theEditionOfTheTestIsWholeBesideAView() {
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        for (const int width : {1024, 1280}) {
            const ShownWindow shown(examplePath("iso230-2-1988-example"), {width, 770});
            shown.window->evaluator().setView(0, "ISO 230-2:2014");
            QTest::qWait(20);
            const auto *summary = shown.find<QLabel>("testSummary");
            QVERIFY(summary->accessibleName().contains(u"ISO 230-2:1988"_s));
            QCOMPARE(summary->text(), summary->accessibleName());
        }
    }
}

void LayoutTest::namesOfLimitsAreWhole() {
    for (const auto &[example, language, size, least] :
         {std::tuple("iso230-2-1988-example", Language::Id::french, QSize(1280, 770), 10),
          std::tuple("iso230-4-full-circles-xy", Language::Id::english, QSize(960, 720), 7)}) {
        setWindowLanguage(language);
        const ShownWindow shown(examplePath(example), size);
        shown.window->workplace().showPage(Page::limits);
        QTest::qWait(20);
        int names = 0;
        for (const QLabel *label : shown.find("limitsPage")->findChildren<QLabel *>()) {
            if (!label->wordWrap() || label->text().isEmpty() || !label->isVisible())
                continue;
            ++names;
            const QRect needed = label->fontMetrics().boundingRect(QRect(0, 0, label->width(), 1000),
                                                                   Qt::TextWordWrap, label->text());
            QVERIFY2(needed.height() <= label->height() + 2 && needed.width() <= label->width(),
                     qPrintable(label->text()));
        }
        QVERIFY(names >= least);
    }
}

/// Qt makes them as narrow as their shortest text.
void LayoutTest::boxesAreWideEnoughToRead() {
    QMessageBox message(QMessageBox::Warning, u"Title"_s, u"Nothing was pasted"_s, QMessageBox::Ok);
    message.setInformativeText(u"line 5 of what was pasted begins with no symbol of this edition"_s);
    QInputDialog input;
    input.setLabelText(u"Name of the test"_s);
    for (QDialog *box : std::initializer_list<QDialog *>{&message, &input}) {
        box->show();
        QVERIFY2(box->width() >= 380, qPrintable(QString::number(box->width())));
    }
    const auto *informative = message.findChild<QLabel *>(u"qt_msgbox_informativelabel"_s);
    QVERIFY(informative);
    const QRect needed = informative->fontMetrics().boundingRect(QRect(0, 0, informative->width(), 1000),
                                                                 Qt::TextWordWrap, informative->text());
    QVERIFY2(needed.height() <= 2 * informative->fontMetrics().lineSpacing(),
             qPrintable(QString::number(informative->width())));
}

void LayoutTest::choicesOfACircleAreWhole() {
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        const ShownWindow shown(examplePath("iso230-4-feedback-yz"), {1280, 800});
        const auto *page = shown.find("circlesPage");
        QTRY_VERIFY(page->isVisible());
        QTest::qWait(20);
        for (const ElidedBox *box : page->findChildren<ElidedBox *>())
            QCOMPARE(box->shownText(), box->currentText());
        QVERIFY(page->findChildren<ElidedBox *>().size() >= 5);
    }
}

void LayoutTest::headOfTheDiagnosisHasAGap() {
    setWindowLanguage(Language::Id::french);
    const ShownWindow shown(examplePath("iso230-4-feedback-yz"), {960, 720});
    shown.window->workplace().showPage(Page::diagnosis);
    QTest::qWait(20);
    const auto *words = shown.find("diagnosisNature");
    const auto *count = shown.find("diagnosisSummary");
    QVERIFY(count->geometry().left() - words->geometry().right() > 8);
}

void LayoutTest::namesOfResultsAreWhole() {
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        for (const char *example : {"iso230-2-1988-example", "one-direction"}) {
            for (const int width : {960, 1024, 1280}) {
                const ShownWindow shown(examplePath(example), {width, 690});
                const auto *table = shown.find<QTableView>("results");
                QTRY_VERIFY(table->model()->rowCount() > 0);
                QTest::qWait(20);
                for (int row = 0; row < table->model()->rowCount(); ++row) {
                    const QString name =
                        table->model()->index(row, ResultsModel::columnOf("name")).data().toString();
                    QVERIFY2(QFontMetrics(table->font()).horizontalAdvance(name) <=
                                 table->columnWidth(ResultsModel::columnOf("name")) - 6,
                             qPrintable(name));
                }
            }
        }
    }
}

void LayoutTest::labelsOfFormsAreWhole() {
    QStringList cut;
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        for (const char *example :
             {"iso230-2-1988-example", "long-axis-with-zone", "rotary-axis", "iso230-4-full-circles-xy"}) {
            const ShownWindow shown(examplePath(example), {1280, 800});
            for (const Page page : pages) {
                shown.window->workplace().showPage(page);
                QTest::qWait(10);
                for (const Field *field : shown.window->findChildren<Field *>()) {
                    const auto *label = field->findChild<ElidedLabel *>();
                    if (label->isVisible() && label->shownText() != label->text())
                        cut += label->text();
                }
                for (const QCheckBox *box : shown.window->findChildren<QCheckBox *>()) {
                    const bool isWhole = box->sizeHint().width() <= box->width();
                    if (box->isVisible() && qobject_cast<const Field *>(box->parentWidget()) && !isWhole)
                        cut += box->text();
                }
            }
        }
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

void LayoutTest::formsHaveRoomInNarrowWindows() {
    QStringList cut;
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        for (const char *example : {"long-axis-with-zone", "rotary-axis", "iso230-4-full-circles-xy"}) {
            for (const int width : {960, 1024}) {
                const ShownWindow shown(examplePath(example), {width, 600});
                for (const Page page : pages) {
                    shown.window->workplace().showPage(page);
                    QTest::qWait(10);
                    for (const QScrollArea *area : shown.window->findChildren<QScrollArea *>()) {
                        if (area->isVisible() && area->widget()->width() > area->viewport()->width())
                            cut += u"%1, page %2, %3 pixels"_s.arg(QLatin1StringView(example))
                                       .arg(static_cast<int>(page))
                                       .arg(width);
                    }
                }
            }
        }
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

/// The first and the last column of a tool in which something is drawn, in its toolbar.
static std::pair<int, int> drawnOf(QToolButton &tool) {
    const QImage picture = tool.grab().toImage();
    const QRgb ground = picture.pixel(1, picture.height() / 2);
    std::pair<int, int> drawn(picture.width(), 0);
    for (int x = 0; x < picture.width(); ++x) {
        for (int y = 0; y < picture.height(); ++y) {
            if (picture.pixel(x, y) != ground)
                drawn = {std::min(drawn.first, x), std::max(drawn.second, x)};
        }
    }
    return {tool.x() + drawn.first, tool.x() + drawn.second};
}

/// From a word to the next icon, with or without a line between them.
void LayoutTest::toolsAreEvenlySpaced() {
    for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
        setWindowLanguage(language);
        for (const int width : {1280, 960}) {
            const ShownWindow shown(examplePath("iso230-2-1988-example"), {width, 800});
            QTest::qWait(20);
            std::vector<std::pair<int, int>> drawn;
            for (QToolButton *tool :
                 shown.find("toolBar")->findChildren<QToolButton *>(QString(), Qt::FindDirectChildrenOnly)) {
                if (tool->isVisible())
                    drawn.push_back(drawnOf(*tool));
            }
            QCOMPARE(drawn.size(), std::size_t(8));
            std::vector<int> gaps;
            QString said;
            for (std::size_t i = 1; i < drawn.size(); ++i) {
                gaps.push_back(drawn[i].first - drawn[i - 1].second);
                said += QString::number(gaps.back()) + u' ';
            }
            QVERIFY2(std::ranges::max(gaps) - std::ranges::min(gaps) <= 4, qPrintable(said));
        }
    }
}

void LayoutTest::wideWindowsSayFullNames() {
    setWindowLanguage(Language::Id::french);
    const auto name = [](int width) {
        const ShownWindow shown(examplePath("iso230-2-1988-example"), {width, 1050});
        const auto *table = shown.find<QTableView>("results");
        QTest::qWait(20);
        return table->model()->index(0, ResultsModel::columnOf("name")).data().toString();
    };
    QCOMPARE(name(1280), u"précision"_s);
    const ShownWindow resized(examplePath("iso230-2-1988-example"), {1280, 800});
    QTest::qWait(20);
    resized.window->resize(1920, 1050);
    const auto *table = resized.find<QTableView>("results");
    QTRY_VERIFY(table->model()->index(0, ResultsModel::columnOf("name")).data().toString().size() > 12);
    const QString full = name(1920);
    QVERIFY2(full.size() > 12 && full.startsWith(u"précision"_s), qPrintable(full));
}

void LayoutTest::wideWindowsShowMoreFindings() {
    const auto inSight = [](QSize size) {
        const ShownWindow shown(examplePath("iso230-2-1988-example"), size);
        QTest::qWait(20);
        return shown.find("findings")->height();
    };
    QVERIFY(inSight({1920, 1050}) >= 5 * inSight({1280, 800}) / 3);
    QVERIFY(inSight({1600, 900}) > inSight({1280, 800}));
}

void LayoutTest::startsSayTheirStandard() {
    const ShownWindow shown({}, {1280, 770});
    QVERIFY(shown.find("welcomeNew")
                ->accessibleDescription()
                .startsWith(u"ISO 230-2 · 1988, 1997, 2006, 2014, "_s));
    QVERIFY(shown.find("welcomeNewCircle")
                ->accessibleDescription()
                .startsWith(u"ISO 230-4 · 1996, 2005, 2022, "_s));
}

void LayoutTest::aDriftTestHasNoEmptyTable() {
    Document document = openDocument(examplePath("rotary-axis"));
    insertTest(document, 1, newDriftTest(Axis{}));
    const QTemporaryDir folder;
    const QString path = folder.filePath(u"a.palmer"_s);
    saveDocument(document, path);
    const ShownWindow shown(path);
    auto *results = shown.find("resultsPanel");
    QVERIFY(results->isVisible());
    shown.window->workplace().showTest(1);
    QVERIFY(!results->isVisible());
    const auto *model = shown.find<QListView>("navigation")->model();
    const auto icon = [&](int row) {
        return model->index(row, 0).data(NavigationModel::iconRole).toString();
    };
    QVERIFY(icon(model->rowCount() - 1) != icon(model->rowCount() - 2));
    shown.window->workplace().showTest(0);
    QVERIFY(results->isVisible());
    shown.window->resize(900, 720); // below one another, behind tabs
    shown.window->workplace().showTest(1);
    QVERIFY(!shown.find<QTabBar>("rightTabs")->isTabVisible(2));
}

void LayoutTest::pageAndFigureTakeTurnsInALowWindow_data() {
    QTest::addColumn<QString>("example");
    QTest::addColumn<QSize>("size");
    // What enlarged fonts leave of 1280 × 800, with the title of a window manager and without.
    for (const QSize size : {QSize(731, 440), QSize(731, 457), QSize(900, 600)}) {
        for (const char *example : {"iso230-2-1988-example", "rotary-axis", "iso230-4-full-circles-xy"})
            QTest::addRow("%s, %d", example, size.height()) << examplePath(example) << size;
    }
}

void LayoutTest::pageAndFigureTakeTurnsInALowWindow() {
    QFETCH(const QString, example);
    QFETCH(const QSize, size);
    const ShownWindow shown(example, size);
    auto *tabs = shown.find<QTabBar>("rightTabs");
    const auto *centre = shown.find("centre");
    const auto isWhole = [&](const char *name) { // none of it below the window
        const auto *part = shown.find(name);
        const QRect area(part->mapTo(shown.window, QPoint()), part->size());
        return part->isVisible() && shown.window->centralWidget()->geometry().contains(area);
    };
    QCOMPARE(shown.window->size(), size);
    QVERIFY(tabs->isVisible() && tabs->isTabVisible(0));
    QTRY_VERIFY(isWhole("centre") && isWhole("rightTabs"));
    if (const auto *view = shown.find<QTableView>("readings"); view->isVisible()) {
        const auto sixth = [&] { return view->visualRect(view->model()->index(5, 0)); };
        QTRY_VERIFY2(view->viewport()->rect().contains(sixth()),
                     qPrintable(u"%1 of %2"_s.arg(sixth().bottom()).arg(view->viewport()->height())));
        QVERIFY(isWhole("readings"));
    }
    const std::array parts{"figureView", "resultsPanel", "findingsPanel"};
    for (int i = 0; i < 3; ++i) {
        QVERIFY(!shown.find(parts.at(static_cast<std::size_t>(i)))->isVisible());
        tabs->setCurrentIndex(1 + i);
        QTRY_VERIFY(isWhole(parts.at(static_cast<std::size_t>(i))) && isWhole("rightTabs"));
        QVERIFY(!centre->isVisible());
        shown.window->workplace().showPage(Page::conditions); // as from a finding
        QTRY_VERIFY(isWhole("centre"));
        QCOMPARE(tabs->currentIndex(), 0);
    }
    if (!example.contains(u"230-4")) { // explained beside the page
        tabs->setCurrentIndex(2);
        shown.window->workplace().selection().setParameter("A");
        QTRY_VERIFY(isWhole("explanation"));
        shown.window->workplace().selection().setParameter({});
    }
    shown.window->workplace().showPage(Page::readings);
    for (int i = 0; i < 6 && !shown.find("figureView")->isVisible(); ++i)
        shown.window->workplace().focusNextPane(true);
    QTRY_VERIFY(isWhole("figureView"));
    shown.window->resize(1280, 800);
    QTRY_VERIFY(centre->isVisible() && shown.find("resultsPanel")->isVisible());
    QVERIFY(!tabs->isVisible());
    shown.window->resize(size);
    QTRY_VERIFY(isWhole("centre") && isWhole("rightTabs"));
}

void LayoutTest::pointsThatDoNotApplyAreFoldedAway() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    shown.window->workplace().showPage(Page::agreedPoints);
    auto *zone = shown.find("field.agreedPoints.zone"); // of axes longer than 2 m
    auto *gradient = shown.find("field.agreedPoints.gradient");
    QVERIFY(!zone->isVisible() && gradient->isVisible());
    auto *others = shown.find<QPushButton>("inapplicablePoints");
    QVERIFY(others->isVisible() && others->text().startsWith(u"1 "_s));
    others->click();
    QVERIFY(zone->isVisible() && !others->isVisible());
}

/// From one field to the next, in both languages; no name is cut.
void LayoutTest::agreedPointsAreSeventyHigh() {
    for (const Language::Id id : {Language::Id::english, Language::Id::french}) {
        setWindowLanguage(id);
        const ShownWindow shown(examplePath("long-axis-with-zone"), {1366, 768});
        shown.window->workplace().showPage(Page::agreedPoints);
        QTest::qWait(20);
        int before = 0;
        int seen = 0;
        for (const auto *text : shown.find("agreedPointsPage")->findChildren<QLineEdit *>()) {
            if (!text->objectName().startsWith(u"field.agreedPoints."_s) || !text->isVisible())
                continue;
            const int at = text->mapTo(shown.window.data(), QPoint()).y();
            QVERIFY2(seen == 0 || at - before <= 70, qPrintable(QString::number(at - before)));
            before = at;
            ++seen;
            for (const auto *label : text->parentWidget()->findChildren<QLabel *>()) {
                if (label->buddy() == text)
                    QVERIFY2(label->heightForWidth(label->width()) <= label->height(),
                             qPrintable(label->text()));
            }
        }
        QVERIFY(seen > 5);
    }
}

void LayoutTest::sevenTabsAreInSight_data() {
    QTest::addColumn<int>("width");
    QTest::newRow("narrow") << 1024;
    QTest::newRow("as it is opened") << 1280;
    QTest::newRow("usual") << 1366;
}

/// The page of a circle with its counts, in the longer language.
void LayoutTest::sevenTabsAreInSight() {
    QFETCH(int, width);
    setWindowLanguage(Language::Id::french);
    const ShownWindow shown(examplePath("teaching-04-squareness"), {width, 768});
    auto *tabs = shown.find<PageTabs>("pageTabs");
    for (const int tab : {0, 1, 2, 4}) // as in a new file
        tabs->setCount(tab, 18);
    int visible = 0;
    for (int tab = 0; tab < tabs->count(); ++tab) {
        if (!tabs->isTabVisible(tab))
            continue;
        ++visible;
        shown.window->findChild<QTabBar *>("pageTabs")->setCurrentIndex(tab);
        QTest::qWait(20);
        QVERIFY2(tabs->tabRect(0).left() >= 0, qPrintable(tabs->tabText(tab)));
        QVERIFY2(tabs->tabRect(tabs->count() - 2).right() <= tabs->width(), qPrintable(tabs->tabText(tab)));
    }
    QCOMPARE(visible, 7);
}

/// As in a small window of a screen with large pixels.
void LayoutTest::theStatusIsNotCutInALetter() {
    const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {683, 512});
    const auto *lack = shown.find<ElidedButton>("statusLack");
    QTRY_VERIFY(lack->isVisible() && lack->shownText().endsWith(u'…'));
    QVERIFY(lack->fontMetrics().horizontalAdvance(lack->shownText()) <= lack->width());
    QVERIFY(lack->geometry().right() < lack->parentWidget()->width());
}

/// 24 px at least, on every page.
void LayoutTest::buttonsCanBeHit() {
    const ShownWindow shown(examplePath("x-axis-as-found-as-left"), {1366, 768});
    QStringList small;
    for (int page = 0; page <= static_cast<int>(Page::comparison); ++page) {
        shown.window->workplace().showPage(static_cast<Page>(page));
        QTest::qWait(20);
        for (const auto *button : shown.window->findChildren<QAbstractButton *>()) {
            const bool isBox = qobject_cast<const QCheckBox *>(button); // its words belong to it
            if (button->isVisible() && !isBox && !qobject_cast<QLineEdit *>(button->parentWidget()) &&
                std::min(button->width(), button->height()) < 24)
                small << u"%1 %2 × %3"_s.arg(button->objectName()).arg(button->width()).arg(button->height());
        }
    }
    small.removeDuplicates();
    QVERIFY2(small.isEmpty(), qPrintable(small.join(u"; ")));
}

void LayoutTest::agreedPointsBeginWithACapital() {
    for (const Language::Id language : {Language::Id::english, Language::Id::french}) {
        setWindowLanguage(language);
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        shown.window->workplace().showPage(Page::agreedPoints);
        int seen = 0;
        for (const auto *edit : shown.find("agreedPointsPage")->findChildren<QLineEdit *>()) {
            if (!edit->objectName().startsWith(u"field."_s))
                continue;
            ++seen;
            QVERIFY2(edit->accessibleName().at(0).isUpper(), qPrintable(edit->accessibleName()));
        }
        QVERIFY(seen > 4);
    }
}

void LayoutTest::theNumberOfAnAgreementIsTypedBesideItsText() {
    const ShownWindow shown(examplePath("iso230-2-1988-example"));
    QVERIFY(QTest::qWaitForWindowActive(shown.window));
    shown.window->workplace().showPage(Page::agreedPoints);
    auto *value = shown.find<QLineEdit>("value.gradient");
    value->setFocus();
    QTest::keyClicks(value, u"0,5"_s);
    const auto agreed = [&]() -> std::optional<AgreedPoint> {
        for (const AgreedPoint &point : shown.window->model().document()->tests[0]->agreedPoints) {
            if (point.point == "gradient")
                return point;
        }
        return {};
    };
    QVERIFY(agreed());
    QCOMPARE(agreed()->value, std::optional(0.5));
    QCOMPARE(agreed()->state, AgreementState::agreed);     // to state a number is to agree
    shown.find("field.agreedPoints.gradient")->setFocus(); // a visit of its own
    value->setFocus();
    QTest::keyClick(value, Qt::Key_End);
    QTest::keyClicks(value, u"x"_s);
    QCOMPARE(agreed()->value, std::optional(0.5)); // what is no number is not taken, and is told on closing
    QVERIFY(shown.window->workplace().refusedTexts().contains(u"0.5x"_s));
    QVERIFY(shown.window->findChild<QLineEdit *>(u"value.feed"_s));
    QVERIFY(!shown.window->findChild<QLineEdit *>(u"value.warmUp"_s));
}

/// E_VE and R_LSC are drawn with a lower index: narrower than the letters side by side.
void LayoutTest::symbolsInLabelsHaveTheirIndex() {
    QVERIFY(namesSymbol(u"Env. variation E_VE"_s) && namesSymbol(u"R_LSC − R"_s));
    QVERIFY(!namesSymbol(u"a_file_name.palmer"_s));
    const auto drawn = [](const QString &text) {
        ElidedLabel label;
        label.setText(text);
        label.resize(300, 30);
        const QImage picture = label.grab().toImage();
        int right = 0;
        for (int x = 0; x < picture.width(); ++x) {
            for (int y = 0; y < picture.height(); ++y) {
                if (picture.pixel(x, y) != picture.pixel(picture.width() - 1, 0))
                    right = x;
            }
        }
        return right;
    };
    QVERIFY(drawn(u"E_VE"_s) > 0);
    QVERIFY(drawn(u"E_VE"_s) < drawn(u"EVE"_s));
}

/// What Qt's French catalogue lacks, and what it calls otherwise, stands in ours.
void LayoutTest::textsOfQtAreFrench() {
    setWindowLanguage(Language::Id::french);
    const auto say = [](const char *context, const char *text, const char *comment) {
        return QCoreApplication::translate(context, text, comment);
    };
    QCOMPARE(say("QAbstractFileIconProvider", "Folder", "All other platforms"), u"Dossier"_s);
    QCOMPARE(say("QAbstractFileIconProvider", "Drive", nullptr), u"Lecteur"_s);
    QCOMPARE(say("QPlatformTheme", "Discard", nullptr), u"Ne pas enregistrer"_s);
    QCOMPARE(say("QFileDialog", "New Folder", nullptr), u"Nouveau dossier"_s); // Qt's own is there as before
}

QTEST_MAIN(LayoutTest)
#include "layouttest.moc"
