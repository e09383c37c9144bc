// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/help/help.h"

#include "document/statedthings.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "report/explanations/explanation.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace palmer {
namespace {

struct CircularFormula {
    const char *id = nullptr;
    const char *formula = nullptr;
    Text words;
};
constexpr std::array circularFormulas{
    CircularFormula{"G", "G = r_max − r_min",
                    REPORT_TEXT("report",
                                "r from the centre of the minimum zone circles of one path, or of its "
                                "least squares circle where that was chosen; the report says which")},
    CircularFormula{"G(b)", "G(b) = r_max − r_min",
                    REPORT_TEXT("report",
                                "the same for the points of both paths about one common centre; not the "
                                "larger of two G")},
    CircularFormula{"Fmax", "F_max = max(r − R) + C",
                    REPORT_TEXT("report",
                                "r from the chosen centre: least squares circle (full circles) or set-up; "
                                "C corrects to 20 °C")},
    CircularFormula{"Fmin", "F_min = min(r − R) + C", REPORT_TEXT("report", "likewise")},
    CircularFormula{
        "D", "D = R_LSC − R + C",
        REPORT_TEXT("report", "R_LSC of the least squares circle of both full paths, each of equal weight")},
    CircularFormula{"H", "H = max|r_ccw − r_cw|",
                    REPORT_TEXT("report", "over all angles about the common centre")},
    CircularFormula{"Gf", "G_f = r_max − r_min", REPORT_TEXT("report", "of the feedback signal of the axes")},
    CircularFormula{"G(b)f", "G(b)_f = r_max − r_min",
                    REPORT_TEXT("report", "of the feedback signal of the axes, both paths")},
};

struct TargetFormula {
    std::string_view id;
    const char *formula = nullptr;
};
constexpr std::array targetFormulas{
    TargetFormula{"mean+", "x̄_i↑ = Σ x_ij↑ / n"},
    TargetFormula{"mean-", "x̄_i↓ = Σ x_ij↓ / n"},
    TargetFormula{"mean", "x̄_i = (x̄_i↑ + x̄_i↓)/2"},
    TargetFormula{"reversal", "B_i = x̄_i↑ − x̄_i↓"},
    TargetFormula{"range+", "W_i↑ = max x_ij↑ − min x_ij↑"},
    TargetFormula{"range-", "W_i↓ = max x_ij↓ − min x_ij↓"},
    TargetFormula{"s+", "s_i↑ = √(Σ(x_ij↑ − x̄_i↑)²/(n − 1))"},
    TargetFormula{"s-", "s_i↓ = √(Σ(x_ij↓ − x̄_i↓)²/(n − 1))"},
    TargetFormula{"R+", "R_i↑ = %d s_i↑"},
    TargetFormula{"R-", "R_i↓ = %d s_i↓"},
    TargetFormula{"U", "U_i = |x̄_i↑ − x̄_i↓|"},
    TargetFormula{"Ps", "Ps_i = %c (s_i↑ + s_i↓)"},
    TargetFormula{"R", "R_i = max(%c s_i↑ + %c s_i↓ + |B_i|; R_i↑; R_i↓)"},
};

Table symbolTable(const Language &language) {
    Table table;
    table.columns = {{language.text(REPORT_TEXT("report", "Symbol")), {}, Alignment::left, false},
                     {language.text(REPORT_TEXT("report", "Name")), {}, Alignment::left, true},
                     {language.text(REPORT_TEXT("report", "Formula")), {}, Alignment::left, true},
                     {language.text(REPORT_TEXT("report", "Clause")), {}, Alignment::left, false}};
    return table;
}

Cell clauseCell(const char *clause) {
    return *clause == 0 ? Cell() : Cell(QString::fromUtf8(clause));
}

/// The page of an edition, with its title.
HelpPage pageOf(const Edition &edition, const Language &language) {
    const QString word = QString::fromUtf8(edition.word);
    HelpPage page{QStringLiteral("editions.") + word, word, {}};
    page.content.blocks.emplace_back(Heading{1, word});
    if (!edition.title.empty())
        page.content.blocks.emplace_back(Paragraph{language.text(edition.title)});
    return page;
}

HelpPage positioningPage(const Edition &edition, const Language &language) {
    HelpPage page = pageOf(edition, language);
    auto &blocks = page.content.blocks;
    blocks.emplace_back(Heading{2, language.text(REPORT_TEXT("report", "Parameters of the axis"))});
    Table table = symbolTable(language);
    for (const Row &row : edition.rows)
        table.rows.push_back({Cell(symbolPhrase(row.term.symbol)), Cell(language.text(row.term.name)),
                              Cell(phraseOf(formulaOf(edition, row, language))),
                              clauseCell(row.term.clause)});
    blocks.emplace_back(std::move(table));
    blocks.emplace_back(Heading{2, language.text(REPORT_TEXT("report", "Quantities at a target"))});
    Table targets = symbolTable(language);
    for (const TargetTerm &term : edition.targetTerms) {
        const auto found = std::ranges::find(targetFormulas, std::string_view(term.id), &TargetFormula::id);
        QString source = found == targetFormulas.end() ? QString() : inLettersOf(edition, found->formula);
        source.replace(QStringLiteral("%c"), language.number(edition.c, Quantity::number));
        source.replace(QStringLiteral("%d"), language.number(2 * edition.c, Quantity::number));
        targets.rows.push_back({Cell(symbolPhrase(term.symbol)), Cell(language.text(term.name)),
                                Cell(phraseFrom(source)), clauseCell(term.clause)});
    }
    blocks.emplace_back(std::move(targets));
    blocks.emplace_back(Paragraph{language.sentence(
        REPORT_TEXT("report", "x_ij is actual position minus target position; %1 counts targets, %2 runs; ↑ "
                              "and ↓ are approaches in the positive and the negative direction. A clause "
                              "that is not known is not printed."),
        {std::string(edition.targetLetter), std::string(edition.runLetter)})});
    return page;
}

HelpPage circularPage(const Edition &edition, const Language &language) {
    HelpPage page = pageOf(edition, language);
    auto &blocks = page.content.blocks;
    Table table = symbolTable(language);
    for (const CircularRow &row : edition.circles->rows) {
        const auto found = std::ranges::find_if(circularFormulas, [&](const CircularFormula &formula) {
            return std::string_view(formula.id) == row.term.id;
        });
        Phrase formula;
        if (found != circularFormulas.end()) {
            formula = phraseFrom(QString::fromUtf8(found->formula));
            formula.spans.push_back({language.semicolon() + language.text(found->words)});
        }
        table.rows.push_back({Cell(symbolPhrase(row.term.symbol)), Cell(language.text(row.term.name)),
                              Cell(formula), clauseCell(row.term.clause)});
    }
    blocks.emplace_back(std::move(table));
    blocks.emplace_back(Paragraph{language.text(REPORT_TEXT(
        "report", "The indices name the axes in the order in which the path crosses their positive "
                  "ends: counterclockwise XY, clockwise YX. Figure 6 of the standard contradicts its "
                  "clause 3.8; Palmer follows the clause."))});
    return page;
}

struct HelpStep {
    Text title;
    Text words;
};

HelpPage pageOf(const char *id, const Text &title, std::span<const HelpStep> steps,
                const Language &language) {
    HelpPage page{QString::fromLatin1(id), language.text(title), {}};
    auto &blocks = page.content.blocks;
    blocks.emplace_back(Heading{1, page.title});
    for (const HelpStep &step : steps) {
        blocks.emplace_back(Heading{2, language.text(step.title)});
        blocks.emplace_back(Paragraph{language.text(step.words)});
    }
    return page;
}

HelpPage workflowPage(const Language &language) {
    const auto steps = std::to_array<HelpStep>({
        {REPORT_TEXT_FOR("report", "Start", "the first step of the work"),
         REPORT_TEXT("report",
                     "A new test, an import, a file, an example. A file holds one report: a machine, its "
                     "instruments and any number of tests. A further test takes over what is stated of the "
                     "one in view, but nothing that was measured and no limits.")},
        {REPORT_TEXT("report", "Plan"),
         REPORT_TEXT("report",
                     "“Plan…” proposes targets from travel, period and seed, prints them with an empty "
                     "table and writes the part program.")},
        {REPORT_TEXT("report", "Enter or import"),
         REPORT_TEXT("report",
                     "Type, paste from a spreadsheet with comma or point, or import. Enter walks the "
                     "measuring cycle as the machine does.")},
        {REPORT_TEXT("report", "See at once"),
         REPORT_TEXT("report",
                     "Figure, results and findings follow every key. A click on a result explains it with "
                     "the numbers put in and the clause.")},
        {REPORT_TEXT("report", "Describe"),
         REPORT_TEXT("report",
                     "Machine, instruments, conditions, agreed points. What the edition requires is marked "
                     "and counted; F8 walks what is missing. Nothing of it blocks the printing. Templates "
                     "keep what is always the same.")},
        {REPORT_TEXT("report", "Compare"),
         REPORT_TEXT("report",
                     "“Compare…” sets editions side by side with the reason of each difference, and tests "
                     "over one another: as found and as left.")},
        {REPORT_TEXT("report", "Decide"),
         REPORT_TEXT("report",
                     "Limits with their edition, the uncertainty, the decision rule: then there is a "
                     "verdict. It is based on unrounded numbers.")},
        {REPORT_TEXT("report", "Print"),
         REPORT_TEXT("report",
                     "“Report…” shows the pages as they are printed, in French, in English or both.")},
    });
    return pageOf("workflow", REPORT_TEXT("report", "Workflow"), steps, language);
}

HelpPage registerPage(const Language &language) {
    const auto steps = std::to_array<HelpStep>({
        {REPORT_TEXT("report", "Folders"),
         REPORT_TEXT(
             "report",
             "The register lists the tests of the files and reports in folders and below them. The "
             "files stay the only record: Palmer never writes into them, and the register can be made "
             "anew from them at any time.")},
        {REPORT_TEXT("report", "Machines"),
         REPORT_TEXT(
             "report",
             "A machine is known by maker and serial number; capitals and additional blanks are the "
             "only differences that do not count. Without serial number it is “not identified”, known by "
             "name, maker and type. “Join with another…” makes two machines one, “Separate from another…” "
             "takes "
             "it back. With an interval each axis and plane has its day of the next test. All is kept in "
             "palmer-machines.json in the "
             "folder of the files. The mark of a certificate counts the days until one expires.")},
        {REPORT_TEXT("report", "Trend"),
         REPORT_TEXT(
             "report",
             "At least four tests since the last intervention make a line, weighted with what their "
             "uncertainties share. “Not before” is the day its upper bound of 95 % reaches the limit: "
             "for the level, not for the next test. Tests of another edition, feed, correction, travel, "
             "zone, "
             "radius, compensation, offset or number of runs are another series and never joined; the legend "
             "says "
             "what differs.")},
        {REPORT_TEXT("report", "Compare curves"),
         REPORT_TEXT("report",
                     "Several chosen tests of one axis are laid over one another, with the difference of two "
                     "on their common travel.")},
        {REPORT_TEXT("report", "Type test"),
         REPORT_TEXT(
             "report",
             "The newest comparable test of each machine of a type, with upper tolerance limits: what "
             "most machines of the type stay below. The machines are those in the register, no random "
             "sample. The examples have one of eight machines.")},
        {REPORT_TEXT("report", "History report"),
         REPORT_TEXT("report",
                     "Prints what is to be watched first, the trends, the campaigns and all tests of a "
                     "machine with their files.")},
    });
    return pageOf("register", REPORT_TEXT("report", "Register"), steps, language);
}

HelpPage sheetPage(const Language &language) {
    const auto steps = std::to_array<HelpStep>({
        {REPORT_TEXT("report", "Rows"),
         REPORT_TEXT(
             "report",
             "What is checked on a machine beside its tests: geometry, run-out, level. Each row has a "
             "number, an object, a tolerance, a measured value with its U (k = 2) and a unit. Objects and "
             "tolerances are those of the parties: Palmer ships none.")},
        {REPORT_TEXT("report", "Tolerance"),
         REPORT_TEXT(
             "report",
             "One number limits the magnitude of the value; two, the least and the largest, its signed "
             "value. Units are printed as typed and never converted.")},
        {REPORT_TEXT("report", "A row from a test"),
         REPORT_TEXT(
             "report",
             "A row may name a parameter of a test of the report: value, U, limit and unit then are those "
             "of the test, and change with it.")},
        {REPORT_TEXT("report", "Verdict"),
         REPORT_TEXT(
             "report",
             "One decision rule holds for all rows. The verdict of the report is the worst of those of "
             "sheet and tests. A row without a value is “not measured”: as long as there is one, the "
             "sheet is not proven. A row that does not apply needs a reason.")},
    });
    return pageOf("sheet", REPORT_TEXT("report", "Acceptance sheet"), steps, language);
}

HelpPage comparisonPage(const Language &language) {
    const auto steps = std::to_array<HelpStep>({
        {REPORT_TEXT("report", "Two tests"),
         REPORT_TEXT(
             "report",
             "As found and as left, before and after, two machines, two laboratories: two tests of one axis "
             "or plane are compared at their common targets, with as many cycles as both have. Everything "
             "else that differs is listed above the result. It is an interpretation, no result of the "
             "standard.")},
        {REPORT_TEXT("report", "U of the difference"),
         REPORT_TEXT(
             "report",
             "One simulation of both tests draws whole cycles anew and the errors of the budget, those that "
             "both share (the same instrument, α of the machine, the sensors) once for both. The U of each "
             "test would say too much of what is shared, and nothing of other cycles.")},
        {REPORT_TEXT("report", "Words"),
         REPORT_TEXT(
             "report",
             "“Changed” where the difference exceeds its U, between these two sessions; else “no change "
             "proven”. With an agreed tolerance: unchanged within it, changed by more, or not proven. "
             "Laboratories are judged by E_n.")},
    });
    return pageOf("comparison", REPORT_TEXT("report", "Comparison of two tests"), steps, language);
}

HelpPage thermalPage(const Language &language) {
    const auto steps = std::to_array<HelpStep>({
        {REPORT_TEXT("report", "Drift test"),
         REPORT_TEXT(
             "report",
             "Several sensors at rest over hours, with the temperatures beside them: a table of times, "
             "deviations and temperatures is read as one drift test. The channel of an axis has its name.")},
        {REPORT_TEXT("report", "E_VE over the duration of a test"),
         REPORT_TEXT(
             "report",
             "The largest range within any window as long as the test. Only a test whose duration is stated "
             "takes it so; others take the range of the whole record. A record that is too short gives a "
             "lower "
             "bound, which is said.")},
        {REPORT_TEXT("report", "Response to the temperature"),
         REPORT_TEXT(
             "report",
             "How many µm a channel moves per °C, and how fast: x = a + b·t + k·y, τ·dy/dt = θ − y, with "
             "intervals of 95 % for noise that may be correlated. Where the data cannot carry it, a sentence "
             "says why. It is an interpretation, no result of the standard.")},
        {REPORT_TEXT("report", "What the drift explains"),
         REPORT_TEXT("report", "How much of U it is, and what half the duration, no drift, or a temperature "
                               "held to ± 1, 2 or 5 °C "
                               "would make of it at worst.")},
    });
    return pageOf("thermal", REPORT_TEXT("report", "Thermal behaviour"), steps, language);
}

HelpPage fieldsPage(const Language &language) {
    HelpPage page{QStringLiteral("fields"), language.text(REPORT_TEXT("report", "Fields")), {}};
    auto &blocks = page.content.blocks;
    blocks.emplace_back(Heading{1, page.title});
    blocks.emplace_back(Paragraph{language.text(REPORT_TEXT(
        "report", "An empty field means “not stated”; 0 is a statement. Numbers are read with a point or "
                  "a comma. What cannot be read stays in red, and the value before it is kept."))});
    for (const StatedThing &field : statedThings()) {
        if (field.meaning.empty())
            continue;
        const QString key = QString::fromUtf8(field.key.data(), static_cast<qsizetype>(field.key.size()));
        blocks.emplace_back(Heading{3, language.text(field.name), {}, key});
        blocks.emplace_back(Paragraph{language.text(field.meaning)});
    }
    return page;
}

} // namespace

std::vector<HelpPage> composeHelp(const Language &language) {
    std::vector<HelpPage> pages{workflowPage(language),   registerPage(language), sheetPage(language),
                                comparisonPage(language), thermalPage(language),  fieldsPage(language)};
    for (const Edition *edition : editions())
        pages.push_back(edition->circles ? circularPage(*edition, language)
                                         : positioningPage(*edition, language));
    for (HelpPage &page : pages)
        page.content.language = language.code();
    return pages;
}

} // namespace palmer
