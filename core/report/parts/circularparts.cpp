// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "figures/circlefigure.h"
#include "kernel/evaluation/iso230_4/circles.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace palmer {

namespace {

constexpr QSizeF separateSize{112, 97}; ///< mm; two separate figures fit on a page
constexpr double parameterLabels = 26;  ///< mm
constexpr int deviationDecimals = 1;    ///< of centres and C next to the figure, µm
constexpr int circleDecimals = 2;       ///< of centres and radii in their table, µm
constexpr int pointAngleDecimals = 1;
constexpr int timeDecimals = 1;

QString axisName(const std::string &name) {
    return QString::fromStdString(name.empty() ? "–" : name);
}

/// True if the edition has G(b); that of 1996 has not.
bool hasPair(const CircularPart &part) {
    return std::ranges::any_of(part.evaluation.parameters, [](const Parameter &parameter) {
        return std::string_view(parameter.term.symbol.base) == "G(b)";
    });
}

// ---- The parameters of the test --------------------------------------------------------------------------

/// One text if it is the same for all paths, otherwise one per path in the order of measurement.
template <typename TextOf>
QString ofEachPath(const CircularPart &part, TextOf textOf) {
    QStringList texts;
    for (const EvaluatedPath &path : part.results.paths)
        texts << textOf(path);
    const bool same = std::ranges::all_of(texts, [&](const QString &text) { return text == texts.front(); });
    if (!same)
        return texts.join(QStringLiteral(", "));
    if (texts.size() < 2)
        return texts.join(QString());
    return part.write.say(REPORT_TEXT("report", "%1 per sense"), texts.front());
}

QString sensesText(const CircularPart &part) {
    QStringList senses;
    for (const EvaluatedPath &path : part.results.paths)
        senses << part.write.text(shortSenseText(path.sense));
    return senses.join(QStringLiteral(", "));
}

QString angleRange(const Writer &write, double from, double to) {
    return write.say(REPORT_TEXT("report", "%1 to %2"),
                     {Number{from, Quantity::angle, -1}, Number{to, Quantity::angle, -1}});
}

constexpr double roundingOfAngles = 0.1; ///< degrees

/// "360°" for a closed circle without overlap, otherwise its ends.
QString rangeText(const CircularPart &part, double low, double high, bool closed) {
    const auto round = [](double angle) { return std::round(angle / roundingOfAngles) * roundingOfAngles; };
    if (closed && high - low <= 360 + roundingOfAngles / 2)
        return part.write.quantity(360, Quantity::angle);
    return angleRange(part.write, round(low), round(high));
}

/// Captured range of a path.
QString captureText(const CircularPart &part, const EvaluatedPath &path) {
    const auto &angles = part.measurement.arcs[path.arc].angles;
    if (angles.empty())
        return QStringLiteral("–");
    const auto [low, high] = std::ranges::minmax(angles);
    return rangeText(part, low, high, path.fullCircle);
}

/// True if a path has captured points that are not evaluated.
bool evaluatesPart(const CircularPart &part) {
    return std::ranges::any_of(part.results.paths, [&](const EvaluatedPath &path) {
        return path.source.size() != part.measurement.arcs[path.arc].angles.size();
    });
}

QString evaluatedText(const CircularPart &part, const EvaluatedPath &path) {
    return rangeText(part, path.evaluated.from, path.evaluated.to, path.fullCircle);
}

QString temperatureText(const CircularPart &part, SensorMeasures what, std::optional<double> alpha) {
    const auto temperature = statedTemperature(part.measurement.conditions.common, what, sensorTemperature);
    QStringList texts{part.write.quantity(temperature, Quantity::temperature, temperatureDecimals)};
    if (alpha)
        texts << QStringLiteral("α\u00A0=\u00A0") +
                     part.write.language().number(
                         *alpha, Quantity::expansion,
                         statedDecimals(*alpha, Quantity::expansion, expansionDecimals));
    return joined(texts, part.write.semicolon());
}

QString startAndStop(const CircularPart &part) {
    const CircularConditions &conditions = part.measurement.conditions;
    if (conditions.startPoint.empty() && conditions.stopPoint.empty())
        return {};
    const auto orDash = [](const std::string &text) {
        return QString::fromStdString(text.empty() ? "–" : text);
    };
    return orDash(conditions.startPoint) + part.write.semicolon() + orDash(conditions.stopPoint);
}

/// The circle whose centre the figure is drawn about, which removes the set-up error.
const CircleResult *drawnCircle(const CircularPart &part) {
    const CircularResults &results = part.results;
    if (results.paths.empty())
        return nullptr;
    const CircleOf of =
        results.paths.size() == 2 ? CircleOf::both : iso230_4::circleOf(results.paths.front().sense);
    return results.circle(of, part.measurement.referenceCircle);
}

QString circleKind(const CircularPart &part, ReferenceCircle kind) {
    return part.write.text(kind == ReferenceCircle::minimumZone ? REPORT_TEXT("report", "minimum zone")
                                                                : REPORT_TEXT("report", "least squares"));
}

/// Number of evaluated points of a path, with the number of all if it differs.
QString pointsText(const CircularPart &part, const EvaluatedPath &path) {
    const Writer &write = part.write;
    const QString evaluated = write.language().count(path.source.size());
    return evaluatesPart(part)
               ? write.say(
                     REPORT_TEXT("report", "%1 of %2"),
                     {evaluated.toStdString(),
                      write.language().count(part.measurement.arcs[path.arc].angles.size()).toStdString()})
               : evaluated;
}

} // namespace

