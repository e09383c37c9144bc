#include "ui/forms/agreedpointspage.h"

#include "document/bounds.h"
#include "document/edits.h"
#include "kernel/evaluation/agreedpoints.h"
#include "report/agreedtext.h"
#include "ui/elidedlabel.h"
#include "ui/model/documentmodel.h"
#include "ui/model/editname.h"
#include "ui/results/chip.h"
#include "ui/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

namespace palmer::ui {

namespace {

constexpr int pageMargin = 16;
constexpr int fieldHeight = 28;
constexpr int letterWidth = 26;

constexpr char context[] = "palmer::ui::AgreedPointsPage";

} // namespace

/// The text of an agreement. Undo and redo are the window's.
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
        setCursorPosition(0); // of a text longer than the field its beginning
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
    : QWidget(parent)
    , m_model(model)
    , m_chip(new Chip(this))
    , m_source(new QLabel(this))
    , m_scroll(new QScrollArea(this)) {
    setObjectName(QStringLiteral("agreedPointsPage"));
    m_chip->setObjectName(QStringLiteral("missingChip"));
    m_source->setProperty("secondary", true);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *content = new QWidget(m_scroll);
    content->setProperty("ground", QStringLiteral("base"));
    m_body = new QVBoxLayout(content);
    m_body->setContentsMargins(pageMargin, 4, pageMargin, pageMargin);
    m_body->setSpacing(4);
    m_scroll->setWidget(content);
    auto *bar = new QHBoxLayout;
    bar->setContentsMargins(pageMargin, 8, pageMargin, 4);
    bar->setSpacing(10);
    bar->addWidget(m_chip);
    bar->addWidget(m_source);
    bar->addStretch();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(m_scroll, 1);
    connect(&selection, &Selection::fieldChosen, this, [this, &selection](const QString &id) {
        if (selection.page() == Page::agreedPoints)
            focusField(id);
    });
}

void AgreedPointsPage::build(const Edition &edition) {
    if (m_built && m_built->points.data() == edition.points.data()) {
        m_built = &edition;
        return;
    }
    m_built = &edition;
    m_rows.clear();
    while (QLayoutItem *item = m_body->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (const AgreementPoint &point : edition.points) {
        auto *area = new QWidget(m_scroll->widget());
        Row row{&point,
                new Chip(area),
                new ElidedLabel(area),
                new QToolButton(area),
                new QToolButton(area),
                new QToolButton(area),
                new QToolButton(area),
                new AgreementEdit(area),
                new QPushButton(area),
                new QLabel(area)};
        row.name->setBuddy(row.text);
        row.text->begun = [this] { ++m_visit; };
        row.text->setProperty("helpTopic", QStringLiteral("agreedPoints"));
        row.text->setMaxLength(std::numeric_limits<int>::max()); // nothing is cut in silence
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
        connect(row.take, &QPushButton::clicked, this, [this, &point] { takeFromConditions(point); });
        row.text->setFixedHeight(fieldHeight);
        row.text->setObjectName(QStringLiteral("field.agreedPoints.") + QString::fromLatin1(point.point));
        const QString places[]{QStringLiteral("first"), QStringLiteral("middle"), QStringLiteral("middle"),
                               QStringLiteral("last")};
        QToolButton *buttons[]{row.agreed, row.notAgreed, row.notApplicable, row.notDeclared};
        constexpr std::optional<AgreementState> states[]{AgreementState::agreed, AgreementState::notAgreed,
                                                         AgreementState::notApplicable, std::nullopt};
        auto *head = new QHBoxLayout;
        head->setSpacing(8);
        head->addWidget(row.letter);
        head->addWidget(row.name, 1);
        head->addWidget(row.take);
        auto *body = new QHBoxLayout;
        body->setContentsMargins(letterWidth + 8, 0, 0, 0);
        body->setSpacing(0);
        body->addWidget(row.text, 1);
        body->addSpacing(8);
        for (std::size_t k = 0; k < std::size(buttons); ++k) {
            buttons[k]->setProperty("segment", places[k]);
            buttons[k]->setCheckable(true);
            buttons[k]->setFocusPolicy(Qt::StrongFocus);
            buttons[k]->setObjectName(QStringLiteral("state%1.").arg(k) + QString::fromLatin1(point.point));
            connect(buttons[k], &QToolButton::clicked, this,
                    [this, &point, state = states[k]] { setState(point, state); });
            body->addWidget(buttons[k]);
        }
        auto *layout = new QVBoxLayout(area);
        layout->setContentsMargins(0, 4, 0, 4);
        layout->setSpacing(4);
        layout->addLayout(head);
        layout->addLayout(body);
        layout->addWidget(row.refusal);
        m_body->addWidget(area);
        m_rows.push_back(row);
    }
    m_body->addStretch(1);
}

const AgreedPoint *AgreedPointsPage::agreed(const AgreementPoint &point) const {
    const Document &document = *m_model.document();
    if (m_test >= document.tests.size())
        return nullptr;
    const auto &points = document.tests[m_test]->agreedPoints;
    const auto found = std::ranges::find(points, point.point, &AgreedPoint::point);
    return found == points.end() ? nullptr : &*found;
}

/// A point that is not declared has no entry in the file: its text goes, too.
void AgreedPointsPage::setState(const AgreementPoint &point, std::optional<AgreementState> state) {
    const AgreedPoint *before = agreed(point);
    m_model.edit(QT_TRANSLATE_NOOP("edits", "change a point to agree"),
                 [&, text = before ? before->text : std::string()](Document &document) {
                     editTest(document, m_test,
                              [&](Test &test) { setAgreedPoint(test, point.point, state, text); });
                 });
    refresh(); // the button is checked as the document says, whatever was clicked
}

/// A text longer than a test file holds is refused with a sentence; the one before is kept.
bool AgreedPointsPage::refuses(const Row &row, const QString &text) const {
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

/// A text for what was not declared or not agreed is its agreement; taken away again, nothing is declared.
void AgreedPointsPage::setText(const AgreementPoint &point, const QString &text) {
    const AgreedPoint *before = agreed(point);
    std::optional<AgreementState> state = before ? std::optional(before->state) : std::nullopt;
    const bool wasEmpty = !before || before->text.empty();
    if (state.value_or(AgreementState::notAgreed) == AgreementState::notAgreed && wasEmpty && !text.isEmpty())
        state = AgreementState::agreed;
    else if (state == AgreementState::agreed && !wasEmpty && text.isEmpty() && !before->value)
        state.reset();
    m_model.edit(
        changeOf(context, QT_TRANSLATE_NOOP("palmer::ui::AgreedPointsPage", "Text of an agreement"))
            .constData(),
        [&](Document &document) {
            editTest(document, m_test,
                     [&](Test &test) { setAgreedPoint(test, point.point, state, text.toStdString()); });
        },
        QStringLiteral("agreedPoint/%1/%2/%3")
            .arg(QString::fromLatin1(point.point))
            .arg(m_test)
            .arg(m_visit));
}

void AgreedPointsPage::takeFromConditions(const AgreementPoint &point) {
    m_model.edit(QT_TRANSLATE_NOOP("edits", "take an agreement from the conditions"),
                 [&](Document &document) {
                     editTest(document, m_test, [&](Test &test) {
                         const QString text = agreedTextFromConditions(test, point.point, m_language);
                         setAgreedPoint(test, point.point, AgreementState::agreed, text.toStdString());
                         takeAgreedValue(test, point.point);
                     });
                 });
}

void AgreedPointsPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    if (m_test != test) {
        for (const Row &row : m_rows)
            row.refusal->hide();
    }
    m_test = test;
    refresh();
}

void AgreedPointsPage::setLanguage(const Language &language) {
    m_language = language;
    refresh();
}

void AgreedPointsPage::refresh() {
    const Edition *edition = m_test < m_evaluated.tests.size() ? m_evaluated.tests[m_test]->edition : nullptr;
    m_scroll->setVisible(edition != nullptr);
    m_chip->hide();
    m_source->clear();
    if (!edition)
        return;
    build(*edition);
    const Test &test = *m_evaluated.document->tests[m_test];
    int open = 0;
    for (const Row &row : m_rows) {
        const auto found = std::ranges::find(test.agreedPoints, row.point->point, &AgreedPoint::point);
        const std::optional<AgreementState> state =
            found == test.agreedPoints.end() ? std::nullopt : std::optional(found->state);
        const bool settled = state == AgreementState::agreed || state == AgreementState::notApplicable ||
                             roleOf(*row.point, test) == PointRole::notApplicable;
        open += settled ? 0 : 1;
        const QString letter = QString::fromUtf8(row.point->letter);
        row.letter->setContent(
            letter, letter.isEmpty() ? QString::fromLatin1(settled ? "check" : "miss") : QString(),
            settled ? Token::ok : Token::unsure, settled ? Token::okGround : Token::unsureGround);
        row.letter->setAccessibleName(settled ? tr("settled")
                                      : state ? tr("not agreed")
                                              : tr("not declared"));
        row.letter->setFixedWidth(letterWidth);
        row.name->setText(m_language.text(row.point->name));
        row.agreed->setText(tr("Agreed"));
        row.notAgreed->setText(tr("Not agreed"));
        row.notApplicable->setText(tr("Not applicable"));
        row.notDeclared->setText(tr("Not declared"));
        row.agreed->setChecked(state == AgreementState::agreed);
        row.notAgreed->setChecked(state == AgreementState::notAgreed);
        row.notApplicable->setChecked(state == AgreementState::notApplicable);
        row.notDeclared->setChecked(!state);
        const QString text =
            found == test.agreedPoints.end() ? QString() : QString::fromStdString(found->text);
        if (row.text->text() != text && row.refusal->isHidden()) {
            row.text->setText(text);
            row.text->setCursorPosition(0);
        }
        row.take->setText(tr("take from the conditions"));
        row.take->setFont(themeFont(TextSize::small));
        row.take->setVisible(text.isEmpty() && !settled &&
                             !agreedTextFromConditions(test, row.point->point, m_language).isEmpty());
        row.text->setPlaceholderText(tr("text of the agreement"));
        row.text->setAccessibleName(row.name->text());
        row.text->setAccessibleDescription(!state                               ? row.notDeclared->text()
                                           : state == AgreementState::agreed    ? row.agreed->text()
                                           : state == AgreementState::notAgreed ? row.notAgreed->text()
                                                                                : row.notApplicable->text());
    }
    const int all = static_cast<int>(m_rows.size());
    m_chip->setVisible(open > 0);
    m_chip->setContent(tr("%n of %1 points not agreed", nullptr, open).arg(all), QStringLiteral("warn"),
                       Token::unsure, Token::unsureGround);
    const QString word = QString::fromUtf8(edition->word);
    m_source->setText(*edition->pointsClause == 0
                          ? word
                          : tr("%1, clause %2").arg(word, QString::fromUtf8(edition->pointsClause)));
    m_source->setFont(themeFont(TextSize::small));
}

bool AgreedPointsPage::focusField(const QString &id) {
    for (const Row &row : m_rows) {
        if (id != QStringLiteral("agreedPoints.") + QString::fromLatin1(row.point->point))
            continue;
        m_scroll->ensureWidgetVisible(row.text);
        row.text->setFocus(Qt::OtherFocusReason);
        return true;
    }
    return false;
}

void AgreedPointsPage::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        refresh();
    QWidget::changeEvent(event);
}

} // namespace palmer::ui
