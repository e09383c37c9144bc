// SPDX-FileCopyrightText: 2026 the Palmer authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/commands.h"

#include "commandline/inputs.h"
#include "commandline/optionvalues.h"
#include "commandline/outputfile.h"
#include "commandline/preparation.h"
#include "commandline/simulations.h"
#include "commandline/streams.h"
#include "document/spool.h"
#include "document/testsofverdict.h"
#include "export/dcc.h"
#include "export/resultsjson.h"
#include "kernel/numerics/runinbackground.h"
#include "print/pdf/logo.h"
#include "print/pdf/writepdf.h"
#include "report/composereport.h"
#include "report/parts/parts.h"
#include "validation/validation.h"

#include <QFileInfo>
#include <algorithm>
#include <array>
#include <future>
#include <iterator>
#include <memory>
#include <utility>

namespace palmer {

namespace {

constexpr const char *originalsOption = "with-originals";
constexpr const char *dccOption = "with-dcc";
constexpr const char *annexOption = "no-annex";

constexpr auto reportOptions = optionList(
    Option{"o", "OUT.pdf|FOLDER",
           REPORT_TEXT("report",
                       "the PDF to write; of two languages OUT.fr.pdf and OUT.en.pdf; of several files the "
                       "folder they go into")},
    Option{"language", "fr|en|fr,en",
           REPORT_TEXT("report", "language of the report; without it those the file asks for")},
    Option{originalsOption, "",
           REPORT_TEXT("report", "the test file inside the PDF keeps the bytes of the instrument files that "
                                 "it was imported from; without it only their names and fingerprints")},
    Option{
        annexOption, "",
        REPORT_TEXT("report",
                    "only the certificate: verdict, results, conditions, what the text of the edition asks, "
                    "signatures")},
    Option{dccOption, "",
           REPORT_TEXT("report", "the PDF also carries the results as a digital calibration certificate")},
    Option{
        "edition", "E",
        REPORT_TEXT("report", "evaluate the tests of its kind under another edition (a view: no verdicts)")},
    nameOption, preparationOptions, jobsOption, foreignOptions, forceOption);

QStringList languagesOf(const Invocation &invocation, const Document &document) {
    QStringList result;
    if (const auto chosen = invocation.value("language")) {
        result = chosen->split(u',');
    } else {
        for (const ReportLanguage language : document.report.languages)
            result << (language == ReportLanguage::fr ? QStringLiteral("fr") : QStringLiteral("en"));
    }
    result.removeDuplicates();
    return result;
}

/// Prints a line for each unreadable picture of the laboratory, without which the report is printed.
void sayUnreadablePictures(const Document &document, const Input &input, const Language &language) {
    const Laboratory &laboratory = document.report.laboratory;
    const auto say = [&](const std::optional<std::string> &picture, const char *place) {
        const QByteArray bytes = QByteArray::fromBase64(QByteArray::fromStdString(picture.value_or("")));
        if (!bytes.isEmpty() && Logo(bytes).empty())
            printError(input.file,
                       Error(Error::Kind::content,
                             {REPORT_TEXT("report", "this is no PNG or SVG picture; the report is printed "
                                                    "without it"),
                              {},
                              {}},
                             place),
                       language);
    };
    say(laboratory.logo, "report.laboratory.logo");
    say(laboratory.mark, "report.laboratory.mark");
}

/// Composes and writes the reports of a document, one output per language.
class Reports {
public:
    explicit Reports(const Invocation &invocation)
        : m_invocation(invocation)
        , m_inputs(inputsOf(invocation)) {
        const QString output = neededOutput(invocation, "report", "-o OUT.pdf");
        if (const Edition *asked = editionAsked(invocation))
            m_edition = asked->word;
        if (!m_edition.empty() && invocation.has(dccOption)) // a view certifies nothing
            throw UsageError({REPORT_TEXT("report", "--%1 and --%2 do not go together"),
                              {std::string("edition"), std::string(dccOption)}});
        if (m_inputs.several) {
            m_outputs = outputsInFolder(invocation, output, m_inputs, QStringLiteral(".pdf"));
            requireOwnNames();
            const QFileInfo folder(output);
            if (!folder.isDir() && (folder.exists() || folder.suffix().toLower() == QLatin1StringView("pdf")))
                throw UsageError(
                    {REPORT_TEXT("report", "the reports of several files go into a folder; %1 is none"),
                     {output.toStdString()}});
        } else {
            requireNoName(invocation);
            requireOutput(invocation, output, {"pdf"});
            m_outputs = {output};
        }
        m_selfTest = runInBackground(true, selfTestPasses); // once for all, while the file is read
        if (m_inputs.several)
            m_selfTest.wait(); // no thread may run when processes are forked
    }

    int run() {
        return eachDocument(m_invocation, m_inputs,
                            [this](const Input &input, Document document) -> JobResult {
                                const auto index = static_cast<qsizetype>(&input - m_inputs.list.data());
                                sayUnreadablePictures(document, input, m_invocation.language);
                                return {report(std::move(document), m_outputs.at(index)), {}};
                            });
    }

private:
    /// Languages of the reports of an input; none where it cannot be read, as then nothing is written.
    [[nodiscard]] QStringList languagesOfInput(qsizetype index) const {
        try {
            const QString &file = m_inputs.list[static_cast<std::size_t>(index)].file;
            return languagesOf(m_invocation, documentFrom(file, m_invocation, Say::nothing));
        } catch (const Error &) {
            return {};
        } catch (const UsageError &) {
            return {};
        }
    }