KeyValues parameterRows(const CircularPart &part) {
    const Writer &write = part.write;
    const CircularMeasurement &measurement = part.measurement;
    const CircularConditions &conditions = measurement.conditions;
    const Conditions &common = conditions.common;
    const bool external = !part.feedback();
    const bool length = part.needsLength();
    LabelledRows rows(write, {{}, parameterLabels, true});
    rows.add(REPORT_TEXT("report", "Nominal diameter"),
             write.quantity(2 * measurement.nominalRadius, Quantity::position));
    rows.add(REPORT_TEXT_FOR("report", "Feed", "contouring"),
             write.quantity(measurement.feed, Quantity::feed));
    rows.add(REPORT_TEXT("report", "Contouring"), sensesText(part));
    rows.add(REPORT_TEXT("report", "Axes moved"),
             write.say(REPORT_TEXT_FOR("report", "%1 and %2", "axes"),
                       {axisName(measurement.plane.first).toStdString(),
                        axisName(measurement.plane.second).toStdString()}));
    rows.add(REPORT_TEXT("report", "Centre"), pointText(write, conditions.centre), external);
    rows.add(REPORT_TEXT("report", "Tool offset"), pointText(write, common.toolOffset), external);
    rows.add(REPORT_TEXT("report", "Workpiece offset"), pointText(write, common.workpieceOffset), external);
    rows.add(REPORT_TEXT("report", "Other axes"), common.otherAxes);
    rows.add(REPORT_TEXT("report", "Air"), temperatureText(part, SensorMeasures::air, {}), length);
    rows.add(REPORT_TEXT("report", "Instrument"),
             temperatureText(part, SensorMeasures::instrument, common.expansion.instrument), length);
    rows.add(REPORT_TEXT("report", "Machine"),
             temperatureText(part, SensorMeasures::machine, common.expansion.machine), length);
    rows.add(REPORT_TEXT("report", "Correction C"),
             write.quantity(part.results.correction, Quantity::deviation, deviationDecimals), false);
    rows.add(REPORT_TEXT("report", "Captured range"),
             ofEachPath(part, [&](const EvaluatedPath &path) { return captureText(part, path); }));
    if (evaluatesPart(part))
        rows.add(REPORT_TEXT("report", "Evaluated range"),
                 ofEachPath(part, [&](const EvaluatedPath &path) { return evaluatedText(part, path); }));
    rows.add(REPORT_TEXT("report", "Points"),
             ofEachPath(part, [&](const EvaluatedPath &path) { return pointsText(part, path); }));
    rows.add(REPORT_TEXT("report", "Start, stop"), startAndStop(part));
    rows.add(REPORT_TEXT("report", "Smoothing"), conditions.smoothing);
    rows.add(REPORT_TEXT("report", "Compensation"), common.compensation);
    rows.add(hasPair(part) || part.results.paths.size() < 2 ? REPORT_TEXT("report", "Circle, G, G(b)")
                                                            : REPORT_TEXT("report", "Circle, G, H"),
             circleKind(part, measurement.referenceCircle));
    if (external && part.asksFor(OfCircle::radialDeviation))
        rows.add(REPORT_TEXT("report", "Centre, F"),
                 write.text(measurement.centring == Centring::leastSquares
                                ? REPORT_TEXT("report", "least squares")
                                : REPORT_TEXT("report", "set-up of the instrument")));
    if (const CircleResult *circle = drawnCircle(part)) {
        // Centre of the path as the instrument sees it.
        const Point error = part.results.centringError.value_or(Point{});
        rows.add(
            REPORT_TEXT("report", "Set-up removed"),
            centreText(part, {circle->centre.x - error.x, circle->centre.y - error.y}, deviationDecimals));
    }
    return rows.take();
}

