// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#undef QT_NO_CAST_FROM_ASCII // literals of a test are UTF-8

#include "laws/importchoices.h"

#include "core/import/layouts/workshoptable.h"
#include "core/import/storedworkbook.h"
#include "document/writedocument.h"
#include "import/importmeasurement.h"
#include "kernel/measurement/testfacts.h"
#include "language/language.h"

#include <QStringList>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace palmer::laws {

namespace {

/// A file to import, and the choices that are made already.
struct ImportCase {
    QByteArray bytes;
    QString name = "x.csv";
    ImportOptions options = {};
};

using Random = std::mt19937;

std::size_t below(Random &random, std::size_t n) {
    return random() % n;
}

/// Targets and readings of both directions, the first column in mm, the others in µm.
std::vector<QStringList> numbersOf(Random &random, std::size_t runs) {
    std::vector<QStringList> rows;
    const std::size_t targets = 4 + below(random, 4);
    const double step = below(random, 2) == 0 ? 50 : 12.5;
    for (std::size_t i = 0; i < targets; ++i) {
        QStringList row{QString::number(static_cast<double>(i) * step, 'f', 2)};
        for (std::size_t j = 0; j < 2 * runs; ++j)
            row << QString::number(static_cast<double>(below(random, 160)) / 10 - 6.05, 'f', 2);
        rows.push_back(row);
    }
    return rows;
}

QStringList directed(std::size_t runs) {
    QStringList head{"Target (mm)"};
    for (std::size_t j = 0; j < 2 * runs; ++j)
        head << QString("Run %1 %2 (µm)").arg(j / 2 + 1).arg(j % 2 == 0 ? "forward" : "reverse");
    return head;
}

QByteArray csvOf(const QStringList &head, const std::vector<QStringList> &rows) {
    QStringList lines;
    if (!head.isEmpty())
        lines << head.join(';');
    for (const QStringList &row : rows)
        lines << row.join(';');
    return lines.join('\n').toUtf8() + '\n';
}

ImportCase workshop(Random &random) {
    return {testdata::workshopTable(random).bytes};
}

/// A table that says all, but for `lines` above it.
ImportCase tableBelow(Random &random, const QByteArray &lines) {
    const std::size_t runs = 1 + below(random, 3);
    return {lines + csvOf(directed(runs), numbersOf(random, runs))};
}

ImportCase withoutUnits(Random &random) {
    return {csvOf({"Target", "Deviation forward", "Deviation reverse"}, numbersOf(random, 1))};
}

ImportCase withoutDirections(Random &random) {
    return {csvOf({"Target (mm)", "Run 1 (µm)", "Run 2 (µm)"}, numbersOf(random, 1))};
}

ImportCase bare(Random &random) {
    return {csvOf({}, numbersOf(random, 1 + below(random, 2)))};
}

ImportCase bareAcross(Random &random) {
    const std::vector<QStringList> rows = numbersOf(random, 2);
    std::vector<QStringList> across(5);
    for (const QStringList &row : rows) {
        for (std::size_t c = 0; c < across.size(); ++c)
            across[c] << row[static_cast<qsizetype>(c)];
    }
    return {csvOf({}, across)};
}

/// Many pairs of numbers without a word: points of a circle, or readings.
ImportCase barePairs(Random &random) {
    std::vector<QStringList> rows;
    const bool isCircle = below(random, 2) == 0;
    for (int i = 0; i < 48; ++i) {
        const double angle = i * std::numbers::pi / 24;
        rows.push_back(isCircle ? QStringList{QString::number(100 * std::cos(angle), 'f', 3),
                                              QString::number(100 * std::sin(angle), 'f', 3)}
                                : QStringList{QString::number(i * 7.5, 'f', 1),
                                              QString::number(std::sin(angle) / 100, 'f', 4)});
    }
    return {csvOf({}, rows)};
}

ImportCase otherWords(Random &random) {
    const std::size_t runs = 1 + below(random, 2);
    QStringList head{"Target (mm)"};
    for (std::size_t j = 0; j < 2 * runs; ++j)
        head << QString("%1 %2 (µm)").arg(j == 0 ? "Frumious" : "Error").arg(j + 1);
    return {csvOf(head, numbersOf(random, runs))};
}

ImportCase twoAxes(Random &random) {
    return {csvOf({"Target (mm)", "X deviation (µm)", "Y deviation (µm)"}, numbersOf(random, 1))};
}

ImportCase axesOfBlocks(Random &random) {
    const QByteArray heads[] = {"Deviation", "Error"};
    QByteArray file;
    for (std::size_t i = 0; i < 2; ++i)
        file += QByteArray("Axis ") + "XY"[i] + "\n" +
                csvOf({"Target (mm)", heads[i * below(random, 2)] + " forward (µm)",
                       heads[i * below(random, 2)] + " reverse (µm)"},
                      numbersOf(random, 1)) +
                '\n';
    return {file};
}

ImportCase axisAgainstHeading(Random &random) {
    return {"Axis: Y\n" + csvOf({"X (mm)", "X forward (µm)", "X reverse (µm)"}, numbersOf(random, 1))};
}

ImportCase twoTables(Random &random) {
    return {csvOf({"Time (s)", "Air (°C)"}, {{"0", "20.1"}, {"600", "20.3"}, {"1200", "20.4"}}) + '\n' +
            csvOf(directed(1), numbersOf(random, 1))};
}

ImportCase twoStates(Random &random) {
    return {csvOf({"Target (mm)", "As found ↑ (µm)", "As found ↓ (µm)", "As left ↑ (µm)", "As left ↓ (µm)"},
                  numbersOf(random, 2))};
}

ImportCase twoDays(Random &random) {
    if (below(random, 2) == 0)
        return {"Date: 2026-03-04\n" + csvOf(directed(1), numbersOf(random, 1)) + "\nDate: 2026-03-05\n" +
                csvOf(directed(1), numbersOf(random, 1))};
    std::vector<QStringList> rows;
    for (const char *day : {"2026-03-04", "2026-03-05"}) {
        for (QStringList &row : numbersOf(random, 1)) {
            row.prepend(day);
            rows.push_back(row);
        }
    }
    QStringList head = directed(1);
    head.prepend("Date");
    return {csvOf(head, rows)};
}

ImportCase corrections(Random &random) {
    return {csvOf({"Target (mm)", "Correction ↑ (µm)", "Correction ↓ (µm)"}, numbersOf(random, 1))};
}

ImportCase saidSign(Random &random) {
    return tableBelow(random,
                      below(random, 2) == 0 ? "Deviation = target - actual\n" : "Signs as displayed\n");
}

/// Numbers that want a look: a run of zeros, the targets once more, far too large, fewer runs down, a letter
/// among digits, a line that ends early.
template <int kind>
ImportCase odd(Random &random) {
    std::vector<QStringList> rows = numbersOf(random, 2);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (kind == 0)
            rows[i][1] = "0";
        else if (kind == 1)
            rows[i][1] = rows[i][0];
        else if (kind == 2)
            rows[i][1] = QString::number(static_cast<double>(i) * 2100.5);
        else if (kind == 3)
            rows[i].removeLast();
    }
    if (kind == 4)
        rows[1][2] = "12O.5";
    if (kind == 5)
        rows[2].resize(2);
    QStringList head = directed(2);
    head.resize(rows[0].size());
    return {csvOf(head, rows)};
}

