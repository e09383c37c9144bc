// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "document/thermal.h"

#include "document/edits.h"
#include "document/readdocument.h"
#include "document/writedocument.h"
#include "kernel/diagnosis/synthesize.h"
#include "kernel/measurement/testfacts.h"
#include "report/parts/thermalparts.h"

#include <QTest>
#include <cmath>

using namespace palmer;

namespace {

/// A drift of two channels over eight hours and a positioning test of X that takes it.
Document withDrift(std::optional<double> minutes) {
    DriftSynthesis asked;
    asked.channels = {{"X", 0.0033, 45 * 60.0, 0}, {"Y", -0.0019, 64 * 60.0, 0}};
    asked.noise.deviation = 0.00005;
    Test drift;
    drift.id = "d";
    drift.measurement = synthesizeDrift(asked);
    PositioningSynthesis axis;
    for (int i = 0; i < 6; ++i)
        axis.targets.push_back(100.0 * i);
    axis.noise.deviation = 0.0005;
    Test test;
    test.id = "x";
    test.edition = "ISO 230-2:2006";
    PositioningMeasurement measured = synthesizePositioning(axis);
    measured.uncertainty.method = UncertaintyMethod::budget;
    measured.uncertainty.device.fixed = 0;
    measured.uncertainty.device.perMetre = 1;
    measured.uncertainty.misalignmentRange = 0.5;
    measured.uncertainty.temperatureRange = {1, 0};
    measured.uncertainty.expansionRange = {2, 0};
    measured.conditions.common.expansion = {11.5, 0};
    measured.conditions.common.sensors = {{SensorMeasures::machine, {}, 20.5, 20.5, {}}};
    measured.uncertainty.driftTest = "d";
    test.duration = minutes;
    test.measurement = std::move(measured);
    Document document;
    document.tests = {std::make_shared<const Test>(std::move(drift)),
                      std::make_shared<const Test>(std::move(test))};
    return document;
}

const Test &positioning(const Document &document) {
    return *document.tests[1];
}

} // namespace

class ThermalDocumentTest : public QObject {
    Q_OBJECT

private slots:
    void theDurationLimitsTheWindow() {
        const Document document = withDrift(40);
        const auto found = driftVariation(document, "d", positioning(document));
        const auto &drift = std::get<DriftMeasurement>(document.tests[0]->measurement);
        double largest = 0; // a double loop over the channel of the axis
        for (std::size_t i = 0; i < drift.times.size(); ++i) {
            for (std::size_t j = i; j < drift.times.size() && drift.times[j] <= drift.times[i] + 2400; ++j)
                largest =
                    std::max(largest, std::abs(*drift.channels[0].values[j] - *drift.channels[0].values[i]));
        }
        QCOMPARE(found->value, largest);
        QVERIFY(!found->isLowerBound);
        const Document endless = withDrift({});
        const auto whole = driftVariation(endless, "d", positioning(endless));
        QCOMPARE(whole->value, *rangeOf(std::get<DriftMeasurement>(endless.tests[0]->measurement)));
        QVERIFY(whole->value > 2 * found->value);
    }

    void aRecordShorterThanTheTestIsSaid() {
        const Document document = withDrift(600);
        QVERIFY(driftVariation(document, "d", positioning(document))->isLowerBound);
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
        QVERIFY(std::ranges::any_of(evaluated.tests[1]->findings, [](const Finding &finding) {
            return std::string_view(finding.message.text.source).find("lower bound") !=
                   std::string_view::npos;
        }));
    }

