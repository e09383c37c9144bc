// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/pdf/textblock.h"

#include "kernel/evaluation/edition.h"
#include "language/papercharacters.h"
#include "print/fonts.h"
#include "print/pdf/tags.h"

#include <QFontMetricsF>
#include <QGlyphRun>
#include <QHash>
#include <QPaintEngine>
#include <QPainter>
#include <QRawFont>
#include <QVarLengthArray>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace palmer {

namespace {

/// Text is measured and drawn in these units. In them most of it, of 8.5 points, is as large as the em square
/// of its font: its advances are whole numbers, which Qt writes shorter into the PDF. Sizes are whole units.
constexpr double unitsPerPoint = 2048 / 8.5;
constexpr double scriptSize = 0.75;
constexpr double paperSubscriptDrop = 0.22; ///< fraction of the text size
constexpr double superscriptRise = 0.36;
/// Liberation Sans, fractions of the size.
constexpr double fontAscent = 0.905;
constexpr double fontDescent = 0.212;

/// Characters that are drawn glyph by glyph: Latin letters, digits and the signs that go with them. In the
/// paper font a text of them is as wide as its characters and what each pair is kerned, and none of them
/// makes a ligature; shaping it takes many times as long.
constexpr std::u16string_view plainSigns = u"–—’“”…−≤≥↑↓\u202F";
constexpr std::size_t firstPlain = 0x20;
constexpr std::size_t plainLatin = 0x100 - firstPlain;
constexpr std::size_t plainCount = plainLatin + plainSigns.size();

/// Index of a plain character; plainCount for others.
std::size_t plainIndex(QChar character) {
    const char16_t c = character.unicode();
    constexpr char16_t noBreakSpace = 0xa0;
    constexpr char16_t softHyphen = 0xad;
    if (c < firstPlain + plainLatin)
        return (c >= firstPlain && c < 0x7f) || (c >= noBreakSpace && c != softHyphen) ? c - firstPlain
                                                                                       : plainCount;
    const std::size_t sign = plainSigns.find(c);
    return sign == std::u16string_view::npos || !isOnPaper(c) ? plainCount : plainLatin + sign;
}

/// Advances and glyphs of plain characters in a font, measured when they are first needed. In 64ths of a
/// pixel, as Qt counts.
class PlainGlyphs {
public:
    explicit PlainGlyphs(const QFont &font)
        : m_metrics(font)
        , m_raw(QRawFont::fromFont(font)) {}

    /// Calls `visit` with glyph and place of each character. Returns the advance of all, null if some are not
    /// plain.
    std::optional<double> each(const QString &text, auto visit) {
        int x = 0;
        std::size_t before = plainCount;
        for (const QChar &c : text) {
            const std::size_t index = plainIndex(c);
            if (index == plainCount)
                return std::nullopt;
            const Known &known = knownOf(index, c);
            if (before < plainCount)
                x += kerning(before, index, &c);
            visit(known.glyph, x / parts);
            x += known.advance;
            before = index;
        }
        return x / parts;
    }

    [[nodiscard]] const QRawFont &raw() const { return m_raw; }

private:
    struct Known {
        quint32 glyph = 0;
        int advance = -1; ///< not measured yet
    };
    static constexpr double parts = 64;
    static constexpr int unknown = std::numeric_limits<int>::max();

    [[nodiscard]] int advanceOf(const QString &text) const {
        return qRound(m_metrics.horizontalAdvance(text) * parts);
    }

    const Known &knownOf(std::size_t index, QChar character) {
        Known &known = m_known[index];
        if (known.advance < 0)
            known = {m_raw.glyphIndexesForString(character).value(0), advanceOf(character)};
        return known;
    }

    /// `second`: the second character, which follows the first in its text.
    int kerning(std::size_t first, std::size_t index, const QChar *second) {
        int &kerned = m_kerning[first * plainCount + index];
        if (kerned == unknown)
            kerned = advanceOf(QString(second - 1, 2)) - m_known[first].advance - m_known[index].advance;
        return kerned;
    }

