// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/partprogram.h"

#include "document/documenterror.h"
#include "document/place.h"
#include "kernel/planning/targetplan.h"
#include "language/rounding.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

namespace palmer {
namespace {

/// Differences between the dialects of G-code. Heidenhain Klartext has its own words.
struct Code {
    const char *open = nullptr;  ///< before the first block
    const char *close = nullptr; ///< after the last block
    const char *setUp =
        nullptr; ///< work offset; absolute, metric, feed per minute; exact stop at every target
    const char *dwell = nullptr;   ///< word before the seconds
    const char *offset = nullptr;  ///< work offset of the positions
    bool brackets = false;         ///< comments in brackets; false: after a semicolon
    bool assigns = false;          ///< axis names may have a number: X1=10
    bool pointOfPositions = false; ///< positions need a decimal point, or they are increments
    bool pointOfFeed = false;      ///< feeds need a decimal point
};

constexpr Code codeOf(Dialect dialect) {
    switch (dialect) {
    case Dialect::iso:
        return {"%\nO2302\n", "%\n", "G54 G90 G21 G94 G61", "G4 X", "G54", true, false, true, false};
    case Dialect::siemens:
        return {"", "", "G54 G90 G710 G94 G60", "G4 F", "G54", false, true, false, false};
    case Dialect::linuxcnc: // a program number would start a subroutine
        return {"", "", "G54 G90 G21 G94 G61.1", "G4 P", "G54", true, false, false, false};
    case Dialect::haas: // P without a decimal point is in milliseconds
        return {"%\nO02302\n", "%\n", "G54 G90 G21 G94 G61", "G4 P", "G54", true, false, true, true};
    case Dialect::heidenhain:
        break;
    }
    return {"", "", "", "", "", false, false, false, false};
}

[[noreturn]] void refuseProgram(Text text, std::vector<Argument> arguments = {}) {
    throw Error(Error::Kind::content, {text, std::move(arguments)});
}

/// Text of a comment: controls know only ASCII, and a bracket ends a comment.
std::string commentText(const QString &text) {
    std::string plain;
    for (const QChar c : text.normalized(QString::NormalizationForm_KD)) {
        if (c == u'\u2191')
            plain += '+';
        else if (c == u'\u2193' || c == u'\u2013' || c == u'\u2212')
            plain += '-';
        else if (c == u'\u2019')
            plain += '\'';
        else if (c == u';') // ends a block; French has a blank before it
            plain.erase(plain.find_last_not_of(' ') + 1).append(",");
        else if (c.isSpace())
            plain += ' ';
        else if (c.unicode() >= 32 && c.unicode() < 127 && c != u'(' && c != u')')
            plain += c.toLatin1();
    }
    return plain;
}

std::string withPoint(const std::string &number) {
    return number.find('.') == std::string::npos ? number + ".0" : number;
}

/// A positive number with at most 3 decimals and no trailing zeros: "4", "0.5".
std::string shortNumber(double value) {
    std::string digits = Decimal(value).rounded(3);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.'))
        digits.pop_back();
    return digits;
}

/// The axis name as the control writes it.
std::string axisName(const std::string &name, Dialect dialect) {
    std::string axis = name;
    std::ranges::transform(axis, axis.begin(), [](char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    });
    const bool known = !axis.empty() && axis.size() <= 4 &&
                       std::string_view("XYZUVWABC").find(axis[0]) != std::string_view::npos &&
                       std::all_of(axis.begin() + 1, axis.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!known)
        refuseProgram(
            REPORT_TEXT("report",
                        "a part program cannot move the axis “%1”: it knows the letters X, Y, Z, U, "
                        "V, W, A, B and C"),
            {excerpt(name)});
    if (axis.size() > 1 && !codeOf(dialect).assigns)
        refuseProgram(REPORT_TEXT("report",
                                  "in this dialect the axis %1 has no name of its own: %1 before a "
                                  "position would be axis %2 at another place; give the letter that the "
                                  "control knows it by"),
                      {axis, axis.substr(0, 1)});
    return axis;
}

/// Writes the program in one dialect.
class ProgramWriter {
public:
    ProgramWriter(const CycleProgram &program, Dialect dialect)
        : m_decimals(program.decimals)
        , m_klartext(dialect == Dialect::heidenhain)
        , m_code(codeOf(dialect))
        , m_axis(axisName(program.axis, dialect))
        , m_feed(program.feed ? shortNumber(*program.feed) : std::string())
        , m_dwell(shortNumber(program.dwell)) {}

    void comment(const QString &text) {
        const std::string plain = commentText(text);
        line(m_code.brackets ? "(" + plain + ")" : "; " + plain);
    }

    void begin() {
        m_text += m_code.open;
        if (m_klartext)
            line("BEGIN PGM ISO230_2 MM");
    }

    void setUp() {
        if (!m_klartext)
            line(m_code.setUp);
    }

    void move(double position) {
        const std::string to = Decimal(position).rounded(m_decimals);
        if (m_klartext) {
            const std::string sign = to.starts_with('-') ? "" : "+";
            line("L " + m_axis + sign + to + (m_feed.empty() ? " R0 FMAX" : " R0 F" + m_feed));
            return;
        }
        line((m_feed.empty() ? "G0 " : "G1 ") + m_axis + (m_axis.size() > 1 ? "=" : "") +
             (m_code.pointOfPositions ? withPoint(to) : to) +
             (m_feed.empty() ? "" : " F" + (m_code.pointOfFeed ? withPoint(m_feed) : m_feed)));
    }

