// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/parts/comparedtests.h"

#include "figures/differencefigure.h"
#include "figures/testfigures.h"
#include "kernel/evaluation/edition.h"
#include "language/rounding.h"
#include "report/parts/parts.h"
#include "report/tables/diagnosisrows.h"
#include "report/tables/resulttable.h"
#include "report/words/correctiontext.h"
#include "report/words/printednumbers.h"
#include "report/words/wording.h"

#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>

namespace palmer {

namespace {

Text refusalText(NotComparable why) {
    return inOrder(
        why,
        {REPORT_TEXT("report", "The two tests are of different kinds: they are not compared."),
         REPORT_TEXT("report", "The two tests are of different axes or planes: they are not compared."),
         REPORT_TEXT("report", "The two tests were made in different directions: they are not compared."),
         REPORT_TEXT("report", "The two circles differ in radius or signal: they are not compared."),
         REPORT_TEXT("report", "Tests without an edition have no results to be compared."),
         REPORT_TEXT("report",
                     "Both laboratories used the same instrument: its error is in both results, and "
                     "E_n would not see it.")});
}

Text gapText(NoWord why) {
    return inOrder(
        why,
        {REPORT_TEXT("report", "Fewer than 5 common targets: nothing is said of the parameters."),
         REPORT_TEXT("report", "One cycle alone shows no repeatability: nothing is said of a change."),
         REPORT_TEXT("report", "The repeatability of the circles is not known: nothing is said of a change."),
         REPORT_TEXT("report", "No uncertainty is known in both tests: nothing is said of a change.")});
}

Text sharedText(SharedError error) {
    return inOrder(error, {REPORT_TEXT_FOR("report", "the instrument", "shared error"),
                           REPORT_TEXT_FOR("report", "temperature sensors of the machine", "shared error"),
                           REPORT_TEXT_FOR("report", "α of the machine", "shared error"),
                           REPORT_TEXT_FOR("report", "temperature sensors of the instrument", "shared error"),
                           REPORT_TEXT_FOR("report", "α of the instrument", "shared error"),
                           REPORT_TEXT_FOR("report", "misalignment", "shared error")});
}

Table parameterTable(const TestComparison &comparison, const PlacedTest &before, const PlacedTest &after,
                     const Writer &write) {
    const QString unit = write.language().unit(comparison.quantity);
    const auto [first, second] = sideTexts(before, after);
    Table table;
    table.columns = {
        columnOf(QString(), 7.8),
        flexibleColumn(QString(), 40),
        write.column(first, 13.6, Alignment::decimal, unit),
        write.column(second, 13.6, Alignment::decimal, unit),
        write.column(REPORT_TEXT("report", "Difference"), 16, Alignment::decimal, unit),
        columnOf(QStringLiteral("U"), 10, Alignment::decimal, unit),
        columnOf(Phrase({{QStringLiteral("E")}, {QStringLiteral("n"), true}}), 10, Alignment::decimal),
        write.column(REPORT_TEXT("report", "Diff. ± U"), 17),
        write.column(REPORT_TEXT("report", "Statement"), 27)};
    table.columns.front().fitting = true;
    table.columns.back().fitting = true;
    table.columns[7].paddingLeft = 3;
    table.columns[8].paddingLeft = 2; // from the longest whisker
    const std::vector<ComparedWords> words = comparedWords(comparison, write.language());
    const char *family = nullptr;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const ComparedParameter &parameter = comparison.parameters[i];
        if (family && std::string_view(family) != parameter.term.family)
            table.rulesAfter.push_back(table.rows.size() - 1);
        family = parameter.term.family;
        const ComparedWords &row = words[i];
        Cell word(row.word);
        if (parameter.word) {
            word.mark = markOf(*parameter.word);
            word.bold = statesDifference(*parameter.word);
        }
        Cell picture = blankCell();
        if (row.picture) {
            picture.blank = false;
            picture.extras.edit().whisker = row.picture;
        }
        table.rows.push_back({boldCell(row.symbol), nameInTable(write, parameter.term.name), row.before,
                              row.after, boldCell(row.difference), row.uncertainty, row.enRatio, picture,
                              word});
    }
    leaveOutEmptyColumns(table, 5, 8); // without U no picture and no word
    return table;
}

/// For two circles: the sources that both diagnoses value, and the difference of the paths.
void addCircles(std::vector<Block> &blocks, const PlacedTest &before, const PlacedTest &after,
                const Writer &write) {
    constexpr double number = 22; // mm
    const Language &language = write.language();
    if (const auto sources = comparedSources(before, after); !sources.empty()) {
        const auto [first, second] = sideTexts(before, after);
        Table table;
        table.columns = {write.flexible(REPORT_TEXT("report", "Source"), 60),
                         write.column(first, number, Alignment::decimal),
                         write.column(second, number, Alignment::decimal),
                         write.column(REPORT_TEXT("report", "Difference"), number, Alignment::decimal),
                         columnOf(QStringLiteral("U"), number, Alignment::decimal),
                         columnOf(QString(), number)};
        for (const ComparedSource &one : sources) {
            const auto shown = [&](double value) { return shownParameter(one.id, value); };
            const int decimals = decimalsOfEstimate(shown(one.uncertainty) / 2);
            const auto text = [&](double value) {
                return language.number(shown(value), Quantity::number, decimals);
            };
            table.rows.push_back({write.language().sentence(one.name), text(one.before), text(one.after),
                                  boldCell(text(one.after - one.before)), text(one.uncertainty),
                                  QString::fromUtf8(influence(one.id).unit)});
        }
        addHeading(
            blocks, write.text(REPORT_TEXT("report", "Sources that both circles show")),
            write.text(REPORT_TEXT("report", "U: 95 % from both fits; degrees of freedom by JCGM 100, G.4")));
        blocks.emplace_back(std::move(table));
    }
    LineFigure figure = pathDifferenceFigure(comparedPaths(before, after), language);
    if (figure.lines.empty())
        return;
    addHeading(blocks, figure.title,
               write.text(REPORT_TEXT("report", "each about its least squares centre")));
    blocks.emplace_back(FigureBlock{std::move(figure)});
}

QString dateOf(const PlacedTest &placed, const Writer &write) {
    const Test &test = placed.test();
    return joined({dateText(write, test.date), QString::fromStdString(test.time.value_or(""))});
}

QString instrumentsOf(const PlacedTest &placed) {
    QStringList names;
    for (const Instrument &instrument : placed.evaluated->document->instruments) {
        if (std::ranges::find(placed.test().instruments, instrument.id) != placed.test().instruments.end())
            names << joined({QString::fromStdString(instrument.description.empty() ? instrument.model
                                                                                   : instrument.description),
                             QString::fromStdString(instrument.serialNumber),
                             QString::fromStdString(instrument.certificate)});
    }
    return names.join(QStringLiteral("\n"));
}

/// "11", and the first of them that the other test does not have.
QString targetsOf(const PositioningMeasurement &m, const PlacedTest &other, const Writer &write) {
    constexpr qsizetype mostAlone = 4;
    const Quantity quantity = m.axis.motion == Motion::linear ? Quantity::position : Quantity::angle;
    const auto *theirs = std::get_if<PositioningMeasurement>(&other.test().measurement);
    QStringList alone;
    for (const double target : m.targets) {
        const auto isSame = [target](double one) { return std::abs(one - target) <= sameTarget; };
        if (theirs && std::ranges::none_of(theirs->targets, isSame))
            alone << write.language().quantity(target, quantity);
    }
    if (alone.size() > mostAlone)
        alone = alone.mid(0, mostAlone) << QStringLiteral("…");
    const QString count = write.language().number(static_cast<double>(m.targets.size()), Quantity::count, 0);
    return alone.isEmpty() ? count
                           : write.say(REPORT_TEXT("report", "%1, not in the other test: %2"),
                                       {count.toStdString(), alone.join(write.semicolon()).toStdString()});
}

/// How many readings of the runs have no value or are excluded; empty: none.
QString gapsOf(const PositioningMeasurement &m, const Writer &write) {
    std::size_t gaps = m.excluded.size();
    for (const Run &run : m.runs)
        gaps += m.targets.size() - run.deviations.size() +
                static_cast<std::size_t>(
                    std::ranges::count_if(run.deviations, [](const auto &value) { return !value; }));
    return gaps > 0 ? write.language().number(static_cast<double>(gaps), Quantity::count, 0) : QString();
}

bool statesSameUncertainty(const Test &a, const Test &b) {
    return std::visit(
        [](const auto &one, const auto &other) {
            if constexpr (requires { one.uncertainty == other.uncertainty; })
                return one.uncertainty == other.uncertainty;
            else
                return false;
        },
        a.measurement, b.measurement);
}

/// The contributions with another U than in the other test, a line each; a sign if the same is stated.
QString budgetOf(const PlacedTest &placed, const PlacedTest &other, const Writer &write) {
    if (statesSameUncertainty(placed.test(), other.test())) {
        const UncertaintyMethod *method = methodOf(placed.test());
        return method && *method != UncertaintyMethod::none ? QStringLiteral("=") : QString();
    }
    const Quantity quantity = deviationQuantity(placed.test());
    const auto &theirs = other.evaluation().uncertainty.contributions;
    QStringList lines;
    for (const Contribution &one : placed.evaluation().uncertainty.contributions) {
        const auto same = std::ranges::find(theirs, std::string_view(one.id),
                                            [](const Contribution &c) { return std::string_view(c.id); });
        if (same == theirs.end() || same->expanded != one.expanded)
            lines << write.say(REPORT_TEXT("report", "%1: %2"),
                               {contributionName(one, write.language()).toStdString(),
                                one.expanded
                                    ? write.language().quantity(*one.expanded, quantity, 2).toStdString()
                                    : std::string("–")});
    }
    return lines.join(u'\n');
}

/// The other statements on the surroundings: coefficients, air, places of the sensors.
void addSurroundings(LabelledRows &rows, const Conditions &conditions, const Writer &write) {
    QStringList places;
    for (const Sensor &sensor : conditions.sensors)
        places << joined({write.text(sensorText(sensor.measures)), QString::fromStdString(sensor.position)});
    rows.add(REPORT_TEXT("report", "Temperature sensors"), places.join(u'\n'));
    rows.add(REPORT_TEXT("report", "α machine"),
             write.quantity(conditions.expansion.machine, Quantity::expansion));
    rows.add(REPORT_TEXT("report", "α instrument"),
             write.quantity(conditions.expansion.instrument, Quantity::expansion));
}

/// The statements about a test other than its readings, in the order of the report.
std::vector<KeyValue> statedRows(const PlacedTest &placed, const PlacedTest &other, const Writer &write) {
    const Test &test = placed.test();
    const Document &document = *placed.evaluated->document;
    LabelledRows rows(write);
    rows.add(REPORT_TEXT("report", "Test"),
             joined({QString::fromStdString(document.report.number), QString::fromStdString(test.title)}));
    rows.add(REPORT_TEXT("report", "Date of test"), dateOf(placed, write));
    rows.add(REPORT_TEXT("report", "Machine"),
             joined({QString::fromStdString(document.machine.name),
                     QString::fromStdString(document.machine.serialNumber)}));
    rows.add(REPORT_TEXT("report", "Edition"), test.edition);
    rows.add(REPORT_TEXT("report", "Instruments"), instrumentsOf(placed));
    if (const auto *m = std::get_if<PositioningMeasurement>(&test.measurement)) {
        const auto up = std::ranges::count(m->runs, Direction::positive, &Run::approach);
        const auto down = std::ranges::count(m->runs, Direction::negative, &Run::approach);
        rows.add(REPORT_TEXT("report", "Axis travel"),
                 write.quantity(m->axis.travel,
                                m->axis.motion == Motion::linear ? Quantity::position : Quantity::angle));
        rows.add(REPORT_TEXT("report", "Target positions"), targetsOf(*m, other, write));
        rows.add(REPORT_TEXT("report", "Runs"), QStringLiteral("%1 ↑, %2 ↓").arg(up).arg(down));
        rows.add(REPORT_TEXT("report", "Readings without a value"), gapsOf(*m, write));
        if (m->conditions.common.correctionTo20 != CorrectionTo20::notStated)
            rows.add(REPORT_TEXT("report", "Correction to 20 °C"), write.text(correctionText(test)));
        if (m->cycle && placed.evaluation().edition)
            rows.add(REPORT_TEXT("report", "Cycle"),
                     write.text(cycleText(m->cycle, *placed.evaluation().edition)));
    }
    if (const Conditions *conditions = conditionsOf(test))
        addSurroundings(rows, *conditions, write);
    rows.add(REPORT_TEXT("report", "Uncertainty budget"), budgetOf(placed, other, write));
    std::vector<KeyValue> all = rows.take().rows;
    if (placed.evaluation().edition) {
        const TestPart part{write, *placed.evaluated, test, placed.evaluation(), placed.index};
        std::vector<KeyValue> conditions = conditionRows(part).rows;
        if (const auto *circle = std::get_if<CircularMeasurement>(&test.measurement)) {
            const KeyValues own = parameterRows({part, *circle, resultsOf(*circle, placed.evaluation())});
            conditions.insert(conditions.begin(), own.rows.begin(), own.rows.end());
        }
        std::ranges::copy(conditions, std::back_inserter(all));
    }
    for (const SensorMeasures what :
         {SensorMeasures::machine, SensorMeasures::instrument, SensorMeasures::air}) {
        const Conditions *conditions = conditionsOf(test);
        if (!conditions)
            continue;
        const Temperatures of = temperaturesOf(*conditions, what);
        const auto number = [&](std::optional<double> value) {
            return write.quantity(value, Quantity::temperature, temperatureDecimals);
        };
        all.push_back({write.say(REPORT_TEXT("report", "%1: %2"),
                                 {REPORT_TEXT("report", "Temperature"), sensorText(what)}),
                       joined({number(of.start), number(of.end)}, QStringLiteral(" … "))});
    }
    return all;
}

} // namespace

