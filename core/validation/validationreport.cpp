// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/validationreport.h"

#include "document/filewords.h"
#include "document/json.h"
#include "document/jsonformats.h"
#include "document/sha256.h"
#include "language/units.h"
#include "system/process.h"

#include <QCoreApplication>
#include <QDate>
#include <QFile>
#include <QRegularExpression>
#include <QSysInfo>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace palmer {

namespace {

constexpr int digitsOfDifference = 2;
constexpr int digitsShown = 12;
constexpr double labelWidth = 42; ///< mm

Text sourceText(ExpectationSource source) {
    return inOrder(source, {REPORT_TEXT("report", "published"), REPORT_TEXT("report", "recomputed"),
                            REPORT_TEXT("report", "exact"), REPORT_TEXT("report", "certified"),
                            REPORT_TEXT("report", "second implementation")});
}

/// It has no unit.
bool isStudentsT(const Expectation &expected) {
    return expected.what == Expected::drift && expected.id == "t";
}

/// Names the method that is compared.
Text methodText(const Expectation &expected) {
    if (isStudentsT(expected))
        return REPORT_TEXT("report", "t of the progression of the runs");
    if (expected.what != Expected::parameter || expected.of.empty())
        return inOrder(
            expected.what,
            {REPORT_TEXT("report", "Results"), REPORT_TEXT("report", "Values per target"),
             REPORT_TEXT("report", "Contributions to the budget"),
             REPORT_TEXT("report", "E_VE, progression of the runs"),
             REPORT_TEXT("report", "Correction C to 20 °C"), REPORT_TEXT("report", "Diagnosis"),
             REPORT_TEXT("report", "Comparison of two tests"), REPORT_TEXT("report", "Compensation"),
             REPORT_TEXT("report", "Trend"), REPORT_TEXT("report", "Contouring feed"),
             REPORT_TEXT("report", "Reference circles"), REPORT_TEXT("report", "Acceptance sheet"),
             REPORT_TEXT("report", "Response to the temperature"), REPORT_TEXT("report", "Type test")});
    struct Row {
        std::string_view of;
        Text text;
    };
    static constexpr std::array rows{
        Row{"budget", REPORT_TEXT("report", "U of the budget")},
        Row{"budgetActual", REPORT_TEXT("report", "U with the actual targets")},
        Row{"expandedUncertainty", REPORT_TEXT("report", "U after the simulation")},
        Row{"verdict", REPORT_TEXT("report", "Verdicts")}};
    const auto *row = std::ranges::find(rows, std::string_view(expected.of), &Row::of);
    return row != rows.end() ? row->text : REPORT_TEXT("report", "Monte Carlo");
}

/// Converts "−1.5e−11 µm" to "−1.5·10⁻¹¹ µm".
QString withPower(const QString &text) {
    static const QRegularExpression exponent(QStringLiteral("^(.*)e([−-]?)(\\d+)"));
    static constexpr std::u16string_view raised = u"⁰¹²³⁴⁵⁶⁷⁸⁹";
    const auto match = exponent.match(text);
    if (!match.hasMatch())
        return text;
    QString power = match.captured(2).isEmpty() ? QString() : QStringLiteral("⁻");
    for (const QChar digit : match.captured(3))
        power += QChar(raised[static_cast<std::size_t>(digit.digitValue())]);
    const QString factor = match.captured(1);
    return (factor == QStringLiteral("1") ? QString() : factor + QChar(u'·')) + QStringLiteral("10") + power +
           text.mid(match.capturedEnd());
}

/// Values of one set, method and source.
struct Group {
    QString set; ///< as shown: of all sets of one name
    Quantity quantity = Quantity::number;
    std::vector<const Comparison *> values;

