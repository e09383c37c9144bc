// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commandline/editionoption.h"

#include "document/filewords.h"

#include <algorithm>
#include <vector>

namespace palmer {

namespace {

QString bare(const QString &word) {
    QString result = word.toLower();
    result.remove(u' ');
    return result;
}

/// True if the part matches whole words and numbers of the designation: "2006" matches, "006" does not.
bool isPartOf(const QString &part, const QString &designation) {
    // At `at` between two characters; "ISO230" has a word and a number, as blanks are removed.
    const auto isBorder = [&designation](qsizetype at) {
        if (at <= 0 || at >= designation.size())
            return true;
        const QChar before = designation[at - 1];
        const QChar after = designation[at];
        return !(before.isLetter() && after.isLetter()) && !(before.isDigit() && after.isDigit());
    };
    for (qsizetype at = designation.indexOf(part); at >= 0; at = designation.indexOf(part, at + 1)) {
        if (isBorder(at) && isBorder(at + part.size()))
            return true;
    }
    return false;
}

} // namespace

const Edition *editionAsked(const Invocation &invocation, std::optional<Kind> kind) {
    const auto word = invocation.value(QLatin1StringView("edition"));
    return word ? editionCalled(*word, kind) : nullptr;
}

const Edition *editionCalled(const QString &word, std::optional<Kind> kind) {
    const QString asked = bare(word);
    const auto known = kind ? editionsOf(*kind) : editions();
    std::vector<const Edition *> found;
    for (const Edition *edition : known) {
        const QString designation = bare(QString::fromUtf8(edition->word));
        if (designation == asked)
            return edition;
        if (!asked.isEmpty() && asked.front().isLetterOrNumber() && isPartOf(asked, designation))
            found.push_back(edition);
    }
    if (found.size() == 1)
        return found.front();
    if (found.empty())
        throw UsageError(
            {REPORT_TEXT("report", "unknown edition %1; known: %2"), {word.toStdString(), wordsOf(known)}});
    throw UsageError({REPORT_TEXT("report", "the edition %1 may be one of these: %2"),
                      {word.toStdString(), wordsOf(found)}});
}

void demandTestOf(const Edition &edition, const Document &document) {
    const bool has = std::ranges::any_of(
        document.tests, [&](const TestPointer &test) { return kindOf(*test) == edition.kind; });
    if (!has)
        throw UsageError(
            {REPORT_TEXT("report", "no test of the file is of the kind of %1"), {std::string(edition.word)}});
}

} // namespace palmer