Text changeText(ChangeWord word) {
    return inOrder(
        word, {REPORT_TEXT("report", "no change proven"), REPORT_TEXT_FOR("report", "changed", "a value"),
               REPORT_TEXT("report", "changed, better"), REPORT_TEXT("report", "changed, worse"),
               REPORT_TEXT("report", "unchanged within t"), REPORT_TEXT("report", "changed by more than t"),
               REPORT_TEXT("report", "not proven"), REPORT_TEXT("report", "the results agree"),
               REPORT_TEXT("report", "the results disagree")});
}

Mark markOf(ChangeWord word) {
    return inOrder(word, {Mark::openCircle, Mark::warning, Mark::check, Mark::cross, Mark::check, Mark::cross,
                          Mark::openCircle, Mark::check, Mark::cross});
}

bool statesDifference(ChangeWord word) {
    return inOrder(word, {false, true, true, true, false, true, false, false, true});
}

std::optional<ChangeWord> wordOfAll(const TestComparison &comparison) {
    const auto says = [&](ChangeWord word) {
        return std::ranges::any_of(comparison.parameters,
                                   [&](const ComparedParameter &p) { return p.word == word; });
    };
    const bool better = says(ChangeWord::better);
    const bool worse = says(ChangeWord::worse);
    if (better && worse)
        return ChangeWord::changed;
    // One parameter decides for the whole test; the weaker statements only if all make them.
    for (const ChangeWord word :
         {ChangeWord::better, ChangeWord::worse, ChangeWord::changed, ChangeWord::changedByMore,
          ChangeWord::disagree, ChangeWord::notProven, ChangeWord::noChangeProven,
          ChangeWord::unchangedWithin, ChangeWord::agree}) {
        if (says(word))
            return word;
    }
    return std::nullopt;
}

