// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/comparedialog.h"

#include "import/formats.h"
#include "import/importmeasurement.h"
#include "kernel/measurement/testfacts.h"
#include "ui/errorbox.h"
#include "ui/figures/comparisonview.h"
#include "ui/formulatext.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/background.h"
#include "ui/quiettable.h"
#include "ui/sizeonscreen.h"
#include "ui/testname.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QTableWidget>
#include <algorithm>
#include <map>

namespace palmer::ui {

namespace {

constexpr int listWidth = 190;
constexpr int cellMargin = 6;

constexpr int symbolRole = Qt::UserRole + 1;
constexpr int nameColumn = 1;
constexpr int nameLetters = 32; ///< per line of a name
constexpr int differsRole = Qt::UserRole + 2;

/// Draws symbols with subscripts and names in as many lines as needed; values that differ from the first
/// column are bold on a coloured background.
class ComparedDelegate : public QuietDelegate {
public:
    using QuietDelegate::QuietDelegate;

    [[nodiscard]] QColor ground(const QStyleOptionViewItem &option, const QModelIndex &index) const override {
        return index.data(differsRole).toBool() && !(option.state & QStyle::State_Selected)
                   ? token(Token::unsureGround, option.palette)
                   : QuietDelegate::ground(option, index);
    }

    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override {
        const QRect room = option.rect.adjusted(cellMargin, 0, -cellMargin, 0);
        const QColor colour = option.palette.color(QPalette::Text);
        if (const QVariant symbol = index.data(symbolRole); symbol.isValid()) {
            drawFormula(painter, room, Qt::AlignLeft | Qt::AlignVCenter, symbol.value<Formula>(), option.font,
                        colour, true);
        } else if (index.column() == nameColumn) {
            painter.setFont(option.font);
            painter.setPen(colour);
            painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                             index.data().toString());
        } else {
            QuietDelegate::paintContent(painter, option, index);
        }
    }

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option,
                                 const QModelIndex &index) const override {
        const QSize size = QuietDelegate::sizeHint(option, index);
        int height = tableRowHeight;
        if (index.column() == nameColumn && option.rect.width() > 2 * cellMargin) {
            const QRect room(0, 0, option.rect.width() - 2 * cellMargin, 1000);
            const QRect text =
                option.fontMetrics.boundingRect(room, Qt::TextWordWrap, index.data().toString());
            height = std::max(height, text.height() + cellMargin);
        }
        return {size.width() + 2 * cellMargin, height};
    }
};

QTableWidgetItem *cell(const QString &text, bool number) {
    auto *item = new QTableWidgetItem(text);
    item->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return item;
}

/// Shows a dash if empty.
QTableWidgetItem *numberCell(const QString &number) {
    return cell(number.isEmpty() ? QStringLiteral("–") : number, true);
}

/// A value cell; `first`: the value it is compared with.
QTableWidgetItem *valueCell(const QString &value, const QString &first) {
    QTableWidgetItem *item = numberCell(value);
    if (value.isEmpty() || first.isEmpty() || value == first)
        return item;
    QFont bold = QApplication::font();
    bold.setBold(true);
    item->setFont(bold);
    item->setData(differsRole, true);
    return item;
}

/// The footnote numbers of a row's reasons, "1, 3"; new reasons are appended to `footnotes`.
QString notesOf(const ComparisonRow &row, QStringList &footnotes) {
    std::vector<qsizetype> numbers;
    for (const QString &reason : row.reasons) {
        if (!footnotes.contains(reason))
            footnotes << reason;
        numbers.push_back(footnotes.indexOf(reason) + 1);
    }
    std::ranges::sort(numbers);
    QStringList words;
    for (const qsizetype number : numbers)
        words << QString::number(number);
    return words.join(QStringLiteral(", "));
}

int columnContents(const QTableWidget &table, int column) {
    int widest = 0;
    QStyleOptionViewItem option;
    option.font = table.font();
    option.fontMetrics = table.fontMetrics();
    for (int r = 0; r < table.rowCount(); ++r)
        widest =
            std::max(widest, table.itemDelegate()->sizeHint(option, table.model()->index(r, column)).width());
    return widest;
}

