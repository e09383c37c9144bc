// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/readingspage.h"

#include "document/documenterror.h"
#include "kernel/measurement/readingsaside.h"
#include "language/decimals.h"
#include "ui/currentcell.h"
#include "ui/guards.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/clipboardtext.h"
#include "ui/pastebar.h"
#include "ui/readings/readingsview.h"
#include "ui/ruling.h"
#include "ui/tablepaste.h"
#include "ui/theme.h"

#include <QAction>
#include <QButtonGroup>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QInputDialog>
#include <QToolButton>

namespace palmer::ui {

ReadingsPage::ReadingsPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_editor(model)
    , m_view(new ReadingsView(m_model, m_editor, selection, this))
    , m_pasted(new TablePaste(model, *this))
    , m_leaveOut(made<QToolButton>("leaveOutTargets", this))
    , m_pasteButton(made<QToolButton>("pasteButton", trait::iconOnly, this))
    , m_addRunButton(made<QToolButton>("addRunButton", this)) {
    setObjectName(QStringLiteral("readingsPage"));
    setFocusProxy(m_view);
    auto *units = new QButtonGroup(this);
    auto *groupings = new QButtonGroup(this);
    m_deviations = addSegment(*units, "first", "showDeviations", static_cast<int>(ReadingUnit::deviations));
    m_positions = addSegment(*units, "last", "showPositions", static_cast<int>(ReadingUnit::positions));
    m_byRun = addSegment(*groupings, "first", "groupByRun", static_cast<int>(ReadingGrouping::byRun));
    m_byDirection =
        addSegment(*groupings, "last", "groupByDirection", static_cast<int>(ReadingGrouping::byDirection));
    m_deviations->setChecked(true);
    m_byRun->setChecked(true);
    connect(units, &QButtonGroup::idClicked, this,
            [this](int id) { m_model.setUnit(static_cast<ReadingUnit>(id)); });
    connect(groupings, &QButtonGroup::idClicked, this,
            [this](int id) { m_model.setGrouping(static_cast<ReadingGrouping>(id)); });

    makeActions();
    m_pasteButton->setIcon(lineIcon(QStringLiteral("paste")));
    m_addRunButton->setIcon(lineIcon(QStringLiteral("plus")));
    m_addRunButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    for (QToolButton *button : {m_pasteButton, m_addRunButton})
        button->setFocusPolicy(Qt::TabFocus);
    m_leaveOut->setFocusPolicy(Qt::TabFocus);
    connect(m_leaveOut, &QToolButton::clicked, this, [this] {
        commitTyping();
        m_editor.removeTargets(unmeasuredTargets(*m_model.measurement()));
    });
    connect(m_pasteButton, &QToolButton::clicked, m_paste, &QAction::trigger);
    connect(m_addRunButton, &QToolButton::clicked, m_addRuns, &QAction::trigger);
    arrange();
    connectParts();
    retranslate();
}

void ReadingsPage::arrange() {
    auto *bar = inRow(nullptr, noMargins, 0,
                      {m_deviations, m_positions, Placed::gap(8), m_byRun, m_byDirection, Placed::stretch(),
                       m_pasteButton, Placed::gap(8), m_addRunButton});
    auto *barArea = new QWidget(this);
    barArea->setFixedHeight(pageBarHeight);
    barArea->setLayout(bar);

    inColumn(this, {pageMargin, 0, pageMargin, 8}, 0, {barArea, {m_view, 1}, {m_leaveOut, 0, Qt::AlignLeft}});
}

void ReadingsPage::connectParts() {
    connect(m_view, &ReadingsView::summaryChanged, this, &ReadingsPage::summaryChanged);
    connect(m_view, &ReadingsView::summaryChanged, this, &ReadingsPage::enableActions);
    connect(m_view, &ReadingsView::typed, m_pasted, &TablePaste::end);
    connect(m_pasted, &TablePaste::undone, m_view, [this] { m_view->setFocus(); });
    connect(&m_selection, &Selection::parameterChanged, this, &ReadingsPage::markRuling);
    connect(&m_selection, &Selection::pageChanged, this, &ReadingsPage::enableActions);
}

QToolButton *ReadingsPage::addSegment(QButtonGroup &group, const char *segment, const char *name, int id) {
    auto *button =
        made<QToolButton>(name, trait::checkable, trait::strongFocus, trait::segment(segment), this);
    group.addButton(button, id);
    return button;
}

ReadingsPage::~ReadingsPage() {
    delete m_view;
}

QAction *ReadingsPage::addAction(QList<QAction *> &list, const QString &name, const QKeySequence &shortcut) {
    auto *action = made<QAction>(name, this);
    action->setShortcut(shortcut);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    list << action;
    connect(action, &QAction::triggered, this, [] { commitTyping(); }); // before the action runs
    m_view->addAction(action);                                          // for its context menu too
    return action;
}

void ReadingsPage::addSeparator(QList<QAction *> &list) {
    auto *separator = new QAction(this);
    separator->setSeparator(true);
    list << separator;
    m_view->addAction(separator);
}

void ReadingsPage::makeActions() {
    m_cut = addAction(m_editActions, QStringLiteral("cutReadings"), QKeySequence::Cut);
    m_copy = addAction(m_editActions, QStringLiteral("copyReadings"), QKeySequence::Copy);
    m_paste = addAction(m_editActions, QStringLiteral("pasteReadings"), QKeySequence::Paste);
    m_clear = addAction(m_editActions, QStringLiteral("clearReadings"), QKeySequence(Qt::Key_Delete));
    m_fillDown = addAction(m_editActions, QStringLiteral("fillDown"), QKeySequence(Qt::CTRL | Qt::Key_D));
    m_fillRight = addAction(m_editActions, QStringLiteral("fillRight"), QKeySequence(Qt::CTRL | Qt::Key_R));
    addSeparator(m_editActions);
    m_setAside = addAction(m_editActions, QStringLiteral("setAside"), QKeySequence(Qt::CTRL | Qt::Key_E));
    m_bringBack = addAction(m_editActions, QStringLiteral("bringBack"), ReadingsModel::bringBackKeys());
    addSeparator(m_editActions);
    m_insertAbove = addAction(m_testActions, QStringLiteral("insertTargetAbove"),
                              QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Plus));
    m_insertBelow =
        addAction(m_testActions, QStringLiteral("insertTargetBelow"), QKeySequence(Qt::CTRL | Qt::Key_Plus));
    m_removeTargets =
        addAction(m_testActions, QStringLiteral("removeTargets"), QKeySequence(Qt::CTRL | Qt::Key_Minus));
    addSeparator(m_testActions);
    m_addRuns = addAction(m_testActions, QStringLiteral("addRuns"));
    m_insertRun = addAction(m_testActions, QStringLiteral("insertRun"));
    m_removeRuns = addAction(m_testActions, QStringLiteral("removeRuns"));
    m_view->setContextMenuPolicy(Qt::ActionsContextMenu);
    connectActions();
}

