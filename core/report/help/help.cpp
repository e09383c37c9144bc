// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/help/help.h"

#include "kernel/evaluation/iso230_4/circularcase.h"
#include "report/explanations/explanation.h"
#include "report/help/validationreport.h"
#include "report/words/wording.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace palmer {
namespace {

struct FieldHelp {
    const char *key = nullptr; ///< in the file
    Text name;
    Text meaning;
};

// clang-format off
constexpr std::array fieldHelps{
    FieldHelp{"date", REPORT_TEXT("report", "Date of the test"), REPORT_TEXT("report", "The day the readings were taken: 12.03.2026, 2026-03-12 or in words. The day stands first.")},
    FieldHelp{"name", REPORT_TEXT("report", "Name"), REPORT_TEXT("report", "What the report calls the machine, or the letter of the axis under test.")},
    FieldHelp{"manufacturer", REPORT_TEXT("report", "Manufacturer"), REPORT_TEXT("report", "The maker of the machine, as on its plate.")},
    FieldHelp{"model", REPORT_TEXT("report", "Type"), REPORT_TEXT("report", "The type of the machine, as on its plate.")},
    FieldHelp{"serialNumber", REPORT_TEXT("report", "Serial number"), REPORT_TEXT("report", "Tells this machine or this instrument from all others of its type.")},
    FieldHelp{"controller", REPORT_TEXT("report", "Numerical control"), REPORT_TEXT("report", "Maker and type of the numerical control, with its version where compensation depends on it.")},
    FieldHelp{"instruments", REPORT_TEXT("report", "Instrument"), REPORT_TEXT("report", "The measuring instrument. Each test names those it was measured with; the first one is taken for all tests.")},
    FieldHelp{"certificate", REPORT_TEXT("report", "Calibration certificate"), REPORT_TEXT("report", "Number of the certificate that makes the readings traceable.")},
    FieldHelp{"calibrationDate", REPORT_TEXT("report", "Calibrated on"), REPORT_TEXT("report", "The day of the calibration, not of its end of validity.")},
    FieldHelp{"travel", REPORT_TEXT("report", "Axis travel"), REPORT_TEXT("report", "The whole travel of the axis, not that between the first and the last target: the number of targets and the kind of test follow from it.")},
    FieldHelp{"range", REPORT_TEXT("report", "Ends of the axis"), REPORT_TEXT("report", "Both ends of the travel in coordinates of the axis, as “0 … 1800”: shows whether the first and the last target can be approached from both sides.")},
    FieldHelp{"zone", REPORT_TEXT("report", "Agreed working zone"), REPORT_TEXT("report", "The 2 000 mm (360°) of a long axis that were agreed for the full test. A test whose targets lie inside is judged as that of a short axis.")},
    FieldHelp{"positionFeedback", REPORT_TEXT("report", "Measuring system of the axis"), REPORT_TEXT("report", "How the axis knows its position: linear scale, rotary encoder at the screw, …")},
    FieldHelp{"targetChoice", REPORT_TEXT("report", "Choice of targets"), REPORT_TEXT("report", "Freely chosen targets have a random part, so that periodic errors do not stay hidden; the plan proposes them.")},
    FieldHelp{"cycle", REPORT_TEXT("report", "Test cycle"), REPORT_TEXT("report", "Standard: all targets up, all down, again. Step: all approaches at one target, then the next; only by written agreement. Not stated: the report says so.")},
    FieldHelp{"feed", REPORT_TEXT("report", "Feed rate"), REPORT_TEXT("report", "The feed between the targets, as programmed; or rapid.")},
    FieldHelp{"dwell", REPORT_TEXT("report", "Dwell at the target"), REPORT_TEXT("report", "How long the axis rests before the reading is taken.")},
    FieldHelp{"approachDistance", REPORT_TEXT("report", "Approach distance"), REPORT_TEXT("report", "How far the axis goes beyond a target before it comes back to it: beyond the first and the last one it needs that room.")},
    FieldHelp{"sensors", REPORT_TEXT("report", "Temperatures"), REPORT_TEXT("report", "Start and end of the test for each sensor, and where it was. The mean of machine and instrument is what the correction to 20 °C uses.")},
    FieldHelp{"expansion", REPORT_TEXT("report", "Expansion coefficient α"), REPORT_TEXT("report", "Of the measuring system of the machine and of the instrument, in µm/(m·°C): steel about 11.5, glass scales about 8. Needed to correct to 20 °C. An instrument that compensates the air only: 0.")},
    FieldHelp{"correctionTo20", REPORT_TEXT("report", "Correction to 20 °C"), REPORT_TEXT("report", "By the instrument: its material compensation was on, nothing is added. Applied here: Palmer adds the nominal differential expansion. Never both: that costs 35 µm/m at 3 °C.")},
    FieldHelp{"airPressure", REPORT_TEXT("report", "Air pressure"), REPORT_TEXT("report", "At the place of the test and not reduced to sea level: the wavelength of a laser depends on it.")},
    FieldHelp{"airHumidity", REPORT_TEXT("report", "Air humidity"), REPORT_TEXT("report", "Relative humidity at the machine.")},
    FieldHelp{"gradientPerHour", REPORT_TEXT("report", "Temperature gradient"), REPORT_TEXT("report", "Largest change of the air temperature in one hour, in the 12 hours before the test and during it.")},
    FieldHelp{"warmUp", REPORT_TEXT("report", "Warm-up"), REPORT_TEXT("report", "Agreed, the maker's, a dry run, or the movements needed to set up the instrument alone.")},
    FieldHelp{"compensation", REPORT_TEXT("report", "Active compensation"), REPORT_TEXT("report", "Which compensation of the control was on: pitch error, reversal, temperature; or none.")},
    FieldHelp{"otherAxes", REPORT_TEXT("report", "Axes not under test"), REPORT_TEXT("report", "Where the other axes stood: squareness and pitch of the axis move the readings with them.")},
    FieldHelp{"toolOffset", REPORT_TEXT("report", "Offset to the tool reference"), REPORT_TEXT("report", "X, Y, Z from the tool reference to the measuring line. 0 is a statement, empty is none.")},
    FieldHelp{"workpieceOffset", REPORT_TEXT("report", "Offset to the workpiece reference"), REPORT_TEXT("report", "X, Y, Z from the workpiece reference to the measuring line. 0 is a statement, empty is none.")},
    FieldHelp{"complete", REPORT_TEXT("report", "Complete, in working order"), REPORT_TEXT("report", "The machine was completely assembled and in working order; guards may be absent.")},
    FieldHelp{"levelled", REPORT_TEXT("report", "Levelled and aligned"), REPORT_TEXT("report", "Levelling and geometric alignment were done before the test.")},
    FieldHelp{"unloaded", REPORT_TEXT("report", "Unloaded"), REPORT_TEXT("report", "The test was made without workpiece.")},
    FieldHelp{"calibrationDue", REPORT_TEXT("report", "Calibration due"), REPORT_TEXT("report", "The day the calibration ends. A test made after it is noted.")},
    FieldHelp{"scaleElement", REPORT_TEXT("report", "Element of the scale"), REPORT_TEXT("report", "Length of one element of the axis's measuring device; 0: continuous. A long axis has a target in each element, of a continuous one every 250 mm.")},
    FieldHelp{"faces", REPORT_TEXT("report", "Faces of the polygon"), REPORT_TEXT("report", "How many faces the polygon has: as many targets are asked for.")},
    FieldHelp{"continuousDevice", REPORT_TEXT("report", "Continuous measuring device"), REPORT_TEXT("report", "Whether a rotary device with a continuous scale of suitable accuracy was at hand: then three further targets are chosen freely.")},
    FieldHelp{"purpose", REPORT_TEXT("report", "Purpose of the test"), REPORT_TEXT("report", "Acceptance, periodic check, comparison, … The step cycle is no reference for acceptance.")},
    FieldHelp{"role", REPORT_TEXT("report", "As found or as left"), REPORT_TEXT("report", "Before or after an adjustment. The verdict of the report rests on all tests except those as found.")},
    FieldHelp{"load", REPORT_TEXT("report", "Load"), REPORT_TEXT("report", "What was on the machine during the test; none is a statement.")},
    FieldHelp{"instrumentPosition", REPORT_TEXT("report", "Position of the instrument"), REPORT_TEXT("report", "Where the measuring device stood, in words; both offsets complete say it as well.")},
    FieldHelp{"temperatureControlled", REPORT_TEXT("report", "Room temperature can be controlled"), REPORT_TEXT("report", "Where it can, 20 °C are asked for (1988: ± 0.5 °C; the same bound is taken for circles, whose text has none).")},
    FieldHelp{"stabilised", REPORT_TEXT("report", "Thermally stable before the test"), REPORT_TEXT("report", "Machine and instruments were long enough in their environment to be thermally stable.")},
    FieldHelp{"soak", REPORT_TEXT("report", "Soaking time"), REPORT_TEXT("report", "How long machine and instruments stood in their environment before the test: 12 h. Whether that made them stable is declared beside it.")},
    FieldHelp{"shielded", REPORT_TEXT("report", "Shielded from draughts and radiation"), REPORT_TEXT("report", "Machine and instruments were protected from draughts and from radiation, of the sun or of heaters.")},
    FieldHelp{"instrumentCompensation", REPORT_TEXT("report", "Compensation by the instrument"), REPORT_TEXT("report", "Whether the instrument's compensation for the air and the machine's temperature was switched on; nothing is asked of one that has none.")},
    FieldHelp{"gradientHoursBefore", REPORT_TEXT("report", "Gradient: hours before the test"), REPORT_TEXT("report", "How many hours before the test the gradient covers: 12 are asked for.")},
    FieldHelp{"cutOff", REPORT_TEXT("report", "What the evaluated range leaves out"), REPORT_TEXT("report", "Feed-in, feed-out, overshoot: all other points of the path are to be used.")},
    FieldHelp{"referenceLength", REPORT_TEXT("report", "Reference length"), REPORT_TEXT("report", "Whether the reference length of the instrument is calibrated: F and D need it.")},
    FieldHelp{"centring", REPORT_TEXT("report", "Set-up error"), REPORT_TEXT("report", "Standard uncertainty of the centring; of an arc F contains the set-up error.")},
    FieldHelp{"uncertainty", REPORT_TEXT("report", "Measurement uncertainty"), REPORT_TEXT("report", "U beside every result: by a budget, a simulation, or as the laboratory states it.")},
    FieldHelp{"plane", REPORT_TEXT("report", "Plane"), REPORT_TEXT("report", "The two axes that were moved. Sense and angle run from the first towards the second.")},
    FieldHelp{"requiredResults", REPORT_TEXT("report", "Required results"), REPORT_TEXT("report", "The results that supplier and user ask for: G, G(b), F, D. Bi-directional ones need a path of each sense.")},
    FieldHelp{"centre", REPORT_TEXT("report", "Centre of the circle"), REPORT_TEXT("report", "X, Y, Z of the centre in coordinates of the machine.")},
    FieldHelp{"startPoint", REPORT_TEXT("report", "Start point"), REPORT_TEXT("report", "Where the path began, as an angle or an axis.")},
    FieldHelp{"stopPoint", REPORT_TEXT("report", "Stop point"), REPORT_TEXT("report", "Where the path ended.")},
    FieldHelp{"smoothing", REPORT_TEXT("report", "Data smoothing"), REPORT_TEXT("report", "Filters of the instrument or its program that the data went through; or none.")},
    FieldHelp{"recentredBetweenRuns", REPORT_TEXT("report", "Re-centred between the runs"), REPORT_TEXT("report", "Bi-directional results need both paths measured one after the other without re-centring.")},
    FieldHelp{"device", REPORT_TEXT("report", "Instrument"), REPORT_TEXT("report", "As its certificate states it: a fixed part and a part that grows with the length, brought to k = 2. Or the full width of the range its error lies in.")},
    FieldHelp{"misalignmentRange", REPORT_TEXT("report", "Misalignment"), REPORT_TEXT("report", "The largest distance by which the measuring line may have left the axis over the travel, in mm: it enters as a cosine error.")},
    FieldHelp{"temperatureRange", REPORT_TEXT("report", "Range of the temperature"), REPORT_TEXT("report", "The full width in which the mean temperature of machine or instrument is sure to lie: sensors, their places, changes between start and end.")},
    FieldHelp{"expansionRange", REPORT_TEXT("report", "Range of the expansion coefficient"), REPORT_TEXT("report", "The full width in which α is sure to lie. 3.4 µm/(m·°C) gives U(α) = 2 µm/(m·°C), which ISO 230-2 calls the typical minimum.")},
    FieldHelp{"environmentalVariation", REPORT_TEXT("report", "Environmental variation E_VE"), REPORT_TEXT("report", "The largest less the smallest reading of a drift test at rest, over the time of the test. Typed in, or taken from a drift test of the file.")},
    FieldHelp{"length", REPORT_TEXT("report", "Length L"), REPORT_TEXT("report", "What the contributions grow with; empty: the measurement travel.")},
    FieldHelp{"displacement", REPORT_TEXT("report", "Calibration of displacement"), REPORT_TEXT("report", "Expanded uncertainty of the instrument's displacement, from its certificate. A simulation draws one error a trial for all points: F and D move by it, G does not. The budget counts it in G, too.")},
    FieldHelp{"pointNoise", REPORT_TEXT("report", "Noise of a point"), REPORT_TEXT("report", "Standard uncertainty of a single point, from readings at rest. G grows with it and with the number of points.")},
    FieldHelp{"repeatability", REPORT_TEXT("report", "Repeatability"), REPORT_TEXT("report", "Standard uncertainty of the result from repeated circles; empty: from the repetitions of the file. A simulation adds one draw a trial to each result, G among them, and moves no point by it.")},
    FieldHelp{"trials", REPORT_TEXT("report", "Trials"), REPORT_TEXT("report", "How many times the test is evaluated anew with other errors; empty: as many as two digits of the uncertainty need. Fewer than 220 000 are shown and never decide.")},
    FieldHelp{"seed", REPORT_TEXT_FOR("report", "Seed", "of a simulation"), REPORT_TEXT("report", "The same seed gives the same figures, on any computer.")},
    FieldHelp{"expanded", REPORT_TEXT("report", "Expanded uncertainty"), REPORT_TEXT("report", "U of the result with k = 2, as the laboratory determined it.")},
    FieldHelp{"limits", REPORT_TEXT("report", "Limits"), REPORT_TEXT("report", "What was agreed, with the edition it was agreed for and where it stands. Under another edition there is no verdict.")},
    FieldHelp{"decisionRule", REPORT_TEXT("report", "Decision rule"), REPORT_TEXT("report", "How a value near its limit is judged, whose risk the uncertainty is: ISO 14253-1 asks the maker to prove conformity, the other rule asks the user to prove the contrary.")},
    FieldHelp{"guardFactor", REPORT_TEXT("report", "Guard band"), REPORT_TEXT("report", "How many times the expanded uncertainty U the value has to stay away from the limit; 1 as a rule.")},
    FieldHelp{"agreedPoints", REPORT_TEXT("report", "Points to be agreed"), REPORT_TEXT("report", "What the edition leaves to supplier and user. “Not agreed” is printed as it is, “not applicable” asks for nothing.")},
};
// clang-format on

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

Phrase phrase(const Formula &formula) {
    Phrase result;
    for (const FormulaSpan &span : formula.spans)
        result.spans.push_back({span.text, span.subscript, false, false, span.strong});
    return result;
}

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

HelpPage positioningPage(const Edition &edition, const Language &language) {
    HelpPage page{
        QStringLiteral("editions.") + QString::fromUtf8(edition.word), QString::fromUtf8(edition.word), {}};
    auto &blocks = page.content.blocks;
    blocks.emplace_back(Heading{1, page.title});
    if (!edition.title.empty())
        blocks.emplace_back(Paragraph{language.text(edition.title)});
    blocks.emplace_back(Heading{2, language.text(REPORT_TEXT("report", "Parameters of the axis"))});
    Table table = symbolTable(language);
    for (const Row &row : edition.rows)
        table.rows.push_back({Cell(symbolPhrase(row.term.symbol)), Cell(language.text(row.term.name)),
                              Cell(phrase(formulaOf(edition, row, language))), clauseCell(row.term.clause)});
    blocks.emplace_back(std::move(table));
    blocks.emplace_back(Heading{2, language.text(REPORT_TEXT("report", "Quantities at a target"))});
    Table targets = symbolTable(language);
    for (const TargetTerm &term : edition.targetTerms) {
        const auto found = std::ranges::find(targetFormulas, std::string_view(term.id), &TargetFormula::id);
        QString source = found == targetFormulas.end() ? QString() : QString::fromUtf8(found->formula);
        source.replace(QStringLiteral("%c"), language.number(edition.c, Quantity::number));
        source.replace(QStringLiteral("%d"), language.number(2 * edition.c, Quantity::number));
        targets.rows.push_back({Cell(symbolPhrase(term.symbol)), Cell(language.text(term.name)),
                                Cell(phrase(formulaFrom(source))), clauseCell(term.clause)});
    }
    blocks.emplace_back(std::move(targets));
    blocks.emplace_back(Paragraph{language.text(REPORT_TEXT(
        "report", "x_ij is actual position minus target position; i counts targets, j runs; ↑ and ↓ "
                  "are approaches in the positive and the negative direction. A clause that is not "
                  "known is not printed."))});
    return page;
}

HelpPage circularPage(const Edition &edition, const Language &language) {
    HelpPage page{
        QStringLiteral("editions.") + QString::fromUtf8(edition.word), QString::fromUtf8(edition.word), {}};
    auto &blocks = page.content.blocks;
    blocks.emplace_back(Heading{1, page.title});
    if (!edition.title.empty())
        blocks.emplace_back(Paragraph{language.text(edition.title)});
    Table table = symbolTable(language);
    for (const CircularRow &row : edition.circles->rows) {
        const auto found = std::ranges::find_if(circularFormulas, [&](const CircularFormula &formula) {
            return std::string_view(formula.id) == row.term.id;
        });
        Phrase formula;
        if (found != circularFormulas.end()) {
            formula = phrase(formulaFrom(QString::fromUtf8(found->formula)));
            formula.spans.push_back({QStringLiteral("; ") + language.text(found->words)});
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
         REPORT_TEXT("report",
                     "A machine is known by maker and serial number, without case, spaces and punctuation. "
                     "Those without serial number stand apart. With an interval the list says when the next "
                     "test is due; the mark of a certificate counts the days until one expires.")},
        {REPORT_TEXT("report", "Trend"),
         REPORT_TEXT(
             "report",
             "At least four tests since the last intervention make a line, weighted with what their "
             "uncertainties share. “Not before” is the day its upper bound of 95 % reaches the limit: "
             "for the level, not for the next test. Tests of another edition, feed, correction or "
             "travel are another series and never joined.")},
        {REPORT_TEXT("report", "Compare curves"),
         REPORT_TEXT("report",
                     "Several chosen tests of one axis are laid over one another, with the difference of two "
                     "on their common travel.")},
        {REPORT_TEXT("report", "History report"),
         REPORT_TEXT("report",
                     "Prints what is to be watched first, the trends, the campaigns and all tests of a "
                     "machine with their files.")},
    });
    return pageOf("register", REPORT_TEXT("report", "Register"), steps, language);
}

