// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/field.h"

#include "document/bounds.h"
#include "language/withunit.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QAbstractScrollArea>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPlainTextEdit>
#include <algorithm>
#include <array>
#include <limits>

namespace palmer::ui {

namespace {

constexpr int linesHeight = 66;
constexpr int denseHeight = 26;
constexpr int labelGap = 4;
constexpr int labelHeight = Field::headHeight - labelGap;
constexpr int barWidth = 4;
constexpr int margin = 8;
constexpr int iconSize = 12;
constexpr qsizetype longestToolTip = 1000;

/// Bar on the left of a field that is required and empty.
class RequiredBar : public QWidget {
public:
    using QWidget::QWidget;

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter(this).fillRect(rect(), token(Token::unsure, palette()));
    }
};

/// Icon in front of the reason for a refusal.
class RefusedMark : public QWidget {
public:
    explicit RefusedMark(QWidget *parent)
        : QWidget(parent) {
        setFixedSize(iconSize, iconSize);
    }

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter painter(this);
        drawLineIcon(painter, rect(), QStringLiteral("warn"), token(Token::bad, palette()));
    }
};

/// Goes from not stated to yes, no, and back.
class AnswerBox : public QCheckBox {
public:
    explicit AnswerBox(QWidget *parent)
        : QCheckBox(parent) {
        setTristate(true);
        setCheckState(Qt::PartiallyChecked);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }

protected:
    void nextCheckState() override {
        setCheckState(checkState() == Qt::PartiallyChecked ? Qt::Checked
                      : checkState() == Qt::Checked        ? Qt::Unchecked
                                                           : Qt::PartiallyChecked);
    }
};

constexpr std::array answers{Qt::PartiallyChecked, Qt::Checked, Qt::Unchecked};

/// Beginning of a long text, enough to recognise it.
QString beginningOf(const QString &text) {
    constexpr qsizetype enough = 60;
    return text.size() <= enough ? text : text.first(enough).trimmed() + u'…';
}

} // namespace

