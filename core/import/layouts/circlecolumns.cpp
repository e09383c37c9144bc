// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/arcs.h"

#include "document/place.h"
#include "tables/contenterror.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace palmer {

namespace {

/// Layouts of points of a circle: the role of the second columns, and the question where it is a guess.
struct CircleLayout {
    std::string_view word;
    ColumnRole second;
    Text content;
};
constexpr std::array circleLayouts{
    CircleLayout{"xy", ColumnRole::y,
                 REPORT_TEXT("report", "Content: the columns are read as x and y of points of a circle.")},
    CircleLayout{"angleRadius", ColumnRole::radius,
                 REPORT_TEXT("report", "Content: the columns are read as angle and radius.")},
    CircleLayout{"angleDeviation", ColumnRole::deviation,
                 REPORT_TEXT("report", "Content: the columns are read as angle and radial deviation.")},
    CircleLayout{"deviations", ColumnRole::deviation, {}},
};

class CircleColumnSearch {
public:
    explicit CircleColumnSearch(TableReading &reading)
        : m(reading) {}

    CircleColumns find() {
        takeRoles();
        if (const auto chosen = m.resolveColumns(m.result.columns, m_question, RemarkGrade::assumption))
            takeChosen(*chosen);
        if (m_found.seconds.empty())
            refuseCircleColumns();
        keepOneTest(m, m_found);
        if (m_found.seconds.empty() || m.body.blocks.empty()) // "As left" above columns "As found"
            refuseContent(REPORT_TEXT("report", "there are no points of a circle in it"));
        takeNominal();
        resolveLayout();
        m_found.senses = columnOf(m.result.columns, ColumnRole::direction);
        m_found.runs = columnOfRuns();
        return std::move(m_found);
    }

private:
    void setRole(std::size_t column, ColumnRole role) { m.result.columns[column].role = role; }
    [[nodiscard]] Meaning meaningOf(std::size_t column) const { return m.body.columns[column].meaning; }

    /// Columns named as angles, otherwise those with an angle's unit: "Angular position (°)".
    [[nodiscard]] std::vector<std::size_t> angleColumns() const {
        std::vector<std::size_t> angles = m.body.numberColumns(Meaning::angle);
        if (!angles.empty())
            return angles;
        for (const Meaning meaning : {Meaning::place, Meaning::target, Meaning::unknown}) {
            std::ranges::copy_if(m.body.numberColumns(meaning), std::back_inserter(angles),
                                 [&](std::size_t c) { return m.body.columns[c].isIn(UnitKind::angle); });
        }
        return angles;
    }

    /// Columns of radial deviations without angles: named so, otherwise by a sense, otherwise the first.
    [[nodiscard]] std::vector<std::size_t> deviationsAlone() const {
        std::vector<std::size_t> found = m.body.numberColumns(Meaning::deviation);
        if (found.empty())
            found = m.body.columnsWhere(
                [](const TableColumn &column) { return column.isNumeric() && senseIn(column.heading); });
        if (found.empty())
            std::ranges::copy_if(m.body.numberColumns(), std::back_inserter(found),
                                 [&](std::size_t c) { return isNamedReading(c); });
        if (found.empty() && !m.body.numberColumns().empty())
            found = {firstUnnamed()};
        return found;
    }

    /// Columns of radii, otherwise of deviations, otherwise those the headings do not name. Precondition: the
    /// column of angles is known.
    [[nodiscard]] std::vector<std::size_t> readingsByAngle() {
        for (const Meaning meaning : {Meaning::radius, Meaning::deviation}) {
            if (std::vector<std::size_t> found = pathsIn(m.body.numberColumns(meaning)); !found.empty())
                return withSenses(std::move(found));
        }
        return unnamed();
    }

    /// Adds columns that name nothing but their sense: "Deviation CCW (µm); CW (µm)".
    [[nodiscard]] std::vector<std::size_t> withSenses(std::vector<std::size_t> columns) const {
        const TableColumn &first = m.body.columns[columns.front()];
        const std::vector<std::size_t> others = m.body.columnsWhere([&](const TableColumn &column) {
            return column.isNumeric() && column.meaning == Meaning::unknown && column.unit == first.unit &&
                   senseIn(column.heading);
        });
        if (senseIn(first.heading))
            columns.insert(columns.end(), others.begin(), others.end());
        std::ranges::sort(columns);
        return columns;
    }

