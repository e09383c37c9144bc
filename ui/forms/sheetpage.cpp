// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/sheetpage.h"

#include "print/pdf/marks.h"
#include "ui/currentcell.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/clipboardtext.h"
#include "ui/pastebar.h"
#include "ui/tablepaste.h"
#include "ui/testname.h"
#include "ui/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <utility>

namespace palmer::ui {

namespace {

constexpr const char *sheetContext = "palmer::ui::SheetPage";
constexpr std::array columnWidths{52, 200, 120, 72, 60, 56, 110, 72, 72, 72, 120, 88};
constexpr int iconWidth = 18;      ///< of a verdict
constexpr int mostForObject = 200; ///< more than that, in wide windows

/// The guard picture of a row, its verdict behind its icon; else the text.
class SheetDelegate : public QuietDelegate {
public:
    using QuietDelegate::QuietDelegate;

protected:
    void paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                      const QModelIndex &index) const override {
        if (const QVariant icon = index.data(SheetModel::iconRole); icon.isValid()) {
            const QRect &cell = option.rect;
            drawLineIcon(painter, QRect(cell.left() + tablePadding, cell.top(), iconWidth - 4, cell.height()),
                         icon.toString(), index.data(Qt::ForegroundRole).value<QColor>());
            QStyleOptionViewItem behind = option;
            behind.rect.setLeft(cell.left() + iconWidth);
            QuietDelegate::paintContent(painter, behind, index);
            return;
        }
        const QVariant guard = index.data(SheetModel::guardRole);
        if (!guard.isValid()) {
            QuietDelegate::paintContent(painter, option, index);
            return;
        }
        constexpr double points = 72 / 25.4; // of a millimetre, in which the picture is drawn
        const double scale = (option.rect.width() - 2.0 * tablePadding) / (guardPictureWidth * points);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(option.rect.left() + tablePadding,
                          option.rect.center().y() - scale * points * guardPictureHeight / 2);
        painter.scale(scale, scale);
        drawGuardPicture(painter, {}, guard.value<Guard>(), option.palette.color(QPalette::Text));
    }
};

Member<int> ruleOfSheet() {
    return choiceOf<Rule>(
        ofDocument([](auto &document) -> auto & { return document.report.decisionRule.rule; }),
        {Rule::simpleAcceptance, Rule::iso14253_1, Rule::rejectionProven});
}

Member<std::optional<double>> factorOfSheet() {
    return converted<std::optional<double>, double>(
        ofDocument([](auto &document) -> auto & { return document.report.decisionRule.guardFactor; }),
        [](const double &factor) { return std::optional(factor); },
        [](const std::optional<double> &factor) { return factor.value_or(DecisionRule().guardFactor); });
}

} // namespace

SheetPage::SheetPage(DocumentModel &model, QWidget *parent)
    : Form(sheetContext, Page::sheet, model, parent)
    , m_summary(made<QLabel>("sheetSummary", trait::wrapped, trait::plainText, this))
    , m_reason(made<QLabel>("sheetReason", trait::reason, trait::plainText, this))
    , m_table(made<QTableView>("sheetTable", this))
    , m_pasted(new TablePaste(model, *this)) {
    setObjectName(QStringLiteral("sheetPage"));
    addSection(QT_TR_NOOP("Decision rule"));
    beginRow();
    addChoice({"", QT_TR_NOOP("Rule")},
              {QT_TR_NOOP("simple acceptance"), QT_TR_NOOP("ISO 14253-1: conformity is to be proven"),
               QT_TR_NOOP("non-conformity is to be proven")},
              ruleOfSheet(), false, 2);
    addNumber({"", QT_TR_NOOP("Guard band, times U")}, Quantity::number, factorOfSheet(), 1,
              Allowed::notNegative);
    addSection(QT_TR_NOOP("Checks"));
    addSectionButton(QT_TR_NOOP("Paste"), [this] { paste(); })->setObjectName(QStringLiteral("pasteSheet"));
    addSectionButton(QT_TR_NOOP("Add a row"), [this] {
        addRow();
    })->setObjectName(QStringLiteral("addSheetRow"));
    addSectionButton(QT_TR_NOOP("Remove rows"), [this] {
        removeRows();
    })->setObjectName(QStringLiteral("removeSheetRows"));
    m_link = addSectionButton(QT_TR_NOOP("Take from a test…"), [this] { chooseSource(); });
    m_link->setObjectName(QStringLiteral("linkSheetRow"));
    beginRow();
    addWidget(m_summary);
    beginRow();
    addWidget(m_reason);
    beginRow();
    addWidget(m_table);
    addStretch();
    m_reason->hide();
    makeTable();
    refresh();
}

