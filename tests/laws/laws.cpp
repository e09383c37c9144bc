// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "laws/laws.h"

#include "document/evaluateddocument.h"
#include "document/json.h"
#include "document/plannedtest.h"
#include "document/readdocument.h"
#include "document/savedocument.h"
#include "document/testsofverdict.h"
#include "export/dcc.h"
#include "export/partprogram.h"
#include "export/resultsjson.h"
#include "figures/figuretexts.h"
#include "figures/testfigures.h"
#include "import/importmeasurement.h"
#include "kernel/evaluation/accordance.h"
#include "kernel/measurement/testfacts.h"
#include "language/rounding.h"
#include "language/visibletext.h"
#include "print/figures/exportfigure.h"
#include "print/pdf/writepdf.h"
#include "print/proof/verifyreport.h"
#include "register/listing.h"
#include "register/registeredtest.h"
#include "report/attachedfile.h"
#include "report/blocks/pagetext.h"
#include "report/blocks/plaintext.h"
#include "report/composereport.h"
#include "report/parts/comparedtests.h"
#include "report/tables/findinglines.h"
#include "report/tables/resulttable.h"
#include "report/tables/summary.h"
#include "report/words/findingtext.h"
#include "report/words/wording.h"
#include "ui/results/findingsmodel.h"

#include <QBuffer>
#include <QLocale>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <algorithm>
#include <cmath>
#include <set>

namespace palmer::laws {

namespace {

/// A file read and evaluated.
struct Followed {
    EvaluatedDocument evaluated;

