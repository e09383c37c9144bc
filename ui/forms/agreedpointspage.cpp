// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/agreedpointspage.h"

#include "document/bounds.h"
#include "document/edits.h"
#include "kernel/evaluation/agreedpoints.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "language/withunit.h"
#include "report/words/agreedtext.h"
#include "ui/chip.h"
#include "ui/errorbox.h"
#include "ui/forms/form.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/documentmodel.h"
#include "ui/model/editname.h"
#include "ui/theme.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <limits>

namespace palmer::ui {

namespace {

constexpr int letterWidth = 26;
constexpr int valueWidth = 132;
constexpr int headHeight = 30; ///< a row is 70 px high: its head, a field and the gaps

constexpr const char *agreedPointsContext = "palmer::ui::AgreedPointsPage";

/// Setting the number agreed for a point declares the point agreed.
void setAgreedValue(Test &test, const char *point, const std::optional<double> &value) {
    const AgreedPoint *before = agreedPoint(test, point);
    if (value || before)
        setAgreedPoint(test, point, value ? AgreementState::agreed : before->state,
                       before ? before->text : std::string());
    for (AgreedPoint &agreed : test.agreedPoints) {
        if (agreed.point == point)
            agreed.value = value;
    }
}

/// The quantity of a point's number in this test; null for points agreed only in words.
std::optional<Quantity> agreedQuantity(std::string_view point, const Test &test) {
    if (!isJudged(test) || !axisOf(test))
        return std::nullopt;
    if (point == "gradient")
        return Quantity::gradient;
    if (point == "feed")
        return feedQuantity(test);
    return std::nullopt;
}

} // namespace

/// Text of an agreement. Undo and redo are left to the window.
class AgreementEdit : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

    std::function<void()> begun;

protected:
    void focusInEvent(QFocusEvent *event) override {
        begun();
        QLineEdit::focusInEvent(event);
    }

    void focusOutEvent(QFocusEvent *event) override {
        QLineEdit::focusOutEvent(event);
        setCursorPosition(0); // shows the beginning of a long text
    }

    bool event(QEvent *event) override {
        if (event->type() == QEvent::ShortcutOverride) {
            const auto *key = static_cast<QKeyEvent *>(event);
            if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
                event->ignore();
                return false;
            }
        }
        return QLineEdit::event(event);
    }
};

AgreedPointsPage::AgreedPointsPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_chip(made<LinkChip>("missingChip", this))
    , m_source(made<QLabel>(trait::secondary, this))
    , m_scroll(new QScrollArea(this)) {
    setObjectName(QStringLiteral("agreedPointsPage"));
    trait::scrollsDown(*m_scroll);
    auto *content = new QWidget(m_scroll);
    content->setProperty("ground", QStringLiteral("base"));
    m_body = inColumn(content, {pageMargin, 4, pageMargin, pageMargin}, 4, {});
    m_scroll->setWidget(content);
    connect(m_chip, &LinkChip::clicked, this, &AgreedPointsPage::nextWanted);
    auto *bar = inRow(nullptr, {pageMargin, 8, pageMargin, 4}, 10, {m_chip, m_source, Placed::stretch()});
    inColumn(this, noMargins, 0, {bar, {m_scroll, 1}});
    connect(&selection, &Selection::fieldChosen, this, [this, &selection](const QString &id) {
        if (selection.page() == Page::agreedPoints)
            focusField(id);
    });
}

void AgreedPointsPage::build(const Edition &edition, const Test &test) {
    const bool rotary = motionOf(test) == Motion::rotary;
    if (m_built && m_built->points.data() == edition.points.data() && m_builtRotary == rotary) {
        m_built = &edition;
        return;
    }
    m_built = &edition;
    m_builtRotary = rotary;
    for (const Row &row : m_rows) {
        if (row.value)
            m_refused.keep(m_of, *row.value);
    }
    m_rows.clear();
    while (QLayoutItem *item = m_body->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const AgreementPoint &point : edition.points)
        addRow(point, test);
    m_others = made<QPushButton>("inapplicablePoints", trait::link, trait::notDefault, m_scroll->widget());
    connect(m_others, &QPushButton::clicked, this, [this] {
        m_showsAll = true;
        refresh();
    });
    m_body->addWidget(m_others, 0, Qt::AlignLeft);
    m_body->addStretch(1);
}

