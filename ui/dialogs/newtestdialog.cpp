// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/newtestdialog.h"

#include "document/documenterror.h"
#include "document/plannedtest.h"
#include "kernel/evaluation/edition.h"
#include "kernel/planning/cycleprogram.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "ui/dialogs/statementsbox.h"
#include "ui/errorbox.h"
#include "ui/formrows.h"
#include "ui/madewidgets.h"
#include "ui/pastebar.h"
#include "ui/tabletext.h"
#include "ui/testname.h"
#include "ui/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalBlocker>
#include <QTextCursor>
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace palmer::ui {

namespace {

constexpr double proposedTravel = 1000;
constexpr double proposedAngle = 360;
constexpr int decimals = 3; ///< of proposed targets
constexpr double resolution = 0.001;
constexpr int dialogWidth = 460;
constexpr int runsWidth = 64;
constexpr std::size_t fewestTargets = 2;
constexpr std::size_t mostReadings = 1'000'000; ///< of a new test
constexpr quint32 mostProposedSeed = 1'000'000; ///< short enough to read out

} // namespace

NewTestDialog::NewTestDialog(Language language, const Test *like, QWidget *parent)
    : QDialog(parent)
    , m_language(std::move(language))
    , m_seed(QRandomGenerator::global()->bounded(1U, mostProposedSeed))
    , m_name(made<QLineEdit>("newAxis", this))
    , m_motion(made<QComboBox>("newMotion", this))
    , m_travel(made<QLineEdit>("newTravel", this))
    , m_edition(made<QComboBox>("newEdition", this))
    , m_cycle(made<QComboBox>("newCycle", this))
    , m_runs(made<QLineEdit>("newRuns", this))
    , m_both(made<QCheckBox>("newBothDirections", this))
    , m_first(made<QLineEdit>("newFirst", this))
    , m_last(made<QLineEdit>("newLast", this))
    , m_count(made<QLineEdit>("newCount", this))
    , m_list(made<TableText>("newTargets", this))
    , m_read(new PasteBar(this))
    , m_statements(new StatementsBox(this))
    , m_why(made<QLabel>("newWhy", trait::secondary, trait::wrapped, trait::plainText, this))
    , m_problem(made<QLabel>("newProblem", trait::reason, trait::wrapped, trait::plainText, this)) {
    setObjectName(QStringLiteral("newTestDialog"));
    setWindowTitle(tr("New positioning test"));

    fillFields(like);
    makeForm();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_create = buttons->addButton(tr("&Create"), QDialogButtonBox::AcceptRole);
    m_create->setObjectName(QStringLiteral("createTest"));
    makePrimary(*m_create);
    inColumn(this, styleMargins, styleSpacing,
             {m_form, m_read, m_statements, Placed::stretch(1), buttons}); // rows keep their places
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connectFields();
    propose();
    resize(dialogWidth, sizeHint().height());
}

/// Fills the choices and the proposed values.
void NewTestDialog::fillFields(const Test *like) {
    m_motion->addItem(tr("linear"), static_cast<int>(Motion::linear));
    m_motion->addItem(tr("rotary"), static_cast<int>(Motion::rotary));
    for (const Edition *edition : editionsOf(Kind::positioning))
        m_edition->addItem(QString::fromUtf8(edition->word), QString::fromUtf8(edition->word));
    m_cycle->addItem(tr("not stated"));
    m_cycle->addItem(tr("standard cycle"), static_cast<int>(Cycle::standard));
    m_cycle->addItem(tr("step cycle"), static_cast<int>(Cycle::step));
    m_runs->setText(QStringLiteral("5"));
    m_both->setText(tr("from &both sides"));
    m_both->setChecked(true);
    m_runs->setFixedWidth(runsWidth);
    for (QLineEdit *field : {m_travel, m_first, m_last, m_runs, m_count})
        field->setAlignment(Qt::AlignRight);
    m_list->setMaximumHeight(110);
    m_list->setTabChangesFocus(true);
    m_edition->setCurrentIndex(
        m_edition->findData(QString::fromUtf8(defaultEdition(Kind::positioning).word)));
    if (like && !like->edition.empty() && m_edition->findData(QString::fromStdString(like->edition)) >= 0)
        m_edition->setCurrentIndex(m_edition->findData(QString::fromStdString(like->edition)));
    m_name->setText(QStringLiteral("X"));
    const auto *tested = like ? std::get_if<PositioningMeasurement>(&like->measurement) : nullptr;
    if (tested && (tested->axis.name == "X" || tested->axis.name == "Y")) // propose the next axis
        m_name->setText(QChar(char16_t(tested->axis.name[0] + 1)));
    m_name->selectAll();
    m_travel->setText(m_language.number(proposedTravel, Quantity::position));
}

void NewTestDialog::makeForm() {
    m_form = new QFormLayout;
    // The widget next to a field is not a field itself: the label belongs to the field.
    const auto addRow = [&](const QString &text, QWidget *field, QWidget *beside) {
        auto *label = new QLabel(text, this);
        label->setBuddy(field);
        auto *row = inRow(8, {{field, beside == m_both ? 0 : 1}, {beside, beside == m_both ? 1 : 0}});
        m_form->addRow(label, row);
    };
    for (QLabel *&unit : m_units) {
        unit = made<QLabel>(trait::secondary, this);
        unit->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("mm")));
    }
    m_form->addRow(tr("&Axis"), m_name);
    m_form->addRow(tr("&Motion"), m_motion);
    addRow(tr("&Travel"), m_travel, m_units[0]);
    m_form->addRow(tr("&Edition"), m_edition);
    m_form->addRow(tr("C&ycle"), m_cycle);
    addRow(tr("&Runs"), m_runs, m_both);
    addRow(tr("&First target"), m_first, m_units[1]);
    addRow(tr("&Last target"), m_last, m_units[2]);
    m_form->addRow(tr("&Number of targets"), m_count);
    addRow(tr("Target &positions"), m_list, m_units[3]);
    m_form->addRow(QString(), m_why);
    alignLabels(*m_form);
}

