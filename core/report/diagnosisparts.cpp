// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/diagnosisparts.h"

#include "document/diagnosedtest.h"
#include "figures/diagnosisfigure.h"
#include "figures/ticks.h"
#include "kernel/diagnosis/traces.h"
#include "report/circularparts.h"
#include "report/diagnosisrows.h"
#include "report/statedsources.h"
#include "report/wording.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace palmer {

namespace {

constexpr double micrometres = 1000; ///< of a millimetre
constexpr int contributionDecimals = 2;

QString counted(const Language &language, auto n) {
    return language.number(static_cast<double>(n), Quantity::count, 0);
}

QString ofAll(const Diagnosis &diagnosis, const Language &language) {
    return language.sentence(
        {REPORT_TEXT("report", "%1 of %2"),
         {counted(language, diagnosis.rank).toStdString(), counted(language, diagnosis.of).toStdString()}});
}

Cell contributionCell(const DiagnosisRow &row, const Language &language, int decimals) {
    return row.contribution
               ? Cell(language.number(*row.contribution * micrometres, Quantity::number, decimals))
               : Cell();
}

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
        for (const Message &remark : m_diagnosis.remarks)
            m_blocks.emplace_back(Paragraph{m_language.sentence(remark)});
        return std::move(m_blocks);
    }

private:
    [[nodiscard]] QString text(const Text &words) const { return m_language.text(words); }

    void addFit() {
        KeyValues fit;
        fit.rows.push_back(
            {text(REPORT_TEXT("report", "Parameters told apart")), ofAll(m_diagnosis, m_language)});
        fit.rows.push_back({text(REPORT_TEXT("report", "Condition of the fit")),
                            m_language.number(m_diagnosis.condition, Quantity::number, 1)});
        fit.rows.push_back({text(REPORT_TEXT("report", "Rest, standard deviation")),
                            m_language.quantity(m_diagnosis.residual, Quantity::deviation, 3)});
        m_blocks.emplace_back(std::move(fit));
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
        std::vector<Block> sums; // their names are too long for a column of a terminal
        for (const DiagnosisRow &row : diagnosisRows(m_diagnosis, m_language)) {
            if (row.kind == DiagnosisRowKind::sum)
                sums.emplace_back(Paragraph{m_language.sentence(
                    {REPORT_TEXT("report", "Known of these sources is their sum: %1 = %2 %4, u = %3 %4."),
                     {row.name.toStdString(), row.value.toStdString(), row.u.toStdString(),
                      row.unit.toStdString()}})});
            else
                table.rows.push_back({row.name, row.value, row.u, row.unit,
                                      contributionCell(row, m_language, contributionDecimals), row.meaning});
        }
        m_blocks.emplace_back(std::move(table));
        std::ranges::move(sums, std::back_inserter(m_blocks));
    }

    const Diagnosis &m_diagnosis;
    const Language &m_language;
    std::vector<Block> m_blocks;
};

// ---- The page of the report ------------------------------------------------------------------------------

constexpr double figureWidth = 112; ///< mm
constexpr double figureHeight = 97;
constexpr std::size_t mostRowsUnbroken = 16;
constexpr double figureGap = 5;
constexpr double stripWidth = 175;
constexpr double stripHeight = 25;
constexpr double spectrumHeight = 40;
constexpr double barWidth = 18;    ///< of the end of the scale, mm
constexpr double barColumn = 20.5; ///< mm
constexpr std::size_t partsOfStrip = 1500;
constexpr int decimalsOfWidths = 1;

class DiagnosisPage {
public:
    DiagnosisPage(const CircularPart &part, const DiagnosedTest &test)
        : m_part(part)
        , m_write(part.write)
        , m_test(test)
        , m_rows(diagnosisRows(test.diagnosis, part.write.language()))
        , m_traced(prevailingParts(test.circle, test.diagnosis))
        , m_chosen(prevailingSources(test)) {}

    void add(std::vector<Block> &blocks) const {
        addFigure(blocks);
        addSources(blocks);
        addStated(blocks);
        addRest(blocks);
    }

private:
    [[nodiscard]] const Language &language() const { return m_write.language(); }
    /// ": " as the language spaces it.
    [[nodiscard]] QString colon() const {
        return language().id() == Language::Id::french ? QStringLiteral("\u00A0: ") : QStringLiteral(": ");
    }
    [[nodiscard]] QString width(double mm) const {
        return language().quantity(mm, Quantity::deviation, decimalsOfWidths);
    }

