// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/readers.h"

#include "document/place.h"
#include "import/instruments/ballbarelements.h"
#include "import/instruments/otherlines.h"
#include "import/layouts/arcs.h"
#include "import/layouts/sections.h"
#include "tables/contenterror.h"
#include "tables/dates.h"
#include "tables/decodetext.h"
#include "tables/numbercell.h"
#include "tables/units.h"

#include <QDate>
#include <QRegularExpression>
#include <QTime>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>

// Above 500 lines: one reader of one format, whose elements come in any order.

namespace palmer {

namespace {

constexpr int deepest = 64;
constexpr qsizetype longestText = qsizetype(1) << 28;
constexpr std::size_t mostReadings = 10'000'000;

std::optional<double> numberOf(const QString &text) {
    return numberIn(text.trimmed().toStdString());
}

struct BallbarRun {
    std::optional<Sense> sense;
    std::vector<double> readings;
    QString type; ///< DT of the readings
};

class BallbarReader {
public:
    BallbarReader(QByteArrayView bytes, Choices &choices, Imported &imported)
        : m_choices(choices)
        , m(imported) {
        // Qt decodes it only where its builder had ICU.
        if (declaredEncoding(bytes).compare(QLatin1StringView("windows-1252"), Qt::CaseInsensitive) == 0)
            m_xml.addData(QString::fromStdString(decodeText(bytes, Encoding::windows1252).text));
        else
            m_xml.addData(bytes.toByteArray());
    }

    void read() {
        parse();
        compose();
    }

private:
    [[nodiscard]] std::string place() const {
        return std::to_string(m_xml.lineNumber()) + ':' + std::to_string(m_xml.columnNumber() + 1);
    }

    /// Elements are recognised by name, at any depth.
    void parse() {
        QString text;
        while (!m_xml.atEnd()) {
            switch (m_xml.readNext()) {
            case QXmlStreamReader::DTD:
            case QXmlStreamReader::EntityReference:
                refuseAsAt(Error::Kind::syntax, place(),
                           REPORT_TEXT("report", "document type definitions "
                                                 "and entities are refused: no ballbar file has them"));
            case QXmlStreamReader::StartElement:
                if (m_path.size() >= deepest)
                    refuseAsAt(Error::Kind::syntax, place(),
                               REPORT_TEXT("report", "nested deeper than a file of this kind can be"));
                begin();
                text.clear();
                break;
            case QXmlStreamReader::Characters:
                if (text.size() + m_xml.text().size() > longestText)
                    refuseAsAt(Error::Kind::tooLarge, place(),
                               REPORT_TEXT("report", "a text longer than a file of this kind can have"));
                text += m_xml.text();
                break;
            case QXmlStreamReader::EndElement:
                end(text);
                text.clear();
                break;
            default:
                break;
            }
        }
        if (m_xml.hasError())
            refuseAsAt(Error::Kind::syntax, place(),
                       m_xml.error() == QXmlStreamReader::PrematureEndOfDocumentError
                           ? REPORT_TEXT("report", "the XML ends too early; the file was cut off")
                           : REPORT_TEXT("report", "this is no XML from here on; the file is damaged"));
    }

    void begin() {
        const QString name = m_xml.name().toString();
        const auto attributes = m_xml.attributes();
        const auto attribute = [&](const char *key) {
            return attributes.value(QLatin1StringView(key)).toString();
        };
        m_path << name;
        if (name == QLatin1StringView("TEST_SPEC"))
            m_tests.push_back(std::to_string(m_xml.lineNumber()) + " (" +
                              excerpt(attribute("NAME").toStdString()) + ')');
        if (!isOfTest())
            return;
        m_type = attribute("DT");
        m_feature = attribute("NAME");
        m_others.addAttributes(name, attributes);
        if (name == QLatin1StringView("TEST_SPEC")) {
            m_testName = m_feature;
        } else if (name == QLatin1StringView("INSTRUMENT")) {
            m_instrument.manufacturer = attribute("MANUFACTURER").toStdString();
            m_instrument.model = attribute("MODEL").toStdString();
        } else if (name == QLatin1StringView("PLANE")) {
            const QString plane = attribute("TEST_PLANE");
            m_plane = plane.isEmpty() ? attribute("VIEW") : plane;
        } else if (name == QLatin1StringView("MACHINE_TESTED")) {
            m.machine.name = m_feature.toStdString();
        } else if (name == QLatin1StringView("BALLBAR_RUN")) {
            m_runs.emplace_back();
        } else if (name == QLatin1StringView("ANALYSIS")) {
            m_analysis = m_feature;
        }
    }