    QFontMetricsF m_metrics;
    QRawFont m_raw;
    std::array<Known, plainCount> m_known = {};
    std::vector<int> m_kerning = std::vector<int>(plainCount * plainCount, unknown);
};

struct Face {
    QFont font;
    QFontMetricsF metrics;
    PlainGlyphs plain;
    QHash<QString, double> widths = {}; ///< of other short texts
};

/// Caches fonts and metrics: a report draws thousands of short texts in a dozen fonts.
Face &face(double size, bool bold, bool italic) {
    thread_local std::map<int, Face> faces;
    const int pixels = qRound(size * unitsPerPoint);
    const int key = 4 * pixels + 2 * (bold ? 1 : 0) + (italic ? 1 : 0);
    const auto known = faces.find(key);
    if (known != faces.end())
        return known->second;
    loadFonts();
    const QFont font = paperFont(pixels, bold, italic);
    return faces.emplace(key, Face{font, QFontMetricsF(font), PlainGlyphs(font)}).first->second;
}

double sizeOf(const TextRun &look, const TextStyle &style) {
    return look.script == TextRun::Script::normal ? style.size : scriptSize * style.size;
}

Face &face(const TextRun &run, const TextStyle &style) {
    return face(sizeOf(run, style), run.bold || style.bold, run.italic);
}

/// A report repeats its words and numbers, and shaping them takes most of the time of its layout.
double advance(Face &face, const QString &text) {
    if (const auto plain = face.plain.each(text, [](quint32, double) {}))
        return *plain;
    constexpr qsizetype longest = 40;
    constexpr qsizetype most = 20'000;
    if (text.size() > longest)
        return face.metrics.horizontalAdvance(text);
    if (face.widths.size() >= most)
        face.widths.clear();
    const auto known = face.widths.constFind(text);
    return known != face.widths.cend() ? *known
                                       : *face.widths.insert(text, face.metrics.horizontalAdvance(text));
}

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): counts of one thread
thread_local std::size_t measuredLetters = 0;
/// Null unless requested.
thread_local std::optional<std::vector<QRectF>> foreignPlaces;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

bool needsOtherFont(const QString &text) {
    constexpr char16_t endOfLatin = 0x370;
    return std::ranges::any_of(text, [](QChar c) { return c.unicode() >= endOfLatin; }) &&
           !notOnPaper(text).empty();
}

/// Pieces of a text in the paper font, and single characters that it lacks.
struct TextPiece {
    QString text;
    char32_t foreign = 0; ///< 0: the text is in the paper font
};

std::vector<TextPiece> piecesOf(const QString &text) {
    std::vector<TextPiece> result;
    for (const char32_t character : text.toUcs4()) {
        const QString sign = QString::fromUcs4(&character, 1);
        if (!isOnPaper(character))
            result.push_back({sign, character});
        else if (result.empty() || result.back().foreign != 0)
            result.push_back({sign});
        else
            result.back().text += sign;
    }
    return result;
}

double widthOf(const TextPiece &piece, const TextRun &look, const TextStyle &style) {
    if (piece.foreign != 0)
        return foreignWidth(piece.foreign) * sizeOf(look, style);
    return advance(face(look, style), piece.text) / unitsPerPoint;
}

/// Characters of other fonts have a fixed width, so that it does not depend on the installed fonts.
double widthOf(const QString &text, const TextRun &look, const TextStyle &style) {
    measuredLetters += static_cast<std::size_t>(text.size());
    if (!needsOtherFont(text))
        return advance(face(look, style), text) / unitsPerPoint;
    double width = 0;
    for (const TextPiece &piece : piecesOf(text))
        width += widthOf(piece, look, style);
    return width;
}

