// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures/targetstrip.h"
#include "figures/testfigures.h"

#include "core/kernel/evaluation/positioningdata.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace palmer;
using namespace Qt::StringLiterals;
using namespace palmer::testdata;

namespace {

CurveFigure figureOf(const Test &test, Language::Id language = Language::Id::english,
                     const DeviationFigureOptions &options = {}) {
    return deviationFigure(test, evaluated(test), Language(language), options);
}

QStringList dimensionIds(const CurveFigure &figure) {
    QStringList ids;
    for (const Dimension &dimension : figure.dimensions)
        ids += dimension.id;
    return ids;
}

QStringList legendTexts(const CurveFigure &figure) {
    QStringList texts;
    for (const LegendEntry &entry : figure.legend)
        texts += entry.text;
    return texts;
}

const Dimension *dimension(const CurveFigure &figure, const char *id) {
    for (const Dimension &candidate : figure.dimensions) {
        if (candidate.id == QLatin1String(id))
            return &candidate;
    }
    return nullptr;
}

QList<int> curveLengths(const CurveFigure &figure, CurveRole role) {
    QList<int> lengths;
    for (const Curve &curve : figure.curves) {
        if (curve.role == role)
            lengths += static_cast<int>(curve.points.size());
    }
    return lengths;
}

QStringList labels(const FigureAxis &axis) {
    QStringList labels;
    for (const Tick &tick : axis.ticks)
        labels += tick.label;
    return labels;
}

/// A test of `runs` runs each way that leaves nothing to chance: the deviation is the index of the target
/// plus, alternately, half a micrometre.
Test simpleTest(std::vector<double> targets, std::size_t runs, bool up = true, bool down = true) {
    std::vector<double> row;
    std::vector<std::vector<double>> rows[2];
    for (std::size_t j = 0; j < runs; ++j) {
        row.clear();
        for (std::size_t i = 0; i < targets.size(); ++i)
            row.push_back(static_cast<double>(i) + (j % 2 ? 0.5 : 0.0));
        rows[0].push_back(row);
        for (double &value : row)
            value += 2;
        rows[1].push_back(row);
    }
    if (!up)
        rows[0].clear();
    if (!down)
        rows[1].clear();
    return positioningTest("ISO 230-2:2006", std::move(targets), rows[0], rows[1]);
}

} // namespace

/// What the figure of a positioning test shows.
class DeviationFigure : public QObject {
    Q_OBJECT

private slots:
    void workedExample();
    void editionsDiffer();
    void languages();
    void optionsLeaveOut();
    void oneDirection();
    void oneRunHasNoLimits();
    void longAxis();
    void rotaryAxis();
    void missingReadingsBreakTheCurve();
    void correctionMovesTheReadings();
    void repeatabilityBesideItsTarget();
    void nothingMeasured();
    void otherRanges();
    void everythingLiesInTheRanges();
    void aReadingSetAsideStaysOnTheStrip();
    void limitsStandBesideTheirDimensions();
};

