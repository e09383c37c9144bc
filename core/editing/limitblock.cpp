// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "editing/limitblock.h"

#include "editing/typedreading.h"
#include "kernel/evaluation/edition.h"
#include "kernel/words/unit.h"
#include "language/entry.h"
#include "tables/contenterror.h"
#include "tables/table.h"
#include "tables/units.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

namespace palmer {

namespace {

QStringList cellsOf(const CellTable &table, const TableRow &row) {
    QStringList cells;
    for (const TableCell &cell : table.cells(row)) {
        if (cell.size > 0)
            cells << QString::fromUtf8(table.text(cell));
    }
    return cells;
}

QString squeezed(const QString &text) {
    static const QRegularExpression space(QStringLiteral("[\\s_,]"));
    return text.normalized(QString::NormalizationForm_KC).remove(space);
}

const Unit *unitOfWord(const QString &word) {
    return unitIn('(' + word.toStdString() + ')');
}

Motion motionOf(Quantity quantity) {
    return quantity == Quantity::angularDeviation ? Motion::rotary : Motion::linear;
}

/// A number with its unit, if one follows it: "15 µm".
struct Amount {
    QString number;
    const Unit *unit = nullptr;
};

std::optional<Amount> amountIn(const QString &cell) {
    static const QRegularExpression form(
        QStringLiteral("^[≤<]?\\s*([+\\-\u2212]?[0-9.,\u00a0\u202f ]*[0-9][0-9.,]*)\\s*(\\D*)$"));
    const QRegularExpressionMatch match = form.match(cell);
    if (!match.hasMatch())
        return std::nullopt;
    Amount amount{match.captured(1).trimmed(), nullptr};
    if (const QString word = match.captured(2).trimmed(); !word.isEmpty()) {
        amount.unit = unitOfWord(word);
        if (!amount.unit)
            return std::nullopt;
    }
    return amount;
}

/// Content of a line.
struct LimitLine {
    int number = 0; ///< from 1
    const LimitName *name = nullptr;
    std::vector<Amount> amounts;
    const Unit *unit = nullptr;
    const Edition *edition = nullptr;
};

[[noreturn]] void refuse(Text sentence, const LimitLine &line) {
    refuseContent(sentence, wholeNumber(line.number));
}

class LimitBlock {
public:
    LimitBlock(const std::vector<LimitName> &names, const QString &block, const ImportOptions &answers)
        : m_names(names) {
        TableOptions options;
        options.comments = false;
        for (const auto &[sign, delimiter] :
             {std::pair(u'\t', Delimiter::tab), std::pair(u';', Delimiter::semicolon),
              std::pair(u'|', Delimiter::bar)}) {
            if (!options.delimiter && block.contains(sign))
                options.delimiter = delimiter; // "≤ 20" is not a number that readTable could go by
        }
        const CellTable table = readTable(block.toStdString(), options);
        for (const TableRow &row : table.rows()) {
            const QStringList cells = cellsOf(table, row);
            LimitLine line = read(cells);
            line.number = static_cast<int>(row.line);
            const bool heading = m_lines.empty() && line.amounts.empty() && !line.name;
            if (heading && line.unit)
                m_unit = line.unit;
            if (!heading && (line.name || !line.amounts.empty()))
                m_lines.push_back(std::move(line));
            else if (!heading && !cells.isEmpty())
                refuse(REPORT_TEXT("report",
                                   "line %1 of what was pasted is no limit; expected a symbol and a "
                                   "number"),
                       line);
        }
        if (const auto answer = answers.find("unit"); answer != answers.end()) {
            m_unit = unitOf(answer->second);
            m_origin = Origin::chosen;
        }
    }

    [[nodiscard]] PastedLimits into(Limits limits, std::size_t first, Quantity quantity,
                                    const DisplayUnits &units) const {
        PastedLimits result;
        result.limits = std::move(limits);
        bool areAllSaid = true; // each beside its number
        const bool named = std::ranges::any_of(m_lines, [](const LimitLine &line) { return line.name; });
        for (const LimitLine &line : m_lines) {
            if (line.amounts.empty())
                continue;
            if (line.amounts.size() > 1)
                refuse(
                    REPORT_TEXT("report",
                                "line %1 of what was pasted has several numbers; expected the limit alone"),
                    line);
            if (named && !line.name)
                refuse(REPORT_TEXT("report", "line %1 of what was pasted begins with no symbol of this "
                                             "edition"),
                       line);
            const std::size_t at = first + result.taken;
            if (!named && at >= m_names.size())
                refuse(
                    REPORT_TEXT("report", "line %1 of what was pasted is one limit more than there are rows"),
                    line);
            Limit &limit = result.limits[line.name ? line.name->id : m_names[at].id];
            limit.value = valueOf(line, quantity, units);
            if (line.edition)
                limit.edition = line.edition->word;
            areAllSaid &= line.amounts.front().unit || line.unit;
            ++result.taken;
        }
        if (!areAllSaid)
            result.units.push_back({"unit",
                                    m_unit ? m_unit->word : usualUnits(motionOf(quantity), units)["unit"],
                                    m_unit ? m_origin : Origin::guessed});
        return result;
    }

private:
    [[nodiscard]] LimitLine read(const QStringList &cells) const {
        LimitLine line;
        for (const QString &cell : cells) {
            const auto named = std::ranges::find_if(m_names, [&](const LimitName &name) {
                return squeezed(cell) == squeezed(name.symbol) || cell.toStdString() == name.id;
            });
            if (!line.name && line.amounts.empty() && named != m_names.end())
                line.name = &*named;
            else if (const Edition *edition = findEdition(cell.toStdString()))
                line.edition = edition;
            else if (auto amount = amountIn(cell))
                line.amounts.push_back(std::move(*amount));
            else if (const Unit *unit = unitOfWord(cell))
                line.unit = unit;
            else if (const Unit *within = unitIn(cell.toStdString()))
                line.unit = line.unit ? line.unit : within;
        }
        return line;
    }

    [[nodiscard]] double valueOf(const LimitLine &line, Quantity quantity, const DisplayUnits &units) const {
        const Amount &amount = line.amounts.front();
        const Unit *unit = amount.unit ? amount.unit : line.unit ? line.unit : m_unit;
        const NumberEntry entry = unit ? enteredNumber(amount.number, Quantity::number)
                                       : enteredNumber(amount.number, quantity, units);
        if (unit && unit->kind != unitKindOf(motionOf(quantity)))
            refuse(REPORT_TEXT("report", "the unit in line %1 of what was pasted is not one of this axis"),
                   line);
        if (!entry.value)
            refuse(REPORT_TEXT("report", "line %1 of what was pasted is no limit; expected a symbol and a "
                                         "number"),
                   line);
        return unit ? unit->toBase(*entry.value) : *entry.value;
    }

    const std::vector<LimitName> &m_names;
    std::vector<LimitLine> m_lines;
    const Unit *m_unit = nullptr; ///< of the heading, or chosen
    Origin m_origin = Origin::recognised;
};

} // namespace

PastedLimits pasteLimits(Limits limits, const std::vector<LimitName> &names, std::size_t first,
                         const QString &block, Quantity quantity, const DisplayUnits &units,
                         const ImportOptions &answers) {
    return LimitBlock(names, block, answers).into(std::move(limits), first, quantity, units);
}

} // namespace palmer