void ReadingsPage::connectActions() {
    connect(m_cut, &QAction::triggered, this, [this] {
        QGuiApplication::clipboard()->setText(copied());
        const std::vector<ReadingPlace> places = m_view->selectedPlaces();
        m_editor.cut(places);
        m_view->say(m_model.keptAside(places));
    });
    connect(m_copy, &QAction::triggered, this, [this] { QGuiApplication::clipboard()->setText(copied()); });
    connect(m_paste, &QAction::triggered, this, &ReadingsPage::paste);
    connect(m_clear, &QAction::triggered, this, [this] {
        const std::vector<ReadingPlace> places = m_view->selectedPlaces();
        m_editor.clear(places);
        m_view->say(m_model.keptAside(places));
    });
    connect(m_fillDown, &QAction::triggered, this, [this] { fill(true); });
    connect(m_fillRight, &QAction::triggered, this, [this] { fill(false); });
    connect(m_setAside, &QAction::triggered, this, &ReadingsPage::askReason);
    connect(m_bringBack, &QAction::triggered, this, [this] { m_editor.bringBack(m_view->selectedPlaces()); });
    const auto currentRow = [this] {
        return static_cast<std::size_t>(std::max(0, m_view->currentIndex().row()));
    };
    connect(m_insertAbove, &QAction::triggered, this,
            [this, currentRow] { m_editor.insertTarget(currentRow()); });
    connect(m_insertBelow, &QAction::triggered, this,
            [this, currentRow] { m_editor.insertTarget(currentRow() + 1); });
    connect(m_removeTargets, &QAction::triggered, this, [this] {
        const std::vector<int> rows = m_view->selectedRows();
        m_editor.removeTargets({rows.begin(), rows.end()});
    });
    connect(m_addRuns, &QAction::triggered, this, [this] { m_editor.addRuns(); });
    connect(m_insertRun, &QAction::triggered, this, [this] {
        if (const auto place = m_model.placeAt(m_view->currentIndex()))
            m_editor.insertRun(place->run, m_model.measurement()->runs[place->run].approach);
    });
    connect(m_removeRuns, &QAction::triggered, this, [this] {
        std::vector<std::size_t> runs;
        for (const int column : m_view->selectedColumns()) {
            if (const auto place = m_model.placeAt(m_model.index(0, column)))
                runs.push_back(place->run);
        }
        m_editor.removeRuns(runs);
    });
}

