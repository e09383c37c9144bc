// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "print/figures/exportfigure.h"

#include "core/kernel/evaluation/positioningdata.h"
#include "figures/figuretexts.h"
#include "figures/testfigures.h"

#include <QHashSeed>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTest>
#include <QXmlStreamReader>
#include <algorithm>
#include <numeric>
#include <random>

using namespace palmer;
using namespace palmer::testdata;
using namespace Qt::StringLiterals;

namespace {

const Language &french() {
    static const Language language(Language::Id::french);
    return language;
}

Figure example() {
    const Test test = example1988("ISO 230-2:2006");
    return deviationFigure(test, evaluated(test), french());
}

} // namespace

/// Figures as files.
class ExportFigure : public QObject {
    Q_OBJECT

private slots:
    void sameBytesAtAnyTime();
    void pdfIsSound();
    void svgIsVectors();
    void svgDashesAreAsLongAsOnThePage();
    void svgHasNoMoreDigitsThanPaperShows();
    void svgOfManyReadingsIsSmall();
    void pngHasTheSizeOfThePage();
};

void ExportFigure::sameBytesAtAnyTime() {
    const Figure figure = example();
    const QByteArray pdf = figureAsPdf(figure, u"Titre"_s);
    const QByteArray svg = figureAsSvg(figure, u"Titre"_s, french());
    const QByteArray png = figureAsPng(figure);
    QTest::qWait(1100); // times in a PDF have whole seconds
    qputenv("TZ", "Asia/Tokyo");
    tzset();
    QCOMPARE(figureAsPdf(figure, u"Titre"_s), pdf);
    QCOMPARE(figureAsSvg(figure, u"Titre"_s, french()), svg);
    QCOMPARE(figureAsPng(figure), png);
    qputenv("TZ", "UTC");
    tzset();
}

void ExportFigure::pdfIsSound() {
    const QByteArray pdf = figureAsPdf(example(), u"Écarts"_s);
    QVERIFY(pdf.startsWith("%PDF-1."));
    QVERIFY(pdf.endsWith("%%EOF\n"));
    QVERIFY(!pdf.contains("/CreationDate"));
    QVERIFY(!pdf.contains("/Subtype /Image")); // vectors only
    // The table of objects points at objects.
    const qsizetype start = pdf.lastIndexOf("startxref\n") + 10;
    const qsizetype table = pdf.mid(start, pdf.indexOf('\n', start) - start).trimmed().toLongLong();
    QVERIFY(pdf.mid(table).startsWith("xref\n0 "));
    const QList<QByteArray> lines = pdf.mid(table).split('\n');
    const int count = lines[1].split(' ')[1].toInt();
    QVERIFY(count > 10);
    for (int i = 1; i < count; ++i) {
        const QByteArray &line = lines[2 + i];
        QCOMPARE(line.size(), qsizetype{19}); // 20 with its end
        QVERIFY(line.endsWith(" n "));
        QVERIFY2(pdf.mid(line.left(10).toLongLong()).startsWith(QByteArray::number(i) + " 0 obj"), line);
    }
}