    /// A record that is too short, or has a long gap, says "at least": of E_VE, its share and U.
    void aLowerBoundIsSaidToBeOne_data() {
        QTest::addColumn<double>("minutes");
        QTest::addColumn<bool>("hasGap");
        QTest::addColumn<bool>("isLowerBound");
        QTest::newRow("within the record") << 40.0 << false << false;
        QTest::newRow("a longer test") << 600.0 << false << true;
        QTest::newRow("a gap") << 40.0 << true << true;
    }
    void aLowerBoundIsSaidToBeOne() {
        QFETCH(double, minutes);
        QFETCH(bool, hasGap);
        QFETCH(bool, isLowerBound);
        Document document = withDrift(minutes);
        if (hasGap)
            editMeasurement<DriftMeasurement>(document, 0, [](DriftMeasurement &drift) {
                for (std::size_t i = 0; i < drift.times.size(); ++i) {
                    if (drift.times[i] > 3600 && drift.times[i] < 7200)
                        drift.channels[0].values[i].reset();
                }
            });
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
        const DriftCases cases = driftCases(evaluated, 1);
        QCOMPARE(cases.cases[0].isLowerBound, isLowerBound);
        const bool holds = std::ranges::any_of(
            cases.cases, [](const DriftCase &one) { return one.kind == DriftCase::held; });
        QVERIFY(!(holds && isLowerBound)); // no "at most" with a part that is "at least"
        const QString sign = QString("≥") + QChar(QChar::Nbsp);
        const Language english(Language::Id::english);
        const auto blocks = thermalBlocks(evaluated, 0, english);
        const auto &headline = std::get<VerdictLine>(blocks.front());
        QCOMPARE(headline.word.startsWith(sign), isLowerBound);
        QCOMPARE(headline.limits.state.startsWith(sign), isLowerBound);
        QCOMPARE(headline.limits.text.plain().startsWith("U(A) ≥"), isLowerBound);
        const Table table = driftCaseTable(cases, false, english);
        for (std::size_t i = 1; i < 5; ++i) // E_VE, share, U(A), U(R)
            QCOMPARE(table.rows[0][i].text.plain().startsWith(sign), isLowerBound);
    }