Field::Field(Kind kind, QWidget *parent)
    : Translated(parent)
    , m_kind(kind)
    , m_most(kind == Kind::longText ? mostOfText : mostOfLine)
    , m_height(fieldHeight)
    , m_label(made<ElidedLabel>(trait::secondary, this))
    , m_mark(new QLabel(this)) {
    QWidget *edit = nullptr;
    if (kind == Kind::choice) {
        edit = m_choice = new ElidedBox(this);
        m_choice->setFixedHeight(fieldHeight);
        m_choice->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        connect(m_choice, &QComboBox::activated, this, &Field::entered);
    } else if (kind == Kind::answer) {
        edit = m_answer = new AnswerBox(this);
        connect(m_answer, &QCheckBox::clicked, this, &Field::entered);
    } else if (kind == Kind::longText) {
        edit = m_lines = new QPlainTextEdit(this);
        m_lines->setFixedHeight(linesHeight);
        m_lines->setTabChangesFocus(true);
        m_lines->setUndoRedoEnabled(false); // undo is left to the window
        connect(m_lines, &QPlainTextEdit::textChanged, this, &Field::typed);
    } else {
        edit = m_line = new QLineEdit(this);
        m_line->setFixedHeight(fieldHeight);
        m_line->setMaxLength(std::numeric_limits<int>::max()); // never truncated silently
        m_line->setAlignment((kind == Kind::number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        connect(m_line, &QLineEdit::textEdited, this, &Field::typed);
        connect(m_line, &QLineEdit::returnPressed, this, &Field::finish);
    }
    edit->installEventFilter(this);
    m_unit = made<QLabel>(trait::secondary, m_answer ? this : edit);
    m_bar = new RequiredBar(edit);
    m_refusedMark = new RefusedMark(edit);
    m_refusedMark->hide();
    m_label->setFixedHeight(labelHeight);
    m_label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_mark->setFixedHeight(labelHeight);
    m_mark->setProperty("tone", QStringLiteral("unsure"));
    m_label->setBuddy(edit);
    m_unit->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_bar->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_refusedMark->setAttribute(Qt::WA_TransparentForMouseEvents);
    makeReason();
    if (m_answer) {
        m_label->hide();
        inRow(this, noMargins, labelGap, {{m_answer, 1}, m_mark, m_unit});
    } else {
        auto *head = inRow(styleSpacing, {{m_label, 1}, m_mark});
        inColumn(this, noMargins, labelGap, {head, edit, Placed::stretch()});
    }
    setFocusProxy(edit);
    retranslate();
}

void Field::makeReason() {
    m_reasonRow = new QWidget(this);
    m_reason = made<ElidedLabel>("refusal", m_reasonRow);
    m_reason->setProperty("tone", QStringLiteral("bad"));
    inRow(m_reasonRow, noMargins, 4, {new RefusedMark(m_reasonRow), {m_reason, 1}});
    m_reasonRow->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_reasonRow->setAutoFillBackground(true);
    m_reasonRow->hide();
}

Field::~Field() {
    delete m_reasonRow;
}

QWidget *Field::edit() const {
    return m_line     ? static_cast<QWidget *>(m_line)
           : m_lines  ? static_cast<QWidget *>(m_lines)
           : m_answer ? static_cast<QWidget *>(m_answer)
                      : m_choice;
}

QString Field::text() const {
    if (m_choice)
        return m_none && m_choice->currentIndex() <= 0 ? QString() : m_choice->currentText();
    if (m_answer)
        return m_words.value(choice());
    return m_line ? m_line->text() : m_lines->toPlainText();
}

int Field::choice() const {
    if (m_answer)
        return static_cast<int>(std::ranges::find(answers, m_answer->checkState()) - answers.begin());
    return m_choice ? m_choice->currentIndex() : -1;
}

QString Field::refusal() const {
    return isRefused() ? refusalText() : QString();
}

void Field::setLabel(const QString &label) {
    m_labelSource = label;
    retranslate();
}

void Field::setHeading(const QString &heading) {
    m_heading = heading;
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

void Field::setPlaceholder(const QString &text) {
    if (m_placeholder == text)
        return;
    m_placeholder = text;
    retranslate();
}

void Field::setReader(Reader reader) {
    m_reader = std::move(reader);
}

void Field::setChoices(const QStringList &words, bool none) {
    m_none = none;
    if (m_answer) {
        m_words = words;
        m_words.front().clear(); // states nothing
        return;
    }
    const int current = m_choice->currentIndex();
    m_choice->clear();
    m_choice->addItems(words);
    m_choice->setCurrentIndex(current);
}

Field::Reading Field::read(const QString &text) const {
    if (m_reader)
        return m_reader(text);
    if (const std::size_t length = lengthOf(text); length > m_most)
        return {{}, tr("%1 characters, where a test file holds no more than %2").arg(length).arg(m_most)};
    return {text, {}};
}

void Field::setText(const QString &text) {
    if (m_line) {
        m_line->setText(text);
        m_line->setCursorPosition(m_line->hasFocus() ? static_cast<int>(text.size()) : 0);
    } else if (m_lines && m_lines->toPlainText() != text) {
        const QSignalBlocker quiet(m_lines);
        m_lines->setPlainText(text);
    }
}

void Field::show(const QString &value, bool required) {
    bool kept = isRefused() ? value == m_shown : m_isTyped && read(text()).canonical == value;
    // The value of an emptied field is shown only on leaving it, as the user is about to type.
    if (!kept && m_isTyped && !m_choice && text().isEmpty()) {
        if (!m_ofNothing)
            m_ofNothing = value;
        kept = m_ofNothing == value;
    }
    if (!kept) {
        setText(value);
        m_refusal.clear();
        m_isTyped = false;
    }
    m_shown = value;
    m_required = required;
    retranslate();
}

void Field::setRequired(bool required) {
    if (m_required == required)
        return;
    m_required = required;
    retranslate();
}

void Field::setUsual(bool usual) {
    if (std::exchange(m_usual, usual) != usual)
        retranslate();
}

void Field::showChoice(int index, bool required) {
    if (m_answer)
        m_answer->setCheckState(answers.at(static_cast<std::size_t>(std::max(0, index))));
    else
        m_choice->setCurrentIndex(index);
    m_required = required;
    retranslate();
}

void Field::forget() {
    m_isTyped = false;
    m_ofNothing.reset();
    m_refusal.clear();
}

void Field::refuse(const QString &text) {
    const QString refusal = read(text).refusal;
    if (refusal.isEmpty())
        return;
    setText(text);
    m_isTyped = true;
    m_refusal = refusal;
    m_atFocus = m_shown;
    retranslate();
}

void Field::reread() {
    if (!isRefused())
        return;
    m_refusal = read(text()).refusal;
    retranslate();
}

void Field::setBare() {
    m_bare = true;
    m_label->hide();
    retranslate();
}

void Field::setDense() {
    m_height = denseHeight;
    edit()->setProperty("dense", true);
    if (!m_lines)
        edit()->setFixedHeight(m_answer ? m_answer->sizeHint().height() : m_height);
    layout()->setSpacing(m_answer ? labelGap : 0);
}

bool Field::isDense() const {
    return m_height == denseHeight;
}

void Field::hideLabel() {
    m_labelHidden = true;
    m_label->hide();
    retranslate();
}

void Field::typed() {
    m_isTyped = true;
    m_ofNothing.reset();
    const Reading reading = read(text());
    m_refusal = reading.refusal;
    if (isRefused())
        m_shown = m_atFocus;
    retranslate();
    emit entered();
}

/// On leaving the field, replaces a valid text by its canonical form.
void Field::finish() {
    if (m_line)
        m_line->setCursorPosition(0); // shows the beginning of a long text
    if (!m_isTyped || isRefused())
        return;
    const QString canonical = text().isEmpty() && m_ofNothing ? *m_ofNothing : read(text()).canonical;
    m_isTyped = false;
    m_ofNothing.reset();
    if (m_line && canonical != m_line->text())
        setText(canonical);
}

bool Field::undoRefused() {
    if (!isRefused())
        return false;
    restore();
    return true;
}

/// Esc: restores the text from when the field was focused.
void Field::restore() {
    setText(m_atFocus);
    typed();
    m_isTyped = false;
}

void Field::placeParts() {
    QWidget *shown = edit();
    if (m_answer) {
        m_bar->hide();
        m_mark->setText(m_required ? QStringLiteral("●") : m_usual ? QStringLiteral("○") : QString());
        m_mark->setToolTip(m_required ? tr("required") : tr("usual"));
        return;
    }
    const int height = m_lines ? linesHeight : m_height;
    const int unitWidth = m_unit->text().isEmpty() ? 0 : m_unit->sizeHint().width() + 6;
    if (m_line)
        m_line->setTextMargins(m_required ? barWidth : 0, 0, unitWidth, 0);
    m_unit->setGeometry(shown->width() - unitWidth - margin + 4, 0, unitWidth, height);
    m_bar->setGeometry(1, 1, barWidth, height - 2);
    m_bar->setVisible(m_required);
    // If label and word do not fit side by side, only the dot is shown; bar and placeholder say the same.
    const bool refused = isRefusedInHead();
    const QString dot = refused      ? QStringLiteral("⚠")
                        : m_required ? QStringLiteral("●")
                                     : QStringLiteral("○");
    const QString meaning = refused            ? m_reason->text()
                            : !m_required      ? tr("usual")
                            : text().isEmpty() ? tr("required")
                                               : tr("incomplete"); // a feed without its kind
    const QString mark = dot + u' ' + meaning;
    const int needed = m_label->fontMetrics().horizontalAdvance(m_label->text()) +
                       m_mark->fontMetrics().horizontalAdvance(mark) + margin;
    m_mark->setText(!m_required && !m_usual && !refused ? QString()
                    : needed > width() && width() > 0   ? dot
                                                        : mark);
    m_mark->setToolTip(meaning);
    m_unit->setVisible(unitWidth > 0);
    m_refusedMark->move(margin, (height - iconSize) / 2);
    m_refusedMark->setVisible(isRefused() && isDense() && m_labelHidden && !m_bare);
}

/// True if the label has the mark of the refusal: there is no gap below a dense field.
bool Field::isRefusedInHead() const {
    return isRefused() && isDense() && !m_labelHidden && !m_bare;
}

/// Places the reason in the gap below the field, so that unfinished typing moves nothing: as long as needed
/// while it is typed, later as long as the field. Below a dense field is a label instead of a gap, which it
/// covers only meanwhile.
void Field::placeReason() {
    if (!m_reasonRow)
        return;
    const bool isTyping = edit()->hasFocus();
    const bool isSaid = isRefusedInHead() && m_mark->text().endsWith(m_reason->text());
    if (!isRefused() || m_bare || !isVisible() || (isDense() && (!isTyping || isSaid))) {
        m_reasonRow->hide();
        return;
    }
    QSize size = m_reasonRow->layout()->sizeHint();
    if (isDense())
        size.setHeight(std::max(size.height(), headHeight - 1));
    else if (!isTyping)
        size.setWidth(std::min(size.width(), width()));
    const QPoint below = edit()->geometry().bottomLeft() + QPoint(0, 1);
    QWidget *around = parentWidget() ? parentWidget() : this;
    // The immediate parent may end with the field, as a table row does.
    while (!around->isWindow() && around->parentWidget() &&
           mapTo(around, below).y() + size.height() > around->height() &&
           !qobject_cast<QAbstractScrollArea *>(around->parentWidget()->parentWidget()))
        around = around->parentWidget();
    if (m_reasonRow->parentWidget() != around)
        m_reasonRow->setParent(around);
    const QPoint at = mapTo(around, below);
    const int width = std::min(size.width(), around->width());
    m_reasonRow->setGeometry(std::max(0, std::min(at.x(), around->width() - width)), at.y(), width,
                             size.height());
    m_reasonRow->show();
    m_reasonRow->raise();
}

/// Why the text is invalid, and which value is kept instead.
QString Field::refusalText() const {
    const QString now = read(text()).refusal; // in the language of now
    const QString reason = capitalised(now.isEmpty() ? m_refusal : now);
    if (m_shown.isEmpty())
        return tr("%1.").arg(reason);
    return tr("%1; %2 kept.").arg(reason, beginningOf(withUnit(m_shown, m_unit->text())));
}

/// Accessible description.
QString Field::description() const {
    if (isRefused())
        return m_reason->text();
    if (m_required)
        return text().isEmpty() ? tr("required, not stated") : tr("incomplete");
    if (m_usual)
        return tr("usual in practice, not stated");
    if (m_answer && !text().isEmpty())
        return text();
    if (!text().isEmpty())
        return m_unit->text();
    return m_placeholder.isEmpty() ? tr("not stated") : m_placeholder;
}

void Field::retranslate() {
    m_label->setFont(themeFont(TextSize::small));
    m_unit->setFont(themeFont(TextSize::small));
    m_mark->setFont(themeFont(TextSize::tiny));
    if (m_reasonRow)
        m_reason->setFont(themeFont(TextSize::tiny));
    const QString label = m_labelArgument.isEmpty() || m_labelSource.isEmpty()
                              ? m_labelSource
                              : m_labelSource.arg(m_labelArgument);
    m_label->setText(m_heading.isEmpty() ? label : m_heading);
    if (m_answer)
        m_answer->setText(
            QString(choice() == 2 ? tr("%1: no").arg(label) : label).replace(u'&', QStringLiteral("&&")));
    if (isRefused())
        m_reason->setText(refusalText());
    m_mark->setVisible((m_required || m_usual || isRefusedInHead()) && !m_bare && !m_labelHidden);
    setStyled(*m_mark, "refused", isRefusedInHead());
    const QString placeholder = !m_placeholder.isEmpty()                              ? m_placeholder
                                : m_kind == Kind::number && !m_unit->text().isEmpty() ? QStringLiteral("–")
                                                                                      : tr("not stated");
    if (m_line)
        m_line->setPlaceholderText(placeholder);
    if (m_lines)
        m_lines->setPlaceholderText(placeholder);
    QWidget *shown = edit();
    setStyled(*shown, "refused", isRefused());
    shown->setAccessibleName(label);
    shown->setAccessibleDescription(description());
    if (m_line || m_lines)
        shown->setToolTip(isRefused()                            ? m_reason->text()
                          : m_line && m_line->text().size() > 30 ? m_line->text().left(longestToolTip)
                                                                 : QString());
    placeParts();
    placeReason();
}

bool Field::eventFilter(QObject *watched, QEvent *event) {
    if (event->type() == QEvent::FocusIn) {
        m_atFocus = m_shown;
        placeReason();
        emit begun();
    } else if (event->type() == QEvent::FocusOut) {
        finish();
        placeReason();
    } else if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        // Undo and redo belong to the window, which has one stack.
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    } else if (event->type() == QEvent::KeyPress && !m_choice && !m_answer) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_Escape && (m_isTyped || isRefused())) {
            restore();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void Field::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    placeParts();
    placeReason();
}

void Field::moveEvent(QMoveEvent *event) {
    QWidget::moveEvent(event);
    placeReason();
}

void Field::showEvent(QShowEvent *event) {
    QWidget::showEvent(event);
    placeReason();
}

void Field::hideEvent(QHideEvent *event) {
    QWidget::hideEvent(event);
    placeReason();
}

} // namespace palmer::ui
