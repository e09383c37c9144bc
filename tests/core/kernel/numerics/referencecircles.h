// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <QFile>
#include <QString>
#include <QStringList>

#include <map>
#include <stdexcept>

/// The sets of points with known circles in resources/reference/circles.
namespace reference {

/// The lines of a file without those that begin with '#', split at `separator`.
inline std::vector<QStringList> rows(const QString &name, QChar separator) {
    QFile file(QStringLiteral(PALMER_REFERENCE_CIRCLES "/") + name);
    if (!file.open(QIODevice::ReadOnly))
        throw std::runtime_error("cannot read " + file.fileName().toStdString());
    std::vector<QStringList> result;
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine()).trimmed();
        if (!line.isEmpty() && !line.startsWith(u'#'))
            result.push_back(line.split(separator));
    }
    return result;
}

inline palmer::Points points(const QString &name) {
    palmer::Points points;
    for (const QStringList &row : rows(name, u',')) {
        points.x.push_back(row.at(0).toDouble());
        points.y.push_back(row.at(1).toDouble());
    }
    return points;
}

/// Angles in degrees and radii in mm of one sense of the ballbar pair: ccw or cw.
struct Path {
    std::vector<double> angles;
    std::vector<double> radii;
};

inline Path ballbarPath(const QString &sense) {
    Path path;
    for (const QStringList &row : rows(QStringLiteral("ballbar_pair_%1.csv").arg(sense), u';')) {
        bool number = false;
        const double angle = row.at(0).toDouble(&number);
        if (!number)
            continue; // the line with the names of the columns
        path.angles.push_back(angle);
        path.radii.push_back(150 + row.at(1).toDouble() / 1000);
    }
    return path;
}

/// One line of expected.csv: its columns by name, numbers as far as they are numbers.
struct Expected {
    QString file;
    QString status;
    std::map<QString, double> value;
};

inline std::vector<Expected> expected() {
    const std::vector<QStringList> table = rows(QStringLiteral("expected.csv"), u',');
    std::vector<Expected> result;
    for (std::size_t i = 1; i < table.size(); ++i) {
        Expected expected;
        for (qsizetype k = 0; k < table[0].size(); ++k) {
            const QString &cell = table[i].at(k);
            if (table[0].at(k) == u"file")
                expected.file = cell;
            else if (table[0].at(k) == u"status")
                expected.status = cell;
            else
                expected.value[table[0].at(k)] = cell.toDouble();
        }
        result.push_back(expected);
    }
    return result;
}

} // namespace reference