    /// True within the test that is read, or before all tests.
    [[nodiscard]] bool isOfTest() const {
        return m_tests.empty() ||
               static_cast<double>(m_tests.size()) == m_choices.chosenNumber("table").value_or(1);
    }

    void end(const QString &text) {
        const QString name = m_path.isEmpty() ? QString() : m_path.takeLast();
        const std::string value = text.trimmed().toStdString();
        if (!isOfTest())
            return;
        if (!BallbarElements::isKnown(name))
            m_others.add(name, text.trimmed(), m_type);
        else if (name == QLatin1StringView("NOMINAL_LENGTH"))
            takeLength(text);
        else if (name == QLatin1StringView("PROGRAMMED_FEEDRATE"))
            takeFeed(text);
        else if (name == QLatin1StringView("A_AXIS_NAME"))
            m_axisA = value;
        else if (name == QLatin1StringView("B_AXIS_NAME"))
            m_axisB = value;
        else if (name == QLatin1StringView("OPERATOR"))
            m.operatorName = value;
        else if (name == QLatin1StringView("DATE_STARTED"))
            m_date = text.trimmed();
        else if (name == QLatin1StringView("SERIAL_NUMBER"))
            (m_path.contains(QLatin1StringView("MACHINE_TESTED")) ? m.machine.serialNumber
                                                                  : m_instrument.serialNumber) = value;
        else if (name == QLatin1StringView("LAST_CALIBRATED"))
            takeCalibration(name, text.trimmed());
        else if (name == QLatin1StringView("RUN_DIRECTION"))
            setDirection(text.trimmed());
        else if (name == QLatin1StringView("READINGS"))
            takeReadings(value);
        else if (name == QLatin1StringView("FEATURE"))
            takeFeature(text);
    }

    /// Stores a length in mm, the default unit; a value in an unknown unit is ignored.
    void takeLength(const QString &text) {
        const TypeUnit *unit = typeUnit(m_type);
        m_length = numberOf(text);
        m_lengthType = m_length ? m_type : QString();
        if (m_length && unit && unit->isLength)
            m_length = *m_length * unit->multiplier / unit->divisor;
        else if (m_length && !m_type.isEmpty())
            leaveOut(m_length);
        if (!m_length && !text.trimmed().isEmpty())
            m_others.add(QStringLiteral("NOMINAL_LENGTH"), text.trimmed(), m_type);
    }

    /// Stores a feed in mm/min.
    void takeFeed(const QString &text) {
        const TypeUnit *unit = typeUnit(m_type);
        m_feed = numberOf(text);
        const bool isFeed = unit && QLatin1StringView(unit->unit) == QLatin1StringView("mm/min");
        if (m_feed && !isFeed && !m_type.isEmpty())
            leaveOut(m_feed);
        if (!m_feed && !text.trimmed().isEmpty())
            m_others.add(QStringLiteral("PROGRAMMED_FEEDRATE"), text.trimmed(), m_type);
    }

    void leaveOut(std::optional<double> &value) {
        value.reset();
        m.remarks.problem({}, REPORT_TEXT("report", "The unit “%1” is not known."),
                          excerpt(m_type.toStdString()));
    }

