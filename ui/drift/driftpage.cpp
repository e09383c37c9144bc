// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drift/driftpage.h"

#include "document/documenterror.h"
#include "document/edits.h"
#include "document/thermal.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "ui/currentcell.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/clipboardtext.h"
#include "ui/pastebar.h"
#include "ui/quiettable.h"
#include "ui/tablepaste.h"
#include "ui/testname.h"
#include "ui/theme.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <functional>

namespace palmer::ui {

namespace {

constexpr int driftColumnWidth = 104; // six beside a figure, at 1366
constexpr int rangeDecimals = 2;

} // namespace

DriftPage::DriftPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_selection(selection)
    , m_range(made<ElidedLabel>("driftRange", this))
    , m_explained(made<QLabel>(trait::wrapped, trait::secondary, this))
    , m_taken(made<QLabel>("driftTakenBy", trait::wrapped, trait::secondary, this))
    , m_reason(made<QLabel>("driftReason", trait::reason, trait::plainText, this))
    , m_paste(made<QToolButton>("pasteDrift", trait::strongFocus, this))
    , m_remove(made<QToolButton>("removeDrift", trait::strongFocus, this))
    , m_table(made<QTableView>("driftReadings", this))
    , m_pasted(new TablePaste(model, *this)) {
    setObjectName(QStringLiteral("driftPage"));
    setFocusProxy(m_table);
    m_taken->setTextFormat(Qt::RichText);
    m_reason->hide();
    m_paste->setIcon(lineIcon(QStringLiteral("paste")));
    m_remove->setIcon(lineIcon(QStringLiteral("close")));
    for (QToolButton *button : {m_paste, m_remove})
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    makeTable();
    connectParts();
    arrange();
    refresh();
}

void DriftPage::makeTable() {
    m_table->setModel(&m_readings);
    m_table->setItemDelegate(new QuietDelegate(m_table));
    makeQuiet(*m_table, tableRowHeight, tableRowHeight);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::AnyKeyPressed);
    m_table->horizontalHeader()->setDefaultSectionSize(driftColumnWidth);
    takeTableKeys(
        *m_table, [this] { paste(); }, [this] { removeRows(); });
}

void DriftPage::connectParts() {
    m_readings.setWriter(
        [this](std::size_t row, const std::vector<DriftReading> &readings) { write(row, readings); });
    connect(&m_readings, &DriftModel::refusedText, this, &DriftPage::showReason);
    connect(m_model.undoStack(), &QUndoStack::indexChanged, this, [this] { m_readings.keepRefused(); });
    connect(m_pasted, &TablePaste::refused, this,
            [this](const QString &sentence) { showReason(sentence + u'.'); });
    connect(m_pasted, &TablePaste::undone, m_table, [this] { m_table->setFocus(); });
    connect(m_table->itemDelegate(), &QAbstractItemDelegate::closeEditor, this,
            [this](QWidget *, QAbstractItemDelegate::EndEditHint hint) {
                if (hint == QAbstractItemDelegate::SubmitModelCache)
                    goOn();
            });
    connect(m_paste, &QToolButton::clicked, this, &DriftPage::paste);
    connect(m_remove, &QToolButton::clicked, this, &DriftPage::removeRows);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex &current) {
                if (!m_following && static_cast<std::size_t>(current.row()) < m_readings.readings())
                    m_selection.setReading(ReadingPlace{0, static_cast<std::size_t>(current.row())});
            });
    connect(&m_selection, &Selection::readingChanged, this, [this] {
        const auto place = m_selection.reading();
        if (!place || place->target >= m_readings.readings() || !isVisible())
            return;
        m_following = true;
        const int column = std::max(0, m_table->currentIndex().column());
        makeCurrent(*m_table, m_readings.index(static_cast<int>(place->target), column));
        m_following = false;
    });
}

void DriftPage::arrange() {
    auto *bar = inRow(styleSpacing, {m_paste, m_remove, Placed::stretch()});
    inColumn(this, {pageMargin, pageMargin, pageMargin, 8}, 8,
             {m_range, m_explained, m_taken, bar, m_reason, {m_table, 1}});
}

DriftPage::~DriftPage() {
    delete m_table;
}

void DriftPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const QModelIndex current = test == m_test ? m_table->currentIndex() : QModelIndex();
    const int row = current.row();
    const int column = current.column();
    const int scrolled = test == m_test ? m_table->verticalScrollBar()->value() : 0;
    if (test != m_test) {
        m_reason->hide();
        m_pasted->end();
    }
    m_evaluated = evaluated;
    m_test = test;
    m_readings.show(evaluated, test, m_language);
    if (row >= 0 && m_readings.rowCount() > 0) {
        m_following = true;
        makeCurrent(*m_table, m_readings.index(std::min(row, m_readings.rowCount() - 1), column));
        m_following = false;
    }
    m_table->verticalScrollBar()->setValue(scrolled);
    refresh();
}

void DriftPage::setLanguage(const Language &language) {
    m_language = language;
    m_readings.show(m_evaluated, m_test, m_language);
    refresh();
}

