// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/directioncodes.h"
#include "import/layouts/placedpass.h"
#include "import/layouts/positioningcolumns.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "kernel/words/shortest.h"
#include "tables/dates.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

// Above 500 lines: one reader, whose steps share what is known of the blocks.

namespace palmer {

namespace {

/// Rows with monotonic targets: one pass of every column.
struct Piece {
    std::size_t section = 0;
    std::vector<std::uint32_t> rows;
    std::optional<Direction> direction;
    std::optional<Direction> hint; ///< from a title that contains other words
    const TableBlock *block = nullptr;
};

class TargetsDownReader {
public:
    explicit TargetsDownReader(TableReading &reading)
        : m(reading)
        , m_columns(positioningColumns(reading))
        , m_target(*m_columns.target) {}

    FoundPasses read() {
        static_cast<FoundForm &>(m_found) = static_cast<const FoundForm &>(m_columns);
        m_found.positionUnit = m.body.columns[m_target].said();
        chooseAxis();
        chooseState();
        if (m_columns.direction || m_columns.number)
            readLines();
        else
            readPieces();
        m.result.columns = std::move(m_columns.columns);
        return std::move(m_found);
    }

private:
    [[nodiscard]] ImportColumn columnIn(std::size_t section, std::size_t column) const {
        ImportColumn result = m_columns.columns[column];
        // Blocks with their own headings: the second has those of the other direction.
        if (m.body.sections.size() > 1 && !m.choices.isChosen("columns")) {
            const HeadingWords &words = m.body.sections[section][column].words;
            result.direction = words.direction ? words.direction : result.direction;
            result.number = words.number.value_or(result.number);
        }
        return result;
    }

    /// The target of a row that has one.
    [[nodiscard]] double targetAt(std::uint32_t row) const { return m.cell(row, m_target)->value; }

    /// The target of a row; a row without one is remarked as unread data.
    std::optional<double> targetOf(std::uint32_t row) { return targetOf(row, m_target); }
    std::optional<double> targetOf(std::uint32_t row, std::size_t column) {
        if (const auto target = m.numberAt(row, column))
            return target;
        m.remarkNoTarget(row, m.cellText(row, column));
        return {};
    }

    void add(PlacedPass &placed, std::uint32_t row, double target, std::size_t column) {
        std::size_t targets = m_target;
        if (!m_columns.ownTargets.empty()) { // rare, but checked for each reading
            if (const auto own = m_columns.ownTargets.find(column); own != m_columns.ownTargets.end()) {
                const auto ofColumn = targetOf(row, own->second);
                if (!ofColumn)
                    return;
                target = *ofColumn;
                targets = own->second;
            }
        }
        placed.add(m, row, target, column);
        m.setRole(row, targets, CellRole::position);
    }

    // ---- several axes: a column that names them, or titles of blocks

    void chooseAxis() {
        const auto named = m.body.columnsWhere([](const TableColumn &column) {
            return column.kind == ColumnKind::words && column.meaning == Meaning::axis;
        });
        if (!named.empty())
            m_axisColumn = named.back();
        std::vector<std::string> axes;
        const auto collect = [&](const std::string &axis) {
            if (!axis.empty() && axes.size() < 20 && std::ranges::find(axes, axis) == axes.end())
                axes.push_back(axis);
        };
        for (const TableBlock &block : m.body.blocks) {
            if (!m_axisColumn) {
                collect(axisOfBlock(block));
                continue;
            }
            for (const std::uint32_t row : block.rows)
                collect(std::string(m.cellText(row, *m_axisColumn)));
        }
        if (!axes.empty() && m.axisFound.empty() && (m_axisColumn || axes.size() > 1))
            m.axisFound = axes.front();
        if (axes.size() < 2) {
            m_axisColumn.reset();
            return;
        }
        m_axis = resolveAxis(m, axes);
    }

    [[nodiscard]] std::string axisOfBlock(const TableBlock &block) const {
        for (const std::uint32_t head : m.titlesOf(block)) {
            const HeadingWords heading = readHeading(m.textOf(head));
            const bool says = heading.meaning == Meaning::axis || heading.words == 1;
            std::string name(1, heading.axis); // braces would make it two characters
            if (says && heading.axis != 0)
                return name;
        }
        return {};
    }

