// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QRgb>
#include <QString>
#include <vector>

class QPainter;

namespace palmer {

constexpr QRgb black = 0xff000000;
constexpr QRgb noteGrey = 0xff333333;
constexpr QRgb labelGrey = 0xff444444;
constexpr QRgb dashGrey = 0xff777777;

/// Sizes in points, of a multiple of 0.1; `leading` in sizes. The text of pages is Liberation Sans.
struct TextStyle {
    double size = 9;
    bool bold = false;
    QRgb colour = black;
    double leading = 1.2;
};

/// A piece of text that is set in one way. `grey`: as notes are (units in a head, words beside a heading).
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

/// A text broken into lines of at most `width` points: at spaces, and at a line feed; within a word only
/// where the word alone is wider than a line. No-break spaces do not break. Measured once; drawn as text that
/// can be searched and copied.
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
    /// From the top of the block to the base line of its first line.
    [[nodiscard]] double ascent() const;
    /// As it stands, without the ends of the lines.
    [[nodiscard]] QString text() const;
    /// One of its lines as a block of its own.
    [[nodiscard]] TextBlock line(std::size_t index) const;

    /// `topLeft` in points of the painter; centred and right aligned lines stand in `width` from there.
    void draw(QPainter &painter, QPointF topLeft, TextAlignment alignment = TextAlignment::left,
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
    };

    /// A space before a word, or a new line where the word has no room; nothing at the beginning of a line.
    void beginWord(const std::vector<TextRun> &runs, bool spaceBefore, double width);
    /// Broken where it is wider than a line.
    void append(const TextRun &run, double width);
    void appendToLine(const TextRun &run, double width);
    void measure(Line &line) const;
    void measureEnd(Line &line) const; ///< after its last fragment has grown

    TextStyle m_style;
    std::vector<Line> m_lines;
};

/// How wide a text of one style stands on its line, points.
[[nodiscard]] double textWidth(const QString &text, const TextStyle &style);

/// A text on one line, cut at its end to what fits.
[[nodiscard]] TextBlock elided(const QString &text, const TextStyle &style, double width);

/// While it lives: where this thread draws characters that the font of paper lacks, in units of the device.
class ForeignPlaces {
public:
    ForeignPlaces();
    ~ForeignPlaces();
    ForeignPlaces(const ForeignPlaces &) = delete;
    ForeignPlaces &operator=(const ForeignPlaces &) = delete;

    /// Those since the last time.
    [[nodiscard]] std::vector<QRectF> take();
};

/// Characters measured by this thread so far: the work of laying out, for those who watch that it does not
/// grow faster than the text.
[[nodiscard]] std::size_t charactersMeasured();

} // namespace palmer
