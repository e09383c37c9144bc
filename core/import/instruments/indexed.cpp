// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/place.h"
#include "import/instruments/datanumbers.h"
#include "import/instruments/otherlines.h"
#include "import/layouts/passes.h"
#include "import/layouts/sections.h"
#include "tables/contenterror.h"
#include "tables/folded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace palmer {

namespace {

constexpr long mostIndex = 1'000'000;

struct Assignment {
    std::string name;
    std::vector<long> indexes;
    std::string_view value;
    std::string_view comment;
};

/// `NAME[i,j]=value`; null for any other line.
std::optional<Assignment> assignmentOf(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos)
        return {};
    std::string_view left = withoutBlanks(line.substr(0, equals));
    Assignment result;
    result.value = withoutBlanks(line.substr(equals + 1));
    if (const std::size_t comment = result.value.find(';'); comment != std::string_view::npos) {
        result.comment = withoutBlanks(result.value.substr(comment + 1));
        result.value = withoutBlanks(result.value.substr(0, comment));
    }
    if (result.value.size() > 1 && result.value.front() == '"' && result.value.back() == '"')
        result.value = result.value.substr(1, result.value.size() - 2);
    if (left.ends_with(']')) {
        const std::size_t open = left.find('[');
        if (open == std::string_view::npos)
            return {};
        std::string_view list = left.substr(open + 1, left.size() - open - 2);
        left = withoutBlanks(left.substr(0, open));
        while (!list.empty()) {
            const std::size_t comma = list.find(',');
            const CellValue index = readCell(list.substr(0, comma), DecimalMark::point);
            if (index.kind != CellKind::number || index.value < 0 || index.value > mostIndex ||
                index.value != std::floor(index.value))
                return {};
            result.indexes.push_back(static_cast<long>(index.value));
            if (comma == std::string_view::npos)
                break;
            list.remove_prefix(comma + 1);
        }
    }
    result.name = upperCase(left);
    return result;
}

class IndexedReader {
public:
    IndexedReader(Choices &choices, Imported &imported)
        : m_choices(choices)
        , m(imported)
        , m_numbers(imported.text, choices) {}

    void read() {
        collect();
        const FileNotes notes = m_others.notes();
        std::vector<Pass> passes = passesOf();
        m_choices.resolve("content", "positions", Origin::recognised);
        PassForm form;
        form.content = m_choices.isChosen("content") ? std::string(m_choices.chosen("content")) : "positions";
        form.unit = resolveUnit(
            "unit", notes.unit, notes.unit.unit, *unitOf("mm"),
            {REPORT_TEXT("report", "Unit of the positions: nothing in the file says it; read as %1.")},
            m_choices, m.remarks);
        form.positionUnit = unitOf(
            m_choices
                .resolve("positionUnit", form.unit->word,
                         notes.unit.unit || m_choices.isChosen("unit") ? Origin::recognised : Origin::guessed)
                .value);
        requireOneMotion(form);
        form.sign = "actualMinusTarget";
        m_others.askForKind(
            {}, REPORT_TEXT("report", "Kind: the file speaks of “%1”; read as a positioning test."),
            m.remarks);
        m.test = testFrom(measurementOf(std::move(passes), form, m.remarks),
                          m_axis.empty() ? notes.axis : m_axis, m_choices, notes.edition);
        m_numbers.remark(m.remarks);
        takeNotes(notes, m);
    }

private:
    void collect() {
        for (const auto &[whole, number] : linesOf(m.text)) {
            const std::string_view line = withoutBlanks(whole);
            if (line.empty())
                continue;
            if (line.front() == ';' || line.front() == '#' || line.starts_with("//")) { // a comment
                if (const std::size_t begin = line.find_first_not_of(";#/ \t"); begin < line.size())
                    m_others.add(number, line.substr(begin));
                continue;
            }
            auto assignment = assignmentOf(line);
            if (assignment && take(*assignment, number)) {
                if (!assignment->comment.empty())
                    m_others.add(number, assignment->comment);
                continue;
            }
            if (isOfData(line))
                m.remarks.unlike(number);
            else
                m_others.add(number, line);
        }
        if (m_targets.empty())
            refuseContent(REPORT_TEXT("report", "there are no target positions in it"));
        if (m_positions && *m_positions != static_cast<double>(m_targets.size()))
            m.remarks.problem(
                {}, REPORT_TEXT("report", "Targets named in the head: %1, in the list: %2; the list counts."),
                counted(*m_positions), counted(m_targets.size()));
    }