/// Draws a plain text; returns false for others. Only for PDF.
bool drawPlain(TextUnits &units, QPointF at, PlainGlyphs &plain, const QString &text, QRgb colour) {
    if (!units.isPdf())
        return false;
    QVarLengthArray<quint32, 64> glyphs;
    QVarLengthArray<QPointF, 64> places;
    const bool isPlain = plain
                             .each(text,
                                   [&](quint32 glyph, double x) {
                                       glyphs.append(glyph);
                                       places.append({at.x() + x, at.y()});
                                   })
                             .has_value();
    if (isPlain)
        units.add(plain.raw(), colour, glyphs, places);
    return isPlain;
}

/// Draws on a baseline, in units. Characters of other fonts are fitted to their fixed width.
void drawRun(TextUnits &units, QPointF at, const TextRun &run, const TextStyle &style) {
    Face &own = face(run, style);
    const QRgb colour = run.grey ? noteGrey : style.colour;
    if (drawPlain(units, at, own.plain, run.text, colour))
        return;
    QPainter &painter = units.painter();
    painter.setPen(QColor::fromRgb(colour));
    painter.setFont(own.font);
    if (!needsOtherFont(run.text)) {
        painter.drawText(at, run.text);
        return;
    }
    for (const TextPiece &piece : piecesOf(run.text)) {
        const double width = widthOf(piece, run, style) * unitsPerPoint;
        const double needed = piece.foreign == 0 ? 0 : own.metrics.horizontalAdvance(piece.text);
        if (foreignPlaces && piece.foreign != 0)
            foreignPlaces->push_back(painter.combinedTransform().mapRect(
                QRectF(at.x(), at.y() - own.metrics.ascent(), width, own.metrics.height())));
        if (needed > width && width > 0) {
            painter.save();
            painter.translate(at);
            painter.scale(width / needed, 1);
            painter.drawText(QPointF(0, 0), piece.text);
            painter.restore();
        } else {
            painter.drawText(at + QPointF(piece.foreign == 0 ? 0 : (width - needed) / 2, 0), piece.text);
        }
        at.rx() += width;
    }
}

double widthOf(const TextRun &run, const TextStyle &style) {
    return widthOf(run.text, run, style);
}

bool sameLook(const TextRun &a, const TextRun &b) {
    return a.bold == b.bold && a.italic == b.italic && a.script == b.script && a.grey == b.grey;
}

TextRun part(const TextRun &run, qsizetype from, qsizetype length) {
    TextRun result = run;
    result.text = run.text.mid(from, length);
    return result;
}

/// An unbreakable word with the space before it. The format may change within a word.
struct Word {
    std::vector<TextRun> runs;
    bool spaceBefore = false;
    bool newLine = false;
};

bool isSpace(QChar c) {
    return c == u' ' || c == u'\t';
}

bool isWhole(QStringView word) {
    return std::ranges::all_of(word, [](QChar c) { return c.isDigit(); });
}

/// True if the word begins with a group of three digits: "000", "000,5", "000)".
bool beginsWithGroup(QStringView word) {
    constexpr qsizetype group = 3;
    return word.size() >= group && isWhole(word.first(group)) &&
           (word.size() == group || !word[group].isLetterOrNumber());
}

/// Both sides of a space within the designation of an edition, up to its number: "JIS", "B " and "JIS B", "".
struct DesignationSpace {
    QString before;
    QString after;

    bool operator==(const DesignationSpace &) const = default;
};

const std::vector<DesignationSpace> &spacesOfDesignations() {
    static const std::vector<DesignationSpace> spaces = [] {
        std::vector<DesignationSpace> all;
        for (const Kind kind : allKinds) {
            for (const Edition *edition : editionsOf(kind)) {
                const QString word = QString::fromUtf8(edition->word);
                const qsizetype number = word.lastIndexOf(u' ') + 1;
                for (qsizetype at = word.indexOf(u' '); at >= 0; at = word.indexOf(u' ', at + 1)) {
                    DesignationSpace one{word.left(at), word.mid(at + 1, number - at - 1)};
                    if (std::ranges::find(all, one) == all.end())
                        all.push_back(std::move(one));
                }
            }
        }
        return all;
    }();
    return spaces;
}