    /// The columns that are paths: among those that name a sense, one that names none, or both, is computed
    /// from them; so is a difference.
    [[nodiscard]] std::vector<std::size_t> pathsIn(std::vector<std::size_t> columns) const {
        const auto isSilent = [&](std::size_t c) { return !senseIn(m.body.columns[c].heading); };
        const auto isComputed = [&](std::size_t c) {
            const auto [clockwise, counterclockwise] = sensesIn(m.body.columns[c].heading);
            return (clockwise && counterclockwise) ||
                   folded(m.body.columns[c].heading).find("diff") != std::string::npos;
        };
        if (!std::ranges::all_of(columns, isSilent))
            std::erase_if(columns, isSilent);
        else if (m.body.numberColumns().size() > columns.size() + 2)
            std::erase_if(columns, isComputed);
        return columns;
    }

    /// Gives each path its own angles, where there are as many columns of them: "Angle CCW; Radius CCW; Angle
    /// CW; Radius CW".
    void takeOwnAngles(const std::vector<std::size_t> &angles) {
        if (angles.size() != m_found.seconds.size() || angles.size() < 2)
            return;
        const auto senseOf = [&](std::size_t c) { return senseOfColumn(m, c); };
        m_found.firsts = angles;
        for (std::size_t k = 0; k < angles.size(); ++k) {
            const auto ofSense = std::ranges::find(angles, senseOf(m_found.seconds[k]), senseOf);
            if (std::ranges::count(angles, senseOf(m_found.seconds[k]), senseOf) == 1)
                m_found.firsts[k] = *ofSense;
        }
        m_found.first = m_found.firsts.front();
    }

    /// "X CCW; Y CCW; X CW; Y CW": pairs that differ in sense or number.
    void takeFurtherCoordinates() {
        const auto alike = [&](std::size_t column) {
            const TableColumn &head = m.body.columns[column];
            return m.body.columnsWhere([&](const TableColumn &other) {
                return other.isNumeric() && other.meaning == head.meaning &&
                       other.words.axis == head.words.axis && other.words.stem == head.words.stem;
            });
        };
        const std::vector<std::size_t> firsts = alike(*m_found.first);
        const std::vector<std::size_t> seconds = alike(m_found.seconds.front());
        if (firsts.size() != seconds.size() || firsts.size() < 2)
            return;
        m_found.firsts = firsts;
        m_found.seconds = seconds;
    }

    /// Commanded positions of the axes that are read: called so, or beside those called actual.
    [[nodiscard]] std::optional<AxisColumns> commandedColumns() const {
        const bool isChosen = m.choices.isChosen("columns");
        const auto ofAxis = [&](std::size_t column) {
            const TableColumn &read = m.body.columns[column];
            std::vector<std::size_t> others = m.body.columnsWhere([&](const TableColumn &other) {
                return isPosition(other) && other.words.axis == read.words.axis &&
                       (other.meaning == Meaning::target ||
                        (read.meaning == Meaning::actual && other.meaning != Meaning::actual));
            });
            std::erase_if(others, [&](std::size_t c) {
                return isChosen && m.result.columns[c].role != ColumnRole::nominal;
            });
            return others;
        };
        const std::vector<std::size_t> x = ofAxis(*m_found.first);
        const std::vector<std::size_t> y = ofAxis(m_found.seconds.front());
        const bool isOther = x.size() == 1 && y.size() == 1 && x.front() != *m_found.first;
        return isOther ? std::optional(AxisColumns(x.front(), y.front())) : std::nullopt;
    }

