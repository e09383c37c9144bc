// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/arcs.h"
#include "import/layouts/passes.h"
#include "import/layouts/tablereading.h"

#include "document/place.h"
#include "kernel/numerics/angles.h"
#include "kernel/numerics/leastsquarescircle.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace palmer {

namespace {

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
};

class CircleReader {
public:
    explicit CircleReader(TableReading &reading)
        : m(reading) {}

    void read() {
        chooseColumns();
        const std::string layout = resolveLayout();
        collectPaths();
        CircularMeasurement measurement;
        Test test;
        std::string plane = m.notes.plane;
        if (plane.empty() && layout == "xy")
            plane = planeOfHeadings();
        resolveCircle(measurement, test.edition, plane, m.notes.feed, m.choices, m.result.remarks);
        if (layout == "deviations")
            putAtEqualSteps();
        if (layout == "xy")
            convertXy(measurement);
        else
            convertAngles(measurement, layout == "angleRadius");
        if (measurement.arcs.empty())
            refuseContent(REPORT_TEXT("report", "there are no points of a circle in it"));
        std::size_t points = 0;
        for (const Arc &arc : measurement.arcs)
            points += arc.angles.size();
        m.remarks.note({}, REPORT_TEXT("report", "Understood: paths: %1; points: %2."),
                       counted(measurement.arcs.size()), counted(points));
        if (m_missing > 0)
            m.remarks.problem("unread", REPORT_TEXT("report", "Points without a number were left out: %1."),
                              counted(m_missing));
        test.measurement = std::move(measurement);
        m.result.test = std::move(test);
    }

private:
    void chooseColumns() {
        takeRoles();
        const auto choice = m.choices.resolve("columns", wordOf(m.result.columns),
                                              m_question ? Origin::guessed : Origin::recognised);
        if (choice.origin == Origin::chosen)
            takeChosen(choice.value);
        else if (m_question)
            m.remarks.add(RemarkGrade::assumption, "columns", *m_question);
        if (m_seconds.empty())
            refuseColumns();
        takeNominal();
    }

    [[noreturn]] static void refuseColumns() {
        refuseContent(REPORT_TEXT("report", "these columns do not make a circle; expected x and y, angle and "
                                            "radius, angle and deviation, or radial deviations alone"));
    }

    void setRole(std::size_t column, ColumnRole role) { m.result.columns[column].role = role; }

    [[nodiscard]] std::vector<std::size_t> numbersOf(Meaning meaning) const {
        std::vector<std::size_t> found;
        for (const std::size_t c : m.body.numberColumns()) {
            if (m.body.columns[c].meaning == meaning)
                found.push_back(c);
        }
        return found;
    }

    /// Columns named as angles, otherwise those with an angle's unit: "Angular position (°)".
    [[nodiscard]] std::vector<std::size_t> angleColumns() const {
        std::vector<std::size_t> angles = numbersOf(Meaning::angle);
        if (!angles.empty())
            return angles;
        for (const Meaning meaning : {Meaning::place, Meaning::target, Meaning::unknown}) {
            std::ranges::copy_if(numbersOf(meaning), std::back_inserter(angles), [&](std::size_t c) {
                const Unit *unit = m.body.columns[c].unit;
                return unit && unit->kind == UnitKind::angle;
            });
        }
        return angles;
    }

    /// Columns of radial deviations without angles: named so, otherwise by a sense, otherwise the first.
    [[nodiscard]] std::vector<std::size_t> deviationsAlone() const {
        std::vector<std::size_t> found = numbersOf(Meaning::deviation);
        const std::vector<std::size_t> columns = m.body.numberColumns();
        if (found.empty())
            std::ranges::copy_if(columns, std::back_inserter(found), [&](std::size_t c) {
                return senseIn(m.body.columns[c].heading).has_value();
            });
        if (found.empty() && !columns.empty())
            found = {columns.front()};
        return found;
    }

