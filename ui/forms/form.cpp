// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/form.h"

#include "document/bounds.h"
#include "document/fields.h"
#include "document/fieldvalue.h"
#include "document/statedthings.h"
#include "language/decimals.h"
#include "language/withunit.h"
#include "report/words/findingtext.h"
#include "ui/chip.h"
#include "ui/forms/columnslayout.h"
#include "ui/forms/grouplayout.h"
#include "ui/forms/sectionhead.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/documentmodel.h"
#include "ui/model/editname.h"
#include "ui/theme.h"

#include <QAction>
#include <QCalendarWidget>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QShowEvent>
#include <QTimer>
#include <QWidgetAction>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int fieldGap = 12;
constexpr int groupGap = 8; ///< between the fields of a group
constexpr int rowGap = 4;   ///< between its rows
constexpr int sectionGap = 18;
constexpr int barHeight = 28;
constexpr int mostWidth = 720; ///< of the fields; wider ones are no easier to read

/// Removes a widget from the page at once, even from within one of its signals.
void dispose(QWidget *widget) {
    widget->hide();
    widget->setParent(nullptr);
    widget->deleteLater();
}

} // namespace

Form::Form(const char *context, Page page, DocumentModel &model, QWidget *parent)
    : Translated(parent)
    , m_context(context)
    , m_page(page)
    , m_model(model)
    , m_chip(made<LinkChip>("missingChip", this))
    , m_usual(made<LinkChip>("usualChip", this))
    , m_bar(new QHBoxLayout)
    , m_scroll(new QScrollArea(this)) {
    connect(m_chip, &LinkChip::clicked, this, &Form::nextWanted);
    connect(m_usual, &LinkChip::clicked, this, [this] {
        if (focusNext(true, &Field::isUsual))
            return;
        startOver(); // comes round
        focusNext(true, &Field::isUsual);
    });
    auto *content = new QWidget(m_scroll);
    content->setProperty("ground", QStringLiteral("base"));
    content->setMaximumWidth(mostWidth + 2 * pageMargin);
    m_scroll->viewport()->setBackgroundRole(QPalette::Base); // the fields do not fill the view
    m_body = inColumn(content, {pageMargin, 8, pageMargin, pageMargin}, fieldGap, {});
    m_scroll->setWidget(content);
    trait::scrollsDown(*m_scroll);
    m_bar->setContentsMargins(pageMargin, 8, pageMargin, 4);
    m_bar->setSpacing(8);
    m_bar->addStrut(barHeight); // keeps the fields in place when the chip disappears
    m_bar->addWidget(m_chip);
    m_bar->addWidget(m_usual);
    m_bar->addStretch();
    inColumn(this, noMargins, 0, {m_bar, {m_scroll, 1}});
}

void Form::addToBar(QWidget *widget) {
    m_bar->addWidget(widget);
}

QString Form::word(const char *source, const char *comment) const {
    return QCoreApplication::translate(m_context, source, comment);
}

QWidget *Form::body() const {
    const bool folds = !m_sections.empty() && m_sections.back().content;
    return folds ? m_sections.back().content : page();
}

void Form::addSection(const char *title, const QString &argument) {
    if (!m_sections.empty())
        m_body->addSpacing(sectionGap - fieldGap);
    auto *label = new QLabel(page());
    m_head = inRow(styleSpacing, {label, Placed::stretch()});
    m_body->addLayout(m_head);
    m_titles.push_back({label, title, argument});
    m_sections.push_back({nullptr, nullptr, title, {}, {}, m_entries.size()});
}

void Form::addFoldingSection(const char *title, std::function<QString()> summary) {
    if (!m_sections.empty())
        m_body->addSpacing(sectionGap - fieldGap);
    auto *head = made<SectionHead>(QStringLiteral("section.") + QString::fromLatin1(title), page());
    m_group = nullptr;
    m_head = inRow(styleSpacing, {{head, 1}});
    m_body->addLayout(m_head);
    m_sections.push_back({head, nullptr, title, std::move(summary), {}, m_entries.size()});
    connect(head, &QAbstractButton::clicked, this, [this, place = m_sections.size() - 1] {
        const Section &section = m_sections[place];
        fold(section, !section.head->isFolded());
        m_chosen[section.title] = section.head->isFolded();
        refreshSummaries();
    });
}

QPushButton *Form::addLink(const char *text, std::function<void()> pressed) {
    auto *button = made<QPushButton>(trait::link, trait::notDefault, body());
    connect(button, &QPushButton::clicked, this, [pressed = std::move(pressed)] { pressed(); });
    m_buttons.push_back({button, text});
    return button;
}