    /// What the widths of minimum zones are of: the result where that is one.
    [[nodiscard]] QString zoneName() const {
        if (m_part.measurement.referenceCircle != ReferenceCircle::minimumZone)
            return m_write.text(REPORT_TEXT("report", "minimum zone"));
        const QString feedback = m_part.feedback() ? QStringLiteral("f") : QString();
        return (m_test.circle.arcs.size() > 1 ? QStringLiteral("G(b)") : QStringLiteral("G")) + feedback;
    }

    /// "sources 1 to 4", "source 1".
    [[nodiscard]] QString tracedName() const {
        return m_traced == 1
                   ? m_write.text(REPORT_TEXT("report", "source 1"))
                   : m_write.say(REPORT_TEXT("report", "sources 1 to %1"), counted(language(), m_traced));
    }

    void addFigure(std::vector<Block> &blocks) const {
        DiagnosisFigureOptions options;
        options.size = {figureWidth, figureHeight};
        options.columns = 2;
        if (m_traced > 0)
            options.synthetic = {
                m_write.say(REPORT_TEXT_FOR("report", "synthetic, %1", "sources 1 to 4"), tracedName())};
        CircleFigure figure = diagnosisFigure(m_test, m_chosen, language(), options);
        SideBySide both;
        both.leftWidth = figureWidth;
        both.gap = figureGap;
        both.left.emplace_back(Heading{
            2, figure.title, m_write.say(REPORT_TEXT("report", "%1 per division"), figure.divisionLabel)});
        const QSizeF size = printedSize(figure);
        both.left.emplace_back(FigureBlock{std::move(figure), size.width(), size.height()});
        both.right.emplace_back(Heading{2, m_write.text(REPORT_TEXT("report", "Fit")),
                                        m_write.text(REPORT_TEXT("report", "least squares"))});
        both.right.emplace_back(fit());
        addWhatWeighs(both.right);
        blocks.emplace_back(std::move(both));
    }

    [[nodiscard]] KeyValues fit() const {
        const Diagnosis &diagnosis = m_test.diagnosis;
        const FittedCircle circle = fittedCircle(m_test.circle, diagnosis);
        KeyValues values;
        values.narrow = true;
        const auto add = [&](const Text &label, const QString &value) {
            values.rows.push_back({m_write.text(label), value});
        };
        add(REPORT_TEXT_FOR("report", "Feed", "contouring"),
            m_write.quantity(m_part.measurement.feed, Quantity::feed));
        QStringList points;
        for (const DiagnosedArc &arc : m_test.circle.arcs)
            points << counted(language(), arc.points.size());
        points.removeDuplicates();
        add(REPORT_TEXT("report", "Senses"), m_test.circle.arcs.size() > 1
                                                 ? m_write.text(REPORT_TEXT("report", "both together"))
                                                 : m_write.text(senseText(m_test.circle.arcs.front().sense)));
        const auto arcs = m_test.circle.arcs.size();
        add(REPORT_TEXT("report", "Points"),
            arcs > 1 && points.size() == 1
                ? counted(language(), arcs) + QStringLiteral(" × ") + points.front()
                : points.join(QStringLiteral(" + ")));
        add(REPORT_TEXT("report", "Told apart"), ofAll(diagnosis, language()));
        add(REPORT_TEXT_FOR("report", "Condition", "of a fit"),
            language().number(diagnosis.condition, Quantity::number, 1));
        add(REPORT_TEXT("report", "Rest, std. deviation"),
            language().quantity(diagnosis.residual, Quantity::deviation,
                                decimalsOfEstimate(diagnosis.residual * micrometres)));
        add(REPORT_TEXT("report", "Fitted centre"), centreText(m_part, circle.centre, decimalsOfWidths));
        add(REPORT_TEXT("report", "Fitted radius"),
            signedNumber(m_write, circle.radius - m_test.circle.nominalRadius, Quantity::deviation,
                         decimalsOfWidths) +
                QStringLiteral("\u00A0") + language().unit(Quantity::deviation));
        return values;
    }

