// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/testsview.h"

#include "ui/measures.h"
#include "ui/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QMenu>
#include <QShortcut>
#include <algorithm>
#include <tuple>

namespace palmer::ui {

namespace {

constexpr int fewResults = 3;        ///< shown unless the table is wide
constexpr int leastForChange = 1000; ///< px of the table, from which it has the column of changes

int widthOf(TextSize size, const QString &text) {
    return QFontMetrics(themeFont(size)).horizontalAdvance(text) + 1;
}

} // namespace

TestsView::TestsView() {
    constexpr int tableHead = 28;
    setObjectName(QStringLiteral("tests"));
    m_sorted->setSourceModel(m_tests);
    m_sorted->setSortRole(TestTableModel::sortRole);
    setModel(m_sorted);
    setItemDelegate(m_delegate);
    setSelectionBehavior(SelectRows);
    setSelectionMode(ExtendedSelection);
    setSortingEnabled(true);
    sortByColumn(TestTableModel::dateColumn, Qt::DescendingOrder);
    setShowGrid(false);
    setFrameShape(NoFrame);
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false); // the next widget follows, not the next cell
    setHorizontalScrollMode(ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(tableRowHeight);
    horizontalHeader()->setFixedHeight(tableHead);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setStretchLastSection(true);
    connect(this, &QTableView::doubleClicked, this, &TestsView::openAsked);
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
        new QShortcut(key, this, this, &TestsView::openCurrent, Qt::WidgetShortcut);
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &TestsView::chosenChanged);
    connect(selectionModel(), &QItemSelectionModel::currentRowChanged, viewport(),
            QOverload<>::of(&QWidget::update)); // the frame of a row
}

void TestsView::retranslate() {
    setAccessibleName(tr("Tests"));
    m_tests->retranslate();
}

void TestsView::setTests(std::vector<ListedTest> tests) {
    m_tests->setTests(std::move(tests));
    m_contents.clear();
    fitColumns();
}

const ListedTest &TestsView::testAt(const QModelIndex &index) const {
    return m_tests->test(m_sorted->mapToSource(index).row());
}

std::vector<const ListedTest *> TestsView::chosen() const {
    std::vector<const ListedTest *> chosen;
    for (const QModelIndex &index : selectionModel()->selectedRows())
        chosen.push_back(&testAt(index));
    std::ranges::sort(chosen, {}, [](const ListedTest *test) {
        return std::tuple(test->test.date.value_or(""), test->test.time.value_or(""), test->id);
    });
    return chosen;
}

void TestsView::choose(const QString &digest) {
    for (int row = 0; row < count(); ++row) {
        const QModelIndex index = m_sorted->index(row, 0);
        if (testAt(index).test.digest != digest)
            continue;
        selectRow(row);
        scrollTo(index);
    }
}

/// Opens the chosen test, or the current row if none is chosen.
void TestsView::openCurrent() {
    if (!selectionModel()->hasSelection() && currentIndex().isValid())
        selectRow(currentIndex().row());
    emit openAsked();
}

/// The column that sorts already offers the opposite order.
void TestsView::fillSorting(QMenu &menu) {
    menu.clear();
    for (int column = TestTableModel::dateColumn; column < m_tests->columnCount(); ++column) {
        if (isColumnHidden(column))
            continue;
        const bool isSorted = column == m_sorted->sortColumn();
        const bool turned = isSorted && m_sorted->sortOrder() == Qt::AscendingOrder;
        QAction *action =
            menu.addAction(m_tests->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(), this,
                           [this, column, order = turned ? Qt::DescendingOrder : Qt::AscendingOrder] {
                               sortByColumn(column, order);
                           });
        action->setCheckable(true);
        action->setChecked(isSorted);
    }
}

void TestsView::resizeEvent(QResizeEvent *event) {
    fitColumns();
    QTableView::resizeEvent(event);
}

void TestsView::changeEvent(QEvent *event) {
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::LanguageChange)
        m_contents.clear();
}

/// Width that the contents and the heading of a column need, px.
int TestsView::neededWidth(int column) {
    const auto [known, isNew] = m_contents.try_emplace(column, 0);
    if (isNew)
        known->second = sizeHintForColumn(column);
    return std::max(known->second, horizontalHeader()->sectionSizeHint(column));
}

void TestsView::fitResults() {
    constexpr int leastValue = 44;
    constexpr int leastResult = 80;
    constexpr int wide = 1250; ///< of the table: all results fit
    std::vector<int> valueWidths;
    for (std::size_t i = 0; i < m_tests->results().size(); ++i) {
        const int column = TestTableModel::firstResult + static_cast<int>(i);
        const TestTableModel::Longest longest = m_tests->longest(i);
        const int value = std::max(leastValue, widthOf(TextSize::base, longest.value));
        const int least = std::max(leastResult, horizontalHeader()->sectionSizeHint(column));
        valueWidths.push_back(value);
        setColumnHidden(column, width() < wide && i >= fewResults);
        setColumnWidth(column, std::max(least, value + valueGap + 2 * resultPadding +
                                                   widthOf(TextSize::small, longest.uncertainty)));
    }
    m_delegate->setValueWidths(std::move(valueWidths));
}

void TestsView::fitColumns() {
    constexpr int markWidth = 30;
    constexpr int limitsWidth = 104;
    constexpr int accordanceWidth = 110;
    constexpr int padding = 10;
    constexpr int markPadding = 20 + 2 * resultPadding; ///< of a word after its mark
    constexpr int leastWord = 64;                       ///< of a shrinkable column, whose text is elided
    constexpr int leastAxis = 40;
    for (int i = TestTableModel::dateColumn; i < TestTableModel::firstResult; ++i)
        setColumnWidth(i, neededWidth(i) + padding);
    setColumnWidth(TestTableModel::markColumn, markWidth);
    fitResults();
    const int results = static_cast<int>(m_tests->results().size());
    const int limits = TestTableModel::firstResult + results;
    setColumnHidden(limits, false); // may be hidden for another axis
    setColumnHidden(limits + 1, false);
    setColumnWidth(limits, std::max(limitsWidth, neededWidth(limits) + markPadding));
    constexpr int changeWidth = 130;
    setColumnWidth(limits + 1, std::max(accordanceWidth, neededWidth(limits + 1) + markPadding));
    setColumnHidden(limits + 2, width() < leastForChange);
    int tooWide =
        (width() < leastForChange ? 0 : changeWidth) - viewport()->width(); // the last takes the rest
    for (int i = 0; i <= limits + 1; ++i)
        tooWide += columnWidth(i); // 0 if hidden
    for (const auto &[column, least] : {std::pair(TestTableModel::purposeColumn, leastWord),
                                        std::pair(TestTableModel::roleColumn, leastWord),
                                        std::pair(TestTableModel::axisColumn, leastAxis)}) {
        const int before = columnWidth(column);
        const int after = std::clamp(before - tooWide, std::min(before, least), before);
        setColumnWidth(column, after);
        tooWide -= before - after;
    }
    // A narrow window shows only the first parameter; the trend has the others.
    for (int i = std::min(results, fewResults) - 1; i > 0 && tooWide > 0; --i) {
        tooWide -= columnWidth(TestTableModel::firstResult + i);
        setColumnHidden(TestTableModel::firstResult + i, true);
    }
}

} // namespace palmer::ui