namespace {

/// The parameters with a word that states no difference.
struct WordShare {
    ChangeWord word;
    QStringList symbols;
};

/// The shares, the strongest statement first.
std::vector<WordShare> sharesWithoutDifference(const TestComparison &comparison) {
    std::vector<WordShare> shares;
    for (const ChangeWord word : {ChangeWord::unchangedWithin, ChangeWord::agree, ChangeWord::noChangeProven,
                                  ChangeWord::notProven}) {
        WordShare share{word, {}};
        for (const ComparedParameter &parameter : comparison.parameters) {
            if (parameter.word == word)
                share.symbols << symbolPhrase(parameter.term.symbol, parameter.index).plain();
        }
        if (!share.symbols.isEmpty())
            shares.push_back(std::move(share));
    }
    return shares;
}

/// The short word for a share.
Text briefWord(ChangeWord word) {
    if (word == ChangeWord::agree)
        return REPORT_TEXT("report", "agreeing");
    return changeText(word == ChangeWord::noChangeProven ? ChangeWord::notProven : word);
}

} // namespace

VerdictLine decisionLine(const TestComparison &comparison, const Language &language) {
    const Writer write(language);
    VerdictLine line;
    const auto word = wordOfAll(comparison);
    if (!word)
        return line;
    line.interprets = true;
    line.mark = markOf(*word);
    line.label = write.text(REPORT_TEXT_FOR("report", "Decision", "on two tests"));
    static const QRegularExpression symbol(QStringLiteral("\\bT\\b")); // of the tolerance: stays small
    line.word = write.text(changeText(*word)).toUpper().replace(symbol, QStringLiteral("t"));
    const std::vector<ComparedWords> words = comparedWords(comparison, language);
    std::size_t said = 0;
    std::size_t changed = 0;
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto &own = comparison.parameters[i].word;
        said += own ? 1 : 0;
        if (own && statesDifference(*own)) {
            ++changed;
            first = first.value_or(i);
        }
    }
    const auto share = [&](std::size_t count) {
        return write.say(REPORT_TEXT_FOR("report", "%1 of %2", "parameters that changed"),
                         {wholeNumber(count), wholeNumber(said)});
    };
    const bool ofLaboratories = std::ranges::any_of(
        comparison.parameters, [](const ComparedParameter &p) { return p.enRatio.has_value(); });
    line.limits.label =
        write.text(ofLaboratories ? REPORT_TEXT("report", "Different") : REPORT_TEXT("report", "Changed"));
    line.limits.state = share(changed);
    if (first) {
        const ComparedWords &shown = words[*first];
        line.limits.text =
            write.say(REPORT_TEXT("report", "%1: %2 → %3, difference %4 ± %5"),
                      {shown.symbol.plain().toStdString(), shown.before.toStdString(),
                       shown.after.toStdString(), shown.difference.toStdString(),
                       (shown.uncertainty + u' ' + language.unit(comparison.quantity)).toStdString()});
    }
    QStringList further;
    for (const WordShare &each : sharesWithoutDifference(comparison)) {
        const QString symbols = each.symbols.join(QStringLiteral(", "));
        QString label = write.text(briefWord(each.word));
        const QString state = share(static_cast<std::size_t>(each.symbols.size()));
        if (line.accordance.label.isEmpty()) {
            label[0] = label[0].toUpper();
            line.accordance = {label, Mark::none, state, symbols};
        } else {
            further << write.say(REPORT_TEXT("report", "%1: %2"),
                                 {(label + u' ' + state).toStdString(), symbols.toStdString()});
        }
    }
    if (!further.isEmpty())
        line.accordance.text =
            QStringList{line.accordance.text.plain(), further.join(write.semicolon())}.join(
                write.semicolon());
    return line;
}

