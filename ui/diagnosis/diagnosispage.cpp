// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnosis/diagnosispage.h"

#include "kernel/diagnosis/sourcewords.h"
#include "kernel/measurement/testfacts.h"
#include "report/tables/diagnosisrows.h"
#include "ui/diagnosis/feedsview.h"
#include "ui/elidedlabel.h"
#include "ui/figures/linechart.h"
#include "ui/figures/zoombuttons.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/rowtable.h"
#include "ui/theme.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <numbers>

namespace palmer::ui {

namespace {

constexpr int diagnosisBarHeight = 38;
constexpr int tickWidth = 26;
constexpr int leastBar = 90;
constexpr int chartHeight = 150;

enum TableColumn { ticks, source, value, expanded, unit, bar, part, columns };

/// A checkbox in the middle of a cell.
QCheckBox *tickBox(QTableWidget &table, int row) {
    auto *cell = new QWidget(&table);
    auto *box = new QCheckBox(cell);
    box->setFocusPolicy(Qt::NoFocus); // the space bar ticks the current row
    inRow(cell, {0, 0, 0, 1}, styleSpacing, {{box, 0, Qt::AlignCenter}});
    table.setCellWidget(row, TableColumn::ticks, cell);
    return box;
}

} // namespace

DiagnosisPage::DiagnosisPage(QWidget *parent)
    : QWidget(parent)
    , m_nature(made<ElidedLabel>("diagnosisNature", TextSize::head, this))
    , m_summary(made<ElidedLabel>("diagnosisSummary", TextSize::small, trait::secondary, this))
    , m_trace(made<QToolButton>("traceSources", trait::checkable, trait::strongFocus, trait::segment("first"),
                                this))
    , m_empty(made<QLabel>("diagnosisEmpty", trait::secondary, trait::wrapped, this)) {
    setObjectName(QStringLiteral("diagnosisPage"));
    auto *head = inRow(nullptr, {pageMargin, 6, pageMargin, 0}, 12, {m_nature, {m_summary, 1}});
    auto *bar = makeBar();
    m_area = new QScrollArea(this);
    trait::scrollsDown(*m_area);
    m_content = new QWidget(m_area->viewport());
    m_content->setAttribute(Qt::WA_StyledBackground);
    m_content->setProperty("ground", QStringLiteral("base"));
    m_table = new RowTable("diagnosisTable", TableColumn::columns, m_content);
    m_table->setFocusPolicy(Qt::StrongFocus);
    m_table->installEventFilter(this);
    m_warnings = made<QLabel>("diagnosisWarnings", trait::plainText, trait::wrapped, m_content);
    m_correct = made<QPushButton>("correctStartAngle", trait::notDefault, m_content);
    m_title = made<QLabel>("sourceTitle", trait::plainText, trait::wrapped, m_content);
    m_text = made<QLabel>("sourceText", trait::plainText, trait::wrapped, m_content);
    m_remarks = made<QLabel>("diagnosisRemarks", trait::plainText, trait::wrapped, m_content);
    for (QLabel *label : {m_title, m_text, m_remarks})
        label->setProperty("secondary", label != m_title);
    inColumn(m_content, {pageMargin, 0, pageMargin, 8}, 4,
             {m_warnings,
              {m_correct, 0, Qt::AlignLeft},
              m_table,
              Placed::gap(6),
              m_title,
              m_text,
              m_remarks,
              {makeBelow(), 1}});
    m_area->setWidget(m_content);
    m_empty->setAlignment(Qt::AlignCenter);
    inColumn(this, noMargins, 0, {head, bar, {m_area, 1}, {m_empty, 1}});
    connect(&m_diagnoser, &Diagnoser::changed, this, [this] {
        refresh();
        trace();
    });
    connect(&m_diagnoser, &Diagnoser::traced, this, [this](const SyntheticPaths &paths) {
        if (isVisible())
            emit pathsWanted(paths);
    });
    connect(m_correct, &QPushButton::clicked, this, [this] {
        m_table->setFocus(); // the button goes: the page would scroll to what follows
        emit startAngleCorrected(diagnosis()->rotation.removed());
    });
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) { showRow(row); });
    retranslate();
}

QToolButton *DiagnosisPage::addSegment(const char *segment, const char *name) {
    return made<QToolButton>(name, trait::checkable, trait::strongFocus, trait::segment(segment), this);
}