QPushButton *Form::addSectionButton(const char *text, std::function<void()> pressed) {
    QPushButton *button = addLink(text, std::move(pressed));
    addToSection(button);
    return button;
}

void Form::addToSection(QWidget *widget, int stretch) {
    m_head->addWidget(widget, stretch);
    m_sections.back().atHead.push_back(widget);
}

QPushButton *Form::addButton(const char *text, std::function<void()> pressed, int weight) {
    auto *button = made<QPushButton>(trait::notDefault, body());
    connect(button, &QPushButton::clicked, this, [pressed = std::move(pressed)] { pressed(); });
    const Qt::Alignment place = Qt::AlignLeft | Qt::AlignBottom;
    if (m_columns)
        m_columns->add(button, weight, place);
    else
        m_row->addWidget(button, 0, m_column++, place);
    m_buttons.push_back({button, text});
    return button;
}

void Form::addWidget(QWidget *widget, int weight) {
    if (m_group && (!m_columns || m_columns->taken() + weight > ColumnsLayout::columns))
        beginColumns();
    if (m_columns)
        m_columns->add(widget, weight);
    else
        m_row->addWidget(widget, 0, m_column);
    if (body()->isVisible())
        widget->show(); // the layout would do this only after the focus was set
    if (!m_columns)
        m_row->setColumnStretch(m_column++, weight);
}

void Form::beginGroup(const char *name) {
    auto *label = new QLabel(body());
    label->setWordWrap(true);
    m_titles.push_back({label, name, {}});
    const bool first = !m_group;
    if (first) {
        m_groups = inColumn(rowGap, {});
        m_groups->setContentsMargins(noMargins);
        addToPlace(m_groups);
    }
    m_group = new GroupLayout(label, rowGap, first);
    m_groups->addLayout(m_group);
    m_row = nullptr;
    m_columns = nullptr;
}

void Form::addToGroup(QLayout *row) {
    m_columns = nullptr;
    m_group->addRow(row);
}

void Form::beginRow() {
    m_row = new QGridLayout;
    m_row->setHorizontalSpacing(fieldGap);
    m_column = 0;
    m_columns = nullptr;
    addToPlace(m_row);
}

void Form::beginColumns() {
    m_columns = new ColumnsLayout(m_group ? groupGap : fieldGap);
    if (m_group)
        m_group->addRow(m_columns);
    else
        addToPlace(m_columns);
}

void Form::addToPlace(QLayout *row) {
    Section *section = m_sections.empty() ? nullptr : &m_sections.back();
    if (!section || !section->head) {
        m_body->addLayout(row);
        return;
    }
    if (!section->content) { // after all widgets in its head, for the tab order
        section->content = new QWidget(page());
        inColumn(section->content, noMargins, fieldGap, {});
        m_body->addWidget(section->content);
        if (page()->isVisible())
            section->content->show();
        const auto before = m_folded.find(section->title);
        fold(*section, before != m_folded.end() && before->second);
    }
    static_cast<QVBoxLayout *>(section->content->layout())->addLayout(row);
}

Form::Topic::Topic(const char *thing)
    : Topic(thing, statedThing(thing)->name.source) {}

Field *Form::add(Field::Kind kind, const Topic &topic, const QString &unit, int weight) {
    auto *field = new Field(kind, body());
    if (m_group)
        field->setDense();
    field->setUnit(unit);
    field->edit()->setObjectName(QStringLiteral("field.") + QString::fromLatin1(topic.key) + u'.' +
                                 QString::number(m_entries.size()));
    field->edit()->setProperty("helpTopic", QString::fromLatin1(topic.key));
    addWidget(field, weight);
    connect(field, &Field::begun, this, [this, place = m_entries.size()] {
        ++m_visit;
        m_place = place;
    });
    connect(field, &Field::entered, this, [this, field] { commit(field); });
    m_entries.push_back({field, topic.key, topic.label, {}, {}, false, {}, {}, {}});
    return field;
}

Field *Form::addText(const Topic &topic, Member<std::string> member, int weight, Field::Kind kind) {
    Field *field = add(kind, topic, {}, weight);
    last().value = [read = member.read](const FormSource &source) { return stated(read(source)); };
    last().change = [this, field, write = std::move(member.write)]() -> Change {
        return [write, test = m_test, text = field->valueText().toStdString()](Document &document) {
            write(document, test, text);
        };
    };
    return field;
}

Field *Form::addLongText(const Topic &topic, Member<std::string> member, int weight) {
    return addText(topic, std::move(member), weight, Field::Kind::longText);
}

