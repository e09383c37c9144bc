// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/parts.h"

#include "document/diagnosedtest.h"
#include "figures/diagnosisfigure.h"
#include "figures/ticks.h"
#include "kernel/diagnosis/traces.h"
#include "report/tables/diagnosisrows.h"
#include "report/words/wording.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace palmer {

namespace {

constexpr double micrometres = 1000; ///< per millimetre
constexpr int decimalsOfParts = 2;
const QString intervalHead = QStringLiteral("± 95\u00A0%");

QString ofAll(const Diagnosis &diagnosis, const Language &language) {
    return language.sentence(
        REPORT_TEXT("report", "%1 of %2"),
        {language.count(diagnosis.toldApart).toStdString(), language.count(diagnosis.of).toStdString()});
}

Cell contributionCell(const DiagnosisRow &row, const Language &language, int decimals) {
    return row.contribution
               ? Cell(language.number(*row.contribution * micrometres, Quantity::number, decimals))
               : Cell();
}

/// Composes the table of sources and its explanations.
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
            "faults of machines. ± is the 95 % interval of the fit alone. The part of "
            "G(b) is what the source would make alone; parts do not add up."))});
        for (const QString &warning : diagnosisWarnings(m_diagnosis, m_language))
            m_blocks.emplace_back(Paragraph{warning});
        addFit();
        addSources();
        for (const Message &remark : m_diagnosis.remarks)
            m_blocks.emplace_back(Paragraph{m_language.sentence(remark)});
        return std::move(m_blocks);
    }

