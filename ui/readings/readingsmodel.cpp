// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readings/readingsmodel.h"

#include "editing/editreadings.h"
#include "editing/outliers.h"
#include "editing/typedreading.h"
#include "kernel/evaluation/resultsof.h"
#include "kernel/evaluation/targetvalue.h"
#include "kernel/measurement/readingsaside.h"
#include "language/decimals.h"

#include <algorithm>
#include <utility>

namespace palmer::ui {

namespace {

constexpr std::size_t mostHinted = 20'000; ///< readings; more would noticeably delay each edit

/// True if rows with equal deviations look the same. Precondition: the same rows and columns.
bool differsInDeviationsOnly(const PositioningMeasurement &before, const PositioningMeasurement &now) {
    return before.axis == now.axis && before.targets == now.targets && before.cycle == now.cycle &&
           before.standardDeviation == now.standardDeviation && before.conditions == now.conditions &&
           before.excluded == now.excluded && before.refused == now.refused &&
           readingDecimals(before) == readingDecimals(now);
}

/// The first and last row whose deviations differ; an empty range if none do.
std::pair<int, int> changedRows(const PositioningMeasurement &before, const PositioningMeasurement &now) {
    std::pair rows(static_cast<int>(now.targets.size()), -1);
    for (std::size_t j = 0; j < now.runs.size(); ++j) {
        for (std::size_t i = 0; i < now.targets.size(); ++i) {
            if (readingAt(before, {j, i}) == readingAt(now, {j, i}))
                continue;
            rows.first = std::min(rows.first, static_cast<int>(i));
            rows.second = std::max(rows.second, static_cast<int>(i));
        }
    }
    return rows;
}

} // namespace

bool ReadingsModel::hasSameCells(const PositioningMeasurement *measurement,
                                 const TestEvaluation *evaluation) const {
    if (!measurement || !m_measurement || measurement->targets.size() != m_measurement->targets.size() ||
        readingColumns(*measurement, m_grouping) != m_readings)
        return false;
    return std::ranges::equal(statisticColumns(*evaluation, m_language), m_statistics, {},
                              &StatisticColumn::id, &StatisticColumn::id);
}

void ReadingsModel::show(const EvaluatedDocument &evaluated, std::size_t test) {
    const auto *measurement = measured<PositioningMeasurement>(evaluated, test);
    TestEvaluationPointer evaluation = measurement ? evaluated.tests[test] : nullptr;
    const bool same = hasSameCells(measurement, evaluation.get());
    const std::shared_ptr<const Document> former = m_document; // keeps alive the measurement shown until now
    const PositioningMeasurement *before = m_measurement;
    dropRefused(measurement ? evaluated.document->tests[test]->id : std::string(), measurement);
    const auto outliers = m_outliers;
    const bool wasPending = m_pending;
    const bool sameEdition = m_evaluation && evaluation && m_evaluation->edition == evaluation->edition;
    if (!same)
        beginResetModel();
    m_document = evaluated.document;
    m_evaluation = std::move(evaluation);
    m_pending = evaluated.isPending(test);
    m_measurement = measurement;
    rebuild();
    if (!same) {
        endResetModel();
    } else if (rowCount() > 0) {
        // After typing one reading only its row is repainted.
        std::pair<int, int> rows{0, rowCount() - 1};
        if (sameEdition && !m_pending && !wasPending && outliers == m_outliers &&
            differsInDeviationsOnly(*before, *measurement))
            rows = changedRows(*before, *measurement);
        else
            emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
        if (rows.first <= rows.second)
            emit dataChanged(index(rows.first, 0), index(rows.second, columnCount() - 1));
    }
}

/// Drops refused texts whose target has changed.
void ReadingsModel::dropRefused(const std::string &id, const PositioningMeasurement *now) {
    if (now && m_measurement && id == m_id) {
        m_refusedTargets.removeIf(id, [&](const RefusedTexts::Cell &cell) {
            return now->targets.size() != m_measurement->targets.size() ||
                   now->targets[cell.row] != m_measurement->targets[cell.row];
        });
    }
    m_id = id;
}

void ReadingsModel::refuseTarget(std::size_t target, const QString &text, const QString &reason) {
    m_refusedTargets.put(m_id, {target, positionColumn}, text, reason);
    const QModelIndex cell = index(static_cast<int>(target), positionColumn);
    emit dataChanged(cell, cell);
}

void ReadingsModel::acceptTarget(std::size_t target) {
    m_refusedTargets.remove(m_id, {target, positionColumn});
    const QModelIndex cell = index(static_cast<int>(target), positionColumn);
    emit dataChanged(cell, cell);
}

const RefusedTexts::Refused *ReadingsModel::refusedTarget(int row) const {
    return m_refusedTargets.find(m_id, {static_cast<std::size_t>(row), positionColumn});
}

void ReadingsModel::setLanguage(const Language &language) {
    beginResetModel();
    m_language = language;
    rebuild();
    endResetModel();
}

void ReadingsModel::setUnit(ReadingUnit unit) {
    beginResetModel();
    m_unit = unit;
    rebuild();
    endResetModel();
}

void ReadingsModel::setGrouping(ReadingGrouping grouping) {
    beginResetModel();
    m_grouping = grouping;
    rebuild();
    endResetModel();
}

void ReadingsModel::retranslate() {
    beginResetModel();
    rebuild();
    endResetModel();
}

void ReadingsModel::rebuild() {
    m_readings.clear();
    m_statistics.clear();
    m_heads.clear();
    m_texts.reset();
    m_outliers.clear();
    if (!m_measurement)
        return;
    if (m_measurement->targets.size() * m_measurement->runs.size() <= mostHinted) {
        for (const OutlierHint &hint : outlierHints(*m_measurement))
            m_outliers.insert(hint.place);
    }
    m_texts.emplace(*m_measurement, m_language, m_unit);
    m_readings = readingColumns(*m_measurement, m_grouping);
    m_statistics = statisticColumns(*m_evaluation, m_language);
    const Edition *edition = m_evaluation->edition;
    const QString letter = QString::fromUtf8(edition ? edition->targetLetter : "i");
    m_heads.push_back({formulaFrom(letter), {}, {}, tr("Number of the target")});
    m_heads.push_back(
        {formulaFrom(QStringLiteral("P ") + m_texts->positionUnit()), {}, {}, tr("Target position")});
    for (const ReadingColumn &column : m_readings) {
        const bool up = column.approach == Direction::positive;
        const QString arrow = up ? QStringLiteral("↑") : QStringLiteral("↓");
        const QString number = QString::number(column.number);
        const QString name = tr("Run %1 %2").arg(number, arrow);
        if (m_grouping == ReadingGrouping::byRun)
            m_heads.push_back({formulaFrom(arrow), column.approach, tr("Run %1").arg(number), name});
        else
            m_heads.push_back({formulaFrom(number), column.approach, tr("Runs %1").arg(arrow), name});
    }
    for (const StatisticColumn &column : m_statistics) {
        m_heads.push_back({column.symbol, {}, tr("Computed, %1").arg(m_texts->deviationUnit()), column.name});
    }
}

int ReadingsModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() || !m_measurement ? 0 : static_cast<int>(m_measurement->targets.size());
}

int ReadingsModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_heads.size());
}

int ReadingsModel::computedColumn() const {
    return firstReadingColumn + static_cast<int>(m_readings.size());
}

std::optional<ReadingPlace> ReadingsModel::placeAt(const QModelIndex &index) const {
    if (!index.isValid() || index.column() < firstReadingColumn || index.column() >= computedColumn())
        return std::nullopt;
    return ReadingPlace{m_readings[static_cast<std::size_t>(index.column() - firstReadingColumn)].run,
                        static_cast<std::size_t>(index.row())};
}

bool ReadingsModel::holds(const ReadingPlace &place) const {
    return m_measurement && place.run < m_measurement->runs.size() &&
           place.target < m_measurement->targets.size();
}

QModelIndex ReadingsModel::indexOf(const ReadingPlace &place) const {
    if (!holds(place))
        return {};
    const auto found = std::ranges::find(m_readings, place.run, &ReadingColumn::run);
    return index(static_cast<int>(place.target),
                 firstReadingColumn + static_cast<int>(found - m_readings.begin()));
}

QString ReadingsModel::text(const QModelIndex &index) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (index.column() == numberColumn)
        return QString::number(index.row() + 1);
    if (index.column() == positionColumn) {
        const RefusedTexts::Refused *refused = refusedTarget(index.row());
        return refused ? refused->text : m_texts->position(row);
    }
    if (const auto place = placeAt(index)) {
        const RefusedReading *refused = refusedAt(*m_measurement, *place);
        return refused ? QString::fromStdString(refused->text)
                       : m_texts->reading(place->run, place->target).text;
    }
    if (m_pending)
        return QStringLiteral("…");
    const PositioningResults &results = resultsOf(*m_measurement, *m_evaluation);
    const auto column = static_cast<std::size_t>(index.column() - computedColumn());
    return m_texts->statistic(targetValue(m_statistics[column].id, results.targets[row],
                                          m_evaluation->edition ? m_evaluation->edition->c : 0));
}

