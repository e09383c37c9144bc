#include "import/passes.h"
#include "import/tablereading.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "kernel/evaluation/edition.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace palmer {

namespace {

constexpr std::string_view defaultEdition = "ISO 230-2:2014";

/// What is found in the rows and columns, before units and signs.
struct Found {
    std::vector<Pass> passes;
    std::string content;
    const Unit *unit = nullptr;
    const Unit *positionUnit = nullptr;
};

/// A pass with the places its readings stand at, for the colours.
struct PlacedPass {
    std::optional<Direction> direction;
    Pass pass;
    std::vector<std::pair<std::uint32_t, std::size_t>> places;
};

bool isStrictlyMonotone(std::span<const double> values) {
    if (values.size() < 2)
        return true;
    const bool up = values[1] > values[0];
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (up ? values[i] <= values[i - 1] : values[i] >= values[i - 1])
            return false;
    }
    return true;
}

/// 1, 2, 3 … or 1, 1, 2, 2 …: numbers of runs, no positions.
bool areRunNumbers(std::span<const double> values) {
    double last = 0;
    for (const double value : values) {
        if (value != last && value != last + 1)
            return false;
        last = value;
    }
    return !values.empty() && values.front() == 1 && last >= 1;
}

/// Sum of the squares of the readings about the mean of their position and direction: small where the
/// directions are right.
double scatter(std::span<const PlacedPass> passes, const std::function<Direction(std::size_t)> &direction) {
    double sum = 0;
    for (const Direction wanted : {Direction::positive, Direction::negative}) {
        std::map<double, std::array<double, 3>> moments; // n, Σ, Σ²
        for (std::size_t j = 0; j < passes.size(); ++j) {
            if (direction(j) != wanted)
                continue;
            for (const PassReading &reading : passes[j].pass.readings) {
                if (reading.value) {
                    auto &moment = moments[reading.position];
                    moment[0] += 1;
                    moment[1] += *reading.value;
                    moment[2] += *reading.value * *reading.value;
                }
            }
        }
        for (const auto &[position, moment] : moments)
            sum += moment[2] - moment[1] * moment[1] / moment[0];
    }
    return sum;
}

class PositioningReader {
public:
    explicit PositioningReader(TableReading &reading)
        : m(reading) {}

    void read() {
        const std::string layout = settleLayout();
        if (layout == "list")
            readList();
        else if (layout == "runsDown")
            readRunsDown();
        else
            readTargetsDown();
        if (m_placed.empty())
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "there are no readings in it; expected target "
                                               "positions and deviations")});
        settleDirections();
        colour();
        std::vector<Pass> passes;
        bool ordered = true;
        bool both = false;
        for (std::size_t j = 0; j < m_placed.size(); ++j) {
            PlacedPass &placed = m_placed[j];
            placed.pass.direction = *placed.direction;
            if (j > 0) {
                const bool same = passes.back().direction == placed.pass.direction;
                ordered &= !same;
                both |= !same;
            }
            passes.push_back(std::move(placed.pass));
        }
        if (both && !ordered)
            passes = inCycles(std::move(passes));
        const PassForm form = settleForm(passes, m_found.content, m_found.unit ? m_found.unit : m.notes.unit,
                                         m_found.positionUnit, m.choices, m.result.remarks);
        Test test;
        PositioningMeasurement measurement = measurementOf(passes, form, m.result.remarks);
        measurement.axis.name = m.choices.settle("axis", axisName(), Origin::recognised).value;
        test.edition = m.choices.settle("edition", defaultEdition, Origin::recognised).value;
        const Edition *edition = findEdition(test.edition);
        if (!edition || edition->kind != Kind::positioning) {
            m.choices.settle("edition", defaultEdition, Origin::recognised);
            test.edition = defaultEdition;
        }
        test.measurement = std::move(measurement);
        m.result.test = std::move(test);
    }

