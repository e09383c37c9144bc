// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/circles/pointsmodel.h"

#include "kernel/evaluation/iso230_4/paths.h"
#include "ui/quiettable.h"
#include "ui/theme.h"

#include <QApplication>
#include <algorithm>
#include <limits>

namespace palmer::ui {

namespace {

constexpr int pointAngleDecimals = 4;
constexpr int mostDeviationDecimals = 3;
constexpr int lengthDecimals = 5; ///< mm, as fine as deviations

} // namespace

bool PointsModel::hasSameCells(const CircularMeasurement *measurement) const {
    constexpr auto points = [](const Arc &arc) { return arc.angles.size(); };
    return measurement && m_measurement &&
           std::ranges::equal(measurement->arcs, m_measurement->arcs, {}, points, points);
}

/// Drops a refused text if its point has changed.
void PointsModel::dropRefused(const CircularMeasurement *now) {
    const bool same = hasSameCells(now);
    m_refused.removeIf(m_id, [&](const RefusedTexts::Cell &cell) {
        const auto number = [&cell](const CircularMeasurement &measurement) {
            const Arc &arc = measurement.arcs[cell.column / 2];
            return cell.column % 2 == 0 ? arc.angles[cell.row] : arc.radialDeviations[cell.row];
        };
        return !same || number(*now) != number(*m_measurement);
    });
}

/// If the cells stay the same, only their data change, so that an open editor stays open.
void PointsModel::show(const EvaluatedDocument &evaluated, std::size_t test, const Language &language) {
    const auto *measurement = measured<CircularMeasurement>(evaluated, test);
    const std::string id = measurement ? evaluated.document->tests[test]->id : std::string();
    const bool same = id == m_id && hasSameCells(measurement);
    if (id == m_id)
        dropRefused(measurement);
    const std::shared_ptr<const Document> former = m_document; // keeps alive what was shown until now
    if (!same)
        beginResetModel();
    m_document = evaluated.document;
    m_measurement = measurement;
    m_id = id;
    m_language = language;
    m_arcs.clear();
    std::size_t rows = 0;
    for (std::size_t k = 0; m_measurement && k < m_measurement->arcs.size(); ++k) {
        const Arc &arc = m_measurement->arcs[k];
        rows = std::max(rows, arc.angles.size());
        m_arcs.push_back({iso230_4::evaluatedRange(arc),
                          decimalsOf(arc.angles, Quantity::angle, pointAngleDecimals),
                          decimalsOf(arc.radialDeviations, Quantity::deviation, mostDeviationDecimals)});
    }
    m_rows = static_cast<int>(std::min<std::size_t>(rows, std::numeric_limits<int>::max() / 64));
    if (!same) {
        endResetModel();
    } else if (m_rows > 0) {
        emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
        emit dataChanged(index(0, 0), index(m_rows - 1, columnCount() - 1));
    }
}

RefusedTexts::Cell PointsModel::cellOf(const QModelIndex &index) const {
    return {static_cast<std::size_t>(index.row()), 2 * arcOf(index.column()) + (isAngle(index) ? 0U : 1U)};
}

const RefusedTexts::Refused *PointsModel::refused(const QModelIndex &index) const {
    return placeAt(index) ? m_refused.find(m_id, cellOf(index)) : nullptr;
}

void PointsModel::refuse(const QModelIndex &index, const QString &text, const QString &reason) {
    m_refused.put(m_id, cellOf(index), text, reason);
    emit dataChanged(index, index);
}

void PointsModel::accept(const QModelIndex &index) {
    m_refused.remove(m_id, cellOf(index));
    emit dataChanged(index, index);
}

void PointsModel::setUnit(PointUnit unit) {
    if (m_unit == unit)
        return;
    beginResetModel();
    m_unit = unit;
    endResetModel();
}

int PointsModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int PointsModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : 1 + columnsPerArc() * static_cast<int>(m_arcs.size());
}

std::optional<ReadingPlace> PointsModel::placeAt(const QModelIndex &index) const {
    if (!index.isValid() || index.column() == 0)
        return std::nullopt;
    const ReadingPlace place{arcOf(index.column()), static_cast<std::size_t>(index.row())};
    return place.target < m_measurement->arcs[place.run].angles.size() ? std::optional(place) : std::nullopt;
}

QModelIndex PointsModel::indexOf(const ReadingPlace &place) const {
    if (place.run >= m_arcs.size() || place.target >= m_measurement->arcs[place.run].angles.size())
        return {};
    return index(static_cast<int>(place.target), 2 + columnsPerArc() * static_cast<int>(place.run));
}