void AgreedPointsPage::addRow(const AgreementPoint &point, const Test &test) {
    auto *area = new QWidget(m_scroll->widget());
    Row row{&point,
            area,
            new Chip(area),
            new QLabel(area),
            new QToolButton(area),
            new QToolButton(area),
            new QToolButton(area),
            new QToolButton(area),
            new AgreementEdit(area),
            new QPushButton(area),
            new QLabel(area),
            nullptr};
    row.name->setBuddy(row.text);
    row.text->begun = [this] { ++m_visit; };
    row.text->setProperty("helpTopic", QStringLiteral("agreedPoints"));
    row.text->setMaxLength(std::numeric_limits<int>::max()); // never truncated silently
    row.refusal->setObjectName(QStringLiteral("refusal.") + QString::fromLatin1(point.point));
    row.refusal->setWordWrap(true);
    row.refusal->hide();
    connect(row.text, &QLineEdit::textEdited, this, [this, row, &point](const QString &text) {
        if (!refuses(row, text))
            setText(point, text);
    });
    row.take->setProperty("link", true);
    row.take->setAutoDefault(false);
    row.take->setIcon(lineIcon(QStringLiteral("link")));
    row.take->setObjectName(QStringLiteral("take.") + QString::fromLatin1(point.point));
    connect(row.take, &QPushButton::clicked, this, [this, &point] { copyFromConditions(point); });
    row.text->setFixedHeight(fieldHeight);
    row.text->setObjectName(QStringLiteral("field.agreedPoints.") + QString::fromLatin1(point.point));
    row.name->setWordWrap(true);
    row.name->setFixedHeight(headHeight);
    row.name->setAlignment(Qt::AlignVCenter);
    auto *head = inRow(8, {row.letter, {row.name, 1}, makeStates(row)});
    auto *text = inRow(nullptr, {letterWidth + 8, 0, 0, 0}, 8, {{row.text, 1}, row.take});
    if (const auto quantity = agreedQuantity(point.point, test)) {
        row.value = makeValue(point, *quantity, area);
        text->addWidget(row.value);
    }
    inColumn(area, {0, 2, 0, 2}, 4, {head, text, row.refusal});
    m_body->addWidget(area);
    m_rows.push_back(row);
}

/// Exclusive buttons for the states.
QHBoxLayout *AgreedPointsPage::makeStates(const Row &row) {
    const AgreementPoint &point = *row.point;
    const std::array places{QStringLiteral("first"), QStringLiteral("middle"), QStringLiteral("middle"),
                            QStringLiteral("last")};
    const std::array buttons{row.agreed, row.notAgreed, row.notApplicable, row.notDeclared};
    constexpr auto states = std::to_array<std::optional<AgreementState>>(
        {AgreementState::agreed, AgreementState::notAgreed, AgreementState::notApplicable, std::nullopt});
    auto *body = inRow(nullptr, noMargins, 0, {});
    for (std::size_t k = 0; k < std::size(buttons); ++k) {
        buttons[k]->setProperty("segment", places[k]);
        buttons[k]->setProperty("narrow", true);
        buttons[k]->setCheckable(true);
        buttons[k]->setFocusPolicy(Qt::StrongFocus);
        buttons[k]->setObjectName(QStringLiteral("state%1.").arg(k) + QString::fromLatin1(point.point));
        connect(buttons[k], &QToolButton::clicked, this,
                [this, &point, state = states[k]] { setState(point, state); });
        body->addWidget(buttons[k]);
    }
    return body;
}

