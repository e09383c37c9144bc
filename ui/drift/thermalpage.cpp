// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drift/thermalpage.h"

#include "document/edits.h"
#include "kernel/measurement/testfacts.h"
#include "report/parts/thermalparts.h"
#include "ui/elidedlabel.h"
#include "ui/figures/figurecard.h"
#include "ui/madewidgets.h"
#include "ui/measures.h"
#include "ui/rowtable.h"
#include "ui/testname.h"
#include "ui/windowlanguage.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int driftHeight = 230;
constexpr int temperatureHeight = 150;

} // namespace

ThermalPage::ThermalPage(DocumentModel &model, QWidget *parent)
    : Translated(parent)
    , m_model(model)
    , m_channelLabel(made<QLabel>(trait::secondary, this))
    , m_channel(made<ElidedBox>("thermalChannel", this))
    , m_userLabel(made<QLabel>(trait::secondary, this))
    , m_user(made<ElidedBox>("thermalUser", this))
    , m_take(made<QPushButton>("takeVariation", trait::notDefault, this)) {
    setObjectName(QStringLiteral("thermalPage"));
    m_channelLabel->setBuddy(m_channel);
    m_userLabel->setBuddy(m_user);
    m_user->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto *bar = inRow(nullptr, {pageMargin, 8, pageMargin, 4}, 8,
                      {m_channelLabel, m_channel, Placed::gap(12), m_userLabel, {m_user, 1}, m_take});
    auto *area = new QScrollArea(this);
    trait::scrollsDown(*area);
    auto *content = new QWidget(area->viewport());
    content->setAttribute(Qt::WA_StyledBackground);
    content->setProperty("ground", QStringLiteral("base"));
    m_drift = made<LineView>("driftChannels", content);
    m_drift->setFixedHeight(driftHeight);
    m_temperatures = made<LineView>("driftTemperatures", content);
    m_temperatures->setFixedHeight(temperatureHeight);
    m_responseTitle = made<QLabel>("responseTitle", TextSize::head, content);
    m_responses = new RowTable("responses", 8, content);
    m_responses->setFocusPolicy(Qt::StrongFocus);
    m_notes = made<QLabel>("thermalNotes", TextSize::small, trait::secondary, trait::wrapped, content);
    inColumn(content, {pageMargin, 0, pageMargin, 8}, 6,
             {m_drift, m_temperatures, m_responseTitle, m_responses, m_notes, Placed::stretch(1)});
    area->setWidget(content);
    inColumn(this, noMargins, 0, {bar, {area, 1}});
    connect(m_channel, &QComboBox::activated, this, [this] { present(); });
    connect(m_user, &QComboBox::activated, this, [this] { want(); });
    connect(m_take, &QPushButton::clicked, this, &ThermalPage::take);
}

void ThermalPage::makeSide(QWidget *parent) {
    m_side = made<QWidget>("thermalSide", parent);
    m_side->setAttribute(Qt::WA_StyledBackground);
    m_side->setProperty("ground", QStringLiteral("base"));
    m_variationTitle = made<QLabel>("variationTitle", TextSize::head, m_side);
    m_variation = made<LineView>("variationFigure", m_side);
    m_casesTitle = made<QLabel>("casesTitle", TextSize::head, m_side);
    m_cases = new RowTable("driftCases", 6, m_side);
    m_cases->setFocusPolicy(Qt::StrongFocus);
    inColumn(m_side, {pageMargin, 12, pageMargin, 12}, 6,
             {m_variationTitle, {m_variation, 1}, m_casesTitle, m_cases});
    m_side->hide();
    retranslate();
}

const DriftMeasurement *ThermalPage::drift() const {
    return measured<DriftMeasurement>(m_evaluated, m_test);
}

void ThermalPage::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const bool same = m_test == test && m_evaluated.document == evaluated.document;
    m_evaluated = evaluated;
    m_test = test;
    if (same && m_result)
        return;
    m_result.reset();
    fillBoxes();
    if (isVisible())
        want();
}

void ThermalPage::showEvent(QShowEvent *event) {
    QWidget::showEvent(event);
    if (!m_result)
        want();
}

