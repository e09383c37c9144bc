// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/compensationdialog.h"

#include "document/savedocument.h"
#include "document/testfile.h"
#include "export/controls.h"
#include "figures/testfigures.h"
#include "kernel/evaluation/edition.h"
#include "kernel/evaluation/evaluatetest.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "ui/errorbox.h"
#include "ui/figures/figurecard.h"
#include "ui/forms/field.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/saving.h"
#include "ui/sizeonscreen.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontDatabase>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTableWidget>
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace palmer::ui {

namespace {

constexpr int compensationFieldsWidth = 280;
constexpr int predictionRowHeight = 24;
constexpr int predictionRows = 6;
constexpr std::array formats{CompensationFormat::linuxcnc, CompensationFormat::siemens,
                             CompensationFormat::weihong, CompensationFormat::csv};
constexpr std::array<std::string_view, 6> predicted{"A", "E", "M", "B", "Bmean", "R"};

const Parameter *parameter(const TestEvaluation &evaluation, std::string_view id) {
    const auto found = std::ranges::find_if(
        evaluation.parameters, [&](const Parameter &each) { return each.term.id == id && each.value; });
    return found == evaluation.parameters.end() ? nullptr : &*found;
}

} // namespace

CompensationDialog::CompensationDialog(EvaluatedDocument evaluated, std::size_t test, QWidget *parent)
    : Translated(parent)
    , m_evaluated(std::move(evaluated))
    , m_test(test)
    , m_format(addChoice("format"))
    , m_signConfirmed(addSwitch("signConfirmed", &CompensationOptions::signConfirmed))
    , m_perDirection(addSwitch("perDirection", &CompensationOptions::perDirection))
    , m_sign(addChoice("sign"))
    , m_incremental(addSwitch("incremental", &CompensationOptions::incremental))
    , m_encoder(addChoice("encoder"))
    , m_mark(addChoice("decimalMark"))
    , m_reason(made<QLabel>("compensationReason", trait::reason, trait::wrapped, trait::plainText, this))
    , m_tableTitle(made<QLabel>(TextSize::head, this))
    , m_table(made<QPlainTextEdit>("compensationTable", this))
    , m_curveTitle(made<QLabel>(TextSize::head, this))
    , m_curve(made<LineView>("compensationCurve", this))
    , m_predictionTitle(made<QLabel>(TextSize::head, this))
    , m_prediction(made<QTableWidget>("prediction", this))
    , m_note(made<QLabel>("compensationNote", trait::secondary, trait::wrapped, trait::plainText, this))
    , m_compare(made<QPushButton>("compareCompensation", trait::notDefault, this))
    , m_save(made<QPushButton>("saveCompensation", trait::primary, trait::notDefault, this))
    , m_close(made<QPushButton>("closeCompensation", trait::notDefault, this)) {
    setObjectName(QStringLiteral("compensationDialog"));
    resize(1040, 680);
    Field *from = addNumber("from", QT_TR_NOOP("From (empty: first target)"), &CompensationOptions::from);
    Field *to = addNumber("to", QT_TR_NOOP("To (empty: last target)"), &CompensationOptions::to);
    Field *interval =
        addNumber("interval", QT_TR_NOOP("Interval (empty: the targets)"), &CompensationOptions::interval);
    m_reference =
        addNumber("reference", QT_TR_NOOP("Reference point of the axis"), &CompensationOptions::reference);
    auto *fields =
        inColumn(8, {m_format, from, to, interval, m_reference, m_encoder, m_sign, m_mark, m_perDirection,
                     m_incremental, m_signConfirmed, m_reason, Placed::stretch(1)});
    m_signConfirmed->setVisible(fileOfAssumedSign(*m_evaluated.document->tests[m_test]) != nullptr);
    connect(m_signConfirmed, &QCheckBox::toggled, this, &CompensationDialog::signConfirmed);
    auto *left = scrolledPlace(this);
    left->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    const int scrollBar = left->verticalScrollBar()->sizeHint().width();
    left->setFixedWidth(compensationFieldsWidth + scrollBar);
    left->setWidget(new QWidget(left));
    left->widget()->setLayout(fields);
    fields->setContentsMargins(0, 0, scrollBar, 0);

    m_table->setReadOnly(true);
    m_table->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_table->setTabChangesFocus(true);
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(font().pointSizeF());
    m_table->setFont(fixed);
    m_prediction->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_prediction->setSelectionMode(QAbstractItemView::NoSelection);
    m_prediction->setTabKeyNavigation(false);
    m_prediction->verticalHeader()->hide();
    m_prediction->verticalHeader()->setDefaultSectionSize(predictionRowHeight);
    m_prediction->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_prediction->setFixedHeight((predictionRows + 1) * predictionRowHeight + 4);

    auto *right = inColumn(styleSpacing, {m_curveTitle, {m_curve, 1}});
    auto *prediction = inColumn(styleSpacing, {m_predictionTitle, m_prediction, m_note, Placed::stretch()});
    auto *table = inColumn(styleSpacing, {m_tableTitle, m_table});
    right->addLayout(inRow(pageMargin, {{prediction, 1}, {table, 1}}));
    auto *body = inRow(pageMargin, {left, {right, 1}});
    auto *foot = inRow(styleSpacing, {m_compare, Placed::stretch(), m_close, m_save});
    inColumn(this, {pageMargin, pageMargin, pageMargin, pageMargin}, pageMargin, {{body, 1}, foot});

    connect(m_compare, &QPushButton::clicked, this, &CompensationDialog::chooseTable);
    connect(m_save, &QPushButton::clicked, this, &CompensationDialog::chooseFile);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    retranslate();
    const auto ofControl = formatsOfControl(m_evaluated.document->machine.controller).compensation;
    if (const auto at = std::ranges::find(formats, ofControl); at != formats.end()) {
        m_format->showChoice(static_cast<int>(at - formats.begin()), false);
        compute();
    }
}

Field *CompensationDialog::addChoice(const char *name) {
    auto *field = new Field(Field::Kind::choice, this);
    field->edit()->setObjectName(QStringLiteral("compensation.") + QLatin1StringView(name));
    connect(field, &Field::entered, this, &CompensationDialog::compute);
    return field;
}

Field *CompensationDialog::addNumber(const char *name, const char *label,
                                     std::optional<double> CompensationOptions::*value) {
    auto *field = new Field(Field::Kind::number, this);
    field->edit()->setObjectName(QStringLiteral("compensation.") + QLatin1StringView(name));
    const auto &measurement = *measured<PositioningMeasurement>(m_evaluated, m_test);
    const Quantity quantity = positionQuantity(measurement.axis);
    field->setReader([quantity](const QString &typed) -> Field::Reading {
        const NumberEntry entry = enteredNumber(typed, quantity, windowLanguage().units());
        if (entry.refusal)
            return {{}, windowLanguage().text(*entry.refusal)};
        return {entry.value ? windowLanguage().number(certain(*entry.value), quantity) : QString(), {}};
    });
    connect(field, &Field::entered, this, [this, field, quantity, value] {
        m_options.*value = enteredNumber(field->valueText(), quantity, windowLanguage().units()).value;
        compute();
    });
    m_numbers.push_back({field, label, value});
    return field;
}

QCheckBox *CompensationDialog::addSwitch(const char *name, bool CompensationOptions::*value) {
    auto *box = made<QCheckBox>(QStringLiteral("compensation.") + QLatin1StringView(name), this);
    connect(box, &QCheckBox::toggled, this, [this, value](bool on) {
        m_options.*value = on;
        compute();
    });
    return box;
}

CompensationFormat CompensationDialog::format() const {
    return formats.at(static_cast<std::size_t>(std::max(m_format->choice(), 0)));
}

/// Options for a format, without those it does not support.
CompensationOptions CompensationDialog::optionsFor(CompensationFormat kind) const {
    const bool csv = kind == CompensationFormat::csv;
    const bool siemens = kind == CompensationFormat::siemens;
    CompensationOptions options = m_options;
    options.perDirection = options.perDirection && !siemens && measuredBothWays(*m_evaluated.tests[m_test]);
    options.incremental = options.incremental && csv;
    options.deviations = (csv || kind == CompensationFormat::weihong) && m_sign->choice() == 1;
    options.decimalMark = csv && m_mark->choice() == 1 ? ',' : '.';
    options.encoder = siemens ? std::max(m_encoder->choice(), 0) : 0;
    if (!siemens)
        options.reference.reset();
    return options;
}

void CompensationDialog::compute() {
    const CompensationFormat kind = format();
    const bool csv = kind == CompensationFormat::csv;
    const bool siemens = kind == CompensationFormat::siemens;
    m_perDirection->setEnabled(!siemens && measuredBothWays(*m_evaluated.tests[m_test]));
    m_sign->setEnabled(csv || kind == CompensationFormat::weihong);
    m_mark->setEnabled(csv);
    m_incremental->setEnabled(csv);
    m_reference->setEnabled(siemens);
    m_encoder->setEnabled(siemens);
    const CompensationOptions options = optionsFor(kind);
    const Test &test = *m_evaluated.document->tests[m_test];
    const TestEvaluation &evaluation = *m_evaluated.tests[m_test];
    m_written.clear();
    m_remarks.clear();
    m_before.reset();
    m_after.reset();
    m_withCompared.reset();
    m_refusal.reset();
    try {
        const CompensationTable table = compensationTable(test, evaluation, kind, options);
        m_written = writeCompensation(table, kind, options);
        m_remarks = compensationRemarks(test, table, kind, options);
        CompensationTable read = readCompensation(m_written, kind, options);
        read.motion = table.motion; // not stated in the files of some controls
        predict(read);
    } catch (const Error &error) {
        m_written.clear();
        m_refusal = error;
        try { // what any control could do, as long as this one misses something
            predict(compensationTable(test, evaluation, CompensationFormat::csv,
                                      optionsFor(CompensationFormat::csv)));
        } catch (const Error &) {
            m_after.reset(); // the refusal holds for every control
        }
    }
    showPrediction();
}

/// The test as it would be with the table applied, and with the one compared.
void CompensationDialog::predict(const CompensationTable &table) {
    const Test &test = *m_evaluated.document->tests[m_test];
    Surroundings surroundings;
    surroundings.machine = &m_evaluated.document->machine;
    const Edition *edition =
        parameter(*m_evaluated.tests[m_test], "M") ? nullptr : &defaultEdition(Kind::positioning);
    m_before = evaluateTest(test, surroundings, edition);
    m_after = evaluateTest(compensated(test, table), surroundings, edition);
    if (!m_compared)
        return;
    m_withCompared = evaluateTest(compensated(test, m_compared->table), surroundings, edition);
    m_difference = largestDifference(m_compared->table, table);
}

/// Notes on the table and on the one compared with it.
QString CompensationDialog::notes() const {
    const Language &language = windowLanguage();
    QStringList lines{(m_written.isEmpty()
                           ? tr("After %1, from the means at the targets: this table is not complete.")
                           : tr("After %1, from the table as it is written."))
                          .arg(QString::fromUtf8(m_before->edition->word))};
    for (const Message &remark : m_remarks)
        lines << language.sentence(remark);
    if (m_withCompared) {
        const auto &measurement = *measured<PositioningMeasurement>(m_evaluated, m_test);
        const bool linear = measurement.axis.motion == Motion::linear;
        lines << tr("%1 (%2): the largest difference, written − compared, is %3 at %4 %5.")
                     .arg(m_comparedName, QString::fromUtf8(m_compared->control),
                          language.quantity(m_difference.value,
                                            linear ? Quantity::deviation : Quantity::angularDeviation, 1),
                          language.quantity(m_difference.position, positionQuantity(measurement.axis)),
                          m_difference.direction == Direction::positive ? QStringLiteral("↑")
                                                                        : QStringLiteral("↓"));
        for (const Message &remark : m_compared->remarks)
            lines << tr("%1: %2").arg(m_comparedName, language.sentence(remark));
    }
    return lines.join(u'\n');
}

void CompensationDialog::showPrediction() {
    const Language &language = windowLanguage();
    m_reason->setText(m_refusal ? language.sentence(m_refusal->message) : QString());
    m_reason->setVisible(m_refusal.has_value());
    m_table->setPlainText(QString::fromUtf8(m_written));
    m_save->setEnabled(!m_written.isEmpty());
    m_prediction->setRowCount(0);
    m_curve->setVisible(m_after.has_value());
    m_note->clear();
    m_prediction->setColumnCount(m_withCompared ? 4 : 3);
    m_prediction->setHorizontalHeaderLabels(
        {tr("Quantity"), tr("measured"), tr("predicted"), tr("compared")});
    if (!m_after)
        return;
    m_curve->setFigure(
        compensationFigure(*m_evaluated.document->tests[m_test], *m_before, *m_after, language));
    for (const std::string_view id : predicted) {
        const Parameter *before = parameter(*m_before, id);
        const Parameter *after = parameter(*m_after, id);
        if (!before || !after)
            continue;
        const int row = m_prediction->rowCount();
        m_prediction->insertRow(row);
        QStringList texts{QString::fromStdString(plainSymbol(*before)),
                          language.quantity(*before->value, before->term.quantity, 1),
                          language.quantity(*after->value, after->term.quantity, 1)};
        if (const Parameter *compared = m_withCompared ? parameter(*m_withCompared, id) : nullptr)
            texts << language.quantity(*compared->value, compared->term.quantity, 1);
        for (int column = 0; column < texts.size(); ++column) {
            auto *item = new QTableWidgetItem(texts[column]);
            item->setTextAlignment(column == 0 ? Qt::AlignLeft | Qt::AlignVCenter
                                               : Qt::AlignRight | Qt::AlignVCenter);
            m_prediction->setItem(row, column, item);
        }
    }
    m_note->setText(notes());
}

void CompensationDialog::chooseTable() {
    auto *dialog = made<QFileDialog>("comparedFileDialog", this, tr("Compare with a compensation table"),
                                     QSettings().value(QStringLiteral("window/exportFolder")).toString());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &CompensationDialog::compareWith);
    dialog->open();
}