QString Form::refusalOf(double value, Allowed allowed) const {
    struct Rule {
        Allowed allowed;
        bool (*holds)(double);
        const char *refusal;
    };
    constexpr auto isPositive = [](double number) { return number > 0; };
    constexpr auto isWhole = [](double number) {
        return std::trunc(number) == number && std::abs(number) <= 1e9;
    };
    static constexpr std::array rules{
        Rule{Allowed::positive, isPositive, QT_TR_NOOP("not greater than 0")},
        Rule{Allowed::counting, isPositive, QT_TR_NOOP("not greater than 0")},
        Rule{Allowed::notNegative, [](double number) { return number >= 0; },
             QT_TR_NOOP("a negative number")},
        Rule{Allowed::whole, isWhole, QT_TR_NOOP("not a whole number")},
        Rule{Allowed::counting, isWhole, QT_TR_NOOP("not a whole number")},
        Rule{Allowed::percentage, [](double number) { return number >= 0 && number <= 100; },
             QT_TR_NOOP("not between 0 and 100")},
    };
    for (const Rule &rule : rules) {
        if (rule.allowed == allowed && !rule.holds(value))
            return tr(rule.refusal);
    }
    const unsigned demands = allowed == Allowed::celsius       ? celsius
                             : allowed == Allowed::coefficient ? coefficient
                                                               : nothing;
    if (const auto beyond = beyondBounds(value, demands))
        return m_language.sentence(*beyond);
    const auto expected = expectedInstead(value, demands);
    return expected ? m_language.sentence(*expected, {}) : QString();
}

Field *Form::addNumber(const Topic &topic, Quantity quantity, Member<Amount> member, int weight,
                       Allowed allowed) {
    Field *field = add(Field::Kind::number, topic, m_language.unit(quantity), weight);
    last().quantity = quantity;
    const auto shown = [this, quantity, allowed](const Amount &value) {
        // Years and seeds are identifiers: no digit groups.
        const bool whole = allowed == Allowed::whole || allowed == Allowed::counting;
        return value && whole ? QString::number(*value, 'f', 0) : stated(value, quantity, m_language);
    };
    field->setReader([this, quantity, allowed, shown](const QString &typed) -> Field::Reading {
        const NumberEntry entry = enteredNumber(typed, quantity, m_language.units());
        if (entry.refusal)
            return {{}, m_language.text(*entry.refusal)};
        if (const QString refusal = entry.value ? refusalOf(*entry.value, allowed) : QString();
            !refusal.isEmpty())
            return {{}, refusal};
        return {shown(entry.value), {}};
    });
    last().value = [read = member.read, shown](const FormSource &source) { return shown(read(source)); };
    last().change = [this, field, quantity, write = std::move(member.write)]() -> Change {
        return [write, test = m_test,
                value = enteredNumber(field->valueText(), quantity, m_language.units()).value](
                   Document &document) { write(document, test, value); };
    };
    return field;
}

Field *Form::addInterval(const Topic &topic, Quantity quantity, Member<std::optional<Interval>> member,
                         int weight) {
    Field *field = add(Field::Kind::number, topic, m_language.unit(quantity), weight);
    last().quantity = quantity;
    const auto shown = [this, quantity](const std::optional<Interval> &interval) {
        return interval ? QStringLiteral("%1 … %2").arg(stated(interval->from, quantity, m_language),
                                                        stated(interval->to, quantity, m_language))
                        : QString();
    };
    field->setReader([this, quantity, shown](const QString &typed) -> Field::Reading {
        const IntervalEntry entry = enteredInterval(typed, quantity, m_language.units());
        return entry.refusal ? Field::Reading{{}, m_language.text(*entry.refusal)}
                             : Field::Reading{shown(entry.value), {}};
    });
    last().value = [read = member.read, shown](const FormSource &source) { return shown(read(source)); };
    last().change = [this, field, quantity, write = std::move(member.write)]() -> Change {
        return [write, test = m_test,
                value = enteredInterval(field->valueText(), quantity, m_language.units()).value](
                   Document &document) { write(document, test, value); };
    };
    return field;
}

