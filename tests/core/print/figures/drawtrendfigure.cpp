// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/print/figures/recordedtexts.h"
#include "figures/ticks.h"
#include "language/language.h"
#include "print/figures/drawkinds.h"
#include "print/fonts.h"

#include <QPainter>
#include <QTest>

using namespace palmer;

namespace {

TrendPanel panelOf(const QString &symbol, const QString &index, const QString &statement) {
    TrendPanel panel;
    panel.symbol = symbol + index;
    panel.y.symbol = symbol;
    panel.y.subscript = index;
    panel.y.unit = "µm";
    panel.statement = statement;
    const Language language(Language::Id::english);
    setRange(panel.y, 0, 25, 4, TickSteps::values, language);
    setRange(panel.x, 2018.5, 2030.5, 5, TickSteps::values, language);
    panel.today = 2026;
    return panel;
}

} // namespace

/// The small trends of a history: what stands above them has room beside each other.
class DrawTrendFigure : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { loadFonts(); }

    void noTextCoversAnother_data() {
        QTest::addColumn<QString>("statement");
        QTest::addColumn<bool>("isFirst");
        for (const char *statement :
             {"pas avant sept. 2030 *", "pas avant juil. 2030 *", "pas avant févr. 2030 *", "pas de tendance",
              "not before Sept 2030 *", "not before May 2030 *", "no trend shown", "trop peu d’essais",
              "at the limit", "sans limite"}) {
            QTest::newRow(statement) << statement << false;
            // What is watched first has a date, not the star of one beyond.
            const QByteArray first = QByteArray(statement).replace(" *", "");
            QTest::newRow((first + ", to be watched first").constData()) << QString::fromUtf8(first) << true;
        }
    }
    void noTextCoversAnother() {
        QFETCH(QString, statement);
        QFETCH(bool, isFirst);
        for (const auto &[symbol, index] : {std::pair("G(b)", "XY"), std::pair("G(b)", "ZX"),
                                            std::pair("D", "YZ"), std::pair("A", ""), std::pair("B̄", "")}) {
            TrendFigure figure;
            figure.title = figure.label = "XY";
            figure.note = "R 150 mm";
            for (int i = 0; i < 4; ++i) {
                figure.panels.push_back(panelOf(symbol, index, statement));
                figure.panels.back().isFirst = isFirst;
            }
            testdata::TextRecorder recorder(QSize(500, 100));
            {
                QPainter painter(&recorder);
                (void)drawKind(painter, QRectF(0, 0, 175 * mm, 26 * mm), figure, Medium::paper);
            }
            QVERIFY(recorder.texts.size() > 20);
            for (std::size_t i = 0; i < recorder.texts.size(); ++i) {
                for (std::size_t j = i + 1; j < recorder.texts.size(); ++j) {
                    const testdata::RecordedText &a = recorder.texts[i];
                    const testdata::RecordedText &b = recorder.texts[j];
                    // An index stands close to its symbol.
                    const bool isIndex = a.text == symbol && b.text == index;
                    QVERIFY2(isIndex || !a.box.adjusted(0, 0, 0.5, 0).intersects(b.box),
                             qPrintable(a.text + " and " + b.text));
                }
            }
        }
    }

    /// What splits many series stands below the chart of one trend, whole.
    void aLongNoteHasLines() {
        const QStringList series{"Another series: tool offset X 1 Y 2 Z 3 mm",
                                 "ISO 230-2:2006",
                                 "correction to 20 °C: not applied",
                                 "feed 3 000 mm/min",
                                 "runs in either direction: 3 + 3",
                                 "zone 0 to 1 000 mm",
                                 "active compensation: pitch table off"};
        TrendFigure figure;
        figure.note = series.join(" · ");
        figure.panels.push_back(panelOf("A", "", "no trend shown"));
        testdata::TextRecorder recorder(QSize(500, 300));
        {
            QPainter painter(&recorder);
            (void)drawKind(painter, QRectF(0, 0, 175 * mm, 90 * mm), figure, Medium::paper);
        }
        QString all;
        for (const testdata::RecordedText &text : recorder.texts) {
            all += text.text + '\n';
            QVERIFY2(text.box.right() <= 175 * mm, qPrintable(text.text));
        }
        for (const QString &one : series)
            QVERIFY2(all.contains(one), qPrintable(one + " is not in\n" + all));
    }
};

QTEST_MAIN(DrawTrendFigure)
#include "drawtrendfigure.moc"
