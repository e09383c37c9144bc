// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/workplace.h"

#include "document/edits.h"
#include "editing/editreadings.h"
#include "editing/measuringcycle.h"
#include "kernel/measurement/readingsaside.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "report/words/findingtext.h"
#include "report/words/wording.h"
#include "ui/circles/arctexts.h"
#include "ui/circles/circlespage.h"
#include "ui/comparison/comparisonpage.h"
#include "ui/comparison/comparisonside.h"
#include "ui/diagnosis/diagnosispage.h"
#include "ui/drift/driftpage.h"
#include "ui/drift/thermalpage.h"
#include "ui/figures/figureview.h"
#include "ui/forms/agreedpointspage.h"
#include "ui/forms/conditionspage.h"
#include "ui/forms/field.h"
#include "ui/forms/limitspage.h"
#include "ui/forms/reportpages.h"
#include "ui/guards.h"
#include "ui/madewidgets.h"
#include "ui/model/editname.h"
#include "ui/navigation/navigationlist.h"
#include "ui/readings/keyhints.h"
#include "ui/readings/readingspage.h"
#include "ui/readings/targetcard.h"
#include "ui/results/explanationcard.h"
#include "ui/results/findingspanel.h"
#include "ui/results/resultspanel.h"
#include "ui/theme.h"
#include "ui/thinsplitter.h"
#include "ui/uncertainty/uncertaintypage.h"
#include "ui/window/pagetabs.h"
#include "ui/window/rightside.h"
#include "ui/window/testhead.h"
#include "ui/windowlanguage.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QFrame>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <span>

namespace palmer::ui {

namespace {

constexpr int centreWidth = 560;
constexpr int rightWidth = 496;
constexpr int leastRightWidth = 380;
constexpr int railBelow = 1180;
constexpr int stackedBelow = 1000;
/// In a low window the figure below the table would leave two rows: it then stays next to a narrower centre.
constexpr int narrowCentreWidth = 528;
constexpr int narrowRightWidth = 366;
constexpr int besideFrom = narrowCentreWidth + narrowRightWidth + 50; ///< with the collapsed navigation
constexpr int stackedFrom = 1200 - 99;                                ///< of the height
constexpr int wideFrom = 1580;
constexpr int leastFindings = 3;
constexpr int heightOfAFinding = 80; ///< a wide window shows one more finding per so many pixels
constexpr int wideShare = 42;        ///< right side of a wide window, per cent
// Heights of the workplace; menu, toolbar and status bar take 99 px of the window's height.
constexpr int foldBelow = 760 - 99;
constexpr int noCardBelow = 640 - 99;
constexpr int noKeysBelow = 760 - 99;
/// Below this height, a page with six table rows and the smallest figure do not fit in a column.
constexpr int turnsBelow = 690 - 99;
constexpr int lowTabsBelow = 400;
constexpr QSize least(NavigationList::railWidth + 1 + centreWidth, 280); ///< with the page as a tab

/// A tab and its text.
struct TestPage {
    Page page;
    const char *text = nullptr;
};
constexpr std::array testPages{
    TestPage{Page::readings, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "&Readings")},
    TestPage{Page::conditions, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "&Conditions")},
    TestPage{Page::agreedPoints, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "&Agreed points")},
    TestPage{Page::limits, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "&Limits")},
    TestPage{Page::uncertainty, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "U&ncertainty")},
    TestPage{Page::comparison, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "C&omparison")},
    TestPage{Page::diagnosis, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "Dia&gnosis")},
    TestPage{Page::thermal, QT_TRANSLATE_NOOP("palmer::ui::Workplace", "Thermal &behaviour")}};

/// How the tests of a kind are shown.
struct KindView {
    const char *sizes = nullptr;    ///< settings key of the widths they share
    std::span<const Page> ownPages; ///< besides the readings and, of judged kinds, those of all of them
    int more = 0;                   ///< px by which their page is wider, as their results need less
};
constexpr std::array judgedPages{Page::conditions, Page::agreedPoints, Page::limits, Page::uncertainty,
                                 Page::comparison};
constexpr std::array circlePages{Page::diagnosis};
constexpr std::array driftPages{Page::thermal};
/// In the order of Kind.
constexpr std::array kindViews{KindView{"positioning", {}}, KindView{"circular", circlePages, 28},
                               KindView{"positioning", driftPages}};
static_assert(kindViews.size() == allKinds.size());

const KindView &viewOf(Kind kind) {
    return kindViews.at(static_cast<std::size_t>(kind));
}

/// Widget of a pane for the keyboard: its table, otherwise a widget that is not a button, otherwise its
/// first.
QWidget *mainPart(QWidget *pane) {
    const auto takesKeys = [](const QWidget *widget) {
        return widget->isVisible() && widget->isEnabled() && (widget->focusPolicy() & Qt::TabFocus) != 0;
    };
    if (takesKeys(pane))
        return pane;
    QWidget *best = nullptr;
    for (QWidget *part : pane->findChildren<QWidget *>()) {
        if (!takesKeys(part))
            continue;
        if (qobject_cast<QAbstractItemView *>(part))
            return part;
        const bool isButton = qobject_cast<QAbstractButton *>(part) || qobject_cast<QComboBox *>(part);
        if (!best || (qobject_cast<QAbstractButton *>(best) && !isButton))
            best = part;
    }
    return best;
}

/// The first reading that differs in value or exclusion; null if targets or runs differ.
std::optional<ReadingPlace> changedReading(const PositioningMeasurement &was,
                                           const PositioningMeasurement &is) {
    if (was.targets.size() != is.targets.size() || was.runs.size() != is.runs.size())
        return std::nullopt;
    const ReadingsAside wasAside(was);
    const ReadingsAside isAside(is);
    for (std::size_t run = 0; run < is.runs.size(); ++run) {
        for (std::size_t target = 0; target < is.targets.size(); ++target) {
            const bool same = readingAt(was, {run, target}) == readingAt(is, {run, target}) &&
                              (wasAside.at(run, target) == nullptr) == (isAside.at(run, target) == nullptr);
            if (!same)
                return ReadingPlace{run, target};
        }
    }
    return std::nullopt;
}