Field *AgreedPointsPage::makeValue(const AgreementPoint &point, Quantity quantity, QWidget *parent) {
    auto *field = new Field(Field::Kind::number, parent);
    field->setBare();
    field->setFixedWidth(valueWidth);
    field->edit()->setObjectName(QStringLiteral("value.") + QString::fromLatin1(point.point));
    field->edit()->setProperty("helpTopic", QStringLiteral("agreedPoints"));
    field->setReader([this, quantity](const QString &typed) -> Field::Reading {
        const NumberEntry entry = enteredNumber(typed, quantity, m_language.units());
        if (entry.refusal)
            return {{}, m_language.text(*entry.refusal)};
        return {entry.value ? m_language.number(certain(*entry.value), quantity) : QString(), {}};
    });
    connect(field, &Field::begun, this, [this] { ++m_visit; });
    connect(field, &Field::entered, this, [this, field, quantity, name = point.point] {
        const auto value = enteredNumber(field->valueText(), quantity, m_language.units()).value;
        m_model.edit(
            changeOf(agreedPointsContext, QT_TR_NOOP("Number of an agreement")).constData(),
            [&](Document &document) {
                editTest(document, m_test, [&](Test &test) { setAgreedValue(test, name, value); });
            },
            QStringLiteral("agreedValue/%1/%2/%3").arg(QString::fromLatin1(name)).arg(m_test).arg(m_visit));
    });
    return field;
}

QStringList AgreedPointsPage::refusedTexts() const {
    QStringList texts = m_refused.texts();
    for (const Row &row : m_rows) {
        if (row.value && row.value->isRefused())
            texts << row.value->text();
    }
    return texts;
}

const AgreedPoint *AgreedPointsPage::agreed(const AgreementPoint &point) const {
    const Document &document = *m_model.document();
    if (m_test >= document.tests.size())
        return nullptr;
    const auto &points = document.tests[m_test]->agreedPoints;
    const auto found = std::ranges::find(points, point.point, &AgreedPoint::point);
    return found == points.end() ? nullptr : &*found;
}

/// A point that is not declared has no entry in the file, so its text is removed too.
void AgreedPointsPage::setState(const AgreementPoint &point, std::optional<AgreementState> state) {
    const AgreedPoint *before = agreed(point);
    m_model.edit(QT_TRANSLATE_NOOP("edits", "change a point to agree"),
                 [&, text = before ? before->text : std::string()](Document &document) {
                     editTest(document, m_test,
                              [&](Test &test) { setAgreedPoint(test, point.point, state, text); });
                 });
    refresh(); // sets the buttons to the document's state, whatever was clicked
}

/// Refuses a text longer than a test file allows, with a message; the former text is kept.
bool AgreedPointsPage::refuses(const Row &row, const QString &text) {
    const std::size_t length = lengthOf(text);
    const bool tooLong = length > mostOfText;
    row.refusal->setVisible(tooLong);
    if (tooLong) {
        row.refusal->setText(
            tr("%1 characters, where a test file holds no more than %2: the text before is kept.")
                .arg(length)
                .arg(mostOfText));
        row.refusal->setFont(themeFont(TextSize::small));
        QPalette palette = row.refusal->palette();
        palette.setColor(QPalette::WindowText, token(Token::bad, palette));
        row.refusal->setPalette(palette);
    }
    return tooLong;
}

/// Text for a point not declared or not agreed makes it agreed; removing the text makes it undeclared.
void AgreedPointsPage::setText(const AgreementPoint &point, const QString &text) {
    const AgreedPoint *before = agreed(point);
    std::optional<AgreementState> state = before ? std::optional(before->state) : std::nullopt;
    const bool wasEmpty = !before || before->text.empty();
    if (state.value_or(AgreementState::notAgreed) == AgreementState::notAgreed && wasEmpty && !text.isEmpty())
        state = AgreementState::agreed;
    else if (state == AgreementState::agreed && !wasEmpty && text.isEmpty() && !before->value)
        state.reset();
    m_model.edit(
        changeOf(agreedPointsContext, QT_TR_NOOP("Text of an agreement")).constData(),
        [&](Document &document) {
            editTest(document, m_test,
                     [&](Test &test) { setAgreedPoint(test, point.point, state, text.toStdString()); });
        },
        QStringLiteral("agreedPoint/%1/%2/%3")
            .arg(QString::fromLatin1(point.point))
            .arg(m_test)
            .arg(m_visit));
}