Field *Form::addDate(const Topic &topic, Member<Moment> member, int weight) {
    Field *field = add(Field::Kind::text, topic, {}, weight);
    field->setReader([this](const QString &typed) -> Field::Reading {
        const MomentEntry entry = enteredDate(typed, m_language);
        return entry.refusal ? Field::Reading{{}, m_language.sentence(*entry.refusal)}
                             : Field::Reading{statedDate(entry.value, m_language), {}};
    });
    offerCalendar(*field);
    last().value = [read = member.read](const FormSource &source) {
        return statedDate(read(source), source.language);
    };
    last().change = [this, field, write = std::move(member.write)]() -> Change {
        return [write, test = m_test, value = enteredDate(field->valueText(), m_language).value](
                   Document &document) { write(document, test, value); };
    };
    return field;
}

/// A calendar, with today, at the end of a date; Alt+Down opens it.
void Form::offerCalendar(Field &field) {
    auto *line = qobject_cast<QLineEdit *>(field.edit());
    QAction *action = line->addAction(lineIcon(QStringLiteral("down")), QLineEdit::TrailingPosition);
    action->setObjectName(QStringLiteral("calendar"));
    action->setShortcut(QKeySequence(Qt::ALT | Qt::Key_Down));
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setText(tr("Calendar (Alt+Down)"));
    const auto take = [this, line](const QDate &date) {
        line->setText(m_language.date(date.toString(Qt::ISODate).toStdString()));
        emit line->textEdited(line->text());
    };
    connect(action, &QAction::triggered, line, [this, line, take] {
        auto *menu = new QMenu(line);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->setObjectName(QStringLiteral("calendarMenu"));
        connect(menu->addAction(tr("&Today")), &QAction::triggered, line,
                [take] { take(QDate::currentDate()); });
        auto *calendar = new QCalendarWidget(menu);
        const MomentEntry stated = enteredDate(line->text(), m_language);
        if (stated.value)
            calendar->setSelectedDate(QDate::fromString(QString::fromStdString(*stated.value), Qt::ISODate));
        calendar->setFirstDayOfWeek(Qt::Monday);
        connect(calendar, &QCalendarWidget::activated, menu, [menu, take](const QDate &date) {
            take(date);
            menu->close();
        });
        connect(calendar, &QCalendarWidget::clicked, menu, [menu, take](const QDate &date) {
            take(date);
            menu->close();
        });
        auto *place = new QWidgetAction(menu);
        place->setDefaultWidget(calendar);
        menu->addAction(place);
        menu->popup(line->mapToGlobal(line->rect().bottomLeft()));
    });
}

Field *Form::addTime(const Topic &topic, Member<Moment> member, int weight) {
    Field *field = add(Field::Kind::text, topic, {}, weight);
    field->setReader([this](const QString &typed) -> Field::Reading {
        const MomentEntry entry = enteredTime(typed);
        return entry.refusal ? Field::Reading{{}, m_language.sentence(*entry.refusal)}
                             : Field::Reading{stated(entry.value.value_or(std::string())), {}};
    });
    last().value = [read = member.read](const FormSource &source) {
        return stated(read(source).value_or(std::string()));
    };
    last().change = [this, field, write = std::move(member.write)]() -> Change {
        return [write, test = m_test, value = enteredTime(field->valueText()).value](Document &document) {
            write(document, test, value);
        };
    };
    return field;
}

Field *Form::addChoice(const Topic &topic, const std::vector<const char *> &words, Member<int> member,
                       bool none, int weight) {
    std::vector<Text> texts;
    texts.reserve(words.size());
    for (const char *word : words)
        texts.push_back({word, ""});
    return addChoiceOf(topic, std::move(texts), std::move(member), none, weight);
}

Field *Form::addWordsOf(const Topic &topic, Member<std::size_t> member, int weight) {
    const auto words = statedThing(topic.key)->form.words;
    std::vector<Text> texts(words.begin(), words.end());
    const bool none = texts.front().empty();
    if (none)
        texts.front() = {QT_TR_NOOP("not stated"), ""};
    return addChoiceOf(topic, std::move(texts),
                       converted<int, std::size_t>(
                           std::move(member),
                           [](const std::size_t &place) { return static_cast<int>(place); },
                           [](const int &index) { return static_cast<std::size_t>(index); }),
                       none, weight);
}

namespace {

template <class T>
Member<T> memberOfTest(const char *key) {
    return {[key](const FormSource &source) {
                const FieldValue value = source.test ? fieldValue(*source.test, key) : FieldValue();
                const T *own = std::get_if<T>(&value);
                return own ? *own : T();
            },
            [key](Document &document, std::size_t index, const T &value) {
                editTest(document, index, [&](Test &test) { setFieldValue(test, key, value); });
            }};
}

} // namespace

