// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/arcs.h"
#include "import/layouts/passes.h"
#include "import/layouts/tablereading.h"

#include "document/place.h"
#include "kernel/measurement/plane.h"
#include "kernel/numerics/angles.h"
#include "kernel/numerics/leastsquarescircle.h"
#include "tables/contenterror.h"
#include "tables/folded.h"
#include "tables/numbercell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>

// Above 500 lines: one reader, whose steps share the columns and paths that were found.

namespace palmer {

namespace {

constexpr double programmedStep = 0.001; ///< mm

double rounded(double value, double step) {
    // Divides by an integer, so that 13.3 is the number people write.
    return step < 1 ? std::round(value * std::round(1 / step)) / std::round(1 / step)
                    : std::round(value / step) * step;
}

/// The nearest round number that may be a programmed radius.
double nominalOf(double radius) {
    for (const double step : {10.0, 5.0, 1.0, 0.5, 0.1}) {
        if (std::abs(rounded(radius, step) - radius) < std::min(0.2 * step, 0.3))
            return rounded(radius, step);
    }
    return rounded(radius, 0.01);
}

/// A path as the file gives it: two numbers a point, or one.
struct RawPath {
    std::vector<double> first;  ///< angle or x; empty of deviations alone
    std::vector<double> second; ///< radius, deviation or y
    std::optional<Sense> stated;
    std::optional<std::uint32_t> title; ///< names a sense among other words
};

class CircleReader {
public:
    explicit CircleReader(TableReading &reading)
        : m(reading)
        , m_columns(circleColumns(reading)) {}

    void read() {
        collectPaths();
        CircularMeasurement measurement;
        measurement.referenceLength.calibrated = m.notes.isCalibrated;
        Test test;
        const bool isXy = m_columns.layout == "xy";
        resolveCircle(measurement, test.edition,
                      m.notes.plane.empty() && isXy ? planeOfHeadings() : m.notes.plane, m.notes.feed,
                      m.choices, m.remarks);
        if (!m_columns.first)
            putAtEqualSteps();
        if (isXy)
            convertXy(measurement);
        else
            convertAngles(measurement);
        if (measurement.arcs.empty())
            refuseContent(REPORT_TEXT("report", "there are no points of a circle in it"));
        cutOvershoot(measurement);
        askForSense();
        remarkPaths(measurement, m.remarks);
        if (m_missing > 0)
            m.remarks.problem("unread", REPORT_TEXT("report", "Points without a number were left out: %1."),
                              counted(m_missing));
        test.role = m.stateFound;
        test.measurement = std::move(measurement);
        m.result.test = std::move(test);
    }

private:
    void collectPaths() {
        for (const std::size_t second : m_columns.seconds) {
            const std::optional<Sense> ofColumn = senseOfColumn(m, second);
            const std::optional<Sense> ofRun = ofColumn ? ofColumn : senseOfRun(second);
            for (const TableBlock &block : m.body.blocks)
                collectPaths(block, second, ofRun);
        }
        askForSenses();
        askForUnlike();
    }

    /// "Run 1 direction: CCW" above a column headed "Run 1".
    [[nodiscard]] std::optional<Sense> senseOfRun(std::size_t column) const {
        const auto number = m.body.columns[column].words.number;
        for (const std::uint32_t note : m.body.notes) {
            const std::string text = m.textOf(note);
            const auto sense = senseIn(text);
            if (number && sense && m.body.columns[column].meaning == Meaning::run) {
                const HeadingWords title = readHeading(text);
                if (title.number == number && title.meaning == Meaning::run)
                    return sense;
            }
        }
        return {};
    }

    /// Takes the sense of a title that says nothing else; one that says more is kept.
    void takeTitle(const TableBlock &block, RawPath &path) const {
        constexpr std::size_t prose = 3; // unknown words
        for (const std::uint32_t head : m.titlesOf(block)) {
            const std::string text = m.textOf(head);
            const HeadingWords title = readHeading(text);
            if (title.namesSense && title.isTitle()) {
                path.stated = senseIn(text);
                return;
            }
            const auto [clockwise, counterclockwise] = sensesIn(text);
            if (!path.title && !m_columns.senses && (clockwise || counterclockwise) &&
                ((clockwise && counterclockwise) || title.unknownWords < prose || title.saysDirection ||
                 title.meaning == Meaning::angle))
                path.title = head;
        }
    }

