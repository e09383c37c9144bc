// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/statedsources.h"

#include "kernel/diagnosis/sourcewords.h"
#include "report/tables/diagnosisrows.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace palmer {

namespace {

/// A word in the name of a result, and its source. Longer words must come first.
struct Name {
    const char *word;
    InfluenceId id;
};

constexpr std::array names{
    Name{"REVERSALSPIKE", InfluenceId::reversalSpike}, Name{"SQUARENESS", InfluenceId::squareness},
    Name{"SERVOMISMATCH", InfluenceId::servoMismatch}, Name{"SCALEMISMATCH", InfluenceId::scaleMismatch},
    Name{"LATERALPLAY", InfluenceId::lateralPlay},     Name{"STRAIGHTNESS", InfluenceId::straightness},
    Name{"CYCLICERROR", InfluenceId::cyclic},          Name{"BACKLASH", InfluenceId::backlash}};

/// "AF_SCALE_MISMATCH_X" → "AFSCALEMISMATCHX".
QString lettersOf(const std::string &name) {
    QString letters;
    for (const QChar c : QString::fromStdString(name).toUpper()) {
        if (c.isLetter())
            letters += c;
    }
    return letters;
}

/// The source of a result; for sources of an axis, the one whose letter follows the word.
const SourceEstimate *sourceOf(const Diagnosis &diagnosis, const std::string &result) {
    const QString letters = lettersOf(result);
    for (const Name &name : names) {
        const QLatin1StringView word(name.word);
        const qsizetype at = letters.indexOf(word);
        if (at < 0)
            continue;
        const std::string rest = letters.mid(at + word.size()).toStdString();
        if (!influence(name.id).ofAxis)
            return diagnosis.find(name.id);
        if (rest == diagnosis.first)
            return diagnosis.find(name.id, PlaneAxis::first);
        if (rest == diagnosis.second)
            return diagnosis.find(name.id, PlaneAxis::second);
        return nullptr;
    }
    return nullptr;
}

} // namespace

std::vector<StatedSource> statedSources(const Test &test, const Diagnosis &diagnosis,
                                        const Language &language) {
    constexpr int decimals = -1; // as many as the program gave
    std::vector<StatedSource> result;
    for (const ImportedFile &file : test.imports) {
        for (const ImportedResult &stated : file.results) {
            const SourceEstimate *source = sourceOf(diagnosis, stated.name);
            if (!source)
                continue;
            StatedSource row;
            row.name = QString::fromStdString(stated.name);
            row.stated = language.number(stated.value, Quantity::number, decimals);
            row.statedUnit = QString::fromStdString(stated.unit);
            row.source = language.sentence(sourceName(*source));
            if (source->value && source->u) {
                const double u = shownUncertainty(*source);
                const int digits = decimalsOfEstimate(u);
                row.here =
                    language.number(shownParameter(source->id, *source->value), Quantity::number, digits);
                row.u = language.number(u, Quantity::number, digits);
            }
            row.unit = QString::fromUtf8(influence(source->id).unit);
            row.positive = language.sentence(positiveMeaning(diagnosis, *source));
            result.push_back(std::move(row));
        }
    }
    return result;
}

} // namespace palmer