    /// Columns of radii, otherwise of deviations, otherwise those the headings do not name. Precondition: the
    /// column of angles is known.
    [[nodiscard]] std::vector<std::size_t> readingsByAngle() {
        for (const Meaning meaning : {Meaning::radius, Meaning::deviation}) {
            if (std::vector<std::size_t> found = numbersOf(meaning); !found.empty())
                return found;
        }
        return unnamed();
    }

    /// Sets the roles of columns by their headings; columns of different roles are never paths of one test.
    void takeRoles() {
        const TableBody &body = m.body;
        m.result.columns = m.columnsAs({});
        const auto of = [&](Meaning meaning) { return numbersOf(meaning); };
        const std::vector<std::size_t> angle = angleColumns();
        const auto coordinates = coordinateColumns();
        m_named = coordinates || !angle.empty();
        // "angle, x, y": points, and the angles at which they were taken.
        const bool isXy =
            coordinates && (angle.empty() || (of(Meaning::radius).empty() && of(Meaning::deviation).empty()));
        if (body.numberColumns().size() == 1 || m.choices.chosen("layout") == "deviations") {
            m_first.reset();
            m_seconds = deviationsAlone();
        } else if (isXy) {
            m_first = coordinates->first;
            m_seconds = {coordinates->second};
        } else {
            m_first = angle.empty() ? firstUnnamed() : angle.front();
            m_seconds = readingsByAngle();
        }
        if (m_first)
            setRole(*m_first, isXy ? ColumnRole::x : ColumnRole::angle);
        for (const std::size_t c : m_seconds)
            setRole(c, !m_first ? ColumnRole::deviation : isXy ? ColumnRole::y : roleOf(c));
        for (const std::size_t c : of(Meaning::nominal))
            setRole(c, ColumnRole::nominal);
        takeSenses();
        if (const auto runs = columnOfRuns())
            setRole(*runs, ColumnRole::number);
    }

