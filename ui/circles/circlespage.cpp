#include "ui/circles/circlespage.h"

#include "editing/typedreading.h"
#include "kernel/evaluation/iso230_4/paths.h"
#include "language/entry.h"
#include "ui/circles/arccurvesview.h"
#include "ui/circles/arcdialog.h"
#include "ui/circles/quiettable.h"
#include "ui/elidedlabel.h"
#include "ui/model/editname.h"
#include "ui/theme.h"

#include <QAction>
#include <QButtonGroup>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

constexpr int pageMargin = 16;
constexpr int barHeight = 44;
constexpr int fieldGap = 12;
constexpr int labelHeight = 16;
constexpr int fieldHeight = 28;
constexpr int rowHeight = 26;
constexpr int headHeight = 26;
constexpr int mostArcs = 4; ///< shown without scrolling
constexpr int cellMargin = 16;
constexpr int rowsLookedAt = 50; ///< for the width of a column
constexpr int leastHeightForPoints = 480;
constexpr int gridColumns = 12;
constexpr double longestRadius = 1e5; ///< mm
constexpr double fastestFeed = 1e6;   ///< mm/min
constexpr double farthestAngle = 1e6; ///< degrees
constexpr int radiusDecimals = 4;
constexpr int feedDecimals = 3;
constexpr int angleDecimals = 3;

/// The planes offered: right-handed first.
constexpr std::array<std::array<const char *, 2>, 6> planes{
    {{"X", "Y"}, {"Y", "Z"}, {"Z", "X"}, {"Y", "X"}, {"Z", "Y"}, {"X", "Z"}}};

QString planeText(const std::string &first, const std::string &second) {
    return QString::fromStdString(first) + QStringLiteral(" → ") + QString::fromStdString(second);
}

/// A number as it was entered: without zeros at its end.
class NumberBox : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    [[nodiscard]] QString textFromValue(double value) const override {
        QString text = locale().toString(value, 'f', decimals());
        if (const QString group = locale().groupSeparator(); !group.isEmpty())
            text.replace(group, QChar(0x202F));
        const QString point = locale().decimalPoint();
        if (text.contains(point)) {
            while (text.endsWith(u'0'))
                text.chop(1);
            if (text.endsWith(point))
                text.chop(point.size());
        }
        return text.replace(u'-', QChar(0x2212));
    }
    [[nodiscard]] double valueFromText(const QString &text) const override {
        return QDoubleSpinBox::valueFromText(
            QString(text).replace(QChar(0x2212), u'-').remove(QChar(0x202F)));
    }
    [[nodiscard]] QValidator::State validate(QString &text, int &position) const override {
        QString plain = text;
        plain.replace(QChar(0x2212), u'-').remove(QChar(0x202F));
        return QDoubleSpinBox::validate(plain, position);
    }
};

NumberBox *makeNumber(QWidget *parent, const char *name, const QString &unit) {
    auto *box = new NumberBox(parent);
    box->setObjectName(QLatin1StringView(name));
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    box->setKeyboardTracking(false); // one step to undo for what is typed
    box->setSuffix(unit == QStringLiteral("°") ? unit : QStringLiteral(" ") + unit);
    box->setFixedHeight(fieldHeight);
    return box;
}

} // namespace

