// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/sectionhead.h"

#include "ui/elidedlabel.h"
#include "ui/theme.h"

#include <QAccessibleWidget>
#include <QEvent>
#include <QKeyEvent>
#include <QPainter>

namespace palmer::ui {

namespace {

constexpr int leastHeight = 28;
constexpr int arrowWidth = 22;
constexpr int gap = 12;

/// A button that reports being expanded or collapsed, which Qt's buttons do not.
class HeadAccess : public QAccessibleWidget {
public:
    explicit HeadAccess(QWidget *head)
        : QAccessibleWidget(head, QAccessible::Button) {}

    [[nodiscard]] QAccessible::State state() const override {
        QAccessible::State state = QAccessibleWidget::state();
        const bool folded = static_cast<const SectionHead *>(widget())->isFolded();
        state.expandable = true;
        state.expanded = !folded;
        state.collapsed = folded;
        return state;
    }
    [[nodiscard]] QStringList actionNames() const override {
        return QStringList(pressAction()) + QAccessibleWidget::actionNames();
    }
    void doAction(const QString &name) override {
        if (name == pressAction())
            static_cast<SectionHead *>(widget())->click();
        else
            QAccessibleWidget::doAction(name);
    }
};

QAccessibleInterface *accessOf(const QString &, QObject *object) {
    auto *head = qobject_cast<SectionHead *>(object);
    return head ? new HeadAccess(head) : nullptr;
}

} // namespace

SectionHead::SectionHead(QWidget *parent)
    : QAbstractButton(parent) {
    [[maybe_unused]] static const bool known = (QAccessible::installFactory(accessOf), true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
}

void SectionHead::setTitle(const QString &title) {
    setText(title);
    setAccessibleName(title);
    retranslate();
}

void SectionHead::setSummary(const QString &summary, bool asks) {
    if (m_summary == summary && m_asks == asks)
        return;
    m_summary = summary;
    m_asks = asks;
    retranslate();
}

void SectionHead::setFolded(bool folded) {
    if (m_folded == folded)
        return;
    m_folded = folded;
    setFocusPolicy(folded ? Qt::StrongFocus : Qt::ClickFocus); // what is open is reached by its fields
    retranslate();
    QAccessible::State changed;
    changed.expanded = true;
    changed.collapsed = true;
    QAccessibleStateChangeEvent event(this, changed);
    QAccessible::updateAccessibility(&event);
}

void SectionHead::retranslate() {
    setAccessibleDescription(m_folded ? m_summary : QString());
    constexpr qsizetype longest = 1000;
    const QString what = m_folded ? tr("Unfold the section") : tr("Fold the section away");
    setToolTip(m_folded && !m_summary.isEmpty() ? m_summary.first(std::min(m_summary.size(), longest))
                                                : what);
    update();
}

QSize SectionHead::sizeHint() const {
    const QFontMetrics metrics(themeFont(TextSize::head));
    return {metrics.horizontalAdvance(text()) + gap + arrowWidth, std::max(leastHeight, metrics.height())};
}

void SectionHead::paintEvent(QPaintEvent *) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(token(Token::accent, palette()), 2) : QPen(Qt::NoPen));
        painter.setBrush(underMouse() ? QBrush(token(Token::hover, palette())) : QBrush(Qt::NoBrush));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
    // The title is aligned with the fields; the focus frame needs a margin.
    const QRect room = rect().adjusted(hasFocus() ? 4 : 0, 0, -arrowWidth, 0);
    painter.setFont(themeFont(TextSize::head));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, text());
    const int used = painter.fontMetrics().horizontalAdvance(text()) + gap;
    drawLineIcon(painter, QRect(width() - arrowWidth, 0, arrowWidth, height()),
                 m_folded ? QStringLiteral("left") : QStringLiteral("down"),
                 token(Token::secondaryText, palette()));
    if (!m_folded)
        return;
    drawElided(painter, room.adjusted(used, 0, 0, 0), Qt::AlignLeft, m_summary, themeFont(TextSize::small),
               token(m_asks ? Token::unsure : Token::secondaryText, palette()));
}

void SectionHead::keyPressEvent(QKeyEvent *event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const bool toggles =
        enter || (event->key() == Qt::Key_Left && !m_folded) || (event->key() == Qt::Key_Right && m_folded);
    if (toggles)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

void SectionHead::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) {
        updateGeometry();
        retranslate();
    }
    QAbstractButton::changeEvent(event);
}

} // namespace palmer::ui
