// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "figures/figure.h"
#include "kernel/evaluation/finding.h"
#include "kernel/evaluation/parameter.h"
#include "report/blocks/packedrows.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <concepts>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace palmer {

// Lengths in mm, for a text width of 175 mm (A4). On wider paper the rest goes to the flexible columns.

/// A part of a text; a subscript is lower on paper and inline in plain text.
struct Span {
    QString text;
    bool subscript = false;
    bool italic = false;
    bool muted = false; ///< grey and regular, like a unit next to a name
    bool bold = false;

    bool operator==(const Span &) const = default;
};

/// A short text made of spans: a symbol with its index, a number, a name. '\n' starts a new line.
struct Phrase {
    std::vector<Span> spans;

    Phrase() = default;
    Phrase(QString text) // NOLINT(google-explicit-constructor): most phrases are plain
        : spans{{std::move(text)}} {}
    explicit Phrase(std::vector<Span> parts)
        : spans(std::move(parts)) {}

    [[nodiscard]] QString plain() const;
    Phrase &operator+=(const Phrase &other);

    bool operator==(const Phrase &) const = default;
};

/// Signs drawn as paths, because no font has them all.
enum class Mark {
    none,
    check,      ///< met, agreed
    cross,      ///< exceeded, not agreed, requirement; the word next to it is bold
    openCircle, ///< not proven, recommendation, note
    warning     ///< a requirement is not met or not declared
};

[[nodiscard]] Mark markOf(Verdict verdict);
[[nodiscard]] Mark markOf(Grade grade);

/// The guard picture of a result: base line from 0, tick at the limit, value as a diamond, and the band limit
/// ± g if the rule has one. All in the same unit, absolute value, limit > 0.
struct Guard {
    double limit = 1;
    double value = 0;
    std::optional<double> guardBand;

    bool operator==(const Guard &) const = default;
};

/// The picture of a difference: value with its ± as a whisker on an axis common to a table, a line at 0.
struct Whisker {
    double from = -1; ///< ends of the axis, around 0
    double to = 1;
    double value = 0;
    double half = 0;   ///< ±
    bool open = false; ///< draw only the outline of the point

    bool operator==(const Whisker &) const = default;
};

/// A small line below the text of a cell.
struct CellNote {
    QString text;
    Mark mark = Mark::none; ///< before the text

    bool operator==(const CellNote &) const = default;
};

/// A value in memory of its own, for what is large or rare: the default value takes none. Copies share it
/// until one of them changes.
template <class T>
class Boxed {
public:
    Boxed() = default;
    // NOLINTBEGIN(google-explicit-constructor,*-forwarding-reference-overload): is the value
    template <class Value>
    requires(std::constructible_from<T, Value> && !std::same_as<std::remove_cvref_t<Value>, Boxed>)
        Boxed(Value &&value)
        : m_value(std::make_shared<T>(std::forward<Value>(value))) {}
    // NOLINTEND(google-explicit-constructor,*-forwarding-reference-overload)

    [[nodiscard]] const T &operator*() const {
        static const T usual{};
        return m_value ? *m_value : usual;
    }
    [[nodiscard]] const T *operator->() const { return &**this; }
    /// The value, to be changed at once.
    [[nodiscard]] T &edit() {
        if (!m_value || m_value.use_count() > 1)
            m_value = std::make_shared<T>(**this);
        return *m_value;
    }

    bool operator==(const Boxed &other) const { return m_value == other.m_value || **this == *other; }

private:
    std::shared_ptr<T> m_value;
};

/// Properties that few cells have.
struct CellExtras {
    std::optional<Guard> guard = {};
    std::optional<Whisker> whisker = {};
    std::optional<double> bar = {}; ///< a bar from the left, fraction of the column width, 0 … 1
    bool hollow = false;            ///< draw only the outline of the bar
    std::size_t rows = 1;           ///< number of rows it spans; these stay together
    std::size_t columns = 1;        ///< number of columns it spans; the other cells are blank
    std::vector<CellNote> notes = {};

    bool operator==(const CellExtras &) const = default;
};

