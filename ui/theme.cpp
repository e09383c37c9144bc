// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme.h"

#include "print/figures/style.h"
#include "ui/application.h"

#include <QApplication>
#include <QEvent>
#include <QFile>
#include <QFontMetrics>
#include <QIconEngine>
#include <QPaintEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSettings>
#include <QStyle>
#include <QSvgRenderer>
#include <QToolButton>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

namespace palmer::ui {

namespace {

struct Pair {
    QRgb light;
    QRgb dark;
};

Pair colours(Token token) {
    switch (token) {
    case Token::ok:
        return {0x1B7340, 0x6BC48B};
    case Token::okGround:
        return {0xE5F3EA, 0x1D3327};
    case Token::bad:
        return {0xB3261E, 0xF28E86};
    case Token::badGround:
        return {0xFBE8E6, 0x40231F};
    case Token::unsure:
        return {0x855600, 0xE2B65A};
    case Token::unsureGround:
        return {0xFDF1D8, 0x3A2F17};
    case Token::explanation:
        return {0x7A3E9D, 0xC79AE6};
    case Token::accent:
        return {0x1F5FA8, 0x6FA8E6};
    case Token::secondaryText:
        return {0x59626B, 0xA4ACB3};
    case Token::line:
        return {0xDCDFE2, 0x34393E};
    case Token::up:
        return {0x004488, 0x78AEF0};
    case Token::down:
        return {0xE07B00, 0xF0A040};
    case Token::downText:
        return {0xA85700, 0xF2AC58};
    default:
        return {0, 0};
    }
}

QColor mixed(const QColor &colour, const QColor &ground, double strength) {
    const auto part = [&](int a, int b) { return qRound(a * strength + b * (1 - strength)); };
    return {part(colour.red(), ground.red()), part(colour.green(), ground.green()),
            part(colour.blue(), ground.blue())};
}

bool isWhole(double value) {
    return value == std::floor(value);
}

/// Read once per colour, as lists draw the same few icons in all rows.
void renderIcon(QPainter &painter, const QRectF &area, const QString &name, const QColor &colour) {
    static std::map<std::pair<QString, QRgb>, std::unique_ptr<QSvgRenderer>> known;
    auto &icon = known[{name, colour.rgb()}];
    if (!icon) {
        QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
        if (!file.open(QIODevice::ReadOnly))
            return;
        QByteArray picture = file.readAll();
        picture.replace("currentColor", colour.name().toLatin1());
        icon = std::make_unique<QSvgRenderer>(picture);
    }
    icon->render(&painter, area);
}

/// Draws `:/icons/<name>.svg` for every size and colour; it is only a few strokes.
class LineIconEngine : public QIconEngine {
public:
    LineIconEngine(QString name, QPalette::ColorRole role)
        : m_name(std::move(name))
        , m_role(role) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override {
        renderIcon(*painter, rect, m_name, colour(mode));
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override {
        const QString key = QStringLiteral("palmer-icon %1 %2 %3x%4")
                                .arg(m_name, colour(mode).name())
                                .arg(size.width())
                                .arg(size.height());
        QPixmap found;
        if (QPixmapCache::find(key, &found))
            return found;
        found = QPixmap(size);
        found.fill(Qt::transparent);
        QPainter painter(&found);
        paint(&painter, QRect(QPoint(), size), mode, state);
        painter.end();
        QPixmapCache::insert(key, found);
        return found;
    }

    [[nodiscard]] QIconEngine *clone() const override { return new LineIconEngine(*this); }

private:
    [[nodiscard]] QColor colour(QIcon::Mode mode) const {
        const QPalette palette = QApplication::palette();
        return palette.color(mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, m_role);
    }

    QString m_name;
    QPalette::ColorRole m_role;
};

/// The style sheet, with placeholders @name.
constexpr auto styleSheet = R"(
QMenuBar { background: @window; padding-left: 10px; }
QMenuBar::item { background: transparent; padding: 5px 8px; border-radius: 4px; }
QMenuBar::item:selected { background: @selected; color: @text; }
QToolTip { background: @base; color: @text; border: 1px solid @field; padding: 3px; }
QToolBar { background: @window; border: none; border-bottom: 1px solid @line; padding: 0 8px; spacing: 0; }
QToolBar::separator { background: @line; width: 1px; margin: 8px 0; }
QCheckBox::indicator, QListView::indicator { width: 14px; height: 14px; border: 1px solid @field; border-radius: 3px;
    background: @base; }
QCheckBox::indicator:hover, QCheckBox::indicator:focus, QListView::indicator:hover { border-color: @accent; }
QCheckBox::indicator:checked, QListView::indicator:checked { image: url(:/icons/check-@kind.svg); background: @selected; border-color: @accent; }
QCheckBox::indicator:indeterminate { image: url(:/icons/dash-@kind.svg); border-color: @unsure; }
QCheckBox::indicator:disabled { border-color: @line; }
QListView[roomy="true"]::item, QTreeView[roomy="true"]::item { min-height: 22px; }
QScrollBar { background: transparent; border: none; }
QScrollBar:vertical { width: 9px; }
QScrollBar:horizontal { height: 9px; }
QScrollBar::handle { background: @field; border-radius: 3px; margin: 1px; }
QScrollBar::handle:hover { background: @disabled; }
QScrollBar::handle:vertical { min-height: 28px; }
QScrollBar::handle:horizontal { min-width: 28px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QStatusBar { background: @window; border-top: 1px solid @line; }
QStatusBar::item { border: none; }
QPushButton { background: @base; color: @text; border: 1px solid @field; border-radius: 4px;
    min-height: 26px; padding: 0 12px; icon-size: 16px; }
QPushButton:hover { background: @hover; }
QPushButton:pressed, QPushButton:checked { background: @selected; border-color: @accent; }
QPushButton:disabled { color: @disabled; border-color: @line; }
QPushButton:focus { border: 2px solid @accent; min-height: 24px; padding: 0 11px; }
QPushButton::menu-indicator, QToolButton::menu-indicator { image: url(:/icons/down-@kind.svg); width: 12px;
    height: 12px; subcontrol-origin: padding; subcontrol-position: center right; right: 6px; }
QToolButton[popupMode="1"] { padding-right: 20px; }
QToolButton::menu-button { border: none; width: 18px; }
QToolButton::menu-arrow { image: url(:/icons/down-@kind.svg); width: 12px; height: 12px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QPushButton[primary="true"] { background: @accent; color: @onAccent; border-color: @accent; }
QPushButton[primary="true"]:hover { background: @accentHover; }
QPushButton[primary="true"]:focus { border-color: @text; }
QPushButton[primary="true"]:disabled { background: @line; color: @disabled; border-color: @line; }
QPushButton[large="true"] { min-height: 34px; }
QPushButton[large="true"]:focus { min-height: 32px; }
QPushButton[link="true"] { background: transparent; color: @accent; border-color: transparent; padding: 0 4px; }
QStatusBar > QPushButton { min-height: 22px; }
QStatusBar > QPushButton:focus { min-height: 20px; }
QPushButton[link="true"][bad="true"] { color: @bad; }
QPushButton[link="true"][opens="true"] { padding: 0 18px 0 4px; }
QPushButton[link="true"]:hover { text-decoration: underline; }
QPushButton[link="true"]:focus { border: 2px solid @accent; padding: 0 3px; }
QPushButton[link="true"][opens="true"]:focus { padding: 0 17px 0 3px; }
QToolButton { background: transparent; color: @text; border: 1px solid transparent; border-radius: 4px;
    min-height: 26px; padding: 0 7px; icon-size: 16px; }
QToolButton[iconOnly="true"] { padding: 0 5px; min-width: 16px; }
QToolButton[tight="true"] { padding: 0 3px; }
QToolButton:hover { background: @hover; }
QToolButton:pressed, QToolButton:checked { background: @selected; border-color: @accent; }
QToolButton:disabled { color: @disabled; }
QToolButton:focus { border: 2px solid @accent; min-height: 24px; padding: 0 6px; }
QToolButton[iconOnly="true"]:focus { padding: 0 4px; }
QToolButton[tight="true"]:focus { padding: 0 2px; }
QToolBar > QToolButton { padding: 0 @afterWord 0 12px; }
QToolBar > QToolButton:focus { padding: 0 @afterFocusedWord 0 11px; }
QToolBar > QToolButton[iconOnly="true"] { padding: 0 12px; }
QToolBar > QToolButton[iconOnly="true"]:focus { padding: 0 11px; }
QToolBar > QToolButton[popupMode="1"] { padding-right: 20px; }
QToolBar > QToolButton[popupMode="1"]:focus { padding-right: 19px; }
QToolBar > QToolButton::menu-button { width: 36px; }
QToolButton[segment="first"], QToolButton[segment="middle"], QToolButton[segment="last"] {
    background: @base; border: 1px solid @field; border-radius: 0; padding: 0 9px; min-height: 24px; }
QToolButton[segment="only"] { background: @base; border: 1px solid @field; padding: 0 22px 0 9px; min-height: 24px; }
QToolButton[segment="first"] { border-top-left-radius: 4px; border-bottom-left-radius: 4px; }
QToolButton[segment="middle"], QToolButton[segment="last"] { margin-left: -1px; }
QToolButton[segment="last"] { border-top-right-radius: 4px; border-bottom-right-radius: 4px; }
QToolButton[segment][narrow="true"] { padding: 0 2px; }
QToolButton[segment]:checked { background: @selected; border-color: @accent; }
QToolButton[segment]:focus { border: 2px solid @accent; padding: 0 8px; min-height: 22px; }
QToolButton[segment][narrow="true"]:focus { padding: 0 1px; }
QLineEdit, QAbstractSpinBox, QComboBox, QPlainTextEdit { background: @base; color: @text; border: 1px solid @field;
    border-radius: 3px; selection-background-color: @accent; selection-color: @onAccent; }
QLineEdit, QAbstractSpinBox, QComboBox { min-height: 26px; padding: 0 8px; }
QLineEdit > QToolButton { border: none; padding: 0; min-height: 0; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus { border: 2px solid @accent; min-height: 24px; padding: 0 7px; }
QLineEdit[dense="true"], QComboBox[dense="true"] { min-height: 24px; }
QLineEdit[dense="true"]:focus, QComboBox[dense="true"]:focus { min-height: 22px; }
QLineEdit[cell="true"], QLineEdit[cell="true"]:focus { border: 2px solid @accent; min-height: 0; padding: 0 4px 0 2px; }
QPlainTextEdit { padding: 0 6px; }
QPlainTextEdit:focus { border: 2px solid @accent; padding: 0 5px; }
QLineEdit[refused="true"], QPlainTextEdit[refused="true"] { color: @bad; border-color: @bad; }
QLineEdit:disabled, QComboBox:disabled { color: @disabled; }
QComboBox::drop-down { border: none; width: 22px; }
QComboBox::down-arrow { image: url(:/icons/down-@kind.svg); width: 14px; height: 14px; }
QComboBox QAbstractItemView { background: @base; border: 1px solid @field; selection-background-color: @selected;
    selection-color: @text; outline: none; }
QFrame[card="true"] { background: @base; border: 1px solid @line; border-radius: 6px; }
.QWidget[ground="base"], palmer--ui--RightSide, palmer--ui--CirclesPage { background: @base; }
QFrame[rule="true"] { background: @line; border: none; }
QLabel[reason="true"] { background: @badGround; color: @bad; border: 1px solid @bad; border-radius: 3px; padding: 0 8px; }
QLabel[mark="true"] { background: @unsureGround; color: @unsure; border: 1px solid @unsure; border-radius: 3px; padding: 1px 8px; }
QLabel[keycap="true"] { background: @window; border: 1px solid @field; border-radius: 3px; padding: 0 5px; }
QFrame[notice="good"] { background: @okGround; border: none; border-bottom: 1px solid @line; }
QFrame[notice="true"] { background: @unsureGround; border: none; border-bottom: 1px solid @line; }
QFrame[bar="true"] { background: @selected; border: 1px solid @accent; border-radius: 4px; }
QLabel[secondary="true"] { color: @secondary; }
QLabel[tone="unsure"] { color: @unsure; }
QLabel[tone="bad"], QLabel[refused="true"] { color: @bad; }
)";

QString pixels(int count) {
    return QString::number(std::max(count, 0)) + QStringLiteral("px");
}

QString filledStyleSheet(const QPalette &palette) {
    const QColor window = palette.color(QPalette::Window);
    const QColor base = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::WindowText);
    const QColor accent = token(Token::accent, palette);
    // Qt adds two spaces and three pixels after a tool button's word; less padding there centres icon and
    // word.
    const int behind = 2 * QFontMetrics(QApplication::font()).horizontalAdvance(u' ') + 3;
    const std::array<std::pair<const char *, QString>, 20> values{{
        {"@afterWord", pixels(12 - behind)},
        {"@afterFocusedWord", pixels(11 - behind)},
        // longer names first, as one is a prefix of another
        {"@accentHover", mixed(accent, text, 0.85).name()},
        {"@accent", accent.name()},
        {"@onAccent", isDark(palette) ? QStringLiteral("#101316") : QStringLiteral("#ffffff")},
        {"@selected", mixed(accent, base, isDark(palette) ? 0.3 : 0.13).name()},
        {"@secondary", token(Token::secondaryText, palette).name()},
        {"@okGround", token(Token::okGround, palette).name()},
        {"@unsureGround", token(Token::unsureGround, palette).name()},
        {"@unsure", token(Token::unsure, palette).name()},
        {"@badGround", token(Token::badGround, palette).name()},
        {"@bad", token(Token::bad, palette).name()},
        {"@window", window.name()},
        {"@base", base.name()},
        {"@text", text.name()},
        {"@field", mixed(text, base, 0.3).name()},
        {"@disabled", palette.color(QPalette::Disabled, QPalette::WindowText).name()},
        {"@hover", token(Token::hover, palette).name()},
        {"@line", token(Token::line, palette).name()},
        {"@kind", isDark(palette) ? QStringLiteral("dark") : QStringLiteral("light")},
    }};
    QString sheet = QString::fromLatin1(styleSheet);
    for (const auto &[name, value] : values)
        sheet.replace(QLatin1StringView(name), value);
    return sheet;
}

/// Refills the style sheet when the system changes the palette.
class Theme : public QObject {
public:
    explicit Theme(QObject *parent)
        : QObject(parent) {
        fill();
        qApp->installEventFilter(this);
    }

    bool eventFilter(QObject *watched, QEvent *event) override {
        if (watched == qApp && event->type() == QEvent::ApplicationPaletteChange)
            fill();
        return false;
    }

private:
    static void fill() {
        const QString sheet = filledStyleSheet(QApplication::palette());
        if (sheet == qApp->styleSheet())
            return;
        qApp->setStyleSheet(sheet);
        useOneFont();
    }
};

constexpr auto themeKey = "window/theme";
// Settings values in the order of the enumeration; never change them.
constexpr std::array themeWords{"system", "light", "dark"};

/// The colours of one of our palettes, from which the others are derived.
struct Ground {
    QRgb window, base, text, disabled;
};
constexpr Ground lightGround{0xF3F4F5, 0xFFFFFF, 0x16191C, 0x9AA0A6};
constexpr Ground darkGround{0x1F2225, 0x181A1D, 0xE8EAEC, 0x6B7178};

QPalette paletteOf(const Ground &ground) {
    const QColor window = QColor::fromRgb(ground.window);
    const QColor base = QColor::fromRgb(ground.base);
    const QColor text = QColor::fromRgb(ground.text);
    const QColor disabled = QColor::fromRgb(ground.disabled);
    QPalette palette(window, window); // derives lights and shadows
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                           QPalette::ToolTipText, QPalette::HighlightedText}) {
        palette.setColor(role, text);
        palette.setColor(QPalette::Disabled, role, disabled);
    }
    palette.setColor(QPalette::Base, base);
    palette.setColor(QPalette::ToolTipBase, base);
    palette.setColor(QPalette::AlternateBase, mixed(window, base, 0.5));
    palette.setColor(QPalette::PlaceholderText, disabled);
    palette.setColor(QPalette::Highlight, selectedGround(palette));
    palette.setColor(QPalette::Link, token(Token::accent, palette));
    return palette;
}

void usePalette(ThemeChoice choice) {
    switch (choice) {
    case ThemeChoice::system:
        QApplication::setPalette(QPalette());
        return;
    case ThemeChoice::light:
        QApplication::setPalette(paletteOf(lightGround));
        return;
    case ThemeChoice::dark:
        QApplication::setPalette(paletteOf(darkGround));
        return;
    }
}

} // namespace

ThemeChoice themeChoice() {
    const QByteArray kept = QSettings().value(QLatin1StringView(themeKey)).toByteArray();
    const auto found = std::ranges::find(themeWords, std::string_view(kept.constData()));
    return found == themeWords.end() ? ThemeChoice::system
                                     : static_cast<ThemeChoice>(found - themeWords.begin());
}

void setThemeChoice(ThemeChoice choice) {
    QSettings().setValue(QLatin1StringView(themeKey),
                         QByteArray(themeWords.at(static_cast<std::size_t>(choice))));
    usePalette(choice);
}

bool isDark(const QPalette &palette) {
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
}

Medium screenMedium(const QPalette &palette) {
    return isDark(palette) ? Medium::screenDark : Medium::screenLight;
}

QColor token(Token token, const QPalette &palette) {
    const QColor base = palette.color(QPalette::Base);
    if (token == Token::lineStrong)
        return mixed(palette.color(QPalette::WindowText), base, 0.35);
    if (token == Token::hover)
        return mixed(palette.color(QPalette::WindowText), base, 0.07);
    const Pair pair = colours(token);
    return QColor::fromRgb(isDark(palette) ? pair.dark : pair.light);
}

QColor selectedGround(const QPalette &palette) {
    return mixed(token(Token::accent, palette), palette.color(QPalette::Base), isDark(palette) ? 0.3 : 0.13);
}

QFont themeFont(TextSize size) {
    constexpr std::array factors{1.0, 0.92, 0.85, 1.0, 1.15};
    QFont font = QApplication::font();
    const double factor = factors.at(static_cast<std::size_t>(size));
    if (font.pointSizeF() > 0)
        font.setPointSizeF(font.pointSizeF() * factor);
    else
        font.setPixelSize(qRound(font.pixelSize() * factor));
    if (size == TextSize::head || size == TextSize::title)
        font.setWeight(QFont::DemiBold);
    return font;
}

QToolButton *iconButton(QWidget *parent, const QString &objectName, const QString &icon) {
    auto *button = new QToolButton(parent);
    button->setObjectName(objectName);
    button->setIcon(lineIcon(icon));
    button->setProperty("iconOnly", true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

QIcon lineIcon(const QString &name, QPalette::ColorRole role) {
    return QIcon(new LineIconEngine(name, role));
}

void drawLineIcon(QPainter &painter, const QRect &area, const QString &name, const QColor &colour) {
    QRectF square(0, 0, 16, 16);
    square.moveCenter(QRectF(area).center());
    square.moveTopLeft(square.topLeft().toPoint());
    const double ratio = painter.device()->devicePixelRatioF();
    const QTransform &moved = painter.worldTransform();
    const bool onGrid = painter.paintEngine()->type() == QPaintEngine::Raster &&
                        moved.type() <= QTransform::TxTranslate && isWhole(ratio) && isWhole(moved.dx()) &&
                        isWhole(moved.dy());
    if (!onGrid) {
        renderIcon(painter, square, name, colour);
        return;
    }
    // Cached, as lists and tables draw the same few marks in each row.
    const QString key = QStringLiteral("palmer-mark %1 %2 %3").arg(name, colour.name()).arg(ratio);
    QPixmap mark;
    if (!QPixmapCache::find(key, &mark)) {
        mark = QPixmap((square.size() * ratio).toSize());
        mark.setDevicePixelRatio(ratio);
        mark.fill(Qt::transparent);
        QPainter once(&mark);
        renderIcon(once, QRectF(QPointF(), square.size()), name, colour);
        once.end();
        QPixmapCache::insert(key, mark);
    }
    painter.drawPixmap(square.topLeft(), mark);
}

void setStyled(QWidget &widget, const char *property, bool value) {
    if (widget.property(property).toBool() == value)
        return;
    widget.setProperty(property, value);
    widget.style()->unpolish(&widget); // matches the rules again
    widget.style()->polish(&widget);
}

namespace {

constexpr const char *textSizeKey = "window/textSize";
constexpr int smallestTextStep = -2;
constexpr int largestTextStep = 5;

void useTextSize(int step) {
    static const QFont ofSystem = QApplication::font();
    constexpr double perStep = 0.1;
    QFont font = ofSystem;
    const double factor = 1 + perStep * step;
    if (font.pointSizeF() > 0)
        font.setPointSizeF(ofSystem.pointSizeF() * factor);
    else
        font.setPixelSize(qRound(ofSystem.pixelSize() * factor));
    if (font != QApplication::font())
        QApplication::setFont(font);
}

} // namespace

int textSizeStep() {
    return std::clamp(QSettings().value(QLatin1StringView(textSizeKey), 0).toInt(), smallestTextStep,
                      largestTextStep);
}

void setTextSizeStep(int step) {
    QSettings().setValue(QLatin1StringView(textSizeKey), std::clamp(step, smallestTextStep, largestTextStep));
    useTextSize(textSizeStep());
}

void installTheme() {
    static bool installed = false;
    if (std::exchange(installed, true))
        return;
    useTextSize(textSizeStep());
    if (const ThemeChoice choice = themeChoice(); choice != ThemeChoice::system)
        usePalette(choice);
    new Theme(qApp);
}

} // namespace palmer::ui