    explicit Followed(const Json &file)
        : evaluated(evaluate(
              std::make_shared<const Document>(readDocument(QByteArray::fromStdString(file.dump()))))) {}
};

/// Letters and digits alone: lines break, symbols get a comma before an index, numbers their thin blanks.
QString plain(const QString &text) {
    QString result;
    for (const QChar c : text) {
        if (c.isLetterOrNumber())
            result += c;
    }
    return result;
}

/// The rows of a test that are unmet, and those that ask for a statement.
std::set<std::string> openRows(const TestEvaluation &evaluation) {
    std::set<std::string> rows;
    for (const Finding &finding : evaluation.findings) {
        if (finding.state && (finding.source == Source::text || finding.source == Source::practice))
            rows.insert(finding.id + (finding.state == State::undeclared ? " asked" : ""));
    }
    return rows;
}

int openNames(const TestEvaluation &evaluation) {
    return static_cast<int>(
        std::ranges::count_if(evaluation.findings, [](const Finding &f) { return f.state.has_value(); }));
}

/// A correction that is no longer stated gives other numbers, and a verdict on those.
bool sameValues(const AgreedLimit &limit, const TestEvaluation &a, const TestEvaluation &b) {
    return std::ranges::all_of(a.parameters, [&](const Parameter &parameter) {
        if (!parameter.value ||
            std::ranges::find(limit.parameters, parameterId(parameter)) == limit.parameters.end())
            return true;
        const auto same = std::ranges::find(b.parameters, parameterId(parameter), parameterId);
        return same == b.parameters.end() || same->value == parameter.value;
    });
}

bool isGood(Accordance accordance) {
    return accordance == Accordance::yes || accordance == Accordance::partly;
}

/// Without U nobody can prove a rejection: the verdict becomes "not proven", which is no reason to reject.
bool isUnprovenNow(const Followed &before, const Followed &after) {
    for (std::size_t i = 0; i < before.evaluated.tests.size(); ++i) {
        const Test &test = *before.evaluated.document->tests[i];
        if (test.decisionRule.rule == Rule::rejectionProven &&
            before.evaluated.tests[i]->verdict == Verdict::doesNotConform &&
            after.evaluated.tests[i]->verdict == Verdict::notProven)
            return true;
    }
    return false;
}

/// Rows that the text asks for only where something is stated (2006, 4.3.1: the statements of a correction),
/// so that they go with it, and contradictions between two statements: the key, and the row.
const std::set<std::pair<std::string, std::string>> obligations{{"correctionTo20", "correctionStatements"},
                                                                {"range", "travel"}};

/// What gets better when the statement `key` is taken away; null: nothing.
std::optional<std::string> better(const std::string &key, const Followed &before, const Followed &after) {
    const auto &tests = before.evaluated.tests;
    if (after.evaluated.tests.size() != tests.size())
        return "another number of tests";
    for (std::size_t i = 0; i < tests.size(); ++i) {
        const TestEvaluation &a = *tests[i];
        const TestEvaluation &b = *after.evaluated.tests[i];
        const std::set<std::string> rowsBefore = openRows(a);
        const std::set<std::string> rowsAfter = openRows(b);
        std::string gone;
        for (const std::string &row : rowsBefore)
            gone += rowsAfter.contains(row) || obligations.contains({key, row}) ? "" : " " + row;
        // A row may give way to another that asks what is no longer said.
        const bool asked =
            std::ranges::any_of(rowsAfter, [&](const std::string &row) { return !rowsBefore.contains(row); });
        if (!gone.empty() && !asked && openNames(b) < openNames(a))
            return "requirement met:" + gone;
        for (const AgreedLimit &limit : a.limits) {
            const auto now = std::ranges::find(b.limits, limit.key, &AgreedLimit::key);
            if (limit.state != LimitState::respected && now != b.limits.end() &&
                now->state == LimitState::respected && sameValues(limit, a, b))
                return "limit respected: " + limit.key;
        }
        if (!isGood(a.accordance()) && isGood(b.accordance()))
            return "accordance shown";
    }
    if (hasRejection(before.evaluated) && !hasRejection(after.evaluated) && !isUnprovenNow(before, after))
        return "exit 1 becomes 0";
    return std::nullopt;
}

/// Takes a statement away: null, or the key removed. The null file is only made where the schema allows it.
Json without(const Json &file, const Path &path, bool asNull) {
    Json changed = file;
    Json *at = &changed;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        at = at->is_array() ? &(*at)[std::stoul(path[i])] : &(*at)[path[i]];
    if (asNull)
        (*at)[path.back()] = nullptr;
    else
        at->erase(path.back());
    return changed;
}

/// The file without a statement; null where it is none: what a file needs to be one the reader asks for.
std::optional<Followed> whenSilent(const Json &file) {
    try {
        return Followed(file);
    } catch (const Error &) {
        return std::nullopt;
    }
}

QString pageOf(const Followed &followed) {
    const Language english(Language::Id::english);
    return pageText(composeReport(followed.evaluated, english, {QStringLiteral("Palmer " PALMER_VERSION)}));
}

/// Choices that are made, and printed as made, where none is stated; and what only places and names things.
/// A feed is programmed unless it is rapid.
const std::set<std::string> choices{
    "feedMode",   "coverageFactor", "guardFactor", "method",      "rule", "driftModel", "angleReference",
    "sameSensor", "seed",           "trials",      "instruments", "id",   "driftTest"};

/// Whether something is stated there that a reader may look for.
bool isStatement(const Json &file, const Path &path) {
    const Json *at = &file;
    for (const std::string &key : path)
        at = at->is_array() ? &at->at(std::stoul(key)) : &at->at(key);
    return !choices.contains(path.back()) &&
           (at->is_boolean() || at->is_number() ||
            (at->is_string() && *at != "" && *at != "notStated" && *at != "not stated"));
}

/// Readings are drawn and tabulated, which other tests look at; seeds and trials are of a simulation that
/// these files do not ask for.
const std::set<std::string> drawn{"runs",   "arcs", "times",  "deviations", "values",
                                  "series", "seed", "trials", "version"};

/// "123" of 0.0123, which may be printed as 12.3 µm.
QString significantDigits(double number) {
    static const QRegularExpression zeros(QStringLiteral("^0+|0+$"));
    QString digits = QString::number(std::abs(number), 'g', 15);
    if (digits.contains(u'e'))
        digits = QString::number(std::abs(number), 'f', QLocale::FloatingPointShortest);
    digits.remove(u'.').remove(zeros);
    return digits;
}

QStringList numbersIn(const QString &text) {
    static const QRegularExpression number(QStringLiteral("[0-9]+"));
    QStringList found;
    for (auto it = number.globalMatch(text); it.hasNext();)
        found << it.next().captured();
    return found;
}

constexpr int filesOfAnSvg = 5; ///< one in so many: drawing takes its time

/// Follows one file.
class Follower {
public:
    Follower(const Json &file, Counts &counts)
        : m_file(file)
        , m_followed(file)
        , m_counts(counts)
        , m_json(parseJson(resultsJson(m_followed.evaluated, QStringLiteral("x.palmer"),
                                       Language(Language::Id::english), JsonForm::oneLine)
                               .toStdString())) {
        harmless("JSON", QString::fromUtf8(resultsJson(m_followed.evaluated, QStringLiteral("x.palmer"),
                                                       Language(Language::Id::english), JsonForm::oneLine)));
    }

    [[nodiscard]] const Followed &followed() const { return m_followed; }
    [[nodiscard]] std::vector<Violation> &violations() { return m_violations; }

    void follow(bool asPdf) {
        for (const Language::Id id : {Language::Id::english, Language::Id::french}) {
            const Language language(id);
            const Report report =
                composeReport(m_followed.evaluated, language, {QStringLiteral("Palmer " PALMER_VERSION)});
            const QString page = plain(pageText(report));
            harmless("the report", pageText(report));
            limitsOnPages(report, language);
            statementsOnPages(page);
            oneVoice(page, language);
            if (id == Language::Id::english)
                sameNumbers(report);
            if (asPdf && id == Language::Id::english)
                verifies(report);
        }
        for (std::size_t i = 0; i < document().tests.size(); ++i) {
            csv(i);
            figure(i);
            window(i);
            program(i);
        }
        certificate();
        limits();
        counts();
        groups();
        registered();
    }

private:
    [[nodiscard]] const Document &document() const { return *m_followed.evaluated.document; }
    void violated(const char *law, std::string what) { m_violations.push_back({law, std::move(what)}); }