void DeviationFigure::workedExample() {
    const Test test = example1988("ISO 230-2:2006");
    const TestEvaluation evaluation = evaluated(test);
    const CurveFigure figure = deviationFigure(test, evaluation, Language(Language::Id::english));
    QCOMPARE(curveLengths(figure, CurveRole::up), QList<int>{11});
    QCOMPARE(curveLengths(figure, CurveRole::down), QList<int>{11});
    QCOMPARE(curveLengths(figure, CurveRole::mean), QList<int>{11});
    QCOMPARE(figure.bands.size(), std::size_t{2});
    QCOMPARE(figure.readings.size(), std::size_t{110});
    // From the plot outwards; R stands there because the last target rules it.
    QCOMPARE(dimensionIds(figure), (QStringList{u"R"_s, u"M"_s, u"E"_s, u"A"_s, u"B"_s}));
    for (const Dimension &shown : figure.dimensions) {
        const Parameter *meant = parameter(evaluation, shown.id.toStdString());
        QVERIFY(meant);
        // Differences of numbers of about 10 µm, each rounded to 16 digits.
        QVERIFY(std::abs(shown.upper - shown.lower - 1000 * *meant->value) < 1e-12);
        QCOMPARE(shown.label, shown.id);
    }
    QCOMPARE(dimension(figure, "A")->upperPosition, 150.71);
    QCOMPARE(dimension(figure, "A")->lowerPosition, 601.11);
    QCOMPARE(dimension(figure, "R")->upperPosition, 1500.41);
    QVERIFY(dimension(figure, "R")->place == DimensionPlace::gutter);
    QVERIFY(dimension(figure, "B")->place == DimensionPlace::rightOfTarget);
    QCOMPARE(dimension(figure, "B")->upperPosition, 150.71);
    QVERIFY(std::abs(dimension(figure, "B")->upper - 5.40) < 1e-12);
    QVERIFY(std::abs(dimension(figure, "B")->lower - 0.92) < 1e-12);
    QCOMPARE(legendTexts(figure),
             (QStringList{u"x̄↑ ±\u202f2s↑"_s, u"x̄↓ ±\u202f2s↓"_s, u"x̄ bi-directional"_s, u"readings"_s}));
    QCOMPARE(labels(figure.x), (QStringList{u"0"_s, u"250"_s, u"500"_s, u"750"_s, u"1\u202f000"_s,
                                            u"1\u202f250"_s, u"1\u202f500"_s}));
    QCOMPARE(labels(figure.y),
             (QStringList{u"−10"_s, u"−8"_s, u"−6"_s, u"−4"_s, u"−2"_s, u"0"_s, u"2"_s, u"4"_s, u"6"_s}));
}

void DeviationFigure::editionsDiffer() {
    const CurveFigure old = figureOf(example1988("ISO 230-2:1988"));
    QCOMPARE(dimensionIds(old), (QStringList{u"R"_s, u"A"_s})); // 1988 knows no M, E, B
    QCOMPARE(legendTexts(old).first(), u"x̄↑ ±\u202f3s↑"_s);
    // Published: A = 18.03 = 6.89 − (−11.14) µm; print tolerance.
    QVERIFY(std::abs(dimension(old, "A")->upper - 6.89) < 0.015);
    QVERIFY(std::abs(dimension(old, "A")->lower + 11.14) < 0.015);
    const CurveFigure newest = figureOf(example1988("ISO 230-2:2014"));
    QCOMPARE(newest.y.quantity, u"Positioning deviation"_s);
    QCOMPARE(newest.title, u"Positioning deviations of the X axis"_s);
    QCOMPARE(old.y.quantity, u"Positional deviation"_s);
}

void DeviationFigure::languages() {
    const Test test = example1988("ISO 230-2:2006");
    const CurveFigure english = figureOf(test);
    const CurveFigure french = figureOf(test, Language::Id::french);
    QCOMPARE(english.x.quantity, u"Target position"_s);
    QCOMPARE(french.x.quantity, u"Point visé"_s);
    QCOMPARE(french.y.quantity, u"Écart de position"_s);
    QCOMPARE(french.title, u"Écarts de position de l’axe X"_s);
    QCOMPARE(legendTexts(french).mid(2), (QStringList{u"x̄ bidirectionnel"_s, u"relevés"_s}));
    QCOMPARE(french.y.unit, u"µm"_s);
    QCOMPARE(french.x.unit, u"mm"_s);
    // The picture is the same, only its words are not.
    QCOMPARE(french.curves, english.curves);
    QCOMPARE(french.dimensions, english.dimensions);
}

void DeviationFigure::optionsLeaveOut() {
    const Test test = example1988("ISO 230-2:2006");
    const CurveFigure figure =
        figureOf(test, Language::Id::english, {.readingMarks = false, .dimensions = false});
    QVERIFY(figure.readings.empty());
    QVERIFY(figure.dimensions.empty());
    QCOMPARE(legendTexts(figure).size(), qsizetype{3});
}

void DeviationFigure::oneDirection() {
    const CurveFigure up = figureOf(simpleTest({0, 100, 200, 300}, 5, true, false));
    QCOMPARE(curveLengths(up, CurveRole::up), QList<int>{4});
    QVERIFY(curveLengths(up, CurveRole::down).isEmpty());
    QVERIFY(curveLengths(up, CurveRole::mean).isEmpty());
    QCOMPARE(dimensionIds(up), (QStringList{u"R+"_s, u"E+"_s, u"A+"_s}));
    QCOMPARE(up.dimensions.front().label, u"R↑"_s);
    QCOMPARE(legendTexts(up), (QStringList{u"x̄↑ ±\u202f2s↑"_s, u"readings"_s}));
    const CurveFigure down = figureOf(simpleTest({0, 100, 200, 300}, 5, false, true));
    QCOMPARE(dimensionIds(down), (QStringList{u"R-"_s, u"E-"_s, u"A-"_s}));
    QCOMPARE(legendTexts(down), (QStringList{u"x̄↓ ±\u202f2s↓"_s, u"readings"_s}));
}

