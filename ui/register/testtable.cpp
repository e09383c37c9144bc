// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/testtable.h"

#include "kernel/measurement/testfacts.h"
#include "register/listing.h"
#include "register/machinetrend.h"
#include "report/words/wording.h"
#include "ui/register/numbertag.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr std::size_t mostResults = 5;

const RegisteredResult *resultOf(const RegisteredTest &test, const std::string &id) {
    const auto found = std::ranges::find(test.results, id, &RegisteredResult::id);
    return found == test.results.end() ? nullptr : &*found;
}

TrendMark markOf(TestRole role) {
    return role == TestRole::asLeft    ? TrendMark::asLeft
           : role == TestRole::asFound ? TrendMark::asFound
                                       : TrendMark::noRole;
}

QString said(const Text &text) {
    return text.empty() ? QString() : windowLanguage().text(text);
}

bool hasLimits(const RegisteredTest &test) {
    return std::ranges::any_of(test.results,
                               [](const RegisteredResult &result) { return result.limit.has_value(); });
}

} // namespace

void TestTableModel::setTests(std::vector<ListedTest> tests) {
    beginResetModel();
    std::ranges::reverse(tests); // newest first
    m_tests = std::move(tests);
    m_results = parametersOf(m_tests);
    if (m_results.size() > mostResults)
        m_results.resize(mostResults);
    m_numbers.clear();
    endResetModel();
}

void TestTableModel::setNumbers(std::map<int, int> numbers) {
    if (numbers == m_numbers)
        return;
    m_numbers = std::move(numbers);
    if (!m_tests.empty())
        emit dataChanged(index(0, markColumn), index(rowCount() - 1, markColumn));
}

void TestTableModel::retranslate() {
    beginResetModel();
    endResetModel();
}

int TestTableModel::rowCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_tests.size());
}

int TestTableModel::columnCount(const QModelIndex &parent) const {
    return parent.isValid() ? 0 : firstResult + static_cast<int>(m_results.size()) + 2;
}

QVariant TestTableModel::resultData(const RegisteredTest &test, std::size_t column, int role) const {
    const RegisteredResult *result = resultOf(test, m_results[column]);
    if (role == sortRole)
        return result && result->value ? QVariant(*result->value) : QVariant();
    if (!result)
        return {};
    const ShownResult shown = shownResult(*result, test.angular, windowLanguage());
    if (role == Qt::DisplayRole)
        return shown.value;
    return role == uncertaintyRole ? QVariant(shown.uncertainty) : QVariant();
}

TestTableModel::Longest TestTableModel::longest(std::size_t result) const {
    // Digits are equally wide, so the widest numbers have the most characters; only these are formatted.
    const DisplayUnits &units = windowLanguage().units();
    const RegisteredTest *value = nullptr;
    const RegisteredTest *expanded = nullptr;
    int mostOfValue = -1;
    int mostOfExpanded = -1;
    const auto characters = [](double number, int decimals) {
        const double size = std::abs(number);
        const int whole = size < 10 ? 1 : static_cast<int>(std::log10(size)) + 1;
        return whole + (whole - 1) / 3 + (number < 0 ? 1 : 0) + decimals;
    };
    for (const ListedTest &listed : m_tests) {
        const RegisteredResult *found = resultOf(listed.test, m_results[result]);
        if (!found || !found->value)
            continue;
        const double scale =
            unitScale(listed.test.angular ? Quantity::angularDeviation : Quantity::deviation, units);
        const int ofValue = characters(*found->value * scale, found->decimals.value_or(0));
        if (ofValue > mostOfValue) {
            mostOfValue = ofValue;
            value = &listed.test;
        }
        if (!found->expandedUncertainty)
            continue;
        const int ofExpanded =
            characters(*found->expandedUncertainty * scale, found->uncertaintyDecimals.value_or(0));
        if (ofExpanded > mostOfExpanded) {
            mostOfExpanded = ofExpanded;
            expanded = &listed.test;
        }
    }
    Longest longest;
    if (value)
        longest.value =
            shownResult(*resultOf(*value, m_results[result]), value->angular, windowLanguage()).value;
    if (expanded)
        longest.uncertainty =
            shownResult(*resultOf(*expanded, m_results[result]), expanded->angular, windowLanguage())
                .uncertainty;
    return longest;
}