QWidget *DiagnosisPage::makeBar() {
    auto *area = new QWidget(this);
    area->setFixedHeight(diagnosisBarHeight);
    auto *row = inRow(area, {pageMargin, 4, pageMargin, 4}, 0, {});
    m_summary->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_summary->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // takes the remaining width
    m_circle = addSegment("first", "diagnosisOfCircle");
    m_feeds = addSegment("last", "diagnosisOfFeeds");
    m_circle->setChecked(true);
    auto *views = new QButtonGroup(this);
    views->addButton(m_circle);
    views->addButton(m_feeds);
    m_trace->setChecked(true);
    m_trace->setIcon(lineIcon(QStringLiteral("circle")));
    m_trace->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    row->addWidget(m_circle);
    row->addWidget(m_feeds);
    row->addStretch();
    row->addWidget(m_trace);
    connect(views, &QButtonGroup::buttonClicked, this, [this] { refresh(); });
    connect(m_trace, &QToolButton::toggled, this, &DiagnosisPage::trace);
    return area;
}

/// Charts of the residual, or of several feeds.
QWidget *DiagnosisPage::makeBelow() {
    auto *area = new QWidget(m_content);
    area->setMinimumHeight(chartHeight);
    m_chartBar = new QWidget(area);
    m_rest = addSegment("first", "showRest");
    m_spectrum = addSegment("last", "showSpectrum");
    m_rest->setChecked(true);
    auto *kinds = new QButtonGroup(this);
    kinds->addButton(m_rest);
    kinds->addButton(m_spectrum);
    m_chartNote = made<ElidedLabel>("chartNote", trait::secondary, area);
    m_chartNote->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // takes the remaining width
    auto *bar = inRow(m_chartBar, {0, 4, 0, 0}, 0, {m_rest, m_spectrum, Placed::gap(8), {m_chartNote, 1}});
    auto *zoom = new ZoomButtons(m_chartBar);
    bar->addWidget(zoom);
    m_overlay = new FeedsView(area);
    m_chart = made<LineChart>("diagnosisChart", area);
    auto *charts = inRow(8, {{m_overlay, 2}, {m_chart, 3}});
    inColumn(area, noMargins, 4, {m_chartBar, {charts, 1}});
    connect(zoom, &ZoomButtons::zoomWanted, m_chart, &LineChart::zoomBy);
    connect(zoom, &ZoomButtons::fitWanted, m_chart, &LineChart::fit);
    connect(kinds, &QButtonGroup::buttonClicked, this, [this] { fillChart(); });
    return area;
}

// ---- What is shown ---------------------------------------------------------------------------------------

void DiagnosisPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    if (test >= evaluated.tests.size() || !isCircle(*evaluated.document->tests[test])) {
        m_evaluated = {};
        return;
    }
    const std::string &id = evaluated.document->tests[test]->id;
    if (id != m_testId) {
        m_ticked.reset();
        m_current.clear();
        m_circle->setChecked(true);
    }
    m_testId = id;
    if (isVisible())
        want();
}

void DiagnosisPage::setLanguage(const Language &language) {
    m_language = language;
    retranslate();
}

void DiagnosisPage::want() {
    if (m_evaluated.tests.empty() || m_evaluated.isPending(m_test))
        return;
    const ShownDiagnosis *before = m_diagnoser.shown();
    m_diagnoser.want(m_evaluated, m_test, m_language);
    if (!before || m_diagnoser.shown() != before)
        refresh(); // show that it is being computed
}

bool DiagnosisPage::isOfFeeds() const {
    return m_feeds->isChecked() && !m_feeds->isHidden();
}

const Diagnosis *DiagnosisPage::diagnosis() const {
    const ShownDiagnosis *shown = m_diagnoser.shown();
    if (!shown || !shown->test)
        return nullptr;
    return isOfFeeds() ? &shown->together : &shown->test->diagnosis;
}

void DiagnosisPage::refresh() {
    const ShownDiagnosis *shown = m_diagnoser.shown();
    const bool several = shown && !shown->atFeeds.empty();
    m_circle->setVisible(several);
    m_feeds->setVisible(several);
    const Diagnosis *found = diagnosis();
    m_trace->setVisible(!isOfFeeds());
    m_trace->setEnabled(found);
    m_area->setVisible(found);
    m_empty->setVisible(!found);
    m_empty->setText(shown ? tr("The evaluated points are too few for a diagnosis.")
                           : tr("The circle is being diagnosed…"));
    m_summary->clear();
    m_rows.clear();
    m_overlay->show({}, {}, m_language);
    if (!found)
        return;
    const auto count = [&](int n) { return m_language.number(n, Quantity::count, 0); };
    m_summary->setText(tr("%1 of %2 parameters told apart · condition %3")
                           .arg(count(found->toldApart), count(found->of),
                                m_language.number(found->condition, Quantity::number, 1)));
    m_rows = diagnosisRows(*found, m_language);
    fillTable();
    fillBelow();
}

