// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/exportfigure.h"

#include "figures/figuretexts.h"
#include "language/visibletext.h"
#include "print/figures/drawfigure.h"
#include "print/fonts.h"

#include <QBuffer>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace palmer {

namespace {

constexpr double millimetresPerInch = 25.4;

QRectF pageInPoints(const Figure &figure) {
    return {QPointF(0, 0), paperSize(figure) * pointsPerMillimetre};
}

/// Removes the creation date from a PDF of Qt, since the same figure must give the same bytes, and updates
/// the offsets after it.
QByteArray withoutDate(const QByteArray &pdf) {
    const qsizetype from = pdf.indexOf("/CreationDate (");
    const qsizetype table = pdf.lastIndexOf("\nxref\n");
    const qsizetype trailer = pdf.indexOf("trailer", table);
    const qsizetype start = pdf.lastIndexOf("startxref");
    if (from < 0 || table < from || trailer < 0 || start < 0)
        throw std::runtime_error("the PDF has no date or no table of its objects");
    const qsizetype length = pdf.indexOf(")\n", from) + 2 - from;
    const auto moved = [&](const QByteArray &digits) {
        const qlonglong offset = digits.toLongLong();
        return QByteArray::number(offset > from ? offset - length : offset);
    };
    QByteArray result = pdf.left(from) + pdf.mid(from + length, table + 1 - from - length);
    for (const QByteArray &line : pdf.mid(table + 1, trailer - table - 1).split('\n')) {
        const bool inUse = line.endsWith(" n ");
        result += inUse ? moved(line.left(10)).rightJustified(10, '0') + line.mid(10) : line;
        result += '\n';
    }
    result.chop(1);
    return result + pdf.mid(trailer, start - trailer) + "startxref\n" +
           moved(pdf.mid(start + 10, pdf.indexOf('\n', start + 10) - start - 10).trimmed()) + "\n%%EOF\n";
}

/// Marks the SVG as an image with a language, for screen readers.
QByteArray asPicture(QByteArray svg, const QString &language) {
    return svg.replace("<svg ", R"(<svg role="img" xml:lang=")" + language.toLatin1() + R"(" )");
}

/// QSvgGenerator treats lines thinner than half a unit as one unit wide when it writes dashes: shortens the
/// dashes.
QByteArray withTrueDashes(const QByteArray &svg) {
    static const QRegularExpression dashed(QStringLiteral(
        R"re(stroke-dasharray="([^"]*)" stroke-dashoffset="([^"]*)" stroke-width="([^"]*)")re"));
    const QString text = QString::fromUtf8(svg);
    QString result;
    qsizetype end = 0;
    for (auto matches = dashed.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        const double width = match.captured(3).toDouble();
        const double factor = qRound(width) == 0 ? width : 1;
        QStringList lengths;
        for (const QString &length : match.captured(1).split(QLatin1Char(',')))
            lengths += QString::number(length.toDouble() * factor);
        result += text.mid(end, match.capturedStart() - end);
        result += QStringLiteral(R"(stroke-dasharray="%1" stroke-dashoffset="%2" stroke-width="%3")")
                      .arg(lengths.join(QLatin1Char(',')), match.captured(2), match.captured(3));
        end = match.capturedEnd();
    }
    return (result + text.mid(end)).toUtf8();
}

/// Names the font as those know it who look at the picture.
QByteArray withPrintedFamily(QByteArray svg) {
    const auto attribute = [](const QString &family) {
        return QStringLiteral("font-family=\"%1\"").arg(family).toUtf8();
    };
    return svg.replace(attribute(paperFamily()), attribute(printedFamily()));
}

/// A number of a path rounded to a hundredth of a point; QSvgGenerator writes six digits.
QByteArray shortNumber(const QByteArray &number) {
    constexpr double hundredths = 100;
    const double value = std::round(number.toDouble() * hundredths) / hundredths;
    return QByteArray::number(value == 0 ? 0.0 : value, 'g', 7); // never "-0"
}

/// Removes digits that no paper resolves from paths and lines, and redundant attributes.
QByteArray withShortPaths(QByteArray svg) {
    svg.replace(" vector-effect=\"none\"", "");
    QByteArray result;
    result.reserve(svg.size());
    QByteArray number;
    bool inPath = false;
    for (const char c : std::as_const(svg)) {
        if (!inPath) {
            result += c;
            inPath = c == '"' && (result.endsWith(" d=\"") || result.endsWith(" points=\""));
        } else if ((c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' ||
                   (c == 'e' && !number.isEmpty())) {
            number += c;
        } else {
            if (!number.isEmpty())
                result += shortNumber(number);
            number.clear();
            result += c;
            inPath = c != '"';
        }
    }
    return result;
}

void begin(QPainter &painter, QPaintDevice *device) {
    if (!painter.begin(device))
        throw std::runtime_error("the figure cannot be drawn");
}

} // namespace

QByteArray figureAsSvg(const Figure &figure, const QString &title, const Language &language) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    const QRectF page = pageInPoints(figure);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(2540); // hundredths of a millimetre, for an exact size
    generator.setSize((paperSize(figure) * 100).toSize());
    generator.setViewBox(page);
    generator.setTitle(title);
    generator.setDescription(figureSentence(figure, language));
    QPainter painter;
    begin(painter, &generator);
    drawFigure(painter, page, figure, Medium::paper);
    painter.end();
    return visibleText(
        withPrintedFamily(withShortPaths(withTrueDashes(asPicture(buffer.data(), language.code())))));
}

QByteArray figureAsPdf(const Figure &figure, const QString &title) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(1200);
        writer.setPageLayout(
            QPageLayout(QPageSize(paperSize(figure), QPageSize::Millimeter, QString(), QPageSize::ExactMatch),
                        QPageLayout::Portrait, QMarginsF(0, 0, 0, 0), QPageLayout::Millimeter));
        writer.setTitle(title);
        writer.setCreator(QStringLiteral("Palmer"));
        QPainter painter;
        begin(painter, &writer);
        painter.scale(1200 / 72.0, 1200 / 72.0);
        drawFigure(painter, pageInPoints(figure), figure, Medium::paper);
    }
    return withoutDate(buffer.data());
}

QByteArray figureAsPng(const Figure &figure, int dotsPerInch) {
    const double scale = dotsPerInch / 72.0;
    const QRectF page = pageInPoints(figure);
    QImage image((page.size() * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    image.setDotsPerMeterX(qRound(dotsPerInch * 1000 / millimetresPerInch));
    image.setDotsPerMeterY(qRound(dotsPerInch * 1000 / millimetresPerInch));
    QPainter painter;
    begin(painter, &image);
    painter.scale(scale, scale);
    drawFigure(painter, page, figure, Medium::paper);
    painter.end();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, "PNG"))
        throw std::runtime_error("the figure cannot be written as PNG");
    return buffer.data();
}

} // namespace palmer