    /// The value that comes closest to its tolerance or exceeds it most.
    [[nodiscard]] const Comparison &worst() const {
        return **std::ranges::max_element(values, {}, [](const Comparison *value) {
            const double tolerance = value->expectation.tolerance;
            return !value->difference ? -1.0 : std::abs(*value->difference) / (tolerance > 0 ? tolerance : 1);
        });
    }
};

/// Returns the unit of a value and its tolerance: relative ones and Student's t have none.
Quantity quantityOf(const Expectation &expected, const SetValidation &set) {
    return expected.relative || isStudentsT(expected) ? Quantity::number : set.quantity;
}

std::vector<Group> groupsOf(const std::vector<SetValidation> &sets, const Language &language) {
    std::vector<Group> result;
    for (const SetValidation &set : sets) {
        const QString name = set.name.at(language.code());
        for (const Comparison &comparison : set.comparisons) {
            const Expectation &expected = comparison.expectation;
            const Quantity quantity = quantityOf(expected, set);
            auto group = std::ranges::find_if(result, [&](const Group &one) {
                const Expectation &known = one.values.front()->expectation;
                return one.set == name && methodText(known) == methodText(expected) &&
                       known.source == expected.source && known.relative == expected.relative &&
                       one.quantity == quantity;
            });
            if (group == result.end())
                group = result.insert(group, {name, quantity, {}});
            group->values.push_back(&comparison);
        }
    }
    return result;
}

/// With few digits of the unit shown: the difference shows the rest.
QString shown(std::optional<double> value, int digits, Quantity quantity, const Language &language) {
    const double scale = unitScale(quantity);
    const double rounded = QString::number(value.value_or(0) * scale, 'g', digits).toDouble() / scale;
    return value ? withPower(language.quantity(rounded, quantity)) : QString();
}

Table summary(const std::vector<Group> &groups, const Language &language) {
    Table result;
    const auto add = [&](const Text &title, double width, bool isText, bool flexible = false) {
        result.columns.push_back({title.empty() ? Phrase() : language.text(title),
                                  {},
                                  isText ? Alignment::left : Alignment::right,
                                  flexible,
                                  width});
    };
    add(REPORT_TEXT("report", "Data"), 36, true, true);
    add(REPORT_TEXT("report", "Method"), 42, true, true);
    add(REPORT_TEXT("report", "Source"), 34, true);
    add(REPORT_TEXT("report", "Values"), 12, false);
    add(REPORT_TEXT("report", "Tolerance"), 22, false);
    add(REPORT_TEXT("report", "Largest difference"), 24, false);
    add({}, 20, true);
    for (const Group &group : groups) {
        const Comparison &worst = group.worst();
        const auto number = [&](std::optional<double> value) {
            return shown(value, digitsOfDifference, group.quantity, language);
        };
        const bool agree = std::ranges::all_of(group.values, &Comparison::agrees);
        Cell verdict(
            language.text(agree ? REPORT_TEXT("report", "agrees") : REPORT_TEXT("report", "DOES NOT AGREE")));
        verdict.bold = !agree;
        const bool isWord = !worst.expectation.word.empty();
        result.rows.push_back({group.set, language.text(methodText(worst.expectation)),
                               language.text(sourceText(worst.expectation.source)),
                               language.count(group.values.size()),
                               isWord ? QString() : number(worst.expectation.tolerance),
                               number(worst.difference), std::move(verdict)});
    }
    return result;
}

/// The values that do not agree, by their place in the file.
QStringList differences(const std::vector<Group> &groups, const Language &language) {
    QStringList lines;
    for (const Group &group : groups) {
        for (const Comparison *value : group.values) {
            const Expectation &expected = value->expectation;
            const auto either = [&](std::optional<double> number, const std::string &word) {
                return word.empty() ? shown(number, digitsShown, group.quantity, language).toStdString()
                                    : word;
            };
            if (!value->agrees)
                lines << language.sentence(REPORT_TEXT("report", "%1, %2: %3 expected, %4 computed"),
                                           {group.set.toStdString(), value->place.toStdString(),
                                            either(expected.value, expected.word),
                                            either(value->computed, value->word)});
        }
    }
    return lines;
}

QString processor() {
    const QString name = processorName();
    return name.isEmpty() ? QSysInfo::currentCpuArchitecture() : name;
}

/// Facts about this build.
KeyValues buildIn(const Language &language) {
    QFile program(QCoreApplication::applicationFilePath());
    const std::string digest = program.open(QIODevice::ReadOnly) ? sha256(program.readAll()) : std::string();
    const std::string today = QDate::currentDate().toString(Qt::ISODate).toStdString();
    return {{{language.text(REPORT_TEXT("report", "Program")), QStringLiteral("Palmer " PALMER_VERSION)},
             {language.text(REPORT_TEXT("report", "Compiler")), QStringLiteral(PALMER_COMPILER)},
             {language.text(REPORT_TEXT("report", "Processor")), processor()},
             {language.text(REPORT_TEXT("report", "SHA-256 of the program")), QString::fromStdString(digest)},
             {language.text(REPORT_TEXT("report", "Made on")), language.date(today)}},
            labelWidth};
}

} // namespace