/// A table cell. Without text, mark and picture it prints a thin dash, unless it is blank. Small, as a report
/// of a thousand tests has a hundred thousand of them.
struct Cell {
    Phrase text;
    Mark mark = Mark::none; ///< before the text
    bool bold = false;
    bool blank = false; ///< prints nothing, not even a dash
    bool pale = false;  ///< grey, including mark and picture: for information only
    Boxed<CellExtras> extras = {};

    Cell() = default;
    Cell(Phrase phrase) // NOLINT(google-explicit-constructor): most cells are a phrase
        : text(std::move(phrase)) {}
    Cell(QString words) // NOLINT(google-explicit-constructor)
        : text(std::move(words)) {}

    /// True if it prints the dash of a missing value.
    [[nodiscard]] bool isMissing() const;

    bool operator==(const Cell &) const = default;
};

[[nodiscard]] Cell blankCell();
[[nodiscard]] Cell boldCell(Phrase text);

// ---- Blocks --------------------------------------------------------------------------------------------

/// Level 1: a report or test; 2: a section; 3: within a section. Never separated from the block below it.
struct Heading {
    int level = 2;
    QString text;
    Phrase note = {};        ///< small and regular on the same line
    QString anchor = {};     ///< target of `VerdictLine::anchor`
    bool annexFirst = false; ///< its section goes to the annex if the certificate is too long otherwise

    bool operator==(const Heading &) const = default;
};

enum class TextSize { normal, small }; ///< 9 pt black, 8 pt dark grey

struct Paragraph {
    QString text; ///< '\n' starts a new line
    TextSize size = TextSize::normal;

    bool operator==(const Paragraph &) const = default;
};

/// A label and its value; an empty value prints as a thin dash, '\n' starts a new line.
struct KeyValue {
    QString key;
    QString value;
    bool further = false; ///< nobody asks for it: it stands in the annex, if there is one

    bool operator==(const KeyValue &) const = default;
};

struct KeyValues {
    std::vector<KeyValue> rows;
    double labelWidth = 30;
    bool narrow = false; ///< smaller and closer, for a column next to a figure

    bool operator==(const KeyValues &) const = default;
};

/// decimal: aligned on the decimal mark, the block of numbers at the right edge.
enum class Alignment { left, right, decimal };

struct Column {
    Phrase title;      ///< bold, first line of the head
    QString unit = {}; ///< regular, second line of the head
    Alignment alignment = Alignment::left;
    bool flexible = false; ///< wraps if the table is too wide; takes the remaining width
    double width = 0;      ///< mm; 0: an equal share of what the other columns leave
    int titleSpan = 1;     ///< columns that the title spans; their own titles are empty
    double gapBefore = 0;  ///< mm before the column
    double paddingLeft = 1;
    bool pages = false;   ///< each cell prints the page of its row's link (`Table::links`)
    bool fitting = false; ///< grows if its text needs it
    double spare = 0;     ///< width it gives to fitting columns before flexible ones shrink, mm

    bool operator==(const Column &) const = default;
};

/// A column of a fixed width, mm; 0: an equal share.
[[nodiscard]] Column columnOf(Phrase title, double width, Alignment alignment = Alignment::left,
                              QString unit = {});
/// A left-aligned column that wraps and takes the remaining width.
[[nodiscard]] Column flexibleColumn(Phrase title, double width);

/// A title over several columns with a rule below it, on the first line of the head.
struct Spanner {
    std::size_t first = 0;
    std::size_t count = 1;
    Phrase title;

    bool operator==(const Spanner &) const = default;
};

/// Rows of cells, one per column. A rule follows the rows listed in `rulesAfter`, ascending; head and end
/// always have one. A split table repeats its head on every page.
struct Table {
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows = {};
    std::vector<std::size_t> rulesAfter = {};
    std::vector<std::size_t> strongRulesAfter = {}; ///< black
    std::vector<Spanner> spanners = {};
    bool unbroken = false; ///< never split over two pages
    bool headless = false;
    bool narrow = false; ///< rows closer
    std::vector<QString> links =
        {};                 ///< anchors that the rows link to, one per row; empty if the rows have no links
    PackedRows packed = {}; ///< further rows, of long tables and of reports with many tests

