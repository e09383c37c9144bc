// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figures/figureview.h"

#include "document/savedocument.h"
#include "document/testfile.h"
#include "document/thermal.h"
#include "figures/figuretexts.h"
#include "figures/testfigures.h"
#include "figures/thinning.h"
#include "kernel/evaluation/correctionto20.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "print/figures/exportfigure.h"
#include "report/explanations/explanation.h"
#include "report/tables/readingtable.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/figures/circlefigureview.h"
#include "ui/figures/zoombuttons.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/ruling.h"
#include "ui/saving.h"
#include "ui/theme.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDrag>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <array>

namespace palmer::ui {

namespace {

/// Number of readings per target in a direction: "5", or "1 … 2" during entry.
QString countText(const PositioningResults &results, DirectionStatistics TargetStatistics::*direction) {
    const auto count = [direction](const TargetStatistics &target) { return (target.*direction).n; };
    const auto [least, most] = std::ranges::minmax_element(results.targets, {}, count);
    if (least == results.targets.end())
        return QStringLiteral("0");
    return count(*least) == count(*most) ? QString::number(count(*most))
                                         : QStringLiteral("%1 … %2").arg(count(*least)).arg(count(*most));
}

constexpr int tightWidth = 520;
constexpr int clipboardDotsPerInch = 200;
constexpr std::size_t drawnAtOnce = 50'000; ///< readings; figures of more are made in the background

// Readings the pointer can find in a test's curves.

FigureReadings readingsIn(std::shared_ptr<const CurveFigure> figure,
                          const PositioningMeasurement &measurement) {
    return {std::move(figure), measurement};
}

FigureReadings readingsIn(std::shared_ptr<const CurveFigure> figure, const auto & /*measurement*/) {
    return FigureReadings(std::move(figure));
}

// Label of a reading in a figure of curves.

QString labelOf(const PositioningMeasurement &measurement, const ReadingPlace &place,
                const Language &language) {
    if (place.run >= measurement.runs.size() || place.target >= measurement.targets.size())
        return {};
    return ReadingTexts(measurement, language, ReadingUnit::deviations).label(place.run, place.target);
}

QString labelOf(const DriftMeasurement &drift, const ReadingPlace &place, const Language &language) {
    if (place.target >= drift.times.size())
        return {};
    constexpr std::size_t sample = 1000; // readings that show how many decimals were taken
    constexpr int mostDecimals = 4;
    const auto &values = mainChannel(drift).values;
    const Quantity quantity = deviationQuantity(drift);
    int decimals = 0;
    for (std::size_t i = 0; i < std::min(values.size(), sample); ++i)
        decimals = std::max(decimals, values[i] ? decimalsOf(*values[i], quantity) : 0);
    const std::optional<double> value = values.at(place.target);
    return language.quantity(drift.times[place.target], Quantity::time) + QStringLiteral(" · ") +
           (value ? language.quantity(*value, quantity, std::min(decimals, mostDecimals)) : QString());
}

QString labelOf(const auto & /*measurement*/, const ReadingPlace & /*place*/, const Language & /*language*/) {
    return {};
}

/// The figure in these ranges, or whole; large ones are thinned to what a screen resolves.
CurveFigure figureIn(const CurveFigure &whole, const std::optional<std::array<Interval, 2>> &ranges,
                     const Language &language) {
    const bool isLarge = !isOrdinary(whole);
    if (!ranges)
        return isLarge ? thinned(whole) : whole;
    CurveFigure figure = withRanges(whole, (*ranges)[0], (*ranges)[1], language);
    return isLarge ? thinned(figure) : figure;
}

/// Hides the marks; the pointer still finds the readings.
CurveFigure withoutReadings(CurveFigure figure) {
    figure.readings = {};
    std::erase_if(figure.legend,
                  [](const LegendEntry &entry) { return entry.sample == LegendSample::readings; });
    return figure;
}

} // namespace

FigureView::FigureView(Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_selection(selection)
    , m_title(new ElidedLabel(this))
    , m_note(made<ElidedLabel>("figureNote", trait::secondary, this))
    , m_canvas(new FigureCanvas(selection, this))
    , m_circles(new CircleFigureView(selection, this))
    , m_marks(iconButton(this, QStringLiteral("readingMarks"), QStringLiteral("dots")))
    , m_zoom(new ZoomButtons(this))
    , m_copy(iconButton(this, QStringLiteral("copyFigure"), QStringLiteral("copy")))
    , m_save(iconButton(this, QStringLiteral("saveFigure"), QStringLiteral("save")))
    , m_detach(iconButton(this, QStringLiteral("detachFigure"), QStringLiteral("detach")))
    , m_maximise(iconButton(this, QStringLiteral("maximiseFigure"), QStringLiteral("maxi"))) {
    setObjectName(QStringLiteral("figureView"));
    m_note->setSeparator(QStringLiteral(" · "));
    m_marks->setCheckable(true);
    m_marks->setChecked(m_readingMarks);
    connect(m_marks, &QToolButton::toggled, this, [this](bool on) {
        m_readingMarks = on;
        m_circles->setContacts(on);
        refresh();
    });
    connect(m_zoom, &ZoomButtons::zoomWanted, this, &FigureView::zoomBy);
    connect(m_zoom, &ZoomButtons::fitWanted, this, &FigureView::fit);
    connect(m_copy, &QToolButton::clicked, this, &FigureView::copy);
    connect(m_save, &QToolButton::clicked, this, &FigureView::askWhereToSave);
    connect(m_detach, &QToolButton::clicked, this, &FigureView::detachWanted);
    connect(m_maximise, &QToolButton::clicked, this, &FigureView::maximiseWanted);
    connect(m_canvas, &FigureCanvas::rangesWanted, this, &FigureView::showRanges);
    connect(m_canvas, &FigureCanvas::fitWanted, this, &FigureView::fit);
    connect(m_circles, &CircleFigureView::figureChanged, this, &FigureView::refreshCircles);
    connect(&selection, &Selection::hoveredChanged, this, &FigureView::showHoverLabel);
    connect(&selection, &Selection::parameterChanged, this, &FigureView::mark);

    auto *head = inRow(
        2, {m_title, Placed::gap(8), {m_note, 1}, m_marks, m_zoom, m_copy, m_save, m_detach, m_maximise});
    inColumn(this, {pageMargin, 2, 6, 2}, 2, {head, {m_canvas, 1}, {m_circles, 1}});
    m_circles->hide();
    for (QWidget *handle : std::initializer_list<QWidget *>{m_title, m_copy})
        handle->installEventFilter(this);
    m_title->setCursor(Qt::OpenHandCursor);
    setContextMenuPolicy(Qt::ActionsContextMenu);
    for (QToolButton *button : {m_copy, m_save, m_detach, m_maximise}) {
        auto *action = new QAction(button->icon(), {}, button);
        connect(action, &QAction::triggered, button, &QToolButton::click);
        addAction(action);
    }
    actions().first()->setShortcut(QKeySequence::Copy);
    actions().first()->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    retranslate();
}

/// In a narrow panel the buttons shrink to leave space for the title.
void FigureView::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    const bool tight = width() < tightWidth;
    if (m_copy->property("tight").toBool() == tight)
        return;
    for (QToolButton *button : findChildren<QToolButton *>()) {
        if (button->property("iconOnly").toBool())
            setStyled(*button, "tight", tight);
    }
}

void FigureView::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const bool other = test != m_test;
    m_evaluated = evaluated;
    m_test = test;
    if (other)
        forget(); // each test has its own zoom
    retranslate();
}

