// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/application.h"

#include "print/fonts.h"

#include <QApplication>
#include <QFontDatabase>
#include <QFontInfo>
#include <QRawFont>
#include <QScreen>
#include <algorithm>
#include <cmath>
#include <vector>

namespace palmer::ui {

namespace {

constexpr auto styleName = "fusion";
constexpr auto scaleVariable = "QT_SCALE_FACTOR";
constexpr double designed = 13;         ///< font size the layout is designed for, px
constexpr double roomUntil = 16.5;      ///< smallest font size that needs scaling, px
constexpr QSizeF leastScreen(640, 440); ///< smallest screen, in scaled pixels
constexpr auto enlarged = "enlarged";

/// True if Windows replaces its own font by any other, with serifs perhaps, as Wine does. Elsewhere the name
/// of a font may be that of a kind of fonts.
bool isReplaced(const QFont &font) {
    return QGuiApplication::platformName() == QLatin1StringView("windows") &&
           QFontDatabase::styles(font.family()).isEmpty(); // its name alone is always known
}

/// Signs that no font of the machine may have (⚠, ✓, ↺) come from one of the program, and letters from that
/// of the reports if the machine has no font at all.
void addFonts() {
    loadFonts(); // first, as in the command line: a PDF has its fonts in the order of Qt's numbers for them
    QFont font = QApplication::font();
    if (QRawFont::fromFont(font).fontTable("cmap").isEmpty()) { // Qt's boxes
        font.setFamily(paperFamily());
        QApplication::setFont(font);
    } else if (isReplaced(font)) {
        QFont::insertSubstitution(font.family(), paperFamily()); // that of menus as well
    }
    const int signs = QFontDatabase::addApplicationFont(QStringLiteral(":/signs/PalmerSigns.ttf"));
    QFont::insertSubstitutions(font.family(), QFontDatabase::applicationFontFamilies(signs));
}

} // namespace

double scaleForFont(double pixels, QSize screen) {
    if (pixels < roomUntil)
        return 1;
    const double room =
        std::min(screen.width() / leastScreen.width(), screen.height() / leastScreen.height());
    const double quarters = std::min(std::round(4 * pixels / designed), std::floor(4 * room));
    return std::max(1.0, quarters / 4);
}

std::unique_ptr<QApplication> makeApplication(int &argc, char **argv) {
    const std::vector<char *> words(argv, argv + argc); // QApplication removes the arguments it knows
    auto application = std::make_unique<QApplication>(argc, argv);
    QApplication::setStyle(QLatin1StringView(styleName));
    QFont font = QApplication::font();
    const double scale =
        scaleForFont(QFontInfo(font).pixelSize(), QGuiApplication::primaryScreen()->availableSize());
    if (scale == 1) {
        addFonts();
        return application;
    }
    // The desktop's font is known only once there is an application, but the scale must be set before.
    application.reset();
    argc = static_cast<int>(words.size());
    std::ranges::copy(words, argv);
    const QByteArray before = qgetenv(scaleVariable);
    const double asked = before.isEmpty() ? 1 : before.toDouble();
    qputenv(scaleVariable, QByteArray::number(scale * (asked > 0 ? asked : 1)));
    application = std::make_unique<QApplication>(argc, argv);
    if (before.isEmpty())
        qunsetenv(scaleVariable); // child processes have their own scale
    else
        qputenv(scaleVariable, before);
    if (font.pointSizeF() > 0)
        font.setPointSizeF(font.pointSizeF() / scale);
    else
        font.setPixelSize(static_cast<int>(std::lround(font.pixelSize() / scale)));
    QApplication::setStyle(QLatin1StringView(styleName));
    QApplication::setFont(font);
    application->setProperty(enlarged, true);
    addFonts();
    return application;
}

void useOneFont() {
    if (!qApp->property(enlarged).toBool())
        return;
    for (const char *name : {"QMenu", "QMenuBar", "QMessageBox", "QTipLabel", "QStatusBar", "QPushButton",
                             "QCheckBox", "QRadioButton", "QToolButton", "QAbstractItemView", "QListView",
                             "QHeaderView", "QComboMenuItem", "QComboLineEdit"})
        QApplication::setFont(QApplication::font(), name);
}

} // namespace palmer::ui
