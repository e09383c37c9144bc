// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/register/testtable.h"

#include "kernel/measurement/testfacts.h"
#include "register/listing.h"
#include "register/machinetrend.h"
#include "register/sincelast.h"
#include "report/parts/comparedtests.h"
#include "report/words/wording.h"
#include "ui/elidedlabel.h"
#include "ui/register/numbertag.h"
#include "ui/theme.h"
#include "ui/windowlanguage.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace palmer::ui {

namespace {

constexpr std::size_t mostResults = 5;
const QString nbsp = QStringLiteral("\u00A0");

TrendMark markOf(TestRole role) {
    return role == TestRole::asLeft    ? TrendMark::asLeft
           : role == TestRole::asFound ? TrendMark::asFound
                                       : TrendMark::noRole;
}

QString said(const Text &text) {
    return text.empty() ? QString() : windowLanguage().text(text);
}

QString unitOf(const RegisteredTest &test) {
    return windowLanguage().unit(test.angular ? Quantity::angularDeviation : Quantity::deviation);
}

/// True for lengths beside angles: the heading can give no unit.
bool areMixed(const std::vector<ListedTest> &tests) {
    return std::ranges::any_of(
        tests, [&](const ListedTest &each) { return each.test.angular != tests.front().test.angular; });
}

/// The value as shown, with its unit where lengths and angles are mixed.
ShownValue shownIn(const RegisteredTest &test, const RegisteredResult &result, bool withUnit) {
    ShownValue shown = shownResult(result, test.angular, windowLanguage());
    if (withUnit && !shown.value.isEmpty())
        (shown.uncertainty.isEmpty() ? shown.value : shown.uncertainty) += nbsp + unitOf(test);
    return shown;
}

QVariant resultData(const RegisteredTest &test, const std::string &id, int role, bool withUnit) {
    const RegisteredResult *result = resultOf(test, id);
    if (role == TestTableModel::sortRole) {
        constexpr double behindLengths = 1e6; // mm
        return result && result->value ? QVariant(*result->value + (test.angular ? behindLengths : 0))
                                       : QVariant();
    }
    if (!result)
        return {};
    const ShownValue shown = shownIn(test, *result, withUnit);
    return role == Qt::DisplayRole                   ? QVariant(shown.value)
           : role == TestTableModel::uncertaintyRole ? QVariant(shown.uncertainty)
                                                     : QVariant();
}

QVariant limitsData(const RegisteredTest &test, int role) {
    const bool exceeded = test.verdict == Verdict::doesNotConform;
    const bool respected = test.verdict == Verdict::conforms;
    switch (role) {
    case Qt::DisplayRole:
        return said(limitsText(test.verdict, hasLimit(test)));
    case TestTableModel::sortRole:
        return test.verdict ? static_cast<int>(*test.verdict) : -1;
    case TestTableModel::iconRole:
        return exceeded    ? QStringLiteral("cross")
               : respected ? QStringLiteral("check")
                           : QStringLiteral("ques");
    case TestTableModel::tokenRole:
        return static_cast<int>(exceeded ? Token::bad : respected ? Token::ok : Token::secondaryText);
    default:
        return {};
    }
}

QVariant accordanceData(const RegisteredTest &test, int role) {
    const bool isJudged = traitsOf(test.kind).isJudged;
    switch (role) {
    case Qt::DisplayRole:
        if (!isJudged)
            return QString();
        if (test.accordance == Accordance::no)
            return TestTableModel::tr("%n not met", nullptr, test.counts.unmet);
        if (test.accordance == Accordance::notShown)
            return TestTableModel::tr("%n not declared", nullptr, test.counts.undeclared);
        return test.accordance == Accordance::yes      ? TestTableModel::tr("in accordance")
               : test.accordance == Accordance::partly ? TestTableModel::tr("in part")
                                                       : TestTableModel::tr("not checked");
    case TestTableModel::sortRole:
        return static_cast<int>(test.accordance);
    case TestTableModel::iconRole:
        if (!isJudged)
            return QString();
        return test.accordance == Accordance::yes  ? QStringLiteral("check")
               : test.accordance == Accordance::no ? QStringLiteral("warn")
                                                   : QStringLiteral("ques");
    case TestTableModel::tokenRole:
        return static_cast<int>(test.accordance == Accordance::yes  ? Token::ok
                                : test.accordance == Accordance::no ? Token::unsure
                                                                    : Token::secondaryText);
    default:
        return {};
    }
}

QVariant sinceLastData(const ListedTest &listed, int role) {
    if (!listed.sinceLast)
        return {};
    const auto word = wordOfAll(listed.sinceLast->comparison);
    const Mark mark = word ? palmer::markOf(*word) : Mark::none;
    switch (role) {
    case Qt::DisplayRole:
        return sinceLastWord(*listed.sinceLast, windowLanguage());
    case TestTableModel::sortRole:
        return word ? static_cast<int>(*word) : -1;
    case TestTableModel::iconRole:
        return mark == Mark::check   ? QStringLiteral("check")
               : mark == Mark::cross ? QStringLiteral("cross")
                                     : QStringLiteral("ques");
    case TestTableModel::tokenRole:
        return static_cast<int>(mark == Mark::check   ? Token::ok
                                : mark == Mark::cross ? Token::bad
                                                      : Token::secondaryText);
    default:
        return {};
    }
}

QVariant dateData(const RegisteredTest &test, int role) {
    if (!test.date || (role != Qt::DisplayRole && role != TestTableModel::sortRole))
        return {};
    return role == TestTableModel::sortRole ? QString::fromStdString(*test.date + test.time.value_or(""))
                                            : windowLanguage().shortDate(*test.date);
}

/// The edition; of a test that none judges its kind.
QString editionWithoutIso(const RegisteredTest &test) {
    if (!traitsOf(test.kind).isJudged)
        return TestTableModel::tr("drift");
    return QString::fromStdString(test.edition).remove(QStringLiteral("ISO "));
}

/// A column of a text, by which it is sorted.
RowColumn<ListedTest> textColumn(const QString &title, QString (*text)(const RegisteredTest &)) {
    return {title, {}, [text](const ListedTest &listed, int role) {
                return role == Qt::DisplayRole || role == TestTableModel::sortRole
                           ? QVariant(text(listed.test))
                           : QVariant();
            }};
}

RowColumn<ListedTest> dataColumn(const QString &title, QVariant (*data)(const RegisteredTest &, int)) {
    return {title, {}, [data](const ListedTest &listed, int role) { return data(listed.test, role); }};
}

} // namespace