private:
    [[nodiscard]] std::string axisName() const {
        if (!m.notes.axis.empty())
            return m.notes.axis;
        // "X (mm)": the targets are called by the axis.
        for (const TableColumn &column : m.body.columns) {
            const std::string bare = withoutUnit(column.heading);
            if (bare.size() == 1 && std::string_view("XYZABCUVW").find(bare[0]) != std::string_view::npos)
                return bare;
        }
        return {};
    }

    [[nodiscard]] std::vector<double> headNumbers(std::uint32_t row) const {
        std::vector<double> numbers;
        for (const TableCell &cell : m.table().cells(m.row(row))) {
            if (cell.isNumber())
                numbers.push_back(cell.value);
        }
        return numbers;
    }

    /// The values of a column over the rows of all blocks; shorter where a cell is no number.
    [[nodiscard]] std::vector<double> columnValues(std::size_t column) const {
        std::vector<double> values;
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const TableCell *cell = m.cell(row, column);
                if (cell && cell->isNumber())
                    values.push_back(cell->value);
            }
        }
        return values;
    }

    std::string settleLayout() {
        const TableBody &body = m.body;
        const bool directions = body.columnOf(ColumnKind::directions).has_value();
        const auto head = body.blocks.front().numericHead;
        std::string found = "targetsDown";
        Origin origin = Origin::recognised;
        const bool namedList = (body.columnOf(Meaning::deviation) || body.columnOf(Meaning::actual)) &&
                               body.columnOf(Meaning::run) && body.columnOf(Meaning::target) &&
                               body.numberColumns().size() <= 5;
        if (head) {
            const std::vector<double> numbers = headNumbers(*head);
            const bool runsFollow = !areRunNumbers(numbers) && isStrictlyMonotone(numbers);
            found = runsFollow ? "runsDown" : "targetsDown";
        } else if (directions || namedList) {
            found = "list";
        } else if (body.blocks.size() == 1 && body.columnHeads.empty() &&
                   body.blocks.front().rows.size() > 1) {
            const auto &rows = body.blocks.front().rows;
            const std::vector<double> first = headNumbers(rows.front());
            const std::vector<double> column = columnValues(body.numberColumns().front());
            if (first.size() > 2 && isStrictlyMonotone(first) && !isStrictlyMonotone(column)) {
                found = "runsDown";
                origin = Origin::guessed;
            }
        }
        const auto choice = m.choices.settle("layout", found, origin);
        if (choice.origin == Origin::guessed)
            m.remark(
                RemarkGrade::assumption,
                {REPORT_TEXT("report",
                             "Layout: the first line is read as the targets, each further one as a run.")},
                0, "layout");
        return choice.value;
    }

    // ---- targets down, runs across

    void readTargetsDown() {
        const TableBody &body = m.body;
        std::vector<std::size_t> columns = body.numberColumns();
        const auto erase = [&](std::size_t column) { std::erase(columns, column); };
        for (const std::size_t column : body.numberColumns()) {
            const Meaning meaning = body.columns[column].meaning;
            if (meaning == Meaning::statistic || meaning == Meaning::time ||
                meaning == Meaning::temperature) {
                erase(column);
                m.remark(RemarkGrade::note,
                         {REPORT_TEXT("report", "The column “%1” is not read: it holds no readings."),
                          {body.columns[column].heading}});
            }
        }
        if (columns.empty())
            return;
        std::size_t target = columns.front();
        const bool named = body.columns[target].meaning == Meaning::index;
        if (columns.size() > 2 && (named || body.columns[target].meaning != Meaning::target) &&
            isCounter(m, target) && (named || isAxisLike(columns[1], columns[2]))) {
            erase(target);
            target = columns.front();
        } else if (const auto stated = body.columnOf(Meaning::target);
                   stated && *stated != target && std::ranges::find(columns, *stated) != columns.end() &&
                   isCounter(m, target)) {
            erase(target);
            target = *stated;
        }
        erase(target);
        m_found.positionUnit = body.columns[target].unit;
        if (columns.empty())
            throw Error(
                Error::Kind::content,
                {REPORT_TEXT("report",
                             "there is one column of numbers only; expected target positions and readings")});
        for (const std::size_t column : columns)
            takeHeading(column);
        bool shortSigns = lettersMeanDirections(columns);
        // A pass is a piece of a block in which the targets only rise or only fall.
        struct Piece {
            std::vector<std::uint32_t> rows;
            std::optional<Direction> direction;
        };
        std::vector<Piece> pieces;
        bool shuffled = false;
        for (const TableBlock &block : body.blocks) {
            auto cut = piecesOf(block, target, shuffled);
            const std::optional<Direction> titled = directionInHeading(m.titleOf(block), false);
            const bool turns = cut.size() > 1;
            for (auto &rows : cut) {
                std::optional<Direction> direction = titled;
                const TableCell *first = m.cell(rows.front(), target);
                const TableCell *last = m.cell(rows.back(), target);
                const bool falls = rows.size() > 1 && last->value < first->value;
                if (turns)
                    direction = falls ? Direction::negative : Direction::positive;
                else if (!direction && falls && body.blocks.size() > 1 && !shuffled)
                    direction = Direction::negative;
                pieces.push_back({std::move(rows), direction});
            }
        }
        if (pieces.size() > 1 &&
            std::ranges::any_of(pieces, [](const Piece &p) { return p.direction.has_value(); })) {
            for (Piece &piece : pieces)
                piece.direction = piece.direction.value_or(Direction::positive);
        }
        if (shuffled)
            m.remark(RemarkGrade::note,
                     {REPORT_TEXT("report", "The targets stand in no order; they were sorted.")});
        const bool piecesOnly = pieces.size() > 1;
        for (const std::size_t column : columns) {
            const auto stated = directionInHeading(body.columns[column].heading, shortSigns);
            for (const Piece &piece : pieces) {
                PlacedPass placed;
                placed.direction = stated ? stated : piece.direction;
                for (const std::uint32_t row : piece.rows)
                    addReading(placed, row, target, column);
                // A column that is not continued in a second block is no run there.
                if (!piecesOnly || hasValue(placed))
                    m_placed.push_back(std::move(placed));
            }
        }
        m_shortSigns = shortSigns;
        m_blockwise = piecesOnly;
    }

    /// Whether a column rises or falls strictly and by more than the values beside it.
    [[nodiscard]] bool isAxisLike(std::size_t column, std::size_t beside) const {
        const std::vector<double> values = columnValues(column);
        const std::vector<double> others = columnValues(beside);
        if (!isStrictlyMonotone(values) || values.size() < 2 || others.empty())
            return false;
        const auto [low, high] = std::ranges::minmax(others);
        return std::abs(values.back() - values.front()) > 2 * std::max(std::abs(low), std::abs(high)) ||
               (high - low > 0 &&
                std::abs(values.back() - others.back()) < 0.1 * std::abs(values.back() - values.front()));
    }

    std::vector<std::vector<std::uint32_t>> piecesOf(const TableBlock &block, std::size_t target,
                                                     bool &shuffled) {
        std::vector<std::vector<std::uint32_t>> pieces;
        std::vector<std::uint32_t> rows;
        std::vector<double> positions;
        for (const std::uint32_t row : block.rows) {
            const TableCell *cell = m.cell(row, target);
            if (!cell || !cell->isNumber()) {
                m.remark(RemarkGrade::problem,
                         {REPORT_TEXT("report", "“%1” is no target position; the line was not read."),
                          {excerpt(m.cellText(row, target))}},
                         m.row(row).line);
                continue;
            }
            rows.push_back(row);
            positions.push_back(cell->value);
        }
        if (rows.empty())
            return pieces;
        std::vector<double> sorted = positions;
        std::ranges::sort(sorted);
        const bool distinct = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
        if (distinct) {
            shuffled |= !isStrictlyMonotone(positions);
            pieces.push_back(std::move(rows));
            return pieces;
        }
        int direction = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double step = i > 0 ? positions[i] - positions[i - 1] : 0;
            const int now = step > 0 ? 1 : step < 0 ? -1 : 0;
            if (i == 0 || now == 0 || (direction != 0 && now != direction)) {
                pieces.emplace_back();
                direction = 0;
            } else {
                direction = now;
            }
            pieces.back().push_back(rows[i]);
        }
        return pieces;
    }

    // ---- runs down, targets across

    void readRunsDown() {
        const TableBody &body = m.body;
        const auto directionColumn = body.columnOf(ColumnKind::directions);
        std::optional<std::uint32_t> head = body.blocks.front().numericHead;
        for (const TableBlock &block : body.blocks) {
            std::size_t first = 0;
            if (block.numericHead) {
                head = block.numericHead;
            } else if (!head) {
                head = block.rows.front();
                first = 1;
            }
            std::vector<std::pair<std::size_t, double>> targets;
            const auto cells = m.table().cells(m.row(*head));
            for (std::size_t c = 0; c < cells.size(); ++c) {
                if (cells[c].isNumber())
                    targets.emplace_back(c, cells[c].value);
                m.setRole(*head, c, cells[c].isNumber() ? CellRole::position : CellRole::head);
            }
            if (!m_found.positionUnit)
                m_found.positionUnit = unitIn(joined(*head));
            const std::optional<Direction> titled = directionInHeading(m.titleOf(block), false);
            for (std::size_t i = first; i < block.rows.size(); ++i) {
                const std::uint32_t row = block.rows[i];
                PlacedPass placed;
                placed.direction = titled;
                if (directionColumn)
                    placed.direction = directionOf(m.cellText(row, *directionColumn));
                else if (const auto labelled =
                             labelDirection(row, targets.empty() ? 0 : targets.front().first))
                    placed.direction = labelled;
                for (const auto &[column, position] : targets) {
                    placed.pass.readings.push_back({position, m.number(row, column), m.row(row).line});
                    placed.places.emplace_back(row, column);
                }
                m_placed.push_back(std::move(placed));
            }
        }
        m_acrossRows = true;
    }

    [[nodiscard]] std::string joined(std::uint32_t row) const {
        std::string text;
        for (const TableCell &cell : m.table().cells(m.row(row))) {
            if (cell.kind == CellKind::text && text.size() < 200)
                text += ' ' + std::string(m.table().text(cell));
        }
        return text;
    }

    [[nodiscard]] std::optional<Direction> labelDirection(std::uint32_t row, std::size_t before) const {
        std::optional<Direction> found;
        for (std::size_t c = 0; c < before && !found; ++c) {
            const TableCell *cell = m.cell(row, c);
            if (cell && cell->kind != CellKind::number)
                found = directionInHeading(m.table().text(*cell), true);
        }
        return found;
    }

    // ---- one reading a line

    void readList() {
        const TableBody &body = m.body;
        const auto directionColumn = body.columnOf(ColumnKind::directions);
        std::optional<std::size_t> value = body.columnOf(Meaning::deviation);
        if (!value)
            value = body.columnOf(Meaning::actual);
        std::optional<std::size_t> target = body.columnOf(Meaning::target);
        std::optional<std::size_t> run = body.columnOf(Meaning::run);
        if (target == value)
            target.reset();
        if (!value || !target)
            placeUnnamed(value, target, run);
        if (!value || !target)
            throw Error(
                Error::Kind::content,
                {REPORT_TEXT("report",
                             "there is one column of numbers only; expected target positions and readings")});
        takeHeading(*value);
        m_found.positionUnit = body.columns[*target].unit;
        std::map<std::pair<double, int>, std::size_t> passes;
        std::map<std::pair<double, int>, std::size_t> times; // (target, direction) seen
        std::size_t number = 0;
        for (const TableBlock &block : body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const auto position = m.number(row, *target);
                if (!position)
                    continue;
                std::optional<Direction> direction;
                if (directionColumn)
                    direction = directionOf(m.cellText(row, *directionColumn));
                const int side = direction ? static_cast<int>(*direction) : 2;
                double runNumber = 0;
                if (run)
                    runNumber = m.number(row, *run).value_or(0);
                else
                    runNumber = static_cast<double>(++times[{*position, side}]);
                const auto [pass, isNew] = passes.try_emplace({runNumber, side}, number);
                if (isNew) {
                    ++number;
                    m_placed.push_back({direction, {}, {}});
                }
                addReading(m_placed[pass->second], row, *target, *value);
                if (directionColumn && direction)
                    m.setRole(row, *directionColumn,
                              *direction == Direction::positive ? CellRole::positive : CellRole::negative);
            }
        }
        if (!directionColumn)
            directionsFromOrder();
    }

    /// Which numbers of a list without headings are what: the reading is the last, the target that with the
    /// largest range, a column that stays the same from line to line the run.
    void placeUnnamed(std::optional<std::size_t> &value, std::optional<std::size_t> &target,
                      std::optional<std::size_t> &run) const {
        std::vector<std::size_t> columns = m.body.numberColumns();
        if (columns.size() < 2)
            return;
        if (!value)
            value = columns.back();
        std::erase(columns, *value);
        if (run)
            std::erase(columns, *run);
        if (!target) {
            double widest = -1;
            for (const std::size_t column : columns) {
                const std::vector<double> values = columnValues(column);
                if (values.empty())
                    continue;
                const auto [low, high] = std::ranges::minmax(values);
                if (high - low >= widest) {
                    widest = high - low;
                    target = column;
                }
            }
        }
        if (!target || run)
            return;
        std::erase(columns, *target);
        for (const std::size_t column : columns) {
            const std::vector<double> values = columnValues(column);
            std::size_t same = 0;
            for (std::size_t i = 1; i < values.size(); ++i)
                same += values[i] == values[i - 1] ? 1 : 0;
            if (2 * same > values.size() && !isCounter(m, column))
                run = column;
        }
    }

    /// A run with rising targets is ↑, with falling ones ↓; if all rise, they are taken as ↑ and ↓ in turn.
    void directionsFromOrder() {
        bool falls = false;
        for (PlacedPass &placed : m_placed) {
            const auto &readings = placed.pass.readings;
            const bool down = readings.size() > 1 && readings.back().position < readings.front().position;
            placed.direction = down ? Direction::negative : Direction::positive;
            falls |= down;
        }
        if (!falls) {
            for (PlacedPass &placed : m_placed)
                placed.direction.reset();
        }
    }

    // ---- common

    void takeHeading(std::size_t column) {
        const TableColumn &heading = m.body.columns[column];
        if (heading.unit && !m_found.unit)
            m_found.unit = heading.unit;
        if (m_found.content.empty())
            m_found.content = heading.meaning == Meaning::deviation ? "deviations"
                              : heading.meaning == Meaning::actual  ? "positions"
                                                                    : "";
    }

    [[nodiscard]] bool lettersMeanDirections(std::span<const std::size_t> columns) const {
        bool positive = false;
        bool negative = false;
        for (const std::size_t column : columns) {
            const std::string &heading = m.body.columns[column].heading;
            if (directionInHeading(heading, false))
                return false;
            const auto direction = directionInHeading(heading, true);
            positive |= direction == Direction::positive;
            negative |= direction == Direction::negative;
        }
        return positive && negative;
    }

    void addReading(PlacedPass &placed, std::uint32_t row, std::size_t target, std::size_t column) {
        const TableCell *position = m.cell(row, target);
        placed.pass.readings.push_back({position->value, m.number(row, column), m.row(row).line});
        placed.places.emplace_back(row, column);
        m.setRole(row, target, CellRole::position);
    }

    [[nodiscard]] static bool hasValue(const PlacedPass &placed) {
        return std::ranges::any_of(placed.pass.readings,
                                   [](const PassReading &r) { return r.value.has_value(); });
    }

    void settleDirections() {
        const std::size_t n = m_placed.size();
        const bool stated =
            std::ranges::all_of(m_placed, [](const PlacedPass &p) { return p.direction.has_value(); });
        std::string found = "stated";
        Origin origin = Origin::recognised;
        if (!stated) {
            origin = Origin::guessed;
            if (n % 2 == 1) {
                found = "positive";
            } else {
                const auto alternating = [](std::size_t j) {
                    return j % 2 == 0 ? Direction::positive : Direction::negative;
                };
                const auto halves = [n](std::size_t j) {
                    return 2 * j < n ? Direction::positive : Direction::negative;
                };
                found = n > 2 && scatter(m_placed, halves) < 0.5 * scatter(m_placed, alternating)
                            ? "sideBySide"
                            : "alternating";
            }
        } else if (m_shortSigns) {
            origin = Origin::guessed;
        }
        const auto choice = m.choices.settle("directions", found, origin);
        if (choice.value == "stated" && !stated)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT("report", "the file does not say which runs are ↑ and which ↓; choose "
                                               "another word for “directions”")});
        if (choice.value != "stated") {
            for (std::size_t j = 0; j < n; ++j)
                m_placed[j].direction = directionUnder(choice.value, j, n);
        }
        if (choice.origin != Origin::guessed)
            return;
        Text text = REPORT_TEXT("report",
                                "Directions: the letters in the headings are read as ↑ (A, F) and ↓ (R, B).");
        if (choice.value == "alternating")
            text =
                m_acrossRows
                    ? REPORT_TEXT(
                          "report",
                          "Directions: nothing in the file says them; the lines are read as ↑ and ↓ in turn.")
                : m_blockwise
                    ? REPORT_TEXT("report", "Directions: nothing in the file says them; the blocks are read "
                                            "as ↑ and ↓ in turn.")
                    : REPORT_TEXT(
                          "report",
                          "Directions: nothing in the file says them; the runs are read as ↑ and ↓ in turn.");
        else if (choice.value == "sideBySide")
            text = REPORT_TEXT("report", "Directions: nothing in the file says them; the first half of the "
                                         "runs is read as ↑, the second as ↓.");
        else if (choice.value == "positive")
            text =
                REPORT_TEXT("report", "Directions: nothing in the file says them; all runs are read as ↑.");
        m.remark(RemarkGrade::assumption, {text}, 0, "directions");
    }

    [[nodiscard]] static Direction directionUnder(std::string_view word, std::size_t j, std::size_t n) {
        if (word == "positive")
            return Direction::positive;
        if (word == "negative")
            return Direction::negative;
        const bool first = word == "sideBySide" ? 2 * j < n : j % 2 == 0;
        return first ? Direction::positive : Direction::negative;
    }

    void colour() {
        for (const PlacedPass &placed : m_placed) {
            for (const auto &[row, column] : placed.places)
                m.setRole(row, column,
                          *placed.direction == Direction::positive ? CellRole::positive : CellRole::negative);
        }
    }

    TableReading &m;
    Found m_found;
    std::vector<PlacedPass> m_placed;
    bool m_shortSigns = false;
    bool m_blockwise = false;
    bool m_acrossRows = false;
};

} // namespace

void readPositioning(TableReading &reading) {
    PositioningReader(reading).read();
}

} // namespace palmer