/// The first target whose position differs; null if their number differs or none does.
std::optional<std::size_t> changedTarget(const PositioningMeasurement &was,
                                         const PositioningMeasurement &is) {
    if (was.targets.size() != is.targets.size())
        return std::nullopt;
    const auto [old, now] = std::ranges::mismatch(was.targets, is.targets);
    return now == is.targets.end() ? std::nullopt
                                   : std::optional(static_cast<std::size_t>(now - is.targets.begin()));
}

/// The first arc point that differs; null if the number of arcs or points differs.
std::optional<ReadingPlace> changedPoint(const CircularMeasurement &was, const CircularMeasurement &is) {
    if (was.arcs.size() != is.arcs.size())
        return std::nullopt;
    for (std::size_t arc = 0; arc < is.arcs.size(); ++arc) {
        const Arc &old = was.arcs[arc];
        const Arc &now = is.arcs[arc];
        if (old.angles.size() != now.angles.size())
            return std::nullopt;
        const auto angle = std::ranges::mismatch(old.angles, now.angles).in2 - now.angles.begin();
        const auto deviation = std::ranges::mismatch(old.radialDeviations, now.radialDeviations).in2 -
                               now.radialDeviations.begin();
        const auto point = static_cast<std::size_t>(std::min(angle, deviation));
        if (point < now.angles.size())
            return ReadingPlace{arc, point};
    }
    return std::nullopt;
}

/// The first point whose agreement differs.
std::optional<QString> changedAgreement(const Test &before, const Test &after) {
    const auto differs = [](const std::vector<AgreedPoint> &all, const AgreedPoint &one) {
        return std::ranges::find(all, one) == all.end();
    };
    for (const auto &[some, others] : {std::pair(&after.agreedPoints, &before.agreedPoints),
                                       std::pair(&before.agreedPoints, &after.agreedPoints)}) {
        for (const AgreedPoint &one : *some) {
            if (differs(*others, one))
                return QStringLiteral("agreedPoints.") + QString::fromStdString(one.point);
        }
    }
    return std::nullopt;
}

/// The page whose labels have that translation context.
std::optional<Page> pageOfContext(const QString &context) {
    static const std::map<QString, Page> pages{
        {QStringLiteral("palmer::ui::ConditionsPage"), Page::conditions},
        {QStringLiteral("palmer::ui::AgreedPointsPage"), Page::agreedPoints},
        {QStringLiteral("palmer::ui::LimitsPage"), Page::limits},
        {QStringLiteral("palmer::ui::UncertaintyPage"), Page::uncertainty},
        {QStringLiteral("palmer::ui::IdentificationPage"), Page::identification},
        {QStringLiteral("palmer::ui::MachinePage"), Page::machine},
        {QStringLiteral("palmer::ui::InstrumentsPage"), Page::instruments},
        {QStringLiteral("palmer::ui::SheetPage"), Page::sheet}};
    const auto found = pages.find(context);
    return found == pages.end() ? std::nullopt : std::optional(found->second);
}

int tabOf(Page page) {
    const auto found = std::ranges::find(testPages, page, &TestPage::page);
    return found == testPages.end() ? -1 : static_cast<int>(found - testPages.begin());
}

} // namespace

