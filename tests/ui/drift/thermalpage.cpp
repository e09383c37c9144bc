// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/drift/thermalpage.h"
#include "document/edits.h"
#include "kernel/measurement/testfacts.h"
#include "ui/elidedlabel.h"
#include "ui/figures/figurecard.h"
#include "ui/rowtable.h"
#include "ui/window/shownwindow.h"

#include <QComboBox>
#include <QPushButton>
#include <QTest>

using namespace palmer;
using namespace palmer::ui;

class ThermalPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }
    void init() { setWindowLanguage(Language::Id::english); }

    void showsResponsesAndWhatTheyExplain() {
        const ShownWindow shown(examplePath("thermal-behaviour"));
        auto &workplace = shown.window->workplace();
        workplace.showTest(1);
        workplace.showPage(Page::thermal);
        const auto *responses = shown.find<RowTable>("responses");
        QTRY_COMPARE(responses->rowCount(), 3);
        QCOMPARE(responses->item(0, 0)->text(), QString("X"));
        QVERIFY(responses->item(0, 2)->text().startsWith("3.3"));
        QVERIFY(shown.find<LineView>("driftChannels")->figure().has_value());
        QVERIFY(shown.find<LineView>("variationFigure")->figure().has_value());
        const auto *cases = shown.find<RowTable>("driftCases");
        QCOMPARE(cases->rowCount(), 7);
        QVERIFY(!shown.find<QPushButton>("takeVariation")->isEnabled()); // it is taken already
        workplace.showPage(Page::readings);
        QVERIFY(!shown.find<QWidget>("thermalSide")->isVisible());
    }

    void theVariationIsTakenIntoTheBudget() {
        const ShownWindow shown(examplePath("thermal-behaviour"));
        shown.window->model().edit("", [](Document &document) {
            editTest(document, 0, [](Test &test) {
                withUncertainty(test, [](auto &inputs) { inputs.driftTest.reset(); });
            });
        });
        shown.window->workplace().showTest(1);
        shown.window->workplace().showPage(Page::thermal);
        auto *take = shown.find<QPushButton>("takeVariation");
        QTRY_VERIFY(take->isEnabled());
        take->click();
        const std::string *taken = driftTestOf(*shown.window->model().document()->tests[0]);
        QVERIFY(taken && *taken == shown.window->model().document()->tests[1]->id);
    }

    void aChannelWithoutNameHasItsNumber() {
        const ShownWindow shown(examplePath("thermal-behaviour"));
        shown.window->model().edit("", [](Document &document) {
            editTest(document, 1, [](Test &test) {
                for (DriftChannel &channel : std::get<DriftMeasurement>(test.measurement).channels)
                    channel.name.clear();
            });
        });
        shown.window->workplace().showTest(1);
        shown.window->workplace().showPage(Page::thermal);
        const auto *channel = shown.find<QComboBox>("thermalChannel");
        QTRY_COMPARE(channel->itemText(1), QString("2"));
        const auto *user = shown.find<ElidedBox>("thermalUser"); // a channel of no test's axis
        QCOMPARE(user->count(), 0);
        QCOMPARE(user->shownText(), QString("no test of these axes"));
    }
};

QTEST_MAIN(ThermalPageTest)
#include "thermalpage.moc"