    /// "As found" and "As left" above blocks: two tests.
    void chooseState() {
        bool found = false;
        bool left = false;
        for (const TableBlock &block : m.body.blocks) {
            found |= m.stateOf(block) == TestRole::asFound;
            left |= m.stateOf(block) == TestRole::asLeft;
        }
        m_hasStates = found && left && m.stateFound == TestRole::notStated;
        if (m_hasStates)
            m.stateFound = resolveState(m);
        else if (found || left)
            takeState();
    }

    /// Takes the state of a title that says nothing else.
    void takeState() {
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t head : m.titlesOf(block)) {
                const HeadingWords title = readTitle(m.textOf(head));
                if (m.stateFound == TestRole::notStated && title.isTitle() &&
                    title.state != TestRole::notStated)
                    m.stateFound = statedState(m, title.state, m.textOf(head));
            }
        }
    }

    [[nodiscard]] bool isOfOtherTest(const TableBlock &block) {
        if (m_hasStates) {
            if (const TestRole state = m.stateOf(block); state != TestRole::notStated)
                m_blockState = state; // applies until another is named
            if (m_blockState != m.stateFound)
                return true;
        }
        return isOfOtherAxis(block);
    }

    [[nodiscard]] bool isOfOtherAxis(const TableBlock &block) {
        if (m_axis.empty() || m_axisColumn)
            return false;
        if (const std::string axis = axisOfBlock(block); !axis.empty())
            m_blockAxis = axis; // applies until another is named
        return m_blockAxis != m_axis;
    }
    /// True for a line of another axis, machine, day …
    [[nodiscard]] bool isOfOtherTest(std::uint32_t row) const {
        return (m_axisColumn && m.cellText(row, *m_axisColumn) != m_axis) ||
               (!m_columns.isOfOtherTest.empty() && m_columns.isOfOtherTest[row]);
    }

    // ---- a column with the direction or run number of each line

    void readLines() {
        for (const TableBlock &block : m.body.blocks) {
            if (isOfOtherTest(block))
                continue;
            m_titled = directionOfBlock(m, block).stated;
            for (const std::uint32_t row : block.rows) {
                if (!isOfOtherTest(row))
                    readLine(block.section, row);
            }
        }
        remarkCodes();
        if (const auto line = m_repeated ? m_repeated : fragment())
            askForRepeated(*line);
        const bool stated = std::ranges::all_of(
            m_found.passes, [](const PlacedPass &placed) { return placed.direction.has_value(); });
        if (!stated)
            directionsFromOrder();
    }

    /// The line where a pass begins that has less than half the readings of another.
    [[nodiscard]] std::optional<std::size_t> fragment() const {
        const auto sizeOf = [](const PlacedPass &placed) { return placed.pass.readings.size(); };
        std::size_t most = 0;
        for (const PlacedPass &placed : m_found.passes)
            most = std::max(most, sizeOf(placed));
        const auto found = std::ranges::find_if(m_found.passes, [&](const PlacedPass &placed) {
            return sizeOf(placed) > 0 && 2 * sizeOf(placed) < most;
        });
        return found == m_found.passes.end() ? std::nullopt
                                             : std::optional(found->pass.readings.front().line);
    }

    void readLine(std::size_t section, std::uint32_t row) {
        const auto target = targetOf(row);
        if (!target)
            return;
        const std::optional<Direction> stated = directionOfRow(row);
        unsigned number = 0;
        if (m_columns.number) {
            const auto value = m.number(row, *m_columns.number);
            number = value && *value >= 0 && *value < 1e6 ? static_cast<unsigned>(*value) : 0;
        }
        for (const std::size_t column : m_columns.values) {
            const ImportColumn what = columnIn(section, column);
            const auto direction = what.direction ? what.direction : stated ? stated : m_titled;
            const int side = direction ? static_cast<int>(*direction) : 2;
            // A repeated target within a run starts the next pass.
            const std::size_t time = m_times[{column, number, side, *target}]++;
            if (time > 0 && number > 0 && direction && !m_repeated)
                m_repeated = m.row(row).line;
            const auto [place, isNew] =
                m_passes.try_emplace({column, number, side, time}, m_found.passes.size());
            if (isNew)
                m_found.passes.push_back({direction, what.number > 0 ? what.number : number, {}, {}});
            add(m_found.passes[place->second], row, *target, column);
        }
        if (stated)
            m.setRole(row, *m_columns.direction,
                      *stated == Direction::positive ? CellRole::positive : CellRole::negative);
    }

