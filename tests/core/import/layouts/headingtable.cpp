// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "core/import/layouts/headingtable.h"

#include "core/import/storedworkbook.h"

#include <QString>
#include <QStringList>

namespace palmer::testdata {

namespace {

const std::vector<QStringList> groupWords{
    {"Linear", "Pitch"},
    {"Linear (µm)", "Pitch (arcsec)"},
    {"Laser", "Encoder"},
    {"Laser", "Scale", "Motor"},
    {"As found", "As left"},
    {"Before compensation", "After compensation"},
    {"Avant réglage", "Après réglage"},
    {"X", "Y"},
    {"X axis", "Y axis", "Z axis"},
    {"2024", "2025"},
    {"2023", "2024", "2025"},
    {"µm", "arcsec"},
    {"mm", "in"},
    {"Mean", "2 σ"},
    {"Machine A", "Machine B"},
    {"Spindel oben", "Spindel unten"},
    {"Position", "Yaw"},
    {"Left", "Right"},
    {"Morning", "Evening"},
    {"Cold", "Warm", "Hot"},
};

const std::vector<QStringList> directions{
    {"Forward", "Reverse"}, {"↑", "↓"}, {"aller", "retour"}, {"hin", "zurück"}, {"+", "-"}};

QString byColons(const QStringList &cells) {
    constexpr qsizetype width = 22;
    QString line = cells.front().leftJustified(width);
    for (const QString &cell : cells.mid(1))
        line += (cell.isEmpty() ? "   " : " : ") + cell.leftJustified(width);
    return line;
}

/// Where cells stand in their columns.
enum class Placed { left, right, centred };

/// A word above several columns, with empty cells behind it, stands over the first, or in the middle.
QString fixed(const QStringList &cells, qsizetype width, Placed placed) {
    QString line;
    for (qsizetype i = 0, columns = 1; i < cells.size(); i += columns) {
        for (columns = 1; !cells[i].isEmpty() && i + columns < cells.size() && cells[i + columns].isEmpty();)
            ++columns;
        QString cell = cells[i];
        if (placed == Placed::centred && columns > 1)
            cell.prepend(QString((columns * width - cell.size()) / 2, ' '));
        else if (placed != Placed::left)
            cell = cell.rightJustified(width);
        line += cell.leftJustified(columns * width);
    }
    return line;
}

/// As narrow as the words allow, each over `span` columns: single blanks between some.
qsizetype narrowWidth(const QStringList &words, qsizetype span) {
    qsizetype width = 0;
    for (const QString &word : words)
        width = std::max(width, word.size() / span + 1);
    return width;
}

} // namespace

GroupedTable groupedTable(std::mt19937 &random) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    GroupedTable table;
    const QStringList &words = groupWords[below(groupWords.size())];
    const QStringList &ways = directions[below(directions.size())];
    const std::size_t pairs = 1 + below(3);
    const bool repeats = below(3) == 0; // the word over each column
    const bool statesUnit = below(2) == 0;
    // 5: columns parted by " : ", a group over the first of its own; 6 to 8: narrow columns of fixed width.
    const std::size_t form = below(9);
    const bool isSheet = form == 4;
    const QString delimiter = form == 0 ? ";" : form == 1 ? "," : "\t";
    QStringList top{""};
    QStringList head{"Position (mm)"};
    for (std::size_t g = 0; g < static_cast<std::size_t>(words.size()); ++g) {
        table.groups.emplace_back();
        for (std::size_t j = 0; j < 2 * pairs; ++j) {
            top << (j == 0 || repeats || form == 3 ? words[static_cast<qsizetype>(g)] : "");
            head << ways[static_cast<qsizetype>(j % 2)] +
                        (pairs > 1 ? QString(" %1").arg(j / 2 + 1) : QString()) + (statesUnit ? " (µm)" : "");
            table.groups.back().emplace_back();
        }
    }
    std::vector<QStringList> rows{top, head};
    const std::size_t targets = 4 + below(6);
    int serial = 11 + static_cast<int>(below(20)); // every number once
    for (std::size_t i = 0; i < targets; ++i) {
        const double target = static_cast<double>(i) * 50 + static_cast<double>(below(9));
        table.targets.push_back(target);
        QStringList row{QString::number(target)};
        for (auto &group : table.groups) {
            for (std::vector<double> &column : group) {
                column.push_back(++serial / 10.0);
                row << QString::number(column.back(), 'f', 1);
            }
        }
        rows.push_back(row);
    }
    if (isSheet) {
        std::vector<MergedCells> merged;
        const auto span = static_cast<int>(2 * pairs);
        for (int g = 0; !repeats && g < static_cast<int>(words.size()); ++g)
            merged.push_back({0, 1 + g * span, span});
        table.text = storedWorkbook(rows, merged);
        return table;
    }
    const qsizetype narrow =
        std::max(narrowWidth(head, 1), narrowWidth(words, repeats ? 1 : static_cast<qsizetype>(2 * pairs)));
    const qsizetype width = form == 3 ? 22 : narrow + static_cast<qsizetype>(below(3));
    const Placed placed = form < 7 ? Placed::left : form == 7 ? Placed::right : Placed::centred;
    for (const QStringList &row : rows)
        table.text += (form == 3 || form > 5 ? fixed(row, width, placed)
                       : form == 5           ? byColons(row)
                                             : row.join(delimiter))
                          .toUtf8() +
                      '\n';
    return table;
}

const std::vector<QByteArray> &conditionBlocks() {
    static const std::vector<QByteArray> blocks{
        "Air temperature;20,1;20,3\n",
        "Air temperature (°C);20,1;20,3\nMachine temperature (°C);20,4;20,6\n",
        "Sensor;Start (°C);End (°C)\nSpindle;20,1;20,3\nTable;20,2;20,4\nAir;20,3;20,4\n",
        "Temperature;20,1\n",
        "Pressure;1013,2;hPa\nHumidity;45;%\n",
        "Machine:;DMU 50\nSerial number:;1234\n",
        "Machine;DMU 50\n",
        "Operator;A. Smith\nDate;12.03.2026\n",
        "Feed;2000;mm/min\n",
        "Dwell;3;s\n",
        "Number of runs;5\n",
        "Number of targets;4\nNumber of runs;2\n",
        "Travel;0;500\n",
        "Lower limit;Upper limit\n0;500\n",
        "Expansion coefficient;11,5\n",
        "Laser;XL-80;123456\n",
        "Material 1;20,11\nMaterial 2;20,35\nMaterial 3;20,40\n",
        "Start;08:15\nEnd;10:40\n",
        "Start;20,1\nEnd;20,4\n",
        "Resolution;0,001;mm\n",
        "# Air 20.1 20.3\n",
        "Test after ISO 230-2:2014\n",
        "Report 2026-117\nCustomer;Example Ltd\n",
        "Température air;20,1;20,3\n",
        "Lufttemperatur;20,1;20,3\nMaterialtemperatur;20,5;20,6\n",
        "Remark;door open\n",
        "Version;1.2.3\n",
        "Axis;X\n",
        "Offset X;Offset Y;Offset Z\n0;100;250\n",
        "Dead path;150;mm\nWavelength;632,99;nm\n",
    };
    return blocks;
}

} // namespace palmer::testdata
