// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/comparison/comparisonpage.h"

#include "document/edits.h"
#include "import/formats.h"
#include "import/importmeasurement.h"
#include "kernel/measurement/testfacts.h"
#include "language/decimals.h"
#include "language/entry.h"
#include "report/parts/comparedtests.h"
#include "report/tables/resulttable.h"
#include "ui/comparison/comparisonside.h"
#include "ui/elidedlabel.h"
#include "ui/errorbox.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/model/background.h"
#include "ui/rowtable.h"
#include "ui/testname.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QApplication>
#include <QButtonGroup>
#include <QCheckBox>
#include <QClipboard>
#include <QFileDialog>
#include <QFileInfo>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>

namespace palmer::ui {

namespace {

enum ConditionColumn { condition, wasStated, isStated, conditionColumns };
enum ParameterColumn { symbol, name, before, after, difference, plusMinus, picture, word, parameterColumns };

constexpr int pictureWidth = 84;
constexpr int toleranceWidth = 72;
constexpr int decisionHeight = 46;

} // namespace

ComparisonPage::ComparisonPage(DocumentModel &model, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_bar(new QWidget(this)) {
    setObjectName(QStringLiteral("comparisonPage"));
    makeBar();
    auto *area = new QScrollArea(this);
    trait::scrollsDown(*area);
    auto *content = new QWidget(area->viewport());
    content->setAttribute(Qt::WA_StyledBackground);
    content->setProperty("ground", QStringLiteral("base"));
    m_decision = made<QFrame>("comparisonDecision", content);
    m_decision->setProperty("card", true);
    m_decision->setMinimumHeight(decisionHeight);
    m_word = made<QLabel>("comparisonWord", TextSize::head, m_decision);
    m_counts =
        made<QLabel>("comparisonCounts", TextSize::small, trait::secondary, trait::wrapped, m_decision);
    m_main = made<QLabel>("comparisonMain", TextSize::head, m_decision);
    auto *words = inColumn(2, {m_word, m_counts});
    inRow(m_decision, {12, 4, 12, 4}, 12, {{words, 1}, {m_main, 0, Qt::AlignVCenter}});
    m_conditionsTitle = made<QLabel>("comparedConditionsTitle", TextSize::head, content);
    m_conditions = new RowTable("comparedConditions", ConditionColumn::conditionColumns, content);
    m_parameters = new RowTable("comparedParameters", ParameterColumn::parameterColumns, content);
    m_parameters->setPictures(picture, pictureWidth);
    for (RowTable *table : {m_conditions, m_parameters})
        table->setFocusPolicy(Qt::StrongFocus);
    m_reason = made<QLabel>("comparisonReason", trait::plainText, trait::wrapped, content);
    m_note = made<QLabel>("comparisonNote", TextSize::small, trait::secondary, trait::wrapped, content);
    inColumn(content, {pageMargin, 8, pageMargin, 8}, 6,
             {m_decision, m_reason, m_conditionsTitle, m_conditions, Placed::gap(4), m_parameters, m_note,
              Placed::stretch(1)});
    area->setWidget(content);
    inColumn(this, noMargins, 0, {m_bar, {area, 1}});
    retranslate();
}

void ComparisonPage::makeBar() {
    m_label = made<QLabel>(trait::secondary, m_bar);
    m_other = made<ElidedBox>("comparedWith", m_bar);
    m_other->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_label->setBuddy(m_other);
    m_forwards = made<QToolButton>("afterLessBefore", trait::checkable, trait::strongFocus,
                                   trait::segment("first"), m_bar);
    m_backwards = made<QToolButton>("beforeLessAfter", trait::checkable, trait::strongFocus,
                                    trait::segment("last"), m_bar);
    m_forwards->setChecked(true);
    auto *direction = new QButtonGroup(this);
    direction->addButton(m_forwards);
    direction->addButton(m_backwards);
    m_copy = iconButton(m_bar, QStringLiteral("copyDifferences"), QStringLiteral("copy"));
    m_toleranceLabel = made<QLabel>(trait::secondary, m_bar);
    m_tolerance = made<QLineEdit>("changeTolerance", m_bar);
    m_tolerance->setFixedWidth(toleranceWidth);
    m_tolerance->setAlignment(Qt::AlignRight);
    m_toleranceLabel->setBuddy(m_tolerance);
    m_untouched = made<QCheckBox>("setUpUntouched", m_bar);
    m_refusal = made<ElidedLabel>("toleranceRefusal", TextSize::small, m_bar);
    m_refusal->setProperty("tone", QStringLiteral("bad"));
    auto *segments = inRow(0, {m_forwards, m_backwards});
    auto *first = inRow(8, {m_label, {m_other, 1}, segments, m_copy});
    auto *second = inRow(
        8, {m_toleranceLabel, m_tolerance, Placed::gap(8), m_untouched, Placed::gap(8), {m_refusal, 1}});
    inColumn(m_bar, {pageMargin, 8, pageMargin, 4}, 6, {first, second});
    connect(m_other, &QComboBox::activated, this, &ComparisonPage::choose);
    connect(direction, &QButtonGroup::buttonClicked, this, [this] { want(); });
    connect(m_tolerance, &QLineEdit::textEdited, this, &ComparisonPage::showRefusal);
    connect(m_tolerance, &QLineEdit::editingFinished, this, &ComparisonPage::state);
    connect(m_untouched, &QCheckBox::clicked, this, &ComparisonPage::state);
    connect(m_copy, &QToolButton::clicked, this, &ComparisonPage::copy);
}

const Test *ComparisonPage::test() const {
    return m_test < m_evaluated->tests.size() ? m_evaluated->document->tests[m_test].get() : nullptr;
}

void ComparisonPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const Test *former = this->test();
    const bool another = !former || test >= evaluated.tests.size() ||
                         former->id != evaluated.document->tests[test]->id ||
                         (former->id.empty() && m_test != test);
    const bool same = !another && m_test == test && m_evaluated->document == evaluated.document;
    m_evaluated = std::make_shared<const EvaluatedDocument>(evaluated);
    m_test = test;
    if (same && m_result)
        return;
    if (another) {
        m_ofFile.reset();
        m_result.reset(); // that of the test before
        m_tolerance->clear();
    }
    const std::size_t ownBefore =
        std::erase_if(m_offers, [](const Offer &offer) { return offer.file.isEmpty(); });
    std::vector<Offer> own;
    if (const Test *shown = this->test()) {
        for (std::size_t i = 0; i < evaluated.tests.size(); ++i) {
            if (i != test && isJudged(*shown) && areOfSameAxis(*shown, *evaluated.document->tests[i]))
                own.push_back({m_evaluated, i, {}});
        }
    }
    m_offers.insert(m_offers.begin(), own.begin(), own.end());
    if (m_ofFile)
        *m_ofFile += own.size() - ownBefore;
    if (!isVisible())
        return; // is filled when it is shown
    fillBox();
    want();
}

void ComparisonPage::showEvent(QShowEvent *event) {
    QWidget::showEvent(event);
    fillBox();
    want();
}

/// The tests of this file, those of other files, "none" and "another file…".
void ComparisonPage::fillBox() {
    const QSignalBlocker quiet(m_other);
    QStringList choices{tr("no test", "to compare with")};
    for (const Offer &offer : m_offers) {
        const Test &other = *offer.evaluated->document->tests[offer.test];
        QStringList words{testName(other)};
        if (!offer.file.isEmpty())
            words << offer.file;
        if (other.date)
            words << windowLanguage().date(*other.date);
        choices << words.join(QStringLiteral(" · "));
    }
    choices << tr("Another file…");
    if (choices != m_choices) { // a file may have a thousand tests of an axis
        m_other->clear();
        m_other->addItems(choices);
        m_choices = std::move(choices);
    }
    int row = 0;
    const Test *shown = test();
    for (std::size_t i = 0; i < m_offers.size(); ++i) {
        const bool stated =
            shown && shown->comparedWith && m_offers[i].file.isEmpty() &&
            m_offers[i].evaluated->document->tests[m_offers[i].test]->id == shown->comparedWith->test;
        if (m_ofFile ? *m_ofFile == i : stated)
            row = static_cast<int>(i) + 1;
    }
    m_other->setCurrentIndex(row);
    const std::optional<ComparedWith> &stated = shown ? shown->comparedWith : std::optional<ComparedWith>();
    const Quantity quantity = shown ? deviationQuantity(*shown) : Quantity::deviation;
    m_toleranceLabel->setText(tr("Agreed tolerance, %1").arg(windowLanguage().unit(quantity)));
    if (!m_ofFile) {
        if (refusal().isEmpty() || row == 0)
            m_tolerance->setText(stated && stated->tolerance
                                     ? windowLanguage().number(certain(*stated->tolerance), quantity)
                                     : QString());
        m_untouched->setChecked(stated && stated->setUpUntouched);
    }
    m_tolerance->setEnabled(row > 0);
    m_untouched->setEnabled(row > 0);
    showRefusal();
}

/// Why the typed tolerance cannot be accepted; empty if it can.
QString ComparisonPage::refusal() const {
    const Test *shown = test();
    if (!shown)
        return {};
    const auto entry =
        enteredNumber(m_tolerance->text(), deviationQuantity(*shown), windowLanguage().units());
    if (entry.refusal)
        return windowLanguage().text(*entry.refusal);
    return entry.value && !(*entry.value > 0) ? tr("not greater than 0") : QString();
}

/// As typed, or else as it is stated.
std::optional<double> ComparisonPage::tolerance() const {
    const Test &shown = *test();
    if (refusal().isEmpty())
        return enteredNumber(m_tolerance->text(), deviationQuantity(shown), windowLanguage().units()).value;
    return shown.comparedWith && !m_ofFile ? shown.comparedWith->tolerance : std::nullopt;
}

void ComparisonPage::showRefusal() {
    const QString reason = refusal();
    m_refusal->setText(reason.isEmpty() ? reason : QStringLiteral("⚠ %1.").arg(capitalised(reason)));
    setStyled(*m_tolerance, "refused", !reason.isEmpty());
    m_tolerance->setAccessibleDescription(m_refusal->text());
}

QStringList ComparisonPage::refusedTexts() const {
    return refusal().isEmpty() ? QStringList() : QStringList{m_tolerance->text()};
}

void ComparisonPage::choose(int row) {
    const auto last = static_cast<int>(m_offers.size()) + 1;
    if (row == last) {
        chooseFile();
        fillBox();
        want();
        return;
    }
    m_ofFile.reset();
    if (row > 0 && !m_offers[static_cast<std::size_t>(row) - 1].file.isEmpty())
        m_ofFile = static_cast<std::size_t>(row) - 1;
    state();
}

/// Writes what is chosen into the test; with a test of another file there is nothing to write.
void ComparisonPage::state() {
    const Test *shown = test();
    if (!shown)
        return;
    if (m_ofFile) {
        fillBox();
        want();
        return;
    }
    const int row = m_other->currentIndex();
    std::optional<ComparedWith> stated;
    if (row > 0 && row <= static_cast<int>(m_offers.size())) {
        const Offer &offer = m_offers[static_cast<std::size_t>(row) - 1];
        stated = ComparedWith{offer.evaluated->document->tests[offer.test]->id, tolerance(),
                              m_untouched->isChecked()};
    }
    if (stated == shown->comparedWith) {
        fillBox();
        want();
        return;
    }
    m_model.edit(QT_TRANSLATE_NOOP("edits", "choose the test to compare with"),
                 [&, index = m_test](Document &document) {
                     editTest(document, index, [&](Test &changed) { changed.comparedWith = stated; });
                 });
}

bool ComparisonPage::addFile(const QString &path) {
    const QString file = QFileInfo(path).fileName();
    try {
        std::vector<Message> guesses;
        const auto other = awaited([&] {
            return std::make_shared<const EvaluatedDocument>(
                evaluate(std::make_shared<const Document>(readTests(path, guesses))));
        });
        const auto like = counterpart({m_evaluated.get(), m_test}, *other);
        if (!like) {
            showError(this, tr("%1 has no test like this one").arg(file),
                      tr("A comparison needs the same axis or plane, directions and radius."));
            return false;
        }
        m_offers.push_back({other, *like, file});
        m_ofFile = m_offers.size() - 1;
        fillBox();
        want();
        return true;
    } catch (const Error &error) {
        showError(this, tr("%1 cannot be opened").arg(file), error);
        return false;
    }
}

void ComparisonPage::chooseFile() {
    QFileDialog dialog(this, tr("Compare with the test of a file"));
    dialog.setObjectName(QStringLiteral("comparisonFileDialog"));
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilters(
        {tr("Tests and measurements (%1)").arg(QStringLiteral("*.palmer ") + importPatterns()),
         tr("All files (*)")});
    if (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty())
        addFile(dialog.selectedFiles().constFirst());
}

std::optional<ComparisonPage::Offer> ComparisonPage::chosen() const {
    const int row = m_other->currentIndex();
    return row > 0 && row <= static_cast<int>(m_offers.size())
               ? std::optional(m_offers[static_cast<std::size_t>(row) - 1])
               : std::nullopt;
}

void ComparisonPage::want() {
    m_worker.cancel();
    const auto other = chosen();
    const Test *shown = test();
    if (!other || !shown) {
        m_result.reset();
        present();
        return;
    }
    Result result{*other, {m_evaluated, m_test, {}}, {}, m_backwards->isChecked()};
    if (precedes(*shown, *other->evaluated->document->tests[other->test]))
        result.swapped = !result.swapped;
    if (result.swapped)
        std::swap(result.before, result.after);
    ComparisonOptions options;
    options.setUpUntouched = m_untouched->isChecked();
    options.tolerance = tolerance();
    if (!m_result)
        present();
    m_worker.start(
        [result = std::move(result), options](const Background::Job &) mutable {
            result.comparison = compare(result.before.placed(), result.after.placed(), options);
            return std::move(result);
        },
        [this](Result done) {
            m_result = std::move(done);
            present();
        });
}

void ComparisonPage::present() {
    const bool any = m_result.has_value();
    for (QWidget *part :
         std::initializer_list<QWidget *>{m_conditions, m_conditionsTitle, m_parameters, m_decision, m_note})
        part->setVisible(any);
    m_copy->setEnabled(any);
    m_reason->setVisible(!any);
    if (!any) {
        m_reason->setText(
            chosen()
                ? tr("The two tests are being compared…")
                : tr("Choose the test to compare with: of this file, such as the one as found or that "
                     "before a repair, or of another file. The report then has a page of the comparison."));
        if (m_side)
            m_side->clear();
        return;
    }
    const Language &language = windowLanguage();
    const PlacedTest was = m_result->before.placed();
    const PlacedTest is = m_result->after.placed();
    const TestComparison &comparison = m_result->comparison;
    const VerdictLine decision = decisionLine(comparison, language);
    QString word = decision.word.toLower();
    if (!word.isEmpty())
        word[0] = word[0].toUpper();
    m_decision->setVisible(!word.isEmpty());
    m_word->setText(word);
    const QString colon = language.semicolon().replace(u';', u':');
    QStringList counts{decision.limits.label + colon + decision.limits.state};
    if (!decision.accordance.label.isEmpty())
        counts << decision.accordance.label + colon + decision.accordance.text.plain();
    m_counts->setText(counts.join(language.semicolon()));
    m_main->setText(decision.limits.text.plain());
    const QString reason = reasonOf(comparison, language);
    m_reason->setText(reason);
    m_reason->setVisible(!reason.isEmpty());
    fillConditions(was, is);
    fillParameters(was, is);
    m_note->setText(language.text(comparisonNature()) +
                    (m_ofFile ? u' ' + tr("A test of another file is not part of the report.") : QString()));
    if (m_side)
        m_side->show(comparison, was, is);
}

void ComparisonPage::fillConditions(const PlacedTest &was, const PlacedTest &is) {
    const Language &language = windowLanguage();
    const ComparedConditions conditions = compareConditions(was, is, language);
    const auto [first, second] = sideTexts(was, is);
    m_conditionsTitle->setText(language.text(REPORT_TEXT("report", "Differences of the conditions")));
    m_conditions->setHead(condition, QString(), false);
    m_conditions->setHead(wasStated, language.text(first), false);
    m_conditions->setHead(isStated, language.text(second), false);
    m_conditions->setRowCount(static_cast<int>(conditions.differing.size()));
    for (int row = 0; row < m_conditions->rowCount(); ++row) {
        const DifferingCondition &differing = conditions.differing[static_cast<std::size_t>(row)];
        const std::array texts{differing.name, differing.before, differing.after};
        for (int column = 0; column < conditionColumns; ++column) {
            QString text = texts.at(static_cast<std::size_t>(column));
            m_conditions->setCell(row, column, text.replace(u'\n', QStringLiteral("; ")), false)
                ->setToolTip(text);
        }
    }
    m_conditions->fit(isStated, 150, {wasStated, condition});
    m_conditions->setVisible(!conditions.differing.empty());
    m_conditionsTitle->setVisible(!conditions.differing.empty());
}

void ComparisonPage::fillParameters(const PlacedTest &was, const PlacedTest &is) {
    const Language &language = windowLanguage();
    const TestComparison &comparison = m_result->comparison;
    const auto [first, second] = sideTexts(was, is);
    const QString unit = QStringLiteral(" ") + language.unit(comparison.quantity);
    m_parameters->setHead(symbol, QString(), false);
    m_parameters->setHead(name, language.text(REPORT_TEXT("report", "Quantity")), false);
    m_parameters->setHead(before, language.text(first), true);
    m_parameters->setHead(after, language.text(second), true);
    m_parameters->setHead(difference, language.text(REPORT_TEXT("report", "Difference")) + unit, true);
    m_parameters->setHead(plusMinus, QStringLiteral("± U"), true);
    m_parameters->setHead(picture, language.text(REPORT_TEXT("report", "Diff. ± U")), false);
    m_parameters->setHead(word, language.text(REPORT_TEXT("report", "Statement")), false);
    const std::vector<ComparedWords> words = comparedWords(comparison, language);
    m_parameters->setRowCount(static_cast<int>(words.size()));
    for (int row = 0; row < m_parameters->rowCount(); ++row) {
        const ComparedWords &shown = words[static_cast<std::size_t>(row)];
        const ComparedParameter &parameter = comparison.parameters[static_cast<std::size_t>(row)];
        const auto &own = parameter.word;
        const bool changed = own && statesDifference(*own);
        m_parameters->setCell(row, symbol, shown.symbol.plain(), false, true);
        m_parameters->setCell(row, name, language.text(listedName(parameter.term)), false)
            ->setToolTip(shown.name);
        m_parameters->setCell(row, before, shown.before, true);
        m_parameters->setCell(row, after, shown.after, true);
        m_parameters->setCell(row, difference, shown.difference, true, true);
        m_parameters->setCell(row, plusMinus, shown.uncertainty, true);
        auto *drawn = m_parameters->setCell(row, picture, QString(), false);
        if (shown.picture)
            drawn->setData(RowTable::whiskerRole, QVariant::fromValue(*shown.picture));
        const QString en =
            shown.enRatio.isEmpty() ? QString() : QStringLiteral(" (En %1)").arg(shown.enRatio);
        const QString said =
            own == ChangeWord::noChangeProven
                ? language.text(changeText(ChangeWord::notProven)) // leaves room to the names
                : shown.word;
        m_parameters->setCell(row, word, said + en, false, changed);
    }
    m_parameters->fit(name, 60);
    m_parameters->setVisible(!words.empty());
}

void ComparisonPage::copy() {
    QStringList lines;
    for (int row = -1; row < m_parameters->rowCount(); ++row) {
        QStringList cells;
        for (int column = 0; column < parameterColumns; ++column) {
            const QTableWidgetItem *item =
                row < 0 ? m_parameters->horizontalHeaderItem(column) : m_parameters->item(row, column);
            if (column != picture)
                cells << (item ? item->text() : QString());
        }
        lines << cells.join(u'\t');
    }
    QApplication::clipboard()->setText(lines.join(u'\n'));
}

void ComparisonPage::retranslate() {
    m_label->setText(tr("Compared with"));
    m_other->setAccessibleName(m_label->text());
    m_forwards->setText(tr("after − before"));
    m_backwards->setText(tr("before − after"));
    m_untouched->setText(tr("set-up untouched"));
    m_untouched->setToolTip(tr("The instrument stood as it had been aligned for the other test: its "
                               "misalignment is shared"));
    m_tolerance->setToolTip(tr("Up to this a change is of no consequence; empty: none was agreed"));
    nameWidget(*m_copy, tr("Copy the table for a spreadsheet"));
    const QString parameters = tr("Differences of the parameters");
    m_parameters->setAccessibleName(parameters);
    m_conditions->setAccessibleName(
        windowLanguage().text(REPORT_TEXT("report", "Differences of the conditions")));
    fillBox();
    present();
}

} // namespace palmer::ui