/// The channels, and the tests that take E_VE from here or could.
void ThermalPage::fillBoxes() {
    const QSignalBlocker quietChannel(m_channel);
    const QSignalBlocker quietUser(m_user);
    const DriftMeasurement *shown = drift();
    m_channel->clear();
    m_user->clear();
    m_users.clear();
    if (!shown)
        return;
    for (const DriftChannel &channel : channelsOf(*shown)) {
        const QString name = QString::fromStdString(channel.name);
        m_channel->addItem(name.isEmpty() ? QString::number(m_channel->count() + 1) : name);
    }
    m_channel->setCurrentIndex(std::max(0, m_channel->findText(QString::fromStdString(shown->axis.name))));
    const std::string &id = m_evaluated.document->tests[m_test]->id;
    const std::vector<std::size_t> takers = testsTaking(*m_evaluated.document, id);
    m_users = takers;
    for (std::size_t i = 0; i < m_evaluated.tests.size(); ++i) {
        const Test &other = *m_evaluated.document->tests[i];
        if (isJudged(other) && std::ranges::find(takers, i) == takers.end() &&
            driftVariation(*m_evaluated.document, id, other))
            m_users.push_back(i);
    }
    for (const std::size_t i : m_users) {
        const Test &other = *m_evaluated.document->tests[i];
        QString name = testName(other);
        if (other.duration)
            name += QStringLiteral(" · ") + windowLanguage().number(*other.duration, Quantity::number) +
                    QStringLiteral(" min");
        m_user->addItem(name);
    }
    m_user->setCurrentIndex(m_users.empty() ? -1 : 0); // a box with a placeholder chooses none itself
    m_user->setEnabled(!m_users.empty());
}

std::optional<std::size_t> ThermalPage::user() const {
    const int at = m_user->currentIndex();
    return at >= 0 && at < static_cast<int>(m_users.size())
               ? std::optional(m_users[static_cast<std::size_t>(at)])
               : std::nullopt;
}

void ThermalPage::want() {
    m_worker.cancel();
    const DriftMeasurement *shown = drift();
    if (!shown)
        return;
    m_worker.start(
        [evaluated = m_evaluated, test = m_test, user = user()](const Background::Job &) {
            Result result;
            result.channels = thermalChannels(*measured<DriftMeasurement>(evaluated, test));
            if (user) {
                result.cases = driftCases(evaluated, *user);
                result.angular = motionOf(*evaluated.document->tests[*user]) == Motion::rotary;
            }
            return result;
        },
        [this](Result done) {
            m_result = std::move(done);
            present();
        });
}

void ThermalPage::fill(RowTable &table, const Table &content) {
    table.clearSpans();
    table.setColumnCount(static_cast<int>(content.columns.size()));
    table.setRowCount(static_cast<int>(content.rows.size()));
    for (int column = 0; column < table.columnCount(); ++column) {
        const Column &head = content.columns[static_cast<std::size_t>(column)];
        const QString unit = head.unit.isEmpty() ? QString() : u' ' + head.unit;
        QString title; // "E_VE", drawn with its subscript
        for (const Span &span : head.title.spans)
            title += (span.subscript ? QStringLiteral("_") : QString()) + span.text;
        table.setHead(column, title + unit, head.alignment != Alignment::left);
    }
    for (int row = 0; row < table.rowCount(); ++row) {
        const auto &cells = content.rows[static_cast<std::size_t>(row)];
        for (int column = 0; column < table.columnCount(); ++column) {
            const Cell &cell = cells[static_cast<std::size_t>(column)];
            const bool number =
                content.columns[static_cast<std::size_t>(column)].alignment != Alignment::left;
            auto *item =
                table.setCell(row, column, cell.text.plain(), number && cell.extras->columns == 1, cell.bold);
            if (!number)
                item->setToolTip(cell.text.plain()); // a narrow window elides it
            if (cell.extras->bar)
                item->setData(RowTable::barRole, *cell.extras->bar);
            if (cell.extras->columns > 1)
                table.setSpan(row, column, 1, static_cast<int>(cell.extras->columns));
        }
    }
}

