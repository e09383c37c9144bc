// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/diagnosis/diagnosis.h"
#include "language/language.h"
#include "report/blocks/report.h"
#include "report/parts/testpart.h"

namespace palmer {

// The sections of a report in the order of its pages; the sources are named after them.

/// The title of the report: its own, or "Acceptance test report" (composeReport gives those of other purposes
/// "Test report").
[[nodiscard]] QString reportTitle(const Writer &write, const ReportHead &head);

/// Running head of the pages of a test.
[[nodiscard]] RunningHead runningHead(const TestPart &part);

/// The head of a positioning test.
[[nodiscard]] TestHead positioningHead(const PositioningPart &part);

/// The head of a circular test.
[[nodiscard]] TestHead circularHead(const CircularPart &part);

/// The head of the annex, and the running head of its pages.
[[nodiscard]] TestHead annexHead(const std::vector<TestPart> &parts, const QString &anchor);
[[nodiscard]] RunningHead annexRunningHead(const std::vector<TestPart> &parts);

/// The head of a report whose tests have no pages of their own.
[[nodiscard]] TestHead driftHead(const Writer &write, const Document &document);

/// The head of the first page of a report over several tests.
[[nodiscard]] TestHead summaryHead(const std::vector<TestPart> &parts);

/// The head of the acceptance sheet.
[[nodiscard]] TestHead sheetHead(const Writer &write, const EvaluatedDocument &evaluated,
                                 const std::vector<TestPart> &parts);

/// "met", "not measured".
[[nodiscard]] Text sheetStateText(SheetState state);

/// The guard picture of a row; blank without a verdict, or if a range is permitted.
[[nodiscard]] Cell sheetPicture(const SheetResult &result);

/// The printed value of a row of a sheet: its own numbers as entered, those of a result as in its test.
struct SheetWords {
    QString permitted;
    QString value;
    QString uncertainty;
    QString unit;
    QString source; ///< "test 2, A"; empty for own numbers
    QString state;
    QString reason; ///< why nothing is proven, unless the numbers say it
};
[[nodiscard]] SheetWords sheetWords(const EvaluatedDocument &evaluated, const std::vector<TestPart> &parts,
                                    const SheetResult &result, std::size_t index, const Writer &write);

/// The rows of the acceptance sheet; column 7 holds the guard pictures.
[[nodiscard]] Table sheetTable(const EvaluatedDocument &evaluated, const std::vector<TestPart> &parts,
                               const Writer &write);

/// The head of the page that compares a test with another one.
[[nodiscard]] TestHead comparisonHead(const TestPart &after, const TestPart &before);

/// The head of the page of a drift test.
[[nodiscard]] TestHead thermalHead(const Writer &write, const EvaluatedDocument &evaluated, std::size_t test);

/// "16 of 18 rows met", and which are not.
[[nodiscard]] VerdictStatement sheetStatement(const EvaluatedDocument &evaluated, const Writer &write);

/// Adds the findings about rows that name no result of this report.
void addSheetFindings(std::vector<Block> &blocks, const EvaluatedDocument &evaluated, const Writer &write);

/// Adds the acceptance sheet as the first page: the verdict of the report in its two parts, sheet and tests,
/// all rows, the rule, responsibility.
void addSheet(std::vector<Block> &blocks, const EvaluatedDocument &evaluated,
              const std::vector<TestPart> &parts, const Writer &write);

/// The same for a terminal, after the tests; nothing without a sheet.
void addSheetResults(std::vector<Block> &blocks, const EvaluatedDocument &evaluated, const Writer &write);

/// The verdict on several tests: limits and accordance.
[[nodiscard]] VerdictLine verdictOfTests(const std::vector<TestPart> &parts);

/// The large word of a verdict, and a second line if the limits are respected but facts of the test are
/// unknown.
struct LargeWord {
    Text word;
    Text second = {}; ///< may be empty
};

/// "Conforms" etc. require that all requirements were read, declared and met. Otherwise the word only
/// concerns the limits, and with an unmet requirement there is no verdict on respected limits.
[[nodiscard]] LargeWord largeWord(std::optional<Verdict> verdict, bool anyLimit, Accordance accordance);

/// The mark next to the large word; may be none.
[[nodiscard]] Mark largeMark(std::optional<Verdict> verdict, Accordance accordance);

/// The guard picture of a result; blank without verdict, or if the limit is not positive.
[[nodiscard]] Cell guardCell(const Parameter &parameter);

/// "met", "exceeded" with its mark; a missing value without verdict.
[[nodiscard]] Cell verdictCell(const Writer &write, const Parameter &parameter);

/// "ISO 14253-1, conformity has to be proven", with the guard band unless it is U.
[[nodiscard]] QString ruleInShort(const TestPart &part);

/// Adds the figure of a positioning test with its heading.
void addFigure(std::vector<Block> &blocks, const PositioningPart &part);

/// Adds the verdict line, with the result that decides it.
void addVerdict(std::vector<Block> &blocks, const TestPart &part);

/// Adds results, those with a limit first, with guard pictures, verdicts and their legend.
void addResults(std::vector<Block> &blocks, const PositioningPart &part);
void addResults(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the findings of the text of the edition in order of grade, unless the report leaves them out.
void addFindings(std::vector<Block> &blocks, const TestPart &part);

/// Adds those of practice, laboratory and program.
void addFurtherFindings(std::vector<Block> &blocks, const TestPart &part);

/// A name of the standard without its ending "of an axis", which a heading states, unless a single word would
/// be left; with a capital.
[[nodiscard]] QString nameInTable(const Writer &write, const Text &name);

/// "U: expanded uncertainty, k = 2, …": the coverage of U and where it comes from; empty without U.
[[nodiscard]] QString uncertaintySentence(const TestPart &part);

/// The decision rule of a test in words, with its guard factor.
[[nodiscard]] QString decisionText(const TestPart &part);

/// The limits with their sources; may have no rows.
[[nodiscard]] Table limitsTable(const TestPart &part);

/// Adds these and the decision rule in words.
void addLimits(std::vector<Block> &blocks, const TestPart &part);

/// The conditions stated by a test, one row each; missing values are empty.
[[nodiscard]] KeyValues conditionRows(const TestPart &part);

/// Removes the rows without a value; returns their labels, joined.
[[nodiscard]] QString takeMissing(KeyValues &rows, const Writer &write);

/// Temperatures of a kind of sensor: the mean of all of them, null unless each has a value.
struct Temperatures {
    std::optional<double> start;
    std::optional<double> end;
};
[[nodiscard]] Temperatures temperaturesOf(const Conditions &conditions, SensorMeasures what);

/// "Machine", "Instrument", "Air".
[[nodiscard]] Text sensorText(SensorMeasures what);

/// True if temperatures matter for the test or are stated.
[[nodiscard]] bool statesTemperatures(const TestPart &part);

/// The correction to 20 °C in words; empty if it cannot be required.
[[nodiscard]] QString correctionOf(const TestPart &part);

/// The sensors with their positions; null if the environment table already shows everything.
[[nodiscard]] std::optional<Table> sensorTable(const TestPart &part);

/// Adds the temperatures over time if a sensor has a series and the curve is wanted.
void addTemperatureCurve(std::vector<Block> &blocks, const TestPart &part);

/// The points to be agreed, with the agreement, its parties and its clause.
struct AgreedPoints {
    QString note;
    Table table;
    std::size_t keys = 1; ///< columns that identify the point
};
/// Null if the edition has none.
[[nodiscard]] std::optional<AgreedPoints> agreedPointsOf(const TestPart &part);

/// Adds the test conditions with the environment and the temperature sensors.
void addConditions(std::vector<Block> &blocks, const PositioningPart &part);

/// The same for a circular test, without the parameters printed next to its figure.
void addConditions(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the conditions that neither edition nor practice ask for, which a certificate with an annex leaves
/// out.
void addFurtherConditions(std::vector<Block> &blocks, const TestPart &part);

/// Adds the points to be agreed between supplier/manufacturer and user, each with its state.
void addAgreedPoints(std::vector<Block> &blocks, const TestPart &part);

/// Adds the correction to 20 °C if it was to be made here, and its value at each target. Linear axes only; in
/// all other cases the conditions state it.
void addCorrection(std::vector<Block> &blocks, const PositioningPart &part);

/// The same for F and D, with C and its inputs; nothing if neither is required.
void addCorrection(std::vector<Block> &blocks, const CircularPart &part);

/// "X 0; Y –; Z 150"; empty if nothing is stated.
[[nodiscard]] QString pointText(const Writer &write, const Point3 &point);

/// True if the budget of a test is used, and therefore shown.
[[nodiscard]] bool usesBudget(const TestEvaluation &evaluation);

/// Adds an uncertainty budget as a table sorted by size, with shares and bars, then the U of each result by
/// the budget and by Monte Carlo, which of them decides, and what to improve first. Nothing if the method
/// needs no budget.
void addBudget(std::vector<Block> &blocks, const TestPart &part);

/// Sentences below the U of both methods, in window and report: how each was determined, which decides, and
/// where they differ. Only the numbers if the methods were explained for the test `before`.
[[nodiscard]] QString methodText(const TestPart &part, std::optional<int> before = {});

/// Statistics per target, one row each; values that rule a parameter of the axis are bold. `mayBePacked`:
/// more than 2 000 rows are.
[[nodiscard]] Table targetTable(const PositioningPart &part, bool mayBePacked = false);

/// Adds the statistics per target, with ruling values bold, and all readings as entered: in the same table if
/// they fit, otherwise below it with both directions side by side, or ↑ above ↓ if these would be too narrow
/// (more than seven runs per direction); many runs in several tables.
void addTargetsAndReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// Estimates the pages of rows that "all readings" adds to the report; 0: none.
[[nodiscard]] int pagesOfAllReadings(const Document &document);

/// Adds the excluded readings, each with its reason.
void addExcludedReadings(std::vector<Block> &blocks, const PositioningPart &part);

/// Results under the requested editions, side by side, without verdict; null if none is requested. The first
/// column contains the symbols, with the unit below its title. `narrow`: factors are printed as "c = 2".
[[nodiscard]] std::optional<Table> editionsTable(const TestPart &part, bool narrow = false);
/// Why values differ between editions: by the factor of s, or, with the same factor, by what the editions
/// define; may be empty.
[[nodiscard]] QString reasonsOfDifferences(const TestPart &part);

/// Adds this table.
void addEditions(std::vector<Block> &blocks, const TestPart &part);

void addRemarks(std::vector<Block> &blocks, const TestPart &part, const QString &remarks);

/// Adds the files the measurement came from, with the results stated by their programs.
void addImports(std::vector<Block> &blocks, const TestPart &part);

/// The parameters of a circular test (4.4), as they stand next to its figure.
[[nodiscard]] KeyValues parameterRows(const CircularPart &part);

/// Adds the figure of a circular test with the test parameters next to it (4.4): both senses in one, or the
/// first of the three figures of the standard.
void addActualPaths(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the other figures of the standard, each with the circle it is drawn about; none if the report
/// combines them.
void addSeparateFigures(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the measured and evaluated range of each path and its duration.
void addPaths(std::vector<Block> &blocks, const CircularPart &part);

/// Adds the reference circles with their certificates.
void addCircles(std::vector<Block> &blocks, const CircularPart &part);

/// Adds G of the further arcs of each sense next to that of the first, if the report includes them.
void addRepetitions(std::vector<Block> &blocks, const CircularPart &part);

/// "+10.1": centres need their sign.
[[nodiscard]] QString signedNumber(const Writer &write, double value, Quantity quantity, int decimals);

/// "X −14.9; Y +10.1 µm".
[[nodiscard]] QString centreText(const CircularPart &part, Point centre, int decimals);

/// The diagnosis of a circle as text: heading that declares it an interpretation and no result of the
/// standard, quality of the separation, the sources with value, u, part of G(b) and meaning, remarks. Empty
/// if the circle gives no diagnosis.
[[nodiscard]] std::vector<Block> diagnosisParts(const Diagnosis &diagnosis, const Language &language);

/// Adds the diagnosis page of a report with figures: measured and synthetic path, the sources with advice for
/// the machine, the residual. The last of several tests of a plane at different feeds is followed by a page
/// of the joint diagnosis. Nothing unless the report includes it.
void addDiagnosis(std::vector<Block> &blocks, const CircularPart &part);

// Merged sections of a report over several tests: a statement made by several tests is printed once, with
// their numbers.

/// "1, 3 – 5"; "all" if all `count` tests are listed. `numbers` must be ascending.
[[nodiscard]] QString testNumbers(const Writer &write, const std::vector<int> &numbers, int count);

/// Adds the conditions of all tests, their environment and sensors.
void addConditionsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the paths of the circular tests and their corrections to 20 °C.
void addPathsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the points to be agreed, grouped by edition.
void addAgreedPointsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the limits with their sources, and the decision rules in words.
void addLimitsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the results of tests as found and as left, with the same axis or plane and edition, side by side.
void addBeforeAndAfter(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds a page per test that states what it is compared with: the decision, differing conditions, parameters
/// and mean deviations.
void addStatedComparisons(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the remarks of the report and of its tests.
void addRemarksOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the results under the requested editions, with as many tests side by side as fit.
void addComparisonsOfTests(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Adds the first page of a report over several tests: the overall verdict, and every quantity with a limit,
/// test by test. Tests as found are only informative if there are others.
void addSummary(std::vector<Block> &blocks, const std::vector<TestPart> &parts);

/// Axis, measurement travel, working zone, cycle and targets, as in the head of a test.
[[nodiscard]] KeyValues axisRows(const PositioningPart &part);

/// "control …, year …, <place of the machine>", as far as stated.
[[nodiscard]] QString machineDetails(const Writer &write, const Machine &machine);

/// "calibrated by …, certificate …, <day>, traceable to …, accreditation …, certificate …", as far as stated.
[[nodiscard]] QString traceabilityText(const Writer &write, const Instrument &instrument);

/// Adds the instruments of all tests with their traceability.
void addTraceability(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// Adds a page per drift test with several channels or temperatures.
void addThermalPages(std::vector<Block> &blocks, const EvaluatedDocument &evaluated, const Writer &write);

/// Adds the drift tests of the file with their ranges.
void addDriftTests(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated);

/// Adds statements: short ones in two columns, long ones below.
void addStated(std::vector<Block> &blocks, const std::vector<KeyValue> &rows);

/// Adds the statements that ISO/IEC 17025, 7.8 requires, with the signatures unless they are left out;
/// without an annex first what addProgram() says.
void addStatements(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated,
                   const Making &making, const QString &fingerprint, const QString &foreign, int level);

/// Adds the program, the full fingerprint and how U was evaluated; `foreign`: characters of the report that
/// its font lacks. `level` of the heading: 1 if the sections above belong to a test.
void addProgram(std::vector<Block> &blocks, const Writer &write, const EvaluatedDocument &evaluated,
                const Making &making, const QString &fingerprint, const QString &foreign, int level);

/// States what the results relate to, and that the report is reproduced only in full.
[[nodiscard]] QString scopeText(const Writer &write);

/// States the coverage of all U, and how they were evaluated; empty unless a budget or simulation of this
/// program gave one.
[[nodiscard]] QString coverageText(const Writer &write, const EvaluatedDocument &evaluated);

/// Adds the person responsible for the report: name, date and signature on one line.
void addResponsibility(std::vector<Block> &blocks, const Writer &write, const ReportHead &head);

} // namespace palmer