private:
    [[nodiscard]] QString text(const Text &words) const { return m_language.text(words); }

    void addFit() {
        m_blocks.emplace_back(
            KeyValues{{{text(REPORT_TEXT("report", "Parameters told apart")), ofAll(m_diagnosis, m_language)},
                       {text(REPORT_TEXT("report", "Condition of the fit")),
                        m_language.number(m_diagnosis.condition, Quantity::number, 1)},
                       {text(REPORT_TEXT("report", "Rest, standard deviation")),
                        m_language.quantity(m_diagnosis.residual, Quantity::deviation, 3)}}});
    }

    void addSources() {
        Table table;
        table.columns = {
            {text(REPORT_TEXT_FOR("report", "Source", "diagnosis")), {}, Alignment::left, false},
            {text(REPORT_TEXT("report", "Value")), {}, Alignment::decimal, false},
            {intervalHead, {}, Alignment::decimal, false},
            {},
            {text(REPORT_TEXT("report", "Part of G(b)")), QStringLiteral("µm"), Alignment::decimal, false},
            {text(REPORT_TEXT("report", "Meaning")), {}, Alignment::left, true}};
        std::vector<Block> sums; // their names are too long for a terminal column
        for (const DiagnosisRow &row : diagnosisRows(m_diagnosis, m_language)) {
            if (row.kind == DiagnosisRowKind::sum)
                sums.emplace_back(Paragraph{m_language.sentence(
                    REPORT_TEXT("report", "Known of these sources is their sum: %1 = %2 %3."),
                    {row.name.toStdString(),
                     (row.expanded.isEmpty() ? row.value : row.value + QStringLiteral(" ± ") + row.expanded)
                         .toStdString(),
                     row.unit.toStdString()})});
            else
                table.rows.push_back({row.name, row.value, row.expanded, row.unit,
                                      contributionCell(row, m_language, decimalsOfParts), row.meaning});
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
constexpr double stripWidth = 175;
constexpr double stripHeight = 25;
constexpr double spectrumHeight = 40;
constexpr double barWidth = 18;    ///< of the full scale, mm
constexpr double barColumn = 20.5; ///< mm
constexpr std::size_t partsOfStrip = 1500;
constexpr int decimalsOfWidths = 1;

/// Options of the table of sources.
struct SourcesOfPage {
    std::size_t traced = 0; ///< number of leading sources that are drawn
    QString zone;           ///< what the contributions are a part of
    bool circle = false;    ///< include radius and centre, otherwise printed next to the figure
};

/// End of the bar scale, µm.
double endOfBars(const std::vector<DiagnosisRow> &rows) {
    double largest = 0;
    for (const DiagnosisRow &row : rows)
        largest = std::max(largest, row.contribution.value_or(0) * micrometres);
    return scaleEnd(largest);
}

Table sourcesTable(const Writer &write, const std::vector<DiagnosisRow> &rows, const SourcesOfPage &page) {
    const Language &language = write.language();
    const double end = endOfBars(rows);
    Table table;
    table.unbroken = rows.size() < mostRowsUnbroken;
    table.columns = {columnOf(QString(), 6.5, Alignment::right),
                     write.column(REPORT_TEXT_FOR("report", "Source", "diagnosis"), 38),
                     write.column(REPORT_TEXT("report", "Value"), 14, Alignment::decimal),
                     columnOf(intervalHead, 13.5, Alignment::decimal),
                     columnOf(QString(), 10.5),
                     columnOf(page.zone, page.zone.contains(u' ') ? 12.5 : 8.5, Alignment::decimal,
                              language.unit(Quantity::deviation)),
                     columnOf(QString(), barColumn),
                     {write.text(REPORT_TEXT("report", "Meaning, and what to look at on the machine")),
                      {},
                      Alignment::left,
                      true}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const DiagnosisRow &row = rows[i];
        const bool isCircle = row.kind == DiagnosisRowKind::fitCircle;
        if (isCircle && !page.circle)
            continue;
        const bool traced = i < page.traced;
        Cell name(row.name);
        name.bold = traced;
        Cell number(language.count(i + 1));
        Cell bar = blankCell();
        if (row.contribution && !isCircle) {
            bar = Cell();
            bar.extras.edit().bar = *row.contribution * micrometres / end * barWidth / (barColumn - 2);
            bar.extras.edit().hollow = !traced;
        } else {
            number = blankCell();
        }
        Cell unit(row.unit);
        Cell words(traced && !row.advice.isEmpty() ? row.meaning + u' ' + row.advice : row.meaning);
        words.pale = name.pale = unit.pale = row.kind == DiagnosisRowKind::notTold;
        table.rows.push_back({std::move(number), std::move(name), row.value, row.expanded, std::move(unit),
                              contributionCell(row, language, decimalsOfWidths), std::move(bar),
                              std::move(words)});
    }
    return table;
}

/// The figure with its heading on the left, for a right column.
SideBySide withTracedFigure(CircleFigure figure, const Writer &write) {
    SideBySide both;
    both.leftWidth = figureWidth;
    both.gap = figureGap;
    both.left.emplace_back(
        Heading{2, figure.title, write.say(REPORT_TEXT("report", "%1 per division"), figure.divisionLabel)});
    const QSizeF size = printedSize(figure);
    both.left.emplace_back(FigureBlock{std::move(figure), size.width(), size.height()});
    return both;
}

KeyValues narrowRows() {
    KeyValues values;
    values.narrow = true;
    return values;
}

/// Adds how well a fit tells its parameters apart, and what it leaves.
void addQuality(LabelledRows &rows, const Diagnosis &diagnosis, const Language &language) {
    rows.add(REPORT_TEXT("report", "Told apart"), ofAll(diagnosis, language));
    rows.add(REPORT_TEXT_FOR("report", "Condition", "of a fit"),
             language.number(diagnosis.condition, Quantity::number, 1));
    rows.add(REPORT_TEXT("report", "Rest, std. deviation"),
             language.quantity(diagnosis.residual, Quantity::deviation,
                               decimalsOfEstimate(diagnosis.residual * micrometres)));
}

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
        for (const QString &warning : diagnosisWarnings(m_test.diagnosis, language()))
            blocks.emplace_back(Paragraph{warning});
        addFigure(blocks);
        addSources(blocks);
        addStated(blocks);
        addRest(blocks);
    }

private:
    [[nodiscard]] const Language &language() const { return m_write.language(); }
    /// ": " with the spacing of the language.
    [[nodiscard]] QString colon() const {
        return language().id() == Language::Id::french ? QStringLiteral("\u00A0: ") : QStringLiteral(": ");
    }
    [[nodiscard]] QString width(double mm) const {
        return language().quantity(mm, Quantity::deviation, decimalsOfWidths);
    }

    /// Name of the minimum zone width: the symbol of the result if it is one.
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
                   : m_write.say(REPORT_TEXT("report", "sources 1 to %1"), language().count(m_traced));
    }

    void addFigure(std::vector<Block> &blocks) const {
        DiagnosisFigureOptions options;
        options.size = {figureWidth, figureHeight};
        options.columns = 2;
        if (m_traced > 0)
            options.synthetic = {
                m_write.say(REPORT_TEXT_FOR("report", "synthetic, %1", "sources 1 to 4"), tracedName())};
        CircleFigure figure = diagnosisFigure(m_test, m_chosen, language(), options);
        SideBySide both = withTracedFigure(std::move(figure), m_write);
        both.right.emplace_back(Heading{2, m_write.text(REPORT_TEXT("report", "Fit")),
                                        m_write.text(REPORT_TEXT("report", "least squares"))});
        both.right.emplace_back(fit());
        addWhatWeighs(both.right);
        blocks.emplace_back(std::move(both));
    }

    [[nodiscard]] KeyValues fit() const {
        const Diagnosis &diagnosis = m_test.diagnosis;
        const FittedCircle circle = fittedCircle(m_test.circle, diagnosis);
        LabelledRows rows(m_write, narrowRows());
        rows.add(REPORT_TEXT_FOR("report", "Feed", "contouring"),
                 m_write.quantity(m_part.measurement.feed, Quantity::feed));
        QStringList points;
        for (const DiagnosedArc &arc : m_test.circle.arcs)
            points << language().count(arc.points.size());
        points.removeDuplicates();
        rows.add(REPORT_TEXT("report", "Senses"),
                 m_test.circle.arcs.size() > 1 ? m_write.text(REPORT_TEXT("report", "both together"))
                                               : m_write.text(senseText(m_test.circle.arcs.front().sense)));
        const auto arcs = m_test.circle.arcs.size();
        rows.add(REPORT_TEXT("report", "Points"),
                 arcs > 1 && points.size() == 1
                     ? language().count(arcs) + QStringLiteral(" × ") + points.front()
                     : points.join(QStringLiteral(" + ")));
        addQuality(rows, diagnosis, language());
        rows.add(REPORT_TEXT("report", "Fitted centre"), centreText(m_part, circle.centre, decimalsOfWidths));
        rows.add(REPORT_TEXT("report", "Fitted radius"),
                 signedNumber(m_write, circle.radius - m_test.circle.nominalRadius, Quantity::deviation,
                              decimalsOfWidths) +
                     QStringLiteral("\u00A0") + language().unit(Quantity::deviation));
        return rows.take();
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
                                        language().count(m_traced))});
        const bool one = m_traced == 1;
        KeyValues values = narrowRows();
        values.rows = {
            {m_write.say(REPORT_TEXT("report", "%1, measured"), zoneName()), width(widths.measured)},
            {one ? m_write.text(REPORT_TEXT("report", "source 1 alone"))
                 : m_write.say(REPORT_TEXT("report", "sources 1 to %1 alone"), language().count(m_traced)),
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
        const double end = endOfBars(m_rows);
        addHeading(blocks, m_write.text(REPORT_TEXT("report", "Sources")),
                   m_write.say(REPORT_TEXT("report", "the part of %1 is what the source would make alone; "
                                                     "bars from 0 to %2, full where traced"),
                               {zoneName().toStdString(),
                                language().quantity(end, Quantity::micrometres, -1).toStdString()}));
        blocks.emplace_back(sourcesTable(m_write, m_rows, {m_traced, zoneName(), false}));
    }

    /// Adds the diagnosis by the instrument's own program.
    void addStated(std::vector<Block> &blocks) const {
        const std::vector<StatedSource> stated = statedSources(m_part.test, m_test.diagnosis, language());
        if (stated.empty())
            return;
        Table table;
        table.columns = {
            m_write.column(REPORT_TEXT("report", "Stated by the instrument’s program"), 46),
            m_write.column(REPORT_TEXT("report", "Value"), 13, Alignment::decimal),
            columnOf(QString(), 11),
            m_write.column(REPORT_TEXT("report", "Value here"), 19, Alignment::decimal),
            columnOf(intervalHead, 11, Alignment::decimal),
            columnOf(QString(), 10.5),
            {m_write.text(REPORT_TEXT("report", "Positive here means")), {}, Alignment::left, true}};
        for (const StatedSource &row : stated)
            table.rows.push_back({row.name, row.stated, row.statedUnit, row.here, row.expanded, row.unit,
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
            line.name.clear(); // same colours as in the figure above
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
    std::vector<DiagnosisRow> m_rows; ///< the traced ones first
    std::size_t m_traced;
    std::vector<std::size_t> m_chosen;
};

// ---- Several feeds ---------------------------------------------------------------------------------------

/// Page of the joint diagnosis of circles of one plane at several feeds, after the page of the last of them.
class FeedsPage {
public:
    FeedsPage(const Writer &write, const std::vector<DiagnosedTest> &tests, const Diagnosis &together)
        : m_write(write)
        , m_tests(tests)
        , m_together(together)
        , m_rows(diagnosisRows(together, write.language())) {}

    void add(std::vector<Block> &blocks) const {
        for (const QString &warning : diagnosisWarnings(m_together, language()))
            blocks.emplace_back(Paragraph{warning});
        addFigure(blocks);
        addHeading(blocks, m_write.text(REPORT_TEXT("report", "Sources")),
                   m_write.text(REPORT_TEXT("report", "the part of G(b) is what the source would make alone, "
                                                      "at the feed where that is most")));
        blocks.emplace_back(sourcesTable(m_write, m_rows, {0, QStringLiteral("G(b)"), true}));
        addOverFeed(blocks);
        QStringList remarks;
        for (const Message &remark : m_together.remarks)
            remarks << language().sentence(remark);
        if (!remarks.isEmpty())
            blocks.emplace_back(Paragraph{remarks.join(u' '), TextSize::small});
    }

private:
    [[nodiscard]] const Language &language() const { return m_write.language(); }

    void addFigure(std::vector<Block> &blocks) const {
        CircleFigureOptions options;
        options.size = {figureWidth, figureHeight};
        const std::vector<PathProfile> profiles = profilesAtFeeds(m_tests);
        CircleFigure figure = feedsFigure(m_tests, profiles, language(), options);
        SideBySide both = withTracedFigure(std::move(figure), m_write);
        both.right.emplace_back(Heading{2, m_write.text(REPORT_TEXT("report", "Fit")),
                                        m_write.text(REPORT_TEXT("report", "all feeds together"))});
        LabelledRows rows(m_write, narrowRows());
        rows.add(REPORT_TEXT("report", "Circles"), language().count(m_tests.size()));
        addQuality(rows, m_together, language());
        both.right.emplace_back(rows.take());
        both.right.emplace_back(Paragraph{
            m_write.text(REPORT_TEXT("report", "Each circle is drawn about its own fitted centre. What grows "
                                               "with the square of the feed is a lag; what stays is radius, "
                                               "scale or squareness.")),
            TextSize::small});
        blocks.emplace_back(std::move(both));
    }

    /// Adds detected lags and the most important sources over the feed, as each circle shows them.
    void addOverFeed(std::vector<Block> &blocks) const {
        constexpr double width = 85;
        constexpr double height = 42;
        std::vector<LineFigure> figures;
        const auto add = [&](const DiagnosisRow &row) {
            const SourceEstimate &source = m_together.sources[row.sources.front()];
            LineFigure figure = overFeedFigure(m_tests, source.id, source.axis, language());
            const bool isNew = std::ranges::none_of(
                figures, [&](const LineFigure &known) { return known.title == figure.title; });
            if (row.kind == DiagnosisRowKind::source && !figure.lines.empty() && isNew && figures.size() < 2)
                figures.push_back(std::move(figure));
        };
        for (const DiagnosisRow &row : m_rows) { // lags, which only several feeds determine
            const SourceEstimate &source = m_together.sources[row.sources.front()];
            const bool isLag = source.id == InfluenceId::commonLag || source.id == InfluenceId::lagMismatch;
            if (isLag && source.isSeen())
                add(row);
        }
        std::ranges::for_each(m_rows, add);
        if (figures.empty())
            return;
        SideBySide both;
        both.leftWidth = width;
        both.gap = figureGap;
        for (std::size_t i = 0; i < figures.size(); ++i) {
            std::vector<Part> &half = i == 0 ? both.left : both.right;
            half.emplace_back(Heading{
                2, figures[i].title,
                m_write.text(REPORT_TEXT("report", "each circle by itself, with its 95 % interval"))});
            for (FigureLine &line : figures[i].lines)
                line.name.clear();
            half.emplace_back(FigureBlock{std::move(figures[i]), width, height});
        }
        blocks.emplace_back(std::move(both));
    }

    const Writer &m_write;
    const std::vector<DiagnosedTest> &m_tests;
    const Diagnosis &m_together;
    std::vector<DiagnosisRow> m_rows;
};

/// Adds the joint diagnosis if this is the last test of a group at several feeds.
void addFeeds(std::vector<Block> &blocks, const CircularPart &part) {
    for (const std::vector<std::size_t> &group : testsAtSeveralFeeds(part.evaluated)) {
        if (group.back() != part.index)
            continue;
        std::vector<DiagnosedTest> tests;
        std::vector<DiagnosedCircle> circles;
        for (const std::size_t test : group) {
            if (auto one = diagnosedTest(part.evaluated, test)) {
                circles.push_back(one->circle);
                tests.push_back(std::move(*one));
            }
        }
        if (!areSeveralFeeds(circles))
            continue;
        const Diagnosis together = diagnose(circles);
        if (!together.valid())
            continue;
        const Writer &write = part.write;
        blocks.emplace_back(PageBreak{});
        blocks.emplace_back(Heading{
            1,
            write.say(REPORT_TEXT("report", "Diagnosis of plane %1 at several feeds (interpretation)"),
                      part.plane()),
            write.text(REPORT_TEXT("report", "not a result of ISO 230-4"))});
        FeedsPage(write, tests, together).add(blocks);
    }
}

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
        "report",
        "This diagnosis is no result of the test and no part of the verdict. It takes the measured "
        "path apart into known faults of machines; ± is the 95 % interval of the fit alone, without "
        "the uncertainty of the instrument."))});
    const auto test = diagnosedTest(part.evaluated, part.index);
    if (test)
        DiagnosisPage(part, *test).add(blocks);
    else
        blocks.emplace_back(Paragraph{
            write.text(REPORT_TEXT("report", "The evaluated points are too few for a diagnosis."))});
    addFeeds(blocks, part);
}

} // namespace palmer