    void addWhatWeighs(std::vector<Part> &blocks) const {
        const TracedWidths widths = tracedWidths(m_test.circle, m_test.diagnosis, m_chosen);
        blocks.emplace_back(Heading{2, m_write.text(REPORT_TEXT("report", "What weighs"))});
        if (m_traced == 0) {
            blocks.emplace_back(
                Paragraph{m_write.text(REPORT_TEXT("report", "No source stands out of the noise."))});
            return;
        }
        blocks.emplace_back(Paragraph{
            m_traced == 1 ? m_write.text(REPORT_TEXT("report", "Source 1 makes most of the path by itself."))
                          : m_write.say(REPORT_TEXT("report", "Sources 1 to %1 make most of the path."),
                                        counted(language(), m_traced))});
        const bool one = m_traced == 1;
        KeyValues values;
        values.narrow = true;
        values.rows = {
            {m_write.say(REPORT_TEXT("report", "%1, measured"), zoneName()), width(widths.measured)},
            {one ? m_write.text(REPORT_TEXT("report", "source 1 alone"))
                 : m_write.say(REPORT_TEXT("report", "sources 1 to %1 alone"), counted(language(), m_traced)),
             width(widths.chosen)},
            {m_write.say(one ? REPORT_TEXT("report", "%1 without it")
                             : REPORT_TEXT("report", "%1 without them"),
                         zoneName()),
             width(widths.without)}};
        blocks.emplace_back(std::move(values));
        blocks.emplace_back(Paragraph{
            m_write.text(REPORT_TEXT("report", "The parts do not add up: they do not reach their maximum at "
                                               "the same angle.")),
            TextSize::small});
    }

    void addSources(std::vector<Block> &blocks) const {
        double largest = 0;
        for (const DiagnosisRow &row : m_rows)
            largest = std::max(largest, row.contribution.value_or(0) * micrometres);
        const double end = scaleEnd(largest);
        Table table;
        table.unbroken = m_rows.size() < mostRowsUnbroken;
        table.columns = {
            {QString(), {}, Alignment::right, false, 6.5},
            {m_write.text(REPORT_TEXT_FOR("report", "Source", "diagnosis")), {}, Alignment::left, false, 38},
            {m_write.text(REPORT_TEXT("report", "Value")), {}, Alignment::decimal, false, 14},
            {Phrase({{QStringLiteral("u"), false, true}}), {}, Alignment::decimal, false, 13.5},
            {QString(), {}, Alignment::left, false, 10.5},
            {zoneName(), language().unit(Quantity::deviation), Alignment::decimal, false, 8.5},
            {QString(), {}, Alignment::left, false, barColumn},
            {m_write.text(REPORT_TEXT("report", "Meaning, and what to look at on the machine")),
             {},
             Alignment::left,
             true}};
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            const DiagnosisRow &row = m_rows[i];
            if (row.kind == DiagnosisRowKind::fitCircle)
                continue; // stands beside the figure
            const bool traced = i < m_traced;
            Cell name(row.name);
            name.bold = traced;
            Cell number(counted(language(), i + 1));
            Cell bar = blankCell();
            if (row.contribution) {
                bar = Cell();
                bar.bar = *row.contribution * micrometres / end * barWidth / (barColumn - 2);
                bar.hollow = !traced;
            } else {
                number = blankCell();
            }
            Cell unit(row.unit);
            Cell words(traced && !row.advice.isEmpty() ? row.meaning + u' ' + row.advice : row.meaning);
            words.pale = name.pale = unit.pale = row.kind == DiagnosisRowKind::notTold;
            table.rows.push_back({std::move(number), std::move(name), row.value, row.u, std::move(unit),
                                  contributionCell(row, language(), decimalsOfWidths), std::move(bar),
                                  std::move(words)});
        }
        addHeading(blocks, m_write.text(REPORT_TEXT("report", "Sources")),
                   m_write.say(REPORT_TEXT("report", "the part of %1 is what the source would make alone; "
                                                     "bars from 0 to %2, full where traced"),
                               {zoneName().toStdString(),
                                language().quantity(end, Quantity::micrometres, -1).toStdString()}));
        blocks.emplace_back(std::move(table));
    }

    /// What the program of the instrument says of the same faults.
    void addStated(std::vector<Block> &blocks) const {
        const std::vector<StatedSource> stated = statedSources(m_part.test, m_test.diagnosis, language());
        if (stated.empty())
            return;
        Table table;
        table.columns = {
            {m_write.text(REPORT_TEXT("report", "Stated by the instrument’s program")),
             {},
             Alignment::left,
             false,
             46},
            {m_write.text(REPORT_TEXT("report", "Value")), {}, Alignment::decimal, false, 13},
            {QString(), {}, Alignment::left, false, 11},
            {m_write.text(REPORT_TEXT("report", "Value here")), {}, Alignment::decimal, false, 19},
            {Phrase({{QStringLiteral("u"), false, true}}), {}, Alignment::decimal, false, 11},
            {QString(), {}, Alignment::left, false, 10.5},
            {m_write.text(REPORT_TEXT("report", "Positive here means")), {}, Alignment::left, true}};
        for (const StatedSource &row : stated)
            table.rows.push_back({row.name, row.stated, row.statedUnit, row.here, row.u, row.unit,
                                  QString(row.source + colon() + row.positive)});
        addHeading(blocks, m_write.text(REPORT_TEXT("report", "Beside the instrument’s own diagnosis")),
                   m_write.text(REPORT_TEXT("report", "its file states no sign convention: opposite signs "
                                                      "throughout may mean the opposite one")));
        blocks.emplace_back(std::move(table));
    }

    void addSpectrum(std::vector<Block> &blocks) const {
        LineFigure spectrum = spectrumFigure(m_test, language(), partsOfStrip);
        if (spectrum.lines.empty())
            return;
        for (FigureLine &line : spectrum.lines)
            line.name.clear();
        const auto &feed = m_test.circle.feed;
        const double turn = 2 * std::numbers::pi * m_test.circle.nominalRadius; // mm
        constexpr int decimals = 4;
        addHeading(blocks, spectrum.title,
                   feed ? m_write.say(REPORT_TEXT("report", "one wave a turn is %1 Hz"),
                                      language().number(*feed / turn, Quantity::number, decimals))
                        : QString());
        blocks.emplace_back(FigureBlock{std::move(spectrum), stripWidth, spectrumHeight});
    }

    void addRest(std::vector<Block> &blocks) const {
        LineFigure strip = residualFigure(m_test, language(), partsOfStrip);
        for (FigureLine &line : strip.lines)
            line.name.clear(); // as in the figure above
        addHeading(blocks, strip.title,
                   m_write.text(REPORT_TEXT("report", "measured minus all sources, over the angle; colours "
                                                      "as above")));
        blocks.emplace_back(FigureBlock{std::move(strip), stripWidth, stripHeight});
        addSpectrum(blocks);
        QStringList remarks{m_write.text(
            REPORT_TEXT("report", "The rest holds vibration, noise and what is none of these sources. Centre "
                                  "and radius, taken out before the path is drawn, have no part in G(b)."))};
        for (const Message &remark : m_test.diagnosis.remarks)
            remarks << language().sentence(remark);
        blocks.emplace_back(Paragraph{remarks.join(u' '), TextSize::small});
    }

    const CircularPart &m_part;
    const Writer &m_write;
    const DiagnosedTest &m_test;
    std::vector<DiagnosisRow> m_rows; ///< those that are traced come first
    std::size_t m_traced;
    std::vector<std::size_t> m_chosen;
};

} // namespace