CirclesPage::CirclesPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : QWidget(parent)
    , m_model(model)
    , m_selection(selection)
    , m_arcs(new QTableView(this))
    , m_newArc(new QToolButton(this))
    , m_empty(new QLabel(this))
    , m_curves(new ArcCurvesView(selection, this))
    , m_points(new QTableView(this)) {
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
    auto *bar = new QHBoxLayout;
    bar->setContentsMargins(0, 8, 0, 8);
    bar->setSpacing(0);
    for (QToolButton *button : {m_deviations, m_coordinates, m_lengths})
        bar->addWidget(button);
    bar->addStretch();
    bar->addWidget(m_newArc);
    m_newArc->setObjectName(QStringLiteral("newArcButton"));
    m_newArc->setIcon(lineIcon(QStringLiteral("plus")));
    m_newArc->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_newArc->setFocusPolicy(Qt::StrongFocus);
    auto *barArea = new QWidget(this);
    barArea->setFixedHeight(barHeight);
    barArea->setLayout(bar);

    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(fieldGap);
    grid->setVerticalSpacing(8);
    makeParameters(*grid);
    auto *rangeRow = new QHBoxLayout;
    rangeRow->setSpacing(8);
    makeRangeRow(*rangeRow);
    makeTables();
    makeActions();
    m_empty->setObjectName(QStringLiteral("noArcs"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setProperty("secondary", true);
    m_empty->hide();

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(pageMargin, 0, pageMargin, 8);
    layout->setSpacing(8);
    layout->addWidget(barArea);
    layout->addLayout(grid);
    layout->addWidget(m_arcs);
    layout->addLayout(rangeRow);
    layout->addWidget(m_curves);
    layout->addWidget(m_points, 1);
    layout->addWidget(m_empty, 1);
    connect(m_curves, &ArcCurvesView::rangeWanted, this,
            [this](std::size_t arc, const Interval &range) { setRange(arc, range); });
    connect(&selection, &Selection::hoveredChanged, this, &CirclesPage::showHovered);
    connect(&selection, &Selection::readingChanged, this, &CirclesPage::showCurrent);
    retranslate();
}

CirclesPage::~CirclesPage() {
    delete m_arcs;
    delete m_points;
}

QToolButton *CirclesPage::addUnit(QButtonGroup &group, const char *segment, const char *name,
                                  PointUnit unit) {
    auto *button = new QToolButton(this);
    button->setObjectName(QLatin1StringView(name));
    button->setCheckable(true);
    button->setProperty("segment", QString::fromLatin1(segment));
    button->setFocusPolicy(Qt::StrongFocus);
    group.addButton(button, static_cast<int>(unit));
    return button;
}

QWidget *CirclesPage::labelled(QGridLayout &grid, int row, int column, int span, const char *label,
                               QWidget *field) {
    auto *text = new ElidedLabel(this);
    text->setFixedHeight(labelHeight);
    text->setProperty("secondary", true);
    text->setBuddy(field);
    auto *box = new QVBoxLayout;
    box->setSpacing(4);
    box->addWidget(text);
    box->addWidget(field);
    grid.addLayout(box, row, column, 1, span);
    m_labels.push_back({text, label, field});
    return field;
}

QComboBox *CirclesPage::addChoice(QGridLayout &grid, int row, int column, int span, const char *name,
                                  const char *label) {
    auto *box = new QComboBox(this);
    box->setObjectName(QLatin1StringView(name));
    box->setFixedHeight(fieldHeight);
    box->setMinimumContentsLength(6);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setFocusPolicy(Qt::StrongFocus);
    labelled(grid, row, column, span, label, box);
    return box;
}

QDoubleSpinBox *CirclesPage::addNumber(QGridLayout &grid, int row, int column, int span, const char *name,
                                       const char *label, const QString &unit) {
    NumberBox *box = makeNumber(this, name, unit);
    labelled(grid, row, column, span, label, box);
    return box;
}

void CirclesPage::makeParameters(QGridLayout &grid) {
    for (int column = 0; column < gridColumns; ++column)
        grid.setColumnStretch(column, 1);
    m_plane = addChoice(grid, 0, 0, 3, "plane", QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "Plane"));
    m_radius =
        addNumber(grid, 0, 3, 3, "nominalRadius",
                  QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "Nominal radius"), QStringLiteral("mm"));
    m_feed =
        addNumber(grid, 0, 6, 3, "contouringFeed",
                  QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "Contouring feed"), QStringLiteral("mm/min"));
    m_source =
        addChoice(grid, 0, 9, 3, "signalSource", QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "Source"));
    m_circle = addChoice(grid, 1, 0, 4, "referenceCircle",
                         QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "Reference circle of G"));
    m_centring =
        addChoice(grid, 1, 4, 4, "centring", QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "Centring for F"));
    m_angle =
        addChoice(grid, 1, 8, 4, "angleReference", QT_TRANSLATE_NOOP("palmer::ui::CirclesPage", "Angle"));
    for (const auto &[first, second] : planes)
        m_plane->addItem(planeText(first, second),
                         QStringList({QLatin1String(first), QLatin1String(second)}));
    m_radius->setDecimals(radiusDecimals);
    m_radius->setRange(0, longestRadius);
    m_feed->setDecimals(feedDecimals);
    m_feed->setRange(0, fastestFeed);

    connect(m_plane, &QComboBox::activated, this, &CirclesPage::setPlane);
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (value > 0)
            edit(QT_TRANSLATE_NOOP("edits", "change the nominal radius"),
                 [value](CircularMeasurement &m) { m.nominalRadius = value; });
    });
    connect(m_feed, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(QT_TRANSLATE_NOOP("edits", "change the contouring feed"),
             [value](CircularMeasurement &m) { m.feed = value > 0 ? std::optional(value) : std::nullopt; });
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

void CirclesPage::makeRangeRow(QHBoxLayout &row) {
    m_rangeLabel = new QLabel(this);
    m_rangeLabel->setProperty("secondary", true);
    m_from = makeNumber(this, "evaluatedFrom", QStringLiteral("°"));
    m_to = makeNumber(this, "evaluatedTo", QStringLiteral("°"));
    for (QDoubleSpinBox *box : {m_from, m_to}) {
        box->setDecimals(angleDecimals);
        box->setRange(-farthestAngle, farthestAngle);
        box->setFixedWidth(78);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            if (m_from->value() < m_to->value())
                setRange(m_arc, Interval{m_from->value(), m_to->value()});
            else
                fillRange(); // an empty range says nothing: back to the one that holds
        });
    }
    const auto button = [&](const char *name) {
        auto *made = new QPushButton(this);
        made->setObjectName(QLatin1StringView(name));
        made->setFixedHeight(fieldHeight);
        made->setAutoDefault(false);
        return made;
    };
    m_whole = button("wholeArc");
    m_reverse = button("reverseSense");
    const auto arrow = [&](const char *name) {
        auto *made = new QToolButton(this);
        made->setObjectName(QLatin1StringView(name));
        made->setFixedSize(fieldHeight, fieldHeight);
        made->setFocusPolicy(Qt::StrongFocus);
        return made;
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
    row.addWidget(m_rangeLabel);
    row.addWidget(m_from);
    row.addWidget(new QLabel(QStringLiteral("…"), this));
    row.addWidget(m_to);
    row.addWidget(m_whole);
    row.addStretch();
    row.addWidget(m_reverse);
    row.addWidget(m_earlier);
    row.addWidget(m_later);
    row.addWidget(m_delete);
}