const Test *DriftPage::test() const {
    if (m_test >= m_evaluated.tests.size())
        return nullptr;
    const Test &shown = *m_evaluated.document->tests[m_test];
    return isDrift(shown) ? &shown : nullptr;
}

QString DriftPage::takenBy() const {
    QStringList names;
    for (const TestPointer &other : m_evaluated.document->tests) {
        if (takesVariation(*other, test()->id))
            names << testName(*other);
    }
    return names.join(QStringLiteral(", "));
}

void DriftPage::refresh() {
    m_range->setFont(themeFont(TextSize::title));
    m_explained->setFont(themeFont(TextSize::small));
    m_taken->setFont(themeFont(TextSize::small));
    m_paste->setText(tr("Paste"));
    m_paste->setToolTip(tr("Paste times and deviations from a table (%1)")
                            .arg(QKeySequence(QKeySequence::Paste).toString(QKeySequence::NativeText)));
    m_paste->setAccessibleName(tr("Paste readings"));
    m_remove->setText(tr("Remove rows"));
    m_remove->setToolTip(tr("Remove the readings that are selected (%1)")
                             .arg(QKeySequence(Qt::Key_Delete).toString(QKeySequence::NativeText)));
    m_remove->setAccessibleName(tr("Remove the readings that are selected"));
    m_table->setAccessibleName(tr("Readings of the drift test"));
    m_explained->setText(
        tr("Environmental variation error: the largest less the smallest deviation at rest"));
    const auto *shown = measured<DriftMeasurement>(m_evaluated, m_test);
    if (!shown || m_evaluated.isPending(m_test))
        return;
    const DriftResults &results = resultsOf(*shown, *m_evaluated.tests[m_test]);
    m_range->setText(results.range ? tr("E_VE = %1")
                                         .arg(m_language.quantity(*results.range, deviationQuantity(*shown),
                                                                  rangeDecimals))
                                   : tr("No readings yet"));
    const QString taken = takenBy();
    m_taken->setText(taken.isEmpty()
                         ? tr("No test takes its E_VE from here yet: page “Uncertainty”.")
                               .replace(QLatin1StringView("E_VE"), QLatin1StringView("E<sub>VE</sub>"))
                         : tr("Taken by: %1").arg(taken).toHtmlEscaped());
}

void DriftPage::write(std::size_t row, const std::vector<DriftReading> &readings) {
    m_reason->hide();
    m_model.edit(QT_TRANSLATE_NOOP("edits", "change a reading"), [&](Document &document) {
        editTest(document, m_test, [&](Test &changed) { setDriftReadings(changed, row, readings); });
    });
}

void DriftPage::paste() {
    const QModelIndex current = m_table->currentIndex();
    const std::size_t row =
        current.isValid() ? static_cast<std::size_t>(current.row()) : m_readings.readings();
    m_reason->hide();
    m_pasted->paste(
        [this, row, text = clipboardText().toStdString()](const ImportOptions &answers) -> SaidPaste {
            m_reason->hide();
            const Test *shown = test();
            if (!shown)
                return {};
            PastedDrift pasted = driftReadingsFrom(text, motionOf(*shown), m_language.units(), answers);
            const DriftMeasurement &drift = pasted.drift;
            if (pasted.questions.empty()) {
                m_model.edit(QT_TRANSLATE_NOOP("edits", "paste readings"), [&](Document &document) {
                    editTest(document, m_test, [&](Test &changed) { putDriftReadings(changed, row, drift); });
                });
            }
            const int taken = static_cast<int>(pasted.taken);
            const QString summary =
                drift.channels.empty()
                    ? PasteBar::tr("%n reading(s) pasted", nullptr, taken)
                    : PasteBar::tr("%n row(s) pasted, channels: %1, temperatures: %2", nullptr, taken)
                          .arg(drift.channels.size())
                          .arg(drift.temperatures.size());
            return {std::move(pasted), summary, {}};
        });
}

void DriftPage::removeRows() {
    std::vector<int> rows;
    for (const QModelIndex &index : m_table->selectionModel()->selectedIndexes())
        rows.push_back(index.row());
    std::ranges::sort(rows, std::greater<>());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    if (rows.empty())
        return;
    m_model.edit(QT_TRANSLATE_NOOP("edits", "remove readings"), [&](Document &document) {
        editTest(document, m_test, [&](Test &changed) {
            for (const int row : rows) // from the last, so that the others keep their row numbers
                removeDriftReadings(changed, static_cast<std::size_t>(row), 1);
        });
    });
}

/// Enter moves from the time to the deviation, then to the next reading.
void DriftPage::goOn() {
    const QModelIndex current = m_table->currentIndex();
    if (current.data(QuietDelegate::refusedRole).toBool())
        return;
    const bool isLast = current.column() + 1 == m_readings.columnCount();
    const QModelIndex next =
        isLast ? m_readings.index(current.row() + 1, 0) : current.siblingAtColumn(current.column() + 1);
    if (next.isValid())
        makeCurrent(*m_table, next);
}

void DriftPage::showReason(const QString &reason) {
    m_reason->setText(capitalised(reason));
    m_reason->setVisible(!reason.isEmpty());
}

} // namespace palmer::ui