    [[nodiscard]] std::optional<Direction> directionOfRow(std::uint32_t row) {
        if (!m_columns.direction)
            return {};
        const auto code = codeOf(row);
        if (!code)
            return directionOrSense(m.cellText(row, *m_columns.direction));
        if (m_codes.directions.empty())
            m_codes = codesOfDirection();
        const auto known = m_codes.directions.find(*code);
        return known == m_codes.directions.end() ? std::nullopt : std::optional(known->second);
    }

    /// The number that a line has for its direction; words that name none are numbered.
    [[nodiscard]] std::optional<double> codeOf(std::uint32_t row) const {
        const auto code = m.numberAt(row, *m_columns.direction);
        const auto &words = m.body.directionWords;
        const auto word = words.find(m.cellText(row, *m_columns.direction));
        return code || word == words.end() || word->second
                   ? code
                   : std::optional(static_cast<double>(std::distance(words.begin(), word)));
    }

    [[nodiscard]] std::optional<Direction> directionOrSense(std::string_view text) {
        const auto direction = m.body.directionIn(text);
        m_found.hasHints |= !m.body.directionWords.empty();
        const auto sense = direction ? std::nullopt : senseIn(text);
        if (!sense)
            return direction;
        m_found.hasSenses = true;
        m_found.hasHints = true;
        return *sense == Sense::clockwise ? Direction::positive : Direction::negative;
    }

    [[nodiscard]] DirectionCodes codesOfDirection() const {
        std::vector<CodedTarget> lines;
        for (const TableBlock &block : m.body.blocks) {
            for (const std::uint32_t row : block.rows) {
                const auto code = codeOf(row);
                const auto target = m.numberAt(row, m_target);
                const auto run = m_columns.number ? m.numberAt(row, *m_columns.number) : std::nullopt;
                if (code && target && !isOfOtherTest(row))
                    lines.push_back({*code, run.value_or(0), *target});
            }
        }
        return directionCodes(lines);
    }

    [[nodiscard]] std::string nameOfCode(double code) const {
        const auto &words = m.body.directionWords;
        const auto place = static_cast<std::size_t>(std::max(code, 0.0));
        return place >= words.size()
                   ? shortest(code)
                   : excerpt(std::next(words.begin(), static_cast<std::ptrdiff_t>(place))->first);
    }

    /// Says what the codes of directions are taken for, or asks.
    void remarkCodes() {
        if (m_codes.directions.empty() || m_codes.origin == DirectionCodes::Origin::stated)
            return;
        m_found.hasHints |= m_codes.origin != DirectionCodes::Origin::ordered;
        std::string up;
        std::string down;
        for (const auto &[code, direction] : m_codes.directions) {
            std::string &list = direction == Direction::positive ? up : down;
            list += (list.empty() ? "" : ", ") + nameOfCode(code);
        }
        if (m_codes.origin == DirectionCodes::Origin::ordered)
            m.remarks.note("directions",
                           REPORT_TEXT("report", "Directions: %1 in their column is ↑, %2 is ↓, by the order "
                                                 "of the targets."),
                           up, down);
        else if (m_codes.origin == DirectionCodes::Origin::unclear || !m.body.directionWords.empty())
            m_found.unclearCodes = {up, down.empty() ? "–" : down};
    }

    /// A run with ascending targets is ↑, with descending ones ↓; unknown if all ascend.
    void directionsFromOrder() {
        const auto falls = [](const PlacedPass &placed) {
            const auto &readings = placed.pass.readings;
            return readings.size() > 1 && readings.back().position < readings.front().position;
        };
        const bool isOfBoth = std::ranges::any_of(m_found.passes, falls);
        for (PlacedPass &placed : m_found.passes) {
            placed.direction = falls(placed) ? Direction::negative : Direction::positive;
            if (!isOfBoth)
                placed.direction.reset();
        }
    }

    // ---- targets down, runs across