Report composeValidation(const std::vector<SetValidation> &sets, const Language &language) {
    Report report;
    const std::vector<Group> groups = groupsOf(sets, language);
    const QStringList wrong = differences(groups, language);
    qsizetype values = 0;
    for (const Group &group : groups)
        values += static_cast<qsizetype>(group.values.size());
    report.blocks.emplace_back(
        Paragraph{language.sentence(REPORT_TEXT("report", "%1 of %2 values reproduced."),
                                    {wholeNumber(values - wrong.size()), wholeNumber(values)})});
    report.blocks.emplace_back(summary(groups, language));
    if (!wrong.isEmpty())
        report.blocks.emplace_back(Paragraph{wrong.join(u'\n')});
    report.blocks.emplace_back(Heading{2, language.text(REPORT_TEXT("report", "Origin of the data"))});
    KeyValues origins{{}, labelWidth};
    for (const SetValidation &set : sets)
        origins.rows.push_back({set.name.at(language.code()), set.origin.at(language.code()) +
                                                                  QStringLiteral("\nSHA-256 ") +
                                                                  QString::fromStdString(sha256(set.file))});
    report.blocks.emplace_back(std::move(origins));
    return report;
}

Report composeValidationDocument(const std::vector<SetValidation> &sets, const Language &language) {
    Report report = composeValidation(sets, language);
    KeyValues build = buildIn(language);
    TestHead head;
    report.making.program = build.rows.front().value;
    head.title =
        language.sentence(REPORT_TEXT("report", "Validation of %1"), {report.making.program.toStdString()});
    report.title = report.footerLeft = head.title;
    report.date = QDate::currentDate().toString(Qt::ISODate);
    report.blocks.insert(report.blocks.begin(), {std::move(head), std::move(build)});
    report.language = language.code();
    report.footerRight = language.text(REPORT_TEXT("report", "page %1 / %2"));
    return report;
}

QByteArray validationJson(const std::vector<SetValidation> &sets) {
    using Json = nlohmann::ordered_json;
    Json result = jsonHead("selftest");
    const Language english(Language::Id::english);
    for (const KeyValue &fact : buildIn(english).rows)
        result["build"][fact.key.toStdString()] = fact.value.toStdString();
    result["sets"] = Json::array();
    const auto orWord = [](std::optional<double> number, const std::string &word) {
        return !word.empty() ? Json(word) : number ? Json(*number) : Json(nullptr);
    };
    for (const SetValidation &set : sets) {
        Json values = Json::array();
        for (const Comparison &value : set.comparisons) {
            const Expectation &expected = value.expectation;
            values.push_back({{"place", value.place.toStdString()},
                              {"source", english.text(sourceText(expected.source)).toStdString()},
                              {"expected", orWord(expected.value, expected.word)},
                              {"computed", orWord(value.computed, value.word)},
                              {"tolerance", expected.tolerance},
                              {"difference", orWord(value.difference, {})},
                              {"agrees", value.agrees}});
        }
        result["sets"].push_back({{"name", set.name.at(english.code()).toStdString()},
                                  {"origin", set.origin.at(english.code()).toStdString()},
                                  {"sha256", sha256(set.file)},
                                  {"agrees", set.agrees()},
                                  {"values", std::move(values)}});
    }
    return QByteArray::fromStdString(printJson(result));
}

} // namespace palmer
