// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/strips.h"

#include "print/figures/drawkinds.h"
#include "print/pdf/logo.h"
#include "print/pdf/marks.h"
#include "print/pdf/tags.h"

#include <QPainter>
#include <algorithm>
#include <numeric>

namespace palmer {

namespace {

// Gaps, points.
constexpr double afterHead = 5 * mm;
constexpr double afterHeading = 1.9 * mm;
constexpr double belowTitle = 3 * mm; ///< between the title of a test and its first section
constexpr double afterSmallHeading = 1.2 * mm;
constexpr double betweenTables = 2.6 * mm;
constexpr double belowTable = 1.8 * mm; ///< between a table and its small print
constexpr double paragraphGap = 1.6 * mm;
constexpr double beforeVerdict = 3.8 * mm;
constexpr double beforeEnd = 8 * mm;

// Head of a test.
constexpr double logoHeight = 10 * mm;
constexpr double logoWidth = 50 * mm;
constexpr double logoGap = 3.5 * mm;
constexpr double nameGap = 1.1 * mm;
constexpr double titleGap = 4.5 * mm;
constexpr double subtitleGap = 1 * mm;
constexpr double ruleAbove = 3.2 * mm;
constexpr double ruleBelow = 2.6 * mm;
constexpr double leftColumn = 74 * mm;
constexpr double columnGap = 9 * mm;
constexpr double leftLabels = 25;  ///< mm
constexpr double rightLabels = 31; ///< mm

constexpr TextStyle h1{15, true, black, 1.2};
constexpr TextStyle h2{10.5, true, black, 1.2};
constexpr TextStyle h3{9, true, black, 1.28};
constexpr TextStyle subtitleStyle{10.5, false, black, 1.2};
constexpr TextStyle noteStyle{8.5, false, noteGrey, 1.2};
constexpr TextStyle smallStyle{8, false, noteGrey, 1.3};
constexpr TextStyle paragraphStyle{9, false, black, 1.35};
constexpr TextStyle narrowSmallStyle{7.5, false, noteGrey, 1.25};
constexpr TextStyle narrowParagraphStyle{8.5, false, black, 1.3};
constexpr TextStyle labelStyle{8.5, false, labelGrey, 1.28};
constexpr TextStyle valueStyle{9, false, black, 1.28};
constexpr TextStyle missingStyle{9, false, dashGrey, 1.28};
constexpr TextStyle narrowLabelStyle{8, false, labelGrey, 1.28};
constexpr TextStyle narrowValueStyle{8.5, false, black, 1.28};
constexpr TextStyle narrowMissingStyle{8.5, false, dashGrey, 1.28};

Strip strip(double height, std::function<void(QPainter &, QPointF)> draw) {
    Strip result;
    result.height = height;
    result.draw = std::move(draw);
    return result;
}

/// The same strips as parts of one element of the structure.
Strips tagged(const char *type, Strips strips) {
    const auto of = std::make_shared<char>();
    for (Strip &each : strips) {
        if (each.draw)
            each.draw = [type, of, draw = std::move(each.draw)](QPainter &painter, QPointF at) {
                const Tag tag(type, of.get());
                draw(painter, at);
            };
    }
    return strips;
}

double heightOf(const Strips &strips) {
    double height = 0;
    for (const Strip &each : strips)
        height += each.height + (&each == &strips.front() ? 0 : each.gap);
    return height;
}

void drawStrips(QPainter &painter, QPointF at, const Strips &strips) {
    for (const Strip &each : strips) {
        if (&each != &strips.front())
            at.ry() += each.gap;
        if (each.draw)
            each.draw(painter, at);
        at.ry() += each.height;
    }
}

Strip textStrip(TextBlock block, TextAlignment alignment = TextAlignment::left, double width = 0) {
    const double height = block.height();
    return strip(height, [block = std::move(block), alignment, width](QPainter &painter, QPointF at) {
        block.draw(painter, at, alignment, width);
    });
}

/// Lines of running text, at least two on each page.
Strips lineStrips(const TextBlock &block) {
    Strips result;
    for (std::size_t i = 0; i < block.lineCount(); ++i) {
        result.push_back(textStrip(block.line(i)));
        const bool ends = i == 0 || i + 2 == block.lineCount();
        result.back().withNext = ends && i + 1 < block.lineCount();
    }
    return result;
}

Strips keyValueStrips(const KeyValues &values, double width) {
    constexpr double labelRoom = 1.5 * mm; // at least, between a label and its value
    const double labelGap = (values.narrow ? 1.5 : 3.0) * mm;
    const double rowGap = (values.narrow ? 0.45 : 0.75) * mm;
    const TextStyle &labels = values.narrow ? narrowLabelStyle : labelStyle;
    const TextStyle &stated = values.narrow ? narrowValueStyle : valueStyle;
    const TextStyle &dashes = values.narrow ? narrowMissingStyle : missingStyle;
    const double left = values.labelWidth * mm + labelGap;
    Strips result;
    for (const KeyValue &row : values.rows) {
        const bool missing = row.value.isEmpty();
        TextBlock label(row.key, labels, left - labelRoom);
        TextBlock value(missing ? thinDash : row.value, missing ? dashes : stated,
                        std::max(width - left, 20.0));
        // Label and value share a baseline.
        const double drop = value.ascent() - label.ascent();
        const std::size_t lines = std::max(label.lineCount(), value.lineCount());
        constexpr std::size_t tallRow = 24; // split between its lines
        const std::size_t step = lines > tallRow ? 1 : lines;
        const double height = value.lineHeight() * static_cast<double>(step);
        const auto add = [&](TextBlock key, TextBlock stands) {
            result.push_back(strip(
                height, [=, key = std::move(key), stands = std::move(stands)](QPainter &painter, QPointF at) {
                    const Tag item("/LI");
                    {
                        const Tag tag("/Lbl");
                        key.draw(painter, at + QPointF(0, drop));
                    }
                    const Tag tag("/LBody");
                    stands.draw(painter, at + QPointF(left, 0));
                }));
        };
        const auto lineOf = [](const TextBlock &block, std::size_t index) {
            return index < block.lineCount() ? block.line(index) : TextBlock();
        };
        const std::size_t first = result.size();
        if (step == lines) {
            add(std::move(label), std::move(value));
        } else {
            for (std::size_t i = 0; i < lines; ++i)
                add(lineOf(label, i), lineOf(value, i));
        }
        if (first < result.size())
            result[first].gap = rowGap;
    }
    return tagged("/L", std::move(result));
}

/// Down to this size small texts shrink to fit on one line, points.
constexpr double smallestOfOneLine = 7.2;

Strips headingStrips(const Heading &heading, double width) {
    const TextStyle &style = heading.level == 1 ? h1 : heading.level == 2 ? h2 : h3;
    constexpr double noteGap = 2 * mm;
    const TextBlock title(heading.text, style, width);
    const double noteLeft = title.width() + noteGap;
    const TextStyle beside =
        fitted(noteStyle, smallestOfOneLine, width - noteLeft,
               [&](const TextStyle &tried) { return TextBlock(richText(heading.note), tried).width(); });
    const TextBlock wholeNote(richText(heading.note), beside);
    Strip result;
    const bool fits =
        title.lineCount() == 1 && wholeNote.lineCount() == 1 && noteLeft + wholeNote.width() <= width;
    if (heading.note.plain().isEmpty()) {
        result = textStrip(title);
    } else if (fits) {
        const double drop = title.ascent() - wholeNote.ascent();
        result = strip(title.height(), [=](QPainter &painter, QPointF at) {
            title.draw(painter, at);
            wholeNote.draw(painter, at + QPointF(noteLeft, drop));
        });
    } else {
        const TextBlock note(richText(heading.note), noteStyle, width);
        result = strip(title.height() + note.height(), [=](QPainter &painter, QPointF at) {
            title.draw(painter, at);
            note.draw(painter, at + QPointF(0, title.height()));
        });
    }
    result.withNext = true;
    return {result};
}

/// Short notes on one line, separated by thin strokes, or below each other if they are too long.
class NoteLine {
public:
    NoteLine(const QStringList &notes, double room) {
        double width = 0;
        for (const QString &note : notes) {
            for (const QString &line : note.split(u'\n', Qt::SkipEmptyParts)) {
                m_notes.emplace_back(line, style, room);
                width += m_notes.back().width() + (m_notes.size() > 1 ? noteGap : 0);
            }
        }
        m_beside = width <= room;
        for (const TextBlock &note : m_notes) {
            m_width = m_beside ? width : std::max(m_width, note.width());
            m_height = m_beside ? note.height() : m_height + note.height();
        }
    }