QVariant TestTableModel::limitsData(const RegisteredTest &test, int role) {
    const bool exceeded = test.verdict == Verdict::doesNotConform;
    const bool respected = test.verdict == Verdict::conforms;
    switch (role) {
    case Qt::DisplayRole:
        return said(limitsText(test.verdict, hasLimits(test)));
    case sortRole:
        return test.verdict ? static_cast<int>(*test.verdict) : -1;
    case iconRole:
        return exceeded    ? QStringLiteral("cross")
               : respected ? QStringLiteral("check")
                           : QStringLiteral("ques");
    case tokenRole:
        return static_cast<int>(exceeded ? Token::bad : respected ? Token::ok : Token::secondaryText);
    default:
        return {};
    }
}

QVariant TestTableModel::accordanceData(const RegisteredTest &test, int role) {
    const bool isJudged = traitsOf(test.kind).isJudged;
    switch (role) {
    case Qt::DisplayRole:
        if (!isJudged)
            return QString();
        if (test.accordance == Accordance::no)
            return tr("%n not met", nullptr, test.counts.unmet);
        if (test.accordance == Accordance::notShown)
            return tr("%n not declared", nullptr, test.counts.undeclared);
        return test.accordance == Accordance::yes      ? tr("in accordance")
               : test.accordance == Accordance::partly ? tr("in part")
                                                       : tr("not checked");
    case sortRole:
        return static_cast<int>(test.accordance);
    case iconRole:
        if (!isJudged)
            return QString();
        return test.accordance == Accordance::yes  ? QStringLiteral("check")
               : test.accordance == Accordance::no ? QStringLiteral("warn")
                                                   : QStringLiteral("ques");
    case tokenRole:
        return static_cast<int>(test.accordance == Accordance::yes  ? Token::ok
                                : test.accordance == Accordance::no ? Token::unsure
                                                                    : Token::secondaryText);
    default:
        return {};
    }
}

QVariant TestTableModel::data(const QModelIndex &index, int role) const {
    if (!index.isValid())
        return {};
    const ListedTest &listed = m_tests[static_cast<std::size_t>(index.row())];
    const RegisteredTest &test = listed.test;
    if (role == Qt::ToolTipRole) {
        QStringList lines;
        for (const TestPlace &place : listed.places)
            lines << place.path;
        return lines.join(u'\n');
    }
    const int results = static_cast<int>(m_results.size());
    const int column = index.column();
    if (column >= firstResult && column < firstResult + results)
        return resultData(test, static_cast<std::size_t>(column - firstResult), role);
    if (column == firstResult + results)
        return limitsData(test, role);
    if (column == firstResult + results + 1)
        return accordanceData(test, role);
    if (column == markColumn) {
        if (role == markRole)
            return static_cast<int>(markOf(test.role));
        const auto number = m_numbers.find(listed.id);
        return role == numberRole && number != m_numbers.end() ? QVariant(number->second) : QVariant();
    }
    if (role != Qt::DisplayRole && role != sortRole)
        return {};
    switch (column) {
    case dateColumn:
        if (!test.date)
            return QString();
        return role == sortRole ? QString::fromStdString(*test.date + test.time.value_or(""))
                                : windowLanguage().shortDate(*test.date);
    case axisColumn:
        return QString::fromStdString(test.axis);
    case editionColumn:
        return QString::fromStdString(test.edition).remove(QStringLiteral("ISO "));
    case purposeColumn:
        return said(purposeText(test.purpose));
    default:
        return said(roleText(test.role));
    }
}