void DeviationFigure::oneRunHasNoLimits() {
    const CurveFigure figure = figureOf(simpleTest({0, 100, 200, 300}, 1));
    QVERIFY(figure.bands.empty());
    QVERIFY(figure.readings.empty()); // they are the curves
    QCOMPARE(dimensionIds(figure), (QStringList{u"M"_s, u"E"_s, u"B"_s}));
    QCOMPARE(legendTexts(figure), (QStringList{u"x̄↑"_s, u"x̄↓"_s, u"x̄ bi-directional"_s}));
}

void DeviationFigure::longAxis() {
    Test test = simpleTest({0, 1000, 2000, 3000}, 5);
    QVERIFY(figureOf(test).bands.empty());
    QCOMPARE(dimensionIds(figureOf(test)), (QStringList{u"M"_s, u"E"_s, u"B"_s}));
    // The travel of the axis decides, not that of the measurement.
    Test part = simpleTest({0, 500, 1000, 1500}, 5);
    QCOMPARE(figureOf(part).bands.size(), std::size_t{2});
    measurement(part).axis.travel = 5000;
    QVERIFY(figureOf(part).bands.empty());
    // An agreed zone of it is judged as a short axis.
    measurement(part).zone = Interval{0, 1500};
    QCOMPARE(figureOf(part).bands.size(), std::size_t{2});
    QVERIFY(dimensionIds(figureOf(part)).contains(u"A"_s));
}

void DeviationFigure::rotaryAxis() {
    Test test = simpleTest({0, 90, 180, 270, 360}, 5);
    measurement(test).axis.motion = Motion::rotary;
    for (Run &run : measurement(test).runs) {
        for (auto &deviation : run.deviations)
            deviation = *deviation * 1000 / 3600; // as many arc seconds as there were micrometres
    }
    const CurveFigure figure = figureOf(test);
    QCOMPARE(figure.x.unit, u"°"_s);
    QCOMPARE(figure.y.unit, u"″"_s);
    QCOMPARE(labels(figure.x),
             (QStringList{u"0"_s, u"60"_s, u"120"_s, u"180"_s, u"240"_s, u"300"_s, u"360"_s}));
    const FigurePoint last = figure.curves.front().points.back();
    QCOMPARE(last.x, 360.0);
    QVERIFY(std::abs(last.y - 4.2) < 1e-12); // 4 and, in two runs of five, half an arc second
}

void DeviationFigure::missingReadingsBreakTheCurve() {
    Test test = simpleTest({0, 100, 200, 300, 400, 500}, 5);
    for (Run &run : measurement(test).runs) {
        if (run.approach == Direction::positive)
            run.deviations[2] = std::nullopt;
    }
    int left = 0;
    for (Run &run : measurement(test).runs) { // target 5 keeps one reading ↓: a mean, but no limits
        if (run.approach == Direction::negative && left++ > 0)
            run.deviations[4] = std::nullopt;
    }
    const CurveFigure figure = figureOf(test);
    QCOMPARE(curveLengths(figure, CurveRole::up), (QList<int>{2, 3}));
    QCOMPARE(curveLengths(figure, CurveRole::down), QList<int>{6});
    QCOMPARE(curveLengths(figure, CurveRole::mean), (QList<int>{2, 3}));
    QList<int> bands;
    for (const Band &band : figure.bands)
        bands += static_cast<int>(band.points.size());
    QCOMPARE(bands, (QList<int>{2, 3, 4, 1}));
    QVERIFY(figure.dimensions.empty()); // a parameter that lacks a statistic has no value
    QCOMPARE(figure.positions.size(), std::size_t{6});
    QCOMPARE(figure.curves[1].points.front().target, 4);
}