bool isWithinDesignation(QStringView text, qsizetype space) {
    const QStringView before = text.first(space);
    const QStringView after = text.sliced(space + 1);
    return std::ranges::any_of(spacesOfDesignations(), [&](const DesignationSpace &one) {
        if (!before.endsWith(one.before) || !after.startsWith(one.after))
            return false;
        const qsizetype begin = before.size() - one.before.size();
        const qsizetype number = one.after.size();
        return (begin == 0 || !before[begin - 1].isLetterOrNumber()) && number < after.size() &&
               after[number].isDigit();
    });
}

/// True if a line must not end at this space: before and after "=", between the groups of a number, between a
/// number and its unit, between a count and what is counted, between the name of a standard, "page" and the
/// like and their number or letter ("l’ISO 230-2", "(clause 3").
bool joinsWords(QStringView text, qsizetype space) {
    const auto isEnd = [&](qsizetype at) {
        return at < 0 || at >= text.size() || isSpace(text[at]) || text[at] == u'\n';
    };
    qsizetype from = space;
    while (!isEnd(from - 1))
        --from;
    qsizetype end = space + 1;
    while (!isEnd(end))
        ++end;
    QStringView before = text.mid(from, space - from);
    QStringView after = text.mid(space + 1, end - space - 1);
    if (before.isEmpty() || after.isEmpty())
        return false;
    if (before == u"=" || after == u"=" || isWithinDesignation(text, space))
        return true;
    static constexpr std::array<QStringView, 22> numbered{
        u"ISO/IEC", u"JCGM",    u"ASME",       u"page",        u"pages", u"n°",    u"No.",    u"clause",
        u"clauses", u"article", u"articles",   u"annexe",      u"annex", u"Annex", u"Annexe", u"test",
        u"Test",    u"essai",   u"paragraphe", u"paragraphes", u"germe", u"seed"};
    for (qsizetype i = before.size(); i > 0; --i) {
        if (QStringView(u"’'(«“[\u00A0\u202F").contains(before[i - 1])) {
            before = before.mid(i);
            break;
        }
    }
    const bool isNumber =
        after[0].isDigit() || (after[0].isUpper() && (after.size() == 1 || !after[1].isLetter()));
    if (isNumber && std::ranges::find(numbered, before) != numbered.end())
        return true;
    if (before.isEmpty() || !before.back().isDigit())
        return false;
    constexpr qsizetype longestCount = 3;
    const bool isCount = before.size() <= longestCount && isWhole(before);
    if (beginsWithGroup(after) || (isCount && after[0].isLower()))
        return true;
    while (!after.isEmpty() && QStringView(u",;:.)").contains(after.back()))
        after.chop(1);
    static constexpr std::array<QStringView, 29> units{
        u"mm",     u"µm",    u"m",   u"nm", u"°",    u"′",    u"″",      u"°C",    u"°C/h",  u"K",
        u"K/h",    u"h",     u"min", u"s",  u"%",    u"hPa",  u"mm/min", u"m/min", u"°/min", u"µm/(m·°C)",
        u"tr/min", u"r/min", u"kg",  u"Hz", u"mrad", u"µrad", u"µm/m",   u"in",    u"bar"};
    return std::ranges::find(units, after) != units.end();
}

std::vector<Word> words(const RichText &text) {
    std::vector<Word> result(1);
    for (const TextRun &run : text) {
        qsizetype from = 0;
        const auto finish = [&](qsizetype to) {
            if (to > from)
                result.back().runs.push_back(part(run, from, to - from));
            from = to + 1;
        };
        for (qsizetype i = 0; i < run.text.size(); ++i) {
            const QChar c = run.text[i];
            if ((!isSpace(c) && c != u'\n') || (isSpace(c) && joinsWords(run.text, i)))
                continue;
            finish(i);
            if (c == u'\n')
                result.push_back({{}, false, true});
            else if (!result.back().runs.empty())
                result.push_back({{}, true, false});
            else if (!result.back().newLine)
                result.back().spaceBefore = true;
        }
        finish(run.text.size());
    }
    return result;
}