std::vector<std::size_t> ReadingsModel::runs() const {
    std::vector<std::size_t> result;
    for (const ReadingColumn &column : m_readings)
        result.push_back(column.run);
    return result;
}

QString ReadingsModel::plainText(const QModelIndex &index) const {
    if (!index.isValid() || !m_texts)
        return {};
    const auto row = static_cast<std::size_t>(index.row());
    const auto plain = [this](double value, Quantity quantity) {
        QString text = m_language.number(value, quantity);
        return text.remove(u'\u202F').replace(u'\u2212', u'-');
    };
    if (index.column() == positionColumn && !refusedTarget(index.row()))
        return plain(m_measurement->targets[row], positionQuantity(m_measurement->axis));
    const auto place = placeAt(index);
    if (!place)
        return text(index).remove(u'\u202F').replace(u'\u2212', u'-');
    if (const RefusedReading *refused = refusedAt(*m_measurement, *place))
        return QString::fromStdString(refused->text);
    const auto deviation = readingAt(*m_measurement, *place);
    if (!deviation)
        return {};
    if (m_unit == ReadingUnit::deviations)
        return plain(*deviation, deviationQuantity(m_measurement->axis));
    const double target = m_measurement->targets[row];
    return plain(target + deviationFrom(0, *deviation), positionQuantity(m_measurement->axis));
}

/// Why the cell is red; empty if it is not.
QString ReadingsModel::refusal(const QModelIndex &index) const {
    if (index.column() == positionColumn) {
        const RefusedTexts::Refused *refused = refusedTarget(index.row());
        return refused ? refused->reason : QString();
    }
    const auto place = placeAt(index);
    const RefusedReading *refused = place ? refusedAt(*m_measurement, *place) : nullptr;
    if (!refused)
        return {};
    // A text refused in a pasted block may be a number when typed, with the other decimal mark.
    const auto problem = enteredNumber(QString::fromStdString(refused->text), Quantity::number).refusal;
    return problem ? m_language.text(*problem) : tr("other decimal mark");
}

QString ReadingsModel::toolTip(const QModelIndex &index) const {
    if (const QString reason = refusal(index); !reason.isEmpty())
        return index.column() == positionColumn
                   ? tr("%1: not taken, the target stays where it was").arg(reason)
                   : tr("%1: not taken, the reading is missing").arg(reason);
    const auto place = placeAt(index);
    if (!place)
        return {};
    if (m_outliers.contains(*place))
        return tr("Far from the other readings here: a typing error?");
    const ShownReading reading = m_texts->reading(place->run, place->target);
    if (!reading.excluded)
        return {};
    return reading.reason.isEmpty() ? tr("Set aside, without a reason")
                                    : tr("Set aside: %1").arg(reading.reason);
}