    /// The roles of the columns with the senses that paths beside each other could have.
    [[nodiscard]] std::vector<std::string> answersOfSenses() const {
        std::vector<std::string> answers;
        const std::size_t count = m_columns.seconds.size();
        using Pattern = std::function<std::optional<Direction>(std::size_t)>;
        const auto up = [](bool is) { return is ? Direction::positive : Direction::negative; };
        for (const Pattern &pattern : {Pattern([&](std::size_t k) { return up(k % 2 == 0); }),
                                       Pattern([&](std::size_t k) { return up(k % 2 == 1); }),
                                       Pattern([&](std::size_t k) { return up(2 * k < count); }),
                                       Pattern([&](std::size_t k) { return up(2 * k >= count); }),
                                       Pattern([](std::size_t) { return std::optional<Direction>(); })}) {
            std::vector<ImportColumn> columns = m.result.columns;
            for (std::size_t k = 0; k < count; ++k)
                columns[m_columns.seconds[k]].direction = pattern(k);
            if (std::string word = wordOf(columns); std::ranges::find(answers, word) == answers.end())
                answers.push_back(std::move(word));
        }
        return answers;
    }

    /// Asks for columns of one sense whose headings differ by more than the number of a run.
    void askForUnlike() {
        constexpr unsigned mostRuns = 50;
        for (std::size_t k = 1; k < m_columns.seconds.size() && !m.choices.isChosen("columns"); ++k) {
            const TableColumn &other = m.body.columns[m_columns.seconds[k]];
            for (std::size_t i = 0; i < k; ++i) {
                const TableColumn &one = m.body.columns[m_columns.seconds[i]];
                const bool isNumbered =
                    std::max(one.words.number.value_or(0), other.words.number.value_or(0)) < mostRuns;
                if (senseIn(one.heading) == senseIn(other.heading) && senseIn(one.heading) &&
                    (one.words.stem != other.words.stem || !isNumbered))
                    return (void)m.remarks.problem(
                        "columns",
                        REPORT_TEXT("report", "Columns: “%1” and “%2” are read as paths of one test."),
                        excerpt(one.heading), excerpt(other.heading));
            }
        }
    }

    /// Columns with common angles have the same sense unless a word distinguishes them.
    void askForSenses() {
        if (!m_unknownSense.empty())
            m.remarks.problem(
                "columns",
                REPORT_TEXT("report", "Sense: “%1” is neither clockwise nor counterclockwise to the program; "
                                      "those points are read as their angles run."),
                excerpt(m_unknownSense));
        const auto isSilent = [](const RawPath &path) { return !path.stated && !path.title; };
        if (m_columns.seconds.size() > 1 && m_columns.firsts.empty() && m.body.blocks.size() == 1 &&
            std::ranges::any_of(m_paths, isSilent) && !m.choices.isChosen("columns"))
            m.remarks
                .problem("columns",
                         REPORT_TEXT("report", "Sense: no word says which column is clockwise; all are read "
                                               "as the angles run. A column can be given + "
                                               "(counterclockwise) or - (clockwise)."))
                .answers = answersOfSenses();
    }

    /// Asks where the angles contradict the named sense, or its words are not all known. If they contradict
    /// one sense of two, all points are listed by angle.
    void askForSense() {
        const bool isContradicted = m_turned > 0 && m_turned == m_stated;
        const Text against =
            REPORT_TEXT("report", "Sense: the angles run against the sense the file names; the "
                                  "points are taken in the opposite order.");
        if (m_turned > 0 && !isContradicted)
            m.remarks.problem({}, against);
        if (!isContradicted && !m_unclearTitle)
            return;
        if (m.choices.resolve("sense", isContradicted ? "stated" : "angles", Origin::guessed).origin ==
            Origin::chosen)
            return;
        if (isContradicted)
            m.remarks.problem("sense", against);
        else
            m.remarks
                .problem({"sense", m.row(*m_unclearTitle).line},
                         REPORT_TEXT("report",
                                     "Sense: the file says “%1”; the points are read as their angles run."),
                         excerpt(withoutBlanks(m.textOf(*m_unclearTitle))))
                .answers = {"angles", "mirrored"};
    }

