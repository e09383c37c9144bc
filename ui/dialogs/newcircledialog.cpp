// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/newcircledialog.h"

#include "kernel/evaluation/edition.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "ui/dialogs/statementsbox.h"
#include "ui/formrows.h"
#include "ui/madewidgets.h"
#include "ui/testname.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <utility>

namespace palmer::ui {

namespace {

constexpr double proposedRadius = 150;
constexpr int newCircleDialogWidth = 420;

} // namespace

NewCircleDialog::NewCircleDialog(Language language, const Test *like, QWidget *parent)
    : QDialog(parent)
    , m_language(std::move(language))
    , m_plane(made<QComboBox>("newPlane", this))
    , m_radius(made<QLineEdit>("newRadius", this))
    , m_feed(made<QLineEdit>("newFeed", this))
    , m_source(made<QComboBox>("newSource", this))
    , m_edition(made<QComboBox>("newCircleEdition", this))
    , m_statements(new StatementsBox(this))
    , m_problem(made<QLabel>("newCircleProblem", trait::reason, trait::wrapped, trait::plainText, this)) {
    setObjectName(QStringLiteral("newCircleDialog"));
    setWindowTitle(tr("New circular test"));
    for (const char *plane : {"XY", "YZ", "ZX", "YX", "ZY", "XZ"}) // right-handed first
        m_plane->addItem(QString::fromLatin1(plane).insert(1, QStringLiteral(" → ")),
                         QString::fromLatin1(plane));
    m_source->addItems({tr("external"), tr("feedback signal")});
    for (const Edition *edition : editionsOf(Kind::circular))
        m_edition->addItem(QString::fromUtf8(edition->word), QString::fromUtf8(edition->word));
    m_edition->setCurrentIndex(m_edition->findData(QString::fromUtf8(defaultEdition(Kind::circular).word)));
    m_radius->setText(m_language.number(proposedRadius, Quantity::position));
    m_feed->setPlaceholderText(tr("not stated"));
    const auto *circle = like ? std::get_if<CircularMeasurement>(&like->measurement) : nullptr;
    if (circle) {
        const QString plane = QString::fromStdString(circle->plane.first + circle->plane.second);
        m_plane->setCurrentIndex(std::max(0, m_plane->findData(plane)));
        m_edition->setCurrentIndex(std::max(0, m_edition->findData(QString::fromStdString(like->edition))));
        m_source->setCurrentIndex(static_cast<int>(circle->source));
        m_radius->setText(m_language.number(certain(circle->nominalRadius), Quantity::position));
        if (circle->feed)
            m_feed->setText(m_language.number(certain(*circle->feed), Quantity::feed));
    }

    auto *form = new QFormLayout;
    const auto addNumber = [&](const QString &text, QLineEdit *field, Quantity quantity) {
        field->setAlignment(Qt::AlignRight);
        auto *label = new QLabel(text, this);
        label->setBuddy(field);
        auto *unit = made<QLabel>(trait::secondary, m_language.unit(quantity), this);
        form->addRow(label, inRow(8, {field, unit}));
        connect(field, &QLineEdit::textChanged, this, &NewCircleDialog::check);
    };
    form->addRow(tr("&Plane"), m_plane);
    addNumber(tr("Nominal &radius"), m_radius, Quantity::position);
    addNumber(tr("Contouring &feed"), m_feed, Quantity::feed);
    form->addRow(tr("&Source of the signal"), m_source);
    form->addRow(tr("&Edition"), m_edition);
    alignLabels(*form);
    auto *note = made<QLabel>(trait::secondary, trait::wrapped,
                              tr("The arcs are typed or pasted afterwards, as tables."), this);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_create = buttons->addButton(tr("&Create"), QDialogButtonBox::AcceptRole);
    m_create->setObjectName(QStringLiteral("createCircle"));
    makePrimary(*m_create);
    inColumn(this, styleMargins, styleSpacing, {form, m_statements, m_problem, note, buttons});
    setMinimumWidth(newCircleDialogWidth);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    check();
}

void NewCircleDialog::check() {
    const NumberEntry radius = enteredNumber(m_radius->text(), Quantity::position, m_language.units());
    const NumberEntry feed = enteredNumber(m_feed->text(), Quantity::feed, m_language.units());
    QString problem;
    if (!radius.value || !(*radius.value > 0))
        problem = tr("The nominal radius is a number above 0.");
    else if (feed.refusal || (feed.value && !(*feed.value > 0)))
        problem = tr("The feed is a number above 0, or not stated.");
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_create->setEnabled(problem.isEmpty());
}

NewCircularTest NewCircleDialog::wanted() const {
    NewCircularTest result;
    const std::string plane = m_plane->currentData().toString().toStdString();
    result.plane = {plane.substr(0, 1), plane.substr(1)};
    result.nominalRadius =
        enteredNumber(m_radius->text(), Quantity::position, m_language.units()).value.value_or(0);
    result.feed = enteredNumber(m_feed->text(), Quantity::feed, m_language.units()).value;
    result.source = static_cast<SignalSource>(m_source->currentIndex());
    result.edition = m_edition->currentData().toString().toStdString();
    return result;
}

void NewCircleDialog::offerStatementsOf(const Test &test) {
    m_statements->offer(testName(test));
}

bool NewCircleDialog::takesStatements() const {
    return m_statements->isChecked();
}

} // namespace palmer::ui
