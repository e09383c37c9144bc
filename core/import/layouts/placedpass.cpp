// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/layouts/placedpass.h"

#include "document/place.h"
#include "tables/contenterror.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace palmer {

namespace {

/// Sum of squares of the readings about the mean at their position and direction: small if these are right.
double scatter(std::span<const PlacedPass> passes, const std::function<Direction(std::size_t)> &direction) {
    double sum = 0;
    for (const Direction wanted : {Direction::positive, Direction::negative}) {
        struct Moments {
            double count = 0;
            double mean = 0;
        };
        std::map<double, Moments> moments;
        for (std::size_t j = 0; j < passes.size(); ++j) {
            if (direction(j) != wanted)
                continue;
            for (const PassReading &reading : passes[j].pass.readings) {
                if (reading.isMissing)
                    continue;
                // Welford's method: positions as readings would leave no digits for the scatter of their
                // squares.
                auto &[count, mean] = moments[reading.position];
                const double d = reading.value - mean;
                mean += d / ++count;
                sum += d * (reading.value - mean);
            }
        }
    }
    return sum;
}

Direction directionUnder(std::string_view word, std::size_t j, std::size_t n) {
    if (word == "positive")
        return Direction::positive;
    if (word == "negative")
        return Direction::negative;
    const bool first = word == "sideBySide" ? 2 * j < n : j % 2 == 0;
    return first ? Direction::positive : Direction::negative;
}

/// Directions unknown: alternating or in halves, whichever scatters less.
std::string guessOf(const std::vector<PlacedPass> &passes) {
    const std::size_t n = passes.size();
    if (n % 2 == 1)
        return "positive";
    const auto inTurn = [n](std::size_t j) { return directionUnder("alternating", j, n); };
    const auto halves = [n](std::size_t j) { return directionUnder("sideBySide", j, n); };
    return n > 2 && scatter(passes, halves) < 0.5 * scatter(passes, inTurn) ? "sideBySide" : "alternating";
}

/// True if the readings support the guessed directions: ↑ and ↓ differ by more than their scatter. Also for
/// one unnumbered run each way, which is usual.
bool isPlain(std::string_view word, const std::vector<PlacedPass> &passes) {
    const std::size_t n = passes.size();
    if (word != "alternating" && word != "sideBySide")
        return true;
    if (n == 2)
        return passes[0].number == 0 && passes[1].number == 0;
    const auto guessed = [&](std::size_t j) { return directionUnder(word, j, n); };
    const auto allUp = [](std::size_t) { return Direction::positive; };
    return scatter(passes, guessed) < 0.5 * scatter(passes, allUp);
}

Message questionFor(std::string_view word, const FoundPasses &found, const TableBody &body) {
    if (word == "alternating" && found.isByLine)
        return {REPORT_TEXT(
            "report", "Directions: nothing in the file says them; the lines are read as ↑ and ↓ in turn.")};
    if (word == "alternating" && found.isBlockwise)
        return {REPORT_TEXT(
            "report", "Directions: nothing in the file says them; the blocks are read as ↑ and ↓ in turn.")};
    if (word == "alternating")
        return {REPORT_TEXT(
            "report", "Directions: nothing in the file says them; the runs are read as ↑ and ↓ in turn.")};
    if (word == "sideBySide")
        return {REPORT_TEXT("report", "Directions: nothing in the file says them; the first half of the runs "
                                      "is read as ↑, the second as ↓.")};
    if (word == "positive")
        return {REPORT_TEXT("report", "Directions: nothing in the file says them; all runs are read as ↑.")};
    if (body.directionWords.size() == 1)
        return {
            body.directionWords.begin()->second == Direction::positive
                ? REPORT_TEXT("report",
                              "Directions: “%1” is read as ↑, the opposite of the other word of its column.")
                : REPORT_TEXT("report",
                              "Directions: “%1” is read as ↓, the opposite of the other word of its column."),
            {excerpt(body.directionWords.begin()->first)}};
    if (found.hasSenses)
        return {REPORT_TEXT("report", "Directions: the file says clockwise or counterclockwise, not which of "
                                      "them is positive; clockwise is read as ↑.")};
    return {REPORT_TEXT(
        "report", "Directions: letters, abbreviations or titles say them; look whether ↑ and ↓ are right.")};
}

/// The heading of the targets if it names a direction: above columns of blanks, its words may belong to the
/// readings. Empty if it names none.
std::string targetHeadingWithDirection(const TableReading &reading) {
    const std::vector<ImportColumn> &columns = reading.result.columns;
    for (std::size_t c = 0; c < std::min(columns.size(), reading.body.columns.size()); ++c) {
        const std::string &heading = reading.body.columns[c].heading;
        if (columns[c].role == ColumnRole::target && readHeading(heading).direction)
            return heading;
    }
    return {};
}

/// "Up = negative direction": a line that gives a direction another name. Null if there is none.
std::optional<std::uint32_t> renamedDirection(const TableReading &reading) {
    const auto found = std::ranges::find_if(reading.body.notes, [&](std::uint32_t note) {
        const std::string text = reading.textOf(note);
        const std::size_t sign = std::min(text.find_first_of("=:"), text.size());
        const HeadingWords name = readHeading(std::string_view(text).substr(0, sign));
        const HeadingWords meant = readHeading(std::string_view(text).substr(sign));
        return name.isDirectionOnly() && meant.direction && meant.direction != name.direction;
    });
    return found == reading.body.notes.end() ? std::nullopt : std::optional(*found);
}

/// A row above the numbers that is none of their headings, but names two directions, or speaks of runs or
/// directions in words that are not all known. Null if there is none.
std::optional<std::uint32_t> unusedDirections(const TableReading &reading) {
    const auto names = [&](const TableCell &cell) {
        const HeadingWords words = readHeading(reading.table().text(cell));
        return words.direction && words.unknownWords == 0;
    };
    for (const TableBlock &block : reading.body.blocks) {
        for (const std::uint32_t head : reading.titlesOf(block)) {
            const HeadingWords all = readHeading(reading.textOf(head));
            if ((all.direction || all.namesBoth) && !all.isTitle() &&
                (all.saysDirection || all.meaning == Meaning::run))
                return head;
            if (!reading.row(head).comment &&
                std::ranges::count_if(reading.table().cells(reading.row(head)), names) >= 2)
                return head;
        }
    }
    return {};
}

/// The words that answer where the file states no directions.
std::vector<std::string> unstatedDirections() {
    std::vector<std::string> answers;
    for (const ImportWord &word : findImportKey("directions")->words) {
        if (word.word != std::string_view("stated") && word.word != std::string_view("reversed"))
            answers.emplace_back(word.word);
    }
    return answers;
}

void askForDirections(std::string_view word, const FoundPasses &found, TableReading &reading) {
    const bool stated = word == "stated";
    const std::size_t first = reading.remarks.size();
    const std::string straying = stated ? std::string() : targetHeadingWithDirection(reading);
    const auto unused = stated ? std::nullopt : unusedDirections(reading);
    const auto renamed = stated ? renamedDirection(reading) : std::nullopt;
    if (!straying.empty())
        reading.remarks.problem("directions",
                                REPORT_TEXT("report", "Directions: only “%1”, the heading of the targets, "
                                                      "names one."),
                                excerpt(straying));
    else if (unused)
        reading.remarks.problem({"directions", reading.row(*unused).line},
                                REPORT_TEXT("report", "Directions: “%1” names some, but is not read as the "
                                                      "headings of the columns."),
                                excerpt(withoutBlanks(reading.textOf(*unused))));
    else if (renamed)
        reading.remarks
            .problem({"directions", reading.row(*renamed).line},
                     REPORT_TEXT("report", "Directions: the file says “%1”; ↑ and ↓ are read as the runs are "
                                           "called."),
                     excerpt(withoutBlanks(reading.textOf(*renamed))))
            .answers = {"stated", "reversed"};
    else if (stated && found.unclearCodes)
        reading.remarks
            .problem("directions",
                     REPORT_TEXT("report", "Directions: nothing says which of the entries in their column is "
                                           "↑, or the order of the targets contradicts it; %1 is read as ↑, "
                                           "%2 as ↓."),
                     found.unclearCodes->first, found.unclearCodes->second)
            .answers = {"stated", "reversed"};
    else
        // A machine's direction of rotation depends on the side it is seen from.
        reading.remarks.add(isPlain(word, found.passes) && !found.hasSenses ? RemarkGrade::assumption
                                                                            : RemarkGrade::problem,
                            "directions", questionFor(word, found, reading.body));
    for (std::size_t i = first; i < reading.remarks.size() && !stated; ++i)
        reading.remarks[i].answers = unstatedDirections();
}

} // namespace