    void dwell() {
        if (m_klartext) {
            line("CYCL DEF 9.0 DWELL TIME");
            line("CYCL DEF 9.1 DWELL " + m_dwell);
        } else {
            line(m_code.dwell + withPoint(m_dwell)); // without a point older controls read milliseconds
        }
    }

    void end() {
        line("M30");
        if (m_klartext)
            line("END PGM ISO230_2 MM");
        m_text += m_code.close;
    }

    [[nodiscard]] QByteArray text() const { return QByteArray::fromStdString(m_text); }

private:
    void line(const std::string &words) {
        if (m_klartext)
            m_text += std::to_string(m_number++) + " "; // every block is numbered, from 0
        m_text += words + "\n";
    }

    int m_decimals;
    bool m_klartext;
    Code m_code;
    std::string m_axis;
    std::string m_feed; ///< empty: rapid
    std::string m_dwell;
    std::string m_text;
    int m_number = 0;
};

void requireSense(const CycleProgram &program, Dialect dialect) {
    constexpr double shortest = 0.001; // s, mm/min: limited by the digits written
    constexpr double longestOfKlartext = 3600;
    if (program.targets.empty() || program.runs < 1)
        refuseProgram(REPORT_TEXT("report", "a part program needs targets and runs"));
    if (!(program.dwell >= shortest) || !std::isfinite(program.dwell) ||
        (dialect == Dialect::heidenhain && program.dwell > longestOfKlartext))
        refuseProgram(REPORT_TEXT("report", "the dwell of a part program cannot be %1"),
                      {Number{program.dwell, Quantity::time}});
    if (!(program.approach > 0) || !std::isfinite(program.approach))
        refuseProgram(REPORT_TEXT("report", "the approach distance of a part program is above 0"));
    if (program.feed && (!(*program.feed >= shortest) || !std::isfinite(*program.feed)))
        refuseProgram(REPORT_TEXT("report", "the feed rate of a part program is above 0"));
    std::string last;
    for (const double target : program.targets) {
        std::string written = Decimal(target).rounded(program.decimals);
        if (written == last)
            throw Error(Error::Kind::content,
                        {REPORT_TEXT_COUNTED("report", "two targets are the same with %n decimal(s): %1"),
                         {written},
                         program.decimals});
        last = std::move(written);
    }
}

void comments(ProgramWriter &writer, const CycleProgram &program, Dialect dialect, const Language &language) {
    const Quantity position = program.motion == Motion::linear ? Quantity::position : Quantity::angle;
    writer.comment(language.sentence(
        !program.only ? REPORT_TEXT("report", "positioning test of axis %1; targets: %2; runs each way: %3")
        : *program.only == Direction::positive
            ? REPORT_TEXT("report", "positioning test of axis %1; targets: %2; runs, positive only: %3")
            : REPORT_TEXT("report", "positioning test of axis %1; targets: %2; runs, negative only: %3"),
        {program.axis, wholeNumber(program.targets.size()), wholeNumber(program.runs)}));
    const Interval moved = movedThrough(program);
    writer.comment(language.sentence(
        REPORT_TEXT("report", "moves from %1 to %2: check the room before the start"),
        {Number{moved.from, position, program.decimals}, Number{moved.to, position, program.decimals}}));
    if (dialect == Dialect::heidenhain)
        writer.comment(language.text(REPORT_TEXT(
            "report", "positions in the active datum: set it before the start; for a compensation table at "
                      "the machine datum")));
    else
        writer.comment(language.sentence(
            REPORT_TEXT("report", "positions in work offset %1: set it before the start; for a compensation "
                                  "table to the machine zero"),
            {std::string(codeOf(dialect).offset)}));
}

} // namespace

std::span<const DialectName> dialects() {
    static constexpr std::array names{
        DialectName{Dialect::iso, "iso", "ISO (DIN 66025)", "nc"},
        DialectName{Dialect::siemens, "siemens", "Siemens SINUMERIK", "mpf"},
        DialectName{Dialect::heidenhain, "heidenhain", "Heidenhain", "h"},
        DialectName{Dialect::linuxcnc, "linuxcnc", "LinuxCNC", "ngc"},
        DialectName{Dialect::haas, "haas", "Haas", "nc"},
    };
    return names;
}

void requireProgrammable(const CycleProgram &program, Dialect dialect) {
    requireSense(program, dialect);
    (void)axisName(program.axis, dialect);
}

QByteArray partProgram(const CycleProgram &program, Dialect dialect, const Language &language) {
    requireProgrammable(program, dialect);
    ProgramWriter writer(program, dialect);
    writer.begin();
    comments(writer, program, dialect, language);
    writer.setUp();
    int run = -1;
    std::size_t target = program.targets.size();
    const std::vector<Move> path = cyclePath(program);
    for (auto move = path.begin(); move != path.end(); ++move) {
        // A move without a stop belongs to the next stop.
        const Stop &stop = move->stop ? *move->stop : *std::next(move)->stop;
        if (program.cycle == Cycle::standard && stop.run != run)
            writer.comment(language.sentence(REPORT_TEXT("report", "run %1"), {wholeNumber(stop.run + 1)}));
        if (program.cycle == Cycle::step && stop.target != target)
            writer.comment(
                language.sentence(REPORT_TEXT("report", "target %1"), {wholeNumber(stop.target + 1)}));
        run = stop.run;
        target = stop.target;
        writer.move(move->position);
        if (move->stop)
            writer.dwell();
    }
    writer.end();
    return writer.text();
}

} // namespace palmer