/// Makes the column as wide as the names if there is space; otherwise they wrap.
void fitNames(QTableWidget &table) {
    if (table.columnCount() <= nameColumn)
        return;
    int others = 0;
    for (int c = 0; c < table.columnCount(); ++c) {
        if (c != nameColumn)
            others += std::max(table.horizontalHeader()->sectionSizeHint(c), columnContents(table, c));
    }
    const int least = nameLetters * table.fontMetrics().averageCharWidth();
    const int wanted = std::max(least, columnContents(table, nameColumn));
    table.setColumnWidth(nameColumn, std::clamp(table.viewport()->width() - others, least, wanted));
}

/// Fills a table; `differences`: a column after every value but the first; otherwise the footnote numbers at
/// the end. Returns the footnotes in order.
QStringList fill(QTableWidget &table, const ResultComparison &comparison, const QStringList &heads,
                 bool differences) {
    QStringList footnotes;
    table.clear();
    table.setColumnCount(static_cast<int>(heads.size()));
    table.setHorizontalHeaderLabels(heads);
    for (int c = 0; c < table.columnCount(); ++c) {
        const bool words = c <= 1 || (!differences && c == table.columnCount() - 1);
        table.horizontalHeaderItem(c)->setTextAlignment((words ? Qt::AlignLeft : Qt::AlignRight) |
                                                        Qt::AlignVCenter);
    }
    table.setRowCount(static_cast<int>(comparison.rows.size()));
    for (int r = 0; r < table.rowCount(); ++r) {
        const ComparisonRow &row = comparison.rows[static_cast<std::size_t>(r)];
        int column = 0;
        QTableWidgetItem *symbol = cell(row.symbol.plain(), false);
        symbol->setData(symbolRole, QVariant::fromValue(row.symbol));
        table.setItem(r, column++, symbol);
        table.setItem(r, column++, cell(row.name, false));
        for (qsizetype i = 0; i < row.values.size(); ++i) {
            table.setItem(r, column++, valueCell(row.values[i], row.values[0]));
            if (differences && i > 0)
                table.setItem(r, column++, numberCell(row.differences[i]));
        }
        if (!differences) {
            QTableWidgetItem *notes = cell(notesOf(row, footnotes), false);
            notes->setToolTip(row.reason());
            table.setItem(r, column, notes);
        }
    }
    table.horizontalHeader()->setStretchLastSection(false); // keeps its own width
    table.resizeColumnsToContents();
    fitNames(table);
    table.horizontalHeader()->setStretchLastSection(!differences); // ends the rules with the table
    table.resizeRowsToContents();
    return footnotes;
}

QTableWidget *readOnlyTable(QWidget *parent, const char *name) {
    auto *table = made<QTableWidget>(name, parent);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    makeQuiet(*table, tableRowHeight, tableRowHeight);
    table->setItemDelegate(new ComparedDelegate(table));
    table->setWordWrap(true);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    return table;
}

} // namespace

CompareDialog::CompareDialog(const EvaluatedDocument &evaluated, std::size_t test, QWidget *parent)
    : Translated(parent)
    , m_evaluated(std::make_shared<const EvaluatedDocument>(evaluated))
    , m_test(test)
    , m_tabs(made<QTabWidget>("compareTabs", this))
    , m_editionList(made<QListWidget>("editionList", this))
    , m_editionTable(readOnlyTable(this, "editionTable"))
    , m_editionNotes(made<QLabel>("editionNotes", trait::secondary, trait::wrapped, trait::plainText, this))
    , m_testList(made<QListWidget>("testList", this))
    , m_view(new ComparisonView(this))
    , m_testTable(readOnlyTable(this, "testTable"))
    , m_testNotes(made<QLabel>(trait::secondary, trait::wrapped, trait::plainText, this))
    , m_addFile(made<QPushButton>("addFile", trait::notDefault, this))
    , m_copy(made<QPushButton>("copyComparison", trait::notDefault, this))
    , m_close(made<QPushButton>("closeComparison", trait::notDefault, this)) {
    setObjectName(QStringLiteral("compareDialog"));
    resize(sizeOnScreen(*this, {1200, 720}));
    for (QListWidget *list : {m_editionList, m_testList}) {
        list->setFixedWidth(listWidth);
        list->setProperty("roomy", true);
    }
    auto *editions = new QWidget(m_tabs);
    auto *editionColumn = inColumn(styleSpacing, {{m_editionTable, 1}, m_editionNotes});
    inRow(editions, styleMargins, styleSpacing, {m_editionList, {editionColumn, 1}});
    auto *tests = new QWidget(m_tabs);
    auto *listColumn = inColumn(styleSpacing, {{m_testList, 1}, m_addFile});
    auto *testColumn = inColumn(styleSpacing, {{m_view, 1}, {m_testTable, 1}, m_testNotes});
    inRow(tests, styleMargins, styleSpacing, {listColumn, {testColumn, 1}});
    m_tabs->addTab(editions, QString());
    m_tabs->addTab(tests, QString());
    auto *buttons = inRow(styleSpacing, {Placed::stretch(), m_copy, m_close});
    m_copy->setIcon(lineIcon(QStringLiteral("copy")));
    inColumn(this, styleMargins, styleSpacing, {{m_tabs, 1}, buttons});

    if (test < evaluated.tests.size()) {
        const Test &shown = *evaluated.document->tests[test];
        for (const std::string &word : editionsToCompare(shown))
            m_editions.emplace_back(word, true);
        m_offers.push_back({m_evaluated, test, testName(shown), true});
    }
    offer(m_evaluated, {});
    connect(m_editionList, &QListWidget::itemChanged, this, [this](QListWidgetItem *item) {
        m_editions[static_cast<std::size_t>(m_editionList->row(item))].second =
            item->checkState() == Qt::Checked;
        showEditions();
    });
    connect(m_testList, &QListWidget::itemChanged, this, [this](QListWidgetItem *item) {
        m_offers[static_cast<std::size_t>(m_testList->row(item))].isChosen =
            item->checkState() == Qt::Checked;
        showTests();
    });
    connect(m_addFile, &QPushButton::clicked, this, &CompareDialog::chooseFile);
    connect(m_copy, &QPushButton::clicked, this, &CompareDialog::copy);
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    retranslate();
    for (QTableWidget *table : {m_editionTable, m_testTable})
        table->viewport()->installEventFilter(this);
}