QString DiagnosisPage::idOf(std::size_t place) const {
    return QString::fromStdString(sourceId(diagnosis()->sources[place]));
}

/// Centre and radius are not drawn: they define the circle about which the path is drawn.
bool DiagnosisPage::canBeTraced(const DiagnosisRow &row) const {
    return !isOfFeeds() && (row.kind == DiagnosisRowKind::source || row.kind == DiagnosisRowKind::sum);
}

bool DiagnosisPage::isTicked(const DiagnosisRow &row) const {
    if (!canBeTraced(row))
        return false;
    if (m_ticked)
        return m_ticked->contains(idOf(row.sources.front()));
    return std::ranges::find(m_diagnoser.shown()->prevailing, row.sources.front()) !=
           m_diagnoser.shown()->prevailing.end();
}

void DiagnosisPage::fillTable() {
    const QSignalBlocker blocker(m_table);
    const QColor grey = token(Token::secondaryText, palette());
    double largest = 0;
    for (const DiagnosisRow &row : m_rows)
        largest = std::max(largest, row.contribution.value_or(0));
    m_table->clearContents();
    m_table->setRowCount(static_cast<int>(m_rows.size()));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const DiagnosisRow &row = m_rows[i];
        const int at = static_cast<int>(i);
        const bool ticked = isTicked(row);
        m_table->setCell(at, ticks, QString(), false)->setData(RowTable::keyRole, idOf(row.sources.front()));
        if (!isOfFeeds()) {
            QCheckBox *box = tickBox(*m_table, at);
            box->setObjectName(QStringLiteral("trace") + QString::number(i));
            box->setChecked(ticked);
            box->setEnabled(canBeTraced(row));
            box->setAccessibleName(tr("Trace: %1").arg(row.name));
            box->setToolTip(canBeTraced(row) ? box->accessibleName() : row.meaning);
            connect(box, &QCheckBox::toggled, this, [this, i](bool on) { tick(i, on); });
        }
        const QString dash = QStringLiteral("–");
        m_table->setCell(at, source, row.name, false);
        m_table->setCell(at, value, row.value.isEmpty() ? dash : row.value, true);
        m_table->setCell(at, expanded, row.expanded.isEmpty() ? dash : row.expanded, true)
            ->setForeground(grey);
        m_table->setCell(at, unit, row.unit, false)->setForeground(grey);
        auto *picture = m_table->setCell(at, TableColumn::bar, QString(), false);
        if (row.contribution) {
            picture->setData(RowTable::barRole, largest > 0 ? *row.contribution / largest : 0.0);
            picture->setData(RowTable::firstRole, ticked);
        }
        m_table->setCell(
            at, part, row.contribution ? m_language.number(*row.contribution, Quantity::deviation, 1) : dash,
            true);
        for (int column = 0; column < TableColumn::columns; ++column) {
            m_table->item(at, column)->setToolTip(row.meaning);
            if (row.kind == DiagnosisRowKind::notTold)
                m_table->item(at, column)->setForeground(grey);
        }
    }
    m_table->setHead(ticks, QString(), false);
    m_table->setHead(source, tr("Source"), false);
    m_table->setHead(value, tr("value"), true);
    m_table->setHead(expanded, QStringLiteral("± 95\u00A0%"), true);
    m_table->setHead(unit, QString(), false);
    m_table->setHead(TableColumn::bar, tr("part of G(b), %1").arg(m_language.unit(Quantity::deviation)),
                     false);
    m_table->setHead(part, QString(), true);
    m_table->setColumnHidden(ticks, isOfFeeds());
    m_table->item(0, ticks)->setText(QStringLiteral("      ")); // as wide as a checkbox
    m_table->fit(TableColumn::bar, leastBar, {source});
    const int row = std::max(0, m_table->rowOf(m_current));
    m_table->setCurrentCell(row, source);
    showRow(row);
}

std::optional<std::size_t> DiagnosisPage::currentRow() const {
    const int row = m_table->currentRow();
    if (row < 0 || static_cast<std::size_t>(row) >= m_rows.size())
        return std::nullopt;
    return static_cast<std::size_t>(row);
}

