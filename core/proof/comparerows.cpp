// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/compare.h"

#include <algorithm>

namespace palmer {

namespace {

struct Line {
    int page = 0; ///< from 1
    PrintedWords words;
};

/// Groups words into lines, each from left to right; a word belongs to the line that contains its middle.
std::vector<Line> linesOf(const PrintedWords &words, int page) {
    PrintedWords sorted = words;
    std::ranges::stable_sort(sorted, {}, [](const PrintedWord &word) { return word.area.center().y(); });
    std::vector<Line> lines;
    for (const PrintedWord &word : sorted) {
        if (lines.empty() || word.area.center().y() > lines.back().words.front().area.bottom())
            lines.push_back({page, {}});
        lines.back().words.push_back(word);
    }
    for (Line &line : lines)
        std::ranges::stable_sort(line.words, {}, [](const PrintedWord &word) { return word.area.left(); });
    return lines;
}

QString squeezed(const QString &text) {
    QString result;
    for (const QChar c : text) {
        if (!c.isSpace())
            result += c;
    }
    return result;
}

/// Index after the words from `from` on that make up `text`; null if they do not match.
std::optional<std::size_t> behind(const Line &line, std::size_t from, const QString &text) {
    QString read;
    for (std::size_t i = from; i < line.words.size() && read.size() < text.size(); ++i) {
        read += squeezed(line.words[i].text);
        if (read == text)
            return i + 1;
    }
    return std::nullopt;
}

/// Largest number of the values that follow in the line, in order, from word `from` on.
qsizetype valuesIn(const Line &line, std::size_t from, const QStringList &values) {
    qsizetype most = 0;
    if (values.isEmpty())
        return most;
    for (std::size_t i = from; i < line.words.size(); ++i) {
        if (const auto next = behind(line, i, values.front()))
            most = std::max(most, 1 + valuesIn(line, *next, values.mid(1)));
    }
    return std::max(most, valuesIn(line, from, values.mid(1)));
}

/// Number of values of the row that follow its label; null if the line does not contain the label.
std::optional<qsizetype> matched(const Line &line, const PrintedRow &row) {
    std::optional<qsizetype> most;
    for (std::size_t i = 0; i < line.words.size(); ++i) {
        if (const auto next = behind(line, i, row.label))
            most = std::max(most.value_or(0), valuesIn(line, *next, row.values));
    }
    return most;
}

QString textOf(const Line &line) {
    QStringList texts;
    for (const PrintedWord &word : line.words)
        texts << word.text;
    return texts.join(u' ');
}

QString textOf(const PrintedRow &row) {
    return (QStringList{row.label} + row.values).join(u' ');
}

Difference differenceAt(const Line &line, const PrintedRow &row) {
    QRectF area;
    for (const PrintedWord &word : line.words)
        area |= word.area;
    return {line.page, area, textOf(line), textOf(row), {}, {}};
}

PrintedRow squeezed(const PrintedRow &row) {
    PrintedRow result{squeezed(row.label), {}};
    for (const QString &value : row.values)
        result.values << squeezed(value);
    return result;
}

} // namespace

std::vector<Difference> compareRows(const std::vector<PrintedWords> &pages,
                                    const std::vector<PrintedRow> &rows) {
    constexpr qsizetype fewest = 3; ///< least number of values for recognising a row with one changed
    std::vector<Line> lines;
    for (std::size_t i = 0; i < pages.size(); ++i)
        std::ranges::move(linesOf(pages[i], static_cast<int>(i) + 1), std::back_inserter(lines));
    std::vector<bool> prints(lines.size(), false);
    std::vector<const PrintedRow *> almost(lines.size(), nullptr);
    std::vector<Difference> missing;
    for (auto given = rows.begin(); given != rows.end(); ++given) {
        if (std::find(rows.begin(), given, *given) != given)
            continue;
        const PrintedRow row = squeezed(*given);
        auto wanted = std::count(given, rows.end(), *given);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto values = matched(lines[i], row);
            if (values == row.values.size()) {
                prints[i] = true;
                --wanted;
            } else if (values && row.values.size() >= fewest && *values == row.values.size() - 1) {
                almost[i] = &*given;
            }
        }
        for (; wanted > 0; --wanted)
            missing.push_back({0, {}, {}, textOf(*given), {}, {}});
    }
    std::vector<Difference> result;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!almost[i] || prints[i])
            continue;
        result.push_back(differenceAt(lines[i], *almost[i]));
        // The row of this line is reported as changed, not also as missing.
        std::erase_if(missing, [&, done = false](const Difference &difference) mutable {
            const bool same = !done && difference.follows == result.back().follows;
            done = done || same;
            return same;
        });
    }
    std::ranges::move(missing, std::back_inserter(result));
    return result;
}

} // namespace palmer