std::vector<Block> diagnosisParts(const Diagnosis &diagnosis, const Language &language) {
    return diagnosis.valid() ? DiagnosisComposer(diagnosis, language).blocks() : std::vector<Block>();
}

void addDiagnosis(std::vector<Block> &blocks, const CircularPart &part) {
    const auto &include = part.head().include;
    if (std::ranges::find(include, ReportExtra::diagnosis) == include.end())
        return;
    const Writer &write = part.write;
    blocks.emplace_back(PageBreak{});
    blocks.emplace_back(Heading{1,
                                write.text(REPORT_TEXT("report", "Diagnosis of the circle (interpretation)")),
                                write.text(REPORT_TEXT("report", "not a result of ISO 230-4"))});
    blocks.emplace_back(Paragraph{write.text(REPORT_TEXT(
        "report", "This diagnosis is no result of the test and no part of the verdict. It takes the measured "
                  "path apart into known faults of machines; u is the standard uncertainty of the fit alone, "
                  "without that of the instrument."))});
    const auto test = diagnosedTest(part.evaluated, part.index);
    if (test)
        DiagnosisPage(part, *test).add(blocks);
    else
        blocks.emplace_back(Paragraph{
            write.text(REPORT_TEXT("report", "The evaluated points are too few for a diagnosis."))});
    blocks.emplace_back(PageBreak{}); // what follows is no interpretation
}

} // namespace palmer
