// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "import/noteform.h"

#include "import/layouts/sections.h"
#include "tables/folded.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <optional>

namespace palmer {

namespace {

constexpr auto anyCase =
    QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption;

/// A unit and the words for what it is the unit of.
struct UnitStatement {
    QString of;
    SaidUnit unit;
    bool isLabelled = false; ///< by the word "unit"
    bool isWhole = false;    ///< the value is the unit and nothing else
};

/// The unit in a value; letters that are units only in brackets are units here too. Several, or one with a
/// number that is no part of it, are kept in their words.
void takeValue(const QString &text, UnitStatement &statement) {
    const std::string value = text.trimmed().toStdString();
    statement.unit = saidUnit('(' + value + ')');
    statement.isWhole = statement.unit.isSaid();
    if (statement.isWhole)
        return;
    statement.unit = saidUnit(value);
    static const QRegularExpression parts(QStringLiteral(R"([\s,;/]+)"));
    for (const QString &part : text.split(parts, Qt::SkipEmptyParts)) {
        const SaidUnit other = part.size() > 1 ? saidUnit('(' + part.toStdString() + ')') : SaidUnit();
        if (statement.unit.unit && ((other.unit && other != statement.unit) || part[0].isDigit()))
            statement.unit = {nullptr, value};
    }
}

Meaning meaningOf(const QString &words);

/// "Deviations [nm]", "at position (mm)": a quantity of the table and its unit in brackets, nothing else.
std::optional<UnitStatement> unitInBrackets(const QString &text) {
    static const QRegularExpression form(QStringLiteral(R"(^([^:=\d(\[]+)\s*[(\[]([^)\]]+)[)\]]$)"));
    const auto found = form.match(text.trimmed());
    if (!found.hasMatch())
        return {};
    UnitStatement statement{found.captured(1), saidUnit('(' + found.captured(2).toStdString() + ')')};
    constexpr int mostUnknown = 1; // "at"
    const bool isOfTable = isOneOf(meaningOf(statement.of),
                                   {Meaning::deviation, Meaning::actual, Meaning::place, Meaning::target}) &&
                           readHeading(statement.of.toStdString()).unknownWords <= mostUnknown;
    return isOfTable && statement.unit.unit ? std::optional(statement) : std::nullopt;
}

std::optional<UnitStatement> unitStatement(const QString &text) {
    if (const auto inBrackets = unitInBrackets(text))
        return inBrackets;
    static const QRegularExpression word(
        QStringLiteral(
            R"(\bunit(?:s|e|es|é|és|à|a|ies)?\b|\bunidad(?:es)?\b|(?:ma(?:ß|ss)|mess)?einheit(?:en)?\b|)"
            R"(单位|單位|単位)"),
        anyCase);
    static const QRegularExpression behindIn(QStringLiteral(R"(^(.*)\b(?:in|en)\s+(\S+(?:\s\S+)?)$)"),
                                             anyCase);
    UnitStatement statement;
    if (const auto unit = word.match(text); unit.hasMatch()) {
        static const QRegularExpression sign(QStringLiteral("[:=;]"));
        const qsizetype colon = text.indexOf(sign);
        if (colon >= 0 && colon < unit.capturedEnd())
            return {};
        statement.isLabelled = true;
        // "Pitch errors (unit: 0.1 µm)"
        const qsizetype begin = text.lastIndexOf(QLatin1Char('('), unit.capturedStart()) + 1;
        statement.of = text.mid(begin, unit.capturedStart() - begin) + QLatin1Char(' ') +
                       text.mid(unit.capturedEnd(), colon < 0 ? -1 : colon - unit.capturedEnd());
        takeValue(text.mid(colon < 0 ? unit.capturedEnd() : colon + 1), statement);
    } else if (const auto found = behindIn.match(text); found.hasMatch()) {
        statement.of = found.captured(1);
        takeValue(found.captured(2), statement);
    }
    return statement.unit.isSaid() ? std::optional(statement) : std::nullopt;
}

/// The quantity that a unit belongs to; also from the beginnings of words, as in "Einheit der Positionen".
Meaning meaningOf(const QString &words) {
    struct Row {
        const char *beginning;
        Meaning meaning;
    };
    const Meaning meaning = readHeading(words.toStdString()).meaning;
    const std::string low = ' ' + folded(words.toStdString());
    for (const auto &[beginning, of] :
         {Row{" abweich", Meaning::deviation}, Row{" fehler", Meaning::deviation},
          Row{" deviat", Meaning::deviation}, Row{" posit", Meaning::place}, Row{" posiz", Meaning::place},
          Row{" soll", Meaning::target}, Row{" quot", Meaning::place}, Row{" cot", Meaning::place}}) {
        if (meaning == Meaning::unknown && low.find(beginning) != std::string::npos)
            return of;
    }
    return meaning;
}

/// The field for a unit, by what it is the unit of; null: of something else.
SaidUnit *fieldOf(const UnitStatement &said, FileNotes &notes) {
    static const QRegularExpression general(
        QStringLiteral(
            R"(\b(?:dimension|size|leng|lang|longueur|lungh|longitud|measur|mass|metr|display|output|all\b))"),
        anyCase);
    const Meaning meaning = meaningOf(said.of);
    const UnitKind kind = said.unit.unit ? said.unit.unit->kind : UnitKind::length;
    const bool isOfTime = meaning == Meaning::time;
    const bool isOfHeat = meaning == Meaning::temperature;
    const bool isOfAny = isOneOf(meaning, {Meaning::unknown, Meaning::run, Meaning::axis}) &&
                         (!said.isLabelled || readHeading(said.of.toStdString()).unknownWords == 0 ||
                          general.match(said.of).hasMatch());
    const bool isGeneral = isOfAny && said.isLabelled;
    if ((isOfTime && !said.unit.unit) || (kind == UnitKind::time && (isOfTime || isGeneral)))
        return &notes.timeUnit;
    if ((isOfHeat && !said.unit.unit) || (kind == UnitKind::temperature && (isOfHeat || isGeneral)))
        return &notes.temperatureUnit;
    if (isOfTime || isOfHeat || kind == UnitKind::time || kind == UnitKind::temperature)
        return nullptr;
    if (isOneOf(meaning, {Meaning::place, Meaning::target, Meaning::angle}))
        return &notes.positionUnit;
    if (isOneOf(meaning, {Meaning::deviation, Meaning::reading, Meaning::actual, Meaning::radius}))
        return &notes.unit;
    // A unit without conversion may be of anything: "Humidity in %".
    const bool isSize =
        said.unit.unit || said.isLabelled || said.unit.foreign.find_first_of("0123456789") == 0;
    return isOfAny && isSize ? &notes.generalUnit : nullptr;
}

/// Two units of one quantity that are not the same are one that cannot be read.
bool takeUnit(const UnitStatement &said, const std::string &text, FileNotes &notes) {
    SaidUnit *field = fieldOf(said, notes);
    if (!field) {
        const bool isUnclear =
            said.isLabelled && said.isWhole && said.unit.unit && meaningOf(said.of) == Meaning::unknown;
        if (isUnclear && !notes.generalUnit.isSaid())
            notes.generalUnit.foreign = text;
        return false;
    }
    if (field->isSaid() && *field != said.unit)
        *field = {nullptr, field->words() + ", " + said.unit.words()};
    else
        *field = said.unit;
    return field->unit != nullptr;
}

/// "Scale factor 0.1", "Multiply by 10", "tenths of a micron", "x 0.1".
bool saysFactor(const QString &text, const FileNotes &notes) {
    static const QRegularExpression scale(
        QStringLiteral(
            R"(\b(?:scal(?:e factor|ing)|multipl(?:y|ied|ier|icat\w*|i[eé]e?s?|izier\w*)|fa[ck]t(?:or|eur|eurs|oren)|)"
            R"(fattore|tenths?|zehntel|dixi[eè]mes?|hundredths?|hundertstel|centi[eè]mes?|thousandths?|tausendstel|)"
            R"(milli[eè]mes?)\b|(?<!\w)(?<!\d\s)[x×]\s?(?:10{1,3}|0[.,]0{0,3}1)\b)"),
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression other(QStringLiteral(
        "resol|auflos|risol|cert|sicher|toler|limit|accura|genau|precis|dead path|travel|distan|cover|expan|"
        "elarg|erweit|copert|cobert|dilat|ausdehn|compens|kompens|correl|safety|power|k ?=|temp"));
    static const QRegularExpression one(QStringLiteral(R"(^\D*1(?:[.,]0+)?\D*$)"));
    const std::string line = text.toStdString();
    const SaidUnit said = saidUnit(line);
    const bool isOfReadings = !isOneOf(
        readHeading(line).meaning, {Meaning::radius, Meaning::nominal, Meaning::other, Meaning::temperature});
    const bool isPart = isOfReadings && !notes.unit.isSaid() && !notes.generalUnit.isSaid() &&
                        !said.foreign.empty() && said.foreign.front() >= '0' && said.foreign.front() <= '9';
    return (isPart || (scale.match(text).hasMatch() && !one.match(text).hasMatch())) &&
           !other.match(QString::fromStdString(folded(line))).hasMatch();
}

} // namespace

QString statementOf(const LabelledValue &said) {
    if (said.label.empty() || said.values.empty() || said.text.find_first_of(":=") != std::string::npos)
        return QString::fromStdString(said.text).trimmed();
    QString text = QString::fromStdString(said.label) + QLatin1Char(':');
    for (const std::string &value : said.values)
        text += QLatin1Char(' ') + QString::fromStdString(value);
    return text;
}

bool isUnitWithLabel(const LabelledValue &said) {
    const auto statement = unitStatement(statementOf(said));
    return statement && statement->isLabelled;
}

bool readForm(const LabelledValue &said, FileNotes &notes) {
    static const QRegularExpression sign(
        QStringLiteral(
            R"(\b(?:signs?(?![-\s]*off)|vorzeichen|signes?|segn[oi]|signos?|inwards?|nach innen|vers l['’]int[eé]rieur|)"
            R"(verso l['’]interno|hacia dentro|(?:correction|compensation) (?:values?|table)|korrektur(?:werte|tabelle)|)"
            R"(kompensations(?:werte|tabelle)|valeurs? de (?:correction|compensation)|valori di (?:correzione|)"
            R"(compensazione)|valores de (?:correcci[oó]n|compensaci[oó]n))\b)"),
        anyCase);
    // "Positions in inches, deviations in microns", "Deviation (nm) at position (mm)"
    static const QRegularExpression between(
        QStringLiteral(R"(\s*[,;]\s+|\s+(?:and|und|et|e|y)\s+|(?<=[)\]])\s+\w+\s+(?=\w))"));
    const QString text = statementOf(said);
    const QStringList clauses = text.split(between);
    if (clauses.size() > 1 &&
        std::ranges::all_of(clauses, [](const QString &clause) { return unitStatement(clause).has_value(); }))
        return std::ranges::count_if(clauses, [&](const QString &clause) {
                   return takeUnit(*unitStatement(clause), clause.toStdString(), notes);
               }) == clauses.size();
    static const QRegularExpression interval(
        QStringLiteral(R"(\b\w*interval(?:l|le|lo|o)?\b\D*?(\d+(?:[.,]\d+)?)\s*(ms|s|sec|min|h)\b)"),
        anyCase);
    if (const auto found = interval.match(text); found.hasMatch() && !notes.interval) {
        const auto value = numberIn(found.captured(1).toStdString());
        const SaidUnit unit = saidUnit('(' + found.captured(2).toStdString() + ')');
        if (value && unit.unit)
            notes.interval = unit.unit->toBase(*value);
        return notes.interval.has_value();
    }
    const auto statement = unitStatement(text);
    if (statement && takeUnit(*statement, said.text, notes))
        return true;
    if (!statement && saysFactor(text, notes))
        notes.factor += (notes.factor.empty() ? "" : ", ") + said.text;
    else if (sign.match(text).hasMatch() && notes.sign.words.empty())
        notes.sign.words = said.text;
    return false;
}

void settleUnits(FileNotes &notes) {
    if (!notes.unit.isSaid())
        notes.unit = notes.generalUnit;
    else if (!notes.positionUnit.isSaid() && notes.generalUnit.unit != notes.unit.unit)
        notes.positionUnit.unit = notes.generalUnit.unit;
    if (!notes.factor.empty())
        notes.unit = {nullptr, notes.unit.words() + (notes.unit.isSaid() ? ", " : "") + notes.factor};
}

bool doubtsReadings(const std::string &line) {
    static const QRegularExpression words(QStringLiteral(
        R"(\b(?:invalid|abort(?:ed)?|interrupt(?:ed)?|discard(?:ed)?|reject(?:ed)?|unusable|wrong|faulty|swapped|)"
        R"(beam (?:broken|lost|break)|exchanged|re-?zeroed|ungultig|ungueltig|abgebrochen|unterbrochen|)"
        R"(verworfen|falsch|fehlerhaft|vertauscht|unbrauchbar|invalides?|invalidees?|interrompue?s?|abandonnee?s?|)"
        R"(rejetee?s?|fausse?s?|permutee?s?|non valid[oaei]|interrott[oaei]|scartat[oaei]|sbagliat[oaei]|)"
        R"(scambiat[oaei]|no valid[oa]s?|interrumpid[oa]s?|descartad[oa]s?|erronee?s?|erroneo)\b|)"
        R"((?:readings?|taken|measured) (?:in|from) \w+ direction only)"));
    return words.match(QString::fromStdString(folded(line))).hasMatch();
}

} // namespace palmer
