#include "report/report.h"

namespace palmer {

QString Phrase::plain() const {
    QString result;
    for (const Span &span : spans)
        result += span.text;
    return result;
}

Mark markOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::conforms:
        return Mark::check;
    case Verdict::notProven:
        return Mark::openCircle;
    case Verdict::doesNotConform:
        return Mark::cross;
    }
    return Mark::none;
}

Mark markOf(Grade grade) {
    return grade == Grade::requirement ? Mark::cross : Mark::openCircle;
}

bool Cell::isMissing() const {
    return !blank && mark == Mark::none && !guard && !bar && text.plain().isEmpty();
}

Cell blankCell() {
    Cell cell;
    cell.blank = true;
    return cell;
}

Report withPages(Report report, const std::map<QString, int> &pages) {
    for (Block &block : report.blocks) {
        auto *line = std::get_if<VerdictLine>(&block);
        if (!line || line->anchor.isEmpty())
            continue;
        const auto found = pages.find(line->anchor);
        line->accordance.replace(QLatin1String("%1"),
                                 found == pages.end() ? QStringLiteral("–") : QString::number(found->second));
    }
    return report;
}

} // namespace palmer
