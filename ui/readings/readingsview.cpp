// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/readingsview.h"

#include "editing/measuringcycle.h"
#include "ui/currentcell.h"
#include "ui/formulatext.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/readings/readingseditor.h"
#include "ui/readings/readingsheader.h"
#include "ui/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QScreen>
#include <QScrollBar>
#include <QUndoStack>
#include <algorithm>
#include <set>

namespace palmer::ui {

namespace {

constexpr int numberWidth = 30;
constexpr int positionWidth = 74;
constexpr int readingWidth = 46;
constexpr int cellMargin = 12;
constexpr int tightMargin = 8; ///< used if the measured columns fit only with it
constexpr int rowHeightTight = 21;
constexpr int rowHeightLow = 24;
constexpr int rowHeightHigh = 32;
constexpr int leastRows = 6;   ///< visible if not all fit
constexpr int lowWindow = 820; ///< eleven targets fit without scrolling
constexpr int highWindow = 1000;

ReadingsDelegate *delegateOf(const QAbstractItemView *view) {
    return static_cast<ReadingsDelegate *>(view->itemDelegate());
}

} // namespace

ReadingsView::ReadingsView(ReadingsModel &model, ReadingsEditor &editor, Selection &selection,
                           QWidget *parent)
    : QTableView(parent)
    , m_model(model)
    , m_editor(editor)
    , m_selection(selection)
    , m_frozen(made<QTableView>("frozenReadings", this))
    , m_reason(made<QLabel>("reason", TextSize::small, trait::reason, trait::plainText, viewport())) {
    setObjectName(QStringLiteral("readings"));
    m_frozen->setFocusPolicy(Qt::NoFocus);
    m_frozen->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_frozen->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_frozen->setFrameShape(QFrame::NoFrame);
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen})
        view->setItemDelegate(new ReadingsDelegate(view)); // before a model, which reports its current cell
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen}) {
        view->setModel(&model);
        view->setHorizontalHeader(new ReadingsHeader(model, view));
        view->verticalHeader()->hide();
        view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
        view->verticalHeader()->setMinimumSectionSize(rowHeightTight);
        view->setShowGrid(false);
        view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
        view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
        view->setMouseTracking(true);
        view->setCornerButtonEnabled(false);
        view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                              QAbstractItemView::AnyKeyPressed);
        view->setTabKeyNavigation(true);
        connect(view, &QAbstractItemView::entered, this, &ReadingsView::hover);
        connect(delegateOf(view), &ReadingsDelegate::typed, this, &ReadingsView::take);
        connect(delegateOf(view), &ReadingsDelegate::stepWanted, this, &ReadingsView::step);
    }
    m_reason->hide();
    // The frozen columns take no focus: after typing there it returns here.
    connect(delegateOf(m_frozen), &ReadingsDelegate::closeEditor, this, [this] { setFocus(); });
    m_frozen->setSelectionModel(selectionModel());
    m_frozen->viewport()->installEventFilter(this);
    m_frozen->setFocusProxy(this);
    m_frozen->setContextMenuPolicy(Qt::CustomContextMenu); // target actions belong to the targets
    connect(m_frozen, &QWidget::customContextMenuRequested, this, [this](const QPoint &at) {
        auto *menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->addActions(actions());
        menu->popup(m_frozen->viewport()->mapToGlobal(at));
    });
    connect(verticalScrollBar(), &QScrollBar::valueChanged, m_frozen->verticalScrollBar(),
            &QScrollBar::setValue);
    connect(m_frozen->verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(),
            &QScrollBar::setValue);
    connect(&m_selection, &Selection::hoveredChanged, this, &ReadingsView::showHovered);
    connect(m_editor.model().undoStack(), &QUndoStack::indexChanged, this,
            [this] { m_refused = QModelIndex(); });
    connect(&m_selection, &Selection::readingChanged, this, &ReadingsView::showCurrent);
    connect(&model, &QAbstractItemModel::modelReset, this, [this] {
        m_typed = QModelIndex();
        m_said.clear();
        fitColumns();
        showHovered();
        showCurrent();
        showReason();
    });
    connect(&model, &QAbstractItemModel::dataChanged, this, [this] {
        fitColumns();
        showNext(); // another cycle may have another order
        showReason();
        emit summaryChanged(m_model.summary(selectionModel()->selectedIndexes()));
    });
    fitColumns();
}

int ReadingsView::rowHeight() const {
    const int ofWindow = window() ? window()->height() : 0;
    const int wanted = ofWindow >= highWindow                  ? rowHeightHigh
                       : ofWindow <= lowWindow && ofWindow > 0 ? rowHeightLow
                                                               : tableRowHeight;
    const int all = m_model.rowCount();
    const int room = height() - 2 * frameWidth() - horizontalHeader()->height();
    const int rows = all * rowHeightTight <= room ? all : std::min(all, leastRows);
    const bool fitsTight = rows * wanted > room && rows * rowHeightTight <= room;
    return std::max(fitsTight ? room / rows : wanted, QFontMetrics(font()).height() + 4);
}

