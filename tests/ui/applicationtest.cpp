// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "ui/application.h"

#include "ui/window/shownwindow.h"

#include <QDirIterator>
#include <QFontInfo>
#include <QLabel>
#include <QMenuBar>
#include <QRawFont>
#include <QTableView>
#include <QTemporaryFile>
#include <QTest>
#include <array>
#include <string>

using namespace palmer::ui;
using namespace Qt::StringLiterals;

/// A window on a desktop whose fonts are twice as large.
class ApplicationTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { prepareApplication(); }

    void usualFontsLeaveTheWindowAsItIs() {
        const QSize screen(1920, 1080);
        for (const double pixels : {9.0, 12.0, 13.0, 15.0, 16.0})
            QCOMPARE(scaleForFont(pixels, screen), 1.0);
        QCOMPARE(scaleForFont(17, screen), 1.25);
        QCOMPARE(scaleForFont(24, screen), 1.75);
        QCOMPARE(scaleForFont(26, screen), 2.0);
    }

    void screensKeepRoomForTheWindow() {
        QCOMPARE(scaleForFont(24, QSize(1280, 800)), 1.75);
        QCOMPARE(scaleForFont(24, QSize(960, 720)), 1.5);
        QCOMPARE(scaleForFont(24, QSize(800, 600)), 1.25);
        QCOMPARE(scaleForFont(24, QSize(500, 400)), 1.0);
        for (double pixels = 5; pixels < 60; pixels += 0.5) {
            const double scale = scaleForFont(pixels, QSize(3840, 2160));
            QVERIFY(scale >= scaleForFont(pixels - 0.5, QSize(3840, 2160)));
            QVERIFY(pixels / scale <= 16.5);
        }
    }

    void theWholeIsEnlarged() {
        QCOMPARE(qApp->devicePixelRatio(), 1.75);
        const int pixels = QFontInfo(QApplication::font()).pixelSize();
        QVERIFY2(pixels >= 11 && pixels <= 15, qPrintable(QString::number(pixels)));
        QVERIFY(!qEnvironmentVariableIsSet("QT_SCALE_FACTOR")); // nothing for what is started from here
        QCOMPARE(QCoreApplication::arguments().value(1), u"a word"_s);
    }

    /// On a machine without fonts each sign that the sources of the window write comes from the program.
    void noSignIsAnEmptyBox() {
        const QRawFont letters(u":/fonts/LiberationSans-Regular.ttf"_s, 10);
        const QRawFont signs(u":/signs/PalmerSigns.ttf"_s, 10);
        QCOMPARE(QFont::substitutes(QApplication::font().family()), {signs.familyName().toLower()});
        int found = 0;
        QDirIterator sources(QStringLiteral(PALMER_SOURCE_DIR "/ui"), {u"*.cpp"_s}, QDir::Files,
                             QDirIterator::Subdirectories);
        while (sources.hasNext()) {
            QFile source(sources.next());
            QVERIFY(source.open(QIODevice::ReadOnly));
            for (const QChar sign : QString::fromUtf8(source.readAll())) {
                if (sign.category() != QChar::Symbol_Other && sign.category() != QChar::Symbol_Math)
                    continue;
                found += signs.supportsCharacter(sign);
                QVERIFY2(letters.supportsCharacter(sign) || signs.supportsCharacter(sign),
                         qPrintable(source.fileName() + u" writes "_s + sign));
            }
        }
        QVERIFY(found > 10);
    }

    /// A change of the style takes the fonts of the desktop for them.
    void menusAndToolsHaveTheFontOfTheRest() {
        QFont large = QApplication::font();
        large.setPointSizeF(2 * large.pointSizeF());
        QApplication::setFont(large, "QToolButton");
        QApplication::setFont(large, "QMenuBar");
        useOneFont();
        QCOMPARE(QApplication::font("QToolButton"), QApplication::font());
        QCOMPARE(QApplication::font("QMenuBar"), QApplication::font());
    }

    /// What does not fit ends in "…" and has no place in which its letters are cut off above and below.
    void nothingIsCutOff() {
        for (const char *example : {"iso230-2-1988-example", "iso230-4-full-circles-xy"}) {
            const ShownWindow shown(examplePath(example), {1090, 600});
            QTRY_VERIFY(shown.find("rightSide")->isVisible());
            int seen = 0;
            for (const auto *label : shown.window->findChildren<QLabel *>()) {
                if (!label->isVisible() || label->text().isEmpty() || label->wordWrap())
                    continue;
                ++seen;
                QVERIFY2(label->height() >= label->fontMetrics().ascent() + 2, qPrintable(label->text()));
            }
            QVERIFY(seen > 8);
            if (auto *view = shown.find<QTableView>("readings"); view->isVisible()) {
                const QRect sixth = view->visualRect(view->model()->index(5, 0));
                QVERIFY(view->viewport()->rect().contains(sixth));
            }
            const auto *menu = shown.window->menuBar();
            QVERIFY(menu->height() >= menu->fontMetrics().height());
            for (auto *table : shown.window->findChildren<QTableView *>()) {
                if (table->isVisible() && table->model()->rowCount() > 0)
                    QVERIFY2(table->rowHeight(0) >= table->fontMetrics().height(),
                             qPrintable(table->objectName()));
            }
        }
    }
};

PALMER_TEST(runApplicationTest) {
    qputenv("QT_FONT_DPI", "192");
    qputenv("QT_ENABLE_HIGHDPI_SCALING", "0"); // the fonts alone are larger
    qunsetenv("QT_SCALE_FACTOR");
    QTemporaryFile screen;
    if (!screen.open())
        return 1;
    screen.write(R"({"screens": [{"name": "one", "x": 0, "y": 0, "width": 1920, "height": 1080}]})");
    screen.close();
    std::string platform = "offscreen:configfile=" + screen.fileName().toStdString();
    std::string program(argv[0]);
    std::string option("-platform");
    std::string word("a word");
    std::array<char *, 5> words{program.data(), option.data(), platform.data(), word.data(), nullptr};
    int count = 4;
    const auto application = makeApplication(count, words.data());
    ApplicationTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "applicationtest.moc"