    [[nodiscard]] bool empty() const { return m_notes.empty(); }
    [[nodiscard]] double width() const { return m_width; }
    [[nodiscard]] double height() const { return m_height; }

    /// Draws from `at`; right-aligned notes end there.
    void draw(QPainter &painter, QPointF at, TextAlignment alignment) const {
        if (alignment == TextAlignment::right)
            at.rx() -= m_width;
        for (const TextBlock &note : m_notes) {
            const bool first = &note == &m_notes.front();
            if (m_beside && !first) {
                painter.setPen(QPen(ruleGrey, groupRule * mm, Qt::SolidLine, Qt::FlatCap));
                const QPointF stroke = at + QPointF(noteGap / 2, 0.15 * note.height());
                painter.drawLine(stroke, stroke + QPointF(0, 0.7 * note.height()));
                at.rx() += noteGap;
            }
            note.draw(painter, at, m_beside ? TextAlignment::left : alignment, m_width);
            at += m_beside ? QPointF(note.width(), 0) : QPointF(0, note.height());
        }
    }

private:
    static constexpr TextStyle style{8, false, noteGrey, 1.2};
    static constexpr double noteGap = 4 * mm;

    std::vector<TextBlock> m_notes;
    bool m_beside = false;
    double m_width = 0;
    double m_height = 0;
};

/// `name`: whose picture it is, for readers who do not see it.
void drawLogo(QPainter &painter, const QRectF &area, const Logo &logo, const QString &name) {
    if (logo.empty())
        return;
    const Tag tag(painter, area, name);
    logo.draw(painter, area);
}

/// Logo, name and address of the laboratory on the left, number and related data on the right.
Strip letterhead(const TestHead &head, double width) {
    const Logo logo(head.logo);
    const Logo mark(head.mark);
    const QSizeF logoSize = logo.size({logoWidth, logoHeight});
    const QSizeF markSize = mark.size({logoWidth, logoHeight});
    const double logoRoom = logo.empty() ? 0 : logoSize.width() + logoGap;
    const double markRoom = mark.empty() ? 0 : markSize.width() + logoGap;

    constexpr double half = 0.5;
    const TextBlock number(head.number, h2, width * half);
    const NoteLine numberNotes(head.numberNotes, width * half);
    const double numberWidth = std::max(number.width(), numberNotes.width());

    const double nameWidth = width - logoRoom - markRoom - numberWidth - logoGap;
    const TextBlock name(head.laboratory, h2, nameWidth);
    const NoteLine address({head.address, head.accreditation}, nameWidth);

    const auto heightOfBoth = [](const TextBlock &title, const NoteLine &notes) {
        return title.height() + (notes.empty() ? 0 : nameGap + notes.height());
    };
    const double height = std::max({heightOfBoth(name, address), heightOfBoth(number, numberNotes),
                                    logoSize.height(), markSize.height()});
    return strip(height, [=, laboratory = head.laboratory,
                          accreditation = head.accreditation](QPainter &painter, QPointF at) {
        const QPointF right = at + QPointF(width, 0);
        drawLogo(painter, QRectF(at, logoSize), logo, laboratory);
        drawLogo(painter, QRectF(right - QPointF(numberWidth + logoGap + markSize.width(), 0), markSize),
                 mark, accreditation);
        {
            const Tag tag("/P");
            name.draw(painter, at + QPointF(logoRoom, 0));
            address.draw(painter, at + QPointF(logoRoom, name.height() + nameGap), TextAlignment::left);
        }
        const Tag tag("/P");
        number.draw(painter, at, TextAlignment::right, width);
        numberNotes.draw(painter, right + QPointF(0, number.height() + nameGap), TextAlignment::right);
    });
}

/// Two columns side by side as one strip; below each other if they are higher than `tallest`.
Strips besideEachOther(Strips left, Strips right, double rightAt, double tallest) {
    const double height = std::max(heightOf(left), heightOf(right));
    if (height > tallest) {
        left.insert(left.end(), right.begin(), right.end());
        return left;
    }
    return {strip(height,
                  [left = std::move(left), right = std::move(right), rightAt](QPainter &painter, QPointF at) {
                      drawStrips(painter, at, left);
                      drawStrips(painter, at + QPointF(rightAt, 0), right);
                  })};
}

/// The letterhead below each other, line by line, if it is too high side by side.
Strips tallLetterhead(const TestHead &head, double width) {
    const Logo logo(head.logo);
    const Logo mark(head.mark);
    const QSizeF logoSize = logo.size({logoWidth, logoHeight});
    const QSizeF markSize = mark.size({logoWidth, logoHeight});
    Strips result{strip(std::max(logoSize.height(), markSize.height()), [=, laboratory = head.laboratory,
                                                                         accreditation = head.accreditation](
                                                                            QPainter &painter, QPointF at) {
        drawLogo(painter, QRectF(at, logoSize), logo, laboratory);
        drawLogo(painter, QRectF(at + QPointF(width - markSize.width(), 0), markSize), mark, accreditation);
    })};
    const auto add = [&](const QString &text, const TextStyle &style) {
        if (text.isEmpty())
            return;
        Strips lines = tagged("/P", lineStrips(TextBlock(text, style, width)));
        lines.front().gap = nameGap;
        std::ranges::move(lines, std::back_inserter(result));
    };
    add(head.laboratory, h2);
    add(head.address, smallStyle);
    add(head.accreditation, smallStyle);
    add(head.number, h2);
    for (const QString &note : head.numberNotes)
        add(note, smallStyle);
    return result;
}

Strips testHeadStrips(const TestHead &head, double width, double tallest) {
    Strips result{letterhead(head, width)};
    if (result.front().height > tallest / 2)
        result = tallLetterhead(head, width);
    const auto line = [&](const QString &text, const TextStyle &style, double gap) {
        if (text.isEmpty())
            return;
        TextBlock block(text, style, width);
        Strips lines;
        if (block.height() > tallest / 4)
            lines = lineStrips(block);
        else
            lines.push_back(textStrip(std::move(block)));
        lines = tagged(text == head.title ? "/H1" : "/P", std::move(lines));
        lines.front().gap = gap;
        std::ranges::move(lines, std::back_inserter(result));
    };
    line(head.title, h1, titleGap);
    line(head.subtitle, subtitleStyle, subtitleGap);
    const TextStyle small = fitted(noteStyle, smallestOfOneLine, width, [&](const TextStyle &style) {
        return TextBlock(head.editionTitle, style).width();
    });
    line(head.editionTitle, small, subtitleGap / 2);
    line(head.notice, {9, true, black, 1.28}, 2 * subtitleGap);
    result.push_back(strip(
        ruleBelow, [width](QPainter &painter, QPointF at) { drawRule(painter, at, width, strongRule); }));
    result.back().gap = ruleAbove;

    KeyValues left = head.left;
    left.labelWidth = leftLabels;
    KeyValues right = head.right;
    right.labelWidth = rightLabels;
    const double rightAt = leftColumn + columnGap;
    const Strips columns = besideEachOther(keyValueStrips(left, leftColumn),
                                           keyValueStrips(right, width - rightAt), rightAt, tallest / 2);
    result.insert(result.end(), columns.begin(), columns.end());
    for (std::size_t i = 0; i + 1 < result.size() && heightOf(result) < tallest; ++i)
        result[i].withNext = true;
    return result;
}

Strips legendStrips(const ResultsLegend &legend, double width) {
    constexpr double signGap = 0.9 * mm;
    constexpr double itemGap = 2.4 * mm;
    struct Item {
        LegendSign sign;
        TextBlock text;
        double x = 0;
        double y = 0;
    };
    std::vector<Item> items;
    double x = 0;
    double y = 0;
    const double lineHeight = smallStyle.size * smallStyle.leading;
    for (const LegendItem &item : legend.items) {
        const double sign = item.sign == LegendSign::none ? 0 : legendSignWidth(item.sign) * mm + signGap;
        TextBlock text(item.text, smallStyle);
        if (x > 0 && x + sign + text.width() > width) {
            x = 0;
            y += lineHeight;
        }
        if (sign + text.width() > width)
            text = TextBlock(item.text, smallStyle, width - sign);
        items.push_back({item.sign, text, x, y});
        x += sign + text.width() + itemGap;
        y += text.height() - lineHeight;
    }
    return {strip(y + lineHeight, [items, lineHeight](QPainter &painter, QPointF at) {
        for (const Item &item : items) {
            const double sign = legendSignWidth(item.sign) * mm;
            const QPointF left = at + QPointF(item.x, item.y);
            if (item.sign != LegendSign::none)
                drawLegendSign(painter, item.sign, left + QPointF(sign / 2, lineHeight / 2));
            item.text.draw(painter, left + QPointF(item.sign == LegendSign::none ? 0 : sign + signGap, 0));
        }
    })};
}

/// A part of the verdict: label, mark, state and explanation.
struct StatementBlock {
    TextBlock label;
    Mark mark = Mark::none;
    TextBlock state; ///< in a large verdict above the text, otherwise at its beginning
    TextBlock text;
    double textAt = 0; ///< behind label and mark