/// The rest of a run from `from` on. The cost of its queries depends on the line length, not on the rest.
class Rest {
public:
    Rest(const TextRun &run, const TextStyle &style)
        : m_run(run)
        , m_style(style) {}

    [[nodiscard]] bool empty() const { return m_from == m_run.text.size(); }

    /// Removes and returns the first `count` characters.
    TextRun consume(qsizetype count) {
        m_from += count;
        return part(m_run, m_from - count, count);
    }
    TextRun consumeAll() { return consume(m_run.text.size() - m_from); }

    [[nodiscard]] double width(qsizetype count) const {
        return widthOf(m_run.text.mid(m_from, count), m_run, m_style);
    }

    /// True if the rest is wider than `width`.
    [[nodiscard]] bool exceeds(double width) const {
        return firstBeyond(width) <= m_run.text.size() - m_from;
    }

    /// Number of characters that fit into `width`, at least one; never splits a letter and its accent.
    [[nodiscard]] qsizetype most(double width) const {
        return std::max<qsizetype>(before(firstBeyond(width)), whole(1));
    }

    /// The same, or fewer if the line ends better.
    [[nodiscard]] qsizetype fitting(double width) const {
        const qsizetype size = m_run.text.size() - m_from;
        const qsizetype count = most(width);
        // Prefer the end after a separator if most of the line is used.
        for (qsizetype at = count; at < size && at > count / 2; --at) {
            if (QStringLiteral("/-_.,;:").contains(m_run.text[m_from + at - 1]))
                return at;
        }
        return count;
    }

    /// Last end of a whole character before `count`.
    [[nodiscard]] qsizetype before(qsizetype count) const {
        --count;
        while (count > 0 && joins(count))
            --count;
        return count;
    }

private:
    [[nodiscard]] bool joins(qsizetype at) const {
        const qsizetype place = m_from + at;
        return place < m_run.text.size() &&
               (m_run.text[place].isMark() || m_run.text[place].isLowSurrogate());
    }
    /// First end of a whole character from `count` on.
    [[nodiscard]] qsizetype whole(qsizetype count) const {
        while (joins(count))
            ++count;
        return count;
    }

    /// Least number of characters wider than `width`; one more than the rest has if all fit. Doubles the
    /// measured length until it is too wide, then bisects.
    [[nodiscard]] qsizetype firstBeyond(double width) const {
        const qsizetype size = m_run.text.size() - m_from;
        qsizetype fits = 0;
        qsizetype beyond = whole(std::min<qsizetype>(firstGuess, size));
        while (this->width(beyond) <= width) {
            if (beyond == size)
                return size + 1;
            fits = beyond;
            beyond = whole(std::min(2 * beyond, size));
        }
        for (;;) {
            qsizetype middle = whole(fits + (beyond - fits + 1) / 2);
            if (middle >= beyond)
                middle = before(beyond);
            if (middle <= fits)
                return beyond;
            (this->width(middle) <= width ? fits : beyond) = middle;
        }
    }

    static constexpr qsizetype firstGuess = 32;

    const TextRun &m_run;
    const TextStyle &m_style;
    qsizetype m_from = 0;
};