void CirclesPage::makeActions() {
    const auto action = [this](const char *name, const QKeySequence &shortcut) {
        auto *made = new QAction(this);
        made->setObjectName(QLatin1StringView(name));
        made->setShortcut(shortcut);
        made->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(made);
        return made;
    };
    m_newArcAction = action("newArc", QKeySequence(Qt::CTRL | Qt::Key_Plus));
    m_pasteArcAction = action("pasteArc", QKeySequence::Paste);
    m_deleteArcAction = action("deleteArc", QKeySequence(Qt::CTRL | Qt::Key_Minus));
    m_testActions = {m_newArcAction, m_deleteArcAction};
    const auto fromClipboard = [] {
        const QString text = QGuiApplication::clipboard()->text();
        return ArcDialog::looksLikePoints(text) ? text : QString();
    };
    connect(m_newArcAction, &QAction::triggered, this, [this, fromClipboard] { askForArc(fromClipboard()); });
    connect(m_pasteArcAction, &QAction::triggered, this,
            [this] { askForArc(QGuiApplication::clipboard()->text()); });
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
    m_arc = shown->arcs.size(); // the first of the new ones
    const QByteArray name =
        countedEdit(QT_TRANSLATE_N_NOOP("edits", "add %n arc(s)"), static_cast<int>(arcs.size()));
    edit(name.constData(),
         [&](CircularMeasurement &m) { m.arcs.insert(m.arcs.end(), arcs.begin(), arcs.end()); });
}