QString ReadingsModel::accessibleText(const QModelIndex &index) const {
    const QString where =
        tr("target %1, %2").arg(QString::number(index.row() + 1), head(index.column()).name) +
        QStringLiteral(": ");
    if (const QString reason = refusal(index); !reason.isEmpty())
        return where + text(index) + QStringLiteral(", ") + reason;
    const auto place = placeAt(index);
    if (place && m_texts->reading(place->run, place->target).missing)
        return where + tr("no reading");
    return where + text(index);
}

QVariant ReadingsModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid() || !m_texts)
        return {};
    const auto place = placeAt(index);
    switch (role) {
    case Qt::DisplayRole:
        return text(index);
    case Qt::TextAlignmentRole:
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::EditRole:
        return plainText(index);
    case refusedRole:
        return refusal(index);
    case outlierRole:
        return place && m_outliers.contains(*place);
    case Qt::ToolTipRole:
        return toolTip(index);
    case Qt::AccessibleTextRole:
        return accessibleText(index);
    case excludedRole:
        return place && m_texts->reading(place->run, place->target).excluded;
    case missingRole:
        return place && refusal(index).isEmpty() && m_texts->reading(place->run, place->target).missing;
    case groupEndRole:
        return index.column() == positionColumn ||
               (place && m_readings[static_cast<std::size_t>(index.column() - firstReadingColumn)].endsGroup);
    default:
        return {};
    }
}

QVariant ReadingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (section < 0)
        return {};
    if (orientation == Qt::Vertical)
        return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant();
    if (section >= columnCount())
        return {};
    switch (role) {
    case Qt::DisplayRole:
        return head(section).text.plain();
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return head(section).name;
    default:
        return {};
    }
}

Qt::ItemFlags ReadingsModel::flags(const QModelIndex &index) const {
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return index.column() == positionColumn || placeAt(index) ? flags | Qt::ItemIsEditable : flags;
}

QString ReadingsModel::keptAside(const std::vector<ReadingPlace> &places) const {
    if (!m_measurement)
        return {};
    const auto count =
        std::ranges::count_if(places, [aside = ReadingsAside(*m_measurement)](const ReadingPlace &place) {
            return aside.at(place.run, place.target) != nullptr;
        });
    if (count == 0)
        return {};
    return tr("%n reading(s) set aside and left so: take back first (%1)", nullptr, static_cast<int>(count))
        .arg(bringBackKeys().toString(QKeySequence::NativeText));
}

QKeySequence ReadingsModel::bringBackKeys() {
    return {Qt::CTRL | Qt::SHIFT | Qt::Key_E};
}

QString ReadingsModel::summary(const QModelIndexList &indexes) const {
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (const QModelIndex &index : indexes) {
        if (const auto place = placeAt(index))
            places.emplace_back(place->run, place->target);
    }
    return m_texts && !places.empty() ? m_texts->summary(places) : QString();
}

QStringList ReadingsModel::widestTexts(int column) const {
    QStringList texts;
    if (!m_measurement || m_measurement->targets.empty())
        return texts;
    const int last = rowCount() - 1;
    if (column < firstReadingColumn || column >= computedColumn()) {
        for (const int row : {0, last / 2, last})
            texts << text(index(row, column));
        return texts;
    }
    // All reading columns are as wide as the extreme values need.
    std::optional<ReadingPlace> least;
    std::optional<ReadingPlace> most;
    for (std::size_t j = 0; j < m_measurement->runs.size(); ++j) {
        const auto &deviations = m_measurement->runs[j].deviations;
        for (std::size_t i = 0; i < std::min(deviations.size(), m_measurement->targets.size()); ++i) {
            if (!deviations[i])
                continue;
            if (!least || *deviations[i] < *m_measurement->runs[least->run].deviations[least->target])
                least = ReadingPlace{j, i};
            if (!most || *deviations[i] > *m_measurement->runs[most->run].deviations[most->target])
                most = ReadingPlace{j, i};
        }
    }
    for (const auto &place : {least, most}) {
        if (place)
            texts << m_texts->reading(place->run, place->target).text;
    }
    if (most && m_unit == ReadingUnit::positions)
        texts << m_texts->reading(most->run, m_measurement->targets.size() - 1).text;
    return texts;
}

} // namespace palmer::ui