    void readPieces() {
        bool shuffled = false;
        for (const TableBlock &block : m.body.blocks) {
            if (!isOfOtherTest(block))
                cut(block, shuffled);
        }
        if (!shuffled)
            joinPieces();
        completeDirections(shuffled);
        if (m_pieces.size() > 1) {
            askForOtherTargets();
            askForRepeatedTargets();
            askForUnnamedBlocks();
        }
        if (shuffled)
            m.remarks.note({}, REPORT_TEXT("report", "The targets stand in no order; they were sorted."));
        m_found.isBlockwise = m_pieces.size() > 1;
        for (const std::size_t column : m_columns.values) {
            for (const Piece &piece : m_pieces) {
                const ImportColumn what = columnIn(piece.section, column);
                PlacedPass placed{what.direction ? what.direction : piece.direction, what.number, {}, {}};
                placed.pass.readings.reserve(piece.rows.size());
                placed.cells.reserve(piece.rows.size());
                for (const std::uint32_t row : piece.rows)
                    add(placed, row, targetAt(row), column);
                // A column not continued in a second block has no run there.
                const bool hasValue = !std::ranges::all_of(placed.pass.readings, &PassReading::isMissing);
                if (m_pieces.size() == 1 || hasValue)
                    m_found.passes.push_back(std::move(placed));
            }
        }
    }

    /// True for the next page of a list or lines after a comment: targets continue, no title changes
    /// direction.
    [[nodiscard]] bool continues(const Piece &piece, const Piece &next) const {
        const bool isTitled = next.hint && next.hint != piece.hint;
        const bool isOther = piece.direction && next.direction && piece.direction != next.direction;
        if (isOther || isTitled || !haveSameRuns(piece, next))
            return false;
        // Each piece is ordered; the step between them must have the same sign.
        const double step = targetAt(next.rows.front()) - targetAt(piece.rows.back());
        const auto goesOn = [&](const Piece &each) {
            const double way = targetAt(each.rows.back()) - targetAt(each.rows.front());
            return way == 0 || (way > 0) == (step > 0);
        };
        return step != 0 && goesOn(piece) && goesOn(next);
    }

    [[nodiscard]] bool haveSameRuns(const Piece &piece, const Piece &next) const {
        return std::ranges::all_of(m_columns.values, [&](std::size_t column) {
            const ImportColumn a = columnIn(piece.section, column);
            const ImportColumn b = columnIn(next.section, column);
            return a.direction == b.direction && a.number == b.number;
        });
    }

    void joinPieces() {
        std::vector<Piece> joined;
        for (Piece &piece : m_pieces) {
            if (joined.empty() || !continues(joined.back(), piece)) {
                joined.push_back(std::move(piece));
                continue;
            }
            Piece &whole = joined.back();
            whole.rows.insert(whole.rows.end(), piece.rows.begin(), piece.rows.end());
            whole.direction = whole.direction ? whole.direction : piece.direction;
        }
        m_pieces = std::move(joined);
    }

    /// Asks if blocks at other targets than the first are separate runs or its continuation.
    void askForOtherTargets() {
        const auto targetsOf = [&](const Piece &piece) {
            std::vector<double> targets;
            for (const std::uint32_t row : piece.rows)
                targets.push_back(targetAt(row));
            std::ranges::sort(targets);
            return targets;
        };
        const std::vector<double> first = targetsOf(m_pieces.front());
        const auto isOther = [&](const Piece &piece) {
            std::vector<double> common;
            const std::vector<double> targets = targetsOf(piece);
            std::ranges::set_intersection(first, targets, std::back_inserter(common));
            return 2 * common.size() < std::max(first.size(), targets.size());
        };
        const auto other = std::ranges::find_if(m_pieces, isOther);
        if (other != m_pieces.end())
            m.remarks.problem({"layout", m.row(other->rows.front()).line},
                              REPORT_TEXT("report",
                                          "Layout: the targets of the block that begins here are others than "
                                          "those of the first block; it is read as runs of its own."));
    }

    void askForRepeated(std::size_t line) {
        m.remarks.problem({"layout", line},
                          REPORT_TEXT("report", "Layout: targets stand twice in a "
                                                "run; the readings there are read as runs of their own."));
    }

    /// 0, 100, 100, 200: a repeated reading, not a new run.
    void askForRepeatedTargets() {
        const auto rises = [&](const Piece &piece) {
            return targetAt(piece.rows.back()) > targetAt(piece.rows.front());
        };
        for (std::size_t i = 1; i < m_pieces.size(); ++i) {
            const Piece &piece = m_pieces[i - 1];
            const Piece &next = m_pieces[i];
            const bool isEither = piece.rows.size() > 1 || next.rows.size() > 1;
            const bool areBoth = piece.rows.size() > 1 && next.rows.size() > 1;
            if (piece.block == next.block && isEither && (!areBoth || rises(piece) == rises(next)) &&
                targetAt(piece.rows.back()) == targetAt(next.rows.front()))
                return askForRepeated(m.row(next.rows.front()).line);
        }
    }