ImportCase doubts(Random &random) {
    return tableBelow(random, "Run 1 is invalid\n");
}

ImportCase thousands(Random &random) {
    std::vector<QStringList> rows;
    const auto number = [&](std::size_t whole) {
        return QString::number(whole) + ',' + QString::number(below(random, 9)) + "00";
    };
    for (std::size_t i = 0; i < 5; ++i)
        rows.push_back({number(i + 1), number(1 + below(random, 8)), number(1 + below(random, 8))});
    return {csvOf(directed(1), rows)};
}

ImportCase warm(Random &random) {
    std::vector<QStringList> rows = numbersOf(random, 1);
    rows.push_back({"600", "1.25", "2.50"});
    return {"Machine temperature: 22.5 °C\n" + csvOf(directed(1), rows)};
}

ImportCase sheets(Random &random) {
    const auto cells = [&](QStringList head) {
        std::vector<QStringList> rows = numbersOf(random, 1);
        for (QStringList &row : rows) {
            for (QString &cell : row)
                cell += '|' + cell;
        }
        rows.insert(rows.begin(), std::move(head));
        return rows;
    };
    if (below(random, 2) == 0)
        return {testdata::storedOds(cells(directed(1)), cells(directed(1))), "x.ods"};
    return {testdata::storedOds(cells(directed(1)), {}, 2), "x.ods"};
}