    /// Two columns named after axes, in the order of the plane: the stated one, otherwise the table's.
    [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> coordinateColumns() const {
        std::vector<std::size_t> found;
        const auto letter = [&](std::size_t c) { return m.body.columns[c].words.axis; };
        for (const std::size_t c : m.body.numberColumns()) {
            const Meaning meaning = m.body.columns[c].meaning;
            if ((meaning == Meaning::x || meaning == Meaning::y) &&
                std::ranges::find(found, letter(c), letter) == found.end())
                found.push_back(c);
        }
        if (found.size() < 2)
            return {};
        const std::string plane =
            upperCase(m.choices.isChosen("plane") ? m.choices.chosen("plane") : m.notes.plane);
        if (plane.size() == 2) {
            const auto first = std::ranges::find(found, plane[0], letter);
            const auto second = std::ranges::find(found, plane[1], letter);
            if (first != found.end() && second != found.end() && first != second)
                return std::pair(*first, *second);
        }
        const bool isYx = letter(found[0]) == 'Y' && letter(found[1]) == 'X';
        return isYx ? std::pair(found[1], found[0]) : std::pair(found[0], found[1]);
    }

    [[nodiscard]] ColumnRole roleOf(std::size_t c) const {
        return m.body.columns[c].meaning == Meaning::radius ? ColumnRole::radius : ColumnRole::deviation;
    }

    [[nodiscard]] std::size_t firstUnnamed() const {
        const std::vector<std::size_t> columns = m.body.numberColumns();
        const bool counts = columns.size() > 2 && isCounter(m, columns.front());
        return columns[counts ? 1 : 0];
    }

    /// Columns with undefined headings: those that name a sense, otherwise all of similar size.
    [[nodiscard]] std::vector<std::size_t> unnamed() {
        std::vector<std::size_t> columns;
        std::vector<std::size_t> sensed;
        for (const std::size_t c : m.body.numberColumns()) {
            const Meaning meaning = m.body.columns[c].meaning;
            if (c <= *m_first || !(meaning == Meaning::unknown || meaning == Meaning::run ||
                                   meaning == Meaning::reading || meaning == Meaning::actual))
                continue;
            columns.push_back(c);
            if (senseIn(m.body.columns[c].heading))
                sensed.push_back(c);
        }
        if (!sensed.empty() || columns.size() < 2)
            return sensed.empty() ? columns : sensed;
        const bool named =
            std::ranges::any_of(columns, [&](std::size_t c) { return !m.body.columns[c].heading.empty(); });
        const bool radii = areRadii(columns.front());
        const std::size_t all = columns.size();
        std::erase_if(columns, [&](std::size_t c) { return areRadii(c) != radii; });
        if (named || columns.size() < all)
            m_question = {REPORT_TEXT("report", "Columns: the headings do not say which hold readings; "
                                                "column %1 and those like it are read."),
                          {counted(columns.front() + 1)}};
        return columns;
    }

    [[nodiscard]] bool areRadii(std::size_t column) const {
        const auto [low, high] = m.rangeOf(column);
        return low > 0 && high - low < 0.1 * high;
    }

    void takeChosen(const std::string &text) {
        std::vector<ImportColumn> chosen = m.columnsAs(text);
        m_seconds.clear();
        m_named = true;
        std::optional<std::size_t> first;
        for (std::size_t c = 0; c < chosen.size(); ++c) {
            const ColumnRole role = chosen[c].role;
            if (!first && (role == ColumnRole::angle || role == ColumnRole::x))
                first = c;
            if (role == ColumnRole::radius || role == ColumnRole::y || role == ColumnRole::deviation)
                m_seconds.push_back(c);
        }
        const bool pooled = std::ranges::any_of(
            m_seconds, [&](std::size_t c) { return chosen[c].role != chosen[m_seconds.front()].role; });
        if (m_seconds.empty() || pooled ||
            (!first && chosen[m_seconds.front()].role != ColumnRole::deviation))
            refuseColumns();
        m_first = first;
        m.result.columns = std::move(chosen);
        if (!columnOf(m.result.columns, ColumnRole::direction))
            takeSenses();
    }

    /// Reads a column of senses even if its role is not among those chosen.
    void takeSenses() {
        const auto senses = columnOfSenses();
        if (senses && m.result.columns[*senses].role == ColumnRole::ignored)
            setRole(*senses, ColumnRole::direction);
    }

    /// Takes the nominal radius from a column with the same value in every line.
    void takeNominal() {
        for (std::size_t c = 0; c < m.result.columns.size(); ++c) {
            if (m.result.columns[c].role != ColumnRole::nominal || m.notes.radius)
                continue;
            const auto [low, high] = m.rangeOf(c);
            const Unit *unit = m.result.columns[c].unit;
            if (low == high && low > 0)
                m.notes.radius = unit && unit->kind == UnitKind::length ? unit->toBase(low) : low;
        }
    }

    [[nodiscard]] static Message contentOf(std::string_view layout) {
        if (layout == "xy")
            return {REPORT_TEXT("report", "Content: the columns are read as x and y of points of a circle.")};
        if (layout == "angleRadius")
            return {REPORT_TEXT("report", "Content: the columns are read as angle and radius.")};
        return {REPORT_TEXT("report", "Content: the columns are read as angle and radial deviation.")};
    }

    /// The layout that the headings name, otherwise a guess from the numbers.
    [[nodiscard]] Choice<std::string> recognisedLayout() const {
        const Meaning meaning = m.body.columns[m_seconds.front()].meaning;
        if (!m_first)
            return {"deviations", Origin::recognised};
        if (m.result.columns[*m_first].role == ColumnRole::x)
            return {"xy", Origin::recognised};
        if (!m_named && areOnCircle(m, *m_first, m_seconds.front()))
            return {"xy", Origin::guessed};
        if (m.choices.isChosen("columns") || meaning == Meaning::radius || meaning == Meaning::deviation)
            return {m.result.columns[m_seconds.front()].role == ColumnRole::radius ? "angleRadius"
                                                                                   : "angleDeviation",
                    Origin::recognised};
        return {areRadii(m_seconds.front()) ? "angleRadius" : "angleDeviation", Origin::guessed};
    }

    std::string resolveLayout() {
        const Choice<std::string> found = recognisedLayout();
        const auto choice = m.choices.resolve("layout", found.value, found.origin);
        if (!isLayoutOfCircles(choice.value))
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 for a circular test"),
                          nameOfChoice("layout"), nameOfWord("layout", choice.value));
        if ((choice.value == "deviations") == m_first.has_value())
            refuseColumns();
        if (choice.origin == Origin::guessed)
            m.remarks.add(RemarkGrade::assumption, "layout", contentOf(choice.value));
        // The layout determines the columns, even if it was chosen against their headings.
        const bool isXy = choice.value == "xy";
        if (m_first)
            setRole(*m_first, isXy ? ColumnRole::x : ColumnRole::angle);
        for (const std::size_t second : m_seconds)
            setRole(second, isXy                            ? ColumnRole::y
                            : choice.value == "angleRadius" ? ColumnRole::radius
                                                            : ColumnRole::deviation);
        return choice.value;
    }

