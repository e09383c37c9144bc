// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/evaluateddocument.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "language/language.h"
#include "report/blocks/report.h"

#include <QStringList>
#include <variant>

namespace palmer {

// Page dimensions and decimals shared by the parts of a report.
inline constexpr double textWidth = 175; ///< mm
inline constexpr double figureGap = 5;   ///< mm between a figure and the column next to it
inline constexpr double percent = 100;
inline constexpr qsizetype mostNamed = 6; ///< results or rows named in a verdict
inline constexpr int temperatureDecimals = 1;
inline constexpr int expansionDecimals = 1; ///< of α

/// Formats the texts of a report in one language.
class Writer {
public:
    explicit Writer(const Language &language)
        : m_language(language) {}

    [[nodiscard]] const Language &language() const { return m_language; }
    [[nodiscard]] QString text(const Text &words) const { return m_language.text(words); }
    [[nodiscard]] QString say(const Text &words, std::vector<Argument> arguments = {}) const {
        return m_language.sentence(words, std::move(arguments));
    }
    [[nodiscard]] QString say(const Text &words, const QString &name) const {
        return say(words, {Argument(name.toStdString())});
    }
    [[nodiscard]] QString quantity(std::optional<double> value, Quantity quantity, int decimals = -1) const {
        return value ? m_language.quantity(*value, quantity, decimals) : QString();
    }

    /// As stated, with all its digits; empty if it is not.
    [[nodiscard]] QString number(std::optional<double> value, Quantity quantity, int decimals = -1) const {
        return value ? m_language.number(certain(*value), quantity, decimals) : QString();
    }
    /// The same with at least this many decimals.
    [[nodiscard]] QString numberAtLeast(std::optional<double> value, Quantity quantity, int least) const {
        return number(value, quantity, value ? statedDecimals(*value, quantity, least) : least);
    }

    /// A column with a title in words; width in mm.
    [[nodiscard]] Column column(const Text &title, double width, Alignment alignment = Alignment::left,
                                const QString &unit = {}) const {
        return columnOf(text(title), width, alignment, unit);
    }
    [[nodiscard]] Column flexible(const Text &title, double width) const {
        return flexibleColumn(text(title), width);
    }

    /// "; " with the spacing of the language.
    [[nodiscard]] QString semicolon() const { return m_language.semicolon(); }

private:
    const Language &m_language;
};

/// Collects rows of a label and a value.
class LabelledRows {
public:
    explicit LabelledRows(const Writer &write, KeyValues values = {})
        : m_write(write)
        , m_values(std::move(values)) {}

    /// A blank value is none, and omitted unless the row is needed.
    void add(const Text &label, const QString &value, bool needed = true) {
        const bool isBlank = value.trimmed().isEmpty();
        if (needed || !isBlank)
            m_values.rows.push_back({m_write.text(label), isBlank ? QString() : value});
    }
    void add(const Text &label, const std::string &value, bool needed = true) {
        add(label, QString::fromStdString(value), needed);
    }
    [[nodiscard]] KeyValues take() { return std::move(m_values); }
    [[nodiscard]] KeyValue &last() { return m_values.rows.back(); }

private:
    const Writer &m_write;
    KeyValues m_values;
};

/// One test with the inputs for its part of a report. Owns nothing.
struct TestPart {
    const Writer &write;
    const EvaluatedDocument &evaluated;
    const Test &test;
    const TestEvaluation &evaluation; ///< has an edition: no drift test
    std::size_t index = 0;            ///< in the document
    int number = 1;                   ///< in the report
    int count = 1;
    /// The file under each edition named by the head, in its order; evaluated once for all tests.
    const std::vector<EvaluatedDocument> *views = nullptr;
    bool annex = true; ///< the report has one

    [[nodiscard]] const Document &document() const { return *evaluated.document; }
    [[nodiscard]] const ReportHead &head() const { return document().report; }
    [[nodiscard]] const Edition &edition() const { return *evaluation.edition; }
    [[nodiscard]] bool leavesOut(ReportPart part) const;
    [[nodiscard]] QString findingsAnchor() const { return QStringLiteral("findings-%1").arg(number); }
    [[nodiscard]] QString headAnchor() const { return QStringLiteral("test-%1").arg(number); }
};

struct PositioningPart : TestPart {
    const PositioningMeasurement &measurement;
    const PositioningResults &results;

    [[nodiscard]] Quantity along() const { return positionQuantity(measurement.axis); }
    [[nodiscard]] Quantity deviation() const { return deviationQuantity(measurement.axis); }
    /// True for linear axes, whose results depend on temperature.
    [[nodiscard]] bool needsLength() const { return measurement.axis.motion == Motion::linear; }
};

struct CircularPart : TestPart {
    const CircularMeasurement &measurement;
    const CircularResults &results;

    [[nodiscard]] bool feedback() const { return measurement.source == SignalSource::feedback; }
    /// True if the parties require it and the edition has it.
    [[nodiscard]] bool asksFor(OfCircle quantity) const;
    /// True if F or D is required and possible, so that reference length and temperatures matter.
    [[nodiscard]] bool needsLength() const;
    /// True if F and D are corrected to 20 °C, or known temperatures need no correction.
    [[nodiscard]] bool holdsAt20() const { return results.at20 == At20::hold; }
    /// Axes in the order of the plane: "XY".
    [[nodiscard]] QString plane() const;
};

/// Calls `use` with the part of its kind. Precondition: a test that editions judge.
template <class Use>
auto withKind(const TestPart &part, Use use) {
    switch (kindOf(part.test)) {
    case Kind::positioning: {
        const auto &positioning = std::get<PositioningMeasurement>(part.test.measurement);
        return use(PositioningPart{part, positioning, resultsOf(positioning, part.evaluation)});
    }
    case Kind::circular: {
        const auto &circular = std::get<CircularMeasurement>(part.test.measurement);
        return use(CircularPart{part, circular, resultsOf(circular, part.evaluation)});
    }
    case Kind::drift:
        break;
    }
    throw std::bad_variant_access();
}

/// "Positioning test of the X axis".
[[nodiscard]] QString testName(const Writer &write, const Test &test);

/// Joins the non-empty texts.
[[nodiscard]] QString joined(QStringList texts, const QString &separator = QStringLiteral(", "));

/// "A, B and C".
[[nodiscard]] QString enumerated(const Writer &write, QStringList texts);

/// A date in words; may be empty.
[[nodiscard]] QString dateText(const Writer &write, const std::optional<std::string> &date);

/// "20 to 21 November 2026"; only one of the dates if the other is missing.
[[nodiscard]] QString periodText(const Writer &write, const std::optional<std::string> &from,
                                 const std::optional<std::string> &to);

/// Name, address and contact on one line.
[[nodiscard]] QString partyText(const Party &party);

/// Removes the empty columns from `first` to `last` of a table without spanners.
void leaveOutEmptyColumns(Table &table, std::size_t first, std::size_t last);

/// Adds the heading of a section.
void addHeading(std::vector<Block> &blocks, const QString &text, Phrase note = {},
                const QString &anchor = {});

} // namespace palmer