Workplace::Workplace(DocumentModel &model, Evaluator &evaluator, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_evaluator(evaluator)
    , m_outer(made<ThinSplitter>("outerSplitter", Qt::Horizontal, this))
    , m_side(new QWidget(m_outer))
    , m_inner(made<ThinSplitter>("innerSplitter", Qt::Horizontal, m_outer))
    , m_navigation(new NavigationList(m_navigationModel, m_side))
    , m_addTest(made<QToolButton>("addTestButton", m_side)) {
    setObjectName(QStringLiteral("workplace"));
    setFocusProxy(m_navigation);
    m_centre = makeCentre();
    m_right = new RightSide(m_selection, m_inner);
    m_right->setMinimumWidth(leastRightWidth);
    m_comparisonSide = new ComparisonSide(m_right);
    m_comparison->setSide(m_comparisonSide);
    m_thermal->makeSide(m_right);
    m_figure = m_right->figure();
    m_results = m_right->results();
    m_findings = m_right->findings();
    m_inner->setStretchFactor(0, 1);
    m_inner->setStretchFactor(1, 0);
    m_addTest->setIcon(lineIcon(QStringLiteral("plus")));
    m_addTest->setPopupMode(QToolButton::InstantPopup);
    m_addTest->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_addTest->setFocusPolicy(Qt::TabFocus);
    m_addTest->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    inColumn(m_side, {0, 0, 0, 4}, 4, {{m_navigation, 1}, m_addTest});
    m_outer->setStretchFactor(0, 0);
    m_outer->setStretchFactor(1, 1);
    inColumn(this, noMargins, styleSpacing, {m_outer});
    connectParts();
    retranslate();
}

void Workplace::makePages(QWidget *centre) {
    m_pages = new QStackedWidget(centre);
    m_readingPages = new QStackedWidget(m_pages);
    m_readings = new ReadingsPage(m_model, m_selection, m_readingPages);
    m_circlesPlace = new QScrollArea(m_readingPages); // on low screens the page is higher than its space
    trait::scrollsDown(*m_circlesPlace);
    m_circles = new CirclesPage(m_model, m_selection, m_circlesPlace->viewport());
    m_circles->setAttribute(Qt::WA_StyledBackground);
    m_circles->setProperty("ground", QStringLiteral("base"));
    m_circlesPlace->setWidget(m_circles);
    m_circlesPlace->setFocusProxy(m_circles);
    m_drift = new DriftPage(m_model, m_selection, m_readingPages);
    // in the order of Kind
    for (QWidget *page : std::initializer_list<QWidget *>{m_readings, m_circlesPlace, m_drift})
        m_readingPages->addWidget(page);
    Q_ASSERT(m_readingPages->count() == int(allKinds.size()));
    m_conditions = new ConditionsPage(m_model, m_selection, m_pages);
    m_agreedPoints = new AgreedPointsPage(m_model, m_selection, m_pages);
    m_limits = new LimitsPage(m_model, m_selection, m_pages);
    m_uncertainty = new UncertaintyPage(m_model, m_evaluator, m_selection, m_pages);
    m_comparison = new ComparisonPage(m_model, m_pages);
    m_diagnosis = new DiagnosisPage(m_pages);
    m_thermal = new ThermalPage(m_model, m_pages);
    m_reportPages = new ReportPages(m_model, m_selection, m_pages);
    for (QWidget *page :
         std::initializer_list<QWidget *>{m_readingPages, m_conditions, m_agreedPoints, m_limits,
                                          m_uncertainty, m_comparison, m_diagnosis, m_thermal, m_reportPages})
        m_pages->addWidget(page);
}

// Every part is made with its final parent: reparenting recomputes all styles below it. A splitter adopts
// widgets made with it as parent.
QWidget *Workplace::makeCentre() {
    auto *centre = made<QWidget>("centre", m_inner);
    centre->setAttribute(Qt::WA_StyledBackground);
    centre->setProperty("ground", QStringLiteral("base"));
    centre->setMinimumWidth(centreWidth);
    m_head = new TestHead(centre);
    m_tabs = made<PageTabs>("pageTabs", centre);
    for (std::size_t i = 0; i < testPages.size(); ++i)
        m_tabs->addTab(QString());
    makePages(centre);
    auto *card = new QFrame(centre);
    m_card = card;
    m_target = new TargetCard(m_selection, card);
    m_explanation = new ExplanationCard(m_selection, card);
    card->setObjectName(QStringLiteral("detailCard"));
    inColumn(card, noMargins, styleSpacing, {m_target, m_explanation});
    m_keys = new KeyHints(centre);
    card->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);

    auto *tabRow = inRow(nullptr, {12, 0, 12, 0}, styleSpacing, {m_tabs});
    auto *line = new QFrame(centre);
    line->setProperty("rule", true);
    line->setFixedHeight(1);
    inColumn(centre, noMargins, 0, {m_head, tabRow, line, {m_pages, 1}, m_card, m_keys});
    return centre;
}

void Workplace::connectParts() {
    connect(m_navigation, &NavigationList::pageChosen, this, &Workplace::showPage);
    connect(m_navigation, &NavigationList::testChosen, this, &Workplace::showTest);
    connect(m_tabs, &QTabBar::currentChanged, this, [this](int tab) {
        if (tab >= 0)
            showPage(testPages.at(static_cast<std::size_t>(tab)).page);
    });
    // Queued: the tab first gets the focus from the click.
    connect(
        m_tabs, &QTabBar::tabBarClicked, this,
        [this](int tab) {
            if (tab >= 0)
                focusPage();
        },
        Qt::QueuedConnection);
    connect(m_head, &TestHead::viewChosen, this,
            [this](const QString &edition) { emit viewChosen(m_selection.test(), edition); });
    connect(m_head, &TestHead::editionSet, this,
            [this](const QString &edition) { emit editionSet(m_selection.test(), edition); });
    connect(&m_selection, &Selection::testChanged, this, [this] {
        presentTest();
        presentPage();
    });
    connect(&m_selection, &Selection::pageChanged, this, [this] { presentPage(); });
    connect(&m_selection, &Selection::parameterChanged, this, [this] {
        if (!m_selection.parameter().isEmpty())
            m_right->turnTo(nullptr); // the page explains the parameter
        presentCard();
    });
    connect(&m_selection, &Selection::readingChanged, this, [this] { presentStatus(); });
    connect(&m_selection, &Selection::hoveredChanged, this, [this] { presentStatus(); });
    connect(m_readings, &ReadingsPage::summaryChanged, this, [this](const QString &summary) {
        if (summary.isEmpty())
            presentStatus();
        else
            emit hintChanged(summary);
    });
    connect(m_findings, &FindingsPanel::activated, this, [this](Page page, const QString &id) {
        showPage(page);
        m_selection.setField(id);
    });
    connect(m_agreedPoints, &AgreedPointsPage::nextWanted, this, [this] { showNextMissing(true); });
    connect(m_conditions, &ConditionsPage::likeLastWanted, this, &Workplace::likeLastWanted);
    for (Form *form : std::initializer_list<Form *>{m_conditions, m_limits, m_uncertainty})
        connect(form, &Form::nextWanted, this, [this] { showNextMissing(true); });
    connect(m_reportPages, &ReportPages::nextWanted, this, [this] { showNextMissing(true); });
    connect(m_diagnosis, &DiagnosisPage::pathsWanted, this, [this](const SyntheticPaths &paths) {
        m_figure->setSynthetic(paths);
        if (m_detachedFigure)
            m_detachedFigure->setSynthetic(paths);
    });
    connect(m_diagnosis, &DiagnosisPage::startAngleCorrected, this, [this](double by) {
        m_model.edit(QT_TRANSLATE_NOOP("edits", "correct the start angle"), [&](Document &document) {
            editMeasurement<CircularMeasurement>(
                document, m_selection.test(), [&](CircularMeasurement &circle) { turnAngles(circle, -by); });
        });
    });
    connect(m_right, &RightSide::turned, this, &Workplace::presentTurn);
    connect(m_figure, &FigureView::said, this, &Workplace::hintChanged);
    connect(m_results, &ResultsPanel::findingsWanted, this, &Workplace::showFindings);
    connect(m_results, &ResultsPanel::said, this, &Workplace::hintChanged);
    connect(m_explanation, &ExplanationCard::said, this, &Workplace::hintChanged);
    connect(m_figure, &FigureView::detachWanted, this, &Workplace::detachFigure);
    connect(m_figure, &FigureView::maximiseWanted, this, [this] { setFigureMaximised(!m_maximised); });
    for (QSplitter *splitter : {m_outer, m_inner})
        connect(splitter, &QSplitter::splitterMoved, this, [this] { keepSizes(); });
}