std::pair<Text, Text> sideTexts(const PlacedTest &before, const PlacedTest &after) {
    const Text first = roleText(before.test().role);
    const Text second = roleText(after.test().role);
    if (before.test().role == after.test().role || first.empty() || second.empty())
        return {REPORT_TEXT_FOR("report", "before", "of two tests"),
                REPORT_TEXT_FOR("report", "after", "of two tests")};
    return {first, second};
}

std::vector<ComparedWords> comparedWords(const TestComparison &comparison, const Language &language) {
    const double scale = unitScale(comparison.quantity, language.units());
    Whisker axis{0, 0, 0, 0, false};
    for (const ComparedParameter &p : comparison.parameters) {
        const double half = p.uncertainty.value_or(0);
        axis.from = std::min(axis.from, p.difference - half);
        axis.to = std::max(axis.to, p.difference + half);
    }
    std::vector<ComparedWords> all;
    for (const ComparedParameter &parameter : comparison.parameters) {
        const double shown = parameter.uncertainty.value_or(0) * scale;
        int decimals = 1;
        if (shown > 0 && shown < 1)
            decimals = std::min(3, 1 - static_cast<int>(std::floor(std::log10(shown))));
        const auto number = [&](double value) {
            return language.number(value, comparison.quantity, decimals);
        };
        ComparedWords words;
        words.symbol = symbolPhrase(parameter.term.symbol, parameter.index);
        words.name = language.text(parameter.term.name);
        words.before = number(parameter.before);
        words.after = number(parameter.after);
        words.difference = number(parameter.difference);
        if (parameter.uncertainty) {
            words.uncertainty = number(*parameter.uncertainty);
            words.picture = axis;
            words.picture->value = parameter.difference;
            words.picture->half = *parameter.uncertainty;
            words.picture->open = !parameter.word || !statesDifference(*parameter.word);
        }
        if (parameter.repeatabilityAlone)
            words.repeatability = number(*parameter.repeatabilityAlone);
        if (parameter.errorsAlone)
            words.errors = number(*parameter.errorsAlone);
        if (parameter.shift)
            words.shift = number(*parameter.shift);
        if (parameter.enRatio)
            words.enRatio = language.number(*parameter.enRatio, Quantity::number, 2);
        if (parameter.word)
            words.word = language.text(changeText(*parameter.word));
        all.push_back(std::move(words));
    }
    return all;
}

