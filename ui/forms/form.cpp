#include "ui/forms/form.h"

#include "ui/results/chip.h"
#include "ui/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int pageMargin = 16;
constexpr int fieldGap = 12;
constexpr int sectionGap = 18;

} // namespace

Form::Form(const char *context, Page page, QWidget *parent)
    : QWidget(parent)
    , m_context(context)
    , m_page(page)
    , m_chip(new Chip(this))
    , m_scroll(new QScrollArea(this)) {
    m_chip->setObjectName(QStringLiteral("missingChip"));
    auto *content = new QWidget(m_scroll);
    content->setProperty("ground", QStringLiteral("base"));
    m_body = new QVBoxLayout(content);
    m_body->setContentsMargins(pageMargin, 8, pageMargin, pageMargin);
    m_body->setSpacing(fieldGap);
    m_scroll->setWidget(content);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto *bar = new QHBoxLayout;
    bar->setContentsMargins(pageMargin, 8, pageMargin, 4);
    bar->addWidget(m_chip);
    bar->addStretch();
    layout->addLayout(bar);
    layout->addWidget(m_scroll, 1);
}

void Form::addSection(const char *title) {
    if (!m_titles.empty())
        m_body->addSpacing(sectionGap - fieldGap);
    auto *label = new QLabel(m_scroll->widget());
    m_body->addWidget(label);
    m_titles.push_back({label, title});
}

void Form::beginRow() {
    m_row = new QGridLayout;
    m_row->setHorizontalSpacing(fieldGap);
    m_column = 0;
    m_body->addLayout(m_row);
}

Field *Form::add(Field::Kind kind, const char *key, const char *label, const QString &unit, Value value,
                 int weight) {
    auto *field = new Field(kind, m_scroll->widget());
    field->setUnit(unit);
    field->edit()->setObjectName(QStringLiteral("field.") + QString::fromLatin1(key) + u'.' +
                                 QString::number(m_entries.size()));
    m_row->addWidget(field, 0, m_column);
    m_row->setColumnStretch(m_column++, weight);
    m_entries.push_back({field, key, label, std::move(value)});
    return field;
}

Field *Form::addText(const char *key, const char *label, Value value, int weight) {
    return add(Field::Kind::text, key, label, {}, std::move(value), weight);
}

Field *Form::addNumber(const char *key, const char *label, const QString &unit, Value value, int weight) {
    return add(Field::Kind::number, key, label, unit, std::move(value), weight);
}

void Form::addStretch() {
    m_body->addStretch(1);
}

void Form::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    refresh();
}

void Form::setLanguage(const Language &language) {
    m_language = language;
    refresh();
}

bool Form::isMissingHere(const char *key) const {
    if (*key == 0 || m_test >= m_evaluated.tests.size())
        return false;
    const TestEvaluation &evaluation = *m_evaluated.tests[m_test];
    return std::ranges::any_of(evaluation.findings, [&](const Finding &finding) {
        return finding.id == key && finding.grade == Grade::requirement &&
               pageOf(finding, evaluation.edition) == m_page;
    });
}

void Form::clear() {
    m_entries.clear();
    m_titles.clear();
    m_row = nullptr;
    while (QLayoutItem *item = m_body->takeAt(0)) {
        if (QLayout *row = item->layout()) {
            while (QLayoutItem *part = row->takeAt(0)) {
                delete part->widget();
                delete part;
            }
        }
        delete item->widget();
        delete item;
    }
}

void Form::refresh() {
    prepare();
    for (const Title &title : m_titles) {
        title.shown->setText(QCoreApplication::translate(m_context, title.source));
        title.shown->setFont(themeFont(TextSize::head));
    }
    for (const Entry &entry : m_entries)
        entry.field->setLabel(QCoreApplication::translate(m_context, entry.label));
    if (!m_evaluated.document) {
        m_chip->hide();
        return;
    }
    const bool hasTest = m_test < m_evaluated.tests.size();
    const FormSource source{*m_evaluated.document,
                            hasTest ? m_evaluated.document->tests[m_test].get() : nullptr, m_language};
    for (const Entry &entry : m_entries) {
        const QString value = entry.value(source);
        entry.field->show(value, value.isEmpty() && isMissingHere(entry.key));
    }
    const int missing = hasTest ? countMissing(*m_evaluated.tests[m_test], m_page) : 0;
    m_chip->setVisible(missing > 0);
    if (missing > 0)
        m_chip->setContent(missingText(missing), QStringLiteral("warn"), Token::unsure, Token::unsureGround);
}

QString stated(const std::string &text) {
    return QString::fromStdString(text);
}

QString stated(const std::optional<double> &value, Quantity quantity, const Language &language) {
    return value ? language.number(*value, quantity, -1) : QString();
}

QString statedDate(const std::optional<std::string> &date, const Language &language) {
    return date && !date->empty() ? language.date(*date) : QString();
}

QString Form::missingText(int count) const {
    return tr("%n required statement(s) missing", nullptr, count);
}

bool Form::focusField(const QString &id) {
    const auto has = [&](const Entry &entry) { return id == QLatin1StringView(entry.key); };
    auto found = std::ranges::find_if(
        m_entries, [&](const Entry &entry) { return has(entry) && entry.field->isRequired(); });
    if (found == m_entries.end())
        found = std::ranges::find_if(m_entries, has);
    if (found == m_entries.end())
        return false;
    m_scroll->ensureWidgetVisible(found->field);
    found->field->edit()->setFocus(Qt::OtherFocusReason);
    return true;
}

void Form::follow(Selection &selection) {
    connect(&selection, &Selection::fieldChosen, this, [this, &selection](const QString &id) {
        if (selection.page() == m_page)
            focusField(id);
    });
}

void Form::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        refresh();
    QWidget::changeEvent(event);
}

} // namespace palmer::ui
