#include "export/partprogram.h"

#include "kernel/planning/targetplan.h"
#include "language/rounding.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace palmer {
namespace {

bool isAxis(const std::string &axis) {
    return !axis.empty() && std::isalpha(static_cast<unsigned char>(axis[0])) != 0 && axis.size() <= 4 &&
           std::all_of(axis.begin() + 1, axis.end(),
                       [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

/// Text of a comment: controls know ASCII only, and brackets end a comment.
std::string commentText(const QString &text) {
    std::string plain;
    for (const QChar c : text.normalized(QString::NormalizationForm_KD)) {
        if (c == u'\u2191')
            plain += '+';
        else if (c == u'\u2193' || c == u'\u2013' || c == u'\u2212')
            plain += '-';
        else if (c == u'\u2019')
            plain += '\'';
        else if (c.isSpace())
            plain += ' ';
        else if (c.unicode() >= 32 && c.unicode() < 127 && c != u'(' && c != u')')
            plain += c.toLatin1();
    }
    return plain;
}

/// Writes the lines of one dialect.
class Writer {
public:
    Writer(const CycleProgram &program, Dialect dialect)
        : m_program(program)
        , m_dialect(dialect) {}

    void comment(const QString &text) {
        const std::string plain = commentText(text);
        if (m_dialect == Dialect::iso)
            line("(" + plain + ")");
        else
            line("; " + plain);
    }

    void begin() {
        switch (m_dialect) {
        case Dialect::iso:
            m_text += "%\nO2302\n";
            break;
        case Dialect::siemens:
            break;
        case Dialect::heidenhain:
            line("BEGIN PGM ISO230_2 MM");
            break;
        }
    }

    void setUp() {
        if (m_dialect == Dialect::heidenhain)
            return;
        // absolute, metric, feed per minute; exact stop at every target
        line(m_dialect == Dialect::iso ? "G90 G21 G94 G61" : "G90 G710 G94 G60");
    }

    void move(double position) {
        const std::string to = Decimal(position).rounded(m_program.decimals);
        const std::string feed = m_program.feed ? Decimal(*m_program.feed).shortest() : std::string();
        if (m_dialect == Dialect::heidenhain) {
            const std::string sign = to.starts_with('-') ? "" : "+";
            line("L " + m_program.axis + sign + to + (feed.empty() ? " R0 FMAX" : " R0 F" + feed));
            return;
        }
        // SINUMERIK wants X1=… for an axis with a number.
        const bool assigned = m_dialect == Dialect::siemens && m_program.axis.size() > 1;
        line((feed.empty() ? "G0 " : "G1 ") + m_program.axis + (assigned ? "=" : "") + to +
             (feed.empty() ? "" : " F" + feed));
    }

    void dwell() {
        const std::string seconds = Decimal(m_program.dwell).shortest();
        if (m_dialect == Dialect::heidenhain) {
            line("CYCL DEF 9.0 DWELL TIME");
            line("CYCL DEF 9.1 DWELL " + seconds);
        } else {
            line((m_dialect == Dialect::iso ? "G4 X" : "G4 F") + withPoint(seconds));
        }
    }

    void end() {
        if (m_dialect == Dialect::heidenhain) {
            line("M30");
            line("END PGM ISO230_2 MM");
        } else {
            line("M30");
            if (m_dialect == Dialect::iso)
                m_text += "%\n";
        }
    }

    [[nodiscard]] QByteArray text() const { return QByteArray::fromStdString(m_text); }

private:
    /// Without a point older controls take seconds for milliseconds.
    static std::string withPoint(const std::string &number) {
        return number.find('.') == std::string::npos ? number + ".0" : number;
    }

    void line(const std::string &words) {
        if (m_dialect == Dialect::heidenhain)
            m_text += std::to_string(m_number++) + " " + words + "\n"; // every block has its number, from 0
        else
            m_text += words + "\n";
    }

    const CycleProgram &m_program;
    Dialect m_dialect;
    std::string m_text;
    int m_number = 0;
};

} // namespace

QByteArray partProgram(const CycleProgram &program, Dialect dialect, const Language &language) {
    if (program.targets.empty() || program.runs < 1 || !(program.dwell > 0) || !(program.approach > 0) ||
        !isAxis(program.axis) || (program.feed && !(*program.feed > 0)))
        return {};
    Writer writer(program, dialect);
    writer.begin();
    const Quantity position = program.motion == Motion::linear ? Quantity::position : Quantity::angle;
    writer.comment(language.sentence(
        {REPORT_TEXT("report", "positioning test of axis %1; targets: %2; runs each way: %3"),
         {program.axis, Number{static_cast<double>(program.targets.size()), Quantity::count, 0},
          Number{static_cast<double>(program.runs), Quantity::count, 0}},
         {}}));
    writer.comment(
        language.sentence({REPORT_TEXT("report", "moves from %1 to %2: check the room before the start"),
                           {Number{program.targets.front() - program.approach, position, program.decimals},
                            Number{program.targets.back() + program.approach, position, program.decimals}},
                           {}}));
    writer.setUp();
    int run = -1;
    std::size_t target = program.targets.size();
    const std::vector<Move> path = cyclePath(program);
    for (auto move = path.begin(); move != path.end(); ++move) {
        // A move without rest belongs to the stop after it.
        const Stop &stop = move->stop ? *move->stop : *std::next(move)->stop;
        if (program.cycle == Cycle::standard && stop.run != run)
            writer.comment(language.sentence({REPORT_TEXT("report", "run %1"),
                                              {Number{static_cast<double>(stop.run + 1), Quantity::count, 0}},
                                              {}}));
        if (program.cycle == Cycle::step && stop.target != target)
            writer.comment(
                language.sentence({REPORT_TEXT("report", "target %1"),
                                   {Number{static_cast<double>(stop.target + 1), Quantity::count, 0}},
                                   {}}));
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