    /// The angle of a line, or its x.
    [[nodiscard]] std::optional<double> firstOf(std::uint32_t row, std::size_t second) {
        const auto column = m_columns.firstOf(second);
        const auto first = column ? m.number(row, *column) : std::nullopt;
        const auto y = m_columns.third ? m.number(row, *m_columns.third) : std::nullopt;
        if (!m_columns.third || !first)
            return first;
        return y ? std::optional(std::atan2(*y, *first) / degree) : std::nullopt;
    }

    /// The words of the line before.
    struct Parting {
        std::string_view sense = {};
        std::string_view run = {};
    };

    /// Collects the paths of a block and column: a new one where another sense or run is named.
    void collectPaths(const TableBlock &block, std::size_t second, std::optional<Sense> stated) {
        Parting last;
        RawPath path;
        path.stated = stated;
        if (!stated)
            takeTitle(block, path);
        path.first.reserve(block.rows.size());
        path.second.reserve(block.rows.size());
        for (const std::uint32_t row : block.rows) {
            part(last, row, path);
            const auto a = firstOf(row, second);
            const auto b = m.number(row, second);
            if (!b || (m_columns.first && !a)) {
                ++m_missing;
                continue;
            }
            path.second.push_back(*b);
            if (m_columns.first) {
                path.first.push_back(*a);
                m.setRole(row, *m_columns.firstOf(second), CellRole::position);
            }
            m.setRole(row, second, path.stated == Sense::clockwise ? CellRole::negative : CellRole::positive);
        }
        finish(path);
    }

    /// Ends the path if the line belongs to another one.
    void part(Parting &last, std::uint32_t row, RawPath &path) {
        auto sense = path.stated;
        bool ends = false;
        if (m_columns.senses) {
            const std::string_view word = m.cellText(row, *m_columns.senses);
            if (word != last.sense) {
                sense = senseIn(word);
                ends = !sense || sense != path.stated;
            }
            last.sense = word;
            if (!sense && m_unknownSense.empty())
                m_unknownSense = word;
        }
        if (m_columns.runs) {
            const std::string_view run = m.cellText(row, *m_columns.runs);
            ends |= run != last.run;
            last.run = run;
        }
        if (ends)
            finish(path);
        path.stated = sense;
    }

    void finish(RawPath &path) {
        if (!path.second.empty())
            m_paths.push_back(std::move(path));
        path = {};
    }

    /// Deviations without angles: where the path begins, and how far it goes.
    void putAtEqualSteps() {
        if (m_missing > 0)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT_COUNTED(
                             "report", "%n line(s) without a number: without angles every point is needed"),
                         {},
                         static_cast<int>(m_missing)});
        if (m_paths.empty())
            refuseCircleColumns();
        const auto runs = [](Sense sense) {
            return [sense](const RawPath &path) { return path.stated == sense; };
        };
        const bool isClockwise = std::ranges::all_of(m_paths, runs(Sense::clockwise));
        const bool areMixed = !isClockwise && std::ranges::any_of(m_paths, runs(Sense::clockwise));
        constexpr double wholeTurn = 360;
        const double usual = m.choices.usualNumber("arc").value_or(wholeTurn);
        const auto start = m.choices.resolveNumber(
            "startAngle", m.notes.startAngle.value_or(m.choices.usualNumber("startAngle").value_or(0)),
            m.notes.startAngle ? Origin::recognised : Origin::guessed);
        const auto way =
            m.choices.resolveNumber("arc", isClockwise ? -std::abs(usual) : usual, Origin::guessed);
        constexpr double mostAngle = 36'000;
        if (way.value == 0 || std::abs(way.value) > mostAngle || std::abs(start.value) > mostAngle)
            refuseContent(REPORT_TEXT("report", "start angle, arc or overshoot is beyond sense"));
        for (RawPath &path : m_paths) {
            const double extent = !areMixed || !path.stated          ? way.value
                                  : *path.stated == Sense::clockwise ? -std::abs(way.value)
                                                                     : std::abs(way.value);
            path.stated.reset(); // the angles have it
            const auto steps = static_cast<double>(std::max<std::size_t>(path.second.size(), 2) - 1);
            for (std::size_t i = 0; i < path.second.size(); ++i)
                path.first.push_back(start.value + extent * static_cast<double>(i) / steps);
        }
        const char *open = start.origin == Origin::guessed ? "startAngle"
                           : way.origin == Origin::guessed ? "arc"
                                                           : "";
        const RawPath &path = m_paths.front();
        m.remarks.add(
            *open == '\0' ? RemarkGrade::note : RemarkGrade::assumption, open,
            {REPORT_TEXT("report", "No angles: the points are put at equal steps from %1 to %2."),
             {Number{path.first.front(), Quantity::angle}, Number{path.first.back(), Quantity::angle}}});
    }

