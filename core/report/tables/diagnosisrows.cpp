// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tables/diagnosisrows.h"

#include "kernel/diagnosis/sourcewords.h"
#include "kernel/diagnosis/traces.h"
#include "kernel/numerics/poweroften.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace palmer {

namespace {

class RowMaker {
public:
    RowMaker(const Diagnosis &diagnosis, const Language &language)
        : m_diagnosis(diagnosis)
        , m_language(language) {}

    [[nodiscard]] DiagnosisRow rowOf(std::size_t place) const {
        const SourceEstimate &source = m_diagnosis.sources[place];
        DiagnosisRow row;
        const bool frame = source.id == InfluenceId::centre || source.id == InfluenceId::radius;
        row.kind = frame              ? DiagnosisRowKind::fitCircle
                   : source.separable ? DiagnosisRowKind::source
                                      : DiagnosisRowKind::notTold;
        row.sources = {place};
        row.name = nameOf(source);
        setUnit(row, influence(source.id).unit);
        if (source.value && source.u)
            setNumbers(row, shownParameter(source.id, *source.value), shownUncertainty(source),
                       shownExpanded(source));
        row.contribution = source.contribution;
        row.meaning =
            source.separable ? m_language.sentence(sourceMeaning(m_diagnosis, source)) : reasonOf(source);
        if (source.separable && !frame && !source.reasons.empty())
            row.meaning += u' ' +
                           m_language.text(REPORT_TEXT("report", "An indication, without an interval:")) +
                           u' ' + sentences(source.reasons).join(u' ');
        if (source.separable)
            row.advice = adviceOf(source);
        return row;
    }

    /// Row of a part; the name of a sum is "Backlash X + 1.02 · Lateral play Y".
    [[nodiscard]] DiagnosisRow rowOf(const DiagnosedPart &part) const {
        if (!part.sum)
            return rowOf(part.sources.front());
        const SourceSum &sum = *part.sum;
        DiagnosisRow row;
        row.kind = DiagnosisRowKind::sum;
        row.sources = part.sources;
        for (const SourceSum::Part &one : sum.of) {
            if (&one != &sum.of.front())
                row.name += one.factor < 0 ? QStringLiteral(" − ") : QStringLiteral(" + ");
            constexpr double asGoodAsOne = 5e-4;
            if (std::abs(std::abs(one.factor) - 1) > asGoodAsOne)
                row.name +=
                    m_language.number(std::abs(one.factor), Quantity::number, 3) + QStringLiteral(" · ");
            row.name += m_language.sentence(summandName(m_diagnosis, one));
        }
        setUnit(row, sum.of.front().unit);
        setNumbers(row, sum.value, sum.u,
                   sum.interval ? std::optional(sum.interval->to - sum.value) : std::nullopt);
        row.contribution = part.contribution;
        row.meaning = m_language.text(
            REPORT_TEXT("report", "These arcs tell the sum alone, not how it is shared out."));
        row.advice =
            m_language.text(REPORT_TEXT("report", "A full circle in both senses tells more of them apart."));
        return row;
    }

private:
    /// Lengths use the unit of deviations, others their own.
    void setUnit(DiagnosisRow &row, const char *unit) const {
        row.quantity = unit == std::string_view("µm") ? Quantity::micrometres : Quantity::number;
        row.unit =
            row.quantity == Quantity::micrometres ? m_language.unit(row.quantity) : QString::fromUtf8(unit);
    }

    void setNumbers(DiagnosisRow &row, double value, double u, std::optional<double> half) const {
        const int decimals = decimalsOfEstimate(half.value_or(2 * u));
        row.value = m_language.number(value, row.quantity, decimals);
        const double last = powerOfTen(-decimals);
        if (half)
            row.expanded = *half < last / 2
                               ? QStringLiteral("<\u00A0") + m_language.number(last, row.quantity, decimals)
                               : m_language.number(*half, row.quantity, decimals);
    }

    [[nodiscard]] QStringList sentences(const std::vector<Message> &messages) const {
        QStringList result;
        for (const Message &message : messages)
            result << m_language.sentence(message);
        return result;
    }

    [[nodiscard]] QString nameOf(const SourceEstimate &source) const {
        QString name = m_language.sentence(sourceName(source));
        if (source.pitch)
            name += QStringLiteral(", ") + m_language.quantity(*source.pitch, Quantity::position);
        if (source.width)
            name += QStringLiteral(", ") + m_language.quantity(*source.width, Quantity::angle, 1);
        return name;
    }

    [[nodiscard]] QString reasonOf(const SourceEstimate &source) const {
        QStringList others;
        for (const std::size_t other : source.with)
            others << m_language.sentence(sourceName(m_diagnosis.sources[other]));
        if (others.isEmpty())
            return m_language.sentence(sourceMeaning(m_diagnosis, source));
        return m_language.sentence(REPORT_TEXT("report", "These arcs do not tell it from: %1."),
                                   {others.join(QStringLiteral(", ")).toStdString()});
    }

    /// Advice for the machine; empty if the value could be zero, or is an indication.
    [[nodiscard]] QString adviceOf(const SourceEstimate &source) const {
        if (source.u && !source.isSeen())
            return {};
        const Message advice = sourceAdvice(m_diagnosis, source);
        return advice.text.empty() ? QString() : m_language.sentence(advice);
    }

    const Diagnosis &m_diagnosis;
    const Language &m_language;
};

} // namespace

QStringList diagnosisWarnings(const Diagnosis &diagnosis, const Language &language) {
    QStringList result;
    if (const auto rotation = rotationStatement(diagnosis.rotation))
        result << language.sentence(*rotation);
    if (!diagnosis.modelFits) {
        QStringList seen;
        for (const Message &reason : diagnosis.reasons)
            seen << language.sentence(reason);
        result << language.sentence(
            REPORT_TEXT("report", "The noise model does not fit: intervals are not valid, and values are "
                                  "indications. Seen in the rest: %1."),
            {seen.join(QStringLiteral(", ")).toStdString()});
    }
    return result;
}

std::vector<DiagnosisRow> diagnosisRows(const Diagnosis &diagnosis, const Language &language) {
    const RowMaker make(diagnosis, language);
    std::vector<DiagnosisRow> rows;
    for (const DiagnosedPart &part : rankedParts(diagnosis))
        rows.push_back(make.rowOf(part));
    std::vector<DiagnosisRow> circle;
    for (std::size_t i = 0; i < diagnosis.sources.size(); ++i) {
        DiagnosisRow row = make.rowOf(i);
        if (row.kind == DiagnosisRowKind::fitCircle)
            circle.push_back(std::move(row));
        else if (!row.contribution)
            rows.push_back(std::move(row));
    }
    std::ranges::move(circle, std::back_inserter(rows));
    return rows;
}

int decimalsOfEstimate(double standardUncertainty) {
    if (!(standardUncertainty > 0))
        return 1;
    constexpr int most = 4;
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(standardUncertainty))), 0, most);
}

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
                const auto half = shownExpanded(*source);
                const int digits = decimalsOfEstimate(half.value_or(2 * shownUncertainty(*source)));
                row.here =
                    language.number(shownParameter(source->id, *source->value), Quantity::number, digits);
                if (half)
                    row.expanded = language.number(*half, Quantity::number, digits);
            }
            row.unit = QString::fromUtf8(influence(source->id).unit);
            row.positive = language.sentence(positiveMeaning(diagnosis, *source));
            result.push_back(std::move(row));
        }
    }
    return result;
}

} // namespace palmer
