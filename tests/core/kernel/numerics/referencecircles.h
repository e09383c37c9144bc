// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kernel/numerics/points.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <map>
#include <stdexcept>

/// The sets of points with known circles in resources/reference.
namespace reference {

/// The lines of a file without those that begin with '#', split at `separator`.
inline std::vector<QStringList> rows(const QString &name, QChar separator) {
    QFile file(QStringLiteral(PALMER_SOURCE_DIR "/resources/reference/circles/") + name);
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

/// Sets of points and what is known of their circles.
inline std::vector<QJsonObject> pointSets() {
    std::vector<QJsonObject> result;
    for (const char *name : {"constructed-circles", "nist-circles"}) {
        QFile file(
            QStringLiteral(PALMER_SOURCE_DIR "/resources/reference/%1.json").arg(QLatin1StringView(name)));
        if (!file.open(QIODevice::ReadOnly))
            throw std::runtime_error("cannot read " + file.fileName().toStdString());
        result.push_back(QJsonDocument::fromJson(file.readAll()).object());
    }
    return result;
}

inline palmer::Points points(const QString &name) {
    palmer::Points points;
    for (const QJsonObject &set : pointSets()) {
        for (const QJsonValue item : set[QLatin1StringView("points")].toArray()) {
            if (item[QLatin1StringView("name")] != name)
                continue;
            for (const QJsonValue x : item[QLatin1StringView("x")].toArray())
                points.x.push_back(x.toDouble());
            for (const QJsonValue y : item[QLatin1StringView("y")].toArray())
                points.y.push_back(y.toDouble());
        }
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

/// What is known of a set, by id; without minimum zone those ids are missing.
struct Expected {
    QString name;
    std::map<QString, double> value;

    [[nodiscard]] double at(const char *id) const {
        const auto found = value.find(QLatin1StringView(id));
        return found == value.end() ? 0 : found->second;
    }
    [[nodiscard]] bool hasZone() const { return value.contains(QStringLiteral("mzc_width")); }
};

inline std::vector<Expected> expected() {
    std::vector<Expected> result;
    for (const QJsonObject &set : pointSets()) {
        const QJsonArray points = set[QLatin1StringView("points")].toArray();
        for (qsizetype i = 0; i < points.size(); ++i) {
            Expected &one = result.emplace_back();
            one.name = points[i][QLatin1StringView("name")].toString();
            for (const QJsonValue row : set[QLatin1StringView("expected")].toArray()) {
                if (row[QLatin1StringView("test")].toInt() == i + 1)
                    one.value[row[QLatin1StringView("circle")].toString()] =
                        row[QLatin1StringView("value")].toDouble();
            }
        }
    }
    return result;
}

} // namespace reference
