// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/circlespage.h"

#include "document/edits.h"
#include "editing/typedreading.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "ui/circles/arccurvesview.h"
#include "ui/circles/arcdialog.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/clipboardtext.h"
#include "ui/model/editname.h"
#include "ui/quiettable.h"
#include "ui/theme.h"

#include <QAction>
#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

constexpr int fieldGap = 12;
constexpr int labelHeight = 16;
constexpr int mostArcs = 4; ///< shown without scrolling
constexpr int cellMargin = 16;
constexpr int rowsLookedAt = 50; ///< to find the width of a column
constexpr int leastPoints = 3;   ///< in view where the page is higher than its place and scrolls
constexpr int angleWidth = 72;
constexpr int reverseWidth = 36; ///< icon only: the range leaves no space for words

/// Available planes, right-handed ones first.
constexpr std::array<std::array<const char *, 2>, 6> planes{
    {{"X", "Y"}, {"Y", "Z"}, {"Z", "X"}, {"Y", "X"}, {"Z", "Y"}, {"X", "Z"}}};

QString planeText(const std::string &first, const std::string &second) {
    return QString::fromStdString(first) + QStringLiteral(" → ") + QString::fromStdString(second);
}

} // namespace

CirclesPage::CirclesPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_selection(selection)
    , m_arcs(made<QTableView>("arcs", this))
    , m_newArc(made<QToolButton>("newArcButton", trait::strongFocus, this))
    , m_empty(made<QLabel>("noArcs", trait::secondary, trait::wrapped, this))
    , m_import(made<QPushButton>("importArcs", this))
    , m_curves(new ArcCurvesView(selection, this))
    , m_points(made<QTableView>("points", this))
    , m_reason(made<QLabel>("circlesReason", trait::reason, trait::wrapped, trait::plainText, this)) {
    setObjectName(QStringLiteral("circlesPage"));
    auto *units = new QButtonGroup(this);
    m_deviations = addUnit(*units, "first", "showRadialDeviations", PointUnit::deviations);
    m_coordinates = addUnit(*units, "middle", "showCoordinates", PointUnit::coordinates);
    m_lengths = addUnit(*units, "last", "showLengths", PointUnit::lengths);
    m_deviations->setChecked(true);
    connect(units, &QButtonGroup::idClicked, this, [this](int id) {
        m_pointsModel.setUnit(static_cast<PointUnit>(id));
        fitColumns();
        showCurrent();
    });
    auto *bar = inRow(nullptr, {0, 8, 0, 8}, 0,
                      {m_deviations, m_coordinates, m_lengths, Placed::stretch(), m_newArc});
    m_newArc->setIcon(lineIcon(QStringLiteral("plus")));
    m_newArc->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto *barArea = new QWidget(this);
    barArea->setFixedHeight(pageBarHeight);
    barArea->setLayout(bar);

    auto *parameters = inColumn(8, {});
    makeParameters(*parameters);
    auto *rangeRow = makeRangeRow();
    makeTables();
    makeActions();
    m_reason->hide();
    m_empty->setAlignment(Qt::AlignCenter);
    connect(m_import, &QPushButton::clicked, this, &CirclesPage::importAsked);
    m_emptyPlace = new QWidget(this);
    inColumn(m_emptyPlace, noMargins, 12,
             {Placed::stretch(), m_empty, {m_import, 0, Qt::AlignHCenter}, Placed::stretch()});
    m_emptyPlace->hide();

    auto *curves = new QGridLayout; // the reason overlays the curves, so that nothing below moves
    curves->addWidget(m_curves, 0, 0);
    curves->addWidget(m_reason, 0, 0, Qt::AlignTop);
    m_reason->raise();
    inColumn(this, {pageMargin, 0, pageMargin, 8}, 8,
             {barArea, parameters, m_arcs, rangeRow, curves, {m_points, 1}, {m_emptyPlace, 1}});
    connect(m_curves, &ArcCurvesView::rangeWanted, this,
            [this](std::size_t arc, const Interval &range) { setRange(arc, range); });
    connect(m_model.undoStack(), &QUndoStack::indexChanged, this, [this] { m_refusedPoint = QModelIndex(); });
    connect(&selection, &Selection::hoveredChanged, this, &CirclesPage::showHovered);
    connect(&selection, &Selection::readingChanged, this, &CirclesPage::showCurrent);
    connect(&selection, &Selection::pageChanged, this, &CirclesPage::enableActions);
    retranslate();
}

CirclesPage::~CirclesPage() {
    delete m_arcs;
    delete m_points;
}