void ExportFigure::svgIsVectors() {
    const QByteArray svg = figureAsSvg(example(), u"Écarts de position"_s, french());
    QXmlStreamReader reader(svg);
    QStringList texts;
    QString title;
    QString description;
    while (!reader.atEnd()) {
        reader.readNext();
        if (!reader.isStartElement())
            continue;
        if (reader.name() == "svg"_L1) {
            QCOMPARE(reader.attributes().value("width"_L1), u"175mm"_s);
            QCOMPARE(reader.attributes().value("height"_L1), u"86mm"_s);
            QCOMPARE(reader.attributes().value("role"_L1), u"img"_s);
        }
        QVERIFY(reader.name() != "image"_L1);
        if (reader.name() == "title"_L1)
            title = reader.readElementText();
        else if (reader.name() == "desc"_L1)
            description = reader.readElementText();
        else if (reader.name() == "text"_L1)
            texts += reader.readElementText().trimmed();
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    QCOMPARE(title, u"Écarts de position"_s);
    QCOMPARE(description, figureSentence(example(), french()));
    for (const QString &expected : {u"1\u202f500"_s, u"−10"_s, u"x̄ bidirectionnel"_s, u"relevés"_s, u"A"_s})
        QVERIFY2(texts.contains(expected), qPrintable(expected));
}

void ExportFigure::svgDashesAreAsLongAsOnThePage() {
    const QByteArray svg = figureAsSvg(example(), QString(), french());
    // ↓: 2 mm and 1 mm in points, and its width 0.45 mm.
    QVERIFY(svg.contains(
        "stroke-dasharray=\"5.66929,2.83465\" stroke-dashoffset=\"0\" stroke-width=\"1.27559\""));
    // Edges of ↓: 1.1 mm and 0.7 mm, 0.17 mm wide.
    QVERIFY(svg.contains(
        "stroke-dasharray=\"3.11811,1.98425\" stroke-dashoffset=\"0\" stroke-width=\"0.48189\""));
}

/// Hundredths of a point in paths, and drawn they are the page.
void ExportFigure::svgHasNoMoreDigitsThanPaperShows() {
    const QByteArray svg = figureAsSvg(example(), QString(), french());
    static const QRegularExpression path(u" (?:d|points)=\"([^\"]*)\""_s);
    static const QRegularExpression number(u"-?[0-9.]+(?:e[-+]?[0-9]+)?"_s);
    int numbers = 0;
    for (auto paths = path.globalMatch(QString::fromUtf8(svg)); paths.hasNext();) {
        const QString coordinates = paths.next().captured(1);
        for (auto found = number.globalMatch(coordinates); found.hasNext(); ++numbers) {
            const QString text = found.next().captured();
            QVERIFY2(text.section(u'.', 1).size() <= 2 && !text.contains(u'e') && text != u"-0",
                     qPrintable(text));
        }
    }
    QVERIFY(numbers > 500);
    const QImage drawn =
        QImage::fromData(figureAsPng(example(), 150)).convertToFormat(QImage::Format_Grayscale8);
    QImage rendered(drawn.size(), QImage::Format_RGB32);
    rendered.fill(Qt::white);
    QPainter painter(&rendered);
    painter.setRenderHint(QPainter::Antialiasing);
    QSvgRenderer(svg).render(&painter);
    painter.end();
    rendered.convertTo(QImage::Format_Grayscale8);
    qint64 differing = 0; // texts are set anew, and a little otherwise
    for (int y = 0; y < drawn.height(); ++y) {
        for (int x = 0; x < drawn.width(); ++x)
            differing += std::abs(qGray(drawn.pixel(x, y)) - qGray(rendered.pixel(x, y))) > 96;
    }
    QVERIFY2(differing < drawn.width() * drawn.height() / 100, qPrintable(QString::number(differing)));
}

/// 10⁶ readings without any smoothness: the most that is drawn.
void ExportFigure::svgOfManyReadingsIsSmall() {
    constexpr std::size_t targets = 100'000;
    std::mt19937 random(3);
    std::vector<std::vector<double>> up(5, std::vector<double>(targets));
    auto down = up;
    for (auto *runs : {&up, &down}) {
        for (std::vector<double> &run : *runs)
            std::ranges::generate(run, [&] { return static_cast<double>(random() % 20'000) / 1000; });
    }
    std::vector<double> positions(targets);
    std::iota(positions.begin(), positions.end(), 0.0);
    const Test test = positioningTest("ISO 230-2:2006", positions, up, down);
    DeviationFigureOptions options;
    options.readingMarks = true;
    const QByteArray svg =
        figureAsSvg(deviationFigure(test, evaluated(test), french(), options), QString(), french());
    QVERIFY2(svg.size() < 1'000'000, qPrintable(QString::number(svg.size())));
}

void ExportFigure::pngHasTheSizeOfThePage() {
    const QImage image = QImage::fromData(figureAsPng(example(), 254));
    QCOMPARE(image.size(), QSize(1750, 860));
    QCOMPARE(image.dotsPerMeterX(), 10000);
    QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
}

// As main does: fonts are written in the order of a hash.
static const bool deterministic = [] {
    QHashSeed::setDeterministicGlobalSeed();
    return true;
}();

QTEST_MAIN(ExportFigure)
#include "exportfigure.moc"
