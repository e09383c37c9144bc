#include "import/filenotes.h"

#include <QDate>
#include <QRegularExpression>

namespace palmer {

namespace {

constexpr std::size_t mostLines = 300;
constexpr std::size_t longestLine = 500;

const QRegularExpression &pattern(const char *text) {
    thread_local std::map<const char *, QRegularExpression> patterns;
    const auto [found, isNew] = patterns.try_emplace(text, QString::fromUtf8(text),
                                                     QRegularExpression::CaseInsensitiveOption |
                                                         QRegularExpression::UseUnicodePropertiesOption);
    return found->second;
}

std::optional<QString> captured(const char *text, const QString &line) {
    const auto match = pattern(text).match(line);
    return match.hasMatch() ? std::optional(match.captured(1).trimmed()) : std::nullopt;
}

std::optional<double> positiveNumber(const std::optional<QString> &text) {
    if (!text)
        return {};
    const std::string number = text->toStdString();
    const CellValue value =
        readCell(number, number.find(',') == std::string::npos ? DecimalMark::point : DecimalMark::comma);
    return value.kind == CellKind::number && value.value > 0 ? std::optional(value.value) : std::nullopt;
}

bool read(const QString &line, FileNotes &notes) {
    bool understood = false;
    const auto take = [&](std::string &field, const char *text) {
        if (const auto found = captured(text, line); found && field.empty() && !found->isEmpty()) {
            field = found->toStdString();
            understood = true;
        }
    };
    take(notes.axis, R"(\b(?:axis|axe|achse)\b[\s:=;,|]*([A-Z][0-9]?)\b)");
    take(notes.plane, R"(\b(?:plane|plan|ebene)\b[\s:=;,|]*([XYZ]{2})\b)");
    take(notes.operatorName,
         R"(\b(?:operator|opérateur|operateur|bediener|by|par)\s*[:=;]\s*([^;|,]{2,60}))");
    take(notes.machine, R"(\b(?:machine|maschine)\s*[:=;]\s*([^;|,]{2,80}))");
    take(notes.serialNumber,
         R"(\b(?:serial(?: no| number)?|n° de série|numéro de série|s/n)\.?\s*[:=;]\s*([^;|,]{1,60}))");
    if (notes.operatorName == "–" || notes.operatorName == "—")
        notes.operatorName.clear();
    if (pattern(R"(\b(?:unit|units|unité|unités|unite|einheit)\b)").match(line).hasMatch() && !notes.unit) {
        notes.unit = unitIn(line.toStdString());
        understood |= notes.unit != nullptr;
    }
    if (const auto iso = captured(R"(\b(\d{4}-\d{2}-\d{2})(?:\b|T))", line);
        iso && !notes.date && QDate::fromString(*iso, Qt::ISODate).isValid()) {
        notes.date = iso->toStdString();
        understood = true;
    } else if (const auto date = captured(R"(\b(\d{1,2}[./-]\d{1,2}[./-]\d{2,4})\b)", line);
               date && notes.dateText.empty()) {
        notes.dateText = date->toStdString();
        understood = true;
    }
    if (const auto radius =
            positiveNumber(captured(R"((?:\bR|\bradius|\brayon)\s*[:=;]?\s*(\d+(?:[.,]\d+)?)\s*mm\b)", line));
        radius && !notes.radius) {
        notes.radius = radius;
        understood = true;
    }
    if (const auto feed = positiveNumber(
            captured(R"((?:\bF|\bfeed|\bavance|\bfeedrate)\s*[:=;]?\s*(\d+(?:[.,]\d+)?)\s*mm/min)", line));
        feed && !notes.feed) {
        notes.feed = feed;
        understood = true;
    }
    return understood;
}

} // namespace

FileNotes notesOf(const CellTable &table, const TableBody &body) {
    FileNotes notes;
    std::size_t lines = 0;
    for (const std::uint32_t index : body.notes) {
        if (++lines > mostLines)
            break;
        const TableRow &row = table.rows()[index];
        std::string line;
        for (const TableCell &cell : table.cells(row)) {
            if (line.size() < longestLine && cell.size > 0)
                line += (line.empty()     ? ""
                         : row.count == 2 ? " : "
                                          : " ; ") +
                        std::string(table.text(cell).substr(0, longestLine));
        }
        if (read(QString::fromStdString(line), notes))
            ++notes.understood;
        else
            ++notes.ignored;
    }
    return notes;
}

} // namespace palmer