    [[nodiscard]] std::string planeOfHeadings() const {
        const std::string axes{m.body.columns[*m_columns.first].words.axis,
                               m.body.columns[m_columns.seconds.front()].words.axis};
        return planeOf(axes) ? axes : std::string();
    }

    /// The unit in the heading, otherwise in the lines above.
    [[nodiscard]] SaidUnit saidFor(const TableColumn &column) const {
        return column.said().isSaid() ? column.said() : m.notes.unit;
    }

    const Unit *resolveUnit(std::string_view key, const SaidUnit &stated, UnitKind kind, const char *guess,
                            Text remark) {
        const Unit *found = stated.unit && stated.unit->kind == kind ? stated.unit : nullptr;
        const Unit *unit =
            palmer::resolveUnit(key, stated, found, *unitOf(guess), {remark}, m.choices, m.remarks);
        if (!unit || unit->kind != kind)
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 for a circular test"), nameOfChoice(key),
                          nameOfWord(key, m.choices.chosen(key)));
        return unit;
    }

    double resolveRadius(double found, Origin origin) {
        const auto choice =
            m.notes.radius ? m.choices.resolveNumber("nominalRadius", *m.notes.radius, Origin::recognised)
                           : m.choices.resolveNumber("nominalRadius", found, origin);
        if (!(choice.value > 0))
            refuseContent(REPORT_TEXT("report", "the nominal radius is not positive"));
        return choice.value;
    }

    void convertXy(CircularMeasurement &measurement) {
        const Unit *unit =
            resolveUnit("unit", saidFor(m.body.columns[*m_columns.first]), UnitKind::length, "mm",
                        REPORT_TEXT("report", "Unit of x and y: nothing in the file says it; read as %1."));
        Points points;
        std::size_t count = 0;
        for (const RawPath &path : m_paths)
            count += path.first.size();
        points.x.reserve(count);
        points.y.reserve(count);
        for (RawPath &path : m_paths) {
            for (std::size_t i = 0; i < path.first.size(); ++i) {
                points.x.push_back(path.first[i] = unit->toBase(path.first[i]));
                points.y.push_back(path.second[i] = unit->toBase(path.second[i]));
            }
        }
        const LeastSquaresCircle fit = leastSquaresCircle(points.view());
        if (!fit.valid() || !(fit.radius > 0))
            refuseContent(REPORT_TEXT("report", "the points do not lie on a circle"));
        const bool atOrigin = std::hypot(fit.centre.x, fit.centre.y) < 0.2 * fit.radius;
        const std::string axes = planeOfHeadings();
        const auto stated = [&](std::size_t axis) {
            return axis < axes.size() ? m.notes.centre.find(axes[axis]) : m.notes.centre.end();
        };
        const bool isStated = stated(0) != m.notes.centre.end() && stated(1) != m.notes.centre.end();
        const std::optional<LeastSquaresCircle> commanded = commandedCircle(*unit);
        const Origin origin = atOrigin || isStated || commanded ? Origin::recognised : Origin::guessed;
        const auto centreOf = [&](const char *key, std::size_t axis, double fitted) {
            const double programmed = !commanded  ? rounded(fitted, 0.1)
                                      : axis == 0 ? rounded(commanded->centre.x, programmedStep)
                                                  : rounded(commanded->centre.y, programmedStep);
            const double found = isStated ? stated(axis)->second : atOrigin && !commanded ? 0 : programmed;
            return m.choices.resolveNumber(key, found, origin).value;
        };
        const double cx = centreOf("centreFirst", 0, fit.centre.x);
        const double cy = centreOf("centreSecond", 1, fit.centre.y);
        if (origin == Origin::guessed && !m.choices.isChosen("centreFirst"))
            m.remarks.assumption(
                "centreFirst", REPORT_TEXT("report", "Centre: nothing in the file says it; taken at %1; %2."),
                Number{cx, Quantity::position}, Number{cy, Quantity::position});
        const double radius =
            commanded ? resolveRadius(rounded(commanded->radius, programmedStep), Origin::recognised)
                      : resolveRadius(nominalOf(fit.radius), Origin::guessed);
        if (commanded)
            m.remarks.note({},
                           REPORT_TEXT("report", "Centre and nominal radius: those of the commanded "
                                                 "positions, %1; %2 and %3."),
                           Number{cx, Quantity::position}, Number{cy, Quantity::position},
                           Number{radius, Quantity::position});
        else
            remarkRadius(radius);
        measurement.nominalRadius = radius;
        for (const RawPath &path : m_paths) {
            Arc arc;
            for (std::size_t i = 0; i < path.first.size(); ++i) {
                const double x = path.first[i] - cx;
                const double y = path.second[i] - cy;
                arc.angles.push_back(std::atan2(y, x) / degree);
                // each C library rounds hypot in its own way, a square root none
                arc.radialDeviations.push_back(std::sqrt(x * x + y * y) - radius);
            }
            unwrap(arc.angles);
            addArcs(measurement, std::move(arc), path);
        }
        askForUnread(m, m_columns, [&](std::uint32_t row, std::size_t second) {
            const auto x = m.numberAt(row, *m_columns.firstOf(second));
            const auto y = m.numberAt(row, second);
            return x && y ? std::optional(std::hypot(unit->toBase(*x) - cx, unit->toBase(*y) - cy))
                          : std::nullopt;
        });
        askForCircle(measurement, points, fit.radius);
    }

    /// The programmed circle, where the table has commanded positions that lie on one.
    [[nodiscard]] std::optional<LeastSquaresCircle> commandedCircle(const Unit &unit) const {
        constexpr double accuracy = 0.002; // mm
        if (!m_columns.commanded)
            return {};
        Points points;
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const auto x = m.numberAt(row, m_columns.commanded->first);
                const auto y = m.numberAt(row, m_columns.commanded->second);
                if (!x || !y)
                    continue;
                points.x.push_back(unit.toBase(*x));
                points.y.push_back(unit.toBase(*y));
            }
        }
        const LeastSquaresCircle fit = leastSquaresCircle(points.view());
        double worst = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            worst =
                std::max(worst, std::abs(std::hypot(points.x[i] - fit.centre.x, points.y[i] - fit.centre.y) -
                                         fit.radius));
        return fit.valid() && worst < accuracy ? std::optional(fit) : std::nullopt;
    }

    /// Asks if the points are a circle: a fit to a straightness line is a circle of 78 m.
    void askForCircle(const CircularMeasurement &measurement, const Points &points, double radius) {
        constexpr std::size_t fewest = 8;
        constexpr double shortest = 45; // °
        constexpr double largest = 3;   // radius as a multiple of the extent of the points
        double span = 0;
        for (const Arc &arc : measurement.arcs) {
            const auto [from, to] = std::ranges::minmax(arc.angles);
            span = std::max(span, to - from);
        }
        const auto [left, right] = std::ranges::minmax(points.x);
        const auto [low, high] = std::ranges::minmax(points.y);
        const double extent = std::max(right - left, high - low);
        if (points.x.size() >= fewest && radius <= largest * extent && span >= shortest)
            return;
        m.remarks.problem("kind",
                          REPORT_TEXT("report", "Kind: an arc of %2 and radius "
                                                "%3 (points: %1) is hardly a circular test; is it one?"),
                          counted(points.x.size()), Number{span, Quantity::angle, 1},
                          Number{radius, Quantity::position, 0});
    }

    void remarkRadius(double radius) {
        if (!m.choices.isChosen("nominalRadius") && !m.notes.radius)
            m.remarks.assumption(
                "nominalRadius",
                REPORT_TEXT("report", "Nominal radius: nothing in the file says it; taken as %1."),
                Number{radius, Quantity::position});
    }

    /// Meaning of the numbers in a list of angles.
    struct AngleForm {
        bool radii = false; ///< otherwise radial deviations
        const Unit *angle = nullptr;
        const Unit *reading = nullptr;
        double radius = 0;     ///< nominal, mm
        bool inverted = false; ///< deviations are positive inwards
        AngleReference reference = AngleReference::polar;
    };

    /// "Diameter (mm)", "Durchmesser": half of it is read as the radius.
    void takeDiameters() {
        const std::string &heading = m.body.columns[m_columns.seconds.front()].heading;
        const std::string low = folded(heading);
        constexpr std::array<std::string_view, 4> words{"diameter", "durchmesser", "diametr", "\u2300"};
        if (std::ranges::none_of(words,
                                 [&](std::string_view word) { return low.find(word) != std::string::npos; }))
            return;
        for (RawPath &path : m_paths) {
            for (double &value : path.second)
                value /= 2;
        }
        m.remarks.note({}, REPORT_TEXT("report", "“%1”: half of each diameter is read as the radius."),
                       excerpt(heading));
    }

    void resolveAngleUnits(AngleForm &form) {
        double largest = 0;
        double mean = 0;
        double size = 0;
        std::size_t n = 0;
        for (const RawPath &path : m_paths) {
            for (std::size_t i = 0; i < path.first.size(); ++i, ++n) {
                largest = std::max(largest, std::abs(path.first[i]));
                mean += path.second[i];
                size = std::max(size, std::abs(path.second[i]));
            }
        }
        mean /= static_cast<double>(std::max<std::size_t>(n, 1));
        form.angle = unitOf("deg");
        if (m_columns.first && !m_columns.third)
            form.angle = resolveUnit(
                "positionUnit", m.body.columns[*m_columns.first].said(), UnitKind::angle,
                largest < 7 && n > 20 ? "rad" : "deg",
                REPORT_TEXT("report", "Unit of the angles: nothing in the file says it; read as %1."));
        const TableColumn &second = m.body.columns[m_columns.seconds.front()];
        form.reading = resolveUnit(
            "unit", saidFor(second), UnitKind::length, form.radii || size < 0.5 ? "mm" : "um",
            REPORT_TEXT("report", "Unit of the radial deviations: nothing in the file says it; read as %1."));
        constexpr double anyRadius = 150; // to continue reading, as deviations do not depend on it
        form.radius =
            resolveRadius(form.radii ? nominalOf(form.reading->toBase(mean)) : anyRadius, Origin::guessed);
        if (form.radii)
            remarkRadius(form.radius);
        else if (!m.choices.isChosen("nominalRadius") && !m.notes.radius)
            m.remarks.problem("nominalRadius",
                              REPORT_TEXT("report", "Nominal radius: nothing in the file says it, and "
                                                    "deviations do not show it; state it in mm."));
    }

    /// A radial deviation is positive outwards; the other sign is a choice.
    void resolveRadialSign(AngleForm &form) {
        if (form.radii)
            return;
        const SaidSign &said = m.notes.sign;
        const auto sign =
            m.choices.resolve("sign", said.sign.empty() ? "actualMinusTarget" : said.sign, Origin::guessed);
        form.inverted = sign.value == "targetMinusActual";
        if (sign.origin == Origin::guessed && !said.words.empty())
            m.remarks.problem(
                "sign",
                form.inverted ? REPORT_TEXT("report", "Sign: the file says “%1”; read as positive inwards.")
                              : REPORT_TEXT("report", "Sign: the file says “%1”; read as positive outwards."),
                excerpt(said.words));
        else if (sign.origin == Origin::guessed)
            m.remarks.note("sign",
                           REPORT_TEXT("report", "Sign: radial deviations are read as positive outwards."));
    }

    void resolveReference(AngleForm &form) {
        const bool isCommanded =
            m_columns.first && !m_columns.third && m.body.columns[*m_columns.first].words.isTarget;
        const auto reference = m.choices.resolve("angleReference", isCommanded ? "commanded" : "polar",
                                                 isCommanded ? Origin::recognised : Origin::guessed);
        form.reference = reference.value == "commanded" ? AngleReference::commanded : AngleReference::polar;
        if (reference.origin == Origin::guessed)
            m.remarks.assumption("angleReference",
                                 REPORT_TEXT("report", "Angles: read as those of the measured "
                                                       "point, not of the programmed path (a ballbar)."));
    }

    void convertAngles(CircularMeasurement &measurement) {
        AngleForm form{m_columns.layout == "angleRadius"};
        takeDiameters();
        resolveAngleUnits(form);
        resolveRadialSign(form);
        resolveReference(form);
        measurement.nominalRadius = form.radius;
        for (RawPath &path : m_paths) {
            Arc arc;
            arc.angleReference = form.reference;
            for (std::size_t i = 0; i < path.first.size(); ++i) {
                arc.angles.push_back(form.angle->toBase(path.first[i]));
                const double value = form.reading->toBase(path.second[i]);
                arc.radialDeviations.push_back(form.radii      ? value - form.radius
                                               : form.inverted ? 0 - value
                                                               : value);
            }
            unwrap(arc.angles);
            addArcs(measurement, std::move(arc), path);
        }
        askForUnread(m, m_columns, [&](std::uint32_t row, std::size_t second) {
            const auto value = m.numberAt(row, second);
            return value ? std::optional(form.reading->toBase(*value)) : value;
        });
    }

    /// Cuts off the angular overshoot that the file states, if the points have it; asks where they run on
    /// beyond whole turns.
    void cutOvershoot(CircularMeasurement &measurement) {
        constexpr double turn = 360;
        double span = 0;
        double step = 0;
        for (const Arc &arc : measurement.arcs) {
            span = std::max(span, std::abs(arc.angles.back() - arc.angles.front()));
            for (std::size_t i = 1; i < arc.angles.size(); ++i) // large if the points are in no order
                step = std::max(step, std::abs(arc.angles[i] - arc.angles[i - 1]));
        }
        const double stated = m.notes.overshoot.value_or(0);
        const double beyond = std::abs(std::remainder(span, turn));
        const bool isInPoints = stated > 0 && std::abs(span - 2 * stated - turn) < 2 * step;
        const bool isDoubtful = span > turn && beyond > 2 * step && !isInPoints;
        if (stated == 0 && !isDoubtful && !m.choices.isChosen("overshoot"))
            return;
        const Choice<double> overshoot = m.choices.resolveNumber(
            "overshoot", isInPoints ? stated : 0, isDoubtful ? Origin::guessed : Origin::recognised);
        if (overshoot.value < 0 || 2 * overshoot.value >= std::max(span, step))
            refuseContent(REPORT_TEXT("report", "start angle, arc or overshoot is beyond sense"));
        if (overshoot.origin == Origin::guessed)
            m.remarks.assumption("overshoot",
                                 REPORT_TEXT("report", "Angular overshoot: the points run over %1; all are "
                                                       "evaluated."),
                                 Number{span, Quantity::angle, 1});
        else if (stated > 0 && overshoot.value == 0)
            m.remarks.note({},
                           REPORT_TEXT("report", "Angular overshoot: %1 is stated, but the points run over "
                                                 "%2; nothing is cut off."),
                           Number{stated, Quantity::angle, 1}, Number{span, Quantity::angle, 1});
        for (Arc &arc : measurement.arcs) {
            const auto [low, high] = std::minmax(arc.angles.front(), arc.angles.back());
            if (overshoot.value > 0)
                arc.evaluated = Interval{low + overshoot.value, high - overshoot.value};
        }
    }

    /// A path that reverses is two arcs. If a stated sense contradicts the angles, the points were listed by
    /// angle, and their order is reversed.
    void addArcs(CircularMeasurement &measurement, Arc path, const RawPath &raw) {
        const std::optional<Sense> stated = raw.stated;
        const std::string_view chosen = m.choices.chosen("sense");
        for (double &angle : path.angles)
            angle = chosen == "mirrored" ? 0 - angle : angle;
        const std::size_t turn = turningPoint(path.angles);
        if (turn > 0 && !stated) {
            if (raw.title && senseIn(m.textOf(*raw.title)))
                m_unclearTitle = raw.title;
            Arc second = path;
            const auto at = static_cast<std::ptrdiff_t>(turn);
            second.angles.erase(second.angles.begin(), second.angles.begin() + at);
            second.radialDeviations.erase(second.radialDeviations.begin(),
                                          second.radialDeviations.begin() + at);
            path.angles.resize(turn);
            path.radialDeviations.resize(turn);
            path.sense = senseOf(path.angles);
            second.sense = senseOf(second.angles);
            measurement.arcs.push_back(std::move(path));
            measurement.arcs.push_back(std::move(second));
            return;
        }
        path.sense = senseOf(path.angles);
        if (raw.title && senseIn(m.textOf(*raw.title)) != path.sense)
            m_unclearTitle = raw.title;
        m_stated += stated ? 1 : 0;
        m_turned += stated && *stated != path.sense ? 1 : 0;
        if (stated && *stated != path.sense && chosen != "angles") {
            std::ranges::reverse(path.angles);
            std::ranges::reverse(path.radialDeviations);
            path.sense = *stated;
        }
        measurement.arcs.push_back(std::move(path));
    }

    /// Index of the first point of the way back of a path that goes there and back; 0 if it does not reverse.
    [[nodiscard]] static std::size_t turningPoint(const std::vector<double> &angles) {
        if (angles.size() < 8)
            return 0;
        // The first of equal ones, as the way back may repeat the last point of the way there.
        const auto low = std::ranges::min_element(angles);
        const auto high = std::ranges::max_element(angles);
        const auto farthest = std::abs(*high - angles.front()) > std::abs(*low - angles.front()) ? high : low;
        const double there = std::abs(*farthest - angles.front());
        const double back = std::abs(*farthest - angles.back());
        if (there < 45 || back < 0.5 * there)
            return 0;
        return static_cast<std::size_t>(farthest - angles.begin()) + 1;
    }

    TableReading &m;
    CircleColumns m_columns;
    std::vector<RawPath> m_paths;
    std::size_t m_missing = 0;
    std::string_view m_unknownSense;             ///< the first word of a column of senses that names none
    std::optional<std::uint32_t> m_unclearTitle; ///< against which the angles run
    std::size_t m_stated = 0;                    ///< paths with a stated sense
    std::size_t m_turned = 0;                    ///< those of them against which the angles run
};

} // namespace