/// Adds the tests of a document comparable with the one in view; those of its own axis are preselected, as
/// many as a table shows. Equal names are numbered.
void CompareDialog::offer(const std::shared_ptr<const EvaluatedDocument> &evaluated, const QString &file) {
    constexpr std::ptrdiff_t mostPreselected = 8;
    if (m_offers.empty())
        return;
    const Test &first = *m_offers[0].evaluated->document->tests[m_offers[0].test];
    std::map<QString, int> named;
    for (const Offer &offer : m_offers)
        ++named[offer.name];
    std::ptrdiff_t chosen = std::ranges::count_if(m_offers, &Offer::isChosen);
    for (std::size_t i = 0; i < evaluated->tests.size(); ++i) {
        const Test &test = *evaluated->document->tests[i];
        const bool itself = file.isEmpty() && i == m_test;
        if (itself || !isComparable(first, test))
            continue;
        const QString base = testName(test);
        QString name = file.isEmpty() ? base : QStringLiteral("%1 – %2").arg(base, file);
        for (int number = ++named[name]; number > 1; ++number) {
            name = QStringLiteral("%1 (%2)").arg(base).arg(number);
            if (named[name]++ == 0)
                break;
        }
        const bool isChosen = !file.isEmpty() || (areOfSameAxis(first, test) && chosen <= mostPreselected);
        chosen += isChosen ? 1 : 0;
        m_offers.push_back({evaluated, i, name, isChosen});
    }
}

void CompareDialog::fillLists() {
    const QSignalBlocker quietEditions(m_editionList);
    const QSignalBlocker quietTests(m_testList);
    m_editionList->clear();
    for (std::size_t i = 0; i < m_editions.size(); ++i) {
        auto *item = new QListWidgetItem(QString::fromStdString(m_editions[i].first), m_editionList);
        item->setCheckState(m_editions[i].second ? Qt::Checked : Qt::Unchecked);
        if (i == 0)
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable); // the reference of the comparison
    }
    m_testList->clear();
    for (std::size_t i = 0; i < m_offers.size(); ++i) {
        auto *item = new QListWidgetItem(m_offers[i].name, m_testList);
        item->setCheckState(m_offers[i].isChosen ? Qt::Checked : Qt::Unchecked);
        if (i == 0)
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    }
}

void CompareDialog::showEditions() {
    std::vector<std::string> chosen;
    for (const auto &[word, isShown] : m_editions) {
        if (isShown)
            chosen.push_back(word);
    }
    m_ofEditions = awaited([&] { return compareEditions(*m_evaluated, m_test, chosen, windowLanguage()); });
    const QStringList reasons =
        fill(*m_editionTable, m_ofEditions,
             QStringList{m_ofEditions.unit, tr("quantity")} + m_ofEditions.columns + QStringList{tr("Notes")},
             false);
    QStringList lines;
    for (qsizetype i = 0; i < reasons.size(); ++i)
        lines << QStringLiteral("%1\u2002%2").arg(i + 1).arg(reasons[i]);
    m_editionNotes->setText((lines + m_ofEditions.notes).join(u'\n'));
}