QToolButton *CirclesPage::addUnit(QButtonGroup &group, const char *segment, const char *name,
                                  PointUnit unit) {
    auto *button =
        made<QToolButton>(name, trait::checkable, trait::strongFocus, trait::segment(segment), this);
    group.addButton(button, static_cast<int>(unit));
    return button;
}

QWidget *CirclesPage::labelled(QHBoxLayout &row, int share, const char *label, QWidget *field) {
    auto *text = made<ElidedLabel>(trait::secondary, this);
    text->setFixedHeight(labelHeight);
    text->setBuddy(field);
    row.addLayout(inColumn(4, {text, field}), share);
    m_labels.push_back({text, label, field});
    return field;
}

QComboBox *CirclesPage::addChoice(QHBoxLayout &row, int share, const char *name, const char *label) {
    auto *box = made<ElidedBox>(name, trait::strongFocus, this);
    box->setFixedHeight(fieldHeight);
    box->setMinimumContentsLength(6);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    labelled(row, share, label, box);
    return box;
}

/// Each visit of a number field is a separate undo step.
Field *CirclesPage::makeNumber(const char *name) {
    auto *field = new Field(Field::Kind::number, this);
    field->edit()->setObjectName(QLatin1StringView(name));
    connect(field, &Field::begun, this, [this] { ++m_visit; });
    m_numbers.push_back(field);
    return field;
}

QString CirclesPage::stepOf(const Field *field) const {
    return QStringLiteral("circles/%1/%2/%3").arg(field->edit()->objectName()).arg(m_test).arg(m_visit);
}

/// Accepts a number above 0; `needed`: it must not be empty.
void CirclesPage::readPositive(Field *field, Quantity quantity, bool needed) {
    field->setReader([this, quantity, needed](const QString &typed) -> Field::Reading {
        const NumberEntry entry = enteredNumber(typed, quantity, m_language.units());
        if (entry.refusal)
            return {{}, m_language.text(*entry.refusal)};
        if (!entry.value && needed)
            return {{}, tr("a circle needs a nominal radius")};
        if (entry.value && !(*entry.value > 0))
            return {{}, tr("not greater than 0")};
        return {entry.value ? m_language.number(certain(*entry.value), quantity) : QString(), {}};
    });
}

void CirclesPage::makeParameters(QVBoxLayout &rows) {
    auto *test = inRow(fieldGap, {});
    auto *centres = inRow(fieldGap, {});
    rows.addLayout(test);
    rows.addLayout(centres);
    // The width shares follow the lengths of the labels.
    m_plane = addChoice(*test, 4, "plane", QT_TR_NOOP("Plane"));
    m_radius = makeNumber("nominalRadius");
    m_feed = makeNumber("contouringFeed");
    test->addWidget(m_radius, 5);
    test->addWidget(m_feed, 6);
    readPositive(m_radius, Quantity::position, true);
    readPositive(m_feed, Quantity::feed, false);
    m_source = addChoice(*test, 6, "signalSource", QT_TR_NOOP("Source"));
    m_circle = addChoice(*centres, 1, "referenceCircle", QT_TR_NOOP("Reference circle of G"));
    m_centring = addChoice(*centres, 1, "centring", QT_TR_NOOP("Centring for F"));
    m_angle = addChoice(*centres, 1, "angleReference", QT_TR_NOOP("Angle"));
    m_angle->setPlaceholderText(QStringLiteral("–")); // angles come with the arcs
    for (const auto &[first, second] : planes)
        m_plane->addItem(planeText(first, second),
                         QStringList({QLatin1String(first), QLatin1String(second)}));

    connect(m_plane, &QComboBox::activated, this, &CirclesPage::setPlane);
    connect(m_radius, &Field::entered, this, [this] {
        const auto value = enteredNumber(m_radius->valueText(), Quantity::position, m_language.units()).value;
        if (value)
            edit(
                QT_TRANSLATE_NOOP("edits", "change the nominal radius"),
                [value](CircularMeasurement &m) { m.nominalRadius = *value; }, stepOf(m_radius));
    });
    connect(m_feed, &Field::entered, this, [this] {
        const auto value = enteredNumber(m_feed->valueText(), Quantity::feed, m_language.units()).value;
        edit(
            QT_TRANSLATE_NOOP("edits", "change the contouring feed"),
            [value](CircularMeasurement &m) { m.feed = value; }, stepOf(m_feed));
    });
    connect(m_source, &QComboBox::activated, this, [this](int index) {
        edit(QT_TRANSLATE_NOOP("edits", "change the source of the signal"),
             [index](CircularMeasurement &m) { m.source = static_cast<SignalSource>(index); });
    });
    connect(m_circle, &QComboBox::activated, this, [this](int index) {
        edit(QT_TRANSLATE_NOOP("edits", "change the reference circle"),
             [index](CircularMeasurement &m) { m.referenceCircle = static_cast<ReferenceCircle>(index); });
    });
    connect(m_centring, &QComboBox::activated, this, [this](int index) {
        edit(QT_TRANSLATE_NOOP("edits", "change the centring"),
             [index](CircularMeasurement &m) { m.centring = static_cast<Centring>(index); });
    });
    connect(m_angle, &QComboBox::activated, this, [this](int index) {
        edit(QT_TRANSLATE_NOOP("edits", "change what the angles are"), [index](CircularMeasurement &m) {
            for (Arc &arc : m.arcs)
                arc.angleReference = static_cast<AngleReference>(index);
        });
    });
}