ImportCase drift(Random &random) {
    std::vector<QStringList> rows;
    const bool isHot = below(random, 2) == 0;
    for (int i = 0; i < 12; ++i)
        rows.push_back({QString::number(i * 5), QString::number(static_cast<double>(below(random, 90)) / 10),
                        QString::number(isHot ? 120.5 + i : 20.5)});
    return {csvOf({below(random, 2) == 0 ? "Time" : "Time (min)",
                   below(random, 2) == 0 ? "Deviation" : "Deviation (µm)", "Temperature table (°C)"},
                  rows)};
}

ImportCase processVariables(Random &random) {
    QByteArray file;
    for (int i = 0; i < 8; ++i) {
        for (const char *name : {"LAB:X:Position", "LAB:Y:Position"})
            file += QString("%1 2026-03-04 10:%2:00 %3\n")
                        .arg(name)
                        .arg(i, 2, 10, QLatin1Char('0'))
                        .arg(static_cast<double>(below(random, 90)) / 1e4, 0, 'f', 4)
                        .toUtf8();
    }
    return {file, "x.txt"};
}

ImportCase temperatures(Random &random) {
    ImportCase made = drift(random);
    made.options["kind"] = "temperatures";
    return made;
}

/// Points of a circle by their angles, with a word for its sense.
ImportCase circle(Random &random) {
    const bool isRadius = below(random, 2) == 0;
    const bool isAgainst = below(random, 2) == 0;
    std::vector<QStringList> rows;
    for (int i = 0; i <= 40; ++i) {
        const double deviation = static_cast<double>(below(random, 90)) / 1e4;
        rows.push_back({QString::number(isAgainst ? 360 - 9 * i : 9 * i),
                        isRadius ? QString::number(100 + deviation, 'f', 4)
                                 : QString::number(deviation * 1000, 'f', 1)});
    }
    constexpr std::array titles{"", "counterclockwise\n", "Circle cw or ccw\n"};
    return {titles[below(random, titles.size())] +
            csvOf({"Angle (°)", isRadius ? "Radius (mm)" : "Deviation (µm)"}, rows)};
}

/// Paths of several tests, or without a word for their sense: every path is an answer.
ImportCase paths(Random &random) {
    const std::array<QStringList, 4> heads{
        QStringList{"Angle (°)", "CCW F500 (µm)", "CW F500 (µm)", "CCW F2000 (µm)", "CW F2000 (µm)"},
        QStringList{"Angle (°)", "CCW XY (µm)", "CCW YZ (µm)"},
        QStringList{"Angle (°)", "As found CCW (µm)", "As left CCW (µm)"},
        QStringList{"Angle (°)", "Deviation 1 (µm)", "Deviation 2 (µm)"}};
    const QStringList &head = heads[below(random, heads.size())];
    std::vector<QStringList> rows;
    for (int i = 0; i <= 40; ++i) {
        rows.push_back({QString::number(9 * i)});
        while (rows.back().size() < head.size())
            rows.back() << QString::number(static_cast<double>(below(random, 90)) / 10, 'f', 1);
    }
    return {csvOf(head, rows)};
}

ImportCase radialDeviations(Random &random) {
    std::vector<QStringList> rows;
    for (int i = 0; i < 40; ++i)
        rows.push_back({QString::number(static_cast<double>(below(random, 90)) / 10, 'f', 1)});
    return {csvOf({"Deviation (µm)"}, rows), "x.csv", {{"kind", "circular"}, {"nominalRadius", "100"}}};
}