void ReadingsView::setRowHeight() {
    const int row = rowHeight();
    if (verticalHeader()->defaultSectionSize() == row)
        return;
    verticalHeader()->setDefaultSectionSize(row);
    m_frozen->verticalHeader()->setDefaultSectionSize(row);
}

void ReadingsView::fitColumns() {
    const QFontMetrics metrics(font());
    const auto widest = [&](int column) {
        int width = qRound(formulaWidth(m_model.head(column).text, font()));
        for (const QString &text : m_model.widestTexts(column))
            width = std::max(width, metrics.horizontalAdvance(text));
        return width;
    };
    const int columns = m_model.columnCount();
    const int reading =
        columns > ReadingsModel::firstReadingColumn ? widest(ReadingsModel::firstReadingColumn) : 0;
    m_contents.clear();
    for (int column = 0; column < columns; ++column) {
        const bool isReading =
            column >= ReadingsModel::firstReadingColumn && column < m_model.computedColumn();
        m_contents.push_back(isReading ? reading : widest(column));
        m_frozen->setColumnHidden(column, column > ReadingsModel::positionColumn);
    }
    setRowHeight();
    shareWidth();
    placeFrozen();
}

int ReadingsView::widthOf(int column, bool tight) const {
    const int content = m_contents[static_cast<std::size_t>(column)];
    if (tight)
        return content + tightMargin;
    const int least = column == ReadingsModel::numberColumn     ? numberWidth
                      : column == ReadingsModel::positionColumn ? positionWidth
                                                                : readingWidth;
    return std::max(least, content + cellMargin);
}

/// Shows the computed columns only if all columns fit, so that the measured ones do not scroll. If these do
/// not fit either, uses narrower margins if that suffices.
void ReadingsView::shareWidth() {
    const int columns = static_cast<int>(m_contents.size());
    const int measured = std::min(m_model.computedColumn(), columns);
    const auto needed = [&](int count, bool tight) {
        int sum = 0;
        for (int column = 0; column < count; ++column)
            sum += widthOf(column, tight);
        return sum;
    };
    const bool scrolls =
        m_model.rowCount() * rowHeight() > height() - 2 * frameWidth() - horizontalHeader()->height();
    const int room = width() - 2 * frameWidth() - (scrolls ? verticalScrollBar()->sizeHint().width() : 0);
    const bool fit = needed(columns, false) <= room;
    const bool tight = needed(measured, false) > room && needed(measured, true) <= room;
    const int spare = tight ? (room - needed(measured, true)) / std::max(1, measured) : 0;
    for (int column = 0; column < columns; ++column) {
        const int width = widthOf(column, tight) + spare;
        if (columnWidth(column) != width) {
            setColumnWidth(column, width);
            m_frozen->setColumnWidth(column, width);
        }
        if (column >= measured && isColumnHidden(column) == fit)
            setColumnHidden(column, !fit);
    }
}

void ReadingsView::placeFrozen() {
    if (m_model.columnCount() <= ReadingsModel::positionColumn) {
        m_frozen->hide();
        return;
    }
    m_frozen->show();
    m_frozen->horizontalHeader()->setFixedHeight(horizontalHeader()->height());
    m_frozen->setGeometry(frameWidth(), frameWidth(),
                          columnWidth(ReadingsModel::numberColumn) +
                              columnWidth(ReadingsModel::positionColumn),
                          viewport()->height() + horizontalHeader()->height());
    m_frozen->raise();
    m_frozen->verticalScrollBar()->setValue(verticalScrollBar()->value());
}

void ReadingsView::updateGeometries() {
    QTableView::updateGeometries();
    placeFrozen();
}

void ReadingsView::resizeEvent(QResizeEvent *event) {
    setRowHeight();
    shareWidth();
    QTableView::resizeEvent(event);
    placeFrozen();
}

/// Columns covered by the frozen ones are not visible.
void ReadingsView::scrollTo(const QModelIndex &index, ScrollHint hint) {
    if (index.column() <= ReadingsModel::positionColumn) {
        QTableView::scrollTo(index.siblingAtColumn(index.column()), hint);
        return;
    }
    QTableView::scrollTo(index, hint);
    const int covered = m_frozen->width() - columnViewportPosition(index.column());
    if (covered > 0)
        horizontalScrollBar()->setValue(horizontalScrollBar()->value() - covered);
}

void ReadingsView::setRuling(const std::vector<std::size_t> &targets) {
    std::vector<int> rows;
    rows.reserve(targets.size());
    for (const std::size_t target : targets)
        rows.push_back(static_cast<int>(target));
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen}) {
        delegateOf(view)->setRuling(rows);
        view->viewport()->update();
    }
    if (!rows.empty())
        scrollTo(m_model.index(rows.front(), std::max(0, columnAt(m_frozen->width()))), EnsureVisible);
}