    /// Sets the roles of columns by their headings; columns of different roles are never paths of one test.
    void takeRoles() {
        m.result.columns = m.columnsAs({});
        const auto has = [&](Meaning meaning) { return !m.body.numberColumns(meaning).empty(); };
        const std::vector<std::size_t> angle = angleColumns();
        const auto coordinates = axisColumns(m);
        m_named = coordinates || !angle.empty();
        const bool hasRadial = has(Meaning::radius) || has(Meaning::deviation);
        // Deviations at nominal points.
        const bool isPolar = coordinates && angle.empty() && has(Meaning::deviation) &&
                             m.body.columns[coordinates->first].words.isTarget;
        // "angle, x, y": points, and the angles at which they were taken.
        const bool isXy = coordinates && !isPolar && (angle.empty() || !hasRadial);
        const bool isAlone = angle.empty() && !coordinates && isNamedReading(firstUnnamed());
        if (m.body.numberColumns().size() == 1 || isAlone || m.choices.chosen("layout") == "deviations") {
            m_found.seconds = deviationsAlone();
        } else if (isXy) {
            m_found.first = coordinates->first;
            m_found.seconds = {coordinates->second};
            takeFurtherCoordinates();
        } else if (isPolar) {
            m_found.first = coordinates->first;
            m_found.third = coordinates->second;
            m_found.seconds = m.body.numberColumns(Meaning::deviation);
            setRole(*m_found.third, ColumnRole::y);
        } else {
            m_found.first = angle.empty() ? firstUnnamed() : angle.front();
            askForAngles();
            m_found.seconds = readingsByAngle();
            takeOwnAngles(angle);
        }
        const ColumnRole ofFirst = isXy || isPolar ? ColumnRole::x : ColumnRole::angle;
        if (m_found.first)
            setRole(*m_found.first, ofFirst);
        for (const std::size_t first : m_found.firsts)
            setRole(first, ofFirst);
        for (const std::size_t c : m_found.seconds)
            setRole(c, m_found.first && isXy                              ? ColumnRole::y
                       : m_found.first && meaningOf(c) == Meaning::radius ? ColumnRole::radius
                                                                          : ColumnRole::deviation);
        for (const std::size_t c : m.body.numberColumns(Meaning::nominal))
            setRole(c, ColumnRole::nominal);
        takeSenses();
        if (const auto runs = columnOfRuns())
            setRole(*runs, ColumnRole::number);
    }

    /// The first column that is no counter of points.
    [[nodiscard]] std::size_t firstUnnamed() const {
        std::vector<std::size_t> columns = m.body.columnsWhere(
            [](const TableColumn &column) { return column.isNumeric() && !column.isTime(); });
        if (columns.empty())
            columns = m.body.numberColumns();
        const bool counts = columns.size() > 1 && isCounter(m, columns.front()) &&
                            (columns.size() > 2 || meaningOf(columns.front()) == Meaning::index);
        return columns[counts ? 1 : 0];
    }

    /// "Run 1 CW", "Deviation": no angle.
    [[nodiscard]] bool isNamedReading(std::size_t c) const {
        return senseIn(m.body.columns[c].heading) ||
               (meaningOf(c) == Meaning::run && m.body.columns[c].words.number) ||
               isOneOf(meaningOf(c), {Meaning::deviation, Meaning::reading});
    }

    void askForAngles() {
        const TableColumn &column = m.body.columns[*m_found.first];
        if (!m_named && !column.heading.empty())
            m_question = {REPORT_TEXT("report",
                                      "Columns: the headings do not say which holds the angles; “%1” "
                                      "is read as such."),
                          {excerpt(column.heading)}};
    }

