// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "figures/figuretexts.h"

#include "document/evaluateddocument.h"
#include "document/readdocument.h"
#include "figures/circlefigure.h"
#include "figures/testfigures.h"

#include <QFile>
#include <QTest>

using namespace palmer;

namespace {

EvaluatedDocument example(const QString &name) {
    QFile file(QStringLiteral(EXAMPLES "%1.palmer").arg(name));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no example %s", qPrintable(name));
    return evaluate(std::make_shared<const Document>(readDocument(file.readAll())));
}

} // namespace

class FigureSentence : public QObject {
    Q_OBJECT

private slots:
    /// What it says is counted anew from the readings of the file.
    void theRangesAreThoseOfTheReadings() {
        const EvaluatedDocument evaluated = example("iso230-2-1988-example");
        const Test &test = *evaluated.document->tests[0];
        const auto &measurement = std::get<PositioningMeasurement>(test.measurement);
        for (const auto id : {Language::Id::english, Language::Id::french}) {
            const Language language(id);
            CurveFigure figure = deviationFigure(test, *evaluated.tests[0], language);
            const QString sentence = figureSentence(figure, language);
            QVERIFY2(sentence.startsWith(figure.title + (id == Language::Id::french ? "\u00a0: " : ": ")),
                     qPrintable(sentence));
            QVERIFY(sentence.contains(figure.x.quantity) && sentence.contains(figure.y.quantity));
            QVERIFY(sentence.contains(language.number(measurement.targets.back(), Quantity::number, -1)));
            for (const LegendEntry &entry : figure.legend)
                QVERIFY(sentence.contains(entry.text));
            // Without bands the ends are those of the readings.
            figure.bands.clear();
            double least = 1e9;
            double greatest = -1e9;
            for (const Run &run : measurement.runs) {
                for (const auto &deviation : run.deviations) {
                    least = std::min(least, *deviation * 1000);
                    greatest = std::max(greatest, *deviation * 1000);
                }
            }
            const auto number = [&](double value) { return language.number(value, Quantity::number, 1); };
            const QString bare = figureSentence(figure, language);
            QVERIFY2(bare.contains(number(least)) && bare.contains(number(greatest)), qPrintable(bare));
        }
    }

    void circlesSayCentreScaleAndPaths() {
        const EvaluatedDocument evaluated = example("iso230-4-full-circles-xy");
        const Language language(Language::Id::french);
        for (const CircleFigureOptions &options :
             separateCircleFigures(*evaluated.document->tests[0], *evaluated.tests[0])) {
            const CircleFigure figure =
                circleFigure(*evaluated.document->tests[0], *evaluated.tests[0], language, options);
            const QString sentence = figureSentence(figure, language);
            QVERIFY2(sentence.contains(figure.centre) && sentence.contains(figure.caption),
                     qPrintable(sentence));
            QVERIFY2(sentence.contains("µm"), qPrintable(sentence));
        }
    }

    void othersSayTheirLines() {
        const Language language(Language::Id::english);
        LineFigure lines;
        lines.title = "Temperatures";
        lines.x = {"Time", {}, {}, "min", false, 0, 30, 5, {}};
        lines.y = {"Temperature", {}, {}, "°C", false, 19, 22, 0.5, {}};
        lines.lines = {{LineRole::machine, {}, "machine", {{0, 20.1}, {30, 21.45}}},
                       {LineRole::air, {}, "air", {{0, 19.9}, {30, 20.0}}}};
        QCOMPARE(figureSentence(lines, language), "Temperatures: Time 0.0 to 30.0\u00a0min; machine 20.10 to "
                                                  "21.45\u00a0°C; air 19.90 to 20.00\u00a0°C");
        BarFigure bars;
        bars.title = "Contributions";
        bars.bars = {{"u1", "expansion", {}, 3.6, "3.60", "54 %"}};
        QCOMPARE(figureSentence(bars, language), "Contributions: expansion 3.60 54 %");
        bars.dots = DotLegend{"value ± U", {}};
        bars.lines = {{5, "Tolerance limit 5.0 µm", true}};
        QCOMPARE(figureSentence(bars, language),
                 "Contributions: expansion 3.60 54 %; Tolerance limit 5.0 µm");
        QCOMPARE(figureSentence(CurveFigure(), language), QString());
    }
};

QTEST_APPLESS_MAIN(FigureSentence)
#include "figuresentence.moc"
