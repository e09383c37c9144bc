// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/resultspanel.h"

#include "language/withunit.h"
#include "report/parts/parts.h"
#include "report/words/accordancetext.h"
#include "ui/chip.h"
#include "ui/elidedlabel.h"
#include "ui/formulatext.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/results/resultsdelegate.h"
#include "ui/theme.h"
#include "ui/verdictmark.h"

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QTableView>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr int resultLineHeight = 20;
constexpr int headHeight = 22;
constexpr int mostRows = 13;
constexpr int leastRows = 6;
constexpr int symbolWidth = 40;
constexpr int narrowSymbolWidth = 32;
constexpr int symbolMargin = 14; ///< before and after a symbol
constexpr int scaleWidth = 62;
constexpr int cellMargin = 10;
constexpr int narrowCellMargin = 5;
constexpr int nameMargin = 8;

/// A plain header: small words over their columns, a rule below.
class PlainHeader : public QHeaderView {
public:
    explicit PlainHeader(QWidget *parent)
        : QHeaderView(Qt::Horizontal, parent) {}

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter painter(viewport());
        painter.fillRect(viewport()->rect(), palette().color(QPalette::Base));
        painter.setFont(themeFont(TextSize::small));
        for (int column = 0; column < count(); ++column) {
            if (isSectionHidden(column))
                continue;
            const bool right = ResultsModel::isNumber(column);
            const QRect room = QRect(sectionViewportPosition(column), 0, sectionSize(column), height())
                                   .adjusted(2, 0, -4, -2);
            painter.setPen(token(Token::secondaryText, palette()));
            painter.drawText(room, (right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
                             model()->headerData(column, Qt::Horizontal).toString());
        }
        painter.setPen(token(Token::lineStrong, palette()));
        painter.drawLine(0, height() - 1, viewport()->width(), height() - 1);
    }
};

/// As high as its rows; in a low window shrinks to a few rows and scrolls.
class ResultsTable : public QTableView {
public:
    using QTableView::QTableView;

    void setRows(int rows) {
        m_rows = rows;
        setMaximumHeight(heightOf(rows));
        updateGeometry();
    }
    [[nodiscard]] QSize sizeHint() const override {
        return {QTableView::sizeHint().width(), heightOf(m_rows)};
    }
    [[nodiscard]] QSize minimumSizeHint() const override {
        return {QTableView::minimumSizeHint().width(), heightOf(std::min(m_rows, leastRows))};
    }

private:
    static int heightOf(int rows) { return headHeight + rows * resultLineHeight + 2; }

    int m_rows = 0;
};

/// Width of the header and texts of a column, without margin.
int widthOfResults(const ResultsModel &model, int column, const QFontMetrics &metrics) {
    int width = QFontMetrics(themeFont(TextSize::small))
                    .horizontalAdvance(model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    for (int row = 0; row < model.rowCount(); ++row) {
        const QString text = model.index(row, column).data().toString();
        const int mark = ResultsModel::column(column).look == ResultLook::verdict && !text.isEmpty() ? 16 : 0;
        const int after = ResultsModel::isNumber(column) ? model.roomAfter(text, column, metrics) : 0;
        width = std::max(width, metrics.horizontalAdvance(text) + mark + after);
    }
    return width;
}

bool saysNothing(const ResultsModel &model, int column) {
    for (int row = 0; row < model.rowCount(); ++row) {
        const QString text = model.index(row, column).data().toString();
        if (!text.isEmpty() && text != QStringLiteral("–"))
            return false;
    }
    return true;
}

} // namespace