/// True if the run surely fits on one line as it is: most texts of a report do. A line that is built word by
/// word is wider by what a space is kerned with its neighbours.
bool isOneLine(const TextRun &run, const TextStyle &style, double width) {
    if (run.text.isEmpty() || isSpace(run.text.front()) || isSpace(run.text.back()))
        return false;
    qsizetype spaces = 0;
    for (qsizetype i = 0; i < run.text.size(); ++i) {
        const QChar c = run.text[i];
        if (c == u'\n' || c == u'\t' || (c == u' ' && run.text[i + 1] == u' '))
            return false;
        spaces += c == u' ' ? 1 : 0;
    }
    constexpr double mostKerned = 0.3; // fraction of the size
    return width >= TextBlock::unlimited ||
           widthOf(run, style) + static_cast<double>(spaces) * mostKerned * style.size <= width;
}

} // namespace

TextBlock::TextBlock(const QString &text, const TextStyle &style, double width)
    : TextBlock(RichText{{text}}, style, width) {}

TextBlock::TextBlock(const RichText &text, const TextStyle &style, double width)
    : m_style(style)
    , m_lines(1) {
    if (text.size() == 1 && isOneLine(text.front(), style, width)) {
        m_lines.front().fragments.push_back({text.front(), 0});
        measure(m_lines.front());
        return;
    }
    for (const Word &word : words(text)) {
        if (word.newLine)
            m_lines.emplace_back();
        if (word.runs.empty())
            continue;
        beginWord(word.runs, word.spaceBefore, width);
        for (const TextRun &run : word.runs)
            append(run, width);
    }
    // While a line grows its width is the sum of its words.
    for (Line &line : m_lines)
        measure(line);
}

void TextBlock::beginWord(const std::vector<TextRun> &runs, bool spaceBefore, double width) {
    const Line &line = m_lines.back();
    if (line.fragments.empty())
        return;
    TextRun space = runs.front();
    space.text = QStringLiteral(" ");
    const double gap = spaceBefore ? widthOf(space, m_style) : 0;
    if (width < unlimited) {
        double needed = 0;
        for (const TextRun &run : runs)
            needed += widthOf(run, m_style);
        if (line.width + gap + needed > width + 0.01) {
            m_lines.emplace_back();
            return;
        }
    }
    if (gap > 0)
        appendToLine(space, width);
}

void TextBlock::append(const TextRun &run, double width) {
    Rest rest(run, m_style);
    while (width < unlimited && rest.exceeds(width + 0.01 - m_lines.back().width)) {
        const qsizetype count = rest.fitting(width - m_lines.back().width);
        const bool alone = m_lines.back().fragments.empty();
        if (!alone && rest.width(count) > width - m_lines.back().width) {
            m_lines.emplace_back();
            continue;
        }
        appendToLine(rest.consume(count), width);
        if (rest.empty())
            break;
        m_lines.back().goesOn = true;
        m_lines.emplace_back();
    }
    if (!rest.empty())
        appendToLine(rest.consumeAll(), width);
}

void TextBlock::appendToLine(const TextRun &run, double width) {
    Line &line = m_lines.back();
    if (!line.fragments.empty() && sameLook(line.fragments.back().run, run))
        line.fragments.back().run.text += run.text;
    else
        line.fragments.push_back({run, 0});
    if (width < unlimited)
        line.width += widthOf(run, m_style);
}

void TextBlock::measure(Line &line) const {
    line.width = 0;
    for (Fragment &fragment : line.fragments) {
        fragment.width = widthOf(fragment.run, m_style);
        line.width += fragment.width;
    }
}

double TextBlock::width() const {
    double widest = 0;
    for (const Line &line : m_lines)
        widest = std::max(widest, line.width);
    return widest;
}

bool TextBlock::splitsWord() const {
    return std::ranges::any_of(m_lines, &Line::goesOn);
}

double TextBlock::ascent() const {
    return (lineHeight() - (fontAscent + fontDescent) * m_style.size) / 2 + fontAscent * m_style.size;
}

QString TextBlock::text() const {
    QString text;
    for (const Line &line : m_lines) {
        for (const Fragment &fragment : line.fragments)
            text += fragment.run.text;
    }
    return text;
}