/// Buttons for the current arc as a whole.
void CirclesPage::makeArcButtons() {
    const auto button = [&](const char *name) {
        auto *result = made<QPushButton>(name, trait::notDefault, this);
        result->setFixedHeight(fieldHeight);
        return result;
    };
    m_whole = button("wholeArc");
    m_reverse = button("reverseSense");
    m_reverse->setIcon(lineIcon(QStringLiteral("cycle")));
    m_reverse->setFixedWidth(reverseWidth);
    m_reverse->setStyleSheet(QStringLiteral("padding: 0"));
    const auto arrow = [&](const char *name) {
        auto *result = made<QToolButton>(name, trait::strongFocus, this);
        result->setFixedSize(fieldHeight, fieldHeight);
        return result;
    };
    m_earlier = arrow("moveArcUp");
    m_later = arrow("moveArcDown");
    m_delete = arrow("deleteArcButton");
    m_delete->setIcon(lineIcon(QStringLiteral("close")));
    m_delete->setProperty("iconOnly", true);
    connect(m_whole, &QPushButton::clicked, this, [this] { setRange(m_arc, std::nullopt); });
    connect(m_reverse, &QPushButton::clicked, this, [this] {
        edit(QT_TRANSLATE_NOOP("edits", "change the sense of an arc"), [this](CircularMeasurement &m) {
            Sense &sense = m.arcs[m_arc].sense;
            sense = sense == Sense::clockwise ? Sense::counterclockwise : Sense::clockwise;
        });
    });
    const auto move = [this](std::size_t to) {
        const std::size_t from = std::exchange(m_arc, to);
        edit(QT_TRANSLATE_NOOP("edits", "change the order of the arcs"),
             [from, to](CircularMeasurement &m) { std::swap(m.arcs[from], m.arcs[to]); });
    };
    connect(m_earlier, &QToolButton::clicked, this, [this, move] { move(m_arc - 1); });
    connect(m_later, &QToolButton::clicked, this, [this, move] { move(m_arc + 1); });
}

QHBoxLayout *CirclesPage::makeRangeRow() {
    m_rangeLabel = made<QLabel>(trait::secondary, this);
    m_from = makeNumber("evaluatedFrom");
    m_to = makeNumber("evaluatedTo");
    for (Field *end : {m_from, m_to}) {
        end->setBare();
        end->setFixedWidth(angleWidth);
        end->setReader([this, end](const QString &typed) { return readEnd(end, typed); });
        connect(end, &Field::entered, this, [this, end] { typeRange(end); });
    }
    m_cutOff = new Field(Field::Kind::text, this);
    m_cutOff->edit()->setObjectName(QStringLiteral("cutOff"));
    m_cutOff->setBare();
    m_numbers.push_back(m_cutOff);
    connect(m_cutOff, &Field::begun, this, [this] { ++m_visit; });
    connect(m_cutOff, &Field::entered, this, [this] {
        edit(
            QT_TRANSLATE_NOOP("edits", "state what an arc leaves out"),
            [this](CircularMeasurement &m) {
                if (m_arc < m.arcs.size())
                    m.arcs[m_arc].cutOff = m_cutOff->valueText().toStdString();
            },
            stepOf(m_cutOff));
        showReason();
    });
    makeArcButtons();
    return inRow(6, {m_rangeLabel,
                     m_from,
                     new QLabel(QStringLiteral("…"), this),
                     m_to,
                     m_whole,
                     {m_cutOff, 1},
                     m_reverse,
                     m_earlier,
                     m_later,
                     m_delete});
}