ResultsPanel::ResultsPanel(Selection &selection, QWidget *parent)
    : Translated(parent)
    , m_selection(selection)
    , m_title(new QLabel(this))
    , m_rule(made<ElidedLabel>("resultsRule", trait::secondary, this))
    , m_viewNote(made<QLabel>("viewNote", trait::secondary, trait::wrapped, this))
    , m_chip(made<Chip>("verdictChip", this))
    , m_limits(made<Chip>("limitsChip", this))
    , m_accordance(made<LinkChip>("accordanceChip", this))
    , m_copy(made<QToolButton>("copyResults", trait::iconOnly, trait::strongFocus, this))
    , m_table(made<ResultsTable>("results", this))
    , m_delegate(new ResultsDelegate(m_table)) {
    setObjectName(QStringLiteral("resultsPanel"));
    m_accordance->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed); // its tooltip has the whole text
    m_rule->setSeparator(QStringLiteral(" · "));
    m_copy->setIcon(lineIcon(QStringLiteral("copy")));
    connect(m_accordance, &LinkChip::clicked, this, &ResultsPanel::findingsWanted);
    connect(m_copy, &QToolButton::clicked, this, &ResultsPanel::copy);
    makeTable();
    followSelection();
    arrange();
    retranslate();
}

void ResultsPanel::makeTable() {
    m_table->setHorizontalHeader(new PlainHeader(m_table));
    m_table->setModel(&m_model);
    m_table->setItemDelegate(m_delegate);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->verticalHeader()->setMinimumSectionSize(resultLineHeight);
    m_table->verticalHeader()->setDefaultSectionSize(resultLineHeight);
    QHeaderView *header = m_table->horizontalHeader();
    header->setFixedHeight(headHeight);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(ResultsModel::columnOf("name"), QHeaderView::Stretch);
    header->setMinimumSectionSize(10);
    header->setSectionsClickable(false);
    header->setHighlightSections(false);
    m_table->installEventFilter(this);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto add = [this](auto done) {
        auto *action = new QAction(m_table);
        connect(action, &QAction::triggered, this, done);
        m_table->addAction(action);
    };
    add([this] { explain(m_table->currentIndex()); });
    add([this] { copyLine(m_table->currentIndex().row()); });
    add([this] { copy(); });
}

/// One result in words: "A = 16.2 µm, U = 3.0 µm, k = 2".
void ResultsPanel::copyLine(int row) {
    if (row < 0)
        return;
    const ResultTable &table = m_model.table();
    const ResultLine &line = m_model.line(row);
    QStringList parts{line.symbol.plain() + QStringLiteral(" = ") + withUnit(line.cell("value"), table.unit)};
    if (const QString &uncertainty = line.cell("expandedUncertainty");
        !uncertainty.isEmpty() && uncertainty != QStringLiteral("–")) {
        parts << QStringLiteral("U = ") + withUnit(uncertainty, table.unit);
        parts << table.coverage;
    }
    parts.removeAll(QString());
    QGuiApplication::clipboard()->setText(parts.join(QStringLiteral(", ")));
    emit said(tr("Results copied"));
}

void ResultsPanel::followSelection() {
    connect(m_table, &QAbstractItemView::clicked, this, &ResultsPanel::explain);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex &current) {
                if (!m_selection.parameter().isEmpty() && m_table->hasFocus())
                    explain(current); // an open explanation follows the arrows
            });
    connect(&m_selection, &Selection::parameterChanged, this, &ResultsPanel::showExplained);
}

void ResultsPanel::arrange() {
    auto *head = inRow(8, {m_title, {m_rule, 1}, m_chip, m_copy});
    auto *statements = inRow(nullptr, {0, 0, 4, 2}, 8, {m_limits, m_accordance, Placed::stretch()});
    inColumn(this, {pageMargin, 2, pageMargin - 4, 2}, 0, {head, statements, m_viewNote, {m_table, 1}});
}

void ResultsPanel::show(const EvaluatedDocument &evaluated, std::size_t test) {
    m_evaluated = evaluated;
    m_test = test;
    refresh();
}

void ResultsPanel::setLanguage(const Language &language) {
    m_language = language;
    refresh();
}

void ResultsPanel::resizeEvent(QResizeEvent *event) {
    QWidget::resizeEvent(event);
    fitNames();
}

void ResultsPanel::setNarrow(bool narrow) {
    m_narrow = narrow;
    fitColumns();
}