Field *Form::addThing(const Topic &topic, int weight) {
    const char *thing = topic.key;
    const FieldValue value = fieldValue(*shownTest(), thing);
    if (std::holds_alternative<std::string>(value))
        return addText(topic, memberOfTest<std::string>(thing), weight);
    if (std::holds_alternative<std::optional<bool>>(value))
        return addYesNo(topic, memberOfTest<std::optional<bool>>(thing), weight);
    if (std::holds_alternative<std::size_t>(value))
        return addWordsOf(topic, memberOfTest<std::size_t>(thing), weight);
    if (!std::holds_alternative<Amount>(value))
        return nullptr;
    const unsigned demands = fieldDemands(*shownTest(), thing);
    return addNumber(topic, quantityOf(*statedThing(thing), motionOf(*shownTest())),
                     memberOfTest<Amount>(thing), weight,
                     (demands & positive) != 0      ? Allowed::positive
                     : (demands & notNegative) != 0 ? Allowed::notNegative
                     : (demands & percentage) != 0  ? Allowed::percentage
                                                    : Allowed::any);
}

Field *Form::addChoiceOf(const Topic &topic, std::vector<Text> words, Member<int> member, bool none,
                         int weight, Field::Kind kind) {
    Field *field = add(kind, topic, {}, weight);
    last().words = std::move(words);
    last().none = none;
    last().choice = std::move(member.read);
    last().change = [this, field, write = std::move(member.write)]() -> Change {
        return [write, test = m_test, index = field->choice()](Document &document) {
            write(document, test, index);
        };
    };
    return field;
}

Field *Form::addYesNo(const Topic &topic, Member<std::optional<bool>> member, int weight, Field::Kind kind) {
    using Answer = std::optional<bool>;
    return addChoiceOf(
        topic, {{QT_TR_NOOP("not stated"), ""}, {QT_TR_NOOP("yes"), ""}, {QT_TR_NOOP("no"), ""}},
        choiceOf<Answer>(std::move(member), {Answer(), Answer(true), Answer(false)}), true, weight, kind);
}

Field *Form::addAnswer(const Topic &topic, int weight) {
    return addYesNo(topic, memberOfTest<std::optional<bool>>(topic.key), weight, Field::Kind::answer);
}

void Form::addStretch() {
    m_body->addStretch(1);
}

void Form::edit(const char *name, const std::function<void(Document &)> &change, const QString &mergeKey) {
    m_model.edit(name, change, mergeKey);
}

void Form::commit(const Field *field) {
    const auto entry =
        std::ranges::find_if(m_entries, [&](const Entry &candidate) { return candidate.field == field; });
    if (entry == m_entries.end() || !m_evaluated.document)
        return;
    // The edit refreshes the page, which may delete the field.
    const Change change = entry->change();
    const QByteArray name = changeOf(m_context, entry->label, field->labelArgument());
    QString key; // choices are separate steps; typing is merged
    if (!entry->choice)
        key = QStringLiteral("%1/%2/%3/%4")
                  .arg(objectName(), field->edit()->objectName())
                  .arg(m_test)
                  .arg(m_visit);
    edit(name.constData(), change, key);
}

void Form::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const bool another = test != m_test;
    m_evaluated = evaluated;
    m_test = test;
    if (another) {
        startOver();
        keepRefused();
        for (const Entry &entry : m_entries)
            entry.field->forget();
        m_chosen.clear();
        m_isFoldDue = true;
    }
    // Pages out of view cost nothing while the user types elsewhere.
    m_isStale = parentWidget() && !isVisibleTo(window());
    if (!m_isStale)
        refresh();
}

void Form::showEvent(QShowEvent *event) {
    m_isFoldDue = m_isFoldDue || !event->spontaneous();
    if (std::exchange(m_isStale, false))
        refresh();
    else
        foldComplete();
    QWidget::showEvent(event);
}

void Form::hideEvent(QHideEvent *event) {
    startOver();
    QWidget::hideEvent(event);
}

void Form::setLanguage(const Language &language) {
    m_language = language;
    for (const Entry &entry : m_entries) {
        if (entry.quantity)
            entry.field->setUnit(m_language.unit(*entry.quantity));
    }
    refresh();
}

const Test *Form::shownTest() const {
    return m_evaluated.document && m_test < m_evaluated.document->tests.size()
               ? m_evaluated.document->tests[m_test].get()
               : nullptr;
}