    /// "20260312-102530", or a date as people write it.
    [[nodiscard]] static std::optional<std::string> dayIn(const QString &text) {
        const QDate date = QDate::fromString(text.left(8), QStringLiteral("yyyyMMdd"));
        return date.isValid() ? std::optional(date.toString(Qt::ISODate).toStdString())
                              : isoDate(text.toStdString());
    }

    void takeCalibration(const QString &name, const QString &text) {
        m_instrument.calibrationDate = dayIn(text);
        if (!m_instrument.calibrationDate && !text.isEmpty())
            m_others.add(name, text, m_type);
    }

    void setDirection(const QString &text) {
        if (m_runs.empty())
            return;
        if (text.compare(QLatin1StringView("CW"), Qt::CaseInsensitive) == 0)
            m_runs.back().sense = Sense::clockwise;
        else if (text.compare(QLatin1StringView("CCW"), Qt::CaseInsensitive) == 0)
            m_runs.back().sense = Sense::counterclockwise;
        else
            refuseContentAt(place(),
                            REPORT_TEXT("report", "“%1” is no direction of a run; expected CW or CCW"),
                            excerpt(text.toStdString()));
    }

    void takeReadings(std::string_view text) {
        if (m_runs.empty()) {
            m.remarks.unlike(static_cast<std::size_t>(m_xml.lineNumber()));
            return;
        }
        std::vector<double> &readings = m_runs.back().readings;
        if (readings.empty())
            m_runs.back().type = m_type;
        else if (m_runs.back().type != m_type)
            m_runs.back().type += QStringLiteral(", ") + m_type;
        for (std::string_view rest = withoutBlanks(text); !rest.empty(); rest = withoutBlanks(rest)) {
            const std::size_t end = std::min(rest.find_first_of(" \t\r\n"), rest.size());
            const std::string_view word = rest.substr(0, end);
            const auto value = numberIn(word);
            if (!value)
                refuseContentAt(
                    place(),
                    REPORT_TEXT("report", "“%1” is no reading; expected numbers separated by blanks"),
                    excerpt(word));
            readings.push_back(*value);
            if (readings.size() > mostReadings)
                refuseReadings(place());
            rest.remove_prefix(end);
        }
    }

    void takeFeature(const QString &text) {
        const auto number = numberOf(text);
        const bool isRead = number && !m_feature.isEmpty() && m_results.size() <= 10'000;
        if (!isRead || BallbarElements::isAngle(m_feature))
            m_others.add(m_feature, text.trimmed(), m_type);
        if (!isRead)
            return;
        const TypeUnit *unit = typeUnit(m_type);
        const QString head = m_path.contains(QLatin1StringView("ANALYSIS")) && !m_analysis.isEmpty()
                                 ? m_analysis + QStringLiteral(": ")
                                 : QString();
        m_results.push_back(
            {(head + m_feature).toStdString(), *number, unit ? unit->unit : m_type.toStdString()});
    }