QVariant TestTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const int results = static_cast<int>(m_results.size());
    if (section >= firstResult && section < firstResult + results) {
        const bool angular = !m_tests.empty() && m_tests.front().test.angular;
        return plainSymbolOf(m_results[static_cast<std::size_t>(section - firstResult)]) + u' ' +
               windowLanguage().unit(angular ? Quantity::angularDeviation : Quantity::deviation) +
               QStringLiteral(" ± U");
    }
    if (section == firstResult + results)
        return tr("Limits");
    if (section == firstResult + results + 1)
        return tr("Test");
    switch (section) {
    case dateColumn:
        return tr("Date");
    case axisColumn:
        return tr("Axis");
    case editionColumn:
        return tr("Edition");
    case purposeColumn:
        return tr("Purpose");
    case roleColumn:
        return tr("Role");
    default:
        return {};
    }
}

void TestDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                         const QModelIndex &index) const {
    QStyleOptionViewItem plain = option;
    initStyleOption(&plain, index);
    const QPalette &palette = option.palette;
    const bool selected = (option.state & QStyle::State_Selected) != 0;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (selected)
        painter->fillRect(option.rect, selectedGround(palette));
    painter->setPen(token(Token::line, palette));
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    const QRect area = option.rect.adjusted(resultPadding, 0, -resultPadding, 0);
    const QString text = plain.text;
    QFont font = themeFont(TextSize::base);
    const QString icon = index.data(TestTableModel::iconRole).toString();
    const QString uncertainty = index.data(TestTableModel::uncertaintyRole).toString();
    if (index.column() == TestTableModel::markColumn) {
        const QPointF centre = QRectF(option.rect).center();
        const QVariant number = index.data(TestTableModel::numberRole);
        if (number.isValid()) {
            drawNumberTag(*painter, centre, number.toInt(), palette);
        } else {
            drawRoleMark(*painter, centre,
                         static_cast<TrendMark>(index.data(TestTableModel::markRole).toInt()),
                         token(Token::accent, palette), palette);
        }
    } else if (!icon.isEmpty()) {
        const auto look = static_cast<Token>(index.data(TestTableModel::tokenRole).toInt());
        const QColor colour = token(look, palette);
        drawLineIcon(*painter, QRect(area.left(), area.top(), 16, area.height()), icon, colour);
        font.setBold(look == Token::bad);
        painter->setFont(font);
        painter->setPen(colour);
        painter->drawText(area.adjusted(20, 0, 0, 0), Qt::AlignVCenter, text);
    } else if (index.column() >= TestTableModel::firstResult) {
        // A clipped number would look like another one.
        const auto draw = [&](const QRect &room, Qt::Alignment side, const QString &number) {
            painter->drawText(room, side | Qt::AlignVCenter,
                              painter->fontMetrics().elidedText(number, Qt::ElideRight, room.width()));
        };
        const auto column = static_cast<std::size_t>(index.column() - TestTableModel::firstResult);
        const int wanted = column < m_valueWidths.size() ? m_valueWidths[column] : area.width();
        const QRect value(area.left(), area.top(), std::min(wanted, area.width()), area.height());
        painter->setFont(font);
        painter->setPen(palette.color(QPalette::Text));
        draw(value, Qt::AlignRight, text);
        painter->setFont(themeFont(TextSize::small));
        painter->setPen(token(Token::secondaryText, palette));
        if (const QRect rest = area.adjusted(value.width() + valueGap, 0, 0, 0); rest.width() > 0)
            draw(rest, Qt::AlignLeft, uncertainty);
    } else {
        painter->setFont(font);
        painter->setPen(palette.color(QPalette::Text));
        painter->drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                          painter->fontMetrics().elidedText(text, Qt::ElideRight, area.width()));
    }
    painter->restore();
}

} // namespace palmer::ui