void FigureView::setLanguage(const Language &language) {
    m_language = language;
    m_circles->setLanguage(language);
    retranslate();
}

void FigureView::setSynthetic(const SyntheticPaths &paths) {
    m_circles->setSynthetic(paths);
}

void FigureView::standAlone() {
    setWindowFlag(Qt::Window);
    setAttribute(Qt::WA_DeleteOnClose);
    m_detach->hide();
    m_maximise->hide();
}

std::optional<CurveFigure> FigureView::figure() const {
    return m_shown;
}

void FigureView::refresh() {
    const Test *test = shownTest();
    const bool circular = showsCircles();
    const bool curves = test && !circular;
    m_making.cancel();
    m_zooming.cancel();
    for (QWidget *button : std::initializer_list<QWidget *>{m_zoom, m_copy, m_save, m_detach, m_maximise})
        button->setEnabled(test);
    m_marks->setVisible(!test || isJudged(*test));
    m_marks->setEnabled(test);
    m_circles->setVisible(circular);
    m_canvas->setVisible(!circular);
    if (curves)
        return refreshCurves();
    forget();
    if (circular) {
        m_circles->show(m_evaluated, m_test); // emits figureChanged, which calls refreshCircles
        mark();
        return;
    }
    m_circles->clear();
    m_title->clear();
    m_note->clear();
}

