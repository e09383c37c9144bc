// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/diagnosis/diagnosispage.h"
#include "ui/elidedlabel.h"
#include "ui/figures/circlecanvas.h"
#include "ui/window/pagetabs.h"
#include "ui/window/shownwindow.h"

#include <QImage>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;

namespace {

bool isSyntheticDrawn(const ShownWindow &shown) {
    const auto figure = shown.window->findChild<CircleCanvas *>()->paperFigure();
    return figure && std::ranges::any_of(figure->traces, &CircleTrace::synthetic);
}

} // namespace

/// The tab of the diagnosis and the figure beside it.
class DiagnosisWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void theFigureShowsWhatIsTickedWhileTheTabIsInView() {
        const ShownWindow shown(examplePath("iso230-4-full-circles-xy"));
        auto &workplace = shown.window->workplace();
        QTRY_VERIFY(shown.window->findChild<CircleCanvas *>()->paperFigure());
        QVERIFY(!isSyntheticDrawn(shown));
        workplace.showPage(Page::diagnosis);
        auto *page = shown.find<DiagnosisPage>("diagnosisPage");
        QVERIFY(page->isVisible());
        QTRY_VERIFY(isSyntheticDrawn(shown));
        QVERIFY(!page->tracedNames().isEmpty());
        const auto figure = *shown.window->findChild<CircleCanvas *>()->paperFigure();
        QVERIFY(std::ranges::any_of(figure.legend, [](const CircleLegendEntry &entry) {
            return entry.sample == CircleLegendSample::synthetic && entry.text == "synthetic path";
        }));
        // The measured paths keep their marks and results.
        QCOMPARE(figure.arrows.size(), std::size_t(2));
        QCOMPARE(figure.starts.size(), std::size_t(2));
        workplace.showPage(Page::limits);
        QVERIFY(!isSyntheticDrawn(shown));
    }

    /// What it is drawn about stands in a corner of its own.
    void theSyntheticPathIsNamedBesideTheCentre() {
        setWindowLanguage(Language::Id::french);
        const ShownWindow shown(examplePath("iso230-4-full-circles-xy"));
        auto *canvas = shown.window->findChild<CircleCanvas *>();
        QTRY_VERIFY(canvas->paperFigure() && !canvas->isMaking());
        const QRect corner(0, 0, canvas->width() * 3 / 10, 40);
        const QImage before = canvas->grab(corner).toImage();
        shown.window->workplace().showPage(Page::diagnosis);
        QTRY_VERIFY(isSyntheticDrawn(shown));
        QTRY_VERIFY(!canvas->isMaking());
        QCOMPARE(canvas->grab(corner).toImage(), before);
    }

    void nothingOfItIsCutOff() {
        for (const Language::Id language : {Language::Id::french, Language::Id::english}) {
            setWindowLanguage(language);
            const ShownWindow shown(examplePath("iso230-4-full-circles-xy"), {1280, 800});
            shown.window->workplace().showPage(Page::diagnosis);
            for (const char *name : {"diagnosisSummary", "chartNote"}) {
                const auto *label = shown.find<ElidedLabel>(name);
                QTRY_VERIFY(!label->text().isEmpty() && label->isVisible());
                QCOMPARE(label->shownText(), label->text());
            }
        }
    }

    void theSyntheticPathIsNotPointedAt() {
        const ShownWindow shown(examplePath("iso230-4-full-circles-xy"));
        auto &workplace = shown.window->workplace();
        workplace.showPage(Page::diagnosis);
        QTRY_VERIFY(isSyntheticDrawn(shown));
        auto *canvas = shown.window->findChild<CircleCanvas *>();
        const QString text = canvas->readOut({0, 0});
        QVERIFY(text.startsWith("XY"));
        workplace.showPage(Page::readings);
        QCOMPARE(canvas->readOut({0, 0}), text);
    }

    void onlyCirclesHaveTheTab() {
        const ShownWindow shown(examplePath("iso230-2-1988-example"));
        auto *tabs = shown.find<PageTabs>("pageTabs");
        int diagnosis = 0;
        while (diagnosis < tabs->count() && !tabs->tabText(diagnosis).remove(u'&').contains("Diagnosis"))
            ++diagnosis;
        QVERIFY(diagnosis < tabs->count());
        QVERIFY(!tabs->isTabVisible(diagnosis));
        shown.window->workplace().showPage(Page::diagnosis); // the shortcut
        QCOMPARE(shown.window->workplace().selection().page(), Page::readings);
        const ShownWindow circle(examplePath("iso230-4-full-circles-xy"));
        QVERIFY(circle.find<PageTabs>("pageTabs")->isTabVisible(diagnosis));
    }

    void theStartAngleIsCorrectedAndUndone() {
        const ShownWindow shown(examplePath("iso230-4-full-circles-xy"));
        DocumentModel &model = shown.window->model();
        const auto angleOf = [](const Document &document) {
            return std::get<CircularMeasurement>(document.tests[0]->measurement).arcs[1].angles[7];
        };
        const Document before = *model.document();
        emit shown.find<DiagnosisPage>("diagnosisPage")->startAngleCorrected(0.25);
        QVERIFY(std::abs(angleOf(*model.document()) - (angleOf(before) - 0.25)) < 1e-9);
        model.undoStack()->undo();
        QVERIFY(*model.document() == before);
    }

    void anEditIsDiagnosedAnew() {
        const ShownWindow shown(examplePath("iso230-4-full-circles-xy"));
        shown.window->workplace().showPage(Page::diagnosis);
        QTRY_VERIFY(isSyntheticDrawn(shown));
        Document changed = *shown.window->model().document();
        palmer::Test test = *changed.tests[0];
        std::get<CircularMeasurement>(test.measurement).arcs[0].radialDeviations[10] += 1e-3;
        changed.tests[0] = std::make_shared<const palmer::Test>(std::move(test));
        shown.window->model().setDocument(std::move(changed), {});
        // The path of before belongs to another evaluation: not drawn until there is one of this.
        QTRY_VERIFY(isSyntheticDrawn(shown));
    }
};

QTEST_MAIN(DiagnosisWindowTest)
#include "diagnosiswindow.moc"
