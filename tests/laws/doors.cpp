// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "laws/doors.h"

#include "core/import/importpicture.h"
#include "core/import/layouts/workshoptable.h"
#include "core/import/storedworkbook.h"
#include "document/documenterror.h"
#include "document/evaluateddocument.h"
#include "document/setfield.h"
#include "document/templatefile.h"
#include "editing/arctable.h"
#include "editing/driftreadings.h"
#include "editing/limitblock.h"
#include "editing/newtest.h"
#include "editing/readingblock.h"
#include "editing/sheetblock.h"
#include "editing/typedreading.h"
#include "import/importmeasurement.h"
#include "kernel/evaluation/edition.h"
#include "ui/model/clipboardtext.h"

#include <QMimeData>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace palmer::laws {

namespace {

/// The readings as text, or the questions that want an answer, or that nothing can be read.
struct Outcome {
    QString readings;
    std::set<std::string> questions;
    bool isRefused = false;

    bool operator==(const Outcome &) const = default;
};

QString told(const Outcome &outcome) {
    QStringList asked;
    for (const std::string &question : outcome.questions)
        asked << QString::fromStdString(question);
    return outcome.isRefused ? "refused" : asked.isEmpty() ? outcome.readings : "asks " + asked.join(", ");
}

std::set<std::string> owed(const std::vector<Question> &questions) {
    std::set<std::string> ids;
    for (const Question &question : questions) {
        if (!question.canBeAssumed())
            ids.insert(question.id);
    }
    return ids;
}

Outcome outcomeOf(const std::function<Outcome()> &read) {
    try {
        Outcome outcome = read();
        if (!outcome.questions.empty())
            outcome.readings.clear(); // what would be read is no matter before the answer
        return outcome;
    } catch (const Error &) {
        return {{}, {}, true};
    }
}

/// Numbers alone: what else a file says (machine, dates, temperatures) has no place in a table that is open.
QString numbersOf(Imported imported) {
    imported.sensors.clear();
    return testdata::picture(imported);
}

Outcome ofFile(const QByteArray &bytes, const QString &name, const ImportOptions &options = {}) {
    return outcomeOf([&]() -> Outcome {
        const Imported imported = importMeasurement(bytes, name, options);
        return {numbersOf(imported), owed(imported.questions), false};
    });
}

QString htmlOf(const std::vector<QStringList> &rows) {
    QString html = "<html><body><table>";
    for (const QStringList &row : rows) {
        html += "<tr>";
        for (const QString &cell : row)
            html += "<td>" + cell.toHtmlEscaped() + "</td>";
        html += "</tr>";
    }
    return html + "</table></body></html>";
}

QByteArray rtfOf(const std::vector<QStringList> &rows) {
    QByteArray rtf = "{\\rtf1\\ansi\\ansicpg1252{\\fonttbl{\\f0 Arial;}}\n";
    for (const QStringList &row : rows) {
        rtf += "\\trowd";
        for (qsizetype c = 0; c < row.size(); ++c)
            rtf += "\\cellx" + QByteArray::number(1000 * (c + 1));
        for (const QString &cell : row) {
            rtf += "\\pard\\intbl ";
            for (const QChar c : cell) {
                if (c.unicode() < 0x80)
                    rtf += (c == '\\' || c == '{' || c == '}' ? "\\" : "") + QByteArray(1, c.toLatin1());
                else
                    rtf += "\\u" + QByteArray::number(static_cast<qint16>(c.unicode())) + "?";
            }
            rtf += "\\cell";
        }
        rtf += "\\row\n";
    }
    return rtf + "}";
}

QString copiedAs(const char *format, const QByteArray &bytes) {
    QMimeData data;
    data.setData(format, bytes);
    return ui::copiedText(data);
}

class Follower {
public:
    Follower(DoorCounts &counts, const std::function<void(const std::string &, const std::string &)> &report)
        : m_counts(counts)
        , m_report(report) {}

    void begin(const QString &text, const Outcome &file) {
        m_text = text;
        m_file = file;
        ++m_counts.tables;
        m_counts.asked += file.questions.empty() ? 0 : 1;
        m_counts.refused += file.isRefused ? 1 : 0;
    }

    void compare(const char *door, const Outcome &outcome) { compare(door, outcome, m_file); }
    void compare(const char *door, const Outcome &outcome, const Outcome &expected) {
        if (outcome == expected) {
            ++m_counts.equal;
            return;
        }
        ++m_counts.differing[door];
        m_report(door, QString("%1\n--- expected\n%2\n--- %3\n%4")
                           .arg(m_text.left(700), told(expected), QString::fromLatin1(door), told(outcome))
                           .toStdString());
    }