/// Reads an end of the evaluated range, which must be on its side of the other one.
Field::Reading CirclesPage::readEnd(const Field *end, const QString &typed) const {
    const NumberEntry entry = enteredNumber(typed, Quantity::angle, m_language.units());
    if (entry.refusal)
        return {{}, m_language.text(*entry.refusal)};
    if (!entry.value)
        return {{}, tr("the range needs both ends")};
    const Field *other = end == m_from ? m_to : m_from;
    const auto beyond = enteredNumber(other->text(), Quantity::angle, m_language.units()).value;
    if (beyond && end == m_from && !(*entry.value < *beyond))
        return {{}, tr("not below the upper end of the range")};
    if (beyond && end == m_to && !(*beyond < *entry.value))
        return {{}, tr("not above the lower end of the range")};
    return {m_language.number(certain(*entry.value), Quantity::angle), {}};
}

void CirclesPage::typeRange(const Field *end) {
    (end == m_from ? m_to : m_from)->reread(); // this value may make it valid
    const auto number = [this](const Field *field) {
        return enteredNumber(field->valueText(), Quantity::angle, m_language.units()).value;
    };
    const auto from = number(m_from);
    const auto to = number(m_to);
    const CircularMeasurement *shown = measurement();
    const auto now =
        shown && m_arc < shown->arcs.size() ? iso230_4::evaluatedRange(shown->arcs[m_arc]) : std::nullopt;
    if (from && to && *from < *to && now != Interval{*from, *to})
        setRange(m_arc, Interval{*from, *to}, stepOf(end));
    showReason();
}

/// Shows why something is red here: an end of the range, or the last typed point.
void CirclesPage::showReason() {
    QString reason = m_pointReason;
    for (const Field *end : {m_from, m_to, m_cutOff}) {
        if (end->isRefused())
            reason = end->refusal();
    }
    m_reason->setText(reason.isEmpty() ? reason : QStringLiteral("⚠ ") + capitalised(reason));
    m_reason->setVisible(!reason.isEmpty());
}

QString CirclesPage::shownArc() const {
    return QString::fromStdString(m_shownId) + u'/' + QString::number(m_arc);
}

QStringList CirclesPage::refusedTexts() const {
    QStringList texts = m_pointsModel.refusedTexts().texts() + m_refused.texts();
    for (const Field *field : m_numbers) {
        if (field->isRefused())
            texts << field->text();
    }
    return texts;
}

void CirclesPage::makeActions() {
    const auto action = [this](const char *name, const QKeySequence &shortcut) {
        auto *result = made<QAction>(name, this);
        result->setShortcut(shortcut);
        result->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(result);
        return result;
    };
    m_newArcAction = action("newArc", QKeySequence(Qt::CTRL | Qt::Key_Plus));
    m_pasteArcAction = action("pasteArc", QKeySequence::Paste);
    m_deleteArcAction = action("deleteArc", QKeySequence(Qt::CTRL | Qt::Key_Minus));
    m_testActions = {m_newArcAction, m_deleteArcAction};
    const auto fromClipboard = [] {
        const QString text = clipboardText();
        return ArcDialog::looksLikePoints(text) ? text : QString();
    };
    connect(m_newArcAction, &QAction::triggered, this, [this, fromClipboard] { askForArc(fromClipboard()); });
    connect(m_pasteArcAction, &QAction::triggered, this, [this] { askForArc(clipboardText()); });
    connect(m_deleteArcAction, &QAction::triggered, this, &CirclesPage::deleteArc);
    connect(m_newArc, &QToolButton::clicked, m_newArcAction, &QAction::trigger);
    connect(m_delete, &QToolButton::clicked, m_deleteArcAction, &QAction::trigger);
}

void CirclesPage::askForArc(const QString &text) {
    const CircularMeasurement *shown = measurement();
    if (!shown)
        return;
    ArcDialog dialog(*shown, m_language, text, this);
    if (dialog.exec() == QDialog::Accepted)
        addArcs(dialog.arcs());
}

void CirclesPage::addArcs(const std::vector<Arc> &arcs) {
    const CircularMeasurement *shown = measurement();
    if (!shown || arcs.empty())
        return;
    m_arc = shown->arcs.size(); // the first of the new arcs
    const QByteArray name =
        countedEdit(QT_TRANSLATE_N_NOOP("edits", "add %n arc(s)"), static_cast<int>(arcs.size()));
    edit(name.constData(),
         [&](CircularMeasurement &m) { m.arcs.insert(m.arcs.end(), arcs.begin(), arcs.end()); });
}