    [[nodiscard]] double height() const { return std::max(label.height(), state.height() + text.height()); }
};

constexpr double statementMark = 4 * mm;
constexpr TextStyle ofStatementLabel{8.5, false, black, 1.25};

/// Room for the labels of the statements of a verdict.
double statementLabel(const VerdictLine &line) {
    constexpr double least = 13.5 * mm;
    constexpr double behind = 1.5 * mm;
    return std::max({least, TextBlock(line.limits.label, ofStatementLabel).width() + behind,
                     TextBlock(line.accordance.label, ofStatementLabel).width() + behind});
}

StatementBlock statementBlock(const VerdictStatement &statement, double width, double label, bool large) {
    constexpr TextStyle text{8.5, false, black, 1.25};
    constexpr TextStyle largeState{10, true, black, 1.25};
    constexpr TextStyle largeText{8.5, false, noteGrey, 1.25};
    StatementBlock result{
        TextBlock(statement.label, ofStatementLabel), statement.mark, {}, {}, label + statementMark};
    const double room = width - result.textAt;
    RichText words = richText(statement.text);
    const bool empty = statement.text.plain().isEmpty();
    if (large) {
        result.state = TextBlock(statement.state, largeState, room);
        if (!empty)
            result.text = TextBlock(words, largeText, room);
        return result;
    }
    TextRun state;
    state.text = empty ? statement.state : statement.state + u' ';
    state.bold = true;
    words.insert(words.begin(), state);
    TextStyle style = text;
    constexpr double smallest = 7.5;
    constexpr std::size_t mostLines = 3;
    while (style.size > smallest && TextBlock(words, style, room).lineCount() > mostLines)
        style.size -= 0.1;
    result.text = TextBlock(words, style, room);
    return result;
}

void drawStatement(QPainter &painter, QPointF at, const StatementBlock &statement) {
    statement.label.draw(painter, at);
    const TextBlock &first = statement.state.empty() ? statement.text : statement.state;
    const double mark = markBox * mm;
    drawMark(painter, statement.mark,
             at + QPointF(statement.textAt - statementMark + mark / 2, first.lineHeight() / 2), mark);
    const QPointF text = at + QPointF(statement.textAt, 0);
    if (!statement.state.empty())
        statement.state.draw(painter, text);
    if (!statement.text.empty())
        statement.text.draw(painter,
                            text + QPointF(0, statement.state.empty() ? 0 : statement.state.height()));
}

/// The text with a line break at the space nearest to its middle.
QString inTwoLines(QString text) {
    const auto fromMiddle = [&](qsizetype at) { return std::abs(2 * at + 1 - text.size()); };
    qsizetype best = text.indexOf(u' ');
    for (qsizetype at = best; at >= 0; at = text.indexOf(u' ', at + 1))
        best = fromMiddle(at) < fromMiddle(best) ? at : best;
    return best < 0 ? text : text.replace(best, 1, u'\n');
}

/// The large word with its second line, both at the largest size that fits their column; words that would
/// become small are broken.
TextBlock verdictWord(const VerdictLine &line, double width) {
    constexpr qsizetype longWord = 12;
    constexpr double smallest = 8;
    constexpr double small = 10;
    TextStyle style{12, true, black, 1.2};
    if (line.large)
        style.size = std::max(line.word.size(), line.second.size()) > longWord ? 14 : 18;
    const auto widthOf = [](const QString &text) {
        return [text](const TextStyle &tried) { return TextBlock(text, tried).width(); };
    };
    QStringList lines{line.word, line.second};
    lines.removeAll(QString());
    for (QString &each : lines) {
        if (fitted(style, smallest, width, widthOf(each)).size < small)
            each = inTwoLines(each);
    }
    const QString text = lines.join(u'\n');
    return {text, fitted(style, smallest, width, widthOf(text)), width};
}

Strips verdictStrips(const VerdictLine &line, double width) {
    constexpr double left = 1.2 * mm;
    const double padding = (line.large ? 3.2 : 1.9) * mm;
    const double column = (line.large ? 60 : 50) * mm;
    const double rightAt = column + (line.large ? 5 : 4) * mm;
    const double gap = (line.large ? 1.4 : 0.9) * mm; // above and below the hairline
    const double largeMark = (line.large ? 4.8 : 3.4) * mm;
    const double wordLeft = line.mark == Mark::none ? 0 : largeMark + 1.2 * mm;
    const TextBlock label(line.label, {9, false, black, 1.28});
    const TextBlock word = verdictWord(line, column - left - wordLeft);
    const TextBlock note =
        line.note.isEmpty() ? TextBlock() : TextBlock(line.note, smallStyle, column - left);
    const double labels = statementLabel(line);
    const StatementBlock limits = statementBlock(line.limits, width - rightAt - left, labels, line.large);
    const StatementBlock accordance =
        statementBlock(line.accordance, width - rightAt - left, labels, line.large);

    const double leftHeight = label.height() + word.height() + note.height();
    const bool isAlone = line.accordance == VerdictStatement(); // no hairline then
    const double rightHeight = limits.height() + (isAlone ? 0 : accordance.height() + 2 * gap);
    const double inner = std::max(leftHeight, rightHeight);
    const double height = inner + 2 * padding;
    return {strip(height, [=, mark = line.mark, large = line.large](QPainter &painter, QPointF at) {
        drawRule(painter, at, width, strongRule);
        drawRule(painter, at + QPointF(0, height), width, strongRule);
        // The word is read first, however long the reasons are.
        QPointF place = at + QPointF(left, padding + (large ? (inner - leftHeight) / 2 : 0));
        label.draw(painter, place);
        place.ry() += label.height();
        drawMark(painter, mark, place + QPointF(largeMark / 2, word.lineHeight() / 2), largeMark);
        word.draw(painter, place + QPointF(wordLeft, 0));
        place.ry() += word.height();
        if (!note.empty())
            note.draw(painter, place);
        place = at + QPointF(rightAt, padding + (inner - rightHeight) / 2);
        drawStatement(painter, place, limits);
        place.ry() += limits.height() + gap;
        if (isAlone)
            return;
        drawRule(painter, place, width - rightAt - left, groupRule, groupGrey);
        place.ry() += gap;
        drawStatement(painter, place, accordance);
    })};
}

/// A heading at the largest size that fits its column.
TextBlock signatureHeading(const QString &text, double width) {
    constexpr double smallest = 7.5;
    const auto widthOf = [&](const TextStyle &style) { return TextBlock(text, style).width(); };
    return {text, fitted(h3, smallest, width, widthOf), width};
}

std::vector<double> signatureWidths(const Signatures &signatures, double width, double gap) {
    double fixed = 0;
    double sharing = 0;
    for (const SignatureColumn &column : signatures.columns) {
        fixed += column.width * mm;
        sharing += column.width > 0 ? 0 : 1;
    }
    const double gaps = gap * (static_cast<double>(signatures.columns.size()) - 1);
    std::vector<double> result;
    for (const SignatureColumn &column : signatures.columns)
        result.push_back(column.width > 0 ? column.width * mm : (width - gaps - fixed) / sharing);
    return result;
}

/// Columns of lines to fill in or sign; neighbouring lines have the same height, so that all rules are level.
class SignatureBlock {
public:
    SignatureBlock(const Signatures &signatures, double width)
        : m_signatures(signatures)
        , m_widths(signatureWidths(signatures, width, gap)) {
        for (std::size_t c = 0; c < signatures.columns.size(); ++c) {
            const SignatureColumn &column = signatures.columns[c];
            if (!column.heading.isEmpty())
                m_headings = std::max(m_headings, signatureHeading(column.heading, m_widths[c]).height());
            m_heights.resize(std::max(m_heights.size(), column.lines.size()));
            m_columns.emplace_back();
            for (std::size_t i = 0; i < column.lines.size(); ++i) {
                m_columns.back().push_back(made(column.lines[i], m_widths[c]));
                m_heights[i] = std::max(m_heights[i], neededBy(column.lines[i], m_columns.back().back()));
            }
        }
    }