void DiagnosisPage::showRow(int at) {
    if (at < 0 || static_cast<std::size_t>(at) >= m_rows.size())
        return;
    const DiagnosisRow &row = m_rows[static_cast<std::size_t>(at)];
    m_current = idOf(row.sources.front());
    m_title->setFont(themeFont(TextSize::head));
    m_title->setText(row.expanded.isEmpty()
                         ? row.name
                         : tr("%1: %2 ± %3 %4", "source, value, half its 95 % interval, unit")
                               .arg(row.name, row.value, row.expanded, row.unit));
    m_text->setText(row.advice.isEmpty() ? row.meaning : row.meaning + u' ' + row.advice);
    if (isOfFeeds())
        fillChart();
}

/// Values stated by the instrument's program, converted to our sign convention.
QStringList DiagnosisPage::statedTexts() const {
    QStringList texts;
    const DiagnosedTest &test = *m_diagnoser.shown()->test;
    for (const StatedSource &row : statedSources(*test.test, test.diagnosis, m_language)) {
        const QString here = row.expanded.isEmpty()
                                 ? QStringLiteral("–")
                                 : QStringLiteral("%1 ± %2 %3").arg(row.here, row.expanded, row.unit);
        texts << tr("The instrument’s program states %1 = %2 %3; here: %4. Positive here: %5")
                     .arg(row.name, row.stated, row.statedUnit, here, row.positive);
    }
    if (!texts.isEmpty())
        texts << tr(
            "Its file states no sign convention: opposite signs throughout may mean the opposite one.");
    return texts;
}

void DiagnosisPage::fillBelow() {
    const ShownDiagnosis &shown = *m_diagnoser.shown();
    const QStringList warnings = diagnosisWarnings(*diagnosis(), m_language);
    m_warnings->setText(warnings.join(u'\n'));
    m_warnings->setVisible(!warnings.isEmpty());
    const Rotation &rotation = diagnosis()->rotation;
    m_correct->setVisible(!isOfFeeds() && rotation.commanded && rotation.isStated());
    m_correct->setText(tr("Correct the start angle by %1")
                           .arg(m_language.quantity(-rotation.removed(), Quantity::angle, 2)));
    QStringList remarks;
    for (const Message &remark : diagnosis()->remarks)
        remarks << m_language.sentence(remark);
    if (!isOfFeeds())
        remarks += statedTexts();
    m_remarks->setText(remarks.join(u'\n'));
    m_remarks->setVisible(!remarks.isEmpty());
    m_chartBar->setVisible(!isOfFeeds());
    m_overlay->setVisible(isOfFeeds());
    if (isOfFeeds())
        m_overlay->show(shown.atFeeds, shown.paths, m_language);
    fillChart();
}

void DiagnosisPage::fillChart() {
    const ShownDiagnosis *shown = m_diagnoser.shown();
    if (!shown || !shown->test)
        return;
    const QString none = tr("No single circle tells it.");
    m_chartNote->clear();
    if (isOfFeeds()) {
        const auto row = currentRow();
        if (!row)
            return;
        const SourceEstimate &source = diagnosis()->sources[m_rows[*row].sources.front()];
        m_chart->setReadOut({});
        m_chart->setFigure(overFeedFigure(shown->atFeeds, source.id, source.axis, m_language), m_language,
                           none);
        return;
    }
    const DiagnosedTest &test = *shown->test;
    if (m_rest->isChecked()) {
        m_chartNote->setText(tr("measured minus sources, s = %1")
                                 .arg(m_language.quantity(test.diagnosis.residual, Quantity::deviation, 3)));
        m_chart->setReadOut({});
        m_chart->setFigure(shown->residual, m_language);
        return;
    }
    const auto perTurn =
        test.circle.feed
            ? std::optional(*test.circle.feed / test.circle.nominalRadius / (2 * std::numbers::pi))
            : std::nullopt;
    m_chartNote->setText(
        perTurn ? tr("one wave a turn is %1 Hz").arg(m_language.number(*perTurn, Quantity::number, 4))
                : tr("the frequency needs the contouring feed"));
    m_chart->setReadOut([language = m_language, perTurn](const FigureLine &, const QPointF &at) {
        QString text = QStringLiteral("n = ") + language.number(at.x(), Quantity::number, 1);
        if (perTurn)
            text += QStringLiteral("  ") + language.number(at.x() * *perTurn, Quantity::number, 2) +
                    QStringLiteral("\u00A0Hz");
        return text + QStringLiteral("  ") +
               language.quantity(at.y() / unitScale(Quantity::deviation, language.units()),
                                 Quantity::deviation, 3);
    });
    m_chart->setFigure(shown->spectrum, m_language);
}