void ResultsPanel::refresh() {
    const int row = m_table->currentIndex().row();
    m_model.setTable(resultTable(m_evaluated, m_test, m_language), m_language);
    const ResultTable &table = m_model.table();
    QStringList rule{table.unit, table.circle};
    if (!table.view)
        rule << table.rule;
    if (!table.coverage.isEmpty())
        rule << table.coverage;
    rule.removeAll(QString());
    m_rule->setText(rule.join(QStringLiteral(" · ")));
    m_viewNote->setText(table.otherTest ? rolesNote() : table.viewNote);
    m_viewNote->setVisible(table.view || table.otherTest);
    showVerdict();
    m_copy->setEnabled(!table.lines.empty());
    static_cast<ResultsTable *>(m_table)->setRows(std::min(mostRows, m_model.rowCount()));
    fitColumns();
    showExplained();
    if (m_selection.parameter().isEmpty() && row >= 0 && row < m_model.rowCount())
        m_table->setCurrentIndex(m_model.index(row, 0));
}

/// Shows the verdict and, next to it, its two statements, limits and accordance.
void ResultsPanel::showVerdict() {
    const ResultTable &table = m_model.table();
    const bool any = !table.view && !table.lines.empty();
    for (QWidget *chip : std::initializer_list<QWidget *>{m_chip, m_limits, m_accordance})
        chip->setVisible(any);
    if (!any)
        return;
    const Test &test = *m_evaluated.document->tests[m_test];
    const TestEvaluation &evaluation = *m_evaluated.tests[m_test];
    const bool anyLimit = hasLimits(test.limits);
    const Accordance accordance = evaluation.accordance();
    if (table.provisional) {
        m_chip->setContent(tr("provisional"), QStringLiteral("dots"), Token::secondaryText, Token::hover);
    } else {
        VerdictMark look = verdictMark(evaluation.verdict);
        if (largeMark(evaluation.verdict, accordance) == Mark::warning)
            look = {QStringLiteral("warn"), Token::unsure, {}};
        m_chip->setContent(m_language.text(largeWord(evaluation.verdict, anyLimit, accordance).word),
                           look.icon, look.colour, groundOf(look.colour));
    }
    VerdictMark limits = limitsMark(evaluation.verdict, anyLimit);
    if (table.provisional)
        limits.colour = Token::secondaryText;
    m_chip->setVisible(table.provisional || m_chip->text() != limits.word); // not the same word twice
    m_limits->setContent(limits.word, limits.icon, limits.colour, groundOf(limits.colour));
    const VerdictMark edition = accordanceMark(accordance);
    m_accordance->setContent(edition.word, edition.icon, edition.colour, groundOf(edition.colour));
    const QString sentence = accordanceText(test, evaluation, m_language, false);
    m_accordance->setToolTip(sentence);
    m_accordance->setAccessibleName(sentence);
}

void ResultsPanel::fitColumns() {
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    const QFontMetrics metrics(bold);
    double symbols = m_narrow ? narrowSymbolWidth : symbolWidth;
    for (int row = 0; row < m_model.rowCount(); ++row)
        symbols = std::max(symbols, formulaWidth(m_model.line(row).symbol, bold) + symbolMargin);
    for (int place = 0; place < m_model.columnCount(); ++place)
        fitColumn(place, static_cast<int>(std::ceil(symbols)), metrics);
    // Results before an adjustment are left of those after it, whichever is in view.
    QHeaderView *header = m_table->horizontalHeader();
    const bool isFirst = m_model.table().otherIsFound;
    const int first = ResultsModel::columnOf(isFirst ? "other" : "value");
    const int second = ResultsModel::columnOf(isFirst ? "otherUncertainty" : "expandedUncertainty");
    const int place = ResultsModel::columnOf("name") + 1;
    if (header->visualIndex(first) != place) {
        header->moveSection(header->visualIndex(first), place);
        header->moveSection(header->visualIndex(second), place + 1);
    }
    fitNames();
}