/// A point needs a number: other text stays in red with the reason and is not accepted.
void CirclesPage::typePoint(const QModelIndex &index, const QString &text) {
    const CircularMeasurement *shown = measurement();
    const auto place = m_pointsModel.placeAt(index);
    if (!shown || !place)
        return;
    const bool angle = m_pointsModel.isAngle(index);
    const bool length = !angle && m_pointsModel.unit() == PointUnit::lengths;
    const NumberEntry entry = enteredNumber(text,
                                            angle    ? Quantity::angle
                                            : length ? Quantity::position
                                                     : Quantity::deviation,
                                            m_language.units());
    if (entry.refusal) {
        m_pointReason = m_language.text(*entry.refusal);
        m_pointsModel.refuse(index, text, m_pointReason);
        m_refusedPoint = index;
    } else {
        m_pointReason = entry.value ? QString() : tr("a point needs a number");
        m_pointsModel.accept(index);
    }
    showReason();
    if (!entry.value)
        return;
    const double value = length ? deviationFrom(shown->nominalRadius, *entry.value) : *entry.value;
    edit(QT_TRANSLATE_NOOP("edits", "change a point"), [&](CircularMeasurement &m) {
        if (place->run >= m.arcs.size() || place->target >= m.arcs[place->run].angles.size())
            return;
        Arc &arc = m.arcs[place->run];
        (angle ? arc.angles : arc.radialDeviations)[place->target] = value;
    });
}

bool CirclesPage::undoRefused() {
    const QModelIndex cell = m_refusedPoint;
    if (!cell.isValid() || !cell.data(QuietDelegate::refusedRole).toBool())
        return false;
    m_refusedPoint = QModelIndex();
    m_pointReason.clear();
    m_pointsModel.accept(cell);
    showReason();
    return true;
}

void CirclesPage::deleteArc() {
    const CircularMeasurement *shown = measurement();
    if (!shown || m_arc >= shown->arcs.size())
        return;
    edit(QT_TRANSLATE_NOOP("edits", "delete an arc"), [this](CircularMeasurement &m) {
        m.arcs.erase(m.arcs.begin() + static_cast<std::ptrdiff_t>(m_arc));
    });
}

void CirclesPage::makeTables() {
    for (QTableView *table : {m_arcs, m_points}) {
        makeQuiet(*table, tableRowHeight, tableRowHeight);
        table->setItemDelegate(new QuietDelegate(table)); // before the model, which reports its current cell
        table->setModel(table == m_arcs ? static_cast<QAbstractItemModel *>(&m_arcsModel) : &m_pointsModel);
        table->setEditTriggers(QAbstractItemView::NoEditTriggers);
        table->setSelectionMode(QAbstractItemView::SingleSelection);
        table->setWordWrap(false);
        table->setCornerButtonEnabled(false);
        table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
        table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
        table->horizontalHeader()->setSectionsClickable(false);
        table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    }
    m_arcs->setFrameShape(QFrame::NoFrame);
    m_arcs->setSelectionBehavior(QAbstractItemView::SelectRows);
    connect(m_arcs->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex &current) {
                if (current.isValid() && !m_filling)
                    chooseArc(current.row());
            });
    m_points->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                              QAbstractItemView::AnyKeyPressed);
    connect(&m_pointsModel, &PointsModel::typed, this, &CirclesPage::typePoint);
    m_points->setMinimumHeight((1 + leastPoints) * tableRowHeight + 2);
    m_points->setMouseTracking(true);
    m_points->viewport()->installEventFilter(this);
    connect(m_points, &QAbstractItemView::entered, this, &CirclesPage::hover);
    connect(m_points->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex &current) {
                if (m_following || !current.isValid())
                    return;
                if (const auto place = m_pointsModel.placeAt(current))
                    m_selection.setReading(*place);
            });
}

const CircularMeasurement *CirclesPage::measurement() const {
    return measured<CircularMeasurement>(m_evaluated, m_test);
}

void CirclesPage::edit(const char *name, const std::function<void(CircularMeasurement &)> &change,
                       const QString &mergeKey) {
    if (!m_filling)
        m_model.edit(
            name, [&](Document &document) { editMeasurement(document, m_test, change); }, mergeKey);
}

void CirclesPage::setRange(std::size_t arc, std::optional<Interval> range, const QString &mergeKey) {
    edit(
        QT_TRANSLATE_NOOP("edits", "change the evaluated range of an arc"),
        [&](CircularMeasurement &m) {
            if (arc >= m.arcs.size())
                return;
            m.arcs[arc].evaluated.reset();
            if (range != iso230_4::evaluatedRange(m.arcs[arc])) // the whole arc needs no statement
                m.arcs[arc].evaluated = range;
        },
        mergeKey);
}