    [[nodiscard]] std::size_t rowCount() const { return rows.size() + packed.count(); }
    /// Returns what `visit` makes of the cells of row `index`.
    // NOLINTNEXTLINE(modernize-use-nodiscard): may be nothing
    decltype(auto) withRow(std::size_t index, auto visit) const {
        return index < rows.size() ? visit(rows[index]) : visit(packed.row(index - rows.size()));
    }
    void eachRow(auto visit) const {
        for (std::size_t i = 0; i < rowCount(); ++i)
            withRow(i, visit);
    }

    bool operator==(const Table &) const = default;
};

/// Removes a column of a table whose rows are not packed and which has no spanners; cells that span it become
/// narrower.
void eraseColumn(Table &table, std::size_t column);

/// Packs the rows of a table, unless one of them has a cell that is not plain.
void packRows(Table &table);

/// A figure; its caption is the heading above it.
struct FigureBlock {
    Boxed<Figure> figure;
    double width = 175;
    double height = 86;
    double least = 65; ///< height that it may shrink to

    bool operator==(const FigureBlock &) const = default;
};

/// Blocks allowed in a half of a page.
using Part = std::variant<Heading, Paragraph, KeyValues, Table, FigureBlock>;

/// Two columns of blocks starting at the same height; drawn and read left, then right. Never split.
struct SideBySide {
    std::vector<Part> left;
    std::vector<Part> right;
    double leftWidth = 83; ///< mm
    double gap = 9;        ///< mm
    /// Both columns end in key-value rows, all of them at first in the left one: the page moves as many to
    /// the right one as make both about equally high.
    bool levelled = false;

    bool operator==(const SideBySide &) const = default;
};

/// Head of a test or of the summary. Empty texts are omitted with their lines.
struct TestHead {
    QString laboratory;
    QString address;         ///< may have several lines
    QString accreditation;   ///< below the address
    QByteArray logo;         ///< PNG or SVG, at most 10 mm high; precedes the laboratory name
    QByteArray mark;         ///< of the accreditation body; same format
    QString number;          ///< "Report No. …", right
    QStringList numberNotes; ///< revision and what it replaces, date of issue, "Test 1 of 2": right, small
    QString title;
    QString subtitle;
    QString editionTitle; ///< the edition's own title, small, below the subtitle
    QString notice;       ///< states that this is no acceptance result: bold, below the titles
    KeyValues left;       ///< 74 wide, gap 9
    KeyValues right;
    QString anchor = {}; ///< target of `Table::links`
    bool annex = false;  ///< begins the annex

    bool operator==(const TestHead &) const = default;
};

enum class LegendSign { none, value, limit, band, check, cross, openCircle, warning };

struct LegendItem {
    LegendSign sign = LegendSign::none;
    QString text;

    bool operator==(const LegendItem &) const = default;
};

/// One line below the results that explains the guard pictures. Stays with the table above it.
struct ResultsLegend {
    std::vector<LegendItem> items;

    bool operator==(const ResultsLegend &) const = default;
};

/// One of the two parts of a verdict. Text order: label, state, text.
struct VerdictStatement {
    QString label; ///< "Limits", "Test"
    Mark mark = Mark::none;
    QString state; ///< "exceeded"; bold
    Phrase text;   ///< details, with "%1" for the page of the line's anchor if it has one

    bool operator==(const VerdictStatement &) const = default;
};

/// Verdict on a test or a report: one large word, and next to it its two parts in equal size: the limits and
/// the accordance with the edition. Stays with the block above it. Text order: label, word, note, limits,
/// accordance.
struct VerdictLine {
    Mark mark = Mark::none;
    QString label;       ///< "Verdict of the test"
    QString word;        ///< in capitals; empty if only the parts are given
    QString second = {}; ///< below the word in the same size: unknown facts of the test; may be empty
    QString note = {};   ///< small, below the word
    VerdictStatement limits;
    VerdictStatement accordance;
    QString anchor = {};
    bool large = false;      ///< for a whole report
    bool interprets = false; ///< main result of an interpretation, no verdict on a test or report

