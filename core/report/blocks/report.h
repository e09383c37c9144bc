// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "figures/figure.h"
#include "kernel/evaluation/finding.h"
#include "kernel/evaluation/parameter.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace palmer {

// Lengths in mm, for a text width of 175 mm (A4). On wider paper what is left goes to the flexible columns.

/// A part of a text; a subscript stands lower on paper and beside it in plain text.
struct Span {
    QString text;
    bool subscript = false;
    bool italic = false;
    bool muted = false; ///< grey and regular, as the unit beside a name
    bool bold = false;

    bool operator==(const Span &) const = default;
};

/// A short text made of spans: a symbol with its index, a number, a name. A '\n' begins a line.
struct Phrase {
    std::vector<Span> spans;

    Phrase() = default;
    Phrase(QString text) // NOLINT(google-explicit-constructor): most phrases are plain
        : spans{{std::move(text)}} {}
    explicit Phrase(std::vector<Span> parts)
        : spans(std::move(parts)) {}

    [[nodiscard]] QString plain() const;

    bool operator==(const Phrase &) const = default;
};

/// Signs that are drawn as paths: no font has them all.
enum class Mark {
    none,
    check,      ///< met, agreed
    cross,      ///< exceeded, not agreed, requirement; the word beside it is bold
    openCircle, ///< not proven, recommendation, note
    warning     ///< a requirement is not met or was not declared
};

[[nodiscard]] Mark markOf(Verdict verdict);
[[nodiscard]] Mark markOf(Grade grade);

/// The guard picture of a result: base line from 0, tick at the limit, value as a diamond, and, where the
/// rule has one, the band limit ± g. All in one unit, value by absolute value, limit > 0.
struct Guard {
    double limit = 1;
    double value = 0;
    std::optional<double> guardBand;

    bool operator==(const Guard &) const = default;
};

/// A small line below the text of a cell.
struct CellNote {
    QString text;
    Mark mark = Mark::none; ///< before the text

    bool operator==(const CellNote &) const = default;
};

/// A field of a table. Without text, mark and picture it prints a thin dash, unless it is blank.
struct Cell {
    Phrase text;
    bool bold = false;
    bool blank = false;     ///< nothing is to stand here, not even a dash
    Mark mark = Mark::none; ///< before the text
    std::optional<Guard> guard = {};
    std::optional<double> bar = {}; ///< a bar from the left, part of the width of its column, 0 … 1
    bool hollow = false;            ///< of a bar: its outline alone
    bool pale = false;              ///< grey, with its mark and picture: for information only
    std::size_t rows = 1;           ///< it stands beside; these are never split
    std::size_t columns = 1;        ///< its text stands in; the cells of the others are blank
    std::vector<CellNote> notes = {};

    Cell() = default;
    Cell(Phrase phrase) // NOLINT(google-explicit-constructor): most cells are a phrase
        : text(std::move(phrase)) {}
    Cell(QString words) // NOLINT(google-explicit-constructor)
        : text(std::move(words)) {}

    /// Prints the dash of a missing value.
    [[nodiscard]] bool isMissing() const;

    bool operator==(const Cell &) const = default;
};

[[nodiscard]] Cell blankCell();

// ---- Blocks --------------------------------------------------------------------------------------------

/// Level 1: a report or test; 2: a section; 3: within a section. Never parted from the block below it.
struct Heading {
    int level = 2;
    QString text;
    Phrase note = {};    ///< small and regular on the same line
    QString anchor = {}; ///< what `VerdictLine::anchor` points to

    bool operator==(const Heading &) const = default;
};

enum class TextSize { normal, small }; ///< 9 pt black, 8 pt dark grey

struct Paragraph {
    QString text; ///< '\n' begins a line
    TextSize size = TextSize::normal;

    bool operator==(const Paragraph &) const = default;
};

/// A label and what is stated; an empty value prints as a thin dash, '\n' begins a line.
struct KeyValue {
    QString key;
    QString value;

    bool operator==(const KeyValue &) const = default;
};

struct KeyValues {
    std::vector<KeyValue> rows;
    double labelWidth = 30;
    bool narrow = false; ///< smaller and closer, as in a column beside a figure

    bool operator==(const KeyValues &) const = default;
};