    [[nodiscard]] double height() const {
        return std::accumulate(m_heights.begin(), m_heights.end(), m_headings) + groupRule * mm;
    }

    void draw(QPainter &painter, QPointF at) const {
        for (std::size_t c = 0; c < m_columns.size(); ++c) {
            const SignatureColumn &column = m_signatures.columns[c];
            if (!column.heading.isEmpty()) {
                const Tag tag("/P");
                signatureHeading(column.heading, m_widths[c]).draw(painter, at);
            }
            QPointF top = at + QPointF(0, m_headings);
            for (std::size_t i = 0; i < m_columns[c].size(); ++i) {
                drawLine(painter, top, column.lines[i], m_columns[c][i], m_heights[i]);
                top.ry() += m_heights[i];
                drawRule(painter, top, m_widths[c], groupRule);
            }
            at.rx() += m_widths[c] + gap;
        }
    }

private:
    struct Line {
        TextBlock label;
        TextBlock value;

        /// Height of the value beyond one line.
        [[nodiscard]] double more() const { return value.empty() ? 0 : value.height() - value.lineHeight(); }
    };

    [[nodiscard]] static Line made(const SignatureLine &line, double width) {
        constexpr TextStyle labelText{8, false, labelGrey, 1.2};
        constexpr TextStyle valueText{9, false, black, 1.2};
        Line result{TextBlock(line.label, labelText), {}};
        if (!line.value.isEmpty())
            result.value = TextBlock(line.value, valueText,
                                     line.height > 0 ? width : width - result.label.width() - labelGap);
        return result;
    }