void AgreedPointsPage::copyFromConditions(const AgreementPoint &point) {
    m_model.edit(
        QT_TRANSLATE_NOOP("edits", "take an agreement from the conditions"), [&](Document &document) {
            editTest(document, m_test, [&](Test &test) {
                const QString text = agreedTextFromConditions(test, point.point, m_language);
                setAgreedPoint(test, point.point, AgreementState::agreed, text.toStdString());
                takeAgreedValue(test, point.point);
                // A number is printed in the language of each report, a text as it is.
                AgreedPoint &taken = *std::ranges::find(test.agreedPoints, point.point, &AgreedPoint::point);
                const auto quantity = agreedQuantity(point.point, test);
                if (taken.value && quantity && text == m_language.quantity(*taken.value, *quantity))
                    taken.text.clear();
            });
        });
}

void AgreedPointsPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    if (m_test != test) {
        for (const Row &row : m_rows) {
            row.refusal->hide();
            if (!row.value)
                continue;
            m_refused.keep(m_of, *row.value);
            row.value->forget();
        }
    }
    if (m_test != test)
        m_showsAll = false;
    m_test = test;
    refresh();
}

void AgreedPointsPage::setLanguage(const Language &language) {
    m_language = language;
    refresh();
}

/// `isCounted`: one that is not listed is asked for, and counted, with the conditions.
void AgreedPointsPage::refreshLetter(const Row &row, bool isCounted, bool settled, bool declared) {
    const QString letter = QString::fromUtf8(row.point->letter);
    row.letter->setContent(letter,
                           letter.isEmpty() ? QString::fromLatin1(settled ? "check" : "miss") : QString(),
                           settled     ? Token::ok
                           : isCounted ? Token::unsure
                                       : Token::secondaryText,
                           settled     ? Token::okGround
                           : isCounted ? Token::unsureGround
                                       : Token::hover);
    row.letter->setAccessibleName(settled ? tr("settled") : declared ? tr("not agreed") : tr("not declared"));
    row.letter->setFixedWidth(letterWidth);
}

/// `agreed`: the declaration of the point; null if there is none.
void AgreedPointsPage::refreshRow(const Row &row, const Test &test, const AgreedPoint *agreed, bool settled) {
    refreshLetter(row, roleOf(*row.point, test) == PointRole::listed, settled, agreed != nullptr);
    const QString name = capitalised(m_language.text(row.point->name));
    row.name->setText(name);
    row.name->setFont(themeFont(TextSize::small));
    for (QToolButton *button : {row.agreed, row.notAgreed, row.notApplicable, row.notDeclared})
        button->setFont(themeFont(TextSize::small));
    row.agreed->setText(tr("Agreed"));
    row.notAgreed->setText(tr("Not agreed"));
    row.notApplicable->setText(tr("Not applicable"));
    row.notDeclared->setText(tr("Not declared"));
    QToolButton *const chosen = !agreed                                      ? row.notDeclared
                                : agreed->state == AgreementState::agreed    ? row.agreed
                                : agreed->state == AgreementState::notAgreed ? row.notAgreed
                                                                             : row.notApplicable;
    for (QToolButton *button : {row.agreed, row.notAgreed, row.notApplicable, row.notDeclared}) {
        button->setAccessibleName(tr("%1: %2").arg(name, button->text()));
        button->setChecked(button == chosen);
    }
    const QString text = agreed ? QString::fromStdString(agreed->text) : QString();
    if (row.text->text() != text && row.refusal->isHidden()) {
        row.text->setText(text);
        row.text->setCursorPosition(0);
    }
    if (row.value) {
        const Quantity quantity = *agreedQuantity(row.point->point, test);
        row.value->setLabel(tr("%1: number").arg(name));
        row.value->setUnit(m_language.unit(quantity));
        row.value->show(stated(agreed ? agreed->value : std::nullopt, quantity, m_language), false);
    }
    row.take->setText(tr("take from the conditions"));
    row.take->setFont(themeFont(TextSize::small));
    row.take->setVisible(text.isEmpty() && !settled &&
                         !agreedTextFromConditions(test, row.point->point, m_language).isEmpty());
    row.text->setPlaceholderText(tr("text of the agreement"));
    row.text->setAccessibleName(name);
    row.text->setAccessibleDescription(chosen->text());
}