    /// Throws UsageError if the report of one input in one of two languages has the name of another's.
    void requireOwnNames() const {
        for (qsizetype i = 0; i < m_outputs.size(); ++i) {
            for (const QString &name : {QStringLiteral("fr"), QStringLiteral("en")}) {
                const QString file = withLanguage(m_outputs[i], name);
                const qsizetype other = m_outputs.indexOf(file);
                const QStringList own = other < 0 ? QStringList() : languagesOfInput(i);
                if (own.size() > 1 && own.contains(name) && languagesOfInput(other).size() == 1)
                    throw UsageError(
                        {REPORT_TEXT("report",
                                     "%1 and %2 would both be written as %3; call the command for each"),
                         {m_inputs.list[static_cast<std::size_t>(other)].shown.toStdString(),
                          m_inputs.list[static_cast<std::size_t>(i)].shown.toStdString(),
                          file.toStdString()}});
            }
        }
    }

    /// Warns before the time is spent.
    void warnOfLength(const Document &document) const {
        const auto &include = document.report.include;
        const int pages = pagesOfAllReadings(document);
        if (pages > 0 && std::ranges::find(include, ReportExtra::allReadings) != include.end())
            printError(m_invocation.language.sentence(
                {REPORT_TEXT_COUNTED("report",
                                     "all readings are to be printed, on about %n more page(s): that takes "
                                     "time and memory; without “allReadings” under “include” the report "
                                     "says how many it leaves out"),
                 {},
                 pages}));
    }

    [[nodiscard]] int report(Document document, const QString &output) const {
        if (!m_inputs.several && !m_edition.empty())
            requireTestOf(*findEdition(m_edition), document);
        warnOfLength(document);
        auto whole = std::make_shared<const Document>(std::move(document));
        const bool certified = m_invocation.has(dccOption);
        if (certified)
            requireForDcc({whole, {}, {}, {}}, m_invocation.language);
        const Originals originals =
            m_invocation.has(originalsOption) ? Originals::include : Originals::leaveOut;
        // Written during the evaluation and then compressed: for 10⁶ readings each takes longer than all
        // pages.
        auto carried = runInBackground(true, [&whole, originals] {
            const QByteArray file = attachedFile(*whole, originals);
            return std::pair(file, attachmentsOf(attachedFileName(*whole), file, {}));
        });
        const bool hasAnnex = !m_invocation.has(annexOption);
        EvaluatedDocument evaluated =
            simulated(evaluate(whole, nullptr, m_edition),
                      hasAnnex ? SimulateWhich::forReport : SimulateWhich::monteCarloOnly,
                      m_inputs.several ? 1 : 0, m_invocation.language);
        const bool isRejected = hasRejection(evaluated);
        const QStringList languages = languagesOf(m_invocation, *evaluated.document);
        if (output == QLatin1StringView("-") && languages.size() > 1)
            throw UsageError(
                {REPORT_TEXT("report", "standard output takes one report; choose --language"), {}});
        const auto targetOf = [&](const QString &name) {
            return languages.size() > 1 ? withLanguage(output, name) : output;
        };
        for (const QString &name : languages)
            requireOutput(m_invocation, targetOf(name), {"pdf"});
        auto results = runInBackground(true, [&evaluated, certified] {
            return attachmentsOf({}, {}, attachedResults(evaluated),
                                 certified ? dcc(evaluated) : QByteArray());
        });
        auto [testFile, attachments] = carried.get();
        carried = {};
        ReportOptions stated{
            QStringLiteral("Palmer " PALMER_VERSION), m_selfTest.get(), originals, testFile, {}, hasAnnex};
        std::vector<FileToSave> reports;
        // For 10⁶ readings the results are 80 MB until they are compressed, as much as the report.
        constexpr qsizetype large = 1 << 22;
        const auto takeResults = [&] {
            if (results.valid()) // once for all languages
                std::ranges::copy(results.get(), std::back_inserter(attachments));
        };
        if (testFile.size() > large)
            takeResults();
        for (const QString &name : languages) {
            Report report = composeReport(evaluated, Language::fromName(name).value(), stated);
            takeResults();
            if (name == languages.back()) { // the memory is needed for the pages
                evaluated = {};
                whole.reset();
                testFile.clear();
                stated.testFile.clear();
            }
            const auto pdf = std::make_shared<Spool>();
            writePdf(std::move(report), *pdf, attachments);
            reports.push_back({pdf->bytes(), targetOf(name), pdf});
        }
        try {
            if (m_inputs.several)
                makeFolderOf(output);
            writeOutputs(reports);
        } catch (const UnsavedFile &error) {
            printError(error.path, error, m_invocation.language);
            return cannotRead;
        }
        return isRejected ? difference : done;
    }

    const Invocation &m_invocation;
    Inputs m_inputs;
    QStringList m_outputs; ///< by input
    std::string m_edition;
    std::shared_future<bool> m_selfTest;
};

int runReport(const Invocation &invocation) {
    return Reports(invocation).run();
}

} // namespace

Command reportCommand() {
    return {"report",      "FILE|FOLDER…", REPORT_TEXT("report", "the printed report as PDF"),
            reportOptions, runReport,      true};
}

} // namespace palmer