ComparedConditions compareConditions(const PlacedTest &before, const PlacedTest &after,
                                     const Language &language) {
    const Writer write(language);
    const std::vector<KeyValue> was = statedRows(before, after, write);
    const std::vector<KeyValue> is = statedRows(after, before, write);
    ComparedConditions result;
    // Some names stand twice, as that of the machine and that of its temperature.
    std::vector<bool> seen(was.size());
    for (const KeyValue &row : is) {
        std::size_t i = 0;
        while (i < was.size() && (seen[i] || was[i].key != row.key))
            ++i;
        const QString former = i < was.size() ? was[i].value : QString();
        if (i < was.size())
            seen[i] = true;
        if (former != row.value)
            result.differing.push_back({row.key, former, row.value});
        else if (!row.value.isEmpty() && !result.alike.contains(row.key))
            result.alike << row.key;
    }
    for (std::size_t i = 0; i < was.size(); ++i) {
        if (!seen[i] && !was[i].value.isEmpty())
            result.differing.push_back({was[i].key, was[i].value, {}});
    }
    return result;
}

QString reasonOf(const TestComparison &comparison, const Language &language) {
    if (comparison.refusal)
        return language.text(refusalText(*comparison.refusal));
    return comparison.noWord ? language.text(gapText(*comparison.noWord)) : QString();
}