/// decimal: aligned on the decimal mark, the whole at the right edge.
enum class Alignment { left, right, decimal };

struct Column {
    Phrase title;      ///< bold, first line of the head
    QString unit = {}; ///< regular, second line of the head
    Alignment alignment = Alignment::left;
    bool flexible = false; ///< breaks into lines where the table is too wide; takes what is left over
    double width = 0;      ///< mm; 0: these columns share what the others leave, equally
    int titleSpan = 1;     ///< columns the title spreads over; the titles of those are empty
    double gapBefore = 0;  ///< mm before the column
    double paddingLeft = 1;
    bool pages = false;   ///< each of its cells prints the page that its row leads to (`Table::links`)
    bool fitting = false; ///< wider where a text of it needs that
    double spare = 0;     ///< mm of the width that fitting columns take before the flexible ones give

    bool operator==(const Column &) const = default;
};

/// A title over several columns, with a rule below it; stands on the first line of the head.
struct Spanner {
    std::size_t first = 0;
    std::size_t count = 1;
    Phrase title;

    bool operator==(const Spanner &) const = default;
};

/// Rows of cells, one a column. A rule follows the rows whose index stands in `rulesAfter`, ascending; head
/// and end have theirs anyway. The head is repeated on every page of a table that is split.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows = {};
    std::vector<std::size_t> rulesAfter = {};
    std::vector<std::size_t> strongRulesAfter = {}; ///< black
    std::vector<Spanner> spanners = {};
    bool unbroken = false; ///< never split over two pages
    bool headless = false; ///< without head
    std::vector<QString> links =
        {}; ///< anchors that the rows lead to, one a row; none: no row leads anywhere

    bool operator==(const Table &) const = default;
};

/// A figure with its caption, the heading above it.
struct FigureBlock {
    Figure figure;
    double width = 175;
    double height = 86;

    bool operator==(const FigureBlock &) const = default;
};

/// What may stand in a half of a page.
using Part = std::variant<Heading, Paragraph, KeyValues, Table, FigureBlock>;

/// Two columns of blocks from the same height on; drawn and read left, then right. Never split.
struct SideBySide {
    std::vector<Part> left;
    std::vector<Part> right;
    double leftWidth = 83; ///< mm
    double gap = 9;        ///< mm

    bool operator==(const SideBySide &) const = default;
};

/// The head of a test or of the summary. Empty texts are left out together with their lines.
struct TestHead {
    QString laboratory;
    QString address;         ///< may have several lines
    QString accreditation;   ///< below the address
    QByteArray logo;         ///< PNG or SVG, at most 10 mm high; before the name of the laboratory
    QByteArray mark;         ///< of the accreditation body, PNG or SVG, likewise
    QString number;          ///< "Report No. …", right
    QStringList numberNotes; ///< revision and what it replaces, date of issue, "Test 1 of 2": right, small
    QString title;
    QString subtitle;
    QString editionTitle; ///< the edition's own title words; small, below the subtitle
    QString notice;       ///< that this is no acceptance result: bold, below the titles
    KeyValues left;       ///< 74 wide, gap 9
    KeyValues right;
    QString anchor = {}; ///< what `Table::links` points to

    bool operator==(const TestHead &) const = default;
};

enum class LegendSign { none, value, limit, band, check, cross, openCircle, warning };

struct LegendItem {
    LegendSign sign = LegendSign::none;
    QString text;

    bool operator==(const LegendItem &) const = default;
};

/// One line below the results: what the guard pictures mean. Stays with the table above it.
struct ResultsLegend {
    std::vector<LegendItem> items;

    bool operator==(const ResultsLegend &) const = default;
};

/// One of the two parts of a verdict. Order of the text: label, state, text.
struct VerdictStatement {
    QString label; ///< "Limits", "Test"
    Mark mark = Mark::none;
    QString state; ///< "exceeded"; bold
    Phrase text;   ///< which; with "%1" for the page of the line's anchor, where there is one

    bool operator==(const VerdictStatement &) const = default;
};