void CirclesPage::setPlane() {
    const QStringList axes = m_plane->currentData().toStringList();
    if (axes.size() == 2)
        edit(QT_TRANSLATE_NOOP("edits", "change the plane"), [&](CircularMeasurement &m) {
            m.plane = {axes[0].toStdString(), axes[1].toStdString()};
        });
}

void CirclesPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    if (m_test != test) {
        leaveFields({m_from, m_to, m_cutOff});
        m_arc = 0;
    }
    m_evaluated = evaluated;
    m_test = test;
    refresh();
}

void CirclesPage::setLanguage(const Language &language) {
    m_language = language;
    retranslate();
}

/// The menus of the window offer them only with the arcs in view.
void CirclesPage::enableActions() {
    const CircularMeasurement *shown = m_selection.page() == Page::readings ? measurement() : nullptr;
    m_newArcAction->setEnabled(shown);
    m_pasteArcAction->setEnabled(shown);
    m_deleteArcAction->setEnabled(shown && !shown->arcs.empty());
}

void CirclesPage::refresh() {
    enableActions();
    const CircularMeasurement *shown = measurement();
    if (!shown)
        return;
    m_filling = true;
    if (const std::string &now = m_evaluated.document->tests[m_test]->id; now != m_shownId) {
        leaveFields(m_numbers);
        m_pointReason.clear();
        m_shownId = now;
    }
    m_arc = shown->arcs.empty() ? 0 : std::min(m_arc, shown->arcs.size() - 1);
    fillParameters(*shown);
    m_arcsModel.show(m_evaluated, m_test, m_language);
    m_pointsModel.show(m_evaluated, m_test, m_language);
    const std::string &id = m_shownId;
    if (!m_evaluated.isPending(m_test)) {
        m_curves->show(m_evaluated, m_test, m_language);
        m_curvesOf = id;
    } else if (id != m_curvesOf) { // same test: keep the former curves until the new ones are ready
        m_curves->clear();
        m_curvesOf.clear();
    }
    const int arcs = m_arcsModel.rowCount();
    m_arcs->setFixedHeight(tableRowHeight + std::clamp(arcs, 1, mostArcs) * tableRowHeight + 2);
    m_arcs->setCurrentIndex(m_arcsModel.index(static_cast<int>(m_arc), 0));
    showParts();
    fitColumns();
    m_filling = false;
    chooseArc(static_cast<int>(m_arc));
    showCurrent();
}

void CirclesPage::fillParameters(const CircularMeasurement &shown) {
    const QString plane = planeText(shown.plane.first, shown.plane.second);
    if (m_plane->findText(plane) < 0)
        m_plane->addItem(plane, QStringList({QString::fromStdString(shown.plane.first),
                                             QString::fromStdString(shown.plane.second)}));
    m_plane->setCurrentIndex(m_plane->findText(plane));
    m_radius->show(m_language.number(certain(shown.nominalRadius), Quantity::position), false);
    m_feed->show(shown.feed ? m_language.number(certain(*shown.feed), Quantity::feed) : QString(), false);
    for (Field *field : {m_radius, m_feed})
        m_refused.giveBack(QString::fromStdString(m_shownId), *field);
    m_source->setCurrentIndex(static_cast<int>(shown.source));
    m_circle->setCurrentIndex(static_cast<int>(shown.referenceCircle));
    m_centring->setCurrentIndex(static_cast<int>(shown.centring));
    m_angle->setCurrentIndex(shown.arcs.empty() ? -1 : static_cast<int>(shown.arcs.front().angleReference));
    m_angle->setEnabled(!shown.arcs.empty());
}

void CirclesPage::fillRange() {
    const CircularMeasurement *shown = measurement();
    const bool any = shown && m_arc < shown->arcs.size();
    const auto range = any ? iso230_4::evaluatedRange(shown->arcs[m_arc]) : std::nullopt;
    const auto angle = [&](double value) { return m_language.number(certain(value), Quantity::angle); };
    m_from->show(range ? angle(range->from) : QString(), false);
    m_to->show(range ? angle(range->to) : QString(), false);
    for (Field *end : {m_from, m_to}) {
        end->setEnabled(range.has_value());
        m_refused.giveBack(shownArc(), *end);
    }
    m_cutOff->show(any ? QString::fromStdString(shown->arcs[m_arc].cutOff) : QString(), false);
    m_cutOff->setEnabled(any);
    m_refused.giveBack(shownArc(), *m_cutOff);
    showReason();
    m_whole->setEnabled(any && shown->arcs[m_arc].evaluated.has_value());
    m_reverse->setEnabled(any);
    m_earlier->setEnabled(any && m_arc > 0);
    m_later->setEnabled(any && m_arc + 1 < shown->arcs.size());
    m_delete->setEnabled(any);
}