namespace {

constexpr Text changedBeyondU =
    REPORT_TEXT("report", "“Changed” where the difference exceeds its U, always between these two sessions.");

Text meaningOfWords(const TestComparison &comparison) {
    const auto says = [&](auto predicate) { return std::ranges::any_of(comparison.parameters, predicate); };
    if (says([](const ComparedParameter &p) { return p.enRatio.has_value(); }))
        return REPORT_TEXT("report",
                           "E_n (ISO/IEC 17043): difference over its U; the results agree where its "
                           "magnitude is at most 1.");
    constexpr std::array ofTolerance{ChangeWord::unchangedWithin, ChangeWord::changedByMore,
                                     ChangeWord::notProven};
    if (says([&](const ComparedParameter &p) {
            return p.word && std::ranges::find(ofTolerance, *p.word) != ofTolerance.end();
        }))
        return REPORT_TEXT("report",
                           "Unchanged within t where difference and U together are at most t; changed "
                           "by more than t where the difference less U exceeds it; always between "
                           "these two sessions.");
    return changedBeyondU;
}

/// The parts of U, each alone; empty without a simulation.
QString partsOfUncertainty(const TestComparison &comparison, const Writer &write) {
    QStringList parts;
    const std::vector<ComparedWords> words = comparedWords(comparison, write.language());
    for (std::size_t i = 0; i < words.size(); ++i) {
        const ComparedParameter &parameter = comparison.parameters[i];
        if (parameter.repeatabilityAlone)
            parts << joined({words[i].symbol.plain() + QChar(QChar::Nbsp) + words[i].repeatability,
                             words[i].errors, words[i].shift},
                            write.semicolon());
    }
    if (parts.isEmpty())
        return {};
    const std::string unit = write.language().unit(comparison.quantity).toStdString();
    return write.say(comparison.simulated
                         ? REPORT_TEXT("report", "Parts of U (%1), each alone: repeatability; errors of "
                                                 "measurement; shift of the mean, which decides nothing: %2.")
                         : REPORT_TEXT("report", "Repeatability alone (%1): %2."),
                     {unit, parts.join(QStringLiteral(" · ")).toStdString()});
}

} // namespace