/// Marks a field of every finding of this page, the first empty one, so that there are as many marks as are
/// counted.
void Form::markWhatIsMissing(const std::vector<bool> &isEmpty) {
    std::vector<Lack> lacks(m_entries.size(), Lack::none);
    const auto &tests = m_evaluated.tests;
    for (const Finding &finding : m_test < tests.size() ? tests[m_test]->findings : std::vector<Finding>()) {
        if (lackOf(finding) == Lack::none || pageOf(finding, *m_evaluated.document) != m_page)
            continue;
        // A field has only the last part of its path; its page determines the object.
        const auto mark = [&](const std::string &path, bool ifEmpty) {
            const std::string key = path.substr(path.rfind('.') + 1);
            for (std::size_t i = 0; i < m_entries.size(); ++i) {
                if (isEmpty[i] != ifEmpty || lacks[i] != Lack::none || key != m_entries[i].key)
                    continue;
                lacks[i] = lackOf(finding);
                return true;
            }
            return false;
        };
        const auto any = [&](bool empty) {
            return std::ranges::any_of(finding.keys,
                                       [&](const std::string &path) { return mark(path, empty); });
        };
        if (!any(true)) // something is stated, but not all that is asked: a feed, not its kind
            static_cast<void>(any(false));
    }
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        m_entries[i].field->setRequired(lacks[i] == Lack::required);
        m_entries[i].field->setUsual(lacks[i] == Lack::usual);
    }
}

void Form::removeItems(QLayout &layout) {
    while (QLayoutItem *item = layout.takeAt(0)) {
        if (QLayout *inner = item->layout())
            removeItems(*inner);
        if (QWidget *widget = item->widget())
            dispose(widget);
        delete item;
    }
}

/// Keeps refused texts for when the fields come back.
void Form::keepRefused() {
    for (const Entry &entry : m_entries)
        m_refused.keep(m_of, *entry.field);
}

QStringList Form::refusedTexts() const {
    QStringList texts = m_refused.texts();
    for (const Entry &entry : m_entries) {
        if (entry.field->isRefused())
            texts << entry.field->text();
    }
    return texts;
}

void Form::clear() {
    keepRefused();
    const QWidget *focused = QWidget::focusWidget();
    m_focused =
        focused && page()->isAncestorOf(focused) && focused->hasFocus() ? focused->objectName() : QString();
    if (std::ranges::none_of(m_entries, [&](const Entry &entry) { return entry.field->edit() == focused; }))
        startOver(); // the fields are replaced
    for (const Section &section : m_sections) {
        if (section.head)
            m_folded[section.title] = section.head->isFolded();
    }
    m_entries.clear();
    m_titles.clear();
    m_buttons.clear();
    m_sections.clear();
    m_row = nullptr;
    m_columns = nullptr;
    m_group = nullptr;
    m_head = nullptr;
    m_isRebuilt = true;
    removeItems(*m_body);
}

void Form::refreshTexts() {
    m_chip->setToolTip(tr("Go to the next (F8)"));
    for (const Title &title : m_titles) {
        const QString text = word(title.source);
        title.shown->setText(title.argument.isEmpty() ? text : text.arg(title.argument));
        title.shown->setFont(themeFont(TextSize::head));
    }
    for (const Section &section : m_sections) {
        if (section.head)
            section.head->setTitle(word(section.title));
    }
    for (const Button &button : m_buttons)
        button.shown->setText(word(button.source));
    for (const Entry &entry : m_entries) {
        entry.field->setLabel(word(entry.label));
        if (entry.words.empty())
            continue;
        QStringList words;
        for (const Text &text : entry.words) {
            const QString own = word(text.source, text.comment);
            words << (own == QString::fromUtf8(text.source)
                          ? QCoreApplication::translate("palmer::ui::Form", text.source, text.comment)
                          : own);
        }
        entry.field->setChoices(words, entry.none);
    }
}

void Form::refresh() {
    prepare();
    refreshTexts();
    if (!m_evaluated.document) {
        m_chip->hide();
        m_usual->hide();
        return;
    }
    const FormSource source{*m_evaluated.document, shownTest(), m_language};
    std::vector<bool> isEmpty;
    for (const Entry &entry : m_entries) {
        if (entry.choice) {
            const int index = entry.choice(source);
            isEmpty.push_back(entry.none && index <= 0);
            entry.field->showChoice(index, isEmpty.back() && entry.field->isRequired());
        } else {
            const QString value = entry.value(source);
            isEmpty.push_back(value.isEmpty());
            entry.field->show(value, isEmpty.back() && entry.field->isRequired());
        }
    }
    markWhatIsMissing(isEmpty);
    m_of = source.test ? QString::fromStdString(source.test->id) : QString();
    for (const Entry &entry : m_entries)
        m_refused.giveBack(m_of, *entry.field);
    refreshOthers();
    foldComplete();
    refreshSummaries();
    if (std::exchange(m_isRebuilt, false))
        chainFields();
    if (!m_focused.isEmpty()) {
        if (auto *field = findChild<QWidget *>(std::exchange(m_focused, QString())))
            field->setFocus(Qt::OtherFocusReason);
    }
    const int missing = m_test < m_evaluated.tests.size() ? countMissing(m_evaluated, m_test, m_page) : 0;
    m_chip->setVisible(missing > 0);
    m_chip->setContent(missingText(missing), QStringLiteral("warn"), Token::unsure, Token::unsureGround);
    const auto usual = static_cast<int>(
        std::ranges::count_if(m_entries, [](const Entry &entry) { return entry.field->isUsual(); }));
    m_usual->setVisible(usual > 0);
    m_usual->setContent(usualText(usual), {}, Token::secondaryText, Token::hover);
}