bool CompensationDialog::compareWith(const QString &path) {
    try {
        m_compared = readFoundTable(readBytes(path), path);
        m_comparedName = QFileInfo(path).fileName();
        compute();
        return true;
    } catch (const Error &error) {
        showError(this, tr("%1 cannot be compared").arg(QFileInfo(path).fileName()), error);
        return false;
    }
}

void CompensationDialog::chooseFile() {
    auto *dialog = made<QFileDialog>("compensationFileDialog", this, tr("Save the compensation table"),
                                     QSettings().value(QStringLiteral("window/exportFolder")).toString());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    const auto kind = format();
    if (kind == CompensationFormat::weihong)
        dialog->selectFile(QStringLiteral("axeserr.dat")); // the control requires this name
    dialog->setDefaultSuffix(kind == CompensationFormat::csv       ? QStringLiteral("csv")
                             : kind == CompensationFormat::siemens ? QStringLiteral("mpf")
                             : kind == CompensationFormat::weihong ? QStringLiteral("dat")
                                                                   : QStringLiteral("comp"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) {
        QSettings().setValue(QStringLiteral("window/exportFolder"), QFileInfo(path).absolutePath());
        if (saveTo(path))
            accept();
    });
    dialog->open();
}

bool CompensationDialog::saveTo(const QString &path) {
    try {
        requireNoTestFileName(path);
        saveBytes(m_written, path);
        saySaved(this, path);
    } catch (const Error &error) {
        showError(this, tr("%1 cannot be saved").arg(QFileInfo(path).fileName()), error);
        return false;
    }
    return true;
}