    void collectPaths() {
        for (const std::size_t second : m_seconds) {
            const std::optional<Sense> ofColumn = senseIn(m.body.columns[second].heading);
            for (const TableBlock &block : m.body.blocks)
                collectPaths(block, second, ofColumn ? ofColumn : senseIn(m.titleOf(block)));
        }
        askForSenses();
    }

    /// Two columns with common angles have the same sense unless a word distinguishes them.
    void askForSenses() {
        if (!m_unknownSense.empty())
            m.remarks.problem(
                "columns",
                REPORT_TEXT("report", "Sense: “%1” is neither clockwise nor counterclockwise to the program; "
                                      "those points are read as their angles run."),
                excerpt(m_unknownSense));
        const auto isSilent = [](const RawPath &path) { return !path.stated; };
        if (m_seconds.size() == 2 && m.body.blocks.size() == 1 && std::ranges::any_of(m_paths, isSilent) &&
            !m_question && !m.choices.isChosen("columns"))
            m.remarks.problem("columns",
                              REPORT_TEXT("report", "Sense: no word says which "
                                                    "column is clockwise; both are read as the angles run."));
    }

    /// Columns that split the lines of a block into paths.
    struct Parting {
        std::optional<std::size_t> senses;
        std::optional<std::size_t> runs;
        std::string_view lastSense = {};
        std::string_view lastRun = {};
    };

    /// Collects the paths of a block and column: a new one where another sense or run is named.
    void collectPaths(const TableBlock &block, std::size_t second, std::optional<Sense> stated) {
        Parting parting{columnOf(m.result.columns, ColumnRole::direction), columnOfRuns()};
        RawPath path;
        path.stated = stated;
        path.first.reserve(block.rows.size());
        path.second.reserve(block.rows.size());
        for (const std::uint32_t row : block.rows) {
            part(parting, row, path);
            const auto a = m_first ? m.number(row, *m_first) : std::nullopt;
            const auto b = m.number(row, second);
            if (!b || (m_first && !a)) {
                ++m_missing;
                continue;
            }
            path.second.push_back(*b);
            if (m_first) {
                path.first.push_back(*a);
                m.setRole(row, *m_first, CellRole::position);
            }
            m.setRole(row, second, path.stated == Sense::clockwise ? CellRole::negative : CellRole::positive);
        }
        finish(path);
    }

    /// Ends the path if the line belongs to another one.
    void part(Parting &parting, std::uint32_t row, RawPath &path) {
        auto sense = path.stated;
        bool ends = false;
        if (parting.senses) {
            const std::string_view word = m.cellText(row, *parting.senses);
            if (word != parting.lastSense) {
                sense = senseIn(word);
                ends = !sense || sense != path.stated;
            }
            parting.lastSense = word;
            if (!sense && m_unknownSense.empty())
                m_unknownSense = word;
        }
        if (parting.runs) {
            const std::string_view run = m.cellText(row, *parting.runs);
            ends |= run != parting.lastRun;
            parting.lastRun = run;
        }
        if (ends)
            finish(path);
        path.stated = sense;
    }

    /// The column of path numbers: each path has its own arc.
    [[nodiscard]] std::optional<std::size_t> columnOfRuns() const {
        const std::vector<std::size_t> found = numbersOf(Meaning::run);
        return found.size() == 1 && m_first != found.front() &&
                       std::ranges::find(m_seconds, found.front()) == m_seconds.end()
                   ? std::optional(found.front())
                   : std::nullopt;
    }