    [[nodiscard]] double neededBy(const SignatureLine &line, const Line &made) const {
        const double empty = line.forSignature     ? signatureHeight
                             : m_signatures.narrow ? narrowLine
                                                   : lineHeight;
        return (line.height > 0 ? line.height * mm : empty) + made.more();
    }

    static void drawLine(QPainter &painter, QPointF at, const SignatureLine &line, const Line &made,
                         double height) {
        const Tag tag("/P");
        const double bottom = at.y() + height - labelAbove - made.more();
        if (line.height > 0) { // the value is below the label
            made.label.draw(painter, at);
            made.value.draw(painter, {at.x(), bottom});
            return;
        }
        const double top = line.forSignature ? at.y() + signatureLabel : bottom;
        made.label.draw(painter, {at.x(), top});
        made.value.draw(painter, {at.x() + made.label.width() + labelGap,
                                  top + made.label.ascent() - made.value.ascent()});
    }

    static constexpr double gap = 8 * mm;
    static constexpr double lineHeight = 7.4 * mm;
    static constexpr double narrowLine = 5.6 * mm;
    static constexpr double signatureHeight = 17 * mm; ///< 12 mm free below the label
    static constexpr double signatureLabel = 1.2 * mm;
    static constexpr double labelAbove = 4 * mm; ///< from a label to its rule
    static constexpr double labelGap = 2 * mm;

