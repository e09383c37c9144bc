// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/testfile.h"

#include "document/documenterror.h"

#include <QByteArray>
#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

namespace palmer {

namespace {

/// Keys that occur throughout every test file, up to its end.
constexpr auto keys = std::to_array<std::string_view>({"format",
                                                       "version",
                                                       "writtenBy",
                                                       "report",
                                                       "machine",
                                                       "instruments",
                                                       "tests",
                                                       "kind",
                                                       "edition",
                                                       "targets",
                                                       "runs",
                                                       "approach",
                                                       "deviations",
                                                       "arcs",
                                                       "sense",
                                                       "angles",
                                                       "conditions",
                                                       "agreedPoints",
                                                       "radialDeviations",
                                                       "extensions",
                                                       "limits",
                                                       "excluded",
                                                       "uncertainty",
                                                       "decisionRule",
                                                       "standardDeviation",
                                                       "targetChoice",
                                                       "imports",
                                                       "expanded",
                                                       "measures",
                                                       "times"});

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// True if the text has one of these keys as in JSON: "key" and a colon.
bool holdsKey(std::string_view text) {
    for (std::size_t colon = text.find(':'); colon != std::string_view::npos;
         colon = text.find(':', colon + 1)) {
        std::size_t end = colon;
        while (end > 0 && isBlank(text[end - 1]))
            --end;
        if (end < 2 || text[end - 1] != '"')
            continue;
        const std::size_t begin = text.rfind('"', end - 2);
        if (begin != std::string_view::npos &&
            std::ranges::find(keys, text.substr(begin + 1, end - begin - 2)) != keys.end())
            return true;
    }
    return false;
}

/// Removes the zeros of UTF-16 and UTF-32 in either byte order: ASCII then is as in UTF-8.
QByteArray withoutZeros(QByteArrayView bytes) {
    QByteArray result = bytes.toByteArray();
    result.erase(std::remove(result.begin(), result.end(), '\0'), result.end());
    return result;
}

std::string_view trimmed(std::string_view text) {
    const auto skipped = [](char c) {
        return isBlank(c) || std::strchr("\xEF\xBB\xBF\xFE\xFF", c) != nullptr; // and byte order marks
    };
    while (!text.empty() && skipped(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && skipped(text.back()))
        text.remove_suffix(1);
    return text;
}

} // namespace

bool isTestFileName(const QString &name) {
    return name.endsWith(QLatin1StringView(".palmer"), Qt::CaseInsensitive);
}

void requireNoTestFileName(const QString &name) {
    if (isTestFileName(name))
        throw Error(Error::Kind::unwritable,
                    {REPORT_TEXT("report", "this is the name of a test file, and what was measured would be "
                                           "lost; choose another ending")});
}

bool isTestFile(QByteArrayView bytes, const QString &name) {
    if (isTestFileName(name) || bytes.startsWith("%PDF-"))
        return true;
    if (bytes.startsWith("PK\x03\x04")) // a workbook
        return false;
    constexpr qsizetype headSize = 4096;
    const bool wide = bytes.first(std::min(bytes.size(), headSize)).contains('\0');
    const QByteArray narrow = wide ? withoutZeros(bytes) : QByteArray();
    const QByteArrayView seen = wide ? QByteArrayView(narrow) : bytes;
    const std::string_view text = trimmed({seen.data(), static_cast<std::size_t>(seen.size())});
    if (text.starts_with("{\\rtf"))
        return false;
    const bool endsLatex = text.substr(text.find_last_of('\n') + 1).starts_with("\\end{");
    return text.starts_with('{') || (text.ends_with('}') && !endsLatex) || holdsKey(text);
}

} // namespace palmer
