#include "report/diagnosisparts.h"

#include "kernel/diagnosis/sourcewords.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

namespace palmer {

namespace {

constexpr double micrometres = 1000; ///< of a millimetre

/// The table of sources and what is said of it.
class DiagnosisComposer {
public:
    DiagnosisComposer(const Diagnosis &diagnosis, const Language &language)
        : m_diagnosis(diagnosis)
        , m_language(language) {}

    std::vector<Block> blocks() {
        m_blocks.emplace_back(Heading{2, text(REPORT_TEXT("report", "Diagnosis (an interpretation)"))});
        m_blocks.emplace_back(Paragraph{text(REPORT_TEXT(
            "report",
            "Not a result of ISO 230-4, and no part of the verdict: the path taken apart into known "
            "faults of machines. u is the standard uncertainty of the fit alone. The part of "
            "G(b) is what the source would make alone; parts do not add up."))});
        addFit();
        addSources();
        addSums();
        for (const Message &remark : m_diagnosis.remarks)
            m_blocks.emplace_back(Paragraph{m_language.sentence(remark)});
        return std::move(m_blocks);
    }

private:
    [[nodiscard]] QString text(const Text &words) const { return m_language.text(words); }
    [[nodiscard]] QString number(double value, int decimals) const {
        return m_language.number(value, Quantity::number, decimals);
    }

    void addFit() {
        const auto count = [this](auto n) {
            return m_language.number(static_cast<double>(n), Quantity::count, 0);
        };
        KeyValues fit;
        fit.rows.push_back({text(REPORT_TEXT("report", "Parameters told apart")),
                            m_language.sentence({REPORT_TEXT("report", "%1 of %2"),
                                                 {count(m_diagnosis.rank).toStdString(),
                                                  count(m_diagnosis.of).toStdString()}})});
        fit.rows.push_back(
            {text(REPORT_TEXT("report", "Condition of the fit")), number(m_diagnosis.condition, 1)});
        fit.rows.push_back({text(REPORT_TEXT("report", "Rest, standard deviation")),
                            m_language.quantity(m_diagnosis.residual, Quantity::deviation, 3)});
        m_blocks.emplace_back(std::move(fit));
    }

    [[nodiscard]] QString nameOf(const SourceEstimate &source) const {
        QString name = m_language.sentence(sourceName(source));
        if (source.pitch)
            name += QStringLiteral(", ") + m_language.quantity(*source.pitch, Quantity::position);
        if (source.width)
            name += QStringLiteral(", ") + m_language.quantity(*source.width, Quantity::angle, 1);
        return name;
    }

    void addSources() {
        Table table;
        table.columns = {
            {text(REPORT_TEXT_FOR("report", "Source", "diagnosis")), {}, Alignment::left, false},
            {text(REPORT_TEXT("report", "Value")), {}, Alignment::decimal, false},
            {QStringLiteral("u"), {}, Alignment::decimal, false},
            {},
            {text(REPORT_TEXT("report", "Part of G(b)")), QStringLiteral("µm"), Alignment::decimal, false},
            {text(REPORT_TEXT("report", "Meaning")), {}, Alignment::left, true}};
        for (const SourceEstimate &source : m_diagnosis.sources) {
            const QString unit = QString::fromUtf8(influence(source.id).unit);
            Cell value;
            Cell u;
            if (source.value && source.u) {
                const double shown = shownParameter(source.id, *source.value);
                const double uncertainty = shownUncertainty(source);
                const int decimals = decimalsOfEstimate(uncertainty);
                value = number(shown, decimals);
                u = number(uncertainty, decimals);
            }
            QString meaning = m_language.sentence(sourceMeaning(m_diagnosis, source));
            table.rows.push_back(
                {nameOf(source), value, u, unit,
                 source.contribution ? Cell(number(*source.contribution * micrometres, 2)) : Cell(),
                 meaning});
        }
        m_blocks.emplace_back(std::move(table));
    }

    /// "Backlash X + 1.00 · Lateral play Y = 7.5 ± 0.1 µm"
    void addSums() {
        for (const SourceSum &sum : m_diagnosis.sums) {
            QString left;
            for (const SourceSum::Part &part : sum.of) {
                const bool first = &part == &sum.of.front();
                if (!first)
                    left += part.factor < 0 ? QStringLiteral(" − ") : QStringLiteral(" + ");
                if (std::abs(std::abs(part.factor) - 1) > 5e-4)
                    left += number(std::abs(part.factor), 3) + QStringLiteral(" · ");
                left += m_language.sentence(sourceName(m_diagnosis.sources[part.source]));
            }
            const int decimals = decimalsOfEstimate(sum.u);
            const QString unit =
                QString::fromUtf8(influence(m_diagnosis.sources[sum.of.front().source].id).unit);
            m_blocks.emplace_back(Paragraph{m_language.sentence(
                {REPORT_TEXT("report", "Known of these sources is their sum: %1 = %2 %4, u = %3 %4."),
                 {left.toStdString(), number(sum.value, decimals).toStdString(),
                  number(sum.u, decimals).toStdString(), unit.toStdString()}})});
        }
    }

    const Diagnosis &m_diagnosis;
    const Language &m_language;
    std::vector<Block> m_blocks;
};

} // namespace

std::vector<Block> diagnosisParts(const Diagnosis &diagnosis, const Language &language) {
    return diagnosis.valid() ? DiagnosisComposer(diagnosis, language).blocks() : std::vector<Block>();
}

int decimalsOfEstimate(double standardUncertainty) {
    if (!(standardUncertainty > 0))
        return 1;
    constexpr int most = 4;
    return std::clamp(1 - static_cast<int>(std::floor(std::log10(standardUncertainty))), 0, most);
}

} // namespace palmer