SheetPage::~SheetPage() {
    delete m_table;
}

void SheetPage::makeTable() {
    m_table->setModel(&m_rows);
    m_table->setItemDelegate(new SheetDelegate(m_table));
    makeQuiet(*m_table, tableRowHeight, tableRowHeight);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                             QAbstractItemView::AnyKeyPressed);
    m_table->horizontalHeader()->setSectionResizeMode(static_cast<int>(SheetColumn::object),
                                                      QHeaderView::Stretch);
    // Its columns need more room than fields.
    m_table->parentWidget()->setMaximumWidth(std::accumulate(columnWidths.begin(), columnWidths.end(), 0) +
                                             mostForObject + 2 * pageMargin);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the page scrolls
    m_table->installEventFilter(this);
    takeTableKeys(
        *m_table, [this] { paste(); }, [this] { removeRows(); });
    const auto sayWhy = [this](const QString &reason) {
        m_reason->setText(capitalised(reason));
        m_reason->setVisible(!reason.isEmpty());
    };
    connect(&m_rows, &SheetModel::refusedText, this, sayWhy);
    connect(m_pasted, &TablePaste::refused, this, sayWhy);
    connect(m_pasted, &TablePaste::undone, m_table, [this] { m_table->setFocus(); });
    m_rows.setWriter([this](const std::vector<SheetRow> &changed) {
        write(QT_TRANSLATE_NOOP("edits", "change the acceptance sheet"), changed);
    });
}

std::vector<SheetRow> SheetPage::rows() const {
    return evaluated().document ? evaluated().document->report.sheet : std::vector<SheetRow>();
}

void SheetPage::write(const char *name, const std::vector<SheetRow> &changed) {
    edit(name, [&](Document &document) { document.report.sheet = changed; });
}

void SheetPage::paste() {
    const QModelIndex current = m_table->currentIndex();
    const std::size_t row = current.isValid() ? static_cast<std::size_t>(current.row()) : rows().size();
    const auto column =
        static_cast<SheetColumn>(current.isValid() && current.column() < sheetColumns ? current.column() : 0);
    m_reason->hide();
    m_pasted->paste([this, row, column, text = clipboardText()](const ImportOptions &answers) -> SaidPaste {
        PastedSheet pasted = pasteSheet(rows(), row, column, text, answers);
        if (pasted.sheet != rows())
            write(QT_TRANSLATE_NOOP("edits", "paste rows"), pasted.sheet);
        const int taken = static_cast<int>(pasted.taken);
        return {std::move(pasted), tr("%n row(s) pasted", nullptr, taken), {}};
    });
}

void SheetPage::addRow() {
    std::vector<SheetRow> more = rows();
    more.emplace_back().number = "";
    write(QT_TRANSLATE_NOOP("edits", "add a row"), more);
    makeCurrent(*m_table, m_rows.index(static_cast<int>(more.size()) - 1, 0));
    m_table->setFocus();
}

void SheetPage::removeRows() {
    std::vector<int> chosen;
    for (const QModelIndex &index : m_table->selectionModel()->selectedIndexes())
        chosen.push_back(index.row());
    std::ranges::sort(chosen, std::greater<>());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<SheetRow> rest = rows();
    for (const int row : chosen) {
        if (static_cast<std::size_t>(row) < rest.size())
            rest.erase(rest.begin() + row);
    }
    if (rest != rows())
        write(QT_TRANSLATE_NOOP("edits", "remove rows"), rest);
}