void DeviationFigure::correctionMovesTheReadings() {
    const Test test = simpleTest({0, 100}, 2);
    TestEvaluation evaluation = evaluated(test);
    std::get<PositioningResults>(evaluation.results).corrections = {0.001, -0.003}; // mm
    const CurveFigure figure = deviationFigure(test, evaluation, Language(Language::Id::english));
    QVERIFY(std::abs(figure.readings[0].y - 1.0) < 1e-12);
    QVERIFY(std::abs(figure.readings[1].y + 2.0) < 1e-12);
    QCOMPARE(figure.readings[1].target, 2);
    QCOMPARE(figure.readings[1].run, 1);
    QCOMPARE(figure.readings.back().run, 2);
}

void DeviationFigure::repeatabilityBesideItsTarget() {
    const auto place = [](std::size_t ruling) {
        Test test = simpleTest({0, 100, 200, 300}, 5);
        measurement(test).runs.front().deviations[ruling] = 0.02;
        return dimension(figureOf(test), "R")->place;
    };
    QVERIFY(place(0) == DimensionPlace::rightOfTarget); // the axis stands on its left
    QVERIFY(place(1) == DimensionPlace::leftOfTarget);
    QVERIFY(place(3) == DimensionPlace::gutter);
}

void DeviationFigure::nothingMeasured() {
    const CurveFigure none = figureOf(positioningTest("ISO 230-2:2006", {}, {}, {}));
    QVERIFY(none.curves.empty());
    QVERIFY(none.legend.empty());
    QVERIFY(none.x.from < none.x.to);
    QVERIFY(none.y.from < none.y.to);
    const CurveFigure single = figureOf(simpleTest({100}, 5));
    QCOMPARE(curveLengths(single, CurveRole::up), QList<int>{1});
    QVERIFY(single.x.from < 100 && single.x.to > 100);
    QVERIFY(!dimensionIds(single).contains(u"M"_s)); // zero: nothing to show
    Test equal = simpleTest({0, 100}, 2);
    for (Run &run : measurement(equal).runs)
        run.deviations = {0.002, 0.002};
    const CurveFigure flat = figureOf(equal);
    QCOMPARE(flat.y.from, 1.0);
    QCOMPARE(flat.y.to, 3.0);
    QVERIFY(flat.dimensions.empty());
}

void DeviationFigure::otherRanges() {
    const Language french(Language::Id::french);
    const CurveFigure figure = figureOf(example1988("ISO 230-2:2006"), Language::Id::french);
    const CurveFigure zoomed = withRanges(figure, {595, 605}, {-8.4, -7.3}, french);
    QCOMPARE(zoomed.curves, figure.curves);
    QCOMPARE(zoomed.x.from, 595.0);
    QCOMPARE(labels(zoomed.x), (QStringList{u"596"_s, u"598"_s, u"600"_s, u"602"_s, u"604"_s}));
    QCOMPARE(labels(zoomed.y).first(), u"−8,4"_s);
    QCOMPARE(labels(zoomed.y).last(), u"−7,3"_s);
}

void DeviationFigure::everythingLiesInTheRanges() {
    std::mt19937_64 random(20262);
    const auto uniform = [&](double from, double to) {
        return std::uniform_real_distribution(from, to)(random);
    };
    for (int round = 0; round < 400; ++round) {
        const auto m = static_cast<std::size_t>(uniform(1, 30));
        const auto n = static_cast<std::size_t>(uniform(1, 7));
        const double scale = std::pow(10.0, uniform(-3, 4)); // nanometres to centimetres
        const double offset = uniform(-2, 2) * scale;
        std::vector<double> targets;
        for (std::size_t i = 0; i < m; ++i)
            targets.push_back(static_cast<double>(i) * 50 + uniform(-20, 20));
        std::vector<std::vector<double>> rows[2];
        for (auto &direction : rows) {
            direction.assign(n, std::vector<double>(m));
            for (auto &run : direction) {
                for (double &reading : run)
                    reading = offset + uniform(-1, 1) * scale;
            }
        }
        Test test =
            positioningTest(round % 2 ? "ISO 230-2:2006" : "ISO 230-2:1988", targets, rows[0], rows[1]);
        for (Run &run : measurement(test).runs) {
            for (auto &deviation : run.deviations) {
                if (uniform(0, 1) < 0.05)
                    deviation = std::nullopt;
            }
        }
        const TestEvaluation evaluation = evaluated(test);
        const CurveFigure figure = deviationFigure(test, evaluation, Language(Language::Id::english));
        const auto inX = [&](double x) { return x > figure.x.from && x < figure.x.to; };
        const auto inY = [&](double y) { return y > figure.y.from && y < figure.y.to; };
        for (const Band &band : figure.bands) {
            for (const BandPoint &point : band.points) {
                QVERIFY(inX(point.x) && inY(point.lower) && inY(point.upper));
                QVERIFY(point.lower <= point.upper);
            }
        }
        for (const Curve &curve : figure.curves) {
            for (const FigurePoint &point : curve.points)
                QVERIFY(inX(point.x) && inY(point.y));
        }
        for (const ReadingMark &reading : figure.readings)
            QVERIFY(inX(reading.x) && inY(reading.y));
        for (const Dimension &shown : figure.dimensions) {
            QVERIFY(inX(shown.lowerPosition) && inX(shown.upperPosition));
            QVERIFY(inY(shown.lower) && inY(shown.upper));
            const double value = *parameter(evaluation, shown.id.toStdString())->value * 1000;
            // Both ends carry the rounding of numbers as large as the offset.
            QVERIFY(std::abs(shown.upper - shown.lower - value) <= 1e-12 * scale);
        }
        QVERIFY(figure.x.ticks.size() >= 2);
        QVERIFY(figure.y.ticks.size() >= 4);
    }
}

