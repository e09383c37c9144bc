#include "import/positioningcolumns.h"

#include "document/documenterror.h"
#include "document/place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace palmer {

namespace {

/// 1, 1, 2, 2 … in any order: numbers of runs. Readings are hardly ever small whole numbers that repeat.
bool areRunNumbers(const std::vector<double> &values) {
    std::size_t changes = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] < 0 || values[i] > 1e4 || values[i] != std::floor(values[i]))
            return false;
        changes += i > 0 && values[i] != values[i - 1] ? 1 : 0;
    }
    return !values.empty() && changes <= values.size();
}

/// +1 and −1, or two of 0, 1, 2: codes of directions.
bool areDirectionCodes(const std::vector<double> &values) {
    return !values.empty() && std::ranges::all_of(values, [](double value) {
        return value == -1 || value == 0 || value == 1 || value == 2;
    });
}

bool isStrictlyMonotone(const std::vector<double> &values) {
    return values.size() > 1 &&
           (std::ranges::adjacent_find(values, std::ranges::greater_equal()) == values.end() ||
            std::ranges::adjacent_find(values, std::ranges::less_equal()) == values.end());
}

class ColumnsReader {
public:
    explicit ColumnsReader(TableReading &reading)
        : m(reading)
        , m_heads(reading.body.columns) {}

    PositioningColumns read() {
        takeHeadings();
        findTarget();
        findValues();
        chooseAxis();
        keepOneRole();
        keepOneUnit();
        keepOneStem();
        keepDirected();
        takeHints();
        proveSign();
        settle();
        return std::move(m_result);
    }

private:
    [[nodiscard]] const HeadingWords &words(std::size_t c) const { return m_heads[c].words; }
    [[nodiscard]] bool isNumeric(std::size_t c) const { return m_heads[c].kind == ColumnKind::numbers; }
    [[nodiscard]] ColumnRole &role(std::size_t c) { return m_result.columns[c].role; }