    Signatures m_signatures;
    std::vector<double> m_widths;
    double m_headings = 0;
    std::vector<double> m_heights;
    std::vector<std::vector<Line>> m_columns;
};

Strips signatureStrips(const Signatures &signatures, double width) {
    const SignatureBlock block(signatures, width);
    return {strip(block.height(), [block](QPainter &painter, QPointF at) { block.draw(painter, at); })};
}

/// Gap between two blocks.
double gapBetween(const Block &above, const Block &below) {
    const auto *heading = std::get_if<Heading>(&above);
    if (std::holds_alternative<TestHead>(above))
        return afterHead;
    if (beginsSection(below))
        return heading && heading->level == 1 ? belowTitle : sectionGap;
    if (heading)
        return heading->level <= 2 ? afterHeading : afterSmallHeading;
    if (std::holds_alternative<ResultsLegend>(below))
        return belowTable;
    if (std::holds_alternative<VerdictLine>(below))
        return beforeVerdict;
    if (std::holds_alternative<EndMark>(below))
        return beforeEnd;
    const auto *paragraph = std::get_if<Paragraph>(&below);
    if (paragraph)
        return paragraph->size == palmer::TextSize::small ? belowTable : paragraphGap;
    if (std::holds_alternative<Table>(below))
        return betweenTables;
    return sectionGap / 2;
}

bool staysBelow(const Block &block) {
    const auto *paragraph = std::get_if<Paragraph>(&block);
    return std::holds_alternative<ResultsLegend>(block) || std::holds_alternative<VerdictLine>(block) ||
           std::holds_alternative<EndMark>(block) ||
           (paragraph && paragraph->size == palmer::TextSize::small);
}

bool isTitle(const Block &block) {
    const auto *heading = std::get_if<Heading>(&block);
    return heading && heading->level == 1;
}

/// True if a paragraph between a heading and block i belongs to that block: a table, a figure or a part of
/// the section.
template <class AnyStrip>
bool introduces(const std::vector<BlockWith<AnyStrip>> &blocks, std::size_t i) {
    const Block &block = *blocks[i].block;
    const auto *heading = std::get_if<Heading>(&block);
    return i > 1 && std::holds_alternative<Paragraph>(*blocks[i - 1].block) &&
           std::holds_alternative<Heading>(*blocks[i - 2].block) &&
           (std::holds_alternative<Table>(block) || std::holds_alternative<FigureBlock>(block) ||
            (heading && heading->level > 2));
}

/// Sets the properties of a heading (block i) that depend on the next block.
template <class AnyStrip>
void stateOfHeading(AnyStrip &strip, const std::vector<BlockWith<AnyStrip>> &blocks, std::size_t i,
                    bool titled) {
    const auto *heading = std::get_if<Heading>(&*blocks[i].block);
    if (!heading || i + 1 == blocks.size())
        return;
    const Block &next = *blocks[i + 1].block;
    strip.title = isTitle(*blocks[i].block);
    strip.filler = titled && std::holds_alternative<FindingsBlock>(next);
    if (heading->level == 2 && (beginsSection(next) || isMark(next)))
        strip.withNext = false; // the section is only the heading's note
}

/// Keeps the section of the signatures together, of a long one its last strips, so that signatures are never
/// alone on a page.
void takeAlong(auto &above) {
    constexpr std::size_t mostOfSection = 12;
    constexpr std::size_t most = 3;
    const auto stays = [](const StripPlace &strip) { return !strip.pageBreak && !strip.running; };
    std::size_t first = above.size();
    while (first > 0 && stays(above[first - 1]) && (first == above.size() || !above[first].section))
        --first;
    if (above.size() - first > mostOfSection)
        first = above.size() - most;
    for (std::size_t i = first; i < above.size(); ++i)
        above[i].withNext = true;
}

Strips partStrips(const std::vector<Part> &parts, double width, double tallest) {
    std::vector<Block> blocks;
    for (const Part &part : parts)
        std::visit([&](const auto &block) { blocks.emplace_back(block); }, part);
    return blockStrips(blocks, width, tallest);
}

class StripMaker {
public:
    StripMaker(std::shared_ptr<const Block> owner, double width, double tallest, bool narrow)
        : m_owner(std::move(owner))
        , m_width(width)
        , m_tallest(tallest)
        , m_narrow(narrow) {}