// ---- What is traced --------------------------------------------------------------------------------------

void DiagnosisPage::tick(std::size_t row, bool on) {
    std::set<QString> ticked;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (i == row ? on : isTicked(m_rows[i]))
            ticked.insert(idOf(m_rows[i].sources.front()));
    }
    m_ticked = std::move(ticked);
    m_table->item(static_cast<int>(row), TableColumn::bar)->setData(RowTable::firstRole, on);
    m_table->setCurrentCell(static_cast<int>(row), source);
    trace();
}

void DiagnosisPage::trace() {
    std::vector<std::size_t> chosen;
    if (const ShownDiagnosis *shown = m_diagnoser.shown(); shown && shown->test && m_trace->isChecked()) {
        for (const DiagnosisRow &row : diagnosisRows(shown->test->diagnosis, m_language)) {
            const bool traceable = row.kind == DiagnosisRowKind::source || row.kind == DiagnosisRowKind::sum;
            const QString id =
                QString::fromStdString(sourceId(shown->test->diagnosis.sources[row.sources.front()]));
            const bool prevails =
                std::ranges::find(shown->prevailing, row.sources.front()) != shown->prevailing.end();
            if (traceable && (m_ticked ? m_ticked->contains(id) : prevails))
                chosen.insert(chosen.end(), row.sources.begin(), row.sources.end());
        }
    }
    m_diagnoser.trace(chosen);
}

QStringList DiagnosisPage::tracedNames() const {
    QStringList names;
    for (const DiagnosisRow &row : m_rows) {
        if (m_trace->isChecked() && isTicked(row))
            names << row.name;
    }
    return names;
}

bool DiagnosisPage::eventFilter(QObject *watched, QEvent *event) {
    const auto row = currentRow();
    if (watched == m_table && event->type() == QEvent::KeyPress && row) {
        const auto *key = static_cast<QKeyEvent *>(event); // NOLINT: a key press is one
        const auto *cell = m_table->cellWidget(static_cast<int>(*row), TableColumn::ticks);
        auto *box = cell ? cell->findChild<QCheckBox *>() : nullptr;
        if (key->key() == Qt::Key_Space && box && box->isEnabled()) {
            box->toggle();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

// ---- Events ----------------------------------------------------------------------------------------------

void DiagnosisPage::showEvent(QShowEvent *event) {
    QWidget::showEvent(event);
    want();
    if (m_diagnoser.shown())
        trace();
}

void DiagnosisPage::hideEvent(QHideEvent *event) {
    QWidget::hideEvent(event);
    emit pathsWanted({});
}

void DiagnosisPage::changeEvent(QEvent *event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange && !m_rows.empty())
        fillTable();
    QWidget::changeEvent(event);
}

void DiagnosisPage::retranslate() {
    m_nature->setText(tr("Interpretation, not a result of ISO 230-4"));
    m_circle->setText(tr("This circle"));
    m_feeds->setText(tr("All feeds"));
    m_circle->setToolTip(tr("What this circle says by itself"));
    m_feeds->setToolTip(tr("What the tests of this plane at several feeds say together"));
    m_trace->setText(tr("Trace the ticked sources"));
    m_trace->setToolTip(tr("Draw the path that the ticked sources make over the measured one"));
    m_rest->setText(tr("Rest"));
    m_spectrum->setText(tr("Spectrum"));
    m_rest->setToolTip(tr("What no source explains, over the angle"));
    m_spectrum->setToolTip(tr("What no source explains, by its waves: a vibration stands out"));
    m_table->setAccessibleName(tr("Sources"));
    m_overlay->setAccessibleName(tr("Circles at several feeds"));
    m_chart->setAccessibleName(tr("Chart"));
    m_chart->setAccessibleDescription(
        tr("Plus and minus zoom, arrows move, 0 shows the whole; a rectangle drawn with the mouse is zoomed "
           "into; the wheel zooms"));
    const QString zooming =
        tr("Wheel, plus and minus zoom; dragging and arrows move; a double click or 0 shows the whole");
    m_overlay->setAccessibleDescription(zooming);
    m_overlay->setToolTip(zooming);
    for (QToolButton *button : {m_circle, m_feeds, m_trace, m_rest, m_spectrum})
        button->setAccessibleName(button->text());
    refresh();
    if (isVisible())
        want();
}

} // namespace palmer::ui