ImportCase ballbar(Random &random) {
    const auto readings = [&](double middle, int decimals) {
        QByteArray text;
        for (int i = 0; i < 24; ++i)
            text += QByteArray::number(middle + static_cast<double>(below(random, 90)) / 1e4, 'f', decimals) +
                    ' ';
        return text;
    };
    const bool isAbsolute = below(random, 2) == 0;
    return {"<TEST_DOCUMENT><TEST_SPEC NAME=\"test\"><DYNAMIC_BALLBAR>"
            "<NOMINAL_LENGTH DT=\"UT_LENGTH_MM\">100</NOMINAL_LENGTH>"
            "<PLANE VIEW=\"XY\" TEST_PLANE=\"XY\"><A_AXIS_NAME>X</A_AXIS_NAME><B_AXIS_NAME>Y</B_AXIS_NAME>"
            "</PLANE></DYNAMIC_BALLBAR></TEST_SPEC><RUN_RESULTS><BALLBAR_RUN><RUN_DIRECTION>CCW"
            "</RUN_DIRECTION><FEATURE NAME=\"OVERSHOOT\" DT=\"UT_ANGLE\">30</FEATURE><READINGS>" +
                readings(isAbsolute ? 100 : 0.001, 4) +
                "</READINGS></BALLBAR_RUN><BALLBAR_RUN><RUN_DIRECTION>CW</RUN_DIRECTION><READINGS>" +
                readings(isAbsolute ? 100 : 0.001, 4) +
                "</READINGS></BALLBAR_RUN></RUN_RESULTS></TEST_DOCUMENT>",
            "x.b5r"};
}

/// Choices that no file asks for.
ImportCase linesOf(Random &random) {
    ImportCase made = twoTables(random);
    made.options["lines"] = "6-99";
    return made;
}
ImportCase feedOf(Random &random) {
    ImportCase made = circle(random);
    made.options["feed"] = "1000";
    return made;
}

ImportCase angles(Random &random) {
    QByteArray rows;
    for (int i = 1; i <= 3; ++i)
        rows += QByteArray("1 ") + QByteArray::number(i) + ' ' +
                QByteArray::number(static_cast<double>(below(random, 90)) / 1e3, 'f', 3) + '\n';
    return {"HEADER::\nFile type : ANG\nOwner : Renishaw\nVersion no : 2\nTARGET DATA::\nFiletype : ANG\n"
            "Target-count : 3\nTargets :\n0 90 180\nFlags: 0 1 2 0\nUSER-TEXT::\nMachine : M\n"
            "RUNS::\nRun-count : 1\nDEVIATIONS::\nRun Target Data:\n" +
                rows + "EOF::\n",
            "x.rtl"};
}

constexpr std::array makers{workshop,
                            withoutUnits,
                            withoutDirections,
                            bare,
                            bareAcross,
                            barePairs,
                            otherWords,
                            twoAxes,
                            axesOfBlocks,
                            axisAgainstHeading,
                            twoTables,
                            twoStates,
                            twoDays,
                            corrections,
                            saidSign,
                            odd<0>,
                            odd<1>,
                            odd<2>,
                            odd<3>,
                            odd<4>,
                            odd<5>,
                            linesOf,
                            feedOf,
                            doubts,
                            thousands,
                            warm,
                            sheets,
                            drift,
                            processVariables,
                            temperatures,
                            circle,
                            paths,
                            radialDeviations,
                            ballbar,
                            angles};

/// What an import says, or why it is refused.
struct Answered {
    std::optional<Imported> imported;
    QString refusal = {};
    bool isNoAnswer = false; ///< refused for the answer itself, not for what it finds in the file
};

Answered answered(const ImportCase &made, const ImportOptions &options) {
    try {
        return {importMeasurement(made.bytes, made.name, options)};
    } catch (const Error &error) {
        return {{},
                Language(Language::Id::english).sentence(error.message),
                std::string_view(error.message.text.source).find("cannot be") != std::string_view::npos};
    }
}

/// The document with its test, without that a sign was assumed: an answer states it.
QString documentOf(const Imported &imported, const ImportCase &made) {
    if (!imported.test) { // temperatures belong to a test that is there
        QStringList sensors;
        for (const Sensor &sensor : imported.sensors)
            sensors << QString::fromStdString(sensor.position) + QString::number(sensor.start.value_or(0));
        return sensors.join(u'\n');
    }
    Document document;
    addImported(document, imported, made.bytes, made.name, false);
    Test test = *document.tests.front();
    for (ImportedFile &file : test.imports)
        file.signAssumed = false;
    document.tests.front() = std::make_shared<const Test>(std::move(test));
    return QString::fromUtf8(writeDocument(document));
}

