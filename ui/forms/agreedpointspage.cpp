#include "ui/forms/agreedpointspage.h"

#include "ui/elidedlabel.h"
#include "ui/results/chip.h"
#include "ui/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int pageMargin = 16;
constexpr int fieldHeight = 28;
constexpr int letterWidth = 26;

} // namespace

AgreedPointsPage::AgreedPointsPage(Selection &selection, QWidget *parent)
    : QWidget(parent)
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
    connect(&selection, &Selection::fieldChosen, this, [this](const QString &id) { focusField(id); });
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
                new QLineEdit(area)};
        row.name->setBuddy(row.text);
        row.text->setReadOnly(true);
        row.text->setFixedHeight(fieldHeight);
        row.text->setObjectName(QStringLiteral("field.agreedPoints.") + QString::fromLatin1(point.point));
        const QString places[]{QStringLiteral("first"), QStringLiteral("middle"), QStringLiteral("last")};
        QToolButton *buttons[]{row.agreed, row.notAgreed, row.notApplicable};
        auto *head = new QHBoxLayout;
        head->setSpacing(8);
        head->addWidget(row.letter);
        head->addWidget(row.name, 1);
        auto *body = new QHBoxLayout;
        body->setContentsMargins(letterWidth + 8, 0, 0, 0);
        body->setSpacing(0);
        body->addWidget(row.text, 1);
        body->addSpacing(8);
        for (std::size_t k = 0; k < 3; ++k) {
            buttons[k]->setProperty("segment", places[k]);
            buttons[k]->setCheckable(true);
            buttons[k]->setAttribute(Qt::WA_TransparentForMouseEvents); // shown here, changed nowhere yet
            buttons[k]->setFocusPolicy(Qt::NoFocus);
            body->addWidget(buttons[k]);
        }
        auto *layout = new QVBoxLayout(area);
        layout->setContentsMargins(0, 4, 0, 4);
        layout->setSpacing(4);
        layout->addLayout(head);
        layout->addLayout(body);
        m_body->addWidget(area);
        m_rows.push_back(row);
    }
    m_body->addStretch(1);
}

void AgreedPointsPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
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
        const AgreementState state =
            found == test.agreedPoints.end() ? AgreementState::notAgreed : found->state;
        const bool settled = state != AgreementState::notAgreed;
        open += settled ? 0 : 1;
        const QString letter = QString::fromUtf8(row.point->letter);
        row.letter->setContent(
            letter, letter.isEmpty() ? QString::fromLatin1(settled ? "check" : "miss") : QString(),
            settled ? Token::ok : Token::unsure, settled ? Token::okGround : Token::unsureGround);
        row.letter->setAccessibleName(settled ? tr("settled") : tr("not agreed"));
        row.letter->setFixedWidth(letterWidth);
        row.name->setText(m_language.text(row.point->name));
        row.agreed->setText(tr("Agreed"));
        row.notAgreed->setText(tr("Not agreed"));
        row.notApplicable->setText(tr("Not applicable"));
        row.agreed->setChecked(state == AgreementState::agreed);
        row.notAgreed->setChecked(state == AgreementState::notAgreed);
        row.notApplicable->setChecked(state == AgreementState::notApplicable);
        row.text->setText(found == test.agreedPoints.end() ? QString() : QString::fromStdString(found->text));
        row.text->setCursorPosition(0);
        row.text->setPlaceholderText(tr("text of the agreement"));
        row.text->setAccessibleName(row.name->text());
        row.text->setAccessibleDescription(state == AgreementState::agreed      ? row.agreed->text()
                                           : state == AgreementState::notAgreed ? row.notAgreed->text()
                                                                                : row.notApplicable->text());
    }
    const int all = static_cast<int>(m_rows.size());
    m_chip->setVisible(open > 0);
    m_chip->setContent(tr("%1 of %2 points not agreed").arg(open).arg(all), QStringLiteral("warn"),
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