    /// Each limit of the file is in JSON in exactly one state, and "conforms" needs all of them respected.
    void limits() {
        for (std::size_t i = 0; i < document().tests.size(); ++i) {
            const TestEvaluation &evaluation = *m_followed.evaluated.tests[i];
            std::set<std::string> stated;
            const Json &limits = m_file["tests"][i].value("limits", Json::object());
            for (const auto &[key, limit] : limits.items()) {
                if (limit.contains("value") && !limit["value"].is_null())
                    stated.insert(key);
            }
            m_counts.limits += static_cast<int>(stated.size());
            if (!evaluation.edition)
                continue;
            bool all = !stated.empty();
            std::set<std::string> listed;
            for (const Json &limit : m_json["tests"][i]["agreedLimits"]) {
                if (!listed.insert(limit["key"]).second)
                    violated("limits", "twice: " + limit["key"].get<std::string>());
                all = all && limit["state"] == "respected";
                if ((limit["state"] == "notEvaluable") != !limit["reason"].is_null())
                    violated("limits", "a reason without need, or none: " + limit["key"].get<std::string>());
            }
            if (listed != stated)
                violated("limits", "listed are others than those of the file");
            const Json &verdict = m_json["tests"][i]["verdict"];
            if ((verdict == "conforms") != all)
                violated("limits",
                         "verdict " + verdict.dump() + " with all respected: " + (all ? "yes" : "no"));
            if (stated.empty() != verdict.is_null())
                violated("limits", "a verdict without a limit, or none with one");
            if (!stated.empty() && !all && countsForVerdict(document(), i) &&
                document().tests[i]->decisionRule.rule != Rule::rejectionProven &&
                !hasRejection(m_followed.evaluated))
                violated("limits", "exit 0 with a limit that is not respected");
        }
    }

    /// Page 1 names every limit of its test, the summary counts all of them.
    void limitsOnPages(const Report &report, const Language &language) {
        std::vector<const VerdictLine *> lines;
        for (const Block &block : report.blocks) {
            if (const auto *line = std::get_if<VerdictLine>(&block); line && !line->interprets)
                lines.push_back(line);
        }
        std::vector<std::size_t> tests;
        for (std::size_t i = 0; i < document().tests.size(); ++i) {
            if (m_followed.evaluated.tests[i]->edition)
                tests.push_back(i);
        }
        if (!document().report.sheet.empty() && !lines.empty()) {
            sheetOnPages(*lines.front(), language);
            lines.erase(lines.begin());
        }
        const bool summary = lines.size() == tests.size() + 1;
        if (!summary && lines.size() != tests.size()) {
            violated("limits", "verdict lines: " + std::to_string(lines.size()));
            return;
        }
        std::size_t counted = 0;
        for (std::size_t k = 0; k < tests.size(); ++k) {
            const TestEvaluation &evaluation = *m_followed.evaluated.tests[tests[k]];
            const QString text = lines[k + (summary ? 1 : 0)]->limits.text.plain();
            if (countsForVerdict(document(), tests[k]))
                counted += evaluation.limits.size();
            for (const AgreedLimit &limit : evaluation.limits) {
                bool named = text.contains(QString::fromStdString(limit.symbol));
                for (const Parameter &parameter : evaluation.parameters) {
                    if (std::ranges::find(limit.parameters, parameterId(parameter)) != limit.parameters.end())
                        named = named || text.contains(QString::fromStdString(plainSymbol(parameter)));
                }
                if (!named)
                    violated("limits", "page 1 does not name " + limit.key + " in " +
                                           language.code().toStdString() + ": " + text.toStdString());
            }
        }
        if (!summary || counted < 2) // one is named, not counted
            return;
        const QString text = lines[0]->limits.text.plain();
        if (!numbersIn(text).contains(QString::number(counted)))
            violated("limits",
                     "the summary counts others than " + std::to_string(counted) + ": " + text.toStdString());
    }

    /// Page 1 counts and names the rows that are not met; without their values none gets better.
    void sheetOnPages(const VerdictLine &line, const Language &language) {
        const Json &sheet = m_json["sheet"];
        const Json &rows = m_file["report"]["sheet"];
        std::map<std::string, int> states;
        for (const Json &row : sheet["rows"])
            ++states[row["state"]];
        const int apply = static_cast<int>(rows.size()) - states["notApplicable"];
        if (sheet["rows"].size() != rows.size())
            violated("sheet", "the JSON has other rows");
        if ((sheet["verdict"] == "conforms") != (apply > 0 && states["conforms"] == apply))
            violated("sheet", "verdict " + sheet["verdict"].dump() + " of " + Json(states).dump());
        if (!numbersIn(line.limits.state).contains(QString::number(states["conforms"])))
            violated("sheet", "page 1 counts others in " + language.code().toStdString() + ": " +
                                  line.limits.state.toStdString());
        if (states["notMeasured"] > 0 && (!hasRejection(m_followed.evaluated) ||
                                          m_followed.evaluated.verdict() == std::optional(Verdict::conforms)))
            violated("sheet", "exit 0 with a row that is not measured");
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const bool isMeasured = rows[i].contains("measured") && !rows[i]["measured"].is_null();
            if (isMeasured && sheet["rows"][i]["measured"] != rows[i]["measured"])
                violated("sheet", "another value in JSON");
            const bool isOpen = !isMeasured && !rows[i].contains("from");
            const bool applies = sheet["rows"][i]["state"] != "notApplicable";
            if (isOpen && applies && sheet["rows"][i]["state"] != "notMeasured")
                violated("sheet", "a row without value is " + sheet["rows"][i]["state"].dump());
        }
    }