    bool operator==(const VerdictLine &) const = default;
};

/// Findings in words, combined by clause and state. Text order: heading, grade, sentence, clause.
struct FindingLine {
    QString heading = {}; ///< set on the first finding of a source; applies to those that follow
    Grade grade = Grade::note;
    QString gradeName;
    QString clause; ///< "4.3.2"; empty (printed as a dash) if unknown
    Phrase sentence;

    bool operator==(const FindingLine &) const = default;
};

struct FindingsBlock {
    std::vector<FindingLine> lines;
    bool narrow = false; ///< smaller and closer

    bool operator==(const FindingsBlock &) const = default;
};

/// A line to fill in by hand; known values are printed.
struct SignatureLine {
    QString label;
    QString value = {};
    bool forSignature = false; ///< with space for a signature
    double height = 0;         ///< mm, label above the free space; 0: default height of the lines

    bool operator==(const SignatureLine &) const = default;
};

struct SignatureColumn {
    QString heading; ///< may be empty in all columns
    std::vector<SignatureLine> lines;
    double width = 0; ///< mm; 0: an equal share of the rest

    bool operator==(const SignatureColumn &) const = default;
};

/// Columns side by side, at most four; never split. Text order: column by column, each with heading, then
/// label and value of each line.
struct Signatures {
    std::vector<SignatureColumn> columns;
    bool narrow = false; ///< lines closer, with the same space for signatures

    bool operator==(const Signatures &) const = default;
};

/// These lines, above a rule, head every following page, but not the page of this block.
struct RunningHead {
    QString left;
    QString right;

    bool operator==(const RunningHead &) const = default;
};

struct PageBreak {
    bool operator==(const PageBreak &) const = default;
};

/// The last words of a certificate or report, centred.
struct EndMark {
    QString text; ///< with "%1" for the page of the anchor if it has one
    QString anchor = {};

    bool operator==(const EndMark &) const = default;
};

using Block =
    std::variant<Heading, Paragraph, KeyValues, Table, SideBySide, TestHead, FigureBlock, ResultsLegend,
                 VerdictLine, FindingsBlock, Signatures, RunningHead, PageBreak, EndMark>;

/// How a report was made: with this and its test file it can be reproduced.
struct Making {
    QString program;                         ///< "Palmer 0.1.0"
    std::optional<bool> selfTestPassed = {}; ///< in the process that made it; null: not run
    std::vector<int> simulated = {};         ///< tests whose uncertainty was simulated, counted from 1
    QString edition = {};                    ///< for a view: the other edition; otherwise empty
    bool annex = true;                       ///< false: only the certificate

    bool operator==(const Making &) const = default;
};

/// Content of a report, block by block in reading order, in one language; renderers decide the layout on a
/// page or terminal.
struct Report {
    std::vector<Block> blocks;
    QString language = {}; ///< "en", "fr"
    Paper paper = Paper::a4;
    QString title = {};      ///< of the PDF
    QString laboratory = {}; ///< author of the PDF
    QString date = {};       ///< YYYY-MM-DD or empty; the only date in the PDF
    Making making = {};
    QByteArray testFile = {};  ///< source of the report; may be empty
    QString testFileName = {}; ///< name of the attachment
    int certificatePages = 0;  ///< most pages before the annex while a section may go there; 0: any
    QString fingerprint = {};  ///< SHA-256 of the test file, 64 hex digits
    QString footerLeft = {};   ///< "Report …"
    QString footerCentre = {}; ///< "Fingerprint SHA-256 …"
    QString footerRight = {};  ///< "page %1 / %2"

    bool operator==(const Report &) const = default;
};

/// Target name of a block for links and page numbers; may be empty.
[[nodiscard]] QString anchorOf(const Block &block);

/// True if a block may name pages.
[[nodiscard]] bool namesPages(const Block &block);

/// Fills in the numbers of the pages that a block names; anchors without a page print a dash. Returns
/// namesPages().
bool putPages(Block &block, const std::map<QString, int> &pages);

} // namespace palmer
