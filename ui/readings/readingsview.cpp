#include "ui/readings/readingsview.h"

#include "ui/formulatext.h"
#include "ui/readings/readingsdelegate.h"
#include "ui/readings/readingsheader.h"
#include "ui/theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHeaderView>
#include <QMouseEvent>
#include <QScreen>
#include <QScrollBar>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int numberWidth = 30;
constexpr int positionWidth = 74;
constexpr int readingWidth = 46;
constexpr int cellMargin = 12;
constexpr int rowHeightNormal = 26;
constexpr int rowHeightLow = 24;
constexpr int rowHeightHigh = 32;
constexpr int lowWindow = 768;
constexpr int highWindow = 1000;

ReadingsDelegate *delegateOf(const QAbstractItemView *view) {
    return static_cast<ReadingsDelegate *>(view->itemDelegate());
}

} // namespace

ReadingsView::ReadingsView(ReadingsModel &model, Selection &selection, QWidget *parent)
    : QTableView(parent)
    , m_model(model)
    , m_selection(selection)
    , m_frozen(new QTableView(this)) {
    setObjectName(QStringLiteral("readings"));
    m_frozen->setObjectName(QStringLiteral("frozenReadings"));
    m_frozen->setFocusPolicy(Qt::NoFocus);
    m_frozen->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_frozen->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_frozen->setFrameShape(QFrame::NoFrame);
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen})
        view->setItemDelegate(new ReadingsDelegate(view)); // both before a model: it tells its current cell
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen}) {
        view->setItemDelegate(
            new ReadingsDelegate(view)); // before the model, which tells of its current cell
        view->setModel(&model);
        view->setHorizontalHeader(new ReadingsHeader(model, view));
        view->verticalHeader()->hide();
        view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
        view->verticalHeader()->setMinimumSectionSize(rowHeightLow);
        view->setShowGrid(false);
        view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
        view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
        view->setMouseTracking(true);
        view->setCornerButtonEnabled(false);
        view->setEditTriggers(QAbstractItemView::NoEditTriggers);
        connect(view, &QAbstractItemView::entered, this, &ReadingsView::hover);
    }
    m_frozen->setSelectionModel(selectionModel());
    m_frozen->viewport()->installEventFilter(this);
    m_frozen->setFocusProxy(this);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, m_frozen->verticalScrollBar(),
            &QScrollBar::setValue);
    connect(m_frozen->verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(),
            &QScrollBar::setValue);
    connect(&m_selection, &Selection::hoveredChanged, this, &ReadingsView::showHovered);
    connect(&m_selection, &Selection::readingChanged, this, &ReadingsView::showCurrent);
    connect(&model, &QAbstractItemModel::modelReset, this, [this] {
        fitColumns();
        showHovered();
        showCurrent();
    });
    fitColumns();
}

void ReadingsView::setRowHeight() {
    const int height = window() ? window()->height() : 0;
    const int row = height >= highWindow                ? rowHeightHigh
                    : height <= lowWindow && height > 0 ? rowHeightLow
                                                        : rowHeightNormal;
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
        return width + cellMargin;
    };
    const int columns = m_model.columnCount();
    int reading = readingWidth;
    for (int column = 0; column < columns; ++column) {
        int width = readingWidth;
        if (column == ReadingsModel::numberColumn)
            width = std::max(numberWidth, widest(column));
        else if (column == ReadingsModel::positionColumn)
            width = std::max(positionWidth, widest(column));
        else if (column == ReadingsModel::firstReadingColumn)
            width = reading = std::max(readingWidth, widest(column));
        else if (column < m_model.computedColumn())
            width = reading;
        else
            width = std::max(readingWidth, widest(column));
        setColumnWidth(column, width);
        m_frozen->setColumnWidth(column, width);
        m_frozen->setColumnHidden(column, column > ReadingsModel::positionColumn);
    }
    setRowHeight();
    placeFrozen();
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
    QTableView::resizeEvent(event);
    placeFrozen();
}

/// What stands under the frozen columns is not in view.
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
        setCurrentIndex(index);
        m_following = false;
    }
}

void ReadingsView::currentChanged(const QModelIndex &current, const QModelIndex &previous) {
    QTableView::currentChanged(current, previous);
    for (QTableView *view : {static_cast<QTableView *>(this), m_frozen})
        delegateOf(view)->setCurrent(current);
    // The ground of the whole row tells the current one.
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

bool ReadingsView::viewportEvent(QEvent *event) {
    if (event->type() == QEvent::Leave)
        m_selection.setHovered({});
    else if (event->type() == QEvent::MouseMove &&
             !indexAt(static_cast<QMouseEvent *>(event)->position().toPoint()).isValid())
        m_selection.setHovered({});
    return QTableView::viewportEvent(event);
}

bool ReadingsView::eventFilter(QObject *watched, QEvent *event) {
    if (watched == m_frozen->viewport() && event->type() == QEvent::Wheel) {
        // One scroll bar moves both.
        QCoreApplication::sendEvent(viewport(), event);
        return true;
    }
    return QTableView::eventFilter(watched, event);
}

} // namespace palmer::ui