void CompensationDialog::retranslate() {
    const auto &measurement = *measured<PositioningMeasurement>(m_evaluated, m_test);
    const auto choices = [](Field *field, const QString &label, const QStringList &words) {
        const int chosen = std::max(field->choice(), 0);
        field->setLabel(label);
        field->setChoices(words, false);
        field->showChoice(chosen, false);
    };
    setWindowTitle(tr("Compensation table"));
    choices(
        m_format, tr("Control"),
        {QStringLiteral("LinuxCNC"), QStringLiteral("Siemens"), QStringLiteral("Weihong"), tr("any (CSV)")});
    choices(m_encoder, tr("Measuring system"), {tr("first (0)"), tr("second (1)")});
    choices(m_sign, tr("Sign of the values"), {tr("corrections, added to the command"), tr("deviations")});
    choices(m_mark, tr("Decimal mark"), {tr("point ."), tr("comma ,")});
    for (const NumberField &number : m_numbers) {
        number.field->setLabel(tr(number.label));
        number.field->setUnit(windowLanguage().unit(positionQuantity(measurement.axis)));
        const auto &value = m_options.*number.value;
        number.field->show(
            value ? windowLanguage().number(*value, positionQuantity(measurement.axis)) : QString(), false);
    }
    m_signConfirmed->setText(tr("The de&viations are actual − target"));
    m_perDirection->setText(tr("&Each direction apart"));
    m_incremental->setText(tr("&Incremental values"));
    m_curveTitle->setText(tr("Means, measured and predicted"));
    m_curve->setAccessibleName(m_curveTitle->text());
    m_tableTitle->setText(tr("What is written"));
    m_table->setAccessibleName(m_tableTitle->text());
    m_predictionTitle->setText(tr("Prediction"));
    m_prediction->setAccessibleName(m_predictionTitle->text());
    m_compare->setText(tr("Compare &with a table…"));
    m_save->setText(tr("&Save the table…"));
    m_close->setText(tr("&Close"));
    compute();
}

} // namespace palmer::ui