/// Keeps refused texts to restore them with the test or arc they were typed for.
void CirclesPage::leaveFields(const std::vector<Field *> &fields) {
    for (Field *field : fields) {
        const bool ofArc = field == m_from || field == m_to || field == m_cutOff;
        m_refused.keep(ofArc ? shownArc() : QString::fromStdString(m_shownId), *field);
        field->forget();
    }
}

void CirclesPage::chooseArc(int row) {
    const auto arc = static_cast<std::size_t>(std::max(0, row));
    if (arc != m_arc)
        leaveFields({m_from, m_to, m_cutOff});
    m_arc = arc;
    m_curves->setCurrentArc(m_arc);
    fillRange();
}

void CirclesPage::hover(const QModelIndex &index) {
    m_selection.setHovered(m_pointsModel.placeAt(index));
}

void CirclesPage::showHovered() {
    const auto place = m_selection.hovered();
    const bool exists = place && measurement();
    static_cast<QuietDelegate *>(m_points->itemDelegate())
        ->setHovered(exists ? m_pointsModel.indexOf(*place) : QModelIndex());
    m_points->viewport()->update();
}

/// Makes every column as wide as its header and numbers; the remaining width is distributed evenly.
void CirclesPage::fitColumns() {
    const QFontMetrics metrics(font());
    const auto fit = [&](QTableView *table, int rows) {
        const QAbstractItemModel *model = table->model();
        std::vector<int> widths;
        int sum = 0;
        for (int column = 0; column < model->columnCount(); ++column) {
            int width = metrics.horizontalAdvance(
                model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
            for (int row = 0; row < std::min(rows, model->rowCount()); ++row)
                width =
                    std::max(width, metrics.horizontalAdvance(model->index(row, column).data().toString()));
            if (model->rowCount() > rows)
                width = std::max(width, metrics.horizontalAdvance(
                                            model->index(model->rowCount() - 1, column).data().toString()));
            widths.push_back(width + cellMargin);
            sum += widths.back();
        }
        const int count = std::max(1, static_cast<int>(widths.size()));
        const int more = std::max(0, table->viewport()->width() - sum) / count;
        for (int column = 0; column < static_cast<int>(widths.size()); ++column)
            table->setColumnWidth(column, widths[static_cast<std::size_t>(column)] + more);
    };
    fit(m_arcs, m_arcsModel.rowCount());
    fit(m_points, rowsLookedAt);
}

void CirclesPage::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    showParts();
    fitColumns();
}

void CirclesPage::showPoint(const ReadingPlace &point) {
    m_selection.setReading(point);
    if (m_points->isVisible())
        m_points->setFocus();
}

void CirclesPage::showParts() {
    const bool any = m_pointsModel.rowCount() > 0;
    const bool scrolls = parentWidget() && height() > parentWidget()->height();
    QWidget *main = !any ? static_cast<QWidget *>(m_newArc) : scrolls ? m_arcs : m_points; // one in view
    setFocusProxy(main);
    if (m_points->hasFocus() && !any) // keeps the focus, and thus the shortcuts, on the page
        main->setFocus();
    m_points->setVisible(any);
    m_curves->setVisible(any);
    m_emptyPlace->setVisible(!any);
}

/// The current cell follows the point chosen in the figure or curve.
void CirclesPage::showCurrent() {
    if (!measurement())
        return;
    const auto place = m_selection.reading();
    const QModelIndex index = place ? m_pointsModel.indexOf(*place) : QModelIndex();
    if (!index.isValid() || m_pointsModel.placeAt(m_points->currentIndex()) == place)
        return;
    m_following = true;
    m_points->setCurrentIndex(index);
    m_points->scrollTo(index);
    m_following = false;
}

bool CirclesPage::eventFilter(QObject *watched, QEvent *event) {
    // Check the kind of event first: a table being destroyed sends events too.
    if (event->type() == QEvent::Leave && watched == m_points->viewport())
        m_selection.setHovered({});
    else if (event->type() == QEvent::Resize && watched == m_points->viewport())
        fitColumns(); // a table gets its width only when it is shown
    return QWidget::eventFilter(watched, event);
}