    /// The title directly above a block that is not a column heading.
    [[nodiscard]] std::string titleOf(const TableBlock &block) const {
        const std::vector<std::uint32_t> titles = m.titlesOf(block);
        return titles.empty() ? std::string() : m.textOf(titles.front());
    }

    /// The day named by a title; empty if there is none.
    [[nodiscard]] static std::string dayIn(const std::string &title) {
        if (auto day = isoDate(title))
            return *day;
        std::string_view rest = title;
        while (!rest.empty()) {
            const std::string_view word = rest.substr(0, rest.find_first_of(" ,;()"));
            if (isDate(word))
                return std::string(word);
            rest.remove_prefix(std::min(word.size() + 1, rest.size()));
        }
        return {};
    }

    /// "Run 2", "Forward 2" above a block. "Test 2" may be a test of its own, and so may a block of another
    /// day, or one that counts its own runs.
    [[nodiscard]] bool isTitledAsRun(const Piece &piece) const {
        const std::string text = titleOf(*piece.block);
        const HeadingWords title = readHeading(text);
        if (title.isDirectionOnly() || (title.hint && !isName(title)) ||
            directionOfBlock(m, *piece.block).stated || (m_found.hasHints && piece.hint))
            return true;
        std::set<unsigned> numbers;
        for (const std::size_t column : m_columns.values)
            numbers.insert(columnIn(piece.section, column).number);
        return title.meaning == Meaning::run && title.number && !title.isTest && title.unknownWords == 0 &&
               dayIn(text).empty() && numbers.size() < 2;
    }

    /// "Machine: B", "F1000": the letter is no direction, as in "1A" and "R 2".
    [[nodiscard]] static bool isName(const HeadingWords &title) {
        constexpr unsigned mostRuns = 99;
        const auto isLetter = [](char c) { return c != ' '; };
        const bool hasWord = std::ranges::adjacent_find(title.stem, [&](char a, char b) {
                                 return isLetter(a) && isLetter(b);
                             }) != title.stem.end();
        return !title.isHintWord && (title.number > mostRuns || hasWord);
    }

    /// "After compensation" or "Machine 2" above a block, or run numbers of the former block: perhaps another
    /// test.
    void askForUnnamedBlocks() {
        std::set<std::tuple<std::size_t, Direction, unsigned>> known;
        const std::string day = dayIn(titleOf(*m_pieces.front().block));
        for (std::size_t i = 0; i < m_pieces.size(); ++i) {
            const Piece &piece = m_pieces[i];
            const std::string title = titleOf(*piece.block);
            const bool isRun = isTitledAsRun(piece);
            const bool begins = i > 0 && piece.block != m_pieces[i - 1].block;
            bool isOther = begins && !isRun && (readHeading(title).unknownWords > 0 || dayIn(title) != day);
            for (const std::size_t column : m_columns.values) {
                const ImportColumn what = columnIn(piece.section, column);
                if (what.number > 0 && what.direction && !isRun)
                    isOther |= !known.insert({column, *what.direction, what.number}).second && begins;
            }
            if (isOther) {
                m.remarks.problem({"layout", m.row(piece.rows.front()).line},
                                  REPORT_TEXT("report",
                                              "Layout: the block that begins here does not say which runs it "
                                              "holds; it is read as further runs of the same test."));
                return;
            }
        }
    }

    void cut(const TableBlock &block, bool &shuffled) {
        auto pieces = piecesOf(block, shuffled);
        const BlockDirection titled = directionOfBlock(m, block);
        const auto falls = [&](const std::vector<std::uint32_t> &rows) {
            return rows.size() > 1 && targetAt(rows.back()) < targetAt(rows.front());
        };
        const bool turns = pieces.size() > 1 && std::ranges::any_of(pieces, falls);
        for (auto &rows : pieces) {
            std::optional<Direction> direction = titled.stated;
            const bool down = falls(rows);
            if (turns)
                direction = down ? Direction::negative : Direction::positive;
            else if (!direction && !titled.hint && down && m.body.blocks.size() > 1 && !shuffled)
                direction = Direction::negative;
            m_pieces.push_back({block.section, std::move(rows), direction, titled.hint, &block});
        }
    }