void FigureView::forget() {
    m_whole.reset();
    m_shown.reset();
    m_readings = {};
    m_canvas->clear();
}

/// Large tests are drawn in the background; until then the former figure is shown.
void FigureView::refreshCurves() {
    m_circles->clear();
    const TestPointer test = m_evaluated.document->tests[m_test];
    const TestEvaluationPointer evaluation = m_evaluated.tests[m_test];
    const auto make = [test, evaluation, language = m_language, marks = m_readingMarks,
                       zoomed = zoomedRanges()] {
        return contentOf(*test, *evaluation, language, marks, zoomed);
    };
    if (readingsOf(*test) <= drawnAtOnce)
        return receive(make());
    m_making.start([make](const Background::Job &) { return make(); },
                   [this, zoomed = zoomedRanges()](Content content) {
                       const auto now = zoomedRanges();
                       receive(std::move(content));
                       if (now && now != zoomed) // the user zoomed meanwhile
                           showRanges((*now)[0], (*now)[1]);
                   });
}

/// Makes the figure as far as the screen resolves it, and the readings the pointer can find.
FigureView::Content FigureView::contentOf(const Test &test, const TestEvaluation &evaluation,
                                          const Language &language, bool marks,
                                          const std::optional<std::array<Interval, 2>> &zoomed) {
    Content content;
    content.whole =
        std::make_shared<const CurveFigure>(std::get<CurveFigure>(figureOfTest(test, evaluation, language)));
    content.readings = std::visit(
        [&](const auto &measurement) { return readingsIn(content.whole, measurement); }, test.measurement);
    if (!marks && isJudged(test))
        content.whole = std::make_shared<const CurveFigure>(withoutReadings(*content.whole));
    content.shown = figureIn(*content.whole, zoomed, language);
    content.sentence = figureSentence(*content.whole, language);
    return content;
}

void FigureView::receive(Content content) {
    m_whole = std::move(content.whole);
    m_readings = std::move(content.readings);
    m_shown = std::move(content.shown);
    m_sentence = std::move(content.sentence);
    showTitle();
    m_canvas->setFigure(*m_shown, m_readings);
    describe();
    mark();
    showHoverLabel();
}

void FigureView::showTitle() {
    withResults(*shownTest(), *m_evaluated.tests[m_test],
                [this](const auto &measurement, const auto &results) { showTitle(measurement, results); });
}

void FigureView::showTitle(const PositioningMeasurement &measurement, const PositioningResults &results) {
    m_title->setText(m_whole->y.quantity);
    const QString up = countText(results, &TargetStatistics::positive);
    const QString down = countText(results, &TargetStatistics::negative);
    QString note = up == down || !results.downward ? QStringLiteral("n = %1").arg(up)
                   : !results.upward               ? QStringLiteral("n = %1").arg(down)
                                                   : QStringLiteral("n = %1 ↑, %2 ↓").arg(up, down);
    if (!m_whole->bands.empty())
        note += QStringLiteral(" · ") +
                tr("band ±%1s")
                    .arg(m_language.number(m_evaluated.tests[m_test]->edition->c, Quantity::number, -1));
    if (measurement.axis.motion == Motion::linear && isCorrectedTo20(measurement.conditions.common))
        note += QStringLiteral(" · ") + tr("at 20 °C");
    m_note->setText(note);
}

void FigureView::showTitle(const DriftMeasurement &drift, const DriftResults &results) {
    m_title->setText(m_whole->title);
    constexpr int decimals = 2;
    m_note->setText(results.range
                        ? QStringLiteral("E_VE = ") +
                              m_language.quantity(*results.range, deviationQuantity(drift), decimals)
                        : QString());
}

void FigureView::showTitle(const CircularMeasurement &measurement, const CircularResults & /*results*/) {
    const auto figure = m_circles->paperFigure();
    if (!figure)
        return;
    m_title->setText(figure->title);
    m_circles->describe(figureSentence(*figure, m_language));
    QStringList note;
    if (isCorrectedTo20(measurement.conditions.common)) // put first, as the last parts are elided
        note << tr("at 20 °C");
    if (measurement.feed)
        note << QStringLiteral("F ") + m_language.quantity(*measurement.feed, Quantity::feed);
    m_note->setText(note.join(QStringLiteral(" · ")));
}