void Workplace::show(const EvaluatedDocument &evaluated) {
    m_evaluated = evaluated;
    if (m_selection.test() >= evaluated.tests.size())
        m_selection.setTest(0);
    if (evaluated.tests.empty() && !isReportPage())
        m_selection.setPage(Page::identification);
    m_navigationModel.show(evaluated);
    present();
}

void Workplace::showPage(Page page) {
    if (tabOf(page) >= 0 && m_evaluated.tests.empty())
        return;
    if (!hasPage(page))
        page = Page::readings;
    commitTyping();
    m_right->turnTo(nullptr);
    m_selection.setPage(page);
    presentPage(); // needed even if the page is the same and only a tab changed
}

void Workplace::showTest(std::size_t test) {
    if (test >= m_evaluated.tests.size())
        return;
    const bool fromReport = isReportPage();
    commitTyping(); // while its test is still in view
    m_right->turnTo(nullptr);
    m_selection.setTest(test);
    if (fromReport)
        showPage(Page::readings);
}

void Workplace::focusPage() {
    if (m_pages->currentWidget() == m_readingPages) {
        m_readingPages->currentWidget()->setFocus();
        return;
    }
    if (Form *form = formInView())
        return form->focusFirst();
    QWidget *page = m_pages->currentWidget();
    const auto isField = [page](const QWidget *widget) {
        return page->isAncestorOf(widget) && widget->isVisible() && widget->isEnabled() &&
               (widget->focusPolicy() & Qt::TabFocus) != 0 &&
               !qobject_cast<const QAbstractButton *>(widget) && !qobject_cast<const QScrollArea *>(widget);
    };
    for (QWidget *widget = page->nextInFocusChain(); widget && widget != page;
         widget = widget->nextInFocusChain()) {
        if (isField(widget)) {
            widget->setFocus(Qt::TabFocusReason);
            return;
        }
    }
}

void Workplace::focusNextPane(bool forward) {
    const std::array<QWidget *, 6> panes{m_navigation, m_tabs, m_pages, m_figure, m_results, m_findings};
    const auto count = static_cast<int>(panes.size());
    const QWidget *focused = window()->focusWidget();
    int now = forward ? -1 : count;
    for (int i = 0; focused && i < count; ++i) {
        if (panes.at(static_cast<std::size_t>(i)) == focused ||
            panes.at(static_cast<std::size_t>(i))->isAncestorOf(focused))
            now = i;
    }
    for (int step = 1; step <= count; ++step) {
        const int next = ((forward ? now + step : now - step) + 2 * count) % count;
        QWidget *pane = panes.at(static_cast<std::size_t>(next));
        m_right->turnTo(m_right->isAncestorOf(pane) ? pane : nullptr);
        if (!pane->isVisible())
            continue;
        if (pane == m_pages)
            return focusPage();
        if (QWidget *part = mainPart(pane))
            return part->setFocus(Qt::TabFocusReason);
    }
}

void Workplace::showChange(const Document &before, const Document &after, const QString &edit) {
    const auto place = editPlace(edit);
    const auto [was, is] =
        std::ranges::mismatch(before.tests, after.tests,
                              [](const TestPointer &a, const TestPointer &b) { return a == b || *a == *b; });
    if (before.tests.size() < after.tests.size()) { // show the first added test
        showTest(static_cast<std::size_t>(is - after.tests.begin()));
        return showPage(Page::readings);
    }
    if (before.tests.size() == after.tests.size()) {
        if (is != after.tests.end()) {
            showTest(static_cast<std::size_t>(is - after.tests.begin()));
            if (!place && (*was)->measurement != (*is)->measurement)
                return showChangedMeasurement(**was, **is);
            const auto agreement = changedAgreement(**was, **is);
            if (agreement && (!place || pageOfContext(place->context) == Page::agreedPoints)) {
                showPage(Page::agreedPoints);
                m_selection.setField(*agreement);
                return;
            }
        }
    }
    const auto page = place ? pageOfContext(place->context) : std::nullopt;
    if (!page)
        return;
    showPage(*page);
    if (Form *form = formInView())
        form->focusLabel(place->label, place->argument);
}

void Workplace::showChangedMeasurement(const Test &before, const Test &after) {
    showPage(Page::readings);
    m_readingPages->currentWidget()->setFocus();
    static_cast<void>(areOfOneKind(before, after, [this](const auto &was, const auto &is) {
        showChanged(was, is);
        return true;
    }));
}

void Workplace::showChanged(const PositioningMeasurement &was, const PositioningMeasurement &is) {
    if (const auto reading = changedReading(was, is))
        m_readings->showReading(*reading);
    else if (const auto target = changedTarget(was, is))
        m_readings->showTarget(*target);
}

void Workplace::showChanged(const CircularMeasurement &was, const CircularMeasurement &is) {
    const auto point = changedPoint(was, is);
    if (!point)
        return;
    m_circles->showPoint(*point);
    if (QWidget *focused = m_circles->focusWidget()) // on low screens the table may be out of view
        m_circlesPlace->ensureWidgetVisible(focused);
}