void NewTestDialog::connectFields() {
    connect(m_motion, &QComboBox::currentIndexChanged, this, [this] {
        const bool linear = axis().motion == Motion::linear;
        if (!m_name->isModified())
            m_name->setText(linear ? QStringLiteral("X") : QStringLiteral("C"));
        if (!m_travel->isModified())
            m_travel->setText(m_language.number(linear ? proposedTravel : proposedAngle,
                                                linear ? Quantity::position : Quantity::angle));
        propose();
    });
    connect(m_travel, &QLineEdit::textChanged, this, &NewTestDialog::propose);
    connect(m_edition, &QComboBox::currentIndexChanged, this, &NewTestDialog::propose);
    connect(m_name, &QLineEdit::textChanged, this, &NewTestDialog::check);
    connect(m_runs, &QLineEdit::textEdited, this, &NewTestDialog::check);
    for (QLineEdit *field : {m_first, m_last, m_count}) {
        connect(field, &QLineEdit::textEdited, this, [this] {
            m_listed = false;
            propose();
        });
    }
    connect(m_both, &QCheckBox::toggled, this, &NewTestDialog::check);
    connect(m_read, &PasteBar::answered, this, [this](const QString &key, const QString &word) {
        m_answers[key.toStdString()] = word.toStdString();
        check();
    });
    connect(m_list, &QPlainTextEdit::textChanged, this, [this] {
        m_answers.clear();
        m_listed = true;
        m_proposed = false;
        m_why->hide();
        check();
    });
}

Axis NewTestDialog::axis() const {
    Axis result;
    result.name = m_name->text().trimmed().toStdString();
    result.motion = static_cast<Motion>(m_motion->currentData().toInt());
    result.travel = number(m_travel);
    return result;
}

std::optional<double> NewTestDialog::number(const QLineEdit *field) const {
    const bool linear = static_cast<Motion>(m_motion->currentData().toInt()) == Motion::linear;
    return enteredNumber(field->text(), linear ? Quantity::position : Quantity::angle, m_language.units())
        .value;
}

std::optional<std::size_t> NewTestDialog::whole(const QLineEdit *field, std::size_t least,
                                                std::size_t most) const {
    const auto typed = enteredNumber(field->text(), Quantity::count, m_language.units()).value;
    if (!typed || std::trunc(*typed) != *typed || *typed < static_cast<double>(least) ||
        *typed > static_cast<double>(most))
        return std::nullopt;
    return static_cast<std::size_t>(*typed);
}

TargetRequest NewTestDialog::request() const {
    TargetRequest result;
    const Axis asked = axis();
    const Edition *edition = findEdition(m_edition->currentData().toString().toStdString());
    if (edition)
        result.rule = edition->targetRule;
    result.motion = asked.motion;
    result.from = number(m_first).value_or(0);
    result.travel = number(m_last).value_or(0) - result.from;
    result.axisTravel = asked.travel;
    result.decimals = decimals;
    result.seed = m_seed;
    return result;
}