/// Sets the accessible description: the content, then the keys.
void FigureView::describe() {
    m_canvas->setAccessibleName(m_whole->title);
    m_canvas->setAccessibleDescription(m_sentence + QStringLiteral(". ") +
                                       tr("Plus and minus zoom, arrows move, 0 shows the whole; the wheel "
                                          "zooms"));
}

/// The zoomed ranges; null if the whole is shown.
std::optional<std::array<Interval, 2>> FigureView::zoomedRanges() const {
    if (!m_whole || !m_shown ||
        (m_shown->x.from == m_whole->x.from && m_shown->x.to == m_whole->x.to &&
         m_shown->y.from == m_whole->y.from && m_shown->y.to == m_whole->y.to))
        return std::nullopt;
    return std::array{Interval{m_shown->x.from, m_shown->x.to}, Interval{m_shown->y.from, m_shown->y.to}};
}

void FigureView::refreshCircles() {
    if (showsCircles())
        showTitle();
}

const Test *FigureView::shownTest() const {
    return m_test < m_evaluated.tests.size() ? m_evaluated.document->tests[m_test].get() : nullptr;
}

bool FigureView::showsCircles() const {
    const Test *test = shownTest();
    return test && isCircle(*test);
}

QString FigureView::deviationText(const ReadingPlace &point) const {
    return showsCircles() ? m_circles->deviationText(point) : QString();
}

std::optional<FigureView::Leaving> FigureView::leaving() const {
    if (showsCircles()) {
        if (const auto figure = m_circles->paperFigure())
            return Leaving{*figure, figure->title};
        return std::nullopt;
    }
    return m_shown ? std::optional(Leaving{*m_shown, m_shown->title}) : std::nullopt;
}

void FigureView::showRanges(const Interval &x, const Interval &y) {
    if (!m_whole || !m_shown)
        return;
    const std::array<Interval, 2> ranges = rangesWithin(*m_whole, x, y);
    const bool atOnce = readingsOf(*shownTest()) <= drawnAtOnce;
    // A larger test shows at once what is already drawn, then what the range contains.
    m_shown = atOnce ? figureIn(*m_whole, ranges, m_language)
                     : withRanges(*m_shown, ranges[0], ranges[1], m_language);
    m_canvas->setFigure(*m_shown, m_readings);
    m_zooming.cancel();
    if (atOnce)
        return;
    m_zooming.start([whole = m_whole, ranges, language = m_language](
                        const Background::Job &) { return figureIn(*whole, ranges, language); },
                    [this](CurveFigure figure) {
                        m_shown = std::move(figure);
                        m_canvas->setFigure(*m_shown, m_readings);
                    });
}

void FigureView::zoomBy(int steps) {
    if (m_circles->isVisibleTo(this))
        m_circles->zoomBy(steps);
    else
        m_canvas->zoomBy(steps);
}

void FigureView::fit() {
    m_shown.reset();
    m_circles->fit();
    refresh();
}

void FigureView::mark() {
    FigureMarking marking;
    const auto explained =
        explanation(m_evaluated, m_test, m_selection.parameter().toStdString(), m_language);
    if (m_whole && explained && !explained->result.isEmpty()) {
        marking.label = explained->result;
        for (const std::size_t target : rulingTargets(m_evaluated, m_test, m_selection.parameter())) {
            if (target < m_whole->positions.size())
                marking.positions.push_back(m_whole->positions[target]);
        }
        const auto found = std::ranges::find(m_whole->dimensions, m_selection.parameter(), &Dimension::id);
        if (found != m_whole->dimensions.end())
            marking.dimension = *found;
    }
    m_canvas->setMarking(marking);
    m_circles->setMarking(explained ? explained->result : QString(),
                          explained ? explained->points : std::vector<RulingPoint>());
}

void FigureView::showHoverLabel() {
    const Test *test = shownTest();
    const auto place = m_selection.hovered();
    QString label;
    if (test && place)
        label = std::visit([&](const auto &measurement) { return labelOf(measurement, *place, m_language); },
                           test->measurement);
    m_canvas->setHoverLabel(label);
}

