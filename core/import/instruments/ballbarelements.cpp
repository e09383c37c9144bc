// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/instruments/ballbarelements.h"

#include "document/place.h"
#include "import/layouts/sections.h"

#include <QRegularExpression>
#include <algorithm>

namespace palmer {

namespace {

constexpr qsizetype mostUnread = 1000;

constexpr std::array typeUnits{
    TypeUnit{"UT_LENGTH_MM", "mm", 1, 1, true},
    TypeUnit{"UT_LENGTH_UM", "µm", 1, 1000, true},
    TypeUnit{"UT_LENGTH_M", "m", 1000, 1, true},
    TypeUnit{"UT_FEEDRATE", "mm/min"},
    TypeUnit{"UT_SQUARENESS", "µm/m"},
    TypeUnit{"UT_SERVO_MISMATCH", "ms"},
    TypeUnit{"UT_SCALE_ERROR", "ppm"},
    TypeUnit{"UT_ANGLE", "°"},
    TypeUnit{"UT_SPEED", "mm/min"},
    TypeUnit{"UT_PERCENT", "%"},
    TypeUnit{"UT_RANKING", ""},
};

/// Words of the names of elements, and the choice that they state.
struct AngleName {
    const char *choice = nullptr;
    std::array<QLatin1StringView, 2> words;
};
constexpr std::array angleNames{
    AngleName{"startAngle", {QLatin1StringView("START"), QLatin1StringView("ANGLE")}},
    AngleName{"arc", {QLatin1StringView("ARC"), QLatin1StringView("ARC")}},
    AngleName{"overshoot", {QLatin1StringView("OVERSHOOT"), QLatin1StringView("OVERSHOOT")}}};

/// Index of the angle that a name as START_ANGLE means; the number of them if it means none.
std::size_t angleOf(const QString &name) {
    const QStringList words = name.split(u'_');
    const auto has = [&](QLatin1StringView word) { return words.contains(word, Qt::CaseInsensitive); };
    const auto means = [&](const AngleName &row) { return std::ranges::all_of(row.words, has); };
    return static_cast<std::size_t>(std::ranges::find_if(angleNames, means) - angleNames.begin());
}

} // namespace

const TypeUnit *typeUnit(QStringView type) {
    const auto *const found = std::ranges::find_if(
        typeUnits, [&](const TypeUnit &row) { return type == QLatin1StringView(row.type); });
    return found == typeUnits.end() ? nullptr : found;
}

QString declaredEncoding(QByteArrayView bytes) {
    constexpr qsizetype longestDeclaration = 256;
    static const QRegularExpression declared(QStringLiteral("^[^>]*encoding\\s*=\\s*[\"']([^\"'>]+)"));
    const QString begin = QString::fromLatin1(bytes.first(std::min(bytes.size(), longestDeclaration)));
    return declared.match(begin).captured(1);
}

void remarkEncoding(QByteArrayView bytes, Remarks &remarks) {
    QString encoding = declaredEncoding(bytes);
    if (encoding.isEmpty()) { // in UTF-16
        constexpr qsizetype longestDeclaration = 512;
        QXmlStreamReader xml(bytes.first(std::min(bytes.size(), longestDeclaration)).toByteArray());
        xml.readNext();
        encoding = xml.documentEncoding().toString();
    }
    if (!encoding.isEmpty() && encoding.compare(u"UTF-8", Qt::CaseInsensitive) != 0)
        remarks.note({}, REPORT_TEXT("report", "Encoding: %1, as the file says."),
                     excerpt(encoding.toStdString()));
}

bool BallbarElements::isKnown(const QString &name) {
    static const QStringList known =
        QStringLiteral(
            "TEST_DOCUMENT DYNAMIC_BALLBAR TEST_SPEC INSTRUMENT PLANE MACHINE_TESTED BALLBAR_RUN "
            "ANALYSIS NOMINAL_LENGTH PROGRAMMED_FEEDRATE A_AXIS_NAME B_AXIS_NAME OPERATOR "
            "DATE_STARTED SERIAL_NUMBER LAST_CALIBRATED RUN_RESULTS RUN_DIRECTION READINGS FEATURE")
            .split(u' ');
    return known.contains(name);
}

bool BallbarElements::isAngle(const QString &name) {
    return angleOf(name) < angleNames.size();
}

void BallbarElements::addAttributes(const QString &element, const QXmlStreamAttributes &attributes) {
    constexpr std::array known{"NAME", "DT", "MANUFACTURER", "MODEL", "TEST_PLANE", "VIEW"};
    for (const QXmlStreamAttribute &attribute : attributes) {
        const auto is = [&](const char *key) { return attribute.name() == QLatin1StringView(key); };
        const bool isRead = isKnown(element) ? std::ranges::any_of(known, is) : is("DT");
        if (!isRead && m_unread.size() < mostUnread)
            m_unread.insert(element + u'@' + attribute.name().toString() + QStringLiteral(": ") +
                            attribute.value().toString());
    }
}

void BallbarElements::add(const QString &name, const QString &value, const QString &type) {
    const QString text = value.isEmpty() ? name : name + QStringLiteral(": ") + value;
    const std::size_t index = angleOf(name);
    const auto number = numberIn(value.toStdString());
    const bool isInDegrees = type.isEmpty() || type == QLatin1StringView("UT_ANGLE");
    if (index == angleNames.size() || !number || !isInDegrees) {
        if (m_unread.size() < mostUnread)
            m_unread.insert(text);
        return;
    }
    StatedAngle &angle = m_angles[index];
    if (angle.text.isEmpty())
        angle = {text, *number};
    else if (!angle.text.contains(text))
        angle.text += QStringLiteral(", ") + text;
}

Choice<double> BallbarElements::resolveAngle(std::string_view key, double usual, Text assumed,
                                             Choices &choices, Remarks &remarks) const {
    const auto index = std::ranges::find(angleNames, key, &AngleName::choice) - angleNames.begin();
    const StatedAngle &stated = m_angles[static_cast<std::size_t>(index)];
    const bool isStated = !stated.text.isEmpty();
    const Choice<double> angle =
        choices.resolveNumber(key, isStated ? stated.value : usual,
                              isStated || !assumed.empty() ? Origin::guessed : Origin::recognised);
    const Number value{angle.value, Quantity::angle};
    if (angle.origin == Origin::guessed && isStated)
        remarks.add(angle.value == usual ? RemarkGrade::assumption : RemarkGrade::problem, key,
                    messageOf(REPORT_TEXT("report", "%1: the file says “%2” in an element that is not known; "
                                                    "read as %3."),
                              nameOfChoice(key), excerpt(stated.text.toStdString()), value));
    else if (angle.origin == Origin::guessed)
        remarks.assumption(key, assumed, value);
    return angle;
}

void BallbarElements::remark(Remarks &remarks) const {
    QStringList texts(m_unread.begin(), m_unread.end());
    texts.sort();
    std::string list;
    for (const QString &text : texts)
        list += (list.empty() ? "" : ", ") + excerpt(text.toStdString());
    if (!list.empty())
        remarks.note({}, REPORT_TEXT("report", "Elements that were not read: %1."), list);
}

} // namespace palmer
