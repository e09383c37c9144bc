#include "ui/pdf/textblock.h"

#include "ui/fonts.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <map>

namespace palmer::ui {

namespace {

/// Fonts have whole sizes in pixels: text is measured and drawn in tenths of a point.
constexpr double tenths = 10;
constexpr double scriptSize = 0.75;
constexpr double subscriptDrop = 0.22; ///< in sizes of the text
constexpr double superscriptRise = 0.36;
/// Of Liberation Sans, in sizes.
constexpr double fontAscent = 0.905;
constexpr double fontDescent = 0.212;

struct Face {
    QFont font;
    QFontMetricsF metrics;
};

/// A font made and measured once: a report draws thousands of short texts in a dozen fonts.
const Face &face(double size, bool bold, bool italic) {
    thread_local std::map<int, Face> faces;
    const int pixels = qRound(size * tenths);
    const int key = 4 * pixels + 2 * (bold ? 1 : 0) + (italic ? 1 : 0);
    const auto known = faces.find(key);
    if (known != faces.end())
        return known->second;
    loadFonts();
    const QFont font = paperFont(pixels, bold, italic);
    return faces.emplace(key, Face{font, QFontMetricsF(font)}).first->second;
}

const Face &face(const TextRun &run, const TextStyle &style) {
    const double size = run.script == TextRun::Script::normal ? style.size : scriptSize * style.size;
    return face(size, run.bold || style.bold, run.italic);
}

double widthOf(const TextRun &run, const TextStyle &style) {
    return face(run, style).metrics.horizontalAdvance(run.text) / tenths;
}

bool sameLook(const TextRun &a, const TextRun &b) {
    return a.bold == b.bold && a.italic == b.italic && a.script == b.script && a.grey == b.grey;
}

TextRun part(const TextRun &run, qsizetype from, qsizetype length) {
    TextRun result = run;
    result.text = run.text.mid(from, length);
    return result;
}

/// What does not break: a word with the space before it. Runs may change within a word.
struct Word {
    std::vector<TextRun> runs;
    bool spaceBefore = false;
    bool newLine = false;
};

bool isSpace(QChar c) {
    return c == u' ' || c == u'\t';
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
            if (!isSpace(c) && c != u'\n')
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

/// Characters of a run that stand in `width`, at least one; never between a letter and its accent.
qsizetype fitting(const TextRun &run, const TextStyle &style, double width) {
    qsizetype count = 1;
    const auto joins = [&](qsizetype at) {
        return at < run.text.size() && (run.text[at].isMark() || run.text[at].isLowSurrogate());
    };
    for (qsizetype next = 1; next <= run.text.size(); ++next) {
        if (joins(next))
            continue;
        if (next > 1 && widthOf(part(run, 0, next), style) > width)
            break;
        count = next;
    }
    // Better behind a sign that parts words, if most of the line is used that way.
    for (qsizetype at = count; at < run.text.size() && at > count / 2; --at) {
        if (QStringLiteral("/-_.,;:").contains(run.text[at - 1]))
            return at;
    }
    return count;
}

} // namespace

TextBlock::TextBlock(const QString &text, const TextStyle &style, double width)
    : TextBlock(RichText{{text}}, style, width) {}

TextBlock::TextBlock(const RichText &text, const TextStyle &style, double width)
    : m_style(style)
    , m_lines(1) {
    const auto append = [&](const TextRun &run) {
        Line &line = m_lines.back();
        if (!line.fragments.empty() && sameLook(line.fragments.back().run, run)) {
            Fragment &last = line.fragments.back();
            line.width -= last.width;
            last.run.text += run.text;
            last.width = widthOf(last.run, style);
            line.width += last.width;
        } else {
            line.fragments.push_back({run, widthOf(run, style)});
            line.width += line.fragments.back().width;
        }
    };
    const bool wraps = width < unlimited;
    for (const Word &word : words(text)) {
        if (word.newLine)
            m_lines.emplace_back();
        if (word.runs.empty())
            continue;
        double needed = 0;
        if (wraps) {
            for (const TextRun &run : word.runs)
                needed += widthOf(run, style);
        }
        TextRun space = word.runs.front();
        space.text = QStringLiteral(" ");
        const bool begins = m_lines.back().fragments.empty();
        const double gap = word.spaceBefore && !begins ? widthOf(space, style) : 0;
        if (wraps && !begins && m_lines.back().width + gap + needed > width + 0.01)
            m_lines.emplace_back();
        else if (gap > 0)
            append(space);
        for (TextRun run : word.runs) {
            while (wraps && m_lines.back().width + widthOf(run, style) > width + 0.01) {
                const qsizetype count = fitting(run, style, width - m_lines.back().width);
                const bool alone = m_lines.back().fragments.empty();
                if (!alone && widthOf(part(run, 0, count), style) > width - m_lines.back().width) {
                    m_lines.emplace_back();
                    continue;
                }
                append(part(run, 0, count));
                run.text.remove(0, count);
                if (run.text.isEmpty())
                    break;
                m_lines.emplace_back();
            }
            if (!run.text.isEmpty())
                append(run);
        }
    }
}

double TextBlock::width() const {
    double widest = 0;
    for (const Line &line : m_lines)
        widest = std::max(widest, line.width);
    return widest;
}

double TextBlock::ascent() const {
    return (lineHeight() - (fontAscent + fontDescent) * m_style.size) / 2 + fontAscent * m_style.size;
}

TextBlock TextBlock::line(std::size_t index) const {
    TextBlock result;
    result.m_style = m_style;
    result.m_lines.push_back(m_lines[index]);
    return result;
}

void TextBlock::draw(QPainter &painter, QPointF topLeft, TextAlignment alignment, double width) const {
    const QTransform points = painter.transform();
    painter.scale(1 / tenths, 1 / tenths);
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
                y += subscriptDrop * m_style.size;
            else if (fragment.run.script == TextRun::Script::superscript)
                y -= superscriptRise * m_style.size;
            painter.setFont(face(fragment.run, m_style).font);
            painter.setPen(QColor::fromRgb(fragment.run.grey ? noteGrey : m_style.colour));
            painter.drawText(QPointF(x, y) * tenths, fragment.run.text);
            x += fragment.width;
        }
        baseline += lineHeight();
    }
    painter.setTransform(points);
}

double textWidth(const QString &text, const TextStyle &style) {
    return face({text}, style).metrics.horizontalAdvance(text) / tenths;
}

} // namespace palmer::ui