/// A point has to have a number: what is none is not taken, and it is said why.
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
    if (!entry.value) {
        const QString why = entry.refusal ? m_language.text(*entry.refusal) : tr("a point needs a number");
        QToolTip::showText(m_points->viewport()->mapToGlobal(m_points->visualRect(index).bottomLeft()), why,
                           m_points);
        return;
    }
    const double value = length ? deviationFrom(shown->nominalRadius, *entry.value) : *entry.value;
    edit(QT_TRANSLATE_NOOP("edits", "change a point"), [&](CircularMeasurement &m) {
        if (place->run >= m.arcs.size() || place->target >= m.arcs[place->run].angles.size())
            return;
        Arc &arc = m.arcs[place->run];
        (angle ? arc.angles : arc.radialDeviations)[place->target] = value;
    });
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
    m_arcs->setObjectName(QStringLiteral("arcs"));
    m_points->setObjectName(QStringLiteral("points"));
    for (QTableView *table : {m_arcs, m_points}) {
        table->setHorizontalHeader(new QuietHeader(table));
        table->setItemDelegate(new QuietDelegate(table)); // before the model, which tells of its current cell
        table->setModel(table == m_arcs ? static_cast<QAbstractItemModel *>(&m_arcsModel) : &m_pointsModel);
        table->setShowGrid(false);
        table->setEditTriggers(QAbstractItemView::NoEditTriggers);
        table->setSelectionMode(QAbstractItemView::SingleSelection);
        table->setWordWrap(false);
        table->setTabKeyNavigation(false);
        table->setCornerButtonEnabled(false);
        table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
        table->verticalHeader()->hide();
        table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
        table->verticalHeader()->setDefaultSectionSize(rowHeight);
        table->horizontalHeader()->setFixedHeight(headHeight);
        table->horizontalHeader()->setSectionsClickable(false);
        table->horizontalHeader()->setHighlightSections(false);
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
    return m_test < m_evaluated.tests.size()
               ? std::get_if<CircularMeasurement>(&m_evaluated.document->tests[m_test]->measurement)
               : nullptr;
}

void CirclesPage::edit(const char *name, const std::function<void(CircularMeasurement &)> &change) {
    const DocumentPointer &document = m_model.document();
    if (m_filling || m_test >= document->tests.size() ||
        !std::holds_alternative<CircularMeasurement>(document->tests[m_test]->measurement))
        return;
    m_model.edit(name, [&](Document &changed) {
        auto test = std::make_shared<Test>(*changed.tests[m_test]);
        change(std::get<CircularMeasurement>(test->measurement));
        changed.tests[m_test] = std::move(test);
    });
}

void CirclesPage::setRange(std::size_t arc, std::optional<Interval> range) {
    edit(QT_TRANSLATE_NOOP("edits", "change the evaluated range of an arc"), [&](CircularMeasurement &m) {
        if (arc < m.arcs.size())
            m.arcs[arc].evaluated = range;
    });
}

void CirclesPage::setPlane() {
    const QStringList axes = m_plane->currentData().toStringList();
    if (axes.size() == 2)
        edit(QT_TRANSLATE_NOOP("edits", "change the plane"), [&](CircularMeasurement &m) {
            m.plane = {axes[0].toStdString(), axes[1].toStdString()};
        });
}

void CirclesPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    if (m_test != test)
        m_arc = 0;
    m_evaluated = evaluated;
    m_test = test;
    refresh();
}

void CirclesPage::setLanguage(const Language &language) {
    m_language = language;
    const QLocale locale(language.id() == Language::Id::french ? QLocale::French : QLocale::English);
    for (QDoubleSpinBox *box : {m_radius, m_feed, m_from, m_to})
        box->setLocale(locale);
    retranslate();
}

