// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/testhead.h"

#include "kernel/evaluation/edition.h"
#include "kernel/measurement/testfacts.h"
#include "report/words/wording.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/testname.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

namespace palmer::ui {

namespace {

constexpr int usualHeight = 48;
constexpr int lowHeight = 30;

QString headText(const char *text) {
    return QCoreApplication::translate("palmer::ui::TestHead", text);
}

// Words specific to the kind of test.

QStringList ownWords(const PositioningMeasurement &measurement) {
    if (!measurement.cycle)
        return {headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "cycle not stated"))};
    return {measurement.cycle == Cycle::standard
                ? headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "standard cycle"))
                : headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "step cycle"))};
}

QStringList ownWords(const CircularMeasurement &measurement) {
    return {headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "Plane %1"))
                .arg(QString::fromStdString(measurement.plane.first + measurement.plane.second)),
            QStringLiteral("R ") + windowLanguage().quantity(measurement.nominalRadius, Quantity::position)};
}

QStringList ownWords(const DriftMeasurement & /*measurement*/) {
    return {headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "drift test"))};
}

} // namespace

QString testSummary(const Test &test) {
    const Language &language = windowLanguage();
    QStringList parts;
    const auto addAxis = [&](const Axis &axis) {
        const QString name = headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "Axis %1"))
                                 .arg(QString::fromStdString(axis.name));
        if (!axis.name.empty() && !test.title.empty() && name != testName(test)) // else the title names it
            parts += name;
        parts += axis.motion == Motion::linear
                     ? headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "linear"))
                     : headText(QT_TRANSLATE_NOOP("palmer::ui::TestHead", "rotary"));
        if (axis.travel)
            parts += language.quantity(*axis.travel, positionQuantity(axis));
    };
    if (const Axis *axis = axisOf(test))
        addAxis(*axis);
    parts += std::visit([](const auto &measurement) { return ownWords(measurement); }, test.measurement);
    if (test.date)
        parts += language.shortDate(*test.date);
    if (test.role != TestRole::notStated)
        parts += language.text(roleText(test.role));
    return parts.join(QStringLiteral(" · "));
}

TestHead::TestHead(QWidget *parent)
    : Translated(parent)
    , m_title(made<QLabel>("testTitle", TextSize::title, trait::plainText, this))
    , m_subtitle(made<QLabel>("testSummary", TextSize::small, trait::secondary, trait::plainText, this))
    , m_editionLabel(made<QLabel>(TextSize::small, trait::secondary, this))
    , m_set(made<QPushButton>("setEdition", trait::link, this))
    , m_edition(made<QComboBox>("edition", trait::strongFocus, this)) {
    setObjectName(QStringLiteral("testHead"));
    setFixedHeight(usualHeight);
    m_editionLabel->setBuddy(m_edition);
    m_edition->setFixedHeight(fieldHeight);
    m_edition->setMinimumWidth(136);
    m_edition->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_set->setFixedHeight(fieldHeight);
    for (QLabel *label : {m_title, m_subtitle}) {
        label->setMinimumWidth(0);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
    auto *texts = inColumn(0, {Placed::stretch(), m_title, m_subtitle, Placed::stretch()});
    inRow(this, {pageMargin, 0, pageMargin, 0}, 8, {{texts, 1}, m_editionLabel, m_set, m_edition});
    connect(m_edition, &QComboBox::activated, this,
            [this] { emit viewChosen(m_edition->currentData().toString()); });
    connect(m_set, &QPushButton::clicked, this,
            [this] { emit editionSet(m_edition->currentData().toString()); });
    retranslate();
}

void TestHead::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const Test &shown = *evaluated.document->tests[test];
    const TestEvaluation &evaluation = *evaluated.tests[test];
    m_titleText = testName(shown);
    m_subtitleText = testSummary(shown);
    const bool hasEdition = evaluation.edition;
    const bool view = hasEdition && evaluation.view;
    if (view)
        m_subtitleText = tr("View; test: %1").arg(QString::fromStdString(shown.edition));
    m_edition->setVisible(hasEdition);
    m_editionLabel->setVisible(hasEdition && !view);
    m_set->setVisible(view);
    if (hasEdition) {
        const QSignalBlocker blocker(m_edition);
        m_edition->clear();
        for (const Edition *edition : editionsOf(evaluation.edition->kind))
            m_edition->addItem(QString::fromUtf8(edition->word), QString::fromUtf8(edition->word));
        m_edition->setCurrentIndex(m_edition->findData(QString::fromUtf8(evaluation.edition->word)));
    }
    elide();
}

void TestHead::showTitle(const QString &title, const QString &subtitle) {
    m_titleText = title;
    m_subtitleText = subtitle;
    for (QWidget *widget : {static_cast<QWidget *>(m_edition), static_cast<QWidget *>(m_editionLabel),
                            static_cast<QWidget *>(m_set)})
        widget->hide();
    elide();
}

void TestHead::setLow(bool low) {
    m_subtitle->setVisible(!low);
    setFixedHeight(low ? lowHeight : usualHeight);
}

void TestHead::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    elide();
}

void TestHead::elide() {
    if (layout())
        layout()->activate();
    const auto put = [](QLabel *label, const QString &text) {
        label->setText(label->fontMetrics().elidedText(text, Qt::ElideRight, label->width()));
        label->setToolTip(label->text() == text ? QString() : text);
        label->setAccessibleName(text);
    };
    put(m_title, m_titleText);
    put(m_subtitle, m_subtitleText);
}

void TestHead::retranslate() {
    m_editionLabel->setText(tr("E&dition"));
    m_edition->setAccessibleName(tr("Edition the test is evaluated under"));
    m_edition->setToolTip(tr("Shows the results under another edition; the file stays as it is"));
    m_set->setText(tr("&Set as edition"));
    m_set->setAccessibleName(tr("Set as edition of the test"));
    m_set->setToolTip(tr("Writes this edition into the test; it can be undone"));
}

} // namespace palmer::ui