    [[nodiscard]] bool anyPiece(std::optional<Direction> Piece::*says, Direction wanted) const {
        return std::ranges::any_of(m_pieces, [&](const Piece &piece) { return piece.*says == wanted; });
    }

    /// Directions among other words of titles are used if two titles have opposite ones. If some pieces have
    /// a direction, the others get the opposite: blocks come in pairs, otherwise it is asked.
    void completeDirections(bool shuffled) {
        bool up = anyPiece(&Piece::direction, Direction::positive);
        bool down = anyPiece(&Piece::direction, Direction::negative);
        if (!up && !down && anyPiece(&Piece::hint, Direction::positive) &&
            anyPiece(&Piece::hint, Direction::negative)) {
            for (Piece &piece : m_pieces)
                piece.direction = piece.hint;
            m_found.hasHints = true;
            up = down = true;
        }
        if (m_pieces.size() < 2 || !(up || down))
            return;
        const bool completed =
            std::ranges::any_of(m_pieces, [](const Piece &piece) { return !piece.direction; });
        for (Piece &piece : m_pieces) {
            if (piece.direction)
                continue;
            const bool rises = !shuffled && piece.rows.size() > 1;
            const Direction other = down && !up ? Direction::positive : Direction::negative;
            m_found.hasHints |= piece.hint || !(rises && down && !up);
            piece.direction = piece.hint.value_or(other);
        }
        const auto upward = std::ranges::count(m_pieces, Direction::positive,
                                               [](const Piece &piece) { return *piece.direction; });
        m_found.hasHints |= completed && 2 * static_cast<std::size_t>(upward) != m_pieces.size();
    }

    /// The only one without which all others are in order; none among few.
    [[nodiscard]] static std::optional<std::size_t> strayOf(const std::vector<double> &positions) {
        constexpr std::size_t fewest = 5;
        constexpr std::size_t most = 1000; // lines: this compares each with all
        for (std::size_t i = 0;
             i < positions.size() && positions.size() >= fewest && positions.size() <= most; ++i) {
            std::vector<double> others = positions;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            if (isStrictlyMonotone(others))
                return i;
        }
        return {};
    }

    std::vector<std::vector<std::uint32_t>> piecesOf(const TableBlock &block, bool &shuffled) {
        std::vector<std::vector<std::uint32_t>> pieces;
        std::vector<std::uint32_t> rows;
        std::vector<double> positions;
        for (const std::uint32_t row : block.rows) {
            if (isOfOtherTest(row))
                continue;
            if (const auto target = targetOf(row)) {
                rows.push_back(row);
                positions.push_back(*target);
            }
        }
        if (rows.empty())
            return pieces;
        const bool isOrdered = isStrictlyMonotone(positions);
        std::vector<double> sorted = positions;
        if (!isOrdered)
            std::ranges::sort(sorted);
        if (isOrdered || std::ranges::adjacent_find(sorted) == sorted.end()) {
            shuffled |= !isOrdered;
            if (const auto stray = isOrdered ? std::nullopt : strayOf(positions))
                m.remarks.problem({"columns", m.row(rows[*stray]).line},
                                  REPORT_TEXT("report", "The target %1 is out of the order of all others; "
                                                        "look whether a cell of its line is missing."),
                                  excerpt(m.cellText(rows[*stray], m_target)));
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

    TableReading &m;
    PositioningColumns m_columns;
    std::size_t m_target;
    FoundPasses m_found;
    std::vector<Piece> m_pieces;
    std::map<std::tuple<std::size_t, unsigned, int, std::size_t>, std::size_t> m_passes;
    std::map<std::tuple<std::size_t, unsigned, int, double>, std::size_t> m_times;
    DirectionCodes m_codes;
    std::optional<std::size_t> m_repeated; ///< the first line that repeats a target of its run
    std::optional<Direction> m_titled;
    std::optional<std::size_t> m_axisColumn;
    std::string m_axis;
    bool m_hasStates = false; ///< blocks as found and as left
    TestRole m_blockState = TestRole::notStated;
    std::string m_blockAxis;
};

} // namespace

FoundPasses readTargetsDown(TableReading &reading) {
    return TargetsDownReader(reading).read();
}

} // namespace palmer