void CirclesPage::refresh() {
    const CircularMeasurement *shown = measurement();
    m_newArcAction->setEnabled(shown);
    m_pasteArcAction->setEnabled(shown);
    m_deleteArcAction->setEnabled(shown && !shown->arcs.empty());
    if (!shown)
        return;
    m_filling = true;
    m_arc = shown->arcs.empty() ? 0 : std::min(m_arc, shown->arcs.size() - 1);
    fillParameters(*shown);
    m_arcsModel.show(m_evaluated, m_test, m_language);
    m_pointsModel.show(m_evaluated, m_test, m_language);
    const std::string &id = m_evaluated.document->tests[m_test]->id;
    if (!m_evaluated.isPending(m_test)) {
        m_curves->show(m_evaluated, m_test, m_language);
        m_curvesOf = id;
    } else if (id != m_curvesOf) { // those of before stay until the new ones are there
        m_curves->clear();
        m_curvesOf.clear();
    }
    const int arcs = m_arcsModel.rowCount();
    m_arcs->setFixedHeight(headHeight + std::clamp(arcs, 1, mostArcs) * rowHeight + 2);
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
    m_radius->setValue(shown.nominalRadius);
    m_feed->setValue(shown.feed.value_or(0));
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
    const bool before = std::exchange(m_filling, true);
    m_from->setValue(range ? range->from : 0);
    m_to->setValue(range ? range->to : 0);
    m_filling = before;
    for (QWidget *widget : std::initializer_list<QWidget *>{m_from, m_to})
        widget->setEnabled(range.has_value());
    m_whole->setEnabled(any && shown->arcs[m_arc].evaluated.has_value());
    m_reverse->setEnabled(any);
    m_earlier->setEnabled(any && m_arc > 0);
    m_later->setEnabled(any && m_arc + 1 < shown->arcs.size());
    m_delete->setEnabled(any);
}

void CirclesPage::chooseArc(int row) {
    m_arc = static_cast<std::size_t>(std::max(0, row));
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

/// Every column as wide as its head and numbers; what is left is shared by all.
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

/// What has no room goes, the table of the points first.
void CirclesPage::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    showParts();
    fitColumns();
}

void CirclesPage::showParts() {
    const bool any = m_pointsModel.rowCount() > 0;
    m_points->setVisible(any && height() >= leastHeightForPoints);
    m_curves->setVisible(any);
    m_empty->setVisible(!any);
}

/// The current cell follows the point chosen in figure or curve.
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
    // By the kind of event first: the table that goes sends some, too.
    if (event->type() == QEvent::Leave && watched == m_points->viewport())
        m_selection.setHovered({});
    else if (event->type() == QEvent::Resize && watched == m_points->viewport())
        fitColumns(); // a table that comes into view has its width only then
    return QWidget::eventFilter(watched, event);
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
    m_feed->setSpecialValueText(tr("not stated"));
    m_rangeLabel->setFont(themeFont(TextSize::small));
    m_rangeLabel->setText(tr("Evaluated"));
    m_from->setAccessibleName(tr("Evaluated range, from"));
    m_to->setAccessibleName(tr("Evaluated range, to"));
    m_whole->setText(tr("Whole arc"));
    m_whole->setToolTip(tr("Evaluate all of the arc, of more than 360° the middle 360°"));
    m_reverse->setText(tr("Reverse sense"));
    m_reverse->setToolTip(tr("The arc was contoured in the other sense; the points stay as they are"));
    m_earlier->setText(QStringLiteral("↑"));
    m_later->setText(QStringLiteral("↓"));
    m_newArcAction->setText(tr("Paste &or type an arc…"));
    m_deleteArcAction->setText(tr("Delete t&he arc"));
    m_newArc->setText(tr("New arc…"));
    m_newArc->setAccessibleName(tr("New arc"));
    m_newArc->setToolTip(tr("Add arcs from a table, typed or pasted (%1)")
                             .arg(m_pasteArcAction->shortcut().toString(QKeySequence::NativeText)));
    m_empty->setText(tr("No arc yet. Copy the points in a spreadsheet and press %1, or type them with "
                        "“New arc…”.")
                         .arg(m_pasteArcAction->shortcut().toString(QKeySequence::NativeText)));
    for (const auto &[button, text] :
         {std::pair(m_earlier, tr("Move the arc up: it was measured earlier")),
          std::pair(m_later, tr("Move the arc down: it was measured later")),
          std::pair(m_delete, tr("Delete the arc (%1)")
                                  .arg(m_deleteArcAction->shortcut().toString(QKeySequence::NativeText)))}) {
        button->setToolTip(text);
        button->setAccessibleName(text);
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

void CirclesPage::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace palmer::ui