    /// Text, workbook and what a browser or a word processor copies.
    void compareForms(const std::vector<QStringList> &rows, char mark) {
        QStringList lines;
        std::vector<QStringList> withPoints = rows; // a workbook has numbers, not their digits
        for (std::size_t r = 0; r < rows.size(); ++r) {
            lines << rows[r].join('\t');
            for (QString &cell : withPoints[r]) {
                QString point = cell;
                if (mark == ',')
                    point.replace(',', '.');
                bool isNumber = false;
                (void)point.toDouble(&isNumber);
                cell = isNumber ? point : cell;
            }
        }
        const QByteArray text = lines.join('\n').toUtf8();
        const Outcome copied = ofFile(text, {});
        compare("clipboard", copied);
        compare("HTML", ofFile(copiedAs("text/html", htmlOf(rows).toUtf8()).toUtf8(), {}), copied);
        compare("RTF", ofFile(copiedAs("text/rtf", rtfOf(rows)).toUtf8(), {}), copied);
        compare("workbook", ofFile(testdata::storedWorkbook(withPoints), "x.xlsx"), copied);
    }

private:
    DoorCounts &m_counts;
    const std::function<void(const std::string &, const std::string &)> &m_report;
    QString m_text;
    Outcome m_file;
};

/// The test without its readings, as it stands open: what is pasted has to fill it.
Outcome pastedInto(const PositioningMeasurement &read, const QString &text) {
    return outcomeOf([&]() -> Outcome {
        PositioningMeasurement open = read;
        BlockPlace place{0, firstRunOfBlock, {}};
        for (Run &run : open.runs) {
            place.runs.push_back(place.runs.size());
            for (auto &deviation : run.deviations)
                deviation.reset();
        }
        const PastedBlock pasted = pasteBlock(open, text.toStdString(), place, {});
        Imported shown;
        shown.test.emplace();
        shown.test->edition = defaultEdition(Kind::positioning).word;
        shown.test->measurement = pasted.measurement;
        return {numbersOf(shown), owed(pasted.questions), false};
    });
}

void followPositioning(Follower &follower, std::mt19937 &random) {
    const testdata::WorkshopTable table = testdata::workshopTable(random);
    const Outcome file = ofFile(table.bytes, "x.csv");
    follower.begin(table.text, file);
    follower.compare("text", ofFile(table.text.toUtf8(), {}));
    if (file.isRefused || !file.questions.empty() || !table.statesUnits)
        return; // what a table says of its units is known where it is pasted
    const Imported imported = importMeasurement(table.text.toUtf8(), {});
    follower.compare("readings",
                     pastedInto(std::get<PositioningMeasurement>(imported.test->measurement), table.text));
}

void followPlain(Follower &follower, std::mt19937 &random) {
    const testdata::PlainTable table = testdata::plainTable(random);
    QStringList lines;
    for (const QStringList &row : table.rows)
        lines << row.join(';');
    follower.begin(lines.join('\n'), ofFile(lines.join('\n').toUtf8(), "x.csv"));
    follower.compareForms(table.rows, '.');
    const Imported imported = importMeasurement(lines.join('\n').toUtf8(), "x.csv");
    const auto *read = std::get_if<PositioningMeasurement>(&imported.test->measurement);
    const auto listed = [](const std::vector<double> &targets) {
        QStringList texts;
        for (const double target : targets)
            texts << QString::number(target, 'g', 12);
        return Outcome{texts.join(' '), {}, false};
    };
    if (!read || !owed(imported.questions).empty())
        return;
    const auto targets = targetsFrom(lines.join('\n').toStdString(), read->axis, {});
    follower.compare("targets", targets ? listed(targets->targets) : Outcome{{}, {}, true},
                     listed(read->targets));
}

/// A list of limits and a template, against --set.
void followLimits(Follower &follower, std::mt19937 &random) {
    const std::vector<LimitName> names{{"A", "A"}, {"R", "R"}, {"B", "B"}, {"E", "E"}};
    const bool isMillimetres = random() % 2 == 0;
    const bool isInHeading = random() % 2 == 0;
    const char mark = random() % 2 == 0 ? '.' : ',';
    const QString unit = isMillimetres ? "mm" : "µm";
    QStringList lines{isInHeading ? QString("Result\tLimit (%1)").arg(unit) : QString("Result\tLimit")};
    Document document;
    Test test;
    test.edition = defaultEdition(Kind::positioning).word;
    document.tests.push_back(std::make_shared<const Test>(test));
    for (const LimitName &name : names) {
        const double micrometres = static_cast<double>(random() % 500 + 1) / 10;
        const QString number = QString::number(isMillimetres ? micrometres / 1000 : micrometres, 'f', 4)
                                   .replace('.', QLatin1Char(mark));
        lines << name.symbol + '\t' + number + (isInHeading ? QString() : ' ' + unit);
        document = withField(document, "limits." + name.id + ".value", (number + ' ' + unit).toStdString());
    }
    const auto listed = [](const Limits &limits) {
        QStringList texts;
        for (const auto &[id, limit] : limits)
            texts << QString::fromStdString(id) + ' ' + QString::number(limit.value.value_or(-1), 'g', 15);
        return Outcome{texts.join('\n'), {}, false};
    };
    follower.begin(lines.join('\n'), listed(document.tests[0]->limits));
    follower.compare("limits", outcomeOf([&] {
                         return listed(
                             pasteLimits({}, names, 0, lines.join('\n'), Quantity::deviation).limits);
                     }));
    follower.compare("template", outcomeOf([&] {
                         const Template kept{"T", limitSetOf(*document.tests[0])};
                         Test taken = test;
                         applyLimitSet(taken, std::get<LimitSet>(readTemplate(writeTemplate(kept)).content));
                         return listed(taken.limits);
                     }));
}

/// Rows of an acceptance sheet: what a spreadsheet, a browser and a word processor copy is what the file
/// says.
void followSheet(Follower &follower, std::mt19937 &random) {
    const char mark = random() % 2 == 0 ? '.' : ',';
    const bool isHeaded = random() % 2 == 0;
    std::vector<QStringList> rows;
    if (isHeaded)
        rows.push_back({"No.", "Object", "Tolerance", "Measured", "U", "Unit"});
    Document document;
    const auto count = static_cast<int>(1 + random() % 6);
    for (int i = 0; i < count; ++i) {
        const auto number = [&](int most) {
            return QString::number(static_cast<double>(random() % static_cast<unsigned>(most)) / 1000, 'f',
                                   3);
        };
        const QStringList cells{QString("G%1").arg(i + 1),
                                QString("check %1 of the table").arg(i),
                                number(50),
                                random() % 4 == 0 ? QString() : number(40),
                                number(9),
                                "mm"};
        const std::string place = "report.sheet[" + std::to_string(i) + "].";
        constexpr std::array keys{"number", "object", "permitted", "measured", "uncertainty", "unit"};
        QStringList copied;
        for (qsizetype k = 0; k < cells.size(); ++k) {
            if (!cells[k].isEmpty())
                document =
                    withField(document, place + keys.at(static_cast<std::size_t>(k)), cells[k].toStdString());
            copied << (k >= 2 && k <= 4 ? QString(cells[k]).replace('.', QLatin1Char(mark)) : cells[k]);
        }
        rows.push_back(copied);
    }
    const auto listed = [](const std::vector<SheetRow> &sheet) {
        QStringList texts;
        for (const SheetRow &row : sheet)
            texts << QString("%1 %2 %3 %4 %5 %6")
                         .arg(QString::fromStdString(row.number), QString::fromStdString(row.object))
                         .arg(row.permitted.high.value_or(-1))
                         .arg(row.measured.value_or(-1))
                         .arg(row.uncertainty.value_or(-1))
                         .arg(QString::fromStdString(row.unit));
        return Outcome{texts.join('\n'), {}, false};
    };
    QStringList lines;
    for (const QStringList &row : rows)
        lines << row.join('\t');
    follower.begin(lines.join('\n'), listed(document.report.sheet));
    for (const auto &[door, text] : {std::pair("sheet", lines.join('\n')),
                                     std::pair("sheet as HTML", copiedAs("text/html", htmlOf(rows).toUtf8())),
                                     std::pair("sheet as RTF", copiedAs("text/rtf", rtfOf(rows)))})
        follower.compare(door, outcomeOf([&, &text = text] {
                             return listed(pasteSheet({}, 0, SheetColumn::number, text).sheet);
                         }));
}

void followDrift(Follower &follower, std::mt19937 &random) {
    struct Units {
        const char *time;
        const char *deviation;
        double seconds;
        double millimetres;
    };
    constexpr std::array all{Units{"s", "µm", 1, 1e-3}, Units{"min", "mm", 60, 1},
                             Units{"h", "nm", 3600, 1e-6}, Units{"min", "µm", 60, 1e-3}};
    const Units &units = all[random() % all.size()];
    const char mark = random() % 2 == 0 ? '.' : ',';
    const auto number = [&](double value, int decimals) {
        return QString::number(value, 'f', decimals).replace('.', QLatin1Char(mark));
    };
    const auto channels = static_cast<int>(1 + random() % 3);
    const auto temperatures = static_cast<int>(random() % 3);
    QStringList head{QString("Time (%1)").arg(units.time)};
    for (int c = 0; c < channels; ++c)
        head << QString("Deviation%1 (%2)")
                    .arg(channels == 1 ? QString() : u' ' + QChar('X' + c), units.deviation);
    for (int c = 0; c < temperatures; ++c)
        head << QString("Temperature %1 (°C)").arg(c + 1);
    std::vector<QStringList> rows{head};
    const auto points = static_cast<int>(2 + random() % 20);
    for (int i = 0; i < points; ++i) {
        rows.push_back({number(i * 1.5, 1)});
        for (int c = 0; c < channels; ++c)
            rows.back() << number(static_cast<double>(random() % 900) / 10, 1);
        for (int c = 0; c < temperatures; ++c)
            rows.back() << number(20 + static_cast<double>(random() % 90) / 100, 2);
    }
    QStringList lines;
    for (const QStringList &row : rows)
        lines << row.join(';');
    const QString text = lines.join('\n');
    const Outcome file = ofFile(text.toUtf8(), "x.csv");
    follower.begin(text, file);
    follower.compareForms(rows, mark);
    const Axis axis =
        file.isRefused
            ? Axis()
            : std::get<DriftMeasurement>(importMeasurement(text.toUtf8(), "x.csv").test->measurement).axis;
    follower.compare("drift", outcomeOf([&]() -> Outcome {
                         const PastedDrift pasted = driftReadingsFrom(text.toStdString(), Motion::linear);
                         Imported shown;
                         shown.test = newDriftTest(axis);
                         putDriftReadings(*shown.test, 0, pasted.drift);
                         return {numbersOf(shown), owed(pasted.questions), false};
                     }));
}

void followArcs(Follower &follower, std::mt19937 &random) {
    constexpr double radius = 100;
    const bool isAlone = random() % 4 == 0; // radial deviations at equal steps
    const bool isMicrometres = isAlone || random() % 2 == 0;
    const char mark = random() % 2 == 0 ? '.' : ',';
    const auto points = static_cast<int>(36 + random() % 40);
    std::vector<QStringList> rows{{"Angle (°)", isMicrometres ? "Deviation (µm)" : "Radius (mm)"}};
    for (int i = 0; i <= points; ++i) {
        const double micrometres = static_cast<double>(random() % 90) / 10 + 1;
        const double value = isMicrometres ? micrometres : radius + micrometres / 1000;
        rows.push_back({QString::number(360.0 * i / points, 'f', 3).replace('.', QLatin1Char(mark)),
                        QString::number(value, 'f', isMicrometres ? 1 : 4).replace('.', QLatin1Char(mark))});
    }
    QStringList lines;
    for (const QStringList &row : rows)
        lines << (isAlone ? row.last() : row.join(';'));
    const QString text = lines.join('\n');
    ImportOptions known{{"nominalRadius", "100"}, {"plane", "XY"}, {"angleReference", "polar"}};
    const ImportOptions place{{"startAngle", "90"}, {"arc", random() % 2 == 0 ? "180" : "-360"}};
    if (isAlone) {
        known.insert(place.begin(), place.end());
        known["kind"] = "circular"; // nothing says it
    }
    const Outcome file = ofFile(text.toUtf8(), "x.csv", known);
    follower.begin(text, file);
    follower.compare("arcs", outcomeOf([&]() -> Outcome {
                         CircularMeasurement open;
                         open.plane = {"X", "Y"};
                         open.nominalRadius = radius;
                         const ArcTable pasted =
                             readArcTable(text.toStdString(), open, isAlone ? place : ImportOptions());
                         open.arcs = pasted.arcs;
                         Imported shown;
                         shown.test.emplace();
                         shown.test->edition = defaultEdition(Kind::circular).word;
                         shown.test->measurement = std::move(open);
                         return {numbersOf(shown), owed(pasted.questions), false};
                     }));
}

} // namespace

DoorCounts followDoors(int tables, std::uint64_t seed,
                       const std::function<void(const std::string &, const std::string &)> &report) {
    DoorCounts counts;
    Follower follower(counts, report);
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    for (int i = 0; i < tables; ++i) {
        followPositioning(follower, random);
        followPlain(follower, random);
        followDrift(follower, random);
        followArcs(follower, random);
        followLimits(follower, random);
        followSheet(follower, random);
    }
    return counts;
}

} // namespace palmer::laws
