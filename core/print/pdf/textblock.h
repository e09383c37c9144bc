// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRawFont>
#include <QRectF>
#include <QRgb>
#include <QString>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

class QPainter;

namespace palmer {

constexpr QRgb black = 0xff000000;
constexpr QRgb noteGrey = 0xff333333;
constexpr QRgb labelGrey = 0xff444444;
constexpr QRgb dashGrey = 0xff777777;

/// Sizes in points, multiples of 0.1; `leading` as a multiple of the size. The font is Liberation Sans.
struct TextStyle {
    double size = 9;
    bool bold = false;
    QRgb colour = black;
    double leading = 1.2;
};

/// A piece of text in one format. `grey`: like notes (units in a head, words next to a heading).
struct TextRun {
    enum class Script { normal, subscript, superscript };

    QString text;
    bool bold = false;
    bool italic = false;
    Script script = Script::normal;
    bool grey = false;
};

using RichText = std::vector<TextRun>;

enum class TextAlignment { left, centre, right };

/// During its life the unit of the painter is that of texts instead of points: changing it for each cell of a
/// table would take a fifth of the bytes of its page. In a PDF, texts of one content that look the same are
/// drawn as one, at the latest at its end: a third of the bytes of a row of numbers.
class TextUnits {
public:
    explicit TextUnits(QPainter &painter);
    ~TextUnits();
    TextUnits(const TextUnits &) = delete;
    TextUnits &operator=(const TextUnits &) = delete;

    [[nodiscard]] bool isPdf() const;
    /// For what is drawn next: after the texts so far.
    [[nodiscard]] QPainter &painter();
    /// The next text belongs to the current element.
    void markContent();
    /// Adds glyphs at their places in units; only for a PDF: on the screen Qt places them by pixels.
    void add(const QRawFont &font, QRgb colour, std::span<const quint32> glyphs,
             std::span<const QPointF> places);

private:
    void drawGlyphs();

    QPainter &m_painter;
    QTransform m_points;
    QRawFont m_font;
    QRgb m_colour = 0;
    std::vector<quint32> m_glyphs;
    std::vector<QPointF> m_places;
};

/// A text broken into lines of at most `width` points: at spaces and line feeds, within a word only if it is
/// wider than a line, never at no-break spaces. Measured once; drawn as text that can be searched and copied.
class TextBlock {
public:
    TextBlock() = default;
    TextBlock(const RichText &text, const TextStyle &style, double width = unlimited);
    TextBlock(const QString &text, const TextStyle &style, double width = unlimited);

    [[nodiscard]] double height() const { return lineHeight() * static_cast<double>(m_lines.size()); }
    [[nodiscard]] double lineHeight() const { return m_style.size * m_style.leading; }
    [[nodiscard]] double width() const; ///< of the widest line
    [[nodiscard]] std::size_t lineCount() const { return m_lines.size(); }
    [[nodiscard]] bool empty() const { return m_lines.empty(); }
    [[nodiscard]] bool splitsWord() const; ///< a word is wider than a line
    /// Distance from the top of the block to its first baseline.
    [[nodiscard]] double ascent() const;
    /// Its text without line ends.
    [[nodiscard]] QString text() const;
    /// Line `index` as a separate block.
    [[nodiscard]] TextBlock line(std::size_t index) const;

    /// `topLeft` in points of the painter; centred and right-aligned lines are aligned within `width`.
    void draw(QPainter &painter, QPointF topLeft, TextAlignment alignment = TextAlignment::left,
              double width = 0) const;

    /// The same with others in the same units; `topLeft` in points all the same.
    void draw(TextUnits &units, QPointF topLeft, TextAlignment alignment = TextAlignment::left,
              double width = 0) const;

    static constexpr double unlimited = 1e9;

private:
    struct Fragment {
        TextRun run;
        double width = 0;
    };
    struct Line {
        std::vector<Fragment> fragments;
        double width = 0;
        bool goesOn = false; ///< ends within a word
    };

    /// Adds the space before a word, or a new line if the word does not fit; nothing at the start of a line.
    void beginWord(const std::vector<TextRun> &runs, bool spaceBefore, double width);
    /// Appends a run, broken if it is wider than a line.
    void append(const TextRun &run, double width);
    void appendToLine(const TextRun &run, double width);
    void measure(Line &line) const; ///< once it is complete

    TextStyle m_style;
    std::vector<Line> m_lines;
};

/// Width of a text on one line, points.
[[nodiscard]] double textWidth(const QString &text, const TextStyle &style);

/// The style at the largest size down to `smallest`, in tenths, at which `width(style)` is at most `room`.
/// Widths are taken as nearly proportional: each size that is tried loads a font.
template <class Width>
[[nodiscard]] TextStyle fitted(TextStyle style, double smallest, double room, Width width) {
    constexpr double step = 0.1;
    const double wide = width(style);
    if (wide <= room || style.size <= smallest)
        return style;
    const double guess = std::floor(style.size * room / wide / step + 1) * step;
    style.size = std::clamp(guess, smallest, std::max(smallest, style.size - step));
    while (style.size > smallest && width(style) > room)
        style.size -= step;
    return style;
}

/// A text on one line, cut at its end to fit.
[[nodiscard]] TextBlock elided(const QString &text, const TextStyle &style, double width);

/// Records where this thread draws characters that the paper font lacks, in device units.
class ForeignPlaces {
public:
    ForeignPlaces();
    ~ForeignPlaces();
    ForeignPlaces(const ForeignPlaces &) = delete;
    ForeignPlaces &operator=(const ForeignPlaces &) = delete;

    /// The places since the last call.
    [[nodiscard]] std::vector<QRectF> take();
};

/// Characters measured by this thread so far: the cost of the layout, for tests that it does not grow faster
/// than the text.
[[nodiscard]] std::size_t charactersMeasured();

} // namespace palmer