void CirclesPage::nameRange() {
    m_rangeLabel->setFont(themeFont(TextSize::small));
    m_rangeLabel->setText(tr("Evaluated"));
    m_from->setLabel(tr("Evaluated range, from"));
    m_to->setLabel(tr("Evaluated range, to"));
    for (Field *end : {m_from, m_to})
        end->setUnit(m_language.unit(Quantity::angle));
    m_cutOff->setLabel(tr("What the evaluated range leaves out"));
    m_cutOff->setToolTip(tr("What the evaluated range leaves out: feed-in, overshoot…"));
    m_cutOff->setPlaceholder(tr("left out"));
    m_whole->setText(tr("Whole arc"));
    m_whole->setToolTip(tr("Evaluate all of the arc, of more than 360° the middle 360°"));
    m_reverse->setAccessibleName(tr("Reverse sense"));
    m_reverse->setToolTip(tr("Reverse sense") + u'\n' +
                          tr("The arc was contoured in the other sense; the points stay as they are"));
    m_earlier->setText(QStringLiteral("↑"));
    m_later->setText(QStringLiteral("↓"));
}

void CirclesPage::retranslate() {
    const auto words = [this](QComboBox *box, const QStringList &texts) {
        const QSignalBlocker blocker(box);
        const int index = box->currentIndex();
        box->clear();
        box->addItems(texts);
        box->setCurrentIndex(index);
    };
    words(m_source, {tr("external"), tr("feedback signal")});
    words(m_circle, {tr("minimum zone (MZC)"), tr("least squares (LSC)")});
    words(m_centring, {tr("least squares (LSC)"), tr("set-up of the instrument")});
    words(m_angle, {tr("of the point (polar)"), tr("commanded")});
    for (const Labelled &one : m_labels) {
        one.label->setFont(themeFont(TextSize::small));
        one.label->setText(tr(one.source));
        one.field->setAccessibleName(tr(one.source));
    }
    m_circle->setToolTip(tr("The circles the width of which is G"));
    m_centring->setToolTip(tr("About which centre F is measured"));
    m_angle->setToolTip(tr("Whether the angles are those of the measured points or of the programmed path"));
    m_radius->setLabel(tr("Nominal radius"));
    m_radius->setUnit(m_language.unit(Quantity::position));
    m_feed->setLabel(tr("Contouring feed"));
    m_feed->setUnit(m_language.unit(Quantity::feed));
    m_feed->setPlaceholder(QStringLiteral("–")); // words do not fit next to the unit
    m_reason->setFont(themeFont(TextSize::small));
    nameRange();
    m_newArcAction->setText(tr("Paste &or type an arc…"));
    m_deleteArcAction->setText(tr("Delete t&he arc"));
    m_newArc->setText(tr("New arc…"));
    m_newArc->setAccessibleName(tr("New arc"));
    m_newArc->setToolTip(tr("Add arcs from a table, typed or pasted (%1)")
                             .arg(m_pasteArcAction->shortcut().toString(QKeySequence::NativeText)));
    m_empty->setText(tr("No arc yet. Copy the points in a spreadsheet and press %1, or type them with "
                        "“New arc…”.")
                         .arg(m_pasteArcAction->shortcut().toString(QKeySequence::NativeText)));
    m_import->setText(tr("&Import a ballbar file…"));
    for (const auto &[button, text] :
         {std::pair(m_earlier, tr("Move the arc up: it was measured earlier")),
          std::pair(m_later, tr("Move the arc down: it was measured later")),
          std::pair(m_delete, tr("Delete the arc (%1)")
                                  .arg(m_deleteArcAction->shortcut().toString(QKeySequence::NativeText)))}) {
        nameWidget(*button, text);
    }
    m_deviations->setText(QStringLiteral("Δr ") + m_language.unit(Quantity::deviation));
    m_coordinates->setText(tr("Coordinates %1", "unit").arg(m_language.unit(Quantity::position)));
    m_lengths->setText(tr("Lengths %1", "unit").arg(m_language.unit(Quantity::position)));
    m_deviations->setToolTip(tr("Show radial deviations"));
    m_coordinates->setToolTip(
        tr("Show the points in the coordinates of the plane; the data stay as they are"));
    m_lengths->setToolTip(tr("Show distances from the centre; the data stay as they are"));
    m_deviations->setAccessibleName(m_deviations->toolTip());
    m_arcs->setAccessibleName(tr("Arcs"));
    m_points->setAccessibleName(tr("Points"));
    m_curves->setAccessibleName(tr("Radial deviation over the angle"));
    m_curves->setAccessibleDescription(
        tr("The handles set the evaluated range of the current arc; the fields above set it by number"));
    refresh();
}

} // namespace palmer::ui