void ReadingsView::hover(const QModelIndex &index) {
    m_selection.setHovered(m_model.placeAt(index));
}

void ReadingsView::showHovered() {
    const auto place = m_selection.hovered();
    const QModelIndex now = place ? m_model.indexOf(*place) : QModelIndex();
    const QModelIndex before = std::exchange(m_hovered, now);
    delegateOf(this)->setHovered(now);
    if (before.isValid())
        update(before);
    if (now.isValid())
        update(now);
}

void ReadingsView::showCurrent() {
    const auto place = m_selection.reading();
    const QModelIndex index = place ? m_model.indexOf(*place) : QModelIndex();
    if (index.isValid() && index != currentIndex()) {
        m_following = true;
        makeCurrent(*this, index);
        m_following = false;
    }
}

void ReadingsView::showNext() {
    const auto place = m_model.placeAt(currentIndex());
    const auto next = place && m_model.measurement() ? nextInCycle(*m_model.measurement(), *place)
                                                     : std::optional<ReadingPlace>();
    delegateOf(this)->setNext(next ? m_model.indexOf(*next) : QModelIndex());
}

void ReadingsView::currentChanged(const QModelIndex &current, const QModelIndex &previous) {
    QTableView::currentChanged(current, previous);
    m_said.clear();
    showNext();
    showReason();
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen})
        delegateOf(view)->setCurrent(current);
    // The background of the whole row marks the current one.
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen})
        view->viewport()->update();
    if (m_following)
        return;
    const auto place = m_model.placeAt(current);
    m_selection.setReading(place);
    if (!place && current.isValid())
        m_selection.setTarget(static_cast<std::size_t>(current.row()));
}

void ReadingsView::selectionChanged(const QItemSelection &selected, const QItemSelection &deselected) {
    QTableView::selectionChanged(selected, deselected);
    emit summaryChanged(m_model.summary(selectionModel()->selectedIndexes()));
}

std::vector<ReadingPlace> ReadingsView::selectedPlaces() const {
    const QModelIndexList selected = selectionModel()->selectedIndexes();
    std::vector<QModelIndex> cells(selected.begin(), selected.end());
    std::sort(cells.begin(), cells.end()); // QModelIndex does not support std::ranges::sort
    std::vector<ReadingPlace> places;
    for (const QModelIndex &index : cells) {
        if (const auto place = m_model.placeAt(index))
            places.push_back(*place);
    }
    return places;
}

std::vector<int> ReadingsView::selectedRows() const {
    std::set<int> rows;
    for (const QModelIndex &index : selectionModel()->selectedIndexes())
        rows.insert(index.row());
    return {rows.begin(), rows.end()};
}

std::vector<int> ReadingsView::selectedColumns() const {
    std::set<int> columns;
    for (const QModelIndex &index : selectionModel()->selectedIndexes())
        columns.insert(index.column());
    return {columns.begin(), columns.end()};
}

void ReadingsView::moveTo(const QModelIndex &index) {
    if (!index.isValid())
        return;
    makeCurrent(*this, index);
    scrollTo(index, EnsureVisible);
}

bool ReadingsView::isAtEnd(bool forward) {
    const QModelIndex now = currentIndex();
    if (!now.isValid())
        return true;
    const QModelIndex next = moveCursor(forward ? MoveNext : MovePrevious, Qt::NoModifier);
    return forward ? !(now < next) : !(next < now); // otherwise it would wrap around
}

void ReadingsView::step(ReadingsDelegate::Step step) {
    using Step = ReadingsDelegate::Step;
    if ((step == Step::right || step == Step::left) && isAtEnd(step == Step::right)) {
        // NOLINTNEXTLINE(bugprone-parent-virtual-call): that of a table walks its cells
        QAbstractScrollArea::focusNextPrevChild(step == Step::right);
        return;
    }
    const QModelIndex current = currentIndex();
    const auto place = m_model.placeAt(current);
    switch (step) {
    case Step::next:
    case Step::previous:
        if (place) {
            const auto goal = step == Step::next ? nextInCycle(*m_model.measurement(), *place)
                                                 : previousInCycle(*m_model.measurement(), *place);
            moveTo(goal ? m_model.indexOf(*goal) : QModelIndex());
        } else {
            moveTo(current.siblingAtRow(current.row() + (step == Step::next ? 1 : -1)));
        }
        break;
    case Step::right:
        moveTo(moveCursor(MoveNext, Qt::NoModifier));
        break;
    case Step::left:
        moveTo(moveCursor(MovePrevious, Qt::NoModifier));
        break;
    case Step::up:
        moveTo(current.siblingAtRow(current.row() - 1));
        break;
    case Step::down:
        moveTo(current.siblingAtRow(current.row() + 1));
        break;
    case Step::stay:
        break;
    }
}

