// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/findingtext.h"

#include <QStringList>
#include <algorithm>
#include <array>

namespace palmer {

namespace {

QString withRemark(const QString &sentence, Source source, const Language &language) {
    return source == Source::practice
               ? sentence + u' ' + language.text(REPORT_TEXT("report", "(practice; text not available)"))
               : sentence;
}

/// The sentences of a line; names that complete the same sentence stand in it together.
QString sentencesOf(std::span<const Finding *const> line, const Language &language) {
    QStringList sentences;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Finding &finding = *line[i];
        if (finding.name.empty()) {
            sentences << language.sentence(finding.message);
            continue;
        }
        const auto same = [&](const Finding *other) {
            return !other->name.empty() && other->message.text == finding.message.text;
        };
        const auto end = line.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::any_of(line.begin(), end, same))
            continue;
        QStringList names;
        for (const Finding *other : line) {
            if (same(other) && !names.contains(findingName(*other, language)))
                names << findingName(*other, language);
        }
        Message message = finding.message;
        message.arguments.at(0) = names.join(QStringLiteral(", ")).toStdString();
        sentences << language.sentence(message);
    }
    sentences.removeDuplicates();
    return sentences.join(u' ');
}

} // namespace

QString findingName(const Finding &finding, const Language &language) {
    if (finding.name.empty())
        return {};
    const QString name = language.text(finding.name);
    return finding.letter.empty() ? name
                                  : QString::fromStdString(finding.letter) + QStringLiteral(") ") + name;
}

QString findingsText(std::span<const Finding *const> findings, const Language &language) {
    return findings.empty() ? QString()
                            : withRemark(sentencesOf(findings, language), findings.front()->source, language);
}

QString findingText(const Finding &finding, const Language &language) {
    return findingsText(std::array{&finding}, language);
}

} // namespace palmer