/// The menus of the window offer them only with the table in view, which shows what they change.
void ReadingsPage::enableActions() {
    const bool inView = m_selection.page() == Page::readings;
    const std::vector<ReadingPlace> places = inView ? m_view->selectedPlaces() : std::vector<ReadingPlace>();
    const PositioningMeasurement *measurement = inView ? m_model.measurement() : nullptr;
    const bool any = !places.empty() && measurement;
    const auto rows = inView ? m_view->selectedRows() : std::vector<int>();
    const std::vector<std::size_t> unmeasured =
        measurement ? unmeasuredTargets(*measurement) : std::vector<std::size_t>();
    m_leaveOut->setVisible(!unmeasured.empty());
    m_leaveOut->setText(
        tr("Leave out %n target(s) without readings", nullptr, static_cast<int>(unmeasured.size())));
    m_cut->setEnabled(any);
    m_copy->setEnabled(!rows.empty());
    m_paste->setEnabled(measurement);
    m_clear->setEnabled(any);
    m_fillDown->setEnabled(any && rows.size() > 1);
    m_fillRight->setEnabled(any && m_view->selectedColumns().size() > 1);
    m_setAside->setEnabled(any && std::ranges::any_of(places, [&](const ReadingPlace &place) {
                               return readingAt(*measurement, place).has_value();
                           }));
    m_bringBack->setEnabled(
        any && std::ranges::any_of(places, [aside = ReadingsAside(*measurement)](const ReadingPlace &place) {
            return aside.at(place.run, place.target);
        }));
    m_insertAbove->setEnabled(measurement);
    m_insertBelow->setEnabled(measurement);
    m_removeTargets->setEnabled(!rows.empty());
    m_addRuns->setEnabled(measurement);
    m_insertRun->setEnabled(any);
    m_removeRuns->setEnabled(any);
}

QString ReadingsPage::copied() const {
    const std::vector<int> rows = m_view->selectedRows();
    const std::vector<int> columns = m_view->selectedColumns();
    QStringList lines;
    for (const int row : rows) {
        QStringList cells;
        for (const int column : columns) {
            const QModelIndex cell = m_model.index(row, column);
            cells << (m_view->selectionModel()->isSelected(cell) ? m_model.plainText(cell) : QString());
        }
        lines << cells.join(u'\t');
    }
    return lines.isEmpty() ? QString() : lines.join(u'\n') + u'\n';
}

