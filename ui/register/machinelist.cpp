// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/machinelist.h"

#include "register/listing.h"
#include "register/machineidentity.h"
#include "ui/elidedlabel.h"
#include "ui/measures.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

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
    const bool isShown = state.accordance == Accordance::yes || state.accordance == Accordance::partly;
    if (state.verdict == Verdict::conforms && isShown)
        return {QStringLiteral("check"), Token::ok};
    return {QStringLiteral("ques"), Token::secondaryText};
}

/// Beside its name: the serial number, or the mark of a machine without one, its maker and type.
void drawEvidence(QPainter &painter, QRect area, const MachineRow &row, const QPalette &palette) {
    QString text = row.machine.serialNumber;
    QColor colour = token(Token::secondaryText, palette);
    if (!row.machine.isIdentified) {
        text = MachineModel::tr("not identified");
        for (const QString &fact : {row.machine.manufacturer, row.machine.model})
            text += fact.isEmpty() ? QString() : QStringLiteral(" · ") + fact;
        colour = token(Token::unsure, palette);
        drawLineIcon(painter, QRect(area.left(), area.top(), machineMarkSize, area.height()),
                     QStringLiteral("ques"), colour);
        area.adjust(machineMarkSize + 3, 0, 0, 0);
    }
    if (text != row.title() && area.width() > machineMarkSize)
        drawElided(painter, area, Qt::AlignLeft, text, themeFont(TextSize::tiny), colour);
}

} // namespace

QString MachineRow::title() const {
    const QString title = machine.title();
    return title.isEmpty() ? MachineModel::tr("without name") : title;
}

std::optional<int> MachineRow::daysToTest(const QDate &today) const {
    return daysUntil(due.test(), today);
}

std::optional<int> MachineRow::daysToCertificate(const QDate &today) const {
    return daysUntil(due.certificate, today);
}

bool MachineRow::isToDo(const QDate &today) const {
    return daysToTest(today) || daysToCertificate(today) ||
           std::ranges::any_of(
               axes, [](const AxisState &state) { return state.verdict == Verdict::doesNotConform; });
}

QStringList MachineRow::facts() const {
    QStringList facts{machine.manufacturer, machine.model,
                      machine.isIdentified ? MachineModel::tr("No. %1").arg(machine.serialNumber)
                                           : MachineModel::tr("not identified: no serial number"),
                      machine.location};
    if (!machine.joined.empty())
        facts << joinedText(machine, windowLanguage());
    facts.removeAll(QString());
    return facts;
}

void MachineModel::setRows(std::vector<MachineRow> rows) {
    m_all = std::move(rows);
    filter();
}

void MachineModel::setFilter(const QString &words, Show show) {
    m_words = words;
    m_show = show;
    filter();
}

void MachineModel::filter() {
    std::vector<MachineRow> shown;
    const QDate today = QDate::currentDate();
    const QString wanted = comparable(m_words);
    for (const MachineRow &row : m_all) {
        if ((m_show == Show::all || row.isToDo(today)) && searched(row.machine).contains(wanted))
            shown.push_back(row);
    }
    reset(std::move(shown));
}

int MachineModel::toDoCount() const {
    const QDate today = QDate::currentDate();
    return static_cast<int>(
        std::ranges::count_if(m_all, [&](const MachineRow &machine) { return machine.isToDo(today); }));
}

int MachineModel::testCount() const {
    int tests = 0;
    for (const MachineRow &row : m_all)
        tests += row.tests;
    return tests;
}

QVariant MachineModel::cell(const MachineRow &machine, int, int role) const {
    if (role == Qt::DisplayRole)
        return machine.title();
    if (role == Qt::ToolTipRole)
        return machine.facts().join(QStringLiteral(" · "));
    if (role == Qt::AccessibleTextRole)
        return machine.title() + QStringLiteral(", ") + machine.facts().join(QStringLiteral(", "));
    return {};
}

void MachineDelegate::paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                                   const QModelIndex &index) const {
    const MachineRow &row = static_cast<const MachineModel *>(index.model())->row(index.row());
    const QDate today = QDate::currentDate();
    const QPalette &palette = option.palette;
    const QRect area = option.rect.adjusted(pageMargin, 6, -pageMargin, -6);
    painter.setPen(token(Token::line, palette));
    painter.drawLine(area.left(), option.rect.bottom(), area.right(), option.rect.bottom());

    int right = area.right();
    const QFont small = themeFont(TextSize::tiny);
    if (const auto days = row.daysToTest(today)) {
        const QString text = *days < 0 ? tr("overdue %1 d").arg(-*days) : tr("due in %1 d").arg(*days);
        painter.setFont(small);
        const int width = painter.fontMetrics().horizontalAdvance(text) + 12;
        const QRectF pill(right - width + 1, area.top(), width, pillHeight);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(token(*days < 0 ? Token::badGround : Token::unsureGround, palette));
        painter.drawRoundedRect(pill, pillRadius, pillRadius);
        painter.setPen(token(*days < 0 ? Token::bad : Token::unsure, palette));
        painter.drawText(pill, Qt::AlignCenter, text);
        right -= width + 6;
    }
    QFont name = themeFont(TextSize::base);
    name.setBold(option.state & QStyle::State_Selected);
    const QString title = index.data().toString();
    const int titleWidth = std::min(QFontMetrics(name).horizontalAdvance(title) + 1, right - area.left());
    drawElided(painter, {area.left(), area.top(), titleWidth, pillHeight}, Qt::AlignLeft, title, name,
               palette.color(QPalette::Text));
    drawEvidence(painter,
                 {area.left() + titleWidth + 8, area.top(), right - area.left() - titleWidth - 8, pillHeight},
                 row, palette);

    painter.setFont(small);
    int left = area.left();
    int rest = area.right();
    const int y = area.bottom() - pillHeight + 1;
    if (const auto days = row.daysToCertificate(today)) {
        const QString text = *days < 0 ? tr("expired") : tr("%1 d").arg(*days);
        const int width = painter.fontMetrics().horizontalAdvance(text);
        const QColor colour = token(*days < 0 ? Token::bad : Token::unsure, palette);
        painter.setPen(colour);
        painter.drawText(QRect(rest - width, y, width + 1, pillHeight), Qt::AlignVCenter, text);
        drawLineIcon(painter, QRect(rest - width - 18, y, 14, pillHeight), QStringLiteral("cert"), colour);
        rest -= width + 22;
    }
    for (const AxisState &state : row.axes) {
        if (left + raster > rest)
            break;
        painter.setPen(token(Token::secondaryText, palette));
        painter.drawText(QRect(left, y, raster, pillHeight), Qt::AlignLeft | Qt::AlignVCenter, state.axis);
        const int word = painter.fontMetrics().horizontalAdvance(state.axis);
        const MarkLook look = lookOf(state);
        drawLineIcon(painter, QRect(left + word + 3, y, machineMarkSize, pillHeight), look.icon,
                     token(look.token, palette));
        left += std::max(raster, word + machineMarkSize + 10);
    }
}

QSize MachineDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const {
    return {100, machineRowHeight};
}

} // namespace palmer::ui