void ResultsPanel::fitColumn(int place, int symbols, const QFontMetrics &metrics) {
    const ResultColumn &column = ResultsModel::column(place);
    const bool other = m_model.table().otherTest.has_value();
    switch (column.look) {
    case ResultLook::name:
        return;
    case ResultLook::symbol:
        m_table->setColumnWidth(place, symbols);
        return;
    case ResultLook::picture:
        m_table->setColumnWidth(place, scaleWidth);
        m_table->setColumnHidden(place, m_narrow || other);
        return;
    case ResultLook::text:
    case ResultLook::number:
    case ResultLook::verdict:
        break;
    }
    m_table->setColumnWidth(place, widthOfResults(m_model, place, metrics) +
                                       (m_narrow ? narrowCellMargin : cellMargin));
    // In a narrow window, and beside another test, names need the width of empty columns.
    m_table->setColumnHidden(place, (column.besideOnly && !other) ||
                                        ((m_narrow || other) && saysNothing(m_model, place)));
}

/// Shows the standard's names if all fit, otherwise shorter ones that still distinguish senses of circles.
void ResultsPanel::fitNames() {
    using Names = ResultsModel::Names;
    const QFontMetrics metrics(m_table->font());
    const int room = m_table->columnWidth(ResultsModel::columnOf("name")) - nameMargin;
    const auto fit = [&](Names names) {
        for (int row = 0; row < m_model.rowCount(); ++row) {
            if (metrics.horizontalAdvance(m_model.nameOf(row, names)) > room)
                return false;
        }
        return true;
    };
    const bool isCircle = !m_model.table().circle.isEmpty();
    m_model.setNames(!isCircle && fit(Names::full) ? Names::full
                     : fit(Names::brief)           ? Names::brief
                                                   : Names::narrow);
}

/// Note that identifies the tests shown side by side.
QString ResultsPanel::rolesNote() const {
    const ResultTable &table = m_model.table();
    const auto name = [&](std::size_t test) {
        const std::string date = m_evaluated.document->tests[test]->date.value_or(std::string());
        const QString number = m_language.number(static_cast<double>(test) + 1, Quantity::count, 0);
        return date.empty() ? tr("test %1").arg(number)
                            : tr("test %1 of %2").arg(number, m_language.shortDate(date));
    };
    const QString own = name(m_test);
    const QString other = name(*table.otherTest);
    return tr("Before the adjustment: %1 · after it: %2")
        .arg(table.otherIsFound ? other : own, table.otherIsFound ? own : other);
}

void ResultsPanel::explain(const QModelIndex &index) {
    if (index.isValid())
        m_selection.setParameter(m_model.line(index.row()).id);
}

void ResultsPanel::showExplained() {
    m_delegate->setExplained(m_selection.parameter());
    const int row = m_model.rowOf(m_selection.parameter());
    if (row >= 0 && m_table->currentIndex().row() != row)
        m_table->setCurrentIndex(m_model.index(row, 0));
    m_table->viewport()->update();
}

void ResultsPanel::copy() {
    auto *mime = new QMimeData;
    mime->setText(asTabSeparated(m_model.table(), m_language));
    mime->setHtml(asHtml(m_model.table(), m_language));
    QGuiApplication::clipboard()->setMimeData(mime);
    emit said(tr("Results copied"));
}

bool ResultsPanel::eventFilter(QObject *watched, QEvent *event) {
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            explain(m_table->currentIndex());
            return true;
        }
        if (key->matches(QKeySequence::Copy)) {
            copy();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void ResultsPanel::retranslate() {
    m_title->setText(tr("Results"));
    m_title->setFont(themeFont(TextSize::head));
    m_rule->setFont(themeFont(TextSize::small));
    m_viewNote->setFont(themeFont(TextSize::small));
    m_copy->setToolTip(tr("Copy the results as a table (%1)")
                           .arg(QKeySequence(QKeySequence::Copy).toString(QKeySequence::NativeText)));
    m_copy->setAccessibleName(tr("Copy the results as a table"));
    m_table->setAccessibleName(tr("Results"));
    const QStringList menu{tr("&Explain"), tr("&Copy with U and unit"), tr("Copy the &table")};
    for (qsizetype i = 0; i < menu.size(); ++i)
        m_table->actions().at(i)->setText(menu[i]);
    m_model.retranslate();
    refresh();
}

} // namespace palmer::ui