void ThermalPage::present() {
    const DriftMeasurement *shown = drift();
    if (!m_result || !shown || !m_side)
        return;
    const Language &language = windowLanguage();
    const auto channel = static_cast<std::size_t>(std::max(0, m_channel->currentIndex()));
    const bool any = !shown->times.empty();
    const auto draw = [&](LineView &view, const LineFigure &figure, bool visible) {
        view.setAccessibleName(figure.title);
        view.setFigure(visible && any ? std::optional<Figure>(figure) : std::nullopt);
        view.setVisible(visible);
    };
    const auto taker = user();
    const Test *taking = taker ? m_evaluated.document->tests[*taker].get() : nullptr;
    const std::string &id = m_evaluated.document->tests[m_test]->id;
    const auto found = taking ? takenVariation(*m_evaluated.document, id, *taking) : std::nullopt;
    const bool isWithin = found && taking->duration; // otherwise the window is the whole record
    draw(*m_drift,
         channelFigure(*shown, m_result->channels, channel, language, isWithin ? found : std::nullopt), true);
    const bool hot = !shown->temperatures.empty();
    draw(*m_temperatures, temperatureFigure(*shown, language, isWithin ? found : std::nullopt), hot);
    const std::vector<DriftChannel> channels = channelsOf(*shown);
    const LineFigure variation = variationFigure(
        *shown, channel < channels.size() ? deviationQuantity(channels[channel]) : deviationQuantity(*shown),
        language);
    m_variationTitle->setText(variation.title);
    draw(*m_variation, variation, true);
    fill(*m_responses, responseTable(*shown, m_result->channels, language));
    m_responses->fit(1, 60);
    m_responses->setVisible(hot);
    m_responseTitle->setVisible(hot);
    QStringList notes = thermalNotes(*shown, m_result->channels, language);
    if (!hot)
        notes << tr("No temperatures were recorded with the drift: no response can be told.");
    if (!m_result->cases.cases.empty())
        notes << driftCaseNote(m_result->cases, language);
    notes << language.text(thermalNature());
    m_notes->setText(notes.join(u' '));
    const bool cases = !m_result->cases.cases.empty();
    m_casesTitle->setVisible(cases);
    m_cases->setVisible(cases);
    if (cases) {
        Table table = driftCaseTable(m_result->cases, m_result->angular, language);
        table.columns.pop_back(); // the bars need more room than there is
        fill(*m_cases, table);
        m_cases->fit(0, 120);
    }
    const std::string *taken = taking ? driftTestOf(*taking) : nullptr;
    const bool isTaken = taken && *taken == id;
    m_take->setVisible(found.has_value());
    m_take->setEnabled(found && !isTaken);
    if (found)
        m_take->setText(tr("Take %1 into the budget")
                            .arg(language.quantity(found->variation.value, deviationQuantity(*taking), 1)));
}

/// The chosen test takes its E_VE from this drift test.
void ThermalPage::take() {
    const auto taker = user();
    if (!taker)
        return;
    const std::string id = m_evaluated.document->tests[m_test]->id;
    m_model.edit(QT_TRANSLATE_NOOP("edits", "take E_VE from a drift test"), [&](Document &document) {
        editTest(document, *taker, [&](Test &test) {
            withUncertainty(test, [&](auto &inputs) {
                inputs.driftTest = id;
                inputs.environmentalVariation.reset();
            });
        });
    });
}

void ThermalPage::retranslate() {
    m_channelLabel->setText(tr("Channel"));
    m_channel->setAccessibleName(m_channelLabel->text());
    m_userLabel->setText(tr("serves"));
    m_user->setAccessibleName(tr("The test that takes E_VE from here"));
    m_user->setPlaceholderText(tr("no test of these axes"));
    m_responseTitle->setText(windowLanguage().text(REPORT_TEXT("report", "Response to the temperature")));
    m_responses->setAccessibleName(m_responseTitle->text());
    m_casesTitle->setText(windowLanguage().text(REPORT_TEXT("report", "What the drift explains")));
    m_cases->setAccessibleName(m_casesTitle->text());
    fillBoxes();
    present();
}

} // namespace palmer::ui