void DeviationFigure::limitsStandBesideTheirDimensions() {
    Test test = example1988("ISO 230-2:2006");
    test.limits["R"].value = 0.007;
    test.limits["A"].value = 0.032; // farther than the axis reaches
    measurement(test).uncertainty.method = UncertaintyMethod::direct;
    measurement(test).uncertainty.expanded = {{"A", 3}, {"R", 1.5}};
    test.decisionRule = {Rule::iso14253_1, 0.83};
    const CurveFigure guarded = figureOf(test);
    const Dimension *r = dimension(guarded, "R");
    QCOMPARE(r->limit, std::optional(7.0));
    QCOMPARE(r->limitText, u"7"_s);
    QVERIFY(r->guard && std::abs(*r->guard - 0.83 * 1.5) < 1e-9);
    QVERIFY(!dimension(guarded, "A")->limit);
    QVERIFY(!dimension(guarded, "E")->limit);
    QCOMPARE(guarded.legend.back().sample, LegendSample::limit);
    QCOMPARE(guarded.legend.back().text, u"limit ± g"_s);
    test.decisionRule.guardFactor = 1;
    QCOMPARE(figureOf(test).legend.back().text, u"limit ± U"_s);

    test.decisionRule.rule = Rule::simpleAcceptance; // without a band
    const CurveFigure simple = figureOf(test);
    QVERIFY(dimension(simple, "R")->limit && !dimension(simple, "R")->guard);
    QCOMPARE(simple.legend.back().text, u"limit"_s);

    // Under another edition the limit does not hold.
    const CurveFigure view =
        deviationFigure(test, evaluated(test, "ISO 230-2:2014"), Language(Language::Id::english));
    QVERIFY(!dimension(view, "R")->limit);
    QVERIFY(view.legend.back().sample != LegendSample::limit);
}

/// A reading that was set aside stays where it was, as one that no statistic counts.
void DeviationFigure::aReadingSetAsideStaysOnTheStrip() {
    Test test = example1988("ISO 230-2:2006");
    const Language language(Language::Id::english);
    const TargetStrip before = targetStrip(test, evaluated(test), 2, language);
    auto &measured = measurement(test);
    const double value = *measured.runs[0].deviations[2];
    measured.runs[0].deviations[2].reset();
    measured.excluded = {{1, 3, value, "vibration"}};
    const TargetStrip after = targetStrip(test, evaluated(test), 2, language);
    const std::size_t lane = measured.runs[0].approach == Direction::positive ? 0 : 1;
    QCOMPARE(after.lanes[lane].readings.size(), before.lanes[lane].readings.size());
    QVERIFY(!before.lanes[lane].readings[0].isAside && after.lanes[lane].readings[0].isAside);
    QCOMPARE(after.lanes[lane].readings[0].value, before.lanes[lane].readings[0].value);
    QVERIFY(after.lanes[lane].mean != before.lanes[lane].mean);
}

QTEST_GUILESS_MAIN(DeviationFigure)
#include "deviationfigure.moc"