std::vector<Form::Found> Form::found() {
    if (std::exchange(m_isStale, false))
        refresh();
    std::vector<Found> result;
    for (const Entry &entry : m_entries) {
        const QString text = entry.field->text().simplified();
        const QString unit =
            entry.quantity && !text.isEmpty() ? u' ' + m_language.unit(*entry.quantity) : QString();
        const QString name = entry.field->edit()->accessibleName();
        const bool isOfSensor = std::string_view(entry.key) == "sensors";
        result.push_back({isOfSensor ? tr("Temperature · %1").arg(name) : name, text + unit,
                          entry.field->isRequired(), entry.field});
    }
    return result;
}

std::span<const Form::Entry> Form::fieldsOf(const Section &section) const {
    const auto next = static_cast<std::size_t>(&section - m_sections.data()) + 1;
    const std::size_t end = next < m_sections.size() ? m_sections[next].begin : m_entries.size();
    return std::span(m_entries).subspan(section.begin, end - section.begin);
}

int Form::countMissingIn(const Section &section) const {
    return static_cast<int>(std::ranges::count_if(
        fieldsOf(section), [](const Entry &entry) { return entry.field->isRequired(); }));
}

/// True if something is stated and nothing required is missing.
bool Form::isComplete(const Section &section) const {
    const auto fields = fieldsOf(section);
    return countMissingIn(section) == 0 &&
           std::ranges::none_of(fields, [](const Entry &entry) { return entry.field->isRefused(); }) &&
           std::ranges::any_of(fields, [](const Entry &entry) { return !entry.field->text().isEmpty(); });
}

/// Values with units; yes/no answers with their question.
QString Form::valuesOf(const Section &section) const {
    QStringList values;
    for (const Entry &entry : fieldsOf(section)) {
        const QString text = entry.field->text().trimmed().replace(u'\n', u' '); // no-break spaces stay
        if (text.isEmpty())
            continue;
        const bool answers = entry.words.size() > 1 && std::string_view(entry.words[1].source) == "yes";
        const QString unit = entry.quantity ? m_language.unit(*entry.quantity) : QString();
        values << (answers ? tr("%1: %2").arg(word(entry.label), text) : withUnit(text, unit));
    }
    return values.join(QStringLiteral(" · "));
}

void Form::fold(const Section &section, bool folded) {
    section.head->setFolded(folded);
    if (section.content)
        section.content->setVisible(!folded);
    for (QWidget *widget : section.atHead)
        widget->setVisible(!folded);
}

/// Folds complete sections when the page comes into view or shows another test. In view, nothing moves while
/// the user works, and the focused section never folds.
void Form::foldComplete() {
    if (!m_isFoldDue || !isVisible() || m_test >= m_evaluated.tests.size() || m_evaluated.isPending(m_test))
        return;
    m_isFoldDue = false;
    const QWidget *focused = window()->focusWidget();
    for (const Section &section : m_sections) {
        if (!section.head || !section.content)
            continue;
        const auto chosen = m_chosen.find(section.title);
        const bool isHeld = focused && section.content->isAncestorOf(focused);
        fold(section, chosen != m_chosen.end() ? chosen->second : !isHeld && isComplete(section));
    }
    refreshSummaries();
}

void Form::unfoldAround(const QWidget &part) {
    for (const Section &section : m_sections) {
        if (!section.head || !section.head->isFolded() || !section.content->isAncestorOf(&part))
            continue;
        fold(section, false);
        m_chosen.erase(section.title);
    }
}