QString PointsModel::text(const Arc &arc, const ArcColumns &columns, std::size_t point, int part) const {
    if (part == 0)
        return m_language.number(arc.angles[point], Quantity::angle, columns.angleDecimals);
    const double distance = m_measurement->nominalRadius + arc.radialDeviations[point];
    switch (m_unit) {
    case PointUnit::deviations:
        return m_language.number(arc.radialDeviations[point], Quantity::deviation, columns.deviationDecimals);
    case PointUnit::lengths:
        return m_language.number(distance, Quantity::position, lengthDecimals);
    case PointUnit::coordinates: {
        const Point unit = direction(arc.angles[point]);
        return m_language.number(distance * (part == 1 ? unit.x : unit.y), Quantity::position,
                                 lengthDecimals);
    }
    }
    return {};
}

/// All digits, as the editor takes them.
QString PointsModel::plainText(const QModelIndex &index, const ReadingPlace &place) const {
    if (const RefusedTexts::Refused *text = refused(index))
        return text->text;
    const Arc &arc = m_measurement->arcs[place.run];
    const double deviation = arc.radialDeviations[place.target];
    QString text = isAngle(index) ? m_language.number(arc.angles[place.target], Quantity::angle)
                   : m_unit == PointUnit::lengths
                       ? m_language.number(m_measurement->nominalRadius + deviation, Quantity::position)
                       : m_language.number(deviation, Quantity::deviation);
    return text.remove(u'\u202F').replace(u'\u2212', u'-');
}

Qt::ItemFlags PointsModel::flags(const QModelIndex &index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    const bool coordinate = m_unit == PointUnit::coordinates && !isAngle(index); // they come in pairs
    return placeAt(index) && !coordinate ? flags | Qt::ItemIsEditable : flags;
}

bool PointsModel::setData(const QModelIndex &index, const QVariant &value, int role) {
    const auto place = placeAt(index);
    if (role != Qt::EditRole || !place || value.toString() == plainText(index, *place))
        return false;
    emit typed(index, value.toString());
    return true;
}

QVariant PointsModel::data(const QModelIndex &index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::EditRole) {
        const auto place = placeAt(index);
        return place ? QVariant(plainText(index, *place)) : QVariant();
    }
    if (role == QuietDelegate::refusedRole)
        return refused(index) != nullptr;
    if (role == Qt::ToolTipRole || role == Qt::AccessibleDescriptionRole)
        return refused(index) ? QVariant(refused(index)->reason) : QVariant();
    if (role != Qt::DisplayRole && role != Qt::ForegroundRole)
        return {};
    if (index.column() == 0)
        return role == Qt::DisplayRole ? QVariant(m_language.number(index.row() + 1, Quantity::count, 0))
                                       : QVariant(token(Token::secondaryText, QApplication::palette()));
    const auto place = placeAt(index);
    if (!place)
        return {};
    const Arc &arc = m_measurement->arcs[place->run];
    const ArcColumns &columns = m_arcs[place->run];
    if (const RefusedTexts::Refused *text = refused(index))
        return role == Qt::DisplayRole ? QVariant(text->text) : QVariant();
    if (role == Qt::DisplayRole)
        return text(arc, columns, place->target, (index.column() - 1) % columnsPerArc());
    const double angle = arc.angles[place->target];
    const bool evaluated =
        columns.evaluated && angle >= columns.evaluated->from && angle <= columns.evaluated->to;
    return evaluated ? QVariant() : QVariant(token(Token::secondaryText, QApplication::palette()));
}

QVariant PointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    if (section == 0)
        return role == Qt::DisplayRole ? QVariant(QStringLiteral("n")) : QVariant();
    const std::size_t arc = arcOf(section);
    if (arc >= m_arcs.size())
        return {};
    const Sense sense = m_measurement->arcs[arc].sense;
    if (role == Qt::ForegroundRole)
        return token(sense == Sense::counterclockwise ? Token::up : Token::downText, QApplication::palette());
    if (role == Qt::ToolTipRole)
        return arcName(*m_measurement, arc);
    if (role != Qt::DisplayRole)
        return {};
    const int part = (section - 1) % columnsPerArc();
    if (part == 0)
        return tr("angle °");
    switch (m_unit) {
    case PointUnit::deviations:
        return QStringLiteral("Δr %1 ").arg(m_language.unit(Quantity::deviation)) + senseWord(sense);
    case PointUnit::lengths:
        return QStringLiteral("r %1 ").arg(m_language.unit(Quantity::position)) + senseWord(sense);
    case PointUnit::coordinates:
        return QString::fromStdString(part == 1 ? m_measurement->plane.first : m_measurement->plane.second) +
               u' ' + m_language.unit(Quantity::position) + u' ' + senseWord(sense);
    }
    return {};
}

} // namespace palmer::ui
