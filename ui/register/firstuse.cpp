// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/firstuse.h"

#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/register/machinelist.h"
#include "ui/theme.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>

namespace palmer::ui {

namespace {

constexpr int pictureHeight = 190;
constexpr int pictureWidth = 484;
constexpr int firstFactsWidth = 744;
constexpr int factMarkSize = 16;

/// A symbol without words: test files dropping into a folder and the resulting trend.
class Picture : public QWidget {
public:
    explicit Picture(QWidget *parent)
        : QWidget(parent) {
        setFixedSize(pictureWidth, pictureHeight);
    }

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        drawFiles(painter);
        drawTrend(painter);
    }

private:
    void drawFiles(QPainter &painter) const {
        const QColor pale = token(Token::lineStrong, palette());
        for (const QPoint &at : {QPoint(2, 14), QPoint(38, 12), QPoint(20, 28)}) {
            const QRectF sheet(at, QSizeF(23, 30));
            painter.setPen(QPen(pale, 1.2));
            painter.setBrush(palette().color(QPalette::Base));
            painter.drawRoundedRect(sheet, 2, 2);
            for (const double line : {10.0, 15.0, 20.0})
                painter.drawLine(sheet.topLeft() + QPointF(5, line),
                                 sheet.topLeft() + QPointF(line > 15 ? 11 : 18, line));
        }
        QPainterPath folder(QPointF(2, 125));
        for (const QPointF &corner :
             {QPointF(2, 70), QPointF(24, 70), QPointF(32, 79), QPointF(69, 79), QPointF(69, 125)})
            folder.lineTo(corner);
        folder.closeSubpath();
        painter.setPen(QPen(token(Token::secondaryText, palette()), 1.6));
        painter.drawPath(folder);
        drawLineIcon(painter, QRect(85, 92, 16, 16), QStringLiteral("right"),
                     token(Token::secondaryText, palette()));
    }

    void drawTrend(QPainter &painter) const {
        const QColor accent = token(Token::accent, palette());
        const QColor secondary = token(Token::secondaryText, palette());
        const QRectF plot(105, 30, 378, 110);
        painter.setPen(QPen(token(Token::line, palette()), 1));
        for (const double y : {40.0, 70.0, 100.0, 130.0})
            painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(QPen(secondary, 0.8));
        for (int x = 105; x < 477; x += 6) // hatched above the limit, over the plot's width
            painter.drawLine(x, 30, x + 6, 24);
        painter.setPen(QPen(palette().color(QPalette::Text), 2));
        painter.drawLine(plot.topLeft(), plot.topRight());
        painter.setPen(QPen(secondary, 1));
        painter.drawLine(plot.bottomLeft(), plot.bottomRight());
        QColor band = accent;
        band.setAlphaF(0.13F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(band);
        painter.drawPolygon(QPolygonF({{114, 119}, {300, 80}, {483, 46}, {483, 88}, {300, 104}, {114, 137}}));
        painter.setPen(QPen(accent, 2));
        painter.drawLine(QPointF(114, 127), QPointF(438, 77));
        painter.setPen(QPen(accent, 2, Qt::DashLine));
        painter.drawLine(QPointF(438, 77), QPointF(483, 69));
        constexpr std::array heights{128.0, 112.0, 112.0, 70.0, 99.0, 83.0, 82.0};
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const QPointF at(126 + 50.0 * static_cast<double>(i), heights.at(i));
            painter.setPen(QPen(secondary, 1.1));
            painter.drawLine(at - QPointF(0, 12), at + QPointF(0, 12));
            for (const double end : {-12.0, 12.0})
                painter.drawLine(at + QPointF(-3, end), at + QPointF(3, end));
            painter.drawLine(QPointF(at.x(), plot.bottom()), QPointF(at.x(), plot.bottom() + 3));
            painter.setPen(QPen(accent, 1.5));
            painter.setBrush(palette().color(QPalette::Base));
            painter.drawEllipse(at, 4.2, 4.2);
        }
    }
};

QLabel *centred(const char *name, TextSize size) {
    auto *label = made<QLabel>(name, size);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

} // namespace

RegisterFirstUse::RegisterFirstUse(QWidget *parent)
    : QWidget(parent)
    , m_picture(new Picture(this))
    , m_title(centred("registerWelcome", TextSize::title))
    , m_text(centred("registerExplanation", TextSize::base))
    , m_choose(made<QPushButton>("chooseFolder", trait::primary))
    , m_drop(centred("registerDrop", TextSize::small)) {
    setObjectName(QStringLiteral("registerFirstUse"));
    QFont large = themeFont(TextSize::title);
    large.setPixelSize(20);
    m_title->setFont(large);
    m_title->setWordWrap(true);
    for (QLabel *label : {m_text, m_drop})
        label->setProperty("secondary", true);
    m_choose->setFixedWidth(208);
    m_choose->setProperty("large", true);
    m_choose->setDefault(true);
    setFocusProxy(m_choose);
    connect(m_choose, &QPushButton::clicked, this, &RegisterFirstUse::folderWanted);
    auto *rule = new QFrame;
    rule->setProperty("rule", true);
    rule->setFixedHeight(1);
    rule->setMaximumWidth(firstFactsWidth);
    auto *below = inColumn(styleSpacing, {rule, Placed::gap(16), makeFacts()});
    inColumn(this, {pageMargin, 8, pageMargin, 8}, styleSpacing,
             {Placed::stretch(3),
              {m_picture, 0, Qt::AlignHCenter},
              Placed::gap(4),
              m_title,
              Placed::gap(8),
              m_text,
              Placed::gap(20),
              {m_choose, 0, Qt::AlignHCenter},
              Placed::gap(8),
              m_drop,
              Placed::gap(30),
              inRow(styleSpacing, {Placed::stretch(), {below, 1000}, Placed::stretch()}),
              Placed::stretch(4)});
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base); // this changes the palette
    retranslate();
    colour();
}