QMimeData *FigureView::formatsOf(const Leaving &shown) const {
    auto *mime = new QMimeData;
    mime->setData(QStringLiteral("image/svg+xml"), figureAsSvg(shown.figure, shown.title, m_language));
    mime->setData(QStringLiteral("application/pdf"), figureAsPdf(shown.figure, shown.title));
    mime->setImageData(QImage::fromData(figureAsPng(shown.figure, clipboardDotsPerInch)));
    return mime;
}

void FigureView::copy() {
    const auto shown = leaving();
    if (!shown)
        return;
    QGuiApplication::clipboard()->setMimeData(formatsOf(*shown));
    emit said(tr("Figure copied"));
}

QMimeData *FigureView::dragged() {
    const auto shown = leaving();
    if (!shown)
        return nullptr;
    QMimeData *mime = formatsOf(*shown);
    m_dragFolder = std::make_unique<QTemporaryDir>();
    QString name = shown->title;
    name.replace(
        QRegularExpression(QStringLiteral("[^\\w .,()-]"), QRegularExpression::UseUnicodePropertiesOption),
        QStringLiteral("_"));
    QFile file(m_dragFolder->filePath(name + QStringLiteral(".svg")));
    if (file.open(QIODevice::WriteOnly) && file.write(mime->data(QStringLiteral("image/svg+xml"))) > 0)
        mime->setUrls({QUrl::fromLocalFile(file.fileName())});
    return mime;
}

bool FigureView::eventFilter(QObject *watched, QEvent *event) {
    const auto *mouse = dynamic_cast<const QMouseEvent *>(event);
    if (mouse && mouse->type() == QEvent::MouseButtonPress)
        m_pressed = mouse->globalPosition().toPoint();
    const bool begins = mouse && mouse->type() == QEvent::MouseMove && (mouse->buttons() & Qt::LeftButton) &&
                        (mouse->globalPosition().toPoint() - m_pressed).manhattanLength() >=
                            QApplication::startDragDistance();
    if (QMimeData *mime = begins ? dragged() : nullptr) {
        m_copy->setDown(false);
        auto *drag = new QDrag(this);
        drag->setMimeData(mime);
        drag->setPixmap(m_copy->icon().pixmap(32));
        drag->exec(Qt::CopyAction);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

bool FigureView::saveTo(const QString &path) {
    const auto shown = leaving();
    if (!shown)
        return false;
    const QString suffix = QFileInfo(path).suffix().toLower();
    try {
        requireNoTestFileName(path);
        awaited([&] {
            saveBytes(suffix == QStringLiteral("svg")   ? figureAsSvg(shown->figure, shown->title, m_language)
                      : suffix == QStringLiteral("png") ? figureAsPng(shown->figure)
                                                        : figureAsPdf(shown->figure, shown->title),
                      path);
        });
        saySaved(this, path);
        return true;
    } catch (const Error &error) {
        showError(this, tr("%1 cannot be saved").arg(QFileInfo(path).fileName()), error,
                  QMessageBox::Critical, tr("Save figure"));
        return false;
    }
}

void FigureView::askWhereToSave() {
    const auto shown = leaving();
    if (!shown)
        return;
    auto *dialog = made<SaveDialog>(
        "figureFileDialog", this, tr("Save figure"),
        QStringList{tr("PDF, vectors (*.pdf)"), tr("SVG, vectors (*.svg)"), tr("PNG, picture (*.png)")});
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->selectFile(shown->title + QStringLiteral(".pdf"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString &path) { saveTo(path); });
    dialog->open();
}

void FigureView::retranslate() {
    m_title->setFont(themeFont(TextSize::head));
    m_note->setFont(themeFont(TextSize::small));
    nameWidget(*m_marks,
               showsCircles() ? tr("Show the points that rule the result") : tr("Show single readings"));
    nameWidget(*m_copy, tr("Copy the figure"));
    nameWidget(*m_save, tr("Save the figure as PDF, SVG or PNG"));
    nameWidget(*m_detach, tr("Open the figure in a window of its own"));
    nameWidget(*m_maximise, tr("Maximise the figure"), QStringLiteral("F11"));
    m_canvas->setToolTip({});
    m_title->setToolTip(tr("Drag the figure from here into another program"));
    for (QAction *action : actions()) {
        if (const auto *button = qobject_cast<QToolButton *>(action->parent()))
            action->setText(button->accessibleName());
    }
    refresh();
}

} // namespace palmer::ui