namespace {

CircleFigure figureOf(const CircularPart &part, CircleFigureOptions options) {
    const auto &include = part.head().include;
    options.fillFrame = true;
    options.repetitions = std::ranges::find(include, ReportExtra::repetitions) != include.end();
    return circleFigure(part.test, part.evaluation, part.write.language(), options);
}

/// Those of the two senses have one magnification, because they are compared with each other.
std::vector<CircleFigureOptions> figuresOf(const CircularPart &part) {
    std::vector<CircleFigureOptions> figures;
    if (part.head().figures == CircleFigures::separate)
        figures = separateCircleFigures(part.test, part.evaluation);
    if (figures.empty())
        return {{}};
    std::map<CircleSubject, double> least;
    for (CircleFigureOptions &options : figures) {
        if (&options != &figures.front())
            options.size = separateSize;
        if (options.of == CircleOf::both)
            continue;
        double &most = least.try_emplace(options.subject, options.mostMagnification).first->second;
        most = std::min(most, figureOf(part, options).magnification);
    }
    for (CircleFigureOptions &options : figures) {
        if (options.of != CircleOf::both)
            options.mostMagnification = least.at(options.subject);
    }
    return figures;
}

/// Heading and figure as the left one of two columns.
SideBySide besideFigure(CircleFigure figure) {
    const QSizeF size = printedSize(figure);
    SideBySide both;
    both.leftWidth = size.width();
    both.gap = figureGap;
    both.left.emplace_back(Heading{2, figure.title, figure.caption});
    both.left.emplace_back(FigureBlock{std::move(figure), size.width(), size.height()});
    return both;
}

// ---- Tables ----------------------------------------------------------------------------------------------

QString fullCircleText(const CircularPart &part, const EvaluatedPath &path) {
    return path.fullCircle ? part.write.text(REPORT_TEXT("report", "full circle"))
                           : part.write.say(REPORT_TEXT("report", "arc of %1"),
                                            {Number{path.extent, Quantity::angle, 1}});
}

/// Subject of a circle: the pair or a path, by the symbol of its result.
Phrase circleOf(const CircularPart &part, const CircleResult &circle) {
    const bool both = circle.of == CircleOf::both;
    if (both && !hasPair(part))
        return part.write.text(REPORT_TEXT("report", "both paths"));
    std::string index;
    for (const EvaluatedPath &path : part.results.paths) {
        if (index.empty() && (both || circle.of == iso230_4::circleOf(path.sense)))
            index = path.index;
    }
    return symbolPhrase({both ? "G(b)" : "G", part.feedback() ? "f" : "", ""}, index);
}

/// Blank for least squares, which needs no certificate.
Cell certificate(const CircularPart &part, const CircleResult &circle) {
    if (!circle.certified)
        return blankCell();
    Cell cell(part.write.text(*circle.certified ? REPORT_TEXT("report", "proven narrowest")
                                                : REPORT_TEXT("report", "not proven")));
    cell.mark = *circle.certified ? Mark::check : Mark::openCircle;
    return cell;
}

/// Distance from the nominal circle, µm.
QString fromNominal(const CircularPart &part, double radius) {
    return part.write.language().number(radius - part.measurement.nominalRadius, Quantity::deviation,
                                        circleDecimals);
}

bool isOf(const CircleFigureOptions &options, const EvaluatedPath &path) {
    return options.of == CircleOf::both || options.of == iso230_4::circleOf(path.sense);
}

/// Results of a separate figure.
Table resultsOf(const CircularPart &part, const CircleFigureOptions &options) {
    const Writer &write = part.write;
    const bool lengths = options.subject == CircleSubject::radialDeviation;
    Table table;
    table.headless = true;
    table.columns = {columnOf(QString(), 20), flexibleColumn(QString(), 38)};
    for (const Parameter &parameter : part.evaluation.parameters) {
        const Term &term = parameter.term;
        const bool shown = lengths ? term.circle == OfCircle::radialDeviation
                                   : term.circle == OfCircle::deviation &&
                                         (term.of == Of::pair) == (options.of == CircleOf::both);
        const bool ofPath = std::ranges::any_of(part.results.paths, [&](const EvaluatedPath &path) {
            return path.index == parameter.index && isOf(options, path);
        });
        if (!parameter.value || !shown || !ofPath)
            continue;
        const PrintedNumbers printed =
            printedNumbers(parameter, part.test, part.document(), write.language());
        table.rows.push_back({boldCell(symbolPhrase(term.symbol, parameter.index)),
                              withUnit(joined({printed.value, printed.uncertainty}, QStringLiteral(" ± ")),
                                       term.quantity, write.language())});
    }
    return table;
}

/// Centre of a separate figure.
KeyValues centreRows(const CircularPart &part, const CircleFigureOptions &options) {
    const Writer &write = part.write;
    const bool lengths = options.subject == CircleSubject::radialDeviation;
    LabelledRows rows(write, {{}, parameterLabels, true});
    if (lengths && part.measurement.centring == Centring::instrument) {
        rows.add(REPORT_TEXT("report", "Centre"),
                 write.text(REPORT_TEXT("report", "set-up of the instrument")));
        return rows.take();
    }
    const ReferenceCircle kind = lengths ? ReferenceCircle::leastSquares : part.measurement.referenceCircle;
    const CircleResult *circle = part.results.circle(options.of, kind);
    rows.add(REPORT_TEXT("report", "Circle"), circleKind(part, kind));
    rows.add(REPORT_TEXT("report", "Centre"),
             circle ? centreText(part, circle->centre, circleDecimals) : QString());
    if (circle && circle->certified)
        rows.add(REPORT_TEXT_FOR("report", "Certificate", "of a circle"),
                 certificate(part, *circle).text.plain());
    return rows.take();
}

} // namespace