/// Targets by the edition's rule, with the number chosen by the user if the rule allows it.
TargetPlan NewTestDialog::planned() const {
    TargetRequest asked = request();
    TargetPlan plan = planTargets(asked);
    const std::size_t wanted = whole(m_count, fewestTargets, mostTargets).value_or(0);
    if (!m_count->isModified() || plan.targets.size() == wanted)
        return plan;
    constexpr double metre = 1000;
    asked.axisTravel.reset();
    asked.perMetre = (static_cast<double>(wanted) - 0.5) * metre / asked.travel; // is rounded up
    plan = planTargets(asked);
    return plan.targets.size() == wanted ? plan : TargetPlan{};
}

/// Fills fields that were not edited; edited ones are never overwritten.
void NewTestDialog::propose() {
    const Axis asked = axis();
    const Quantity quantity = positionQuantity(asked);
    const double travel = asked.travel.value_or(0);
    for (QLabel *unit : m_units)
        unit->setText(m_language.unit(quantity));
    // Targets are approached from both sides, so the axis needs travel beyond the first and last.
    const double room = travel > 2 * CycleProgram().approach ? CycleProgram().approach : 0;
    if (!m_first->isModified())
        m_first->setText(m_language.number(certain(room), quantity));
    if (!m_last->isModified())
        m_last->setText(m_language.number(certain(travel - room), quantity));
    const TargetPlan plan = planned();
    if (!m_count->isModified() && !plan.targets.empty())
        m_count->setText(QString::number(plan.targets.size()));
    if (!m_runs->isModified() && !plan.targets.empty())
        m_runs->setText(QString::number(plan.runs));
    const auto count = whole(m_count, fewestTargets, mostTargets);
    m_why->setText(whyOf(plan));
    m_why->setVisible(!m_listed && !m_why->text().isEmpty());
    if (!m_listed && count) {
        std::vector<double> proposed = plan.targets;
        m_choice = {TargetChoiceKind::free, statedInterval(plan), std::nullopt,
                    static_cast<long long>(m_seed)};
        if (proposed.empty()) { // the rule does not give that number
            m_choice = {};
            const TargetRequest ends = request();
            proposed = evenTargets(ends.from, ends.from + ends.travel, *count, resolution);
        }
        QStringList positions;
        for (const double target : proposed)
            positions << m_language.number(certain(target), quantity);
        writeTargets(positions.join(QStringLiteral("; ")));
    }
    check();
}

/// Why a proposal does not end where it was asked to.
QString NewTestDialog::whyOf(const TargetPlan &plan) const {
    const auto last = number(m_last);
    if (plan.targets.empty() || !plan.interval || !last || plan.targets.back() == *last)
        return {};
    const Quantity quantity = positionQuantity(axis());
    return tr("The last target is %1, not %2: to every nominal position, each %3, a random part of up to ± "
              "%4 is "
              "added so that periodic errors show, and no target may lie beyond the ends.")
        .arg(m_language.quantity(plan.targets.back(), quantity), m_language.quantity(*last, quantity),
             m_language.quantity(*plan.interval, quantity, decimals),
             m_language.quantity(plan.randomPart, quantity, decimals));
}

/// Writes a proposal so that Ctrl+Z restores a typed list, whatever was proposed since.
void NewTestDialog::writeTargets(const QString &text) {
    const QSignalBlocker blocker(m_list);
    QTextCursor cursor(m_list->document());
    if (m_proposed)
        cursor.joinPreviousEditBlock();
    else
        cursor.beginEditBlock();
    cursor.select(QTextCursor::Document);
    cursor.insertText(text);
    cursor.endEditBlock();
    m_proposed = true;
}

std::optional<PastedTargets> NewTestDialog::readTargets(QString *problem) const {
    try {
        return targetsFrom(m_list->toPlainText().toStdString(), axis(), m_language.units(), m_answers);
    } catch (const Error &error) {
        if (problem)
            *problem = capitalised(m_language.sentence(error.message)) + u'.';
        return std::nullopt;
    }
}

std::optional<std::vector<double>> NewTestDialog::targets() const {
    const auto read = readTargets();
    return read ? std::optional(read->targets) : std::nullopt;
}

/// Shows how a pasted list was read.
void NewTestDialog::showRead() {
    const auto read = m_listed && m_list->document()->blockCount() > 1 ? readTargets() : std::nullopt;
    if (read)
        m_read->say(PasteBar::tr("%n target(s) read", nullptr, static_cast<int>(read->taken)),
                    {read->taken, read->units, {}, {}}, false);
    m_read->setVisible(read.has_value());
}

