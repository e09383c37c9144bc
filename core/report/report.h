#pragma once

#include "kernel/evaluation/finding.h"
#include "kernel/evaluation/parameter.h"

#include <QString>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace palmer {

/// A part of a text; a subscript stands lower on paper and beside it in plain text.
struct Span {
    QString text;
    bool subscript = false;

    bool operator==(const Span &) const = default;
};

/// A short text made of spans: a symbol with its index, a number, a name.
struct Phrase {
    std::vector<Span> spans;

    Phrase() = default;
    Phrase(QString text) // NOLINT(google-explicit-constructor): most phrases are plain
        : spans{{std::move(text), false}} {}
    explicit Phrase(std::vector<Span> parts)
        : spans(std::move(parts)) {}

    [[nodiscard]] QString plain() const;

    bool operator==(const Phrase &) const = default;
};

/// Level 1: a report or test; 2: a section; 3: within a section.
struct Heading {
    int level = 2;
    QString text;

    bool operator==(const Heading &) const = default;
};

struct Paragraph {
    QString text;

    bool operator==(const Paragraph &) const = default;
};

/// A label and what is stated; an empty value prints as a thin dash.
struct KeyValue {
    QString key;
    QString value;

    bool operator==(const KeyValue &) const = default;
};

struct KeyValues {
    std::vector<KeyValue> rows;

    bool operator==(const KeyValues &) const = default;
};

/// decimal: aligned on the decimal mark.
enum class Alignment { left, right, decimal };

struct Column {
    Phrase title;
    QString unit; ///< second line of the head
    Alignment alignment = Alignment::left;
    bool flexible = false; ///< breaks into lines where the table is too wide

    bool operator==(const Column &) const = default;
};

/// Rows of cells, one a column; an empty cell prints as a thin dash. A rule follows the rows whose index
/// stands in `rulesAfter`, ascending; head and end have theirs anyway.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Phrase>> rows;
    std::vector<std::size_t> rulesAfter;

    bool operator==(const Table &) const = default;
};

/// One finding in words.
struct FindingLine {
    Grade grade = Grade::note;
    QString gradeName;
    QString clause; ///< "4.3.2"; empty where it is not known
    QString sentence;

    bool operator==(const FindingLine &) const = default;
};

struct FindingsBlock {
    std::vector<FindingLine> lines;

    bool operator==(const FindingsBlock &) const = default;
};

/// The two parts of the verdict on a test: its limits, and its accordance with the edition.
struct VerdictLine {
    std::optional<Verdict> verdict;
    QString limits;
    bool inAccordance = true;
    QString accordance;

    bool operator==(const VerdictLine &) const = default;
};

using Block = std::variant<Heading, Paragraph, KeyValues, Table, FindingsBlock, VerdictLine>;

/// What is to be read, block by block in the order of reading, in one language; where it stands on a page or
/// a terminal is the business of who draws it.
struct Report {
    std::vector<Block> blocks;

    bool operator==(const Report &) const = default;
};

} // namespace palmer