QString signedNumber(const Writer &write, double value, Quantity quantity, int decimals) {
    const QString number = write.language().number(value, quantity, decimals);
    return number.startsWith(u'−') || value == 0 ? number : u'+' + number;
}

QString centreText(const CircularPart &part, Point centre, int decimals) {
    const Writer &write = part.write;
    const auto coordinate = [&](const std::string &axis, double value) {
        return axisName(axis) + QStringLiteral("\u00A0") +
               signedNumber(write, value, Quantity::deviation, decimals);
    };
    return coordinate(part.measurement.plane.first, centre.x) + write.semicolon() +
           coordinate(part.measurement.plane.second, centre.y) + QStringLiteral("\u00A0") +
           write.language().unit(Quantity::deviation);
}

void addActualPaths(std::vector<Block> &blocks, const CircularPart &part) {
    const Writer &write = part.write;
    CircleFigure figure = figureOf(part, figuresOf(part).front());
    const QString about = figure.centre;
    SideBySide both = besideFigure(std::move(figure));
    Phrase clause;
    if (*part.edition().parametersClause != 0)
        clause =
            write.say(REPORT_TEXT("report", "clause %1"), {std::string(part.edition().parametersClause)});
    both.right.emplace_back(Heading{2, write.text(REPORT_TEXT("report", "Test parameters")), clause});
    both.right.emplace_back(parameterRows(part));
    const Expansion &expansion = part.measurement.conditions.common.expansion;
    QStringList notes{write.text(expansion.machine || expansion.instrument
                                     ? REPORT_TEXT("report", "Positions in mm, α in µm/(m·°C).")
                                     : REPORT_TEXT("report", "Positions in mm."))};
    if (!about.isEmpty())
        notes << write.say(REPORT_TEXT("report", "Figure drawn %1."), about);
    blocks.emplace_back(std::move(both));
    blocks.emplace_back(Paragraph{notes.join(u' '), TextSize::small});
}