TestTableModel::TestTableModel(QObject *parent)
    : RowModel(parent) {
    makeColumns();
}

/// In the order of Column, with the results before the last two.
void TestTableModel::makeColumns() {
    const auto mark = [this](const ListedTest &listed, int role) {
        if (role == markRole)
            return QVariant(static_cast<int>(m_otherSeries.contains(listed.test.digest)
                                                 ? TrendMark::otherSeries
                                                 : markOf(listed.test.role)));
        const auto number = m_numbers.find(listed.id);
        return role == numberRole && number != m_numbers.end() ? QVariant(number->second) : QVariant();
    };
    m_columns = {
        {{}, {}, mark},
        dataColumn(tr("Date"), dateData),
        textColumn(tr("Axis"), [](const RegisteredTest &test) { return QString::fromStdString(test.axis); }),
        textColumn(tr("Edition"), editionWithoutIso),
        textColumn(tr("Purpose"), [](const RegisteredTest &test) { return said(purposeText(test.purpose)); }),
        textColumn(tr("Role"), [](const RegisteredTest &test) { return said(roleText(test.role)); })};
    const bool withUnits = areMixed(m_rows);
    const QString unit = withUnits || m_rows.empty() ? QString() : u' ' + unitOf(m_rows.front().test);
    for (const std::string &id : m_results) {
        const auto data = [id, withUnits](const ListedTest &listed, int role) {
            return resultData(listed.test, id, role, withUnits);
        };
        m_columns.push_back({plainSymbolOf(id) + unit + QStringLiteral(" ± U"), {}, data});
    }
    m_columns.push_back(dataColumn(tr("Limits"), limitsData));
    m_columns.push_back(dataColumn(tr("Test"), accordanceData));
    m_columns.push_back({tr("Against the last"), {}, sinceLastData});
}

QVariant TestTableModel::cell(const ListedTest &listed, int column, int role) const {
    if (role != Qt::ToolTipRole)
        return RowModel::cell(listed, column, role);
    if (column == columnCount() - 1 && listed.sinceLast)
        return decisionLine(listed.sinceLast->comparison, windowLanguage()).limits.text.plain();
    QStringList lines;
    for (const TestPlace &place : listed.places)
        lines << place.path;
    return lines.join(u'\n');
}

void TestTableModel::setTests(std::vector<ListedTest> tests) {
    beginResetModel();
    std::ranges::reverse(tests); // newest first
    m_rows = std::move(tests);
    m_results = parametersOf(m_rows);
    if (m_results.size() > mostResults)
        m_results.resize(mostResults);
    m_numbers.clear();
    makeColumns();
    endResetModel();
}

void TestTableModel::setNumbers(std::map<int, int> numbers) {
    if (numbers == m_numbers)
        return;
    m_numbers = std::move(numbers);
    if (!m_rows.empty())
        emit dataChanged(index(0, markColumn), index(rowCount() - 1, markColumn));
}

void TestTableModel::setOtherSeries(std::set<QString> digests) {
    m_otherSeries = std::move(digests);
    if (!m_rows.empty())
        emit dataChanged(index(0, markColumn), index(rowCount() - 1, markColumn));
}