    void compose() {
        (void)resolveMeasurement(m_tests, m_choices, m.remarks);
        const std::size_t empty =
            std::erase_if(m_runs, [](const BallbarRun &run) { return run.readings.empty(); });
        if (m_runs.empty())
            refuseContent(REPORT_TEXT("report", "there are no readings of a ballbar in it"));
        if (empty > 0)
            m.remarks.problem("unread", REPORT_TEXT("report", "Runs without readings: %1."), counted(empty));
        const bool lengthChosen = m_choices.isChosen("nominalRadius");
        if (!m_length && !lengthChosen)
            refuseLength();
        CircularMeasurement measurement;
        measurement.nominalRadius =
            m_choices.resolveNumber("nominalRadius", m_length.value_or(0), Origin::recognised).value;
        if (!(measurement.nominalRadius > 0))
            refuseContent(REPORT_TEXT("report", "the nominal radius is not positive"));
        Test test;
        askForPlane();
        resolveCircle(measurement, test.edition, planeWord(), m_feed, m_choices, m.remarks);
        resolveReadings(measurement);
        composeArcs(measurement);
        test.title = m_testName.toStdString();
        takeDate(dayIn(m_date), m_date.toStdString(), test, m.remarks);
        const QTime clock = QTime::fromString(m_date.mid(9, 4), QStringLiteral("HHmm"));
        if (test.date && clock.isValid())
            test.time = clock.toString(QStringLiteral("HH:mm")).toStdString();
        if (!m_results.empty()) {
            ImportedFile file;
            file.results = m_results;
            test.imports.push_back(std::move(file));
            m.remarks.note({},
                           REPORT_TEXT("report", "Results of the "
                                                 "instrument's own program: %1; they are shown beside ours."),
                           counted(m_results.size()));
        }
        m_others.remark(m.remarks);
        m_instrument.description = "ballbar";
        m.instruments = {m_instrument};
        test.measurement = std::move(measurement);
        m.test = std::move(test);
    }

    [[noreturn]] void refuseLength() const {
        if (!m_lengthType.isEmpty())
            refuseContent(REPORT_TEXT("report", "the unit “%1” of the nominal length is not known; state the "
                                                "length in mm as nominalRadius"),
                          excerpt(m_lengthType.toStdString()));
        refuseContent(REPORT_TEXT("report", "the nominal length is missing; state it as nominalRadius"));
    }

    [[nodiscard]] std::string planeOfAxes() const {
        return m_axisA.size() == 1 && m_axisB.size() == 1 ? upperCase(m_axisA + m_axisB) : std::string();
    }

    [[nodiscard]] std::string planeOfTest() const {
        const std::string plane = m_plane.toUpper().toStdString();
        return plane.size() == 2 && plane.find_first_not_of("XYZ") == std::string::npos ? plane
                                                                                        : std::string();
    }

    [[nodiscard]] std::string planeWord() const {
        return planeOfAxes().empty() ? planeOfTest() : planeOfAxes();
    }

    void askForPlane() {
        const std::string axes = planeOfAxes();
        const std::string test = planeOfTest();
        if (axes.empty() || test.empty() || std::ranges::is_permutation(axes, test))
            return;
        m.remarks
            .problem("plane", REPORT_TEXT("report", "Plane: the file names %1 and the axes %2; %2 is taken."),
                     test, axes)
            .answers = {axes, test};
    }

    /// The DT of all readings; runs in several units are converted to mm.
    QString typeOfReadings() {
        QStringList types;
        for (const BallbarRun &run : m_runs)
            types << (run.type.isEmpty() ? QStringLiteral("–") : run.type);
        types.removeDuplicates();
        if (types.size() == 1)
            return m_runs.front().type;
        const auto isLength = [](const BallbarRun &run) {
            const TypeUnit *unit = typeUnit(run.type);
            return unit && unit->isLength;
        };
        if (!std::ranges::all_of(m_runs, isLength))
            return types.join(QStringLiteral(", "));
        for (BallbarRun &run : m_runs) {
            const TypeUnit &unit = *typeUnit(run.type);
            for (double &value : run.readings)
                value = value * unit.multiplier / unit.divisor;
        }
        return QStringLiteral("UT_LENGTH_MM");
    }

