// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/forms/limitspage.h"

#include "document/documenterror.h"
#include "kernel/evaluation/iso230_4/circularcase.h"
#include "kernel/measurement/testfacts.h"
#include "report/tables/resulttable.h"
#include "ui/errorbox.h"
#include "ui/forms/decisionrulemembers.h"
#include "ui/forms/templatebutton.h"
#include "ui/formulatext.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/clipboardtext.h"
#include "ui/pastebar.h"
#include "ui/tablepaste.h"
#include "ui/theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <utility>

namespace palmer::ui {

namespace {

constexpr const char *limitsContext = "palmer::ui::LimitsPage";
constexpr int symbolWidth = 40;

void fitHeight(QLabel &name) {
    name.setFixedHeight(std::max(fieldHeight, name.heightForWidth(name.width())));
}

/// The longest names take two lines next to their field, three in a narrow window.
class NameLabel : public QLabel {
public:
    explicit NameLabel(QWidget *parent)
        : QLabel(parent) {
        setWordWrap(true);
        setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        setFixedHeight(fieldHeight);
    }

protected:
    void resizeEvent(QResizeEvent *event) override {
        QLabel::resizeEvent(event);
        fitHeight(*this);
    }
};

/// True if the limits of a test differ in edition or origin, which are then stated row by row.
bool areOfSeveralOrigins(const Test &test) {
    const auto &limits = test.limits;
    return std::ranges::adjacent_find(limits, [](const auto &a, const auto &b) {
               return a.second.edition != b.second.edition || a.second.source != b.second.source;
           }) != limits.end();
}

/// A member of a parameter's limit; a limit without statements is removed.
template <auto member>
auto ofLimit(const std::string &id) {
    using T = std::remove_cvref_t<decltype(std::declval<Limit &>().*member)>;
    return Member<T>{
        [id](const FormSource &source) {
            if (!source.test)
                return T();
            const auto found = source.test->limits.find(id);
            return found == source.test->limits.end() ? T() : found->second.*member;
        },
        [id](Document &document, std::size_t index, const T &value) {
            editTest(document, index, [&](Test &test) {
                const auto any = test.limits.begin();
                const bool isNew =
                    any != test.limits.end() && !test.limits.contains(id) && !areOfSeveralOrigins(test);
                const Limit like = isNew ? Limit{{}, any->second.edition, any->second.source} : Limit();
                const bool isOfAll = test.limits.size() > 1 && !areOfSeveralOrigins(test);
                editLimit(test, id, [&](Limit &limit) {
                    if (isNew) // one edition and origin for all
                        limit = like;
                    limit.*member = value;
                    if (isOfAll && !limit.value)
                        limit = {};
                });
            });
        }};
}

/// A symbol with subscripts.
class SymbolLabel : public QWidget {
public:
    SymbolLabel(Formula symbol, QWidget *parent)
        : QWidget(parent)
        , m_symbol(std::move(symbol)) {
        setFixedSize(symbolWidth, fieldHeight);
    }

protected:
    void paintEvent(QPaintEvent *) override {
        QPainter painter(this);
        drawFormula(painter, rect(), Qt::AlignLeft | Qt::AlignVCenter, m_symbol, font(),
                    palette().color(foregroundRole()));
    }

private:
    Formula m_symbol;
};

struct LimitRow {
    std::string id;
    Formula symbol;
    std::vector<const Term *> terms; ///< limited parameters; empty if the edition has none of them
};

/// Rows for limits: the parameters of the edition and those the test already has limits for.
std::vector<LimitRow> rowsOf(const Edition &edition, const Test &test) {
    std::vector<LimitRow> rows;
    const auto add = [&](const std::string &id, const Formula &symbol, const Term *term) {
        if (id.empty())
            return;
        auto row = std::ranges::find(rows, id, &LimitRow::id);
        if (row == rows.end())
            row = rows.insert(row, {id, symbol, {}});
        if (term)
            row->terms.push_back(term);
    };
    for (const Term *term : termsOf(edition)) {
        add(term->also, formulaFrom(QString::fromUtf8(term->also)), term);
        add(term->id, symbolFormula(term->symbol), term);
    }
    for (const auto &[id, limit] : test.limits)
        add(id, formulaFrom(QString::fromStdString(id)), nullptr);
    return rows;
}

/// The value that a member has in all agreed limits; nothing if they differ.
template <auto member>
auto ofAllLimits() {
    using T = std::remove_cvref_t<decltype(std::declval<Limit &>().*member)>;
    return Member<T>{
        [](const FormSource &source) {
            std::optional<T> common;
            for (const auto &[id, limit] : source.test ? source.test->limits : decltype(Test::limits)()) {
                if (common && *common != limit.*member)
                    return T();
                common = limit.*member;
            }
            return common.value_or(T());
        },
        [](Document &document, std::size_t index, const T &value) {
            editTest(document, index, [&](Test &test) {
                for (auto &[id, limit] : test.limits)
                    limit.*member = value;
                std::erase_if(test.limits, [](const auto &limit) { return limit.second == Limit(); });
            });
        }};
}

} // namespace

LimitsPage::LimitsPage(DocumentModel &model, Selection &selection, QWidget *parent)
    : Form(limitsContext, Page::limits, model, parent)
    , m_pasted(new TablePaste(model, *this)) {
    follow(selection);
    setObjectName(QStringLiteral("limitsPage"));
    addToBar(new TemplateButton(TemplateButton::Kind::limits, model, selection, this));
    connect(m_pasted, &TablePaste::refused, this, [this](const QString &sentence) {
        showError(this, tr("Nothing was pasted"), sentence, QMessageBox::Warning);
    });
    refresh();
}

/// A row of fields for each parameter in the test's edition.
void LimitsPage::prepare() {
    if (std::exchange(m_pastedTest, test()) != test())
        m_pasted->end();
    const Test *shown = shownTest();
    const Edition *edition = shown ? findEdition(shown->edition) : nullptr;
    if (!edition) {
        if (!m_built.isEmpty())
            clear();
        m_built.clear();
        return;
    }
    const bool rotary = motionOf(*shown) == Motion::rotary;
    const std::vector<LimitRow> rows = rowsOf(*edition, *shown);
    QStringList wanted{QString::fromUtf8(edition->word), rotary ? QStringLiteral("°") : QStringLiteral("mm")};
    for (const LimitRow &row : rows)
        wanted << QString::fromStdString(row.id);
    const bool rowByRow = areOfSeveralOrigins(*shown);
    const bool hasGuardBand = shown->decisionRule.rule != Rule::simpleAcceptance;
    wanted << QStringLiteral("rows %1, band %2").arg(rowByRow).arg(hasGuardBand);
    // The emptied limit of another edition keeps its row until the page is shown again.
    const bool onlyLess =
        wanted.size() < m_built.size() && isAncestorOf(focusWidget()) &&
        std::ranges::all_of(wanted, [&](const QString &id) { return m_built.contains(id); });
    if (wanted == m_built || onlyLess)
        return;
    m_built = wanted;
    m_quantity = rotary ? Quantity::angularDeviation : Quantity::deviation;
    m_names.clear();
    m_first = nullptr;
    m_ids.clear();
    m_edits.clear();
    clear();
    addSection(QT_TR_NOOP("Decision rule"));
    beginRow();
    addChoice({"decisionRule", QT_TR_NOOP("Rule")},
              {QT_TR_NOOP("simple acceptance"), QT_TR_NOOP("ISO 14253-1: conformity is to be proven"),
               QT_TR_NOOP("non-conformity is to be proven")},
              decisionRuleMember(), false, 2);
    if (hasGuardBand)
        addNumber({"guardFactor", QT_TR_NOOP("Guard band, times U")}, Quantity::number, guardFactorMember(),
                  1, Allowed::notNegative);
    addSection(QT_TR_NOOP("Agreed limits"));
    addSectionButton(QT_TR_NOOP("Paste"), [this] {
        pasteLimits(0);
    })->setObjectName(QStringLiteral("pasteLimits"));
    for (const LimitRow &row : rows)
        addLimit(row.symbol, row.terms, row.id, edition->kind, rowByRow);
    beginRow();
    if (!rowByRow)
        addEdition(QT_TR_NOOP("Edition of all limits"), edition->kind, ofAllLimits<&Limit::edition>());
    addText({"", QT_TR_NOOP("Origin of all limits")}, ofAllLimits<&Limit::source>(), 5);
    addStretch();
}

void LimitsPage::addLimit(const Formula &symbol, const std::vector<const Term *> &terms,
                          const std::string &id, Kind kind, bool rowByRow) {
    const bool first = m_names.empty();
    beginRow();
    auto *place = new QWidget(body());
    auto *label = new NameLabel(place);
    label->setFont(themeFont(TextSize::small));
    auto *row = inRow(4, {new SymbolLabel(symbol, place), label});
    inColumn(place, noMargins, styleSpacing,
             {Placed::stretch(), // level with the field, not its label
              row});
    place->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWidget(place, 4);
    m_names.push_back({label, terms});
    Field *limit =
        addNumber({"limits", QT_TR_NOOP("Limit of %1")}, m_quantity, ofLimit<&Limit::value>(id), 2);
    limit->setLabelArgument(symbol.plain());
    limit->edit()->installEventFilter(this);
    m_ids.push_back({id, symbol.plain()});
    m_edits.push_back(limit->edit());
    if (first)
        m_first = limit;
    else
        limit->hideLabel();
    if (!rowByRow)
        return addWidget(new QWidget(body()), 6); // as wide as a row with both
    Field *edition = addEdition(QT_TR_NOOP("Agreed for edition"), kind, ofLimit<&Limit::edition>(id));
    Field *origin = addText({"", QT_TR_NOOP("Origin")}, ofLimit<&Limit::source>(id), 3);
    for (Field *field : {edition, origin}) {
        if (!first)
            field->hideLabel();
    }
}

/// A choice among the editions of the kind and that of the test.
Field *LimitsPage::addEdition(const char *label, Kind kind,
                              const Member<std::optional<std::string>> &member) {
    std::vector<const char *> words{QT_TR_NOOP("of the test")};
    std::vector<std::optional<std::string>> values{std::nullopt};
    for (const Edition *edition : editionsOf(kind)) {
        words.push_back(edition->word);
        values.emplace_back(edition->word);
    }
    return addChoice({"", label}, words, choiceOf(member, values), false, 3);
}

bool LimitsPage::eventFilter(QObject *watched, QEvent *event) {
    const auto row = std::ranges::find(m_edits, watched);
    if (row == m_edits.end() || event->type() != QEvent::KeyPress ||
        !static_cast<QKeyEvent *>(event)->matches(QKeySequence::Paste))
        return Form::eventFilter(watched, event);
    const QString text = clipboardText();
    if (!text.trimmed().contains(u'\n') && !text.contains(u'\t'))
        return Form::eventFilter(watched, event);
    pasteLimits(static_cast<std::size_t>(row - m_edits.begin()));
    return true;
}

void LimitsPage::pasteLimits(std::size_t row) {
    m_pasted->paste([this, row, text = clipboardText()](const ImportOptions &answers) -> SaidPaste {
        const Test *shown = shownTest();
        if (!shown)
            return {};
        PastedLimits pasted =
            palmer::pasteLimits(shown->limits, m_ids, row, text, m_quantity, language().units(), answers);
        if (!(pasted.limits == shown->limits))
            edit(QT_TRANSLATE_NOOP("edits", "paste limits"), [&](Document &document) {
                editTest(document, test(), [&](Test &test) { test.limits = pasted.limits; });
            });
        const int taken = static_cast<int>(pasted.taken);
        return {std::move(pasted), PasteBar::tr("%n limit(s) pasted", nullptr, taken), {}};
    });
}

void LimitsPage::refreshOthers() {
    if (m_first)
        m_first->setHeading(tr("Limit"));
    for (const Name &of : m_names) {
        if (of.terms.empty())
            continue;
        const Term &term = *of.terms.front();
        const bool alone = of.terms.size() == 1;
        const auto symbol = [&](std::size_t k) { return symbolFormula(of.terms[k]->symbol).plain(); };
        const QString larger =
            alone ? QString() : tr("the larger of %1 and %2 in size").arg(symbol(0), symbol(1));
        of.label->setText(alone ? language().text(listedName(term))
                                : tr("%1 and %2 in size").arg(symbol(0), symbol(1)));
        fitHeight(*of.label);
        of.label->setToolTip(alone ? language().text(term.name) : larger);
    }
}

} // namespace palmer::ui
