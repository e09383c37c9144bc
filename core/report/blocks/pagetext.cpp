// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/blocks/pagetext.h"

#include <QStringList>

namespace palmer {

namespace {

constexpr QChar dash(u'–');
constexpr QStringView between(u"  ");

class WordPrinter {
public:
    explicit WordPrinter(const std::function<void(const QString &)> &take)
        : m_take(take) {}

    void operator()(const Heading &heading) { cells({heading.text, heading.note.plain()}); }
    void operator()(const Paragraph &paragraph) { line(paragraph.text); }
    void operator()(const KeyValues &values) {
        for (const KeyValue &row : values.rows)
            cells({row.key, row.value.isEmpty() ? QString(dash) : row.value});
    }
    void operator()(const Table &table) {
        if (!table.headless)
            head(table);
        table.eachRow([this](const std::vector<Cell> &row) {
            QStringList texts;
            for (const Cell &cell : row) {
                texts << (cell.isMissing() ? QString(dash) : cell.text.plain());
                for (const CellNote &note : cell.extras->notes)
                    texts << note.text;
            }
            cells(texts);
        });
    }
    void operator()(const SideBySide &both) {
        for (const Part &part : both.left)
            std::visit(*this, part);
        for (const Part &part : both.right)
            std::visit(*this, part);
    }
    void operator()(const TestHead &head) {
        cells({head.laboratory});
        cells({head.address});
        cells({head.accreditation});
        cells({head.number});
        cells(head.numberNotes);
        cells({head.title});
        cells({head.subtitle});
        cells({head.editionTitle});
        cells({head.notice});
        (*this)(head.left);
        (*this)(head.right);
    }
    void operator()(const FigureBlock &block) {
        std::visit([this](const auto &figure) { words(figure); }, *block.figure);
    }
    void operator()(const ResultsLegend &legend) {
        QStringList texts;
        for (const LegendItem &item : legend.items)
            texts << item.text;
        cells(texts);
    }
    void operator()(const VerdictLine &verdict) {
        cells({verdict.label, verdict.word, verdict.second, verdict.note});
        for (const VerdictStatement &part : {verdict.limits, verdict.accordance})
            cells({part.label, part.state, part.text.plain().replace(QLatin1String("%1"), QString(dash))});
    }
    void operator()(const FindingsBlock &findings) {
        for (const FindingLine &finding : findings.lines) {
            if (!finding.heading.isEmpty())
                cells({finding.heading});
            cells({finding.gradeName, finding.sentence.plain(),
                   finding.clause.isEmpty() ? QString(dash) : finding.clause});
        }
    }
    void operator()(const Signatures &signatures) {
        for (const SignatureColumn &column : signatures.columns) {
            line(column.heading);
            for (const SignatureLine &row : column.lines)
                cells({row.label, row.value});
        }
    }
    void operator()(const RunningHead &) {}
    void operator()(const PageBreak &) {}
    void operator()(const EndMark &mark) {
        line(QString(mark.text).replace(QLatin1String("%1"), QString(dash)));
    }

private:
    void line(const QString &text) { m_take(text); }

    /// Adds one line of the non-empty texts.
    void cells(QStringList texts) {
        texts.removeAll(QString());
        if (!texts.isEmpty())
            line(texts.join(between.toString()));
    }

    void head(const Table &table) {
        QStringList titles;
        QStringList units;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            for (const Spanner &spanner : table.spanners) {
                if (spanner.first == i)
                    titles << spanner.title.plain();
            }
            titles << table.columns[i].title.plain();
            units << table.columns[i].unit;
        }
        cells(titles);
        cells(units);
    }

    void axis(const FigureAxis &axis) {
        if (!axis.quantity.isEmpty())
            cells({axis.quantity + u' ' + axis.symbol + axis.subscript +
                   (axis.unit.isEmpty() ? QString() : QStringLiteral(" (") + axis.unit + u')')});
        QStringList labels;
        for (const Tick &tick : axis.ticks)
            labels << tick.label;
        cells(labels);
    }

    void words(const TrendFigure &figure) {
        cells({figure.label, figure.note});
        for (const TrendPanel &panel : figure.panels)
            cells({panel.symbol, panel.statement});
        QStringList legend;
        for (const TrendLegendEntry &entry : figure.legend)
            legend << entry.text;
        cells(legend);
    }
    void words(const CurveFigure &figure) {
        axis(figure.y);
        axis(figure.x);
        QStringList dimensions;
        for (const Dimension &dimension : figure.dimensions) {
            dimensions << dimension.label + dimension.subscript;
            if (dimension.limit)
                dimensions << dimension.limitText;
        }
        cells(dimensions);
        QStringList legend;
        for (const LegendEntry &entry : figure.legend)
            legend << entry.text;
        cells(legend);
    }

    void words(const LineFigure &figure) {
        axis(figure.y);
        axis(figure.x);
        QStringList legend;
        for (const FigureLine &line : figure.lines) {
            if (!line.label.isEmpty())
                cells({line.label});
            legend << line.name;
        }
        cells(legend);
    }

    void words(const BarFigure &figure) {
        axis(figure.x);
        for (const Bar &bar : figure.bars)
            cells({bar.name + bar.subscript, bar.value, bar.share});
        QStringList legend;
        if (figure.dots)
            legend << figure.dots->dot << figure.dots->limit;
        for (const BarLine &one : figure.lines)
            legend << one.text;
        cells(legend);
        line(figure.note);
    }

    void words(const HistogramFigure &figure) {
        axis(figure.x);
        cells({figure.evaluatedText, figure.meanText, figure.coverageText});
    }

    void words(const CircleFigure &figure) {
        QStringList words{figure.firstAxis, figure.secondAxis, figure.ratio, figure.divisionLabel};
        for (const DeviationCircle &ring : figure.rings)
            words << ring.label;
        for (const SenseArrow &arrow : figure.arrows)
            words << arrow.index;
        if (figure.envelope && figure.envelope->dimension)
            words << figure.envelope->label + figure.envelope->subscript;
        if (figure.envelope && figure.envelope->limit)
            words << figure.envelope->limitLabel;
        cells(words);
        QStringList legend;
        for (const CircleLegendEntry &entry : figure.legend)
            legend << entry.text;
        cells(legend);
    }

    const std::function<void(const QString &)> &m_take;
};

} // namespace

void eachPageLine(const Block &block, const std::function<void(const QString &)> &take) {
    std::visit(WordPrinter(take), block);
}

QString pageText(const Block &block) {
    QString result;
    eachPageLine(block, [&result](const QString &line) { result += line + u'\n'; });
    return result;
}

QString pageText(const Report &report) {
    QString result;
    for (const Block &block : report.blocks)
        result += pageText(block);
    return result;
}

} // namespace palmer