void addSeparateFigures(std::vector<Block> &blocks, const CircularPart &part) {
    const auto figures = figuresOf(part);
    for (std::size_t i = 1; i < figures.size(); ++i) {
        SideBySide both = besideFigure(figureOf(part, figures[i]));
        std::get<Heading>(both.left.front()).annexFirst = true;
        both.right.emplace_back(Heading{2, part.write.text(REPORT_TEXT("report", "Results"))});
        if (Table table = resultsOf(part, figures[i]); !table.rows.empty())
            both.right.emplace_back(std::move(table));
        both.right.emplace_back(centreRows(part, figures[i]));
        blocks.emplace_back(std::move(both));
    }
}

void addPaths(std::vector<Block> &blocks, const CircularPart &part) {
    const auto &paths = part.results.paths;
    if (paths.empty())
        return;
    const Writer &write = part.write;
    const QString degrees = write.language().unit(Quantity::angle);
    const QString seconds = write.language().unit(Quantity::time);
    Table table;
    table.columns = {write.column(REPORT_TEXT("report", "Path"), 18),
                     write.flexible(REPORT_TEXT("report", "Sense"), 36),
                     write.column(REPORT_TEXT("report", "Measured"), 26, Alignment::left, degrees),
                     write.column(REPORT_TEXT("report", "Evaluated"), 26, Alignment::left, degrees),
                     columnOf(QString(), 23.5),
                     write.column(REPORT_TEXT("report", "Points"), 14, Alignment::right),
                     write.column(REPORT_TEXT("report", "Step"), 15.5, Alignment::decimal, seconds),
                     write.column(REPORT_TEXT("report", "Duration"), 16, Alignment::decimal, seconds)};
    const auto angle = [&](double value) {
        return write.language().number(value, Quantity::angle, pointAngleDecimals);
    };
    const auto range = [&](Interval interval) {
        return angle(interval.from) + QStringLiteral(" … ") + angle(interval.to);
    };
    for (const EvaluatedPath &path : paths) {
        const Arc &arc = part.measurement.arcs[path.arc];
        std::vector<Cell> row{boldCell(QString::fromStdString(path.index)),
                              write.text(senseText(path.sense))};
        if (arc.angles.empty()) {
            row.resize(4);
        } else {
            // In the direction of contouring.
            const auto [low, high] = path.evaluated;
            row.emplace_back(range({arc.angles.front(), arc.angles.back()}));
            row.emplace_back(
                range(path.sense == Sense::clockwise ? Interval{high, low} : Interval{low, high}));
        }
        row.emplace_back(fullCircleText(part, path));
        row.emplace_back(write.language().count(path.source.size()));
        const auto step = arc.sampleInterval;
        row.emplace_back(step ? write.language().number(*step, Quantity::time, 4) : QString());
        const auto steps =
            static_cast<double>(path.source.empty() ? 0 : path.source.back() - path.source.front());
        row.emplace_back(step ? write.language().number(std::abs(steps) * *step, Quantity::time, timeDecimals)
                              : QString());
        table.rows.push_back(std::move(row));
    }
    addHeading(blocks, write.text(REPORT_TEXT("report", "Measured paths")),
               write.text(REPORT_TEXT("report", "points and time of the evaluated range")));
    blocks.emplace_back(std::move(table));
}

