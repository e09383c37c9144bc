// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/machinelist.h"

#include "register/machineidentity.h"
#include "ui/measures.h"
#include "ui/theme.h"

#include <QPainter>
#include <algorithm>

namespace palmer::ui {

namespace {

constexpr int raster = 40;
constexpr int machineMarkSize = 12;
constexpr int pillHeight = 17;
constexpr double pillRadius = 8.5;

std::optional<int> daysUntil(const std::optional<QDate> &date, const QDate &today) {
    if (!date)
        return std::nullopt;
    const auto days = static_cast<int>(today.daysTo(*date));
    return days <= warningDays ? std::optional(days) : std::nullopt;
}

struct MarkLook {
    QString icon;
    Token token;
};

MarkLook lookOf(const AxisState &state) {
    if (state.verdict == Verdict::doesNotConform)
        return {QStringLiteral("cross"), Token::bad};
    if (state.verdict == Verdict::notProven)
        return {QStringLiteral("ques"), Token::unsure};
    if (state.accordance == Accordance::no)
        return {QStringLiteral("warn"), Token::unsure};
    if (state.verdict == Verdict::conforms)
        return {QStringLiteral("check"), Token::ok};
    return {QStringLiteral("ques"), Token::secondaryText};
}

} // namespace

std::optional<int> MachineRow::daysToTest(const QDate &today) const {
    return daysUntil(due.test, today);
}

std::optional<int> MachineRow::daysToCertificate(const QDate &today) const {
    return daysUntil(due.certificate, today);
}

bool MachineRow::isToDo(const QDate &today) const {
    return daysToTest(today) || daysToCertificate(today) ||
           std::ranges::any_of(
               axes, [](const AxisState &state) { return state.verdict == Verdict::doesNotConform; });
}

void MachineModel::setRows(std::vector<MachineRow> rows) {
    beginResetModel();
    m_all = std::move(rows);
    filter();
    endResetModel();
}

void MachineModel::setFilter(const QString &words, Show show) {
    beginResetModel();
    m_words = words;
    m_show = show;
    filter();
    endResetModel();
}

void MachineModel::filter() {
    m_shown.clear();
    const QDate today = QDate::currentDate();
    const QString wanted = comparable(m_words);
    for (std::size_t i = 0; i < m_all.size(); ++i) {
        const ListedMachine &machine = m_all[i].machine;
        const QString all = comparable(machine.name) + u' ' + comparable(machine.manufacturer) + u' ' +
                            comparable(machine.model) + comparable(machine.serialNumber) + u' ' +
                            comparable(machine.location);
        const bool isKind = m_show == Show::toDo ? m_all[i].isToDo(today)
                                                 : machine.isIdentified == (m_show == Show::identified);
        if (isKind && all.contains(wanted))
            m_shown.push_back(i);
    }
}

int MachineModel::rowOf(int machine) const {
    for (std::size_t i = 0; i < m_shown.size(); ++i) {
        if (m_all[m_shown[i]].machine.id == machine)
            return static_cast<int>(i);
    }
    return -1;
}

int MachineModel::toDoCount() const {
    const QDate today = QDate::currentDate();
    return static_cast<int>(
        std::ranges::count_if(m_all, [&](const MachineRow &machine) { return machine.isToDo(today); }));
}

int MachineModel::unidentifiedTests() const {
    int tests = 0;
    for (const MachineRow &row : m_all)
        tests += row.machine.isIdentified ? 0 : row.tests;
    return tests;
}

int MachineModel::identifiedCount() const {
    return static_cast<int>(
        std::ranges::count_if(m_all, [](const MachineRow &row) { return row.machine.isIdentified; }));
}

int MachineModel::testCount() const {
    int tests = 0;
    for (const MachineRow &row : m_all)
        tests += row.tests;
    return tests;
}

int MachineModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

QVariant MachineModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid())
        return {};
    const MachineRow &machine = row(index.row());
    if (role == Qt::DisplayRole)
        return machine.machine.isIdentified ? machine.machine.title()
                                            : tr("%1 (not identified)").arg(machine.machine.title());
    if (role == idRole)
        return machine.machine.id;
    if (role == Qt::ToolTipRole) {
        QStringList lines{machine.machine.manufacturer, machine.machine.model, machine.machine.serialNumber,
                          machine.machine.location};
        lines.removeAll(QString());
        return lines.join(QStringLiteral(" · "));
    }
    return {};
}

void MachineDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                            const QModelIndex &index) const {
    const auto *model = qobject_cast<const MachineModel *>(index.model());
    if (!model)
        return;
    const MachineRow &row = model->row(index.row());
    const QDate today = QDate::currentDate();
    const QPalette &palette = option.palette;
    painter->save();
    const bool selected = (option.state & QStyle::State_Selected) != 0;
    if (selected) {
        painter->fillRect(option.rect, selectedGround(palette));
        painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())),
                          token(Token::accent, palette));
    } else if ((option.state & QStyle::State_MouseOver) != 0) {
        painter->fillRect(option.rect, token(Token::hover, palette));
    }
    QRect area = option.rect.adjusted(pageMargin, 6, -pageMargin, -6);
    painter->setPen(token(Token::line, palette));
    painter->drawLine(area.left(), option.rect.bottom(), area.right(), option.rect.bottom());

    int right = area.right();
    QFont small = themeFont(TextSize::tiny);
    if (const auto days = row.daysToTest(today)) {
        const QString text = *days < 0 ? tr("overdue %1 d").arg(-*days) : tr("due in %1 d").arg(*days);
        painter->setFont(small);
        const int width = painter->fontMetrics().horizontalAdvance(text) + 12;
        const QRectF pill(right - width + 1, area.top(), width, pillHeight);
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(token(*days < 0 ? Token::badGround : Token::unsureGround, palette));
        painter->drawRoundedRect(pill, pillRadius, pillRadius);
        painter->setPen(token(*days < 0 ? Token::bad : Token::unsure, palette));
        painter->drawText(pill, Qt::AlignCenter, text);
        right -= width + 6;
    }
    QFont name = themeFont(TextSize::base);
    name.setBold(selected);
    painter->setFont(name);
    painter->setPen(palette.color(QPalette::Text));
    const QRect top(area.left(), area.top(), right - area.left(), pillHeight);
    painter->drawText(
        top, Qt::AlignLeft | Qt::AlignVCenter,
        painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, top.width()));

    painter->setFont(small);
    int left = area.left();
    int rest = area.right();
    const int y = area.bottom() - pillHeight + 1;
    if (const auto days = row.daysToCertificate(today)) {
        const QString text = *days < 0 ? tr("expired") : tr("%1 d").arg(*days);
        const int width = painter->fontMetrics().horizontalAdvance(text);
        const QColor colour = token(*days < 0 ? Token::bad : Token::unsure, palette);
        painter->setPen(colour);
        painter->drawText(QRect(rest - width, y, width + 1, pillHeight), Qt::AlignVCenter, text);
        drawLineIcon(*painter, QRect(rest - width - 18, y, 14, pillHeight), QStringLiteral("cert"), colour);
        rest -= width + 22;
    }
    for (const AxisState &state : row.axes) {
        if (left + raster > rest)
            break;
        painter->setPen(token(Token::secondaryText, palette));
        painter->drawText(QRect(left, y, raster, pillHeight), Qt::AlignLeft | Qt::AlignVCenter, state.axis);
        const int word = painter->fontMetrics().horizontalAdvance(state.axis);
        const MarkLook look = lookOf(state);
        drawLineIcon(*painter, QRect(left + word + 3, y, machineMarkSize, pillHeight), look.icon,
                     token(look.token, palette));
        left += std::max(raster, word + machineMarkSize + 10);
    }
    painter->restore();
}

QSize MachineDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const {
    return {100, machineRowHeight};
}

} // namespace palmer::ui