    /// The unit of the readings: their DT; without it guessed from their size, with a remark.
    void resolveReadings(const CircularMeasurement &measurement) {
        const QString type = typeOfReadings();
        double largest = 0;
        std::vector<double> sizes;
        for (const BallbarRun &run : m_runs) {
            for (const double value : run.readings) {
                largest = std::max(largest, std::abs(value));
                sizes.push_back(value);
            }
        }
        std::ranges::nth_element(sizes, sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2));
        const double median = sizes[sizes.size() / 2];
        const TypeUnit *row = typeUnit(type);
        const TypeUnit *said = row && row->isLength ? row : nullptr;
        if (!said && !type.isEmpty())
            m.remarks.problem("unit", REPORT_TEXT("report", "The unit “%1” is not known."),
                              excerpt(type.toStdString()));
        const Origin origin = said ? Origin::recognised : Origin::guessed;
        const double inBase = said ? median * said->multiplier / said->divisor : median;
        const bool absolute = std::abs(inBase - measurement.nominalRadius) < 0.05 * measurement.nominalRadius;
        const auto content = m_choices.resolve("content", absolute ? "positions" : "deviations", origin);
        m_absolute = content.value == "positions";
        const bool isMicro = said ? said->divisor > 1 : !m_absolute && largest >= 1;
        const bool isMetre = said && said->multiplier > 1;
        const auto unit = m_choices.resolve("unit", isMicro ? "um" : isMetre ? "m" : "mm", origin);
        m_unit = unitOf(unit.value);
        if (m_unit->kind != UnitKind::length)
            refuseContent(REPORT_TEXT("report", "%1 cannot be %2 for a circular test"), nameOfChoice("unit"),
                          nameOfWord("unit", unit.value));
        const auto sign = m_choices.resolve("sign", "actualMinusTarget", Origin::guessed);
        m_inverted = sign.value == "targetMinusActual";
        if (content.origin == Origin::guessed || unit.origin == Origin::guessed)
            m.remarks.assumption(
                "unit",
                m_absolute ? REPORT_TEXT("report", "Readings: the file states no unit; about %1 they are "
                                                   "read as lengths of the bar in %2.")
                           : REPORT_TEXT("report", "Readings: the file states no unit; up to %1 they are "
                                                   "read as deviations in %2, positive outwards."),
                Number{m_absolute ? median : largest, Quantity::number, 4}, std::string(m_unit->sign));
    }

    /// Angles of a run, in degrees.
    struct Way {
        double start = 0;
        double arc = 0;
        double overshoot = 0; ///< at each end
    };

    Arc arcOf(const BallbarRun &run, const Way &way, double nominalRadius) {
        Arc path;
        path.angleReference = AngleReference::commanded;
        path.sense = *run.sense;
        const bool clockwise = path.sense == Sense::clockwise;
        // On a partial circle the return run begins where the first ended.
        const double begin = clockwise && way.arc < 360 ? way.start + way.arc : way.start;
        const double sign = clockwise ? -1 : 1;
        const double span = way.arc + 2 * way.overshoot;
        const std::size_t n = run.readings.size();
        if (n < 2)
            refuseContent(REPORT_TEXT("report", "a run of one reading is no circle"));
        for (std::size_t i = 0; i < n; ++i) {
            const double part = static_cast<double>(i) / static_cast<double>(n - 1);
            path.angles.push_back(begin + sign * (span * part - way.overshoot));
            const double value = m_unit->toBase(run.readings[i]) - (m_absolute ? nominalRadius : 0);
            path.radialDeviations.push_back(m_inverted ? 0 - value : value);
        }
        if (way.overshoot > 0) {
            const double last = begin + sign * way.arc;
            path.evaluated = Interval{std::min(begin, last), std::max(begin, last)};
        }
        return path;
    }

    /// Runs of one feed have as many readings if their arcs are as long.
    void askForLengths(const Choice<double> &arc) {
        constexpr double mostUnlike = 1.05;
        const auto size = [](const BallbarRun &run) { return run.readings.size(); };
        const auto [few, many] = std::ranges::minmax_element(m_runs, {}, size);
        if (arc.origin == Origin::guessed &&
            static_cast<double>(size(*many)) > mostUnlike * static_cast<double>(size(*few)))
            m.remarks.problem("arc",
                              REPORT_TEXT("report", "Arc: readings of the runs: %1 to %2, so one may be of a "
                                                    "shorter arc; %3 is assumed for each."),
                              counted(size(*few)), counted(size(*many)), Number{arc.value, Quantity::angle});
    }