void Workplace::present() {
    presentTest();
    presentPage();
}

void Workplace::detachFigure() {
    if (!m_detachedFigure) {
        m_detachedFigure = new FigureView(m_selection, this);
        m_detachedFigure->standAlone();
        m_detachedFigure->setObjectName(QStringLiteral("detachedFigure"));
        connect(m_detachedFigure, &FigureView::said, this, &Workplace::hintChanged);
        m_detachedFigure->setWindowTitle(window()->windowTitle());
        m_detachedFigure->resize(m_figure->size() * 3 / 2);
        m_detachedFigure->setLanguage(windowLanguage());
        m_detachedFigure->show(m_evaluated, m_selection.test());
    }
    m_detachedFigure->QWidget::show();
    m_detachedFigure->activateWindow();
}

void Workplace::presentTest() {
    const std::size_t test = m_selection.test();
    m_reportPages->show(m_evaluated);
    if (test >= m_evaluated.tests.size())
        return;
    m_readings->show(m_evaluated, test);
    m_circles->show(m_evaluated, test);
    m_drift->show(m_evaluated, test);
    m_readingPages->setCurrentIndex(static_cast<int>(kind()));
    for (std::size_t i = 1; i < testPages.size(); ++i)
        m_tabs->setTabVisible(static_cast<int>(i), hasPage(testPages.at(i).page));
    if (!hasPage(m_selection.page()))
        m_selection.setPage(Page::readings);
    m_conditions->show(m_evaluated, test);
    m_agreedPoints->show(m_evaluated, test);
    m_limits->show(m_evaluated, test);
    m_uncertainty->show(m_evaluated, test);
    m_comparison->show(m_evaluated, test);
    m_diagnosis->show(m_evaluated, test);
    m_thermal->show(m_evaluated, test);
    presentResults();
    for (std::size_t i = 0; i < testPages.size(); ++i)
        m_tabs->setCount(static_cast<int>(i), countMissing(m_evaluated, test, testPages.at(i).page));
    if (wantsStack() != m_right->isTabbed() || width() < stackedBelow)
        arrange();
    restoreSizes();
    presentStatus();
}

/// Results are shown with the data they were computed from until there are newer ones.
void Workplace::presentResults() {
    std::size_t test = m_selection.test();
    const std::string &id = m_evaluated.document->tests[test]->id;
    const bool pending = m_evaluated.isPending(test);
    m_right->setComputing(pending);
    m_right->setHasResults(traitsOf(kind()).isJudged);
    if (pending && id == m_resultsOf)
        return;
    m_resultsOf = id;
    if (pending)
        test = m_evaluated.tests.size(); // no results yet
    m_target->show(m_evaluated, test);
    m_keys->show(m_evaluated, test);
    m_explanation->show(m_evaluated, test);
    m_figure->show(m_evaluated, test);
    if (m_detachedFigure)
        m_detachedFigure->show(m_evaluated, test);
    m_results->show(m_evaluated, test);
    m_findings->show(m_evaluated, test);
    emit lackChanged(m_findings->lack());
}

std::vector<SearchEntry> Workplace::searchEntries() {
    std::vector<SearchEntry> entries;
    for (Form *form : findChildren<Form *>()) {
        const Page page = form->pageShown();
        if (tabOf(page) >= 0 && !hasPage(page))
            continue;
        for (const Form::Found &found : form->found())
            entries.push_back({SearchGroup::fields, found.name,
                               found.isMissing ? tr("not stated") : found.value,
                               FindingsModel::pageName(page),
                               [this, page, form, field = found.field] {
                                   showPage(page);
                                   if (field)
                                       form->focusPart(*field);
                               },
                               found.isMissing});
    }
    const std::size_t test = m_selection.test();
    if (test >= m_evaluated.tests.size())
        return entries;
    const TestEvaluation &evaluation = *m_evaluated.tests[test];
    if (hasPage(Page::agreedPoints)) {
        for (const AgreedPointsPage::Found &point : m_agreedPoints->found())
            entries.push_back({SearchGroup::fields, point.name,
                               point.isMissing ? tr("not stated") : point.value,
                               FindingsModel::pageName(Page::agreedPoints),
                               [this, id = point.id] {
                                   showPage(Page::agreedPoints);
                                   m_selection.setField(id);
                               },
                               point.isMissing});
    }
    for (const Parameter &parameter : evaluation.parameters) {
        const QString value = parameter.value
                                  ? windowLanguage().quantity(*parameter.value, parameter.term.quantity, 1)
                                  : QStringLiteral("–");
        entries.push_back(
            {SearchGroup::results,
             QStringLiteral("%1 · %2").arg(QString::fromStdString(plainSymbol(parameter)),
                                           windowLanguage().text(parameter.term.name)),
             value, FindingsModel::tr("Results"),
             [this, id = QString::fromStdString(parameterId(parameter))] { m_selection.setParameter(id); }});
    }
    for (const Finding &finding : evaluation.findings) {
        const Page page = pageOf(finding, *m_evaluated.document);
        entries.push_back({SearchGroup::findings, findingText(finding, windowLanguage()),
                           clauseText(finding.clause, windowLanguage()), FindingsModel::pageName(page),
                           [this, page, id = fieldOf(finding)] {
                               showPage(page);
                               m_selection.setField(id);
                           }});
    }
    return entries;
}

bool Workplace::isReportPage() const {
    return tabOf(m_selection.page()) < 0;
}