class ChoiceFollower {
public:
    ChoiceFollower(ChoiceCounts &counts,
                   const std::function<void(const std::string &, const std::string &)> &report)
        : m_counts(counts)
        , m_report(report) {}

    void follow(const ImportCase &made) {
        ++m_counts.files;
        const Answered plain = answered(made, made.options);
        if (!plain.imported) {
            ++m_counts.refused;
            return;
        }
        for (const ImportChoice &choice : plain.imported->choices)
            ++m_counts.settled[choice.key];
        std::set<std::string> followed;
        for (const Question &question : plain.imported->questions) {
            ++m_counts.asked[question.id];
            if (followed.insert(question.id).second)
                follow(made, *plain.imported, question);
        }
    }

private:
    void follow(const ImportCase &made, const Imported &plain, const Question &question) {
        const std::vector<std::string> answers = answersOf(question);
        for (const std::string &answer : answers)
            requireAccepted(made, question, answer);
        if (!question.proposal.empty()) {
            for (const std::string &answer : {question.proposal, std::string(keepAnswer)}) {
                const Answered kept = requireAccepted(made, question, answer);
                if (kept.imported && documentOf(*kept.imported, made) != documentOf(plain, made))
                    fail("same document", made, question, answer, "another document");
            }
        }
        const ImportKey *key = findImportKey(question.id);
        if (answers.empty() && key->value == ImportValue::text && question.id != "columns")
            return; // any name
        ImportOptions options = made.options;
        options[question.id] = "no such answer";
        const Answered wrong = answered(made, options);
        ++m_counts.answers;
        const bool isName =
            question.id == "axis" && wrong.imported && axesOf(*wrong.imported->test) == options["axis"];
        if ((wrong.imported && !isName) || (!wrong.imported && wrong.refusal.isEmpty()))
            fail("refused", made, question, "no such answer", "accepted");
    }

    Answered requireAccepted(const ImportCase &made, const Question &question, const std::string &answer) {
        ImportOptions options = made.options;
        options[question.id] = answer;
        Answered result = answered(made, options);
        ++m_counts.answers;
        if (!result.imported) {
            if (result.isNoAnswer || result.refusal.isEmpty())
                fail("accepted", made, question, answer, result.refusal);
            return result;
        }
        for (const Question &each : result.imported->questions) {
            if (each.id == question.id)
                fail("asked once", made, question, answer,
                     Language(Language::Id::english).sentence(each.sentence));
        }
        return result;
    }

    void fail(const char *law, const ImportCase &made, const Question &question, const std::string &answer,
              const QString &what) {
        ++m_counts.failures;
        m_report(std::string(law) + ' ' + question.id,
                 QString("%1\n--- %2\n--- %3=%4: %5")
                     .arg(QString::fromUtf8(made.bytes.left(600)),
                          Language(Language::Id::english).sentence(question.sentence),
                          QString::fromStdString(question.id), QString::fromStdString(answer), what)
                     .toStdString());
    }

    ChoiceCounts &m_counts;
    const std::function<void(const std::string &, const std::string &)> &m_report;
};

} // namespace

ChoiceCounts followChoices(int rounds, std::uint64_t seed,
                           const std::function<void(const std::string &, const std::string &)> &report) {
    ChoiceCounts counts;
    ChoiceFollower follower(counts, report);
    Random random(static_cast<Random::result_type>(seed));
    for (int i = 0; i < rounds; ++i) {
        for (const auto &make : makers)
            follower.follow(make(random));
    }
    return counts;
}

std::vector<std::string> ChoiceCounts::missing() const {
    std::vector<std::string> keys;
    for (const ImportKey &key : importKeys()) {
        const bool isThere = isAsked(key.key) ? asked.contains(key.key) : settled.contains(key.key);
        if (!isThere)
            keys.emplace_back(key.key);
    }
    return keys;
}

} // namespace palmer::laws