QWidget *RegisterFirstUse::makeFacts() {
    auto *facts = new QWidget;
    facts->setMaximumWidth(firstFactsWidth);
    auto *grid = new QGridLayout(facts);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(2);
    for (std::size_t i = 0; i < m_facts.size(); ++i) {
        Fact &fact = m_facts.at(i);
        const int column = 2 * static_cast<int>(i);
        fact.mark = new QLabel;
        fact.mark->setFixedSize(factMarkSize, factMarkSize + 2);
        fact.title = made<QLabel>(QStringLiteral("fact%1").arg(i + 1), TextSize::base);
        fact.text = made<QLabel>(TextSize::small, trait::secondary, trait::wrapped);
        fact.text->setAlignment(Qt::AlignTop);
        grid->addWidget(fact.mark, 0, column, Qt::AlignTop);
        grid->addWidget(fact.title, 0, column + 1);
        grid->addWidget(fact.text, 1, column + 1);
        grid->setColumnStretch(column + 1, 1);
    }
    return facts;
}

void RegisterFirstUse::colour() {
    constexpr std::array icons{"lock", "subfolder", "redo"};
    for (std::size_t i = 0; i < m_facts.size(); ++i) {
        const double ratio = devicePixelRatioF();
        QPixmap mark(QSize(factMarkSize, factMarkSize) * ratio);
        mark.setDevicePixelRatio(ratio);
        mark.fill(Qt::transparent);
        QPainter painter(&mark);
        drawLineIcon(painter, QRect(0, 0, factMarkSize, factMarkSize), QString::fromLatin1(icons.at(i)),
                     token(Token::accent, palette()));
        painter.end();
        m_facts.at(i).mark->setPixmap(mark);
    }
    m_choose->setIcon(lineIcon(QStringLiteral("folderadd"), QPalette::Base));
}

void RegisterFirstUse::retranslate() {
    m_title->setText(tr("All tests of all your machines, over the years"));
    m_text->setText(tr("Name the folder in which the tests are kept. Palmer reads the .palmer files in it\n"
                       "and the PDF reports that contain them, and sorts them by machine."));
    m_choose->setText(tr("Choose a folder…"));
    m_drop->setText(tr("or drop a folder into the window"));
    const std::array titles{tr("Nothing is changed"), tr("Folders below included"), tr("Always up to date")};
    const std::array texts{tr("Your files stay the only record; Palmer never writes into them."),
                           tr("A share, a local disk: as many as you like."),
                           tr("Watched while you work; the index can be made anew at any time.")};
    for (std::size_t i = 0; i < m_facts.size(); ++i) {
        m_facts.at(i).title->setText(titles.at(i));
        m_facts.at(i).text->setText(texts.at(i));
    }
}

void RegisterFirstUse::changeEvent(QEvent *event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        colour();
}

void GhostRows::paintEvent(QPaintEvent *) {
    constexpr int marks = 4;
    constexpr std::array widths{92, 80, 104, 86, 98};
    constexpr double first = 0.75;
    constexpr double last = 0.12;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = token(Token::line, palette());
    for (std::size_t row = 0; row < widths.size(); ++row) {
        const int top = static_cast<int>(row) * machineRowHeight;
        painter.setOpacity(first + (last - first) * static_cast<double>(row) / (widths.size() - 1.0));
        painter.setPen(Qt::NoPen);
        painter.setBrush(token(Token::lineStrong, palette()));
        painter.drawRoundedRect(QRectF(pageMargin, top + 7, widths.at(row), 9), 4, 4);
        painter.setBrush(colour);
        for (int mark = 0; mark < marks; ++mark)
            painter.drawRoundedRect(QRectF(pageMargin + 40 * mark, top + 28, 22, 8), 4, 4);
        painter.setPen(colour);
        painter.drawLine(pageMargin, top + machineRowHeight - 3, width() - pageMargin,
                         top + machineRowHeight - 3);
    }
}

} // namespace palmer::ui