    [[nodiscard]] std::vector<double> valuesOf(std::size_t column) const {
        std::vector<double> values;
        constexpr std::size_t enough = 5000;
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const TableCell *cell = m.cell(row, column);
                if (cell && cell->isNumber() && values.size() < enough)
                    values.push_back(cell->value);
            }
        }
        return values;
    }

    void ask(Message message) { m_question = m_question ? m_question : std::optional(std::move(message)); }

    // ---- what the headings say

    void takeHeadings() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const TableColumn &head = m_heads[c];
            m_result.columns.push_back({ColumnRole::ignored, {}, 0, head.unit, head.heading});
            if (head.kind == ColumnKind::directions && !m_result.direction) {
                role(c) = ColumnRole::direction;
                m_result.direction = c;
            } else if (isNumeric(c)) {
                role(c) = roleOf(c);
            }
        }
    }

    [[nodiscard]] ColumnRole roleOf(std::size_t c) const {
        const TableColumn &head = m_heads[c];
        if (head.unit && head.unit->kind == UnitKind::temperature)
            return ColumnRole::temperature;
        if (head.unit && head.unit->kind == UnitKind::time)
            return ColumnRole::time;
        switch (head.meaning) {
        case Meaning::statistic:
            return ColumnRole::statistic;
        case Meaning::temperature:
            return ColumnRole::temperature;
        case Meaning::time:
            return ColumnRole::time;
        case Meaning::radius:
            return head.words.words > 1 ? ColumnRole::radius : ColumnRole::statistic; // R: repeatability
        case Meaning::nominal:
            return ColumnRole::nominal;
        case Meaning::deviation:
            return ColumnRole::deviation;
        case Meaning::actual:
            return ColumnRole::actual;
        case Meaning::reading:
            return ColumnRole::run;
        case Meaning::run:
            return roleOfRun(c);
        case Meaning::direction:
            return head.words.direction || head.words.number ? ColumnRole::run : ColumnRole::direction;
        case Meaning::place:
            return head.words.direction ? ColumnRole::run : ColumnRole::ignored;
        case Meaning::unknown:
        case Meaning::index:
        case Meaning::axis:
        case Meaning::x:
        case Meaning::y:
            return isRunHeading(head.words) ? ColumnRole::run : ColumnRole::ignored;
        case Meaning::target:
        case Meaning::angle:
        case Meaning::other:
        case Meaning::process:
            break;
        }
        return ColumnRole::ignored;
    }

    /// "↑ 3", "2", "X+": a direction or a number and no word that is not understood.
    [[nodiscard]] static bool isRunHeading(const HeadingWords &heading) {
        const bool known = heading.unknownWords == 0 || (heading.hint && heading.unknownWords <= 1);
        return known && (heading.direction || heading.number);
    }

    [[nodiscard]] ColumnRole roleOfRun(std::size_t c) const {
        const HeadingWords &heading = words(c);
        if (!heading.number && !heading.direction && !m_heads[c].unit && areRunNumbers(valuesOf(c)))
            return ColumnRole::number;
        return ColumnRole::run;
    }

    // ---- targets

    /// A list without headings: the reading is the last number of a line, the target that with the largest
    /// range, a column that stays the same from line to line the number of the run.
    void placeBareList() {
        std::vector<std::size_t> columns = m.body.numberColumns();
        const bool isBare =
            std::ranges::all_of(m_heads, [](const TableColumn &head) { return head.heading.empty(); });
        if (!isBare || !m_result.direction || columns.size() < 3)
            return;
        role(columns.back()) = ColumnRole::run;
        columns.pop_back();
        const auto rangeOf = [&](std::size_t c) {
            const std::vector<double> values = valuesOf(c);
            if (values.empty())
                return -1.0;
            const auto [low, high] = std::ranges::minmax(values);
            return high - low;
        };
        std::size_t target = columns.front();
        for (const std::size_t c : columns)
            target = rangeOf(c) >= rangeOf(target) ? c : target;
        m_targets = {target};
        for (const std::size_t c : columns) {
            const std::vector<double> values = valuesOf(c);
            std::size_t same = 0;
            for (std::size_t i = 1; i < values.size(); ++i)
                same += values[i] == values[i - 1] ? 1 : 0;
            if (c != target && 2 * same > values.size() && !isCounter(m, c))
                role(c) = ColumnRole::number;
        }
    }

    void findTarget() {
        placeBareList();
        if (m_targets.empty())
            findTargetByHeading();
        if (m_targets.empty())
            return;
        m_result.target = m_targets.front();
        role(m_targets.front()) = ColumnRole::target;
        findPositions();
    }

    void findTargetByHeading() {
        const std::array<std::function<bool(std::size_t)>, 6> sorts{
            [&](std::size_t c) { return m_heads[c].meaning == Meaning::target; },
            [&](std::size_t c) {
                return m_heads[c].meaning == Meaning::place && !words(c).direction && !words(c).number;
            },
            [&](std::size_t c) {
                return m_heads[c].meaning == Meaning::angle || m_heads[c].meaning == Meaning::place;
            },
            [&](std::size_t c) { return isCalledByAxis(c); },
            [&](std::size_t c) { return m_heads[c].meaning == Meaning::index && !isCounter(m, c); },
            [&](std::size_t c) { return isUnnamed(c); }};
        for (const auto &sort : sorts) {
            for (std::size_t c = 0; c < m_heads.size(); ++c) {
                if (isNumeric(c) && role(c) != ColumnRole::number && !hasOtherAxis(c) && sort(c))
                    m_targets.push_back(c);
            }
            if (!m_targets.empty())
                break;
        }
        dropCounter();
    }

    void findPositions() {
        // "Position" beside "Target": where it follows the target, the actual position.
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (c != m_targets.front() && isNumeric(c) && role(c) == ColumnRole::ignored &&
                m_heads[c].meaning == Meaning::place)
                role(c) = followsTarget(c)  ? ColumnRole::actual
                          : words(c).number ? ColumnRole::run
                                            : ColumnRole::ignored;
        }
    }

    /// The axis that the user chose wants its own targets.
    [[nodiscard]] bool hasOtherAxis(std::size_t c) const {
        const std::string_view chosen = m.choices.chosen("axis");
        return chosen.size() == 1 && words(c).axis != 0 && words(c).axis != chosen[0] && isTwoAxes();
    }
    [[nodiscard]] bool isTwoAxes() const {
        char first = 0;
        for (const TableColumn &head : m_heads) {
            if (head.kind != ColumnKind::numbers || head.words.axis == 0 ||
                head.meaning == Meaning::statistic)
                continue;
            if (first != 0 && head.words.axis != first)
                return true;
            first = head.words.axis;
        }
        return false;
    }

    [[nodiscard]] bool isCalledByAxis(std::size_t c) const {
        const HeadingWords &heading = words(c);
        return heading.axis != 0 && heading.words == 1 && m_heads[c].meaning != Meaning::statistic;
    }

    [[nodiscard]] bool isUnnamed(std::size_t c) const {
        return m_heads[c].meaning == Meaning::unknown && !words(c).direction && !words(c).number;
    }

    /// A first column that counts, and an axis beside it.
    void dropCounter() {
        if (m_targets.size() < 2 || m_heads[m_targets.front()].meaning == Meaning::target ||
            !isCounter(m, m_targets.front()))
            return;
        const bool named = !m_heads[m_targets.front()].heading.empty();
        if (m_targets.size() > 2 ? isAxisLike(m_targets[1], m_targets[2]) : named)
            m_targets.erase(m_targets.begin());
    }

    /// Whether a column rises or falls strictly and by more than the values beside it.
    [[nodiscard]] bool isAxisLike(std::size_t column, std::size_t beside) const {
        const std::vector<double> values = valuesOf(column);
        const std::vector<double> others = valuesOf(beside);
        if (!isStrictlyMonotone(values) || others.empty())
            return false;
        const auto [low, high] = std::ranges::minmax(others);
        const double length = std::abs(values.back() - values.front());
        return length > 2 * std::max(std::abs(low), std::abs(high)) ||
               (high - low > 0 && std::abs(values.back() - others.back()) < 0.1 * length);
    }

    [[nodiscard]] bool followsTarget(std::size_t column) const {
        const std::vector<double> targets = valuesOf(*m_result.target);
        const std::vector<double> values = valuesOf(column);
        if (targets.size() != values.size() || targets.size() < 2)
            return false;
        const auto [low, high] = std::ranges::minmax(targets);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::abs(values[i] - targets[i]) > 0.1 * (high - low))
                return false;
        }
        return high > low;
    }

    // ---- readings

    void findValues() {
        findCodes();
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (role(c) == ColumnRole::number && !m_result.number)
                m_result.number = c;
            if (m_result.columns[c].hasReadings())
                m_result.values.push_back(c);
        }
        if (m_result.values.empty())
            takeUnnamed();
        else
            askForUntitled();
    }

    /// A column headed "direction" that holds numbers.
    void findCodes() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (role(c) != ColumnRole::direction || !isNumeric(c))
                continue;
            const bool codes = !m_result.direction && areDirectionCodes(valuesOf(c));
            role(c) = codes ? ColumnRole::direction : ColumnRole::ignored;
            if (codes)
                m_result.direction = c;
        }
    }

    /// No heading says what is read: what is left are the runs.
    void takeUnnamed() {
        bool named = false;
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const Meaning meaning = m_heads[c].meaning;
            const bool unknown = meaning == Meaning::unknown || meaning == Meaning::x ||
                                 meaning == Meaning::y || meaning == Meaning::axis;
            if (!isNumeric(c) || role(c) != ColumnRole::ignored || !unknown || isDroppedCounter(c))
                continue;
            role(c) = ColumnRole::run;
            m_result.values.push_back(c);
            named |= !m_heads[c].heading.empty() && words(c).axis == 0;
        }
        // A number of the run and nothing else that could be read: the readings themselves.
        if (m_result.values.empty() && m_result.number) {
            m_result.values.push_back(*m_result.number);
            role(*m_result.number) = ColumnRole::run;
            m_result.number.reset();
        }
        if (!m_result.values.empty() && named)
            ask({REPORT_TEXT("report", "Columns: the headings do not say which hold readings; “%1” and those "
                                       "like it are read as runs."),
                 {excerpt(m_heads[m_result.values.front()].heading)}});
        if (m_heads.size() > 2 && !named)
            separatePositions();
    }

    [[nodiscard]] bool isDroppedCounter(std::size_t c) const {
        return m_result.target && c < *m_result.target && isCounter(m, c);
    }

    /// Without headings: columns that follow the targets are positions, and no runs of the others.
    void separatePositions() {
        if (!m_result.target)
            return;
        std::vector<std::size_t> positions;
        std::ranges::copy_if(m_result.values, std::back_inserter(positions),
                             [&](std::size_t c) { return followsTarget(c); });
        if (positions.empty() || positions.size() == m_result.values.size())
            return;
        for (const std::size_t c : m_result.values)
            role(c) = ColumnRole::deviation;
        for (const std::size_t c : positions)
            role(c) = ColumnRole::actual;
        ask({REPORT_TEXT("report",
                         "Columns: some hold positions and some deviations; the deviations are read.")});
    }

    /// A column of numbers without a heading among others that have one.
    void askForUntitled() {
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            if (isNumeric(c) && role(c) == ColumnRole::ignored && m_heads[c].heading.empty() &&
                !isCounter(m, c))
                ask({REPORT_TEXT("report", "Columns: column %1 has numbers and no heading; it is not read."),
                     {Number{static_cast<double>(c + 1), Quantity::count}}});
        }
    }

    void setAside(const std::function<bool(std::size_t)> &keeps) {
        std::erase_if(m_result.values, [&](std::size_t c) {
            const bool goes = !keeps(c);
            if (goes)
                role(c) = ColumnRole::ignored;
            return goes;
        });
    }

    void chooseAxis() {
        if (m.choices.isChosen("columns"))
            return;
        std::vector<std::string> axes;
        for (const std::size_t c : m_result.values) {
            const std::string axis(1, words(c).axis);
            if (words(c).axis != 0 && m_heads[c].meaning != Meaning::statistic && !isLetterHint(c) &&
                std::ranges::find(axes, axis) == axes.end())
                axes.push_back(axis);
        }
        if (axes.size() < 2)
            return;
        const std::string chosen(m.choices.chosen("axis"));
        const std::string axis = std::ranges::find(axes, chosen) != axes.end() ? chosen : axes.front();
        m.axisFound = axis;
        m.result.remarks.push_back(askForAxis(axes, axis));
        setAside([&](std::size_t c) { return words(c).axis == axis[0]; });
        for (const std::size_t c : m_targets) {
            if (words(c).axis == axis[0]) {
                role(*m_result.target) = ColumnRole::ignored;
                m_result.target = c;
                role(c) = ColumnRole::target;
            }
        }
    }

    /// "1A" beside "1R": no axis A.
    [[nodiscard]] bool isLetterHint(std::size_t c) const {
        return words(c).hint && (words(c).axis == 'A' || words(c).axis == 'B');
    }

    void keepOneRole() {
        std::array<std::size_t, 3> counts{};
        const auto sortOf = [&](std::size_t c) {
            return role(c) == ColumnRole::deviation ? 0U : role(c) == ColumnRole::actual ? 1U : 2U;
        };
        for (const std::size_t c : m_result.values)
            ++counts[sortOf(c)];
        const auto roles = std::ranges::count_if(counts, [](std::size_t count) { return count > 0; });
        std::size_t kept = 0;
        if (counts[0] == 0)
            kept = counts[1] >= counts[2] ? 1 : 2;
        else if (counts[2] > counts[0])
            kept = 2;
        if (roles < 2) {
            m_kept = kept;
            return;
        }
        // Deviations and the positions they come from say the same; the deviations are read.
        if (kept != 0 || counts[2] > 0)
            ask({REPORT_TEXT("report", "Columns: the headings name readings of different kinds; those like "
                                       "“%1” are read, the others are not."),
                 {excerpt(m_heads[*std::ranges::find_if(m_result.values, [&](std::size_t c) {
                              return sortOf(c) == kept;
                          })].heading)}});
        if (kept == 0) {
            std::ranges::copy_if(m_result.values, std::back_inserter(m_positions),
                                 [&](std::size_t c) { return role(c) == ColumnRole::actual; });
        }
        // Positions that belong to the deviations keep their role: they prove the sign.
        std::erase_if(m_result.values, [&](std::size_t c) {
            const bool goes = sortOf(c) != kept;
            if (goes && !(kept == 0 && role(c) == ColumnRole::actual))
                role(c) = ColumnRole::ignored;
            return goes;
        });
        m_kept = kept;
    }

    void keepOneUnit() {
        std::map<const Unit *, std::size_t> counts;
        for (const std::size_t c : m_result.values) {
            if (m_heads[c].unit)
                ++counts[m_heads[c].unit];
        }
        if (counts.empty())
            return;
        for (const std::size_t c : m_result.values) {
            if (m_heads[c].unit && (!m_result.unit || counts[m_heads[c].unit] > counts[m_result.unit]))
                m_result.unit = m_heads[c].unit;
        }
        if (counts.size() < 2)
            return;
        ask({REPORT_TEXT("report", "Columns: the readings have different units; those in %1 are read."),
             {std::string(m_result.unit->sign)}});
        setAside([&](std::size_t c) { return m_heads[c].unit == m_result.unit; });
    }

    /// Runs of one kind have the same words; a word that is not understood is a kind of its own.
    void keepOneStem() {
        const auto stemOf = [&](std::size_t c) {
            const std::size_t letters = words(c).hint ? 1 : 0; // "1A" beside "1R"
            return words(c).unknownWords > letters ? words(c).stem : std::string();
        };
        std::map<std::string, std::size_t> counts;
        for (const std::size_t c : m_result.values)
            ++counts[stemOf(c)];
        if (counts.size() < 2)
            return;
        std::string kept;
        if (!counts.contains(kept)) {
            for (const std::size_t c : m_result.values) {
                if (kept.empty() || counts[stemOf(c)] > counts[kept])
                    kept = stemOf(c);
            }
            ask({REPORT_TEXT("report", "Columns: the headings name readings of different kinds; those like "
                                       "“%1” are read, the others are not."),
                 {excerpt(kept)}});
        }
        setAside([&](std::size_t c) { return stemOf(c) == kept; });
    }

    /// Among columns with a direction one without is no run, unless a column of directions says it.
    void keepDirected() {
        const auto isDirected = [&](std::size_t c) { return words(c).direction || words(c).hint; };
        const auto directed = std::ranges::count_if(m_result.values, isDirected);
        if (directed > 0 && static_cast<std::size_t>(directed) < m_result.values.size()) {
            for (const std::size_t c : m_result.values) {
                if (!isDirected(c))
                    ask({REPORT_TEXT("report",
                                     "Columns: “%1” names no direction as the others do; it is not read."),
                         {excerpt(m_heads[c].heading)}});
            }
            setAside(isDirected);
        }
        // A number beside columns that number their runs: "Run 1", "Run 2", "Deviation".
        const auto isNumbered = [&](std::size_t c) { return words(c).number.has_value(); };
        const auto numbered = std::ranges::count_if(m_result.values, isNumbered);
        if (directed == 0 && numbered > 1 && static_cast<std::size_t>(numbered) < m_result.values.size()) {
            ask({REPORT_TEXT("report",
                             "Columns: some readings name no run as the others do; they are not read.")});
            setAside(isNumbered);
        }
    }

    void takeHints() {
        bool up = false;
        bool down = false;
        for (const std::size_t c : m_result.values) {
            const auto direction = words(c).direction ? words(c).direction : words(c).hint;
            up |= direction == Direction::positive;
            down |= direction == Direction::negative;
        }
        const bool paired = up && down;
        bool allSigns = true;
        for (const std::size_t c : m_result.values) {
            ImportColumn &column = m_result.columns[c];
            column.number = words(c).number.value_or(0);
            column.direction = words(c).direction;
            if (!column.direction && paired && words(c).hint) {
                column.direction = words(c).hint;
                m_result.hasHints = true;
            }
            // "Dev + 1" beside "Dev - 1": signs, and no dash between words.
            allSigns = allSigns && folded(m_heads[c].heading).find_first_of("+-") != std::string::npos;
        }
        m_result.hasHints = m_result.hasHints && !allSigns;
    }

    /// Deviation = actual − target, or the opposite: where both stand there, the numbers say which.
    void proveSign() {
        if (m_positions.empty() || m_positions.size() != m_result.values.size() || !m_result.target)
            return;
        double same = 0;
        double opposite = 0;
        double size = 0;
        for (std::size_t k = 0; k < m_positions.size(); ++k) {
            const Unit *unit = m_heads[m_result.values[k]].unit;
            const Unit *base = m_heads[m_positions[k]].unit;
            if (!unit || !base)
                return;
            for (const TableBlock &block : m.body.blocks) {
                for (const std::uint32_t row : block.rows) {
                    const TableCell *t = m.cell(row, *m_result.target);
                    const TableCell *a = m.cell(row, m_positions[k]);
                    const TableCell *d = m.cell(row, m_result.values[k]);
                    if (!t || !a || !d || !t->isNumber() || !a->isNumber() || !d->isNumber())
                        continue;
                    const double difference = base->toBase(a->value) - base->toBase(t->value);
                    same = std::max(same, std::abs(unit->toBase(d->value) - difference));
                    opposite = std::max(opposite, std::abs(unit->toBase(d->value) + difference));
                    size = std::max(size, std::abs(difference));
                }
            }
        }
        constexpr double part = 0.05; // of the largest difference: decimals of the positions
        if (same < part * size)
            m_result.sign = "actualMinusTarget";
        else if (opposite < part * size)
            m_result.sign = "targetMinusActual";
        else
            ask({REPORT_TEXT(
                "report", "Columns: the deviations are not the differences of actual and target positions; "
                          "the deviations are read.")});
    }

    // ---- the result

    void settle() {
        m_result.content = m_kept == 0 ? "deviations" : m_kept == 1 ? "positions" : "";
        const std::string found = wordOf(m_result.columns);
        const auto choice =
            m.choices.settle("columns", found, m_question ? Origin::guessed : Origin::recognised);
        if (choice.origin == Origin::chosen)
            takeChosen(choice.value);
        else if (m_question)
            m.remark(RemarkGrade::assumption, *m_question, 0, "columns");
        m.result.columns =
            m_result.columns; // to be shown, and changed there, where that is all that is known
        if (!m_result.target || m_result.values.empty())
            throw Error(
                Error::Kind::content,
                {REPORT_TEXT("report", "the columns of the targets and of the readings are not known; "
                                       "name them with the choice “columns”")});
        remarkIgnored();
    }

    void takeChosen(const std::string &text) {
        std::string unknown;
        std::vector<ImportColumn> chosen = columnsOf(text, unknown).value_or(std::vector<ImportColumn>());
        if (chosen.size() > m_heads.size())
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "%1 names %2 columns, the table has %3"),
                         {"columns", Number{static_cast<double>(chosen.size()), Quantity::count},
                          Number{static_cast<double>(m_heads.size()), Quantity::count}}});
        chosen.resize(m_heads.size());
        m_result = {};
        const bool hasDeviations =
            std::ranges::find(chosen, ColumnRole::deviation, &ImportColumn::role) != chosen.end();
        ColumnRole content = ColumnRole::run;
        for (std::size_t c = 0; c < chosen.size(); ++c) {
            chosen[c].heading = m_heads[c].heading;
            chosen[c].unit = m_heads[c].unit;
            const auto take = [&](ColumnRole wanted, std::optional<std::size_t> &place) {
                if (chosen[c].role == wanted && !place)
                    place = c;
            };
            take(ColumnRole::target, m_result.target);
            take(ColumnRole::direction, m_result.direction);
            take(ColumnRole::number, m_result.number);
            const bool isProof = hasDeviations && chosen[c].role == ColumnRole::actual;
            if (!chosen[c].hasReadings() || isProof)
                continue;
            if (!m_result.values.empty() && chosen[c].role != content)
                throw Error(Error::Kind::content,
                            {REPORT_TEXT("report", "columns of different roles cannot be read as runs of one "
                                                   "test; ignore one of them")});
            content = chosen[c].role;
            m_result.values.push_back(c);
            if (!m_result.unit)
                m_result.unit = m_heads[c].unit;
        }
        m_result.content = content == ColumnRole::deviation ? "deviations"
                           : content == ColumnRole::actual  ? "positions"
                                                            : "";
        m_result.columns = std::move(chosen);
    }

    void remarkIgnored() {
        std::string names;
        for (std::size_t c = 0; c < m_heads.size(); ++c) {
            const ColumnRole what = m_result.columns[c].role;
            const bool isRead = what == ColumnRole::target || what == ColumnRole::direction ||
                                what == ColumnRole::number ||
                                std::ranges::find(m_result.values, c) != m_result.values.end();
            const bool isCounted = m_heads[c].meaning == Meaning::index;
            if (!isRead && !isCounted && m_heads[c].kind != ColumnKind::empty && !m_heads[c].heading.empty())
                names += (names.empty() ? "" : ", ") + std::string(m_heads[c].heading);
        }
        if (!names.empty())
            m.remark(RemarkGrade::note,
                     {REPORT_TEXT("report", "Columns that are not read: %1."), {excerpt(names)}});
    }

    TableReading &m;
    const std::vector<TableColumn> &m_heads;
    PositioningColumns m_result;
    std::vector<std::size_t> m_targets;
    std::vector<std::size_t> m_positions; ///< actual positions beside the deviations
    std::size_t m_kept = 0;
    std::optional<Message> m_question;
};

} // namespace

PositioningColumns positioningColumns(TableReading &reading) {
    return ColumnsReader(reading).read();
}

Remark askForAxis(const std::vector<std::string> &axes, const std::string &axis) {
    std::string names;
    for (const std::string &each : axes)
        names += (names.empty() ? "" : ", ") + each;
    Remark remark{
        RemarkGrade::assumption,
        {REPORT_TEXT("report", "Axis: the table has several (%1); %2 is read, the others are a test of "
                               "their own."),
         {names, axis}},
        0,
        0,
        "axis"};
    remark.answers = axes;
    return remark;
}

} // namespace palmer
