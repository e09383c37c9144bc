// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/circlespage.h"
#include "ui/figures/circlecanvas.h"
#include "ui/results/resultsmodel.h"
#include "ui/window/shownwindow.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

using namespace palmer;
using namespace palmer::ui;
using namespace Qt::StringLiterals;

namespace {

constexpr const char *example = "iso230-4-full-circles-xy";

QTableView *results(const ShownWindow &shown) {
    return shown.find<QTableView>("results");
}

QString valueOf(const ShownWindow &shown, int row) {
    return results(shown)->model()->index(row, ResultsModel::columnOf("value")).data().toString();
}

} // namespace

/// A circular test in the window as a whole.
class CirclesWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void showsPageFigureAndResults() {
        const ShownWindow shown(examplePath(example));
        QTRY_COMPARE(results(shown)->model()->rowCount(), 8);
        QVERIFY(shown.find<CirclesPage>("circlesPage")->isVisible());
        QVERIFY(!shown.find<QWidget>("readingsPage")->isVisible());
        QVERIFY(shown.window->findChild<CircleCanvas *>()->isVisible());
        QStringList texts;
        for (const QLabel *label : shown.window->findChildren<QLabel *>())
            texts << label->text();
        QVERIFY(texts.contains(u"2 arcs · 3\u202f600 points"_s));
        shown.window->workplace().selection().setHovered(ReadingPlace{0, 0});
        texts.clear();
        for (const QLabel *label : shown.window->findChildren<QLabel *>())
            texts << label->text();
        // The number of the label in the figure, about the centre of it, beside that which was read.
        const QString label = shown.window->findChild<CircleCanvas *>()->readOut({0, 0});
        const QString drawn = shown.window->findChild<CircleCanvas *>()->deviationText({0, 0});
        QVERIFY(!drawn.isEmpty() && label.contains(drawn));
        QVERIFY(texts.contains(u"anticlockwise, point 1: 0.1° · −2.211\u00a0µm · in the figure "_s + drawn));
    }

    void anEmptyTestOffersToImport() {
        const ShownWindow shown(examplePath(example));
        QVERIFY(!shown.find<QAbstractButton>("importArcs")->isVisible());
        shown.window->model().edit("take the arcs away", [](Document &document) {
            auto test = std::make_shared<palmer::Test>(*document.tests[0]);
            std::get<CircularMeasurement>(test->measurement).arcs.clear();
            document.tests[0] = std::move(test);
        });
        QTRY_VERIFY(shown.find<QAbstractButton>("importArcs")->isVisible());
        bool asked = false;
        QTimer::singleShot(0, shown.window, [&] {
            auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            asked = dialog->objectName() == u"importDialog"_s;
            dialog->reject();
        });
        shown.find<QAbstractButton>("importArcs")->click();
        QVERIFY(asked);
    }

    void anEmptyTestCountsAsFrenchDoes() {
        setWindowLanguage(Language::Id::french);
        const ShownWindow shown(examplePath(example));
        shown.window->model().edit("take the arcs away", [](Document &document) {
            auto test = std::make_shared<palmer::Test>(*document.tests[0]);
            std::get<CircularMeasurement>(test->measurement).arcs.clear();
            document.tests[0] = std::move(test);
        });
        const auto says = [&](const QString &text) {
            const auto labels = shown.window->findChildren<QLabel *>();
            return std::ranges::any_of(labels, [&](const QLabel *label) { return label->text() == text; });
        };
        QTRY_VERIFY(says(u"0 arc · 0 point"_s));
    }

    void aShorterRangeGivesOtherResultsUntilItIsUndone() {
        const ShownWindow shown(examplePath(example));
        QTRY_COMPARE(results(shown)->model()->rowCount(), 8);
        const QString before = valueOf(shown, 1); // G of the first path
        auto *from = shown.find<QLineEdit>("evaluatedFrom");
        from->selectAll();
        QTest::keyClicks(from, u"180"_s);
        QTRY_VERIFY(valueOf(shown, 1) != before);
        QVERIFY(shown.window->model().isModified());
        shown.window->model().undoStack()->undo();
        QTRY_COMPARE(valueOf(shown, 1), before);
        QCOMPARE(from->text(), u"0.1"_s);
    }

    void positioningTestsKeepTheirPage() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        QTRY_VERIFY(results(shown)->model()->rowCount() > 0);
        QVERIFY(shown.find<QWidget>("readingsPage")->isVisible());
        QVERIFY(!shown.find<CirclesPage>("circlesPage")->isVisible());
    }

    void everyControlHasANameAndIsReached_data() {
        QTest::addColumn<Language::Id>("language");
        QTest::newRow("in English") << Language::Id::english;
        QTest::newRow("in French") << Language::Id::french;
    }

    void everyControlHasANameAndIsReached() {
        QFETCH(const Language::Id, language);
        setWindowLanguage(language);
        const ShownWindow shown(examplePath(example));
        QTRY_COMPARE(results(shown)->model()->rowCount(), 8);
        QStringList names;
        int controls = 0;
        for (const QWidget *part :
             {shown.find<QWidget>("circlesPage"), shown.find<QWidget>("circleFigureView")}) {
            for (const QWidget *widget : part->findChildren<QWidget *>()) {
                const bool control =
                    qobject_cast<const QAbstractButton *>(widget) ||
                    qobject_cast<const QComboBox *>(widget) || qobject_cast<const QLineEdit *>(widget) ||
                    (qobject_cast<const QAbstractItemView *>(widget) && !widget->objectName().isEmpty() &&
                     widget->focusPolicy() != Qt::NoFocus);
                if (!control || !widget->isVisible() || widget->objectName().startsWith(u"qt_"_s))
                    continue;
                ++controls;
                const auto *button = qobject_cast<const QAbstractButton *>(widget);
                const QString name = !widget->accessibleName().isEmpty() || !button ? widget->accessibleName()
                                                                                    : button->text();
                QVERIFY2(!name.isEmpty(), qPrintable(widget->objectName()));
                QVERIFY2(widget->focusPolicy() & Qt::TabFocus, qPrintable(widget->objectName()));
                names << name;
            }
        }
        QVERIFY(controls >= 20);
        QCOMPARE(names.contains(u"Rayon nominal"_s), language == Language::Id::french);
        QCOMPARE(names.contains(u"Nominal radius"_s), language == Language::Id::english);
    }

    /// The points stay within reach: the page is higher than its place then, and scrolls.
    void whatHasNoRoomScrolls() {
        const ShownWindow shown(examplePath(example), {1180, 640});
        QTRY_COMPARE(results(shown)->model()->rowCount(), 8);
        auto *page = shown.find<CirclesPage>("circlesPage");
        QCoreApplication::processEvents(); // layouts
        const auto *points = shown.find<QTableView>("points");
        QVERIFY(points->isVisible() && points->viewport()->height() >= 3 * points->rowHeight(0));
        QVERIFY(shown.find<QWidget>("arcCurves")->isVisible());
        // nothing lies on anything else
        std::vector<const QWidget *> parts;
        for (const QWidget *part : page->findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
            if (part->isVisible())
                parts.push_back(part);
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY2(!parts[i]->geometry().intersects(parts[j]->geometry()),
                         qPrintable(parts[i]->objectName() + u" on "_s + parts[j]->objectName()));
        }
    }
};

QTEST_MAIN(CirclesWindowTest)
#include "circleswindow.moc"