    /// True for a damaged target or reading: such a name, but for texts (REF_PV=…), or a number with two
    /// indexes.
    [[nodiscard]] static bool isOfData(std::string_view line) {
        constexpr std::size_t longestName = 4;
        const std::string begin = folded(line.substr(0, longestName));
        const std::size_t equals = std::min(line.find('='), line.size());
        const std::string_view name = line.substr(0, equals);
        const std::string_view value = line.substr(std::min(equals + 1, line.size()));
        const bool isNumber = leadingNumber(withoutBlanks(value), DecimalMark::point).size > 0;
        if (begin == "ref_" || begin == "tgt_")
            return isNumber || value.empty() || name.find('[') != std::string_view::npos;
        return isNumber && name.find(',') != std::string_view::npos;
    }

    bool take(const Assignment &assignment, std::size_t line) {
        const std::string &name = assignment.name;
        const std::size_t indexes = assignment.indexes.size();
        if (name == "TGT_DATA" && indexes == 1)
            takeTarget(assignment, line);
        else if ((name == "REF_DATA_FWD" || name == "REF_DATA_BWD") && indexes == 2)
            takeReading(assignment, line);
        else if (name == "UNIT")
            m_others.add(line, "UNIT: " + std::string(assignment.value));
        else if (name == "POSITIONS")
            m_positions = numberOf(assignment, line);
        else if (name == "CYCLES")
            m_cycles = numberOf(assignment, line);
        else if (name == "AXIS")
            takeAxis(assignment, line);
        else
            return false;
        return true;
    }

    std::optional<double> numberOf(const Assignment &assignment, std::size_t line) {
        if (const auto number = m_numbers.one(assignment.value, line))
            return number;
        const CellValue value = readCell(assignment.value, decimalMarkIn(assignment.value));
        if (value.kind != CellKind::missing && value.kind != CellKind::empty)
            m.remarks.problem({"unread", line},
                              REPORT_TEXT("report", "“%1” is not a number. The reading stays missing."),
                              excerpt(assignment.value));
        return {};
    }

    void takeTarget(const Assignment &assignment, std::size_t line) {
        const auto value = numberOf(assignment, line);
        if (!value)
            refuseContentAt(placeOfLine(line), REPORT_TEXT("report", "“%1” is no target position"),
                            excerpt(assignment.value));
        if (!m_targets.emplace(assignment.indexes[0], *value).second)
            remarkRepetition(assignment.name, line);
    }

    void takeReading(const Assignment &assignment, std::size_t line) {
        auto &readings = assignment.name == "REF_DATA_FWD" ? m_forward : m_backward;
        const auto value = numberOf(assignment, line);
        const std::pair index{assignment.indexes[0], assignment.indexes[1]};
        if (value && !readings.try_emplace(index, *value, line).second)
            remarkRepetition(assignment.name, line);
    }

    void takeAxis(const Assignment &assignment, std::size_t line) {
        if (!m_axis.empty() && m_axis != assignment.value)
            m.remarks.unlike(line);
        else
            m_axis = assignment.value;
    }

    void remarkRepetition(const std::string &name, std::size_t line) {
        m.remarks.problem(
            {"unread", line},
            REPORT_TEXT("report", "%1 has these indexes for the second time; the line was not read."), name);
    }