    void sentencesHaveANameAndAShortTime_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("warm"); // s
        QTest::addColumn<QString>("begin");
        QTest::newRow("a third of an hour") << "X" << 12000.0 << "X was warm after 3.33 h:";
        QTest::newRow("whole hours") << "X" << 14400.0 << "X was warm after 4 h:";
        QTest::newRow("without a name") << "" << 14400.0 << "– was warm after 4 h:";
    }
    void sentencesHaveANameAndAShortTime() {
        QFETCH(QString, name);
        QFETCH(double, warm);
        QFETCH(QString, begin);
        ThermalChannel channel;
        channel.channel.name = name.toStdString();
        ThermalResponse &response = channel.responses.emplace_back();
        response.tau = 1;
        response.times = {0, warm, 36000};
        response.response = {1, 1, 0};
        channel.best = 0;
        DriftMeasurement drift;
        drift.temperatures = {{"air", {}, {20.0, 21.0, 21.0}}};
        const QString text = thermalNotes(drift, {channel}, Language(Language::Id::english)).last();
        QVERIFY2(text.simplified().startsWith(begin), qPrintable(text));
    }

    void onlyTheChannelOfTheAxisCounts() {
        Document document = withDrift(40);
        editMeasurement<DriftMeasurement>(document, 0,
                                          [](DriftMeasurement &drift) { drift.channels[0].name = "Z"; });
        QVERIFY(!driftVariation(document, "d", positioning(document)));
    }

    /// A number beside the drift test wins: the test takes nothing from it.
    void aNumberTakesNothing() {
        Document document = withDrift(40);
        const auto takers = [&] { return testsTaking(document, "d").size(); };
        const auto cases = [&] {
            return driftCases(evaluate(std::make_shared<const Document>(document)), 1).cases.size();
        };
        QCOMPARE(takers(), std::size_t(1));
        QVERIFY(cases() > 0);
        editMeasurement<PositioningMeasurement>(document, 1, [](PositioningMeasurement &measurement) {
            measurement.uncertainty.environmentalVariation = 3;
        });
        QCOMPARE(takers(), std::size_t(0));
        QCOMPARE(cases(), std::size_t(0));
    }

    /// The page of a record of two axes shows the channel that the test takes.
    void thePageShowsTheChannelThatIsTaken() {
        Document document = withDrift(40);
        editMeasurement<PositioningMeasurement>(
            document, 1, [](PositioningMeasurement &measurement) { measurement.axis.name = "Y"; });
        editMeasurement<DriftMeasurement>(document, 0,
                                          [](DriftMeasurement &drift) { drift.axis.name = "X"; });
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(document));
        const auto blocks = thermalBlocks(evaluated, 0, Language(Language::Id::english));
        QCOMPARE(std::get<VerdictLine>(blocks.front()).label.simplified(), "Variation of Y in 40 min");
        const auto figure = std::ranges::find_if(
            blocks, [](const Block &block) { return std::holds_alternative<FigureBlock>(block); });
        const auto &drawn = std::get<LineFigure>(*std::get<FigureBlock>(*figure).figure);
        QVERIFY(drawn.band && drawn.band->label.contains("in which Y varies most"));
    }

    /// Lengths and angles have figures and numbers in their own units.
    void anglesAreNotDrawnAsLengths() {
        Document document = withDrift(40);
        editMeasurement<DriftMeasurement>(document, 0, [](DriftMeasurement &drift) {
            drift.channels[1].quantity = ChannelQuantity::angularDeviation;
        });
        const Language english(Language::Id::english);
        const auto &drift = std::get<DriftMeasurement>(document.tests[0]->measurement);
        const std::vector<ThermalChannel> channels = thermalChannels(drift);
        for (const auto &[shown, unit, scale] : {std::tuple{0, "µm", 1000.0}, std::tuple{1, "″", 3600.0}}) {
            const LineFigure figure =
                channelFigure(drift, channels, static_cast<std::size_t>(shown), english);
            QCOMPARE(figure.y.unit, unit);
            QCOMPARE(figure.lines[0].points[100].y(),
                     *drift.channels[std::size_t(shown)].values[100] * scale);
            QCOMPARE(std::ranges::count_if(figure.lines,
                                           [](const FigureLine &line) { return !line.label.isEmpty(); }),
                     1);
            const Quantity quantity = deviationQuantity(drift.channels[std::size_t(shown)]);
            QCOMPARE(variationFigure(drift, quantity, english).lines.size(), std::size_t(1));
        }
        const Table table = responseTable(drift, channels, english);
        QCOMPARE(table.columns[2].unit, "/°C");
        QCOMPARE(table.rows[0][0].text.plain(), "X (µm)");
        QCOMPARE(table.rows[1][0].text.plain(), "Y (″)");
        const double k = table.rows[1][2].text.plain().replace(QChar(0x2212), '-').toDouble();
        QVERIFY(std::abs(k - channels[1].responses[0].k * 3600) < 0.1 * std::abs(k));
    }

    void theResponseIsTheOneItWasMadeFrom() {
        const Document document = withDrift(40);
        const auto channels = thermalChannels(std::get<DriftMeasurement>(document.tests[0]->measurement));
        QCOMPARE(channels.size(), std::size_t(2));
        QVERIFY(channels[0].best && channels[1].best);
        const ThermalResponse &x = channels[0].responses[0];
        QVERIFY(std::abs(x.k - 0.0033) < 0.0002);
        QVERIFY(std::abs(x.tau - 2700) < 300);
    }

    void steadierAirAndShorterTestsCostLess() {
        const EvaluatedDocument evaluated = evaluate(std::make_shared<const Document>(withDrift(40)));
        const DriftCases cases = driftCases(evaluated, 1);
        QCOMPARE(cases.parameters, (std::vector<std::string>{"A", "R"}));
        QCOMPARE(cases.cases.size(), std::size_t(7));
        const auto found = std::ranges::find(evaluated.tests[1]->parameters, "A",
                                             [](const Parameter &p) { return parameterId(p); });
        QCOMPARE(*cases.cases[0].expanded[0], *found->expandedUncertainty);
        QVERIFY(*cases.cases[1].expanded[0] < *cases.cases[0].expanded[0]);
        QVERIFY(*cases.cases[2].expanded[0] < *cases.cases[1].expanded[0]);
        QCOMPARE(*cases.cases[2].share, 0.0);
        QVERIFY(cases.cases[4].variation < cases.cases[5].variation);
    }

    void isReadAsItWasWritten() {
        const Document document = withDrift(40);
        QVERIFY(readDocument(writeDocument(document)) == document);
        QVERIFY(writeDocument(document).contains("\"version\": 3"));
        QVERIFY(!writeDocument(document).contains("\"deviations\": []"));
    }
};

QTEST_GUILESS_MAIN(ThermalDocumentTest)
#include "thermal.moc"