void ReadingsView::keyPressEvent(QKeyEvent *event) {
    using Step = ReadingsDelegate::Step;
    const bool enter = event->key() == Qt::Key_Enter || event->key() == Qt::Key_Return;
    const bool home = event->key() == Qt::Key_Home;
    if ((home || event->key() == Qt::Key_End) && event->modifiers() == Qt::ControlModifier) {
        moveTo(moveCursor(home ? MoveHome : MoveEnd, Qt::ControlModifier));
        return;
    }
    const bool back = event->key() == Qt::Key_Backtab;
    if ((event->key() == Qt::Key_Tab || back) && isAtEnd(!back)) {
        event->ignore(); // to the next field
        return;
    }
    if (enter && state() != EditingState)
        step(event->modifiers().testFlag(Qt::ShiftModifier) ? Step::previous : Step::next);
    else
        QTableView::keyPressEvent(event);
}

/// Cells of the frozen columns are edited in the frozen view, which covers them.
bool ReadingsView::edit(const QModelIndex &index, EditTrigger trigger, QEvent *event) {
    const bool typing = trigger == AnyKeyPressed || trigger == EditKeyPressed || trigger == DoubleClicked;
    if (typing && index.data(ReadingsModel::excludedRole).toBool()) {
        say(m_model.keptAside({*m_model.placeAt(index)}));
        return true; // handled
    }
    if (!index.isValid() || index.column() > ReadingsModel::positionColumn)
        return QTableView::edit(index, trigger, event);
    if (!typing || !(m_model.flags(index) & Qt::ItemIsEditable))
        return false;
    m_frozen->edit(index);
    QWidget *field = m_frozen->indexWidget(index);
    if (field && trigger == AnyKeyPressed && event)
        QCoreApplication::sendEvent(field, event);
    return field;
}

void ReadingsView::take(const QModelIndex &index, const QString &text) {
    m_typed = index;
    m_refused = QModelIndex();
    m_said.clear();
    if (const auto place = m_model.placeAt(index)) {
        m_editor.type(*place, text, m_model.unit(), m_model.language());
    } else {
        const auto target = static_cast<std::size_t>(index.row());
        const auto problem = m_editor.typeTarget(target, text, m_model.language());
        if (problem) {
            m_model.refuseTarget(target, text, m_model.language().sentence(*problem));
            m_refused = index;
        } else
            m_model.acceptTarget(target);
    }
    showReason();
    emit typed();
}

bool ReadingsView::undoRefused() {
    const QModelIndex cell = m_refused;
    if (!cell.isValid() || cell.data(ReadingsModel::refusedRole).toString().isEmpty())
        return false;
    m_refused = QModelIndex();
    m_model.acceptTarget(static_cast<std::size_t>(cell.row()));
    moveTo(cell);
    return true;
}

void ReadingsView::say(const QString &sentence) {
    m_said = sentence;
    showReason();
}

void ReadingsView::showReason() {
    QModelIndex cell = currentIndex();
    QString reason = m_said.isEmpty() ? cell.data(ReadingsModel::refusedRole).toString() : m_said;
    if (reason.isEmpty()) {
        cell = m_typed;
        reason = cell.data(ReadingsModel::refusedRole).toString();
    }
    if (reason.isEmpty()) {
        m_reason->hide();
        return;
    }
    m_reason->setText(QStringLiteral("⚠ ") + reason);
    m_reason->adjustSize();
    const QRect area = visualRect(cell);
    const int width = m_reason->sizeHint().width();
    const int right = area.right() + 4;
    const int left = right + width <= viewport()->width() ? right : area.left() - width - 4;
    m_reason->setGeometry(std::max(0, left), area.top(), width, area.height());
    m_reason->show();
    m_reason->raise();
}

void ReadingsView::scrollContentsBy(int dx, int dy) {
    QTableView::scrollContentsBy(dx, dy);
    showReason();
}

bool ReadingsView::viewportEvent(QEvent *event) {
    const auto isOutside = [&] {
        return event->type() == QEvent::MouseMove &&
               !indexAt(static_cast<QMouseEvent *>(event)->position().toPoint()).isValid();
    };
    if (event->type() == QEvent::Leave || isOutside())
        m_selection.setHovered({});
    return QTableView::viewportEvent(event);
}

bool ReadingsView::eventFilter(QObject *watched, QEvent *event) {
    if (event->type() == QEvent::Wheel && watched == m_frozen->viewport()) {
        // One scroll bar moves both views.
        QCoreApplication::sendEvent(viewport(), event);
        return true;
    }
    return QTableView::eventFilter(watched, event);
}

} // namespace palmer::ui
