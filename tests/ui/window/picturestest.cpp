// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/window/shownwindow.h"

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cstdlib>

namespace {

QString file() {
    return QStringLiteral(SOURCE "/tests/data/report/limits-2006.palmer");
}

/// Few colours make a small file; the pictures are of lines and texts.
QImage reduced(const QImage &picture) {
    return picture.convertToFormat(QImage::Format_RGB32)
        .convertToFormat(QImage::Format_Indexed8, Qt::ThresholdDither | Qt::AvoidDither);
}

/// Share of the pixels that differ visibly; 1 for another size.
double difference(const QImage &one, const QImage &other) {
    const QImage a = one.convertToFormat(QImage::Format_Grayscale8);
    const QImage b = other.convertToFormat(QImage::Format_Grayscale8);
    if (a.size() != b.size())
        return 1;
    constexpr int visible = 64;
    qint64 count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x)
            count += std::abs(a.scanLine(y)[x] - b.scanLine(y)[x]) > visible ? 1 : 0;
    }
    return double(count) / double(a.width() * a.height());
}

} // namespace

/// The pictures of the README show this version. `doc/pictures` makes them by PALMER_PICTURES.
class PicturesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }

    void areOfThisVersion_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QImage>("now");
        ShownWindow shown(file());
        QTest::qWait(500); // what is computed beside the window is shown
        QTest::newRow("window") << "window.png" << shown.window->grab().toImage();
        const QTemporaryDir folder;
        QProcess report;
        report.start(PALMER_CLI, {"report", file(), "--language", "fr", "-o", folder.filePath("r.pdf")});
        QVERIFY(report.waitForFinished(60'000) && report.exitCode() <= 1);
        QProcess page;
        page.start("pdftoppm", {"-r", "110", "-f", "1", "-l", "1", "-png", "-singlefile", folder.filePath("r.pdf"),
                                folder.filePath("page")});
        QVERIFY(page.waitForFinished(60'000));
        QTest::newRow("report") << "report-first-page.png" << QImage(folder.filePath("page.png"));
    }
    void areOfThisVersion() {
        QFETCH(const QString, name);
        QFETCH(const QImage, now);
        QVERIFY(!now.isNull());
        const QString path = QStringLiteral(SOURCE "/doc/") + name;
        if (qEnvironmentVariableIsSet("PALMER_PICTURES"))
            QVERIFY(reduced(now).save(path, "PNG", 0));
        constexpr double few = 2e-4; // less than a word
        const double share = difference(now, QImage(path));
        QVERIFY2(share < few, qPrintable(QStringLiteral("%1 shows an older version (%2 %): run doc/pictures")
                                             .arg(path)
                                             .arg(100 * share)));
        QImage other = now; // a word would be noticed
        for (int x = 300; x < 340; ++x) {
            for (int y = 300; y < 312; ++y)
                other.setPixel(x, y, other.pixel(x, y) ^ 0xFFFFFF);
        }
        QVERIFY(difference(now, other) > few);
    }
};

QTEST_MAIN(PicturesTest)
#include "picturestest.moc"