    /// Every text and every number of the file stands on a page, numbers with all their digits.
    void statementsOnPages(const QString &page) {
        const auto &leftOut = document().report.leaveOut;
        const bool hasTables = std::ranges::find(leftOut, ReportPart::annex) == leftOut.end();
        const std::set<std::string> tables{"targets", "channels", "temperatures"};
        const auto walk = [&](const auto &self, const Json &at, const std::string &place,
                              const std::string &key) -> void {
            if (at.is_string()) {
                const QString text = QString::fromStdString(at.get<std::string>());
                if (!text.startsWith(QLatin1String("Text1")))
                    return;
                ++m_counts.texts;
                if (!page.contains(plain(visibleText(text))))
                    violated("nothing lost", place);
            } else if (at.is_number()) {
                ++m_counts.numbers;
                const auto number = at.get<double>();
                // Degrees are printed in arc seconds, a radius as a diameter.
                const auto isPrinted = [&](double factor) {
                    return page.contains(significantDigits(factor * number));
                };
                // An uncertainty that decides is printed with two digits, rounded up.
                const double unit = std::pow(10, std::floor(std::log10(std::abs(number))) - 1);
                const bool asUncertainty = place.find(".expanded.") != std::string::npos &&
                                           page.contains(significantDigits(std::ceil(number / unit) * unit));
                if (!isPrinted(1) && !isPrinted(3600) && !asUncertainty &&
                    !(key == "nominalRadius" && isPrinted(2)))
                    violated("nothing lost", place + " " + at.dump());
            } else if (at.is_object()) {
                for (const auto &[inner, below] : at.items()) {
                    if (!drawn.contains(inner) && (hasTables || !tables.contains(inner)))
                        self(self, below, place + "." + inner, inner);
                }
            } else if (at.is_array()) {
                for (const Json &below : at)
                    self(self, below, place, key);
            }
        };
        walk(walk, m_file, "", "");
    }

    /// A number is the length of the list it names.
    void counts() {
        for (const Json &test : m_json["tests"]) {
            if (!test.contains("unmet"))
                continue;
            int unmet = 0;
            int undeclared = 0;
            for (const Json &finding : test["findings"]) {
                const bool counted = finding["source"] == "text" && finding["grade"] == "requirement";
                unmet += counted && finding["state"] == "unmet" ? 1 : 0;
                undeclared += counted && finding["state"] == "undeclared" ? 1 : 0;
            }
            if (test["unmet"] != unmet || test["undeclared"] != undeclared)
                violated("one count", "unmet or undeclared");
            const std::string accordance = test["accordance"];
            if ((accordance == "no") != (unmet > 0) && accordance != "notChecked")
                violated("one count",
                         "accordance " + accordance + " with " + std::to_string(unmet) + " unmet");
        }
    }

    /// A grouped line lists as many names as it says; one name alone may have commas of its own.
    void groups() {
        static const QRegularExpression list(QStringLiteral("\\((\\d+)\\): ([^\n]*?)\\.( |$)"));
        for (const TestEvaluationPointer &test : m_followed.evaluated.tests) {
            for (const FindingLine &line : findingLines(*test, Language(Language::Id::english)).lines) {
                for (auto it = list.globalMatch(line.sentence.plain()); it.hasNext();) {
                    const QRegularExpressionMatch found = it.next();
                    const QString names = found.captured(2);
                    const QString between =
                        names.contains(u';') ? QStringLiteral("; ") : QStringLiteral(", ");
                    const auto count = found.captured(1).toLongLong();
                    if (count > 1 && names.split(between).size() != count)
                        violated("one count", found.captured(0).toStdString());
                }
            }
        }
    }