HelpPage fieldsPage(const Language &language) {
    HelpPage page{QStringLiteral("fields"), language.text(REPORT_TEXT("report", "Fields")), {}};
    auto &blocks = page.content.blocks;
    blocks.emplace_back(Heading{1, page.title});
    blocks.emplace_back(Paragraph{language.text(REPORT_TEXT(
        "report", "An empty field means “not stated”; 0 is a statement. Numbers are read with a point or "
                  "a comma. What cannot be read stays in red, and the value before it is kept."))});
    for (const FieldHelp &field : fieldHelps) {
        blocks.emplace_back(Heading{3, language.text(field.name), {}, QString::fromUtf8(field.key)});
        blocks.emplace_back(Paragraph{language.text(field.meaning)});
    }
    return page;
}

} // namespace

std::vector<HelpPage> composeHelp(const Language &language) {
    std::vector<HelpPage> pages{workflowPage(language), registerPage(language), fieldsPage(language)};
    for (const Edition *edition : editions())
        pages.push_back(edition->circles ? circularPage(*edition, language)
                                         : positioningPage(*edition, language));
    for (HelpPage &page : pages)
        page.content.language = language.code();
    return pages;
}

HelpPage composeValidationHelp(const std::vector<SetValidation> &sets, const Language &language) {
    return {QStringLiteral("validation"), language.text(REPORT_TEXT("report", "Validation")),
            composeValidation(sets, language)};
}

QString fieldHelp(std::string_view key, const Language &language) {
    const auto found =
        std::ranges::find_if(fieldHelps, [&](const FieldHelp &field) { return key == field.key; });
    return found == fieldHelps.end() ? QString() : language.text(found->meaning);
}

} // namespace palmer