QStringList methodSentences(const TestComparison &comparison, const Language &language) {
    const Writer write(language);
    const bool ofCircles = comparison.edition && comparison.edition->circles;
    QStringList sentences;
    if (comparison.simulated) {
        QStringList shared;
        for (const SharedError error : comparison.shared)
            shared << write.text(sharedText(error));
        sentences << write.say(REPORT_TEXT("report",
                                           "U of the difference: one simulation of both tests (JCGM 101), %1 "
                                           "trials, 95.45 %. Whole cycles are drawn anew, a method of this "
                                           "program: residuals widened by half of Student’s t of 2n − 2 "
                                           "degrees of freedom; band of the curves by Bonferroni."),
                               {wholeNumber(comparison.trials)});
        sentences << (shared.isEmpty()
                          ? write.text(
                                REPORT_TEXT("report", "No error of measurement is known to be shared."))
                          : write.say(REPORT_TEXT("report",
                                                  "Shared by both tests: %1; all other errors are those of "
                                                  "each."),
                                      shared.join(QStringLiteral(", "))));
    } else if (!comparison.noWord && !comparison.refusal) {
        sentences << write.text(
            ofCircles
                ? REPORT_TEXT("report",
                              "U of the difference: root of the sum of the squares of both U, each with "
                              "its repeatability (JCGM 100); nothing shared is known.")
                : REPORT_TEXT("report", "U of the difference: root of the sum of the squares of both U "
                                        "and of the repeatability (JCGM 100); nothing shared is known."));
    }
    if (!comparison.noWord && !comparison.refusal) {
        const Text meaning = meaningOfWords(comparison);
        sentences << write.text(meaning);
        if (meaning == changedBeyondU && !ofCircles)
            sentences << write.text(REPORT_TEXT("report",
                                                "Of simulated pairs without a change, up to 12 % show one of "
                                                "A, E, M, R and B changed."));
    }
    if (const QString parts = partsOfUncertainty(comparison, write); !parts.isEmpty())
        sentences << parts;
    return sentences;
}