bool ReadingsPage::undoRefused() {
    return m_view->undoRefused();
}

void ReadingsPage::showReading(const ReadingPlace &place) {
    m_selection.setReading(place);
    if (const QModelIndex cell = m_model.indexOf(place); cell.isValid())
        makeCurrent(*m_view, cell); // even if it was the current one of several selected cells
}

void ReadingsPage::showTarget(std::size_t target) {
    makeCurrent(*m_view, m_model.index(static_cast<int>(target), ReadingsModel::positionColumn));
}

void ReadingsPage::paste() {
    if (!m_editor.measurement())
        return;
    const QModelIndex current = m_view->currentIndex();
    BlockPlace place{static_cast<std::size_t>(std::max(0, current.row())),
                     static_cast<std::size_t>(current.isValid() ? current.column()
                                                                : int{ReadingsModel::firstReadingColumn}),
                     m_model.runs()};
    // A block is pasted at the upper left corner of the selection.
    const auto rows = m_view->selectedRows();
    const auto columns = m_view->selectedColumns();
    if (!rows.empty()) {
        place.row = static_cast<std::size_t>(rows.front());
        place.column = static_cast<std::size_t>(columns.front());
    }
    BlockChoices choices{m_model.unit() == ReadingUnit::positions ? BlockContent::positions
                                                                  : BlockContent::deviations,
                         std::nullopt, std::nullopt, m_model.language().units()};
    m_pasted->paste([this, block = clipboardText(), place = std::move(place),
                     choices = std::move(choices)](const ImportOptions &answers) mutable -> SaidPaste {
        choices.answers = answers;
        return pasteBlock(block, place, choices);
    });
}

/// Pastes with the answers that were given. What cannot be read is said in the bar, too.
SaidPaste ReadingsPage::pasteBlock(const QString &block, const BlockPlace &place, BlockChoices &choices) {
    if (const auto content = choices.answers.extract(PasteBar::content)) {
        choices.content = static_cast<BlockContent>(std::stoi(content.mapped()));
        choices.unitsOfHeading = false;
    }
    if (const auto mark = choices.answers.find("decimalMark"); mark != choices.answers.end())
        choices.decimalMark = mark->second == "comma" ? DecimalMark::comma : DecimalMark::point;
    PastedBlock pasted;
    try {
        pasted = m_editor.paste(block, place, choices).value_or(PastedBlock());
        choices.delimiter = pasted.delimiter; // another decimal mark must keep the cells
    } catch (const Error &error) {
        pasted.remarks.push_back(error.message);
    }
    const Axis &axis = pasted.measurement.axis;
    auto content = static_cast<qsizetype>(choices.content);
    if (pasted.unit && choices.content != BlockContent::positions)
        content = QStringList{m_model.language().unit(deviationQuantity(axis)),
                              m_model.language().unit(positionQuantity(axis))}
                      .indexOf(QString::fromUtf8(pasted.unit->sign));
    pasted.units.push_back({PasteBar::content, std::to_string(content)});
    if (pasted.hasMarks)
        pasted.units.push_back({"decimalMark",
                                pasted.decimalMark.value == DecimalMark::comma ? "comma" : "point",
                                pasted.decimalMark.origin});
    const QString summary = PasteBar::summaryOf(pasted);
    return {std::move(pasted), summary, axis.motion};
}

void ReadingsPage::fill(bool down) {
    std::vector<std::vector<ReadingPlace>> lists;
    const auto add = [&](const std::vector<int> &outer, const std::vector<int> &inner, const auto &cell) {
        for (const int first : outer) {
            lists.emplace_back();
            for (const int second : inner) {
                if (const auto place = m_model.placeAt(cell(first, second)))
                    lists.back().push_back(*place);
            }
        }
    };
    if (down)
        add(m_view->selectedColumns(), m_view->selectedRows(),
            [this](int column, int row) { return m_model.index(row, column); });
    else
        add(m_view->selectedRows(), m_view->selectedColumns(),
            [this](int row, int column) { return m_model.index(row, column); });
    std::vector<ReadingPlace> goals;
    for (const auto &places : lists) {
        if (places.size() > 1)
            goals.insert(goals.end(), places.begin() + 1, places.end());
    }
    m_view->say(m_editor.fill(lists) ? m_model.keptAside(goals)
                                     : tr("nothing to fill with: the first cell has no reading"));
}