void Form::refreshSummaries() {
    for (const Section &section : m_sections) {
        if (!section.head || !section.head->isFolded())
            continue;
        const int missing = countMissingIn(section);
        const auto usual = static_cast<int>(std::ranges::count_if(
            fieldsOf(section), [](const Entry &entry) { return entry.field->isUsual(); }));
        section.head->setSummary(missing > 0       ? missingText(missing)
                                 : usual > 0       ? usualText(usual)
                                 : section.summary ? section.summary()
                                                   : valuesOf(section),
                                 missing > 0);
    }
}

QString stated(const std::string &text) {
    return QString::fromStdString(text);
}

QString stated(const std::optional<double> &value, Quantity quantity, const Language &language) {
    return value ? language.number(certain(*value), quantity) : QString();
}

QString statedDate(const std::optional<std::string> &date, const Language &language) {
    return date && !date->empty() ? language.date(*date) : QString();
}

QString Form::usualText(int count) {
    return tr("%1 usual").arg(count);
}

QString Form::missingText(int count) const {
    return missingStatements(count, language());
}

bool Form::focusField(const QString &id) {
    if (std::exchange(m_isStale, false))
        refresh();
    const auto has = [&](const Entry &entry) { return id == QLatin1StringView(entry.key); };
    auto found = std::ranges::find_if(
        m_entries, [&](const Entry &entry) { return has(entry) && entry.field->isRequired(); });
    if (found == m_entries.end())
        found = std::ranges::find_if(m_entries, has);
    if (found == m_entries.end())
        return false;
    focusPart(*found->field);
    return true;
}

void Form::chainAfter(QWidget *before) {
    setTabOrder(before, m_chip);
    chainFields();
}

/// Tab follows the bar, then the fields in their displayed order, whenever they were made.
void Form::chainFields() {
    QWidget *last = m_chip;
    const auto chain = [&last](QWidget *widget) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy() || widget == last)
            return;
        setTabOrder(last, widget);
        last = widget;
    };
    for (int i = 0; i < m_bar->count(); ++i) {
        if (QWidget *widget = m_bar->itemAt(i)->widget())
            chain(widget);
    }
    for (QWidget *widget : page()->findChildren<QWidget *>())
        chain(widget);
}

bool Form::focusLabel(const QByteArray &label, const QString &argument) {
    if (std::exchange(m_isStale, false))
        refresh();
    const auto found = std::ranges::find_if(m_entries, [&](const Entry &entry) {
        return label == entry.label && entry.field->labelArgument() == argument;
    });
    if (found == m_entries.end())
        return false;
    focusPart(*found->field);
    return true;
}

void Form::focusFirst() {
    if (m_entries.empty())
        return;
    if (!m_sections.empty() && m_sections.front().head && m_sections.front().head->isFolded()) {
        m_scroll->ensureWidgetVisible(m_sections.front().head);
        m_sections.front().head->setFocus(Qt::TabFocusReason);
        return;
    }
    Field &field = *m_entries.front().field;
    showPart(field);
    field.edit()->setFocus(Qt::TabFocusReason); // selects the content, to be replaced by typing
}

bool Form::focusNextRequired(bool forward) {
    return focusNext(forward, &Field::isRequired);
}

bool Form::focusNext(bool forward, bool (Field::*isMarked)() const) {
    const auto required = [isMarked](const Entry &entry) { return (entry.field->*isMarked)(); };
    const std::size_t size = m_entries.size();
    std::size_t found = size;
    if (forward) {
        const std::size_t from = m_place ? std::min(*m_place + 1, size) : 0;
        const auto next =
            std::find_if(m_entries.begin() + static_cast<std::ptrdiff_t>(from), m_entries.end(), required);
        found = static_cast<std::size_t>(next - m_entries.begin());
    } else {
        const std::size_t until = m_place ? std::min(*m_place, size) : size;
        for (std::size_t i = 0; i < until; ++i) {
            if (required(m_entries[i]))
                found = i;
        }
    }
    if (found == size)
        return false;
    m_place = found;
    focusPart(*m_entries[found].field);
    return true;
}

void Form::showPart(QWidget &part) {
    unfoldAround(part);
    m_scroll->ensureWidgetVisible(&part);
    // Repeated once a page just built has its layout.
    QTimer::singleShot(0, &part, [this, shown = &part] { m_scroll->ensureWidgetVisible(shown); });
}

void Form::focusPart(Field &field) {
    showPart(field);
    field.edit()->setFocus(Qt::OtherFocusReason);
}

void Form::follow(Selection &selection) {
    connect(&selection, &Selection::fieldChosen, this, [this, &selection](const QString &id) {
        if (selection.page() == m_page)
            focusField(id);
    });
}

} // namespace palmer::ui