void Workplace::presentPage() {
    const Page page = m_selection.page();
    const int tab = tabOf(page);
    m_tabs->setVisible(tab >= 0);
    if (tab >= 0) {
        m_tabs->setCurrentIndex(tab);
        m_pages->setCurrentIndex(tab);
        if (m_selection.test() < m_evaluated.tests.size())
            m_head->show(m_evaluated, m_selection.test());
        m_navigation->setCurrentRow(m_navigationModel.indexOfTest(m_selection.test()));
    } else {
        m_pages->setCurrentWidget(m_reportPages);
        m_reportPages->showPage(page, m_tabs);
        const QModelIndex row = m_navigationModel.indexOf(page);
        m_head->showTitle(row.data().toString(), m_reportPages->subtitle());
        m_navigation->setCurrentRow(row);
    }
    m_findings->setPage(page);
    m_right->setVisible(page != Page::sheet); // whose rows need the width, and are no test's
    m_right->setInstead(page == Page::comparison ? m_comparisonSide
                        : page == Page::thermal  ? m_thermal->side()
                                                 : nullptr);
    presentCard();
    presentStatus();
}

void Workplace::presentCard() {
    const bool explains = !m_selection.parameter().isEmpty();
    const bool wanted = explains || (m_selection.page() == Page::readings && traitsOf(kind()).hasTargets);
    // The same height for both, so that nothing above moves when a result is explained.
    const bool stacked = m_right->isTabbed();
    const bool hasRoom = height() >= (stacked ? stackedFrom : noCardBelow);
    const bool hasRoomForKeys = height() >= (stacked ? stackedFrom : noKeysBelow);
    const bool readings = m_selection.page() == Page::readings && traitsOf(kind()).hasTargets;
    m_card->setMinimumHeight(readings && hasRoom ? m_target->sizeHint().height() : 0);
    m_explanation->setVisible(explains);
    m_target->setVisible(!explains);
    m_card->setVisible(wanted && (explains || hasRoom) && !m_maximised);
    m_keys->setVisible(readings && hasRoomForKeys && !m_maximised);
}

void Workplace::presentStatus() {
    const std::size_t index = m_selection.test();
    if (index >= m_evaluated.tests.size())
        return;
    if (m_selection.page() == Page::sheet) { // no test's
        emit contentChanged({});
        return emit hintChanged({});
    }
    std::visit([this](const auto &measurement) { presentStatusOf(measurement); },
               m_evaluated.document->tests[index]->measurement);
}

void Workplace::presentStatusOf(const DriftMeasurement &measurement) {
    const auto readings = static_cast<int>(measurement.times.size());
    emit contentChanged(withGroups(tr("%n reading(s)", nullptr, readings), readings));
    emit hintChanged({});
}

void Workplace::presentStatusOf(const PositioningMeasurement &measurement) {
    const auto targetCount = static_cast<int>(measurement.targets.size());
    const QString targets = withGroups(tr("%n target(s)", nullptr, targetCount), targetCount);
    // As counted by the table: a run goes one way and back.
    const auto up =
        static_cast<int>(std::ranges::count(measurement.runs, Direction::positive, &Run::approach));
    const auto down = static_cast<int>(measurement.runs.size()) - up;
    const QString runs = up == down  ? withGroups(tr("%n run(s) each way", nullptr, up), up)
                         : down == 0 ? withGroups(tr("%n run(s) ↑", nullptr, up), up)
                         : up == 0   ? withGroups(tr("%n run(s) ↓", nullptr, down), down)
                                     : tr("runs: %1 ↑, %2 ↓").arg(up).arg(down);
    emit contentChanged(targets + QStringLiteral(" · ") + runs);
    const auto place = m_selection.hovered() ? m_selection.hovered() : m_selection.reading();
    if (m_selection.page() != Page::readings || !place || place->run >= measurement.runs.size() ||
        place->target >= measurement.runs[place->run].deviations.size()) {
        emit hintChanged({});
        return;
    }
    const Run &run = measurement.runs[place->run];
    const auto count = std::count_if(measurement.runs.begin(),
                                     measurement.runs.begin() + static_cast<std::ptrdiff_t>(place->run) + 1,
                                     [&](const Run &other) { return other.approach == run.approach; });
    const QString arrow = run.approach == Direction::positive ? QStringLiteral("↑") : QStringLiteral("↓");
    const Quantity quantity = deviationQuantity(measurement.axis);
    const auto &value = run.deviations[place->target];
    QString hint =
        tr("target %1, run %2 %3: %4")
            .arg(place->target + 1)
            .arg(count)
            .arg(arrow, value ? windowLanguage().quantity(*value, quantity, readingDecimals(measurement))
                              : tr("no reading"));
    if (const auto next = nextInCycle(measurement, *place); next && !m_selection.hovered())
        hint += QStringLiteral(" · ") + tr("next: target %1").arg(next->target + 1);
    emit hintChanged(hint);
}

void Workplace::presentStatusOf(const CircularMeasurement &measurement) {
    int points = 0;
    for (const Arc &arc : measurement.arcs)
        points += static_cast<int>(arc.angles.size());
    emit contentChanged(tr("%n arc(s)", nullptr, static_cast<int>(measurement.arcs.size())) +
                        QStringLiteral(" · ") + withGroups(tr("%n point(s)", nullptr, points), points));
    const auto place = m_selection.hovered() ? m_selection.hovered() : m_selection.reading();
    const bool exists = place && place->run < measurement.arcs.size() &&
                        place->target < measurement.arcs[place->run].angles.size();
    if (!exists)
        return emit hintChanged({});
    const QString read = pointText(measurement, place->run, place->target, windowLanguage());
    const QString drawn = m_figure->deviationText(*place); // relative to another centre the number differs
    emit hintChanged(drawn.isEmpty() ? read : tr("%1 · in the figure %2").arg(read, drawn));
}

bool Workplace::undoTyping() {
    const QWidget *focused = window()->focusWidget();
    auto *field = focused ? qobject_cast<Field *>(focused->parentWidget()) : nullptr;
    if (field)
        return field->undoRefused();
    if (m_readings->isAncestorOf(focused))
        return m_readings->undoRefused();
    if (m_drift->isAncestorOf(focused))
        return m_drift->undoRefused();
    return m_circles->isAncestorOf(focused) && m_circles->undoRefused();
}