void AgreedPointsPage::refresh() {
    const Edition *edition = m_test < m_evaluated.tests.size() ? m_evaluated.tests[m_test]->edition : nullptr;
    m_scroll->setVisible(edition != nullptr);
    m_chip->hide();
    m_source->clear();
    if (!edition)
        return;
    const Test &test = *m_evaluated.document->tests[m_test];
    build(*edition, test);
    int others = 0; // inapplicable points, folded
    for (const Row &row : m_rows) {
        const AgreedPoint *agreed = agreedPoint(test, row.point->point);
        const bool applies = roleOf(*row.point, test) != PointRole::notApplicable;
        const bool settled = !applies || (agreed && agreed->state != AgreementState::notAgreed);
        const bool folded = !m_showsAll && !agreed && !applies;
        others += folded ? 1 : 0;
        row.area->setVisible(!folded);
        refreshRow(row, test, agreed, settled);
    }
    m_of = QString::fromStdString(test.id);
    for (const Row &row : m_rows) {
        if (row.value)
            m_refused.giveBack(m_of, *row.value);
    }
    m_others->setVisible(others > 0);
    m_others->setText(tr("%n point(s) that do not apply", nullptr, others));
    const int all = static_cast<int>(m_rows.size());
    const int open = countMissing(m_evaluated, m_test, Page::agreedPoints);
    m_chip->setVisible(open > 0);
    m_chip->setContent(tr("%n of %1 points to be agreed", nullptr, open).arg(all), QStringLiteral("warn"),
                       Token::unsure, Token::unsureGround);
    const QString word = QString::fromUtf8(edition->word);
    m_source->setText(*edition->pointsClause == 0
                          ? word
                          : tr("%1, clause %2").arg(word, QString::fromUtf8(edition->pointsClause)));
    m_source->setFont(themeFont(TextSize::small));
}

std::vector<AgreedPointsPage::Found> AgreedPointsPage::found() const {
    std::vector<Found> result;
    if (m_scroll->isHidden()) // there is no edition, nor a point
        return result;
    const Test &test = *m_evaluated.document->tests[m_test];
    for (const Row &row : m_rows) {
        const AgreedPoint *agreed = agreedPoint(test, row.point->point);
        const bool settled = agreed && agreed->state != AgreementState::notAgreed;
        QStringList said;
        if (row.value && agreed && agreed->value)
            said << withUnit(row.value->valueText(),
                             m_language.unit(*agreedQuantity(row.point->point, test)));
        if (const QString text = row.text->text().simplified(); !text.isEmpty())
            said << text;
        if (said.isEmpty())
            said << row.text->accessibleDescription(); // its state
        result.push_back({idOf(row), row.name->text(), said.join(QStringLiteral(" · ")),
                          !settled && roleOf(*row.point, test) == PointRole::listed});
    }
    return result;
}

/// The ID of the finding of its point.
QString AgreedPointsPage::idOf(const Row &row) {
    return QStringLiteral("agreedPoints.") + QString::fromLatin1(row.point->point);
}

bool AgreedPointsPage::focusField(const QString &id) {
    for (const Row &row : m_rows) {
        if (id != idOf(row))
            continue;
        if (row.area->isHidden()) {
            m_showsAll = true;
            refresh();
        }
        m_scroll->ensureWidgetVisible(row.text);
        row.text->setFocus(Qt::OtherFocusReason);
        return true;
    }
    return false;
}

} // namespace palmer::ui
