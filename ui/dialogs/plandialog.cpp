// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/plandialog.h"

#include "document/edits.h"
#include "document/savedocument.h"
#include "document/testfile.h"
#include "export/controls.h"
#include "kernel/evaluation/edition.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "print/pdf/pages.h"
#include "print/pdf/writepdf.h"
#include "report/planreport.h"
#include "ui/dialogs/cycleview.h"
#include "ui/dialogs/newtestdialog.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/background.h"
#include "ui/model/documentmodel.h"
#include "ui/saving.h"
#include "ui/sizeonscreen.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QBuffer>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>

namespace palmer::ui {

namespace {

constexpr int planFieldsWidth = 380;
constexpr double pointsPerInch = 72;
constexpr double mostDecimals = 9;
constexpr double mostSeed = 999'999'999;

bool hasReadings(const PositioningMeasurement &measurement) {
    return std::ranges::any_of(measurement.runs,
                               [](const Run &run) {
                                   return std::ranges::any_of(run.deviations, [](const auto &reading) {
                                       return reading.has_value();
                                   });
                               }) ||
           !measurement.excluded.empty();
}

using Setter = std::function<QString(const std::optional<double> &)>;

Setter needed(double &number, bool positive) {
    return [&number, positive](const std::optional<double> &value) {
        if (!value)
            return PlanDialog::tr("a number is needed");
        if (positive && !(*value > 0))
            return PlanDialog::tr("not greater than 0");
        number = *value;
        return QString();
    };
}

Setter positiveOrNone(std::optional<double> &number) {
    return [&number](const std::optional<double> &value) {
        if (value && !(*value > 0))
            return PlanDialog::tr("not greater than 0");
        number = value;
        return QString();
    };
}

Setter wholeNumber(double least, double most, const std::function<void(double)> &take) {
    return [least, most, take](const std::optional<double> &value) {
        if (!value)
            return PlanDialog::tr("a number is needed");
        if (*value < least || *value > most)
            return PlanDialog::tr("not from %1 to %2")
                .arg(windowLanguage().number(least, Quantity::count),
                     windowLanguage().number(most, Quantity::count));
        take(*value);
        return QString();
    };
}

} // namespace

PlanDialog::PlanDialog(DocumentModel &model, std::size_t test, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_test(test)
    , m_edition(defaultEdition(Kind::positioning).word)
    , m_view(new CycleView(this))
    , m_summary(made<QLabel>("planSummary", trait::wrapped, this))
    , m_overtravel(made<QLabel>("planOvertravel", trait::reason, trait::wrapped, trait::plainText, this))
    , m_targets(made<QLabel>("planTargets", trait::wrapped, this))
    , m_anew(made<QPushButton>("planAnew", trait::notDefault, this))
    , m_reseed(made<QPushButton>("reseed", trait::notDefault, this))
    , m_fill(made<QPushButton>("fillTest", trait::notDefault, this))
    , m_make(made<QPushButton>("makeTest", trait::primary, trait::notDefault, this))
    , m_print(made<QPushButton>("printPlan", trait::notDefault, this))
    , m_savePlan(made<QPushButton>("savePlan", trait::notDefault, this))
    , m_dialect(made<QComboBox>("dialect", this))
    , m_programReason(made<QLabel>("programReason", trait::reason, trait::wrapped, trait::plainText, this))
    , m_saveProgram(made<QPushButton>("saveProgram", trait::notDefault, this))
    , m_close(made<QPushButton>("closePlan", trait::notDefault, this)) {
    setObjectName(QStringLiteral("planDialog"));
    resize(sizeOnScreen(*this, {980, 680}));
    m_request.travel = 1000;
    begin(test);

    auto *fields = makeFields();
    m_targets->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto *right = inColumn(styleSpacing, {{m_view, 1}, m_summary, m_overtravel, m_targets});
    auto *place = new QScrollArea(this); // on low screens the fields are higher than the dialog
    trait::scrollsDown(*place);
    place->setWidget(fields);
    place->setFixedWidth(planFieldsWidth + place->verticalScrollBar()->sizeHint().width());
    auto *body = inRow(16, {place, {right, 1}});

    auto *program = makeButtons();
    // A separate row, as both do not fit in one on small screens.
    auto *decision = inRow(styleSpacing, {m_anew, Placed::stretch(), m_fill, m_make, m_close});
    inColumn(this, {pageMargin, pageMargin, pageMargin, pageMargin}, 16,
             {{body, 1}, m_programReason, program, decision});
    connect(m_dialect, &QComboBox::currentIndexChanged, this, &PlanDialog::showWhyNoProgram);
    connect(m_saveProgram, &QPushButton::clicked, this, &PlanDialog::chooseProgramFile);
    connect(m_print, &QPushButton::clicked, this, &PlanDialog::choosePrinter);
    connect(m_savePlan, &QPushButton::clicked, this, &PlanDialog::choosePlanFile);
    connect(m_anew, &QPushButton::clicked, this, &PlanDialog::planAnew);
    connect(m_fill, &QPushButton::clicked, this, &PlanDialog::fillTest);
    connect(m_make, &QPushButton::clicked, this, &PlanDialog::makeTest);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    retranslate();
}

/// The choice fields.
void PlanDialog::makeChoices(QWidget *parent) {
    const auto made = [&](Field::Kind kind, const char *name, const std::function<void()> &take) {
        auto *field = new Field(kind, parent);
        field->edit()->setObjectName(QStringLiteral("plan.") + QLatin1StringView(name));
        connect(field, &Field::entered, this, [this, take] {
            take();
            replan();
        });
        return field;
    };
    m_axis =
        made(Field::Kind::text, "axis", [this] { m_program.axis = m_axis->text().trimmed().toStdString(); });
    m_motion = made(Field::Kind::choice, "motion", [this] {
        m_request.motion = m_motion->choice() == 0 ? Motion::linear : Motion::rotary;
        m_request.axisTravel.reset(); // it was in the other unit
        m_request.axisRange.reset();
        m_request.zone.reset();
    });
    m_rule = made(Field::Kind::choice, "rule", [this] {
        m_request.rule = m_rule->choice() == 0 ? TargetRule::nominalInterval : TargetRule::pitches1988;
    });
    m_cycle = made(Field::Kind::choice, "cycle",
                   [this] { m_program.cycle = m_cycle->choice() == 0 ? Cycle::standard : Cycle::step; });
}

/// The button that draws new random parts, in the row of the field next to it.
QWidget *PlanDialog::makeReseed(QWidget *parent) {
    connect(m_reseed, &QPushButton::clicked, this, [this] {
        ++m_request.seed;
        replan();
    });
    auto *place = new QWidget(parent);
    inColumn(place, noMargins, styleSpacing, {Placed::stretch(), m_reseed});
    return place;
}

QWidget *PlanDialog::makeFields() {
    auto *fields = new QWidget(this);
    fields->setFixedWidth(planFieldsWidth);
    auto *grid = new QGridLayout(fields);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(8);
    int row = 0;
    const auto place = [&](QWidget *left, QWidget *right) {
        grid->addWidget(left, row, 0);
        if (right)
            grid->addWidget(right, row, 1);
        ++row;
    };
    makeChoices(fields);
    place(m_axis, m_motion);
    const auto position = [this] {
        return m_request.motion == Motion::linear ? Quantity::position : Quantity::angle;
    };
    place(addNumber(
              "from", QT_TR_NOOP("Travel begins at"), false, position, [this] { return m_request.from; },
              needed(m_request.from, false)),
          addNumber(
              "travel", QT_TR_NOOP("Measurement travel"), false, position,
              [this] { return m_request.travel; }, needed(m_request.travel, true)));
    m_perMetre = addNumber(
        "perMetre", QT_TR_NOOP("Targets per metre"), false, [] { return Quantity::number; },
        [this] { return m_request.perMetre; }, needed(m_request.perMetre, true));
    place(m_perMetre, addNumber(
                          "period", QT_TR_NOOP("Period of the error"), false, position,
                          [this] { return m_request.period; }, positiveOrNone(m_request.period)));
    place(m_rule,
          addNumber(
              "decimals", QT_TR_NOOP("Decimals"), true, [] { return Quantity::count; },
              [this] { return m_request.decimals; }, wholeNumber(0, mostDecimals, [this](double decimals) {
                  m_request.decimals = static_cast<int>(decimals);
              })));
    place(addNumber(
              "seed", QT_TR_NOOP("Seed"), true, [] { return Quantity::count; },
              [this] { return static_cast<double>(m_request.seed); },
              wholeNumber(0, mostSeed,
                          [this](double seed) { m_request.seed = static_cast<std::uint64_t>(seed); })),
          makeReseed(fields));
    const Setter take = wholeNumber(1, mostRuns, [this](double runs) { m_runs = static_cast<int>(runs); });
    place(m_cycle, addNumber(
                       "runs", QT_TR_NOOP("Runs each way"), true, [] { return Quantity::count; },
                       [this] { return m_program.runs; },
                       [this, take](const std::optional<double> &value) {
                           if (value)
                               return take(value);
                           m_runs.reset();
                           return QString();
                       }));
    place(addNumber(
              "feed", QT_TR_NOOP("Feed rate (empty: rapid)"), false,
              [this] { return m_request.motion == Motion::linear ? Quantity::feed : Quantity::angularFeed; },
              [this] { return m_program.feed; }, positiveOrNone(m_program.feed)),
          addNumber(
              "dwell", QT_TR_NOOP("Dwell at target"), false, [] { return Quantity::time; },
              [this] { return m_program.dwell; }, needed(m_program.dwell, true)));
    place(addNumber(
              "approach", QT_TR_NOOP("Approach distance"), false, position,
              [this] { return m_program.approach; }, needed(m_program.approach, true)),
          nullptr);
    grid->setRowStretch(row, 1);
    return fields;
}

/// Buttons for program, print and test.
QHBoxLayout *PlanDialog::makeButtons() {
    const auto ofControl = formatsOfControl(m_model.document()->machine.controller).program;
    for (const DialectName &each : dialects()) {
        m_dialect->addItem(QString::fromUtf8(each.name));
        if (each.dialect == ofControl)
            m_dialect->setCurrentIndex(m_dialect->count() - 1);
    }
    m_saveProgram->setIcon(lineIcon(QStringLiteral("save")));
    m_print->setIcon(lineIcon(QStringLiteral("print")));
    m_savePlan->setIcon(lineIcon(QStringLiteral("pdf")));
    return inRow(styleSpacing,
                 {m_dialect, m_saveProgram, Placed::gap(12), m_print, m_savePlan, Placed::stretch()});
}

Field *PlanDialog::addNumber(const char *name, const char *label, bool whole,
                             std::function<Quantity()> quantity, std::function<std::optional<double>()> get,
                             const std::function<QString(const std::optional<double> &)> &set) {
    auto *field = new Field(Field::Kind::number, this);
    field->edit()->setObjectName(QStringLiteral("plan.") + QLatin1StringView(name));
    const auto shown = [whole, quantity](const std::optional<double> &value) {
        if (!value)
            return QString();
        return whole ? QString::number(*value, 'f', 0) : windowLanguage().number(certain(*value), quantity());
    };
    field->setReader([quantity, set, shown, whole](const QString &typed) -> Field::Reading {
        const NumberEntry entry = enteredNumber(typed, quantity(), windowLanguage().units());
        if (entry.refusal)
            return {{}, windowLanguage().text(*entry.refusal)};
        if (entry.value && whole && std::trunc(*entry.value) != *entry.value)
            return {{}, tr("not a whole number")};
        const QString refusal = set(entry.value);
        return refusal.isEmpty() ? Field::Reading{shown(entry.value), {}} : Field::Reading{{}, refusal};
    });
    connect(field, &Field::entered, this, [this, field, quantity, set] {
        if (field->isRefused()) // keep the value from before the typing
            set(enteredNumber(field->valueText(), quantity(), windowLanguage().units()).value);
        replan();
    });
    constexpr std::array<std::string_view, 3> ofProgram{"feed", "dwell", "approach"};
    m_entries.push_back({field, label, whole, std::move(quantity), std::move(get),
                         std::ranges::find(ofProgram, name) != ofProgram.end()});
    return field;
}

void PlanDialog::begin(std::size_t test) {
    if (!measured<PositioningMeasurement>(*m_model.document(), test))
        return;
    const Test &shown = *m_model.document()->tests[test];
    m_edition = shown.edition;
    std::tie(m_request, m_program) = plannedFor(shown);
    m_own = planOf(shown);
    if (!m_own)
        return;
    m_request = m_own->planned.request;
    m_program = m_own->program;
}

/// New targets for the axis of the test, instead of its own.
void PlanDialog::planAnew() {
    m_own.reset();
    const std::tuple typed(m_program.feed, m_program.dwell, m_program.approach);
    std::tie(m_request, m_program) = plannedFor(*m_model.document()->tests[m_test]);
    std::tie(m_program.feed, m_program.dwell, m_program.approach) = typed;
    ++m_request.seed; // that of the test would choose the same again
    replan();
    m_reseed->setFocus();
}

void PlanDialog::replan() {
    if (m_own) {
        m_plans = {m_own->planned};
        m_plan = m_own->planned.plan;
        return showFields();
    }
    m_plans = planMeasurements(m_request);
    m_plan = m_plans.empty() ? TargetPlan() : m_plans.front().plan;
    m_program.motion = m_request.motion;
    m_program.targets = m_plan.targets;
    m_program.decimals = m_request.decimals;
    m_program.runs = m_runs.value_or(m_plan.runs);
    showFields();
}

void PlanDialog::showFields() {
    for (const Entry &entry : m_entries) {
        const auto value = entry.get();
        entry.field->setUnit(windowLanguage().unit(entry.quantity()));
        entry.field->show(!value        ? QString()
                          : entry.whole ? QString::number(*value, 'f', 0)
                                        : windowLanguage().number(*value, entry.quantity()),
                          false);
    }
    for (const Entry &entry : m_entries)
        entry.field->setEnabled(!m_own || entry.ofProgram);
    for (QWidget *widget : std::initializer_list<QWidget *>{m_axis, m_motion, m_rule, m_cycle, m_reseed})
        widget->setEnabled(!m_own);
    m_anew->setVisible(m_own.has_value());
    for (QPushButton *button : {m_fill, m_make})
        button->setVisible(!m_own);
    m_axis->show(QString::fromStdString(m_program.axis), false);
    m_motion->showChoice(m_request.motion == Motion::linear ? 0 : 1, false);
    m_rule->showChoice(m_request.rule == TargetRule::nominalInterval ? 0 : 1, false);
    m_cycle->showChoice(m_program.cycle == Cycle::standard ? 0 : 1, false);
    m_perMetre->setVisible(m_request.motion == Motion::linear);
    const auto over = m_plan.targets.empty() ? std::nullopt : overtravelText(m_program, m_request);
    m_view->show(m_program, overtravelOf(m_program, m_request));
    m_summary->setText(summary());
    m_overtravel->setText(over ? windowLanguage().sentence(*over) : QString());
    m_overtravel->setVisible(over.has_value());
    const Quantity position = m_request.motion == Motion::linear ? Quantity::position : Quantity::angle;
    QStringList targets;
    constexpr std::size_t most = 60;
    for (std::size_t i = 0; i < std::min(most, m_plan.targets.size()); ++i)
        targets << windowLanguage().number(m_plan.targets[i], position, m_request.decimals);
    if (m_plan.targets.size() > most)
        targets << QStringLiteral("…");
    m_targets->setText(targets.join(QStringLiteral(" · ")));
    const bool any = !m_plan.targets.empty();
    for (QPushButton *button : {m_print, m_savePlan, m_make})
        button->setEnabled(any);
    m_fill->setEnabled(any && canFill());
    showWhyNoProgram();
}

/// Shows why the chosen control's program cannot describe the cycle, if so.
void PlanDialog::showWhyNoProgram() {
    QString reason;
    bool possible = !m_plan.targets.empty();
    try {
        if (possible)
            requireProgrammable(m_program, dialect());
    } catch (const Error &error) {
        possible = false;
        reason = tr("No part program: %1").arg(windowLanguage().sentence(error.message));
    }
    m_programReason->setText(reason);
    m_programReason->setVisible(!reason.isEmpty());
    m_saveProgram->setEnabled(possible);
}

QString PlanDialog::summary() const {
    if (m_plan.targets.empty())
        return tr("These numbers give no plan: too many targets, or too few decimals to tell them apart.");
    const Quantity position = m_request.motion == Motion::linear ? Quantity::position : Quantity::angle;
    const Language &language = windowLanguage();
    const Interval moved = movedThrough(m_program);
    const QString random = language.quantity(m_plan.randomPart, position, 1);
    const QString from = language.quantity(moved.from, position, m_request.decimals);
    const QString to = language.quantity(moved.to, position, m_request.decimals);
    QString text = tr("%n target(s)", nullptr, static_cast<int>(m_plan.targets.size())) + u' ';
    if (m_own)
        text += tr("of this test. The axis moves from %1 to %2.").arg(from, to);
    else if (m_plan.interval)
        text += tr("at a nominal position + a random part: every %1, the random part at most %2. The "
                   "axis moves from %3 to %4.")
                    .arg(language.quantity(*m_plan.interval, position, 1), random, from, to);
    else
        text += tr("at the multiples of 90° and, at random, one in each %1 of the travel. The axis moves "
                   "from %2 to %3.")
                    .arg(random, from, to);
    if (const auto zone = m_plans.back().request.zone; zone && m_plans.size() > 1)
        text += u' ' +
                (m_request.zone
                     ? tr("A long axis: once each way over the whole travel, and a full test of the agreed "
                          "zone besides, from %1 to %2.")
                     : tr("A long axis: once each way over the whole travel, and a full test of a zone "
                          "besides, planned from %1 to %2; the zone is to be agreed."))
                    .arg(language.quantity(zone->from, position), language.quantity(zone->to, position));
    if (m_plan.boundOf2006)
        text += u' ' + tr("The random part follows ISO 230-2:2006: ISO 230-2:1988 has no rule for an unknown "
                          "or long cyclic pitch.");
    if (m_program.cycle == Cycle::step && m_request.rule == TargetRule::nominalInterval)
        text += u' ' + tr("The step cycle needs a written agreement.");
    return text;
}

/// True if the test in view can take the plan: a positioning test without readings.
bool PlanDialog::canFill() const {
    const auto *measurement = measured<PositioningMeasurement>(*m_model.document(), m_test);
    return measurement && !hasReadings(*measurement);
}

void PlanDialog::fillTest() {
    const Test planned = plannedTest(m_request, m_plan, m_program, m_edition);
    m_model.edit(QT_TRANSLATE_NOOP("edits", "plan the targets"), [&](Document &document) {
        const std::function fill = [&](PositioningMeasurement &kept) {
            const auto &made = std::get<PositioningMeasurement>(planned.measurement);
            kept.axis.name = made.axis.name;
            kept.axis.motion = made.axis.motion;
            kept.targets = made.targets;
            kept.targetChoice = made.targetChoice;
            kept.runs = made.runs;
            kept.cycle = made.cycle;
            kept.conditions.feed = made.conditions.feed;
            kept.conditions.feedMode = made.conditions.feedMode;
            kept.conditions.dwell = made.conditions.dwell;
            kept.conditions.approachDistance = made.conditions.approachDistance;
        };
        editMeasurement(document, m_test, fill);
    });
    accept();
}

void PlanDialog::makeTest() {
    const std::size_t index = m_model.document()->tests.size();
    m_model.edit(QT_TRANSLATE_NOOP("edits", "add a planned test"), [&](Document &document) {
        for (const PlannedMeasurement &one : m_plans) {
            Test test = plannedTest(one.request, one.plan, programOf(one, m_program), m_edition);
            if (document.instruments.size() == 1)
                test.instruments = {document.instruments[0].id};
            document.tests.push_back(std::make_shared<const Test>(std::move(test)));
        }
    });
    emit testMade(index);
    accept();
}

Report PlanDialog::report() const {
    return composePlan(m_plans, m_program, windowLanguage());
}

Dialect PlanDialog::dialect() const {
    return dialects()[static_cast<std::size_t>(std::max(m_dialect->currentIndex(), 0))].dialect;
}

bool PlanDialog::write(const QString &path, const std::function<QByteArray()> &bytes) {
    try {
        requireNoTestFileName(path);
        awaited([&] { saveBytes(bytes(), path); });
        saySaved(this, path);
        return true;
    } catch (const Error &error) {
        showError(this, tr("%1 cannot be saved").arg(QFileInfo(path).fileName()), error);
        return false;
    }
}

bool PlanDialog::saveProgram(const QString &path) {
    return std::ranges::all_of(m_plans, [&](const PlannedMeasurement &one) {
        const QFileInfo file(path);
        const QString ending = file.suffix().isEmpty() ? QString() : u'.' + file.suffix();
        const QString ofZone =
            file.dir().filePath(file.completeBaseName() + QStringLiteral("-zone") + ending);
        return write(one.request.zone && m_plans.size() > 1 ? ofZone : path,
                     [&] { return partProgram(programOf(one, m_program), dialect(), windowLanguage()); });
    });
}

bool PlanDialog::savePlan(const QString &path) {
    return write(path, [this] {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        writePdf(report(), buffer);
        return buffer.data();
    });
}

bool PlanDialog::printOn(QPrinter &printer) {
    const Pages pages = layoutPages(report());
    QPainter painter;
    if (!painter.begin(&printer))
        return false;
    const double scale = printer.resolution() / pointsPerInch;
    bool first = true;
    for (const PrintedPage &page : pages) {
        if (!std::exchange(first, false))
            printer.newPage();
        painter.save();
        painter.scale(scale, scale);
        drawPage(painter, page);
        painter.restore();
    }
    return painter.end();
}

void PlanDialog::chooseProgramFile() {
    QFileDialog dialog(this, tr("Save the part program"));
    dialog.setObjectName(QStringLiteral("programDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QString::fromLatin1(
        dialects()[static_cast<std::size_t>(std::max(m_dialect->currentIndex(), 0))].ending));
    if (dialog.exec() == QDialog::Accepted)
        saveProgram(dialog.selectedFiles().constFirst());
}

void PlanDialog::choosePlanFile() {
    if (const QString path = askForPdf(this, tr("Save the plan"), tr("Plan of measurement")); !path.isEmpty())
        savePlan(path);
}

void PlanDialog::choosePrinter() {
    QPrinter printer(QPrinter::HighResolution);
    printer.setFullPage(true);
    QPrintDialog dialog(&printer, this);
    if (dialog.exec() == QDialog::Accepted)
        printOn(printer);
}

void PlanDialog::retranslate() {
    setWindowTitle(tr("Plan of measurement"));
    for (const Entry &entry : m_entries)
        entry.field->setLabel(tr(entry.label));
    m_axis->setLabel(tr("Axis"));
    m_motion->setLabel(tr("Motion"));
    m_motion->setChoices({tr("linear"), tr("rotary")}, false);
    m_rule->setLabel(tr("Choice of targets"));
    m_rule->setChoices({QStringLiteral("P = (i − 1)·p + r"), QStringLiteral("P = (N + r)·p (1988)")}, false);
    m_cycle->setLabel(tr("Test cycle"));
    m_cycle->setChoices({tr("standard test cycle"), tr("step cycle")}, false);
    m_reseed->setText(tr("&Other targets"));
    m_fill->setText(tr("&Put into the test"));
    m_fill->setToolTip(tr("For a positioning test without readings"));
    m_make->setText(tr("&New test"));
    m_print->setText(tr("P&rint…"));
    m_savePlan->setText(tr("Save P&DF…"));
    m_saveProgram->setText(tr("Part pro&gram…"));
    m_anew->setText(tr("Plan new &targets"));
    m_anew->setToolTip(
        tr("Chosen by the rule of the edition; the test keeps its own until they are put into it"));
    m_close->setText(tr("&Close"));
    m_dialect->setAccessibleName(tr("Control"));
    m_view->setAccessibleName(tr("Measuring cycle"));
    replan();
}

} // namespace palmer::ui