void CompareDialog::showTests() {
    std::vector<ComparedTest> chosen;
    for (const Offer &offer : m_offers) {
        if (offer.isChosen)
            chosen.push_back({*offer.evaluated, offer.test, offer.name});
    }
    m_ofTests = awaited([&] { return compareTests(chosen, windowLanguage()); });
    QStringList heads{m_ofTests.unit, tr("quantity")};
    for (qsizetype i = 0; i < m_ofTests.columns.size(); ++i) {
        heads << m_ofTests.columns[i];
        if (i > 0)
            heads << QStringLiteral("Δ");
    }
    fill(*m_testTable, m_ofTests, heads, true);
    const ComparisonFigure figure = comparisonFigure(chosen, windowLanguage());
    m_view->show(figure);
    m_view->setVisible(!figure.curves.empty());
    QStringList notes = m_ofTests.notes;
    if (m_offers.size() < 2)
        notes << tr("This file has no other test of this kind: add a file.");
    for (const auto &[file, guess] : m_guesses)
        notes << QStringLiteral("%1: %2").arg(file, windowLanguage().sentence(guess));
    m_testNotes->setText(notes.join(u' '));
}

bool CompareDialog::addFile(const QString &path) {
    try {
        const std::size_t before = m_offers.size();
        const QString name = QFileInfo(path).fileName();
        std::vector<Message> guesses;
        offer(awaited([&] {
                  return std::make_shared<const EvaluatedDocument>(
                      evaluate(std::make_shared<const Document>(readTests(path, guesses))));
              }),
              name);
        for (const Message &guess : guesses) {
            if (m_offers.size() > before)
                m_guesses.emplace_back(name, guess);
        }
        fillLists();
        showTests();
        if (m_offers.size() == before)
            m_testNotes->setText(tr("%1 has no test of this kind.").arg(QFileInfo(path).fileName()));
        return true;
    } catch (const Error &error) {
        showError(this, tr("%1 cannot be opened").arg(QFileInfo(path).fileName()), error);
        return false;
    }
}

void CompareDialog::chooseFile() {
    QFileDialog dialog(this, tr("Compare with the tests of a file"));
    dialog.setObjectName(QStringLiteral("compareFileDialog"));
    dialog.setFileMode(QFileDialog::ExistingFiles);
    dialog.setNameFilters(
        {tr("Tests and measurements (%1)").arg(QStringLiteral("*.palmer ") + importPatterns()),
         tr("All files (*)")});
    if (dialog.exec() != QDialog::Accepted)
        return;
    for (const QString &path : dialog.selectedFiles())
        addFile(path);
}

void CompareDialog::copy() {
    QApplication::clipboard()->setText(
        asTabSeparated(m_tabs->currentIndex() == 0 ? m_ofEditions : m_ofTests));
}

bool CompareDialog::eventFilter(QObject *watched, QEvent *event) {
    for (QTableWidget *table : {m_editionTable, m_testTable}) {
        if (watched == table->viewport() && event->type() == QEvent::Resize)
            fitNames(*table);
    }
    return QDialog::eventFilter(watched, event);
}

void CompareDialog::retranslate() {
    setWindowTitle(tr("Compare"));
    m_tabs->setAccessibleName(windowTitle());
    m_tabs->tabBar()->setAccessibleName(windowTitle());
    m_tabs->setTabText(0, tr("&Editions"));
    m_tabs->setTabText(1, tr("&Tests"));
    m_addFile->setText(tr("&Add a file…"));
    m_copy->setText(tr("Cop&y"));
    m_copy->setToolTip(tr("Copy the table for a spreadsheet"));
    m_close->setText(tr("&Close"));
    m_editionList->setAccessibleName(tr("Editions"));
    m_testList->setAccessibleName(tr("Tests"));
    m_editionTable->setAccessibleName(tr("Results by edition"));
    m_testTable->setAccessibleName(tr("Results by test"));
    m_view->setAccessibleName(tr("Deviations of the tests over one another"));
    fillLists();
    showEditions();
    showTests();
}

} // namespace palmer::ui