bool areOnCircle(const TableReading &reading, std::size_t xColumn, std::size_t yColumn) {
    Points points;
    std::size_t rows = 0;
    const std::size_t step = std::max<std::size_t>(1, reading.body.rowCount() / 2000);
    for (const TableBlock &block : reading.body.blocks) {
        for (const std::uint32_t row : block.rows) {
            if (rows++ % step != 0)
                continue;
            const auto x = reading.numberAt(row, xColumn);
            const auto y = reading.numberAt(row, yColumn);
            if (x && y) {
                points.x.push_back(*x);
                points.y.push_back(*y);
            }
        }
    }
    if (points.size() < 12)
        return false;
    const LeastSquaresCircle fit = leastSquaresCircle(points.view());
    if (!fit.valid() || !(fit.radius > 0))
        return false;
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        worst = std::max(
            worst, std::abs(std::hypot(points.x[i] - fit.centre.x, points.y[i] - fit.centre.y) - fit.radius));
    const auto [left, right] = std::ranges::minmax(points.x);
    const auto [low, high] = std::ranges::minmax(points.y);
    // Small deviations over a whole turn fit a huge circle as well as a line: the curvature must be visible.
    const double bend = std::min(right - left, high - low);
    return worst < 0.02 * fit.radius && worst < 0.1 * bend && right - left > 0.1 * fit.radius;
}

void readCircles(TableReading &reading) {
    CircleReader(reading).read();
}

} // namespace palmer