void TestTableModel::setSinceLast(int test, std::shared_ptr<const SinceLast> change) {
    const auto row = std::ranges::find(m_rows, test, &ListedTest::id);
    if (row == m_rows.end())
        return;
    row->sinceLast = std::move(change);
    const int at = static_cast<int>(row - m_rows.begin());
    emit dataChanged(index(at, columnCount() - 1), index(at, columnCount() - 1));
}

void TestTableModel::retranslate() {
    beginResetModel();
    makeColumns();
    endResetModel();
}

TestTableModel::Longest TestTableModel::longest(std::size_t result) const {
    // Digits are equally wide, so the widest numbers have the most characters; only these are formatted.
    struct Widest {
        const RegisteredTest *test = nullptr;
        int characters = -1;
    };
    const auto see = [](Widest &widest, const RegisteredTest &test, double number, int decimals) {
        const double size =
            std::abs(number) * unitScale(test.angular ? Quantity::angularDeviation : Quantity::deviation,
                                         windowLanguage().units());
        const int whole = size < 10 ? 1 : static_cast<int>(std::log10(size)) + 1;
        const int characters = whole + (whole - 1) / 3 + (number < 0 ? 1 : 0) + decimals;
        if (characters > widest.characters)
            widest = {&test, characters};
    };
    Widest value;
    Widest expanded;
    for (const ListedTest &listed : m_rows) {
        const RegisteredResult *found = resultOf(listed.test, m_results[result]);
        if (!found || !found->value)
            continue;
        see(value, listed.test, *found->value, found->decimals.value_or(0));
        if (found->expandedUncertainty)
            see(expanded, listed.test, *found->expandedUncertainty, found->uncertaintyDecimals.value_or(0));
    }
    const auto shown = [&](const Widest &widest) {
        return widest.test ? shownResult(*resultOf(*widest.test, m_results[result]), widest.test->angular,
                                         windowLanguage())
                           : ShownValue();
    };
    const QString unit = areMixed(m_rows) ? nbsp + windowLanguage().unit(Quantity::deviation) : QString();
    return {shown(value).value + unit, shown(expanded).uncertainty + unit};
}

QColor TestDelegate::ground(const QStyleOptionViewItem &option, const QModelIndex &) const {
    return option.state & QStyle::State_Selected ? selectedGround(option.palette) : QColor();
}

void TestDelegate::paintContent(QPainter &painter, const QStyleOptionViewItem &option,
                                const QModelIndex &index) const {
    const QPalette &palette = option.palette;
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect area = option.rect.adjusted(resultPadding, 0, -resultPadding, 0);
    const QString text = index.data().toString();
    const QColor colour = palette.color(QPalette::Text);
    QFont font = themeFont(TextSize::base);
    const QString icon = index.data(TestTableModel::iconRole).toString();
    if (index.column() == TestTableModel::markColumn) {
        const QPointF centre = QRectF(option.rect).center();
        const QVariant number = index.data(TestTableModel::numberRole);
        if (number.isValid()) {
            drawNumberTag(painter, centre, number.toInt(), palette);
        } else {
            const auto mark = static_cast<TrendMark>(index.data(TestTableModel::markRole).toInt());
            const Token look = mark == TrendMark::otherSeries ? Token::secondaryText : Token::accent;
            drawRoleMark(painter, centre, mark, token(look, palette), palette);
        }
    } else if (!icon.isEmpty()) {
        const auto look = static_cast<Token>(index.data(TestTableModel::tokenRole).toInt());
        drawLineIcon(painter, QRect(area.left(), area.top(), 16, area.height()), icon, token(look, palette));
        font.setBold(look == Token::bad);
        drawElided(painter, area.adjusted(20, 0, 0, 0), Qt::AlignLeft, text, font, token(look, palette));
    } else if (index.column() >= TestTableModel::firstResult) {
        // A clipped number would look like another one.
        const auto column = static_cast<std::size_t>(index.column() - TestTableModel::firstResult);
        const int wanted = column < m_valueWidths.size() ? m_valueWidths[column] : area.width();
        const QRect value(area.left(), area.top(), std::min(wanted, area.width()), area.height());
        drawElided(painter, value, Qt::AlignRight, text, font, colour);
        if (const QRect rest = area.adjusted(value.width() + valueGap, 0, 0, 0); rest.width() > 0)
            drawElided(painter, rest, Qt::AlignLeft, index.data(TestTableModel::uncertaintyRole).toString(),
                       themeFont(TextSize::small), token(Token::secondaryText, palette));
    } else {
        drawElided(painter, area, Qt::AlignLeft, text, font, colour);
    }
    if (isCurrentRow(option, index)) { // the lines of all cells frame the row
        painter.setPen(QPen(token(Token::accent, palette), 1));
        painter.drawLine(option.rect.topLeft(), option.rect.topRight());
        painter.drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    }
}

} // namespace palmer::ui