/// A menu of the parameters of all tests; the chosen one becomes a row.
void SheetPage::chooseSource() {
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("sheetSources"));
    for (std::size_t i = 0; i < evaluated().tests.size(); ++i) {
        const Test &test = *evaluated().document->tests[i];
        if (test.id.empty() || evaluated().tests[i]->parameters.empty())
            continue;
        QMenu *of = menu.addMenu(testName(test));
        for (const Parameter &parameter : evaluated().tests[i]->parameters) {
            of->addAction(
                QString::fromStdString(plainSymbol(parameter)),
                [this, id = test.id, parameterName = parameterId(parameter), name = parameter.term.name] {
                    std::vector<SheetRow> more = rows();
                    SheetRow &row = more.emplace_back();
                    row.from = SheetSource{id, parameterName};
                    row.object = language().text(name).toStdString();
                    write(QT_TRANSLATE_NOOP("edits", "add a row"), more);
                });
        }
    }
    menu.exec(m_link->mapToGlobal(m_link->rect().bottomLeft()));
}

void SheetPage::fitTable() {
    m_table->setFixedHeight((m_rows.rowCount() + 1) * tableRowHeight + 4);
    fitColumns();
}

/// Room for its texts and heading.
int SheetPage::neededWidth(int column) const {
    const QFontMetrics head(themeFont(TextSize::small));
    const QFontMetrics cells(m_table->font());
    int width = head.horizontalAdvance(m_rows.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    for (int row = 0; row < m_rows.rowCount(); ++row) {
        const QModelIndex cell = m_rows.index(row, column);
        width = std::max(width, cells.horizontalAdvance(cell.data().toString()) +
                                    (cell.data(SheetModel::iconRole).isValid() ? iconWidth : 0));
    }
    return width + 2 * tablePadding + 2;
}

/// Where the object lacks room, the other columns give up what they do not need, then the pictures. Widths
/// that the user has drawn stay as long as nothing else comes of it.
void SheetPage::fitColumns() {
    constexpr auto object = static_cast<int>(SheetColumn::object);
    std::vector<int> widths(columnWidths.begin(), columnWidths.end());
    int lacking = neededWidth(object) - m_table->width() +
                  std::accumulate(widths.begin(), widths.end(), -columnWidths[object]);
    for (int column = m_rows.columnCount() - 1; column >= 0; --column) {
        if (column == object || column == SheetModel::picture)
            continue;
        int &width = widths.at(static_cast<std::size_t>(column));
        const int spared = std::clamp(width - neededWidth(column), 0, std::max(lacking, 0));
        lacking -= spared;
        width -= spared;
    }
    m_table->setColumnHidden(SheetModel::picture, lacking > 0);
    if (std::exchange(m_widths, widths) == widths)
        return;
    for (int column = 0; column < m_rows.columnCount(); ++column)
        m_table->setColumnWidth(column, widths.at(static_cast<std::size_t>(column)));
}

bool SheetPage::eventFilter(QObject *watched, QEvent *event) {
    if (watched == m_table && event->type() == QEvent::Resize)
        fitColumns();
    return Form::eventFilter(watched, event);
}

void SheetPage::refreshOthers() {
    m_rows.show(evaluated(), language());
    m_table->setAccessibleName(word(QT_TR_NOOP("Checks")));
    fitTable();
    if (!evaluated().document)
        return;
    const VerdictStatement said = sheetStatement(evaluated(), Writer(language()));
    m_summary->setText(rows().empty()
                           ? tr("Nothing was checked beside the tests yet. Type into the empty row, or paste "
                                "a table with number, object, tolerance, measured value, U and unit.")
                           : joined({said.state, said.text.plain()}, QStringLiteral(" · ")));
    const auto hasParameters = [](const TestEvaluationPointer &test) { return !test->parameters.empty(); };
    m_link->setEnabled(std::ranges::any_of(evaluated().tests, hasParameters));
}

} // namespace palmer::ui