    void composeArcs(CircularMeasurement &measurement) {
        static const QRegularExpression degrees(QStringLiteral("(\\d{2,3}(?:\\.\\d+)?)\\s*(?:°|deg)"),
                                                QRegularExpression::CaseInsensitiveOption);
        const auto match = degrees.match(m_testName);
        const double named = match.hasMatch() ? match.captured(1).toDouble() : 360;
        const Choice<double> arc = m_others.resolveAngle(
            "arc", named > 0 && named <= 720 ? named : 360,
            REPORT_TEXT("report", "Arc: the file has no angles; %1 at constant feed are assumed."), m_choices,
            m.remarks);
        const Choice<double> start = m_others.resolveAngle(
            "startAngle", 0,
            REPORT_TEXT("report", "Start angle: taken as %1. A wrong one turns squareness into "
                                  "scale mismatch."),
            m_choices, m.remarks);
        const Choice<double> overshoot = m_others.resolveAngle("overshoot", 0, {}, m_choices, m.remarks);
        if (!(arc.value > 0) || arc.value > 36'000 || overshoot.value < 0 || overshoot.value > 3600 ||
            std::abs(start.value) > 36'000)
            refuseContent(REPORT_TEXT("report", "start angle, arc or overshoot is beyond sense"));
        askForLengths(arc);
        for (const BallbarRun &run : m_runs) {
            if (run.sense)
                measurement.arcs.push_back(
                    arcOf(run, {start.value, arc.value, overshoot.value}, measurement.nominalRadius));
            else
                m.remarks.problem("unread",
                                  REPORT_TEXT("report", "A run states no direction and was not read."));
        }
        if (measurement.arcs.empty())
            refuseContent(REPORT_TEXT("report", "no run of the file states its direction"));
        remarkPaths(measurement, m.remarks);
    }

    QXmlStreamReader m_xml;
    Choices &m_choices;
    Imported &m;
    QStringList m_path;
    QString m_type;
    QString m_feature;
    QString m_analysis;
    QString m_testName;
    QString m_plane;
    QString m_date;
    std::string m_axisA;
    std::string m_axisB;
    std::optional<double> m_length;
    QString m_lengthType; ///< DT
    std::optional<double> m_feed;
    std::vector<BallbarRun> m_runs;
    std::vector<ImportedResult> m_results;
    Instrument m_instrument;
    std::vector<std::string> m_tests; ///< line and name of each
    BallbarElements m_others;
    bool m_absolute = false;
    bool m_inverted = false;
    const Unit *m_unit = nullptr;
};

bool isBallbarXml(QByteArrayView bytes) {
    const QByteArrayView start = bytes.first(std::min<qsizetype>(bytes.size(), 1 << 16));
    const qsizetype at = start.startsWith("\xEF\xBB\xBF") ? 3 : 0;
    // In UTF-16 every ASCII letter has a zero byte.
    const bool xml = start.sliced(std::min(at, start.size())).trimmed().startsWith('<') ||
                     start.startsWith("\xFF\xFE<") || start.startsWith(QByteArrayView("\xFE\xFF\0<", 4));
    return xml && !isWebPage(bytes);
}

void readBallbarXml(const ImportSource &source, Choices &choices, Imported &imported) {
    BallbarReader(source.bytes, choices, imported).read();
    remarkEncoding(source.bytes, imported.remarks);
    try {
        imported.text = decodeText(source.bytes).text;
    } catch (const Error &) {
        imported.text.clear(); // code page known to XML but not to the tables
    }
    choices.resolve("kind", "circular", Origin::recognised);
}

} // namespace

const ImportFormat ballbarFormat{"b5r", REPORT_TEXT("report", "Renishaw ballbar"), "b5r", isBallbarXml,
                                 readBallbarXml};

} // namespace palmer