    /// The column of words that name the sense, otherwise of words below a heading that names it.
    [[nodiscard]] std::optional<std::size_t> columnOfSenses() const {
        if (const auto known = m.body.columnOf(ColumnKind::senses))
            return known;
        for (std::size_t c = 0; c < m.body.columns.size(); ++c) {
            if (m.body.columns[c].kind == ColumnKind::words &&
                m.body.columns[c].meaning == Meaning::direction)
                return c;
        }
        return {};
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
            refuseColumns();
        const auto runs = [](Sense sense) {
            return [sense](const RawPath &path) { return path.stated == sense; };
        };
        const bool isClockwise = std::ranges::all_of(m_paths, runs(Sense::clockwise));
        const bool areMixed = !isClockwise && std::ranges::any_of(m_paths, runs(Sense::clockwise));
        constexpr double wholeTurn = 360;
        const double usual = m.choices.usualNumber("arc").value_or(wholeTurn);
        const auto start = m.choices.resolveNumber(
            "startAngle", m.choices.usualNumber("startAngle").value_or(0), Origin::guessed);
        const auto way =
            m.choices.resolveNumber("arc", isClockwise ? -std::abs(usual) : usual, Origin::guessed);
        constexpr double mostAngle = 36'000;
        if (way.value == 0 || std::abs(way.value) > mostAngle || std::abs(start.value) > mostAngle)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "start angle, arc or overshoot is beyond sense")});
        for (RawPath &path : m_paths) {
            const double extent = !areMixed || !path.stated          ? way.value
                                  : *path.stated == Sense::clockwise ? -std::abs(way.value)
                                                                     : std::abs(way.value);
            path.stated.reset(); // the angles have it
            const auto steps = static_cast<double>(std::max<std::size_t>(path.second.size(), 2) - 1);
            for (std::size_t i = 0; i < path.second.size(); ++i)
                path.first.push_back(start.value + extent * static_cast<double>(i) / steps);
        }
        const char *open = start.origin != Origin::chosen ? "startAngle"
                           : way.origin != Origin::chosen ? "arc"
                                                          : "";
        const RawPath &path = m_paths.front();
        m.remarks.add(
            *open == '\0' ? RemarkGrade::note : RemarkGrade::assumption, open,
            {REPORT_TEXT("report", "No angles: the points are put at equal steps from %1 to %2."),
             {Number{path.first.front(), Quantity::angle}, Number{path.first.back(), Quantity::angle}}});
    }

    [[nodiscard]] std::string planeOfHeadings() const {
        const std::string a = withoutUnit(m.body.columns[*m_first].heading);
        const std::string b = withoutUnit(m.body.columns[m_seconds.front()].heading);
        return a.size() == 1 && b.size() == 1 ? upperCase(a + b) : std::string();
    }

    /// The unit in the heading, otherwise in the lines above.
    [[nodiscard]] SaidUnit saidFor(const TableColumn &column) const {
        return column.said().isSaid() ? column.said() : m.notes.unit;
    }

    const Unit *resolveUnit(std::string_view key, const SaidUnit &stated, UnitKind kind, const char *guess,
                            Text remark) {
        const Unit *found = stated.unit && stated.unit->kind == kind ? stated.unit : nullptr;
        const Unit *unit =
            palmer::resolveUnit(key, stated, found, *unitOf(guess), {remark}, m.choices, m.result.remarks);
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
            resolveUnit("unit", saidFor(m.body.columns[*m_first]), UnitKind::length, "mm",
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
        const Origin origin = atOrigin ? Origin::recognised : Origin::guessed;
        const double cx =
            m.choices.resolveNumber("centreFirst", atOrigin ? 0 : rounded(fit.centre.x, 0.1), origin).value;
        const double cy =
            m.choices.resolveNumber("centreSecond", atOrigin ? 0 : rounded(fit.centre.y, 0.1), origin).value;
        if (!atOrigin && !m.choices.isChosen("centreFirst"))
            m.remarks.assumption(
                "centreFirst", REPORT_TEXT("report", "Centre: nothing in the file says it; taken at %1; %2."),
                Number{cx, Quantity::position}, Number{cy, Quantity::position});
        const double radius = resolveRadius(nominalOf(fit.radius), Origin::guessed);
        remarkRadius(radius);
        measurement.nominalRadius = radius;
        for (const RawPath &path : m_paths) {
            Arc arc;
            arc.angles.reserve(path.first.size());
            arc.radialDeviations.reserve(path.first.size());
            for (std::size_t i = 0; i < path.first.size(); ++i) {
                const double x = path.first[i] - cx;
                const double y = path.second[i] - cy;
                arc.angles.push_back(std::atan2(y, x) / degree);
                arc.radialDeviations.push_back(std::hypot(x, y) - radius);
            }
            unwrap(arc.angles);
            addArcs(measurement, std::move(arc), path.stated);
        }
        askForCircle(measurement, points, fit.radius);
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
        if (m_first)
            form.angle = resolveUnit(
                "positionUnit", m.body.columns[*m_first].said(), UnitKind::angle,
                largest < 7 && n > 20 ? "rad" : "deg",
                REPORT_TEXT("report", "Unit of the angles: nothing in the file says it; read as %1."));
        const TableColumn &second = m.body.columns[m_seconds.front()];
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
        const auto sign = m.choices.resolve("sign", "actualMinusTarget", Origin::guessed);
        form.inverted = sign.value == "targetMinusActual";
        if (sign.origin == Origin::guessed)
            m.remarks.note("sign",
                           REPORT_TEXT("report", "Sign: radial deviations are read as positive outwards."));
    }

    void resolveReference(AngleForm &form) {
        const auto reference = m.choices.resolve("angleReference", "polar", Origin::guessed);
        form.reference = reference.value == "commanded" ? AngleReference::commanded : AngleReference::polar;
        if (reference.origin == Origin::guessed)
            m.remarks.assumption("angleReference",
                                 REPORT_TEXT("report", "Angles: read as those of the measured "
                                                       "point, not of the programmed path (a ballbar)."));
    }

    void convertAngles(CircularMeasurement &measurement, bool radii) {
        AngleForm form{radii};
        resolveAngleUnits(form);
        resolveRadialSign(form);
        resolveReference(form);
        measurement.nominalRadius = form.radius;
        for (RawPath &path : m_paths) {
            Arc arc;
            arc.angleReference = form.reference;
            arc.angles.reserve(path.first.size());
            arc.radialDeviations.reserve(path.first.size());
            for (std::size_t i = 0; i < path.first.size(); ++i) {
                arc.angles.push_back(form.angle->toBase(path.first[i]));
                const double value = form.reading->toBase(path.second[i]);
                arc.radialDeviations.push_back(radii           ? value - form.radius
                                               : form.inverted ? 0 - value
                                                               : value);
            }
            unwrap(arc.angles);
            addArcs(measurement, std::move(arc), path.stated);
        }
    }

    /// A path that reverses is two arcs. If a stated sense contradicts the angles, the points were listed by
    /// angle, and their order is reversed.
    void addArcs(CircularMeasurement &measurement, Arc path, std::optional<Sense> stated) {
        const std::size_t turn = turningPoint(path.angles);
        if (turn > 0 && !stated) {
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
        if (stated && *stated != path.sense) {
            std::ranges::reverse(path.angles);
            std::ranges::reverse(path.radialDeviations);
            path.sense = *stated;
            if (!m_turned)
                m.remarks.problem(
                    {}, REPORT_TEXT("report", "Sense: the angles run against the sense the file names; the "
                                              "points are taken in the opposite order."));
            m_turned = true;
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
    std::optional<std::size_t> m_first; ///< angles or x; null: radial deviations alone
    std::vector<std::size_t> m_seconds;
    std::vector<RawPath> m_paths;
    std::size_t m_missing = 0;
    std::optional<Message> m_question;
    std::string_view m_unknownSense; ///< the first word of a column of senses that names none
    bool m_named = false;
    bool m_turned = false;
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