    Strips operator()(const Heading &heading) const {
        return tagged(heading.level == 1   ? "/H1"
                      : heading.level == 2 ? "/H2"
                                           : "/H3",
                      headingStrips(heading, m_width));
    }
    Strips operator()(const Paragraph &paragraph) const {
        if (paragraph.text.isEmpty())
            return {};
        const bool small = paragraph.size == palmer::TextSize::small;
        const TextStyle &style = m_narrow ? (small ? narrowSmallStyle : narrowParagraphStyle)
                                          : (small ? smallStyle : paragraphStyle);
        Strips lines = lineStrips(TextBlock(paragraph.text, style, m_width));
        for (Strip &line : lines)
            line.inText = true;
        return tagged("/P", std::move(lines));
    }
    Strips operator()(const KeyValues &values) const { return keyValueStrips(values, m_width); }
    Strips operator()(const Table &table) const {
        return tagged("/Table", tableStrips(std::shared_ptr<const Table>(m_owner, &table), m_width));
    }
    Strips operator()(const SideBySide &columns) const {
        const double leftWidth = columns.leftWidth * mm;
        const double rightAt = leftWidth + columns.gap * mm;
        const Strips left = partStrips(columns.left, leftWidth, m_tallest);
        const Strips right = partStrips(columns.right, m_width - rightAt, m_tallest);
        Strips result = besideEachOther(left, right, rightAt, m_tallest);
        if (result.size() == 1 && !left.empty() && left.back().drawOf) {
            // The figure shrinks as far as the other column allows.
            const double above = heightOf(left) - left.back().height;
            result.front().least =
                std::min(result.front().height, std::max(above + left.back().least, heightOf(right)));
            result.front().drawOf = [left, right, rightAt, above](double height) {
                Strips lower = left;
                lower.back().height = std::min(left.back().height, height - above);
                lower.back().draw = left.back().drawOf(lower.back().height);
                return [lower, right, rightAt](QPainter &painter, QPointF at) {
                    drawStrips(painter, at, lower);
                    drawStrips(painter, at + QPointF(rightAt, 0), right);
                };
            };
        }
        return result;
    }
    Strips operator()(const TestHead &head) const { return testHeadStrips(head, m_width, m_tallest); }
    Strips operator()(const FigureBlock &figure) const {
        const auto drawOf = [content = figure.figure, width = figure.width * mm](double height) {
            return [content, size = QSizeF(width, height)](QPainter &painter, QPointF at) {
                const Tag tag(painter, QRectF(at, size), *content);
                drawFigure(painter, QRectF(at, size), *content, Medium::paper);
            };
        };
        const double height = figure.height * mm;
        Strip result = strip(height, drawOf(height));
        const auto *circle = std::get_if<CircleFigure>(&*figure.figure);
        const double readable = std::max(figure.least, circle ? leastHeight(*circle) : 0) * mm;
        result.least = std::min(height, readable);
        result.drawOf = drawOf;
        return {result};
    }
    Strips operator()(const ResultsLegend &legend) const {
        return tagged("/P", legendStrips(legend, m_width));
    }
    Strips operator()(const VerdictLine &line) const {
        Strips result = tagged("/P", verdictStrips(line, m_width));
        result.front().link = line.anchor;
        return result;
    }
    Strips operator()(const FindingsBlock &findings) const {
        return tagged("/L", findingStrips(findings, m_width));
    }
    Strips operator()(const Signatures &signatures) const { return signatureStrips(signatures, m_width); }
    Strips operator()(const EndMark &mark) const {
        return tagged("/P",
                      {textStrip(TextBlock(mark.text, smallStyle, m_width), TextAlignment::centre, m_width)});
    }
    Strips operator()(const RunningHead &running) const {
        Strip result;
        result.running = std::make_shared<const RunningHead>(running);
        result.narrow = m_narrow;
        return {result};
    }
    Strips operator()(const PageBreak &) const {
        Strip result;
        result.pageBreak = true;
        return {result};
    }

private:
    std::shared_ptr<const Block> m_owner;
    double m_width;
    double m_tallest;
    bool m_narrow;
};

} // namespace

void levelColumns(SideBySide &both, double width, double tallest) {
    if (!both.levelled)
        return;
    const auto taken = [](std::vector<Part> &column) {
        KeyValues rows = std::get<KeyValues>(std::move(column.back()));
        column.pop_back();
        return rows;
    };
    KeyValues left = taken(both.left);
    KeyValues right = taken(both.right);
    left.rows.insert(left.rows.end(), right.rows.begin(), right.rows.end());
    right.rows.clear();
    const double leftWidth = both.leftWidth * mm;
    const double rightWidth = width - leftWidth - both.gap * mm;
    const auto heightIn = [&](KeyValues column, const KeyValue &row, double columnWidth) {
        column.rows = {row};
        const Strips strips = keyValueStrips(column, columnWidth);
        return heightOf(strips) + strips.front().gap;
    };
    double ofLeft = heightOf(partStrips(both.left, leftWidth, tallest));
    double ofRight = heightOf(partStrips(both.right, rightWidth, tallest));
    for (const KeyValue &row : left.rows)
        ofLeft += heightIn(left, row, leftWidth);
    double least = std::max(ofLeft, ofRight);
    std::size_t kept = left.rows.size();
    for (std::size_t i = left.rows.size(); i-- > 0;) {
        ofLeft -= heightIn(left, left.rows[i], leftWidth);
        ofRight += heightIn(right, left.rows[i], rightWidth);
        if (std::max(ofLeft, ofRight) < least) {
            least = std::max(ofLeft, ofRight);
            kept = i;
        }
    }
    const auto cut = left.rows.begin() + static_cast<std::ptrdiff_t>(kept);
    right.rows.assign(cut, left.rows.end());
    left.rows.erase(cut, left.rows.end());
    both.left.emplace_back(std::move(left));
    both.right.emplace_back(std::move(right));
}

const Heading *sectionHeading(const Block &block) {
    const auto *columns = std::get_if<SideBySide>(&block);
    const Heading *heading =
        columns ? columns->left.empty() ? nullptr : std::get_if<Heading>(&columns->left.front())
                : std::get_if<Heading>(&block);
    return heading && heading->level <= 2 ? heading : nullptr;
}

bool beginsSection(const Block &block) {
    return sectionHeading(block) != nullptr;
}

bool isMark(const Block &block) {
    return std::holds_alternative<RunningHead>(block) || std::holds_alternative<PageBreak>(block);
}

Strips measured(const std::shared_ptr<const Block> &block, double width, double tallest, bool narrow) {
    Strips result = std::visit(StripMaker(block, width, tallest, narrow), *block);
    int index = 0;
    for (Strip &strip : result) {
        strip.index = index++;
        strip.drawn = strip.draw != nullptr;
        strip.lowers = strip.drawOf != nullptr;
    }
    return result;
}

/// The head of a table is the strip before its first row.
StripPlaces placesOf(const Strips &strips) {
    StripPlaces result;
    result.reserve(strips.size());
    const StripPlace *known = nullptr;
    std::shared_ptr<const StripPlace> head;
    for (const Strip &strip : strips) {
        if (strip.head && strip.head.get() != known) {
            known = strip.head.get();
            head = std::make_shared<const StripPlace>(result.back());
        }
        result.push_back(strip);
        if (strip.head)
            result.back().head = head;
    }
    return result;
}

namespace {

/// A head needs its own page; other parts may follow results that were moved to this page.
template <class AnyStrip>
bool isSoftBreak(const std::vector<BlockWith<AnyStrip>> &blocks, std::size_t pageBreak) {
    const std::size_t next = pageBreak + 1;
    const auto *heading = next < blocks.size() ? std::get_if<Heading>(&*blocks[next].block) : nullptr;
    return heading && heading->level == 1;
}

template <class AnyStrip>
std::vector<AnyStrip> withGaps(const std::vector<BlockWith<AnyStrip>> &blocks) {
    std::size_t count = 0;
    for (const BlockWith<AnyStrip> &each : blocks)
        count += each.strips.size();
    std::vector<AnyStrip> result;
    result.reserve(count);
    const Block *above = nullptr;
    bool titled = false; // below the title of a test among several
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Block &block = *blocks[i].block;
        if (blocks[i].strips.empty())
            continue;
        if (std::holds_alternative<Signatures>(block))
            takeAlong(result);
        if (above && !isMark(block) && !result.empty() && (staysBelow(block) || introduces(blocks, i)))
            result.back().withNext = true;
        const std::size_t first = result.size();
        result.insert(result.end(), blocks[i].strips.begin(), blocks[i].strips.end());
        for (std::size_t k = first; k < result.size(); ++k)
            result[k].owner = static_cast<int>(i);
        AnyStrip &begins = result[first];
        if (!isMark(block)) {
            begins.gap = above ? gapBetween(*above, block) : 0;
            begins.block = static_cast<int>(i);
            begins.section = beginsSection(block);
            if (const auto *table = std::get_if<Table>(&block))
                result.back().whole = table->unbroken;
            titled = titled || isTitle(block);
            stateOfHeading(begins, blocks, i, titled);
            above = &block;
        } else if (std::holds_alternative<PageBreak>(block)) {
            begins.soft = isSoftBreak(blocks, i);
            if (!begins.soft)
                above = nullptr;
        }
    }
    return result;
}

} // namespace

StripPlaces joined(const MeasuredBlocks &blocks) {
    return withGaps(blocks);
}

Strips blockStrips(const std::vector<Block> &blocks, double width, double tallest) {
    std::vector<BlockWith<Strip>> all;
    for (const Block &block : blocks) {
        const auto own = std::make_shared<Block>(block);
        all.push_back({own, measured(own, width, tallest)});
    }
    return withGaps(all);
}

} // namespace palmer