void ReadingsPage::askReason() {
    auto *dialog = made<QInputDialog>("reasonDialog", this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Set aside"));
    dialog->setLabelText(
        tr("Why? The reading stays visible, struck through, and is printed with the reason."));
    connect(dialog, &QInputDialog::textValueSelected, this,
            [this, places = m_view->selectedPlaces()](const QString &reason) {
                m_editor.setAside(places, reason);
            });
    dialog->open();
}

void ReadingsPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    if (test != m_test)
        m_pasted->end();
    m_evaluated = evaluated;
    m_test = test;
    m_editor.setTest(test);
    m_model.show(evaluated, test);
    nameUnits();
    enableActions();
    markRuling();
}

void ReadingsPage::setLanguage(const Language &language) {
    m_model.setLanguage(language);
    retranslate();
}

void ReadingsPage::markRuling() {
    m_view->setRuling(rulingTargets(m_evaluated, m_test, m_selection.parameter()));
}

/// Sets the unit names according to the axis and the user's choice.
void ReadingsPage::nameUnits() {
    const auto *measurement = measured<PositioningMeasurement>(m_evaluated, m_test);
    const bool rotary = measurement && measurement->axis.motion == Motion::rotary;
    const Language &language = m_model.language();
    m_deviations->setText(tr("Deviations %1", "unit")
                              .arg(language.unit(rotary ? Quantity::angularDeviation : Quantity::deviation)));
    m_positions->setText(
        tr("Positions %1", "unit").arg(language.unit(rotary ? Quantity::angle : Quantity::position)));
}

void ReadingsPage::retranslate() {
    nameUnits();
    m_byRun->setText(tr("By run"));
    m_byDirection->setText(tr("By direction"));
    m_deviations->setToolTip(tr("Show deviations from the target positions"));
    m_positions->setToolTip(tr("Show actual positions; the data stay as they are"));
    m_byRun->setToolTip(tr("Runs side by side, both directions of a run together"));
    m_byDirection->setToolTip(tr("All runs of one direction side by side"));
    m_view->setAccessibleName(tr("Readings"));
    m_cut->setText(tr("Cu&t"));
    m_copy->setText(tr("&Copy"));
    m_paste->setText(tr("&Paste"));
    m_clear->setText(tr("Cl&ear"));
    m_fillDown->setText(tr("Fill do&wn"));
    m_fillRight->setText(tr("Fill ri&ght"));
    m_setAside->setText(tr("&Set aside…"));
    m_bringBack->setText(tr("Take &back"));
    m_insertAbove->setText(tr("Insert target abo&ve"));
    m_insertBelow->setText(tr("Insert target be&low"));
    m_removeTargets->setText(tr("&Delete targets"));
    m_addRuns->setText(tr("Add a &run each way"));
    m_insertRun->setText(tr("&Insert a run before"));
    m_removeRuns->setText(tr("Delete r&uns"));
    m_addRunButton->setText(tr("Run"));
    nameWidget(*m_addRunButton, tr("Add a run each way"));
    m_pasteButton->setToolTip(
        tr("Paste a block (%1)").arg(m_paste->shortcut().toString(QKeySequence::NativeText)));
    m_pasteButton->setAccessibleName(tr("Paste a block"));
    enableActions();
}

void ReadingsPage::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        m_model.retranslate();
    } else if (event->type() == QEvent::FontChange) {
        m_view->fitColumns();
    }
    QWidget::changeEvent(event);
}

} // namespace palmer::ui
