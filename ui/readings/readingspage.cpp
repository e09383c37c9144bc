#include "ui/readings/readingspage.h"

#include "ui/readings/readingsview.h"
#include "ui/ruling.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>
#include <QVBoxLayout>

namespace palmer::ui {

namespace {

constexpr int pageMargin = 16;
constexpr int barHeight = 44;

} // namespace

ReadingsPage::ReadingsPage(Selection &selection, QWidget *parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_view(new ReadingsView(m_model, selection, this)) {
    setObjectName(QStringLiteral("readingsPage"));
    auto *units = new QButtonGroup(this);
    auto *groupings = new QButtonGroup(this);
    m_deviations = addSegment(units, "first", static_cast<int>(ReadingUnit::deviations));
    m_positions = addSegment(units, "last", static_cast<int>(ReadingUnit::positions));
    m_byRun = addSegment(groupings, "first", static_cast<int>(ReadingGrouping::byRun));
    m_byDirection = addSegment(groupings, "last", static_cast<int>(ReadingGrouping::byDirection));
    m_deviations->setObjectName(QStringLiteral("showDeviations"));
    m_positions->setObjectName(QStringLiteral("showPositions"));
    m_byRun->setObjectName(QStringLiteral("groupByRun"));
    m_byDirection->setObjectName(QStringLiteral("groupByDirection"));
    m_deviations->setChecked(true);
    m_byRun->setChecked(true);
    connect(units, &QButtonGroup::idClicked, this,
            [this](int id) { m_model.setUnit(static_cast<ReadingUnit>(id)); });
    connect(groupings, &QButtonGroup::idClicked, this,
            [this](int id) { m_model.setGrouping(static_cast<ReadingGrouping>(id)); });

    auto *bar = new QHBoxLayout;
    bar->setContentsMargins(0, 0, 0, 0);
    bar->setSpacing(0);
    bar->addWidget(m_deviations);
    bar->addWidget(m_positions);
    bar->addSpacing(8);
    bar->addWidget(m_byRun);
    bar->addWidget(m_byDirection);
    bar->addStretch();
    auto *barArea = new QWidget(this);
    barArea->setFixedHeight(barHeight);
    barArea->setLayout(bar);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(pageMargin, 0, pageMargin, 8);
    layout->setSpacing(0);
    layout->addWidget(barArea);
    layout->addWidget(m_view);

    connect(m_view, &ReadingsView::summaryChanged, this, &ReadingsPage::summaryChanged);
    connect(&m_selection, &Selection::parameterChanged, this, &ReadingsPage::markRuling);
    retranslate();
}

QToolButton *ReadingsPage::addSegment(QButtonGroup *group, const char *name, int id) {
    auto *button = new QToolButton(this);
    button->setCheckable(true);
    button->setProperty("segment", QString::fromLatin1(name));
    button->setFocusPolicy(Qt::StrongFocus);
    group->addButton(button, id);
    return button;
}

ReadingsPage::~ReadingsPage() {
    delete m_view;
}

void ReadingsPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    m_model.show(evaluated, test);
    retranslate();
    markRuling();
}

void ReadingsPage::setLanguage(const Language &language) {
    m_model.setLanguage(language);
    retranslate();
}

void ReadingsPage::markRuling() {
    m_view->setRuling(rulingTargets(m_evaluated, m_test, m_selection.parameter()));
}

void ReadingsPage::retranslate() {
    const auto *measurement =
        m_test < m_evaluated.tests.size()
            ? std::get_if<PositioningMeasurement>(&m_evaluated.document->tests[m_test]->measurement)
            : nullptr;
    const bool rotary = measurement && measurement->axis.motion == Motion::rotary;
    m_deviations->setText(rotary ? tr("Deviations ″") : tr("Deviations µm"));
    m_positions->setText(rotary ? tr("Positions °") : tr("Positions mm"));
    m_byRun->setText(tr("By run"));
    m_byDirection->setText(tr("By direction"));
    m_deviations->setToolTip(tr("Show deviations from the target positions"));
    m_positions->setToolTip(tr("Show actual positions; the data stay as they are"));
    m_byRun->setToolTip(tr("Runs side by side, both directions of a run together"));
    m_byDirection->setToolTip(tr("All runs of one direction side by side"));
    m_view->setAccessibleName(tr("Readings"));
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