    /// True if the first index is the target and the second the cycle; false if only the reverse fits.
    [[nodiscard]] bool targetIsFirst() const {
        bool straight = true;
        bool swapped = true;
        for (const auto *readings : {&m_forward, &m_backward}) {
            for (const auto &[index, value] : *readings) {
                straight &= m_targets.contains(index.first);
                swapped &= m_targets.contains(index.second);
            }
        }
        if (!straight && !swapped)
            refuseContent(REPORT_TEXT("report", "there are readings of targets that are not in the list"));
        // As many cycles as targets, or fewer: the readings are near the targets.
        const bool areBoth = straight && swapped && m_choices.chosen("content") != "deviations";
        return straight && (!areBoth || distance(&std::pair<long, long>::first) <=
                                            distance(&std::pair<long, long>::second));
    }

    /// The sum of the distances of the readings from the targets that one of the indexes names.
    [[nodiscard]] double distance(long std::pair<long, long>::*target) const {
        double sum = 0;
        for (const auto *readings : {&m_forward, &m_backward}) {
            for (const auto &[index, value] : *readings)
                sum += std::abs(value.first - m_targets.at(index.*target));
        }
        return sum;
    }

    /// Passes forward and backward, by cycle.
    [[nodiscard]] std::map<long, std::array<Pass, 2>> cyclesOf() const {
        const bool straight = targetIsFirst();
        std::map<long, std::array<Pass, 2>> cycles;
        for (const int side : {0, 1}) {
            for (const auto &[index, value] : side == 0 ? m_forward : m_backward) {
                const long target = straight ? index.first : index.second;
                const long cycle = straight ? index.second : index.first;
                Pass &pass = cycles[cycle][static_cast<std::size_t>(side)];
                pass.direction = side == 0 ? Direction::positive : Direction::negative;
                pass.readings.push_back(
                    {m_targets.at(target), value.first, static_cast<std::uint32_t>(value.second)});
            }
        }
        return cycles;
    }

    std::vector<Pass> passesOf() {
        std::map<long, std::array<Pass, 2>> cycles = cyclesOf();
        std::vector<Pass> passes;
        for (auto &[cycle, both] : cycles) {
            for (Pass &pass : both) {
                if (!pass.readings.empty())
                    passes.push_back(std::move(pass));
            }
        }
        std::vector<double> targets;
        for (const auto &[index, position] : m_targets)
            targets.push_back(position);
        if (!passes.empty())
            addMissing(passes.front(), targets);
        if (m_cycles && *m_cycles != static_cast<double>(cycles.size()))
            m.remarks.problem({},
                              REPORT_TEXT("report", "Cycles named in the "
                                                    "head: %1, in the readings: %2; the readings count."),
                              counted(*m_cycles), counted(cycles.size()));
        return passes;
    }

    Choices &m_choices;
    Imported &m;
    std::map<long, double> m_targets;
    std::map<std::pair<long, long>, std::pair<double, std::size_t>> m_forward;
    std::map<std::pair<long, long>, std::pair<double, std::size_t>> m_backward;
    DataNumbers m_numbers;
    OtherLines m_others;
    std::optional<double> m_positions;
    std::optional<double> m_cycles;
    std::string m_axis;
};

bool isIndexedText(QByteArrayView bytes) {
    const std::string_view text(bytes.data(), static_cast<std::size_t>(bytes.size()));
    return text.substr(0, 1 << 16).find("TGT_DATA[") != std::string_view::npos ||
           text.substr(0, 1 << 16).find("tgt_data[") != std::string_view::npos;
}

void readIndexedText(const ImportSource &source, Choices &choices, Imported &imported) {
    imported.text = decodedText(source.bytes, choices, imported);
    IndexedReader(choices, imported).read();
    choices.resolve("kind", "positioning", Origin::recognised);
}

} // namespace

const ImportFormat indexedFormat{"indexed", REPORT_TEXT("report", "values with indexes (TGT_DATA)"), "",
                                 isIndexedText, readIndexedText};

} // namespace palmer