QStringList Workplace::refusedTexts() const {
    QStringList texts = m_readings->refusedTexts() + m_circles->refusedTexts() + m_drift->refusedTexts() +
                        m_agreedPoints->refusedTexts() + m_comparison->refusedTexts();
    for (const Form *form : findChildren<Form *>())
        texts += form->refusedTexts();
    return texts;
}

Form *Workplace::formInView() const {
    return qobject_cast<Form *>(isReportPage() ? m_reportPages->currentWidget() : m_pages->currentWidget());
}

std::map<Page, QStringList> Workplace::missingFields() const {
    std::map<Page, QStringList> missing;
    const std::size_t test = m_selection.test();
    if (test >= m_evaluated.tests.size())
        return missing;
    for (const Finding &finding : m_evaluated.tests[test]->findings) {
        if (lackOf(finding) == Lack::required)
            missing[pageOf(finding, *m_evaluated.document)] += fieldOf(finding);
    }
    return missing;
}

bool Workplace::showNextMissingHere(const std::map<Page, QStringList> &missing, bool forward) {
    if (Form *form = formInView()) // field by field, as several may be missing under one name
        return form->focusNextRequired(forward);
    const auto here = missing.find(m_selection.page());
    if (here == missing.end())
        return false;
    const QStringList &ids = here->second;
    const qsizetype now = ids.indexOf(m_selection.field());
    const qsizetype first = forward ? 0 : ids.size() - 1;
    const qsizetype next = now < 0 ? first : now + (forward ? 1 : -1);
    if (next < 0 || next >= ids.size())
        return false;
    m_selection.setField(ids[next]);
    return true;
}

bool Workplace::showNextMissing(bool forward) {
    const std::map<Page, QStringList> missing = missingFields();
    if (missing.empty())
        return false;
    // First on the page in view, so that the focus does not jump between pages.
    const Page page = m_selection.page();
    if (showNextMissingHere(missing, forward))
        return true;
    // Then on the next page that lacks something, cyclically.
    auto next = forward ? missing.upper_bound(page) : missing.lower_bound(page);
    if (forward && next == missing.end())
        next = missing.begin();
    else if (!forward)
        next = std::prev(next == missing.begin() ? missing.end() : next);
    showPage(next->first);
    if (Form *form = formInView()) {
        form->startOver();
        if (form->focusNextRequired(forward))
            return true;
    }
    m_selection.setField(forward ? next->second.front() : next->second.back());
    return true;
}

void Workplace::setTestActions(const QList<QAction *> &add, const QList<QAction *> &change, QAction *report) {
    m_addTest->addActions(add);
    m_navigation->addActions(change);
    for (QWidget *menu :
         std::initializer_list<QWidget *>{m_navigation, m_figure, m_results->findChild<QAbstractItemView *>(),
                                          m_findings->findChild<QAbstractItemView *>()})
        menu->addAction(report);
    m_navigation->setContextMenuPolicy(Qt::ActionsContextMenu);
    QList<QAction *> ofReading;
    for (QAction *action : m_readings->editActions()) {
        static const QStringList names{QStringLiteral("copyReadings"), QStringLiteral("setAside"),
                                       QStringLiteral("bringBack")};
        if (names.contains(action->objectName()))
            ofReading << action;
    }
    m_target->addStripActions(ofReading);
}

QString Workplace::anchorInReport() const {
    const bool findings = m_findings->isAncestorOf(window()->focusWidget());
    return (findings ? QStringLiteral("findings-%1") : QStringLiteral("test-%1")).arg(m_selection.test() + 1);
}

void Workplace::showFindings() {
    if (isReportPage())
        showPage(Page::readings);
    m_findings->setFolded(false);
    m_right->turnTo(m_findings);
    mainPart(m_findings)->setFocus(Qt::OtherFocusReason);
}

void Workplace::beginTyping() {
    const std::size_t test = m_selection.test();
    if (test >= m_evaluated.tests.size())
        return;
    showPage(Page::readings);
    if (const auto *measurement = measured<PositioningMeasurement>(m_evaluated, test))
        m_selection.setReading(firstMissing(*measurement));
    m_readingPages->currentWidget()->setFocus();
}

void Workplace::setFigureMaximised(bool maximised) {
    if (m_maximised == maximised)
        return;
    m_maximised = maximised;
    m_side->setVisible(!maximised);
    m_right->setMaximised(maximised);
    presentTurn();
    presentCard();
}

/// Shows the page unless the figure is maximised or another tab is chosen.
void Workplace::presentTurn() {
    const bool page = !m_maximised && (!m_right->isTakingTurns() || m_right->leavesToPage());
    if (const QWidget *focused = window()->focusWidget();
        !page && !m_maximised && focused && m_centre->isAncestorOf(focused))
        m_right->setFocus(); // otherwise it would go to the neighbour of the hidden widget
    m_centre->setVisible(page);
    if (m_right->leavesToPage())
        restoreSizes();
}

/// Minimum size of the smallest arrangement, not of the current one.
QSize Workplace::minimumSizeHint() const {
    const QSize now = QWidget::minimumSizeHint();
    return m_right->isTakingTurns() ? now : now.boundedTo(least);
}

void Workplace::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    arrange();
}