TextBlock TextBlock::line(std::size_t index) const {
    TextBlock result;
    result.m_style = m_style;
    result.m_lines.push_back(m_lines[index]);
    return result;
}

void TextBlock::draw(QPainter &painter, QPointF topLeft, TextAlignment alignment, double width) const {
    TextUnits units(painter);
    draw(units, topLeft, alignment, width);
}

void TextBlock::draw(TextUnits &units, QPointF topLeft, TextAlignment alignment, double width) const {
    units.markContent();
    double baseline = topLeft.y() + ascent();
    for (const Line &line : m_lines) {
        double x = topLeft.x();
        if (alignment == TextAlignment::right)
            x += width - line.width;
        else if (alignment == TextAlignment::centre)
            x += (width - line.width) / 2;
        for (const Fragment &fragment : line.fragments) {
            double y = baseline;
            if (fragment.run.script == TextRun::Script::subscript)
                y += paperSubscriptDrop * m_style.size;
            else if (fragment.run.script == TextRun::Script::superscript)
                y -= superscriptRise * m_style.size;
            TextRun run = fragment.run;
            if (&fragment == &line.fragments.back() && !line.goesOn)
                run.text += u' '; // readers of the text join its lines
            const QPointF at(std::round(x * unitsPerPoint), std::round(y * unitsPerPoint));
            drawRun(units, at, run, m_style);
            x += fragment.width;
        }
        baseline += lineHeight();
    }
}

TextUnits::TextUnits(QPainter &painter)
    : m_painter(painter)
    , m_points(painter.transform()) {
    painter.scale(1 / unitsPerPoint, 1 / unitsPerPoint);
}

TextUnits::~TextUnits() {
    drawGlyphs();
    m_painter.setTransform(m_points);
}

bool TextUnits::isPdf() const {
    return m_painter.paintEngine()->type() == QPaintEngine::Pdf;
}

QPainter &TextUnits::painter() {
    drawGlyphs();
    return m_painter;
}

void TextUnits::markContent() {
    if (!contentGoesOn())
        palmer::markContent(painter());
}

void TextUnits::add(const QRawFont &font, QRgb colour, std::span<const quint32> glyphs,
                    std::span<const QPointF> places) {
    if (colour != m_colour || font != m_font)
        drawGlyphs();
    m_font = font;
    m_colour = colour;
    m_glyphs.insert(m_glyphs.end(), glyphs.begin(), glyphs.end());
    m_places.insert(m_places.end(), places.begin(), places.end());
}

void TextUnits::drawGlyphs() {
    if (m_glyphs.empty())
        return;
    QGlyphRun run;
    run.setRawFont(m_font);
    run.setRawData(m_glyphs.data(), m_places.data(), static_cast<int>(m_glyphs.size()));
    m_painter.setPen(QColor::fromRgb(m_colour));
    m_painter.drawGlyphRun({}, run);
    m_glyphs.clear();
    m_places.clear();
}

double textWidth(const QString &text, const TextStyle &style) {
    return widthOf({text}, style);
}

TextBlock elided(const QString &text, const TextStyle &style, double width) {
    const TextRun whole{text.simplified()};
    Rest rest(whole, style);
    if (!rest.exceeds(width))
        return {whole.text, style};
    const auto cut = [&](qsizetype count) {
        return TextBlock(whole.text.left(count).trimmed() + u'…', style);
    };
    qsizetype count = rest.most(width);
    while (count > 0 && cut(count).width() > width)
        count = rest.before(count);
    return cut(count);
}

ForeignPlaces::ForeignPlaces() {
    foreignPlaces.emplace();
}

ForeignPlaces::~ForeignPlaces() {
    foreignPlaces.reset();
}

std::vector<QRectF> ForeignPlaces::take() { // NOLINT(readability-convert-member-functions-to-static)
    return std::exchange(*foreignPlaces, {});
}

std::size_t charactersMeasured() {
    return measuredLetters;
}

} // namespace palmer