/// The verdict on a test or a report: one large word, and beside it its two parts in the same size: the
/// limits, and the accordance with the edition. Stays with the block above it. Order of the text: label,
/// word, note, limits, accordance.
struct VerdictLine {
    Mark mark = Mark::none;
    QString label;       ///< "Verdict of the test"
    QString word;        ///< in capitals; empty where only the parts are said
    QString second = {}; ///< below the word in the same size: what is not known of the test; may be empty
    QString note = {};   ///< small, below the word
    VerdictStatement limits;
    VerdictStatement accordance;
    QString anchor = {};
    bool large = false; ///< of a whole report

    bool operator==(const VerdictLine &) const = default;
};

/// Findings in words, those of one clause and state together. Order of the text: heading, grade, sentence,
/// clause.
struct FindingLine {
    QString heading = {}; ///< of the first of a source: what follows it comes from there
    Grade grade = Grade::note;
    QString gradeName;
    QString clause; ///< "4.3.2"; empty where it is not known: a dash
    Phrase sentence;

    bool operator==(const FindingLine &) const = default;
};

struct FindingsBlock {
    std::vector<FindingLine> lines;

    bool operator==(const FindingsBlock &) const = default;
};

/// A line to be filled by hand, with what is known already printed on it.
struct SignatureLine {
    QString label;
    QString value = {};
    bool forSignature = false; ///< with the free space of a signature
    double height = 0;         ///< mm, label above the free space; 0: what the other lines have

    bool operator==(const SignatureLine &) const = default;
};

struct SignatureColumn {
    QString heading; ///< may be empty in all columns
    std::vector<SignatureLine> lines;
    double width = 0; ///< mm; 0: these columns share what the others leave

    bool operator==(const SignatureColumn &) const = default;
};

/// Columns side by side, at most four; never split. Order of the text: column by column, in each the heading
/// and then label and value of each line.
struct Signatures {
    std::vector<SignatureColumn> columns;

    bool operator==(const Signatures &) const = default;
};

/// From here on every page but the first (the one this stands on) carries these lines above a rule.
struct RunningHead {
    QString left;
    QString right;

    bool operator==(const RunningHead &) const = default;
};

struct PageBreak {
    bool operator==(const PageBreak &) const = default;
};

/// The last words of a report, centred.
struct EndMark {
    QString text;

    bool operator==(const EndMark &) const = default;
};

using Block =
    std::variant<Heading, Paragraph, KeyValues, Table, SideBySide, TestHead, FigureBlock, ResultsLegend,
                 VerdictLine, FindingsBlock, Signatures, RunningHead, PageBreak, EndMark>;

/// How a report was made: with this and its test file it can be made again.
struct Making {
    QString program;                         ///< "Palmer 0.1.0"
    std::optional<bool> selfTestPassed = {}; ///< of the process that made it; null: not run
    std::vector<int> simulated = {};         ///< tests whose uncertainty was simulated, counted from 1
    QString edition = {};                    ///< of a view: designation of the other edition; else empty

    bool operator==(const Making &) const = default;
};

/// What is to be read, block by block in the order of reading, in one language; where it stands on a page or
/// a terminal is the business of who draws it.
struct Report {
    std::vector<Block> blocks;
    QString language = {}; ///< "en", "fr"
    Paper paper = Paper::a4;
    QString title = {};      ///< of the PDF
    QString laboratory = {}; ///< its author
    QString date = {};       ///< YYYY-MM-DD or empty: the only date the PDF carries
    Making making = {};
    QByteArray testFile = {};  ///< what the report was made from; empty: from none
    QString testFileName = {}; ///< as it is attached to the PDF
    QString fingerprint = {};  ///< SHA-256 of the test file, 64 hex digits
    QString footerLeft = {};   ///< "Report …"
    QString footerCentre = {}; ///< "Fingerprint SHA-256 …"
    QString footerRight = {};  ///< "page %1 / %2"

    bool operator==(const Report &) const = default;
};

/// What links and numbers of pages lead to a block by; empty: nothing.
[[nodiscard]] QString anchorOf(const Block &block);

/// In a report of several tests the anchor of the title above what stands behind the results of a test;
/// `head` is that of its head.
[[nodiscard]] QString detailsAnchor(const QString &head);

/// The report with the pages of its anchors put in. Anchors without a page print a dash.
[[nodiscard]] Report withPages(Report report, const std::map<QString, int> &pages);

} // namespace palmer