void addCircles(std::vector<Block> &blocks, const CircularPart &part) {
    const auto &circles = part.results.circles;
    if (circles.empty())
        return;
    const Writer &write = part.write;
    const QString unit = write.language().unit(Quantity::deviation);
    const auto number = [&](double value) {
        return Cell(write.language().number(value, Quantity::deviation, circleDecimals));
    };
    Table table;
    table.columns = {write.column(REPORT_TEXT("report", "Path"), 20),
                     write.flexible(REPORT_TEXT("report", "Circle"), 26),
                     columnOf(axisName(part.measurement.plane.first), 14, Alignment::decimal, unit),
                     columnOf(axisName(part.measurement.plane.second), 14, Alignment::decimal, unit),
                     columnOf(phraseFrom(QStringLiteral("R − R_nom")), 17, Alignment::decimal, unit),
                     columnOf(phraseFrom(QStringLiteral("R_min − R_nom")), 20, Alignment::decimal, unit),
                     columnOf(phraseFrom(QStringLiteral("R_max − R_nom")), 20, Alignment::decimal, unit),
                     write.column(REPORT_TEXT("report", "Width"), 14, Alignment::decimal, unit),
                     write.column(REPORT_TEXT_FOR("report", "Certificate", "of a circle"), 30)};
    table.columns.back().paddingLeft = 2;
    table.unbroken = true;
    for (const CircleResult &circle : circles) {
        if (!table.rows.empty() && circle.of != (&circle - 1)->of)
            table.rulesAfter.push_back(table.rows.size() - 1);
        table.rows.push_back(
            {boldCell(circleOf(part, circle)), circleKind(part, circle.kind), number(circle.centre.x),
             number(circle.centre.y), fromNominal(part, circle.radius), fromNominal(part, circle.innerRadius),
             fromNominal(part, circle.outerRadius), number(circle.width), certificate(part, circle)});
    }
    QString note = write.text(REPORT_TEXT("report", "centres relative to the programmed one"));
    if (part.needsLength() &&
        part.measurement.conditions.common.correctionTo20 != CorrectionTo20::appliedByInstrument)
        note += write.semicolon() + write.text(REPORT_TEXT("report", "without correction to 20 °C"));
    addHeading(blocks, write.text(REPORT_TEXT("report", "Reference circles")), note);
    blocks.emplace_back(std::move(table));
    if (part.results.centringError)
        blocks.emplace_back(Paragraph{
            // Centre of the path as the instrument sees it, as next to the figure.
            write.say(REPORT_TEXT("report", "Centring error taken out of the commanded angles: %1."),
                      centreText(part, {-part.results.centringError->x, -part.results.centringError->y},
                                 circleDecimals)),
            TextSize::small});
}

void addRepetitions(std::vector<Block> &blocks, const CircularPart &part) {
    const auto &include = part.head().include;
    const bool asked = std::ranges::find(include, ReportExtra::repetitions) != include.end();
    if (!asked || part.results.repetitions.empty())
        return;
    const Writer &write = part.write;
    const CircularMeasurement &measurement = part.measurement;
    Table table;
    table.columns = {
        columnOf(QString(), 7, Alignment::right),
        write.column(REPORT_TEXT("report", "Path"), 20),
        write.column(REPORT_TEXT("report", "Sense"), 36),
        write.column(REPORT_TEXT("report", "Points"), 18, Alignment::right),
        columnOf(Phrase({{QStringLiteral("G")}, {part.feedback() ? QStringLiteral("f") : QString(), true}}),
                 18, Alignment::decimal, write.language().unit(Quantity::deviation)),
        flexibleColumn(QString(), 76)};
    table.columns.back().paddingLeft = 3;
    std::map<Sense, int> number;
    for (std::size_t k = 0; k < measurement.arcs.size(); ++k) {
        const EvaluatedPath path = iso230_4::evaluatedPath(measurement, k, part.results.centringError);
        const auto circle = iso230_4::circleOfPath(path, measurement.referenceCircle);
        const bool evaluated = ++number[path.sense] == 1;
        table.rows.push_back(
            {QString::number(k + 1), boldCell(QString::fromStdString(path.index)),
             write.text(senseText(path.sense)), write.language().count(path.source.size()),
             circle ? write.language().number(circle->width, Quantity::deviation, circleDecimals) : QString(),
             evaluated ? Cell(write.text(REPORT_TEXT("report", "evaluated"))) : blankCell()});
    }
    addHeading(
        blocks, write.text(REPORT_TEXT("report", "Repetitions")),
        write.text(REPORT_TEXT("report", "all paths in the order of measurement; further paths of a sense "
                                         "have no part in the results")));
    blocks.emplace_back(std::move(table));
}

} // namespace palmer
