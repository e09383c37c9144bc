// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/filewords.h"
#include "document/resultwords.h"
#include "kernel/measurement/testfacts.h"

#include <QtSql/QSqlQuery>

#include <QStringList>
#include <QVariant>
#include <optional>
#include <string>
#include <type_traits>

namespace palmer {

/// Columns of these tables, in the order in which they are written and read.
inline const QString testColumns = QStringLiteral(
    "id, digest, machine, name, manufacturer, model, serial, location, kind, title, word, edition, axis, "
    "angular, date, time, feed, travel, setup, correction, purpose, role, verdict, rule, accordance, unmet, "
    "undeclared, departures, fingerprint, parts, awaits");
inline const QString resultColumns = QStringLiteral(
    "test, position, id, value, expanded, k, bound, limit_value, guard, verdict, own, shared, factor, whole, "
    "decimals, udecimals");

/// Begins a statement with the table `last`: machine, axis and day of the newest test of each axis and plane
/// that meets `condition`, null without one. It steps through the index instead of passing all tests.
[[nodiscard]] inline QString withNewestDays(const QString &condition) {
    return QStringLiteral("with recursive pair(machine, axis) as (select id, (select min(axis) from test "
                          "where test.machine = machine.id) from machine union all select machine, (select "
                          "min(axis) from test where test.machine = pair.machine and test.axis > pair.axis) "
                          "from pair where axis is not null), last(machine, axis, day) as (select machine, "
                          "axis, (select max(date) from test where test.machine = pair.machine and test.axis "
                          "= pair.axis and %1) from pair where axis is not null) ")
        .arg(condition);
}

/// Returns the condition that `kind` is one that editions judge.
[[nodiscard]] inline QString isJudgedKind(const QString &kind) {
    QStringList words;
    for (const auto &row : fileWords<Kind>) {
        if (traitsOf(row.value).isJudged)
            words += u'\'' + QLatin1StringView(row.word) + u'\'';
    }
    return kind + QStringLiteral(" in (") + words.join(QStringLiteral(", ")) + u')';
}

/// Returns a value as it is stored: texts in UTF-16, yes as 1 and no as 0, words of enumerations.
template <class T>
[[nodiscard]] QVariant storedValue(const T &value) {
    if constexpr (std::is_same_v<T, std::string>)
        return QString::fromStdString(value);
    else if constexpr (std::is_same_v<T, bool>)
        return value ? 1 : 0;
    else if constexpr (std::is_enum_v<T>)
        return QString::fromLatin1(fileWord(value));
    else
        return value;
}
template <class T>
[[nodiscard]] QVariant storedValue(const std::optional<T> &value) {
    return value ? storedValue(*value) : QVariant();
}
[[nodiscard]] inline QVariant storedValue(const std::optional<Verdict> &verdict) {
    return verdict ? QVariant(QString::fromLatin1(limitsWord(verdict))) : QVariant();
}

/// Returns the values to bind to a statement.
template <class... T>
[[nodiscard]] QVariantList storedValues(const T &...values) {
    return {storedValue(values)...};
}

/// Reads the columns of a row one after another, each as the type of its variable: the reverse of
/// storedValues(). An unknown word is the first of its enumeration.
class RowReader {
public:
    explicit RowReader(const QSqlQuery &row, int firstColumn = 0)
        : m_row(row)
        , m_column(firstColumn) {}
    template <class... T>
    void read(T &...variables) {
        (take(m_row.value(m_column++), variables), ...);
    }

private:
    static void take(const QVariant &value, QString &text) { text = value.toString(); }
    static void take(const QVariant &value, std::string &text) { text = value.toString().toStdString(); }
    static void take(const QVariant &value, int &number) { number = value.toInt(); }
    static void take(const QVariant &value, qint64 &number) { number = value.toLongLong(); }
    static void take(const QVariant &value, double &number) { number = value.toDouble(); }
    static void take(const QVariant &value, bool &is) { is = value.toInt() != 0; }
    template <class Enumeration>
    requires std::is_enum_v<Enumeration>
    static void take(const QVariant &value, Enumeration &word) {
        word = ofFileWord<Enumeration>(value.toString().toStdString()).value_or(Enumeration{});
    }
    template <class T>
    static void take(const QVariant &value, std::optional<T> &variable) {
        variable.reset();
        if (!value.isNull())
            take(value, variable.emplace());
    }
    static void take(const QVariant &value, std::optional<Verdict> &verdict) {
        verdict.reset();
        for (const Verdict each : {Verdict::conforms, Verdict::notProven, Verdict::doesNotConform}) {
            if (value.toString() == QLatin1StringView(limitsWord(each)))
                verdict = each;
        }
    }

    const QSqlQuery &m_row;
    int m_column;
};

} // namespace palmer