void resolveDirections(FoundPasses &found, TableReading &reading) {
    std::vector<PlacedPass> &passes = found.passes;
    const bool stated =
        std::ranges::all_of(passes, [](const PlacedPass &p) { return p.direction.has_value(); });
    const bool isKnown = stated && !found.hasHints && !renamedDirection(reading);
    const Origin origin = isKnown ? Origin::recognised : Origin::guessed;
    const auto choice = reading.choices.resolve("directions", stated ? "stated" : guessOf(passes), origin);
    const bool isStated = choice.value == "stated" || choice.value == "reversed";
    if (isStated && !stated)
        refuseContent(REPORT_TEXT("report", "the file does not say which "
                                            "runs are ↑ and which ↓; choose another word for “directions”"));
    if (choice.value == "reversed") {
        for (PlacedPass &placed : passes)
            placed.direction =
                placed.direction == Direction::positive ? Direction::negative : Direction::positive;
    } else if (choice.value != "stated") {
        for (std::size_t j = 0; j < passes.size(); ++j)
            passes[j].direction = directionUnder(choice.value, j, passes.size());
    }
    if (choice.origin == Origin::guessed)
        askForDirections(choice.value, found, reading);
}

namespace {

/// True if ↓ precedes ↑ of the same number.
bool hasDownFirst(const std::vector<PlacedPass> &placed) {
    std::set<unsigned> down;
    return std::ranges::any_of(placed, [&](const PlacedPass &each) {
        if (each.direction == Direction::negative)
            down.insert(each.number);
        return each.direction == Direction::positive && down.contains(each.number);
    });
}

} // namespace