    /// Columns with undefined headings: those that name a sense, otherwise all of similar size.
    [[nodiscard]] std::vector<std::size_t> unnamed() {
        std::vector<std::size_t> columns;
        std::vector<std::size_t> sensed;
        for (const std::size_t c : m.body.numberColumns()) {
            if (c <= *m_found.first ||
                !isOneOf(meaningOf(c), {Meaning::unknown, Meaning::run, Meaning::reading, Meaning::actual}))
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
        const bool areRuns =
            std::ranges::all_of(columns, [&](std::size_t c) { return meaningOf(c) == Meaning::run; });
        if ((named && !areRuns) || columns.size() < all)
            m_question = {REPORT_TEXT("report", "Columns: the headings do not say which hold readings; "
                                                "column %1 and those like it are read."),
                          {counted(columns.front() + 1)}};
        return columns;
    }

    [[nodiscard]] bool areRadii(std::size_t column) const {
        const auto [low, high] = m.rangeOf(column);
        return low > 0 && high - low < 0.1 * high;
    }

    void takeChosen(const std::vector<ImportColumn> &chosen) {
        m_found = {};
        m_named = true;
        std::vector<std::size_t> firsts;
        for (std::size_t c = 0; c < chosen.size(); ++c) {
            const ColumnRole role = chosen[c].role;
            if (role == ColumnRole::angle || role == ColumnRole::x)
                firsts.push_back(c);
            if (role == ColumnRole::radius || role == ColumnRole::y || role == ColumnRole::deviation)
                m_found.seconds.push_back(c);
        }
        if (!firsts.empty())
            m_found.first = firsts.front();
        const auto roleOf = [&](std::size_t c) { return chosen[c].role; };
        const auto y = std::ranges::find(m_found.seconds, ColumnRole::y, roleOf);
        if (m_found.first && roleOf(*m_found.first) == ColumnRole::x && y != m_found.seconds.end() &&
            m_found.seconds.size() > 1) {
            m_found.third = *y;
            m_found.seconds.erase(y);
        }
        if (m_found.seconds.empty() ||
            std::ranges::any_of(
                m_found.seconds,
                [&](std::size_t c) { return roleOf(c) != roleOf(m_found.seconds.front()); }) ||
            (!m_found.first && roleOf(m_found.seconds.front()) != ColumnRole::deviation))
            refuseCircleColumns();
        m.result.columns = chosen;
        if (!m_found.third)
            takeOwnAngles(firsts);
        if (!columnOf(m.result.columns, ColumnRole::direction))
            takeSenses();
    }

    /// Reads a column of words that name the sense, otherwise of words below a heading that names it, even if
    /// its role is not among those chosen.
    void takeSenses() {
        auto senses = m.body.columnOf(ColumnKind::senses);
        if (!senses) {
            const std::vector<std::size_t> named = m.body.columnsWhere([](const TableColumn &column) {
                return column.kind == ColumnKind::words && column.meaning == Meaning::direction;
            });
            senses = named.empty() ? std::nullopt : std::optional(named.front());
        }
        if (senses && m.result.columns[*senses].role == ColumnRole::ignored)
            setRole(*senses, ColumnRole::direction);
    }

    /// The column of path numbers: each path has its own arc.
    [[nodiscard]] std::optional<std::size_t> columnOfRuns() const {
        const std::vector<std::size_t> found = m.body.numberColumns(Meaning::run);
        return found.size() == 1 && m_found.first != found.front() &&
                       std::ranges::find(m_found.seconds, found.front()) == m_found.seconds.end()
                   ? std::optional(found.front())
                   : std::nullopt;
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

    /// The layout that the headings name, otherwise a guess from the numbers.
    [[nodiscard]] Choice<std::string> recognisedLayout() const {
        const std::size_t second = m_found.seconds.front();
        if (!m_found.first)
            return {"deviations", Origin::recognised};
        if (m_found.third)
            return {"angleDeviation", Origin::recognised};
        if (m.result.columns[*m_found.first].role == ColumnRole::x)
            return {"xy", Origin::recognised};
        if (!m_named && areOnCircle(m, *m_found.first, second))
            return {"xy", Origin::guessed};
        if (m.choices.isChosen("columns") ||
            isOneOf(meaningOf(second), {Meaning::radius, Meaning::deviation}))
            return {m.result.columns[second].role == ColumnRole::radius ? "angleRadius" : "angleDeviation",
                    Origin::recognised};
        return {areRadii(second) ? "angleRadius" : "angleDeviation", Origin::guessed};
    }

    void resolveLayout() {
        const Choice<std::string> found = recognisedLayout();
        const auto choice = m.choices.resolve("layout", found.value, found.origin);
        const auto *const layout = std::ranges::find(circleLayouts, choice.value, &CircleLayout::word);
        if (layout == circleLayouts.end())
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 for a circular test"),
                          nameOfChoice("layout"), nameOfWord("layout", choice.value));
        if ((choice.value == "deviations") == m_found.first.has_value())
            refuseCircleColumns();
        if (choice.origin == Origin::guessed)
            m.remarks.assumption("layout", layout->content);
        // The layout determines the columns, even if it was chosen against their headings.
        if (m_found.third && choice.value == "xy")
            m_found.seconds = {*std::exchange(m_found.third, std::nullopt)};
        for (const std::size_t second : m_found.seconds) {
            if (m_found.first && !m_found.third)
                setRole(*m_found.firstOf(second), choice.value == "xy" ? ColumnRole::x : ColumnRole::angle);
            setRole(second, layout->second);
        }
        m_found.layout = choice.value;
        if (choice.value == "xy")
            m_found.commanded = commandedColumns();
        if (m_found.commanded) {
            setRole(m_found.commanded->first, ColumnRole::nominal);
            setRole(m_found.commanded->second, ColumnRole::nominal);
        }
    }

    TableReading &m;
    CircleColumns m_found;
    std::optional<Message> m_question;
    bool m_named = false;
};

} // namespace

void refuseCircleColumns() {
    refuseContent(REPORT_TEXT("report", "these columns do not make a circle; expected x and y, angle and "
                                        "radius, angle and deviation, or radial deviations alone"));
}

bool isLayoutOfCircles(std::string_view word) {
    return std::ranges::find(circleLayouts, word, &CircleLayout::word) != circleLayouts.end();
}

bool isPosition(const TableColumn &column) {
    constexpr std::string_view linearAxes = "XYZUVW";
    return column.isNumeric() && linearAxes.find(column.words.axis) != std::string_view::npos &&
           (column.meaning != Meaning::unknown ||
            (column.foreignUnit.empty() && (!column.unit || column.isIn(UnitKind::length)))) &&
           isOneOf(column.meaning, {Meaning::actual, Meaning::x, Meaning::y, Meaning::place, Meaning::reading,
                                    Meaning::unknown, Meaning::target});
}

std::optional<AxisColumns> axisColumns(const TableReading &reading) {
    const auto letter = [&](std::size_t c) { return reading.body.columns[c].words.axis; };
    std::vector<std::size_t> found;
    using Meanings = std::initializer_list<Meaning>;
    for (const Meanings &meanings : {Meanings{Meaning::actual}, Meanings{Meaning::x, Meaning::y},
                                     Meanings{Meaning::place, Meaning::reading}, Meanings{Meaning::unknown},
                                     Meanings{Meaning::target}}) {
        if (found.size() > 1)
            break;
        found.clear();
        for (const std::size_t c : reading.body.numberColumns()) {
            if (isOneOf(reading.body.columns[c].meaning, meanings) && isPosition(reading.body.columns[c]) &&
                std::ranges::find(found, letter(c), letter) == found.end())
                found.push_back(c);
        }
    }
    constexpr double still = 0.01; // of the longest way
    const auto wayOf = [&](std::size_t c) {
        const auto [low, high] = reading.rangeOf(c);
        return high - low;
    };
    if (found.size() > 2) {
        const double longest = wayOf(*std::ranges::max_element(found, {}, wayOf));
        std::erase_if(found, [&](std::size_t c) { return wayOf(c) < still * longest; });
    }
    if (found.size() < 2)
        return {};
    const std::string plane =
        upperCase(reading.choices.isChosen("plane") ? reading.choices.chosen("plane") : reading.notes.plane);
    if (plane.size() == 2) {
        const auto first = std::ranges::find(found, plane[0], letter);
        const auto second = std::ranges::find(found, plane[1], letter);
        if (first != found.end() && second != found.end() && first != second)
            return AxisColumns(*first, *second);
    }
    const bool isYx = letter(found[0]) == 'Y' && letter(found[1]) == 'X';
    return isYx ? AxisColumns(found[1], found[0]) : AxisColumns(found[0], found[1]);
}

std::optional<Sense> senseOfColumn(const TableReading &reading, std::size_t column) {
    if (const auto chosen = reading.result.columns[column].direction)
        return *chosen == Direction::positive ? Sense::counterclockwise : Sense::clockwise;
    return senseIn(reading.body.columns[column].heading);
}

CircleColumns circleColumns(TableReading &reading) {
    return CircleColumnSearch(reading).find();
}

} // namespace palmer
