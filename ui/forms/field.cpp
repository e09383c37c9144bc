#include "ui/forms/field.h"

#include "ui/elidedlabel.h"
#include "ui/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace palmer::ui {

namespace {

constexpr int fieldHeight = 28;
constexpr int labelHeight = 16;
constexpr int labelGap = 4;
constexpr int barWidth = 4;
constexpr int margin = 8;

void colour(QWidget *widget, QPalette::ColorRole role, const QColor &colour) {
    QPalette palette = widget->palette();
    palette.setColor(role, colour);
    widget->setPalette(palette);
}

/// The bar at the left of a field that is required and empty.
class RequiredBar : public QWidget {
public:
    using QWidget::QWidget;

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter(this).fillRect(rect(), token(Token::unsure, palette()));
    }
};

} // namespace

Field::Field(Kind kind, QWidget *parent)
    : QWidget(parent)
    , m_kind(kind)
    , m_label(new ElidedLabel(this))
    , m_mark(new QLabel(this))
    , m_edit(new QLineEdit(this))
    , m_unit(new QLabel(m_edit))
    , m_bar(new RequiredBar(m_edit)) {
    m_label->setFixedHeight(labelHeight);
    m_label->setProperty("secondary", true);
    m_label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_mark->setFixedHeight(labelHeight);
    m_label->setBuddy(m_edit);
    m_edit->setFixedHeight(fieldHeight);
    m_edit->setReadOnly(true);
    m_edit->setAlignment((kind == Kind::number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    m_unit->setProperty("secondary", true);
    m_unit->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_bar->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(0, 0, 0, 0);
    head->addWidget(m_label, 1);
    head->addWidget(m_mark);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(labelGap);
    layout->addLayout(head);
    layout->addWidget(m_edit);
    setFocusProxy(m_edit);
    retranslate();
}

void Field::setLabel(const QString &label) {
    m_labelSource = label;
    retranslate();
}

void Field::setLabelArgument(const QString &argument) {
    m_labelArgument = argument;
    retranslate();
}

void Field::setUnit(const QString &unit) {
    m_unit->setText(unit);
    placeParts();
}

void Field::show(const QString &value, bool required) {
    m_edit->setText(value);
    m_edit->setCursorPosition(0);
    m_edit->setToolTip(value.size() > 30 ? value : QString());
    m_required = required;
    retranslate();
}

void Field::placeParts() {
    const int unitWidth = m_unit->text().isEmpty() ? 0 : m_unit->sizeHint().width() + 6;
    m_edit->setTextMargins(m_required ? barWidth : 0, 0, unitWidth, 0);
    m_unit->setGeometry(m_edit->width() - unitWidth - margin + 4, 0, unitWidth, fieldHeight);
    m_bar->setGeometry(1, 1, barWidth, fieldHeight - 2);
    m_bar->setVisible(m_required);
    // Where label and word have no room beside each other, the mark stands alone; the bar and the placeholder
    // say the same.
    const QString mark = QStringLiteral("● ") + tr("required");
    const int needed = m_label->fontMetrics().horizontalAdvance(m_label->text()) +
                       m_mark->fontMetrics().horizontalAdvance(mark) + margin;
    m_mark->setText(!m_required ? QString() : needed > width() && width() > 0 ? QStringLiteral("●") : mark);
    m_mark->setToolTip(tr("required"));
    m_unit->setVisible(unitWidth > 0);
}

void Field::retranslate() {
    m_label->setFont(themeFont(TextSize::small));
    m_unit->setFont(themeFont(TextSize::small));
    m_mark->setFont(themeFont(TextSize::tiny));
    const QString label = m_labelArgument.isEmpty() || m_labelSource.isEmpty()
                              ? m_labelSource
                              : m_labelSource.arg(m_labelArgument);
    m_label->setText(label);
    m_mark->setVisible(m_required);
    m_edit->setPlaceholderText(m_kind == Kind::number && !m_unit->text().isEmpty() ? QStringLiteral("–")
                                                                                   : tr("not stated"));
    m_edit->setAccessibleName(label);
    m_edit->setAccessibleDescription(m_required                 ? tr("required, not stated")
                                     : m_edit->text().isEmpty() ? tr("not stated")
                                                                : m_unit->text());
    const QColor unsure = token(Token::unsure, palette());
    colour(m_mark, QPalette::WindowText, unsure);
    placeParts();
}

void Field::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::PaletteChange)
        retranslate();
    QWidget::changeEvent(event);
}

void Field::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    placeParts();
}

} // namespace palmer::ui