    /// Terminal, report and JSON give the same findings and verdicts.
    void oneVoice(const QString &page, const Language &language) {
        const auto printed = [&](const Report &report) {
            return plain(visibleText(plainText(report, 100'000)));
        };
        const QString terminal = printed(composeResults(m_followed.evaluated, language));
        const QString findings = printed(composeFindings(m_followed.evaluated, language));
        comparisons(page, terminal, language);
        const auto &leftOut = document().report.leaveOut;
        const auto hasPart = [&](ReportPart part) {
            return std::ranges::find(leftOut, part) == leftOut.end();
        };
        for (const TestEvaluationPointer &test : m_followed.evaluated.tests) {
            for (const Finding &finding : test->findings) {
                const QString said = plain(finding.name.empty() ? language.sentence(finding.message)
                                                                : findingName(finding, language));
                for (const auto &[exit, text] : {std::pair{"terminal", &terminal},
                                                 std::pair{"check", &findings}, std::pair{"report", &page}}) {
                    const bool onPage = hasPart(ReportPart::findings) &&
                                        (finding.source == Source::text || hasPart(ReportPart::annex));
                    if (text == &page && !onPage)
                        continue;
                    if (!text->contains(said))
                        violated("one voice", std::string(exit) + " lacks the finding " + finding.id + ": " +
                                                  said.toStdString());
                }
            }
        }
    }

    /// A comparison that is stated is in the JSON, with the test before it; pages and terminal say its word.
    void comparisons(const QString &page, const QString &terminal, const Language &language) {
        for (std::size_t i = 0; i < document().tests.size(); ++i) {
            const Json asked = m_file["tests"][i].value("comparedWith", Json());
            const Json found = m_json["tests"][i].value("comparison", Json());
            if (asked.is_null() != found.is_null()) {
                violated("nothing lost", "a comparison is stated or in the JSON, but not both");
                continue;
            }
            if (asked.is_null())
                continue;
            if (found["test"] != asked["test"] || found["tolerance"] != asked.value("tolerance", Json()) ||
                found["setUpUntouched"] != asked.value("setUpUntouched", false))
                violated("nothing lost", "another comparison: " + asked.dump());
            for (const Json &parameter : found["parameters"]) {
                if (parameter["difference"] !=
                    parameter["after"].get<double>() - parameter["before"].get<double>())
                    violated("one voice", "a difference is none: " + parameter.dump());
            }
            const TestComparison &comparison = statedComparison(m_followed.evaluated, i)->comparison;
            const auto word = wordOfAll(comparison);
            const QString said =
                plain(word ? language.text(changeText(*word)).toUpper() : reasonOf(comparison, language));
            if (!page.contains(said) || !terminal.contains(said))
                violated("one voice", "pages or terminal lack the comparison: " + said.toStdString());
        }
    }

    /// Terminal and report print each result as the JSON has it, rounded, in the row of its symbol.
    void sameNumbers(const Report &report) {
        const Language english(Language::Id::english);
        const std::array exits{std::pair{"terminal", composeResults(m_followed.evaluated, english)},
                               std::pair{"report", report}};
        for (const auto &[exit, written] : exits) {
            const QStringList lines = plainText(written, 100'000).split(u'\n');
            for (std::size_t i = 0; i < document().tests.size(); ++i) {
                const TestEvaluation &evaluation = *m_followed.evaluated.tests[i];
                for (const PrintedResult &result :
                     printedResults(document(), *document().tests[i], evaluation, english))
                    numberOf(exit, lines, result, m_json["tests"][i]["parameters"]);
            }
        }
    }

    void numberOf(const char *exit, const QStringList &lines, const PrintedResult &result,
                  const Json &parameters) {
        const std::string id = parameterId(*result.parameter);
        const auto json =
            std::ranges::find_if(parameters, [&](const Json &parameter) { return parameter["id"] == id; });
        if (json == parameters.end() || json->at("value").is_null() != result.value.isEmpty()) {
            violated("one voice", std::string(exit) + " has another value of " + id);
            return;
        }
        if (result.value.isEmpty())
            return;
        ++m_counts.results;
        const QString symbol = QString::fromStdString(plainSymbol(*result.parameter));
        if (std::ranges::none_of(lines, [&](const QString &line) {
                const QStringList cells = line.simplified().split(u' ');
                return QString(cells.front()).remove(u',') == symbol && cells.contains(result.value);
            }))
            violated("one voice", std::string(exit) + " lacks " + id + " = " + result.value.toStdString());
        QString digits = result.value;
        digits.replace(QChar(0x2212), u'-').remove(QChar(0x202F));
        const double value = json->at("value").get<double>() * (json->at("unit") == "deg" ? 3600 : 1000);
        const double step = std::pow(10.0, -result.decimals);
        if (std::abs(digits.toDouble() - value) > (0.5 + 1e-6) * step)
            violated("one voice", std::string(exit) + " prints " + digits.toStdString() + " for " + id + " " +
                                      json->at("value").dump());
    }

    /// No exit contains a raw control character or a mark of direction; what those are is said here anew.
    void harmless(const char *exit, const QString &text) {
        const bool raw = std::ranges::any_of(text, [](QChar c) {
            const char16_t u = c.unicode();
            const bool control = (u < 0x20 && u != u'\n' && u != u'\r') || (u >= 0x7F && u < 0xA0);
            return control || u == 0x061C || u == 0x200E || u == 0x200F || (u >= 0x202A && u <= 0x202E) ||
                   (u >= 0x2066 && u <= 0x2069);
        });
        if (raw)
            violated("harmless", std::string(exit) + " has raw control characters");
    }

    /// Every target and every reading stands in the CSV as the number it is.
    void csv(std::size_t i) {
        readBack(i);
        const QByteArray bytes = readingsCsv(m_followed.evaluated, i, Language(Language::Id::english), '.');
        harmless("the CSV", QString::fromUtf8(bytes));
        std::set<double> found;
        for (const QByteArray &line : bytes.split('\n')) {
            for (const QByteArray &cell : line.split(',')) {
                if (cell.startsWith('=') || cell.startsWith('@'))
                    violated("harmless", "a cell is a formula: " + cell.toStdString());
                bool isNumber = false;
                const double number = cell.trimmed().toDouble(&isNumber);
                if (isNumber)
                    found.insert(number);
            }
        }
        const auto walk = [&](const auto &self, const Json &at) -> void {
            if (at.is_number() && !found.contains(at.get<double>()))
                violated("nothing lost", "the CSV lacks " + at.dump());
            if (at.is_structured()) {
                for (const Json &below : at)
                    self(self, below);
            }
        };
        const Json &test = m_file["tests"][i];
        for (const char *list : {"targets", "times", "deviations"})
            walk(walk, test.value(list, Json()));
        for (const Json &run : test.value("runs", Json::array()))
            walk(walk, run["deviations"]);
        for (const Json &arc : test.value("arcs", Json::array())) {
            walk(walk, arc["angles"]);
            walk(walk, arc["radialDeviations"]);
        }
    }

    /// The CSV is read back as what it was made of, and gives the same results.
    void readBack(std::size_t i) {
        const char mark = m_counts.readBack++ % 2 == 0 ? '.' : ',';
        const QByteArray bytes = readingsCsv(m_followed.evaluated, i, Language(Language::Id::english), mark);
        Document document;
        try {
            addImported(document, importMeasurement(bytes, QStringLiteral("x.csv")), bytes,
                        QStringLiteral("x.csv"), false);
        } catch (const Error &error) {
            violated("read back", std::string("the CSV is refused: ") + error.what() + ' ' + error.place);
            return;
        }
        const EvaluatedDocument again = evaluate(std::make_shared<const Document>(std::move(document)));
        const Document &one = *again.document;
        const Test &read = *one.tests.front();
        const Test &written = *this->document().tests[i];
        const auto same = [](const auto &a, const auto &b) {
            return std::visit(
                [&](const auto &x) {
                    auto y = std::get<std::decay_t<decltype(x)>>(b.measurement);
                    if constexpr (requires { x.uncertainty; }) { // a drift test stays behind, not its range
                        y.uncertainty.driftTest = x.uncertainty.driftTest;
                        if (x.uncertainty.driftTest)
                            y.uncertainty.environmentalVariation = x.uncertainty.environmentalVariation;
                    }
                    return x == y;
                },
                a.measurement);
        };
        if (read.measurement.index() != written.measurement.index() || !same(written, read))
            violated("read back", "another measurement is read from the CSV");
        if (read.edition != written.edition || read.title != written.title || read.date != written.date ||
            read.limits != written.limits || read.agreedPoints != written.agreedPoints ||
            read.decisionRule != written.decisionRule || read.purpose != written.purpose ||
            read.role != written.role || read.extensions != written.extensions ||
            (isJudged(written) && read.remarks != written.remarks))
            violated("read back", "the CSV lost or changed a statement of the test");
        if (!(one.machine == this->document().machine) || one.instruments.size() != read.instruments.size())
            violated("read back", "the CSV lost the machine or an instrument");
        const auto &parameters = m_followed.evaluated.tests[i]->parameters;
        const auto equal = [](const Parameter &a, const Parameter &b) {
            const double ua = a.expandedUncertainty.value_or(0);
            const double ub = b.expandedUncertainty.value_or(0);
            return parameterId(a) == parameterId(b) && a.value == b.value &&
                   a.limit.has_value() == b.limit.has_value() &&
                   a.expandedUncertainty.has_value() == b.expandedUncertainty.has_value() &&
                   std::abs(ua - ub) <= 1e-12 * ua; // the range of a drift in another unit
        };
        if (!std::ranges::equal(parameters, again.tests.front()->parameters, equal))
            violated("read back", "the CSV gives other results");
    }

    /// The exports of a figure harm nobody.
    void figure(std::size_t i) {
        const Language english(Language::Id::english);
        const Figure figure = figureOfTest(*document().tests[i], *m_followed.evaluated.tests[i], english);
        harmless("the CSV of a figure", QString::fromUtf8(figureCsv(figure, english, '.')));
        if (i != 0 || ++m_counts.drawn % filesOfAnSvg != 0)
            return;
        const QByteArray svg =
            figureAsSvg(figure, QString::fromStdString(document().tests[i]->title), english);
        harmless("the SVG", QString::fromUtf8(svg));
        QXmlStreamReader reader(svg);
        while (!reader.atEnd())
            reader.readNext();
        if (reader.hasError())
            violated("harmless", "the SVG is no XML");
    }

    /// The window lists each finding on one page, counts those of the others, and sums up what there is.
    void window(std::size_t i) {
        const Language english(Language::Id::english);
        const std::vector<Finding> &findings = m_followed.evaluated.tests[i]->findings;
        const auto sum = [](const QString &text) {
            int result = 0;
            for (const QString &number : numbersIn(text))
                result += number.toInt();
            return result;
        };
        ui::FindingsModel model;
        std::multiset<QString> listed;
        for (int place = 0; place <= static_cast<int>(ui::Page::thermal); ++place) {
            const auto page = static_cast<ui::Page>(place);
            model.show(m_followed.evaluated, i, page, english);
            for (int row = 0; row < model.rowCount(); ++row) {
                const ui::FindingsModel::Line &line = model.line(row);
                if (line.page == page)
                    listed.insert(line.text);
                else if (sum(line.text) != std::ranges::count_if(findings, [&](const Finding &finding) {
                             return ui::pageOf(finding, document()) == line.page;
                         }))
                    violated("one count", "the window: " + line.text.toStdString());
            }
        }
        std::multiset<QString> said;
        for (const Finding &finding : findings)
            said.insert(findingText(finding, english));
        if (listed != said)
            violated("one voice", "the window lists other findings");
        if (sum(model.summary()) != static_cast<int>(findings.size()))
            violated("one count", "the window sums up: " + model.summary().toStdString());
    }

    /// A part program rests at each target as often as it is measured, in every dialect.
    void program(std::size_t i) {
        const auto own = planOf(*document().tests[i]);
        if (!own)
            return;
        const CycleProgram &program = own->program;
        const auto path = cyclePath(program);
        const auto stops =
            std::ranges::count_if(path, [](const Move &move) { return move.stop.has_value(); });
        for (const DialectName &dialect : dialects()) {
            QString text;
            try {
                text =
                    QString::fromUtf8(partProgram(program, dialect.dialect, Language(Language::Id::english)));
            } catch (const Error &error) { // an impossible one says why
                if (error.message.text.empty())
                    violated("part program", "refused without a reason");
                continue;
            }
            harmless("the part program", text);
            ++m_counts.programs;
            static const QRegularExpression rest(QStringLiteral("^(\\d+ CYCL DEF 9\\.1|G4 )"),
                                                 QRegularExpression::MultilineOption);
            if (text.count(rest) != stops)
                violated("part program", std::string(dialect.word) + " rests at another number of targets");
            for (const double target : program.targets) {
                if (!text.contains(QString::fromStdString(Decimal(target).rounded(program.decimals))))
                    violated("part program", std::string(dialect.word) + " lacks a target");
            }
            if (std::ranges::any_of(text, [](QChar c) { return c.unicode() > 126; }))
                violated("part program", std::string(dialect.word) + " is not ASCII");
        }
    }

    void registered() {
        const auto entries = registeredTests(m_followed.evaluated, QStringLiteral("Palmer"));
        std::size_t entry = 0;
        for (std::size_t i = 0; i < document().tests.size(); ++i) {
            const TestEvaluation &evaluation = *m_followed.evaluated.tests[i];
            if (entry >= entries.size()) {
                violated("one voice", "the register lacks a test");
                return;
            }
            const RegisteredTest &test = entries[entry++];
            if (test.verdict != evaluation.verdict || test.accordance != evaluation.accordance())
                violated("one voice", "the register says another verdict");
        }
        listed(entries);
    }

    /// The list of a register says of tests what the table of their file does, and what is due.
    void listed(const std::vector<RegisteredTest> &entries) {
        const QString file = QStringLiteral("file");
        QByteArray list;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            ListedTest one;
            one.test = entries[i];
            one.places = {
                {file, static_cast<int>(i) + 1, {}, QString::fromStdString(document().report.number)}};
            list += listedTestCsv(one).replace(",,,,,,\n", "\n"); // due, and since the last test
        }
        EvaluatedDocument results = m_followed.evaluated;
        for (TestEvaluationPointer &test : results.tests) {
            auto plain = std::make_shared<TestEvaluation>(*test);
            plain->limits.clear(); // the register knows no limits that cannot be evaluated
            test = std::move(plain);
        }
        const QByteArray table =
            summaryCsv(summaryRows(results, file, SummaryForm::csv, Language(Language::Id::english)));
        if (list != table)
            violated("one voice", "the list of the register: " + list.toStdString() + table.toStdString());
    }

    /// Every value, U and limit stands in the digital calibration certificate, in the order of the results.
    void certificate() {
        if (!missingForDcc(m_followed.evaluated).empty())
            return;
        const QByteArray bytes = dcc(m_followed.evaluated);
        harmless("the certificate", QString::fromUtf8(bytes));
        qsizetype at = 0;
        const auto next = [&](const char *element, const std::optional<double> &number, Quantity quantity) {
            if (!number || !std::isfinite(*number))
                return;
            const QByteArray text = "<si:" + QByteArray(element) + '>' +
                                    QByteArray::fromStdString(Decimal(*number, quantity).shortest()) +
                                    "</si:";
            const qsizetype found = bytes.indexOf(text, at);
            if (found < 0)
                violated("one voice", "the certificate lacks " + text.toStdString());
            at = std::max(at, found);
        };
        for (const TestEvaluationPointer &test : m_followed.evaluated.tests) {
            for (const Parameter &parameter : test->parameters) {
                const Quantity quantity = parameter.term.quantity;
                if (!parameter.required && !parameter.limit)
                    continue;
                next("value", parameter.value, quantity);
                if (parameter.value)
                    next("uncertainty", parameter.expandedUncertainty, quantity);
                if (parameter.limit)
                    next("value", parameter.limit->value, quantity);
            }
        }
    }

    /// What is printed follows from the data that the PDF carries.
    void verifies(const Report &report) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        writePdf(report, buffer, attachedResults(m_followed.evaluated));
        ++m_counts.reports;
        const auto opened = openReport(buffer.data(), 1);
        const Verification verification = opened ? verifyReport(*opened) : Verification();
        const Language english(Language::Id::english);
        if (!opened)
            violated("one voice", "the PDF cannot be opened");
        for (const Difference &difference : verification.differences)
            violated("one voice",
                     "the PDF: " +
                         (difference.what ? english.sentence(*difference.what)
                                          : difference.printed + QStringLiteral(" for ") + difference.follows)
                             .toStdString() +
                         " in " + difference.context.toStdString());
    }

    const Json &m_file;
    Followed m_followed;
    Counts &m_counts;
    Json m_json;
    std::vector<Violation> m_violations;
};

/// Follows one file and takes its statements away, one at a time.
class Laws {
public:
    Laws(const Generator &generator, std::size_t mostStatements, std::uint64_t seed)
        : m_generator(generator)
        , m_mostStatements(mostStatements)
        , m_random(seed) {}

    [[nodiscard]] std::vector<Violation> follow(const Json &file, bool asPdf);
    [[nodiscard]] const Counts &counts() const { return m_counts; }

private:
    const Generator &m_generator;
    std::size_t m_mostStatements;
    std::mt19937_64 m_random;
    Counts m_counts;
};

std::vector<Violation> Laws::follow(const Json &file, bool asPdf) {
    ++m_counts.files;
    try {
        Follower follower(file, m_counts);
        m_counts.tests += static_cast<int>(file["tests"].size());
        follower.follow(asPdf);
        std::vector<Path> statements = m_generator.statements(file);
        if (m_mostStatements > 0 && statements.size() > m_mostStatements) {
            std::ranges::shuffle(statements, m_random);
            statements.resize(m_mostStatements);
        }
        const QString page = pageOf(follower.followed());
        constexpr std::uint64_t pagesOfAFile = 4; // about so many are composed anew
        for (const Path &path : statements) {
            for (const bool asNull : {false, true}) {
                if (asNull && !m_generator.mayBeNull(path, file))
                    continue;
                const auto silent = whenSilent(without(file, path, asNull));
                if (!silent)
                    continue;
                ++m_counts.statements;
                if (const auto what = better(path.back(), follower.followed(), *silent))
                    follower.violations().push_back(
                        {"silence", joined(path) + (asNull ? " = null: " : " removed: ") + *what});
                if (isStatement(file, path) && m_random() % statements.size() < pagesOfAFile) {
                    ++m_counts.pages;
                    if (pageOf(*silent) == page)
                        follower.violations().push_back(
                            {"no invention", joined(path) + " is printed alike where it is not stated"});
                }
            }
        }
        for (const Violation &violation : follower.violations())
            ++m_counts.violations[violation.law];
        return std::move(follower.violations());
    } catch (const Error &error) {
        ++m_counts.refused;
        return {{"the schema is the reader's",
                 Language(Language::Id::english).sentence(error.message).toStdString() + " " + error.place}};
    }
}

const Json &schema() {
    static const Json read = Json::parse(readBytes(QStringLiteral(PALMER_SCHEMA)).toStdString());
    return read;
}

} // namespace

Counts &Counts::operator+=(const Counts &other) {
    files += other.files;
    refused += other.refused;
    tests += other.tests;
    limits += other.limits;
    statements += other.statements;
    results += other.results;
    texts += other.texts;
    numbers += other.numbers;
    pages += other.pages;
    reports += other.reports;
    readBack += other.readBack;
    drawn += other.drawn;
    programs += other.programs;
    for (const auto &[law, count] : other.violations)
        violations[law] += count;
    return *this;
}

Counts followFiles(int files, std::uint64_t first, std::size_t mostStatements,
                   const std::function<void(std::uint64_t seed, const Violation &)> &report) {
    constexpr std::uint64_t filesOfAPdf = 20;
    Counts all;
    for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(files); ++seed) {
        Generator generator(schema(), seed);
        Laws laws(generator, mostStatements, seed);
        for (const Violation &violation : laws.follow(generator.file(), seed % filesOfAPdf == 0))
            report(seed, violation);
        all += laws.counts();
    }
    return all;
}

std::string fileOf(std::uint64_t seed) {
    return Generator(schema(), seed).file().dump(2);
}

std::vector<std::string> claimingDefaults() {
    static const std::set<std::string> chosen{
        "motion",
        "quantity",
        "source",
        "angleReference", // what makes readings results at all
        "standardDeviation",
        "centring",
        "referenceCircle",
        "rule",
        "guardFactor", // printed as chosen
        "positioningUncertaintyMethod",
        "uncertaintyMethod",
        "driftModel",
        "seed",
        "kind",
        "sameSensor",
        "setUpUntouched", // only true is printed, false is as not stated
        "coverageFactor", // how an uncertainty is made
        "signatures",
        "languages",
        "paper",
        "include",
        "figures" // of the report
    };
    std::vector<std::string> claims;
    const auto walk = [&](const auto &self, const Json &at, const std::string &name) -> void {
        if (at.is_object() && at.contains("default") && !chosen.contains(name)) {
            const Json &value = at["default"];
            const auto isNothing = [](const Json &one) {
                return one.is_null() || one == "" || one == "notStated" || one == "not stated";
            };
            if (value.is_structured() ? !std::ranges::all_of(value, isNothing) : !isNothing(value))
                claims.push_back(name + ": " + value.dump());
        }
        if (at.is_structured()) {
            for (const auto &[key, below] : at.items())
                self(self, below, key);
        }
    };
    walk(walk, schema(), "");
    return claims;
}

} // namespace palmer::laws