std::vector<Pass> inOrder(std::vector<PlacedPass> placed, TableReading &reading) {
    std::set<unsigned> numbers;
    std::set<std::pair<unsigned, Direction>> numbersOfDirections;
    bool both = false;
    bool inTurn = true;
    for (std::size_t j = 0; j < placed.size(); ++j) {
        PlacedPass &each = placed[j];
        each.pass.direction = *each.direction;
        if (each.number > 0) {
            numbers.insert(each.number);
            numbersOfDirections.insert({each.number, *each.direction});
        }
        const bool same = j > 0 && placed[j - 1].direction == each.direction;
        inTurn &= !same;
        both |= j > 0 && !same;
    }
    const bool isStated = numbers.size() == placed.size();
    const auto place = [](const PlacedPass &each) {
        return std::pair(each.number, *each.direction == Direction::negative);
    };
    if (numbersOfDirections.size() == placed.size()) {
        if (both && inTurn && hasDownFirst(placed))
            reading.remarks.note({},
                                 REPORT_TEXT("report", "Order of the runs: in the table, ↓ comes before ↑ "
                                                       "of the same number; ↑ is put first."));
        else if (!std::ranges::is_sorted(placed, {}, &PlacedPass::number) && both && inTurn)
            reading.remarks.note({}, REPORT_TEXT("report", "Order of the runs: that of their numbers, not "
                                                           "that of the table."));
        std::ranges::stable_sort(placed, {}, place);
    }
    std::vector<Pass> passes;
    passes.reserve(placed.size());
    for (PlacedPass &each : placed)
        passes.push_back(std::move(each.pass));
    if (isStated || !both || inTurn)
        return passes;
    reading.remarks.note({}, REPORT_TEXT("report", "Order of the runs: nothing in the table says it; ↑ and ↓ "
                                                   "are put in turn, the cycle stays not stated."));
    return inCycles(std::move(passes));
}

namespace {

/// "Forward test sequence" above one block and "Backward test sequence" above another: what differs is the
/// direction, whatever the other words mean.
bool hasOpposite(const HeadingWords &title, const TableReading &reading) {
    const auto isOpposite = [&](std::uint32_t head) {
        const HeadingWords other = readHeading(reading.textOf(head));
        return other.direction && other.direction != title.direction && other.stem == title.stem &&
               other.meaning == title.meaning && other.number == title.number;
    };
    return std::ranges::any_of(reading.body.blocks, [&](const TableBlock &block) {
        return std::ranges::any_of(reading.titlesOf(block), isOpposite);
    });
}

} // namespace

BlockDirection directionOfBlock(const TableReading &reading, const TableBlock &block) {
    BlockDirection result;
    for (const std::uint32_t head : reading.titlesOf(block)) {
        const HeadingWords heading = readHeading(reading.textOf(head));
        if (heading.direction && heading.hint && heading.direction != heading.hint)
            continue; // "avance 1; retroceso 1": column headings, not a title
        if (heading.isDirectionOnly() ||
            (heading.direction && heading.isOfReadings() && hasOpposite(heading, reading))) {
            result.stated = heading.direction;
            break;
        }
        if (!result.hint)
            result.hint = heading.direction ? heading.direction : heading.hint;
    }
    return result;
}

} // namespace palmer