std::vector<Block> comparisonBlocks(const TestComparison &comparison, const PlacedTest &before,
                                    const PlacedTest &after, const Language &language,
                                    std::optional<double> tolerance) {
    const Writer write(language);
    std::vector<Block> blocks;
    const auto [first, second] = sideTexts(before, after);
    const ComparedConditions conditions = compareConditions(before, after, language);
    if (precedes(after.test(), before.test()))
        blocks.emplace_back(Paragraph{write.text(
            REPORT_TEXT("report", "By what is stated, the second test was made before the first."))});
    if (!conditions.differing.empty()) {
        constexpr double nameWidth = 45;
        addHeading(blocks, write.text(REPORT_TEXT("report", "Differences of the conditions")),
                   write.text(REPORT_TEXT("report", "everything else is stated alike in both tests")));
        Table table;
        table.columns = {write.column(REPORT_TEXT_FOR("report", "Condition", "of a test"), nameWidth),
                         write.flexible(first, 60), write.flexible(second, 60)};
        for (const DifferingCondition &row : conditions.differing)
            table.rows.push_back({row.name, row.before, row.after});
        blocks.emplace_back(std::move(table));
        if (!conditions.alike.isEmpty())
            blocks.emplace_back(Paragraph{
                write.say(REPORT_TEXT("report", "Alike: %1."), conditions.alike.join(QStringLiteral(", "))),
                TextSize::small});
    }
    if (tolerance && *tolerance > 0)
        blocks.emplace_back(Paragraph{write.say(REPORT_TEXT("report", "Agreed tolerance t of a change: %1."),
                                                {Number{*tolerance, comparison.quantity, -1}})});
    if (comparison.refusal) {
        blocks.emplace_back(Paragraph{reasonOf(comparison, language)});
        return blocks;
    }
    QStringList notes;
    if (comparison.cycles > 0) {
        notes << write.say(comparison.cycles == 1
                               ? REPORT_TEXT("report", "%1 common targets; the first cycle of each test")
                               : REPORT_TEXT("report", "%1 common targets; the first %2 cycles of each test"),
                           {wholeNumber(comparison.commonTargets), wholeNumber(comparison.cycles)});
    }
    if (!comparison.parameters.empty()) {
        addHeading(blocks, write.text(REPORT_TEXT("report", "Differences of the parameters")),
                   notes.join(write.semicolon()));
        blocks.emplace_back(parameterTable(comparison, before, after, write));
    }
    if (comparison.noWord)
        blocks.emplace_back(Paragraph{reasonOf(comparison, language)});
    if (const QStringList sentences = methodSentences(comparison, language); !sentences.isEmpty())
        blocks.emplace_back(Paragraph{sentences.join(u' '), TextSize::small});
    addCircles(blocks, before, after, write);
    CurveFigure figure = differenceFigure(comparison, language);
    if (!figure.curves.empty()) {
        addHeading(blocks, figure.title,
                   comparison.interpolated
                       ? write.text(REPORT_TEXT("report",
                                                "between targets of the first test: linear; less the mean of "
                                                "all"))
                       : write.text(REPORT_TEXT("report", "at the common targets, less the mean of all")));
        FigureBlock block{std::move(figure)};
        block.least = 45; // all of a comparison is read on one page
        blocks.emplace_back(std::move(block));
    }
    return blocks;
}

Report composeComparison(const TestComparison &comparison, const PlacedTest &before, const PlacedTest &after,
                         const Language &language, std::optional<double> tolerance) {
    const Writer write(language);
    Report report;
    report.language = language.code();
    // A terminal shows no notes next to headings.
    const auto add = [&](Block block) {
        const auto *heading = std::get_if<Heading>(&block);
        const QString note = heading ? heading->note.plain() : QString();
        report.blocks.push_back(std::move(block));
        if (!note.isEmpty())
            report.blocks.emplace_back(Paragraph{note, TextSize::small});
    };
    add(Heading{1, write.text(REPORT_TEXT("report", "Comparison of two tests")),
                joined({testName(write, after.test()),
                        QString::fromUtf8(comparison.edition ? comparison.edition->word : "")},
                       QStringLiteral(" · "))});
    add(Paragraph{write.text(comparisonNature()), TextSize::small});
    if (VerdictLine line = decisionLine(comparison, language); !line.word.isEmpty())
        add(std::move(line));
    for (Block &block : comparisonBlocks(comparison, before, after, language, tolerance))
        add(std::move(block));
    return report;
}

Text comparisonNature() {
    return REPORT_TEXT("report", "Difference of two results of the standard; the comparison itself is "
                                 "an interpretation, not a result of it.");
}

} // namespace palmer