/// The first problem and its field.
NewTestDialog::Problem NewTestDialog::problem() const {
    const auto count = [this](std::size_t number) {
        return m_language.number(static_cast<double>(number), Quantity::count);
    };
    const auto first = number(m_first);
    const auto last = number(m_last);
    const auto runs = whole(m_runs, 1, mostRuns);
    QString refusal = tr("The target positions are numbers, parted by semicolons, blanks or lines.");
    const auto list = readTargets(&refusal);
    if (axis().name.empty())
        return {m_name, tr("The axis needs a name.")};
    if (!m_travel->text().trimmed().isEmpty() && !(axis().travel.value_or(0) > 0))
        return {m_travel, tr("The travel is a number above 0.")};
    if (!runs)
        return {m_runs,
                tr("The number of runs each way is a whole number from 1 to %1.").arg(count(mostRuns))};
    if (!m_listed && !first)
        return {m_first, tr("The first target is a number.")};
    if (!m_listed && !last)
        return {m_last, tr("The last target is a number.")};
    if (!m_listed && !(*first < *last))
        return {m_last, tr("The last target has to lie above the first.")};
    if (!m_listed && !whole(m_count, fewestTargets, mostTargets))
        return {m_count, tr("The number of targets is a whole number from %1 to %2.")
                             .arg(count(fewestTargets), count(mostTargets))};
    if (!list)
        return {m_list, refusal};
    const std::vector<double> &positions = list->targets;
    if (positions.size() < fewestTargets)
        return {m_list, tr("A test has two targets at least.")};
    if (std::ranges::adjacent_find(positions, std::greater_equal<>()) != positions.end())
        return {m_list, tr("The target positions have to ascend.")};
    if (positions.size() * *runs * (m_both->isChecked() ? 2 : 1) > mostReadings)
        return {m_runs,
                tr("A new test has %1 readings at most: fewer targets or runs.").arg(count(mostReadings))};
    return {};
}

/// A typed list says where it begins and ends, and how many targets it has.
void NewTestDialog::showListed() {
    const auto listed = m_listed ? targets() : std::nullopt;
    if (!listed || listed->empty())
        return;
    const Quantity quantity = positionQuantity(axis());
    m_first->setText(m_language.number(certain(listed->front()), quantity));
    m_last->setText(m_language.number(certain(listed->back()), quantity));
    m_count->setText(QString::number(listed->size()));
}

/// Shows the message below its field.
void NewTestDialog::check() {
    const Problem found = problem();
    showRead();
    showListed();
    for (QWidget *field :
         std::initializer_list<QWidget *>{m_name, m_travel, m_runs, m_first, m_last, m_count, m_list}) {
        const bool refused = field == found.field;
        field->setAccessibleDescription(refused ? found.sentence : QString());
        setStyled(*field, "refused", refused);
    }
    m_problem->setText(found.sentence);
    m_problem->setVisible(found.field);
    m_create->setEnabled(!found.field);
    if (!found.field || found.field == m_problemAt)
        return;
    m_problemAt = found.field;
    if (m_form->indexOf(m_problem) >= 0)
        delete m_form->takeRow(m_problem).fieldItem;
    for (int row = 0; row < m_form->rowCount(); ++row) {
        const QLayoutItem *label = m_form->itemAt(row, QFormLayout::LabelRole);
        const auto *words = label ? qobject_cast<const QLabel *>(label->widget()) : nullptr;
        if (words && words->buddy() == found.field) {
            m_form->insertRow(row + 1, m_problem);
            break;
        }
    }
}

NewPositioningTest NewTestDialog::wanted() const {
    NewPositioningTest result;
    result.axis = axis();
    result.edition = m_edition->currentData().toString().toStdString();
    if (const QVariant cycle = m_cycle->currentData(); cycle.isValid())
        result.cycle = static_cast<Cycle>(cycle.toInt());
    result.targets = targets().value_or(std::vector<double>());
    if (!m_listed)
        result.targetChoice = m_choice;
    result.runs = static_cast<int>(whole(m_runs, 1, mostRuns).value_or(1));
    result.bothDirections = m_both->isChecked();
    return result;
}

void NewTestDialog::offerStatementsOf(const Test &test) {
    m_statements->offer(testName(test));
}

bool NewTestDialog::takesStatements() const {
    return m_statements->isChecked();
}

} // namespace palmer::ui