void Workplace::arrange() {
    const bool rail = width() < railBelow;
    const bool stacked = wantsStack();
    const bool narrow = width() < stackedBelow && !stacked;
    const int more = viewOf(kind()).more;
    m_centre->setMinimumWidth(narrow ? narrowCentreWidth + more : centreWidth);
    m_right->setMinimumWidth(stacked ? 0 : narrow ? narrowRightWidth - more : leastRightWidth);
    if (rail != m_navigation->isRail() || m_side->maximumWidth() > NavigationList::fullWidth * 2) {
        m_navigation->setRail(rail);
        m_addTest->setToolButtonStyle(rail ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
        m_side->setMinimumWidth(rail ? NavigationList::railWidth : 120);
        m_side->setMaximumWidth(rail ? NavigationList::railWidth : NavigationList::fullWidth * 2);
        restoreNavigation();
    }
    m_results->setNarrow(rail);
    if (stacked != m_right->isTabbed()) {
        m_inner->setOrientation(stacked ? Qt::Vertical : Qt::Horizontal);
        m_right->setTabbed(stacked);
        m_sizesOf.clear();
    }
    const bool turns = stacked && height() < turnsBelow;
    if (turns != m_right->isTakingTurns()) {
        m_head->setLow(turns);
        m_right->setTakingTurns(turns);
        presentTurn();
        m_sizesOf.clear();
    }
    m_tabs->setLow(turns && height() < lowTabsBelow);
    m_right->setLow(turns && height() < lowTabsBelow);
    restoreSizes(); // if they differ now: stacked, wide
    m_findings->setFolded(!stacked && height() < foldBelow);
    // By window size only, so that nothing moves when the number of findings changes.
    m_findings->setRows(width() < wideFrom ? leastFindings
                                           : std::clamp(height() / heightOfAFinding - 6, leastFindings, 8));
    presentCard();
}

/// True if the figure goes below the centre.
bool Workplace::wantsStack() const {
    const bool beside = width() >= besideFrom && height() < stackedFrom;
    return width() < stackedBelow && !beside;
}

Kind Workplace::kind() const {
    const std::size_t test = m_selection.test();
    return test < m_evaluated.tests.size() ? kindOf(*m_evaluated.document->tests[test]) : Kind::positioning;
}

bool hasPage(Kind kind, Page page) {
    const auto isOneOf = [page](std::span<const Page> pages) {
        return std::ranges::find(pages, page) != pages.end();
    };
    if (tabOf(page) < 0 || page == Page::readings) // a page of the report belongs to all
        return true;
    return isOneOf(viewOf(kind).ownPages) || (traitsOf(kind).isJudged && isOneOf(judgedPages));
}

QString Workplace::sizesKey() const {
    return QStringLiteral("sizes/%1%2")
        .arg(QLatin1StringView(viewOf(kind()).sizes), m_right->isTabbed()   ? QStringLiteral("-stacked")
                                                      : width() >= wideFrom ? QStringLiteral("-wide")
                                                                            : QString());
}

void Workplace::restoreSizes() {
    if (m_right->isTakingTurns()) {
        m_inner->setSizes({m_inner->height(), 0}); // only the tab bar below the page
        return;
    }
    const QString key = sizesKey();
    const bool wide = width() >= wideFrom;
    const bool known = key == m_sizesOf;
    if (known && !wide)
        return;
    m_sizesOf = key;
    const QByteArray kept = QSettings().value(key).toByteArray();
    if (known && !kept.isEmpty())
        return;
    if (!known)
        restoreNavigation();
    const bool stacked = m_right->isTabbed();
    if (!kept.isEmpty()) {
        const int right = kept.toInt();
        m_inner->setSizes({(stacked ? m_inner->height() : m_inner->width()) - right, right});
    } else if (stacked) {
        m_inner->setSizes({m_inner->height() * 3 / 5, m_inner->height() * 2 / 5});
    } else {
        const int whole = width() - m_side->width(); // shared by both
        const int right = wide ? whole * wideShare / 100 : rightWidth;
        m_inner->setSizes({std::max(m_centre->minimumWidth(), whole - right), right});
    }
}

void Workplace::restoreNavigation() {
    const bool rail = m_navigation->isRail();
    const int kept = QSettings().value(navigationKey(), NavigationList::fullWidth).toInt();
    const int side =
        rail ? NavigationList::railWidth : std::clamp(kept, m_side->minimumWidth(), m_side->maximumWidth());
    m_outer->setSizes({side, std::max(m_centre->minimumWidth(), width() - side)});
}

QString Workplace::navigationKey() const {
    return QStringLiteral("sizes/navigation-") + QLatin1StringView(viewOf(kind()).sizes);
}

void Workplace::keepSizes() const {
    if (m_maximised || m_right->isTakingTurns())
        return;
    QSettings().setValue(sizesKey(), QByteArray::number(m_inner->sizes().value(1)));
    if (!m_navigation->isRail())
        QSettings().setValue(navigationKey(), m_outer->sizes().value(0));
}

void Workplace::retranslate() {
    setAccessibleName(tr("Test report"));
    m_addTest->setText(tr("Test"));
    nameWidget(*m_addTest, tr("Add a test"));
    m_tabs->setAccessibleName(tr("Pages of the test"));
    for (std::size_t i = 0; i < testPages.size(); ++i)
        m_tabs->setTabText(static_cast<int>(i), tr(testPages.at(i).text));
    const Language &language = windowLanguage();
    m_readings->setLanguage(language);
    m_circles->setLanguage(language);
    m_drift->setLanguage(language);
    m_conditions->setLanguage(language);
    m_agreedPoints->setLanguage(language);
    m_limits->setLanguage(language);
    m_uncertainty->setLanguage(language);
    m_diagnosis->setLanguage(language);
    m_target->setLanguage(language);
    m_keys->setLanguage(language);
    m_explanation->setLanguage(language);
    m_figure->setLanguage(language);
    if (m_detachedFigure)
        m_detachedFigure->setLanguage(language);
    m_results->setLanguage(language);
    m_findings->setLanguage(language);
    m_navigationModel.retranslate();
    if (m_evaluated.document)
        present();
}

} // namespace palmer::ui
